// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The least distance of two drawings, between two bounds.

#ifndef CGAL_BOUNDING_ARCS_2_QUERY_DISTANCE_H
#define CGAL_BOUNDING_ARCS_2_QUERY_DISTANCE_H

#include <CGAL/Bounding_arcs_2/query/Curve_index_2.h>
#include <CGAL/Bounding_arcs_2/query/Query_point.h>

#include <optional>

namespace CGAL::Bounding_arcs {

/// How near a distance is to be.
struct Distance_options {
  /// How wide the bracket may be beside its upper bound.  It is about the cube root that curves which are parallel all
  /// along are cut to.
  double tolerance = 1e-12;
};

/// The least distance of the curves of two drawings, with a point of each, one pair of them where there are several.
/// \return nothing if one of the drawings is empty
/// \guarantee the bracket is certified; it is as wide as the tolerance at most, or some roundings of the coordinates,
///   which is all that is known of the distance 0 of curves that meet, or its status says that a limit was reached
/// \complexity about logarithmic in the number of segments where nearest points are few; of curves at one distance all
///   along, their length over the cube root of the tolerance
/// \throws std::invalid_argument unless the tolerance is a positive number
[[nodiscard]] std::optional<Drawing_distance> distance(const Curve_index_2& a, const Curve_index_2& b,
                                                       const Distance_options& options = {});

}  // namespace CGAL::Bounding_arcs

#ifndef BOUNDING_ARCS_KERNELS
#include <CGAL/Bounding_arcs_2/internal/query/distance_impl.h>
#endif

#endif
