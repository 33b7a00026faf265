// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// bounding_arcs stability --consequences: what goes wrong where rounded figures are believed.

#include "Study_table.h"
#include "study_stability.h"

#include <CGAL/Bounding_arcs_2/study/Consequence_study.h>

namespace bounding_arcs_tool {
namespace {

using namespace CGAL::Bounding_arcs;

constexpr std::size_t MOST_PIECES = 30;  // of a delta

std::string share(std::size_t part, std::size_t all) {
  return digits(static_cast<double>(part) / static_cast<double>(all), 2);
}

}  // namespace

Study_table consequence_table(const Stability_options& options) {
  Study_table table{
      {"family", "delta", "method", "formula", "wrong verdicts", "not held", "wrong counts", "torn offsets"}};
  for_each_delta(options, MOST_PIECES, [&](const std::vector<Study_piece>& pieces) {
    for (const Consequence_row& r : consequence_rows(pieces)) {
      if (!Stability_choice::names(options.choice.methods, r.method)) continue;
      const auto add = [&](const char* formula, const Consequences& c) {
        if (Stability_choice::names(options.choice.formulas, formula))
          table.rows.push_back({r.family, digits(r.delta, 2), r.method, formula, share(c.wrong, c.asked),
                                share(c.not_held, r.pieces), share(c.miscounted, r.pieces), share(c.torn, r.pieces)});
      };
      add("textbook", r.textbook);
      add("stable", r.stable);
    }
  });
  return table;
}

}  // namespace bounding_arcs_tool
