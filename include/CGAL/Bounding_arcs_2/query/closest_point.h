// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The point of a drawing nearest to a point, or to each of many points, with its distance between two bounds; all
// points that are about as near, and the nearest curves.

#ifndef CGAL_BOUNDING_ARCS_2_QUERY_CLOSEST_POINT_H
#define CGAL_BOUNDING_ARCS_2_QUERY_CLOSEST_POINT_H

#include <CGAL/Bounding_arcs_2/query/Query_point.h>
#include <CGAL/Bounding_arcs_2/query/kernel_points.h>
#include <CGAL/Bounding_arcs_2/tree/Bounding_arc_tree_2.h>
#include <CGAL/Bounding_arcs_2/tree/for_each_index.h>

#include <cstddef>
#include <optional>
#include <vector>

namespace CGAL::Bounding_arcs {

namespace internal {
[[nodiscard]] std::optional<Closest_point<>> closest_point(const Bounding_arc_tree_2& tree, const Asked_point& q);
[[nodiscard]] std::optional<Closest_point<>> closest_point(const Bounding_arc_tree_2& tree, const Asked_point& q,
                                                           const Curve_place& near);
[[nodiscard]] std::vector<Closest_point<>> closest_points(const Bounding_arc_tree_2& tree, const Asked_point& q,
                                                          double eps);
[[nodiscard]] std::vector<Closest_point<>> k_nearest_curves(const Bounding_arc_tree_2& tree, const Asked_point& q,
                                                            std::size_t k);
}  // namespace internal

/// Returns the point of the tree's curves that is nearest to q, one of them where there are several.
/// \tparam Point of any kernel
/// \param q exact where its numbers are
/// \return nothing of an empty tree
/// \guarantee the bracket is certified; it is some roundings of coordinates and distance wide, but next to cusps and
///   centers of curvature, where it may be wider
/// \complexity about logarithmic in the number of segments
/// \throws std::invalid_argument for a point that is no number
template <class Point = Default_kernel::Point_2>
[[nodiscard]] std::optional<Closest_point<Point>> closest_point(const Bounding_arc_tree_2& tree, const Point& q) {
  return internal::closest_point(tree, q);
}

/// Returns the same by way of a place near to the result, that of a neighbouring point, say. That only makes it faster.
/// \param near a place of these curves
template <class Point = Default_kernel::Point_2>
[[nodiscard]] std::optional<Closest_point<Point>> closest_point(const Bounding_arc_tree_2& tree, const Point& q,
                                                                const Curve_place& near) {
  return internal::closest_point(tree, q, near);
}

/// Returns the nearest points to many points, in their order.
/// \tparam ConcurrencyTag CGAL::Sequential_tag or CGAL::Parallel_tag, which needs TBB; where several points are
///   nearest, the two may answer with different ones
/// \param points a range of points of any kernel; each search starts from the place before, so that neighbours had
///   better be in order
/// \return as many as there are points, or none of an empty tree
/// \guarantee as closest_point
/// \throws std::invalid_argument for a point that is no number
template <class ConcurrencyTag = CGAL::Sequential_tag, class Points>
[[nodiscard]] std::vector<Closest_point<internal::Element_of<Points>>> closest_points_of_all(
    const Bounding_arc_tree_2& tree, const Points& points) {
  const std::vector<Asked_point> places = internal::asked(points);
  for (const Asked_point& q : places) internal::check_point(q.point);
  if (tree.empty()) return {};
  std::vector<Closest_point<>> results(places.size());
  internal::for_each_range<ConcurrencyTag>(places.size(), [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i)
      results[i] = i == begin ? *internal::closest_point(tree, places[i])
                              : *internal::closest_point(tree, places[i], results[i - 1].place);
  });
  return internal::answered<Closest_point<internal::Element_of<Points>>>(results);
}

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
