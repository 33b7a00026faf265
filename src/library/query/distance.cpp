// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Bodies of query/distance.h.

#include <CGAL/Bounding_arcs_2/query/distance.h>
#include "../tree/Segment_hierarchy.h"
#include "Distance_search.h"
#include "Hausdorff_search.h"
#include "query_units.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <stdexcept>
#include <utility>

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

[[nodiscard]] static Drawing_distance<> directed_hausdorff_distance(const Segment_hierarchy& a,
                                                                    const Segment_hierarchy& b, double eps) {
  Hausdorff_search search(a, b, eps);
  search.search();
  return search.result();
}

std::optional<Drawing_distance<>> directed_hausdorff_distance(const Bounding_arc_tree_2& a,
                                                              const Bounding_arc_tree_2& b, double eps) {
  check_positive(eps);
  if (a.empty() || b.empty()) return std::nullopt;
  const Common_unit both(a, b);
  return out(both.unit(), directed_hausdorff_distance(both.a(), both.b(), both.unit().tolerance_in(eps)));
}

std::optional<Drawing_distance<>> hausdorff_distance(const Bounding_arc_tree_2& a, const Bounding_arc_tree_2& b,
                                                     double eps) {
  check_positive(eps);
  if (a.empty() || b.empty()) return std::nullopt;
  const Common_unit both(a, b);
  const double in_unit = both.unit().tolerance_in(eps);
  const Drawing_distance<> from_a = directed_hausdorff_distance(both.a(), both.b(), in_unit);
  // of the other direction only what is farther matters
  Hausdorff_search search(both.b(), both.a(), in_unit, from_a.distance.lower);
  search.search();
  Drawing_distance<> result = from_a;
  if (search.has_result()) {
    result = search.result();
    std::swap(result.a, result.b);
  }
  result.distance = {search.bounds().lower, (std::max)(search.bounds().upper, from_a.distance.upper)};
  const bool is_limited = from_a.status == Query_status::LIMIT_REACHED || search.is_limited();
  result.status = status_of(result.distance.upper - result.distance.lower, in_unit, is_limited);
  return out(both.unit(), result);
}

}  // namespace CGAL::Bounding_arcs::internal
