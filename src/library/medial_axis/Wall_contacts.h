// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Where walls are nearer to each other than a length: what close walls are cut and joined by.

#ifndef BOUNDING_ARCS_LIBRARY_MEDIAL_AXIS_WALL_CONTACTS_H
#define BOUNDING_ARCS_LIBRARY_MEDIAL_AXIS_WALL_CONTACTS_H

#include "Bounding_parts.h"

#include <cstdint>
#include <vector>

namespace CGAL::Bounding_arcs::internal {

/// Places on two segments that are to be one.
struct Wall_contact {
  std::uint32_t a, b;
  double s, t;  ///< parameters
};

/// Returns contacts of segments that are no farther from each other than a length, or hardly.
///
/// A stretch of one along which another is close has a contact at each of its ends, or, where both go on beyond it on
/// either side, one in its middle: they touch. Two that share a joint are close beside it, whatever the angle: that is
/// a corner. They are one only where one of them ends beside the other.
/// \complexity n log n in the number of segments, and some hundred steps a contact
[[nodiscard]] std::vector<Wall_contact> wall_contacts(const Bounding_parts& parts, double close);

}  // namespace CGAL::Bounding_arcs::internal

#endif
