// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// What the pictures share: the way from the plane to the picture, arcs and curves as SVG paths, and boxes to fit in.

#ifndef BOUNDING_ARCS_TOOL_SVG_PATHS_H
#define BOUNDING_ARCS_TOOL_SVG_PATHS_H

#include "Hierarchy.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdio>
#include <iterator>
#include <limits>
#include <set>
#include <vector>

namespace bounding_arcs_tool {

/// The map from the plane to the picture, PIXELS wide or high and with y downwards; y of the plane is upwards, but
/// downwards too for curves that come from drawings.
struct View {
  double x0, y0, scale;
  bool flips;
  [[nodiscard]] Xy<double> place(const Xy<double>& p) const {
    return {(p.x - x0) * scale, (flips ? y0 - p.y : p.y - y0) * scale};
  }
  [[nodiscard]] std::string operator()(const Xy<double>& p) const {
    const Xy<double> q = place(p);
    char text[80];
    std::snprintf(text, sizeof text, "%.12g %.12g", q.x, q.y);
    return text;
  }
};

// "A ..." or "L ..." to the end of a piece run forwards or backwards.  Arcs flatter than what viewers' single precision
// resolves are drawn as segments.
inline std::string step(const View& view, const Arc_2& piece, bool forwards) {
  constexpr double FLATTEST = 2e-8;  // a height of 1e-8 chords
  const Xy<double>& to = forwards ? piece.to : piece.from;
  const double b = std::fabs(piece.bulge);
  if (b < FLATTEST) return "L" + view(to);
  const double r =
      std::hypot(piece.to.x - piece.from.x, piece.to.y - piece.from.y) * view.scale * (1 + b * b) / (4 * b);
  char text[80];  // what is counterclockwise on the screen is SVG's sweep 0
  std::snprintf(text, sizeof text, "A%.12g %.12g 0 0 %d ", r, r, ((piece.bulge > 0) == forwards) == view.flips ? 0 : 1);
  return text + view(to);
}

/// Returns the path of a Bezier piece, "M ..." and a command: a segment or curve as SVG has it, an arc, also of an
/// ellipse; a fine polyline for what SVG has not.
[[nodiscard]] std::string curve_path(const View& view, const Bezier_curve_2<double>& curve);

// The middle of an arc, off its chord's middle by the bulge times half the chord.
inline Xy<double> middle(const Arc_2& piece) {
  return 0.5 * (piece.from + piece.to) - piece.bulge / 2 * perp(piece.to - piece.from);
}

struct Box {
  double x0 = std::numeric_limits<double>::infinity(), y0 = x0, x1 = -x0, y1 = -x0;
  void add(const Xy<double>& p) {
    x0 = std::min(x0, p.x);
    y0 = std::min(y0, p.y);
    x1 = std::max(x1, p.x);
    y1 = std::max(y1, p.y);
  }
  /// The box, or the origin alone where there is no point: pictures of nothing have a size, too.
  [[nodiscard]] Box or_origin() const {
    Box box = *this;
    if (!(x0 <= x1)) box.add({0, 0});
    return box;
  }
  /// Points of a curve, enough to fit it into a picture.
  void add(const Bezier_curve_2<double>& curve) {
    constexpr int SAMPLES = 16;
    for (int i = 0; i <= SAMPLES; ++i) add(curve.point(i / double(SAMPLES)));
  }
};

/// Text in UTF-8 as content of an element or value of an attribute. What XML 1.0 has no way to write is replaced:
/// control characters by spaces, U+FFFE and U+FFFF by U+FFFD. Line breaks and tabs become spaces, too.
inline std::string escaped(const std::string& text) {
  constexpr const char *FFFE = "\xEF\xBF\xBE", *FFFF = "\xEF\xBF\xBF", *REPLACEMENT = "\xEF\xBF\xBD";
  std::string out;
  for (std::size_t i = 0; i < text.size(); ++i) {
    const char c = text[i];
    if (text.compare(i, 3, FFFE) == 0 || text.compare(i, 3, FFFF) == 0) {
      out += REPLACEMENT;
      i += 2;
    } else if (c == '<') out += "&lt;";
    else if (c == '>') out += "&gt;";  // ends no element, but "]]>" may not stand in content
    else if (c == '&') out += "&amp;";
    else if (c == '"') out += "&quot;";
    else if (static_cast<unsigned char>(c) < 0x20) out += ' ';
    else out += c;
  }
  return out;
}

/// A group that drawing programs show as a layer of that name, to be closed by "</g>".
inline std::string layer_start(const std::string& name) {
  return "<g id=\"" + name + "\" inkscape:groupmode=\"layer\" inkscape:label=\"" + name + "\">\n";
}
/// Namespaces of the root element of a picture with layers.
constexpr const char* SVG_NAMESPACES =
    "xmlns=\"http://www.w3.org/2000/svg\" xmlns:inkscape=\"http://www.inkscape.org/namespaces/inkscape\"";

/// A colour of each of some things, another one than those of its neighbours, where there are as many; told apart also
/// by the colour-blind (Okabe, Ito 2008).
/// \param neighbours of each of them
inline std::vector<const char*> colours_apart(const std::vector<std::set<std::size_t>>& neighbours) {
  constexpr const char* COLOURS[] = {"#0072b2", "#e69f00", "#009e73", "#cc79a7", "#56b4e9", "#f0e442", "#d55e00"};
  constexpr std::size_t COUNT = std::size(COLOURS);
  std::vector<std::size_t> number(neighbours.size(), COUNT);
  std::vector<const char*> colours;
  for (std::size_t i = 0; i < number.size(); ++i) {
    std::vector<bool> is_taken(COUNT + 1, false);
    for (const std::size_t k : neighbours[i]) is_taken[number[k]] = true;
    const auto free = std::find(is_taken.begin(), is_taken.end() - 1, false);
    number[i] = static_cast<std::size_t>(free - is_taken.begin()) % COUNT;
    colours.push_back(COLOURS[number[i]]);
  }
  return colours;
}

/// The view that fits a box into a picture with a margin and two lines of text above, and the picture's size.
struct Sheet {
  static constexpr double PIXELS = 1000, MARGIN = 40, TITLE = 40, LEAST_WIDTH = 560;  // for the text
  View view;
  double width, height;

  /// \param flips y of the plane is upwards
  Sheet(const Box& drawn, bool flips) {
    const Box box = drawn.or_origin();
    const double extent = std::max(box.x1 - box.x0, box.y1 - box.y0);
    const double scale =
        extent > PIXELS / std::numeric_limits<double>::max() ? PIXELS / extent : 1;  // a point has no extent
    const double top = (MARGIN + TITLE) / scale;
    width = std::max((box.x1 - box.x0) * scale + 2 * MARGIN, LEAST_WIDTH);
    const double left = (width - (box.x1 - box.x0) * scale) / 2 / scale;
    view = {box.x0 - left, flips ? box.y1 + top : box.y0 - top, scale, flips};
    height = (box.y1 - box.y0) * scale + 2 * MARGIN + TITLE;
  }
};

/// How wide dots are, in pixels of the picture as it is made; they grow with it. Half of what is usual between
/// neighbours, so that they hide no line, however small what is drawn.
class Dot_width {
 public:
  /// The distance between two neighbours, in pixels.
  void add(double distance) {
    if (distance > 0) distances_.push_back(distance);
  }
  void add(const View& view, const Xy<double>& p, const Xy<double>& q) {
    add(view.scale * std::hypot(q.x - p.x, q.y - p.y));
  }
  /// \param largest where there is room
  [[nodiscard]] double operator()(double largest) {
    constexpr double SHARE = 0.5;
    if (distances_.empty()) return largest;
    const auto median = distances_.begin() + static_cast<std::ptrdiff_t>(distances_.size() / 2);
    std::nth_element(distances_.begin(), median, distances_.end());
    return std::min(largest, SHARE * *median);
  }

 private:
  std::vector<double> distances_;
};

}  // namespace bounding_arcs_tool

#endif
