// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The distance of a point, or of each of many points, from closed curves: less than 0 inside.

#ifndef CGAL_BOUNDING_ARCS_2_QUERY_SIGNED_DISTANCE_H
#define CGAL_BOUNDING_ARCS_2_QUERY_SIGNED_DISTANCE_H

#include <CGAL/Bounding_arcs_2/query/closest_point.h>
#include <CGAL/Bounding_arcs_2/query/point_location.h>

#include <cmath>
#include <cstddef>
#include <optional>
#include <vector>

namespace CGAL::Bounding_arcs {

/// A distance with the side, and where it is measured.
struct Signed_distance {
  Distance_bounds
      distance;  ///< of the exact curves, with its sign: both bounds are at most 0 inside, both 0 on a curve
  Point_side side;
  Xy<double> point;  ///< the nearest one, on the curve but for rounding
  Curve_place place;
  Query_status status = Query_status::COMPLETE;
};

namespace signed_distances {

/// A distance with the sign of a side; 0 on a curve.
[[nodiscard]] inline Signed_distance with_side(const Closest_point& found, Point_side side) {
  Distance_bounds d = found.distance;
  switch (side) {
    case Point_side::INSIDE:
      d = {0 - d.upper, 0 - d.lower};  // no -0
      break;
    case Point_side::OUTSIDE:
      break;
    case Point_side::ON:
      d = {0, 0};
      break;
    case Point_side::UNDECIDED:
      d = {-d.upper, d.upper};
      break;
  }
  return {d, side, found.point, found.place, found.status};
}

}  // namespace signed_distances

/// The distance of q from closed curves, less than 0 where a fill rule has it inside, and a nearest point.
/// \return nothing of an empty drawing
/// \guarantee the bracket is certified and as wide as that of closest_point; the side is right for every point with an
///   index for exact decisions. Without these it may be undecided, next to a curve: then the bracket has both signs
/// \complexity as for closest_point and Point_location_2
/// \throws std::invalid_argument if a curve is open, with its name, or for a point that is no number
[[nodiscard]] inline std::optional<Signed_distance> signed_distance(const Curve_index_2& index, const Xy<double>& q,
                                                                    Fill_rule rule = Fill_rule::NONZERO) {
  const Point_location_2 location(index);
  const auto found = closest_point(index, q);
  if (!found) return std::nullopt;
  return signed_distances::with_side(*found, location.locate(q, rule));
}

/// The signed distances of many points, in their order. A point that is nearer to the one before than that is to all
/// curves is on the same side.
/// \tparam ConcurrencyTag CGAL::Sequential_tag or CGAL::Parallel_tag, which needs TBB
/// \return as many as there are points, or none of an empty drawing
/// \guarantee as signed_distance; neighbours had better be in order
/// \throws std::invalid_argument as signed_distance
template <class ConcurrencyTag = CGAL::Sequential_tag>
[[nodiscard]] std::vector<Signed_distance> signed_distances_of_all(const Curve_index_2& index,
                                                                   const std::vector<Xy<double>>& points,
                                                                   Fill_rule rule = Fill_rule::NONZERO) {
  const Point_location_2 location(index);
  const std::vector<Closest_point> closest = closest_points_of_all<ConcurrencyTag>(index, points);
  std::vector<Signed_distance> results(closest.size());
  internal::for_each_range<ConcurrencyTag>(closest.size(), [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) {
      constexpr double UP = 1 + 8 * ARC_HALF_ULP;  // a difference and a norm
      const bool is_same_side =
          i > begin && results[i - 1].side != Point_side::UNDECIDED &&
          std::hypot(points[i].x - points[i - 1].x, points[i].y - points[i - 1].y) * UP < closest[i - 1].distance.lower;
      results[i] = signed_distances::with_side(closest[i],
                                               is_same_side ? results[i - 1].side : location.locate(points[i], rule));
    }
  });
  return results;
}

}  // namespace CGAL::Bounding_arcs

#endif
