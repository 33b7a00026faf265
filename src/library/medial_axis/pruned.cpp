// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Bodies of medial_axis/pruned.h.

#include <CGAL/Bounding_arcs_2/medial_axis/internal/axis_units.h>
#include <CGAL/Bounding_arcs_2/medial_axis/pruned.h>
#include "Axis_pruner.h"

#include <utility>

namespace CGAL::Bounding_arcs {

Medial_axis_2 pruned(Medial_axis_2 axis, double significance) {
  const Unit unit = internal::unit_of(axis);
  return internal::out(
      unit, internal::Axis_pruner(internal::in(unit, std::move(axis)), unit.tolerance_in(significance)).pruned());
}

}  // namespace CGAL::Bounding_arcs
