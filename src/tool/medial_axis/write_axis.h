// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// A medial axis as a table and as a drawing.

#ifndef BOUNDING_ARCS_TOOL_MEDIAL_AXIS_WRITE_AXIS_H
#define BOUNDING_ARCS_TOOL_MEDIAL_AXIS_WRITE_AXIS_H

#include "../written/Written_drawing.h"
#include "found_axis.h"

#include <ostream>

namespace bounding_arcs_tool {

/// A line a sample: its edge, place and radius, and the curves to its left and right.
void write_axis_csv(std::ostream& out, const Found_axis& found, const Query_drawing& loaded);

/// A curve an edge, "edge_0" the first, on one layer: conics where they were asked for, else lines between samples.
/// \param is_for_svg hyperbolas, which SVG has not, are lines between samples, too
[[nodiscard]] Written_drawing written_axis(const Found_axis& found, const Query_drawing& loaded, bool is_for_svg);

}  // namespace bounding_arcs_tool

#endif
