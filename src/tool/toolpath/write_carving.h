// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// A carving as CSV, as a drawing for DXF, as G-code, and as a picture.

#ifndef BOUNDING_ARCS_TOOL_TOOLPATH_WRITE_CARVING_H
#define BOUNDING_ARCS_TOOL_TOOLPATH_WRITE_CARVING_H

#include <CGAL/Bounding_arcs_2/curve/Drawing_2.h>

#include "../written/Written_drawing.h"
#include "gcode_moves.h"
#include "v_carving.h"

#include <ostream>
#include <string>

namespace bounding_arcs_tool {

/// A line a vertex: the number of its path, carve, pocket or flat, x, y, z, and the bulge of the piece that starts
/// there.
void write_carving_csv(std::ostream& out, const V_carving& carving);

/// Branches with heights on the layer carve, red, pockets at their depth on the layer pocket, blue, and
/// passes of the flat tool on the layer flat, green.
/// \param unit_in_mm 0 for none
[[nodiscard]] Written_drawing written_carving(const V_carving& carving, bool y_is_down, double unit_in_mm);

/// Passes of one tool: of the flat one where there are any, else of the bit. \throws Input_error as write_gcode
void write_carving_gcode(std::ostream& out, const std::string& file, const V_carving& carving,
                         const Gcode_setup& setup);

/// Draws all passes over the curves in colours of their depths, with a scale, and ways through the air dashed.
void draw_carving(std::ostream& out, const V_carving& carving, const CGAL::Bounding_arcs::Drawing_2<double>& curves,
                  bool flips);

}  // namespace bounding_arcs_tool

#endif
