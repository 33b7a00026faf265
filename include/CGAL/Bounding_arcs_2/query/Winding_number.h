// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Where a point is with respect to closed curves.

#ifndef CGAL_BOUNDING_ARCS_2_QUERY_WINDING_NUMBER_H
#define CGAL_BOUNDING_ARCS_2_QUERY_WINDING_NUMBER_H

#include <CGAL/Bounding_arcs_2/curve/Fill_rule.h>

#include <CGAL/Uncertain.h>
#include <CGAL/enum.h>

#include <cstdint>

namespace CGAL::Bounding_arcs {

/// How often closed curves run round a point.
struct Winding_number {
  /// Whether there is a number: there is none on a curve.
  enum class State : std::uint8_t { DECIDED, ON, UNDECIDED };
  State state = State::DECIDED;
  int number = 0;  ///< of all curves together, positive counterclockwise; 0 unless it is decided
};

/// The side that a winding number has under a fill rule; uncertain where that is undecided.
[[nodiscard]] inline Uncertain<Bounded_side> side_of(const Winding_number& w, Fill_rule rule) {
  if (w.state == Winding_number::State::ON) return ON_BOUNDARY;
  if (w.state == Winding_number::State::UNDECIDED) return Uncertain<Bounded_side>::indeterminate();
  return is_filled(rule, w.number) ? ON_BOUNDED_SIDE : ON_UNBOUNDED_SIDE;
}

}  // namespace CGAL::Bounding_arcs

#endif
