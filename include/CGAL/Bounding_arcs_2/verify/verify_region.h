// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Is a curve piece inside its bounding region?  Proven, not sampled: the region is the exact one over the exact curve
// that the given control points and parameters define.

#ifndef CGAL_BOUNDING_ARCS_2_VERIFY_VERIFY_REGION_H
#define CGAL_BOUNDING_ARCS_2_VERIFY_VERIFY_REGION_H

#include <CGAL/Bounding_arcs_2/region/Bilens.h>
#include <CGAL/Bounding_arcs_2/region/Spiral_fat_arc.h>
#include <CGAL/Bounding_arcs_2/region/thickness_bound.h>
#include <CGAL/Bounding_arcs_2/spiral/spiral_parameters.h>
#include <CGAL/Bounding_arcs_2/verify/internal/prove_bca.h>
#include <CGAL/Bounding_arcs_2/verify/internal/prove_outline.h>
#include <CGAL/Bounding_arcs_2/verify/outside_bound.h>
#include <CGAL/Bounding_arcs_2/verify/prove_thickness.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <optional>
#include <type_traits>
#include <utility>
#include <vector>

// Containment in spiral fat arcs and bilens.  Each boundary is two pieces with a joint.  The piece on an osculating
// circle is proven over integers (the triple root divides out exactly); the other piece and the joint hold
// square roots and are proven in MPFR intervals of rising precision:
//   a parameter s splits the curve: on one part it keeps to its side of the second piece's circle or line, on the other
//   it has not yet passed the normal line at the joint, beyond which that second piece lies.
// So the curve, which starts between the two boundaries, crosses neither.

namespace CGAL::Bounding_arcs::verify {

using Interval_polynomial = Bernstein_polynomial<Mpfr_interval>;

/// A strict spiral piece and, in intervals of one precision, its boundary as the construction makes it, with the
/// piece's start at the origin and lengths in units of the shape.
class Osculating_proof {
 public:
  template <class Construction>
  Osculating_proof(const Construction& construction, const Containment_piece& piece, const Chord_shape_2<Rational>& f,
                   const Parameter_range& range, mpfr_prec_t precision)
      : piece_(piece), tight_(piece.tight), flat_(piece.flat), f_(f), range_(range), precision_(precision) {
    Chord_shape_2<Rational> shape = f;
    shape.unit = 1;
    Chord_frame_2<Mpfr_interval> frame;
    frame.shape = convert_shape<Mpfr_interval>(shape, [&](const Rational& x) { return interval(x); });
    frame.p1 = frame.shape.chord;
    boundary_ = construction.boundary(frame);
    tight_end_ = f.tight_first ? frame.p0 : frame.p1;
  }

  /// What the construction came out as: BCA where its own is not defined.
  [[nodiscard]] Region_form form() const { return boundary_.form; }

  /// Neither boundary is crossed. \pre form() is SPIRAL_FAT_ARC or BILENS
  [[nodiscard]] Proof contained() const {
    const bool segments = form() == Region_form::SPIRAL_FAT_ARC,
               infinite = f_.tight_first ? f_.infinite0 : f_.infinite1;
    const Rational k_tight = f_.tight_first ? f_.curvature0 : f_.curvature1;
    const Rational k_flat = f_.tight_first ? f_.curvature1 : f_.curvature0;
    // inner: the tight end's osculating circle and what follows it; where that circle is a point, the one piece left
    Proof proof = !infinite ? prove_osculating(tight_, k_tight, -1)
                            : (segments ? prove_chord() : prove_chord_circle(piece_, false, -1, range_));
    if (proof == Proof::PROVEN && !infinite) proof = prove_inner_joint(segments);
    // outer: the flat end's osculating circle, and before it a contact circle or the tangent at the tight end
    if (proof == Proof::PROVEN) proof = prove_osculating(flat_, k_flat, +1);
    if (proof == Proof::PROVEN) proof = segments ? prove_tangent() : prove_outer_joint();
    return proof;
  }

 private:
  using Piece = Boundary_piece_2<Mpfr_interval>;

  [[nodiscard]] Mpfr_interval interval(const Rational& x) const { return Mpfr_interval(x, precision_); }
  [[nodiscard]] Interval_polynomial interval(const Integer_polynomial& p) const {
    std::vector<Mpfr_interval> c;
    for (const Integer& x : p.scaled_coefficients()) c.push_back(interval(Rational(x)));
    return Interval_polynomial::from_scaled(std::move(c));
  }
  // The piece at the tight or flat end of a chain of two, and the joint.
  [[nodiscard]] const Piece& piece_at(const Boundary_chain_2<Mpfr_interval>& chain, bool tight) const {
    return chain[tight == f_.tight_first ? 0 : 1];
  }
  [[nodiscard]] static const Xy<Mpfr_interval>& joint(const Boundary_chain_2<Mpfr_interval>& chain) {
    return chain[0].to;
  }
  // of lines from the tight end to the flat one: left where the curve turns left on the way
  [[nodiscard]] int turn() const { return f_.tight_first ? f_.turn : -f_.turn; }

  // curvature of the shape: K = curvature c / n^3, so curvature |tangent| is 2 curvature / n^2 in the shape's units
  [[nodiscard]] Proof prove_osculating(const End_view& v, const Rational& curvature, int side) const {
    const std::vector<Integer> k = cleared<Rational>({dot(v.tangent, v.tangent), Rational(f_.turn) * 2 * curvature *
                                                                                     Rational(v.stretch) * v.scale})
                                       .numbers;
    return prove_nonnegative_but_at_ends(Integer(side) * (k[0] * v.bend - k[1] * v.square), range_);
  }
  // Proves that the piece is on the outer side of the chord.
  [[nodiscard]] Proof prove_chord() const {
    return prove_nonnegative_but_at_ends(Integer(-turn()) * tight_.along(perp(piece_.chord)), range_);
  }
  // Proves that the piece is on the inner side of the tight end's tangent.
  [[nodiscard]] Proof prove_tangent() const {
    return prove_nonnegative_but_at_ends(tight_.along(tight_.inward), range_);
  }

  // The side of the contact circle of a piece that touches the curve at this end.
  [[nodiscard]] Interval_polynomial contact(const End_view& v, const Piece& piece, bool at_tight) const {
    const Xy<Mpfr_interval> inward{interval(Rational(v.inward.x)), interval(Rational(v.inward.y))};
    const Mpfr_interval k = Mpfr_interval(f_.turn) * piece.support.curvature * sqrt(dot(inward, inward)) *
                            interval(v.scale);  // the support's normal has length 1
    const std::size_t n = common_zeros(v.bend, v.square, at_tight);
    return without_roots(interval(v.bend) - k * interval(v.square), at_tight ? n : 0, at_tight ? 0 : n);
  }

  [[nodiscard]] Proof prove_inner_joint(bool is_segment) const {
    const Piece& second = piece_at(boundary_.inner, false);
    const Xy<Mpfr_interval> j = joint(boundary_.inner);
    if (!is_segment) return prove_joint(contact(flat_, second, false), false, -1, passed(second, j));
    // the segment's line through the flat end: cross of its direction, seen from the tight end, with the curve
    const Xy<Mpfr_interval> line = f_.tight_first ? second.to - second.from : second.from - second.to;
    const Interval_polynomial beyond =
        Mpfr_interval(turn()) * (line.x * interval(flat_.y) - line.y * interval(flat_.x));
    return prove_joint(without_roots(beyond, 0, common_zeros(flat_.x, flat_.y, false)), false, -1, passed(line, j));
  }
  [[nodiscard]] Proof prove_outer_joint() const {
    const Piece& first = piece_at(boundary_.outer, true);
    return prove_joint(contact(tight_, first, true), true, +1, passed(first, joint(boundary_.outer)));
  }

  // Positive where the curve has passed the normal line at the joint: of a circle, or in a direction.
  [[nodiscard]] Interval_polynomial passed(const Piece& circle, const Xy<Mpfr_interval>& j) const {
    const Xy<Mpfr_interval> n = circle.support.normal_at(j);
    const Xy<Mpfr_interval> tangent{n.y, -n.x};
    return passed(f_.tight_first ? tangent : -tangent, j);
  }
  [[nodiscard]] Interval_polynomial passed(const Xy<Mpfr_interval>& direction, const Xy<Mpfr_interval>& j) const {
    const Mpfr_interval level = dot(direction, j - tight_end_);
    return interval(tight_.scale) * (direction.x * interval(tight_.x) + direction.y * interval(tight_.y)) -
           level * interval(tight_.weight);
  }

  // A piece that ends at a joint, at the tight or at the flat end: on the joint's one side the curve keeps to the
  // piece's side, on the other it lies beyond the normal line at the joint, where the piece is not.
  [[nodiscard]] Proof prove_joint(const Interval_polynomial& piece, bool at_tight, int side,
                                  const Interval_polynomial& passed) const {
    const Interval_polynomial on_side = Mpfr_interval(side) * piece, beyond = Mpfr_interval(at_tight ? 1 : -1) * passed;
    const std::optional<Rational> s = parameter_between(on_side, beyond, at_tight);
    if (!s) return Proof::UNDECIDED;
    const Proof kept = prove_between(on_side, at_tight ? range_.low : *s, at_tight ? *s : range_.high);
    return kept == Proof::PROVEN ? prove_between(beyond, at_tight ? *s : range_.low, at_tight ? range_.high : *s)
                                 : kept;
  }
  [[nodiscard]] Proof prove_between(const Interval_polynomial& p, const Rational& low, const Rational& high) const {
    return prove_nonnegative(
        p.restricted(interval(low), interval(Rational(1 - low)), interval(high), interval(Rational(1 - high))));
  }

  // A parameter at which the curve is on the piece's side and the normal line at the joint lies between it and the
  // piece.  Found by halving: where the piece comes first the curve passes the normal before it leaves the piece's
  // circle, where it comes last it enters before it passes.
  [[nodiscard]] std::optional<Rational> parameter_between(const Interval_polynomial& on_side,
                                                          const Interval_polynomial& beyond, bool at_tight) const {
    Rational low = range_.low, high = range_.high;
    for (mpfr_prec_t i = 0; i < precision_; ++i) {
      const Rational s = (low + high) / 2;
      const Mpfr_interval t = interval(s), rest = interval(Rational(1 - s));
      const bool is_on_side = on_side.homogeneous_value(t, rest).certain_sign() > 0;
      const bool is_beyond = beyond.homogeneous_value(t, rest).certain_sign() > 0;
      if (is_on_side && is_beyond) return s;
      if (at_tight ? !is_beyond : !is_on_side) low = s;
      else high = s;
    }
    return std::nullopt;
  }

  const Containment_piece& piece_;
  const End_view& tight_;
  const End_view& flat_;
  const Chord_shape_2<Rational>& f_;
  const Parameter_range& range_;
  mpfr_prec_t precision_;
  Region_boundary_2<Mpfr_interval> boundary_;
  Xy<Mpfr_interval> tight_end_;
};

}  // namespace CGAL::Bounding_arcs::verify

namespace CGAL::Bounding_arcs {

/// What came of the proof that a region holds its piece.
enum class Containment {
  PROVEN,            ///< the piece lies in the method's region
  PROVEN_AS_SLIVER,  ///< proven but for the rounding of a cut at an end, see Region_proof::slack
  DISPROVED,         ///< the piece leaves the region
  UNDECIDED          ///< not decided within the highest precision
};

namespace verify {

// Past a vertex by a few spacings of parameters the curvature exceeds its end value, by about the square of that
// spacing over the piece's length as a share of what it differs from the chord circle's; more where it changes quickly.
// Each share is tried in turn while the region stays thin enough. The first adds no more than 2^-44 of itself to a
// region's thickness.
inline constexpr double SLIVER_SLACKS[] = {0x1p-44, 0x1p-24, 0x1p-10, 0x1p-4};

/// The shape with the tight end's curvature raised and the flat end's lowered, each by a share of how far it is from
/// that of the circle over the chord: a region that holds the curve although an end was cut past a vertex.
[[nodiscard]] inline Chord_shape_2<Rational> with_curvature_bounds(Chord_shape_2<Rational> f, double share) {
  const Rational cc = dot(f.chord, f.chord);
  if (!f.infinite0) {
    f.curvature0 += Rational(share) * f.kneser0 / cc;
    f.kneser0 *= Rational(1 + share);
  }
  if (!f.infinite1) {
    f.curvature1 -= Rational(share) * f.kneser1 / cc;
    f.kneser1 *= Rational(1 + share);
  }
  return f;
}

/// A piece and the shape that its region is made from, with exact numbers.
struct Exact_piece {
  Relative_piece<Rational> piece;
  Chord_shape_2<Rational> shape;
};

/// What is left out at the ends of a piece, as shares of its parameters.
struct Trims {
  Rational start{0}, end{0};
};

/// The region is the one that the construction makes of the shape, whatever it steps back to.
/// \param reached set to the largest distance of the points left out from the ends that they are next to, in units of
///   the shape
template <class Construction>
[[nodiscard]] Proof prove_containment(const Construction& construction, const Exact_piece& exact,
                                      const Trims& trims = {}, double* reached = nullptr) {
  const Chord_shape_2<Rational>& f = exact.shape;
  const Containment_piece piece = containment_piece(exact.piece, f);
  const Rational &at_tight = f.tight_first ? trims.start : trims.end,
                 &at_flat = f.tight_first ? trims.end : trims.start;
  const Parameter_range range{at_tight, Rational(1 - at_flat)};
  if (reached != nullptr)
    *reached = (std::max)(reach(piece.tight, {Rational(0), range.low}), reach(piece.flat, {range.high, Rational(1)}));
  if constexpr (has_outline_v<Construction>) {
    return prove_outline(construction, piece, f, range);
  } else if constexpr (Construction::NEEDS_CURVATURE) {
    if (!f.proper) return prove_bca(piece, f, range);
    constexpr mpfr_prec_t FIRST = 128, LAST = 4096;  // bits
    for (mpfr_prec_t precision = FIRST; precision <= LAST; precision *= 2) {
      try {
        const Osculating_proof proof(construction, piece, f, range, precision);
        if (proof.form() == Region_form::BCA) return prove_bca(piece, f, range);
        const Proof result = proof.contained();
        if (result != Proof::UNDECIDED) return result;
      } catch (const CGAL::Uncertain_conversion_exception&) {  // a comparison of intervals: try a higher precision
      }
    }
    return Proof::UNDECIDED;
  } else if constexpr (std::is_base_of_v<Bca, Construction>) {
    return prove_bca(piece, f, range);
  } else {
    return prove_between_arcs(construction, piece, f, range);
  }
}

// Some ulp of the coordinates, or what the rounding of a cut's parameter comes to where that is more.
template <class Spiral> [[nodiscard]] double resolution(const Spiral& spiral) {
  constexpr double ULPS = 8, CUTS = 16;
  const double size = spiral.coordinate_size();
  return (std::max)(ULPS * ulp_of(size), CUTS * spiral.cut_error());
}

// Parameters of cuts are roots rounded to double, and of roots within CUT_WIDTH one is the cut: at an end that was cut,
// or that is the curve's own, the piece may hold that much of parameter that is not part of the spiral. The region then
// holds all but what is within a distance of the end, which is tried from there on up to `limit`.
template <class Construction, class Spiral>
[[nodiscard]] std::optional<double> prove_but_for_ends(const Construction& construction, const Spiral& spiral,
                                                       double t0, double t1, const Exact_piece& exact, double limit) {
  constexpr double GROWTH = 8,
                   LARGEST = 0x1p-39;  // of parameters; at a cut a curve departs from its region like a power of them
  const bool at_first = t0 == spiral.first(), at_last = t1 == spiral.last();
  for (double width = CUT_WIDTH; width <= LARGEST && width < (t1 - t0) / 4; width *= GROWTH) {
    const Rational share = Rational(width) / Rational(Rational(t1) - Rational(t0));
    double distance = 0;
    const Proof proof = prove_containment(construction, exact,
                                          {at_first ? share : Rational(0), at_last ? share : Rational(0)}, &distance);
    distance *= CGAL::to_interval(exact.shape.unit).second * (1 + 0x1p-50);
    if (!(distance <= limit)) break;
    if (proof == Proof::PROVEN) return distance;
  }
  return std::nullopt;
}

}  // namespace verify

/// What is proven of a region.
struct Region_proof {
  Containment containment = Containment::UNDECIDED;
  /// How near to the region all of the piece is, where it is PROVEN_AS_SLIVER. With 0 the piece is in the region with
  /// the curvatures at its ends widened, by 2^-44 of what they differ from the chord circles' where that will do.
  double slack = 0;
  [[nodiscard]] bool holds() const {
    return containment == Containment::PROVEN || containment == Containment::PROVEN_AS_SLIVER;
  }
};

/// Whether the piece [t0, t1] of a spiral segment lies in its region.
/// \tparam Construction Bca, Spiral_fat_arc, Bilens, one of the latter two in Near_circular_to_bca, one with regions
///   that have outlines, or one whose sides are an arc each and need no curvature
/// \tparam Spiral Bezier_spiral_2 over a number type whose exact type is CGAL::Exact_rational
/// \param eps the thickness that a region widened for a sliver may not exceed; a slack is at most half of it
/// \guarantee PROVEN and PROVEN_AS_SLIVER are proofs: exact rational arithmetic for BCA, for the others rational
///   arithmetic and MPFR intervals of up to 4096 bits
/// \complexity some ten microseconds for BCA of a cubic, some hundred for the others
template <class Construction, class Spiral>
[[nodiscard]] Region_proof verify_region(const Spiral& spiral, double t0, double t1,
                                         double eps = std::numeric_limits<double>::infinity(),
                                         const Construction& construction = {}) {
  static_assert(verify::has_outline_v<Construction> || !Construction::NEEDS_CONTROL_POINTS,
                "no proof for this construction");
  using verify::Proof;
  using verify::Rational;
  static_assert(std::is_same_v<typename Spiral::Exact_number_type, Rational>, "verification needs rational curves");
  const verify::Exact_piece exact{relative_piece(spiral.exact_table(), Rational(t0), Rational(t1)),
                                  spiral.template shape<Rational>(t0, t1, shape_parts<Construction>())};
  const Proof proof = verify::prove_containment(construction, exact);
  if (proof == Proof::PROVEN) return {Containment::PROVEN, 0};
  if (t0 == spiral.first() || t1 == spiral.last()) {
    if (Construction::NEEDS_CURVATURE && exact.shape.proper)
      for (const double slack : verify::SLIVER_SLACKS) {
        const verify::Exact_piece widened{exact.piece, verify::with_curvature_bounds(exact.shape, slack)};
        if (thickness_interval(construction, widened.shape).sup() > eps) break;
        if (verify::prove_containment(construction, widened) == Proof::PROVEN)
          return {Containment::PROVEN_AS_SLIVER, 0};
      }
    if (const auto slack = verify::prove_but_for_ends(construction, spiral, t0, t1, exact, eps / 2))
      return {Containment::PROVEN_AS_SLIVER, *slack};
    // where a cut stands for several roots the piece need not be a spiral at all, by what coordinates and cuts do not
    // resolve
    if constexpr (!verify::has_outline_v<Construction>) {
      const double limit = (std::min)(eps / 2, verify::resolution(spiral));
      const auto boundary =
          construction.boundary(frame_at_origin(spiral.accurate_shape(t0, t1, shape_parts<Construction>())));
      const double slack = outside_bound(spiral, t0, t1, boundary, limit / 2, verify::Boundary_origin::PIECE);
      if (slack <= limit) return {Containment::PROVEN_AS_SLIVER, slack};
    }
  }
  return {proof == Proof::DISPROVED ? Containment::DISPROVED : Containment::UNDECIDED, 0};
}

/// Whether no point of the outer boundary of the piece's exact region is farther from the inner boundary than
/// `thickness`.
/// \guarantee true is a proof, from the boundaries alone, in MPFR intervals of up to 8192 bits; where the two lengths
///   are equal as far as these tell, it is taken as true
template <class Construction, class Spiral>
[[nodiscard]] bool verify_thickness(const Spiral& spiral, double t0, double t1, double thickness,
                                    const Construction& construction = {}) {
  using verify::Rational;
  Chord_shape_2<Rational> shape = spiral.template shape<Rational>(t0, t1, shape_parts<Construction>());
  if (shape.chord == Xy<Rational>{}) return spiral.is_straight() && thickness >= 0;        // a point
  if (shape.runs_ahead && !shape.proper && shape.sine_change == 0) return thickness >= 0;  // a line or an arc, twice
  const Rational length = Rational(thickness) / shape.unit;
  if constexpr (verify::has_outline_v<Construction>) {
    const std::optional<bool> holds = verify::prove_outline_thickness(construction, shape, length);
    return holds ? *holds : verify_thickness<Bca>(spiral, t0, t1, thickness);
  } else {
    shape.unit = 1;
    const auto boundary = [&](mpfr_prec_t bits) {
      const auto number = [bits](const Rational& x) { return Mpfr_interval(x, bits); };
      return construction.boundary(frame_at_origin(convert_shape<Mpfr_interval>(shape, number)));
    };
    return verify::prove_thickness(boundary, length);
  }
}

}  // namespace CGAL::Bounding_arcs

#endif
