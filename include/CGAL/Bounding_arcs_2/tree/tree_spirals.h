// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The segments of a tree with what regions and chains of arcs need of them: Taylor tables over a number type.

#ifndef CGAL_BOUNDING_ARCS_2_TREE_TREE_SPIRALS_H
#define CGAL_BOUNDING_ARCS_2_TREE_TREE_SPIRALS_H

#include <CGAL/Bounding_arcs_2/spiral/Bezier_spiral_2.h>
#include <CGAL/Bounding_arcs_2/tree/Bounding_arc_tree_2.h>

#include <cstddef>
#include <limits>
#include <type_traits>
#include <vector>

namespace CGAL::Bounding_arcs {

/// Returns the spiral segments of some curves of a hierarchy, cut where it has cut them.
/// \param drawing the same curves, over other numbers or in another unit
template <class NT>
[[nodiscard]] std::vector<Bezier_spiral_2<NT>> spiral_segments(
    const Segment_hierarchy& segments, const Drawing_2<NT>& drawing, std::size_t first = 0,
    std::size_t last = (std::numeric_limits<std::size_t>::max)()) {
  return spirals_between(drawing, first, last, [&](std::size_t curve, std::size_t bezier) {
    return segments.cuts(segments.number_of_bezier(curve, bezier));
  });
}

/// Returns the spiral segments of the curves first, ..., last - 1 of a tree, in order; of all where none are named.
/// \tparam NT the number type of regions: where it is exact, segments are those of the curves as they are
template <class NT = double>
[[nodiscard]] std::vector<Bezier_spiral_2<NT>> spiral_segments(
    const Bounding_arc_tree_2& tree, std::size_t first = 0,
    std::size_t last = (std::numeric_limits<std::size_t>::max)()) {
  const Segment_hierarchy& segments = tree.in_unit();
  if constexpr (!std::is_floating_point_v<NT>)
    if (segments.is_rounded()) return spiral_segments(converted<NT>(tree.exact_drawing()), first, last);
  // numbers that scaling has rounded are cut elsewhere
  if (segments.is_rounded() && &tree.drawing() != &segments.drawing())
    return spiral_segments(converted<NT>(tree.drawing()), first, last);
  if constexpr (std::is_same_v<NT, double>) return spiral_segments(segments, tree.drawing(), first, last);
  else return spiral_segments(segments, converted<NT>(tree.drawing()), first, last);
}

}  // namespace CGAL::Bounding_arcs

#endif
