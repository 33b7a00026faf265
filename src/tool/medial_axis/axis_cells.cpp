// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "axis_cells.h"

#include "../query/query_command.h"

#include <algorithm>
#include <cstddef>
#include <iterator>
#include <set>

namespace bounding_arcs_tool {
namespace {

constexpr const char* COLOURS[] = {"#0072b2", "#e69f00", "#009e73", "#cc79a7", "#56b4e9", "#f0e442", "#d55e00"};

// A colour of each curve.
std::vector<std::size_t> colours(const Cells& cells, std::size_t count) {
  std::vector<std::set<std::size_t>> next(count);
  for (const ba::Voronoi_cell& cell : cells)
    for (const ba::Voronoi_cell::Rim& part : cell.rim) {
      next[cell.curve].insert(part.beyond);
      next[part.beyond].insert(cell.curve);
    }
  std::vector<std::size_t> colour(count, std::size(COLOURS));
  for (std::size_t i = 0; i < count; ++i) {
    bool is_taken[std::size(COLOURS) + 1] = {};
    for (const std::size_t k : next[i]) is_taken[colour[k]] = true;
    const auto* const free = std::find(std::begin(is_taken), std::end(is_taken) - 1, false);
    colour[i] = static_cast<std::size_t>(free - is_taken) % std::size(COLOURS);
  }
  return colour;
}

}  // namespace

void write_cells(std::ostream& out, const Cells& cells, const Drawing_hierarchy& curves) {
  out << "\"cells\":[\n";
  const char* between = "";
  for (const ba::Voronoi_cell& cell : cells) {
    out << between << "{\"curve\":" << cell.curve << ",\"run\":[" << json_of(curves, cell.first).dump() << ","
        << json_of(curves, cell.last).dump() << "],\"reversed\":" << (cell.is_reversed ? "true" : "false")
        << ",\"whole\":" << (cell.is_whole ? "true" : "false") << ",\"rim\":[";
    const char* comma = "";
    for (const ba::Voronoi_cell::Rim& part : cell.rim) {
      out << comma << "[" << part.edge << "," << part.first << "," << part.last << "," << part.beyond << "]";
      comma = ",";
    }
    out << "]}";
    between = ",\n";
  }
  out << "],";
}

void draw_cells(std::ostream& out, const Cells& cells, const Found_axis& found, const Drawing_hierarchy& curves,
                const Sheet& sheet) {
  const std::vector<std::size_t> colour = colours(cells, curves.drawing().curves().size());
  constexpr int PER_PIECE = 16;
  for (const ba::Voronoi_cell& cell : cells) {
    out << "<path style=\"fill:" << COLOURS[colour[cell.curve]] << ";fill-opacity:0.25\" d=\"";
    const char* command = "M";
    for (const Xy<double>& p : ba::internal::cell_polygon(curves, found.axis, cell, PER_PIECE)) {
      out << command << sheet.view(p);
      command = "L";
    }
    out << "Z\"/>\n";
  }
}

}  // namespace bounding_arcs_tool
