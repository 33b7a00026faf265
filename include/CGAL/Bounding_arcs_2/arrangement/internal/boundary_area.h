// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The area within boundaries of edges; see face_area.h.

#ifndef CGAL_BOUNDING_ARCS_2_ARRANGEMENT_INTERNAL_BOUNDARY_AREA_H
#define CGAL_BOUNDING_ARCS_2_ARRANGEMENT_INTERNAL_BOUNDARY_AREA_H

#include <CGAL/Bounding_arcs_2/arrangement/Arr_curve_2.h>
#include <CGAL/Bounding_arcs_2/query/measures.h>

#include <vector>

namespace CGAL::Bounding_arcs::internal {

/// An edge as a face has it to its left.
struct Boundary_part {
  Arr_x_monotone_curve_2 curve;
  bool is_to_right;  ///< it is run through from left to right
};

/// The area that closed boundaries run round, in src/library/arrangement/face_area.cpp.
[[nodiscard]] Measure_bounds boundary_area(const std::vector<std::vector<Boundary_part>>& boundaries, double eps);

}  // namespace CGAL::Bounding_arcs::internal

#endif
