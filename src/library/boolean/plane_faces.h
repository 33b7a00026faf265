// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The faces that curves, open ones, too, cut the plane into, and the region that closed ones fill.

#ifndef BOUNDING_ARCS_LIBRARY_BOOLEAN_PLANE_FACES_H
#define BOUNDING_ARCS_LIBRARY_BOOLEAN_PLANE_FACES_H

#include <CGAL/Bounding_arcs_2/boolean/Outline_2.h>
#include <CGAL/Bounding_arcs_2/boolean/boolean_operations.h>
#include <CGAL/Bounding_arcs_2/curve/Fill_rule.h>
#include <CGAL/Bounding_arcs_2/tree/Directed_segment.h>
#include <CGAL/Bounding_arcs_2/tree/Segment_hierarchy.h>

#include <cstdint>
#include <optional>
#include <vector>

namespace CGAL::Bounding_arcs::internal {

/// What curves cut the plane into.
struct Plane_faces {
  Unit unit;
  Segment_hierarchy curves;  ///< those given, in that unit, with segments cut where curves meet, too
  std::vector<std::vector<Directed_segment>> rings;  ///< each along the boundary of a face, which is on its left
  /// Where pieces of `curves` are on those given: pieces that are points are not among them.
  struct Piece_place {
    std::uint32_t curve, bezier;
  };
  std::vector<Piece_place> places;  ///< by Bezier pieces, numbered through
};

/// Returns the faces of curves that may cross, touch and run together. A ring goes along both sides of what has one
/// face on both. Where curves run together, one of them is in rings.
/// \return nothing where the decisions leave open how curves meet
/// \complexity that of all intersections, n log n otherwise
[[nodiscard]] std::optional<Plane_faces> plane_faces(const Outline_operand& operand, Decisions decisions);

/// Returns the outline of what closed curves fill, with a chain that comes to a vertex again where the region meets
/// itself there: a corner of a chain is one of the region.
/// \throws std::invalid_argument as internal::outline does
[[nodiscard]] Outline_2 region_outline(const Outline_operand& operand, Decisions decisions);

}  // namespace CGAL::Bounding_arcs::internal

#endif
