// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The segments of a tree with what regions and chains of arcs need of them: Taylor tables over a number type.

#ifndef CGAL_BOUNDING_ARCS_2_TREE_TREE_SPIRALS_H
#define CGAL_BOUNDING_ARCS_2_TREE_TREE_SPIRALS_H

#include <CGAL/Bounding_arcs_2/curve/Drawing_2.h>
#include <CGAL/Bounding_arcs_2/spiral/Bezier_spiral_2.h>
#include <CGAL/Bounding_arcs_2/spiral/spiral_parameters.h>
#include <CGAL/Bounding_arcs_2/tree/Bounding_arc_tree_2.h>

#include <cstddef>
#include <limits>
#include <type_traits>
#include <vector>

namespace CGAL::Bounding_arcs {

namespace internal {

/// Whether a tree's segments are those of curves that doubles do not hold, and of them in its own lengths.
[[nodiscard]] bool are_cuts_rounded(const Bounding_arc_tree_2& tree);
[[nodiscard]] bool are_cuts_in_own_lengths(const Bounding_arc_tree_2& tree);
/// Where a Bezier piece of a tree is cut into spiral segments.
[[nodiscard]] Spiral_parameters cuts_of(const Bounding_arc_tree_2& tree, std::size_t curve, std::size_t bezier);

}  // namespace internal

/// Returns the spiral segments of the curves first, ..., last - 1 of a tree, in order; of all where none are named.
/// \tparam NT the number type of regions: where it is exact, segments are those of the curves as they are
template <class NT = double>
[[nodiscard]] std::vector<Bezier_spiral_2<NT>> spiral_segments(
    const Bounding_arc_tree_2& tree, std::size_t first = 0,
    std::size_t last = (std::numeric_limits<std::size_t>::max)()) {
  const auto cuts = [&](std::size_t curve, std::size_t bezier) { return internal::cuts_of(tree, curve, bezier); };
  const bool are_rounded = internal::are_cuts_rounded(tree);
  if constexpr (!std::is_floating_point_v<NT>)
    if (are_rounded) return spiral_segments(tree.exact_drawing().over<NT>(), first, last);
  // numbers that scaling has rounded are cut elsewhere
  if (are_rounded && !internal::are_cuts_in_own_lengths(tree))
    return spiral_segments(tree.drawing().over<NT>(), first, last);
  if constexpr (std::is_same_v<NT, double>) return internal::spirals_between(tree.drawing(), first, last, cuts);
  else return internal::spirals_between(tree.drawing().over<NT>(), first, last, cuts);
}

}  // namespace CGAL::Bounding_arcs

#endif
