// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Axis-aligned boxes, a yardstick: a spiral segment is monotone in x and y, so that its box is that of its ends.

#ifndef CGAL_BOUNDING_ARCS_2_STUDY_AXIS_BOX_H
#define CGAL_BOUNDING_ARCS_2_STUDY_AXIS_BOX_H

#include <CGAL/Bounding_arcs_2/frame/Chord_frame_2.h>
#include <CGAL/Bounding_arcs_2/number/number_types.h>
#include <CGAL/Bounding_arcs_2/region/Region_outline_2.h>
#include <CGAL/Bounding_arcs_2/study/internal/Control_polynomials.h>

namespace CGAL::Bounding_arcs {

/// The axis-aligned box of a piece that is monotone in x and y, as a function of the chord frame.
/// \cgalModels{Construction}
struct Axis_box {
  static constexpr const char* NAME = "box";
  static constexpr int ARCS_PER_REGION = 0;  ///< but four segments
  static constexpr bool NEEDS_CURVATURE = false;
  static constexpr bool NEEDS_CONTROL_POINTS = false;
  static constexpr bool BOUNDARY_NEEDS_SQUARE_ROOT = false;

  /// The smaller side: a corner off the chord is that far from the two sides at the other one.
  /// Order 1 in the length L of the piece, c L with c the smaller of |cos| and |sin| of the chord's direction; order 2
  /// where the tangent at an end is parallel to an axis, curvature L^2 / 2.
  /// \guarantee exact over a field; over double one rounding
  template <class NT> [[nodiscard]] static NT thickness(const Chord_shape_2<NT>& f) {
    return NT(f.unit * study::smaller(absolute(f.chord.x), absolute(f.chord.y)));
  }
  template <class NT> [[nodiscard]] static Region_outline_2<NT> boundary(const Chord_frame_2<NT>& frame) {
    const Xy<NT>&p0 = frame.p0, &p1 = frame.p1;
    const Xy<NT> below{p1.x, p0.y}, above{p0.x, p1.y};  // of a chord that runs up to the right
    const bool is_left = sign_of(frame.shape.chord.x) * sign_of(frame.shape.chord.y) < 0;
    const auto left = chain_through<NT>({p0, is_left ? below : above, p1}),
               right = chain_through<NT>({p0, is_left ? above : below, p1});
    return outline_between(left, right, Outline_form::POLYGON, frame.shape.turn);
  }
};

}  // namespace CGAL::Bounding_arcs

#endif
