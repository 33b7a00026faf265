// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The distance of a point, or of each of many points, from closed curves: less than 0 inside.

#ifndef CGAL_BOUNDING_ARCS_2_QUERY_SIGNED_DISTANCE_H
#define CGAL_BOUNDING_ARCS_2_QUERY_SIGNED_DISTANCE_H

#include <CGAL/Bounding_arcs_2/query/Default_kernel.h>
#include <CGAL/Bounding_arcs_2/query/closest_point.h>
#include <CGAL/Bounding_arcs_2/query/internal/signed_distances.h>

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
