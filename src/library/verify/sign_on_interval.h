// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Proofs that a polynomial is nowhere negative on [0, 1], from the signs of its Bernstein coefficients: over exact
// rings, double-doubles and intervals.

#ifndef BOUNDING_ARCS_LIBRARY_VERIFY_SIGN_ON_INTERVAL_H
#define BOUNDING_ARCS_LIBRARY_VERIFY_SIGN_ON_INTERVAL_H

#include <CGAL/Bounding_arcs_2/number/Double_double.h>
#include <CGAL/Bounding_arcs_2/number/Mpfr_interval.h>
#include <CGAL/Bounding_arcs_2/polynomial/Bernstein_polynomial.h>

#include <CGAL/number_utils.h>

#include <algorithm>
#include <optional>

namespace CGAL::Bounding_arcs::verify {

/// What came of a proof.
enum class Proof { PROVEN, DISPROVED, UNDECIDED };

/// -1, 0 or +1, or nothing where errors leave it open.
template <class Exact> [[nodiscard]] std::optional<int> certain_sign(const Exact& x) {
  return static_cast<int>(CGAL::sign(x));
}
[[nodiscard]] inline std::optional<int> certain_sign(const Double_double& x) { return x.sign(); }
[[nodiscard]] inline std::optional<int> certain_sign(const Mpfr_interval& x) {
  const int sign = x.certain_sign();
  return sign != 0 ? std::optional<int>(sign) : std::nullopt;
}

/// Whether p >= 0 on all of [0, 1].
/// \param depth how often to halve before giving up: a sign that needs finer parts than that is as good as a root
template <class NT> [[nodiscard]] Proof prove_nonnegative(const Bernstein_polynomial<NT>& p, int depth = 30) {
  const auto& c = p.scaled_coefficients();
  const auto is_nonnegative = [](const NT& x) { return certain_sign(x).value_or(-1) >= 0; };
  if (certain_sign(c.front()) == -1 || certain_sign(c.back()) == -1) return Proof::DISPROVED;
  if (std::all_of(c.begin(), c.end(), is_nonnegative)) return Proof::PROVEN;
  if (depth == 0 || !is_nonnegative(c.front()) || !is_nonnegative(c.back())) return Proof::UNDECIDED;
  const auto halves = p.halves();
  const Proof head = prove_nonnegative(halves.first, depth - 1);
  return head == Proof::PROVEN ? prove_nonnegative(halves.second, depth - 1) : head;
}

}  // namespace CGAL::Bounding_arcs::verify

#endif
