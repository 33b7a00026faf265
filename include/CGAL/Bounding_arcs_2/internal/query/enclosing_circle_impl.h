// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Bodies of query/enclosing_circle.h, which the library has compiled.

#ifndef CGAL_BOUNDING_ARCS_2_INTERNAL_QUERY_ENCLOSING_CIRCLE_IMPL_H
#define CGAL_BOUNDING_ARCS_2_INTERNAL_QUERY_ENCLOSING_CIRCLE_IMPL_H

#include <CGAL/Bounding_arcs_2/internal/inline.h>
#include <CGAL/Bounding_arcs_2/internal/query/Circle_search.h>
#include <CGAL/Bounding_arcs_2/internal/query/Work_limit.h>
#include <CGAL/Bounding_arcs_2/query/enclosing_circle.h>

#include <algorithm>
#include <optional>

namespace CGAL::Bounding_arcs {

CGAL_BOUNDING_ARCS_INLINE std::optional<Enclosing_circle> smallest_enclosing_circle(const Curve_index_2& index,
                                                                                    double tolerance) {
  check_tolerance(tolerance);
  if (index.empty()) return std::nullopt;
  constexpr double ROUGH = 0x1p-7;  // of the extent: what is well inside is looked at no more
  const internal::Unit& unit = index.unit();
  const Curve_index_2& in_unit = index.in_unit();
  const double asked = unit.tolerance_in(tolerance), rough = ROUGH * internal::extent_of(in_unit);
  const internal::Circle_search search(in_unit, internal::Hull_samples(in_unit, rough), asked / 2,
                                       internal::is_fine(in_unit, asked));
  const Measure_bounds radius{search.lower(), search.upper(),
                              internal::status_of(search.upper() - search.lower(), asked, search.is_limited())};
  return Enclosing_circle{unit.out(search.centre()), unit.bounds_out(radius)};
}

}  // namespace CGAL::Bounding_arcs

#endif
