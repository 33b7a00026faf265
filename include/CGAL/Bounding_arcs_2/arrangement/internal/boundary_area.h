// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The area within boundaries of parts of Bezier pieces; see face_area.h.

#ifndef CGAL_BOUNDING_ARCS_2_ARRANGEMENT_INTERNAL_BOUNDARY_AREA_H
#define CGAL_BOUNDING_ARCS_2_ARRANGEMENT_INTERNAL_BOUNDARY_AREA_H

#include <CGAL/Bounding_arcs_2/curve/Bezier_curve_2.h>
#include <CGAL/Bounding_arcs_2/number/Bracket.h>
#include <CGAL/Bounding_arcs_2/query/measures.h>

#include <vector>

namespace CGAL::Bounding_arcs::internal {

/// A part of a Bezier piece as a face has it to its left.
struct Boundary_part {
  const Bezier_curve_2<double>* bezier;
  Bracket from, to;  ///< hold the parameters where it starts and ends
};

/// The area that closed boundaries of a face run round, in src/library/arrangement/face_area.cpp.
[[nodiscard]] Measure_bounds boundary_area(const std::vector<std::vector<Boundary_part>>& boundaries, double eps);

}  // namespace CGAL::Bounding_arcs::internal

#endif
