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
  const Point_location_2 location(tree);
  const auto found = closest_point(tree, q);
  if (!found) return std::nullopt;
  return Signed_distance<Point>::of(*found, location.locate(q, rule));
}

/// Returns the signed distances of many points, in their order. A point that is nearer to the one before than that is
/// to all curves is on the same side.
/// \tparam ConcurrencyTag CGAL::Sequential_tag or CGAL::Parallel_tag, which needs TBB
/// \param points a range of points of any kernel; neighbours had better be in order
/// \return as many as there are points, or none of an empty tree
/// \guarantee as signed_distance
/// \throws std::invalid_argument as signed_distance
template <class ConcurrencyTag = CGAL::Sequential_tag, class Points>
[[nodiscard]] std::vector<Signed_distance<internal::Element_of<Points>>> signed_distances_of_all(
    const Bounding_arc_tree_2& tree, const Points& points, Fill_rule rule = Fill_rule::NONZERO) {
  const Point_location_2 location(tree);
  const std::vector<Asked_point> places = internal::asked(points);
  const auto closest = closest_points_of_all<ConcurrencyTag>(tree, points);
  std::vector<Uncertain<Bounded_side>> sides(closest.size());
  internal::for_each_range<ConcurrencyTag>(closest.size(), [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) {
      constexpr double UP = ROUNDED_UP<8>;  // a difference and a norm
      const auto is_near = [&](const Asked_point& p, const Asked_point& q) {
        const double way = stable_norm(p.point - q.point) + (p.error + q.error);
        return way * UP < closest[i - 1].distance.lower;
      };
      const bool is_same_side = i > begin && is_certain(sides[i - 1]) && is_near(places[i], places[i - 1]);
      sides[i] = is_same_side ? sides[i - 1] : location.locate(places[i], rule);
    }
  });
  std::vector<Signed_distance<internal::Element_of<Points>>> results;
  for (std::size_t i = 0; i < closest.size(); ++i)
    results.push_back(Signed_distance<internal::Element_of<Points>>::of(closest[i], sides[i]));
  return results;
}

}  // namespace CGAL::Bounding_arcs

#endif
