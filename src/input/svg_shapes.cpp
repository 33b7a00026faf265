// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The shapes of SVG as drawing commands.

#include "Svg_element.h"

#include <algorithm>

namespace bounding_arcs_tool {

namespace {

using Point = Xy<double>;

void line_unless_there(Svg_outline& outline, const Point& p) {
  if (outline.current() != p) outline.line_to(p);
}

void draw_path(const Svg_element& element, const Svg_viewport&, Svg_outline& outline) {
  element.parsed("d", [&](std::string_view data) {
    if (data != "none") draw_path_data(data, outline);
  });
}

void draw_sharp_rect(const Point& low, const Point& high, Svg_outline& outline) {
  outline.move_to(low);
  outline.line_to({high.x, low.y});
  outline.line_to(high);
  outline.line_to({low.x, high.y});
  outline.close();
}

// Counterclockwise in the coordinates as they are, from the start of the side y = low.y.
void draw_rounded_rect(const Point& low, const Point& size, double rx, double ry, Svg_outline& outline) {
  const Point high{low.x + size.x, low.y + size.y};
  const double x1 = low.x + rx, y1 = low.y + ry;
  const double x2 = 2 * rx < size.x ? high.x - rx : x1, y2 = 2 * ry < size.y ? high.y - ry : y1;
  outline.move_to({x1, low.y});
  line_unless_there(outline, {x2, low.y});
  outline.quarter_to({high.x, low.y}, {high.x, y1});
  line_unless_there(outline, {high.x, y2});
  outline.quarter_to(high, {x2, high.y});
  line_unless_there(outline, {x1, high.y});
  outline.quarter_to({low.x, high.y}, {low.x, y2});
  line_unless_there(outline, {low.x, y1});
  outline.quarter_to(low, {x1, low.y});
  outline.close();
}

void draw_rect(const Svg_element& element, const Svg_viewport& viewport, Svg_outline& outline) {
  const double width = element.size("width", viewport.width, 0), height = element.size("height", viewport.height, 0);
  const Point low{element.length("x", viewport.width, 0), element.length("y", viewport.height, 0)};
  const double given_rx = element.length("rx", viewport.width, -1),
               given_ry = element.length("ry", viewport.height, -1);
  const double rx = std::min(given_rx < 0 ? std::max(given_ry, 0.0) : given_rx, width / 2);
  const double ry = std::min(given_ry < 0 ? std::max(given_rx, 0.0) : given_ry, height / 2);
  if (width == 0 || height == 0) return;
  if (rx == 0 || ry == 0) return draw_sharp_rect(low, {low.x + width, low.y + height}, outline);
  draw_rounded_rect(low, {width, height}, rx, ry, outline);
}

void draw_ellipse(const Point& center, double rx, double ry, Svg_outline& outline) {
  if (rx == 0 || ry == 0) return;
  const Point low{center.x - rx, center.y - ry}, high{center.x + rx, center.y + ry};
  outline.move_to({high.x, center.y});
  outline.quarter_to(high, {center.x, high.y});
  outline.quarter_to({low.x, high.y}, {low.x, center.y});
  outline.quarter_to(low, {center.x, low.y});
  outline.quarter_to({high.x, low.y}, {high.x, center.y});
  outline.close();
}

Point center_of(const Svg_element& element, const Svg_viewport& viewport) {
  return {element.length("cx", viewport.width, 0), element.length("cy", viewport.height, 0)};
}

void draw_circle(const Svg_element& element, const Svg_viewport& viewport, Svg_outline& outline) {
  const double r = element.size("r", viewport.diagonal(), 0);
  draw_ellipse(center_of(element, viewport), r, r, outline);
}

void draw_ellipse_element(const Svg_element& element, const Svg_viewport& viewport, Svg_outline& outline) {
  const double given_rx = element.length("rx", viewport.width, -1),
               given_ry = element.length("ry", viewport.height, -1);
  const double rx = given_rx < 0 ? std::max(given_ry, 0.0) : given_rx;
  draw_ellipse(center_of(element, viewport), rx, given_ry < 0 ? rx : given_ry, outline);
}

void draw_line(const Svg_element& element, const Svg_viewport& viewport, Svg_outline& outline) {
  outline.move_to({element.length("x1", viewport.width, 0), element.length("y1", viewport.height, 0)});
  outline.line_to({element.length("x2", viewport.width, 0), element.length("y2", viewport.height, 0)});
}

void draw_points(const Svg_element& element, const Svg_viewport&, Svg_outline& outline) {
  element.parsed("points", [&](std::string_view text) {
    Svg_scanner scanner(text);
    scanner.skip_space();
    bool comma = false, is_first = true;
    for (; comma || !scanner.at_end(); is_first = false) {
      const double x = scanner.number();
      scanner.skip_separator();
      const Point p{x, scanner.number()};
      comma = scanner.skip_separator();
      if (is_first) outline.move_to(p);
      else outline.line_to(p);
    }
  });
  if (element.name() == "polygon") outline.close();
}

struct Shape {
  std::string_view name;
  void (*draw)(const Svg_element&, const Svg_viewport&, Svg_outline&);
};

constexpr Shape SHAPES[] = {{"path", draw_path},     {"rect", draw_rect},       {"circle", draw_circle},
                            {"line", draw_line},     {"polyline", draw_points}, {"ellipse", draw_ellipse_element},
                            {"polygon", draw_points}};

const Shape* find_shape(std::string_view name) {
  const auto* const found =
      std::find_if(std::begin(SHAPES), std::end(SHAPES), [&](const Shape& shape) { return shape.name == name; });
  return found == std::end(SHAPES) ? nullptr : found;
}

}  // namespace

bool is_svg_shape(std::string_view name) { return find_shape(name) != nullptr; }

void draw_svg_shape(const Svg_element& element, const Svg_viewport& viewport, Svg_outline& outline) {
  find_shape(element.name())->draw(element, viewport, outline);
}

}  // namespace bounding_arcs_tool
