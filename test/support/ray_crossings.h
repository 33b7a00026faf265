// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// How a piece crosses a horizontal ray, by exact roots: what searches for winding numbers are compared with.

#ifndef BOUNDING_ARCS_TEST_RAY_CROSSINGS_H
#define BOUNDING_ARCS_TEST_RAY_CROSSINGS_H

#include "../../src/library/query/exact_intersections.h"

namespace bounding_arcs_test {

/// How a piece crosses a ray, and whether it holds the ray's origin.
struct Ray_crossings {
  int winding = 0;     ///< crossings upwards less crossings downwards
  bool is_on = false;  ///< then winding is of no use
};

/// Crossings with the ray from q to x = +infinity. Points at the ray's height count as below it, ends of the piece as
/// others: as if the ray was higher by less than any number. So the sum over a closed chain of pieces none of which
/// holds q is the winding number of the chain around q.
inline Ray_crossings exact_ray_crossings(const CGAL::Bounding_arcs::Bezier_curve_2<CGAL::Exact_rational>& a,
                                         const CGAL::Bounding_arcs::Xy<CGAL::Exact_rational>& q) {
  namespace ba = CGAL::Bounding_arcs;
  const ba::Integer_piece p(a);
  const ba::Univariate x = ba::moved(p.x, p.w, q.x), y = ba::moved(p.y, p.w, q.y);
  Ray_crossings r;
  if (y.is_zero()) {
    r.is_on = x.is_zero() || !ba::unit_roots(x).empty();
    return r;
  }
  // an end at the ray's height counts as below it, as does what is beyond
  for (ba::Exact_zero& zero : ba::exact_zeros(y)) {
    const int side = zero.t.sign_of(x);
    if (side == 0) r.is_on = true;
    if (side > 0) r.winding += (zero.sign_behind - zero.sign_before) / 2;
  }
  return r;
}

}  // namespace bounding_arcs_test

#endif
