// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// What the command line says of G-code.

#ifndef BOUNDING_ARCS_TOOL_TOOLPATH_GCODE_OPTIONS_H
#define BOUNDING_ARCS_TOOL_TOOLPATH_GCODE_OPTIONS_H

#include "../reading.h"
#include "gcode_moves.h"

#include <cstddef>
#include <ostream>
#include <string>
#include <vector>

namespace CLI {
class App;
}

namespace bounding_arcs_tool {

/// In units of G-code; 0 stands for a default but for the depth.
struct Gcode_words {
  double feed = 0, depth = 0, safe_height = 0, shortest_arc = 0;
  std::size_t digits = 0;
  std::string header;  ///< a file
};

/// Adds the options --feed, --safe-height, --digits, --shortest-arc and --header, and --depth where it is asked for.
void add_gcode_options(CLI::App& command, Gcode_words& words, bool with_depth);

/// Refuses words that lack what G-code needs. To be called before what takes long. \throws Usage_error
void check_gcode_words(const Gcode_words& words);

/// How a drawing becomes G-code: inches stay inches, all else becomes mm. It is told where lengths change, and where
/// there is no unit.
/// \throws Input_error for a header that cannot be read
[[nodiscard]] Gcode_setup gcode_setup(const Gcode_words& words, const File_unit& unit, bool flips);

/// Writes passes as they are given. \throws Input_error where that cannot be done with these digits
void write_gcode(std::ostream& out, const std::string& file, const std::vector<Tool_pass>& passes,
                 const Gcode_setup& setup);

}  // namespace bounding_arcs_tool

#endif
