// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "../medial_axis/medial_axis_command.h"
#include "../offset/offset_command.h"
#include "../option_words.h"
#include "../query/query_command.h"
#include "File_report.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <optional>
#include <utility>

namespace bounding_arcs_tool {

namespace ba = CGAL::Bounding_arcs;

namespace {

Query_answer answer_of(const std::string& query, const Query_drawing& drawing, const Report_words& words) {
  if (query == "hull") return hull_query(drawing, 0);
  if (query == "closest") return closest_query(drawing, read_points(words.points));
  if (query == "locate") return locate_query(drawing, read_points(words.points));
  return self_intersect_query(drawing);
}

// An offset is nearer to its distance than an eighth of that: within an eps as large as it anything would be right.
double eps_of_offsets(const std::string& distances, double eps) {
  constexpr double OF_DISTANCE = 0.125;
  for (const std::string& word : words_between_commas(distances))
    if (const double d = std::fabs(std::strtod(word.c_str(), nullptr)); d > 0) eps = (std::min)(eps, OF_DISTANCE * d);
  return eps;
}

}  // namespace

std::vector<Overlay> overlays_of(const std::string& file, const std::vector<Loaded_curve>& curves,
                                 ba::Fill_rule own_rule, const Report_words& words, double eps) {
  std::vector<Overlay> overlays;
  if (words.queries.empty() && words.distances.empty() && !words.with_medial_axis) return overlays;
  std::vector<Curve_record> records;
  records.reserve(curves.size());
  for (const Loaded_curve& curve : curves) records.push_back(curve.record);
  const ba::Fill_rule rule = fill_rule(words.reading.rule, own_rule);
  const Query_drawing drawing = query_drawing(file, records, words.kernel, rule);
  const auto is_locate = [](const std::string& query) { return query == "locate"; };
  std::optional<Query_drawing> closed;
  if (words.with_medial_axis || std::any_of(words.queries.begin(), words.queries.end(), is_locate))
    closed = closed_drawing(file, {std::move(records), rule, {}}, words.kernel, words.reading);
  for (const std::string& query : words.queries)
    overlays.push_back({answer_of(query, is_locate(query) ? *closed : drawing, words)});
  if (!words.distances.empty()) {
    Offset_words offset;
    offset.distances = words.distances;
    const double offset_eps = eps_of_offsets(offset.distances, eps);
    offset.eps = number(offset_eps);
    for (Offset_outline& outline : offset_outlines(offset, drawing)) {
      Query_answer answer;
      answer.title = "offset by " + digits(outline.distance) + ": " + std::to_string(outline.chains.size()) +
                     " chains, within " + digits(offset_eps);
      overlays.push_back({std::move(answer), std::move(outline.chains)});
    }
  }
  if (words.with_medial_axis) {
    Medial_axis_words axis;
    axis.eps = number(eps);
    overlays.push_back({medial_axis_answer(axis, *closed)});
    overlays.back().answer.title += ", within " + digits(eps);
  }
  return overlays;
}

}  // namespace bounding_arcs_tool
