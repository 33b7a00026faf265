// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Up to 64 pieces of spiral segments, of one or of many, and the arcs over them, in columns.  The loops are plain;
// compiled for wider registers (src/library/chain/arc_loops.cpp) they give the same bits, as each operation rounds by
// itself.

#ifndef BOUNDING_ARCS_LIBRARY_CHAIN_ARC_COLUMNS_H
#define BOUNDING_ARCS_LIBRARY_CHAIN_ARC_COLUMNS_H

#include <CGAL/Bounding_arcs_2/number/strict_math.h>
#include <CGAL/Bounding_arcs_2/tree/Build_options.h>
#include "../tree/Instruction_sets.h"
#include "Cubic_arcs.h"

#include <cstddef>

namespace CGAL::Bounding_arcs::internal {

struct Arc_columns {
  static constexpr std::size_t SIZE = 64;
  using Column = double[SIZE];

  std::size_t count = 0;
  // The segment: its curve is start + unit (c1 s + c2 s^2 + c3 s^3), s in [0, 1], but `end` at 1.
  Column x1, y1, x2, y2, x3, y3, start_x, start_y, end_x, end_y, unit, inverse_unit;
  Column limit;   ///< the largest distance asked for, in units
  Column s0, s1;  ///< the piece
  // The arcs; of balanced ones only the first.
  Column from_x, from_y, joint_x, joint_y, to_x, to_y, joint, bulge0, bulge1;
  Column distance0, distance1;  ///< in units, as in Fitted_arc
};

/// The cubic of piece j.
[[nodiscard]] CGAL_BOUNDING_ARCS_INLINE Cubic column_cubic(const Arc_columns& c, std::size_t j) {
  return {c.x1[j], c.y1[j], c.x2[j], c.y2[j], c.x3[j], c.y3[j]};
}
/// A vector of the segment's units as a point, and the difference of two points as a vector.
[[nodiscard]] CGAL_BOUNDING_ARCS_INLINE Plane_vector in_plane(const Arc_columns& c, std::size_t j, Plane_vector v) {
  return {c.start_x[j] + c.unit[j] * v.x, c.start_y[j] + c.unit[j] * v.y};
}
[[nodiscard]] CGAL_BOUNDING_ARCS_INLINE Plane_vector in_units(const Arc_columns& c, std::size_t j, Plane_vector v) {
  return c.inverse_unit[j] * v;
}
[[nodiscard]] CGAL_BOUNDING_ARCS_INLINE Plane_vector piece_end(const Arc_columns& c, std::size_t j,
                                                               const Cubic& curve) {
  const double s = c.s1[j], end_x = c.end_x[j],
               end_y = c.end_y[j];  // not loaded conditionally, which bars vectorisation
  const Plane_vector p = in_plane(c, j, curve(s));
  return {s == 1 ? end_x : p.x, s == 1 ? end_y : p.y};
}

/// Biarcs over all pieces, and over what follows up to a multiple of 8, where nobody reads them.
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

/// Balanced arcs in the same way.
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

using Arc_function = void (*)(Arc_columns&);

/// The loops compiled for one instruction set; defined in src/library/chain/arc_loops.cpp.
template <class Isa> void compiled_biarcs(Arc_columns&);
template <class Isa> void compiled_balanced(Arc_columns&);

/// The loops of one kind, for function_for.
template <bool ARE_BIARCS> struct Fits_of_kind {
  template <class Isa> [[nodiscard]] static Arc_function of() {
    return ARE_BIARCS ? &compiled_biarcs<Isa> : &compiled_balanced<Isa>;
  }
};
[[nodiscard]] inline Arc_function arc_function(bool are_biarcs, Instruction_set set) {
  return are_biarcs ? function_for<Fits_of_kind<true>>(set) : function_for<Fits_of_kind<false>>(set);
}

}  // namespace CGAL::Bounding_arcs::internal

#endif
