// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// bounding_arcs thickness: the necks of shapes, as JSON or CSV, or a picture coloured by thickness.

#include "thickness_command.h"

#include "../Commands.h"
#include "../Output_file.h"
#include "../number_text.h"
#include "../option_words.h"
#include "../query/Query_answer.h"
#include "../svg_paths.h"
#include "found_axis.h"

#include <CGAL/Bounding_arcs_2/medial_axis/framed.h>
#include <CGAL/Bounding_arcs_2/medial_axis/necks.h>

#include <CLI/CLI.hpp>

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

namespace bounding_arcs_tool {
namespace {

Xy<double> point_of(const Drawing_hierarchy& curves, const Curve_place& p) {
  return curves.drawing().curves()[p.curve].beziers[p.bezier].point(p.t);
}

// The colour of a share of the largest thickness: from dark blue for the thinnest to light yellow.
std::string colour(double share) {
  constexpr double STOPS[][3] = {{68, 1, 84}, {59, 82, 139}, {33, 145, 140}, {94, 201, 98}, {253, 231, 37}};
  constexpr int LAST = sizeof STOPS / sizeof *STOPS - 1;
  const double at = LAST * (std::min)((std::max)(share, 0.0), 1.0);
  const int i = (std::min)(static_cast<int>(at), LAST - 1);
  char text[16];
  const auto mix = [&](int c) {
    return static_cast<int>(std::lround(STOPS[i][c] + (at - i) * (STOPS[i + 1][c] - STOPS[i][c])));
  };
  std::snprintf(text, sizeof text, "#%02x%02x%02x", mix(0), mix(1), mix(2));
  return text;
}

// The discs of the axis, the largest on top, so that each point has the colour of the largest disc that covers it.
// Cells below them, each between two discs and the places that they touch, fill what lies between the discs and the
// curves.
void draw_discs(std::ostream& out, const Found_axis& found, const Drawing_hierarchy& curves, const View& view,
                double largest) {
  std::vector<std::pair<double, Xy<double>>> discs;
  for (const ba::Medial_vertex& v : found.axis.vertices) discs.push_back({v.radius, v.center});
  for (const ba::Medial_edge& e : found.axis.edges)
    for (std::size_t i = 1; i < e.samples.size(); ++i) {
      const ba::Medial_sample &a = e.samples[i - 1], &b = e.samples[i];
      discs.push_back({b.radius, b.center});
      const auto foot = [&](const Curve_place& p) { return "L" + view(point_of(curves, found.on_curves(p))); };
      const std::string fill = colour((a.radius + b.radius) / 2 / largest);
      out << "<path fill=\"" << fill << "\" stroke=\"" << fill << "\" d=\"M" << view(a.center) << foot(a.left)
          << foot(b.left) << "L" << view(b.center) << foot(b.right) << foot(a.right) << "Z\"/>\n";
    }
  std::stable_sort(discs.begin(), discs.end(), [](const auto& a, const auto& b) { return a.first < b.first; });
  char text[160];
  for (const auto& [radius, center] : discs) {
    const Xy<double> c = view.place(center);
    std::snprintf(text, sizeof text, "<circle cx=\"%.7g\" cy=\"%.7g\" r=\"%.7g\" fill=\"%s\"/>\n", c.x, c.y,
                  radius * view.scale, colour(radius / largest).c_str());
    out << text;
  }
}

void draw(std::ostream& out, const Found_axis& found, const std::vector<ba::Neck>& necks, double largest,
          const Query_drawing& loaded) {
  const Drawing_hierarchy& curves = *loaded.curves;
  const CGAL::Bbox_2 all = ba::control_box(curves.drawing());
  Box box;
  box.add({all.xmin(), all.ymin()}), box.add({all.xmax(), all.ymax()});
  const Sheet sheet(box, loaded.flips);
  char text[1000];
  const std::string title =
      std::to_string(necks.size()) + (necks.size() == 1 ? " neck" : " necks") +
      (necks.empty() ? "" : ", the narrowest " + short_number(necks.front().thickness()) + " thick") +
      "; the largest disc is " + short_number(2 * largest) + " wide";
  std::snprintf(text, sizeof text,
                "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"%.0f\" height=\"%.0f\" viewBox=\"0 0 %.0f %.0f\">\n"
                "<title>%s</title>\n<style>.c{fill:none;stroke:#333;stroke-width:1.5}\n"
                ".n{fill:none;stroke:#d55e00;stroke-width:3;stroke-linecap:round}\n"
                "text{font-family:sans-serif;font-size:20px;fill:#333}</style>\n"
                "<rect width=\"100%%\" height=\"100%%\" fill=\"#fff\"/>\n<text x=\"%.0f\" y=\"36\">%s</text>\n",
                sheet.width, sheet.height, sheet.width, sheet.height, title.c_str(), Sheet::MARGIN, title.c_str());
  out << text;
  draw_discs(out, found, curves, sheet.view, largest);
  for (const auto& curve : curves.drawing().curves()) {
    out << "<path class=\"c\" d=\"";
    for (const auto& piece : curve.beziers) out << curve_path(sheet.view, piece);
    out << "\"/>\n";
  }
  for (const ba::Neck& neck : necks)
    out << "<path class=\"n\" d=\"M" << sheet.view(point_of(curves, found.on_curves(neck.disc.left))) << "L"
        << sheet.view(neck.disc.center) << "L" << sheet.view(point_of(curves, found.on_curves(neck.disc.right)))
        << "\"><title>" << short_number(neck.thickness()) << "</title></path>\n";
  out << "</svg>\n";
}

Json json_of_necks(const Found_axis& found, const std::vector<ba::Neck>& necks, const ba::Medial_vertex* largest,
                   const Query_drawing& loaded) {
  const Drawing_hierarchy& curves = *loaded.curves;
  Json document{{"eps", found.axis.eps}, {"of", found.outline ? "outline" : "curves"}};
  if (largest != nullptr)
    document["thickest"] = {{"point", json_of(largest->center)}, {"thickness", 2 * largest->radius}};
  document["necks"] = Json::array();
  for (const ba::Neck& neck : necks) {
    Json record{{"point", json_of(neck.disc.center)}, {"thickness", neck.thickness()}};
    if (std::isfinite(neck.prominence)) record["prominence"] = 2 * neck.prominence;
    for (const Curve_place& p : {neck.disc.left, neck.disc.right}) {
      record["between"].push_back(json_of(loaded, found.on_curves(p)));
      record["between"].back()["point"] = json_of(point_of(curves, found.on_curves(p)));
    }
    document["necks"].push_back(record);
  }
  return document;
}

}  // namespace

CLI::App* add_thickness_command(CLI::App& app, Thickness_words& words) {
  CLI::App* command = app.add_subcommand("thickness", "Where shapes are narrow, and how thick they are everywhere");
  Medial_axis_words& axis = words.axis;
  command->add_option("FILE", axis.file, "A curve file, JSON, SVG or DXF; - reads standard input")->required();
  command->add_option("--eps", axis.eps, "How far the axis may be from the lines between samples")
      ->required()
      ->check(CLI::Validator(check_tolerance, "", "eps"))
      ->type_name("NUMBER");
  command->add_option("--below", words.below, "Only necks that are thinner, in units of the coordinates")
      ->check(number_in(0, 1e300))
      ->type_name("NUMBER");
  add_frame_option(*command, axis);
  add_rule(*command, axis.reading.rule);
  add_reading_options(*command, axis.reading);
  command->add_option("--format", axis.format, "Form of the output")
      ->check(CLI::IsMember({"json", "csv", "svg"}))
      ->capture_default_str();
  command->add_option("-o,--output", axis.output,
                      "Write to this file, whole or not at all, instead of standard output");
  command->footer(
      "The local thickness at a point is the diameter of the largest disc inside that covers it. A neck is the "
      "smallest\n"
      "disc, of those along the medial axis, between two places that are thicker by more than twice eps; by how much "
      "is\n"
      "its prominence. A corner is no neck. A neck's thickness is within twice eps of the least one there. With "
      "--frame\n"
      "it is the room between the curves that is measured: its necks are gaps.\n"
      "Examples:\n"
      "  bounding_arcs thickness part.svg --eps 0.001 --below 1.5\n"
      "  bounding_arcs thickness part.dxf --eps 0.001 --format svg -o thickness.svg\n"
      "  bounding_arcs thickness drawing.svg --eps 0.01 --frame --format csv -o gaps.csv\n");
  return command;
}

int run_thickness(const Thickness_words& words) {
  const Query_drawing loaded = load_axis_drawing(words.axis);
  const Found_axis found = axis_of(loaded, words.axis);
  if (found.axis.status == ba::Medial_axis_status::UNRESOLVED)
    throw Input_error(loaded.file, "thickness", message_of_unresolved(found.axis));
  std::vector<ba::Neck> necks = ba::necks(found.axis);
  necks.erase(std::find_if(necks.begin(), necks.end(), [&](const auto& n) { return !(n.thickness() < words.below); }),
              necks.end());
  const ba::Medial_vertex* largest = nullptr;
  for (const ba::Medial_vertex& v : found.axis.vertices)
    if (largest == nullptr || v.radius > largest->radius) largest = &v;
  Output_file output(words.axis.output);
  if (words.axis.format == "svg") {
    draw(output.stream(), found, necks, largest == nullptr ? 1 : largest->radius, loaded);
  } else if (words.axis.format == "json") {
    output.stream() << json_of_necks(found, necks, largest, loaded).dump(1) << "\n";
  } else {
    Query_answer table;
    table.columns = {"x", "y", "thickness", "x1", "y1", "x2", "y2"};
    for (const ba::Neck& n : necks) {
      const Xy<double> a = point_of(*loaded.curves, found.on_curves(n.disc.left)),
                       b = point_of(*loaded.curves, found.on_curves(n.disc.right));
      table.rows.push_back({digits(n.disc.center.x), digits(n.disc.center.y), digits(n.thickness()), digits(a.x),
                            digits(a.y), digits(b.x), digits(b.y)});
    }
    write_csv(output.stream(), table);
  }
  output.commit();
  return 0;
}

}  // namespace bounding_arcs_tool
