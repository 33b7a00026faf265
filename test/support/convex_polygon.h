// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Convex hulls of points, by CGAL.

#ifndef BOUNDING_ARCS_TEST_CONVEX_POLYGON_H
#define BOUNDING_ARCS_TEST_CONVEX_POLYGON_H

#include <CGAL/Bounding_arcs_2/number/Xy.h>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/ch_graham_andrew.h>

#include <iterator>
#include <vector>

namespace bounding_arcs_test {

/// The corners of the convex hull of some points, counterclockwise.
inline std::vector<CGAL::Bounding_arcs::Xy<double>> convex_polygon(
    const std::vector<CGAL::Bounding_arcs::Xy<double>>& points) {
  using Point = CGAL::Exact_predicates_inexact_constructions_kernel::Point_2;
  std::vector<Point> all, hull;
  for (const auto& p : points) all.emplace_back(p.x, p.y);
  CGAL::ch_graham_andrew(all.begin(), all.end(), std::back_inserter(hull));
  std::vector<CGAL::Bounding_arcs::Xy<double>> result;
  for (const Point& p : hull) result.push_back({p.x(), p.y()});
  return result;
}

}  // namespace bounding_arcs_test

#endif
