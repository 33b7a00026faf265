// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Bodies of query/intersections.h.

#include <CGAL/Bounding_arcs_2/query/intersections.h>
#include "../tree/Segment_hierarchy.h"
#include "Intersection_search.h"
#include "query_units.h"

#include <optional>

namespace CGAL::Bounding_arcs::internal {

Intersections_2<> intersections(const Bounding_arc_tree_2& a, const Bounding_arc_tree_2& b) {
  const Common_unit both(a, b);
  return out(both.unit(), Intersection_search(both.a(), both.b()).all());
}

Intersections_2<> self_intersections(const Bounding_arc_tree_2& a) {
  return out(a.unit(), Intersection_search(a.in_unit()).all());
}

}  // namespace CGAL::Bounding_arcs::internal

namespace CGAL::Bounding_arcs {

std::optional<bool> do_intersect(const Bounding_arc_tree_2& a, const Bounding_arc_tree_2& b) {
  const Common_unit both(a, b);
  return Intersection_search(both.a(), both.b()).any();
}

}  // namespace CGAL::Bounding_arcs
