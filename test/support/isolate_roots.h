// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// All distinct roots of a polynomial with exact coefficients in (0,1), each as the nearest double.

#ifndef BOUNDING_ARCS_TEST_ISOLATE_ROOTS_H
#define BOUNDING_ARCS_TEST_ISOLATE_ROOTS_H

#include <CGAL/Bounding_arcs_2/number/Double_double.h>
#include <CGAL/Bounding_arcs_2/polynomial/Bernstein_polynomial.h>
#include <CGAL/Bounding_arcs_2/polynomial/Root_isolator.h>

#include <CGAL/FPU.h>

#include <vector>

namespace bounding_arcs_test {

using namespace CGAL::Bounding_arcs;

/// A polynomial given once and for all by exact coefficients.
template <class Exact> class Exact_coefficients {
 public:
  using Ring = Exact;

  explicit Exact_coefficients(const Bernstein_polynomial<Exact>& p) : exact_(p) {
    std::vector<Double_double> c;
    for (const Exact& x : p.scaled_coefficients()) c.push_back(to_double_double(x));
    fine_ = Bernstein_polynomial<Double_double>::from_scaled(std::move(c));
  }

  Bernstein_polynomial<Unprotected_interval> enclosure() const {
    std::vector<Unprotected_interval> c;
    for (const Double_double& x : fine_.scaled_coefficients()) c.push_back(CGAL::Bounding_arcs::enclosure(x));
    return Bernstein_polynomial<Unprotected_interval>::from_scaled(std::move(c));
  }
  const Bernstein_polynomial<Double_double>& fine() const { return fine_; }
  const Bernstein_polynomial<Exact>& exact() const { return exact_; }

 private:
  const Bernstein_polynomial<Exact>& exact_;
  Bernstein_polynomial<Double_double> fine_;
};

/// The distinct roots in (0,1) of a polynomial over an exact field, each rounded to the nearest double.
/// Distinct roots that round to the same double count once, and roots that round to within 2^-53 of 0 or 1 are left
/// out. A pair of complex roots as close to the real axis as rounding can tell may add one double, never hide a root.
/// \guarantee exact but for that: the number of roots is proven, each is correctly rounded
/// \complexity quadratic in the degree for each level of bisection, about 50 levels only at multiple roots
/// \source Collins and Akritas 1976 in the Bernstein basis; here decided in intervals first
template <class Exact> [[nodiscard]] Unit_roots isolate_roots(const Bernstein_polynomial<Exact>& p) {
  Exact_coefficients<Exact> layered(p);
  return isolate_layered_roots(layered);
}

}  // namespace bounding_arcs_test

#endif
