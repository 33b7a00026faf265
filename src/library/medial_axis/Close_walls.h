// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Walls that are nearer to each other than a drawing is told: ends that miss each other, circles that touch but for
// rounding, arcs that run beside each other.  There the axis is that of a drawing in which they meet.
//
//   close walls -> cuts where they come near and part -> equal ends are one joint -> equal walls are one -> rings

#ifndef BOUNDING_ARCS_LIBRARY_MEDIAL_AXIS_CLOSE_WALLS_H
#define BOUNDING_ARCS_LIBRARY_MEDIAL_AXIS_CLOSE_WALLS_H

#include "Bounding_parts.h"

#include <cstdint>
#include <functional>
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

/// How often what is filled winds round points beside a wall.
struct Side_windings {
  int left = 0, right = 0;
};

/// Joins walls that are closer than that to each other.
/// \param windings by segment
/// \param is_inside of a winding number
/// \param winding_at what winds round a point on no wall
/// \return the same parts where none are that close
[[nodiscard]] Bounding_parts with_close_walls_joined(Bounding_parts parts, const std::vector<Side_windings>& windings,
                                                     const std::function<bool(int)>& is_inside,
                                                     const std::function<int(const Xy<double>&)>& winding_at,
                                                     double close);

}  // namespace CGAL::Bounding_arcs::internal

#endif
