// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The picture of hierarchies.  Strokes and dots keep their width on the screen at any zoom, arcs are true SVG arcs, and
// regions are translucent in one colour a method.

#include "Commands.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <limits>

namespace bounding_arcs_tool {
namespace {

/// From the plane to the picture, PIXELS wide or high and with y downwards; y of the plane is upwards, but downwards
/// too for curves that come from drawings.
struct View {
  double x0, y0, scale;
  bool flips;
  [[nodiscard]] std::string operator()(const Xy<double>& p) const {
    char text[80];
    std::snprintf(text, sizeof text, "%.12g %.12g", (p.x - x0) * scale, (flips ? y0 - p.y : p.y - y0) * scale);
    return text;
  }
};

// "A ..." or "L ..." to the end of a piece run forwards or backwards.  Arcs flatter than what viewers' single precision
// resolves are drawn as segments.
std::string step(const View& view, const Output_piece& piece, bool forwards) {
  constexpr double FLATTEST = 1e7;  // radius over chord: a height of 1e-8 chords
  const Xy<double>& to = forwards ? piece.to : piece.from;
  const double chord = std::hypot(piece.to.x - piece.from.x, piece.to.y - piece.from.y);
  if (!(piece.radius > 0) || piece.radius > FLATTEST * chord) return "L" + view(to);
  const double r = piece.radius * view.scale;
  char text[80];  // what is counterclockwise on the screen is SVG's sweep 0
  std::snprintf(text, sizeof text, "A%.12g %.12g 0 0 %d ", r, r, (piece.ccw == forwards) == view.flips ? 0 : 1);
  return text + view(to);
}

std::string outline(const View& view, const Output_region& region) {
  std::string path = "M" + view(region.outer.front().from);
  for (const Output_piece& piece : region.outer) path += step(view, piece, true);
  for (auto piece = region.inner.rbegin(); piece != region.inner.rend(); ++piece) path += step(view, *piece, false);
  return path + "Z";
}

// A Bezier piece as SVG has it, or for higher degrees and weights as a fine polyline.
std::string curve_path(const View& view, const Bezier_curve_2<double>& curve) {
  const auto& p = curve.control_points();
  std::string path = "M" + view(p.front());
  constexpr int LARGEST_SVG_DEGREE = 3, SAMPLES = 256;
  if (!curve.is_rational() && curve.degree() <= LARGEST_SVG_DEGREE) {
    path += curve.degree() == 1 ? "L" : (curve.degree() == 2 ? "Q" : "C");
    for (std::size_t i = 1; i < p.size(); ++i) path += (i > 1 ? " " : "") + view(p[i]);
    return path;
  }
  path += "L";
  for (int i = 1; i <= SAMPLES; ++i) path += (i > 1 ? " " : "") + view(curve.point(i / double(SAMPLES)));
  return path;
}

// The middle of an arc, off its chord's middle by its height r - sqrt(r^2 - c^2/4).
Xy<double> middle(const Output_piece& piece) {
  const Xy<double> chord = piece.to - piece.from, center = 0.5 * (piece.from + piece.to);
  const double quarter = dot(chord, chord) / 4, r = piece.radius;
  if (!(r > 0) || quarter == 0) return center;
  const double height = quarter / (r + std::sqrt(std::max(0.0, r * r - quarter)));
  return center - (piece.ccw ? 1 : -1) * height / (2 * std::sqrt(quarter)) * perp(chord);
}

struct Box {
  double x0 = std::numeric_limits<double>::infinity(), y0 = x0, x1 = -x0, y1 = -x0;
  void add(const Xy<double>& p) {
    x0 = std::min(x0, p.x);
    y0 = std::min(y0, p.y);
    x1 = std::max(x1, p.x);
    y1 = std::max(y1, p.y);
  }
};

std::string escaped(const std::string& text) {
  std::string out;
  for (const char c : text) {
    if (c == '<') out += "&lt;";
    else if (c == '&') out += "&amp;";
    else if (c == '"') out += "&quot;";
    else if (static_cast<unsigned char>(c) < 0x20) out += ' ';
    else out += c;
  }
  return out;
}

}  // namespace

Palette palette(Method method) {
  switch (method) {
    case Method::BCA: return {"#56b4e9", "#0072b2"};
    case Method::SFA: return {"#e69f00", "#b34700"};
    case Method::BILENS: break;
  }
  return {"#4dc9a5", "#007a56"};
}

void draw_svg(std::ostream& out, const std::vector<Drawn_curve>& curves, Method method, double eps) {
  Box box;
  std::size_t regions = 0;
  for (const Drawn_curve& c : curves) {
    regions += c.hierarchy->size().regions;
    c.hierarchy->for_each_region([&](const Output_region& region) {
      for (const auto* chain : {&region.inner, &region.outer})
        for (const Output_piece& piece : *chain) {
          box.add(piece.from);
          box.add(piece.to);
          box.add(middle(piece));
        }
    });
  }
  constexpr double PIXELS = 1000, MARGIN = 40, TITLE = 40;
  const double extent = std::max(box.x1 - box.x0, box.y1 - box.y0);
  const double scale = extent > PIXELS / std::numeric_limits<double>::max() ? PIXELS / extent : 1;  // a point has no extent
  const bool flips = std::any_of(curves.begin(), curves.end(), [](const Drawn_curve& c) {
    return c.curve->record.type != Curve_record::PATH;
  });
  const double top = (MARGIN + TITLE) / scale;
  const View view{box.x0 - MARGIN / scale, flips ? box.y1 + top : box.y0 - top, scale, flips};
  const double width = (box.x1 - box.x0) * scale + 2 * MARGIN, height = (box.y1 - box.y0) * scale + 2 * MARGIN + TITLE;
  const Palette colours = palette(method);
  char text[900];
  std::snprintf(text, sizeof text,
                "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"%.0f\" height=\"%.0f\" viewBox=\"0 0 %.0f %.0f\">\n"
                "<title>%s, eps %g: %zu regions</title>\n"
                "<style>path{vector-effect:non-scaling-stroke;stroke-linejoin:round}\n"
                ".r{fill:%s;fill-opacity:.65;stroke:%s;stroke-width:.6}\n"
                ".c{fill:none;stroke:#111;stroke-width:.9}\n"
                ".e{fill:none;stroke:#c0182b;stroke-width:4.5;stroke-linecap:round}\n"
                ".s{fill:none;stroke:#111;stroke-width:5.5;stroke-linecap:round}</style>\n"
                "<rect width=\"100%%\" height=\"100%%\" fill=\"#fff\"/>\n",
                width, height, width, height, name_of(method), eps, regions, colours.fill, colours.stroke);
  out << text;
  std::snprintf(text, sizeof text,
                "<text x=\"%.0f\" y=\"36\" font-family=\"sans-serif\" font-size=\"20\" fill=\"#333\">%s, eps %g: %zu regions</text>\n"
                "<text x=\"%.0f\" y=\"58\" font-family=\"sans-serif\" font-size=\"14\" fill=\"#777\">dots: black where spiral "
                "segments meet, red where regions meet</text>\n",
                MARGIN, name_of(method), eps, regions, MARGIN);
  out << text;
  for (const Drawn_curve& c : curves) {
    out << "<g><title>" << escaped(c.curve->record.name) << "</title>\n";
    std::string spiral_ends, region_ends;
    Xy<double> last;
    c.hierarchy->for_each_region([&](const Output_region& region) {
      last = region.outer.back().to;
      out << "<path class=\"r\" d=\"" << outline(view, region) << "\"/>\n";
      (region.starts_spiral ? spiral_ends : region_ends) += "M" + view(region.outer.front().from) + "h0";
    });
    spiral_ends += "M" + view(last) + "h0";
    out << "<path class=\"c\" d=\"";
    for (const auto& curve : bezier_pieces<double>(c.curve->record)) out << curve_path(view, curve);
    out << "\"/>\n<path class=\"e\" d=\"" << region_ends << "\"/>\n<path class=\"s\" d=\"" << spiral_ends << "\"/></g>\n";
  }
  out << "</svg>\n";
}

}  // namespace bounding_arcs_tool
