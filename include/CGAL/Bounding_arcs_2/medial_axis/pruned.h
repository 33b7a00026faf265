// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// An axis without what tells little of the shape: branches, or ends along which the two feet of discs are close.
//
// What a branch tells is by how much its discs stick out of the disc in which it begins:
//
//     significance = max |c - b| + r - R      over its leaves' discs (c, r), with (b, R) where it begins,
//
// and nothing of the region is lost beyond that distance from what is left. What two feet tell:
//
//         p                the angle pcq, pi where a strip is straight, pi - a along the bisector of a corner of the
//        / \               angle a, 0 at a maximum of curvature (Foskey, Lin, Manocha 2003: theta);
//    ---c---'---           half of |pq|, the radius of the smallest disc around the feet
//        \ /                                              (Chazal, Lieutier 2005: lambda)
//         q

#ifndef CGAL_BOUNDING_ARCS_2_MEDIAL_AXIS_PRUNED_H
#define CGAL_BOUNDING_ARCS_2_MEDIAL_AXIS_PRUNED_H

#include <CGAL/Bounding_arcs_2/medial_axis/Medial_axis_2.h>
#include <CGAL/Bounding_arcs_2/tree/Bounding_arc_tree_2.h>

namespace CGAL::Bounding_arcs {

/// An axis without branches whose discs stick out of the disc where they begin by less than a distance, the least
/// first.
/// \param significance in units of the coordinates; at most 0 leaves all
/// \guarantee discs of what is left, grown by that, cover the discs of what was taken away; regions stay connected and
///   keep an edge each
/// \complexity quadratic in the edges
[[nodiscard]] Medial_axis_2 pruned(Medial_axis_2 axis, double significance);

/// What stays of an axis: feet that are as far apart as both say.
struct Medial_axis_2::Feet_apart {
  double angle = 0;          ///< seen from the center, in radians, at most 2: more would leave nothing of a triangle
  double half_distance = 0;  ///< in units of the coordinates
};

/// Returns an axis without what runs from its leaves to the first sample whose feet are far enough apart. That is an
/// end of an edge, an edge, or, where all edges but one of a vertex are gone, what goes on there. An edge stays whole
/// where its only sample whose feet are so is its other end and there is none between, as along the bisector of a
/// corner. Where feet come together between two discs that are kept, all stays, so that regions stay connected and keep
/// their holes.
/// \param tree of the curves that the places of the axis are of
/// \guarantee samples are those of the axis; new leaves are some of them, with a bracket of their clearance
/// \throws std::invalid_argument for an angle that is not in [0, 2] or a distance below 0
/// \complexity linear in the samples
[[nodiscard]] Medial_axis_2 trimmed(const Bounding_arc_tree_2& tree, Medial_axis_2 axis,
                                    const Medial_axis_2::Feet_apart& apart);

}  // namespace CGAL::Bounding_arcs

#endif
