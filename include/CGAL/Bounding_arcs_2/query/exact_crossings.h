// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// How a piece of a Bezier curve crosses the ray from a point to the right, in exact arithmetic.
//
// Seen from the point, signs of x and y are those of X = sum w (P.x - q.x) B and Y = sum w (P.y - q.y) B.  A crossing
// is counted at the height just below the point: upwards 1, downwards -1, so that what touches the ray counts 0, and a
// corner on it once.  If X and Y have no common root, halves are cut until X or Y has one sign on each.

#ifndef CGAL_BOUNDING_ARCS_2_QUERY_EXACT_CROSSINGS_H
#define CGAL_BOUNDING_ARCS_2_QUERY_EXACT_CROSSINGS_H

#include <CGAL/Bounding_arcs_2/curve/Bezier_curve_2.h>
#include <CGAL/Bounding_arcs_2/polynomial/common_roots.h>

#include <CGAL/number_utils.h>

#include <algorithm>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL::Bounding_arcs {

/// A point with rational coordinates.
using Exact_point = Xy<Exact_rational>;

/// The curve over [0, 1] as seen from a point, times its weight.
struct Seen_curve {
  Exact_polynomial x, y;
};
/// Returns a curve as it is seen from a point.
[[nodiscard]] inline Seen_curve seen_from(const Exact_point& q, const Bezier_curve_2<Exact_rational>& curve) {
  Exact_polynomial::Coefficients x, y;
  for (std::size_t i = 0; i < curve.control_points().size(); ++i) {
    const Exact_point way = curve.control_points()[i] - q;
    const Exact_rational weight = curve.weight(static_cast<int>(i));
    x.push_back(Exact_rational(weight * way.x));
    y.push_back(Exact_rational(weight * way.y));
  }
  return {Exact_polynomial(std::move(x)), Exact_polynomial(std::move(y))};
}
/// Returns the part of a seen curve between two parameters.
[[nodiscard]] inline Seen_curve restricted(const Seen_curve& c, const Exact_rational& t0, const Exact_rational& t1) {
  const Exact_rational s0 = Exact_rational(1 - t0), s1 = Exact_rational(1 - t1);
  return {c.x.restricted(t0, s0, t1, s1), c.y.restricted(t0, s0, t1, s1)};
}

/// Returns 1 from below the point to its height or above it, -1 the other way round.
[[nodiscard]] inline int rise(const Exact_rational& from_y, const Exact_rational& to_y) {
  return static_cast<int>(from_y < 0) - static_cast<int>(to_y < 0);
}

/// Counts the crossings of a seen curve. \pre x and y have no common root
[[nodiscard]] inline int crossings(const Seen_curve& c) {
  const auto &x = c.x.scaled_coefficients(), &y = c.y.scaled_coefficients();
  const auto is_negative = [](const Exact_rational& v) { return CGAL::is_negative(v); };
  const auto is_positive = [](const Exact_rational& v) { return CGAL::is_positive(v); };
  if (std::none_of(y.begin(), y.end(), is_negative) || std::all_of(y.begin(), y.end(), is_negative)) return 0;
  if (std::none_of(x.begin(), x.end(), is_positive)) return 0;
  if (std::none_of(x.begin(), x.end(), is_negative)) return rise(y.front(), y.back());
  const auto xs = c.x.halves(), ys = c.y.halves();
  return crossings({xs.first, ys.first}) + crossings({xs.second, ys.second});
}

/// Counts the crossings of a segment; from b to a as many, with the other sign, even where it runs through the point.
[[nodiscard]] inline int segment_crossings(const Exact_point& q, const Exact_point& a, const Exact_point& b) {
  const Exact_point u = a - q, v = b - q;
  const int way = rise(u.y, v.y);
  return way != 0 && static_cast<int>(CGAL::sign(cross(u, v))) == way ? way : 0;
}

/// How a way crosses the ray from a point.
struct Exact_crossings {
  int number = 0;   ///< of what does not run through the point
  int passing = 0;  ///< how a curve rises that does
  bool is_on = false;
};
/// Counts the crossings of the way from a to the curve's point at t0, along the curve to t1 and from there to b.
/// A curve through q is counted in `passing` alone. \pre for that: y is monotone between t0 and t1
/// \guarantee exact
[[nodiscard]] inline Exact_crossings exact_crossings(const Exact_point& q, const Bezier_curve_2<Exact_rational>& curve,
                                                     double t0, double t1, const Exact_point& a, const Exact_point& b) {
  const Exact_rational first(t0), last(t1);
  const Seen_curve seen = restricted(seen_from(q, curve), first, last);
  Exact_crossings r;
  r.is_on = have_common_root(seen.x, seen.y);
  r.number = segment_crossings(q, a, curve.point(first)) + segment_crossings(q, curve.point(last), b);
  if (r.is_on) r.passing = rise(seen.y.scaled_coefficients().front(), seen.y.scaled_coefficients().back());
  else r.number += crossings(seen);
  return r;
}

}  // namespace CGAL::Bounding_arcs

#endif
