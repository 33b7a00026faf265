// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The subcommand `offset`: its options and its run.

#ifndef BOUNDING_ARCS_TOOL_OFFSET_OFFSET_COMMAND_H
#define BOUNDING_ARCS_TOOL_OFFSET_OFFSET_COMMAND_H

#include "../Hierarchy.h"
#include "../query/query_command.h"
#include "../reading.h"
#include "../stream/record_stream.h"
#include "../toolpath/gcode_options.h"

#include <string>
#include <vector>

namespace CLI {
class App;
}

namespace bounding_arcs_tool {

struct Offset_words {
  std::string file, distances, eps, join = "round", cap = "round", side = "both", format = "json";
  std::string output, dxf = "polylines";
  double miter_limit = 4;
  bool is_plain = false;
  Gcode_words gcode;
  Stream_options stream;
  Reading_words reading;
};

/// What is wrong with a list of distances, or nothing.
[[nodiscard]] std::string check_distances(const std::string& list);

/// An offset as arcs and segments only.
struct Offset_outline {
  double distance;
  std::vector<std::vector<Arc_2>> chains;
};
/// One for each of the distances. \throws Input_error
[[nodiscard]] std::vector<Offset_outline> offset_outlines(const Offset_words& words, const Query_drawing& loaded);

/// Adds the subcommand to the command line.
CLI::App* add_offset_command(CLI::App& app, Offset_words& words);

/// \return the exit status; bad input is thrown as Input_error
int run_offset(const Offset_words& words);

}  // namespace bounding_arcs_tool

#endif
