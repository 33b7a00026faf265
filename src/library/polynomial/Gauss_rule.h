// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Integrals over [-1, 1] by 16 nodes (Gauss), and what they miss of functions that are analytic about there.
//
// The ellipse about -1 and 1 with the half axis R has a sum of half axes r = R + sqrt(R^2 - 1).  With |f| <= M in it
// Chebyshev coefficients of f are at most 2 M r^-k (Bernstein, 1912).  Sixteen nodes are exact up to s^31, a term is
// integrated and summed up to 2 at most each:
//   |error| <= sum over k >= 32 of 4 * 2 M r^-k = 8 M r^-32 / (1 - 1 / r).

#ifndef BOUNDING_ARCS_LIBRARY_POLYNOMIAL_GAUSS_RULE_H
#define BOUNDING_ARCS_LIBRARY_POLYNOMIAL_GAUSS_RULE_H

namespace CGAL::Bounding_arcs::internal {

struct Gauss_rule {
  /// x and -x, and the weight of each.
  struct Node {
    double x, weight;
  };
  static constexpr Node NODES[] = {
      {0.9894009349916499326, 0.02715245941175409485}, {0.9445750230732325761, 0.06225352393864789286},
      {0.8656312023878317439, 0.09515851168249278481}, {0.7554044083550030339, 0.1246289712555338721},
      {0.6178762444026437484, 0.1495959888165767321},  {0.4580167776572273863, 0.1691565193950025382},
      {0.2816035507792589132, 0.1826034150449235889},  {0.09501250983763744019, 0.1894506104550684963}};

  /// A half axis R, and at least 8 r^-32 / (1 - 1 / r).
  struct Ellipse {
    double half_axis, missed;
  };
  /// The widest one first.
  static constexpr Ellipse ELLIPSES[] = {{4, 2e-28}, {3, 3.5e-24}, {2, 5.5e-18}, {1.5, 5.5e-13}, {1.25, 3.75e-9}};
};

}  // namespace CGAL::Bounding_arcs::internal

#endif
