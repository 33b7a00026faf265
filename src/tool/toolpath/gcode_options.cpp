// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "gcode_options.h"

#include "../../input/Input_text.h"
#include "../option_words.h"
#include "../usage.h"
#include "write_gcode.h"

#include <CLI/CLI.hpp>

#include <stdexcept>

namespace bounding_arcs_tool {
namespace {

constexpr double INCH_IN_MM = 25.4;

}  // namespace

void add_gcode_options(CLI::App& command, Gcode_words& words, bool with_depth) {
  command
      .add_option(
          "--feed", words.feed,
          "For gcode, which needs it: how far the tool goes in a minute. This and what follows is in mm, or in\n"
          "inches where the drawing is")
      ->check(number_in(1e-3, 1e9));
  if (with_depth)
    command
        .add_option("--depth", words.depth,
                    "For gcode: how far below 0 the tool cuts, all in one pass; 0 where it is not given")
        ->check(number_in(0, 1e6));
  command
      .add_option("--safe-height", words.safe_height,
                  "For gcode: how high above 0 the tool goes through the air; without it 5 mm, or 0.2 inches")
      ->check(number_in(1e-6, 1e6));
  command
      .add_option(
          "--digits", words.digits,
          "For gcode: digits of coordinates behind the point; without it 4 in mm, and 5 in inches. The path is\n"
          "within eps and 3 units of the last digit")
      ->check(whole_number_in(1, 9));
  command
      .add_option("--shortest-arc", words.shortest_arc,
                  "For gcode: an arc that is shorter becomes lines; without it 0.01 mm, or as much in inches")
      ->check(number_in(1e-9, 1e6));
  command.add_option("--header", words.header,
                     "For gcode: a file to put in front as it is, to start the spindle and the like");
}

void check_gcode_words(const Gcode_words& words) {
  if (words.feed == 0) throw Usage_error("--feed", "a number above 0 with --format gcode", "none");
}

Gcode_setup gcode_setup(const Gcode_words& words, const File_unit& unit, bool flips) {
  constexpr double SAFE_MM = 5, SAFE_INCHES = 0.2, SHORTEST_MM = 0.01;
  constexpr int DIGITS_MM = 4, DIGITS_INCHES = 5;
  Gcode_setup setup;
  if (!words.header.empty()) setup.header = file_contents(words.header);
  if (!(unit.in_mm > 0)) tell(unit.file, "no unit is told: coordinates are taken as mm");
  setup.is_in_inches = is_same_unit(unit.in_mm, INCH_IN_MM);
  if (!setup.is_in_inches && unit.in_mm > 0 && !is_same_unit(unit.in_mm, 1)) {
    setup.scale = unit.in_mm;
    tell(unit.file, "1 unit is " + unit_text(unit.in_mm) + ": coordinates are written in mm");
  }
  setup.flips = flips;
  setup.digits = words.digits > 0 ? static_cast<int>(words.digits) : (setup.is_in_inches ? DIGITS_INCHES : DIGITS_MM);
  setup.feed = words.feed / setup.scale;
  setup.depth = words.depth / setup.scale;
  const double mm = setup.is_in_inches ? 1 / INCH_IN_MM : 1;
  const auto given_or = [&](double word, double otherwise) { return (word > 0 ? word : otherwise) / setup.scale; };
  setup.safe_height = given_or(words.safe_height, setup.is_in_inches ? SAFE_INCHES : SAFE_MM);
  setup.shortest_arc = given_or(words.shortest_arc, SHORTEST_MM * mm);
  return setup;
}

void write_gcode(std::ostream& out, const std::string& file, const std::vector<Tool_pass>& passes,
                 const Gcode_setup& setup) {
  try {
    write_gcode(out, passes, setup);
  } catch (const std::invalid_argument& error) {
    throw Input_error(file, "gcode", error.what());
  }
}

}  // namespace bounding_arcs_tool
