// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Common points of pieces in exact arithmetic, all of them: the last resort of queries.
// Pieces with doubles for coordinates have exact ones in rationals, so that rounding has no part in any answer.

#ifndef BOUNDING_ARCS_LIBRARY_QUERY_EXACT_INTERSECTIONS_H
#define BOUNDING_ARCS_LIBRARY_QUERY_EXACT_INTERSECTIONS_H

#include <CGAL/Bounding_arcs_2/curve/Bezier_curve_2.h>
#include <CGAL/Bounding_arcs_2/number/Bracket.h>
#include <CGAL/Bounding_arcs_2/number/Exact_number.h>
#include <CGAL/Bounding_arcs_2/query/Intersections_2.h>
#include "../curve/Integer_piece.h"
#include "../polynomial/Real_root.h"

#include <optional>
#include <vector>

namespace CGAL::Bounding_arcs {

/// All common points of two pieces, and all parts where they run together.
/// Pieces may be straight, run back and forth, be traced several times, have cusps, be single points. A single point on
/// a piece makes an overlap at each parameter of it, all of [0,1] for the one and no progress for the other.
/// \return kinds are never UNDECIDED
/// \guarantee exact and complete: every pair of parameters with the same point is a point or on an overlap
/// \complexity for degrees m and n a resultant of degree m n at m n + 1 places with n^3 operations each; more
///   where points of one piece belong to several parameters of the other, as on straight pieces of high degree
///   that run back and forth, or on a curve traced twice
[[nodiscard]] Piece_intersections exact_intersections(const Bezier_curve_2<Exact_rational>& a,
                                                      const Bezier_curve_2<Exact_rational>& b);

/// All pairs a < b of parameters with the same point of one piece; 0 and 1 when it is closed. A cusp is none. A piece
/// that runs back over itself makes overlaps; one that is a single point has no pairs worth a list, and none is made.
/// \guarantee as exact_intersections
[[nodiscard]] Piece_intersections exact_self_intersections(const Bezier_curve_2<Exact_rational>& a);

/// Whether a piece runs ahead in one direction between two parameters, so that it does not meet itself there.
/// \return false, too, where intervals do not tell
[[nodiscard]] bool runs_ahead(const Bezier_curve_2<Exact_rational>& a, double t0, double t1);

// Common points of two pieces with the first one's parameters as exact numbers: what exact_intersections rounds.

/// A common point: the exact parameter of the first piece, and doubles around that of the second one.
struct Exact_meeting {
  Real_root t;
  Bracket s;
  Intersection_kind kind;
};
/// The ends of a part along which pieces run together, as t rises.
struct Exact_overlap {
  Real_root t_from, t_to, s_from, s_to;
};
/// All that two pieces have in common, in no order.
struct Exact_meetings {
  std::vector<Exact_meeting> points;
  std::vector<Exact_overlap> overlaps;
};

/// \pre neither is a point
/// \guarantee exact and complete, as exact_intersections
[[nodiscard]] Exact_meetings exact_meetings(const Integer_piece& a, const Integer_piece& b);
/// Which pairs of parameters of a piece with itself are taken.
enum class Parameter_order { RISING, FALLING, ANY };
/// Returns what a piece has in common with itself. \param order whether the second parameter is greater or less
[[nodiscard]] Exact_meetings exact_meetings(const Integer_piece& a, Parameter_order order);

/// The parameters in [0,1] at which a piece is at a point, in rising order. \pre the piece is no point
[[nodiscard]] std::vector<Real_root> exact_roots_at(const Integer_piece& a, const Xy<Exact_rational>& p);

/// Zero at the parameters of a where it is at b(s), for a root s of a polynomial; some zeros are none of these.
/// \pre a is no point
[[nodiscard]] Univariate places_of(const Integer_piece& a, const Integer_piece& b, const Univariate& roots);

/// A zero of a polynomial, with its signs between this zero and its neighbours; -1 beyond 0 and 1.
struct Exact_zero {
  Real_root t;
  int sign_before, sign_behind;
};
/// All zeros in [0,1], in rising order. \pre the polynomial is not zero
[[nodiscard]] std::vector<Exact_zero> exact_zeros(const Univariate& p);

// Line segments, without polynomials where an end of one is on the line of the other one.

/// Whether a piece is a line segment that is run through evenly, and no point.
[[nodiscard]] inline bool is_line(const Bezier_curve_2<double>& c) {
  return c.degree() == 1 && !c.is_rational() && !(c.control_points().front() == c.control_points().back());
}

/// All that two line segments have in common.
/// \pre is_line of both
/// \return nothing where they cross between their ends, which is for others to find
/// \guarantee exact
[[nodiscard]] std::optional<Piece_intersections> line_intersections(const Bezier_curve_2<double>& a,
                                                                    const Bezier_curve_2<double>& b);

/// The crossing of two line segments. \pre they cross between their ends
/// \guarantee exact
[[nodiscard]] Piece_intersections::Intersection line_crossing(const Bezier_curve_2<double>& a,
                                                              const Bezier_curve_2<double>& b);

// How a piece of a Bezier curve crosses the ray from a point to the right, in exact arithmetic.
//
// A crossing is counted at the height just below the point: upwards 1, downwards -1, so that what touches the ray
// counts 0, and a corner on it once.

/// A point with rational coordinates.
using Exact_point = Xy<Exact_rational>;

/// How a way crosses the ray from a point.
struct Exact_crossings {
  int number = 0;   ///< of what does not run through the point
  int passing = 0;  ///< how a curve rises that does
  bool is_on = false;
};
/// Counts the crossings of the way from a to the curve's point at t0, along the curve to t1 and from there to b.
/// A curve through q is counted in `passing` alone. \pre for that: y is monotone between t0 and t1
/// \guarantee exact
[[nodiscard]] Exact_crossings exact_crossings(const Exact_point& q, const Bezier_curve_2<Exact_rational>& curve,
                                              double t0, double t1, const Exact_point& a, const Exact_point& b);

}  // namespace CGAL::Bounding_arcs

#endif
