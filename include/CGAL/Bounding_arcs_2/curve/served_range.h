// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The curves that are served: those whose figures, products of up to six lengths and four weights, stay in the range of
// double. Queries, offsets and chains of arcs serve those alone whose squares of lengths are doubles.

#ifndef CGAL_BOUNDING_ARCS_2_CURVE_SERVED_RANGE_H
#define CGAL_BOUNDING_ARCS_2_CURVE_SERVED_RANGE_H

#include <CGAL/Bounding_arcs_2/curve/Bezier_curve_2.h>
#include <CGAL/Bounding_arcs_2/number/expected.h>

#include <CGAL/number_utils.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <stdexcept>

namespace CGAL::Bounding_arcs {

inline constexpr double LARGEST_COORDINATE = 0x1p1000;  ///< differences of coordinates stay finite
inline constexpr double LARGEST_WEIGHT = 0x1p500;       ///< and its inverse the least: products of two are numbers
inline constexpr double LARGEST_WEIGHT_RATIO =
    0x1p40;  ///< of two weights: parameters resolve what happens within its inverse
inline constexpr double LEAST_ASPECT = 0x1p-1000;  ///< of the box of control points, where these are on no line

namespace internal {

/// \throws std::invalid_argument, with the range that is served, for other curves
template <class NT> void check_served(const Bezier_curve_2<NT>& curve) {
  constexpr double INFINITE = std::numeric_limits<double>::infinity();
  double low[2] = {INFINITE, INFINITE}, high[2] = {-INFINITE, -INFINITE}, least = INFINITE, most = 0;
  for (std::size_t k = 0; k < curve.control_points().size(); ++k) {
    const Xy<NT>& p = curve.control_points()[k];
    const double x[2] = {CGAL::to_double(p.x), CGAL::to_double(p.y)};
    for (int i = 0; i < 2; ++i) {
      if (!(std::fabs(x[i]) <= LARGEST_COORDINATE))
        throw std::invalid_argument(
            expected("control point " + text_of(k), "coordinates up to 2^1000 (1e301)", Xy<double>{x[0], x[1]}));
      low[i] = (std::min)(low[i], x[i]);
      high[i] = (std::max)(high[i], x[i]);
    }
  }
  for (const NT& weight : curve.weights()) {
    const double w = CGAL::to_double(weight);
    if (!std::isfinite(w)) throw std::invalid_argument(expected("weights", "finite numbers", w));
    least = (std::min)(least, w);
    most = (std::max)(most, w);
  }
  if (!curve.weights().empty() && (most > LARGEST_WEIGHT || least < 1 / LARGEST_WEIGHT))
    throw std::invalid_argument(
        expected("weights", "numbers from 2^-500 (3e-151) to 2^500 (3e150)", text_of(least) + " to " + text_of(most)));
  if (most > LARGEST_WEIGHT_RATIO * least)
    throw std::invalid_argument(
        expected("weights", "the largest up to 2^40 (1e12) times the least", text_of(least) + " to " + text_of(most)));
  const double width = high[0] - low[0], height = high[1] - low[1], longer = (std::max)(width, height),
               shorter = (std::min)(width, height);
  const bool is_segment = curve.degree() == 1;  // no figure of it has the shorter side as a factor
  if (!is_segment && shorter > 0 && shorter < LEAST_ASPECT * longer)
    throw std::invalid_argument(expected("control points", "a line, or a box at least 2^-1000 (1e-301) as thin as long",
                                         text_of(width) + " by " + text_of(height)));
}

/// Compiled in the library.
extern template void check_served(const Bezier_curve_2<double>&);

}  // namespace internal

inline constexpr double LARGEST_QUERIED = 0x1p500;  ///< a box's diagonal, squared and times some, stays finite
inline constexpr double LARGEST_SHAPE = 0x1p505;    ///< that of lines and circles to be queried with (shapes.h)

namespace internal {
/// Whether a point is served.
[[nodiscard]] inline bool is_queried(const Xy<double>& p, double most = LARGEST_QUERIED) {
  return std::fabs(p.x) <= most && std::fabs(p.y) <= most;  // no NaN is
}
/// \throws std::invalid_argument for a curve that is larger
inline void check_queried(const Bezier_curve_2<double>& curve, double most = LARGEST_QUERIED) {
  for (std::size_t i = 0; i < curve.control_points().size(); ++i)
    if (const Xy<double>& p = curve.control_points()[i]; !is_queried(p, most))
      throw std::invalid_argument(expected("control point " + text_of(i), "coordinates up to 2^500 (3e150)", p));
}
}  // namespace internal

}  // namespace CGAL::Bounding_arcs

#endif
