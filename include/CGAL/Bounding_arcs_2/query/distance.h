// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// How far two drawings are from each other, where they are nearest and where they are farthest, between two bounds.

#ifndef CGAL_BOUNDING_ARCS_2_QUERY_DISTANCE_H
#define CGAL_BOUNDING_ARCS_2_QUERY_DISTANCE_H

#include <CGAL/Bounding_arcs_2/query/Query_point.h>
#include <CGAL/Bounding_arcs_2/query/kernel_points.h>
#include <CGAL/Bounding_arcs_2/tree/Bounding_arc_tree_2.h>

#include <optional>

namespace CGAL::Bounding_arcs {

namespace internal {
[[nodiscard]] std::optional<Drawing_distance<>> distance(const Bounding_arc_tree_2& a, const Bounding_arc_tree_2& b);
[[nodiscard]] std::optional<Drawing_distance<>> distance(const Bounding_arc_tree_2& a, const Bounding_arc_tree_2& b,
                                                         double eps);
[[nodiscard]] std::optional<Drawing_distance<>> directed_hausdorff_distance(const Bounding_arc_tree_2& a,
                                                                            const Bounding_arc_tree_2& b, double eps);
[[nodiscard]] std::optional<Drawing_distance<>> hausdorff_distance(const Bounding_arc_tree_2& a,
                                                                   const Bounding_arc_tree_2& b, double eps);
}  // namespace internal

/// Returns the least distance of the curves of two trees, with a point of each, one pair of them where there are
/// several.
/// The bracket is as wide as 10^-12 of the distance at most.
/// \tparam Kernel of the points that are answered
/// \return nothing if one of the trees is empty
/// \guarantee the bracket is certified. It may be wider by some roundings of the coordinates, which is all that is
///   known of the distance 0 of curves that meet. Or its status says that a limit was reached
/// \complexity about logarithmic in the number of segments where nearest points are few; of curves at one distance all
///   along, their length over the cube root of the width
template <class Kernel = Default_kernel>
[[nodiscard]] std::optional<Drawing_distance<typename Kernel::Point_2>> distance(const Bounding_arc_tree_2& a,
                                                                                 const Bounding_arc_tree_2& b) {
  return internal::distance(a, b);
}
/// Returns the same in a bracket of a given width.
/// \param eps how wide it may be, a length, positive; curves that are parallel all along are cut to about its cube root
/// \return, \guarantee, \complexity as above
/// \throws std::invalid_argument unless eps is a positive number
template <class Kernel = Default_kernel>
[[nodiscard]] std::optional<Drawing_distance<typename Kernel::Point_2>> distance(const Bounding_arc_tree_2& a,
                                                                                 const Bounding_arc_tree_2& b,
                                                                                 double eps) {
  return internal::distance(a, b, eps);
}

/// Returns the largest distance of a point of tree a from the curves of tree b. With it comes such a point, one of them
/// where there are several, and the point of b that is nearest to it.
/// \param eps how wide the bracket may be, a length, positive
/// \tparam Kernel of the points that are answered
/// \return nothing if one of the trees is empty
/// \guarantee the bracket is certified; it is as wide as eps at most, or some roundings of the coordinates, or its
///   status says that a limit was reached
/// \complexity one search for a closest point for each piece that may be farthest. These are about the logarithm of
///   size over eps where one point is farthest, its cube root where curves are parallel or the same
/// \throws std::invalid_argument unless eps is a positive number
template <class Kernel = Default_kernel>
[[nodiscard]] std::optional<Drawing_distance<typename Kernel::Point_2>> directed_hausdorff_distance(
    const Bounding_arc_tree_2& a, const Bounding_arc_tree_2& b, double eps) {
  return internal::directed_hausdorff_distance(a, b, eps);
}
/// Returns the larger of both directed distances, with the points that realise it.
/// \guarantee, \complexity, \throws as directed_hausdorff_distance
template <class Kernel = Default_kernel>
[[nodiscard]] std::optional<Drawing_distance<typename Kernel::Point_2>> hausdorff_distance(const Bounding_arc_tree_2& a,
                                                                                           const Bounding_arc_tree_2& b,
                                                                                           double eps) {
  return internal::hausdorff_distance(a, b, eps);
}

}  // namespace CGAL::Bounding_arcs

#endif
