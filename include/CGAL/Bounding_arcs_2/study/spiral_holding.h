// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The spiral segment of a curve that a part of the curve belongs to.

#ifndef CGAL_BOUNDING_ARCS_2_STUDY_SPIRAL_HOLDING_H
#define CGAL_BOUNDING_ARCS_2_STUDY_SPIRAL_HOLDING_H

#include <CGAL/Bounding_arcs_2/spiral/Bezier_spiral_2.h>

#include <optional>

namespace CGAL::Bounding_arcs {

/// Returns the spiral segment with all of [t0, t1], or nothing where the curve is cut within.
/// \throws std::invalid_argument for curves out of the range of check_served
[[nodiscard]] inline std::optional<Bezier_spiral_2<double>> spiral_holding(const Bezier_curve_2<double>& curve,
                                                                           double t0, double t1) {
  for (const Bezier_spiral_2<double>& spiral : spiral_segments(curve))
    if (spiral.first() <= t0 && t1 <= spiral.last()) return spiral;
  return std::nullopt;
}

}  // namespace CGAL::Bounding_arcs

#endif
