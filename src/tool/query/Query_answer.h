// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// What a query answers, in the forms in which it can be written: JSON, rows of a table, marks on a picture.

#ifndef BOUNDING_ARCS_TOOL_QUERY_QUERY_ANSWER_H
#define BOUNDING_ARCS_TOOL_QUERY_QUERY_ANSWER_H

#include <CGAL/Bounding_arcs_2/query/Query_point.h>
#include <CGAL/Bounding_arcs_2/tree/Bounding_arc_tree_2.h>

#include <nlohmann/json.hpp>

#include <ostream>
#include <string>
#include <vector>

namespace bounding_arcs_tool {

using Json = nlohmann::ordered_json;
using CGAL::Bounding_arcs::Bounding_arc_tree_2;
using CGAL::Bounding_arcs::Curve_place;
using CGAL::Bounding_arcs::Xy;

/// Something to show on the curves: a dot, or a line through points.
struct Mark {
  enum Kind { DOT, STRONG_DOT, LINE, STRONG_LINE };
  Kind kind;
  std::vector<Xy<double>> points;
};

struct Query_answer {
  std::string title;  ///< of a picture, one line
  Json json;
  std::vector<std::string> columns;
  std::vector<std::vector<std::string>> rows;
  std::vector<Mark> marks;
  bool is_limited = false;  ///< a search ended at its limit of work
};

/// Adds "status" to a record unless a search was complete.
void add_status(Json& record, Query_answer& answer, CGAL::Bounding_arcs::Query_status status);

[[nodiscard]] Json json_of(const Xy<double>& p);
/// {"curve", "name", "bezier", "t"}
[[nodiscard]] Json json_of(const Bounding_arc_tree_2& curves, const Curve_place& place);
/// "curve.bezier" for tables.
[[nodiscard]] std::string name_of_place(const Bounding_arc_tree_2& curves, std::uint32_t curve, std::uint32_t bezier);
/// Writes as few digits as give the same double again.
[[nodiscard]] std::string digits(double x);

/// A list of a document one record a line.
void write_json(std::ostream& out, const Query_answer& answer);
void write_csv(std::ostream& out, const Query_answer& answer);
void write_table(std::ostream& out, const Query_answer& answer);
/// The curves of all drawings with the marks. \param flips y of the plane is upwards
void write_svg(std::ostream& out, const Query_answer& answer, const std::vector<const Bounding_arc_tree_2*>& drawings,
               bool flips);

}  // namespace bounding_arcs_tool

#endif
