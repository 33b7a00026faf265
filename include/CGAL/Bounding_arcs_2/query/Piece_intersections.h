// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// What two pieces, or one piece with itself, have in common: parameters in narrow ranges.
// Invariant: a range holds its exact parameter, and is a single double only where the parameter is that double.

#ifndef CGAL_BOUNDING_ARCS_2_QUERY_PIECE_INTERSECTIONS_H
#define CGAL_BOUNDING_ARCS_2_QUERY_PIECE_INTERSECTIONS_H

#include <CGAL/Bounding_arcs_2/number/Bracket.h>

#include <vector>

namespace CGAL::Bounding_arcs {

/// Tangential: the tangents are parallel there, or one piece has none, as in a cusp.
enum class Intersection_kind { TRANSVERSAL, TANGENTIAL, UNDECIDED };

/// A common point, the first piece's parameter and the second one's, both in [0, 1].
/// A bracket holds one exact parameter. It is at most three doubles wide, and a single double only where the parameter
/// is that double.
struct Piece_intersection {
  Bracket a, b;
  Intersection_kind kind = Intersection_kind::UNDECIDED;
};

/// Common points without end: while the first piece runs from a_from up to a_to, the second one runs from b_from to
/// b_to, up or down, through the same points. A piece that is a single point stays there all the time.
struct Piece_overlap {
  Bracket a_from, a_to, b_from, b_to;
};

/// All that is common, each list sorted by the first piece's parameter, then by the second one's.
/// A pair of parameters on an overlap, its ends included, is not among the points.
struct Piece_intersections {
  std::vector<Piece_intersection> points;
  std::vector<Piece_overlap> overlaps;
};

}  // namespace CGAL::Bounding_arcs

#endif
