// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "common_roots.h"

#include "Real_root.h"

#include <CGAL/polynomial_utils.h>

namespace CGAL::Bounding_arcs {

bool have_common_root(const Exact_polynomial& a, const Exact_polynomial& b) {
  const Univariate divisor = CGAL::gcd(to_powers(a), to_powers(b));
  return divisor.is_zero() || !unit_roots(divisor).empty();
}

}  // namespace CGAL::Bounding_arcs
