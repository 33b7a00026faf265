// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "query_command.h"

#include <CGAL/Bounding_arcs_2/query/convex_hull.h>
#include <CGAL/Bounding_arcs_2/query/enclosing_circle.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace bounding_arcs_tool {
namespace {

namespace ba = CGAL::Bounding_arcs;

Json json_of(const ba::Measure_bounds& m) { return Json::array({m.lower, m.upper}); }

Mark mark_of(const Bounding_arc_tree_2& curves, const ba::Convex_hull<>::Piece& piece) {
  constexpr int SAMPLES = 32;
  if (piece.is_bitangent) return {Mark::STRONG_LINE, {piece.from_point, piece.to_point}};
  Mark mark{Mark::STRONG_LINE, {}};
  const auto& bezier = curves.drawing().curves()[piece.from.curve].beziers[piece.from.bezier];
  for (int i = 0; i <= SAMPLES; ++i)
    mark.points.push_back(bezier.point(piece.from.t + (piece.to.t - piece.from.t) * i / SAMPLES));
  return mark;
}

Mark circle_mark(const Xy<double>& center, double radius) {
  constexpr int SIDES = 256;
  constexpr double TURN = 6.283185307179586;
  Mark mark{Mark::LINE, {}};
  for (int i = 0; i <= SIDES; ++i)
    mark.points.push_back(center + radius * Xy<double>{std::cos(TURN * i / SIDES), std::sin(TURN * i / SIDES)});
  return mark;
}

}  // namespace

// Where there is a curve all of these are there.
Query_answer hull_query(const Query_drawing& drawing, double eps) {
  check_has_curve(drawing);
  const Bounding_arc_tree_2& curves = *drawing.curves;
  const CGAL::Bbox_2 box = curves.box();
  constexpr double OF_EXTENT = 1e-6;
  const double extent = (std::max)(box.xmax() - box.xmin(), box.ymax() - box.ymin());
  const double tolerance = eps > 0 ? eps : OF_EXTENT * extent;
  const ba::Convex_hull<> hull = ba::convex_hull(curves, tolerance);
  const ba::Width_of_drawing<> width = ba::width(curves, tolerance).value();
  const ba::Diameter_of_drawing<> diameter = ba::diameter(curves, tolerance).value();
  const ba::Enclosing_circle<> circle = ba::smallest_enclosing_circle(curves, tolerance).value();
  Query_answer answer;
  answer.title = "convex hull: " + std::to_string(hull.pieces.size()) + " pieces";
  answer.columns = {"piece", "x from", "y from", "place from", "t from", "x to", "y to", "place to", "t to"};
  Json pieces = Json::array();
  for (const ba::Convex_hull<>::Piece& p : hull.pieces) {
    const char* type = p.is_bitangent ? "segment" : "curve";
    const auto end = [&](const Xy<double>& point, const Curve_place& place) {
      return Json{{"point", bounding_arcs_tool::json_of(point)}, {"place", bounding_arcs_tool::json_of(curves, place)}};
    };
    pieces.push_back({{"type", type}, {"from", end(p.from_point, p.from)}, {"to", end(p.to_point, p.to)}});
    answer.rows.push_back({type, digits(p.from_point.x), digits(p.from_point.y),
                           name_of_place(curves, p.from.curve, p.from.bezier), digits(p.from.t), digits(p.to_point.x),
                           digits(p.to_point.y), name_of_place(curves, p.to.curve, p.to.bezier), digits(p.to.t)});
    answer.marks.push_back(mark_of(curves, p));
  }
  answer.json = {
      {"pieces", std::move(pieces)},
      {"width", json_of(width.width)},
      {"diameter", json_of(diameter.diameter)},
      {"circle", {{"center", bounding_arcs_tool::json_of(circle.center)}, {"radius", json_of(circle.radius)}}}};
  add_status(answer.json, answer,
             (std::max)({hull.status, width.width.status, diameter.diameter.status, circle.radius.status}));
  answer.marks.push_back({Mark::LINE, {diameter.first_point, diameter.second_point}});
  answer.marks.push_back({Mark::DOT, {diameter.first_point}});
  answer.marks.push_back({Mark::DOT, {diameter.second_point}});
  answer.marks.push_back(circle_mark(circle.center, circle.radius.upper));
  return answer;
}

}  // namespace bounding_arcs_tool
