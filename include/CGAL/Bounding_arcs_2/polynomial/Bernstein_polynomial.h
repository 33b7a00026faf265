// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// A polynomial on [0,1] in the scaled Bernstein basis t^i (1-t)^(n-i), binomial factors kept in the coefficients:
// products are then plain convolutions, and every operation but `coefficient` needs ring arithmetic only.
// Invariant: at least one coefficient. Signs of scaled and of ordinary Bernstein coefficients are the same.

#ifndef CGAL_BOUNDING_ARCS_2_POLYNOMIAL_BERNSTEIN_POLYNOMIAL_H
#define CGAL_BOUNDING_ARCS_2_POLYNOMIAL_BERNSTEIN_POLYNOMIAL_H

#include <CGAL/Bounding_arcs_2/number/strict_math.h>

#include <CGAL/Algebraic_structure_traits.h>
#include <CGAL/number_utils.h>

#include <algorithm>
#include <cstddef>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL::Bounding_arcs {

namespace internal {
/// The binomial coefficients C(n,0) ... C(n,n), computed by additions alone.
template <class NT> [[nodiscard]] std::vector<NT> binomials(int n) {
  std::vector<NT> row(static_cast<std::size_t>(n) + 1, NT(1));
  for (std::size_t m = 2; m < row.size(); ++m)
    for (std::size_t i = m - 1; i > 0; --i) row[i] = NT(row[i] + row[i - 1]);
  return row;
}

/// How often the signs of a sequence change, some of them perhaps unknown: Descartes' count, between two bounds.
class Sign_variations {
 public:
  int fewest = 0;  ///< of the known signs alone
  int first = 0;   ///< the first known sign, 0 when there is none

  /// Appends +1, -1, or 0 for a number of unknown sign, which may be zero; known zeros are not appended.
  void append(int sign) {
    const int to_plus = std::max(plus_, minus_ + 1), to_minus = std::max(minus_, plus_ + 1);
    plus_ = sign >= 0 ? to_plus : NEVER;
    minus_ = sign <= 0 ? to_minus : NEVER;
    if (sign == 0) return;
    if (last_ == -sign) ++fewest;
    if (first == 0) first = sign;
    last_ = sign;
  }
  /// The most variations over all choices of the unknown signs.
  [[nodiscard]] int most() const { return std::max({plus_, minus_, 0}); }

 private:
  static constexpr int NEVER = -1000000;  // below any count, and no overflow on the way up
  int plus_ = -1, minus_ = -1;            // the most variations of a choice so far that ends in + or in -
  int last_ = 0;
};
}  // namespace internal

/// The polynomial sum c_i t^i (1-t)^(n-i), n the formal degree.
/// NT is a ring; over intervals or numbers with error bounds every result encloses the exact one.
template <class NT> class Bernstein_polynomial {
  using Category = typename Algebraic_structure_traits<NT>::Algebraic_category;
  static constexpr bool IS_FIELD = std::is_convertible_v<Category, Field_tag>;

 public:
  using Number_type = NT;
  using Coefficients = std::vector<NT>;

  /// The zero polynomial of degree 0.
  Bernstein_polynomial() : c_(1, NT(0)) {}

  /// Makes a polynomial from ordinary Bernstein coefficients; none gives the zero polynomial.
  explicit Bernstein_polynomial(Coefficients bernstein) : c_(std::move(bernstein)) {
    if (c_.empty()) c_.assign(1, NT(0));
    if (c_.size() < 3) return;
    const Coefficients factors = internal::binomials<NT>(degree());
    for (std::size_t i = 1; i + 1 < c_.size(); ++i) c_[i] = NT(c_[i] * factors[i]);
  }

  /// Makes a polynomial from scaled coefficients c_i = C(n,i) b_i, at least one.
  [[nodiscard]] static Bernstein_polynomial from_scaled(Coefficients scaled) {
    Bernstein_polynomial p;
    p.c_ = std::move(scaled);
    return p;
  }

  /// The formal degree; leading terms may cancel.
  [[nodiscard]] int degree() const { return static_cast<int>(c_.size()) - 1; }
  [[nodiscard]] const Coefficients& scaled_coefficients() const { return c_; }
  /// The i-th ordinary Bernstein coefficient; NT must be a field.
  [[nodiscard]] NT coefficient(int i) const {
    const auto k = static_cast<std::size_t>(i);
    return NT(c_[k] / internal::binomials<NT>(degree())[k]);
  }

  /// sum c_i t^i s^(n-i): the value at t when s = 1 - t, a positive multiple of the value at t/(t+s) when t + s > 0.
  [[nodiscard]] NT homogeneous_value(const NT& t, const NT& s) const {
    NT value = c_.back(), power(1);
    for (std::size_t i = c_.size() - 1; i-- > 0;) {
      power = NT(power * s);
      value = NT(value * t + c_[i] * power);
    }
    return value;
  }
  [[nodiscard]] NT operator()(const NT& t) const { return homogeneous_value(t, NT(NT(1) - t)); }

  friend Bernstein_polynomial operator*(const Bernstein_polynomial& p, const Bernstein_polynomial& q) {
    Coefficients c(p.c_.size() + q.c_.size() - 1, NT(0));
    for (std::size_t i = 0; i < p.c_.size(); ++i)
      for (std::size_t j = 0; j < q.c_.size(); ++j) c[i + j] = NT(c[i + j] + p.c_[i] * q.c_[j]);
    return from_scaled(std::move(c));
  }
  friend Bernstein_polynomial operator*(const NT& s, Bernstein_polynomial p) {
    for (NT& c : p.c_) c = NT(s * c);
    return p;
  }
  /// Sum and difference; the operand of lower degree is elevated.
  friend Bernstein_polynomial operator+(Bernstein_polynomial p, Bernstein_polynomial q) {
    equalize(p, q);
    for (std::size_t i = 0; i < p.c_.size(); ++i) p.c_[i] = NT(p.c_[i] + q.c_[i]);
    return p;
  }
  friend Bernstein_polynomial operator-(Bernstein_polynomial p, Bernstein_polynomial q) {
    equalize(p, q);
    for (std::size_t i = 0; i < p.c_.size(); ++i) p.c_[i] = NT(p.c_[i] - q.c_[i]);
    return p;
  }

  /// Returns the polynomial with its formal degree raised to `degree`, not below the present one.
  [[nodiscard]] Bernstein_polynomial elevated(int degree) const {
    Coefficients c = c_;
    while (static_cast<int>(c.size()) <= degree) {
      c.push_back(c.back());
      for (std::size_t i = c.size() - 2; i > 0; --i) c[i] = NT(c[i] + c[i - 1]);
    }
    return from_scaled(std::move(c));
  }

  /// The derivative by t.
  [[nodiscard]] Bernstein_polynomial derivative() const {
    const int n = degree();
    if (n == 0) return {};
    Coefficients d(c_.size() - 1, NT(0));
    for (int i = 0; i < n; ++i) {
      const auto k = static_cast<std::size_t>(i);
      d[k] = NT(NT(i + 1) * c_[k + 1] - NT(n - i) * c_[k]);
    }
    return from_scaled(std::move(d));
  }

  /// The polynomials over [0,1/2] and [1/2,1], each on [0,1] again: de Casteljau's algorithm in the scaled basis.
  /// In scaled coefficients each is a Taylor shift by one. Over a ring without division both come multiplied by 2^n.
  /// \complexity quadratic in the degree, additions but for linearly many multiplications
  [[nodiscard]] std::pair<Bernstein_polynomial, Bernstein_polynomial> halves() const {
    Coefficients left(c_.rbegin(), c_.rend()), right(c_);
    shift_by_one(left);
    shift_by_one(right);
    scale_by_powers_of_two(left);
    scale_by_powers_of_two(right);
    return {from_scaled(Coefficients(left.rbegin(), left.rend())), from_scaled(std::move(right))};
  }

  /// The polynomial over the interval with ends t0/(t0+s0) < t1/(t1+s1), on [0,1] again; multiplied by the n-th power
  /// of t0 + s0, which must equal t1 + s1.
  [[nodiscard]] Bernstein_polynomial restricted(const NT& t0, const NT& s0, const NT& t1, const NT& s1) const {
    Coefficients value{c_.back()}, power{NT(1)};
    for (std::size_t i = c_.size() - 1; i-- > 0;) {
      power = times_linear(power, s0, s1);
      value = times_linear(value, t0, t1);
      for (std::size_t k = 0; k < power.size(); ++k) value[k] = NT(value[k] + c_[i] * power[k]);
    }
    return from_scaled(std::move(value));
  }

 private:
  static void equalize(Bernstein_polynomial& p, Bernstein_polynomial& q) {
    if (p.degree() < q.degree()) p = p.elevated(q.degree());
    if (q.degree() < p.degree()) q = q.elevated(p.degree());
  }
  // c(z) becomes c(z + 1), c in powers of z.
  static void shift_by_one(Coefficients& c) {
    const std::size_t n = c.size() - 1;
    for (std::size_t i = 0; i < n; ++i)
      for (std::size_t j = n; j-- > i;) c[j] = NT(c[j] + c[j + 1]);
  }
  // c[j] becomes 2^j c[j], in a field divided by 2^n so that sizes stay put.
  static void scale_by_powers_of_two(Coefficients& c) {
    NT factor(1);
    if constexpr (IS_FIELD) {
      const NT half = NT(NT(1) / NT(2));
      for (std::size_t j = c.size(); j-- > 0; factor = NT(factor * half)) c[j] = NT(c[j] * factor);
    } else {
      for (std::size_t j = 0; j < c.size(); ++j, factor = NT(factor + factor)) c[j] = NT(c[j] * factor);
    }
  }
  // The product with a0 v + a1 u, u and v the parameter and its complement.
  static Coefficients times_linear(const Coefficients& c, const NT& a0, const NT& a1) {
    Coefficients r(c.size() + 1, NT(0));
    for (std::size_t k = 0; k < c.size(); ++k) {
      r[k] = NT(r[k] + a0 * c[k]);
      r[k + 1] = NT(a1 * c[k]);
    }
    return r;
  }
  Coefficients c_;
};

namespace internal {
/// The sign variations of the coefficients, at least the number of roots in (0,1) with multiplicity and of its parity;
/// NT has exact signs.
template <class NT> [[nodiscard]] Sign_variations sign_variations(const Bernstein_polynomial<NT>& p) {
  Sign_variations v;
  for (const NT& c : p.scaled_coefficients())
    if (const int s = static_cast<int>(CGAL::sign(c))) v.append(s);
  return v;
}
}  // namespace internal

}  // namespace CGAL::Bounding_arcs

#endif
