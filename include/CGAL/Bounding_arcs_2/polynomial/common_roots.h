// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Whether two polynomials with exact coefficients have a root in common in [0, 1].

#ifndef CGAL_BOUNDING_ARCS_2_POLYNOMIAL_COMMON_ROOTS_H
#define CGAL_BOUNDING_ARCS_2_POLYNOMIAL_COMMON_ROOTS_H

#include <CGAL/Bounding_arcs_2/polynomial/Bernstein_polynomial.h>
#include <CGAL/Bounding_arcs_2/polynomial/Real_root.h>
#include <CGAL/Bounding_arcs_2/polynomial/proportional_numbers.h>

#include <CGAL/Exact_rational.h>

#include <vector>

namespace CGAL::Bounding_arcs {

using Exact_polynomial = Bernstein_polynomial<Exact_rational>;

/// The coefficients of powers, times a positive number.
[[nodiscard]] inline Univariate to_powers(const Exact_polynomial& p) {
  return to_powers(cleared(p.scaled_coefficients()).numbers);
}

/// \return true, too, where both vanish everywhere
/// \guarantee exact
/// \complexity cubic in the degree, and halvings as many as bits tell neighbouring roots apart
[[nodiscard]] inline bool have_common_root(const Exact_polynomial& a, const Exact_polynomial& b) {
  const Univariate divisor = CGAL::gcd(to_powers(a), to_powers(b));
  return divisor.is_zero() || !unit_roots(divisor).empty();
}

}  // namespace CGAL::Bounding_arcs

#endif
