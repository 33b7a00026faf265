// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The medial axis of the regions that the closed curves of a drawing bound, and the Voronoi diagram of all its curves,
// open ones and points, too, within a frame.

#ifndef CGAL_BOUNDING_ARCS_2_MEDIAL_AXIS_MEDIAL_AXIS_H
#define CGAL_BOUNDING_ARCS_2_MEDIAL_AXIS_MEDIAL_AXIS_H

#include <CGAL/Bounding_arcs_2/internal/medial_axis/Axis_builder.h>
#include <CGAL/Bounding_arcs_2/internal/medial_axis/check_discs.h>
#include <CGAL/Bounding_arcs_2/internal/medial_axis/make_axis_boundary.h>
#include <CGAL/Bounding_arcs_2/medial_axis/Medial_axis_2.h>
#include <CGAL/Bounding_arcs_2/medial_axis/framed.h>
#include <CGAL/Bounding_arcs_2/query/intersections.h>

#include <algorithm>
#include <stdexcept>
#include <utility>

namespace CGAL::Bounding_arcs {

struct Medial_axis_options {
  double eps = 1e-6;  ///< how far the axis, and its radius together, may be from the lines between samples
  Fill_rule rule = Fill_rule::NONZERO;  ///< which points are inside
  bool is_framed = false;  ///< the last curve is a frame: all points in it are inside, and other curves are walls
};

namespace internal {
// Of curves that do not cross; they may touch where convex corners of regions meet.
[[nodiscard]] inline Medial_axis_2 axis_of_uncrossed(const Curve_index_2& index, const Medial_axis_options& options) {
  Axis_boundary_maker maker = options.is_framed ? Axis_boundary_maker::framed(index)
                                                          : Axis_boundary_maker(index, options.rule);
  const bool is_decided = maker.is_decided();
  const Axis_boundary boundary = std::move(maker).boundary();
  constexpr double LEAST = 0x1p-36;  // of the size: a finer polyline would be of roundings, and endless
  const double eps = (std::max)(options.eps, LEAST * boundary.size());
  Medial_axis_2 axis = Axis_builder(boundary, eps).build();
  axis.eps = eps;
  const bool is_right = check_discs(index, boundary, axis);
  if (!is_decided || !is_right) axis.status = Medial_axis_status::UNRESOLVED;
  return axis;
}
}  // namespace internal

/// The medial axis of all regions that the closed curves of a drawing enclose, whatever the direction of the curves. A
/// curve inside of what others enclose under the nonzero rule is a wall with a region on both sides.
///
/// Leaves are convex corners, where the radius is 0, and maxima of curvature with an empty osculating disc; a circular
/// arc of largest curvature is one leaf, which touches both ends of the arc. Discs that touch the same places are one
/// vertex of a higher degree. A disc has one vertex and no edge; the axis of a ring is an edge from a vertex of degree
/// 2, anywhere on it, to itself.
///
/// In a frame each curve has discs on both sides, and ends of open curves and points are touched from all around, like
/// reflex corners: the axis is the Voronoi diagram of the curves and the frame, together with their medial axes within
/// it. What only the frame makes has a sample that touches the last curve in each of its edges (`touches`, framed.h).
/// \param options eps > 0, in units of the coordinates
/// \guarantee of a complete axis: discs of vertices and samples touch their places but for some roundings of the
///   coordinates; the bracket of each vertex's `clearance` is certified. Between samples the axis is within eps by an
///   estimate from its directions and the radius's slopes at both samples. Every eighth sample is asked for curves in
///   its disc at the end; an axis that fails is UNRESOLVED, never silently wrong there
/// \throws std::invalid_argument if a curve is open, or eps is not above 0; in a frame, if that is open, or does not
///   enclose a curve
/// \complexity about n log n in the number of segments, and the samples, which are as many as eps^(-1/2)
/// \source Choi, Choi, Moon 1997 and Aichholzer, Aigner, Aurenhammer, Hackl, Juettler, Rabl 2009: cutting at maximal
///   discs; here of the curves themselves, by searches as Lee, Kim, Kim, Elber 2016 have them
[[nodiscard]] inline Medial_axis_2 medial_axis(const Curve_index_2& index, const Medial_axis_options& options = {}) {
  if (!(options.eps > 0)) throw std::invalid_argument("a tolerance above 0 is needed");
  if (!options.is_framed) check_closed(index.drawing());
  Medial_axis_2 axis;
  const Intersections_2 common = self_intersections(index);
  if (!common.points.empty() || !common.overlaps.empty()) {
    axis.status = Medial_axis_status::CROSSING;
    return axis;
  }
  if (options.is_framed) check_frame(index.drawing());
  return internal::axis_of_uncrossed(index, options);
}

}  // namespace CGAL::Bounding_arcs

#endif
