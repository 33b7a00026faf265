// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Bodies of offset/offset_bracket.h.

#include <CGAL/Bounding_arcs_2/arc/arc_beziers.h>
#include <CGAL/Bounding_arcs_2/offset/offset_bracket.h>
#include <CGAL/Bounding_arcs_2/query/distance.h>
#include <CGAL/Bounding_arcs_2/query/hausdorff_distance.h>

#include <cmath>
#include <optional>
#include <utility>
#include <vector>

namespace CGAL::Bounding_arcs {

Bezier_curve_2<double> quadratic_of(const Arc_2& arc) {
  if (arc.bulge == 0) return Bezier_curve_2<double>({arc.from, arc.to});
  const double b = arc.bulge;
  const Xy<double> chord = arc.to - arc.from;
  const Xy<double> middle = arc.from + (0.5 * chord - (b / ((1 - b) * (1 + b))) * perp(chord));
  return Bezier_curve_2<double>({arc.from, middle, arc.to}, {1, (1 - b) * (1 + b) / (1 + b * b), 1});
}

// Larger ones than a quarter of a circle are two: weights of half a circle are zero.
static void add(const Arc_2& arc, std::vector<Bezier_curve_2<double>>& beziers) {
  constexpr double QUARTER = 0.4142135623730951;  // tan(pi / 8) rounded up
  if (std::fabs(arc.bulge) <= QUARTER) return beziers.push_back(quadratic_of(arc));
  for (Bezier_curve_2<double>& half : arc_beziers(arc.from, arc.to, arc.bulge)) beziers.push_back(std::move(half));
}

Drawing_2<double> drawing_of(const Offset& offset) {
  Drawing_2<double> drawing;
  for (const Offset_chain& chain : offset.chains) {
    std::vector<Bezier_curve_2<double>> beziers;
    const auto finish = [&] {
      if (!beziers.empty()) drawing.add(std::exchange(beziers, {}));
    };
    for (const Offset_piece& piece : chain.pieces)
      if (piece.is_round) add(piece.arc, beziers);
      else finish();
    finish();
  }
  return drawing;
}

std::optional<Offset_error> offset_error(const Bounding_arc_tree_2& curves, const Offset& offset, double eps) {
  const Bounding_arc_tree_2 chains(drawing_of(offset), Decisions::DOUBLE);
  const double d = std::fabs(offset.distance);
  const auto most = directed_hausdorff_distance(chains, curves, eps);
  if (!most) return std::nullopt;
  const auto least = distance(chains, curves, eps);
  return Offset_error{{least->distance.lower - d, least->distance.upper - d},
                      {most->distance.lower - d, most->distance.upper - d}};
}

}  // namespace CGAL::Bounding_arcs
