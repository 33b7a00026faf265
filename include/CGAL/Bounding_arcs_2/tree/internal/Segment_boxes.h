// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The boxes over the segments of a hierarchy: a Box_tree (src/library/tree/Box_tree.h) as traversals see it.

#ifndef CGAL_BOUNDING_ARCS_2_TREE_INTERNAL_SEGMENT_BOXES_H
#define CGAL_BOUNDING_ARCS_2_TREE_INTERNAL_SEGMENT_BOXES_H

#include <CGAL/Bbox_2.h>

#include <cstddef>
#include <cstdint>
#include <memory>
#include <vector>

namespace CGAL::Bounding_arcs {

class Box_tree;

namespace internal {

/// Nodes of up to four boxes. A slot is four times a node's number and the place of a box in it.
class Segment_boxes {
 public:
  /// A box below a node, or a segment.
  struct Child {
    std::uint32_t number;  ///< of the node or segment
    bool is_segment;
    std::size_t slot;
  };
  /// What is below a node.
  struct Children {
    Child child[4];
    std::size_t size;
  };

  explicit Segment_boxes(const std::vector<CGAL::Bbox_2>& segments);

  /// Counts the nodes.
  [[nodiscard]] std::size_t size() const;
  /// The box of all. \pre there are segments
  [[nodiscard]] CGAL::Bbox_2 box() const;
  [[nodiscard]] CGAL::Bbox_2 box(std::size_t slot) const;
  [[nodiscard]] Children children(std::uint32_t node) const;

 private:
  std::shared_ptr<const Box_tree> tree_;
};

}  // namespace internal
}  // namespace CGAL::Bounding_arcs

#endif
