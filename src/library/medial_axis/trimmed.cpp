// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Bodies of medial_axis/trimmed.h.

#include <CGAL/Bounding_arcs_2/medial_axis/internal/axis_units.h>
#include <CGAL/Bounding_arcs_2/medial_axis/trimmed.h>
#include "../tree/Segment_hierarchy.h"
#include "Axis_trimmer.h"
#include "Bounding_parts.h"

#include <utility>

namespace CGAL::Bounding_arcs {

Medial_axis_2 trimmed(Medial_axis_2 axis, const Bounding_arc_tree_2& tree, const Feet_apart& apart) {
  const Unit& unit = tree.unit();
  const auto bounds = internal::bounds_of(axis, tree.in_unit());
  return internal::out(unit, internal::Axis_trimmer(internal::in(unit, std::move(axis)), bounds->segments, apart.angle,
                                                    unit.tolerance_in(apart.half_distance))
                                 .trimmed());
}

}  // namespace CGAL::Bounding_arcs
