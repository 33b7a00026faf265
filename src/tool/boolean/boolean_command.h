// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The subcommand `boolean`: its options and its run.

#ifndef BOUNDING_ARCS_TOOL_BOOLEAN_BOOLEAN_COMMAND_H
#define BOUNDING_ARCS_TOOL_BOOLEAN_BOOLEAN_COMMAND_H

#include "../reading.h"
#include "../stream/record_stream.h"
#include "written_path.h"

#include <string>
#include <vector>

namespace CLI {
class App;
}

namespace bounding_arcs_tool {

struct Boolean_words {
  std::string operation, kernel = "filtered", format = "json", output, dxf = "polylines";
  std::vector<std::string> files;
  Stream_options stream{false, 1, true};
  Reading_words reading;
  Path_words path;
};

/// Adds the subcommand to the command line.
CLI::App* add_boolean_command(CLI::App& app, Boolean_words& words);

/// \return the exit status; bad input is thrown as Input_error
int run_boolean(const Boolean_words& words);

}  // namespace bounding_arcs_tool

#endif
