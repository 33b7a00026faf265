// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The leaves beside a leaf, along its curve and over the ends of segments and Bezier pieces.

#ifndef CGAL_BOUNDING_ARCS_2_TREE_INTERNAL_NEIGHBOURS_H
#define CGAL_BOUNDING_ARCS_2_TREE_INTERNAL_NEIGHBOURS_H

#include <CGAL/Bounding_arcs_2/spiral/Segment_place.h>
#include <CGAL/Bounding_arcs_2/tree/Region_node.h>

#include <cstddef>
#include <cstdint>
#include <optional>

namespace CGAL::Bounding_arcs::internal {

/// The last leaf of a segment of which all nodes above begin where is_taken(t0) says so, but for those at its start.
/// \complexity the depth of the leaf
template <class Tree, class IsTaken>
[[nodiscard]] Node_handle last_leaf(const Tree& tree, std::size_t spiral, const IsTaken& is_taken) {
  Node_handle h = tree.segment_root(static_cast<std::uint32_t>(spiral));
  while (!h.is_leaf) {
    std::optional<Node_handle> next;
    tree.for_each_child(h, [&](const Node_handle& child) {
      if (!next || is_taken(tree.node(child).t0)) next = child;
    });
    h = *next;
  }
  return h;
}
/// The leaf of a segment that holds what comes just behind t. \pre first() <= t < last()
template <class Tree> [[nodiscard]] Node_handle leaf_behind(const Tree& tree, std::size_t spiral, double t) {
  return last_leaf(tree, spiral, [t](double t0) { return t0 <= t; });
}
/// The leaf of a segment that holds what comes just before t. \pre first() < t <= last()
template <class Tree> [[nodiscard]] Node_handle leaf_before(const Tree& tree, std::size_t spiral, double t) {
  return last_leaf(tree, spiral, [t](double t0) { return t0 < t; });
}

/// The leaf that follows one along its curve; around a closed curve without end.
/// \return nothing behind the last leaf of an open curve \pre h.is_leaf
template <class Tree> [[nodiscard]] std::optional<Node_handle> next_leaf(const Tree& tree, const Node_handle& h) {
  const Region_node n = tree.node(h);
  if (n.t1 < tree.spirals()[n.spiral].last()) return leaf_behind(tree, n.spiral, n.t1);
  const auto next = segment_after(tree.spirals(), n.spiral);
  return next ? std::optional(leaf_behind(tree, *next, tree.spirals()[*next].first())) : std::nullopt;
}
/// The leaf before it, the other way round.
template <class Tree> [[nodiscard]] std::optional<Node_handle> previous_leaf(const Tree& tree, const Node_handle& h) {
  const Region_node n = tree.node(h);
  if (tree.spirals()[n.spiral].first() < n.t0) return leaf_before(tree, n.spiral, n.t0);
  const auto before = segment_before(tree.spirals(), n.spiral);
  return before ? std::optional(leaf_before(tree, *before, tree.spirals()[*before].last())) : std::nullopt;
}

}  // namespace CGAL::Bounding_arcs::internal

#endif
