// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Regions with straight sides, to compare arcs with: boxes along the axes, boxes along the chord, convex hulls of
// control points.

#ifndef CGAL_BOUNDING_ARCS_2_STUDY_BOXES_AND_HULLS_H
#define CGAL_BOUNDING_ARCS_2_STUDY_BOXES_AND_HULLS_H

#include <CGAL/Bounding_arcs_2/frame/Chord_frame_2.h>
#include <CGAL/Bounding_arcs_2/number/number_types.h>
#include <CGAL/Bounding_arcs_2/region/Bca.h>
#include <CGAL/Bounding_arcs_2/region/Region_outline_2.h>
#include <CGAL/Bounding_arcs_2/study/internal/Control_polynomials.h>

#include <algorithm>
#include <cstddef>
#include <vector>

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
