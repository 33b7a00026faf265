// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The common zeros in [0,1]^2 of two polynomials in two variables without a common factor.

#ifndef BOUNDING_ARCS_LIBRARY_QUERY_COMMON_ZEROS_H
#define BOUNDING_ARCS_LIBRARY_QUERY_COMMON_ZEROS_H

#include "Fibre.h"
#include "exact_intersections.h"

#include <CGAL/Bounding_arcs_2/query/Intersections_2.h>
#include "../polynomial/Integer_polynomial.h"
#include "../polynomial/Real_root.h"

#include <algorithm>
#include <cstddef>
#include <utility>
#include <vector>

// The resultant of two polynomials in two variables, and the common root over each of its simple places.
// For every t with resultant(t) = 0 and denominator(t) != 0 there is one common root s = numerator(t) / denominator(t).

namespace CGAL::Bounding_arcs {

/// The determinant of Bezout's matrix of f and g in s, which are taken as of one degree, the larger one: zero where
/// they have a common root, at infinity perhaps, as often as the multiplicities of their common zeros there add up to.
/// The null vector of the matrix is (1, s, s^2, ...) at a single common root, so two minors of a row are in the ratio
/// of 1 and s; both are zero at several common roots, or at one at infinity.
struct Elimination {
  Univariate resultant, numerator, denominator;
};

/// Bezout's matrices at single places t, and the polynomials from the minors there.
/// \source Bareiss 1968 for the minors, Newton's divided differences, which are integers at integer places.
///   CGAL's subresultants are these polynomials, too. They take as long for polynomial curves, but 10 to 28 times as
///   long for rational ones, whose weights they do not divide by
class Eliminator {
 public:
  /// \param divisor divides all entries of Bezout's matrix
  /// \param degree bound of the resultant's degree after division
  Eliminator(const Bivariate& f, const Bivariate& g, const Univariate& divisor, int degree)
      : f_(f), g_(g), n_(static_cast<std::size_t>((std::max)(f.degree(), g.degree()))) {
    for (int i = 0; static_cast<int>(places_.size()) <= degree; ++i) {
      const Integer t(i % 2 == 0 ? i / 2 : -(i + 1) / 2);
      const Integer d = divisor.evaluate(t);
      if (d != Integer(0)) take(t, d);
    }
  }
  /// \complexity n^3 for each of as many places as the degree
  [[nodiscard]] Elimination result() {
    return {interpolated(resultants_), interpolated(numerators_), interpolated(denominators_)};
  }

 private:
  using Row = std::vector<Integer>;
  using Matrix = std::vector<Row>;

  static Row coefficients(const Bivariate& p, const Integer& t, std::size_t n) {
    Row c(n + 1, Integer(0));
    for (int j = 0; j <= p.degree(); ++j) c[static_cast<std::size_t>(j)] = coefficient(p, j).evaluate(t);
    return c;
  }
  // Rows and columns by falling powers of s.
  [[nodiscard]] Matrix bezout(const Integer& t, const Integer& divisor) const {
    const Row f = coefficients(f_, t, n_), g = coefficients(g_, t, n_);
    Matrix b(n_, Row(n_, Integer(0)));
    for (std::size_t i = 0; i < n_; ++i)
      for (std::size_t j = i; j < n_; ++j) {
        Integer sum(0);
        for (std::size_t k = 0; k <= i && j + k + 1 <= n_; ++k) {
          sum += f[j + k + 1] * g[i - k];
          sum -= f[i - k] * g[j + k + 1];
        }
        sum = CGAL::integral_division(sum, divisor);
        b[n_ - 1 - i][n_ - 1 - j] = sum;
        b[n_ - 1 - j][n_ - 1 - i] = sum;
      }
    return b;
  }

  // Eliminates the first `columns` columns by rows before `rows`. Then the entries below and to the right are minors,
  // those of the eliminated rows and columns with one more of each, times the sign returned; 0 when a pivot was
  // missing.
  static int eliminate(Matrix& m, std::size_t columns, std::size_t rows) {
    int sign = 1;
    Integer last(1);
    for (std::size_t k = 0; k < columns; ++k) {
      std::size_t pivot = k;
      while (pivot < rows && m[pivot][k] == Integer(0)) ++pivot;
      if (pivot == rows) return 0;
      if (pivot != k) sign = -sign;
      std::swap(m[pivot], m[k]);
      for (std::size_t i = k + 1; i < m.size(); ++i)
        for (std::size_t j = k + 1; j < m.size(); ++j)
          m[i][j] = CGAL::integral_division(Integer(Integer(m[i][j] * m[k][k]) - Integer(m[i][k] * m[k][j])), last);
      last = m[k][k];
    }
    return sign;
  }

  void take(const Integer& t, const Integer& divisor) {
    Matrix m = bezout(t, divisor);
    const std::size_t n = n_;
    Integer numerator(0), denominator(0), determinant(0);
    // A last step makes the determinant from the minors, whether or not the last pivot is zero.
    Matrix whole = m;
    if (n >= 2) {
      if (const int sign = eliminate(m, n - 2, n - 1)) {
        denominator = Integer(sign) * m[n - 2][n - 2];
        numerator = Integer(-sign) * m[n - 2][n - 1];
      }
    }
    if (const int sign = eliminate(whole, n - 1, n)) determinant = Integer(sign) * whole[n - 1][n - 1];
    places_.push_back(t);
    resultants_.push_back(determinant);
    numerators_.push_back(numerator);
    denominators_.push_back(denominator);
  }

  [[nodiscard]] Univariate interpolated(Row d) const {
    const std::size_t n = d.size();
    for (std::size_t k = 1; k < n; ++k)
      for (std::size_t i = n - 1; i >= k; --i)
        d[i] = CGAL::integral_division(Integer(d[i] - d[i - 1]), Integer(places_[i] - places_[i - k]));
    Row c{d[n - 1]};
    for (std::size_t i = n - 1; i-- > 0;) {
      c.insert(c.begin(), Integer(0));
      for (std::size_t j = 0; j + 1 < c.size(); ++j) c[j] -= places_[i] * c[j + 1];
      c[0] += d[i];
    }
    return polynomial(c);
  }

  const Bivariate &f_, &g_;
  std::size_t n_;
  Row places_, resultants_, numerators_, denominators_;
};

}  // namespace CGAL::Bounding_arcs

namespace CGAL::Bounding_arcs::internal {

/// n(t) / d(t) in doubles at a root where it is within (0,1).
[[nodiscard]] inline Bracket range_of_fraction(Real_root& t, const Univariate& n, const Univariate& d) {
  constexpr int STEP = 16;
  constexpr mpfr_prec_t BITS = 64;
  for (;; t.refine(STEP)) {
    if (t.is_dyadic()) return range_of(Mpfr_interval(t.exact_value(n) / t.exact_value(d), BITS));
    const Bracket r = range_of(t.value(n) / t.value(d));
    if (is_narrow(r)) return r;
  }
}

/// Finds the zeros by elimination of s, and by calculation over the roots t where several s share one.
class Common_zeros {
 public:
  /// \param e what elimination made of f and g
  /// \param excluded zeros on this curve are left out
  /// \param which those with s > t or s < t alone; then those with s = t must be excluded
  Common_zeros(const Bivariate& f, const Bivariate& g, Elimination e, const Bivariate& excluded, Parameter_order which)
      : f_(f), g_(g), e_(std::move(e)), excluded_(excluded), which_(which) {
    const Root_multiplicities m = unit_root_multiplicities(e_.resultant);
    solve(m.simple, Intersection_kind::TRANSVERSAL);
    solve(m.multiple, Intersection_kind::TANGENTIAL);
  }
  [[nodiscard]] std::vector<Exact_meeting>& points() { return points_; }

 private:
  // Over a root t with one common root s the multiplicity of t is that of the zero, which is 1 exactly where the
  // gradients of f and g are independent, and that is where the tangents cross.
  void solve(const Univariate& m, Intersection_kind kind) {
    if (m.degree() < 1) return;
    const Univariate several = common_divisor(m, e_.denominator);
    solve_fibres(square_free(several));
    Univariate single = CGAL::integral_division(m, several);
    (void)split_off(single, at_fraction(excluded_, e_.numerator, e_.denominator));
    add_ends(split_off(single, e_.numerator), 0, kind);
    add_ends(split_off(single, e_.numerator - e_.denominator), 1, kind);
    for (Real_root& t : Unit_isolation(single).roots()) add_inner(t, kind);
  }
  static Univariate split_off(Univariate& m, const Univariate& q) {
    const Univariate common = common_divisor(m, q);
    m = CGAL::integral_division(m, common);
    return common;
  }
  void add_ends(const Univariate& m, double s, Intersection_kind kind) {
    if ((which_ == Parameter_order::RISING && s == 0) || (which_ == Parameter_order::FALLING && s == 1)) return;
    for (const Real_root& t : Unit_isolation(m).roots()) points_.push_back({t, {s, s}, kind});
  }
  // Neither end of [0,1], nor t itself where that matters.
  void add_inner(Real_root& t, Intersection_kind kind) {
    const int sign = t.sign_of(e_.denominator, true);
    const auto is_positive = [&](const Univariate& p) { return t.sign_of(p, true) == sign; };
    if (!is_positive(e_.numerator) || !is_positive(e_.denominator - e_.numerator)) return;
    if (which_ != Parameter_order::ANY &&
        is_positive(e_.numerator - polynomial<Integer>({Integer(0), Integer(1)}) * e_.denominator) !=
            (which_ == Parameter_order::RISING))
      return;
    const Bracket s = range_of_fraction(t, e_.numerator, e_.denominator);
    points_.push_back({t, s, kind});
  }

  void solve_fibres(const Univariate& m) {
    if (m.degree() < 1) return;
    std::vector<Fibre> fibres = divided_by_curve(common_fibres(m, f_, g_), excluded_).off;
    const Bivariate jacobian =
        CGAL::differentiate(f_, 0) * CGAL::differentiate(g_) - CGAL::differentiate(f_) * CGAL::differentiate(g_, 0);
    const Fibre_parts parts = divided_by_curve(fibres, jacobian);
    add_fibres(parts.off, Intersection_kind::TRANSVERSAL);
    add_fibres(parts.on, Intersection_kind::TANGENTIAL);
  }
  void add_fibres(const std::vector<Fibre>& fibres, Intersection_kind kind) {
    for (const Fibre& fibre : fibres)
      for (Real_root t : Unit_isolation(fibre.m).roots())
        for (Fibre_root& s : Fibre_isolation(t, fibre.h).roots())
          if (which_ == Parameter_order::ANY || s.is_greater(t) == (which_ == Parameter_order::RISING))
            points_.push_back({t, s.range(), kind});
  }

  const Bivariate &f_, &g_;
  Elimination e_;
  const Bivariate& excluded_;
  Parameter_order which_;
  std::vector<Exact_meeting> points_;
};

}  // namespace CGAL::Bounding_arcs::internal

#endif
