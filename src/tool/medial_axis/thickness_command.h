// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// bounding_arcs thickness: how thick shapes are, and where they are narrow.

#ifndef BOUNDING_ARCS_TOOL_MEDIAL_AXIS_THICKNESS_COMMAND_H
#define BOUNDING_ARCS_TOOL_MEDIAL_AXIS_THICKNESS_COMMAND_H

#include "medial_axis_command.h"

#include <limits>

namespace bounding_arcs_tool {

struct Thickness_words {
  Medial_axis_words axis;  ///< the curves, eps, the rule, the frame, the form and the output
  double below = std::numeric_limits<double>::infinity();  ///< the limit; infinite for none
  double corner = 60;                                      ///< sharper corners are thin places, in degrees
};

/// Adds the subcommand to the command line.
CLI::App* add_thickness_command(CLI::App& app, Thickness_words& words);
/// \return the exit status; bad input is thrown as Input_error
int run_thickness(const Thickness_words& words);

}  // namespace bounding_arcs_tool

#endif
