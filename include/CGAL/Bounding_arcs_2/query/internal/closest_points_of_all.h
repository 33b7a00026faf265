// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The nearest points to many points.

#ifndef CGAL_BOUNDING_ARCS_2_QUERY_INTERNAL_CLOSEST_POINTS_OF_ALL_H
#define CGAL_BOUNDING_ARCS_2_QUERY_INTERNAL_CLOSEST_POINTS_OF_ALL_H

#include <CGAL/Bounding_arcs_2/query/Query_point.h>
#include <CGAL/Bounding_arcs_2/query/internal/point_queries.h>
#include <CGAL/Bounding_arcs_2/tree/for_each_index.h>

#include <cstddef>
#include <vector>

namespace CGAL::Bounding_arcs::internal {

template <class ConcurrencyTag = CGAL::Sequential_tag>
[[nodiscard]] std::vector<Closest_point<>> closest_points_of_all(const Bounding_arc_tree_2& curves,
                                                                 const std::vector<Asked_point>& points) {
  for (const Asked_point& q : points) check_point(q.point);
  if (curves.empty()) return {};
  std::vector<Closest_point<>> results(points.size());
  for_each_range<ConcurrencyTag>(points.size(), [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i)
      results[i] =
          i == begin ? *closest_point(curves, points[i]) : *closest_point(curves, points[i], results[i - 1].place);
  });
  return results;
}

}  // namespace CGAL::Bounding_arcs::internal

#endif
