// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Fat arcs (Sederberg, White, Zundel 1989): the strip between two offsets of an arc through the ends and the middle of
// a piece.  Here the ends' sides are along the normals of the arc.

#ifndef CGAL_BOUNDING_ARCS_2_STUDY_THREE_POINT_FAT_ARC_H
#define CGAL_BOUNDING_ARCS_2_STUDY_THREE_POINT_FAT_ARC_H

#include <CGAL/Bounding_arcs_2/region/Bca.h>
#include <CGAL/Bounding_arcs_2/region/Region_outline_2.h>
#include <CGAL/Bounding_arcs_2/study/internal/Control_polynomials.h>

#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL::Bounding_arcs {

/// The fat arc of a piece of a Bezier curve through C(0), C(1/2), C(1) of the piece; lines, arcs, and pieces whose
/// strip would reach the arc's center step back to BCA.
///
/// With n the circle's normal in C(0), k / |n| its curvature and q the curve minus C(0) the numerator of
/// k |q|^2 - 2 n . q is t (1 - t) (1 - 2 t) g(t), and that product is never more than sqrt(3)/18: the largest Bernstein
/// coefficient of g bounds the distance from the circle.
/// \source Sederberg, White, Zundel 1989: the arc; the bound by what is left of the three roots is this library's
/// \cgalModels{Construction}
struct Three_point_fat_arc {
  static constexpr const char* NAME = "fat-arc";
  static constexpr int ARCS_PER_REGION = 2;  ///< and two segments
  static constexpr bool NEEDS_CURVATURE = false;
  static constexpr bool NEEDS_CONTROL_POINTS = true;
  static constexpr bool NEEDS_CERTAIN_TURN = true;  ///< as lines and arcs step back
  static constexpr bool BOUNDARY_NEEDS_SQUARE_ROOT = true;

  /// Order 3 in the length L of the piece: sqrt(3)/108 of the slope of curvature times L^3; order 4 at a vertex.
  template <class NT> [[nodiscard]] static NT thickness(const Chord_shape_2<NT>& f) {
    const Strip<NT> s = strip(f);
    return s.is_usable ? NT(f.unit * (s.right + s.left)) : Bca::thickness(f);
  }
  template <class NT> [[nodiscard]] static Region_outline_2<NT> boundary(const Chord_frame_2<NT>& frame) {
    const Chord_shape_2<NT>& f = frame.shape;
    const Strip<NT> s = strip(f);
    if (!s.is_usable) return outline_of(Bca::boundary(frame), f.turn);
    const Xy<NT> normal1 = s.normal - s.curvature * f.chord;  // where the curve ends
    const auto side = [&](const NT& offset) {                 // to the right
      const NT step = NT(f.unit * offset / s.length);
      const Xy<NT> a = frame.p0 - step * s.normal, b = frame.p1 - step * normal1;
      const NT curvature = s.curvature * s.length / ((s.length + s.curvature * offset) * f.unit);
      return std::vector<Boundary_piece_2<NT>>{
          segment_between(frame.p0, a), {a, b, {a, s.normal, curvature}}, segment_between(b, frame.p1)};
    };
    return outline_between(side(NT(-s.left)), side(s.right), Outline_form::STRIP, f.turn);
  }

 private:
  // The arc's circle through the curve's start, and how far the strip reaches to either side of it.
  template <class NT> struct Strip {
    bool is_usable = false;
    Xy<NT> normal;
    NT length{0}, curvature{0};  // |normal|, curvature times that
    NT left{0}, right{0};
  };

  template <class NT> [[nodiscard]] static Strip<NT> strip(const Chord_shape_2<NT>& f) {
    Strip<NT> s;
    if (f.turn == 0 || f.sine_change == NT(0) || f.control_points.size() < 3) return s;  // a line or an arc
    const auto curve = study::control_polynomials(f);
    const Xy<NT> middle = curve.halves().first.end(), &d = f.chord;
    s.normal = dot(d, d) * perp(middle) - dot(middle, middle) * perp(d);
    s.curvature = NT(2) * cross(middle, d);
    s.length = square_root(dot(s.normal, s.normal));
    const NT weight = study::least_weight(curve.weight);
    constexpr double MOST = 0.09622504487;  // sqrt(3)/18 and 5e-11 of it, room for proofs where g is constant
    const auto quotient = without_roots(curve.beyond(s.normal, s.curvature).scaled_coefficients());
    const NT reach = NT(MOST) * study::range_of(quotient).reach() / (weight * weight);
    const NT room = s.length * s.length - absolute(NT(s.curvature * reach));
    if (!(room > NT(0))) return s;
    s.right = study::distance_beyond(reach, s.length, s.curvature);
    s.left = study::distance_beyond(reach, s.length, NT(-s.curvature));
    s.is_usable = true;
    return s;
  }
  // Scaled coefficients divided by t (1 - t) (1 - 2 t): the first and the last, which are 0, dropped, and in the
  // homogeneous parameters u - v divided out, from either end to the middle.
  template <class NT> [[nodiscard]] static std::vector<NT> without_roots(const std::vector<NT>& c) {
    const std::size_t size = c.size() - 3;
    std::vector<NT> q(size, NT(0));
    for (std::size_t i = 0; 2 * i < size; ++i) q[i] = i == 0 ? c[1] : NT(c[i + 1] + q[i - 1]);
    for (std::size_t i = size; 2 * --i >= size;) q[i] = i + 1 == size ? NT(-c[i + 2]) : NT(q[i + 1] - c[i + 2]);
    return q;
  }
};

}  // namespace CGAL::Bounding_arcs

#endif
