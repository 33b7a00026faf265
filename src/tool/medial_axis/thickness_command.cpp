// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// bounding_arcs thickness: where shapes are thinner than a limit, and their necks.

#include "thickness_command.h"

#include "../Commands.h"
#include "../Output_file.h"
#include "../dxf/write_dxf.h"
#include "../number_text.h"
#include "../option_words.h"
#include "write_thickness.h"

#include <CLI/CLI.hpp>

#include <algorithm>
#include <cstdio>
#include <iostream>
#include <limits>
#include <vector>

namespace bounding_arcs_tool {
namespace {

Found_thickness thickness_of(const Found_axis& axis, const Query_drawing& loaded, const Thickness_words& words) {
  Found_thickness found{axis, loaded, words.below};
  const auto take = [&](const auto& disc) {
    if (!found.thickest || disc.radius > found.thickest->radius)
      found.thickest = ba::Medial_axis_2::Sample{disc.center, disc.radius, {}, {}};
  };
  for (const ba::Medial_axis_2::Vertex& v : axis.axis.vertices) take(v);
  for (const ba::Medial_axis_2::Edge& e : axis.axis.edges)
    for (const ba::Medial_axis_2::Sample& s : e.samples) take(s);
  const double corner = words.corner * DEGREE;
  const auto all = ba::thin_stretches(axis.axis, std::numeric_limits<double>::infinity(), corner);
  if (!all.empty()) found.thinnest = all.front().disc();
  if (found.has_limit() && words.below > 0) found.stretches = ba::thin_stretches(axis.axis, words.below, corner);
  found.necks = ba::necks(axis.axis);
  const auto is_thick = [&](const ba::Medial_axis_2::Neck& n) { return !(n.thickness() < words.below); };
  found.necks.erase(std::find_if(found.necks.begin(), found.necks.end(), is_thick), found.necks.end());
  return found;
}

// What a failed check found, in one line.
std::string message_of_thin(const Found_thickness& found) {
  const ba::Medial_axis_2::Thin_stretch& least = found.stretches.front();
  char text[240];
  std::snprintf(text, sizeof text, "%zu stretch%s thinner than %s, the least %s at (%s, %s)", found.stretches.size(),
                found.stretches.size() == 1 ? " is" : "es are", number(found.below).c_str(),
                short_number(least.thickness()).c_str(), short_number(least.disc().center.x).c_str(),
                short_number(least.disc().center.y).c_str());
  return text;
}

}  // namespace

CLI::App* add_thickness_command(CLI::App& app, Thickness_words& words) {
  CLI::App* command = app.add_subcommand("thickness", "Where shapes are thin, and how thick they are everywhere");
  Medial_axis_words& axis = words.axis;
  command->add_option("FILE", axis.file, "A curve file, JSON, SVG or DXF; - reads standard input")->required();
  command->add_option("--eps", axis.eps, "How far the axis may be from the lines between samples")
      ->required()
      ->check(CLI::Validator(check_tolerance, "", "eps"))
      ->type_name("NUMBER");
  command
      ->add_option("--below", words.below,
                   "List all stretches that are thinner, in units of the coordinates; exit status 1 if there are any")
      ->check(number_in(0, 1e300))
      ->type_name("NUMBER");
  command->add_option("--corner", words.corner, "Sharper corners are thin places, in degrees")
      ->check(number_in(1, 180))
      ->type_name("ANGLE")
      ->capture_default_str();
  add_frame_option(*command, axis);
  add_rule(*command, axis.reading.rule);
  add_reading_options(*command, axis.reading);
  add_output(*command, {"json", "csv", "svg", "dxf"}, axis.format, axis.output);
  command->footer(
      "The local thickness at a point is the diameter of the largest disc inside that covers it. A stretch is a way\n"
      "along the medial axis on which discs are thinner than --below. It ends where the shape is as thick as that, or\n"
      "the axis branches or ends, and it has its least thickness, its length and the curves beside it. What runs into\n"
      "a corner of --corner degrees or more is no thin place; a wedge or tip that is sharper is one. What is not\n"
      "listed is thicker than --below less twice eps.\n"
      "A neck is the smallest disc between two places that are thicker by more than twice eps; by how much is its\n"
      "prominence. Without --below all necks are listed, and the least thickness outside of corners. With --frame it\n"
      "is the room between the curves that is measured: its necks are gaps.\n"
      "Exit status 1 with --below where something is thinner, and where a part of the axis is left out.\n"
      "Examples:\n"
      "  bounding_arcs thickness part.svg --eps 0.001 --below 1.5\n"
      "  bounding_arcs thickness part.dxf --eps 0.001 --below 1.5 --format svg -o thin.svg\n"
      "  bounding_arcs thickness drawing.svg --eps 0.01 --frame --format csv -o gaps.csv\n");
  return command;
}

int run_thickness(const Thickness_words& words) {
  const Query_drawing loaded = load_axis_drawing(words.axis);
  const Found_axis axis = shown_axis_of(loaded, words.axis);
  const Found_thickness found = thickness_of(axis, loaded, words);
  if (words.axis.format == "dxf") tell_units_of_dxf(loaded.unit());
  Output_file output(words.axis.output);
  if (words.axis.format == "svg") draw_thickness(output.stream(), found);
  else if (words.axis.format == "json") write_thickness_json(output.stream(), found);
  else if (words.axis.format == "dxf") write_dxf(output.stream(), written_thickness(found));
  else write_thickness_csv(output.stream(), found);
  output.commit();
  const int status = tell_of_axis(loaded, axis, "thickness");
  if (found.stretches.empty()) return status;
  std::cerr << "bounding_arcs: " << loaded.file << ": thickness: " << message_of_thin(found) << "\n";
  return 1;
}

}  // namespace bounding_arcs_tool
