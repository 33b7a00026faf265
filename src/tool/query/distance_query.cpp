// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "query_command.h"

#include "../number_text.h"

#include <CGAL/Bounding_arcs_2/query/distance.h>

#include <algorithm>
#include <utility>

namespace bounding_arcs_tool {
namespace {

namespace ba = CGAL::Bounding_arcs;

Json json_of(const ba::Bracket& d) { return Json::array({d.lower, d.upper}); }
Json json_of(const Bounding_arc_tree_2& curves, const ba::Drawing_distance<>::End& p) {
  return {{"point", bounding_arcs_tool::json_of(p.point)}, {"place", bounding_arcs_tool::json_of(curves, p.place)}};
}

void add_distance(Query_answer& answer, const char* what, const ba::Drawing_distance<>& d, const Bounding_arc_tree_2& a,
                  const Bounding_arc_tree_2& b) {
  answer.columns = {"what", "least", "most", "x a", "y a", "place a", "t a", "x b", "y b", "place b", "t b"};
  std::vector<std::string> row{what, digits(d.distance.lower), digits(d.distance.upper)};
  const auto add = [&row](const Bounding_arc_tree_2& curves, const ba::Drawing_distance<>::End& p) {
    for (const std::string& field : {digits(p.point.x), digits(p.point.y),
                                     name_of_place(curves, p.place.curve, p.place.bezier), digits(p.place.t)})
      row.push_back(field);
  };
  add(a, d.a);
  add(b, d.b);
  answer.rows.push_back(std::move(row));
  answer.marks.push_back({Mark::LINE, {d.a.point, d.b.point}});
  answer.marks.push_back({Mark::DOT, {d.a.point}});
  answer.marks.push_back({Mark::DOT, {d.b.point}});
}

// The widest bracket where nothing else is asked for: 1e-9 of the drawings together.
double tolerance_of(const Bounding_arc_tree_2& a, const Bounding_arc_tree_2& b, double eps) {
  if (eps > 0) return eps;
  constexpr double OF_EXTENT = 1e-9;
  const CGAL::Bbox_2 box = a.box() + b.box();
  const double extent = (std::max)(box.xmax() - box.xmin(), box.ymax() - box.ymin());
  return extent > 0 ? OF_EXTENT * extent : OF_EXTENT;
}

}  // namespace

// Between curves there is a distance.
Query_answer distance_query(const Query_drawing& a, const Query_drawing& b, double eps) {
  check_has_curve(a);
  check_has_curve(b);
  const ba::Drawing_distance<> d =
      (eps > 0 ? ba::distance(*a.curves, *b.curves, eps) : ba::distance(*a.curves, *b.curves)).value();
  Query_answer answer;
  answer.title = "distance: " + short_number(d.distance.upper);
  answer.json = {{"distance", json_of(d.distance)}, {"a", json_of(*a.curves, d.a)}, {"b", json_of(*b.curves, d.b)}};
  // of curves that meet, a part of the distance is never reached
  if (d.distance.lower > 0 || d.status == ba::Query_status::LIMIT_REACHED) add_status(answer.json, answer, d.status);
  add_distance(answer, "distance", d, *a.curves, *b.curves);
  return answer;
}

Query_answer hausdorff_query(const Query_drawing& a, const Query_drawing& b, double eps) {
  check_has_curve(a);
  check_has_curve(b);
  const double tolerance = tolerance_of(*a.curves, *b.curves, eps);
  const ba::Drawing_distance<> from_a = ba::directed_hausdorff_distance(*a.curves, *b.curves, tolerance).value();
  ba::Drawing_distance<> from_b = ba::directed_hausdorff_distance(*b.curves, *a.curves, tolerance).value();
  std::swap(from_b.a, from_b.b);
  const bool is_of_a = from_a.distance.upper >= from_b.distance.upper;
  const ba::Drawing_distance<>& both = is_of_a ? from_a : from_b;
  const ba::Bracket d{(std::max)(from_a.distance.lower, from_b.distance.lower),
                      (std::max)(from_a.distance.upper, from_b.distance.upper)};
  Query_answer answer;
  answer.title = "Hausdorff distance: " + short_number(d.upper);
  answer.json = {{"distance", json_of(d)},
                 {"directed", {json_of(from_a.distance), json_of(from_b.distance)}},
                 {"a", json_of(*a.curves, both.a)},
                 {"b", json_of(*b.curves, both.b)}};
  add_status(answer.json, answer, (std::max)(from_a.status, from_b.status));
  add_distance(answer, "from a", from_a, *a.curves, *b.curves);
  add_distance(answer, "from b", from_b, *a.curves, *b.curves);
  return answer;
}

}  // namespace bounding_arcs_tool
