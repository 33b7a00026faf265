// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// How an axis is made, step by step: of curves that do not cross, of what is to their left, or of faces.

#ifndef CGAL_BOUNDING_ARCS_2_MEDIAL_AXIS_INTERNAL_AXIS_OF_UNCROSSED_H
#define CGAL_BOUNDING_ARCS_2_MEDIAL_AXIS_INTERNAL_AXIS_OF_UNCROSSED_H

#include <CGAL/Bounding_arcs_2/medial_axis/Medial_axis_2.h>
#include <CGAL/Bounding_arcs_2/medial_axis/internal/Axis_builder.h>
#include <CGAL/Bounding_arcs_2/medial_axis/internal/Axis_job.h>
#include <CGAL/Bounding_arcs_2/medial_axis/internal/Bounding_curves.h>
#include <CGAL/Bounding_arcs_2/medial_axis/internal/axis_units.h>
#include <CGAL/Bounding_arcs_2/medial_axis/internal/check_discs.h>
#include <CGAL/Bounding_arcs_2/medial_axis/internal/make_axis_boundary.h>
#include <CGAL/Bounding_arcs_2/tree/Drawing_hierarchy.h>
#include <CGAL/Bounding_arcs_2/tree/Segment_hierarchy.h>

#include <algorithm>
#include <cstdint>
#include <utility>
#include <vector>

namespace CGAL::Bounding_arcs::internal {

[[nodiscard]] inline Medial_axis_2 axis_of_boundary(const Segment_hierarchy& curves, Axis_boundary_maker maker,
                                                    const Axis_job& job) {
  const bool is_decided = maker.is_decided();
  const Axis_boundary boundary = std::move(maker).boundary();
  constexpr double LEAST = 0x1p-36;  // of the size: a finer polyline would be of roundings, and endless
  const double eps = (std::max)(job.eps, LEAST * boundary.size());
  const auto made = [&](bool is_joining) {
    Medial_axis_2 axis = Axis_builder(boundary, eps, is_joining, job.loop).build();
    axis.eps = eps;
    check_discs(curves, boundary, job.loop, axis);
    if (!is_decided) axis.status = Medial_axis_status::UNRESOLVED;
    return axis;
  };
  Medial_axis_2 axis = made(false);
  const auto is_good = [](const Medial_axis_2& a) { return a.status == Medial_axis_status::COMPLETE; };
  constexpr double ROOM = 8;  // times the resolution: vertices miss what they touch by less
  const double miss = most_miss(curves, axis);
  if (!is_decided || (is_good(axis) && miss <= ROOM * boundary.resolution())) return axis;
  // nearly equal discs were told apart by rounding
  Medial_axis_2 joined = made(true);
  const bool is_better = is_good(joined) && (!is_good(axis) || most_miss(curves, joined) < miss);
  return is_better ? joined : axis;
}

/// The axis of curves that do not cross or touch.
[[nodiscard]] inline Medial_axis_2 axis_of_uncrossed(const Drawing_hierarchy& all, Axis_job job) {
  const Bounding_curves bounding(all, job.is_framed
                                          ? std::vector<std::uint32_t>{}
                                          : Axis_boundary_maker::curves_within(all.in_unit(), job.rule, job.loop));
  const Drawing_hierarchy& curves = bounding.curves();
  const Segment_hierarchy& in_unit = curves.in_unit();
  job.eps = curves.unit().tolerance_in(job.eps);
  Axis_boundary_maker maker =
      job.is_framed ? Axis_boundary_maker::framed(in_unit) : Axis_boundary_maker(in_unit, job.rule, job.loop);
  return bounding.among_all(out(curves.unit(), axis_of_boundary(in_unit, std::move(maker), job)));
}
/// The axis of what is to the left of closed curves, which may meet at joints.
/// \param is_ccw of each curve
[[nodiscard]] inline Medial_axis_2 axis_to_the_left(const Drawing_hierarchy& curves, const std::vector<bool>& is_ccw,
                                                    Axis_job job) {
  const Segment_hierarchy& in_unit = curves.in_unit();
  job.eps = curves.unit().tolerance_in(job.eps);
  return out(curves.unit(), axis_of_boundary(in_unit, Axis_boundary_maker::directed(in_unit, is_ccw), job));
}

/// The axis of faces, each to the left of a ring or more.
[[nodiscard]] inline Medial_axis_2 axis_of_faces(const Unit& unit, const Segment_hierarchy& curves,
                                                 const std::vector<std::vector<Directed_segment>>& rings,
                                                 Axis_job job) {
  job.eps = unit.tolerance_in(job.eps);
  return out(unit, axis_of_boundary(curves, Axis_boundary_maker::faces(curves, rings), job));
}

}  // namespace CGAL::Bounding_arcs::internal

#endif
