// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Whether two polynomials with exact coefficients have a root in common in [0, 1].

#ifndef BOUNDING_ARCS_LIBRARY_POLYNOMIAL_COMMON_ROOTS_H
#define BOUNDING_ARCS_LIBRARY_POLYNOMIAL_COMMON_ROOTS_H

#include <CGAL/Bounding_arcs_2/number/Exact_number.h>
#include <CGAL/Bounding_arcs_2/polynomial/Bernstein_polynomial.h>

namespace CGAL::Bounding_arcs {

using Exact_polynomial = Bernstein_polynomial<Exact_rational>;

/// \return true, too, where both vanish everywhere
/// \guarantee exact
/// \complexity cubic in the degree, and halvings as many as bits tell neighbouring roots apart
[[nodiscard]] bool have_common_root(const Exact_polynomial& a, const Exact_polynomial& b);

}  // namespace CGAL::Bounding_arcs

#endif
