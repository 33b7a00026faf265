// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Segments, rays, lines, circles and arcs as drawings of exact numbers, so that whatever is asked of two drawings can
// be asked of a drawing and one of these.

#ifndef CGAL_BOUNDING_ARCS_2_QUERY_SHAPES_H
#define CGAL_BOUNDING_ARCS_2_QUERY_SHAPES_H

#include <CGAL/Bounding_arcs_2/curve/Drawing_2.h>
#include <CGAL/Bounding_arcs_2/internal/Exact_number.h>
#include <CGAL/Bounding_arcs_2/query/Curve_index_2.h>
#include <CGAL/Bounding_arcs_2/region/Arc_2.h>

namespace CGAL::Bounding_arcs {

/// A drawing of the segment.
/// \throws std::invalid_argument for numbers that are not finite, and where it says so
[[nodiscard]] Drawing_2<Exact_rational> segment_drawing(const Xy<double>& from, const Xy<double>& to);
/// Counterclockwise from the point to the right of the centre, four quarters. \throws for a radius that is not positive
/// \guarantee exactly the circle
[[nodiscard]] Drawing_2<Exact_rational> circle_drawing(const Xy<double>& centre, double radius);
/// The arc in two halves. \throws for a bulge beyond 1 \guarantee exactly the arc that ends and bulge define
[[nodiscard]] Drawing_2<Exact_rational> arc_drawing(const Arc_2& arc);
/// As much of the ray as may meet the index's curves. \throws for a direction that is 0
[[nodiscard]] Drawing_2<Exact_rational> ray_drawing(const Curve_index_2& index, const Xy<double>& from,
                                                    const Xy<double>& direction);
/// The same of the line through a point.
[[nodiscard]] Drawing_2<Exact_rational> line_drawing(const Curve_index_2& index, const Xy<double>& through,
                                                     const Xy<double>& direction);

}  // namespace CGAL::Bounding_arcs

#ifndef BOUNDING_ARCS_KERNELS
#include <CGAL/Bounding_arcs_2/internal/query/shapes_impl.h>
#endif

#endif
