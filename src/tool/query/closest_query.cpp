// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "../Commands.h"
#include "query_command.h"

#include <CGAL/Bounding_arcs_2/query/closest_point.h>
#include <CGAL/Bounding_arcs_2/query/signed_distance.h>

namespace bounding_arcs_tool {

Query_answer closest_query(const Query_drawing& drawing, const std::vector<Xy<double>>& points) {
  check_has_curve(drawing);
  const Bounding_arc_tree_2& curves = *drawing.curves;
  Query_answer answer;
  answer.title = "closest points: " + std::to_string(points.size());
  answer.columns = {"x", "y", "least", "most", "closest x", "closest y", "place", "t"};
  Json results = Json::array();
  Progress_line progress("points");
  for (const Xy<double>& q : points) {
    progress(results.size(), points.size());
    const auto found = closest_point(curves, q);
    if (!found) continue;
    results.push_back({{"query", json_of(q)},
                       {"distance", {found->distance.lower, found->distance.upper}},
                       {"point", json_of(found->point)},
                       {"place", json_of(curves, found->place)}});
    add_status(results.back(), answer, found->status);
    answer.rows.push_back({digits(q.x), digits(q.y), digits(found->distance.lower), digits(found->distance.upper),
                           digits(found->point.x), digits(found->point.y),
                           name_of_place(curves, found->place.curve, found->place.bezier), digits(found->place.t)});
    answer.marks.push_back({Mark::LINE, {q, found->point}});
    answer.marks.push_back({Mark::DOT, {found->point}});
  }
  answer.json["results"] = std::move(results);
  return answer;
}

Query_answer signed_query(const Query_drawing& drawing, const std::vector<Xy<double>>& points) {
  namespace ba = CGAL::Bounding_arcs;
  check_has_curve(drawing);
  check_closed(drawing);
  const Bounding_arc_tree_2& curves = *drawing.curves;
  Query_answer answer;
  answer.title = "signed distances: " + std::to_string(points.size());
  answer.columns = {"x", "y", "side", "least", "most", "closest x", "closest y", "place", "t"};
  Json results = Json::array();
  Progress_line progress("points");
  for (const Xy<double>& q : points) {
    progress(results.size(), points.size());
    const auto found = ba::signed_distance(curves, q, drawing.rule);
    if (!found) continue;
    results.push_back({{"query", json_of(q)},
                       {"distance", {found->distance.lower, found->distance.upper}},
                       {"side", name_of(found->side)},
                       {"point", json_of(found->point)},
                       {"place", json_of(drawing, found->place)}});
    add_status(results.back(), answer, found->status);
    answer.rows.push_back({digits(q.x), digits(q.y), name_of(found->side), digits(found->distance.lower),
                           digits(found->distance.upper), digits(found->point.x), digits(found->point.y),
                           name_of_place(drawing, found->place), digits(found->place.t)});
    answer.marks.push_back({Mark::LINE, {q, found->point}});
    answer.marks.push_back({found->side == CGAL::ON_BOUNDED_SIDE ? Mark::STRONG_DOT : Mark::DOT, {q}});
  }
  answer.json["results"] = std::move(results);
  return answer;
}

}  // namespace bounding_arcs_tool
