// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The regions of single nodes in hand, for traversals, which see few nodes of many: what a segment's regions share is
// made when a node of another segment is asked for.  Regions have the same bits as those of all leaves
// (Region_columns.h).

#ifndef CGAL_BOUNDING_ARCS_2_TREE_REGION_READER_H
#define CGAL_BOUNDING_ARCS_2_TREE_REGION_READER_H

#include <CGAL/Bounding_arcs_2/tree/Build_options.h>
#include <CGAL/Bounding_arcs_2/tree/Region_columns.h>
#include <CGAL/Bounding_arcs_2/tree/Region_node.h>
#include <CGAL/assertions.h>

#include <cstddef>
#include <cstdint>
#include <optional>
#include <type_traits>

namespace CGAL::Bounding_arcs {

/// The regions of single nodes in doubles, for traversals, which see few nodes of many.
/// Reads a tree over double, which must outlive it. A thread takes one of its own: it keeps what it read last.
/// \code
/// Region_reader reader(regions);  // a tree with an eps, over doubles
/// const Arc_region_2 whole = reader.region(regions.segment_root(0));
/// \endcode
template <class Tree> class Region_reader {
  static_assert(std::is_same_v<typename Tree::Traits::FT, double>, "exact regions are made by Tree::region");

 public:
  explicit Region_reader(const Tree& tree, Build_options::Instruction_set set = Build_options::Instruction_set::BEST)
      : tree_(&tree), segment_(internal::Region_source(tree.traits().construction(), tree.spirals(), set)) {
    rows_.first = {0, MOST + 1};
    rows_.widening.resize(1);
    segment_.resize(rows_, MOST + 1 + internal::Segment_regions::PADDING);
  }

  /// The region of a region node, of any kind of nodes. \pre h.is_region
  /// \complexity over cubics some 40 ns (BCA) to 90, and 160 more where the segment is not the last one that was asked
  ///   for. Curves that batches do not serve (doc/batches.md), and SFA and bilens too long for batches, take
  ///   microseconds
  [[nodiscard]] Arc_region_2 region(const Node_handle& h) {
    CGAL_precondition(h.is_region);
    const Region_node node = tree_->node(h);
    rows_.t[0] = node.t0;
    rows_.t[1] = node.t1;
    make(h.spiral, 1);
    return rows_.region(0, 0);
  }
  /// Calls visit(child, region) for both children of a region node in curve order; none of a leaf. \pre h.is_region
  template <class Visit> void for_each_child(const Node_handle& h, const Visit& visit) {
    CGAL_precondition(h.is_region);
    Node_handle children[MOST];
    std::size_t count = 0;
    tree_->for_each_child(h, [&](const Node_handle& child) {
      const Region_node node = tree_->node(child);
      rows_.t[count] = node.t0;
      rows_.t[count + 1] = node.t1;
      children[count++] = child;
    });
    if (count == 0) return;
    make(h.spiral, MOST);
    const Arc_region_2 first = rows_.region(0, 0), second = rows_.region(1, 0);  // as visits may read others
    visit(children[0], first);
    visit(children[1], second);
  }
  /// Calls visit(leaf, region) for all leaves in curve order. All of a segment are made at once, but of lazy trees, so
  /// that this takes little more time than Region_columns do, and no more memory than one segment's.
  template <class Visit> void for_each_leaf(const Visit& visit) {
    if (tree_->nodes() == Build_options::Nodes::LAZY)
      return tree_->for_each_leaf([&](const Node_handle& h) { visit(h, region(h)); });
    Region_columns leaves;
    leaves.widening.resize(1);
    typename Tree::Leaf_room room;
    std::optional<std::uint32_t> made;  // visits may read nodes of other segments
    std::size_t row = 0;
    tree_->for_each_leaf([&](const Node_handle& h) {
      if (made != h.spiral) {
        make_leaves(h.spiral, room, leaves);
        made = h.spiral;
        row = 0;
      }
      visit(h, leaves.region(row++, 0));
    });
  }

 private:
  static constexpr std::size_t MOST = 2;  // pieces at once

  void open(std::uint32_t spiral) {
    if (spiral == spiral_) return;
    segment_.open(spiral);
    spiral_ = spiral;
  }
  void make(std::uint32_t spiral, std::size_t count) {
    open(spiral);
    rows_.widening[0] = segment_.make(rows_, 0, count);
  }
  void make_leaves(std::uint32_t spiral, typename Tree::Leaf_room& room, Region_columns& leaves) {
    open(spiral);
    const std::size_t count = tree_->number_of_leaves(spiral);
    segment_.resize(leaves, count + 1 + internal::Segment_regions::PADDING);
    leaves.t[0] = tree_->spirals()[spiral].first();
    tree_->write_leaf_ends(spiral, room, &leaves.t[1]);
    leaves.widening[0] = segment_.make(leaves, 0, count);
  }

  const Tree* tree_;
  internal::Segment_regions segment_;
  std::optional<std::uint32_t> spiral_;  // whose regions segment_ makes
  Region_columns rows_;
};

}  // namespace CGAL::Bounding_arcs

#endif
