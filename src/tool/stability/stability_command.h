// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The subcommand `stability`: its options and its run.

#ifndef BOUNDING_ARCS_TOOL_STABILITY_COMMAND_H
#define BOUNDING_ARCS_TOOL_STABILITY_COMMAND_H

#include "../reading.h"

#include <CGAL/Bounding_arcs_2/study/Stability_study.h>

#include <cstddef>
#include <ostream>
#include <string>
#include <vector>

namespace CLI {
class App;
}

namespace bounding_arcs_tool {

struct Stability_options {
  std::vector<std::string> files, families;
  Reading_words reading;
  std::string curve;  ///< a JSON curve
  std::string format = "csv", output, worst;
  std::size_t count = 1000;  ///< of random spirals
  unsigned seed = 1;
  std::size_t jobs = 1;             ///< threads
  bool with_condition = false;      ///< rows have condition numbers
  bool is_of_costs = false;         ///< what exactness costs, in place of errors
  bool is_of_consequences = false;  ///< what goes wrong, in place of errors
  bool is_of_verdicts = false;      ///< predicates on grids of doubles, in place of errors
  CGAL::Bounding_arcs::Stability_choice choice;
  double hunt_seconds = 0;
  std::size_t hunt_steps = 0;
};

/// Adds the subcommand to the command line.
CLI::App* add_stability_command(CLI::App& app, Stability_options& options);

/// \return the exit status; bad input is thrown as Input_error
int run_stability(const Stability_options& options);

/// The rows of a study: of the curves in the files first, then of the families. \throws Input_error
[[nodiscard]] std::vector<CGAL::Bounding_arcs::Stability_row> study_stability(const Stability_options& options);

/// Draws the relative errors against delta, a panel a family and quantity (draw_stability.cpp).
void draw_stability(std::ostream& out, const std::vector<CGAL::Bounding_arcs::Stability_row>& rows);

}  // namespace bounding_arcs_tool

#endif
