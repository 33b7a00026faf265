// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "axis_cells.h"

#include "../query/query_command.h"

#include <cstddef>
#include <set>
#include <vector>

namespace bounding_arcs_tool {
void write_cells(std::ostream& out, const Cells& cells, const Bounding_arc_tree_2& curves) {
  out << "\"cells\":[\n";
  const char* between = "";
  for (const ba::Medial_axis_2::Cell& cell : cells) {
    out << between << "{\"curve\":" << cell.curve << ",\"run\":[" << json_of(curves, cell.first).dump() << ","
        << json_of(curves, cell.last).dump() << "],\"reversed\":" << (cell.is_reversed ? "true" : "false")
        << ",\"whole\":" << (cell.is_whole ? "true" : "false") << ",\"rim\":[";
    const char* comma = "";
    for (const ba::Medial_axis_2::Cell::Rim& part : cell.rim) {
      out << comma << "[" << part.edge << "," << part.first << "," << part.last << "," << part.beyond << "]";
      comma = ",";
    }
    out << "]";
    if (cell.rim.empty()) out << ",\"vertex\":" << cell.vertex;
    out << "}";
    between = ",\n";
  }
  out << "],";
}

void draw_cells(std::ostream& out, const Cells& cells, const Found_axis& found, const Bounding_arc_tree_2& curves,
                const Sheet& sheet) {
  std::vector<std::set<std::size_t>> neighbours(curves.drawing().curves().size());
  for (const ba::Medial_axis_2::Cell& cell : cells)
    for (const ba::Medial_axis_2::Cell::Rim& part : cell.rim) {
      neighbours[cell.curve].insert(part.beyond);
      neighbours[part.beyond].insert(cell.curve);
    }
  const std::vector<const char*> colour = colours_apart(neighbours);
  constexpr int PER_PIECE = 16;
  for (const ba::Medial_axis_2::Cell& cell : cells) {
    out << "<path style=\"fill:" << colour[cell.curve] << ";fill-opacity:0.25\" d=\"";
    const char* command = "M";
    for (const Xy<double>& p : cell.polygon(curves, found.axis, PER_PIECE)) {
      out << command << sheet.view(p);
      command = "L";
    }
    out << "Z\"/>\n";
  }
}

}  // namespace bounding_arcs_tool
