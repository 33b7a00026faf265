// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// An axis without the branches that tell little of the shape.
//
// What a branch tells is by how much its discs stick out of the disc in which it begins:
//
//     significance = max |c - b| + r - R      over its leaves' discs (c, r), with (b, R) where it begins,
//
// and nothing of the region is lost beyond that distance from what is left.

#ifndef CGAL_BOUNDING_ARCS_2_MEDIAL_AXIS_PRUNED_H
#define CGAL_BOUNDING_ARCS_2_MEDIAL_AXIS_PRUNED_H

#include <CGAL/Bounding_arcs_2/medial_axis/Medial_axis_2.h>

namespace CGAL::Bounding_arcs {

/// An axis without branches whose discs stick out of the disc where they begin by less than a distance, the least
/// first.
/// \param significance in units of the coordinates; at most 0 leaves all
/// \guarantee discs of what is left, grown by that, cover the discs of what was taken away; regions stay connected and
///   keep an edge each
/// \complexity quadratic in the edges
[[nodiscard]] Medial_axis_2 pruned(Medial_axis_2 axis, double significance);

}  // namespace CGAL::Bounding_arcs

#endif
