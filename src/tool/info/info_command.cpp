// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "info_command.h"

#include "../Commands.h"
#include "../Output_file.h"
#include "../Read_file.h"
#include "../loose_ends.h"
#include "../number_text.h"
#include "../option_words.h"
#include "../query/Query_answer.h"
#include "../svg_paths.h"
#include "Drawing_facts.h"

#include "../../input/Input_text.h"

#include <CLI/CLI.hpp>

#include <algorithm>
#include <cmath>
#include <cstdio>

namespace bounding_arcs_tool {
namespace {

namespace ba = CGAL::Bounding_arcs;

// A file as it was read, and what is known of it.
struct Info {
  std::string file;
  Read_file read;
  ba::Drawing_2<double> drawing;
  ba::Fill_rule rule;
  Drawing_facts facts;
  Loose_ends open;

  [[nodiscard]] std::size_t size() const { return facts.curves.size(); }
  [[nodiscard]] const Curve_record& record(std::size_t i) const { return read.file.curves[i]; }
  [[nodiscard]] const ba::Drawing_2<double>::Curve& curve(std::size_t i) const { return drawing.curves()[i]; }
};

std::string unit_text(const Info& info) {
  return info.read.file.unit_in_mm > 0 ? "1 unit is " + short_number(info.read.file.unit_in_mm) + " mm"
                                       : "no unit told";
}

std::string title_of(const Info& info) {
  return info.file + ": " + count_text(info.size(), "curve") + ", " + std::to_string(info.facts.closed) +
         " closed and " + std::to_string(info.size() - info.facts.closed) + " open; " + unit_text(info) + "; " +
         name_of(info.rule) + " rule";
}

// Tells of nested curves that run the same way; nothing where there are none.
std::string alike_text(const Info& info) {
  const std::vector<std::size_t>& alike = info.facts.alike;
  if (alike.empty()) return "";
  constexpr std::size_t MOST = 10;
  std::string numbers;
  for (std::size_t i = 0; i < alike.size() && i < MOST; ++i) numbers += (i > 0 ? ", " : "") + std::to_string(alike[i]);
  if (alike.size() > MOST) numbers += " and " + std::to_string(alike.size() - MOST) + " more";
  const bool is_one = alike.size() == 1;
  return count_text(alike.size(), "curve") + (is_one ? " runs" : " run") + " the same way as the one around " +
         (is_one ? "it" : "each") + ": " + numbers +
         (info.rule == ba::Fill_rule::NONZERO ? (is_one ? "; it is no hole" : "; they are no holes") +
                                                    std::string(" by the nonzero rule, --rule evenodd makes them holes")
                                              : std::string("; holes by the evenodd rule, not by the nonzero one"));
}

std::string end_text(const Loose_end::Place& place) {
  return std::string(place.is_start ? "start" : "end") + " of " + std::to_string(place.curve) + " at " +
         place_text(place.point);
}

// What is to be told beside the curves, a line each.
std::vector<std::string> remarks(const Info& info) {
  std::vector<std::string> lines;
  const auto add = [&](const std::string& line) {
    if (!line.empty()) lines.push_back(line);
  };
  add(info.read.converted);
  add(ba::Curve_file::text_of(info.read.file.notes));
  add(info.read.joined);
  add(info.read.ambiguous);
  add(info.read.skipped);
  add(alike_text(info));
  if (info.open.open > 0) add(info.open.text());
  return lines;
}

// The box holds the curve with some rounding to spare, which is not shown.
std::string box_text(const CGAL::Bbox_2& box) {
  constexpr double SHOWN = 1e-9;  // of its coordinates: more digits than there are
  const double unit = SHOWN * (std::max)({-box.xmin(), box.xmax(), -box.ymin(), box.ymax()});
  const auto shown = [&](double x) { return unit > 0 ? std::round(x / unit) * unit + 0.0 : x; };
  char text[120];
  std::snprintf(text, sizeof text, "%.6g..%.6g %.6g..%.6g", shown(box.xmin()), shown(box.xmax()), shown(box.ymin()),
                shown(box.ymax()));
  return text;
}

std::string shown(double x) {
  char text[40];
  std::snprintf(text, sizeof text, "%.6g", x);
  return text;
}

void write_table(std::ostream& out, const Info& info) {
  Query_answer table;
  table.columns = {"curve", "name", "layer", "closed", "pieces", "length", "area", "runs", "inside", "x and y"};
  for (std::size_t i = 0; i < info.size(); ++i) {
    const Curve_facts& of = info.facts.curves[i];
    const std::string layer = table_name(info.record(i).layer), direction = of.direction();
    table.rows.push_back({std::to_string(i), table_name(info.record(i).name), layer.empty() ? "-" : layer,
                          of.is_closed ? "closed" : "open", std::to_string(info.curve(i).beziers.size()),
                          shown(of.length), of.is_closed ? shown(std::fabs(of.area)) : "-",
                          direction.empty() ? "-" : direction, of.inside ? std::to_string(*of.inside) : "-",
                          box_text(of.box)});
  }
  out << one_line(title_of(info), std::string::npos) << '\n';
  for (const std::string& line : remarks(info)) out << one_line(line, std::string::npos) << '\n';
  write_table(out, table);
  if (info.facts.loose_ends.empty()) return;
  Query_answer ends;
  ends.columns = {"end", "nearest other end", "distance"};
  for (const Loose_end& end : info.facts.loose_ends)
    ends.rows.push_back(
        {end_text(end.end), end.nearest ? end_text(*end.nearest) : "-", end.nearest ? shown(end.distance) : "-"});
  out << '\n';
  write_table(out, ends);
}

void write_csv(std::ostream& out, const Info& info) {
  Query_answer table;
  table.columns = {"curve",     "name",   "layer", "closed", "pieces", "length", "area",
                   "direction", "inside", "xmin",  "ymin",   "xmax",   "ymax"};
  for (std::size_t i = 0; i < info.size(); ++i) {
    const Curve_facts& of = info.facts.curves[i];
    table.rows.push_back({std::to_string(i), info.record(i).name, info.record(i).layer, of.is_closed ? "true" : "false",
                          std::to_string(info.curve(i).beziers.size()), number(of.length),
                          of.is_closed ? number(of.area) : "", of.direction(),
                          of.inside ? std::to_string(*of.inside) : "", number(of.box.xmin()), number(of.box.ymin()),
                          number(of.box.xmax()), number(of.box.ymax())});
  }
  write_csv(out, table);
}

Json json_of_box(const CGAL::Bbox_2& box) { return Json::array({box.xmin(), box.ymin(), box.xmax(), box.ymax()}); }

Json json_of_place(const Loose_end::Place& place) {
  return {{"curve", place.curve}, {"end", place.is_start ? "start" : "end"}, {"at", json_of(place.point)}};
}

Json json_of_curve(const Info& info, std::size_t i) {
  const Curve_facts& of = info.facts.curves[i];
  const std::string layer = info.record(i).layer, direction = of.direction();
  return {{"curve", i},
          {"name", info.record(i).name},
          {"layer", layer.empty() ? Json() : Json(layer)},
          {"closed", of.is_closed},
          {"parts", info.read.parts[i]},
          {"pieces", info.curve(i).beziers.size()},
          {"length", of.length},
          {"area", of.is_closed ? Json(of.area) : Json()},
          {"direction", direction.empty() ? Json() : Json(direction)},
          {"inside", of.inside ? Json(*of.inside) : Json()},
          {"box", json_of_box(of.box)}};
}

void write_json(std::ostream& out, const Info& info) {
  Query_answer document;
  Json& json = document.json;
  json["file"] = info.file;
  json["unit_in_mm"] = info.read.file.unit_in_mm > 0 ? Json(info.read.file.unit_in_mm) : Json();
  json["rule"] = name_of(info.rule);
  json["closed"] = info.facts.closed;
  json["open"] = info.size() - info.facts.closed;
  json["moved"] = info.read.moved;
  json["curves"] = json["open_ends"] = json["notes"] = Json::array();
  for (std::size_t i = 0; i < info.size(); ++i) json["curves"].push_back(json_of_curve(info, i));
  for (const Loose_end& end : info.facts.loose_ends) {
    Json record = json_of_place(end.end);
    record["nearest"] = end.nearest ? json_of_place(*end.nearest) : Json();
    record["distance"] = end.nearest ? Json(end.distance) : Json();
    json["open_ends"].push_back(std::move(record));
  }
  json["same_direction"] = info.facts.alike;
  for (const ba::Curve_file::Note& note : info.read.file.notes)
    json["notes"].push_back(
        {{"count", note.count}, {"what", note.what}, {"reason", note.reason}, {"read", note.is_read}});
  write_json(out, document);
}

// An arrow's head in the middle of a piece, which tells the direction of its curve.
std::string arrow(const View& view, const Bezier_curve_2<double>& piece) {
  constexpr double LENGTH = 9, WIDTH = 4, STEP = 0.05;  // pixels; of the parameter
  const Xy<double> tip = view.place(piece.point(0.5)), behind = view.place(piece.point(0.5 - STEP));
  const Xy<double> along = tip - behind;
  const double length = std::hypot(along.x, along.y);
  if (!(length > 0)) return "";
  const Xy<double> u = 1 / length * along, back = tip - LENGTH * u;
  char text[200];
  std::snprintf(text, sizeof text, "M%.6g %.6gL%.6g %.6gL%.6g %.6gZ", tip.x, tip.y, back.x - WIDTH * u.y,
                back.y + WIDTH * u.x, back.x + WIDTH * u.y, back.y - WIDTH * u.x);
  return text;
}

std::string number_at(const View& view, const Xy<double>& p, std::size_t number, const char* style) {
  const Xy<double> q = view.place(p);
  char text[160];
  std::snprintf(text, sizeof text, "<text class=\"%s\" x=\"%.6g\" y=\"%.6g\">%zu</text>\n", style, q.x + 4, q.y - 4,
                number);
  return text;
}

const char* style_of(const Curve_facts& of) { return !of.is_closed ? "o" : of.depth % 2 == 0 ? "c" : "h"; }

// Holes and islands by depth, open curves, all with numbers at their starts; dots where ends are open.
void draw(std::ostream& out, const Info& info) {
  Box box;
  bool flips = true;
  for (std::size_t i = 0; i < info.size(); ++i) {
    for (const auto& piece : info.curve(i).beziers) box.add(piece);
    flips = flips && !info.record(i).y_is_down;
  }
  const Sheet sheet(box, flips);
  char text[1200];
  std::snprintf(text, sizeof text,
                "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"%.0f\" height=\"%.0f\" viewBox=\"0 0 %.0f %.0f\">\n",
                sheet.width, sheet.height, sheet.width, sheet.height);
  out << text << "<title>" << escaped(title_of(info)) << "</title>\n"
      << "<style>path{fill:none;stroke-width:1.8;stroke-linejoin:round}path.c{stroke:#0072b2}path.h{stroke:#009e73}"
         "path.o{stroke:#d55e00}path.f{fill:#333}.d{fill:#d55e00}\n"
         "text{font-family:sans-serif;font-size:15px;paint-order:stroke;stroke:#fff;stroke-width:3px}"
         "text.c{fill:#0072b2}text.h{fill:#006d4f}\ntext.o{fill:#b34700}"
         "text.t{fill:#333;font-size:18px}text.k{fill:#777;font-size:14px}</style>\n"
         "<rect width=\"100%\" height=\"100%\" fill=\"#fff\"/>\n";
  std::snprintf(text, sizeof text, "<text class=\"t\" x=\"%.0f\" y=\"32\">", Sheet::MARGIN);
  out << text << escaped(count_text(info.size(), "curve") + "; " + unit_text(info)) << "</text>\n";
  std::snprintf(text, sizeof text,
                "<text class=\"k\" x=\"%.0f\" y=\"56\">blue: closed, green: closed within an odd number of others, "
                "orange: open, with dots at its ends</text>\n",
                Sheet::MARGIN);
  out << text;
  for (std::size_t i = 0; i < info.size(); ++i) {
    out << "<g><title>" << i << ' ' << escaped(info.record(i).name) << "</title>\n<path class=\""
        << style_of(info.facts.curves[i]) << "\" d=\"";
    for (const auto& piece : info.curve(i).beziers) out << curve_path(sheet.view, piece);
    out << "\"/><path class=\"f\" d=\"" << arrow(sheet.view, info.curve(i).beziers.front()) << "\"/></g>\n";
  }
  for (const Loose_end& end : info.facts.loose_ends) {
    const Xy<double> p = sheet.view.place(end.end.point);
    std::snprintf(text, sizeof text, "<circle class=\"d\" cx=\"%.6g\" cy=\"%.6g\" r=\"3.5\"/>\n", p.x, p.y);
    out << text;
  }
  for (std::size_t i = 0; i < info.size(); ++i)
    out << number_at(sheet.view, info.curve(i).beziers.front().control_points().front(), i,
                     style_of(info.facts.curves[i]));
  out << "</svg>\n";
}

}  // namespace

CLI::App* add_info_command(CLI::App& app, Info_words& words) {
  CLI::App* info = app.add_subcommand("info", "Tell what a drawing is read as: its curves, joints, holes, loose ends");
  info->add_option("FILE", words.file, "A curve file, JSON, SVG or DXF; - reads standard input")->required();
  add_rule(*info, words.reading.rule);
  add_reading_options(*info, words.reading);
  add_output(*info, {"table", "json", "csv", "svg"}, words.format, words.output);
  info->footer(
      "A line a curve: its number as results have it, name and layer; closed or open; Bezier pieces; length; the area\n"
      "that it runs round, and which way by the file's x and y; the curve that it is inside of; its range of x and y.\n"
      "In front of these lines what was left out and joined, and nested curves that run the same way. Behind them "
      "loose\n"
      "ends, and the ends that are nearest. All is as other subcommands read it with the same options. The picture "
      "has\n"
      "the numbers at the starts of curves.\n"
      "Examples:\n"
      "  bounding_arcs info part.dxf\n"
      "  bounding_arcs info part.dxf --join-ends 0.01 --format svg -o part.svg\n"
      "  bounding_arcs info drawing.svg --format json -o drawing.json\n"
      "  bounding_arcs info drawing.svg --strict -o list.csv\n");
  return info;
}

int run_info(const Info_words& words) {
  Info info;
  info.file = name_of_file(words.file);
  info.read = read_file(words.file, words.reading);
  if (words.reading.is_strict) {
    if (words.reading.join.empty()) tell_change(info.file, info.read.joined, words.reading);
    for (const std::string& text : {info.read.ambiguous, ba::Curve_file::text_of(info.read.file.notes)})
      tell_change(info.file, text, words.reading);
  }
  if (words.reading.skips_open) skip_open(info.file, info.read);
  info.drawing = ba::drawing<double>(info.read.file.curves);
  info.rule = fill_rule(words.reading.rule, info.read.file.rule);
  info.facts = drawing_facts(info.file, info.drawing);
  info.open = loose_ends(info.drawing);
  Output_file output(words.output);
  if (words.format == "json") write_json(output.stream(), info);
  else if (words.format == "csv") write_csv(output.stream(), info);
  else if (words.format == "svg") draw(output.stream(), info);
  else write_table(output.stream(), info);
  output.commit();
  return 0;
}

}  // namespace bounding_arcs_tool
