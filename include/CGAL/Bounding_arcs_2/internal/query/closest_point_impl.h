// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Bodies of query/closest_point.h, which the library has compiled.

#ifndef CGAL_BOUNDING_ARCS_2_INTERNAL_QUERY_CLOSEST_POINT_IMPL_H
#define CGAL_BOUNDING_ARCS_2_INTERNAL_QUERY_CLOSEST_POINT_IMPL_H

#include <CGAL/Bounding_arcs_2/internal/inline.h>
#include <CGAL/Bounding_arcs_2/internal/query/Closest_search.h>
#include <CGAL/Bounding_arcs_2/query/closest_point.h>

#include <limits>
#include <optional>

namespace CGAL::Bounding_arcs {

CGAL_BOUNDING_ARCS_INLINE std::optional<Closest_point> closest_point(const Curve_index_2& index, const Xy<double>& q) {
  check_point(q);
  internal::Closest_search search(index, q, std::numeric_limits<double>::infinity());
  search.search();
  return search.result();
}

CGAL_BOUNDING_ARCS_INLINE std::optional<Closest_point> closest_point(const Curve_index_2& index, const Xy<double>& q,
                                                                     const Curve_place& near) {
  check_point(q);
  internal::Closest_search search(index, q, internal::distance_to_look_within(index, q, near));
  search.search();
  auto result = search.result();
  return result ? result : closest_point(index, q);
}

}  // namespace CGAL::Bounding_arcs

#endif
