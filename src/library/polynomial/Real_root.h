// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Real roots as exactly as is asked for. CGAL's Algebraic_kernel_d_1 has such numbers, too. From coefficients to
// doubles around all roots it takes 3 to 6 times as long (test/benchmark/bench_roots.cpp: degrees 3 to 25, 60 to 800
// bits).

#ifndef BOUNDING_ARCS_LIBRARY_POLYNOMIAL_REAL_ROOT_H
#define BOUNDING_ARCS_LIBRARY_POLYNOMIAL_REAL_ROOT_H

#include <CGAL/Bounding_arcs_2/number/Bracket.h>
#include <CGAL/Bounding_arcs_2/number/Mpfr_interval.h>
#include <CGAL/Bounding_arcs_2/polynomial/Bernstein_polynomial.h>
#include "Integer_polynomial.h"

#include <CGAL/Exact_rational.h>
#include <CGAL/assertions.h>

#include <cmath>
#include <limits>
#include <memory>
#include <optional>
#include <vector>

namespace CGAL::Bounding_arcs {

/// Whether a parameter is known well enough: no more than three doubles.
[[nodiscard]] inline bool is_narrow(const Bracket& r) {
  const double inf = std::numeric_limits<double>::infinity();
  return r.upper <= std::nextafter(std::nextafter(r.lower, inf), inf);
}

/// The doubles around an interval, within [0,1].
[[nodiscard]] inline Bracket range_of(const Mpfr_interval& x) {
  return {(std::max)(0.0, x.lower()), (std::min)(1.0, x.upper())};
}

/// A real root of a polynomial over the integers, known as exactly as is asked for.
/// Invariant: a dyadic number that is the root, or an open dyadic interval with this simple root of a polynomial in it,
/// no other, and none at its ends.
class Real_root {
 public:
  /// The number num / 2^k itself.
  Real_root(Integer num, int k) : lower_(num), upper_(std::move(num)), k_(k) {}
  /// The root of p in (num / 2^k, (num + 1) / 2^k).
  Real_root(std::shared_ptr<const Univariate> p, const Integer& num, int k)
      : Real_root(std::move(p), num, Integer(num + 1), k) {}
  /// The root of p in (lower / 2^k, upper / 2^k). \pre it is a simple one, and no other is there or at its ends
  Real_root(std::shared_ptr<const Univariate> p, Integer lower, Integer upper, int k)
      : p_(std::move(p)), lower_(std::move(lower)), upper_(std::move(upper)), k_(k),
        sign_(sign_at_dyadic(*p_, lower_, k)) {}

  [[nodiscard]] bool is_dyadic() const { return lower_ == upper_; }
  /// A polynomial of which it is a simple root, and the only root in [0,1] within the interval.
  [[nodiscard]] Univariate polynomial() const {
    return is_dyadic() ? primitive_part(Bounding_arcs::polynomial<Integer>({Integer(-lower_), power_of_two(k_)})) : *p_;
  }
  [[nodiscard]] Exact_rational lower() const { return fraction(lower_); }
  [[nodiscard]] Exact_rational upper() const { return fraction(upper_); }
  [[nodiscard]] Mpfr_interval enclosure(mpfr_prec_t precision) const {
    const Mpfr_interval low(lower(), precision);
    return is_dyadic() ? low : joined(low, Mpfr_interval(upper(), precision));
  }
  /// A precision at which rounding is no matter beside the width of the interval.
  [[nodiscard]] mpfr_prec_t precision() const { return k_ + SPARE_BITS; }

  /// Halves the interval, `times` times or until the root is met.
  void refine(int times = 1) {
    for (; times > 0 && !is_dyadic(); --times) {
      const Integer middle = lower_ + upper_;
      const int s = sign_at_dyadic(*p_, middle, ++k_);
      lower_ = s * sign_ < 0 ? Integer(lower_ * 2) : middle;
      upper_ = s * sign_ > 0 ? Integer(upper_ * 2) : middle;
    }
  }

  /// Refines until the interval is no wider than 2^-bits.
  void refine_to(int bits) { refine(bits - k_); }

  /// Refines until another root, a dyadic one that this one is not, is neither within the interval nor at its ends.
  void separate(const Real_root& dyadic) {
    while (lower() <= dyadic.lower() && dyadic.lower() <= upper()) refine();
  }

  /// Whether the polynomial is zero at the root.
  [[nodiscard]] bool is_root_of(const Univariate& q) const {
    if (q.is_zero()) return true;
    if (is_dyadic()) return sign_at_dyadic(q, lower_, k_) == 0;
    const Univariate common = CGAL::gcd(*p_, q);
    return common.degree() > 0 && sign_at_dyadic(common, lower_, k_) != sign_at_dyadic(common, upper_, k_);
  }

  /// The value of q, enclosed as tightly as the interval allows.
  [[nodiscard]] Mpfr_interval value(const Univariate& q) const {
    const mpfr_prec_t bits = precision();
    const Mpfr_interval t = enclosure(bits);
    Mpfr_interval r(Exact_rational(q.lcoeff()), bits);
    for (int i = q.degree() - 1; i >= 0; --i) r = r * t + Mpfr_interval(Exact_rational(coefficient(q, i)), bits);
    return r;
  }

  /// \pre the root is dyadic
  [[nodiscard]] Exact_rational exact_value(const Univariate& q) const {
    CGAL_precondition(is_dyadic());
    return value_at(q, lower());
  }

  /// The sign of q at the root. \param is_nonzero saves the test for zero
  [[nodiscard]] int sign_of(const Univariate& q, bool is_nonzero = false) {
    for (bool is_tested = is_nonzero || q.degree() == 0;;) {
      if (is_dyadic()) return sign_at_dyadic(q, lower_, k_);
      if (const int s = value(q).certain_sign()) return s;
      if (k_ < FIRST_BITS) {
        refine_to(FIRST_BITS);
        continue;
      }
      if (q.is_zero() || (!is_tested && is_root_of(q))) return 0;
      is_tested = true;
      refine(k_ / 2);
    }
  }

  /// Which of two roots is the smaller one: -1, 0 or +1.
  [[nodiscard]] int compare(Real_root& other) {
    for (bool is_tested = false;; is_tested = true) {
      if (is_dyadic() && other.is_dyadic()) return static_cast<int>(CGAL::compare(lower(), other.lower()));
      if (upper() <= other.lower()) return -1;
      if (other.upper() <= lower()) return 1;
      if (!is_tested && is_equal(other)) return 0;
      refine(STEP);
      other.refine(STEP);
    }
  }

  /// Compares it with a rational number, as above. \pre it is in [0,1], or beyond the interval
  [[nodiscard]] int compare(const Exact_rational& t) const {
    if (is_dyadic()) return static_cast<int>(CGAL::compare(lower(), t));
    if (t <= lower()) return 1;
    if (t >= upper()) return -1;
    return static_cast<int>(CGAL::sign(value_at(*p_, t))) * sign_;
  }

  /// The doubles next to it on both sides, or the one that it is. \pre it is in [0,1]
  [[nodiscard]] Bracket range() {
    refine_to(DOUBLE_BITS);
    for (;; refine(STEP)) {
      const Bracket r = range_of(enclosure(precision()));
      if (is_dyadic() || (is_narrow(r) && r.lower < r.upper)) return r;
    }
  }

 private:
  static constexpr int SPARE_BITS = 64, STEP = 8, DOUBLE_BITS = 56;
  static constexpr int FIRST_BITS = 40;

  [[nodiscard]] Exact_rational fraction(const Integer& num) const {
    return Exact_rational(num) / Exact_rational(power_of_two(k_));
  }
  // The intervals overlap: a common root of both polynomials in what they share is both of them.
  [[nodiscard]] bool is_equal(const Real_root& other) const {
    if (other.is_dyadic()) return is_within(other) && sign_at_dyadic(*p_, other.lower_, other.k_) == 0;
    if (is_dyadic()) return other.is_equal(*this);
    const Univariate common = CGAL::gcd(*p_, *other.p_);
    if (common.degree() == 0) return false;
    const Real_root& low = lower() < other.lower() ? other : *this;
    const Real_root& high = upper() < other.upper() ? *this : other;
    return sign_at_dyadic(common, low.lower_, low.k_) * sign_at_dyadic(common, high.upper_, high.k_) < 0;
  }
  [[nodiscard]] bool is_within(const Real_root& dyadic) const {
    return lower() < dyadic.lower() && dyadic.lower() < upper();
  }

  std::shared_ptr<const Univariate> p_;
  Integer lower_, upper_;
  int k_ = 0, sign_ = 0;
};

/// The distinct real roots in [0,1] of a polynomial, in rising order; their open intervals are disjoint.
/// \guarantee exact: Descartes' rule of signs in Bernstein's basis, with bisection (Collins and Akritas 1976)
class Unit_isolation {
 public:
  /// \pre p is not zero, and its roots in [0,1] are simple
  explicit Unit_isolation(Univariate p) {
    CGAL_precondition(!p.is_zero());
    if (p.degree() < 1) return;
    split_off(p, Integer(0), 0);
    split_off(p, Integer(1), 0);
    while (const std::optional<Cell> middle = isolate(p)) split_off(p, middle->num, middle->k);
    const std::vector<Real_root> dyadic = roots_;
    const auto shared = std::make_shared<const Univariate>(p);
    for (const Cell& c : cells_) {
      roots_.emplace_back(shared, c.num, c.k);
      for (const Real_root& d : dyadic) roots_.back().separate(d);
    }
    std::sort(roots_.begin(), roots_.end(),
              [](const Real_root& a, const Real_root& b) { return a.lower() + a.upper() < b.lower() + b.upper(); });
  }
  [[nodiscard]] std::vector<Real_root> roots() && { return std::move(roots_); }

 private:
  struct Cell {
    Integer num;
    int k;
  };
  using Bernstein = Bernstein_polynomial<Integer>;

  // A dyadic root is kept as the number that it is, and its factor taken out of p.
  void split_off(Univariate& p, const Integer& num, int k) {
    if (p.degree() < 1 || sign_at_dyadic(p, num, k) != 0) return;
    roots_.emplace_back(num, k);
    p = CGAL::integral_division(p, primitive_part(polynomial<Integer>({Integer(-num), power_of_two(k)})));
  }
  // The cells with one root each, or a dyadic root that has to be taken out first.
  std::optional<Cell> isolate(const Univariate& p) {
    cells_.clear();
    return p.degree() < 1 ? std::nullopt : isolate(to_bernstein(p, p.degree()), {Integer(0), 0});
  }
  std::optional<Cell> isolate(const Bernstein& b, const Cell& cell) {
    const int variations = internal::sign_variations(b).most();
    if (variations == 0) return std::nullopt;
    if (variations == 1) {
      cells_.push_back(cell);
      return std::nullopt;
    }
    const auto [left, right] = b.halves();
    const Cell first{cell.num * 2, cell.k + 1}, second{cell.num * 2 + 1, cell.k + 1};
    if (right.scaled_coefficients().front() == Integer(0)) return second;
    const std::optional<Cell> middle = isolate(left, first);
    return middle ? middle : isolate(right, second);
  }
  std::vector<Cell> cells_;
  std::vector<Real_root> roots_;
};

/// The distinct real roots in [0,1] of any polynomial but zero, in rising order.
[[nodiscard]] inline std::vector<Real_root> unit_roots(const Univariate& p) {
  const Root_multiplicities m = unit_root_multiplicities(p);
  return Unit_isolation(m.simple * m.multiple).roots();
}

}  // namespace CGAL::Bounding_arcs

#endif
