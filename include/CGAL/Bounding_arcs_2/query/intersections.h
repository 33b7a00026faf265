// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Common points of two drawings, and of the curves of one.
//
// The plain algorithm is exact_intersections of each two Bezier pieces.  Before it stands a search in doubles over
// segments whose boxes meet (internal/query/Pair_search.h), which proves almost all points, and that there are no
// others; where it leaves anything of two pieces open, they are asked for exactly, and what it found of them is
// forgotten.

#ifndef CGAL_BOUNDING_ARCS_2_QUERY_INTERSECTIONS_H
#define CGAL_BOUNDING_ARCS_2_QUERY_INTERSECTIONS_H

#include <CGAL/Bounding_arcs_2/query/Curve_index_2.h>
#include <CGAL/Bounding_arcs_2/query/Intersections_2.h>

#include <optional>

namespace CGAL::Bounding_arcs {

/// All common points of two drawings.
/// \guarantee complete and certified: each range holds the parameter of one common point, and there are no others;
///   kinds are right, and common ends, at joints too, are one point. Undecided points are there only where an index
///   has Query_decisions::DOUBLE
/// \complexity n log n and what is found, and some milliseconds for each two pieces that doubles leave open
[[nodiscard]] Intersections_2 intersections(const Curve_index_2& a, const Curve_index_2& b);

/// All points that the curves of a drawing pass more than once: of two curves, or of one with itself. That neighbours
/// share their joint does not count.
/// \guarantee as intersections; of each point the place that comes first is `a`
[[nodiscard]] Intersections_2 self_intersections(const Curve_index_2& a);

/// Whether two drawings have a common point.
/// \return nothing where doubles do not tell and exact arithmetic may not be used
/// \complexity ends with the first point that is proven
[[nodiscard]] std::optional<bool> do_intersect(const Curve_index_2& a, const Curve_index_2& b);

}  // namespace CGAL::Bounding_arcs

#ifndef BOUNDING_ARCS_KERNELS
#include <CGAL/Bounding_arcs_2/internal/query/intersections_impl.h>
#endif

#endif
