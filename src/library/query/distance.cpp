// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Bodies of query/distance.h.

#include <CGAL/Bounding_arcs_2/query/distance.h>
#include "../tree/Segment_hierarchy.h"
#include "Distance_search.h"
#include "query_units.h"

#include <cmath>
#include <optional>
#include <stdexcept>

namespace CGAL::Bounding_arcs::internal {

// \param eps, of_distance as for the search
[[nodiscard]] static std::optional<Drawing_distance<>> distance_within(const Bounding_arc_tree_2& a,
                                                                       const Bounding_arc_tree_2& b, double eps,
                                                                       double of_distance) {
  const Common_unit both(a, b);
  Distance_search search(both.a(), both.b(), eps > 0 ? both.unit().tolerance_in(eps) : 0, of_distance);
  search.search();
  const auto found = search.result();
  return found ? std::optional(out(both.unit(), *found)) : std::nullopt;
}

std::optional<Drawing_distance<>> distance(const Bounding_arc_tree_2& a, const Bounding_arc_tree_2& b) {
  constexpr double OF_DISTANCE = 1e-12;
  return distance_within(a, b, 0, OF_DISTANCE);
}
std::optional<Drawing_distance<>> distance(const Bounding_arc_tree_2& a, const Bounding_arc_tree_2& b, double eps) {
  check_positive(eps);
  return distance_within(a, b, eps, 0);
}

}  // namespace CGAL::Bounding_arcs::internal
