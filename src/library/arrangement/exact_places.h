// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Points and curves of arrangements in exact numbers (overlay/Exact_curve.h).

#ifndef BOUNDING_ARCS_LIBRARY_ARRANGEMENT_EXACT_PLACES_H
#define BOUNDING_ARCS_LIBRARY_ARRANGEMENT_EXACT_PLACES_H

#include "../overlay/Exact_curve.h"

#include <CGAL/Bounding_arcs_2/arrangement/internal/Arranged_curve.h>
#include "../query/exact_intersections.h"

#include <cstddef>

namespace CGAL::Bounding_arcs::internal {

/// What two curves have in common, with exact parameters of the one that comes first.
struct Exact_common {
  bool is_b_first;
  Exact_meetings found;
};
[[nodiscard]] const Exact_common& exact_common(const Arranged_pair& pair);

[[nodiscard]] Exact_place& exact_place(const Arranged_point& p);

/// The branches of a curve that end and start at a parameter: neighbours where it turns, else one.
struct Branches {
  std::size_t before, behind;
};
[[nodiscard]] Branches branches_at(const Arranged_curve& c, const Exact_parameter& t);

/// Notes all places of a point on a curve, or those in a range.
void add_places(const Arranged_point& p, const Arranged_curve& c, const Bracket& range);

}  // namespace CGAL::Bounding_arcs::internal

#endif
