// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Bodies of write_thickness.h.

#include "write_thickness.h"

#include "../number_text.h"
#include "../query/Query_answer.h"
#include "../svg_paths.h"

#include <CGAL/Bounding_arcs_2/medial_axis/framed.h>

#include <algorithm>
#include <cmath>
#include <set>
#include <string>
#include <utility>
#include <vector>

namespace bounding_arcs_tool {
namespace {

Xy<double> point_of(const Found_thickness& found, const Curve_place& of_axis) {
  const Curve_place p = of_axis;
  return found.loaded.curves->drawing().curves()[p.curve].beziers[p.bezier].point(p.t);
}

// The number in the file of the curve of a place.
std::size_t number_of(const Found_thickness& found, const Curve_place& of_axis) {
  return found.loaded.number_of(of_axis.curve);
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
void draw_discs(std::ostream& out, const Found_thickness& found, const View& view, double largest) {
  const ba::Medial_axis_2& axis = found.axis.axis;
  std::vector<std::pair<double, Xy<double>>> discs;
  for (const ba::Medial_vertex& v : axis.vertices) discs.push_back({v.radius, v.center});
  for (const ba::Medial_edge& e : axis.edges)
    for (std::size_t i = 1; i < e.samples.size(); ++i) {
      const ba::Medial_sample &a = e.samples[i - 1], &b = e.samples[i];
      discs.push_back({b.radius, b.center});
      const auto foot = [&](const Curve_place& p) { return "L" + view(point_of(found, p)); };
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

std::string counted(std::size_t count, const std::string& thing, const std::string& things) {
  return std::to_string(count) + " " + (count == 1 ? thing : things);
}
std::string title_of(const Found_thickness& found, double largest) {
  std::string title;
  if (found.has_limit()) {
    title = counted(found.stretches.size(), "stretch", "stretches") + " thinner than " + short_number(found.below);
    if (!found.stretches.empty())
      title += ", the least " + short_number(found.stretches.front().thickness()) + " thick";
    title += "; ";
  }
  title += counted(found.necks.size(), "neck", "necks");
  if (!found.has_limit() && !found.necks.empty())  // a line has room for no more
    title += ", the narrowest " + short_number(found.necks.front().thickness()) + " thick";
  return title + "; the largest disc is " + short_number(2 * largest) + " wide";
}

void draw_curves(std::ostream& out, const Found_thickness& found, const View& view) {
  for (const auto& curve : found.loaded.curves->drawing().curves()) {
    out << "<path class=\"c\" d=\"";
    for (const auto& piece : curve.beziers) out << curve_path(view, piece);
    out << "\"/>\n";
  }
}
// A stretch that is one disc is a dot.
void draw_stretches(std::ostream& out, const Found_thickness& found, const View& view) {
  for (const ba::Thin_stretch& stretch : found.stretches) {
    out << "<path class=\"t\" d=\"M" << view(stretch.samples.front().center);
    for (const ba::Medial_sample& s : stretch.samples) out << "L" << view(s.center);
    out << "\"><title>" << short_number(stretch.thickness()) << "</title></path>\n";
  }
}
void draw_necks(std::ostream& out, const Found_thickness& found, const View& view) {
  for (const ba::Neck& neck : found.necks)
    out << "<path class=\"n\" d=\"M" << view(point_of(found, neck.disc.left)) << "L" << view(neck.disc.center) << "L"
        << view(point_of(found, neck.disc.right)) << "\"><title>" << short_number(neck.thickness())
        << "</title></path>\n";
}

Json json_of_disc(const Found_thickness& found, const ba::Medial_sample& disc) {
  Json record{{"point", json_of(disc.center)}, {"thickness", 2 * disc.radius}};
  for (const Curve_place& p : {disc.left, disc.right}) {
    record["between"].push_back(json_of(found.loaded, p));
    record["between"].back()["point"] = json_of(point_of(found, p));
  }
  return record;
}
Json json_of_stretch(const Found_thickness& found, const ba::Thin_stretch& stretch) {
  Json record = json_of_disc(found, stretch.disc());
  record["length"] = stretch.length;
  record["from"] = json_of(stretch.samples.front().center);
  record["to"] = json_of(stretch.samples.back().center);
  std::set<std::size_t> curves;
  record["polyline"] = Json::array();
  for (const ba::Medial_sample& s : stretch.samples) {
    for (const Curve_place& p : {s.left, s.right}) curves.insert(number_of(found, p));
    record["polyline"].push_back({s.center.x, s.center.y, s.radius});
  }
  record["curves"] = curves;
  record["necks"] = Json::array();
  for (std::size_t i = 0; i < found.necks.size(); ++i)
    if (is_on(found.necks[i], stretch)) record["necks"].push_back(i);
  return record;
}

}  // namespace

bool is_on(const ba::Neck& neck, const ba::Thin_stretch& stretch) {
  return std::any_of(stretch.samples.begin(), stretch.samples.end(),
                     [&](const ba::Medial_sample& s) { return s.center == neck.disc.center; });
}

void draw_thickness(std::ostream& out, const Found_thickness& found) {
  const CGAL::Bbox_2 all = ba::control_box(found.loaded.curves->drawing());
  Box box;
  box.add({all.xmin(), all.ymin()}), box.add({all.xmax(), all.ymax()});
  const Sheet sheet(box, found.loaded.flips);
  const double largest = found.thickest ? found.thickest->radius : 1;
  char text[1200];
  const std::string title = title_of(found, largest);
  std::snprintf(text, sizeof text,
                "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"%.0f\" height=\"%.0f\" viewBox=\"0 0 %.0f %.0f\">\n"
                "<title>%s</title>\n<style>.c{fill:none;stroke:#333;stroke-width:1.5}\n"
                ".t{fill:none;stroke:#d00000;stroke-width:5;stroke-linecap:round;stroke-linejoin:round}\n"
                ".n{fill:none;stroke:#d55e00;stroke-width:3;stroke-linecap:round}\n"
                "text{font-family:sans-serif;font-size:20px;fill:#333}</style>\n"
                "<rect width=\"100%%\" height=\"100%%\" fill=\"#fff\"/>\n<text x=\"%.0f\" y=\"36\">%s</text>\n",
                sheet.width, sheet.height, sheet.width, sheet.height, title.c_str(), Sheet::MARGIN, title.c_str());
  out << text;
  draw_discs(out, found, sheet.view, largest);
  draw_curves(out, found, sheet.view);
  draw_stretches(out, found, sheet.view);
  draw_necks(out, found, sheet.view);
  out << "</svg>\n";
}

void write_thickness_json(std::ostream& out, const Found_thickness& found) {
  const ba::Medial_axis_2& axis = found.axis.axis;
  const bool is_complete = axis.status == ba::Medial_axis_status::COMPLETE;
  Json document{{"eps", axis.eps}, {"moved", axis.moved}, {"status", is_complete ? "complete" : "unresolved"}};
  if (!is_complete) document["unresolved"] = Json::array();
  for (const Xy<double>& p : axis.unresolved) document["unresolved"].push_back(json_of(p));
  for (const std::uint32_t curve : axis.left_out) document["left_out"].push_back(found.loaded.number_of(curve));
  const auto place = [](const Xy<double>& center, double radius) {
    return Json{{"point", json_of(center)}, {"thickness", 2 * radius}};
  };
  if (found.thickest) document["thickest"] = place(found.thickest->center, found.thickest->radius);
  if (found.thinnest) document["thinnest"] = place(found.thinnest->center, found.thinnest->radius);
  if (found.has_limit()) {
    document["below"] = found.below;
    document["stretches"] = Json::array();
    for (const ba::Thin_stretch& stretch : found.stretches)
      document["stretches"].push_back(json_of_stretch(found, stretch));
  }
  document["necks"] = Json::array();
  for (const ba::Neck& neck : found.necks) {
    Json record = json_of_disc(found, neck.disc);
    if (std::isfinite(neck.prominence)) record["prominence"] = 2 * neck.prominence;
    document["necks"].push_back(record);
  }
  out << document.dump(1) << "\n";
}

void write_thickness_csv(std::ostream& out, const Found_thickness& found) {
  Query_answer table;
  table.columns = {"x", "y", "thickness", "x1", "y1", "x2", "y2"};
  const auto row = [&](const ba::Medial_sample& disc) {
    const Xy<double> a = point_of(found, disc.left), b = point_of(found, disc.right);
    std::vector<std::string> fields;
    for (const double x : {disc.center.x, disc.center.y, 2 * disc.radius, a.x, a.y, b.x, b.y})
      fields.push_back(digits(x));
    return fields;
  };
  if (!found.has_limit()) {
    for (const ba::Neck& n : found.necks) table.rows.push_back(row(n.disc));
    return write_csv(out, table);
  }
  for (const char* column : {"length", "x_from", "y_from", "x_to", "y_to", "curve1", "curve2", "necks"})
    table.columns.push_back(column);
  for (const ba::Thin_stretch& s : found.stretches) {
    table.rows.push_back(row(s.disc()));
    const Xy<double> from = s.samples.front().center, to = s.samples.back().center;
    for (const double x : {s.length, from.x, from.y, to.x, to.y}) table.rows.back().push_back(digits(x));
    for (const Curve_place& p : {s.disc().left, s.disc().right})
      table.rows.back().push_back(std::to_string(number_of(found, p)));
    table.rows.back().push_back(std::to_string(
        std::count_if(found.necks.begin(), found.necks.end(), [&](const ba::Neck& neck) { return is_on(neck, s); })));
  }
  write_csv(out, table);
}

Written_drawing written_thickness(const Found_thickness& found) {
  constexpr CGAL::Bounding_arcs::Curve_colour RED{1, -1}, ORANGE{30, -1};
  Written_drawing drawing{!found.loaded.flips, found.loaded.unit_in_mm, found.loaded.page};
  const auto across = [&](const ba::Medial_sample& disc) -> std::vector<Written_piece> {
    return {Arc_2{point_of(found, disc.left), disc.center, 0}, Arc_2{disc.center, point_of(found, disc.right), 0}};
  };
  for (std::size_t k = 0; k < found.stretches.size(); ++k) {
    const std::vector<ba::Medial_sample>& samples = found.stretches[k].samples;
    std::vector<Written_piece> pieces;
    for (std::size_t i = 0; i + 1 < samples.size(); ++i)
      pieces.emplace_back(Arc_2{samples[i].center, samples[i + 1].center, 0});
    if (pieces.empty()) pieces = across(samples.front());
    drawing.curves.push_back({"thin_" + std::to_string(k), {"thin", RED}, std::move(pieces)});
  }
  for (std::size_t i = 0; i < found.necks.size(); ++i)
    drawing.curves.push_back({"neck_" + std::to_string(i), {"necks", ORANGE}, across(found.necks[i].disc)});
  return drawing;
}

}  // namespace bounding_arcs_tool
