// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Polynomials in s over the roots t of another polynomial m: a fibre m(t) = 0, h(t,s) = 0 is a finite set of points.
// Calculated for all roots of m at once as if m was irreducible; where a coefficient turns out to be zero for some
// roots only, m is split in two (Della Dora, Dicrescenzo, Duval 1985).

#ifndef BOUNDING_ARCS_LIBRARY_QUERY_FIBRE_H
#define BOUNDING_ARCS_LIBRARY_QUERY_FIBRE_H

#include "../polynomial/Integer_polynomial.h"

#include <CGAL/Exact_rational.h>

#include <optional>
#include <utility>
#include <vector>

namespace CGAL::Bounding_arcs::internal {

/// The points (t,s) with m(t) = 0 and h(t,s) = 0, m square-free. Once divided, h has a positive integer for a leading
/// coefficient, so that it has its degree over every root of m.
struct Fibre {
  Univariate m;
  Bivariate h;
};

/// c mod m for all coefficients c, times one positive integer for all of them.
[[nodiscard]] inline Bivariate reduced(const Bivariate& p, const Univariate& m) {
  int most = m.degree() - 1;
  for (int j = 0; j <= p.degree(); ++j) most = (std::max)(most, coefficient(p, j).degree());
  // Even powers of the leading coefficient are positive.
  const int steps = most - m.degree() + 1, even = steps + steps % 2;
  const Integer leading(m.lcoeff());
  std::vector<Univariate> c;
  for (int j = 0; j <= p.degree(); ++j) {
    const Univariate q = coefficient(p, j);
    std::vector<Integer> r(q.begin(), q.end());
    for (int step = 0; step < even; ++step) {
      const std::size_t d = static_cast<std::size_t>(m.degree());
      const bool is_long = r.size() > d;
      const Integer top = is_long ? r.back() : Integer(0);
      if (is_long) r.pop_back();
      for (Integer& x : r) x *= leading;
      if (!is_long) continue;
      for (std::size_t i = 0; i < d; ++i) r[r.size() - d + i] -= top * m[static_cast<unsigned>(i)];
    }
    c.push_back(polynomial(r));
  }
  return primitive_part(polynomial(c));
}

/// u with u c = D mod m for an integer D > 0. \pre c and m are coprime, m is not constant
[[nodiscard]] inline Univariate inverse(const Univariate& c, const Univariate& m) {
  using Rational_polynomial = CGAL::Polynomial<Exact_rational>;
  const auto over_rationals = [](const Univariate& p) {
    std::vector<Exact_rational> r;
    for (int i = 0; i <= p.degree(); ++i) r.push_back(Exact_rational(coefficient(p, i)));
    return polynomial(r);
  };
  Rational_polynomial r0 = over_rationals(m), r1 = over_rationals(c), u0(Exact_rational(0)), u1(Exact_rational(1));
  while (r1.degree() > 0) {
    Rational_polynomial q, r;
    Rational_polynomial::euclidean_division(r0, r1, q, r);
    const Rational_polynomial u = u0 - q * u1;
    const Exact_rational scale = Exact_rational(1) / r.lcoeff();
    r0 = std::exchange(r1, r * scale);
    u0 = std::exchange(u1, u * scale);
  }
  const Exact_rational value(r1.lcoeff());
  Integer denominator(1);
  using Traits = CGAL::Fraction_traits<Exact_rational>;
  const auto fraction = [](const Exact_rational& x) {
    std::pair<Integer, Integer> f;
    typename Traits::Decompose()(x, f.first, f.second);
    return f;
  };
  std::vector<Exact_rational> quotients;
  for (int i = 0; i <= u1.degree(); ++i) {
    quotients.push_back(coefficient(u1, i) / value);
    const Integer d = fraction(quotients.back()).second;
    denominator = CGAL::integral_division(denominator, CGAL::gcd(denominator, d)) * d;
  }
  std::vector<Integer> integers;
  for (const Exact_rational& x : quotients) integers.push_back(fraction(x * Exact_rational(denominator)).first);
  return polynomial(integers);
}

/// Reduces h and makes its leading coefficient a positive integer; or tells a factor of m over which h has another
/// degree than over the rest.
[[nodiscard]] inline std::optional<Univariate> make_monic(Bivariate& h, const Univariate& m) {
  h = reduced(h, m);
  while (h.degree() >= 0 && !h.is_zero()) {
    const Univariate leading = h.lcoeff();
    if (leading.degree() == 0) {
      if (CGAL::sign(leading.lcoeff()) == CGAL::NEGATIVE) h = -h;
      return std::nullopt;
    }
    const Univariate common = CGAL::gcd(leading, m);
    if (common.degree() > 0) return common;
    h = reduced(h * inverse(leading, m), m);
  }
  return std::nullopt;
}

/// f over g without a remainder, times a positive integer. \pre g has an integer for a leading coefficient
struct Division {
  Bivariate quotient, remainder;
};
[[nodiscard]] inline Division divided(Bivariate f, const Bivariate& g, const Univariate& m) {
  const Integer leading(g.lcoeff().lcoeff());
  std::vector<Univariate> q(static_cast<std::size_t>((std::max)(0, f.degree() - g.degree() + 1)),
                            Univariate(Integer(0)));
  std::vector<Univariate> r(f.begin(), f.end());
  for (int j = f.degree() - g.degree(); j >= 0; --j) {
    const Univariate top = r.back();
    r.pop_back();
    for (Univariate& c : r) c = c * leading;
    for (Univariate& c : q) c = c * leading;
    q[static_cast<std::size_t>(j)] = top;
    for (int i = 0; i < g.degree(); ++i) {
      Univariate& c = r[static_cast<std::size_t>(j + i)];
      c = c - top * coefficient(g, i);
    }
  }
  return {reduced(polynomial(q), m), reduced(polynomial(r), m)};
}

/// For the roots of m, split as needed, the greatest common divisor of f and g in s.
inline void append_common(const Univariate& m, const Bivariate& f, const Bivariate& g, std::vector<Fibre>& to) {
  const auto split = [&](const Univariate& factor) {
    append_common(factor, f, g, to);
    append_common(CGAL::integral_division(m, factor), f, g, to);
  };
  Bivariate p = f, q = g;
  if (const auto factor = make_monic(p, m)) return split(*factor);
  if (const auto factor = make_monic(q, m)) return split(*factor);
  if (p.degree() < q.degree() || p.is_zero()) std::swap(p, q);
  while (!q.is_zero()) {
    Bivariate r = divided(p, q, m).remainder;
    if (const auto factor = make_monic(r, m)) return split(*factor);
    p = std::exchange(q, r);
  }
  to.push_back({m, p});
}

/// The points of a fibre on the curve e = 0 and the other ones. \pre h has no multiple roots for any t
struct Fibre_parts {
  std::vector<Fibre> on, off;
};
[[nodiscard]] inline Fibre_parts divided_by_curve(const std::vector<Fibre>& fibres, const Bivariate& e) {
  Fibre_parts parts;
  for (const Fibre& fibre : fibres) {
    std::vector<Fibre> common;
    append_common(fibre.m, fibre.h, e, common);
    for (Fibre& c : common) {
      Bivariate h = fibre.h;
      (void)make_monic(h, c.m);
      const Bivariate rest = divided(h, c.h, c.m).quotient;
      if (c.h.degree() > 0) parts.on.push_back(c);
      if (rest.degree() > 0) parts.off.push_back({c.m, rest});
    }
  }
  return parts;
}

/// The common zeros of f and g over the roots of m, each once. \pre f and g do not both vanish for all s at a root of m
[[nodiscard]] inline std::vector<Fibre> common_fibres(const Univariate& m, const Bivariate& f, const Bivariate& g) {
  std::vector<Fibre> common, once;
  if (m.degree() > 0) append_common(m, f, g, common);
  for (const Fibre& c : common) {
    if (c.h.degree() == 0) continue;
    std::vector<Fibre> repeated;
    append_common(c.m, c.h, CGAL::differentiate(c.h), repeated);
    for (const Fibre& r : repeated) {
      Bivariate h = c.h;
      (void)make_monic(h, r.m);
      once.push_back({r.m, divided(h, r.h, r.m).quotient});
    }
  }
  return once;
}

}  // namespace CGAL::Bounding_arcs::internal

#endif
