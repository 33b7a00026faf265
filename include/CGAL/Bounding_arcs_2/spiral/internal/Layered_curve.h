// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The polynomials whose roots cut a Bezier curve into spiral segments, over exact numbers; over doubles they are in
// src/library/spiral.

#ifndef CGAL_BOUNDING_ARCS_2_SPIRAL_INTERNAL_LAYERED_CURVE_H
#define CGAL_BOUNDING_ARCS_2_SPIRAL_INTERNAL_LAYERED_CURVE_H

#include <CGAL/Bounding_arcs_2/curve/Bezier_curve_2.h>
#include <CGAL/Bounding_arcs_2/number/Double_double.h>
#include <CGAL/Bounding_arcs_2/number/Exact_number.h>
#include <CGAL/Bounding_arcs_2/polynomial/Bernstein_polynomial.h>
#include <CGAL/Bounding_arcs_2/polynomial/proportional_numbers.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <optional>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL::Bounding_arcs::internal {

// The four polynomials whose roots cut a Bezier curve into spiral segments, in the Bernstein basis from differences of
// control points. With Q = |C'|^2, C' the derivative or H = F' w - F w' for a homogeneous curve (F, w):  C'.x, C'.y,
//   I = det(C', C'') or D = det(F, F', F''),   2 Q I' - 3 Q' I  or  2 Q (w D' + 3 w' D) - 3 Q' w D,
// all up to constant factors.

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

/// The numbers of a curve, in double-double numbers and, when asked for, in exact ones.
template <class NT> class Layered_curve {
  using Exact = typename Exact_number<NT>::Type;
  using Integers = Proportional_integers<Exact>;

 public:
  using Ring = typename Integers::Ring;

  explicit Layered_curve(const Bezier_curve_2<NT>& curve) : curve_(curve) {
    const auto& w = curve.weights();
    is_rational_ = std::adjacent_find(w.begin(), w.end(), [](const NT& a, const NT& b) { return a != b; }) != w.end();
    fine_ = make_fine();
  }

  const Curve_numbers<Double_double>& fine() const { return fine_; }
  const Curve_numbers<Ring>& exact() {
    if (!exact_) exact_ = from_exact(&Integers::make);
    return *exact_;
  }

 private:
  // Differences of doubles below this size do not overflow.
  static constexpr double LARGE = 0x1p1000;
  static constexpr bool IS_DOUBLE = std::is_same_v<NT, double> || std::is_same_v<NT, float>;

  [[nodiscard]] Curve_numbers<Double_double> make_fine() const {
    if constexpr (IS_DOUBLE) {
      const auto is_small = [](const Xy<NT>& q) {
        return std::abs(double(q.x)) < LARGE && std::abs(double(q.y)) < LARGE;
      };
      const auto& p = curve_.control_points();
      if (std::all_of(p.begin(), p.end(), is_small)) return from_doubles();
    }
    return from_exact(&normalized<Exact>);
  }

  // Pairs of indices of control points whose differences are wanted.
  [[nodiscard]] std::size_t base(std::size_t i) const { return is_rational_ ? 0 : i - 1; }
  [[nodiscard]] std::size_t first() const { return is_rational_ ? 0 : 1; }

  // All differences, those of x before those of y, as `difference` makes them.
  template <class T, class Difference> [[nodiscard]] std::vector<T> differences(Difference difference) const {
    const auto& p = curve_.control_points();
    std::vector<T> r;
    for (std::size_t i = first(); i < p.size(); ++i) r.push_back(difference(p[i].x, p[base(i)].x));
    for (std::size_t i = first(); i < p.size(); ++i) r.push_back(difference(p[i].y, p[base(i)].y));
    return r;
  }

  template <class T> static Curve_numbers<T> assembled(const std::vector<T>& xy, std::vector<T> w) {
    const auto middle = xy.begin() + static_cast<std::ptrdiff_t>(xy.size() / 2);
    return {std::vector<T>(xy.begin(), middle), std::vector<T>(middle, xy.end()), std::move(w)};
  }

  [[nodiscard]] Curve_numbers<Double_double> from_doubles() const {
    std::vector<Double_double> xy = differences<Double_double>(
        [](const NT& a, const NT& b) { return Double_double::two_sum(double(a), -double(b)); });
    std::vector<Double_double> w;
    if (is_rational_)
      for (const NT& x : curve_.weights()) w.push_back(Double_double(double(x)));
    normalize(xy);
    normalize(w);
    return assembled(xy, std::move(w));
  }

  template <class Convert> [[nodiscard]] auto from_exact(Convert convert) const {
    std::vector<Exact> xy = differences<Exact>(
        [](const NT& a, const NT& b) { return Exact(Exact_number<NT>::make(a) - Exact_number<NT>::make(b)); });
    std::vector<Exact> w;
    if (is_rational_)
      for (const NT& x : curve_.weights()) w.push_back(Exact_number<NT>::make(x));
    return assembled(convert(std::move(xy)), convert(std::move(w)));
  }

  const Bezier_curve_2<NT>& curve_;
  bool is_rational_ = false;
  Curve_numbers<Double_double> fine_;
  std::optional<Curve_numbers<Ring>> exact_;
};

}  // namespace CGAL::Bounding_arcs::internal

#endif
