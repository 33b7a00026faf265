// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// G-code as text: written, read back, and compared with the passes that it is of.

#ifndef BOUNDING_ARCS_TOOL_TOOLPATH_WRITE_GCODE_H
#define BOUNDING_ARCS_TOOL_TOOLPATH_WRITE_GCODE_H

#include "gcode_moves.h"

#include <ostream>
#include <string>
#include <vector>

namespace bounding_arcs_tool {

/// The lines from the units to the end of the program, without the header. Each move has all its words, and comments
/// tell of passes. What is not ASCII or would end a comment is _ there.
[[nodiscard]] std::string gcode_text(const Gcode_program& program, const std::vector<Tool_pass>& passes,
                                     const Gcode_setup& setup);

/// The moves of such a text, by its words alone. \throws std::invalid_argument for any other text
[[nodiscard]] std::vector<Gcode_move> read_gcode(const std::string& text, const Gcode_setup& setup);

/// Compares moves with the passes: all pieces are there one after the other, each within MOVE_ERROR, at its height
/// within a unit of the last digit, and nothing else is cut. \throws std::invalid_argument where they differ
void check_gcode(const std::vector<Gcode_move>& moves, const Gcode_program& program,
                 const std::vector<Tool_pass>& passes, const Gcode_setup& setup);

/// Writes passes one after the other, as they are given, behind the header. What is written was read back and checked.
/// \throws std::invalid_argument as gcode_program and check_gcode
void write_gcode(std::ostream& out, const std::vector<Tool_pass>& passes, const Gcode_setup& setup);

}  // namespace bounding_arcs_tool

#endif
