// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The common factor of two equations in t and s, mostly of degree one in each: two pieces of one curve then differ by a
// fractional linear change of parameter, which three pairs of parameters determine.

#ifndef BOUNDING_ARCS_LIBRARY_POLYNOMIAL_COMMON_FACTOR_H
#define BOUNDING_ARCS_LIBRARY_POLYNOMIAL_COMMON_FACTOR_H

#include "Integer_polynomial.h"

#include <array>
#include <cstddef>
#include <optional>
#include <vector>

namespace CGAL::Bounding_arcs {

/// p at t = number, a polynomial in s.
[[nodiscard]] inline Univariate at_number(const Bivariate& p, const Integer& t) {
  std::vector<Integer> c;
  for (int j = 0; j <= p.degree(); ++j) c.push_back(coefficient(p, j).evaluate(t));
  return polynomial(c);
}

using Bilinear_row = std::array<Integer, 4>;  // of t s, t, s and 1

/// What is orthogonal to three rows.
[[nodiscard]] inline Bilinear_row orthogonal(const std::vector<Bilinear_row>& rows) {
  Bilinear_row r;
  for (std::size_t skipped = 0; skipped < 4; ++skipped) {
    std::array<std::size_t, 3> c{};
    for (std::size_t i = 0, k = 0; i < 4; ++i)
      if (i != skipped) c[k++] = i;
    const auto product = [&](std::size_t i, std::size_t j, std::size_t k) {
      return Integer(Integer(rows[0][c[i]] * rows[1][c[j]]) * rows[2][c[k]]);
    };
    Integer sum = product(0, 1, 2);
    sum += product(1, 2, 0);
    sum += product(2, 0, 1);
    sum -= product(0, 2, 1);
    sum -= product(1, 0, 2);
    sum -= product(2, 1, 0);
    r[skipped] = skipped % 2 == 0 ? sum : Integer(-sum);
  }
  return r;
}

/// A common factor of degree one in t and in s, where it is easily found; there may be more to the greatest one.
[[nodiscard]] inline std::optional<Bivariate> bilinear_factor(const Bivariate& f, const Bivariate& g) {
  constexpr int PLACES = 12;  // a few have other common roots, at loops
  std::vector<Bilinear_row> rows;
  for (int i = 1; i <= PLACES && rows.size() < 3; ++i) {
    const Integer t(i);
    const Univariate common = CGAL::gcd(at_number(f, t), at_number(g, t));
    if (common.degree() != 1) continue;
    const Integer n = -coefficient(common, 0), d = coefficient(common, 1);  // the root s = n / d
    rows.push_back({Integer(t * n), Integer(t * d), n, d});
  }
  if (rows.size() < 3) return std::nullopt;
  const Bilinear_row r = orthogonal(rows);
  const Univariate constant = polynomial<Integer>({r[3], r[1]}), linear = polynomial<Integer>({r[2], r[0]});
  const bool is_proper = Integer(r[0] * r[3]) != Integer(r[1] * r[2]);  // else it is a product
  if (!is_proper || !at_fraction(f, -constant, linear).is_zero() || !at_fraction(g, -constant, linear).is_zero())
    return std::nullopt;
  return primitive_part(polynomial<Univariate>({constant, linear}));
}

}  // namespace CGAL::Bounding_arcs

#endif
