// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// A piece as three polynomials with integer coefficients, x/w and y/w its coordinates.
// Invariant: x, y and w have no common factor, and w > 0 on [0,1].

#ifndef CGAL_BOUNDING_ARCS_2_QUERY_INTERNAL_INTEGER_PIECE_H
#define CGAL_BOUNDING_ARCS_2_QUERY_INTERNAL_INTEGER_PIECE_H

#include <CGAL/Bounding_arcs_2/curve/Bezier_curve_2.h>
#include <CGAL/Bounding_arcs_2/polynomial/Bernstein_polynomial.h>
#include <CGAL/Bounding_arcs_2/polynomial/Integer_polynomial.h>

#include <CGAL/Exact_rational.h>
#include <CGAL/Fraction_traits.h>

#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL::Bounding_arcs::internal {

/// Numerator and denominator, which is positive.
[[nodiscard]] inline std::pair<Integer, Integer> decomposed(const Exact_rational& x) {
  std::pair<Integer, Integer> f;
  typename CGAL::Fraction_traits<Exact_rational>::Decompose()(x, f.first, f.second);
  return f;
}

/// The numbers times the least common multiple of their denominators.
[[nodiscard]] inline std::vector<Integer> to_integers(const std::vector<Exact_rational>& numbers) {
  Integer denominator(1);
  for (const Exact_rational& x : numbers) {
    const Integer d = decomposed(x).second;
    denominator = CGAL::integral_division(denominator, CGAL::gcd(denominator, d)) * d;
  }
  std::vector<Integer> r;
  for (const Exact_rational& x : numbers) r.push_back(decomposed(x * Exact_rational(denominator)).first);
  return r;
}

struct Integer_piece {
  Univariate x, y, w;

  explicit Integer_piece(const Bezier_curve_2<Exact_rational>& curve) {
    std::vector<Exact_rational> numbers;
    const auto add = [&](const auto& number_at) {
      std::vector<Exact_rational> c;
      for (int i = 0; i <= curve.degree(); ++i) c.push_back(number_at(i));
      for (Exact_rational& number : powers(std::move(c))) numbers.push_back(std::move(number));
    };
    const auto& p = curve.control_points();
    add([&](int i) { return Exact_rational(p[static_cast<std::size_t>(i)].x * curve.weight(i)); });
    add([&](int i) { return Exact_rational(p[static_cast<std::size_t>(i)].y * curve.weight(i)); });
    add([&](int i) { return curve.weight(i); });
    const std::vector<Integer> integers = to_integers(numbers);
    const auto count = static_cast<std::ptrdiff_t>(p.size());
    const auto part = [&](std::ptrdiff_t i) {
      return polynomial(std::vector<Integer>(integers.begin() + i * count, integers.begin() + (i + 1) * count));
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
  // From Bernstein coefficients: sum b_i C(n,i) t^i (1-t)^(n-i), by differences.
  static std::vector<Exact_rational> powers(std::vector<Exact_rational> c) {
    const std::size_t n = c.size() - 1;
    for (std::size_t k = 1; k <= n; ++k)
      for (std::size_t i = n; i >= k; --i) c[i] -= c[i - 1];
    const std::vector<Exact_rational> factors = binomials<Exact_rational>(static_cast<int>(n));
    for (std::size_t i = 0; i <= n; ++i) c[i] *= factors[i];
    return c;
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

}  // namespace CGAL::Bounding_arcs::internal

#endif
