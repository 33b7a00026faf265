// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Transforms as style attributes write them: functions of numbers with units, about an origin.

#include "Input_text.h"
#include "Svg_scanner.h"
#include "Svg_transform.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace bounding_arcs_tool {

namespace {

constexpr double DEGREES_PER_RADIAN = 180 / 3.14159265358979323846;

struct Angle_unit {
  const char* name;
  double degrees;
};
constexpr Angle_unit ANGLE_UNITS[] = {{"deg", 1}, {"grad", 0.9}, {"rad", DEGREES_PER_RADIAN}, {"turn", 360}};

// The unit may be missing of 0 alone.
double scanned_angle(Svg_scanner& scanner) {
  const double value = scanner.number();
  const Svg_scanner at_unit = scanner;
  const std::string name = scanner.word();
  if (name.empty() && value == 0) return 0;
  for (const Angle_unit& unit : ANGLE_UNITS)
    if (name == unit.name) return value * unit.degrees;
  at_unit.expected("a unit (deg, grad, rad or turn)");
}

double scanned_css_length(Svg_scanner& scanner, double whole) {
  Svg_scanner at_unit = scanner;
  if (at_unit.number() != 0 && at_unit.word().empty()) at_unit.expected("a unit, such as px");
  return scanned_svg_length(scanner, whole);
}

double scanned_number(Svg_scanner& scanner) {
  const double value = scanner.number();
  return scanner.accept('%') ? value / 100 : value;
}

// A function of a list, in small letters. Its arguments are numbers (n), lengths along x and y (x, y) or angles (a);
// those from `least` on may be missing.
struct Css_function {
  std::string_view name, arguments;
  std::size_t least;
  Svg_transform (*map)(const std::vector<double>&);
};

Svg_transform skew(double x, double y) {
  return {1, std::tan(y / DEGREES_PER_RADIAN), std::tan(x / DEGREES_PER_RADIAN), 1, 0, 0};
}

using Values = const std::vector<double>&;
const Css_function CSS_FUNCTIONS[] = {
    {"matrix", "nnnnnn", 6, [](Values v) { return Svg_transform{v[0], v[1], v[2], v[3], v[4], v[5]}; }},
    {"translate", "xy", 1, [](Values v) { return svg_translation(v[0], v.size() > 1 ? v[1] : 0); }},
    {"translatex", "x", 1, [](Values v) { return svg_translation(v[0], 0); }},
    {"translatey", "y", 1, [](Values v) { return svg_translation(0, v[0]); }},
    {"scale", "nn", 1, [](Values v) { return svg_scaling(v[0], v.back()); }},
    {"scalex", "n", 1, [](Values v) { return svg_scaling(v[0], 1); }},
    {"scaley", "n", 1, [](Values v) { return svg_scaling(1, v[0]); }},
    {"rotate", "a", 1, [](Values v) { return svg_rotation(v[0]); }},
    {"skew", "aa", 1, [](Values v) { return skew(v[0], v.size() > 1 ? v[1] : 0); }},
    {"skewx", "a", 1, [](Values v) { return skew(v[0], 0); }},
    {"skewy", "a", 1, [](Values v) { return skew(0, v[0]); }},
};

double argument(Svg_scanner& scanner, char kind, const Svg_viewport& viewport) {
  if (kind == 'x') return scanned_css_length(scanner, viewport.width);
  if (kind == 'y') return scanned_css_length(scanner, viewport.height);
  return kind == 'a' ? scanned_angle(scanner) : scanned_number(scanner);
}

Svg_transform css_function(Svg_scanner& scanner, const Svg_viewport& viewport) {
  const Svg_scanner start = scanner;
  const std::string name = scanner.word();
  const auto* const function = std::find_if(std::begin(CSS_FUNCTIONS), std::end(CSS_FUNCTIONS),
                                            [&](const Css_function& known) { return known.name == name; });
  if (function == std::end(CSS_FUNCTIONS)) start.expected("a transform function of the plane");
  if (!scanner.accept('(')) scanner.expected("\"(\"");
  std::vector<double> values;
  for (const char kind : function->arguments) {
    scanner.skip_space();
    if (values.size() >= function->least && scanner.next() == ')') break;
    if (!values.empty() && !scanner.accept(',')) scanner.expected("\",\"");
    scanner.skip_space();
    values.push_back(argument(scanner, kind, viewport));
  }
  scanner.skip_space();
  if (!scanner.accept(')')) scanner.expected("\")\"");
  return function->map(values);
}

// A word of transform-origin, and the part of the width or height that it stands for.
struct Origin_word {
  std::string_view name;
  double part;
  char axis;  // x, y, or - for either
};
constexpr Origin_word ORIGIN_WORDS[] = {
    {"left", 0, 'x'}, {"right", 1, 'x'}, {"top", 0, 'y'}, {"bottom", 1, 'y'}, {"center", 0.5, '-'}};

// One of the two values of an origin: a word, or a length for whose per cent the axis is needed.
struct Origin_value {
  const Origin_word* word = nullptr;
  std::string_view length = "50%";

  [[nodiscard]] bool is_along(char axis) const { return word != nullptr && word->axis == axis; }
  [[nodiscard]] double along(double whole, bool in_style) const {
    if (word != nullptr) return word->part * whole;
    if (!in_style) return parsed_svg_length(length, whole);
    Svg_scanner scanner(length);
    const double value = scanned_css_length(scanner, whole);
    if (!scanner.at_end()) scanner.expected("the end of the length");
    return value;
  }
};

Origin_value origin_value(std::string_view text) {
  for (const Origin_word& word : ORIGIN_WORDS)
    if (text == word.name) return {&word, ""};
  return {nullptr, text};
}

std::vector<std::string_view> words(std::string_view text) {
  constexpr std::string_view SPACE = " \t\r\n\f";
  std::vector<std::string_view> result;
  for (std::size_t at = 0; (at = text.find_first_not_of(SPACE, at)) != text.npos;) {
    const std::size_t end = std::min(text.find_first_of(SPACE, at), text.size());
    result.push_back(text.substr(at, end - at));
    at = end;
  }
  return result;
}

}  // namespace

Svg_transform parsed_css_transform(std::string_view text, const Svg_viewport& viewport) {
  Svg_scanner scanner(text);
  Svg_transform map;
  if (text == "none") return map;
  for (scanner.skip_space(); !scanner.at_end(); scanner.skip_space()) map = map * css_function(scanner, viewport);
  return map;
}

Xy<double> parsed_transform_origin(std::string_view text, const Svg_viewport& viewport, bool in_style) {
  const std::vector<std::string_view> values = words(text);
  if (values.empty()) throw Svg_error(0, "expected 1 to 3 values, found none");
  if (values.size() > 3)  // the third is along z
    throw Svg_error(0, "expected 1 to 3 values, found " + std::to_string(values.size()));
  Origin_value x = origin_value(values[0]), y = values.size() > 1 ? origin_value(values[1]) : Origin_value();
  if (x.is_along('y') || y.is_along('x')) std::swap(x, y);
  if (x.is_along('y') || y.is_along('x'))
    throw Svg_error(0, "expected a value along each axis, found " + in_quotes(text));
  if (values.size() > 2) (void)Origin_value{nullptr, values[2]}.along(0, in_style);
  return {x.along(viewport.width, in_style), y.along(viewport.height, in_style)};
}

}  // namespace bounding_arcs_tool
