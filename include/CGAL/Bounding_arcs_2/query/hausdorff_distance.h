// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// How far two drawings are from each other where they are farthest, between two bounds.

#ifndef CGAL_BOUNDING_ARCS_2_QUERY_HAUSDORFF_DISTANCE_H
#define CGAL_BOUNDING_ARCS_2_QUERY_HAUSDORFF_DISTANCE_H

#include <CGAL/Bounding_arcs_2/internal/query/Hausdorff_search.h>
#include <CGAL/Bounding_arcs_2/query/Curve_index_2.h>
#include <CGAL/Bounding_arcs_2/query/Query_point.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <stdexcept>
#include <utility>

namespace CGAL::Bounding_arcs {

/// The largest distance of a point of drawing a from drawing b, with such a point, one of them where there are several,
/// and the point of b that is nearest to it.
/// \param tolerance how wide the bracket may be, a length
/// \return nothing if one of the drawings is empty
/// \guarantee the bracket is certified; it is as wide as the tolerance at most, or some roundings of the coordinates
/// \complexity one search for a closest point for each piece that may be farthest: about the logarithm of size over
///   tolerance where one point is farthest, its cube root where curves are parallel or the same
/// \throws std::invalid_argument unless the tolerance is a positive number
[[nodiscard]] inline std::optional<Drawing_distance> directed_hausdorff_distance(const Curve_index_2& a,
                                                                                 const Curve_index_2& b,
                                                                                 double tolerance) {
  if (!(tolerance > 0) || !std::isfinite(tolerance))
    throw std::invalid_argument("the tolerance of a distance is a positive number");
  if (a.empty() || b.empty()) return std::nullopt;
  internal::Hausdorff_search search(a, b, tolerance);
  search.search();
  return search.result();
}

/// The larger of both directed distances, with the points that realise it.
/// \guarantee, \complexity, \throws as directed_hausdorff_distance
[[nodiscard]] inline std::optional<Drawing_distance> hausdorff_distance(const Curve_index_2& a, const Curve_index_2& b,
                                                                        double tolerance) {
  const auto from_a = directed_hausdorff_distance(a, b, tolerance);
  if (!from_a) return std::nullopt;
  // of the other direction only what is farther matters
  internal::Hausdorff_search search(b, a, tolerance, from_a->distance.lower);
  search.search();
  Drawing_distance result = *from_a;
  if (search.has_result()) {
    result = search.result();
    std::swap(result.a, result.b);
  }
  result.distance = {search.bounds().lower, (std::max)(search.bounds().upper, from_a->distance.upper)};
  return result;
}

}  // namespace CGAL::Bounding_arcs

#endif
