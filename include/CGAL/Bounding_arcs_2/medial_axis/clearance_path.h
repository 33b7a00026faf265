// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The path between two points along which there is most room, by the axis: from a point away from what is nearest to it
// until a second thing is as near, then along the axis.

#ifndef CGAL_BOUNDING_ARCS_2_MEDIAL_AXIS_CLEARANCE_PATH_H
#define CGAL_BOUNDING_ARCS_2_MEDIAL_AXIS_CLEARANCE_PATH_H

#include <CGAL/Bounding_arcs_2/medial_axis/Medial_axis_2.h>
#include <CGAL/Bounding_arcs_2/query/kernel_points.h>
#include <CGAL/Bounding_arcs_2/tree/Bounding_arc_tree_2.h>

#include <optional>

namespace CGAL::Bounding_arcs {

/// Returns a path whose least clearance is as large as any path's; among those along the axis the shortest.
/// \param tree of the curves that the axis is of
/// \return nothing where a point is not in a region of the axis, or in one without edges, or they are in different ones
/// \guarantee the clearance along the path is within axis.eps of what lines between stations say. That no path has more
///   is as good as the axis (O'Dunlaing, Yap 1985: the way to the axis never loses clearance)
/// \throws std::invalid_argument for a point that is no number
/// \complexity n log n in the samples
[[nodiscard]] std::optional<Clearance_path> clearance_path(const Bounding_arc_tree_2& tree, const Medial_axis_2& axis,
                                                           const Asked_point& from, const Asked_point& to);

}  // namespace CGAL::Bounding_arcs

#endif
