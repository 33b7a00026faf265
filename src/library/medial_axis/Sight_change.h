// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// How much the distance from an arc's circle changes about a place: its gradient, and its second derivative along a
// line. What is between two discs of an axis is bounded by these.

#ifndef BOUNDING_ARCS_LIBRARY_MEDIAL_AXIS_SIGHT_CHANGE_H
#define BOUNDING_ARCS_LIBRARY_MEDIAL_AXIS_SIGHT_CHANGE_H

#include <CGAL/Bounding_arcs_2/number/Bracket.h>
#include "Line_parts.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace CGAL::Bounding_arcs::internal {

struct Sight_change {
  double turn;      // of the gradient, at most
  Bracket second;   // the second derivative along the line
  double tightest;  // curvature of a circle about the arc's center, at most

  [[nodiscard]] double most_second() const { return (std::max)(std::fabs(second.lower), std::fabs(second.upper)); }
};

/// Along the line by `way` the gradient turns by its part across it times the curvature, across by the curvature.
/// \param across the gradient's part across the line
/// \param way, reach how far places are along the line and across
[[nodiscard]] inline Sight_change sight_change(const Arc_sight& s, double across, double way, double reach) {
  constexpr double INFINITE = std::numeric_limits<double>::infinity();
  const double k = std::fabs(s.curvature), most = k / (1 - k * (way + reach)), square = across * across;
  if (!(k * (way + reach) < 0.5) || !(most * way < 0.75)) return {INFINITE, {-INFINITE, INFINITE}, INFINITE};
  const double turn = most * (std::fabs(across) * way + reach) / (1 - most * way);
  const double bend = most * (2 * std::fabs(across) * turn + turn * turn) + k * most * (way + reach) * square;
  const double value = -s.curvature * square;
  return {turn, {value - bend, value + bend}, most};
}

}  // namespace CGAL::Bounding_arcs::internal

#endif
