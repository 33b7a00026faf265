// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Common points of two single Bezier pieces, from their control points: for drawings see intersections.h.
//
// The plain algorithm is exact_intersections.  Before it stands a search in doubles over control polygons
// (src/library/query/piece_pair_intersections.cpp); where it leaves anything open, it is forgotten.

#ifndef CGAL_BOUNDING_ARCS_2_QUERY_PIECE_PAIR_INTERSECTIONS_H
#define CGAL_BOUNDING_ARCS_2_QUERY_PIECE_PAIR_INTERSECTIONS_H

#include <CGAL/Bounding_arcs_2/curve/Bezier_curve_2.h>
#include <CGAL/Bounding_arcs_2/query/Intersections_2.h>

#include <optional>

namespace CGAL::Bounding_arcs {

/// All common points of two pieces, and all parts where they run together.
/// \guarantee as exact_intersections
/// \throws std::invalid_argument for curves out of the range of check_served
/// \complexity one or two microseconds for cubics, and some milliseconds where doubles leave anything open
[[nodiscard]] Piece_intersections intersections(const Bezier_curve_2<double>& a, const Bezier_curve_2<double>& b);

namespace internal {
/// Returns it by doubles alone, where these tell it; there are no overlaps then.
[[nodiscard]] std::optional<Piece_intersections> intersections_by_doubles(const Bezier_curve_2<double>& a,
                                                                          const Bezier_curve_2<double>& b);
}  // namespace internal

}  // namespace CGAL::Bounding_arcs

#endif
