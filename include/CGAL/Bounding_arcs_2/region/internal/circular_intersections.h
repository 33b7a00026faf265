// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Intersections of the circular kernel, in whichever variant the CGAL version at hand returns them.

#ifndef CGAL_BOUNDING_ARCS_2_REGION_INTERNAL_CIRCULAR_INTERSECTIONS_H
#define CGAL_BOUNDING_ARCS_2_REGION_INTERNAL_CIRCULAR_INTERSECTIONS_H

#include <CGAL/Bounding_arcs_2/region/variant.h>

#include <CGAL/Circular_kernel_intersections.h>

#include <iterator>
#include <utility>
#include <vector>

namespace CGAL::Bounding_arcs::internal {

/// The points a line and a circle share, in lexicographic order; none, one or two.
template <class CK>
[[nodiscard]] std::vector<typename CK::Circular_arc_point_2> intersection_points(const typename CK::Line_2& line,
                                                                                 const typename CK::Circle_2& circle) {
  using Point = std::pair<typename CK::Circular_arc_point_2, unsigned>;
  using Line_2 = typename CK::Line_2;
  using Circle_2 = typename CK::Circle_2;
  std::vector<typename CGAL::CK2_Intersection_traits<CK, Line_2, Circle_2>::type> found;
  CK().intersect_2_object()(line, circle, std::back_inserter(found));
  std::vector<typename CK::Circular_arc_point_2> points;
  for (const auto& object : found)
    if (const Point* p = get_if<Point>(object)) points.push_back(p->first);
  return points;
}

}  // namespace CGAL::Bounding_arcs::internal

#endif
