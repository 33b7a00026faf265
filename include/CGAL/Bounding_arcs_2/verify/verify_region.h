// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Is a curve piece inside its bounding region?  Proven, not sampled: the region is the exact one over the exact curve
// that the given control points and parameters define.

#ifndef CGAL_BOUNDING_ARCS_2_VERIFY_VERIFY_REGION_H
#define CGAL_BOUNDING_ARCS_2_VERIFY_VERIFY_REGION_H

#include <CGAL/Bounding_arcs_2/region/thickness_bound.h>
#include <CGAL/Bounding_arcs_2/verify/prove_osculating.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <type_traits>

namespace CGAL::Bounding_arcs {

enum class Containment {
  PROVEN,           ///< the piece lies in the method's region
  PROVEN_AS_SLIVER, ///< proven with a curvature bound in place of the curvature at an end that lies past a vertex
  DISPROVED,        ///< the piece leaves the region
  UNDECIDED         ///< not decided within the highest precision
};

namespace internal {

// Past a vertex by a few spacings of parameters the curvature exceeds its end value by about the square of that spacing,
// relative, but by more where it changes quickly, next to a near-cusp: each slack is tried in turn while the region
// stays thin enough. The first adds no more than 2^-44 of its sagitta to a region's thickness.
inline constexpr double SLIVER_SLACKS[] = {0x1p-44, 0x1p-24, 0x1p-10, 0x1p-4};

/// The shape with the tight end's curvature raised and the flat end's lowered by a share of the larger one: a region that holds the
/// curve although an end was cut past a vertex.
[[nodiscard]] inline Chord_shape_2<Rational> with_curvature_bounds(Chord_shape_2<Rational> f, double share) {
  const Rational cc = dot(f.chord, f.chord);
  // K over c is curvature over |t|^3; any amount of widening serves a proof, so doubles will do here
  const auto cube = [](const Xy<Rational>& t) { return std::pow(CGAL::to_double(Rational(dot(t, t))), 1.5); };
  const double cube0 = cube(f.tangent0), cube1 = cube(f.tangent1);
  const double largest = (std::max)(std::fabs(CGAL::to_double(f.curvature0)) / cube0, std::fabs(CGAL::to_double(f.curvature1)) / cube1);
  const auto widen = [&](bool start, bool raise) {
    if (start ? f.infinite0 : f.infinite1) return;
    const Rational change((raise ? f.turn : -f.turn) * share * largest * (start ? cube0 : cube1));
    (start ? f.curvature0 : f.curvature1) += change;
    if (start) f.kneser0 += change * cc;
    else f.kneser1 -= change * cc;
  };
  widen(f.tight_first, true);
  widen(!f.tight_first, false);
  orient(f);
  return f;
}

/// The region is the one that the construction makes of the shape, whatever it steps back to.
template <class Construction>
[[nodiscard]] Proof prove_containment(const Construction& construction, const Relative_piece<Rational>& piece,
                                      const Chord_shape_2<Rational>& f) {
  const End_view start = start_view(piece, f), end = end_view(piece, f);
  const End_view &tight = f.tight_first ? start : end, &flat = f.tight_first ? end : start;
  if constexpr (Construction::NEEDS_CURVATURE) {
    if (!f.proper) return prove_bca(tight, flat, f);
    constexpr mpfr_prec_t FIRST = 128, LAST = 4096;  // bits
    for (mpfr_prec_t precision = FIRST; precision <= LAST; precision *= 2) {
      try {
        const Osculating_proof proof(construction, tight, flat, f, precision);
        if (proof.form() == Region_form::BCA) return prove_bca(tight, flat, f);
        const Proof result = proof.contained();
        if (result != Proof::UNDECIDED) return result;
      } catch (const CGAL::Uncertain_conversion_exception&) {  // a comparison of intervals: try a higher precision
      }
    }
    return Proof::UNDECIDED;
  } else {
    return prove_bca(tight, flat, f);
  }
}

}  // namespace internal

/// Whether the piece [t0, t1] of a spiral segment lies in its region.
/// \tparam Construction Bca, Spiral_fat_arc, Bilens, or one of the latter two in Near_circular_to_bca
/// \tparam Spiral Bezier_spiral_2 over a number type whose exact type is CGAL::Exact_rational
/// \param eps the thickness that a region widened for a sliver may not exceed
/// \guarantee PROVEN and PROVEN_AS_SLIVER are proofs: exact rational arithmetic for BCA, for the others rational
///   arithmetic and MPFR intervals of up to 4096 bits
/// \complexity some ten microseconds for BCA of a cubic, some hundred for the others
template <class Construction, class Spiral>
[[nodiscard]] Containment verify_region(const Spiral& spiral, double t0, double t1,
                                        double eps = std::numeric_limits<double>::infinity(),
                                        const Construction& construction = {}) {
  static_assert(!Construction::NEEDS_CONTROL_POINTS, "no proof for this construction");
  using internal::Proof;
  using internal::Rational;
  static_assert(std::is_same_v<typename Spiral::Exact_number_type, Rational>, "verification needs rational curves");
  const auto piece = internal::relative_piece(spiral.exact_table(), Rational(t0), Rational(t1));
  const auto shape = spiral.template shape<Rational>(t0, t1);
  const Proof proof = internal::prove_containment(construction, piece, shape);
  if (proof == Proof::PROVEN) return Containment::PROVEN;
  const bool at_cut = t0 == spiral.first() || t1 == spiral.last();
  if (Construction::NEEDS_CURVATURE && shape.proper && at_cut)
    for (const double slack : internal::SLIVER_SLACKS) {
      const auto widened = internal::with_curvature_bounds(shape, slack);
      if (internal::thickness_interval(construction, widened).sup() > eps) break;
      if (internal::prove_containment(construction, piece, widened) == Proof::PROVEN) return Containment::PROVEN_AS_SLIVER;
    }
  return proof == Proof::DISPROVED ? Containment::DISPROVED : Containment::UNDECIDED;
}

}  // namespace CGAL::Bounding_arcs

#endif
