// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The segments of several trees as one forest, whose pieces know where they come from.

#ifndef BOUNDING_ARCS_LIBRARY_OVERLAY_UNITED_CURVES_H
#define BOUNDING_ARCS_LIBRARY_OVERLAY_UNITED_CURVES_H

#include "Overlay.h"

#include <CGAL/Bounding_arcs_2/overlay/overlay.h>
#include <CGAL/Bounding_arcs_2/tree/Bounding_arc_tree_2.h>
#include "../tree/Segment_hierarchy.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <vector>

namespace CGAL::Bounding_arcs::internal {

/// The place that a Bezier piece of all operands together has in its own.
using Operand_bezier = Overlay_2::Undecided::Of;

/// The segments of all operands together, as their trees have cut them, without pieces of curves that are single
/// points.
struct United_curves {
  std::shared_ptr<const Segment_hierarchy> segments;
  std::shared_ptr<Segment_hierarchy> forest;  ///< the same, where they are not those of one tree
  Unit unit;                                  ///< of the segments
  std::vector<Operand_bezier> beziers;        ///< numbered through
  std::vector<std::uint32_t> operands;        ///< by curve
};
/// What becomes of curves that are single points.
enum class Lone_points { DROPPED, KEPT };

/// Unites the segments of trees, each where it is; trees with points leave these out in a list of their own.
[[nodiscard]] inline United_curves united_curves(const std::vector<const Bounding_arc_tree_2*>& trees,
                                                 Lone_points points) {
  United_curves united;
  for (const Bounding_arc_tree_2* tree : trees) united.unit = (std::max)(united.unit, tree->unit());
  std::vector<std::shared_ptr<const Segment_hierarchy>> all;
  all.reserve(trees.size());
  std::vector<std::uint32_t> kept;
  for (std::uint32_t i = 0; i < trees.size(); ++i) {
    all.push_back(trees[i]->in_unit(united.unit));
    const Segment_hierarchy& segments = *all.back();
    const auto& curves = segments.drawing().curves();
    kept.clear();
    for (std::uint32_t c = 0; c < curves.size(); ++c) {
      const std::size_t before = united.beziers.size();
      for (std::uint32_t b = 0; b < curves[c].beziers.size(); ++b) {
        const std::uint32_t number = segments.number_of_bezier(c, b);
        const bool is_last = b + 1 == curves[c].beziers.size() && united.beziers.size() == before;
        if (segments.is_point(number) && !(is_last && points == Lone_points::KEPT)) continue;
        united.beziers.push_back({i, c, b});
        kept.push_back(number);
      }
      if (united.beziers.size() > before) united.operands.push_back(i);
    }
    if (kept.size() < segments.number_of_beziers())
      all.back() = std::make_shared<const Segment_hierarchy>(segments.of_pieces(kept));
  }
  if (all.size() == 1) united.segments = std::move(all.front());
  else united.segments = united.forest = std::make_shared<Segment_hierarchy>(all);
  return united;
}

/// Returns what an overlay of united curves left open, by operands.
[[nodiscard]] inline Overlay_2::Undecided undecided_meeting(const Open_place& open, const United_curves& united) {
  return {united.unit.out(open.point), united.beziers[open.bezier_a], united.beziers[open.bezier_b]};
}

}  // namespace CGAL::Bounding_arcs::internal

#endif
