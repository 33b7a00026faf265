// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// A medial axis as conics: where curves are arcs, centers of discs that touch two of them are on one.

#ifndef CGAL_BOUNDING_ARCS_2_MEDIAL_AXIS_AXIS_CONICS_H
#define CGAL_BOUNDING_ARCS_2_MEDIAL_AXIS_AXIS_CONICS_H

#include <CGAL/Bounding_arcs_2/arc/Arc_2.h>
#include <CGAL/Bounding_arcs_2/medial_axis/Medial_axis_2.h>
#include <CGAL/Bounding_arcs_2/tree/Bounding_arc_tree_2.h>

#include <array>
#include <cstddef>
#include <vector>

namespace CGAL::Bounding_arcs {

/// A part of an edge: centers of discs that touch two arcs, which stand for the curves. With weights 1, `weight` and 1
/// the points are a rational quadratic Bezier curve: of a hyperbola where the weight is above 1, of a parabola where it
/// is 1, of an ellipse where it is below, and a line where the points are on one.
struct Axis_conic {
  std::size_t first = 0, last = 0;     ///< samples of the edge whose centers are its ends
  std::array<Xy<double>, 3> points{};  ///< control points
  double weight = 1;                   ///< of the middle one
  Arc_2 left, right;  ///< to the left and right of the way, against it and along it; a point: equal ends
  double error = 0;   ///< how far the axis is from it, radii included: an estimate
};

/// Returns an axis as conics, few for a tolerance.
/// \param axis of the tree's curves
/// \param eps how far the axis may be from conics of more than one step between samples; a positive length
/// \return of each edge conics one after the other, from its first sample to its last one. A line between two samples
///   is left where feet are on different segments and where they meet, next to leaves; its `error` is that of samples
/// \throws std::invalid_argument for an eps that is not positive
/// \guarantee the error is what discs differ from both arcs' by, at all samples and at three places of the conic as it
///   is written, and what the arcs' proven widths can make of it there; places between these are not looked at. Radii
///   are distances from either arc. A middle control point is no farther from an end than the ends are from each other
/// \complexity n log n in the samples of an edge; about eps^(-1/3) conics, where lines are eps^(-1/2)
/// \source fat arcs in place of curves: Barton, Elber 2011; their bisectors are conics, Farouki, Johnstone 1994
[[nodiscard]] std::vector<std::vector<Axis_conic>> axis_conics(const Bounding_arc_tree_2& tree,
                                                               const Medial_axis_2& axis, double eps);

}  // namespace CGAL::Bounding_arcs

#endif
