// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// How far two drawings are from each other where they are farthest, between two bounds.

#ifndef CGAL_BOUNDING_ARCS_2_QUERY_HAUSDORFF_DISTANCE_H
#define CGAL_BOUNDING_ARCS_2_QUERY_HAUSDORFF_DISTANCE_H

#include <CGAL/Bounding_arcs_2/query/Curve_index_2.h>
#include <CGAL/Bounding_arcs_2/query/Query_point.h>

#include <optional>

namespace CGAL::Bounding_arcs {

/// The largest distance of a point of drawing a from drawing b, with such a point, one of them where there are several,
/// and the point of b that is nearest to it.
/// \param tolerance how wide the bracket may be, a length
/// \return nothing if one of the drawings is empty
/// \guarantee the bracket is certified; it is as wide as the tolerance at most, or some roundings of the coordinates,
///   or its status says that a limit was reached
/// \complexity one search for a closest point for each piece that may be farthest: about the logarithm of size over
///   tolerance where one point is farthest, its cube root where curves are parallel or the same
/// \throws std::invalid_argument unless the tolerance is a positive number
[[nodiscard]] std::optional<Drawing_distance> directed_hausdorff_distance(const Curve_index_2& a,
                                                                          const Curve_index_2& b, double tolerance);

/// The larger of both directed distances, with the points that realise it.
/// \guarantee, \complexity, \throws as directed_hausdorff_distance
[[nodiscard]] std::optional<Drawing_distance> hausdorff_distance(const Curve_index_2& a, const Curve_index_2& b,
                                                                 double tolerance);

}  // namespace CGAL::Bounding_arcs

#ifndef BOUNDING_ARCS_KERNELS
#include <CGAL/Bounding_arcs_2/internal/query/hausdorff_distance_impl.h>
#endif

#endif
