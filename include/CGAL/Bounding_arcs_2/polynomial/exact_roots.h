// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// All roots of a polynomial in [0, 1], each between two rational numbers that can be made as near as one likes: for
// questions in which two roots must not be taken for one because they round to the same double.

#ifndef CGAL_BOUNDING_ARCS_2_POLYNOMIAL_EXACT_ROOTS_H
#define CGAL_BOUNDING_ARCS_2_POLYNOMIAL_EXACT_ROOTS_H

#include <CGAL/Bounding_arcs_2/polynomial/common_roots.h>

#include <CGAL/number_utils.h>

#include <algorithm>
#include <cstddef>
#include <vector>

namespace CGAL::Bounding_arcs {

/// One root: in the open range (low, high), or low where both are equal.
struct Root_range {
  Exact_rational low, high;
  int sign = 0;  ///< that of the polynomial at low, or right behind it

  [[nodiscard]] bool is_exact() const { return low == high; }
};

/// \pre the polynomial is not 0
/// \guarantee exact: each root once, in increasing order, in ranges without common points inside
class Exact_roots {
 public:
  explicit Exact_roots(const Exact_polynomial& p) {
    Exact_powers c = trimmed(p.scaled_coefficients());
    const bool has_last = c.size() < p.scaled_coefficients().size();
    const auto begin = std::find_if(c.begin(), c.end(), [](const Exact_rational& x) { return !CGAL::is_zero(x); });
    if (begin != c.begin()) ranges_.push_back({0, 0, 0});
    polynomial_ = Exact_polynomial::from_scaled(square_free(Exact_powers(begin, c.end())));
    isolate(polynomial_, 0, 1);
    if (has_last) ranges_.push_back({1, 1, 0});
  }

  [[nodiscard]] const std::vector<Root_range>& ranges() const { return ranges_; }
  [[nodiscard]] std::vector<Root_range>& ranges() { return ranges_; }

  /// Halves a range.
  void refine(Root_range& r) const {
    if (r.is_exact()) return;
    const Exact_rational middle = Exact_rational((r.low + r.high) / 2);
    const int s = static_cast<int>(CGAL::sign(polynomial_(middle)));
    if (s == 0) r.low = r.high = middle;
    else (s == r.sign ? r.low : r.high) = middle;
  }
  void refine(Root_range& r, const Exact_rational& width) const {
    while (r.high - r.low > width) refine(r);
  }

 private:
  // p over [low, high].
  void isolate(const Exact_polynomial& p, const Exact_rational& low, const Exact_rational& high) {
    const Sign_variations v = sign_variations(p);
    if (v.most() == 0) return;
    if (v.most() == 1) {
      ranges_.push_back({low, high, v.first});
      return;
    }
    const auto halves = p.halves();
    const Exact_rational middle = Exact_rational((low + high) / 2);
    isolate(halves.first, low, middle);
    if (CGAL::is_zero(halves.second.scaled_coefficients().front())) ranges_.push_back({middle, middle, 0});
    isolate(halves.second, middle, high);
  }

  Exact_polynomial polynomial_;  // without multiple roots, and without those at 0 and 1
  std::vector<Root_range> ranges_;
};

/// Bounds of a polynomial over a range: its coefficients there.
struct Value_range {
  Exact_rational low, high;
};
[[nodiscard]] inline Value_range values_over(const Exact_polynomial& p, const Root_range& r) {
  if (r.is_exact()) {
    const Exact_rational v = p(r.low);
    return {v, v};
  }
  const Exact_polynomial part = p.restricted(r.low, Exact_rational(1 - r.low), r.high, Exact_rational(1 - r.high));
  const auto& c = part.scaled_coefficients();
  const auto factors = binomials<Exact_rational>(part.degree());
  Value_range v{c[0], c[0]};
  for (std::size_t i = 1; i < c.size(); ++i) {
    const Exact_rational x = Exact_rational(c[i] / factors[i]);
    v.low = (std::min)(v.low, x);
    v.high = (std::max)(v.high, x);
  }
  return v;
}

}  // namespace CGAL::Bounding_arcs

#endif
