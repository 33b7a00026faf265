// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "Query_answer.h"

#include "../Commands.h"
#include "../option_words.h"
#include "../svg_paths.h"

#include <algorithm>
#include <cstddef>
#include <cstdio>

namespace bounding_arcs_tool {
namespace {

std::string path_of(const View& view, const Mark& mark) {
  std::string path = "M" + view(mark.points.front());
  if (mark.kind == Mark::DOT || mark.kind == Mark::STRONG_DOT) return path + "h0";
  for (std::size_t i = 1; i < mark.points.size(); ++i) path += "L" + view(mark.points[i]);
  return path;
}

}  // namespace

void add_status(Json& record, Query_answer& answer, CGAL::Bounding_arcs::Query_status status) {
  using CGAL::Bounding_arcs::Query_status;
  if (status == Query_status::COMPLETE) return;
  const bool is_limited = status == Query_status::LIMIT_REACHED;
  record["status"] = is_limited ? "limit_reached" : "resolution_reached";
  answer.is_limited = answer.is_limited || is_limited;
}

Json json_of(const Xy<double>& p) { return Json::array({p.x, p.y}); }

Json json_of(const Bounding_arc_tree_2& curves, const Curve_place& place) {
  return {{"curve", place.curve},
          {"name", curves.drawing().curves()[place.curve].name},
          {"bezier", place.bezier},
          {"t", place.t}};
}

std::string name_of_place(const Bounding_arc_tree_2& curves, std::uint32_t curve, std::uint32_t bezier) {
  return table_name(curves.drawing().curves()[curve].name) + " " + std::to_string(curve) + "." + std::to_string(bezier);
}

std::string digits(double x) { return Json(x).dump(); }

void write_json(std::ostream& out, const Query_answer& answer) {
  out << '{';
  const char* between = "";
  for (const auto& member : answer.json.items()) {
    out << between << json_string(member.key()) << ':';
    between = ",\n";
    if (!member.value().is_array() || member.value().empty() || !member.value().front().is_object()) {
      out << member.value().dump();
      continue;
    }
    const char* separator = "[\n";
    for (const Json& record : member.value()) {
      out << separator << record.dump();
      separator = ",\n";
    }
    out << ']';
  }
  out << "}\n";
}

void write_csv(std::ostream& out, const Query_answer& answer) {
  const auto line = [&](const std::vector<std::string>& fields) {
    for (std::size_t i = 0; i < fields.size(); ++i) out << (i > 0 ? "," : "") << csv_field(fields[i]);
    out << '\n';
  };
  line(answer.columns);
  for (const auto& row : answer.rows) line(row);
}

void write_table(std::ostream& out, const Query_answer& answer) {
  std::vector<std::size_t> widths;
  for (const std::string& column : answer.columns) widths.push_back(column.size());
  for (const auto& row : answer.rows)
    for (std::size_t i = 0; i < row.size(); ++i) widths[i] = (std::max)(widths[i], row[i].size());
  const auto line = [&](const std::vector<std::string>& fields) {
    std::string text;
    for (std::size_t i = 0; i < fields.size(); ++i) {
      text += fields[i];
      if (i + 1 < fields.size()) text.append(widths[i] - fields[i].size() + 2, ' ');
    }
    out << text << '\n';
  };
  line(answer.columns);
  for (const auto& row : answer.rows) line(row);
}

void write_svg(std::ostream& out, const Query_answer& answer, const std::vector<const Bounding_arc_tree_2*>& drawings,
               bool flips) {
  Box box;
  for (const Bounding_arc_tree_2* curves : drawings)
    for (const auto& curve : curves->drawing().curves())
      for (const auto& bezier : curve.beziers) box.add(bezier);
  for (const Mark& mark : answer.marks)
    for (const Xy<double>& p : mark.points) box.add(p);
  const Sheet sheet(box, flips);
  char text[900];
  std::snprintf(text, sizeof text,
                "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"%.0f\" height=\"%.0f\" viewBox=\"0 0 %.0f %.0f\">\n",
                sheet.width, sheet.height, sheet.width, sheet.height);
  out << text << "<title>" << escaped(answer.title) << "</title>\n"
      << "<style>path{stroke-linejoin:round;stroke-linecap:round;fill:none}"
         ".a,.b,.l,.s{vector-effect:non-scaling-stroke}\n"
         ".a{stroke:#0072b2;stroke-width:1.4}.b{stroke:#b34700;stroke-width:1.4}\n"
         ".l{stroke:#555;stroke-width:.8}.s{stroke:#007a56;stroke-width:3.5;stroke-opacity:.6}\n";
  constexpr double DOT = 7, STRONG_DOT = 9;
  Dot_width dots;  // beside neighbouring ends of Bezier pieces
  for (const Bounding_arc_tree_2* curves : drawings)
    for (const auto& curve : curves->drawing().curves())
      for (const auto& bezier : curve.beziers)
        dots.add(sheet.view, bezier.control_points().front(), bezier.control_points().back());
  std::snprintf(text, sizeof text,
                ".d{stroke:#c0182b;stroke-width:%.3g}.i{stroke:#007a56;stroke-width:%.3g}</style>\n"
                "<rect width=\"100%%\" height=\"100%%\" fill=\"#fff\"/>\n",
                dots(DOT), dots(STRONG_DOT));
  out << text;
  std::snprintf(text, sizeof text,
                "<text x=\"%.0f\" y=\"36\" font-family=\"sans-serif\" font-size=\"20\" fill=\"#333\">", Sheet::MARGIN);
  out << text << escaped(answer.title) << "</text>\n";
  const auto marks = [&](Mark::Kind kind, const char* style) {
    std::string path;
    for (const Mark& mark : answer.marks)
      if (mark.kind == kind) path += path_of(sheet.view, mark);
    if (!path.empty()) out << "<path class=\"" << style << "\" d=\"" << path << "\"/>\n";
  };
  marks(Mark::STRONG_LINE, "s");
  for (std::size_t i = 0; i < drawings.size(); ++i)
    for (const auto& curve : drawings[i]->drawing().curves()) {
      out << "<g><title>" << escaped(curve.name) << "</title><path class=\"" << (i == 0 ? "a" : "b") << "\" d=\"";
      for (const auto& bezier : curve.beziers) out << curve_path(sheet.view, bezier);
      out << "\"/></g>\n";
    }
  marks(Mark::LINE, "l");
  marks(Mark::DOT, "d");
  marks(Mark::STRONG_DOT, "i");
  out << "</svg>\n";
}

}  // namespace bounding_arcs_tool
