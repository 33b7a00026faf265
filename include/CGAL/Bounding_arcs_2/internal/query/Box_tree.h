// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Boxes over items, four children a node, built from the top by cutting the longer side of the items' centres at their
// median twice: whatever the order of the items, a query sees as many boxes as the logarithm of their number.  A node's
// four boxes lie side by side, coordinate by coordinate, as all are looked at together.

#ifndef CGAL_BOUNDING_ARCS_2_INTERNAL_QUERY_BOX_TREE_H
#define CGAL_BOUNDING_ARCS_2_INTERNAL_QUERY_BOX_TREE_H

#include <CGAL/Bounding_arcs_2/curve/Xy.h>

#include <CGAL/Bbox_2.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <vector>

namespace CGAL::Bounding_arcs::internal {

class Box_tree {
 public:
  static constexpr std::size_t WIDTH = 4;

  /// Four boxes and what is below them; a child that is not there has an empty box, which is infinitely far away.
  struct Node {
    double x_low[WIDTH], y_low[WIDTH], x_high[WIDTH], y_high[WIDTH];
    std::uint32_t child[WIDTH];  ///< a node, or an item where the bit is set
    std::uint8_t items = 0;      ///< bit k: child k is an item
    std::uint8_t size = 0;

    [[nodiscard]] bool is_item(std::size_t k) const { return ((items >> k) & 1U) != 0; }
    [[nodiscard]] CGAL::Bbox_2 box(std::size_t k) const { return {x_low[k], y_low[k], x_high[k], y_high[k]}; }
  };

  Box_tree() = default;
  explicit Box_tree(const std::vector<CGAL::Bbox_2>& boxes) {
    std::vector<Item> items(boxes.size());
    for (std::size_t i = 0; i < boxes.size(); ++i) {
      const CGAL::Bbox_2& b = boxes[i];
      items[i] = {static_cast<std::uint32_t>(i), {b.xmin() / 2 + b.xmax() / 2, b.ymin() / 2 + b.ymax() / 2}};
      box_ = i == 0 ? b : box_ + b;
    }
    nodes_.reserve(boxes.size() / 2 + 1);
    if (!items.empty()) build(boxes, items.data(), items.data() + items.size());
  }

  [[nodiscard]] bool empty() const { return nodes_.empty(); }
  [[nodiscard]] const Node& root() const { return nodes_.front(); }
  [[nodiscard]] const Node& node(std::uint32_t i) const { return nodes_[i]; }
  /// Of all items. \pre there are items
  [[nodiscard]] const CGAL::Bbox_2& box() const { return box_; }
  [[nodiscard]] std::size_t bytes() const { return nodes_.capacity() * sizeof(Node); }

 private:
  struct Item {
    std::uint32_t index;
    Xy<double> centre;
  };

  std::uint32_t build(const std::vector<CGAL::Bbox_2>& boxes, Item* begin, Item* end) {
    const auto place = static_cast<std::uint32_t>(nodes_.size());
    nodes_.emplace_back();
    std::array<Item*, WIDTH + 1> cuts{begin, begin, begin, begin, begin};
    const std::size_t size = static_cast<std::size_t>(end - begin);
    if (size <= WIDTH) {
      for (std::size_t k = 0; k <= WIDTH; ++k) cuts[k] = begin + (std::min)(k, size);
    } else {
      cuts[2] = halve(begin, end);
      cuts[1] = halve(begin, cuts[2]);
      cuts[3] = halve(cuts[2], end);
      cuts[4] = end;
    }
    Node node;
    for (std::size_t k = 0; k < WIDTH; ++k) {
      const double none = std::numeric_limits<double>::infinity();
      node.x_low[k] = node.y_low[k] = none;
      node.x_high[k] = node.y_high[k] = -none;
      node.child[k] = 0;
      for (const Item* i = cuts[k]; i != cuts[k + 1]; ++i) {
        const CGAL::Bbox_2& b = boxes[i->index];
        node.x_low[k] = (std::min)(node.x_low[k], b.xmin());
        node.y_low[k] = (std::min)(node.y_low[k], b.ymin());
        node.x_high[k] = (std::max)(node.x_high[k], b.xmax());
        node.y_high[k] = (std::max)(node.y_high[k], b.ymax());
      }
      if (cuts[k] == cuts[k + 1]) continue;
      ++node.size;
      const bool is_item = cuts[k + 1] - cuts[k] == 1;
      if (is_item) node.items = static_cast<std::uint8_t>(node.items | 1U << k);
      node.child[k] = is_item ? cuts[k]->index : build(boxes, cuts[k], cuts[k + 1]);
    }
    nodes_[place] = node;
    return place;
  }
  [[nodiscard]] static Item* halve(Item* begin, Item* end) {
    double x0 = begin->centre.x, x1 = x0, y0 = begin->centre.y, y1 = y0;
    for (const Item* i = begin; i != end; ++i) {
      x0 = (std::min)(x0, i->centre.x);
      x1 = (std::max)(x1, i->centre.x);
      y0 = (std::min)(y0, i->centre.y);
      y1 = (std::max)(y1, i->centre.y);
    }
    Item* middle = begin + (end - begin) / 2;
    const auto by = [](double Xy<double>::*axis) {
      return [axis](const Item& a, const Item& b) { return a.centre.*axis < b.centre.*axis; };
    };
    std::nth_element(begin, middle, end, x1 - x0 < y1 - y0 ? by(&Xy<double>::y) : by(&Xy<double>::x));
    return middle;
  }

  std::vector<Node> nodes_;  // the root first
  CGAL::Bbox_2 box_;
};

/// A node with one of the children only.
[[nodiscard]] inline Box_tree::Node one(const Box_tree::Node& n, std::size_t k) {
  Box_tree::Node single;
  single.x_low[0] = n.x_low[k];
  single.y_low[0] = n.y_low[k];
  single.x_high[0] = n.x_high[k];
  single.y_high[0] = n.y_high[k];
  single.child[0] = n.child[k];
  single.items = n.is_item(k) ? 1 : 0;
  single.size = 1;
  return single;
}

[[nodiscard]] inline bool do_overlap(const Box_tree::Node& a, std::size_t i, const Box_tree::Node& b, std::size_t j) {
  return a.x_low[i] <= b.x_high[j] && b.x_low[j] <= a.x_high[i] && a.y_low[i] <= b.y_high[j] &&
         b.y_low[j] <= a.y_high[i];
}

/// Calls visit(i, j) for items of two trees whose boxes have a common point, until it returns false.
/// \return whether it never did
template <class Visit> bool for_each_overlap(const Box_tree& a, const Box_tree& b, const Visit& visit) {
  const auto below = [&](const auto& self, const Box_tree::Node& m, const Box_tree::Node& n) -> bool {
    for (std::size_t i = 0; i < m.size; ++i)
      for (std::size_t j = 0; j < n.size; ++j) {
        if (!do_overlap(m, i, n, j)) continue;
        if (!(m.is_item(i) ? (n.is_item(j) ? visit(m.child[i], n.child[j]) : self(self, one(m, i), b.node(n.child[j])))
                           : (n.is_item(j) ? self(self, a.node(m.child[i]), one(n, j))
                                           : self(self, a.node(m.child[i]), b.node(n.child[j])))))
          return false;
      }
    return true;
  };
  return a.empty() || b.empty() || below(below, a.root(), b.root());
}

/// Calls visit(i, j) once for each two different items of a tree whose boxes have a common point, until it returns
/// false.
/// \return whether it never did
template <class Visit> bool for_each_overlap(const Box_tree& tree, const Visit& visit) {
  const auto between = [&](const auto& self, const Box_tree::Node& m, const Box_tree::Node& n) -> bool {
    const bool is_same = &m == &n;
    for (std::size_t i = 0; i < m.size; ++i)
      for (std::size_t j = is_same ? i : 0; j < n.size; ++j) {
        if (!do_overlap(m, i, n, j) || (is_same && i == j && m.is_item(i))) continue;
        if (!(m.is_item(i)
                  ? (n.is_item(j) ? visit(m.child[i], n.child[j]) : self(self, one(m, i), tree.node(n.child[j])))
                  : (n.is_item(j) ? self(self, tree.node(m.child[i]), one(n, j))
                                  : self(self, tree.node(m.child[i]), tree.node(n.child[j])))))
          return false;
      }
    return true;
  };
  return tree.empty() || between(between, tree.root(), tree.root());
}

}  // namespace CGAL::Bounding_arcs::internal

#endif
