// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Which points closed curves have inside.

#ifndef CGAL_BOUNDING_ARCS_2_CURVE_FILL_RULE_H
#define CGAL_BOUNDING_ARCS_2_CURVE_FILL_RULE_H

#include <CGAL/Bounding_arcs_2/number/strict_math.h>

#include <cstdint>

namespace CGAL::Bounding_arcs {

/// The rule says which points are inside. NONZERO takes those that curves run round other than 0 times,
/// counterclockwise less clockwise; EVEN_ODD those that they run round an odd number of times.
enum class Fill_rule : std::uint8_t { NONZERO, EVEN_ODD };

/// Whether points that curves run round so often are inside.
[[nodiscard]] inline bool is_filled(Fill_rule rule, int winding) {
  return rule == Fill_rule::NONZERO ? winding != 0 : winding % 2 != 0;
}

}  // namespace CGAL::Bounding_arcs

#endif
