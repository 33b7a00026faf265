// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "write_carving.h"

#include "../number_text.h"
#include "gcode_options.h"

#include <cstddef>
#include <vector>

namespace bounding_arcs_tool {
namespace {

std::vector<Tool_pass> all_passes(const V_carving& carving) {
  std::vector<Tool_pass> passes = carving.branches;
  passes.insert(passes.end(), carving.pockets.begin(), carving.pockets.end());
  return passes;
}

}  // namespace

void write_carving_csv(std::ostream& out, const V_carving& carving) {
  out << "path,kind,x,y,z,bulge\n";
  const std::vector<Tool_pass> passes = all_passes(carving);
  for (std::size_t i = 0; i < passes.size(); ++i) {
    const Tool_pass& pass = passes[i];
    const auto vertex = [&](const Xy<double>& p, std::size_t place, double bulge) {
      out << i << ',' << pass.title << ',' << number(p.x) << ',' << number(p.y) << ',' << number(pass.height_at(place))
          << ',' << number(bulge) << '\n';
    };
    for (std::size_t k = 0; k < pass.pieces.size(); ++k) vertex(pass.pieces[k].from, k, pass.pieces[k].bulge);
    vertex(pass.to(), pass.pieces.size(), 0);
  }
}

Written_drawing written_carving(const V_carving& carving, bool y_is_down, double unit_in_mm) {
  constexpr CGAL::Bounding_arcs::Curve_colour RED{1, -1}, BLUE{5, -1};
  Written_drawing drawing{y_is_down, unit_in_mm};
  const auto add = [&](const std::vector<Tool_pass>& passes, const CGAL::Bounding_arcs::Curve_colour& colour) {
    for (const Tool_pass& pass : passes)
      drawing.curves.push_back(
          {pass.title, {pass.title, colour}, {pass.pieces.begin(), pass.pieces.end()}, pass.height, pass.heights});
  };
  add(carving.branches, RED);
  add(carving.pockets, BLUE);
  return drawing;
}

void write_carving_gcode(std::ostream& out, const std::string& file, const V_carving& carving,
                         const Gcode_setup& setup) {
  write_gcode(out, file, all_passes(carving), setup);
}

}  // namespace bounding_arcs_tool
