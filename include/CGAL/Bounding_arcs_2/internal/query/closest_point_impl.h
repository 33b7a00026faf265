// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Bodies of query/closest_point.h, which the library has compiled.

#ifndef CGAL_BOUNDING_ARCS_2_INTERNAL_QUERY_CLOSEST_POINT_IMPL_H
#define CGAL_BOUNDING_ARCS_2_INTERNAL_QUERY_CLOSEST_POINT_IMPL_H

#include <CGAL/Bounding_arcs_2/internal/inline.h>
#include <CGAL/Bounding_arcs_2/internal/query/Closest_search.h>
#include <CGAL/Bounding_arcs_2/internal/query/Common_unit.h>
#include <CGAL/Bounding_arcs_2/query/closest_point.h>

#include <limits>
#include <optional>

namespace CGAL::Bounding_arcs {

namespace internal {

/// \param most nothing farther is looked for
[[nodiscard]] inline std::optional<Closest_point> closest_within(const Curve_index_2& index, const Xy<double>& q,
                                                                 double most) {
  Closest_search search(index.in_unit(), q, most);
  search.search();
  const auto found = search.result();
  return found ? std::optional(out(index.unit(), *found)) : std::nullopt;
}

}  // namespace internal

CGAL_BOUNDING_ARCS_INLINE std::optional<Closest_point> closest_point(const Curve_index_2& index, const Xy<double>& q) {
  return internal::closest_within(index, internal::point_in(index.unit(), q), std::numeric_limits<double>::infinity());
}

CGAL_BOUNDING_ARCS_INLINE std::optional<Closest_point> closest_point(const Curve_index_2& index, const Xy<double>& q,
                                                                     const Curve_place& near) {
  const Xy<double> p = internal::point_in(index.unit(), q);
  auto result = internal::closest_within(index, p, internal::distance_to_look_within(index, p, near));
  return result ? result : closest_point(index, q);
}

}  // namespace CGAL::Bounding_arcs

#endif
