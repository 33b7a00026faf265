// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Convex hulls of control points, a yardstick: what Bezier curves have always been bounded by.

#ifndef CGAL_BOUNDING_ARCS_2_STUDY_CONTROL_HULL_H
#define CGAL_BOUNDING_ARCS_2_STUDY_CONTROL_HULL_H

#include <CGAL/Bounding_arcs_2/study/internal/Chord_box.h>

#include <algorithm>
#include <cstddef>
#include <vector>

namespace CGAL::Bounding_arcs {

/// The convex hull of the control points of a piece; where these are on both sides of the chord, or before or behind
/// it, the box along the chord that holds them.
/// \cgalModels{Construction}
struct Control_hull {
  static constexpr const char* NAME = "hull";
  static constexpr int ARCS_PER_REGION = 0;  ///< but at most as many segments as control points
  static constexpr bool NEEDS_CURVATURE = false;
  static constexpr bool NEEDS_CONTROL_POINTS = true;
  static constexpr bool NEEDS_CERTAIN_TURN = true;  ///< as lines and arcs step back
  static constexpr bool BOUNDARY_NEEDS_SQUARE_ROOT = false;

  /// Order 2 in the length L of the piece: curvature L^2 / 6 for a cubic, the height of its control points.
  template <class NT> [[nodiscard]] static NT thickness(const Chord_shape_2<NT>& f) {
    return f.turn == 0 ? Bca::thickness(f) : box(f).thickness(f);
  }
  template <class NT> [[nodiscard]] static Region_outline_2<NT> boundary(const Chord_frame_2<NT>& frame) {
    const Chord_shape_2<NT>& f = frame.shape;
    if (f.turn == 0) return outline_of(Bca::boundary(frame), 0);
    const study::Chord_box<NT> b = box(f);
    const NT zero(0);
    const bool has_overhang = b.before.low != zero || b.beyond.high != zero;
    if (has_overhang || (b.across.low != zero && b.across.high != zero)) return b.outline(frame);
    const auto chord = chain_through<NT>({frame.p0, frame.p1}), points = hull_side(frame, b.across.high != zero);
    const bool is_left = b.across.high != zero;
    return outline_between(is_left ? points : chord, is_left ? chord : points, Outline_form::POLYGON, f.turn);
  }

 private:
  template <class NT> [[nodiscard]] static study::Chord_box<NT> box(const Chord_shape_2<NT>& f) {
    study::Chord_box<NT> box = study::chord_slab(f);
    for (std::size_t i = 1; i + 1 < f.control_points.size(); ++i) box.across.add(cross(f.chord, f.control_points[i]));
    return box;
  }
  // The hull's chain off the chord, all control points on that side of it and none before or behind: in their order
  // along the chord, without those that another two pass outside of (Andrew 1979).
  template <class NT>
  [[nodiscard]] static std::vector<Boundary_piece_2<NT>> hull_side(const Chord_frame_2<NT>& frame, bool is_left) {
    const Chord_shape_2<NT>& f = frame.shape;
    std::vector<Xy<NT>> points = f.control_points;
    std::stable_sort(points.begin() + 1, points.end() - 1,
                     [&](const Xy<NT>& p, const Xy<NT>& q) { return dot(f.chord, p) < dot(f.chord, q); });
    points.back() = f.chord;
    const NT side(is_left ? 1 : -1);
    std::vector<Xy<NT>> hull;
    for (const Xy<NT>& q : points) {
      const auto passes_inside = [&] {
        const Xy<NT>&a = hull[hull.size() - 2], &b = hull.back();
        return !(NT(side * cross(b - a, q - b)) < NT(0));
      };
      while (hull.size() > 1 && passes_inside()) hull.pop_back();
      hull.push_back(q);
    }
    for (Xy<NT>& q : hull) q = frame.p0 + f.unit * q;
    hull.back() = frame.p1;
    return chain_through(hull);
  }
};

}  // namespace CGAL::Bounding_arcs

#endif
