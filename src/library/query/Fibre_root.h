// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// One root s of a fibre over a real root t: a polynomial in s whose coefficients are algebraic numbers.
// Invariant: a dyadic number that is the root, or an open dyadic interval with no other root in it.

#ifndef BOUNDING_ARCS_LIBRARY_QUERY_FIBRE_ROOT_H
#define BOUNDING_ARCS_LIBRARY_QUERY_FIBRE_ROOT_H

#include <CGAL/Bounding_arcs_2/polynomial/Bernstein_polynomial.h>
#include "../polynomial/Real_root.h"
#include "Fibre.h"

#include <memory>
#include <utility>
#include <vector>

namespace CGAL::Bounding_arcs::internal {

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
    const Bivariate by_t = transposed(h);
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
