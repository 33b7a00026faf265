// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Frames: drawings whose last curve encloses the others, for Voronoi diagrams (medial_axis.h, `is_framed`).

#ifndef CGAL_BOUNDING_ARCS_2_MEDIAL_AXIS_FRAMED_H
#define CGAL_BOUNDING_ARCS_2_MEDIAL_AXIS_FRAMED_H

#include <CGAL/Bounding_arcs_2/curve/Drawing_2.h>
#include <CGAL/Bounding_arcs_2/medial_axis/Medial_axis_2.h>

#include <cstddef>

namespace CGAL::Bounding_arcs {

/// A drawing with a rectangle behind its curves.
/// \param box to be the frame, with room around the curves: no disc fits between a curve and a frame that touch
[[nodiscard]] Drawing_2<double> framed(Drawing_2<double> drawing, const CGAL::Bbox_2& box);
/// The box of all control points.
[[nodiscard]] CGAL::Bbox_2 control_box(const Drawing_2<double>& drawing);
/// Returns the drawing in a frame with a margin around the box of all control points.
/// \param margin above 0, in units of the coordinates
/// \throws std::invalid_argument for a drawing without curves, or a margin that coordinates do not resolve
[[nodiscard]] Drawing_2<double> framed(Drawing_2<double> drawing, double margin);

namespace internal {
/// Checks a drawing whose last curve is to be a frame, and whose curves do not cross.
/// \throws std::invalid_argument if that is open, or does not enclose a curve
void check_frame(const Drawing_2<double>& drawing);
}  // namespace internal

/// Whether an edge runs beside a curve: its discs touch the curve on one of their sides.
[[nodiscard]] inline bool touches(const Medial_axis_2::Edge& edge, std::size_t curve) {
  const Medial_axis_2::Sample& s = edge.samples[edge.samples.size() / 2];
  return s.left.curve == curve || s.right.curve == curve;
}

}  // namespace CGAL::Bounding_arcs

#endif
