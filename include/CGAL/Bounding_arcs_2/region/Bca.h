// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Bounding circular arcs (Meek and Walton 1995; Lee, Kim, Elber 2015): the two arcs over the chord that touch the
// curve at its start and at its end.  The one of larger angle, at the tight end, is the outer one.  Derivation:
// doc/numerics.md; that the curve is inside: verify/internal/prove_bca.h.

#ifndef CGAL_BOUNDING_ARCS_2_REGION_BCA_H
#define CGAL_BOUNDING_ARCS_2_REGION_BCA_H

#include <CGAL/Bounding_arcs_2/frame/Chord_frame_2.h>
#include <CGAL/Bounding_arcs_2/region/Contact_circle_2.h>

namespace CGAL::Bounding_arcs {

/// The BCA construction as a function of the chord frame.  A piece that does not run ahead is no spiral but the sliver
/// beside a near-cusp: its region is the disc over the chord.
/// \cgalModels{Construction}
struct Bca {
  static constexpr const char* NAME = "bca";
  static constexpr int ARCS_PER_REGION = 2;
  static constexpr bool NEEDS_CURVATURE = false;
  static constexpr bool NEEDS_CONTROL_POINTS = false;
  static constexpr bool BOUNDARY_NEEDS_SQUARE_ROOT = false;

  /// r_outer + |z_outer z_inner| - r_inner = c/2 |tan(alpha0/2) - tan(alpha1/2)|, in units of the plane; of a disc c.
  /// \guarantee exact over a field with square roots; over double a few u relative, up to the slope of curvature
  /// \complexity two square roots shared with a neighbour, one of the chord, two divisions
  template <class NT> [[nodiscard]] static NT thickness(const Chord_shape_2<NT>& f) {
    const NT n0 = square_root(dot(f.tangent0, f.tangent0));
    const NT n1 = square_root(dot(f.tangent1, f.tangent1));
    const NT c = square_root(dot(f.chord, f.chord));
    if (c == NT(0)) return NT(0);  // a single point
    if (!f.runs_ahead) return NT(f.unit * c);
    const NT d0 = n0 * c + dot(f.tangent0, f.chord), d1 = n1 * c + dot(f.tangent1, f.chord);
    const NT change = f.bulge_change(n0, n1, c);
    using CGAL::abs;
    return NT(f.unit *
              NT(c * abs(change) / (NT(2) * d0 * d1)));  // the unit last: before, it would take digits of tiny curves
  }

  /// Both arcs run from p0 to p1. Free of square roots: contact circles with normals scaled by |chord|^2.
  template <class NT> [[nodiscard]] static Region_boundary_2<NT> boundary(const Chord_frame_2<NT>& frame) {
    const Chord_shape_2<NT>& f = frame.shape;
    const NT cc = f.unit * dot(f.chord, f.chord);
    if (!f.runs_ahead && cc != NT(0)) return disc(frame);
    const Contact_circle_2<NT> start{frame.p0, cc * perp(f.tangent0), NT(NT(2) * f.cross0)};
    const Contact_circle_2<NT> end{frame.p1, cc * perp(f.tangent1), NT(NT(2) * f.cross1)};
    const Boundary_chain_2<NT> at_start({frame.p0, frame.p1, start}), at_end({frame.p0, frame.p1, end});
    return f.tight_first ? Region_boundary_2<NT>{at_end, at_start, Region_form::BCA}
                         : Region_boundary_2<NT>{at_start, at_end, Region_form::BCA};
  }

 private:
  template <class NT> [[nodiscard]] static Region_boundary_2<NT> disc(const Chord_frame_2<NT>& frame) {
    const Xy<NT> chord = frame.shape.unit * frame.shape.chord;
    const Boundary_chain_2<NT> left({frame.p0, frame.p1, {frame.p0, -chord, NT(-2)}});  // clockwise
    const Boundary_chain_2<NT> right({frame.p0, frame.p1, {frame.p0, chord, NT(2)}});   // counterclockwise
    return frame.shape.turn < 0 ? Region_boundary_2<NT>{right, left, Region_form::BCA}
                                : Region_boundary_2<NT>{left, right, Region_form::BCA};
  }
};

}  // namespace CGAL::Bounding_arcs

#endif
