// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// bounding_arcs info: what a drawing is read as, a line a curve, before anything is done with it.

#ifndef BOUNDING_ARCS_TOOL_INFO_INFO_COMMAND_H
#define BOUNDING_ARCS_TOOL_INFO_INFO_COMMAND_H

#include "../reading.h"

#include <string>

namespace CLI {
class App;
}

namespace bounding_arcs_tool {

struct Info_words {
  std::string file, format = "table", output;
  Reading_words reading;
};

/// Adds the subcommand to the command line.
CLI::App* add_info_command(CLI::App& app, Info_words& words);

/// \return the exit status; bad input is thrown as Input_error
int run_info(const Info_words& words);

}  // namespace bounding_arcs_tool

#endif
