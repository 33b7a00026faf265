// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The rows of a study of stability as a table for a page: where in a construction the digits are lost.

#include "Study_table.h"
#include "study_stability.h"

#include <cmath>
#include <iterator>
#include <map>
#include <string>

namespace bounding_arcs_tool {
namespace {

using CGAL::Bounding_arcs::Stability_row;

// The steps in their order; outside is none of them.
const char* const STEPS[] = {"normal", "bisector", "center", "radius", "joint", "thickness"};
constexpr std::size_t WORDS = 5;  // columns before them

std::string brief(double x) { return x >= 1 && x < 1000 ? std::to_string(std::lround(x)) : digits(x, 1); }

std::string cell(const Stability_row& row) {
  const std::string error = brief(row.rel_error);
  return row.condition ? error + " (" + brief(*row.condition) + ")" : error;
}

}  // namespace

void write_stability_table(std::ostream& out, const std::vector<Stability_row>& rows) {
  Study_table table{{"family", "delta", "method", "formula", "kernel"}};
  for (const char* step : STEPS) table.columns.emplace_back(step);
  std::map<std::vector<std::string>, std::size_t> places;  // of words in the table
  Picked_deltas is_picked;
  for (const Stability_row& row : rows) {
    if (!is_picked(row.family, row.delta)) continue;
    const std::vector<std::string> words{row.family, digits(row.delta, 2), row.method, row.formula, row.kernel};
    const auto place = places.emplace(words, table.rows.size());
    if (place.second) {
      table.rows.push_back(words);
      table.rows.back().resize(table.columns.size());
    }
    for (std::size_t i = 0; i < std::size(STEPS); ++i)
      if (row.quantity == STEPS[i]) table.rows[place.first->second][WORDS + i] = cell(row);
  }
  write_table(out, table, "markdown");
}

}  // namespace bounding_arcs_tool
