// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The subcommand `clip`: its options and its run.

#ifndef BOUNDING_ARCS_TOOL_BOOLEAN_CLIP_COMMAND_H
#define BOUNDING_ARCS_TOOL_BOOLEAN_CLIP_COMMAND_H

#include "../reading.h"
#include "written_path.h"

#include <string>

namespace CLI {
class App;
}

namespace bounding_arcs_tool {

struct Clip_words {
  std::string file, region, keep = "inside", kernel = "filtered", format = "json", output, dxf = "polylines";
  Reading_words reading;
  Path_words path;
};

/// Adds the subcommand to the command line.
CLI::App* add_clip_command(CLI::App& app, Clip_words& words);

/// \return the exit status; bad input is thrown as Input_error
int run_clip(const Clip_words& words);

}  // namespace bounding_arcs_tool

#endif
