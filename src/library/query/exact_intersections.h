// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Common points of pieces in exact arithmetic, all of them: the last resort of queries.
// Pieces with doubles for coordinates have exact ones in rationals, so that rounding has no part in any answer.

#ifndef BOUNDING_ARCS_LIBRARY_QUERY_EXACT_INTERSECTIONS_H
#define BOUNDING_ARCS_LIBRARY_QUERY_EXACT_INTERSECTIONS_H

#include <CGAL/Bounding_arcs_2/curve/Bezier_curve_2.h>
#include <CGAL/Bounding_arcs_2/number/Exact_number.h>
#include <CGAL/Bounding_arcs_2/query/Intersections_2.h>

namespace CGAL::Bounding_arcs {

/// All common points of two pieces, and all parts where they run together.
/// Pieces may be straight, run back and forth, be traced several times, have cusps, be single points. A single point on
/// a piece makes an overlap at each parameter of it, all of [0,1] for the one and no progress for the other.
/// \return kinds are never UNDECIDED
/// \guarantee exact and complete: every pair of parameters with the same point is a point or on an overlap
/// \complexity for degrees m and n a resultant of degree m n at m n + 1 places with n^3 operations each; more
///   where points of one piece belong to several parameters of the other, as on straight pieces of high degree
///   that run back and forth, or on a curve traced twice
template <class NT>
[[nodiscard]] Piece_intersections exact_intersections(const Bezier_curve_2<NT>& a, const Bezier_curve_2<NT>& b);

/// All pairs a < b of parameters with the same point of one piece; 0 and 1 when it is closed. A cusp is none. A piece
/// that runs back over itself makes overlaps; one that is a single point has no pairs worth a list, and none is made.
/// \guarantee as exact_intersections
template <class NT> [[nodiscard]] Piece_intersections exact_self_intersections(const Bezier_curve_2<NT>& a);

/// How a piece crosses a horizontal ray, and whether it holds the ray's origin.
struct Ray_crossings {
  int winding = 0;     ///< crossings upwards less crossings downwards
  bool is_on = false;  ///< then winding is of no use
};

/// Crossings with the ray from q to x = +infinity. Points at the ray's height count as below it, ends of the piece as
/// others: as if the ray was higher by less than any number. So the sum over a closed chain of pieces none of which
/// holds q is the winding number of the chain around q.
/// \guarantee exact
template <class NT> [[nodiscard]] Ray_crossings exact_ray_crossings(const Bezier_curve_2<NT>& a, const Xy<NT>& q);

}  // namespace CGAL::Bounding_arcs

#endif
