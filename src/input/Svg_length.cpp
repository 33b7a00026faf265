// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The units of lengths.

#include "Svg_length.h"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <iterator>
#include <string>

namespace bounding_arcs_tool {

namespace {

struct Unit {
  const char* name;
  double size;
  double mm = 0;  // 0 for what has no size of its own
};

// User units in a unit, 96 of them to the inch; the font is taken to be 16 units high and half that for small letters.
constexpr Unit UNITS[] = {{"", 1},
                          {"px", 1, 25.4 / 96},
                          {"pt", 96.0 / 72, 25.4 / 72},
                          {"pc", 16, 25.4 / 6},
                          {"mm", 96 / 25.4, 1},
                          {"cm", 96 / 2.54, 10},
                          {"in", 96, 25.4},
                          {"q", 96 / 101.6, 0.25},
                          {"em", 16},
                          {"rem", 16},
                          {"ex", 8}};

// \return nothing for another word
const Unit* unit_of(std::string word) {
  std::transform(word.begin(), word.end(), word.begin(), [](unsigned char c) { return std::tolower(c); });
  const auto found = std::find_if(std::begin(UNITS), std::end(UNITS), [&](const Unit& u) { return word == u.name; });
  return found == std::end(UNITS) ? nullptr : found;
}

}  // namespace

double Svg_viewport::diagonal() const { return std::hypot(width, height) / std::sqrt(2.0); }

double scanned_svg_length(Svg_scanner& scanner, double whole) {
  const double value = scanner.number();
  const Svg_scanner at_unit = scanner;
  const std::string unit = scanner.word();
  if (unit == "%") return value / 100 * whole;
  if (const Unit* known = unit_of(unit)) return value * known->size;
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

double svg_length_in_mm(std::string_view text) {
  try {
    if (!(parsed_svg_length(text, 0) > 0)) return 0;
    Svg_scanner scanner(text);
    scanner.skip_space();
    const double value = scanner.number();
    const Unit* unit = unit_of(scanner.word());
    return unit == nullptr ? 0 : value * unit->mm;
  } catch (const Svg_error&) {
    return 0;
  }
}

}  // namespace bounding_arcs_tool
