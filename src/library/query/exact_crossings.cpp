// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "exact_crossings.h"

#include <CGAL/number_utils.h>

#include <algorithm>
#include <cstddef>
#include <utility>

namespace CGAL::Bounding_arcs {

Seen_curve seen_from(const Exact_point& q, const Bezier_curve_2<Exact_rational>& curve) {
  Exact_polynomial::Coefficients x, y;
  for (std::size_t i = 0; i < curve.control_points().size(); ++i) {
    const Exact_point way = curve.control_points()[i] - q;
    const Exact_rational weight = curve.weight(static_cast<int>(i));
    x.push_back(Exact_rational(weight * way.x));
    y.push_back(Exact_rational(weight * way.y));
  }
  return {Exact_polynomial(std::move(x)), Exact_polynomial(std::move(y))};
}
Seen_curve restricted(const Seen_curve& c, const Exact_rational& t0, const Exact_rational& t1) {
  const Exact_rational s0 = Exact_rational(1 - t0), s1 = Exact_rational(1 - t1);
  return {c.x.restricted(t0, s0, t1, s1), c.y.restricted(t0, s0, t1, s1)};
}

// 1 from below the point to its height or above it, -1 the other way round.
static int rise(const Exact_rational& from_y, const Exact_rational& to_y) {
  return static_cast<int>(from_y < 0) - static_cast<int>(to_y < 0);
}

int crossings(const Seen_curve& c) {
  const auto &x = c.x.scaled_coefficients(), &y = c.y.scaled_coefficients();
  const auto is_negative = [](const Exact_rational& v) { return CGAL::is_negative(v); };
  const auto is_positive = [](const Exact_rational& v) { return CGAL::is_positive(v); };
  if (std::none_of(y.begin(), y.end(), is_negative) || std::all_of(y.begin(), y.end(), is_negative)) return 0;
  if (std::none_of(x.begin(), x.end(), is_positive)) return 0;
  if (std::none_of(x.begin(), x.end(), is_negative)) return rise(y.front(), y.back());
  const auto xs = c.x.halves(), ys = c.y.halves();
  return crossings({xs.first, ys.first}) + crossings({xs.second, ys.second});
}

// From b to a as many, with the other sign, even where it runs through the point.
static int segment_crossings(const Exact_point& q, const Exact_point& a, const Exact_point& b) {
  const Exact_point u = a - q, v = b - q;
  const int way = rise(u.y, v.y);
  return way != 0 && static_cast<int>(CGAL::sign(cross(u, v))) == way ? way : 0;
}

Exact_crossings exact_crossings(const Exact_point& q, const Bezier_curve_2<Exact_rational>& curve, double t0, double t1,
                                const Exact_point& a, const Exact_point& b) {
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
