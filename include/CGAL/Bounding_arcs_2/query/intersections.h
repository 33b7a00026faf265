// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Common points of two drawings, of the curves of one, and of two single Bezier pieces.

#ifndef CGAL_BOUNDING_ARCS_2_QUERY_INTERSECTIONS_H
#define CGAL_BOUNDING_ARCS_2_QUERY_INTERSECTIONS_H

#include <CGAL/Bounding_arcs_2/curve/Bezier_curve_2.h>
#include <CGAL/Bounding_arcs_2/query/Intersections_2.h>
#include <CGAL/Bounding_arcs_2/query/kernel_points.h>
#include <CGAL/Bounding_arcs_2/tree/Bounding_arc_tree_2.h>

#include <optional>

namespace CGAL::Bounding_arcs {

namespace internal {
[[nodiscard]] Intersections_2<> intersections(const Bounding_arc_tree_2& a, const Bounding_arc_tree_2& b);
[[nodiscard]] Intersections_2<> self_intersections(const Bounding_arc_tree_2& a);
}  // namespace internal

/// Returns all common points of the curves of two trees.
/// \guarantee complete and certified: each range holds the parameter of one common point, and there are no others;
///   kinds are right, and common ends, at joints too, are one point. Undecided points are there only
///   without exact decisions
/// \complexity n log n and what is found, and some milliseconds for each two pieces that doubles leave open
template <class Kernel = Default_kernel>
[[nodiscard]] Intersections_2<typename Kernel::Point_2> intersections(const Bounding_arc_tree_2& a,
                                                                      const Bounding_arc_tree_2& b) {
  return internal::intersections(a, b);
}
/// Returns all points that the curves of a tree pass more than once: of two curves, or of one with itself. That
/// neighbours share their joint does not count, nor does a piece that is a point.
/// \guarantee as intersections; of each point the place that comes first is `a`
template <class Kernel = Default_kernel>
[[nodiscard]] Intersections_2<typename Kernel::Point_2> self_intersections(const Bounding_arc_tree_2& a) {
  return internal::self_intersections(a);
}
/// Tells whether the curves of two trees have a common point.
/// \return nothing where doubles do not tell and the kernel has no exact predicates
/// \complexity ends with the first point that is proven
[[nodiscard]] std::optional<bool> do_intersect(const Bounding_arc_tree_2& a, const Bounding_arc_tree_2& b);

/// All common points of two pieces, and all parts where they run together.
/// \guarantee as exact_intersections
/// \throws std::invalid_argument for curves out of the range that is served (served_range.h)
/// \complexity one or two microseconds for cubics, and some milliseconds where doubles leave anything open
[[nodiscard]] Piece_intersections intersections(const Bezier_curve_2<double>& a, const Bezier_curve_2<double>& b);

namespace internal {
/// Returns it by doubles alone, where these tell it; there are no overlaps then.
[[nodiscard]] std::optional<Piece_intersections> intersections_by_doubles(const Bezier_curve_2<double>& a,
                                                                          const Bezier_curve_2<double>& b);
}  // namespace internal

}  // namespace CGAL::Bounding_arcs

#endif
