// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Filter of intersections: two line segments, without polynomials, where an end of one is on the line of the other one.

#ifndef BOUNDING_ARCS_LIBRARY_QUERY_LINE_PAIRS_H
#define BOUNDING_ARCS_LIBRARY_QUERY_LINE_PAIRS_H

#include <CGAL/Bounding_arcs_2/curve/Bezier_curve_2.h>
#include <CGAL/Bounding_arcs_2/query/Intersections_2.h>

#include <optional>

namespace CGAL::Bounding_arcs {

/// Whether a piece is a line segment that is run through evenly, and no point.
[[nodiscard]] inline bool is_line(const Bezier_curve_2<double>& c) {
  return c.degree() == 1 && !c.is_rational() && !(c.control_points().front() == c.control_points().back());
}

/// All that two line segments have in common.
/// \pre is_line of both
/// \return nothing where they cross between their ends, which is for others to find
/// \guarantee exact
[[nodiscard]] std::optional<Piece_intersections> line_intersections(const Bezier_curve_2<double>& a,
                                                                    const Bezier_curve_2<double>& b);

/// The crossing of two line segments. \pre they cross between their ends
/// \guarantee exact
[[nodiscard]] Piece_intersection line_crossing(const Bezier_curve_2<double>& a, const Bezier_curve_2<double>& b);

}  // namespace CGAL::Bounding_arcs

#endif
