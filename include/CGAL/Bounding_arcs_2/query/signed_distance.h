// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The distance of a point, or of each of many points, from closed curves: less than 0 inside.

#ifndef CGAL_BOUNDING_ARCS_2_QUERY_SIGNED_DISTANCE_H
#define CGAL_BOUNDING_ARCS_2_QUERY_SIGNED_DISTANCE_H

#include <CGAL/Bounding_arcs_2/number/stable_norm.h>
#include <CGAL/Bounding_arcs_2/query/Query_point.h>
#include <CGAL/Bounding_arcs_2/query/closest_point.h>
#include <CGAL/Bounding_arcs_2/query/kernel_points.h>
#include <CGAL/Bounding_arcs_2/query/point_location.h>

#include <cmath>
#include <cstddef>
#include <optional>
#include <vector>

namespace CGAL::Bounding_arcs::internal {

/// A distance with the sign of a side; 0 on a curve.
[[nodiscard]] inline Signed_distance<> with_side(const Closest_point<>& found, const Uncertain<Bounded_side>& side) {
  Bracket d = found.distance;
  if (!is_certain(side)) d = {-d.upper, d.upper};
  else if (side == ON_BOUNDARY) d = {0, 0};
  else if (side == ON_BOUNDED_SIDE) d = {0 - d.upper, 0 - d.lower};  // no -0
  return {d, side, found.point, found.place, found.status};
}

[[nodiscard]] inline std::optional<Signed_distance<>> signed_distance(const Bounding_arc_tree_2& curves,
                                                                      const Asked_point& q,
                                                                      Fill_rule rule = Fill_rule::NONZERO) {
  const Point_location_2 location(curves);
  const auto found = closest_point(curves, q);
  if (!found) return std::nullopt;
  return with_side(*found, location.locate(q, rule));
}

template <class ConcurrencyTag = CGAL::Sequential_tag>
[[nodiscard]] std::vector<Signed_distance<>> signed_distances_of_all(const Bounding_arc_tree_2& curves,
                                                                     const std::vector<Asked_point>& points,
                                                                     Fill_rule rule = Fill_rule::NONZERO) {
  const Point_location_2 location(curves);
  const std::vector<Closest_point<>> closest = closest_points_of_all<ConcurrencyTag>(curves, points);
  std::vector<Signed_distance<>> results(closest.size());
  for_each_range<ConcurrencyTag>(closest.size(), [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) {
      constexpr double UP = ROUNDED_UP<8>;  // a difference and a norm
      const auto is_near = [&](const Asked_point& p, const Asked_point& q) {
        const double way = stable_norm(p.point - q.point) + (p.error + q.error);
        return way * UP < closest[i - 1].distance.lower;
      };
      const bool is_same_side = i > begin && is_certain(results[i - 1].side) && is_near(points[i], points[i - 1]);
      results[i] = with_side(closest[i], is_same_side ? results[i - 1].side : location.locate(points[i], rule));
    }
  });
  return results;
}

}  // namespace CGAL::Bounding_arcs::internal

namespace CGAL::Bounding_arcs {

/// Returns the distance of q from closed curves, less than 0 where a fill rule has it inside, and a nearest point.
/// \return nothing of an empty drawing
/// \guarantee the bracket is certified and as wide as that of closest_point; the side is right for every point with an
///   index for exact decisions. Without these it may be undecided, next to a curve: then the bracket has both signs
/// \complexity as for closest_point and Point_location_2
/// \throws std::invalid_argument if a curve is open, with its name, or for a point that is no number
template <class Point = Default_kernel::Point_2>
[[nodiscard]] std::optional<Signed_distance<Point>> signed_distance(const Bounding_arc_tree_2& tree, const Point& q,
                                                                    Fill_rule rule = Fill_rule::NONZERO) {
  return internal::signed_distance(tree, q, rule);
}

/// Returns the signed distances of many points, in their order. A point that is nearer to the one before than that is
/// to all curves is on the same side.
/// \tparam ConcurrencyTag CGAL::Sequential_tag or CGAL::Parallel_tag, which needs TBB
/// \param points a range of points of any kernel; neighbours had better be in order
/// \return as many as there are points, or none of an empty tree
/// \guarantee as signed_distance
/// \throws std::invalid_argument as signed_distance
template <class ConcurrencyTag = CGAL::Sequential_tag, class Points>
[[nodiscard]] std::vector<Signed_distance<Element_of<Points>>> signed_distances_of_all(
    const Bounding_arc_tree_2& tree, const Points& points, Fill_rule rule = Fill_rule::NONZERO) {
  return answered<Signed_distance<Element_of<Points>>>(
      internal::signed_distances_of_all<ConcurrencyTag>(tree, asked(points), rule));
}

}  // namespace CGAL::Bounding_arcs

#endif
