// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Bodies of medial_axis/axis_certificate.h.

#include <CGAL/Bounding_arcs_2/medial_axis/axis_certificate.h>
#include <CGAL/Bounding_arcs_2/medial_axis/internal/axis_units.h>
#include "../tree/Segment_hierarchy.h"
#include "Axis_prover.h"

#include <algorithm>

namespace CGAL::Bounding_arcs {

const char* name_of(Edge_reason reason) {
  switch (reason) {
    case Edge_reason::NONE:
      return "NONE";
    case Edge_reason::FEET:
      return "FEET";
    case Edge_reason::CELL:
      return "CELL";
    case Edge_reason::BAND:
      return "BAND";
    case Edge_reason::ELSEWHERE:
      return "ELSEWHERE";
  }
  return "";
}

bool Axis_certificate::is_proven() const {
  return is_tiled && is_euler &&
         std::all_of(edges.begin(), edges.end(), [](const Edge_bound& e) { return e.status == Edge_status::PROVEN; });
}

Axis_certificate axis_certificate(const Bounding_arc_tree_2& curves, const Medial_axis_2& axis) {
  const Unit& unit = curves.unit();
  const auto bounds = internal::bounds_of(axis, curves.in_unit());
  if (unit.is_one()) return internal::Axis_prover(*bounds, axis).prove();
  const Medial_axis_2 scaled = internal::in(unit, axis);
  Axis_certificate result = internal::Axis_prover(*bounds, scaled).prove();
  result.bound = unit.out(result.bound);
  for (Edge_bound& e : result.edges) e.bound = unit.out(e.bound);
  return result;
}

}  // namespace CGAL::Bounding_arcs
