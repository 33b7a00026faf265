// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Bodies of Study_table.h.

#include "Study_table.h"

#include "../Commands.h"
#include "../option_words.h"
#include "study_stability.h"

#include <cstdio>
#include <cstdlib>

namespace bounding_arcs_tool {
namespace {

// The next delta is this share of the last one or less; those below the least are left out.
constexpr double NEXT_DELTA = 1.01e-4, LEAST_DELTA = 0.99e-20;

// A cell of JSON: a number, a word, or null.
std::string json_cell(const std::string& cell) {
  if (cell.empty()) return "null";
  char* end = nullptr;
  std::strtod(cell.c_str(), &end);
  return *end == 0 ? cell : json_string(cell);
}

void write_markdown(std::ostream& out, const Study_table& table) {
  const auto line = [&](const std::vector<std::string>& cells) {
    for (const std::string& cell : cells) out << "| " << cell << (cell.empty() ? "" : " ");
    out << "|\n";
  };
  line(table.columns);
  for (std::size_t i = 0; i < table.columns.size(); ++i) out << "|---";
  out << "|\n";
  for (const auto& row : table.rows) line(row);
}

void write_json(std::ostream& out, const Study_table& table) {
  out << '{' << provenance_members() << ",\n\"rows\":[";
  const char* separator = "\n";
  for (const auto& row : table.rows) {
    for (std::size_t i = 0; i < row.size(); ++i)
      out << (i == 0 ? separator : ",") << (i == 0 ? "{" : "") << json_string(table.columns[i]) << ':'
          << json_cell(row[i]);
    out << '}';
    separator = ",\n";
  }
  out << "]}\n";
}

void write_csv(std::ostream& out, const Study_table& table) {
  write_provenance(out);
  const auto line = [&](const std::vector<std::string>& cells) {
    for (std::size_t i = 0; i < cells.size(); ++i) out << (i == 0 ? "" : ",") << csv_field(cells[i]);
    out << '\n';
  };
  line(table.columns);
  for (const auto& row : table.rows) line(row);
}

}  // namespace

std::string digits(double x, int count) {
  char text[40];
  std::snprintf(text, sizeof text, "%.*g", count, x);
  return text;
}

void write_table(std::ostream& out, const Study_table& table, const std::string& format) {
  if (format == "json") write_json(out, table);
  else if (format == "markdown") write_markdown(out, table);
  else write_csv(out, table);
}

bool Picked_deltas::operator()(const std::string& family, double delta) {
  const bool counts_pieces = family == "curves" || family == "random" || family == "hunt";
  if (family != family_ || counts_pieces || (delta <= NEXT_DELTA * delta_ && delta >= LEAST_DELTA)) delta_ = delta;
  family_ = family;
  return delta == delta_;
}

}  // namespace bounding_arcs_tool
