// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// A vertex of an MLINE has a place (groups 11, 21), the direction of the line behind it (12, 22), and a miter's
// direction (13, 23). Behind these is, element by element, a count (74) of numbers (41): how far along the miter the
// element is from the vertex, then where its line begins, and where it is cut.

#include "dxf_multiline.h"

#include <cstddef>
#include <vector>

namespace bounding_arcs_tool {
namespace {

struct Multiline_vertex {
  Xy<double> place, miter{0, 0};
  std::vector<double> ways;  // of each element, along the miter
};

// Vertices, and whether elements are cut.
struct Multiline {
  std::vector<Multiline_vertex> vertices;
  bool is_cut = false;
};
Multiline multiline_groups(const Dxf_item& item) {
  constexpr int PLACE_X = 11, PLACE_Y = 21, MITER_X = 13, MITER_Y = 23, COUNT = 74, NUMBER = 41;
  Multiline line;
  std::size_t number = 0;  // of those of an element
  for (const Dxf_group& group : item.groups) {
    if (group.code == PLACE_X) line.vertices.push_back({{real_value(group), 0}, {0, 0}, {}});
    if (line.vertices.empty()) continue;
    Multiline_vertex& vertex = line.vertices.back();
    if (group.code == PLACE_Y) vertex.place.y = real_value(group);
    if (group.code == MITER_X) vertex.miter.x = real_value(group);
    if (group.code == MITER_Y) vertex.miter.y = real_value(group);
    if (group.code == COUNT) number = 0;
    if (group.code != NUMBER) continue;
    const double value = real_value(group);
    if (number == 0) vertex.ways.push_back(value);
    else line.is_cut = line.is_cut || number > 1 || value != 0;
    ++number;
  }
  return line;
}

}  // namespace

Dxf_drawn dxf_multiline(const Dxf_item& item) {
  constexpr int CLOSED = 2;  // of group 71
  const Multiline line = multiline_groups(item);
  if (line.vertices.size() < 2) throw Dxf_left_out("length 0");
  const std::size_t count = line.vertices.front().ways.size();
  if (count == 0) throw Dxf_left_out("no elements");
  Dxf_drawn drawn{{}, line.is_cut ? "cut, read without its gaps" : ""};
  for (std::size_t k = 0; k < count; ++k) {
    std::vector<Dxf_vertex> vertices;
    for (const Multiline_vertex& vertex : line.vertices) {
      if (vertex.ways.size() != count) throw Dxf_left_out("a vertex with other elements");
      vertices.push_back({vertex.place + vertex.ways[k] * vertex.miter, 0});
    }
    drawn.curves.push_back(polyline_curve(vertices, (item.integer(71, 0) & CLOSED) != 0));
  }
  return drawn;
}

}  // namespace bounding_arcs_tool
