// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// How a piece of a Bezier curve crosses the ray from a point to the right, in exact arithmetic.
//
// Seen from the point, signs of x and y are those of X = sum w (P.x - q.x) B and Y = sum w (P.y - q.y) B.  A crossing
// is counted at the height just below the point: upwards 1, downwards -1, so that what touches the ray counts 0, and a
// corner on it once.  If X and Y have no common root, halves are cut until X or Y has one sign on each.

#ifndef BOUNDING_ARCS_LIBRARY_QUERY_EXACT_CROSSINGS_H
#define BOUNDING_ARCS_LIBRARY_QUERY_EXACT_CROSSINGS_H

#include <CGAL/Bounding_arcs_2/curve/Bezier_curve_2.h>
#include "../polynomial/common_roots.h"

namespace CGAL::Bounding_arcs {

/// A point with rational coordinates.
using Exact_point = Xy<Exact_rational>;

/// The curve over [0, 1] as seen from a point, times its weight.
struct Seen_curve {
  Exact_polynomial x, y;
};
/// Returns a curve as it is seen from a point.
[[nodiscard]] Seen_curve seen_from(const Exact_point& q, const Bezier_curve_2<Exact_rational>& curve);
/// Returns the part of a seen curve between two parameters.
[[nodiscard]] Seen_curve restricted(const Seen_curve& c, const Exact_rational& t0, const Exact_rational& t1);

/// Counts the crossings of a seen curve. \pre x and y have no common root
[[nodiscard]] int crossings(const Seen_curve& c);

/// How a way crosses the ray from a point.
struct Exact_crossings {
  int number = 0;   ///< of what does not run through the point
  int passing = 0;  ///< how a curve rises that does
  bool is_on = false;
};
/// Counts the crossings of the way from a to the curve's point at t0, along the curve to t1 and from there to b.
/// A curve through q is counted in `passing` alone. \pre for that: y is monotone between t0 and t1
/// \guarantee exact
[[nodiscard]] Exact_crossings exact_crossings(const Exact_point& q, const Bezier_curve_2<Exact_rational>& curve,
                                              double t0, double t1, const Exact_point& a, const Exact_point& b);

}  // namespace CGAL::Bounding_arcs

#endif
