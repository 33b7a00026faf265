// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Segments, rays, lines, circles and arcs as drawings of exact numbers, so that whatever is asked of two drawings can
// be asked of a drawing and one of these.

#ifndef CGAL_BOUNDING_ARCS_2_QUERY_SHAPES_H
#define CGAL_BOUNDING_ARCS_2_QUERY_SHAPES_H

#include <CGAL/Bounding_arcs_2/arc/Arc_2.h>
#include <CGAL/Bounding_arcs_2/curve/Drawing_2.h>
#include <CGAL/Bounding_arcs_2/query/kernel_points.h>
#include <CGAL/Bounding_arcs_2/tree/Bounding_arc_tree_2.h>

namespace CGAL::Bounding_arcs {

/// A drawing of the segment.
/// \throws std::invalid_argument for numbers that are not finite, and where it says so
[[nodiscard]] Drawing_2<Exact_rational> segment_drawing(const Asked_point& from, const Asked_point& to);
/// Counterclockwise from the point to the right of the center, four quarters. \throws for a radius that is not positive
/// \guarantee exactly the circle
[[nodiscard]] Drawing_2<Exact_rational> circle_drawing(const Asked_point& center, double radius);
/// The arc in two halves. \throws for a bulge beyond 1 \guarantee exactly the arc that ends and bulge define
[[nodiscard]] Drawing_2<Exact_rational> arc_drawing(const Arc_2& arc);
/// Returns as much of the ray as may meet the curves of a tree. \throws for a direction that is 0
[[nodiscard]] Drawing_2<Exact_rational> ray_drawing(const Bounding_arc_tree_2& tree, const Asked_point& from,
                                                    const Asked_point& direction);
/// Returns the same of the line through a point.
[[nodiscard]] Drawing_2<Exact_rational> line_drawing(const Bounding_arc_tree_2& tree, const Asked_point& through,
                                                     const Asked_point& direction);

}  // namespace CGAL::Bounding_arcs

#endif
