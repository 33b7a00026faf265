// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Regions in hand, as they are written, and by how much they must be moved outward to hold the exact curve.

#ifndef CGAL_BOUNDING_ARCS_2_VERIFY_CERTIFIED_ARCS_H
#define CGAL_BOUNDING_ARCS_2_VERIFY_CERTIFIED_ARCS_H

#include <CGAL/Bounding_arcs_2/region/Arc_region_2.h>
#include <CGAL/Bounding_arcs_2/verify/Certified_traits_2.h>

#include <algorithm>

namespace CGAL::Bounding_arcs {

/// The set of points at most `widening` away from a region in hand.
struct Certified_arcs_2 {
  Arc_region_2 region;
  double thickness = 0;      ///< a certified upper bound of the exact region's
  double widening = 0;       ///< in units of the plane; infinite where none is known
  bool is_certified = true;  ///< the widening is at most MOST_ULPS units in the last place of the coordinates
  bool is_other = false;     ///< the region is not the one that was asked for but a BCA
};

/// Certifies the region of the piece [t0, t1], and steps back to its BCA where the widening is above MOST_ULPS ulp.
/// That BCA may be thicker than eps, see for_each_thin_piece.
/// \param thickness of the construction's region, an upper bound
/// \param arcs arcs(construction) -> the region of the piece that a construction makes, in hand
/// \guarantee the region, widened, holds every point of the piece of the exact curve of the control points, slivers
///   past a rounded vertex or cusp included. The widening is at most 1.25 times the bound of outside_bound.
/// \complexity some ten microseconds for a cubic
template <class Construction, class Spiral, class Arcs>
[[nodiscard]] Certified_arcs_2 certified_arcs(const Construction& construction, const Spiral& spiral, double t0,
                                              double t1, double eps, double thickness, const Arcs& arcs) {
  const double ulp = (std::max)(ulp_of(spiral.coordinate_size()), LEAST_ULP), most = MOST_ULPS * ulp;
  const auto certified = [&](const Arc_region_2& r, double thick) {
    const double widening = ROOM_OF_WIDENING * outside_bound(spiral, t0, t1, boundary_of(r), ulp / 2);
    return Certified_arcs_2{r, thick, widening, widening <= most};
  };
  const Certified_arcs_2 own = certified(arcs(construction), thickness);
  if (own.is_certified && own.thickness <= eps) return own;
  Certified_arcs_2 other = certified(arcs(Bca()), certified_thickness(Bca(), spiral, t0, t1, eps));
  other.is_other = true;
  if (other.is_certified && other.thickness <= eps) return other;
  if (own.is_certified != other.is_certified) return own.is_certified ? own : other;
  if (own.is_certified) return other.thickness < own.thickness ? other : own;
  return other.widening < own.widening && other.thickness <= eps ? other : own;
}

}  // namespace CGAL::Bounding_arcs

#endif
