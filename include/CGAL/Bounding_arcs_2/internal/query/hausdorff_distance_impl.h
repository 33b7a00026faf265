// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Bodies of query/hausdorff_distance.h, which the library has compiled.

#ifndef CGAL_BOUNDING_ARCS_2_INTERNAL_QUERY_HAUSDORFF_DISTANCE_IMPL_H
#define CGAL_BOUNDING_ARCS_2_INTERNAL_QUERY_HAUSDORFF_DISTANCE_IMPL_H

#include <CGAL/Bounding_arcs_2/internal/inline.h>
#include <CGAL/Bounding_arcs_2/internal/query/Common_unit.h>
#include <CGAL/Bounding_arcs_2/internal/query/Hausdorff_search.h>
#include <CGAL/Bounding_arcs_2/internal/query/Work_limit.h>
#include <CGAL/Bounding_arcs_2/query/hausdorff_distance.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <stdexcept>
#include <utility>

namespace CGAL::Bounding_arcs {

CGAL_BOUNDING_ARCS_INLINE std::optional<Drawing_distance> directed_hausdorff_distance(const Curve_index_2& a,
                                                                                      const Curve_index_2& b,
                                                                                      double tolerance) {
  if (!(tolerance > 0) || !std::isfinite(tolerance))
    throw std::invalid_argument("the tolerance of a distance is a positive number");
  if (a.empty() || b.empty()) return std::nullopt;
  const internal::Common_unit both(a, b);
  internal::Hausdorff_search search(both.a(), both.b(), both.unit().tolerance_in(tolerance));
  search.search();
  return internal::out(both.unit(), search.result());
}

CGAL_BOUNDING_ARCS_INLINE std::optional<Drawing_distance> hausdorff_distance(const Curve_index_2& a,
                                                                             const Curve_index_2& b, double tolerance) {
  const internal::Common_unit both(a, b);
  const double in_unit = both.unit().tolerance_in(tolerance);
  const auto from_a = directed_hausdorff_distance(both.a(), both.b(), in_unit);
  if (!from_a) return std::nullopt;
  // of the other direction only what is farther matters
  internal::Hausdorff_search search(both.b(), both.a(), in_unit, from_a->distance.lower);
  search.search();
  Drawing_distance result = *from_a;
  if (search.has_result()) {
    result = search.result();
    std::swap(result.a, result.b);
  }
  result.distance = {search.bounds().lower, (std::max)(search.bounds().upper, from_a->distance.upper)};
  const bool is_limited = from_a->status == Query_status::LIMIT_REACHED || search.is_limited();
  result.status = internal::status_of(result.distance.upper - result.distance.lower, in_unit, is_limited);
  return internal::out(both.unit(), result);
}

}  // namespace CGAL::Bounding_arcs

#endif
