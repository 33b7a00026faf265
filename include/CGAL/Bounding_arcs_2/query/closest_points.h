// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// All points of a drawing that are about as near as the nearest one, and the nearest curves.

#ifndef CGAL_BOUNDING_ARCS_2_QUERY_CLOSEST_POINTS_H
#define CGAL_BOUNDING_ARCS_2_QUERY_CLOSEST_POINTS_H

#include <CGAL/Bounding_arcs_2/query/closest_point.h>
#include <CGAL/Bounding_arcs_2/query/internal/queries_in_doubles.h>
#include <CGAL/Bounding_arcs_2/query/kernel_points.h>

#include <cstddef>
#include <vector>

namespace CGAL::Bounding_arcs {

/// Returns all local nearest points that are about as near as the nearest one, nearest ones first. A point of a
/// curve is a local nearest one if no neighbour along the curve is nearer to q. It is returned if its distance is at
/// most eps above the least one.
/// \param eps a length, positive
/// \return nothing of an empty tree; one point for an arc of points that are equally near
/// \guarantee each bracket is certified. No such point is missing, except one that doubles cannot tell from a point
///   that is returned
/// \complexity the logarithm of the number of segments and the number of segments within the distance
/// \throws std::invalid_argument for a point that is no number and unless eps is a positive number
template <class Point = Default_kernel::Point_2>
[[nodiscard]] std::vector<Closest_point<Point>> closest_points(const Bounding_arc_tree_2& tree, const Point& q,
                                                               double eps) {
  return internal::answered<Closest_point<Point>>(internal::closest_points(tree, q, eps));
}

/// Returns the nearest point of each of the k curves that are nearest to q, nearest ones first.
/// \return as many as there are curves where that is less than k
/// \guarantee as closest_point
/// \complexity about the logarithm of the number of segments for each of k curves, and k^2
/// \throws std::invalid_argument for a point that is no number
template <class Point = Default_kernel::Point_2>
[[nodiscard]] std::vector<Closest_point<Point>> k_nearest_curves(const Bounding_arc_tree_2& tree, const Point& q,
                                                                 std::size_t k) {
  return internal::answered<Closest_point<Point>>(internal::k_nearest_curves(tree, q, k));
}

}  // namespace CGAL::Bounding_arcs

#endif
