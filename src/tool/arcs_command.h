// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The subcommand `arcs`: its options and its run.

#ifndef BOUNDING_ARCS_TOOL_ARCS_COMMAND_H
#define BOUNDING_ARCS_TOOL_ARCS_COMMAND_H

#include "reading.h"
#include "stream/record_stream.h"
#include "toolpath/gcode_options.h"

#include <cstddef>
#include <string>
#include <vector>

namespace CLI {
class App;
}

namespace bounding_arcs_tool {

struct Arcs_options {
  std::vector<std::string> files;
  std::string eps, continuity = "tangent", side = "two", format = "table", output, dxf = "polylines";
  std::size_t repeat = 5, max_arcs = 20'000'000;
  bool is_plain = false;
  Gcode_words gcode;
  Stream_options stream;
  Reading_words reading;
};

/// Adds the subcommand to the command line.
CLI::App* add_arcs_command(CLI::App& app, Arcs_options& options);

/// \return the exit status; bad input is thrown as Input_error
int run_arcs(const Arcs_options& options);

}  // namespace bounding_arcs_tool

#endif
