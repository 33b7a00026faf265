// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// A table of what a study found, as CSV, JSON or Markdown.

#ifndef BOUNDING_ARCS_TOOL_STUDY_TABLE_H
#define BOUNDING_ARCS_TOOL_STUDY_TABLE_H

#include <ostream>
#include <string>
#include <vector>

namespace bounding_arcs_tool {

/// Cells are words or numbers as they are written; an empty one tells that there is nothing.
struct Study_table {
  std::vector<std::string> columns;
  std::vector<std::vector<std::string>> rows = {};
};

/// Writes a number in so many digits.
[[nodiscard]] std::string digits(double x, int count);

/// Writes a table. \param format csv, json or markdown; CSV and JSON begin with what made the figures
void write_table(std::ostream& out, const Study_table& table, const std::string& format);

/// Picks deltas for tables that are read: the first of a family, and then each that is some four powers of ten below
/// the one picked last, down to 1e-20.
class Picked_deltas {
 public:
  /// Tells whether rows of this family and delta are picked; families come one after the other, deltas falling.
  [[nodiscard]] bool operator()(const std::string& family, double delta);

 private:
  std::string family_;
  double delta_ = 0;
};

}  // namespace bounding_arcs_tool

#endif
