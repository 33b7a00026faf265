// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The angles between chord and end tangents, as tangents of their halves, and the difference of these without
// cancellation.  Needs square roots.

#ifndef CGAL_BOUNDING_ARCS_2_FRAME_CHORD_ANGLES_2_H
#define CGAL_BOUNDING_ARCS_2_FRAME_CHORD_ANGLES_2_H

#include <CGAL/Bounding_arcs_2/frame/Chord_frame_2.h>

namespace CGAL::Bounding_arcs {
/// (tan(alpha0/2) - tan(alpha1/2)) d0 d1 = A d1 - B d0 with d_i = n_i c + T_i.D: c (A n1 - B n0) + (A T1.D - B T0.D).
/// Where both angles turn the same way A n1 - B n0 = (A^2 n1^2 - B^2 n0^2) / (A n1 + B n0), and the two terms have the
/// same sign, as sin(alpha0 - alpha1) has that of sin^2 alpha0 - sin^2 alpha1; else nothing cancels in the first place.
template <class NT> [[nodiscard]] NT bulge_change(const Chord_shape_2<NT>& f, const NT& n0, const NT& n1, const NT& c) {
  const NT first = f.cross0 * n1, second = f.cross1 * n0;
  if (!f.turns_one_way) return NT(c * (first - second) + f.sine_change);
  return NT(c * f.square_change * ((f.cross0 + f.cross1) / (first + second)) + f.sine_change);
}

/// The half-angle tangents of a chord shape: bulge_i = tan(alpha_i / 2).
template <class NT> struct Chord_angles_2 {
  NT length0{0}, length1{0};  ///< |tangent0|, |tangent1| in the shape's units
  NT chord{0};                ///< |chord| in the shape's units
  NT bulge0{0}, bulge1{0};
  NT bulge_change{0};  ///< bulge0 - bulge1, formed without cancellation
};

/// \guarantee over double, relative error of a few u in each member, of bulge_change up to the slope of curvature
/// \source design formula: A d1 - B d0 = (A - B) d1 + B (d1 - d0), d_i = n_i c + T_i . D
template <class NT> [[nodiscard]] Chord_angles_2<NT> chord_angles(const Chord_shape_2<NT>& f) {
  Chord_angles_2<NT> g;
  g.length0 = square_root(dot(f.tangent0, f.tangent0));
  g.length1 = square_root(dot(f.tangent1, f.tangent1));
  g.chord = square_root(dot(f.chord, f.chord));
  if (g.chord == NT(0)) return g;  // a single point
  const NT d0 = g.length0 * g.chord + dot(f.tangent0, f.chord), d1 = g.length1 * g.chord + dot(f.tangent1, f.chord);
  g.bulge0 = f.cross0 / d0;
  g.bulge1 = f.cross1 / d1;
  g.bulge_change = bulge_change(f, g.length0, g.length1, g.chord) / (d0 * d1);
  return g;
}

}  // namespace CGAL::Bounding_arcs

#endif
