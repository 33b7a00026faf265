// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The curves and points that queries, offsets and chains of arcs serve: squares of lengths are doubles.

#ifndef CGAL_BOUNDING_ARCS_2_CURVE_QUERIED_RANGE_H
#define CGAL_BOUNDING_ARCS_2_CURVE_QUERIED_RANGE_H

#include <CGAL/Bounding_arcs_2/curve/Bezier_curve_2.h>
#include <CGAL/Bounding_arcs_2/number/expected.h>

#include <cmath>
#include <cstddef>
#include <stdexcept>

namespace CGAL::Bounding_arcs {

inline constexpr double LARGEST_QUERIED = 0x1p500;  ///< a box's diagonal, squared and times some, stays finite
inline constexpr double LARGEST_SHAPE = 0x1p505;    ///< that of lines and circles to be queried with (shapes.h)

namespace internal {
/// Whether a point is served.
[[nodiscard]] inline bool is_queried(const Xy<double>& p, double most = LARGEST_QUERIED) {
  return std::fabs(p.x) <= most && std::fabs(p.y) <= most;  // no NaN is
}
}  // namespace internal

/// \throws std::invalid_argument for a curve that is larger
inline void check_queried(const Bezier_curve_2<double>& curve, double most = LARGEST_QUERIED) {
  for (std::size_t i = 0; i < curve.control_points().size(); ++i)
    if (const Xy<double>& p = curve.control_points()[i]; !internal::is_queried(p, most))
      throw std::invalid_argument(expected("control point " + text_of(i), "coordinates up to 2^500 (3e150)", p));
}

}  // namespace CGAL::Bounding_arcs

#endif
