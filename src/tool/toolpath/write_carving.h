// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// A carving as CSV, as a drawing for DXF, and as G-code.

#ifndef BOUNDING_ARCS_TOOL_TOOLPATH_WRITE_CARVING_H
#define BOUNDING_ARCS_TOOL_TOOLPATH_WRITE_CARVING_H

#include "../written/Written_drawing.h"
#include "gcode_moves.h"
#include "v_carving.h"

#include <ostream>
#include <string>

namespace bounding_arcs_tool {

/// A line a vertex: the number of its path, carve or pocket, x, y, z, and the bulge of the piece that starts there.
void write_carving_csv(std::ostream& out, const V_carving& carving);

/// Branches with heights on the layer carve, red, and pockets at their depth on the layer pocket, blue.
/// \param unit_in_mm 0 for none
[[nodiscard]] Written_drawing written_carving(const V_carving& carving, bool y_is_down, double unit_in_mm);

/// Branches, then pockets. \throws Input_error as write_gcode
void write_carving_gcode(std::ostream& out, const std::string& file, const V_carving& carving,
                         const Gcode_setup& setup);

}  // namespace bounding_arcs_tool

#endif
