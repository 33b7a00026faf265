// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Boxes along the chord, a yardstick: as wide as the fat line of Sederberg and Nishita (1990).

#ifndef CGAL_BOUNDING_ARCS_2_STUDY_ORIENTED_BOX_H
#define CGAL_BOUNDING_ARCS_2_STUDY_ORIENTED_BOX_H

#include <CGAL/Bounding_arcs_2/study/internal/Chord_box.h>

namespace CGAL::Bounding_arcs {

/// The box along the chord of a piece of a Bezier curve.  The distance from the chord is t (1 - t) g(t), and no more
/// than the largest coefficient of g over 4: of a cubic 3/4 of the larger distance of a control point.
/// \source Sederberg, Nishita 1990, section 3, for all degrees and for weights
/// \cgalModels{Construction}
struct Oriented_box {
  static constexpr const char* NAME = "oriented-box";
  static constexpr int ARCS_PER_REGION = 0;  ///< but four segments
  static constexpr bool NEEDS_CURVATURE = false;
  static constexpr bool NEEDS_CONTROL_POINTS = true;
  static constexpr bool NEEDS_CERTAIN_TURN = true;  ///< as lines and arcs step back
  static constexpr bool BOUNDARY_NEEDS_SQUARE_ROOT = false;

  /// Order 2 in the length L of the piece: curvature L^2 / 8, the curve's own height.
  template <class NT> [[nodiscard]] static NT thickness(const Chord_shape_2<NT>& f) {
    return f.turn == 0 ? Bca::thickness(f) : box(f).thickness(f);
  }
  template <class NT> [[nodiscard]] static Region_outline_2<NT> boundary(const Chord_frame_2<NT>& frame) {
    if (frame.shape.turn == 0) return outline_of(Bca::boundary(frame), 0);
    return box(frame.shape).outline(frame);
  }

 private:
  template <class NT> [[nodiscard]] static study::Chord_box<NT> box(const Chord_shape_2<NT>& f) {
    study::Chord_box<NT> box = study::chord_slab(f);
    const auto curve = study::control_polynomials(f);
    const auto height = curve.along(perp(f.chord)).scaled_coefficients();  // 0 at both ends
    const auto range = study::range_of<NT>({height.begin() + 1, height.end() - 1});
    const NT scale = NT(NT(4) * study::least_weight(curve.weight));
    box.across.low = NT(range.low / scale);
    box.across.high = NT(range.high / scale);
    return box;
  }
};

}  // namespace CGAL::Bounding_arcs

#endif
