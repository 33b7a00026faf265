// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The subcommand `arrange`: its options and its run.

#ifndef BOUNDING_ARCS_TOOL_ARRANGE_ARRANGE_COMMAND_H
#define BOUNDING_ARCS_TOOL_ARRANGE_ARRANGE_COMMAND_H

#include "../reading.h"

#include <string>
#include <vector>

namespace CLI {
class App;
}

namespace bounding_arcs_tool {

struct Arrange_words {
  std::string format = "json", output, eps;
  std::vector<std::string> files;
  Reading_words reading;
};

/// Adds the subcommand to the command line.
CLI::App* add_arrange_command(CLI::App& app, Arrange_words& words);

/// \return the exit status; bad input is thrown as Input_error
int run_arrange(const Arrange_words& words);

}  // namespace bounding_arcs_tool

#endif
