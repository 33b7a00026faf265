// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Bodies of tree/internal/Segment_boxes.h.

#include "Box_tree.h"

#include <CGAL/Bounding_arcs_2/tree/internal/Segment_boxes.h>

#include <cstddef>
#include <cstdint>
#include <memory>
#include <vector>

namespace CGAL::Bounding_arcs::internal {

Segment_boxes::Segment_boxes(const std::vector<CGAL::Bbox_2>& segments)
    : tree_(std::make_shared<const Box_tree>(segments)) {}

std::size_t Segment_boxes::size() const { return tree_->size(); }
CGAL::Bbox_2 Segment_boxes::box() const { return tree_->box(); }
CGAL::Bbox_2 Segment_boxes::box(std::size_t slot) const {
  return tree_->node(static_cast<std::uint32_t>(slot / Box_tree::WIDTH)).box(slot % Box_tree::WIDTH);
}
Segment_boxes::Children Segment_boxes::children(std::uint32_t node) const {
  static_assert(sizeof(Children::child) / sizeof(Child) == Box_tree::WIDTH);
  const Box_tree::Node& n = tree_->node(node);
  Children below{{}, n.size};
  for (std::size_t k = 0; k < n.size; ++k) below.child[k] = {n.child[k], n.is_item(k), node * Box_tree::WIDTH + k};
  return below;
}

}  // namespace CGAL::Bounding_arcs::internal
