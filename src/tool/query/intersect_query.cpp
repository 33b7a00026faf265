// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "../Commands.h"
#include "query_command.h"

#include <CGAL/Bounding_arcs_2/query/intersections.h>

namespace bounding_arcs_tool {
namespace {

namespace ba = CGAL::Bounding_arcs;

const char* name_of(ba::Intersection_kind kind) {
  switch (kind) {
    case ba::Intersection_kind::TRANSVERSAL:
      return "transversal";
    case ba::Intersection_kind::TANGENTIAL:
      return "tangential";
    case ba::Intersection_kind::UNDECIDED:
      break;
  }
  return "undecided";
}

Json json_of(const ba::Curve_range& r) {
  return {{"curve", r.curve}, {"bezier", r.bezier}, {"t", {r.t.lower, r.t.upper}}};
}
Json place_of(const Bounding_arc_tree_2& curves, const ba::Curve_range& r) {
  return bounding_arcs_tool::json_of(curves, ba::Curve_place{r.curve, r.bezier, r.t.middle()});
}

// The first drawing's curve along an overlap.
Mark mark_of(const Bounding_arc_tree_2& curves, const ba::Overlap_2& o) {
  constexpr int SAMPLES = 64;  // a Bezier piece
  const auto& curve = curves.drawing().curves()[o.a_from.curve];
  Mark mark{Mark::STRONG_LINE, {}};
  const std::size_t count = curve.beziers.size(), first = o.a_from.bezier, last = o.a_to.bezier;
  const double t0 = o.a_from.t.middle(), t1 = o.a_to.t.middle();
  const std::size_t pieces = last > first || (last == first && t0 <= t1) ? last - first : last + count - first;
  for (std::size_t k = 0; k <= pieces; ++k) {
    const double from = k == 0 ? t0 : 0, to = k == pieces ? t1 : 1;
    for (int i = 0; i <= SAMPLES; ++i)
      mark.points.push_back(curve.beziers[(first + k) % count].point(from + (to - from) * i / SAMPLES));
  }
  return mark;
}

Query_answer answer_of(const ba::Intersections_2<>& found, const Bounding_arc_tree_2& a, const Bounding_arc_tree_2& b) {
  Query_answer answer;
  answer.title = "intersections: " + std::to_string(found.points.size()) +
                 (found.overlaps.empty() ? "" : ", overlaps: " + std::to_string(found.overlaps.size()));
  answer.columns = {"x", "y", "kind", "place a", "t a", "place b", "t b"};
  Json points = Json::array(), overlaps = Json::array();
  for (const ba::Intersections_2<>::Intersection& p : found.points) {
    points.push_back({{"point", bounding_arcs_tool::json_of(p.point)},
                      {"kind", name_of(p.kind)},
                      {"a", json_of(p.a)},
                      {"b", json_of(p.b)}});
    answer.rows.push_back({digits(p.point.x), digits(p.point.y), name_of(p.kind),
                           name_of_place(a, p.a.curve, p.a.bezier), digits(p.a.t.middle()),
                           name_of_place(b, p.b.curve, p.b.bezier), digits(p.b.t.middle())});
    answer.marks.push_back({Mark::DOT, {p.point}});
  }
  for (const ba::Overlap_2& o : found.overlaps) {
    overlaps.push_back({{"a", {{"from", place_of(a, o.a_from)}, {"to", place_of(a, o.a_to)}}},
                        {"b", {{"from", place_of(b, o.b_from)}, {"to", place_of(b, o.b_to)}}}});
    answer.marks.push_back(mark_of(a, o));
    for (const bool at_end : {false, true}) {
      const ba::Curve_range &p = at_end ? o.a_to : o.a_from, &q = at_end ? o.b_to : o.b_from;
      const Xy<double> point = at_end ? answer.marks.back().points.back() : answer.marks.back().points.front();
      answer.rows.push_back({digits(point.x), digits(point.y), at_end ? "overlap to" : "overlap from",
                             name_of_place(a, p.curve, p.bezier), digits(p.t.middle()),
                             name_of_place(b, q.curve, q.bezier), digits(q.t.middle())});
    }
  }
  answer.json["intersections"] = std::move(points);
  answer.json["overlaps"] = std::move(overlaps);
  return answer;
}

}  // namespace

Query_answer intersect_query(const Query_drawing& a, const Query_drawing& b) {
  return answer_of(ba::intersections(*a.curves, *b.curves), *a.curves, *b.curves);
}

Query_answer self_intersect_query(const Query_drawing& a) {
  return answer_of(ba::self_intersections(*a.curves), *a.curves, *a.curves);
}

}  // namespace bounding_arcs_tool
