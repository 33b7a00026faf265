// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The point of a drawing nearest to a point, with its distance between two bounds.

#ifndef CGAL_BOUNDING_ARCS_2_QUERY_CLOSEST_POINT_H
#define CGAL_BOUNDING_ARCS_2_QUERY_CLOSEST_POINT_H

#include <CGAL/Bounding_arcs_2/internal/query/Closest_search.h>
#include <CGAL/Bounding_arcs_2/query/Curve_index_2.h>
#include <CGAL/Bounding_arcs_2/query/Query_point.h>

#include <cmath>
#include <limits>
#include <optional>
#include <stdexcept>

namespace CGAL::Bounding_arcs {

/// The point of a drawing nearest to q, one of them where there are several.
/// \param near a place near to the result, that of a neighbouring point, say: only makes it faster
/// \return nothing of an empty drawing
/// \guarantee the bracket is certified; it is some roundings of coordinates and distance wide, but next to cusps and
///   centres of curvature, where it may be wider
/// \complexity about logarithmic in the number of segments
/// \throws std::invalid_argument for a point that is no number
[[nodiscard]] inline std::optional<Closest_point> closest_point(const Curve_index_2& index, const Xy<double>& q) {
  if (!std::isfinite(q.x) || !std::isfinite(q.y))
    throw std::invalid_argument("a point has coordinates that are numbers");
  internal::Closest_search search(index, q, std::numeric_limits<double>::infinity());
  search.search();
  return search.result();
}

}  // namespace CGAL::Bounding_arcs

#endif
