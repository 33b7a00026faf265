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

/// A part of an edge as a conic. Two arcs stand for the curves beside the edge, and the conic has the centers of the
/// discs that touch both arcs. It is a rational quadratic Bezier curve of three points with the weights 1, `weight` and
/// 1: a part of a hyperbola where `weight` is above 1, of a parabola where it is 1, and of an ellipse where it is
/// below 1. It is a line where the points are on a line.
struct Medial_axis_2::Conic {
  std::size_t first = 0, last = 0;     ///< samples of the edge whose centers are its ends
  std::array<Xy<double>, 3> points{};  ///< control points
  double weight = 1;                   ///< of the middle one
  Arc_2 left, right;  ///< beside the edge: `left` runs against it, `right` runs along it; a point has equal ends
  double error = 0;   ///< how far the axis is from the conic, radii included: an estimate
};

/// Returns the edges of an axis as conics, few for a tolerance.
/// \param axis the medial axis of the tree's curves
/// \param eps how far the axis may be from a conic that joins more than two samples; a positive length
/// \return the conics of each edge one after the other, from the edge's first sample to its last one. A line stays
///   between two samples whose feet are on different segments, or meet as they do next to leaves; its `error` is that
///   of samples
/// \throws std::invalid_argument for an eps that is not positive
/// \guarantee `error` is an estimate. It compares the discs of all samples, and those of three places of the conic as
///   it is written, with the discs of the two arcs. It adds what the arcs' proven widths can change there. Places
///   between are not looked at. Radii are distances from either arc. A middle control point is no farther from an end
///   than the ends are from each other
/// \complexity n log n in the samples of an edge; about eps^(-1/3) conics, where lines are eps^(-1/2)
/// \source fat arcs in place of curves: Barton, Elber 2011; their bisectors are conics, Farouki, Johnstone 1994
[[nodiscard]] std::vector<std::vector<Medial_axis_2::Conic>> axis_conics(const Bounding_arc_tree_2& tree,
                                                                         const Medial_axis_2& axis, double eps);

}  // namespace CGAL::Bounding_arcs

#endif
