// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// What boundaries of spiral fat arcs and bilens are made of, from the scalars of frame/Tight_frame_2.h: axes in the
// plane at both ends, contact circles there, joints, chains.

#ifndef CGAL_BOUNDING_ARCS_2_REGION_TIGHT_AXES_H
#define CGAL_BOUNDING_ARCS_2_REGION_TIGHT_AXES_H

#include <CGAL/Bounding_arcs_2/frame/Chord_frame_2.h>
#include <CGAL/Bounding_arcs_2/number/number_types.h>
#include <CGAL/Bounding_arcs_2/region/Contact_circle_2.h>

namespace CGAL::Bounding_arcs {

namespace internal {
/// Unit vectors of the tight frame in the plane: `along` leads from the tight end into the segment.
template <class NT> struct Tight_axes {
  Xy<NT> tight, flat;                ///< the end points
  Xy<NT> along, inward_tight;        ///< at the tight end: tangent into the segment, normal towards the centers
  Xy<NT> back, inward_flat;          ///< the same at the flat end
  Xy<NT> normal_tight, normal_flat;  ///< left normals in the direction of the curve
};

/// Returns the axes of a frame with different ends. Needs square roots.
template <class NT> [[nodiscard]] Tight_axes<NT> tight_axes(const Chord_frame_2<NT>& frame) {
  const Chord_shape_2<NT>& f = frame.shape;
  const auto unit = [](const Xy<NT>& v) {
    const NT n = square_root(dot(v, v));
    return Xy<NT>{NT(v.x / n), NT(v.y / n)};
  };
  const Xy<NT> u_tight = unit(f.tight_first ? f.tangent0 : f.tangent1);
  const Xy<NT> u_flat = unit(f.tight_first ? f.tangent1 : f.tangent0);
  return {f.tight_first ? frame.p0 : frame.p1,
          f.tight_first ? frame.p1 : frame.p0,
          f.tight_first ? u_tight : -u_tight,
          NT(f.turn) * perp(u_tight),
          f.tight_first ? -u_flat : u_flat,
          NT(f.turn) * perp(u_flat),
          perp(u_tight),
          perp(u_flat)};
}

/// The joint of a biarc, from the end where p0 is, so that it keeps its digits relative to there.  From either end the
/// chord to the joint has the direction (x, K): x = (K - sin alpha) cos delta / sin delta + cos alpha, with K, alpha
/// and delta as that end sees them, and |joint - end| = c / sqrt(x^2 + K^2).
template <class NT>
[[nodiscard]] Xy<NT> biarc_joint(const Tight_axes<NT>& axes, const NT& chord, bool from_tight, const NT& x,
                                 const NT& k) {
  const NT scale = chord / (k * k + x * x);
  if (from_tight) return axes.tight + (NT(scale * x) * axes.along + NT(scale * k) * axes.inward_tight);
  return axes.flat + (NT(scale * x) * axes.back + NT(scale * k) * axes.inward_flat);
}
}  // namespace internal

/// The chain tight end -> joint -> flat end, turned round when the tight end comes last.
template <class NT>
[[nodiscard]] Boundary_chain_2<NT> chain(const Chord_frame_2<NT>& frame, const internal::Tight_axes<NT>& axes,
                                         const Xy<NT>& joint, const Contact_circle_2<NT>& at_tight,
                                         const Contact_circle_2<NT>& at_flat) {
  if (frame.shape.tight_first) return {{axes.tight, joint, at_tight}, {joint, axes.flat, at_flat}};
  return {{axes.flat, joint, at_flat}, {joint, axes.tight, at_tight}};
}

namespace internal {
/// The contact circle at the tight or flat end with K = curvature times half the chord, in the curve's direction.
template <class NT>
[[nodiscard]] Contact_circle_2<NT> contact(const Xy<NT>& point, const Xy<NT>& normal, const NT& k, int turn,
                                           const NT& chord) {
  return {point, normal, NT(NT(2 * turn) * k / chord)};
}
}  // namespace internal

}  // namespace CGAL::Bounding_arcs

#endif
