// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// A piece in its place as a program without this library's care has it: no more digits than its number type.

#ifndef BOUNDING_ARCS_LIBRARY_STUDY_PLAIN_FRAME_H
#define BOUNDING_ARCS_LIBRARY_STUDY_PLAIN_FRAME_H

#include <CGAL/Bounding_arcs_2/spiral/Bezier_spiral_2.h>

namespace CGAL::Bounding_arcs::study {

/// The piece [t0, t1] in T, of a curve in T whose unit of lengths has a number there.
template <class T>
[[nodiscard]] Chord_frame_2<T> plain_frame(const Bezier_curve_2<T>& curve, const Bezier_spiral_2<double>& spiral,
                                           double t0, double t1, const Shape_parts& parts = {}) {
  const double unit = length_unit(spiral.curve());
  return {curve.point(T(t0)), curve.point(T(t1)),
          bezier_chord_shape(Taylor_table<T>(curve, unit), T(t0), T(t1), parts, spiral.orders(t0, t1))};
}

}  // namespace CGAL::Bounding_arcs::study

#endif
