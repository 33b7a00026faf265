// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// What exact decisions take of a Bezier piece: the piece in rationals, and the directions at its ends.

#ifndef BOUNDING_ARCS_LIBRARY_CURVE_EXACT_BEZIER_H
#define BOUNDING_ARCS_LIBRARY_CURVE_EXACT_BEZIER_H

#include <CGAL/Bounding_arcs_2/curve/Bezier_curve_2.h>
#include <CGAL/Bounding_arcs_2/number/Exact_number.h>

#include <utility>
#include <vector>

namespace CGAL::Bounding_arcs {

/// \guarantee exact
[[nodiscard]] inline Bezier_curve_2<Exact_rational> exact_bezier(const Bezier_curve_2<double>& curve) {
  std::vector<Xy<Exact_rational>> points;
  std::vector<Exact_rational> weights;
  for (const Xy<double>& p : curve.control_points()) points.push_back({Exact_rational(p.x), Exact_rational(p.y)});
  for (const double w : curve.weights()) weights.emplace_back(w);
  return Bezier_curve_2<Exact_rational>(std::move(points), std::move(weights));
}

/// C' at t = 0 or 1 but for a positive factor: the difference of the last two control points there.
template <class NT> [[nodiscard]] Xy<NT> end_direction(const Bezier_curve_2<NT>& curve, double t) {
  const auto& p = curve.control_points();
  return t == 0 ? p[1] - p[0] : p[p.size() - 1] - p[p.size() - 2];
}

}  // namespace CGAL::Bounding_arcs

#endif
