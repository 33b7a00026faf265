// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The fallbacks of the paper's section 4.3 as named policies that wrap a construction.  The constructions here do not
// need them; they are for studies and for those who want the paper's own behaviour.

#ifndef CGAL_BOUNDING_ARCS_2_REGION_FALLBACKS_H
#define CGAL_BOUNDING_ARCS_2_REGION_FALLBACKS_H

#include <CGAL/Bounding_arcs_2/region/Bca.h>

namespace CGAL::Bounding_arcs {

/// Near-circular pieces: `Construction` (bilens or spiral fat arc) until the end curvatures differ by less than
/// `tolerance` (an inverse length), then BCA.
template <class Construction> struct Near_circular_to_bca : Construction {
  double tolerance = 1e-9;  ///< the paper leaves it open; ten times larger switches about twice as early in length

  template <class NT> [[nodiscard]] NT thickness(const Chord_shape_2<NT>& f) const {
    return is_near_circular(f) ? Bca::thickness(f) : Construction::thickness(f);
  }
  template <class NT> [[nodiscard]] Region_boundary_2<NT> boundary(const Chord_frame_2<NT>& frame) const {
    return is_near_circular(frame.shape) ? Bca::boundary(frame) : Construction::boundary(frame);
  }

 private:
  template <class NT> [[nodiscard]] bool is_near_circular(const Chord_shape_2<NT>& f) const {
    if (f.infinite0 || f.infinite1) return false;
    const NT n0 = square_root(dot(f.tangent0, f.tangent0)), n1 = square_root(dot(f.tangent1, f.tangent1));
    if (n0 == NT(0) || n1 == NT(0)) return true;
    const NT difference = NT(2) * (f.curvature0 / (n0 * n0 * n0) - f.curvature1 / (n1 * n1 * n1)) / f.unit;
    return absolute(difference) < NT(tolerance);
  }
};

/// Near-linear pieces: BCA until both half-angle tangents fall below `flatness`, then the chord as inner boundary and
/// as outer boundary the arc over the chord whose circle contains the control points of the piece.
struct Near_linear_to_chord : Bca {
  static constexpr bool NEEDS_CONTROL_POINTS = true;
  static constexpr bool BOUNDARY_NEEDS_SQUARE_ROOT = true;
  double flatness = 1e-9;  ///< height over half the chord; the curve is this straight before the switch

  template <class NT> [[nodiscard]] NT thickness(const Chord_shape_2<NT>& f) const {
    if (!is_near_linear(f)) return Bca::thickness(f);
    return NT(f.unit * square_root(dot(f.chord, f.chord)) / NT(2) * control_bulge(f));
  }
  template <class NT> [[nodiscard]] Region_boundary_2<NT> boundary(const Chord_frame_2<NT>& frame) const {
    const Chord_shape_2<NT>& f = frame.shape;
    if (!is_near_linear(f)) return Bca::boundary(frame);
    // the arc of bulge b over the chord: its normal at p0, for a left turn, is perp of the chord turned by -alpha
    const NT b = NT(f.turn < 0 ? -1 : 1) * control_bulge(f), square = NT(1) + b * b;
    const NT cosine = (NT(1) - b * b) / square, sine = NT(2) * b / square;
    const Xy<NT> tangent = cosine * f.chord - sine * perp(f.chord);
    const Contact_circle_2<NT> line{frame.p0, perp(f.chord), NT(0)};
    const Contact_circle_2<NT> circle{frame.p0, f.unit * perp(tangent), NT(NT(2) * sine)};
    return {Boundary_chain_2<NT>({frame.p0, frame.p1, line}), Boundary_chain_2<NT>({frame.p0, frame.p1, circle}),
            Region_form::CHORD_AND_CIRCLE};
  }

 private:
  template <class NT> [[nodiscard]] bool is_near_linear(const Chord_shape_2<NT>& f) const {
    const Chord_angles_2<NT> g = f.angles();
    return absolute(g.bulge0) < NT(flatness) && absolute(g.bulge1) < NT(flatness);
  }
  // tan(alpha/2) of the widest arc over the chord through a control point on the curve's side, from the inscribed
  // angle.
  template <class NT> [[nodiscard]] static NT control_bulge(const Chord_shape_2<NT>& f) {
    NT widest{0};
    for (const Xy<NT>& q : f.control_points) {
      const Xy<NT> to_end = f.chord - q;
      const NT height = NT(f.turn < 0 ? -1 : 1) * cross(q, f.chord);
      if (!(height > NT(0))) continue;
      const NT bulge = height / (square_root(NT(dot(q, q) * dot(to_end, to_end))) + dot(q, to_end));
      widest = larger(widest, bulge);
    }
    return widest;
  }
};

}  // namespace CGAL::Bounding_arcs

#endif
