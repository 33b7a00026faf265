// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The four polynomials whose roots cut a Bezier curve into spiral segments, in the Bernstein basis from differences of
// control points. With Q = |C'|^2, C' the derivative or H = F' w - F w' for a homogeneous curve (F, w):  C'.x, C'.y,
//   I = det(C', C'') or D = det(F, F', F''),   2 Q I' - 3 Q' I  or  2 Q (w D' + 3 w' D) - 3 Q' w D,
// all up to constant factors.

#ifndef CGAL_BOUNDING_ARCS_2_SPIRAL_INTERNAL_CURVE_NUMERATORS_H
#define CGAL_BOUNDING_ARCS_2_SPIRAL_INTERNAL_CURVE_NUMERATORS_H

#include <CGAL/Bounding_arcs_2/polynomial/Bernstein_polynomial.h>

#include <cstddef>
#include <vector>

namespace CGAL::Bounding_arcs::internal {

// The numbers the four polynomials are made of: for a polynomial curve the differences of neighbouring control
// points, for a rational one the weights and the control points seen from the first.
template <class NT> struct Curve_numbers { std::vector<NT> x, y, w; };

enum Numerator { SPEED_X, SPEED_Y, INFLECTION, CURVATURE_CHANGE, NUMERATOR_COUNT };

// One of the four polynomials, up to a positive constant.
template <class NT> class Numerator_builder {
  using Polynomial = Bernstein_polynomial<NT>;

 public:
  explicit Numerator_builder(const Curve_numbers<NT>& c) : c_(c) {
    for (std::size_t i = 0; i < c.w.size(); ++i) {
      wx_.push_back(NT(c.w[i] * c.x[i]));
      wy_.push_back(NT(c.w[i] * c.y[i]));
    }
  }

  [[nodiscard]] Polynomial operator()(Numerator which) const {
    if (which == SPEED_X) return speed(c_.x, wx_);
    if (which == SPEED_Y) return speed(c_.y, wy_);
    if (which == INFLECTION) return inflection();
    return curvature_change();
  }

 private:
  using Numbers = std::vector<NT>;

  // The polynomial of the coefficients but the first `skip` and the last `leave`, of a form that many degrees lower.
  static Polynomial slice(const Numbers& b, int skip, int leave) {
    return Polynomial(Numbers(b.begin() + skip, b.end() - leave));
  }

  [[nodiscard]] Polynomial speed(const Numbers& b, const Numbers& wb) const {
    if (c_.w.empty()) return Polynomial(b);
    return slice(wb, 1, 0) * slice(c_.w, 0, 1) - slice(wb, 0, 1) * slice(c_.w, 1, 0);
  }

  [[nodiscard]] Polynomial inflection() const {
    if (c_.w.empty()) {
      if (c_.x.size() < 2) return {};
      return slice(c_.x, 0, 1) * slice(c_.y, 1, 0) - slice(c_.x, 1, 0) * slice(c_.y, 0, 1);
    }
    if (c_.w.size() < 3) return {};
    const auto minor = [this](int i, int j) {
      return slice(wx_, i, 2 - i) * slice(wy_, j, 2 - j) - slice(wx_, j, 2 - j) * slice(wy_, i, 2 - i);
    };
    return minor(0, 1) * slice(c_.w, 2, 0) - minor(0, 2) * slice(c_.w, 1, 1) + minor(1, 2) * slice(c_.w, 0, 2);
  }

  [[nodiscard]] Polynomial curvature_change() const {
    const Polynomial dx = speed(c_.x, wx_), dy = speed(c_.y, wy_), bend = inflection();
    const Polynomial q = dx * dx + dy * dy;
    if (c_.w.empty()) return NT(2) * (q * bend.derivative()) - NT(3) * (q.derivative() * bend);
    const Polynomial w(c_.w), scaled = w * bend;
    const int degree = w.degree();
    const Polynomial change = w * bend.derivative() + NT(3 * degree) * (w_difference() * bend);
    return NT(2) * (q * change) - NT(3) * (q.derivative() * scaled);
  }

  // w' over the degree.
  [[nodiscard]] Polynomial w_difference() const { return slice(c_.w, 1, 0) - slice(c_.w, 0, 1); }

  const Curve_numbers<NT>& c_;
  Numbers wx_, wy_;
};

}  // namespace CGAL::Bounding_arcs::internal

#endif
