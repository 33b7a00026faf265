// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The parts of the subcommand `stability`: what is measured, and how its rows are written.

#ifndef BOUNDING_ARCS_TOOL_STUDY_STABILITY_H
#define BOUNDING_ARCS_TOOL_STUDY_STABILITY_H

#include "stability_command.h"

#include <ostream>
#include <vector>

namespace bounding_arcs_tool {

/// The worst rows of a hunt, whose number of steps is said on standard error where seconds limit it.
[[nodiscard]] std::vector<CGAL::Bounding_arcs::Stability_row> hunt_stability(const Stability_options& options);

/// Adds the condition numbers of their figures to rows.
void add_conditions(std::vector<CGAL::Bounding_arcs::Stability_row>& rows);

/// What made the figures: "bounding_arcs 0.1.0", the compiler, its flags, and the instruction set that is used.
struct Provenance {
  std::string version, compiler, flags, instruction_set;
};
[[nodiscard]] Provenance provenance();

/// Writes rows, each with its curve and the command that gives it again.
void write_stability_csv(std::ostream& out, const std::vector<CGAL::Bounding_arcs::Stability_row>& rows,
                         const Stability_options& options);
void write_stability_json(std::ostream& out, const std::vector<CGAL::Bounding_arcs::Stability_row>& rows,
                          const Stability_options& options);
/// Writes the curve of the worst row of each family, method, formula, kernel and quantity as a file of curves.
void write_worst_curves(std::ostream& out, const std::vector<CGAL::Bounding_arcs::Stability_row>& rows);

}  // namespace bounding_arcs_tool

#endif
