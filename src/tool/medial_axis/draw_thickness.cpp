// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The picture of thickness.

#include "write_thickness.h"

#include "../colour_scale.h"
#include "../number_text.h"
#include "../svg_paths.h"

#include <CGAL/Bounding_arcs_2/medial_axis/medial_axis.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <string>
#include <utility>
#include <vector>

namespace bounding_arcs_tool {
namespace {

// The discs of the axis, the largest on top, so that each point has the colour of the largest disc that covers it.
// Cells below them, each between two discs and the places that they touch, fill what lies between the discs and the
// curves.
void draw_discs(std::ostream& out, const Found_thickness& found, const View& view, double largest) {
  const ba::Medial_axis_2& axis = found.axis.axis;
  std::vector<std::pair<double, Xy<double>>> discs;
  for (const ba::Medial_axis_2::Vertex& v : axis.vertices) discs.push_back({v.radius, v.center});
  for (const ba::Medial_axis_2::Edge& e : axis.edges)
    for (std::size_t i = 1; i < e.samples.size(); ++i) {
      const ba::Medial_axis_2::Sample &a = e.samples[i - 1], &b = e.samples[i];
      discs.push_back({b.radius, b.center});
      const auto foot = [&](const Curve_place& p) { return "L" + view(point_of(found, p)); };
      const std::string fill = colour_of_share((a.radius + b.radius) / 2 / largest);
      out << "<path fill=\"" << fill << "\" stroke=\"" << fill << "\" d=\"M" << view(a.center) << foot(a.left)
          << foot(b.left) << "L" << view(b.center) << foot(b.right) << foot(a.right) << "Z\"/>\n";
    }
  std::stable_sort(discs.begin(), discs.end(), [](const auto& a, const auto& b) { return a.first < b.first; });
  char text[160];
  for (const auto& [radius, center] : discs) {
    const Xy<double> c = view.place(center);
    std::snprintf(text, sizeof text, "<circle cx=\"%.7g\" cy=\"%.7g\" r=\"%.7g\" fill=\"%s\"/>\n", c.x, c.y,
                  radius * view.scale, colour_of_share(radius / largest).c_str());
    out << text;
  }
}

std::string counted(std::size_t count, const std::string& thing, const std::string& things) {
  return std::to_string(count) + " " + (count == 1 ? thing : things);
}

std::string title_of(const Found_thickness& found, double largest) {
  std::string title;
  if (found.has_limit()) {
    title = counted(found.stretches.size(), "stretch", "stretches") + " thinner than " + number(found.below);
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
  for (const ba::Medial_axis_2::Thin_stretch& stretch : found.stretches) {
    out << "<path class=\"t\" d=\"M" << view(stretch.samples.front().center);
    for (const ba::Medial_axis_2::Sample& s : stretch.samples) out << "L" << view(s.center);
    out << "\"><title>" << short_number(stretch.thickness()) << "</title></path>\n";
  }
}
void draw_necks(std::ostream& out, const Found_thickness& found, const View& view) {
  for (const ba::Medial_axis_2::Neck& neck : found.necks)
    out << "<path class=\"n\" d=\"M" << view(point_of(found, neck.disc.left)) << "L" << view(neck.disc.center) << "L"
        << view(point_of(found, neck.disc.right)) << "\"><title>" << short_number(neck.thickness())
        << "</title></path>\n";
}

// Circles about places where a part of the axis is left open.
void draw_unresolved(std::ostream& out, const Found_thickness& found, const View& view) {
  constexpr double RADIUS = 12;  // pixels
  char text[100];
  for (const Xy<double>& p : found.axis.axis.unresolved) {
    const Xy<double> c = view.place(p);
    std::snprintf(text, sizeof text, "<circle class=\"u\" cx=\"%.7g\" cy=\"%.7g\" r=\"%g\"/>\n", c.x, c.y, RADIUS);
    out << text;
  }
}

// What the colours mean: thickness from 0 to that of the largest disc, with a mark at the limit.
void draw_scale(std::ostream& out, const Found_thickness& found, const Sheet& sheet, double largest) {
  const Colour_scale scale(sheet);
  scale.draw(out, 2 * largest, found.has_limit() ? "thickness, red where it is below the limit" : "thickness");
  if (!found.has_limit() || found.below > 2 * largest) return;
  char text[200];
  std::snprintf(text, sizeof text, "<path class=\"l\" d=\"M%.4f %.4fv%g\"/>\n",
                scale.place(found.below / (2 * largest)), scale.top() - Colour_scale::HEIGHT / 2,
                2 * Colour_scale::HEIGHT);
  out << text;
}

}  // namespace

void draw_thickness(std::ostream& out, const Found_thickness& found) {
  const CGAL::Bbox_2 all = found.loaded.curves->drawing().control_box();
  Box box;
  box.add({all.xmin(), all.ymin()}), box.add({all.xmax(), all.ymax()});
  const Sheet sheet(box, found.loaded.flips);
  const double largest = found.thickest ? found.thickest->radius : 1, height = sheet.height + Colour_scale::ROOM;
  char text[1200];
  const std::string title = title_of(found, largest);
  std::snprintf(text, sizeof text,
                "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"%.0f\" height=\"%.0f\" viewBox=\"0 0 %.0f %.0f\">\n"
                "<title>%s</title>\n<style>.c{fill:none;stroke:#333;stroke-width:1.5}\n"
                ".t{fill:none;stroke:#d00000;stroke-width:5;stroke-linecap:round;stroke-linejoin:round}\n"
                ".n{fill:none;stroke:#d55e00;stroke-width:3;stroke-linecap:round}\n"
                ".u{fill:none;stroke:#d55e00;stroke-width:2}.l{stroke:#d00000;stroke-width:3}\n"
                "text{font-family:sans-serif;font-size:20px;fill:#333}%s</style>\n"
                "<rect width=\"100%%\" height=\"100%%\" fill=\"#fff\"/>\n<text x=\"%.0f\" y=\"36\">%s</text>\n",
                sheet.width, height, sheet.width, height, title.c_str(), Colour_scale::STYLE, Sheet::MARGIN,
                title.c_str());
  out << text;
  draw_discs(out, found, sheet.view, largest);
  draw_curves(out, found, sheet.view);
  draw_stretches(out, found, sheet.view);
  draw_necks(out, found, sheet.view);
  draw_unresolved(out, found, sheet.view);
  draw_scale(out, found, sheet, largest);
  out << "</svg>\n";
}

}  // namespace bounding_arcs_tool
