// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// How often closed chains of arcs run round a point, in a time that grows as the logarithm of their number where few
// of them have the point in their box.
//
//         ring: runs of 16 arcs, and boxes of two, four, ... runs above them. A ray goes from x to the right: what is
//   x ---->     above, below or to the left of x does not meet it, and what is to the right of x does as its chord
//   does.

#ifndef BOUNDING_ARCS_LIBRARY_OFFSET_ARC_RINGS_H
#define BOUNDING_ARCS_LIBRARY_OFFSET_ARC_RINGS_H

#include <CGAL/Bounding_arcs_2/arc/Arc_2.h>
#include "../arc/arc_crossings.h"
#include "../tree/Box_tree.h"
#include "Arc_blocks.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace CGAL::Bounding_arcs::internal {

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

/// Boxes of closed chains of arcs. The arcs stay where they are: each call says how to get at those of a ring, from 0
/// on, by arc_of(k).
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
