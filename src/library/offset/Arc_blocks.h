// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Arcs in their order, eight a block, and a tree of boxes over the blocks: neighbours along a chain are near to each
// other, so that a block's box is small, and the tree has an eighth of the items to sort.

#ifndef BOUNDING_ARCS_LIBRARY_OFFSET_ARC_BLOCKS_H
#define BOUNDING_ARCS_LIBRARY_OFFSET_ARC_BLOCKS_H

#include <CGAL/Bounding_arcs_2/arc/Arc_2.h>
#include "../tree/Box_tree.h"

#include <CGAL/Bbox_2.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <vector>

namespace CGAL::Bounding_arcs::internal {

/// A box of an arc, a little larger than the smallest.  The arc is on one side of its chord, and no farther than
/// |bulge| / 2 chords from it.
[[nodiscard]] inline CGAL::Bbox_2 box_about(const Arc_2& arc) {
  const Xy<double> chord = arc.to - arc.from, h = (-0.5 * arc.bulge) * perp(chord);
  const Xy<double> p = arc.from + h, q = arc.to + h;
  constexpr double ROUNDING = 8 * HALF_ULP;
  const double x0 = (std::min)((std::min)(arc.from.x, arc.to.x), (std::min)(p.x, q.x)),
               x1 = (std::max)((std::max)(arc.from.x, arc.to.x), (std::max)(p.x, q.x)),
               y0 = (std::min)((std::min)(arc.from.y, arc.to.y), (std::min)(p.y, q.y)),
               y1 = (std::max)((std::max)(arc.from.y, arc.to.y), (std::max)(p.y, q.y));
  const double room = ROUNDING * ((std::max)(std::fabs(x0), std::fabs(x1)) + (std::max)(std::fabs(y0), std::fabs(y1)));
  return {x0 - room, y0 - room, x1 + room, y1 + room};
}

struct Arc_block {
  std::uint32_t begin, end, chain;
  double turn;  ///< the sum of what its arcs turn by, and of corners between them
  CGAL::Bbox_2 box;
};

class Arc_blocks {
 public:
  static constexpr std::uint32_t SIZE = 8;

  Arc_blocks() = default;
  /// \param begins where chains of arcs begin, in order, and at last the number of arcs: no block is of two chains
  /// \param arc_of, turn_of the arc with a number, and what it turns by, with the corner before it
  /// \param reach how much larger boxes are on each side, for arcs that come that near to each other
  template <class Arc_of, class Turn_of>
  Arc_blocks(const std::vector<std::uint32_t>& begins, const Arc_of& arc_of, const Turn_of& turn_of, double reach = 0) {
    const std::uint32_t count = begins.empty() ? 0 : begins.back();
    boxes_.reserve(count);
    blocks_.reserve(count / SIZE + begins.size());
    for (std::size_t chain = 0; chain + 1 < begins.size(); ++chain)
      for (std::uint32_t i = begins[chain]; i < begins[chain + 1]; i += SIZE) {
        Arc_block block{i, (std::min)(i + SIZE, begins[chain + 1]), static_cast<std::uint32_t>(chain), 0, {}};
        for (std::uint32_t k = i; k < block.end; ++k) {
          const CGAL::Bbox_2 b = box_about(arc_of(k));
          boxes_.emplace_back(b.xmin() - reach, b.ymin() - reach, b.xmax() + reach, b.ymax() + reach);
          block.box = k == i ? boxes_.back() : block.box + boxes_.back();
          block.turn += turn_of(k);
        }
        blocks_.push_back(block);
      }
    std::vector<CGAL::Bbox_2> boxes;
    boxes.reserve(blocks_.size());
    for (const Arc_block& b : blocks_) boxes.push_back(b.box);
    tree_ = Box_tree(boxes);
  }

  [[nodiscard]] const Box_tree& tree() const { return tree_; }
  [[nodiscard]] const Arc_block& block(std::uint32_t i) const { return blocks_[i]; }

  /// Frees the boxes of arcs, which take a third of the memory of arcs. Pairs are not looked for any more.
  void drop_boxes_of_arcs() { boxes_ = std::vector<CGAL::Bbox_2>(); }
  /// Calls visit(i, j) for arcs whose boxes overlap, each two once, but for those that cannot cross as the chain
  /// between them turns by less than half a circle.  Stops when it returns false.
  template <class Visit> bool for_each_pair(const Visit& visit) const {
    constexpr double LESS_THAN_HALF = 3.1;
    for (const Arc_block& b : blocks_) {
      if (b.turn < LESS_THAN_HALF) continue;
      for (std::uint32_t i = b.begin; i < b.end; ++i)
        for (std::uint32_t j = i + 1; j < b.end; ++j)
          if (do_overlap(boxes_[i], boxes_[j]) && !visit(i, j)) return false;
    }
    return for_each_overlap(tree_, [&](std::uint32_t p, std::uint32_t q) {
      const Arc_block &a = blocks_[(std::min)(p, q)], &b = blocks_[(std::max)(p, q)];
      if (a.chain == b.chain && a.end == b.begin && a.turn + b.turn < LESS_THAN_HALF) return true;
      for (std::uint32_t i = a.begin; i < a.end; ++i) {
        if (!do_overlap(boxes_[i], b.box)) continue;
        for (std::uint32_t j = b.begin; j < b.end; ++j)
          if (do_overlap(boxes_[i], boxes_[j]) && !visit(i, j)) return false;
      }
      return true;
    });
  }

 private:
  std::vector<CGAL::Bbox_2> boxes_;
  std::vector<Arc_block> blocks_;
  Box_tree tree_;
};

}  // namespace CGAL::Bounding_arcs::internal

#endif
