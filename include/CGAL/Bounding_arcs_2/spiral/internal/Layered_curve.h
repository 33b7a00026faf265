// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// A Bezier curve's numerators in three number types, each made when first asked for: intervals decide nearly always,
// double-double numbers round the roots, exact numbers are left for the rest.

#ifndef CGAL_BOUNDING_ARCS_2_SPIRAL_INTERNAL_LAYERED_CURVE_H
#define CGAL_BOUNDING_ARCS_2_SPIRAL_INTERNAL_LAYERED_CURVE_H

#include <CGAL/Bounding_arcs_2/curve/Bezier_curve_2.h>
#include <CGAL/Bounding_arcs_2/number/Double_double.h>
#include <CGAL/Bounding_arcs_2/number/Exact_number.h>
#include <CGAL/Bounding_arcs_2/polynomial/Bernstein_polynomial.h>
#include <CGAL/Bounding_arcs_2/polynomial/Interval_isolation.h>
#include <CGAL/Bounding_arcs_2/polynomial/proportional_numbers.h>
#include <CGAL/Bounding_arcs_2/spiral/internal/curve_numerators.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <optional>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL::Bounding_arcs::internal {

// The numbers of a curve, in double-double numbers and, when asked for, in exact ones.
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

// One of the four polynomials of a curve in three number types, as `isolate_layered_roots` wants it.
template <class NT> class Layered_numerator {
 public:
  using Ring = typename Layered_curve<NT>::Ring;

  Layered_numerator(Layered_curve<NT>& curve, Numerator which) : curve_(curve), which_(which) {}

  Bernstein_polynomial<Unprotected_interval> enclosure() const {
    const auto widened = [](const std::vector<Double_double>& a) {
      std::vector<Unprotected_interval> r;
      r.reserve(a.size());
      for (const Double_double& x : a) r.push_back(Bounding_arcs::enclosure(x));
      return r;
    };
    const auto& c = curve_.fine();
    return make(Curve_numbers<Unprotected_interval>{widened(c.x), widened(c.y), widened(c.w)});
  }
  const Bernstein_polynomial<Double_double>& fine() {
    if (!fine_) fine_ = make(curve_.fine());
    return *fine_;
  }
  const Bernstein_polynomial<Ring>& exact() {
    if (!exact_) exact_ = make(curve_.exact());
    return *exact_;
  }

 private:
  template <class T> Bernstein_polynomial<T> make(const Curve_numbers<T>& c) const {
    return Numerator_builder<T>(c)(which_);
  }

  Layered_curve<NT>& curve_;
  Numerator which_;
  std::optional<Bernstein_polynomial<Double_double>> fine_;
  std::optional<Bernstein_polynomial<Ring>> exact_;
};

}  // namespace CGAL::Bounding_arcs::internal

#endif
