// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The units of lengths.

#include "Svg_length.h"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <string>

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

}  // namespace

double Svg_viewport::diagonal() const { return std::hypot(width, height) / std::sqrt(2.0); }

double scanned_svg_length(Svg_scanner& scanner, double whole) {
  const double value = scanner.number();
  const Svg_scanner at_unit = scanner;
  std::string unit = scanner.word();
  std::transform(unit.begin(), unit.end(), unit.begin(), [](unsigned char c) { return std::tolower(c); });
  if (unit == "%") return value / 100 * whole;
  for (const Unit& known : UNITS)
    if (unit == known.name) return value * known.size;
  at_unit.expected("a unit (px, pt, pc, mm, cm, in, q, em, rem, ex or %)");
}

double parsed_svg_length(std::string_view text, double whole) {
  Svg_scanner scanner(text);
  scanner.skip_space();
  const double value = scanned_svg_length(scanner, whole);
  scanner.skip_space();
  if (!scanner.at_end()) scanner.expected("the end of the length");
  return value;
}

}  // namespace bounding_arcs_tool
