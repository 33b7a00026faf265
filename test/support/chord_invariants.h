// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// What a chord shape says whatever the lengths of its tangents and its unit, and end jets of Bezier curves by the
// textbook formulas.

#ifndef BOUNDING_ARCS_TEST_CHORD_INVARIANTS_H
#define BOUNDING_ARCS_TEST_CHORD_INVARIANTS_H

#include <CGAL/Bounding_arcs_2/curve/Bezier_curve_2.h>
#include <CGAL/Bounding_arcs_2/frame/Chord_frame_2.h>
#include <CGAL/Bounding_arcs_2/number/Root_number.h>

#include <CGAL/CORE_Expr.h>
#include <CGAL/Exact_rational.h>

#include <array>
#include <vector>

namespace bounding_arcs_test {

/// The numbers of a shape, each beside its error.
template <class NT> std::array<NT, 15> members(const CGAL::Bounding_arcs::Chord_shape_2<NT>& f) {
  return {f.chord.x,      f.chord.y,          f.tangent0.x,       f.tangent0.y, f.tangent1.x,
          f.tangent1.y,   f.tangent_change.x, f.tangent_change.y, f.cross0,     f.cross1,
          f.cross_change, f.curvature0,       f.curvature1,       f.kneser0,    f.kneser1};
}

enum Invariant { SINE0, SINE1, CURVATURE0, CURVATURE1, KNESER0, KNESER1, SQUARED_CHORD };
using Invariants = std::array<CGAL::Exact_rational, 7>;

/// sin alpha_i, K_i and their differences, each as the signed square, and the squared chord length.
inline Invariants invariants(const CGAL::Bounding_arcs::Chord_shape_2<CGAL::Exact_rational>& f) {
  using Exact = CGAL::Exact_rational;
  const auto signed_square = [](const Exact& x) { return x < 0 ? Exact(-x * x) : Exact(x * x); };
  const Exact n0 = dot(f.tangent0, f.tangent0), n1 = dot(f.tangent1, f.tangent1), c = dot(f.chord, f.chord);
  return {Exact(signed_square(f.cross0) / (n0 * c)),
          Exact(signed_square(f.cross1) / (n1 * c)),
          Exact(signed_square(f.curvature0) * c / (n0 * n0 * n0)),
          Exact(signed_square(f.curvature1) * c / (n1 * n1 * n1)),
          Exact(signed_square(f.kneser0) / (n0 * n0 * n0 * c)),
          Exact(signed_square(f.kneser1) / (n1 * n1 * n1 * c)),
          Exact(f.unit * f.unit * c)};
}

/// Point and derivatives of a curve at t = 0 (in its own parameter) or at t = 1, from the control points.
template <class NT>
CGAL::Bounding_arcs::End_jet_2<NT> end_jet(const CGAL::Bounding_arcs::Bezier_curve_2<NT>& curve, bool at_start) {
  using CGAL::Bounding_arcs::Xy;
  if (!at_start) {
    auto jet = end_jet(curve.reversed(), true);
    jet.first = -jet.first;
    return jet;
  }
  const auto& p = curve.control_points();
  const NT n(curve.degree()), w0 = curve.weight(0), w1 = curve.weight(1);
  const Xy<NT> q1 = w1 * (p[1] - p[0]), first = NT(n / w0) * q1;
  Xy<NT> numerator = NT(-2) * q1;  // over n (n-1): the second derivative of w (C - C(0))
  if (p.size() > 2) numerator = numerator + curve.weight(2) * (p[2] - p[0]);
  const Xy<NT> second = NT(1 / w0) * (NT(n * (n - 1)) * numerator - NT(2 * n * (w1 - w0)) * first);
  return {p[0], first, second};
}

inline CGAL::Bounding_arcs::Chord_frame_2<CORE::Expr> convert_frame(
    const CGAL::Bounding_arcs::Chord_frame_2<CGAL::Exact_rational>& frame) {
  using CGAL::Bounding_arcs::convert;
  return {convert<CORE::Expr>(frame.p0), convert<CORE::Expr>(frame.p1), frame.shape.over<CORE::Expr>()};
}

}  // namespace bounding_arcs_test

#endif
