// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The picture of hierarchies.  Strokes keep their width on the screen at any zoom, dots grow with the drawing, arcs are
// true SVG arcs, and regions are translucent in one colour a method.  Its layers, which Inkscape can switch, have in
// each a group a curve.

#include "Commands.h"
#include "svg_paths.h"

#include <algorithm>
#include <cstdio>

namespace bounding_arcs_tool {
namespace {

std::string outline(const View& view, const Output_region& region) {
  std::string path = "M" + view(region.outer.front().from);
  for (const Arc_2& piece : region.outer) path += step(view, piece, true);
  for (auto piece = region.inner.rbegin(); piece != region.inner.rend(); ++piece) path += step(view, *piece, false);
  return path + "Z";
}

std::string line(const View& view, const Output_chain& chain) {
  std::string path = "M" + view(chain.front().from);
  for (const Arc_2& piece : chain) path += step(view, piece, true);
  return path;
}

// The widths of the two kinds of dots, and whether there are both.
struct Dots {
  double of_regions, of_spirals;
  bool are_regions_halved = false;

  Dots(const View& view, const std::vector<Drawn_curve>& curves) {
    constexpr double REGION = 4.5, SPIRAL = 5.5;
    Dot_width regions, spirals;
    for (const Drawn_curve& c : curves) {
      Xy<double> start;
      bool is_first = true;
      c.hierarchy->for_each_region([&](const Output_region& region) {
        const Xy<double> from = region.outer.front().from, to = region.outer.back().to;
        regions.add(view, from, to);
        if (region.starts_spiral && !is_first) spirals.add(view, start, from);
        if (region.starts_spiral) start = from;
        else are_regions_halved = true;
        is_first = false;
      });
    }
    of_regions = regions(REGION);
    of_spirals = spirals(SPIRAL);
  }
};

}  // namespace

Palette palette(Method method) {
  switch (method) {
    case Method::BCA:
      return {"#56b4e9", "#0072b2"};
    case Method::SFA:
      return {"#e69f00", "#b34700"};
    case Method::FAT_ARC:
      return {"#c9a0dc", "#7b3294"};
    case Method::FAT_BIARC:
      return {"#e3d27a", "#8a6d00"};
    case Method::BOX:
      return {"#9ccbd6", "#1f7a8c"};
    case Method::ORIENTED_BOX:
      return {"#f3a6c4", "#c2185b"};
    case Method::HULL:
      return {"#c4c4c4", "#595959"};
    case Method::BILENS:
      break;
  }
  return {"#4dc9a5", "#007a56"};
}

void draw_svg(std::ostream& out, const std::vector<Drawn_curve>& curves, const char* method, const Palette& colours,
              double eps) {
  Box box;
  std::size_t regions = 0;
  for (const Drawn_curve& c : curves) {
    regions += c.hierarchy->size().regions;
    c.hierarchy->for_each_region([&](const Output_region& region) {
      for (const auto* chain : {&region.inner, &region.outer})
        for (const Arc_2& piece : *chain) {
          box.add(piece.from);
          box.add(piece.to);
          box.add(middle(piece));
        }
    });
  }
  const bool flips =
      std::any_of(curves.begin(), curves.end(), [](const Drawn_curve& c) { return !c.curve->record.y_is_down; });
  const Sheet sheet(box, flips);
  const View& view = sheet.view;
  const Dots dots(view, curves);
  const std::string eps_text = short_number(eps);
  const char* noun = regions == 1 ? "region" : "regions";
  char text[900];
  std::snprintf(text, sizeof text,
                "<svg %s width=\"%.0f\" height=\"%.0f\" viewBox=\"0 0 %.0f %.0f\">\n"
                "<title>%s, eps %s: %zu %s</title>\n"
                "<style>.r,.b,.c{vector-effect:non-scaling-stroke;stroke-linejoin:round}\n"
                ".r{fill:%s;fill-opacity:.65}\n.b{fill:none;stroke:%s;stroke-width:.6}\n"
                ".c{fill:none;stroke:#111;stroke-width:.9}\n"
                ".e{fill:none;stroke:#c0182b;stroke-width:%.3g;stroke-linecap:round}\n"
                ".s{fill:none;stroke:#111;stroke-width:%.3g;stroke-linecap:round}</style>\n"
                "<rect width=\"100%%\" height=\"100%%\" fill=\"#fff\"/>\n",
                SVG_NAMESPACES, sheet.width, sheet.height, sheet.width, sheet.height, method, eps_text.c_str(), regions,
                noun, colours.fill, colours.stroke, dots.of_regions, dots.of_spirals);
  out << text;
  std::snprintf(
      text, sizeof text,
      "<text x=\"%.0f\" y=\"36\" font-family=\"sans-serif\" font-size=\"20\" fill=\"#333\">%s, eps %s: %zu %s</text>\n"
      "<text x=\"%.0f\" y=\"58\" font-family=\"sans-serif\" font-size=\"14\" fill=\"#777\">dots: %s</text>\n",
      Sheet::MARGIN, method, eps_text.c_str(), regions, noun, Sheet::MARGIN,
      dots.are_regions_halved ? "black where spiral segments end, red where other regions meet"
                              : "where spiral segments end");
  out << text;
  const auto layer = [&](const char* name, const auto& draw_curve) {
    out << layer_start(name);
    for (const Drawn_curve& c : curves) {
      out << "<g><title>" << escaped(c.curve->record.name) << "</title>\n";
      draw_curve(c);
      out << "</g>\n";
    }
    out << "</g>\n";
  };
  layer("regions", [&](const Drawn_curve& c) {
    c.hierarchy->for_each_region(
        [&](const Output_region& region) { out << "<path class=\"r\" d=\"" << outline(view, region) << "\"/>\n"; });
  });
  for (const bool is_inner : {true, false})
    layer(is_inner ? "inner" : "outer", [&](const Drawn_curve& c) {
      out << "<path class=\"b\" d=\"";
      c.hierarchy->for_each_region(
          [&](const Output_region& region) { out << line(view, is_inner ? region.inner : region.outer); });
      out << "\"/>\n";
    });
  layer("curves", [&](const Drawn_curve& c) {
    out << "<path class=\"c\" d=\"";
    for (const auto& curve : c.curve->record.bezier_pieces<double>()) out << curve_path(view, curve);
    out << "\"/>\n";
  });
  layer("ends", [&](const Drawn_curve& c) {
    std::string spiral_ends, region_ends;
    Xy<double> last;
    c.hierarchy->for_each_region([&](const Output_region& region) {
      last = region.outer.back().to;
      (region.starts_spiral ? spiral_ends : region_ends) += "M" + view(region.outer.front().from) + "h0";
    });
    spiral_ends += "M" + view(last) + "h0";
    if (!region_ends.empty()) out << "<path class=\"e\" d=\"" << region_ends << "\"/>\n";
    out << "<path class=\"s\" d=\"" << spiral_ends << "\"/>\n";
  });
  out << "</svg>\n";
}

}  // namespace bounding_arcs_tool
