// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Strips between two offsets, to compare arcs with: of an arc through the ends and the middle of a piece (Sederberg,
// White, Zundel 1989), whose ends' sides are along its normals here; and of a biarc, two arcs that touch each other
// and, at its ends, the curve (Bolton 1975, with tangents of one length d at both ends).
//
//             j              q0 = d T0, q1 = D - d T1, the joint j = (q0 + q1)/2, and |q1 - q0| = 2 d gives
//      q0 ____.____ q1       d^2 |T1 - T0|^2 + 2 d D.(T0 + T1) - |D|^2 = 0
//        /         \         with unit tangents T0, T1 and the chord D.
//      p0           p1

#ifndef CGAL_BOUNDING_ARCS_2_STUDY_FAT_ARCS_H
#define CGAL_BOUNDING_ARCS_2_STUDY_FAT_ARCS_H

#include <CGAL/Bounding_arcs_2/region/Bca.h>
#include <CGAL/Bounding_arcs_2/region/Region_outline_2.h>
#include <CGAL/Bounding_arcs_2/study/internal/Control_polynomials.h>

#include <algorithm>
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

/// The fat biarc of a piece of a Bezier curve; lines, arcs, and pieces whose strip would reach a center step back to
/// BCA.
///
/// The halves [0, 1/2] and [1/2, 1] are measured against one arc each.  Seen from the end that the arc touches, with
/// t = 0 there, the numerator of curvature |q|^2 - 2 normal . q is t^2 (1 - t) h(t) + r t^(2n), r what it is in C(1/2),
/// and t^2 (1 - t) is never more than 4/27.  What a half has past the joint's normal is nearer to the other arc's
/// circle than to its own by no more than the difference of curvatures times the square of the distance from the joint.
/// \cgalModels{Construction}
struct Fat_biarc {
  static constexpr const char* NAME = "fat-biarc";
  static constexpr int ARCS_PER_REGION = 4;  ///< and two segments
  static constexpr bool NEEDS_CURVATURE = false;
  static constexpr bool NEEDS_CONTROL_POINTS = true;
  static constexpr bool NEEDS_CERTAIN_TURN = true;  ///< as lines and arcs step back
  static constexpr bool BOUNDARY_NEEDS_SQUARE_ROOT = true;

  /// Order 3 in the length L of the piece: 1/162 of the slope of curvature times L^3; order 4 at a vertex.
  template <class NT> [[nodiscard]] static NT thickness(const Chord_shape_2<NT>& f) {
    const Strip<NT> s = strip(f);
    return s.is_usable ? NT(f.unit * (s.right + s.left)) : Bca::thickness(f);
  }
  template <class NT> [[nodiscard]] static Region_outline_2<NT> boundary(const Chord_frame_2<NT>& frame) {
    const Chord_shape_2<NT>& f = frame.shape;
    const Strip<NT> s = strip(f);
    if (!s.is_usable) return outline_of(Bca::boundary(frame), f.turn);
    const auto side = [&](const NT& offset) {  // to the right
      const Xy<NT> a = frame.p0 - NT(f.unit * offset) * s.normal0, b = frame.p1 - NT(f.unit * offset) * s.normal1,
                   joint = frame.p0 + f.unit * (s.joint - offset * s.normal_joint);
      const auto curvature = [&](const NT& k) { return NT(k / ((NT(1) + k * offset) * f.unit)); };
      return std::vector<Boundary_piece_2<NT>>{segment_between(frame.p0, a),
                                               {a, joint, {a, s.normal0, curvature(s.curvature0)}},
                                               {joint, b, {b, s.normal1, curvature(s.curvature1)}},
                                               segment_between(b, frame.p1)};
    };
    return outline_between(side(NT(-s.left)), side(s.right), Outline_form::STRIP, f.turn);
  }

 private:
  // The biarc, with left normals of length 1, and how far the strip reaches to either side of it.
  template <class NT> struct Strip {
    bool is_usable = false;
    Xy<NT> normal0, normal1, joint, normal_joint;
    NT curvature0{0}, curvature1{0};
    NT left{0}, right{0};

    // The reach beyond one arc of points with these values of `beyond`; false where an offset would be past the center.
    [[nodiscard]] bool add(const study::Around_zero<NT>& beyond, const NT& curvature) {
      const NT one(1), zero(0);
      if (!(one + curvature * beyond.low > zero) || !(one + curvature * beyond.high > zero)) return false;
      right = larger(right, study::distance_beyond(beyond.high, one, curvature));
      left = larger(left, study::distance_beyond(NT(-beyond.low), one, NT(-curvature)));
      return true;
    }
    [[nodiscard]] bool has_room(const NT& curvature) const {
      return NT(1) - curvature * left > NT(0) && NT(1) + curvature * right > NT(0);
    }
  };

  template <class NT> [[nodiscard]] static Strip<NT> strip(const Chord_shape_2<NT>& f) {
    Strip<NT> s;
    if (f.turn == 0 || f.sine_change == NT(0) || !f.runs_ahead || f.control_points.size() < 3) return s;
    const NT one(1), two(2);
    const Xy<NT> t0 = NT(one / square_root(dot(f.tangent0, f.tangent0))) * f.tangent0,
                 t1 = NT(one / square_root(dot(f.tangent1, f.tangent1))) * f.tangent1, turn = t1 - t0;
    const NT ahead = dot(f.chord, t0 + t1), square = dot(f.chord, f.chord);
    const NT d = square / (ahead + square_root(NT(ahead * ahead + dot(turn, turn) * square)));
    s.normal0 = perp(t0);
    s.normal1 = perp(t1);
    s.joint = NT(one / two) * (f.chord - d * turn);
    s.normal_joint = NT(one / (two * d)) * perp(f.chord - d * (t0 + t1));
    const Xy<NT> back = s.joint - f.chord;
    s.curvature0 = two * dot(s.normal0, s.joint) / dot(s.joint, s.joint);
    s.curvature1 = two * dot(s.normal1, back) / dot(back, back);

    const auto halves = study::control_polynomials(f).halves();
    const auto &first = halves.first, second = halves.second.about(f.chord);
    const auto beyond_first = first.beyond(s.normal0, s.curvature0).scaled_coefficients();
    auto beyond_second = second.beyond(s.normal1, s.curvature1).scaled_coefficients();
    std::reverse(beyond_second.begin(), beyond_second.end());
    const auto range0 = range_of_half(beyond_first, first.weight), range1 = range_of_half(beyond_second, second.weight);
    const NT past = larger(square_past(first.about(s.joint), s, 1, range0.reach(), s.curvature0),
                           square_past(halves.second.about(s.joint), s, -1, range1.reach(), s.curvature1));
    const NT change = absolute(NT(s.curvature0 - s.curvature1)) * past;
    const study::Around_zero<NT> range{NT(study::smaller(range0.low, range1.low) - change),
                                       NT(larger(range0.high, range1.high) + change)};
    s.is_usable = s.add(range, s.curvature0) && s.add(range, s.curvature1) && s.has_room(s.curvature0) &&
                  s.has_room(s.curvature1);
    return s;
  }
  // The range of the values of `beyond` on a half whose arc touches at its start. Scaled coefficients give the values,
  // and the first two of them are 0.
  template <class NT>
  [[nodiscard]] static study::Around_zero<NT> range_of_half(const std::vector<NT>& c,
                                                            const Bernstein_polynomial<NT>& weight) {
    constexpr double MOST = 0.14814814816;  // 4/27 and 8e-11 of it, room for proofs where h is constant
    const NT least = study::least_weight(weight), square = least * least, most(MOST);
    auto range = study::range_of<NT>({c.begin() + 2, c.end() - 1});
    study::Around_zero<NT> rest;
    rest.add(c.back());
    range.low = NT((most * range.low + rest.low) / square);
    range.high = NT((most * range.high + rest.high) / square);
    return range;
  }
  // An upper bound of the square of the distance from the joint of points of a half past the joint's normal: v = (x, y)
  // along it and across with |2 y| <= |beyond| + |curvature| |v|^2.
  template <class NT>
  [[nodiscard]] static NT square_past(const study::Control_polynomials<NT>& half, const Strip<NT>& s, int ahead,
                                      const NT& beyond, const NT& curvature) {
    const Xy<NT> along = NT(-ahead) * perp(s.normal_joint);
    const NT least = study::least_weight(half.weight),
             x = NT(study::range_of(half.along(along).scaled_coefficients()).high / least),
             most_y = NT(study::range_of(half.along(s.normal_joint).scaled_coefficients()).reach() / least);
    const NT y = NT((beyond + absolute(curvature) * (x * x + most_y * most_y)) / NT(2));
    return NT(x * x + y * y);
  }
};

}  // namespace CGAL::Bounding_arcs

#endif
