// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// An exact oracle for cuts: the polynomials whose roots cut a curve, in the power basis and straight from their
// definition, and Sturm sequences that count their distinct roots. It shares nothing with the code under test.

#ifndef BOUNDING_ARCS_TEST_STURM_H
#define BOUNDING_ARCS_TEST_STURM_H

#include <CGAL/Bounding_arcs_2/curve/Bezier_curve_2.h>

#include <CGAL/Exact_rational.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <vector>

namespace bounding_arcs_test {

using CGAL::Bounding_arcs::Bezier_curve_2;
using Rational = CGAL::Exact_rational;
using Powers = std::vector<Rational>;  // coefficients of 1, t, t^2, ..., no trailing zeros

inline Powers trimmed(Powers p) {
  while (!p.empty() && p.back() == 0) p.pop_back();
  return p;
}
inline Powers sum(const Powers& p, const Powers& q, const Rational& factor = 1) {
  Powers r(std::max(p.size(), q.size()), Rational(0));
  for (std::size_t i = 0; i < p.size(); ++i) r[i] += p[i];
  for (std::size_t i = 0; i < q.size(); ++i) r[i] += factor * q[i];
  return trimmed(r);
}
inline Powers product(const Powers& p, const Powers& q) {
  if (p.empty() || q.empty()) return {};
  Powers r(p.size() + q.size() - 1, Rational(0));
  for (std::size_t i = 0; i < p.size(); ++i)
    for (std::size_t j = 0; j < q.size(); ++j) r[i + j] += p[i] * q[j];
  return trimmed(r);
}
inline Powers minus(const Powers& p, const Powers& q) { return sum(p, q, -1); }
inline Powers derived(const Powers& p) {
  Powers r;
  for (std::size_t i = 1; i < p.size(); ++i) r.push_back(Rational(static_cast<int>(i)) * p[i]);
  return r;
}
inline Powers from_bernstein(const std::vector<Rational>& b) {
  const int n = static_cast<int>(b.size()) - 1;
  Powers r, basis{1};
  for (int i = 0; i <= n; ++i) {
    Powers term = product(basis, {b[static_cast<std::size_t>(i)]});
    for (int k = i; k < n; ++k) term = product(term, {1, -1});
    r = sum(r, term);
    basis = product(basis, {0, Rational(n - i) / Rational(i + 1)});
  }
  return r;
}
inline Rational value(const Powers& p, const Rational& t) {
  Rational v = 0;
  for (std::size_t i = p.size(); i-- > 0;) v = v * t + p[i];
  return v;
}
inline Powers negative_remainder(Powers p, const Powers& q) {
  while (p.size() >= q.size()) {
    Powers shifted(p.size() - q.size(), Rational(0));
    shifted.insert(shifted.end(), q.begin(), q.end());
    p = sum(p, shifted, -p.back() / q.back());
  }
  if (p.empty()) return p;
  const Rational factor = 1 / (p.back() < 0 ? Rational(-p.back()) : p.back());
  return product(p, {Rational(-factor)});
}

// Distinct roots of a polynomial in half-open intervals.
class Sturm {
 public:
  explicit Sturm(const Powers& p) : chain_{p, derived(p)} {
    while (!chain_.back().empty()) chain_.push_back(negative_remainder(chain_[chain_.size() - 2], chain_.back()));
  }
  int roots(const Rational& a, const Rational& b) const { return changes(a) - changes(b); }

 private:
  int changes(const Rational& t) const {
    int count = 0, last = 0;
    for (const Powers& p : chain_) {
      const int s = static_cast<int>(CGAL::sign(value(p, t)));
      count += s != 0 && last == -s;
      if (s != 0) last = s;
    }
    return count;
  }
  std::vector<Powers> chain_;
};

/// How often a polynomial changes its sign in (a, b), where its ends are not roots.
inline int sign_changes(const Powers& p, const Sturm& roots, const Rational& a, const Rational& b) {
  const int count = roots.roots(a, b);
  if (count == 0) return 0;
  if (count == 1) return CGAL::sign(value(p, a)) == CGAL::sign(value(p, b)) ? 0 : 1;
  Rational middle = (a + b) / 2;
  while (value(p, middle) == 0) middle = (a + middle) / 2;
  return sign_changes(p, roots, a, middle) + sign_changes(p, roots, middle, b);
}
/// Without its roots at 0 and 1: so many times over t and 1 - t.
inline Powers without_end_roots(Powers p) {
  while (!p.empty() && p.front() == 0) p.erase(p.begin());
  while (!p.empty() && value(p, 1) == 0) {
    for (std::size_t i = 1; i < p.size(); ++i) p[i] += p[i - 1];
    p = trimmed(p);
  }
  return p;
}

template <class NT> std::array<Powers, 4> numerators(const Bezier_curve_2<NT>& c) {
  std::vector<Rational> bx, by, bw;
  for (int i = 0; i <= c.degree(); ++i) {
    const auto& p = c.control_points()[static_cast<std::size_t>(i)];
    bw.push_back(Rational(c.weight(i)));
    bx.push_back(bw.back() * Rational(p.x));
    by.push_back(bw.back() * Rational(p.y));
  }
  const Powers x = from_bernstein(bx), y = from_bernstein(by), w = from_bernstein(bw);
  const Powers hx = minus(product(derived(x), w), product(x, derived(w)));
  const Powers hy = minus(product(derived(y), w), product(y, derived(w)));
  const auto determinant = [&](int third) {
    Powers x2 = derived(derived(x)), y2 = derived(derived(y)), w2 = derived(derived(w));
    if (third == 3) x2 = derived(x2), y2 = derived(y2), w2 = derived(w2);
    const Powers a = minus(product(derived(y), w2), product(derived(w), y2));
    const Powers b = minus(product(derived(w), x2), product(derived(x), w2));
    const Powers d = minus(product(derived(x), y2), product(derived(y), x2));
    return sum(sum(product(x, a), product(y, b)), product(w, d));
  };
  const Powers d = determinant(2), q = sum(product(hx, hx), product(hy, hy));
  const Powers change = sum(product(w, determinant(3)), product(product({3}, derived(w)), d));
  const Powers hh = sum(product(hx, derived(hx)), product(hy, derived(hy)));
  return {hx, hy, d, minus(product(change, q), product(product({3}, product(w, d)), hh))};
}

}  // namespace bounding_arcs_test

#endif
