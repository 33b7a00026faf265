// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// What is checked of an axis that is made.

#ifndef CGAL_BOUNDING_ARCS_2_MEDIAL_AXIS_INTERNAL_CHECK_DISCS_H
#define CGAL_BOUNDING_ARCS_2_MEDIAL_AXIS_INTERNAL_CHECK_DISCS_H

#include <CGAL/Bounding_arcs_2/medial_axis/Medial_axis_2.h>
#include <CGAL/Bounding_arcs_2/medial_axis/internal/Axis_boundary.h>
#include <CGAL/Bounding_arcs_2/query/Closest_search.h>

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace CGAL::Bounding_arcs::internal {

// Brackets of all vertices. \return whether no disc of a vertex, nor of any of many samples, has a curve in it: what
// rounding may have made of decisions would be seen there
[[nodiscard]] inline bool check_discs(const Segment_hierarchy& curves, const Axis_boundary& boundary,
                                      Medial_axis_2& axis) {
  const auto is_empty = [&](const Xy<double>& centre, double radius) {
    constexpr double ROUNDING = 64;  // times the resolution
    Closest_search search(curves, centre, radius - ROUNDING * boundary.resolution());
    search.search();
    return !search.result().has_value();
  };
  bool is_right = true;
  constexpr std::size_t STEP = 8;
  for (const Medial_edge& e : axis.edges)
    for (std::size_t i = e.samples.size() / 2 % STEP; i < e.samples.size(); i += STEP)
      is_right = is_right && is_empty(e.samples[i].centre, e.samples[i].radius);
  for (Medial_vertex& v : axis.vertices) {
    v.clearance = closest_point(curves, v.centre)->distance;
    axis.error = (std::max)({axis.error, v.clearance.upper - v.radius, v.radius - v.clearance.lower});
    is_right = is_right && is_empty(v.centre, v.radius);
  }
  return is_right;
}

/// The most by which a vertex's disc misses one of its touches, or its centre's distance from all curves.
[[nodiscard]] inline double most_miss(const Segment_hierarchy& curves, const Medial_axis_2& axis) {
  double most = axis.error;
  for (const Medial_vertex& v : axis.vertices)
    for (const Curve_place& p : v.touches) {
      const Xy<double> point = curves.evaluator(curves.number_of_bezier(p.curve, p.bezier))(p.t).point;
      most = (std::max)(most, std::fabs(euclidean_norm(point - v.centre) - v.radius));
    }
  return most;
}

}  // namespace CGAL::Bounding_arcs::internal

#endif
