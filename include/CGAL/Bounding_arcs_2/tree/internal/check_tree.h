// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// What holds for every tree, checked without a look at curves: Bounding_arc_tree_2::is_valid.

#ifndef CGAL_BOUNDING_ARCS_2_TREE_INTERNAL_CHECK_TREE_H
#define CGAL_BOUNDING_ARCS_2_TREE_INTERNAL_CHECK_TREE_H

#include <CGAL/Bounding_arcs_2/tree/Build_options.h>
#include <CGAL/Bounding_arcs_2/tree/Region_node.h>

#include <CGAL/Bbox_2.h>

#include <cstddef>
#include <cstdint>
#include <vector>

namespace CGAL::Bounding_arcs::internal {

[[nodiscard]] inline bool holds(const CGAL::Bbox_2& box, const CGAL::Bbox_2& other) {
  return box.xmin() <= other.xmin() && other.xmax() <= box.xmax() && box.ymin() <= other.ymin() &&
         other.ymax() <= box.ymax();
}

// Counts in `seen` the segments below a box. \return whether each box holds those below it
template <class Tree>
[[nodiscard]] bool has_nested_boxes(const Tree& tree, const Node_handle& h, std::vector<int>& seen) {
  bool is_nested = true;
  const CGAL::Bbox_2 own = tree.box(h);
  tree.for_each_child(h, [&](const Node_handle& child) {
    is_nested = is_nested && holds(own, tree.box(child));
    if (child.is_region) ++seen[child.spiral];
    else is_nested = is_nested && has_nested_boxes(tree, child, seen);
  });
  return is_nested;
}

// Whether kept leaves follow each other from the first parameter of their segment to the last one, as many as counted.
template <class Tree> [[nodiscard]] bool has_leaves_side_by_side(const Tree& tree) {
  if (tree.nodes() == Build_options::Nodes::LAZY) return true;
  bool is_right = true;
  std::vector<std::size_t> count(tree.spirals().size(), 0);
  std::vector<double> end;
  for (const auto& s : tree.spirals()) end.push_back(s.first());
  tree.for_each_leaf([&](const Node_handle& h) {
    const Region_node n = tree.node(h);
    is_right = is_right && n.spiral == h.spiral && n.t0 == end[h.spiral] && n.t0 < n.t1;
    end[h.spiral] = n.t1;
    ++count[h.spiral];
  });
  for (std::size_t i = 0; i < count.size() && is_right; ++i)
    is_right = end[i] == tree.spirals()[i].last() && count[i] == tree.number_of_leaves(i);
  return is_right;
}

/// Tells whether boxes hold those below them, with each segment in one of them, and leaves are side by side.
template <class Tree> [[nodiscard]] bool is_valid_tree(const Tree& tree) {
  if (!(tree.bound() >= 0)) return false;
  if (tree.spirals().empty()) return tree.number_of_leaves() == 0;
  std::vector<int> seen(tree.spirals().size(), 0);
  if (!has_nested_boxes(tree, tree.root(), seen)) return false;
  for (const int times : seen)
    if (times != 1) return false;
  return has_leaves_side_by_side(tree);
}

}  // namespace CGAL::Bounding_arcs::internal

#endif
