// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// bounding_arcs verify-axis: checks a written axis from its numbers and the curves alone.

#include "verify_axis_command.h"

#include "../Commands.h"
#include "../Elapsed_line.h"
#include "../Output_file.h"
#include "../option_words.h"
#include "found_axis.h"
#include "read_axis.h"

#include <CGAL/Bounding_arcs_2/verify/verify_axis.h>

#include <CLI/CLI.hpp>

#include <algorithm>
#include <cstdint>
#include <cstdio>
#include <optional>

namespace bounding_arcs_tool {
namespace {

namespace ba = CGAL::Bounding_arcs;

void write_checked_json(std::ostream& out, const ba::Axis_verification& v) {
  out << "{\"right\":" << (v.is_right() ? "true" : "false") << ",\"vertices\":" << v.vertices
      << ",\"edges\":" << v.edges << ",\"samples\":" << v.samples << ",\"tiles\":" << v.tiles
      << ",\"discs\":" << v.discs << ",\"miss\":" << number(v.miss) << ",\"aside\":" << number(v.aside)
      << ",\"gap\":" << number(v.gap) << ",\"deviation\":" << number(v.deviation) << ",\"faults\":" << v.faults
      << ",\"findings\":[";
  const char* separator = "\n";
  for (const ba::Axis_verification::Finding& f : v.findings) {
    out << separator << "{\"fault\":\"" << ba::Axis_verification::name_of(f.fault)
        << "\",\"place\":" << json_string(f.place) << ",\"amount\":" << number(f.amount) << "}";
    separator = ",\n";
  }
  out << "]}\n";
}

void write_checked_table(std::ostream& out, const ba::Axis_verification& v) {
  char line[300];
  std::snprintf(
      line, sizeof line,
      "vertices %zu, edges %zu, samples %zu: %zu parts of the boundary, %zu discs\n"
      "radii and distances of feet differ by at most %.3g, centers are beside normals by %.3g, gaps are %.3g\n"
      "the axis is seen to be within %.3g of its lines\n",
      v.vertices, v.edges, v.samples, v.tiles, v.discs, v.miss, v.aside, v.gap, v.deviation);
  out << line;
  if (v.is_right()) out << "right\n";
  else out << v.faults << " faults\n";
  for (const ba::Axis_verification::Finding& f : v.findings) {
    out << "  " << ba::Axis_verification::name_of(f.fault) << " " << f.place;
    if (f.amount != 0) out << ", " << digits(f.amount);
    out << "\n";
  }
}

// Turns numbers of curves in the file into those in the drawing, from which open ones are left out.
void number_as_in(const Query_drawing& drawing, ba::Medial_axis_2& axis) {
  if (drawing.numbers.empty()) return;
  const auto number = [&](Curve_place& p) {
    const auto found = std::lower_bound(drawing.numbers.begin(), drawing.numbers.end(), p.curve);
    const bool is_there = found != drawing.numbers.end() && *found == p.curve;  // else a place on no curve
    p.curve = static_cast<std::uint32_t>((is_there ? found : drawing.numbers.end()) - drawing.numbers.begin());
  };
  for (ba::Medial_axis_2::Vertex& v : axis.vertices)
    for (Curve_place& p : v.touches) number(p);
  for (ba::Medial_axis_2::Edge& e : axis.edges)
    for (ba::Medial_axis_2::Sample& s : e.samples) number(s.left), number(s.right);
}

}  // namespace

CLI::App* add_verify_axis_command(CLI::App& app, Verify_axis_words& words) {
  words.axis.format = "table";
  CLI::App* command =
      app.add_subcommand("verify-axis", "Check a medial axis as it is written, from its numbers and the curves alone");
  command->add_option("FILE", words.axis.file, "A curve file, JSON, SVG or DXF")->required();
  command->add_option("AXIS", words.written, "What medial-axis --feet wrote of it; - reads standard input")->required();
  add_frame_option(*command, words.axis);
  add_rule(*command, words.axis.reading.rule);
  add_reading_options(*command, words.axis.reading);
  add_output(*command, {"table", "json"}, words.axis.format, words.axis.output);
  command->footer(
      "Exit status 1 when something is wrong. Feet have to tile each side of a curve once where a region is. What is\n"
      "between two samples and their feet must not be turned inside out. Discs must touch their feet and hold no "
      "curve.\n"
      "Between two samples the axis is measured to be within the \"bound\" of its edge, or within eps. The frame "
      "has\n"
      "to be the one that the axis was made with; its rule is written in it. Without a frame curves must not cross:\n"
      "boolean union makes such curves, and their axis is the same.\n"
      "Examples:\n"
      "  bounding_arcs medial-axis curve.json --eps 1e-4 --feet --prove -o axis.json\n"
      "  bounding_arcs verify-axis curve.json axis.json\n"
      "  bounding_arcs verify-axis drawing.svg axis.json --frame --format json\n"
      "  bounding_arcs boolean union crossing.svg -o curves.json\n"
      "  bounding_arcs medial-axis curves.json --eps 1e-4 --feet | bounding_arcs verify-axis curves.json -\n");
  return command;
}

int run_verify_axis(const Verify_axis_words& words) {
  const Query_drawing drawing = load_axis_drawing(words.axis);
  Written_axis written = read_axis(words.written);
  if (written.is_framed != words.axis.is_framed)
    throw Input_error(words.written, "frame",
                      written.is_framed ? "expected an axis without one, found one in a frame, which --frame is for"
                                        : "expected an axis in a frame, found one without");
  if (!written.is_framed) expect_no_crossing(drawing, "verify-axis");  // sides of whole curves are checked
  ba::Axis_verification::Options options;
  options.rule = fill_rule(words.axis.reading.rule, written.rule.value_or(drawing.rule));
  options.is_framed = written.is_framed;
  options.bounds = written.bounds;
  number_as_in(drawing, written.axis);
  std::optional<Elapsed_line> elapsed("checking the axis");
  const ba::Axis_verification result = ba::verify_axis(drawing.curves->drawing(), written.axis, options);
  elapsed.reset();
  Output_file output(words.axis.output);
  if (words.axis.format == "json") write_checked_json(output.stream(), result);
  else write_checked_table(output.stream(), result);
  output.commit();
  return result.is_right() ? 0 : 1;
}

}  // namespace bounding_arcs_tool
