// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Parts as curves and outlines as drawings, of boolean/boolean_operations.h and boolean/clip.h.
//
//   parts -> curves in doubles, and how far these are from the parts -> without slivers -> drawing

#include "Chain_drawer.h"
#include "rounded_curves.h"

#include <CGAL/Bounding_arcs_2/boolean/boolean_operations.h>
#include <CGAL/Bounding_arcs_2/boolean/clip.h>

#include <algorithm>
#include <cstddef>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace CGAL::Bounding_arcs::internal {

namespace {

void add_chain(std::vector<Bezier_curve_2<double>> chain, Drawing_2<double>& drawing) {
  const std::string number = std::to_string(drawing.curves().size() + 1);
  drawing.add(std::move(chain), "outline " + number);
}

}  // namespace

}  // namespace CGAL::Bounding_arcs::internal

namespace CGAL::Bounding_arcs {

Bezier_curve_2<double> curve_of(const Drawing_2<double>& drawing, const Clipped_2::Part& part) {
  return internal::curve_of_part(drawing.curves()[part.curve].beziers[part.bezier],
                                 {0, part.curve, part.bezier, part.from, part.to, false, part.start, part.end});
}

Drawing_2<double> outline_drawing(const std::vector<const Bounding_arc_tree_2*>& trees, const Outline_2& outline) {
  Drawing_2<double> result;
  for (const Outline_2::Chain& given : outline.chains) {
    std::vector<Bezier_curve_2<double>> chain;
    for (const Outline_2::Part& p : given.parts)
      chain.push_back(internal::curve_of_part(trees.at(p.operand)->drawing().curves()[p.curve].beziers[p.bezier], p));
    internal::add_chain(std::move(chain), result);
  }
  return result;
}

Drawn_outline drawn_outline(const std::vector<const Bounding_arc_tree_2*>& trees, const Outline_2& outline,
                            const Drawn_outline::Options& options) {
  Drawn_outline result;
  result.outline.status = outline.status;
  result.outline.undecided = outline.undecided;
  internal::Chain_drawer drawer(trees);
  std::vector<std::optional<std::size_t>> numbers;  // of the chains given among those drawn
  std::vector<std::optional<std::size_t>> parents;  // of the chains drawn among those given
  for (const Outline_2::Chain& given : outline.chains) {
    drawer.start(given.parts);
    if (options.drops_slivers) drawer.drop_slivers();
    result.moved = (std::max)(result.moved, drawer.moved());
    numbers.push_back(std::nullopt);
    if (drawer.parts().empty()) continue;
    Outline_2::Chain chain{{}, given.is_ccw, std::nullopt};
    std::vector<Bezier_curve_2<double>> curves;
    for (const internal::Drawn_part& drawn : drawer.parts()) {
      curves.push_back(drawn.curve);
      chain.parts.push_back(drawn.part);
    }
    numbers.back() = result.outline.chains.size();
    parents.push_back(given.parent);
    result.outline.chains.push_back(std::move(chain));
    internal::add_chain(std::move(curves), result.drawing);
  }
  for (std::size_t i = 0; i < parents.size(); ++i) {
    std::optional<std::size_t> parent = parents[i];
    while (parent && !numbers[*parent]) parent = outline.chains[*parent].parent;
    if (parent) result.outline.chains[i].parent = numbers[*parent];
  }
  return result;
}

}  // namespace CGAL::Bounding_arcs
