// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// A box along the chord of a piece, the coordinates that oriented boxes and hulls of control points have in common.

#ifndef CGAL_BOUNDING_ARCS_2_STUDY_INTERNAL_CHORD_BOX_H
#define CGAL_BOUNDING_ARCS_2_STUDY_INTERNAL_CHORD_BOX_H

#include <CGAL/Bounding_arcs_2/frame/Chord_frame_2.h>
#include <CGAL/Bounding_arcs_2/region/Bca.h>
#include <CGAL/Bounding_arcs_2/region/Region_outline_2.h>
#include <CGAL/Bounding_arcs_2/study/internal/Control_polynomials.h>

#include <vector>

namespace CGAL::Bounding_arcs::study {

/// Along the chord and across it to the left, both times |chord|, so that nothing is divided by.
template <class NT> struct Chord_box {
  Around_zero<NT> before, beyond;  ///< of the control points along the chord, from its start and from its end
  Around_zero<NT> across;

  /// The height of the box and, where control points are before or behind the chord, by how much they are: no point of
  /// one side is farther from the other. In units of the plane.
  [[nodiscard]] NT thickness(const Chord_shape_2<NT>& f) const {
    const NT length = square_root(dot(f.chord, f.chord));
    if (length == NT(0)) return NT(0);  // a point
    return NT(f.unit * NT((across.high - across.low + larger(NT(-before.low), beyond.high)) / length));
  }
  /// The side at a height runs round what is before and behind the chord, but for a height of 0.
  [[nodiscard]] std::vector<Boundary_piece_2<NT>> side(const Chord_frame_2<NT>& frame, const NT& height) const {
    if (height == NT(0)) return {segment_between(frame.p0, frame.p1)};
    const Xy<NT>& chord = frame.shape.chord;
    const NT scale = NT(frame.shape.unit / dot(chord, chord));
    const auto from = [&](const Xy<NT>& end, const NT& along, const NT& left) {
      return end + NT(scale * along) * chord + NT(scale * left) * perp(chord);
    };
    return chain_through<NT>({frame.p0, from(frame.p0, before.low, NT(0)), from(frame.p0, before.low, height),
                              from(frame.p1, beyond.high, height), from(frame.p1, beyond.high, NT(0)), frame.p1});
  }
  [[nodiscard]] Region_outline_2<NT> outline(const Chord_frame_2<NT>& frame) const {
    return outline_between(side(frame, across.high), side(frame, across.low), Outline_form::POLYGON, frame.shape.turn);
  }
};

/// Makes the box with the room along the chord that the control points take, and none across.
template <class NT> [[nodiscard]] Chord_box<NT> chord_slab(const Chord_shape_2<NT>& f) {
  Chord_box<NT> box;
  for (std::size_t i = 1; i + 1 < f.control_points.size(); ++i) {
    box.before.add(dot(f.chord, f.control_points[i]));
    box.beyond.add(dot(f.chord, f.control_points[i] - f.chord));
  }
  return box;
}

}  // namespace CGAL::Bounding_arcs::study

#endif
