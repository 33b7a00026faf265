// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The integral of |dkappa/ds|^(1/3) ds, to which for small eps the least number of pieces is proportional whatever is
// put over them: arcs, biarcs or bounding regions.

#ifndef BOUNDING_ARCS_STUDY_SLOPE_INTEGRAL_H
#define BOUNDING_ARCS_STUDY_SLOPE_INTEGRAL_H

#include <CGAL/Bounding_arcs_2/curve/Bezier_curve_2.h>
#include <CGAL/Bounding_arcs_2/spiral/Bezier_spiral_2.h>
#include "../library/chain/Cubic_arcs.h"

#include <boost/math/quadrature/tanh_sinh.hpp>

#include <cmath>

namespace CGAL::Bounding_arcs {

/// The integral of |dkappa/ds|^(1/3) ds over a spiral segment; its third power is a length.
/// \guarantee heuristic: numerical quadrature to about 1e-6 relative, good also for singular ends
[[nodiscard]] inline double slope_integral(const Bezier_spiral_2<double>& spiral) {
  if (spiral.is_straight()) return 0;
  const double h = spiral.last() - spiral.first(), unit = spiral.table<double>().unit();
  const auto density = [&](double s) {
    const auto c = spiral.curve().taylor_expansion(spiral.first() + s * h, 3);
    const Xy<double> d1 = (h / unit) * c[1], d2 = (2 * h * h / unit) * c[2], d3 = (6 * h * h * h / unit) * c[3];
    const double speed = dot(d1, d1), change = cross(d1, d3) * speed - 3 * cross(d1, d2) * dot(d1, d2);
    const double value = std::cbrt(std::fabs(change)) / std::sqrt(speed);
    return std::isfinite(value) ? value : 0.0;  // within rounding of a cusp
  };
  boost::math::quadrature::tanh_sinh<double> integrator;
  constexpr double TOLERANCE = 1e-7;
  return std::cbrt(unit) * integrator.integrate(density, 0.0, 1.0, TOLERANCE);
}

}  // namespace CGAL::Bounding_arcs

#endif
