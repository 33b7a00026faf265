// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// A part of an outline as a curve in doubles, and how far that is from the part.

#ifndef BOUNDING_ARCS_LIBRARY_BOOLEAN_ROUNDED_PART_H
#define BOUNDING_ARCS_LIBRARY_BOOLEAN_ROUNDED_PART_H

#include <CGAL/Bounding_arcs_2/boolean/boolean_operations.h>
#include <CGAL/Bounding_arcs_2/curve/Bezier_curve_2.h>
#include <CGAL/Bounding_arcs_2/number/Bracket.h>
#include <CGAL/Bounding_arcs_2/number/Xy.h>

namespace CGAL::Bounding_arcs::internal {

constexpr double UP = 1 + 0x1p-40;  // for the roundings of bounds

/// Cuts a part out of a piece, in doubles. One that is shorter than these tell is straight.
/// \param from, to hold the parameters of its ends
/// \param is_reversed whether it runs against the piece
/// \param start, end its ends, which it gets bit for bit
[[nodiscard]] Bezier_curve_2<double> curve_of_part(const Bezier_curve_2<double>& piece, const Bracket& from,
                                                   const Bracket& to, bool is_reversed, const Xy<double>& start,
                                                   const Xy<double>& end);

/// Which ends of a part are those of given curves, bit for bit.
struct Exact_ends {
  bool start, end;
};
/// Whether an end of a part is one of its piece.
[[nodiscard]] inline bool is_end_of_piece(const Bracket& t) { return t.is_single() && (t.lower == 0 || t.lower == 1); }

/// How far the curve of a part is from the part itself, point by point.
/// \param exact ends of neighbours count, too
[[nodiscard]] double error_of_part(const Bezier_curve_2<double>& piece, const Outline_2::Part& part,
                                   const Exact_ends& exact);

/// How far the control points and the curve of subcurve(), which are computed in doubles, are from the true ones of
/// nearly the same parameters.
[[nodiscard]] double cutting_error(const Bezier_curve_2<double>& piece);

/// How far rounding alone may put a part's curve from the part, however little is known of where that ends.
/// \param exact as of error_of_part
[[nodiscard]] double rounding_of_part(const Bezier_curve_2<double>& piece, const Outline_2::Part& part,
                                      const Exact_ends& exact);

/// How far any point of a curve may be from a point, by its control points.
[[nodiscard]] double farthest(const Bezier_curve_2<double>& curve, const Xy<double>& from);

}  // namespace CGAL::Bounding_arcs::internal

#endif
