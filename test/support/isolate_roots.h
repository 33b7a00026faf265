// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// All distinct roots of a polynomial with exact coefficients in (0,1), each as the nearest double.

#ifndef BOUNDING_ARCS_TEST_ISOLATE_ROOTS_H
#define BOUNDING_ARCS_TEST_ISOLATE_ROOTS_H

#include "../../src/library/polynomial/Root_isolator.h"

#include <CGAL/Bounding_arcs_2/number/Double_double.h>
#include <CGAL/Bounding_arcs_2/polynomial/Bernstein_polynomial.h>

#include <CGAL/FPU.h>

#include <vector>

namespace bounding_arcs_test {

using namespace CGAL::Bounding_arcs;

/// The distinct roots in (0,1) of a polynomial over an exact field, each rounded to the nearest double.
/// Distinct roots that round to the same double count once, and roots that round to within 2^-53 of 0 or 1 are left
/// out. A pair of complex roots as close to the real axis as rounding can tell may add one double, never hide a root.
/// \guarantee exact but for that: the number of roots is proven, each is correctly rounded
/// \complexity quadratic in the degree for each level of bisection, about 50 levels only at multiple roots
/// \source Collins and Akritas 1976 in the Bernstein basis; here decided in intervals first
template <class Exact> [[nodiscard]] auto isolate_roots(const Bernstein_polynomial<Exact>& p) {
  std::vector<Double_double> fine;
  for (const Exact& x : p.scaled_coefficients()) fine.push_back(to_double_double(x));
  const auto enclosure = [&fine] {
    std::vector<internal::Unprotected_interval> c;
    for (const Double_double& x : fine) c.push_back(internal::enclosure(x));
    return Bernstein_polynomial<internal::Unprotected_interval>::from_scaled(std::move(c));
  };
  return internal::isolate_roots({enclosure, [&] { return Bernstein_polynomial<Double_double>::from_scaled(fine); },
                                  [&] { return internal::Root_oracle(p); }});
}

}  // namespace bounding_arcs_test

#endif
