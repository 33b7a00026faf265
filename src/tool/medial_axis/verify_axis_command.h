// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The subcommand `verify-axis`: its options and its run.

#ifndef BOUNDING_ARCS_TOOL_MEDIAL_AXIS_VERIFY_AXIS_COMMAND_H
#define BOUNDING_ARCS_TOOL_MEDIAL_AXIS_VERIFY_AXIS_COMMAND_H

#include "medial_axis_command.h"

namespace bounding_arcs_tool {

struct Verify_axis_words {
  Medial_axis_words axis;  ///< the curves, the rule, the frame, and the output
  std::string written;     ///< the file of the axis
};

/// Adds the subcommand to the command line.
CLI::App* add_verify_axis_command(CLI::App& app, Verify_axis_words& words);
/// \return the exit status, 1 for an axis that is not right; bad input is thrown as Input_error
int run_verify_axis(const Verify_axis_words& words);

}  // namespace bounding_arcs_tool

#endif
