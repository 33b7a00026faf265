// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The point of a drawing nearest to a point, or to each of many points, with its distance between two bounds.

#ifndef CGAL_BOUNDING_ARCS_2_QUERY_CLOSEST_POINT_H
#define CGAL_BOUNDING_ARCS_2_QUERY_CLOSEST_POINT_H

#include <CGAL/Bounding_arcs_2/query/Query_point.h>
#include <CGAL/Bounding_arcs_2/query/internal/closest_points_of_all.h>
#include <CGAL/Bounding_arcs_2/query/internal/compiled_queries.h>

#include <cstddef>
#include <optional>
#include <vector>

namespace CGAL::Bounding_arcs {

/// Returns the point of the tree's curves that is nearest to q, one of them where there are several.
/// \return nothing of an empty tree
/// \guarantee the bracket is certified; it is some roundings of coordinates and distance wide, but next to cusps and
///   centers of curvature, where it may be wider
/// \complexity about logarithmic in the number of segments
/// \throws std::invalid_argument for a point that is no number
template <class Traits, class Spiral, class Decider>
[[nodiscard]] std::optional<Closest_point<typename Traits::Kernel::Point_2>> closest_point(
    const Bounding_arc_tree_2<Traits, Spiral, Decider>& tree, const typename Traits::Kernel::Point_2& q) {
  using Kernel = typename Traits::Kernel;
  return in_kernel<Kernel>(closest_point(tree.curves(), asked_point<Kernel>(q)));
}

/// Returns the same by way of a place near to the result, that of a neighbouring point, say. That only makes it faster.
/// \param near a place of these curves
template <class Traits, class Spiral, class Decider>
[[nodiscard]] std::optional<Closest_point<typename Traits::Kernel::Point_2>> closest_point(
    const Bounding_arc_tree_2<Traits, Spiral, Decider>& tree, const typename Traits::Kernel::Point_2& q,
    const Curve_place& near) {
  using Kernel = typename Traits::Kernel;
  return in_kernel<Kernel>(closest_point(tree.curves(), asked_point<Kernel>(q), near));
}

/// Returns the nearest points to many points, in their order.
/// \tparam ConcurrencyTag CGAL::Sequential_tag or CGAL::Parallel_tag, which needs TBB; where several points are
///   nearest, the two may answer with different ones
/// \param points a range of the kernel's points; each search starts from the place before, so that neighbours had
///   better be in order
/// \return as many as there are points, or none of an empty tree
/// \guarantee as closest_point
/// \throws std::invalid_argument for a point that is no number
template <class ConcurrencyTag = CGAL::Sequential_tag, class Traits, class Spiral, class Decider, class Points>
[[nodiscard]] std::vector<Closest_point<typename Traits::Kernel::Point_2>> closest_points_of_all(
    const Bounding_arc_tree_2<Traits, Spiral, Decider>& tree, const Points& points) {
  using Kernel = typename Traits::Kernel;
  return in_kernel<Kernel>(
      internal::closest_points_of_all<ConcurrencyTag>(tree.curves(), asked_points<Kernel>(points)));
}

}  // namespace CGAL::Bounding_arcs

#endif
