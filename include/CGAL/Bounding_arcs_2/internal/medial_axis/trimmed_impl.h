// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Bodies of medial_axis/trimmed.h, which the library has compiled.

#ifndef CGAL_BOUNDING_ARCS_2_INTERNAL_MEDIAL_AXIS_TRIMMED_IMPL_H
#define CGAL_BOUNDING_ARCS_2_INTERNAL_MEDIAL_AXIS_TRIMMED_IMPL_H

#include <CGAL/Bounding_arcs_2/internal/inline.h>
#include <CGAL/Bounding_arcs_2/internal/medial_axis/Axis_trimmer.h>
#include <CGAL/Bounding_arcs_2/internal/medial_axis/axis_units.h>
#include <CGAL/Bounding_arcs_2/medial_axis/trimmed.h>

#include <utility>

namespace CGAL::Bounding_arcs {

CGAL_BOUNDING_ARCS_INLINE Medial_axis_2 trimmed(Medial_axis_2 axis, const Curve_index_2& index,
                                                const Feet_apart& apart) {
  const internal::Unit& unit = index.unit();
  return internal::out(unit, internal::Axis_trimmer(internal::in(unit, std::move(axis)), index.in_unit(), apart.angle,
                                                    unit.tolerance_in(apart.half_distance))
                                 .trimmed());
}

}  // namespace CGAL::Bounding_arcs

#endif
