// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Polynomials over the integers in one variable and in two: what the exact stage of queries calculates with.
// A polynomial in two variables is a list of coefficients by powers of s, each a polynomial in t.

#ifndef BOUNDING_ARCS_LIBRARY_POLYNOMIAL_INTEGER_POLYNOMIAL_H
#define BOUNDING_ARCS_LIBRARY_POLYNOMIAL_INTEGER_POLYNOMIAL_H

#include <CGAL/Bounding_arcs_2/number/Exact_number.h>
#include <CGAL/Bounding_arcs_2/number/strict_math.h>
#include <CGAL/Bounding_arcs_2/polynomial/Bernstein_polynomial.h>
#include <CGAL/Bounding_arcs_2/polynomial/proportional_numbers.h>

#include <CGAL/Exact_integer.h>
#include <CGAL/Polynomial.h>
#include <CGAL/Polynomial_traits_d.h>
#include <CGAL/assertions.h>
#include <CGAL/number_utils.h>
#include <CGAL/polynomial_utils.h>

#include <algorithm>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL::Bounding_arcs {

using Integer = CGAL::Exact_integer;
using Univariate = CGAL::Polynomial<Integer>;
using Bivariate = CGAL::Polynomial<Univariate>;  ///< coefficients of powers of s, in t
using Exact_polynomial = Bernstein_polynomial<Exact_rational>;

/// Makes a polynomial from coefficients by rising powers; leading zeros are dropped.
template <class NT> [[nodiscard]] CGAL::Polynomial<NT> polynomial(const std::vector<NT>& c) {
  return c.empty() ? CGAL::Polynomial<NT>(NT(0)) : CGAL::Polynomial<NT>(c.begin(), c.end());
}

/// The coefficient of the i-th power, 0 beyond the degree.
template <class NT> [[nodiscard]] NT coefficient(const CGAL::Polynomial<NT>& p, int i) {
  return i <= p.degree() ? p[static_cast<unsigned>(i)] : NT(0);
}

/// The polynomial over [0,1] as of a degree not below its own: sum c_i t^i = sum c_i t^i (t + (1-t))^(n-i), by growing
/// binomial rows.
[[nodiscard]] inline Bernstein_polynomial<Integer> to_bernstein(const Univariate& p, int degree) {
  std::vector<Integer> sum{coefficient(p, degree)}, row{Integer(1)};
  for (int i = degree - 1; i >= 0; --i) {
    row.push_back(Integer(1));
    for (std::size_t j = row.size() - 2; j > 0; --j) row[j] += row[j - 1];
    sum.insert(sum.begin(), Integer(0));
    const Integer c = coefficient(p, i);
    for (std::size_t j = 0; j < row.size(); ++j) sum[j] += c * row[j];
  }
  return Bernstein_polynomial<Integer>::from_scaled(std::move(sum));
}
/// The polynomial sum c_i t^i (1-t)^(n-i), from scaled coefficients, by Horner's scheme.
[[nodiscard]] inline Univariate to_powers(const std::vector<Integer>& scaled) {
  const Univariate t = polynomial<Integer>({Integer(0), Integer(1)}),
                   s = polynomial<Integer>({Integer(1), Integer(-1)});
  Univariate value(scaled.back()), power(Integer(1));
  for (std::size_t i = scaled.size() - 1; i-- > 0;) {
    power = power * s;
    value = value * t + power * scaled[i];
  }
  return value;
}
/// The coefficients of powers, times a positive number.
[[nodiscard]] inline Univariate to_powers(const Exact_polynomial& p) {
  return to_powers(cleared(p.scaled_coefficients()).numbers);
}

/// The number 2^k.
[[nodiscard]] inline Integer power_of_two(int k) {
  Integer r(1);
  r <<= static_cast<unsigned>(k);
  return r;
}

/// p over its integer content, which is positive: no sign changes.
template <class Coefficient>
[[nodiscard]] CGAL::Polynomial<Coefficient> primitive_part(CGAL::Polynomial<Coefficient> p) {
  const Integer content = CGAL::multivariate_content(p);
  if (content != Integer(0) && content != Integer(1)) p /= content;
  return p;
}

/// The value of p at a rational number.
[[nodiscard]] inline Exact_rational value_at(const Univariate& p, const Exact_rational& t) { return p.evaluate(t); }

/// The sign of p at num / 2^k.
[[nodiscard]] inline int sign_at_dyadic(const Univariate& p, const Integer& num, int k) {
  Integer value(0);
  for (int i = p.degree(), shift = 0; i >= 0; --i, shift += k) {
    Integer c = coefficient(p, i);
    c <<= static_cast<unsigned>(shift);
    value *= num;
    value += c;
  }
  return static_cast<int>(CGAL::sign(value));
}

/// The product of the distinct irreducible factors of p and of those among them that p has more than once.
struct Root_multiplicities {
  Univariate simple, multiple;
};
/// \pre p is not zero
[[nodiscard]] inline Root_multiplicities root_multiplicities(const Univariate& p) {
  CGAL_precondition(!p.is_zero());
  if (p.degree() < 1) return {Univariate(Integer(1)), Univariate(Integer(1))};
  const Univariate q = primitive_part(p), repeated = CGAL::gcd(q, CGAL::differentiate(q));
  const Univariate all = CGAL::integral_division(q, repeated), multiple = CGAL::gcd(all, repeated);
  return {CGAL::integral_division(all, multiple), multiple};
}

/// Factors by the multiplicity of their roots in [0,1]; one without a root there may be in neither, or repeated.
/// Filter: where Descartes' rule of signs leaves one root at most between the ends, no divisor is looked for.
/// \pre p is not zero
[[nodiscard]] inline Root_multiplicities unit_root_multiplicities(const Univariate& p) {
  CGAL_precondition(!p.is_zero());
  Root_multiplicities found{Univariate(Integer(1)), Univariate(Integer(1))};
  Univariate inner = primitive_part(p);
  for (const int end : {0, 1}) {
    const Univariate factor = polynomial<Integer>({Integer(-end), Integer(1)});
    int count = 0;
    for (; sign_at_dyadic(inner, Integer(end), 0) == 0; ++count) inner = CGAL::integral_division(inner, factor);
    if (count == 1) found.simple = found.simple * factor;
    if (count > 1) found.multiple = found.multiple * factor;
  }
  const int variations = internal::sign_variations(to_bernstein(inner, inner.degree())).most();
  if (variations > 1) return root_multiplicities(p);
  if (variations == 1) found.simple = found.simple * inner;
  return found;
}

/// The greatest common divisor but for integers. Filter: t - n, a root at an end of [0,1], divides q where q is 0.
[[nodiscard]] inline Univariate common_divisor(const Univariate& m, const Univariate& q) {
  if (m.degree() < 1) return Univariate(Integer(1));
  if (m.degree() > 1 || m.lcoeff() != Integer(1)) return CGAL::gcd(m, primitive_part(q));
  return sign_at_dyadic(q, Integer(-m[0]), 0) == 0 ? m : Univariate(Integer(1));
}

/// p without repeated factors. \pre p is not zero
[[nodiscard]] inline Univariate square_free(const Univariate& p) {
  CGAL_precondition(!p.is_zero());
  if (p.degree() < 1) return Univariate(Integer(1));
  const Univariate q = primitive_part(p);
  return CGAL::integral_division(q, CGAL::gcd(q, CGAL::differentiate(q)));
}

/// The product of the factors of odd multiplicity, each once: the polynomial changes its sign at their real roots only.
/// \pre p is not zero
[[nodiscard]] inline Univariate odd_part(Univariate p) {
  CGAL_precondition(!p.is_zero());
  Univariate odd(Integer(1));
  for (bool is_odd = true; p.degree() > 0; is_odd = !is_odd) {
    // What is left of p loses one factor of each kind a round; those that vanish in a round have its multiplicity.
    const Univariate factors = square_free(p), rest = CGAL::integral_division(primitive_part(p), factors);
    const Univariate lasting = CGAL::gcd(factors, rest);
    if (is_odd) odd = odd * CGAL::integral_division(factors, lasting);
    p = rest;
  }
  return odd;
}

/// a(t) b(s) - b(t) a(s), or with two pairs of functions a(t) d(s) - b(t) c(s).
[[nodiscard]] inline Bivariate crossed(const Univariate& a, const Univariate& b, const Univariate& c,
                                       const Univariate& d) {
  std::vector<Univariate> by_s;
  for (int j = 0; j <= (std::max)(c.degree(), d.degree()); ++j)
    by_s.push_back(a * coefficient(d, j) - b * coefficient(c, j));
  return polynomial(by_s);
}

/// The numerator of p(t, n(t)/d(t)).
[[nodiscard]] inline Univariate at_fraction(const Bivariate& p, const Univariate& n, const Univariate& d) {
  Univariate value(Integer(0)), power(Integer(1));
  for (int j = p.degree(); j >= 0; --j) {
    value = value * n + coefficient(p, j) * power;
    power = power * d;
  }
  return value;
}

/// p(t, num/2^k) times a power of two.
[[nodiscard]] inline Univariate at_dyadic(const Bivariate& p, const Integer& num, int k) {
  return at_fraction(p, Univariate(num), Univariate(power_of_two(k)));
}

}  // namespace CGAL::Bounding_arcs

#endif
