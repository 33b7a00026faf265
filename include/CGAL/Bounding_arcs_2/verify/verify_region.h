// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Is a curve piece inside its bounding region?  Proven, not sampled: the region is the exact one over the exact curve
// that the given control points and parameters define.

#ifndef CGAL_BOUNDING_ARCS_2_VERIFY_VERIFY_REGION_H
#define CGAL_BOUNDING_ARCS_2_VERIFY_VERIFY_REGION_H

#include <CGAL/Bounding_arcs_2/region/thickness_bound.h>
#include <CGAL/Bounding_arcs_2/spiral/spiral_parameters.h>
#include <CGAL/Bounding_arcs_2/verify/internal/prove_osculating.h>
#include <CGAL/Bounding_arcs_2/verify/internal/prove_outline.h>
#include <CGAL/Bounding_arcs_2/verify/outside_bound.h>
#include <CGAL/Bounding_arcs_2/verify/prove_thickness.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <type_traits>

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
  } else {
    return prove_bca(piece, f, range);
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
/// \tparam Construction Bca, Spiral_fat_arc, Bilens, one of the latter two in Near_circular_to_bca, or one with regions
///   that have outlines
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
