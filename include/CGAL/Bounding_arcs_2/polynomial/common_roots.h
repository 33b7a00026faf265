// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Whether two polynomials with exact coefficients have a root in common in [0, 1], without finding it.
//
// Scaled Bernstein coefficients are those of powers of z = t / (1 - t), which maps [0, 1) onto [0, infinity): Euclid's
// scheme works on them as they are.  A root at t = 1 shows in the last coefficient.

#ifndef CGAL_BOUNDING_ARCS_2_POLYNOMIAL_COMMON_ROOTS_H
#define CGAL_BOUNDING_ARCS_2_POLYNOMIAL_COMMON_ROOTS_H

#include <CGAL/Bounding_arcs_2/number/Exact_number.h>
#include <CGAL/Bounding_arcs_2/polynomial/Bernstein_polynomial.h>

#include <CGAL/number_utils.h>

#include <algorithm>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL::Bounding_arcs {

using Exact_polynomial = Bernstein_polynomial<Exact_rational>;
using Exact_powers = std::vector<Exact_rational>;  // coefficients of 1, z, z^2, ..., the last one is not 0

[[nodiscard]] inline Exact_powers trimmed(Exact_powers p) {
  while (!p.empty() && CGAL::is_zero(p.back())) p.pop_back();
  return p;
}

/// What a division of polynomials gives.
struct Exact_division {
  Exact_powers quotient, remainder;
};
// \pre q is not 0
[[nodiscard]] inline Exact_division divide(Exact_powers p, const Exact_powers& q) {
  Exact_powers quotient(p.size() < q.size() ? 0 : p.size() - q.size() + 1, Exact_rational(0));
  for (std::size_t k = quotient.size(); k-- > 0;) {
    quotient[k] = Exact_rational(p[k + q.size() - 1] / q.back());
    for (std::size_t i = 0; i < q.size(); ++i) p[k + i] = Exact_rational(p[k + i] - quotient[k] * q[i]);
  }
  return {std::move(quotient), trimmed(std::move(p))};
}

// Up to a factor; made monic at each step, which keeps numbers short.
[[nodiscard]] inline Exact_powers common_divisor(Exact_powers p, Exact_powers q) {
  while (!q.empty()) {
    const Exact_rational last = q.back();
    for (Exact_rational& c : q) c = Exact_rational(c / last);
    Exact_powers rest = divide(std::move(p), q).remainder;
    p = std::exchange(q, std::move(rest));
  }
  return p;
}

// A polynomial with the same roots, each once.
[[nodiscard]] inline Exact_powers square_free(const Exact_powers& p) {
  Exact_powers slope;
  for (std::size_t i = 1; i < p.size(); ++i)
    slope.push_back(Exact_rational(Exact_rational(static_cast<int>(i)) * p[i]));
  const Exact_powers repeated = common_divisor(p, trimmed(std::move(slope)));
  return repeated.size() < 2 ? p : divide(p, repeated).quotient;
}

// Whether a polynomial has a root in [0, 1]. It has no multiple roots, so that halving comes to an end.
[[nodiscard]] inline bool has_root(const Exact_polynomial& p) {
  const auto& c = p.scaled_coefficients();
  if (CGAL::is_zero(c.front()) || CGAL::is_zero(c.back())) return true;
  const int variations = sign_variations(p).most();
  if (variations % 2 == 1) return true;  // as many as roots in (0, 1), or an even number more
  if (variations == 0) return false;
  const auto halves = p.halves();
  return has_root(halves.first) || has_root(halves.second);
}

/// \return true, too, where both vanish everywhere
/// \guarantee exact
/// \complexity cubic in the degree, and halvings as many as bits tell neighbouring roots apart
[[nodiscard]] inline bool have_common_root(const Exact_polynomial& a, const Exact_polynomial& b) {
  const auto &p = a.scaled_coefficients(), &q = b.scaled_coefficients();
  const auto both_zero = [](const Exact_rational& x, const Exact_rational& y) {
    return CGAL::is_zero(x) && CGAL::is_zero(y);
  };
  if (both_zero(p.front(), q.front()) || both_zero(p.back(), q.back())) return true;
  const Exact_powers divisor = common_divisor(trimmed(p), trimmed(q));
  return divisor.size() > 1 && has_root(Exact_polynomial::from_scaled(square_free(divisor)));
}

}  // namespace CGAL::Bounding_arcs

#endif
