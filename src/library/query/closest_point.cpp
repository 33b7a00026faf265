// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Bodies of query/closest_point.h.

#include <CGAL/Bounding_arcs_2/query/closest_point.h>
#include "../tree/Segment_hierarchy.h"
#include "Closest_search.h"
#include "query_units.h"

#include <limits>
#include <optional>

namespace CGAL::Bounding_arcs {

/// \param most nothing farther is looked for
[[nodiscard]] static std::optional<Closest_point<>> out(const Unit& unit, const std::optional<Closest_point<>>& found,
                                                        double error) {
  if (!found) return std::nullopt;
  Closest_point<> result = out(unit, *found);
  if (error > 0) result.distance = widened(result.distance, error);
  return result;
}

std::optional<Closest_point<>> internal::closest_point(const Bounding_arc_tree_2& curves, const Asked_point& q) {
  return out(curves.unit(), closest_point(curves.in_unit(), point_in(curves.unit(), q.point)), q.error);
}

std::optional<Closest_point<>> internal::closest_point(const Bounding_arc_tree_2& curves, const Asked_point& q,
                                                       const Curve_place& near) {
  return out(curves.unit(), closest_point(curves.in_unit(), point_in(curves.unit(), q.point), near), q.error);
}

}  // namespace CGAL::Bounding_arcs
