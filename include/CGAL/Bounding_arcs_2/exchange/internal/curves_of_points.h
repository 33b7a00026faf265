// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Curves from CGAL's points: control points in a range, with weights and knots.  For kernels with Cartesian or
// homogeneous coordinates alike.

#ifndef CGAL_BOUNDING_ARCS_2_EXCHANGE_INTERNAL_CURVES_OF_POINTS_H
#define CGAL_BOUNDING_ARCS_2_EXCHANGE_INTERNAL_CURVES_OF_POINTS_H

#include <CGAL/Bounding_arcs_2/curve/B_spline_curve_2.h>
#include <CGAL/Bounding_arcs_2/curve/Bezier_curve_2.h>
#include <CGAL/Bounding_arcs_2/number/Xy.h>
#include <CGAL/Bounding_arcs_2/number/convert.h>

#include <utility>
#include <vector>

namespace CGAL::Bounding_arcs {

/// A Point_2 of a kernel, or what has x() and y(), as numbers of the curve: the same ones, or doubles as
/// CGAL::to_double has them.
/// \tparam NT over which the curve is
template <class NT, class Point> [[nodiscard]] Xy<NT> xy_of_point(const Point& p) {
  return {convert<NT>(p.x()), convert<NT>(p.y())};
}
/// Converts a range of points.
template <class NT, class Points> [[nodiscard]] std::vector<Xy<NT>> xy_of_points(const Points& points) {
  std::vector<Xy<NT>> result;
  for (const auto& p : points) result.push_back(xy_of_point<NT>(p));
  return result;
}

/// The Bezier curve with control points from a range of Point_2.
/// \param weights empty for a polynomial curve, else one positive weight a point
/// \throws std::invalid_argument as Bezier_curve_2
template <class NT, class Points>
[[nodiscard]] Bezier_curve_2<NT> bezier_of_points(const Points& points, std::vector<NT> weights = {}) {
  return Bezier_curve_2<NT>(xy_of_points<NT>(points), std::move(weights));
}
/// The B-spline curve with control points from a range of Point_2.
/// \param knots, weights as for B_spline_curve_2
/// \throws std::invalid_argument as B_spline_curve_2
template <class NT, class Points>
[[nodiscard]] B_spline_curve_2<NT> b_spline_of_points(int degree, const Points& points, std::vector<NT> knots,
                                                      std::vector<NT> weights = {}) {
  return B_spline_curve_2<NT>(degree, xy_of_points<NT>(points), std::move(knots), std::move(weights));
}

}  // namespace CGAL::Bounding_arcs

#endif
