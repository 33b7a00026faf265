// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "write_carving.h"

#include "../colour_scale.h"
#include "../number_text.h"
#include "../reading.h"
#include "../svg_paths.h"
#include "gcode_options.h"

#include <CGAL/Bounding_arcs_2/medial_axis/medial_axis.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdio>
#include <string>
#include <vector>

namespace bounding_arcs_tool {

void write_carving_csv(std::ostream& out, const V_carving& carving) {
  out << "path,kind,x,y,z,bulge\n";
  std::vector<Tool_pass> passes = carving.of_bit();
  passes.insert(passes.end(), carving.flats.begin(), carving.flats.end());
  for (std::size_t i = 0; i < passes.size(); ++i) {
    const Tool_pass& pass = passes[i];
    const auto vertex = [&](const Xy<double>& p, std::size_t place, double bulge) {
      out << i << ',' << pass.title << ',' << number(p.x) << ',' << number(p.y) << ',' << number(pass.height_at(place))
          << ',' << number(bulge) << '\n';
    };
    for (std::size_t k = 0; k < pass.pieces.size(); ++k) vertex(pass.pieces[k].from, k, pass.pieces[k].bulge);
    vertex(pass.to(), pass.pieces.size(), 0);
  }
}

Written_drawing written_carving(const V_carving& carving, bool y_is_down, double unit_in_mm) {
  constexpr CGAL::Bounding_arcs::Curve_record::Colour RED{1, -1}, BLUE{5, -1}, GREEN{3, -1};
  Written_drawing drawing{y_is_down, unit_in_mm};
  const auto add = [&](const std::vector<Tool_pass>& passes, const CGAL::Bounding_arcs::Curve_record::Colour& colour) {
    for (const Tool_pass& pass : passes)
      drawing.curves.push_back(
          {pass.title, {pass.title, colour}, {pass.pieces.begin(), pass.pieces.end()}, pass.height, pass.heights});
  };
  add(carving.branches, RED);
  add(carving.pockets, BLUE);
  add(carving.flats, GREEN);
  return drawing;
}

void write_carving_gcode(std::ostream& out, const std::string& file, const V_carving& carving,
                         const Gcode_setup& setup) {
  write_gcode(out, file, carving.flats.empty() ? carving.of_bit() : carving.flats, setup);
}

namespace {

constexpr int SHADES = 25;  // of depths

// Each run of places whose depths have one shade as a path; segments that go down are cut where it changes.
void draw_pass(std::ostream& out, const Tool_pass& pass, const View& view, double deepest) {
  const double shades = deepest > 0 ? SHADES / deepest : 0;
  int last = -1;
  for (std::size_t i = 0; i < pass.pieces.size(); ++i) {
    const Arc_2& piece = pass.pieces[i];
    const double from = -shades * pass.height_at(i), to = -shades * pass.height_at(i + 1);
    const int parts = 1 + static_cast<int>(std::fabs(to - from));
    for (int k = 0; k < parts; ++k) {
      const auto at = [&](int n) { return piece.from + n / double(parts) * (piece.to - piece.from); };
      const Arc_2 part = parts == 1 ? piece : Arc_2{at(k), at(k + 1), 0};
      const int shade = (std::min)(static_cast<int>(from + (k + 0.5) / parts * (to - from)), SHADES - 1);
      if (shade != last)
        out << (last < 0 ? "" : "\"/>\n") << "<path class=\"w\" stroke=\"" << colour_of_share((shade + 0.5) / SHADES)
            << "\" d=\"M" << view(part.from);
      out << step(view, part, true);
      last = shade;
    }
  }
  out << "\"/>\n";
}

// What one tool does, with its ways from pass to pass.
void draw_tool(std::ostream& out, const std::vector<Tool_pass>& passes, const View& view, double deepest) {
  for (const Tool_pass& pass : passes) draw_pass(out, pass, view, deepest);
  for (std::size_t i = 1; i < passes.size(); ++i)
    if (passes[i].from() != passes[i - 1].to())
      out << "<path class=\"r\" d=\"M" << view(passes[i - 1].to()) << "L" << view(passes[i].from()) << "\"/>\n";
}

}  // namespace

void draw_carving(std::ostream& out, const V_carving& carving, const CGAL::Bounding_arcs::Drawing_2<double>& curves,
                  bool flips) {
  const CGAL::Bbox_2 all = curves.control_box();
  Box box;
  box.add({all.xmin(), all.ymin()}), box.add({all.xmax(), all.ymax()});
  const Sheet sheet(box, flips);
  const std::vector<Tool_pass> of_bit = carving.of_bit();
  double deepest = 0;
  for (const Tool_pass& pass : of_bit)
    for (std::size_t i = 0; i <= pass.pieces.size(); ++i) deepest = (std::max)(deepest, -pass.height_at(i));
  std::string title = count_text(of_bit.size(), "path") + " of the bit, the deepest at " + short_number(deepest);
  if (!carving.flats.empty()) title += "; " + std::to_string(carving.flats.size()) + " of the flat tool";
  char text[1200];
  const double height = sheet.height + Colour_scale::ROOM;
  std::snprintf(text, sizeof text,
                "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"%.0f\" height=\"%.0f\" viewBox=\"0 0 %.0f %.0f\">\n"
                "<title>%s</title>\n<style>path{fill:none;stroke-linejoin:round;stroke-linecap:round}\n"
                ".c{stroke:#bbb;stroke-width:1.5}.w{stroke-width:3}\n"
                ".r{stroke:#d55e00;stroke-width:1;stroke-dasharray:6 5}\n"
                "text{font-family:sans-serif;font-size:20px;fill:#333}%s</style>\n"
                "<rect width=\"100%%\" height=\"100%%\" fill=\"#fff\"/>\n<text x=\"%.0f\" y=\"36\">%s</text>\n",
                sheet.width, height, sheet.width, height, title.c_str(), Colour_scale::STYLE, Sheet::MARGIN,
                title.c_str());
  out << text;
  for (const auto& curve : curves.curves()) {
    out << "<path class=\"c\" d=\"";
    for (const auto& piece : curve.beziers) out << curve_path(sheet.view, piece);
    out << "\"/>\n";
  }
  draw_tool(out, of_bit, sheet.view, deepest);
  draw_tool(out, carving.flats, sheet.view, deepest);
  Colour_scale(sheet).draw(out, deepest, "depth; dashed: through the air");
  out << "</svg>\n";
}

}  // namespace bounding_arcs_tool
