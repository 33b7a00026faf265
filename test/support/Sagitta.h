// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// A method of one's own, all of it: between the chord and the arc over it that touches the curve at its tight end.

#ifndef BOUNDING_ARCS_TEST_SAGITTA_H
#define BOUNDING_ARCS_TEST_SAGITTA_H

#include <CGAL/Bounding_arcs_2/frame/Chord_frame_2.h>
#include <CGAL/Bounding_arcs_2/region/Bca.h>

namespace bounding_arcs_test {

struct Sagitta {
  static constexpr const char* NAME = "sagitta";
  static constexpr int ARCS_PER_REGION = 1;
  static constexpr bool NEEDS_CURVATURE = false;
  static constexpr bool NEEDS_CONTROL_POINTS = false;
  static constexpr bool BOUNDARY_NEEDS_SQUARE_ROOT = false;

  /// The height of the arc: half the chord times the larger tan(alpha/2).
  template <class NT> [[nodiscard]] static NT thickness(const CGAL::Bounding_arcs::Chord_shape_2<NT>& f) {
    const auto angles = f.angles();
    const NT bulge = f.tight_first ? angles.bulge0 : angles.bulge1;
    using CGAL::abs;
    return NT(f.unit * angles.chord * abs(bulge) / NT(2));
  }
  template <class NT>
  [[nodiscard]] static CGAL::Bounding_arcs::Region_boundary_2<NT> boundary(
      const CGAL::Bounding_arcs::Chord_frame_2<NT>& frame) {
    auto region = CGAL::Bounding_arcs::Bca::boundary(frame);
    const auto& f = frame.shape;
    region.inner = CGAL::Bounding_arcs::Boundary_chain_2<NT>({frame.p0, frame.p1, {frame.p0, perp(f.chord), NT(0)}});
    return region;
  }
};

}  // namespace bounding_arcs_test

#endif
