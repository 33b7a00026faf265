// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Bodies of query/closest_points.h.

#include <CGAL/Bounding_arcs_2/query/closest_points.h>
#include "Feet_search.h"
#include "Nearest_curves_search.h"
#include "query_units.h"

#include <cmath>
#include <cstddef>
#include <stdexcept>
#include <vector>

namespace CGAL::Bounding_arcs::internal {

// Brackets in their unit as those of the point that was asked about.
static void take_out(const Unit& unit, double error, std::vector<Closest_point<>>& found) {
  for (Closest_point<>& f : found) {
    f = out(unit, f);
    if (error > 0) f.distance = widened(f.distance, error);
  }
}

std::vector<Closest_point<>> closest_points(const Bounding_arc_tree_2& curves, const Asked_point& q, double eps) {
  check_positive(eps);
  const Segment_hierarchy& in_unit = curves.in_unit();
  const Xy<double> p = point_in(curves.unit(), q.point);
  const auto nearest = closest_point(in_unit, p);
  if (!nearest) return {};
  const double most = nearest->distance.upper + curves.unit().tolerance_in(eps);
  auto found = Feet_search(in_unit, p, most).result();
  take_out(curves.unit(), q.error, found);
  return found;
}

std::vector<Closest_point<>> k_nearest_curves(const Bounding_arc_tree_2& curves, const Asked_point& q, std::size_t k) {
  const Xy<double> p = point_in(curves.unit(), q.point);
  if (k == 0) return {};
  Nearest_curves_search search(curves.in_unit(), p, k);
  auto found = search.result();
  take_out(curves.unit(), q.error, found);
  return found;
}

}  // namespace CGAL::Bounding_arcs::internal
