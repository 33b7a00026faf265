// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The parts of the subcommand `stability`: what is measured, and how its rows are written.

#ifndef BOUNDING_ARCS_TOOL_STUDY_STABILITY_H
#define BOUNDING_ARCS_TOOL_STUDY_STABILITY_H

#include "Study_table.h"
#include "stability_command.h"

#include <functional>

#include <ostream>
#include <vector>

namespace bounding_arcs_tool {

/// The worst rows of a hunt, whose number of steps is said on standard error where seconds limit it.
[[nodiscard]] std::vector<CGAL::Bounding_arcs::Stability_row> hunt_stability(const Stability_options& options);

/// Adds the condition numbers of their figures to rows.
void add_conditions(std::vector<CGAL::Bounding_arcs::Stability_row>& rows);

/// Calls use(pieces) with pieces of each picked delta of the chosen families and curves, at most so many, evenly taken.
void for_each_delta(const Stability_options& options, std::size_t most,
                    const std::function<void(const std::vector<CGAL::Bounding_arcs::Study_piece>&)>& use);

/// What exactness costs: bits, times over that of double, and the share of each stage of the filter (study_costs.cpp).
[[nodiscard]] Study_table cost_table(const Stability_options& options);

/// What goes wrong in double without a filter: shares of wrong verdicts, of pieces that regions do not hold, and of
/// pieces with a wrong number of regions (study_consequences.cpp).
[[nodiscard]] Study_table consequence_table(const Stability_options& options);

/// Counts wrong verdicts of rounded figures on grids of neighbouring doubles, and draws them (draw_verdicts.cpp).
[[nodiscard]] Study_table verdict_table();
void draw_verdicts(std::ostream& out);

/// What made the figures: "bounding_arcs 0.1.0", the compiler, its flags, and the instruction set that is used.
struct Provenance {
  std::string version, compiler, flags, instruction_set;
};
[[nodiscard]] Provenance provenance();
/// Writes it as lines of comments before a table in CSV.
void write_provenance(std::ostream& out);
/// Returns it as members of an object in JSON.
[[nodiscard]] std::string provenance_members();

/// Writes rows, each with its curve and the command that gives it again.
void write_stability_csv(std::ostream& out, const std::vector<CGAL::Bounding_arcs::Stability_row>& rows,
                         const Stability_options& options);
void write_stability_json(std::ostream& out, const std::vector<CGAL::Bounding_arcs::Stability_row>& rows,
                          const Stability_options& options);
/// Writes a table in Markdown: a row for each family, delta, method, formula and kernel, a column for each step, with
/// condition numbers in parentheses. It has the Picked_deltas.
void write_stability_table(std::ostream& out, const std::vector<CGAL::Bounding_arcs::Stability_row>& rows);
/// Writes the curve of the worst row of each family, method, formula, kernel and quantity as a file of curves.
void write_worst_curves(std::ostream& out, const std::vector<CGAL::Bounding_arcs::Stability_row>& rows);

}  // namespace bounding_arcs_tool

#endif
