// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Polynomials in s over the roots t of another polynomial m: a fibre m(t) = 0, h(t,s) = 0 is a finite set of points.
// Calculated for all roots of m at once as if m was irreducible; where a coefficient turns out to be zero for some
// roots only, m is split in two (Della Dora, Dicrescenzo, Duval 1985).

#ifndef BOUNDING_ARCS_LIBRARY_QUERY_FIBRE_H
#define BOUNDING_ARCS_LIBRARY_QUERY_FIBRE_H

#include <CGAL/Bounding_arcs_2/polynomial/Bernstein_polynomial.h>
#include "../polynomial/Integer_polynomial.h"
#include "../polynomial/Real_root.h"

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
  const auto steps_of = [&m](const Univariate& c) { return (std::max)(0, c.degree() - m.degree() + 1); };
  int most = 0;
  for (const Univariate& c : p) most = (std::max)(most, steps_of(c));
  const int even = most + most % 2;  // even powers of the leading coefficient are positive
  std::vector<Univariate> rest;
  for (const Univariate& c : p) {
    Univariate q, r;
    Integer factor;  // the leading coefficient to the power of the steps
    Univariate::pseudo_division(c, m, q, r, factor);
    rest.push_back(r * CGAL::ipower(Integer(m.lcoeff()), even - steps_of(c)));
  }
  return primitive_part(polynomial(rest));
}

/// u with u c = D mod m for an integer D > 0. \pre c and m are coprime, m is not constant
[[nodiscard]] inline Univariate inverse(const Univariate& c, const Univariate& m) {
  Univariate u, of_m;
  Integer d;
  static_cast<void>(CGAL::pseudo_gcdex(c, m, u, of_m, d));
  return CGAL::sign(d) == CGAL::NEGATIVE ? Univariate(-u) : u;
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
[[nodiscard]] inline Division divided(const Bivariate& f, const Bivariate& g, const Univariate& m) {
  Division result;
  Univariate factor;
  Bivariate::pseudo_division(f, g, result.quotient, result.remainder, factor);
  return {reduced(result.quotient, m), reduced(result.remainder, m)};
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

/// One root s of a fibre over a real root t: a polynomial in s whose coefficients are algebraic numbers.
/// Invariant: a dyadic number that is the root, or an open dyadic interval with no other root in it.
class Fibre_root {
 public:
  Fibre_root(std::shared_ptr<Real_root> t, std::shared_ptr<const Bivariate> h, Integer num, int k, int sign)
      : t_(std::move(t)), h_(std::move(h)), num_(std::move(num)), k_(k), sign_(sign) {}

  [[nodiscard]] bool is_dyadic() const { return sign_ == 0; }
  [[nodiscard]] Real_root dyadic() const { return {num_, k_}; }
  [[nodiscard]] Exact_rational lower() const { return Exact_rational(num_) / Exact_rational(power_of_two(k_)); }
  [[nodiscard]] Exact_rational upper() const {
    return is_dyadic() ? lower() : Exact_rational(Integer(num_ + 1)) / Exact_rational(power_of_two(k_));
  }

  void refine() {
    if (is_dyadic()) return;
    num_ = num_ * 2 + 1;
    const int s = t_->sign_of(at_dyadic(*h_, num_, ++k_));
    if (s == 0) sign_ = 0;
    if (s * sign_ < 0) num_ = num_ - 1;
  }
  [[nodiscard]] Bracket range() {
    for (;; refine()) {
      const mpfr_prec_t bits = k_ + 64;
      const Bracket r = range_of(joined(Mpfr_interval(lower(), bits), Mpfr_interval(upper(), bits)));
      if (is_dyadic() || (is_narrow(r) && r.lower < r.upper)) return r;
    }
  }
  /// Whether it is greater than another number. \pre it does not equal that
  [[nodiscard]] bool is_greater(Real_root& other) {
    for (;; refine(), other.refine()) {
      if (lower() >= other.upper()) return true;
      if (upper() <= other.lower()) return false;
    }
  }

 private:
  std::shared_ptr<Real_root> t_;
  std::shared_ptr<const Bivariate> h_;
  Integer num_;
  int k_, sign_;  // the sign of h right after the lower end, 0 when that is the root
};

/// The roots in [0,1] over one real root t. \pre none is multiple
class Fibre_isolation {
 public:
  Fibre_isolation(const Real_root& t, const Bivariate& h)
      : t_(std::make_shared<Real_root>(t)), h_(std::make_shared<const Bivariate>(h)) {
    const Bivariate by_t = CGAL::swap(h, 0, 1);
    Rows rows;
    for (int i = 0; i <= by_t.degree(); ++i) rows.push_back(to_bernstein(coefficient(by_t, i), h.degree()));
    if (sign(rows, 0) == 0) add(Integer(0), 0, 0);
    if (sign(rows, static_cast<std::size_t>(h.degree())) == 0) add(Integer(1), 0, 0);
    isolate(rows, Integer(0), 0);
  }
  [[nodiscard]] std::vector<Fibre_root> roots() && { return std::move(roots_); }

 private:
  using Bernstein = Bernstein_polynomial<Integer>;
  using Rows = std::vector<Bernstein>;  // by powers of t

  void add(const Integer& num, int k, int sign) { roots_.emplace_back(t_, h_, num, k, sign); }
  int sign(const Rows& rows, std::size_t j) {
    std::vector<Integer> c;
    for (const Bernstein& row : rows) c.push_back(row.scaled_coefficients()[j]);
    return t_->sign_of(polynomial(c));
  }
  void isolate(const Rows& rows, const Integer& num, int k) {
    Sign_variations v;
    for (std::size_t j = 0; j < rows.front().scaled_coefficients().size(); ++j)
      if (const int s = sign(rows, j)) v.append(s);
    if (v.most() == 0) return;
    if (v.most() == 1) return add(num, k, v.first);
    Rows left, right;
    for (const Bernstein& row : rows) {
      auto halves = row.halves();
      left.push_back(std::move(halves.first));
      right.push_back(std::move(halves.second));
    }
    const Integer first = num * 2, second = first + 1;
    if (sign(right, 0) == 0) add(second, k + 1, 0);
    isolate(left, first, k + 1);
    isolate(right, second, k + 1);
  }

  std::shared_ptr<Real_root> t_;
  std::shared_ptr<const Bivariate> h_;
  std::vector<Fibre_root> roots_;
};

}  // namespace CGAL::Bounding_arcs::internal

#endif
