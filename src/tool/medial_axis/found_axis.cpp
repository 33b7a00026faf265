// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Bodies of found_axis.h, and the frame.

#include "found_axis.h"

#include "../Commands.h"
#include "../Elapsed_line.h"
#include "../number_text.h"
#include "../reading.h"

#include <CGAL/Bounding_arcs_2/medial_axis/medial_axis.h>
#include <CGAL/Bounding_arcs_2/medial_axis/pruned.h>
#include <CGAL/Bounding_arcs_2/query/intersections.h>

#include <algorithm>
#include <cstddef>
#include <cstdlib>
#include <iostream>
#include <memory>
#include <stdexcept>
#include <string>

namespace bounding_arcs_tool {

// Puts a frame behind the curves.
static void add_frame(Query_drawing& loaded, const Medial_axis_words& words) {
  constexpr double SHARE = 0.1;  // of the size
  const ba::Drawing_2<double>& drawing = loaded.curves->drawing();
  double margin = words.margin;
  if (margin == 0) {
    const CGAL::Bbox_2 box = drawing.control_box();
    margin = SHARE * (std::max)(box.xmax() - box.xmin(), box.ymax() - box.ymin());
    if (margin == 0) margin = 1;  // about a point
  }
  try {
    loaded.curves = std::make_unique<Bounding_arc_tree_2>(ba::framed(drawing, margin), ba::Decisions::EXACT);
  } catch (const std::invalid_argument& error) {
    throw Input_error(loaded.file, "medial-axis", error.what());
  }
}

// Whether curves touch beside a joint is often left open by doubles.
Query_drawing with_frame(Query_drawing loaded, const Medial_axis_words& words) {
  if (words.is_framed) add_frame(loaded, words);
  else loaded.curves = std::make_unique<Bounding_arc_tree_2>(loaded.curves->drawing(), ba::Decisions::EXACT);
  return loaded;
}

Query_drawing load_axis_drawing(const Medial_axis_words& words) {
  return with_frame(words.is_framed ? load_drawing(words.file, "double", words.reading)
                                    : load_closed_drawing(words.file, "double", words.reading),
                    words);
}

std::string message_of_unresolved(const ba::Medial_axis_2& axis) {
  const std::string what = "discs that touch several places cannot be told apart";
  if (axis.unresolved.empty()) return what;
  const std::size_t count = axis.unresolved.size();
  return what + " at " + std::to_string(count) + (count == 1 ? " place" : " places") + ", the first beside " +
         place_text(axis.unresolved.front());
}

int tell_of_axis(const Query_drawing& loaded, const Found_axis& found, const char* command) {
  const std::string place = "bounding_arcs: " + loaded.file + ": " + command + ": ";
  tell_left_out(loaded.file, command, found.axis.left_out.size(), loaded.rule);
  if (found.axis.status != ba::Medial_axis_2::Status::UNRESOLVED) return 0;
  std::cerr << place << message_of_unresolved(found.axis) << "; the rest is written\n";
  return 1;
}

void expect_no_crossing(const Query_drawing& loaded, const char* command) {
  const auto common = ba::self_intersections(*loaded.curves);
  if (common.points.empty() && common.overlaps.empty()) return;
  throw Input_error(
      loaded.file, command,
      "expected curves that do not cross, or a frame, found a crossing; boolean union makes curves without "
      "one that have the same axis");
}

Found_axis axis_of(const Query_drawing& loaded, const Medial_axis_words& words) {
  const double eps = std::strtod(words.eps.c_str(), nullptr);
  ba::Medial_axis_2::Options options;
  options.is_framed = words.is_framed;
  options.rule = loaded.rule;
  Found_axis found;
  ba::Medial_axis_2& axis = found.axis;
  try {
    axis = ba::medial_axis(*loaded.curves, eps, options);
  } catch (const std::invalid_argument& error) {
    throw Input_error(loaded.file, "medial-axis", error.what());
  }
  const bool is_whole_wanted = words.with_cells || words.is_proving || words.prune > 0 || words.prune_angle > 0;
  // where no place is known anything may be wrong
  const bool is_part_told = !axis.edges.empty() && !axis.unresolved.empty();
  if (axis.status == ba::Medial_axis_2::Status::UNRESOLVED && (!is_part_told || is_whole_wanted))
    throw Input_error(loaded.file, "medial-axis", message_of_unresolved(axis));
  if (axis.eps > eps) throw Input_error(loaded.file, "medial-axis", below_resolution(eps, axis.eps));
  const Bounding_arc_tree_2& curves = *loaded.curves;
  if (words.with_cells && !words.is_framed) expect_no_crossing(loaded, "medial-axis");
  if (words.is_proving) found.proof = ba::axis_certificate(curves, axis);
  if (words.prune_angle > 0)
    axis = ba::trimmed(curves, std::move(axis), ba::Medial_axis_2::Feet_apart{words.prune_angle * DEGREE, 0});
  if (words.prune > 0) axis = ba::pruned(std::move(axis), words.prune);
  if (words.with_conics) found.conics = ba::axis_conics(curves, axis, axis.eps);
  return found;
}

Found_axis shown_axis_of(const Query_drawing& loaded, const Medial_axis_words& words) {
  const Elapsed_line elapsed("finding the axis");
  return axis_of(loaded, words);
}

}  // namespace bounding_arcs_tool
