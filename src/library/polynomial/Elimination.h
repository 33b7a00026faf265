// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The resultant of two polynomials in two variables, and the common root over each of its simple places.
// For every t with resultant(t) = 0 and denominator(t) != 0 there is one common root s = numerator(t) / denominator(t).

#ifndef BOUNDING_ARCS_LIBRARY_POLYNOMIAL_ELIMINATION_H
#define BOUNDING_ARCS_LIBRARY_POLYNOMIAL_ELIMINATION_H

#include "Integer_polynomial.h"

#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL::Bounding_arcs {

/// The determinant of Bezout's matrix of f and g in s, which are taken as of one degree, the larger one: zero where
/// they have a common root, at infinity perhaps, as often as the multiplicities of their common zeros there add up to.
/// The null vector of the matrix is (1, s, s^2, ...) at a single common root, so two minors of a row are in the ratio
/// of 1 and s; both are zero at several common roots, or at one at infinity.
struct Elimination {
  Univariate resultant, numerator, denominator;
};

/// Bezout's matrices at single places t, and the polynomials from the minors there.
/// \source Bareiss 1968 for the minors, Newton's divided differences, which are integers at integer places
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

#endif
