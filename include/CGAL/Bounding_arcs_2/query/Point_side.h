// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Where a point is with respect to closed curves.

#ifndef CGAL_BOUNDING_ARCS_2_QUERY_POINT_SIDE_H
#define CGAL_BOUNDING_ARCS_2_QUERY_POINT_SIDE_H

#include <CGAL/Bounding_arcs_2/curve/Fill_rule.h>

#include <cstdint>

namespace CGAL::Bounding_arcs {

/// UNDECIDED only without exact decisions.
enum class Point_side : std::uint8_t { INSIDE, OUTSIDE, ON, UNDECIDED };

/// How often closed curves run round a point.
struct Winding_number {
  /// Whether there is a number: there is none on a curve.
  enum class State : std::uint8_t { DECIDED, ON, UNDECIDED };
  State state = State::DECIDED;
  int number = 0;  ///< of all curves together, positive counterclockwise; 0 unless it is decided
};

/// The side that a winding number has under a fill rule.
[[nodiscard]] inline Point_side side_of(const Winding_number& w, Fill_rule rule) {
  if (w.state == Winding_number::State::ON) return Point_side::ON;
  if (w.state == Winding_number::State::UNDECIDED) return Point_side::UNDECIDED;
  return is_filled(rule, w.number) ? Point_side::INSIDE : Point_side::OUTSIDE;
}

}  // namespace CGAL::Bounding_arcs

#endif
