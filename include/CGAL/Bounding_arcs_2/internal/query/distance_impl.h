// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Bodies of query/distance.h, which the library has compiled.

#ifndef CGAL_BOUNDING_ARCS_2_INTERNAL_QUERY_DISTANCE_IMPL_H
#define CGAL_BOUNDING_ARCS_2_INTERNAL_QUERY_DISTANCE_IMPL_H

#include <CGAL/Bounding_arcs_2/internal/inline.h>
#include <CGAL/Bounding_arcs_2/internal/query/Common_unit.h>
#include <CGAL/Bounding_arcs_2/internal/query/Distance_search.h>
#include <CGAL/Bounding_arcs_2/query/distance.h>

#include <cmath>
#include <optional>
#include <stdexcept>

namespace CGAL::Bounding_arcs {

CGAL_BOUNDING_ARCS_INLINE std::optional<Drawing_distance> distance(const Curve_index_2& a, const Curve_index_2& b,
                                                                   const Distance_options& options) {
  if (!(options.tolerance > 0) || !std::isfinite(options.tolerance))
    throw std::invalid_argument("the tolerance of a distance is a positive number");
  const internal::Common_unit both(a, b);
  internal::Distance_search search(both.a(), both.b(), options.tolerance);
  search.search();
  const auto found = search.result();
  return found ? std::optional(internal::out(both.unit(), *found)) : std::nullopt;
}

}  // namespace CGAL::Bounding_arcs

#endif
