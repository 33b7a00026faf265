// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Outlines are behind their count (group 91) and in front of the style (75). Each begins with its flags (92). A
// polyline has vertices (10, 20) with bulges (42). Otherwise there are edges, each begun by its kind (72): a line (10,
// 20 to 11, 21), an arc or part of an ellipse, or a spline with groups much as a SPLINE has them. Sources (97, 330) are
// behind.

#include "dxf_hatch.h"

#include "Dxf_digits.h"

#include <CGAL/Bounding_arcs_2/curve/join_curves.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

namespace bounding_arcs_tool {
namespace {

using CGAL::Bounding_arcs::Drawing_2;

// Groups from each one of a code on, in front of the first of the code that ends them.
std::vector<Dxf_item> hatch_parts(const Dxf_item& item, int code, int end) {
  std::vector<Dxf_item> result;
  for (const Dxf_group& group : item.groups) {
    if (group.code == end && !result.empty()) break;
    if (group.code == code) result.push_back({item.kind, {}, false});
    if (!result.empty()) result.back().groups.push_back(group);
  }
  return result;
}

Dxf_curve outline_polyline(const Dxf_item& outline) {
  std::vector<Dxf_vertex> vertices;
  for (const Dxf_group& group : outline.groups) {
    if (group.code == 10) vertices.push_back({{real_value(group), 0}, 0});
    if (vertices.empty()) continue;
    if (group.code == 20) vertices.back().point.y = real_value(group);
    if (group.code == 42) vertices.back().bulge = real_value(group);
  }
  return polyline_curve(vertices, true);
}

// Angles of what runs clockwise are told as if y ran downwards.
Dxf_curve edge_arc(const Dxf_item& edge) {
  const Xy<double> center = point(edge, 10);
  const double r = edge.real(40), from = edge.real(50), to = edge.real(51);
  if (!(r > 0)) throw Dxf_left_out("radius 0");
  return conic_curve({r, 0, 0, edge.integer(73, 1) == 0 ? -r : r, center.x, center.y}, from,
                     end_of_range(from, to, last_place_of_angles(edge, 50, 51)));
}

// Angles are seen from the center: those of the circle that the ellipse is the image of differ.
Dxf_curve edge_ellipse(const Dxf_item& edge) {
  const Xy<double> center = point(edge, 10), axis = point(edge, 11);
  const double ratio = edge.real(40), side = edge.integer(73, 1) == 0 ? -ratio : ratio;
  if ((axis.x == 0 && axis.y == 0) || !(ratio > 0)) throw Dxf_left_out("an axis of length 0");
  const auto of_circle = [&](double angle) {
    const Svg_transform turn = svg_rotation(angle);
    constexpr double TURN = 360, DEGREES = 57.295779513082320877;
    const double within = std::atan2(turn.b / ratio, turn.a) * DEGREES;
    return within + TURN * std::round((angle - within) / TURN);
  };
  const double from = edge.real(50), to = edge.real(51);
  return conic_curve({axis.x, axis.y, -side * axis.y, side * axis.x, center.x, center.y}, of_circle(from),
                     of_circle(end_of_range(from, to, last_place_of_angles(edge, 50, 51))));
}

std::vector<Dxf_curve> edge_spline(Dxf_item edge) {
  edge.kind = "SPLINE";
  for (Dxf_group& group : edge.groups) {
    if (group.code == 94) group.code = 71;       // the degree
    else if (group.code == 42) group.code = 41;  // a weight
  }
  return dxf_entity_curves(edge, {}).curves;
}

std::vector<Dxf_curve> edge_curves(const Dxf_item& edge) {
  switch (edge.integer(72, 0)) {
    case 1:
      return {polyline_curve({{point(edge, 10), 0}, {point(edge, 11), 0}}, false)};
    case 2:
      return {edge_arc(edge)};
    case 3:
      return {edge_ellipse(edge)};
    case 4:
      return edge_spline(edge);
    default:
      throw Dxf_left_out("an edge of another kind");
  }
}

// Edges run either way and in any order; their ends are rounded.
std::vector<Dxf_curve> joined_edges(const std::vector<Dxf_curve>& edges) {
  // Four digits are what programs keep at least; details of a hatch are larger. Ten times less leaves some open.
  constexpr double ROUNDING = 0x1p-14;  // of the extent
  Drawing_2<double> drawing;
  double extent = 0;
  for (const Dxf_curve& edge : edges) {
    if (edge.empty()) continue;
    for (const auto& piece : edge)
      for (const Xy<double>& p : piece.control_points()) {
        const Xy<double> way = p - edges.front().front().control_points().front();
        extent = std::max({extent, std::fabs(way.x), std::fabs(way.y)});
      }
    drawing.add(edge);
  }
  std::vector<Dxf_curve> outlines;
  const auto result = CGAL::Bounding_arcs::join_curves(drawing, ROUNDING * extent);
  for (const auto& curve : result.drawing.curves()) {
    if (!curve.is_closed) throw Dxf_left_out("an outline that is not closed");
    outlines.push_back(curve.beziers);
  }
  return outlines;
}

}  // namespace

std::vector<Dxf_curve> dxf_hatch(const Dxf_item& item) {
  constexpr int FLAGS = 92, STYLE = 75, EDGE = 72, SOURCES = 330, POLYLINE = 2, OF_TEXT = 8;
  std::vector<Dxf_curve> outlines;
  for (const Dxf_item& outline : hatch_parts(item, FLAGS, STYLE)) {
    const long long flags = outline.integer(FLAGS, 0);
    if ((flags & OF_TEXT) != 0) continue;
    if ((flags & POLYLINE) != 0) {
      outlines.push_back(outline_polyline(outline));
      continue;
    }
    std::vector<Dxf_curve> edges;
    for (const Dxf_item& edge : hatch_parts(outline, EDGE, SOURCES))
      for (Dxf_curve& curve : edge_curves(edge))
        if (!curve.empty()) edges.push_back(std::move(curve));
    for (Dxf_curve& curve : joined_edges(edges)) outlines.push_back(std::move(curve));
  }
  if (outlines.empty()) throw Dxf_left_out("no outline");
  return outlines;
}

}  // namespace bounding_arcs_tool
