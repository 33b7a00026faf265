// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Bodies of query/enclosing_circle.h.

#include <CGAL/Bounding_arcs_2/query/Work_limit.h>
#include <CGAL/Bounding_arcs_2/query/enclosing_circle.h>
#include "Circle_search.h"
#include "query_units.h"

#include <algorithm>
#include <optional>

namespace CGAL::Bounding_arcs::internal {

std::optional<Enclosing_circle<>> smallest_enclosing_circle(const Bounding_arc_tree_2& curves, double tolerance) {
  check_tolerance(tolerance);
  if (curves.empty()) return std::nullopt;
  constexpr double ROUGH = 0x1p-7;  // of the extent: what is well inside is looked at no more
  const Unit& unit = curves.unit();
  const Segment_hierarchy& in_unit = curves.in_unit();
  const double asked = unit.tolerance_in(tolerance), rough = ROUGH * extent_of(in_unit);
  const Circle_search search(in_unit, Hull_samples(in_unit, rough), asked / 2, is_fine(in_unit, asked));
  const Measure_bounds radius{search.lower(), search.upper(),
                              status_of(search.upper() - search.lower(), asked, search.is_limited())};
  return Enclosing_circle<>{unit.out(search.center()), unit.bounds_out(radius)};
}

}  // namespace CGAL::Bounding_arcs::internal
