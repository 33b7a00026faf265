// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Bodies of medial_axis/medial_axis.h.

#include "../boolean/plane_faces.h"

#include <CGAL/Bounding_arcs_2/medial_axis/framed.h>
#include <CGAL/Bounding_arcs_2/medial_axis/internal/axis_of_uncrossed.h>
#include <CGAL/Bounding_arcs_2/medial_axis/internal/compiled_axes.h>
#include <CGAL/Bounding_arcs_2/medial_axis/medial_axis.h>
#include <CGAL/Bounding_arcs_2/number/expected.h>
#include <CGAL/Bounding_arcs_2/query/Drawing_location.h>
#include <CGAL/Bounding_arcs_2/query/closed_curves.h>
#include <CGAL/Bounding_arcs_2/query/intersections.h>

#include <algorithm>
#include <optional>
#include <vector>

namespace CGAL::Bounding_arcs::internal {

namespace {

/// A point next to the middle of the longest segment of a ring, on its left.
[[nodiscard]] Xy<double> point_within(const Segment_hierarchy& curves, const std::vector<Directed_segment>& ring) {
  const auto length = [&](const Directed_segment& s) {
    const Spiral_piece_2& p = curves.piece(s.segment);
    return euclidean_norm(p.last.point - p.first.point);
  };
  const Directed_segment& s =
      *std::max_element(ring.begin(), ring.end(),
                        [&](const Directed_segment& a, const Directed_segment& b) { return length(a) < length(b); });
  const Spiral_piece_2& p = curves.piece(s.segment);
  const Spiral_sample middle = curves.sample(s.segment, p.first.t + (p.last.t - p.first.t) / 2);
  const double step = 0x1p-30 * length(s) + 64 * curves.error(s.segment);
  return middle.point + (s.is_reversed ? -step : step) * perp(middle.tangent);
}

/// The axis of curves that meet, within a frame.
[[nodiscard]] Medial_axis_2 axis_of_meeting(const Drawing_hierarchy& curves, const Axis_job& job) {
  const Outline_operand operand{&curves.drawing(), curves.in_unit().is_rounded() ? &curves : nullptr};
  std::optional<Plane_faces> faces = plane_faces(operand, curves.in_unit().decisions());
  if (!faces) {
    Medial_axis_2 axis;
    axis.eps = job.eps;
    axis.status = Medial_axis_status::UNRESOLVED;
    return axis;
  }
  Drawing_2<double> frame;
  frame.add(curves.drawing().curves().back().beziers, "frame");
  const Drawing_hierarchy frame_curves(frame);
  const Drawing_location location(frame_curves);
  const auto is_outside = [&](const std::vector<Directed_segment>& ring) {
    return ring.empty() || location.locate(faces->unit.out(point_within(faces->curves, ring))) != Point_side::INSIDE;
  };
  auto& rings = faces->rings;
  rings.erase(std::remove_if(rings.begin(), rings.end(), is_outside), rings.end());
  Medial_axis_2 axis = axis_of_faces(faces->unit, faces->curves, rings, job);
  const auto move = [&](Curve_place& p) {
    const auto& given = faces->places[faces->curves.number_of_bezier(p.curve, p.bezier)];
    p.curve = given.curve, p.bezier = given.bezier;
  };
  for (Medial_vertex& v : axis.vertices) std::for_each(v.touches.begin(), v.touches.end(), move);
  for (Medial_edge& e : axis.edges)
    for (Medial_sample& s : e.samples) move(s.left), move(s.right);
  return axis;
}

}  // namespace

Medial_axis_2 medial_axis(const Drawing_hierarchy& curves, const Axis_job& job) {
  check_above_zero("eps", job.eps);
  if (job.is_framed) check_frame(curves.drawing());
  else check_closed(curves.drawing());
  const Intersections_2<> common = self_intersections(curves);
  if (common.points.empty() && common.overlaps.empty()) return axis_of_uncrossed(curves, job);
  if (job.is_framed) return axis_of_meeting(curves, job);
  Medial_axis_2 axis;
  axis.status = Medial_axis_status::CROSSING;
  return axis;
}

}  // namespace CGAL::Bounding_arcs::internal
