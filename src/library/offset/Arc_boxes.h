// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Boxes over arcs: over blocks of neighbours, for what is near, and over closed chains, for what these run round.

#ifndef BOUNDING_ARCS_LIBRARY_OFFSET_ARC_BOXES_H
#define BOUNDING_ARCS_LIBRARY_OFFSET_ARC_BOXES_H

#include <CGAL/Bounding_arcs_2/arc/Arc_2.h>
#include "../arc/arc_crossings.h"
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

/// Arcs in their order, eight a block, and a tree of boxes over the blocks: neighbours along a chain are near to each
/// other, so that a block's box is small, and the tree has an eighth of the items to sort.
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

/// How often an arc with its chord runs round x: 0 unless x is between both.
[[nodiscard]] inline int winding_of_cap(const Arc_2& arc, const Xy<double>& x) {
  if (arc.bulge == 0) return 0;
  // to the left of the arc and right of the chord, where it turns left; on the chord as if it were a little to the
  // right in the plane, and less above, which is what the crossing of the chord takes for granted
  const Xy<double> chord = arc.to - arc.from;
  const double side = cross(chord, x - arc.from), of_arc = side_of_circle(x, arc);
  const double of_chord = side != 0 ? side : (chord.y != 0 ? -chord.y : chord.x);
  if (arc.bulge > 0) return of_chord < 0 && of_arc > 0 ? 1 : 0;
  return of_chord > 0 && of_arc < 0 ? -1 : 0;
}
/// How often the chord's ray to the right of x is crossed upwards.
[[nodiscard]] inline int winding_of_chord(const Xy<double>& p, const Xy<double>& q, const Xy<double>& x) {
  if ((p.y <= x.y) == (q.y <= x.y)) return 0;
  const double side = cross(q - p, x - p);
  if (p.y <= x.y) return side > 0 ? 1 : 0;
  return side < 0 ? -1 : 0;
}
[[nodiscard]] inline int winding_of_arc(const Arc_2& arc, const Xy<double>& x) {
  return winding_of_chord(arc.from, arc.to, x) + winding_of_cap(arc, x);
}

/// Boxes of closed chains of arcs, which tell how often they run round a point in a time that grows as the logarithm of
/// their number where few of them have the point in their box. The arcs stay where they are: each call says how to get
/// at those of a ring, from 0 on, by arc_of(k).
///
///         ring: runs of 16 arcs, and boxes of two, four, ... runs above them. A ray goes from x to the right: what is
///   x ---->     above, below or to the left of x does not meet it, and what is to the right of x does as its chord
///   does.
class Arc_rings {
 public:
  /// Appends a ring of some arcs, which follow each other bit for bit.
  template <class Arc_of> void add(std::size_t count, const Arc_of& arc_of) {
    const std::size_t runs = (count + RUN - 1) / RUN;
    std::size_t leaves = 1;
    while (leaves < runs) leaves *= 2;
    rings_.push_back({count, leaves, boxes_.size()});
    // node i has the children 2 i and 2 i + 1, and the first is number 1
    std::vector<CGAL::Bbox_2> nodes(2 * leaves);
    for (std::size_t k = 0; k < count; ++k) nodes[leaves + k / RUN] += box_about(arc_of(k));
    for (std::size_t i = leaves - 1; i > 0; --i) nodes[i] = nodes[2 * i] + nodes[2 * i + 1];
    boxes_.insert(boxes_.end(), nodes.begin() + 1, nodes.end());
  }
  /// To be called when all rings are there.
  void finish() {
    tree_ =
        Box_tree(rings_.size(), [this](std::size_t i) -> const CGAL::Bbox_2& { return boxes_[rings_[i].first_box]; });
  }

  /// Calls visit(ring) for rings whose box holds x; others do not run round it.
  template <class Visit> void for_each_about(const Xy<double>& x, const Visit& visit) const {
    const auto holds = [&](const Box_tree::Node& n, std::size_t k) {
      return n.x_low[k] <= x.x && x.x <= n.x_high[k] && n.y_low[k] <= x.y && x.y <= n.y_high[k];
    };
    for_each_item(tree_, holds, [&](const Box_tree::Node& n, std::size_t k) {
      visit(std::size_t{n.child[k]});
      return true;
    });
  }
  /// How often a ring runs round x.
  template <class Arc_of> [[nodiscard]] int winding(std::size_t ring, const Xy<double>& x, const Arc_of& arc_of) const {
    return winding_of_node(rings_[ring], 1, 0, rings_[ring].leaves * RUN, x, arc_of);
  }

 private:
  static constexpr std::size_t RUN = 16;
  struct Ring {
    std::size_t count, leaves, first_box;
  };

  // A node has the arcs [begin, end), but for those beyond the last one.
  template <class Arc_of>
  [[nodiscard]] int winding_of_node(const Ring& ring, std::size_t node, std::size_t begin, std::size_t end,
                                    const Xy<double>& x, const Arc_of& arc_of) const {
    const CGAL::Bbox_2& box = boxes_[ring.first_box + node - 1];
    if (begin >= ring.count || x.y < box.ymin() || x.y > box.ymax() || x.x > box.xmax()) return 0;
    const std::size_t last = (std::min)(end, ring.count);
    if (x.x < box.xmin()) {
      const bool begins_below = arc_of(begin).from.y <= x.y, ends_below = arc_of(last - 1).to.y <= x.y;
      return static_cast<int>(begins_below) - static_cast<int>(ends_below);
    }
    if (end - begin > RUN) {
      const std::size_t middle = begin + (end - begin) / 2;
      return winding_of_node(ring, 2 * node, begin, middle, x, arc_of) +
             winding_of_node(ring, 2 * node + 1, middle, end, x, arc_of);
    }
    int sum = 0;
    for (std::size_t k = begin; k < last; ++k) sum += winding_of_arc(arc_of(k), x);
    return sum;
  }

  std::vector<Ring> rings_;
  std::vector<CGAL::Bbox_2> boxes_;  // of each ring the nodes from number 1 on
  Box_tree tree_;                    // over rings
};

}  // namespace CGAL::Bounding_arcs::internal

#endif
