// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// How far two curves that run along one another are apart, at most, by their control points alone.

#ifndef BOUNDING_ARCS_LIBRARY_BOOLEAN_CURVE_DISTANCE_H
#define BOUNDING_ARCS_LIBRARY_BOOLEAN_CURVE_DISTANCE_H

#include <CGAL/Bounding_arcs_2/curve/Bezier_curve_2.h>
#include <CGAL/Bounding_arcs_2/number/Xy.h>

#include <vector>

namespace CGAL::Bounding_arcs::internal {

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
