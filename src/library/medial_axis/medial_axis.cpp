// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Bodies of medial_axis/medial_axis.h.

#include <CGAL/Bounding_arcs_2/medial_axis/internal/axis_of_uncrossed.h>
#include <CGAL/Bounding_arcs_2/medial_axis/medial_axis.h>
#include <CGAL/Bounding_arcs_2/query/closed_curves.h>
#include <CGAL/Bounding_arcs_2/query/intersections.h>

#include <stdexcept>

namespace CGAL::Bounding_arcs::internal {

Medial_axis_2 medial_axis(const Drawing_hierarchy& curves, const Axis_job& job) {
  if (!(job.eps > 0)) throw std::invalid_argument("a tolerance above 0 is needed");
  if (!job.is_framed) check_closed(curves.drawing());
  Medial_axis_2 axis;
  const Intersections_2<> common = self_intersections(curves);
  if (!common.points.empty() || !common.overlaps.empty()) {
    axis.status = Medial_axis_status::CROSSING;
    return axis;
  }
  if (job.is_framed) check_frame(curves.drawing());
  return axis_of_uncrossed(curves, job);
}

}  // namespace CGAL::Bounding_arcs::internal
