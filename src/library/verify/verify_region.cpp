// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Bodies of verify/verify_region.h.

#include "Thickness_proof.h"
#include "prove_outline.h"

#include <CGAL/Bounding_arcs_2/spiral/Segment_place.h>

#include <CGAL/number_utils.h>

#include <algorithm>
#include <cstddef>
#include <optional>

namespace CGAL::Bounding_arcs {
namespace verify {
namespace {

using internal::Exact_piece;
using internal::Proven_construction;
using internal::Region_question;

// Containment in spiral fat arcs and bilens.  Each boundary is two pieces with a joint.  The piece on an osculating
// circle is proven over integers (the triple root divides out exactly); the other piece and the joint hold
// square roots and are proven in MPFR intervals of rising precision:
//   a parameter s splits the curve: on one part it keeps to its side of the second piece's circle or line, on the other
//   it has not yet passed the normal line at the joint, beyond which that second piece lies.
// So the curve, which starts between the two boundaries, crosses neither.

/// A strict spiral piece and its boundary as the construction makes it, with the piece's start at the origin and
/// lengths in units of the shape.
class Osculating_proof : Piece_in_intervals {
 public:
  Osculating_proof(const Proven_construction& construction, const Piece_in_intervals& piece)
      : Piece_in_intervals(piece), tight_(piece_.tight), flat_(piece_.flat),
        boundary_(construction.enclosed(enclosed_frame(f_, bits_))) {}

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
  [[nodiscard]] Polynomial contact(const End_view& v, const Piece& piece, bool at_tight) const {
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
    const Polynomial beyond = Mpfr_interval(turn()) * (line.x * interval(flat_.y) - line.y * interval(flat_.x));
    return prove_joint(without_roots(beyond, 0, common_zeros(flat_.x, flat_.y, false)), false, -1, passed(line, j));
  }
  [[nodiscard]] Proof prove_outer_joint() const {
    const Piece& first = piece_at(boundary_.outer, true);
    return prove_joint(contact(tight_, first, true), true, +1, passed(first, joint(boundary_.outer)));
  }

  // Positive where the curve has passed the normal line at the joint: of a circle, or in a direction.
  using Piece_in_intervals::passed;
  [[nodiscard]] Polynomial passed(const Piece& circle, const Xy<Mpfr_interval>& j) const {
    const Xy<Mpfr_interval> n = circle.support.normal_at(j);
    const Xy<Mpfr_interval> tangent{n.y, -n.x};
    return passed(f_.tight_first ? tangent : -tangent, j);
  }
  // A piece that ends at a joint, at the tight or at the flat end: on the joint's one side the curve keeps to the
  // piece's side, on the other it lies beyond the normal line at the joint, where the piece is not.
  [[nodiscard]] Proof prove_joint(const Polynomial& piece, bool at_tight, int side, const Polynomial& passed) const {
    const Polynomial on_side = Mpfr_interval(side) * piece, beyond = Mpfr_interval(at_tight ? 1 : -1) * passed;
    const std::optional<Rational> s = parameter_between(on_side, beyond, at_tight);
    if (!s) return Proof::UNDECIDED;
    const Proof kept = prove_between(on_side, at_tight ? range_.low : *s, at_tight ? *s : range_.high);
    return kept == Proof::PROVEN ? prove_between(beyond, at_tight ? *s : range_.low, at_tight ? range_.high : *s)
                                 : kept;
  }
  // A parameter at which the curve is on the piece's side and the normal line at the joint lies between it and the
  // piece.  Found by halving: where the piece comes first the curve passes the normal before it leaves the piece's
  // circle, where it comes last it enters before it passes.
  [[nodiscard]] std::optional<Rational> parameter_between(const Polynomial& on_side, const Polynomial& beyond,
                                                          bool at_tight) const {
    Rational low = range_.low, high = range_.high;
    for (mpfr_prec_t i = 0; i < bits_; ++i) {
      const Rational s = (low + high) / 2;
      const bool is_on_side = sign_at(on_side, s) > 0, is_beyond = sign_at(beyond, s) > 0;
      if (is_on_side && is_beyond) return s;
      if (at_tight ? !is_beyond : !is_on_side) low = s;
      else high = s;
    }
    return std::nullopt;
  }

  const End_view& tight_;
  const End_view& flat_;
  Region_boundary_2<Mpfr_interval> boundary_;
};

/// What is left out at the ends of a piece, as shares of its parameters.
struct Trims {
  Rational start{0}, end{0};
};

Proof prove_strict_piece(const Proven_construction& construction, const Containment_piece& piece,
                         const Chord_shape_2<Rational>& f, const Parameter_range& range) {
  if (!f.proper) return prove_bca(piece, f, range);
  constexpr mpfr_prec_t FIRST = 128, LAST = 4096;  // bits
  for (mpfr_prec_t precision = FIRST; precision <= LAST; precision *= 2) {
    try {
      const Osculating_proof proof(construction, {piece, f, range, precision});
      if (proof.form() == Region_form::BCA) return prove_bca(piece, f, range);
      const Proof result = proof.contained();
      if (result != Proof::UNDECIDED) return result;
    } catch (const CGAL::Uncertain_conversion_exception&) {  // a comparison of intervals: try a higher precision
    }
  }
  return Proof::UNDECIDED;
}

// The region is the one that the construction makes of the shape, whatever it steps back to.
// \param reached set to the largest distance of the points left out from the ends that they are next to, in units of
//   the shape
Proof prove_containment(const Proven_construction& construction, const Exact_piece& exact, const Trims& trims = {},
                        double* reached = nullptr) {
  const Chord_shape_2<Rational>& f = exact.shape;
  const Containment_piece piece = containment_piece(exact.piece, f);
  const Rational &at_tight = f.tight_first ? trims.start : trims.end,
                 &at_flat = f.tight_first ? trims.end : trims.start;
  const Parameter_range range{at_tight, Rational(1 - at_flat)};
  if (reached != nullptr)
    *reached = (std::max)(reach(piece.tight, {Rational(0), range.low}), reach(piece.flat, {range.high, Rational(1)}));
  if (construction.polygon || construction.strip) return prove_outline(construction, piece, f, range);
  if (construction.needs_curvature) return prove_strict_piece(construction, piece, f, range);
  return construction.exact ? prove_between_arcs(construction, piece, f, range) : prove_bca(piece, f, range);
}

// Parameters of cuts are roots rounded to double, and of roots within CUT_WIDTH one is the cut: at an end that was cut,
// or that is the curve's own, the piece may hold that much of parameter that is not part of the spiral. The region then
// holds all but what is within a distance of the end, which is tried from there on up to `limit`.
std::optional<double> prove_but_for_ends(const Proven_construction& construction, const Region_question& piece,
                                         double limit) {
  constexpr double GROWTH = 8,
                   LARGEST = 0x1p-39;  // of parameters; at a cut a curve departs from its region like a power of them
  const bool at_first = piece.t0 == piece.first, at_last = piece.t1 == piece.last;
  for (double width = CUT_WIDTH; width <= LARGEST && width < (piece.t1 - piece.t0) / 4; width *= GROWTH) {
    const Rational share = Rational(width) / Rational(Rational(piece.t1) - Rational(piece.t0));
    double distance = 0;
    const Proof proof = prove_containment(construction, piece.exact,
                                          {at_first ? share : Rational(0), at_last ? share : Rational(0)}, &distance);
    distance *= CGAL::to_interval(piece.exact.shape.unit).second * (1 + 0x1p-50);
    if (!(distance <= limit)) break;
    if (proof == Proof::PROVEN) return distance;
  }
  return std::nullopt;
}

}  // namespace
}  // namespace verify

namespace internal {

using verify::Proof;

Region_proof prove_region(const Proven_construction& construction, const Region_question& piece, double eps) {
  const Exact_piece& exact = piece.exact;
  const Proof proof = verify::prove_containment(construction, exact);
  if (proof == Proof::PROVEN) return {Containment::PROVEN, 0};
  if (piece.t0 == piece.first || piece.t1 == piece.last) {
    if (construction.needs_curvature && exact.shape.proper)
      for (const double slack : verify::SLIVER_SLACKS) {
        const Exact_piece widened{exact.piece, verify::with_curvature_bounds(exact.shape, slack)};
        if (construction.most_thickness(widened.shape) > eps) break;
        if (verify::prove_containment(construction, widened) == Proof::PROVEN)
          return {Containment::PROVEN_AS_SLIVER, 0};
      }
    if (const auto slack = verify::prove_but_for_ends(construction, piece, eps / 2))
      return {Containment::PROVEN_AS_SLIVER, *slack};
    // where a cut stands for several roots the piece need not be a spiral at all, by what coordinates and cuts do not
    // resolve
    if (piece.outside) {
      const double limit = (std::min)(eps / 2, piece.resolution), slack = piece.outside(limit / 2);
      if (slack <= limit) return {Containment::PROVEN_AS_SLIVER, slack};
    }
  }
  return {proof == Proof::DISPROVED ? Containment::DISPROVED : Containment::UNDECIDED, 0};
}

std::optional<bool> prove_thickness(const Proven_construction& construction, const Chord_shape_2<Exact_rational>& shape,
                                    double thickness) {
  const Exact_rational length = Exact_rational(thickness) / shape.unit;
  if (construction.polygon || construction.strip) return verify::prove_outline_thickness(construction, shape, length);
  return verify::prove_thickness(
      [&](mpfr_prec_t bits) { return construction.enclosed(verify::enclosed_frame(shape, bits)); }, length);
}

}  // namespace internal
}  // namespace CGAL::Bounding_arcs
