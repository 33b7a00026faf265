// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Where a shape is narrow: the maximal discs that are smaller than those around them on the axis.
//
// The discs of an axis are flooded from the smallest one up. A pool begins at each local minimum; where two pools meet,
// the one with the larger minimum ends, and its prominence is by how much the radius has risen (Edelsbrunner, Letscher,
// Zomorodian 2002). Pools that begin at an end of the axis are corners and tips, not necks.

#ifndef CGAL_BOUNDING_ARCS_2_MEDIAL_AXIS_NECKS_H
#define CGAL_BOUNDING_ARCS_2_MEDIAL_AXIS_NECKS_H

#include <CGAL/Bounding_arcs_2/medial_axis/Medial_axis_2.h>

#include <cstddef>
#include <ostream>
#include <vector>

namespace CGAL::Bounding_arcs {

/// A place where a shape, or the room in a frame, is narrower than around it.
/// \code
/// for (const Neck& neck : necks(axis)) std::cout << neck.thickness() << '\n';
/// \endcode
struct Neck {
  Medial_sample disc;    ///< the smallest one, and where it touches both sides
  std::size_t edge = 0;  ///< of the axis
  double prominence =
      0;  ///< the radius rises by that on each way to a narrower place or an end; infinite: none is left

  [[nodiscard]] double thickness() const { return 2 * disc.radius; }

  /// Writes the members in their order, with a blank between.
  friend std::ostream& operator<<(std::ostream& out, const Neck& answer) {
    return out << answer.disc << ' ' << answer.prominence;
  }
};

/// Returns the necks of what an axis is of, the narrowest first.
/// \param least_prominence necks that stand out by no more are left out; at least axis.eps is taken, as samples tell no
///   smaller difference
/// \guarantee the thickness is within 2 axis.eps of the least one there, as good as the axis is; a long neck of one
///   width, or a ring, has one place
/// \complexity n log n in the samples
[[nodiscard]] std::vector<Neck> necks(const Medial_axis_2& axis, double least_prominence = 0);

}  // namespace CGAL::Bounding_arcs

#endif
