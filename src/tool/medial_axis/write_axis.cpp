// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "write_axis.h"

#include "../number_text.h"
#include "../written/write_plain_svg.h"

#include <cstddef>
#include <vector>

namespace bounding_arcs_tool {
namespace {

void add_lines(std::vector<Written_piece>& pieces, const ba::Medial_axis_2::Edge& edge, std::size_t first,
               std::size_t last) {
  for (std::size_t i = first; i < last; ++i)
    pieces.emplace_back(Arc_2{edge.samples[i].center, edge.samples[i + 1].center, 0});
}

// Conics begin and end at samples.
void add_conic(std::vector<Written_piece>& pieces, const ba::Medial_axis_2::Conic& conic,
               const ba::Medial_axis_2::Edge& edge, bool is_for_svg) {
  const auto& p = conic.points;
  const bool is_line = cross(p[1] - p[0], p[2] - p[0]) == 0;
  const Written_piece piece = is_line ? Written_piece(Arc_2{p[0], p[2], 0})
                                      : written_piece(ba::Bezier_curve_2<double>(
                                            std::vector<Xy<double>>(p.begin(), p.end()), {1, conic.weight, 1}));
  if (is_for_svg && !is_of_svg(piece)) add_lines(pieces, edge, conic.first, conic.last);
  else pieces.push_back(piece);
}

}  // namespace

void write_axis_csv(std::ostream& out, const Found_axis& found, const Query_drawing& loaded) {
  out << "edge,x,y,radius,left,right\n";
  for (std::size_t i = 0; i < found.axis.edges.size(); ++i)
    for (const ba::Medial_axis_2::Sample& s : found.axis.edges[i].samples) {
      const Curve_place left = s.left, right = s.right;
      out << i << ',' << number(s.center.x) << ',' << number(s.center.y) << ',' << number(s.radius) << ','
          << loaded.number_of(left.curve) << ',' << loaded.number_of(right.curve) << '\n';
    }
}

Written_drawing written_axis(const Found_axis& found, const Query_drawing& loaded, bool is_for_svg) {
  Written_drawing drawing{!loaded.flips, loaded.unit_in_mm, loaded.page};
  for (std::size_t i = 0; i < found.axis.edges.size(); ++i) {
    const ba::Medial_axis_2::Edge& edge = found.axis.edges[i];
    Written_curve curve{"edge_" + std::to_string(i), {"medial_axis", {}}, {}};
    if (found.conics.empty()) add_lines(curve.pieces, edge, 0, edge.samples.size() - 1);
    else
      for (const ba::Medial_axis_2::Conic& conic : found.conics[i]) add_conic(curve.pieces, conic, edge, is_for_svg);
    drawing.curves.push_back(std::move(curve));
  }
  return drawing;
}

}  // namespace bounding_arcs_tool
