// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// A drawing with a hole, and a series of its offsets, outwards and inwards, as a picture in SVG.

#include <CGAL/Bounding_arcs_2.h>

#include <cmath>
#include <cstdio>

using namespace CGAL::Bounding_arcs;

namespace {

void write(const Offset& offset) {
  std::printf("<path stroke=\"%s\" d=\"", offset.distance < 0 ? "#d55e00" : offset.distance > 0 ? "#0072b2" : "#888");
  for (const Offset::Chain& chain : offset.chains) {
    const Xy<double>& start = chain.pieces.front().arc.from;
    std::printf("M%.2f %.2f", start.x, start.y);
    for (const Offset::Piece& piece : chain.pieces) {
      const Arc_2& arc = piece.arc;
      if (arc.bulge == 0) {
        std::printf("L%.2f %.2f", arc.to.x, arc.to.y);
        continue;
      }
      const double radius = std::fabs(1 / curvature(arc));
      std::printf("A%.2f %.2f 0 0 %d %.2f %.2f", radius, radius, arc.bulge > 0 ? 1 : 0, arc.to.x, arc.to.y);
    }
    std::printf("Z");
  }
  std::printf("\"/>\n");
}

}  // namespace

int main() {
  Drawing_2<double> drawing;
  drawing.add({Bezier_curve_2<double>({{0, 0}, {40, 0}}), Bezier_curve_2<double>({{40, 0}, {40, 30}}),
               Bezier_curve_2<double>({{40, 30}, {20, 10}, {0, 30}}), Bezier_curve_2<double>({{0, 30}, {0, 0}})});
  drawing.add(
      {Bezier_curve_2<double>({{14, 6}, {14, 12}, {22, 12}, {22, 6}}), Bezier_curve_2<double>({{22, 6}, {14, 6}})});
  Offset::Options options;
  options.rule = Fill_rule::EVEN_ODD;
  const Offset_source_2 source(Bounding_arc_tree_2(drawing), 0.05, options);  // once, for any number of distances
  std::printf(
      "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"-4 -4 48 38\" fill=\"none\" stroke-width=\"0.3\">\n");
  for (const Offset& offset : source.at({3, 0, -1.5, -3})) write(offset);
  std::printf("</svg>\n");
}
