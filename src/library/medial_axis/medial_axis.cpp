// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Bodies of medial_axis/medial_axis.h.
//
//   curves -> parts that bound regions -> boundary of segments and corners -> parts between discs -> vertices and edges

#include <CGAL/Bounding_arcs_2/medial_axis/framed.h>
#include <CGAL/Bounding_arcs_2/medial_axis/internal/Axis_builder.h>
#include <CGAL/Bounding_arcs_2/medial_axis/internal/Bounding_parts.h>
#include <CGAL/Bounding_arcs_2/medial_axis/internal/axis_units.h>
#include <CGAL/Bounding_arcs_2/medial_axis/internal/check_discs.h>
#include <CGAL/Bounding_arcs_2/medial_axis/internal/compiled_axes.h>
#include <CGAL/Bounding_arcs_2/medial_axis/internal/make_axis_boundary.h>
#include <CGAL/Bounding_arcs_2/medial_axis/medial_axis.h>
#include <CGAL/Bounding_arcs_2/number/expected.h>
#include <CGAL/Bounding_arcs_2/query/closed_curves.h>

#include <algorithm>
#include <memory>
#include <utility>

namespace CGAL::Bounding_arcs::internal {

namespace {

[[nodiscard]] Medial_axis_2 axis_of(const Bounding_parts& parts, const Axis_job& job) {
  const Axis_boundary boundary = axis_boundary(parts);
  constexpr double LEAST = 0x1p-36;  // of the size: a finer polyline would be of roundings, and endless
  const double eps = (std::max)(job.eps, LEAST * boundary.size());
  const auto made = [&](bool is_joining) {
    Medial_axis_2 axis = Axis_builder(boundary, eps, is_joining, job.loop).build();
    axis.eps = eps;
    check_discs(parts.segments, boundary, job.loop, axis);
    return axis;
  };
  Medial_axis_2 axis = made(false);
  const auto is_good = [](const Medial_axis_2& a) { return a.status == Medial_axis_status::COMPLETE; };
  constexpr double ROOM = 8;  // times the resolution: vertices miss what they touch by less
  const double miss = most_miss(parts.segments, axis);
  if (is_good(axis) && miss <= ROOM * boundary.resolution() + parts.moved) return axis;
  // nearly equal discs were told apart by rounding
  Medial_axis_2 joined = made(true);
  const bool is_better = is_good(joined) && (!is_good(axis) || most_miss(parts.segments, joined) < miss);
  return is_better ? joined : axis;
}

}  // namespace

Medial_axis_2 medial_axis(const Drawing_hierarchy& curves, const Axis_job& job) {
  check_above_zero("eps", job.eps);
  if (job.is_framed) check_frame(curves.drawing());
  else check_closed(curves.drawing());
  const auto bounds = std::make_shared<const Bounding_parts>(bounding_parts(curves.in_unit(), job));
  Axis_job in_unit = job;
  in_unit.eps = curves.unit().tolerance_in(job.eps);
  Medial_axis_2 axis = axis_of(*bounds, in_unit);
  axis.moved = bounds->moved;
  if (bounds->undecided) {
    axis.status = Medial_axis_status::UNRESOLVED;
    axis.unresolved = {*bounds->undecided};
  }
  axis = out(curves.unit(), std::move(axis));
  axis.left_out = bounds->left_out;
  axis.options = job;
  axis.bounds = bounds;
  return axis;
}

}  // namespace CGAL::Bounding_arcs::internal
