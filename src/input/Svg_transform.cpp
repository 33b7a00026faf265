// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Composition and the grammar of transform attributes.

#include "Svg_transform.h"

#include "Svg_scanner.h"

#include <cmath>
#include <string>
#include <vector>

namespace bounding_arcs_tool {

namespace {

constexpr double RADIANS_PER_DEGREE = 3.14159265358979323846 / 180;

// A function of the transform list. A count of arguments within [least, most] is needed, and never `not_allowed`.
struct Function {
  const char* name;
  std::size_t least, most, not_allowed;
  Svg_transform (*map)(const std::vector<double>&);
};

const Function FUNCTIONS[] = {
    {"matrix", 6, 6, 0, [](const std::vector<double>& v) { return Svg_transform{v[0], v[1], v[2], v[3], v[4], v[5]}; }},
    {"translate", 1, 2, 0, [](const std::vector<double>& v) { return svg_translation(v[0], v.size() > 1 ? v[1] : 0); }},
    {"scale", 1, 2, 0, [](const std::vector<double>& v) { return svg_scaling(v[0], v.back()); }},
    {"rotate", 1, 3, 2,
     [](const std::vector<double>& v) {
       if (v.size() == 1) return svg_rotation(v[0]);
       return svg_translation(v[1], v[2]) * svg_rotation(v[0]) * svg_translation(-v[1], -v[2]);
     }},
    {"skewX", 1, 1, 0,
     [](const std::vector<double>& v) { return Svg_transform{1, 0, std::tan(v[0] * RADIANS_PER_DEGREE), 1, 0, 0}; }},
    {"skewY", 1, 1, 0,
     [](const std::vector<double>& v) { return Svg_transform{1, std::tan(v[0] * RADIANS_PER_DEGREE), 0, 1, 0, 0}; }},
};

std::vector<double> arguments(Svg_scanner& scanner) {
  scanner.skip_space();
  if (!scanner.accept('(')) scanner.expected("\"(\"");
  scanner.skip_space();
  std::vector<double> values;
  for (bool comma = false; comma || scanner.at_number(); comma = scanner.skip_separator())
    values.push_back(scanner.number());
  if (!scanner.accept(')')) scanner.expected("a number or \")\"");
  return values;
}

Svg_transform function(Svg_scanner& scanner) {
  const Svg_scanner start = scanner;
  const std::string name = scanner.word();
  for (const Function& function : FUNCTIONS) {
    if (name != function.name) continue;
    const std::vector<double> values = arguments(scanner);
    if (values.size() < function.least || values.size() > function.most || values.size() == function.not_allowed)
      start.fail("expected as many arguments as " + name + " takes, found " + std::to_string(values.size()));
    return function.map(values);
  }
  start.expected("matrix, translate, scale, rotate, skewX or skewY");
}

}  // namespace

Xy<double> Svg_transform::operator()(const Xy<double>& p) const {
  if (a == 1 && b == 0 && c == 0 && d == 1 && e == 0 && f == 0) return {p.x + 0.0, p.y + 0.0};
  return {a * p.x + c * p.y + e + 0.0, b * p.x + d * p.y + f + 0.0};
}

Svg_transform Svg_transform::operator*(const Svg_transform& second) const {
  const Svg_transform& s = second;
  return {a * s.a + c * s.b, b * s.a + d * s.b,     a * s.c + c * s.d,
          b * s.c + d * s.d, a * s.e + c * s.f + e, b * s.e + d * s.f + f};
}

Svg_transform svg_translation(double x, double y) { return {1, 0, 0, 1, x, y}; }

Svg_transform svg_scaling(double x, double y) { return {x, 0, 0, y, 0, 0}; }

Svg_transform svg_rotation(double degrees) {
  // remquo is exact, so that a multiple of 90 leaves no rest; the last bits of the quotient are the quarter turns.
  int quarters = 0;
  const double rest = std::remquo(degrees, 90.0, &quarters) * RADIANS_PER_DEGREE;
  const double cosine = std::cos(rest), sine = std::sin(rest);
  switch (quarters & 3) {
    case 0:
      return {cosine, sine, -sine, cosine, 0, 0};
    case 1:
      return {-sine, cosine, -cosine, -sine, 0, 0};
    case 2:
      return {-cosine, -sine, sine, -cosine, 0, 0};
    default:
      return {sine, -cosine, cosine, sine, 0, 0};
  }
}

Svg_transform parsed_svg_transform(std::string_view text) {
  Svg_scanner scanner(text);
  Svg_transform map;
  scanner.skip_space();
  if (text.substr(scanner.character() - 1) == "none") return map;
  while (!scanner.at_end()) {
    map = map * function(scanner);
    scanner.skip_separator();
  }
  return map;
}

}  // namespace bounding_arcs_tool
