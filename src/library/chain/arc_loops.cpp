// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The loops that fit arcs, for one instruction set: compiled once for each, as the batch loops are
// (src/library/tree/batch_loops.cpp).

#include "Cubic_arcs.h"

namespace CGAL::Bounding_arcs::internal {

/// The cubic of piece j.
[[nodiscard]] CGAL_BOUNDING_ARCS_INLINE static Cubic column_cubic(const Arc_columns& c, std::size_t j) {
  return {c.x1[j], c.y1[j], c.x2[j], c.y2[j], c.x3[j], c.y3[j]};
}
/// A vector of the segment's units as a point, and the difference of two points as a vector.
[[nodiscard]] CGAL_BOUNDING_ARCS_INLINE static Plane_vector in_plane(const Arc_columns& c, std::size_t j,
                                                                     Plane_vector v) {
  return {c.start_x[j] + c.unit[j] * v.x, c.start_y[j] + c.unit[j] * v.y};
}
[[nodiscard]] CGAL_BOUNDING_ARCS_INLINE static Plane_vector in_units(const Arc_columns& c, std::size_t j,
                                                                     Plane_vector v) {
  return c.inverse_unit[j] * v;
}
[[nodiscard]] CGAL_BOUNDING_ARCS_INLINE static Plane_vector piece_end(const Arc_columns& c, std::size_t j,
                                                                      const Cubic& curve) {
  const double s = c.s1[j], end_x = c.end_x[j],
               end_y = c.end_y[j];  // not loaded conditionally, which bars vectorisation
  const Plane_vector p = in_plane(c, j, curve(s));
  return {s == 1 ? end_x : p.x, s == 1 ? end_y : p.y};
}

template <class Isa> void fit_biarcs(Arc_columns& c) {
  const std::size_t n = (c.count + 7) / 8 * 8;
  for (std::size_t j = 0; j < n; ++j) {
    const Cubic curve = column_cubic(c, j);
    const Plane_vector from = in_plane(c, j, curve(c.s0[j])), to = piece_end(c, j, curve);
    const double h = c.s1[j] - c.s0[j];
    const Cubic q0 = curve.from(c.s0[j]), q1 = curve.from(c.s1[j]);
    const double u = joint_parameter(q0, q1, h, in_units(c, j, to - from)), s = c.s0[j] + u * h;
    const Plane_vector joint = in_plane(c, j, curve(s));
    const Fitted_arc a = tangent_arc(q0, q1.c1(), u * h, 1, in_units(c, j, joint - from), c.limit[j]);
    const Fitted_arc b = tangent_arc(q1, q0.c1(), (u - 1) * h, -1, in_units(c, j, joint - to), c.limit[j]);
    c.from_x[j] = from.x;
    c.from_y[j] = from.y;
    c.joint_x[j] = joint.x;
    c.joint_y[j] = joint.y;
    c.to_x[j] = to.x;
    c.to_y[j] = to.y;
    c.joint[j] = s;
    c.bulge0[j] = a.bulge;
    c.bulge1[j] = b.bulge;
    c.distance0[j] = a.distance;
    c.distance1[j] = b.distance;
  }
}

template <class Isa> void fit_balanced(Arc_columns& c) {
  const std::size_t n = (c.count + 7) / 8 * 8;
  for (std::size_t j = 0; j < n; ++j) {
    const Cubic curve = column_cubic(c, j);
    const Plane_vector from = in_plane(c, j, curve(c.s0[j])), to = piece_end(c, j, curve);
    const Fitted_arc a = balanced_arc(curve, c.s0[j], c.s1[j], in_units(c, j, to - from), c.limit[j]);
    c.from_x[j] = from.x;
    c.from_y[j] = from.y;
    c.to_x[j] = to.x;
    c.to_y[j] = to.y;
    c.bulge0[j] = a.bulge;
    c.distance0[j] = a.distance;
  }
}

#define BOUNDING_ARCS_FITS(Isa)                \
  template void fit_biarcs<Isa>(Arc_columns&); \
  template void fit_balanced<Isa>(Arc_columns&)
BOUNDING_ARCS_FOR_SETS(BOUNDING_ARCS_FITS)

}  // namespace CGAL::Bounding_arcs::internal
