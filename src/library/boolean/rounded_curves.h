// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Parts of outlines as curves in doubles, how far these are from the parts, and how far two curves that run along one
// another are apart. All of it is told by control points alone.

#ifndef BOUNDING_ARCS_LIBRARY_BOOLEAN_ROUNDED_CURVES_H
#define BOUNDING_ARCS_LIBRARY_BOOLEAN_ROUNDED_CURVES_H

#include <CGAL/Bounding_arcs_2/boolean/boolean_operations.h>
#include <CGAL/Bounding_arcs_2/curve/Bezier_curve_2.h>
#include <CGAL/Bounding_arcs_2/number/Bracket.h>
#include <CGAL/Bounding_arcs_2/number/Xy.h>
#include "../overlay/Meeting_places.h"  // is_end_of_piece

#include <vector>

namespace CGAL::Bounding_arcs::internal {

constexpr double UP = 1 + 0x1p-40;  // for the roundings of bounds

/// Cuts a part out of its piece, in doubles, with the part's ends bit for bit. One that is shorter than doubles tell is
/// straight.
[[nodiscard]] Bezier_curve_2<double> curve_of_part(const Bezier_curve_2<double>& piece, const Outline_2::Part& part);

/// Which ends of a part are those of given curves, bit for bit.
struct Exact_ends {
  bool start, end;
};

/// How far the curve of a part is from the part itself, point by point.
struct Part_errors {
  double all;         ///< at most
  double of_cutting;  ///< what rounding alone may make of it, however little is known of where the part ends
};
/// \param exact ends of neighbours count, too
[[nodiscard]] Part_errors errors_of_part(const Bezier_curve_2<double>& piece, const Outline_2::Part& part,
                                         const Exact_ends& exact);

/// How far the control points and the curve of subcurve(), which are computed in doubles, are from the true ones of
/// nearly the same parameters.
[[nodiscard]] double cutting_error(const Bezier_curve_2<double>& piece);

/// How far any point of a curve may be from a point, by its control points.
[[nodiscard]] double farthest(const Bezier_curve_2<double>& curve, const Xy<double>& from);

/// Returns a bound of the Frechet distance of two curves: small for parts of one curve with other control points, and
/// for curves along one segment; else large.
[[nodiscard]] double distance_bound(const Bezier_curve_2<double>& a, const Bezier_curve_2<double>& b);

/// Returns such a bound for two chains in the same direction. Curves of one are cut near the joints of the other.
/// \param most beyond which a bound is of no use; then it may be any that is larger
[[nodiscard]] double distance_bound(const std::vector<Bezier_curve_2<double>>& a,
                                    const std::vector<Bezier_curve_2<double>>& b, double most);

/// Returns how far the control points of a curve are from a segment at most.
[[nodiscard]] double distance_from_segment(const Bezier_curve_2<double>& curve, const Xy<double>& from,
                                           const Xy<double>& to);

/// Returns the parameter of a point of a curve that is near a point, by Newton's method: any of [0, 1] if there is
/// none.
[[nodiscard]] double parameter_near(const Bezier_curve_2<double>& curve, const Xy<double>& p);

}  // namespace CGAL::Bounding_arcs::internal

#endif
