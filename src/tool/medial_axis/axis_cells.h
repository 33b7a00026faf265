// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// What medial-axis writes of Voronoi cells.

#ifndef BOUNDING_ARCS_TOOL_AXIS_CELLS_H
#define BOUNDING_ARCS_TOOL_AXIS_CELLS_H

#include "found_axis.h"

#include "../svg_paths.h"

#include <CGAL/Bounding_arcs_2/medial_axis/voronoi_cells.h>

#include <ostream>
#include <vector>

namespace bounding_arcs_tool {

using Cells = std::vector<ba::Medial_axis_2::Cell>;

/// Writes `"cells":[...],`.
void write_cells(std::ostream& out, const Cells& cells, const Bounding_arc_tree_2& curves);
/// Draws each cell in a colour of its curve, another one than those of the curves next to it.
void draw_cells(std::ostream& out, const Cells& cells, const Found_axis& found, const Bounding_arc_tree_2& curves,
                const Sheet& sheet);

}  // namespace bounding_arcs_tool

#endif
