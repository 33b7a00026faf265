// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Common points of drawings by Bezier pieces, before what is at joints is joined.

#ifndef BOUNDING_ARCS_LIBRARY_QUERY_NUMBERED_INTERSECTIONS_H
#define BOUNDING_ARCS_LIBRARY_QUERY_NUMBERED_INTERSECTIONS_H

#include <CGAL/Bounding_arcs_2/query/Intersections_2.h>

#include <cstdint>
#include <utility>
#include <vector>

namespace CGAL::Bounding_arcs {

/// A common point of two Bezier pieces.
struct Numbered_point {
  std::pair<std::uint32_t, std::uint32_t> beziers;  // numbered through the drawing
  Piece_intersection common;
};
/// A part along which two Bezier pieces run together.
struct Numbered_overlap {
  std::pair<std::uint32_t, std::uint32_t> beziers;
  Piece_overlap common;
};
/// All that drawings have in common.
struct Numbered_intersections {
  std::vector<Numbered_point> points;
  std::vector<Numbered_overlap> overlaps;
};

}  // namespace CGAL::Bounding_arcs

#endif
