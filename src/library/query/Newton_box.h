// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// A common point of two curves where Newton's steps lead, proven to be there and to be the only one near.
//
// Let F(t, s) = A(t) - B(s), J its derivative in the point m = (t*, s*) where the steps ended, as computed, c the
// determinant cross(A', B'), and f at least |F(m)|.  Newton's map G(x) = x - J^-1 F(x) has the roots of F as its fixed
// points.  On the box |t - t*| <= k r, |s - s*| <= k q with
//   r = 2 f |B'| / |c|,  q = 2 f |A'| / |c|
// derivatives differ from the computed ones by at most alpha + a k r and beta + b k q, where a and b bound second
// derivatives and alpha and beta the errors of first ones, so that with e(k) = (alpha + a k r) r + (beta + b k q) q
//   |G(x) - G(y)| <= k e(k) / (2 f k) |x - y|   in the norm that has the box for its ball, and
//   |G(m) - m|    <= half the box for k = 1.
// If e(1) <= f / 2, G leads the box for k = 1 into itself and is a contraction there: it holds exactly one root.  As
// long as e(k) <= f, at most one root is in the box for k.

#ifndef BOUNDING_ARCS_LIBRARY_QUERY_NEWTON_BOX_H
#define BOUNDING_ARCS_LIBRARY_QUERY_NEWTON_BOX_H

#include <CGAL/Bounding_arcs_2/arc/Arc_2.h>
#include <CGAL/Bounding_arcs_2/query/Intersections_2.h>
#include <CGAL/Bounding_arcs_2/tree/Bezier_evaluator.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <optional>

namespace CGAL::Bounding_arcs::internal {

/// One root, and a larger box in which there is no other. Ranges may go beyond [0, 1] by their width.
struct Newton_box {
  std::uint32_t bezier_a, bezier_b;
  Bracket a, b;
  Bracket alone_a, alone_b;
  Xy<double> point;

  /// Whether a piece's root, if it has one, is this one or none: it is in the box without another root.
  [[nodiscard]] bool is_unique_on(double t0, double t1, double s0, double s1) const {
    return alone_a.lower <= t0 && t1 <= alone_a.upper && alone_b.lower <= s0 && s1 <= alone_b.upper;
  }
  [[nodiscard]] bool is_on(double t0, double t1, double s0, double s1) const {
    return a.lower <= t1 && t0 <= a.upper && b.lower <= s1 && s0 <= b.upper;
  }
  /// Whether it is for certain between the ends of both curves.
  [[nodiscard]] bool is_inside() const { return a.lower > 0 && a.upper < 1 && b.lower > 0 && b.upper < 1; }
  /// Whether this is the same root for certain.
  [[nodiscard]] bool is_same(const Newton_box& other) const {
    return alone_a.lower <= other.a.lower && other.a.upper <= alone_a.upper && alone_b.lower <= other.b.lower &&
           other.b.upper <= alone_b.upper;
  }
};

/// A piece of a curve that Newton's steps start from.
struct Newton_piece {
  const Bezier_evaluator& curve;
  double rounding;  ///< how far exact control points are from those of the evaluator
  std::uint32_t bezier;
  double t0, t1;
  Xy<double> from, to;
};

/// \return nothing where there is no proof
[[nodiscard]] inline std::optional<Newton_box> newton_box(const Newton_piece& a, const Newton_piece& b) {
  const Bezier_evaluator &curve_a = a.curve, &curve_b = b.curve;
  const double error = curve_a.point_error() + curve_b.point_error() + a.rounding + b.rounding;
  // where the chords meet
  const Xy<double> chord_a = a.to - a.from, chord_b = b.to - b.from, way = b.from - a.from;
  const double sine = cross(chord_a, chord_b);
  if (sine == 0) return std::nullopt;
  const double span_a = a.t1 - a.t0, span_b = b.t1 - b.t0;
  const double low_a = (std::max)(0.0, a.t0 - span_a / 2), high_a = (std::min)(1.0, a.t1 + span_a / 2),
               low_b = (std::max)(0.0, b.t0 - span_b / 2), high_b = (std::min)(1.0, b.t1 + span_b / 2);
  double t = std::clamp(a.t0 + cross(way, chord_b) / sine * span_a, low_a, high_a),
         s = std::clamp(b.t0 + cross(way, chord_a) / sine * span_b, low_b, high_b);
  constexpr int MOST_STEPS = 8;
  Curve_jet p, q;
  Xy<double> f;
  double c = 0;
  for (int step = 0;; ++step) {
    p = curve_a(t);
    q = curve_b(s);
    f = p.point - q.point;
    c = cross(p.first, q.first);
    if (c == 0) return std::nullopt;
    const double dt = -cross(f, q.first) / c, ds = cross(p.first, f) / c;
    const double next_t = std::clamp(t + dt, low_a, high_a), next_s = std::clamp(s + ds, low_b, high_b);
    const bool is_small = std::fabs(f.x) + std::fabs(f.y) <= error;
    if (is_small || step == MOST_STEPS || (next_t == t && next_s == s)) break;
    t = next_t;
    s = next_s;
  }
  constexpr double UP = 1 + 0x1p-40;  // for the roundings of what follows
  constexpr double CONVERGED = 8;     // times the errors: else the steps ended at a limit, and halves are soon apart
  if (!(std::fabs(f.x) + std::fabs(f.y) <= CONVERGED * error)) return std::nullopt;
  const double speed_a = euclidean_norm(p.first), speed_b = euclidean_norm(q.first), size = std::fabs(c);
  const double least = euclidean_norm(f) * UP + error;
  const double r = 2 * least * speed_b / size * UP, w = 2 * least * speed_a / size * UP;
  const double turned_a = curve_a.first_change(a.rounding), turned_b = curve_b.first_change(b.rounding);
  // c is of rounded products of the derivatives
  const double alpha = curve_a.first_error() + turned_a + 8 * HALF_ULP * speed_a * (speed_a * speed_b / size),
               beta = curve_b.first_error() + turned_b + 8 * HALF_ULP * speed_b * (speed_a * speed_b / size);
  const double second_a = (curve_a.second_bound() + curve_a.second_change(a.rounding)) * UP,
               second_b = (curve_b.second_bound() + curve_b.second_change(b.rounding)) * UP;
  const double fixed = (alpha * r + beta * w) * UP, growing = (second_a * r * r + second_b * w * w) * UP;
  if (!(fixed + growing <= least / 2)) return std::nullopt;
  const double k = growing > 0 ? (least - fixed) / growing * (1 - 0x1p-40) : 0x1p100;
  const auto around = [](double x, double half) {
    const double wide = half * UP + 4 * HALF_ULP * (std::fabs(x) + half);
    return Bracket{x - wide, x + wide};
  };
  const auto inside = [](double x, double half) {
    const double narrow = half - 4 * HALF_ULP * (std::fabs(x) + half);
    return Bracket{x - narrow, x + narrow};
  };
  return Newton_box{a.bezier, b.bezier, around(t, r), around(s, w), inside(t, k * r), inside(s, k * w), p.point};
}

}  // namespace CGAL::Bounding_arcs::internal

#endif
