// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The body of arrangement/internal/boundary_area.h.

#include "../overlay/Boundary_sum.h"

#include <CGAL/Bounding_arcs_2/arrangement/internal/boundary_area.h>
#include <CGAL/Bounding_arcs_2/curve/exact_bezier.h>
#include <CGAL/Bounding_arcs_2/query/query_units.h>

#include <vector>

namespace CGAL::Bounding_arcs::internal {

Measure_bounds boundary_area(const std::vector<std::vector<Boundary_part>>& boundaries, double eps) {
  check_tolerance(eps);
  Boundary_sum sum;
  for (const std::vector<Boundary_part>& boundary : boundaries) {
    for (const Boundary_part& part : boundary) sum.add(exact_bezier(*part.bezier), part.from, part.to);
    sum.close();
  }
  return sum.bounds(eps);
}

}  // namespace CGAL::Bounding_arcs::internal
