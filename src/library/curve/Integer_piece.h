// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// A piece as three polynomials with integer coefficients, x/w and y/w its coordinates.
// Invariant: x, y and w have no common factor, and w > 0 on [0,1].

#ifndef BOUNDING_ARCS_LIBRARY_CURVE_INTEGER_PIECE_H
#define BOUNDING_ARCS_LIBRARY_CURVE_INTEGER_PIECE_H

#include <CGAL/Bounding_arcs_2/curve/Bezier_curve_2.h>
#include <CGAL/Bounding_arcs_2/polynomial/Bernstein_polynomial.h>
#include <CGAL/Bounding_arcs_2/polynomial/proportional_numbers.h>
#include "../polynomial/Integer_polynomial.h"

#include <CGAL/Exact_rational.h>
#include <CGAL/Fraction_traits.h>

#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL::Bounding_arcs {

/// Numerator and denominator, which is positive.
[[nodiscard]] inline std::pair<Integer, Integer> decomposed(const Exact_rational& x) {
  std::pair<Integer, Integer> f;
  typename CGAL::Fraction_traits<Exact_rational>::Decompose()(x, f.first, f.second);
  return f;
}

/// The numerator of n / w - by, times a positive number.
[[nodiscard]] inline Univariate moved(const Univariate& n, const Univariate& w, const Exact_rational& by) {
  const auto [num, den] = decomposed(by);
  return n * den - w * num;
}
/// The numerator of the derivative of n / w, whose denominator is a square.
[[nodiscard]] inline Univariate derivative_numerator(const Univariate& n, const Univariate& w) {
  return CGAL::differentiate(n) * w - n * CGAL::differentiate(w);
}

/// A Bezier piece as x(t) / w(t) and y(t) / w(t).
struct Integer_piece {
  Univariate x, y, w;

  explicit Integer_piece(const Bezier_curve_2<Exact_rational>& curve) {
    const std::vector<Exact_rational> factors = internal::binomials<Exact_rational>(curve.degree());
    std::vector<Exact_rational> numbers;  // scaled Bernstein coefficients of x, y and w
    const auto add = [&](const auto& number_at) {
      for (std::size_t i = 0; i < factors.size(); ++i)
        numbers.push_back(
            Exact_rational(number_at(i) * Exact_rational(curve.weight(static_cast<int>(i)) * factors[i])));
    };
    const auto& p = curve.control_points();
    add([&](std::size_t i) { return p[i].x; });
    add([&](std::size_t i) { return p[i].y; });
    add([](std::size_t) { return Exact_rational(1); });
    const std::vector<Integer> integers = internal::Proportional_integers<Exact_rational>::make(numbers);
    const auto count = static_cast<std::ptrdiff_t>(p.size());
    const auto part = [&](std::ptrdiff_t i) {
      return to_powers({integers.begin() + i * count, integers.begin() + (i + 1) * count});
    };
    x = part(0), y = part(1), w = part(2);
    reduce();
  }

  [[nodiscard]] int degree() const { return (std::max)({x.degree(), y.degree(), w.degree()}); }
  [[nodiscard]] bool is_point() const { return degree() == 0; }
  /// Whether it is part of a line: no three coefficients (x, y, w) are independent.
  [[nodiscard]] bool is_straight() const {
    for (int i = 0; i <= degree(); ++i)
      for (int j = i + 1; j <= degree(); ++j)
        for (int k = j + 1; k <= degree(); ++k)
          if (determinant(i, j, k) != Integer(0)) return false;
    return true;
  }

 private:
  [[nodiscard]] Integer determinant(int i, int j, int k) const {
    const auto minor = [this](int m, int n) {
      return Integer(Integer(coefficient(x, m) * coefficient(y, n)) - Integer(coefficient(x, n) * coefficient(y, m)));
    };
    return Integer(coefficient(w, i) * minor(j, k)) - Integer(coefficient(w, j) * minor(i, k)) +
           Integer(coefficient(w, k) * minor(i, j));
  }
  void reduce() {
    Univariate common = CGAL::gcd(CGAL::gcd(x, y), w);
    if (CGAL::sign(Integer(coefficient(common, 0))) == CGAL::NEGATIVE)
      common = -common;  // no zero on [0,1], as w has none
    x = CGAL::integral_division(x, common);
    y = CGAL::integral_division(y, common);
    w = CGAL::integral_division(w, common);
  }
};

}  // namespace CGAL::Bounding_arcs

#endif
