// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Proofs that a polynomial keeps one sign on an interval, from the signs of its Bernstein coefficients.

#ifndef CGAL_BOUNDING_ARCS_2_VERIFY_SIGN_ON_INTERVAL_H
#define CGAL_BOUNDING_ARCS_2_VERIFY_SIGN_ON_INTERVAL_H

#include <CGAL/Bounding_arcs_2/internal/Mpfr_interval.h>
#include <CGAL/Bounding_arcs_2/internal/number_types.h>

#include <cstddef>
#include <vector>

namespace CGAL::Bounding_arcs::verify {

/// Coefficients in the power basis, the constant one first.
template <class NT> using Power_polynomial = std::vector<NT>;

enum class Proof { PROVEN, DISPROVED, UNDECIDED };

[[nodiscard]] inline int certain_sign(const CGAL::Exact_rational& x) { return internal::sign_of(x); }
[[nodiscard]] inline int certain_sign(const Mpfr_interval& x) { return x.certain_sign(); }

template <class NT>
[[nodiscard]] Power_polynomial<NT> product(const Power_polynomial<NT>& p, const Power_polynomial<NT>& q) {
  if (p.empty() || q.empty()) return {};
  Power_polynomial<NT> r(p.size() + q.size() - 1, NT(0));
  for (std::size_t i = 0; i < p.size(); ++i)
    for (std::size_t j = 0; j < q.size(); ++j) r[i + j] = NT(r[i + j] + p[i] * q[j]);
  return r;
}

/// Bernstein coefficients over [0, 1] of a polynomial in the power basis.
template <class NT> [[nodiscard]] std::vector<NT> bernstein_coefficients(Power_polynomial<NT> p) {
  const std::size_t n = p.size() - 1;
  // b_i = sum_k binomial(i, k) / binomial(n, k) p_k
  int k_of_n = 1;
  std::vector<NT> scaled;
  NT binomial(1);
  for (std::size_t k = 0; k <= n; ++k) {
    scaled.push_back(NT(p[k] / binomial));
    binomial = NT(binomial * NT(static_cast<int>(n - k)) / NT(k_of_n++));
    if (k == n) break;
  }
  for (std::size_t level = 1; level <= n; ++level)
    for (std::size_t i = n; i >= level; --i) scaled[i] = NT(scaled[i] + scaled[i - 1]);
  return scaled;
}

/// Whether all of a Bernstein polynomial's values on [0, 1] have the sign given, 0 at the two ends not allowed.
/// \param depth how often to halve before giving up
template <class NT> [[nodiscard]] Proof prove_sign_bernstein(const std::vector<NT>& b, int sign, int depth) {
  const int first = certain_sign(b.front()), last = certain_sign(b.back());
  if (first == -sign || last == -sign) return Proof::DISPROVED;
  bool all = true;
  for (const NT& c : b) all = all && certain_sign(c) == sign;
  if (all) return Proof::PROVEN;
  if (depth == 0 || first != sign || last != sign) return Proof::UNDECIDED;
  std::vector<NT> left{b.front()}, right = b;
  for (std::size_t n = b.size() - 1; n > 0; --n) {
    for (std::size_t i = 0; i < n; ++i) right[i] = NT((right[i] + right[i + 1]) / NT(2));
    left.push_back(right[0]);
  }
  const Proof head = prove_sign_bernstein(left, sign, depth - 1);
  return head == Proof::PROVEN ? prove_sign_bernstein(right, sign, depth - 1) : head;
}

/// p(low + (high - low) x) as a polynomial in x, by Horner's scheme on linear forms.
template <class NT>
[[nodiscard]] Power_polynomial<NT> on_interval(const Power_polynomial<NT>& p, const NT& low, const NT& high) {
  Power_polynomial<NT> r{p.back()};
  const Power_polynomial<NT> map{low, NT(high - low)};
  for (std::size_t k = p.size() - 1; k-- > 0;) {
    r = product(r, map);
    r[0] = NT(r[0] + p[k]);
  }
  return r;
}

/// Whether p has the sign given everywhere on [low, high].
template <class NT>
[[nodiscard]] Proof prove_sign(const Power_polynomial<NT>& p, int sign, const NT& low, const NT& high) {
  constexpr int DEPTH = 30;  // a sign that needs finer halves is as good as a root
  return prove_sign_bernstein(bernstein_coefficients(on_interval(p, low, high)), sign, DEPTH);
}

template <class NT> [[nodiscard]] NT value_at(const Power_polynomial<NT>& p, const NT& x) {
  NT r = p.back();
  for (std::size_t k = p.size() - 1; k-- > 0;) r = NT(r * x + p[k]);
  return r;
}

}  // namespace CGAL::Bounding_arcs::verify

#endif
