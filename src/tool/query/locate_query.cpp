// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "../Commands.h"
#include "../loose_ends.h"
#include "query_command.h"

namespace bounding_arcs_tool {

namespace ba = CGAL::Bounding_arcs;

const char* name_of(CGAL::Uncertain<CGAL::Bounded_side> side) {
  if (!is_certain(side)) return "undecided";
  return side == CGAL::ON_BOUNDARY ? "on" : (side == CGAL::ON_BOUNDED_SIDE ? "inside" : "outside");
}

void check_closed(const Query_drawing& drawing, const std::string& more) {
  for (const auto& curve : drawing.curves->drawing().curves()) {
    if (curve.is_closed) continue;
    const Loose_ends ends = loose_ends(drawing.curves->drawing());
    throw Input_error(drawing.file, "curve \"" + curve.name + "\"",
                      "expected a closed curve, which has an inside, found an open one" +
                          (ends.gaps > 0 ? "; the file has " + ends.text() : "") + more);
  }
}

void check_has_curve(const Query_drawing& drawing) {
  if (drawing.curves->drawing().curves().empty())
    throw Input_error(drawing.file, "curves", "expected at least one, found none");
}

Query_answer locate_query(const Query_drawing& drawing, const std::vector<Xy<double>>& points) {
  check_closed(drawing);
  const ba::Point_location_2 location(*drawing.curves);
  Query_answer answer;
  answer.title = "points: " + std::to_string(points.size());
  answer.columns = {"x", "y", "winding", "side"};
  Json results = Json::array();
  Progress_line progress("points");
  for (const Xy<double>& q : points) {
    progress(results.size(), points.size());
    const ba::Winding_number w = location.winding_number(q);
    const bool has_number = w.state == ba::Winding_number::State::DECIDED;
    const char* side = name_of(location.locate(q, drawing.rule));
    results.push_back({{"query", json_of(q)}, {"winding", has_number ? Json(w.number) : Json()}, {"side", side}});
    answer.rows.push_back({digits(q.x), digits(q.y), has_number ? std::to_string(w.number) : "-", side});
    answer.marks.push_back({side[0] == 'i' ? Mark::STRONG_DOT : Mark::DOT, {q}});
  }
  answer.json["results"] = std::move(results);
  return answer;
}

}  // namespace bounding_arcs_tool
