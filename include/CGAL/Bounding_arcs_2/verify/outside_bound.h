// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// How far an exact curve piece leaves the region within a boundary of floating numbers, proven from above.

#ifndef CGAL_BOUNDING_ARCS_2_VERIFY_OUTSIDE_BOUND_H
#define CGAL_BOUNDING_ARCS_2_VERIFY_OUTSIDE_BOUND_H

#include <CGAL/Bounding_arcs_2/verify/internal/Outside_proof.h>

#include <cmath>
#include <type_traits>

namespace CGAL::Bounding_arcs {
namespace verify {

template <class FT> [[nodiscard]] bool is_finite(const Region_boundary_2<FT>& boundary) {
  for (const auto* chain : {&boundary.inner, &boundary.outer})
    for (const Boundary_piece_2<FT>& p : *chain)
      for (const FT x : {p.from.x, p.from.y, p.to.x, p.to.y, p.support.point.x, p.support.point.y, p.support.normal.x,
                         p.support.normal.y, p.support.curvature})
        if (!std::isfinite(x)) return false;
  return true;
}

/// See outside_bound, in exact numbers throughout.
template <class Spiral, class FT>
[[nodiscard]] double exact_outside_bound(const Spiral& spiral, double t0, double t1,
                                         const Region_boundary_2<FT>& boundary, double goal, Boundary_origin origin) {
  return Outside_proof<typename Spiral::Exact_number_type>(spiral, t0, t1, boundary, goal, origin).bound();
}

}  // namespace verify

/// A proven upper bound of the largest distance of a point of the curve piece [t0, t1] from the region that a boundary
/// encloses.  The curve is the exact one of its control points, the boundary's numbers are taken for what they are. The
/// region holds the arcs themselves, their end points, and what lies between the normals at the ends, at each place on
/// the inner side of the outer chain and on the outer side of the inner chain; a joint's normal is that of the first of
/// its two circles.
/// \param boundary over float, double or long double
/// \param goal a distance below which the bound need not be any better
/// \param origin what the boundary's numbers count from
/// \return the bound in units of the plane; 0 where the piece is in the region; infinity where a number of the
///   boundary is not finite or no bound is found
/// \guarantee certified; about a tenth above the least such bound, but for boundaries whose arcs are far from one
///   another at joints and ends
/// \complexity some ten microseconds for a cubic where double-doubles decide, some milliseconds in rational arithmetic
template <class Spiral, class FT>
[[nodiscard]] double outside_bound(const Spiral& spiral, double t0, double t1, const Region_boundary_2<FT>& boundary,
                                   double goal = 0, verify::Boundary_origin origin = verify::Boundary_origin::PLANE) {
  static_assert(std::is_floating_point_v<FT>,
                "boundaries of floating numbers only: exact ones are proven by verify_region");
  // Double-doubles whose errors cut no ends off or let no sign be told, as those of high degrees, have bounds far above
  // any distance that is seen.
  constexpr double FAR = 2;
  if (!verify::is_finite(boundary)) return verify::INFINITE;
  const verify::Outside_proof<Double_double> rough(spiral, t0, t1, boundary, goal, origin);
  const auto [most, seen] = rough.bounds();
  if (most <= goal || (std::isfinite(most) && rough.is_significant(most) && most <= FAR * seen)) return most;
  return verify::exact_outside_bound(spiral, t0, t1, boundary, goal, origin);
}

/// Whether every point of the piece is proven to be at most `widening` away from the region: that the Minkowski sum of
/// the region and a disc of that radius holds the piece.
/// \guarantee true is a proof; false means disproved or undecided, in rational arithmetic
template <class Spiral, class FT>
[[nodiscard]] bool is_within(const Spiral& spiral, double t0, double t1, const Region_boundary_2<FT>& boundary,
                             double widening) {
  // A search that ends at the widening leaves no room for what joints add to it. What ends are cut off by depends on
  // the goal in steps, so that a lower one may tell less: the middle one is near to where a widening was found.
  for (const double goal : {widening, 0.64 * widening, 0.5 * widening})
    if (outside_bound(spiral, t0, t1, boundary, goal) <= widening) return true;
  return verify::is_finite(boundary) && verify::exact_outside_bound(spiral, t0, t1, boundary, widening / 2,
                                                                    verify::Boundary_origin::PLANE) <= widening;
}

}  // namespace CGAL::Bounding_arcs

#endif
