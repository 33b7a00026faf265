// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The curves that queries, offsets and chains of arcs serve: squares of lengths are doubles.

#ifndef CGAL_BOUNDING_ARCS_2_QUERY_QUERIED_RANGE_H
#define CGAL_BOUNDING_ARCS_2_QUERY_QUERIED_RANGE_H

#include <CGAL/Bounding_arcs_2/curve/Bezier_curve_2.h>

#include <cmath>
#include <stdexcept>

namespace CGAL::Bounding_arcs {

inline constexpr double LARGEST_QUERIED = 0x1p500;  ///< a box's diagonal, squared and times some, stays finite

/// \throws std::invalid_argument for a curve that is larger
inline void check_queried(const Bezier_curve_2<double>& curve) {
  for (const Xy<double>& p : curve.control_points())
    if (!(std::fabs(p.x) <= LARGEST_QUERIED && std::fabs(p.y) <= LARGEST_QUERIED))
      throw std::invalid_argument("queries, offsets and arcs serve coordinates up to 2^500 (3e150)");
}

}  // namespace CGAL::Bounding_arcs

#endif
