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
  double widening = 0;       ///< in units of the plane; infinite where none is known
  bool is_certified = true;  ///< the widening is at most MOST_ULPS units in the last place of the coordinates
  bool is_other = false;     ///< the region is not the one that was asked for
};

/// Certifies the region of the piece [t0, t1].
/// \param other () -> the region to step back to where the widening is above MOST_ULPS ulp, as that of a BCA
/// \guarantee the region, widened, holds every point of the piece of the exact curve of the control points, slivers
///   past a rounded vertex or cusp included. The widening is at most 1.25 times the bound of outside_bound.
/// \complexity some ten microseconds for a cubic
template <class Spiral, class Other>
[[nodiscard]] Certified_arcs_2 certified_arcs(const Spiral& spiral, double t0, double t1, const Arc_region_2& region,
                                              const Other& other) {
  const double ulp = (std::max)(internal::ulp_of(spiral.coordinate_size()), LEAST_ULP), most = MOST_ULPS * ulp;
  const auto widening = [&](const Arc_region_2& r) {
    return ROOM_OF_WIDENING * outside_bound(spiral, t0, t1, boundary_of(r), ulp / 2);
  };
  Certified_arcs_2 result{region, widening(region)};
  if (result.widening <= most) return result;
  const Arc_region_2 instead = other();
  const double less = widening(instead);
  if (less < result.widening) result = {instead, less, true, true};
  result.is_certified = result.widening <= most;
  return result;
}

}  // namespace CGAL::Bounding_arcs

#endif
