// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Lengths with units, and the mapping of viewports.

#include "Svg_element.h"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <cstring>
#include <vector>

namespace bounding_arcs_tool {

namespace {

struct Unit {
  const char* name;
  double size;
};

// User units in a unit, 96 of them to the inch; the font is taken to be 16 units high and half that for small letters.
constexpr Unit UNITS[] = {{"", 1},           {"px", 1},         {"pt", 96.0 / 72}, {"pc", 16},
                          {"mm", 96 / 25.4}, {"cm", 96 / 2.54}, {"in", 96},        {"q", 96 / 101.6},
                          {"em", 16},        {"rem", 16},       {"ex", 8}};

// What browsers take for a drawing that does not say its size.
constexpr Svg_viewport DEFAULT_VIEWPORT{300, 150};

double parsed_length(std::string_view text, double whole) {
  Svg_scanner scanner(text);
  scanner.skip_space();
  const double value = scanner.number();
  const Svg_scanner at_unit = scanner;
  std::string unit = scanner.word();
  std::transform(unit.begin(), unit.end(), unit.begin(), [](unsigned char c) { return std::tolower(c); });
  scanner.skip_space();
  if (!scanner.at_end()) scanner.expected("the end of the length");
  if (unit == "%") return value / 100 * whole;
  for (const Unit& known : UNITS)
    if (unit == known.name) return value * known.size;
  at_unit.expected("a unit (px, pt, pc, mm, cm, in, q, em, rem, ex or %)");
}

struct Viewbox {
  double x, y, width, height;
};

Viewbox parsed_viewbox(std::string_view text) {
  Svg_scanner scanner(text);
  double v[4];
  scanner.skip_space();
  for (double& number : v) {
    number = scanner.number();
    scanner.skip_separator();
  }
  if (!scanner.at_end()) scanner.expected("the end after four numbers");
  if (!(v[2] > 0 && v[3] > 0)) throw Svg_error(0, "the width and height must be positive");
  return {v[0], v[1], v[2], v[3]};
}

// A preserveAspectRatio: the parts of the room left over that come before the contents, 0, 1/2 or 1, and which scale is
// taken of the two.
struct Aspect_ratio {
  double left = 0.5, top = 0.5;
  enum { MEET, SLICE, NONE } kind = MEET;
};

// An invalid value counts as none, as the standard has it.
Aspect_ratio parsed_aspect_ratio(std::string_view text) {
  Svg_scanner scanner(text);
  const auto word = [&] {
    scanner.skip_space();
    return scanner.word();
  };
  std::string align = word();
  if (align == "defer") align = word();
  const std::string scale = word();
  scanner.skip_space();
  if (!scanner.at_end() || (!scale.empty() && scale != "meet" && scale != "slice")) return {};
  Aspect_ratio ratio;
  ratio.kind = align == "none" ? Aspect_ratio::NONE : scale == "slice" ? Aspect_ratio::SLICE : Aspect_ratio::MEET;
  if (ratio.kind == Aspect_ratio::NONE) return ratio;
  const std::string_view places[] = {"Min", "Mid", "Max"};
  for (int x = 0; x < 3; ++x)
    for (int y = 0; y < 3; ++y)
      if (align == "x" + std::string(places[x]) + "Y" + std::string(places[y])) {
        ratio.left = x / 2.0;
        ratio.top = y / 2.0;
        return ratio;
      }
  return {};
}

// The text in small letters, without spaces and comments.
std::string plain(std::string_view text) {
  std::string result;
  while (!text.empty()) {
    const std::size_t comment = std::min(text.find("/*"), text.size());
    for (const unsigned char c : text.substr(0, comment))
      if (!std::isspace(c)) result += static_cast<char>(std::tolower(c));
    const std::size_t end = text.find("*/", std::min(comment + 2, text.size()));
    text.remove_prefix(comment == text.size() || end == text.npos ? text.size() : end + 2);
  }
  return result;
}

// What a style attribute sets display to, "" if it does not: by the last declaration that is important, or the last.
std::string styled_display(std::string_view style) {
  const std::string text = plain(style) + ";";
  const std::string_view property = "display:", important = "!important";
  std::string value;
  bool is_important = false;
  for (std::size_t start = 0, end; (end = text.find(';', start)) != text.npos; start = end + 1) {
    std::string_view declaration = std::string_view(text).substr(start, end - start);
    if (declaration.substr(0, property.size()) != property) continue;
    declaration.remove_prefix(property.size());
    const std::size_t mark = declaration.find(important);
    if (is_important && mark == declaration.npos) continue;
    is_important = mark != declaration.npos;
    value = declaration.substr(0, mark);
  }
  return value;
}

}  // namespace

double Svg_viewport::diagonal() const { return std::hypot(width, height) / std::sqrt(2.0); }

std::size_t Svg_element::attribute_bytes() const {
  std::size_t bytes = 0;
  for (const pugi::xml_attribute& attribute : node_.attributes()) bytes += 1 + std::strlen(attribute.value());
  return bytes;
}

bool Svg_element::is_hidden() const {
  const std::string in_style = styled_display(node_.attribute("style").value());
  return (in_style.empty() ? plain(node_.attribute("display").value()) : in_style) == "none";
}

bool Svg_element::is_wanted() const {
  if (has("requiredExtensions")) return false;
  if (!has("systemLanguage")) return true;
  const std::string languages = "," + plain(node_.attribute("systemLanguage").value()) + ",";
  return languages.find(",en,") != languages.npos || languages.find(",en-") != languages.npos;
}

std::string_view Svg_element::reference() const {
  const pugi::xml_attribute plain = node_.attribute("href");
  return plain.empty() ? node_.attribute("xlink:href").value() : plain.value();
}

double Svg_element::length(const char* attribute, double whole, double otherwise) const {
  return parsed(attribute, [&](std::string_view text) {
    return !has(attribute) || text == "auto" ? otherwise : parsed_length(text, whole);
  });
}

double Svg_element::size(const char* attribute, double whole, double otherwise) const {
  const double size = length(attribute, whole, otherwise);
  return parsed(attribute, [&](std::string_view) {
    if (size < 0) throw Svg_error(1, "expected a size that is not negative");
    return size;
  });
}

Svg_transform Svg_element::transform() const { return parsed("transform", parsed_svg_transform); }

Svg_transform Svg_element::viewbox_transform(Svg_viewport& viewport) const {
  if (!has("viewBox")) return {};
  const Viewbox box = parsed("viewBox", parsed_viewbox);
  const Aspect_ratio ratio = parsed_aspect_ratio(node_.attribute("preserveAspectRatio").value());
  double sx = viewport.width / box.width, sy = viewport.height / box.height;
  if (ratio.kind != Aspect_ratio::NONE)
    sx = sy = ratio.kind == Aspect_ratio::MEET ? std::min(sx, sy) : std::max(sx, sy);
  const double left = (viewport.width - sx * box.width) * ratio.left;
  const double top = (viewport.height - sy * box.height) * ratio.top;
  viewport = {box.width, box.height};
  return svg_translation(left, top) * svg_scaling(sx, sy) * svg_translation(-box.x, -box.y);
}

Svg_viewport Svg_element::root_viewport() const {
  if (has("viewBox")) {
    const Viewbox box = parsed("viewBox", parsed_viewbox);
    return {box.width, box.height};
  }
  const Svg_viewport& none = DEFAULT_VIEWPORT;
  return {length("width", none.width, none.width), length("height", none.height, none.height)};
}

}  // namespace bounding_arcs_tool
