// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "written_path.h"

#include "../Commands.h"
#include "../option_words.h"
#include "../usage.h"
#include "../written/write_plain_svg.h"

#include <CGAL/Bounding_arcs_2/chain/arc_chain.h>

#include <CLI/CLI.hpp>

#include <cstdlib>

namespace bounding_arcs_tool {

namespace ba = CGAL::Bounding_arcs;

namespace {

Written_curve of_arcs(const std::string& file, const std::string& name, const Curve_look& look,
                      const std::vector<ba::Bezier_curve_2<double>>& pieces, double eps) {
  ba::Drawing_2<double> one;
  one.add(pieces, name);
  const ba::Arc_chain chain = ba::arc_chain(ba::Bounding_arc_tree_2(std::move(one)), eps);
  if (chain.status != ba::Build_status::COMPLETE)
    throw Input_error(file, "curve \"" + name + "\"", below_resolution(eps, chain.error));
  Written_curve curve{name, look, {}};
  for (const auto& arc : chain.arcs) add_piece(curve.pieces, arc);
  return curve;
}

}  // namespace

void add_path_options(CLI::App& command, Path_words& words) {
  add_plain(command, words.is_plain);
  command
      .add_option(
          "--eps", words.eps,
          "For DXF and plain SVG: arcs that far from the curves at most, in units of the coordinates, in place\n"
          "of the curves themselves")
      ->check(CLI::Validator(check_tolerance, "", "eps"))
      ->type_name("NUMBER");
}

void check_path_words(const Path_words& words, const std::string& format) {
  check_plain(words.is_plain, format);
  if (!words.eps.empty() && format != "dxf" && !words.is_plain)
    throw Usage_error("--format", "dxf, or svg with --plain, with --eps, which no other form has", format);
}

Written_curve written_path(const std::string& file, const std::string& name, const Curve_look& look,
                           const std::vector<ba::Bezier_curve_2<double>>& pieces, const Path_words& words) {
  if (!words.eps.empty()) return of_arcs(file, name, look, pieces, std::strtod(words.eps.c_str(), nullptr));
  Written_curve curve = written_curve(name, look, pieces);
  if (!words.is_plain) return curve;
  for (std::size_t i = 0; i < pieces.size(); ++i)
    if (!is_of_svg(written_piece(pieces[i])))
      throw Input_error(file, "curve \"" + name + "\"",
                        "expected curves that SVG can draw, or --eps for arcs, found " +
                            std::string(pieces[i].is_rational() ? "weights" : "no weights") + " and degree " +
                            std::to_string(pieces[i].degree()) + " in piece " + std::to_string(i));
  return curve;
}

}  // namespace bounding_arcs_tool
