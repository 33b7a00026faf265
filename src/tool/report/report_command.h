// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The subcommand `report`: its options and its run.

#ifndef BOUNDING_ARCS_TOOL_REPORT_REPORT_COMMAND_H
#define BOUNDING_ARCS_TOOL_REPORT_REPORT_COMMAND_H

#include "../Commands.h"
#include "../reading.h"

#include <string>
#include <vector>

namespace CLI {
class App;
}

namespace bounding_arcs_tool {

struct Report_words {
  std::vector<std::string> files, queries, families{"subdivision"};
  std::string output, eps, methods = "bca,bilens,sfa", kernel = "double", points, distances;
  Reading_words reading;
  bool with_medial_axis = false;
  std::size_t repeat = 3, max_regions = 20'000'000;
  double max_size = 8;  ///< MiB
};

/// Adds the subcommand to the command line.
CLI::App* add_report_command(CLI::App& app, Report_words& words);

/// \return the exit status; bad input is thrown as Input_error
int run_report(const Report_words& words);

}  // namespace bounding_arcs_tool

#endif
