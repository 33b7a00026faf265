// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// A tree of boxes.

#ifndef BOUNDING_ARCS_LIBRARY_TREE_BOX_TREE_H
#define BOUNDING_ARCS_LIBRARY_TREE_BOX_TREE_H

#include <CGAL/Bounding_arcs_2/number/Xy.h>
#include <CGAL/Bounding_arcs_2/number/strict_math.h>

#include <CGAL/Bbox_2.h>
#include <CGAL/assertions.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace CGAL::Bounding_arcs {

/// Boxes over items, four children a node, built from the top by cutting the longer side of the items' centers at their
/// median twice. Whatever the order of the items, a query sees as many boxes as the logarithm of their number. A node's
/// four boxes lie side by side, coordinate by coordinate, as all are looked at together.
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
    [[nodiscard]] CGAL::Bbox_2 box() const { return box(0) + box(1) + box(2) + box(3); }  ///< of all four
    void set_box(std::size_t k, const CGAL::Bbox_2& box) {
      x_low[k] = box.xmin();
      y_low[k] = box.ymin();
      x_high[k] = box.xmax();
      y_high[k] = box.ymax();
    }
  };

  Box_tree() = default;
  explicit Box_tree(const std::vector<CGAL::Bbox_2>& boxes)
      : Box_tree(boxes.size(), [&boxes](std::size_t i) -> const CGAL::Bbox_2& { return boxes[i]; }) {}
  /// \param box_of box_of(i): the box of item i, asked for twice
  template <class Box_of> Box_tree(std::size_t count, const Box_of& box_of) {
    std::vector<Item> items(count);
    for (std::size_t i = 0; i < count; ++i) {
      const CGAL::Bbox_2& b = box_of(i);
      items[i] = {static_cast<std::uint32_t>(i), {b.xmin() / 2 + b.xmax() / 2, b.ymin() / 2 + b.ymax() / 2}};
      box_ = i == 0 ? b : box_ + b;
    }
    nodes_.reserve(number_of_nodes(count));
    if (count > 0) build(box_of, items.data(), items.data() + count);
  }

  /// Gives items first, ..., last - 1 other boxes, and what is above them. The tree stays as good as it was where these
  /// moved little.
  /// \pre find_parents() was called
  /// \complexity the logarithm of the number of items for each
  template <class Box_of> void refit(std::size_t first, std::size_t last, const Box_of& box_of) {
    for (std::size_t i = first; i < last; ++i) {
      CGAL::Bbox_2 box = box_of(i);
      for (std::uint32_t place = slots_[i]; place != NO_SLOT;) {
        Node& node = nodes_[place / WIDTH];
        node.set_box(place % WIDTH, box);
        box = node.box();
        place = parents_[place / WIDTH];
      }
    }
    box_ = nodes_.empty() ? CGAL::Bbox_2() : nodes_.front().box();
  }

  /// Finds where items and nodes are, if that is not known yet. \complexity linear in their number
  void find_parents() {
    if (!parents_.empty()) return;
    std::vector<std::uint32_t> parents(nodes_.size(), NO_SLOT), slots;
    for (std::uint32_t i = 0; i < nodes_.size(); ++i)
      for (std::uint32_t k = 0; k < nodes_[i].size; ++k) {
        const std::uint32_t child = nodes_[i].child[k], slot = static_cast<std::uint32_t>(WIDTH) * i + k;
        if (!nodes_[i].is_item(k)) {
          parents[child] = slot;
          continue;
        }
        if (slots.size() <= child) slots.resize(child + 1, NO_SLOT);
        slots[child] = slot;
      }
    slots_ = std::move(slots);
    parents_ = std::move(parents);
  }

  [[nodiscard]] bool empty() const { return nodes_.empty(); }
  [[nodiscard]] const Node& root() const { return nodes_.front(); }
  [[nodiscard]] const Node& node(std::uint32_t i) const { return nodes_[i]; }
  /// The box of all items. \pre there are items
  [[nodiscard]] const CGAL::Bbox_2& box() const {
    CGAL_precondition(!nodes_.empty());
    return box_;
  }
  [[nodiscard]] std::size_t size() const { return nodes_.size(); }
  [[nodiscard]] std::size_t bytes() const { return nodes_.capacity() * sizeof(Node); }

 private:
  struct Item {
    std::uint32_t index;
    Xy<double> center;
  };

  // Child k of node i is in the slot WIDTH i + k.
  static constexpr std::uint32_t NO_SLOT = ~std::uint32_t(0);

  // As many as build() makes; a part of one item has none.
  [[nodiscard]] static std::size_t number_of_nodes(std::size_t items) {
    if (items <= WIDTH) return items > 1 ? 1 : 0;
    const std::size_t half = items / 2, rest = items - half;
    return 1 + number_of_nodes(half / 2) + number_of_nodes(half - half / 2) + number_of_nodes(rest / 2) +
           number_of_nodes(rest - rest / 2);
  }
  template <class Box_of> std::uint32_t build(const Box_of& box_of, Item* begin, Item* end) {
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
      const std::ptrdiff_t count = cuts[k + 1] - cuts[k];
      const std::uint32_t child = count > 1 ? build(box_of, cuts[k], cuts[k + 1]) : (count == 1 ? cuts[k]->index : 0);
      if (count == 1) node.items = static_cast<std::uint8_t>(node.items | 1U << k);
      if (count > 0) ++node.size;
      node.child[k] = child;
      node.set_box(k, count > 1 ? nodes_[child].box() : (count == 1 ? box_of(child) : CGAL::Bbox_2()));
    }
    nodes_[place] = node;
    return place;
  }
  [[nodiscard]] static Item* halve(Item* begin, Item* end) {
    double x0 = begin->center.x, x1 = x0, y0 = begin->center.y, y1 = y0;
    for (const Item* i = begin; i != end; ++i) {
      x0 = (std::min)(x0, i->center.x);
      x1 = (std::max)(x1, i->center.x);
      y0 = (std::min)(y0, i->center.y);
      y1 = (std::max)(y1, i->center.y);
    }
    Item* middle = begin + (end - begin) / 2;
    // the axis is chosen out here, not in each comparison
    if (x1 - x0 < y1 - y0)
      std::nth_element(begin, middle, end, [](const Item& a, const Item& b) { return a.center.y < b.center.y; });
    else std::nth_element(begin, middle, end, [](const Item& a, const Item& b) { return a.center.x < b.center.x; });
    return middle;
  }

  std::vector<Node> nodes_;  // the root first
  CGAL::Bbox_2 box_;
  std::vector<std::uint32_t> slots_, parents_;  // of items and of nodes, where boxes were changed
};

/// The square of the distance from a point to box k of a node.
[[nodiscard]] inline double squared_distance(const Xy<double>& q, const Box_tree::Node& n, std::size_t k) {
  const double dx = (std::max)((std::max)(n.x_low[k] - q.x, q.x - n.x_high[k]), 0.0),
               dy = (std::max)((std::max)(n.y_low[k] - q.y, q.y - n.y_high[k]), 0.0);
  return dx * dx + dy * dy;
}
/// No box within a distance has a computed square above this: it rounds by 4 u, the square of the distance by u.
[[nodiscard]] inline double most_square(double distance) { return distance * distance * ROUNDED_UP<8>; }

/// Visits the items below a node; see for_each_item.
template <class Wants, class Visit>
bool visit_items(const Box_tree& tree, const Box_tree::Node& node, const Wants& wants, const Visit& visit) {
  for (std::size_t k = 0; k < node.size; ++k) {
    if (!wants(node, k)) continue;
    if (!(node.is_item(k) ? visit(node, k) : visit_items(tree, tree.node(node.child[k]), wants, visit))) return false;
  }
  return true;
}
/// Calls visit(node, k) for items, child k of a node, in boxes that are wanted, until it returns false.
/// \param wants wants(node, k): whether something in box k may count
/// \return whether it never did
template <class Wants, class Visit> bool for_each_item(const Box_tree& tree, const Wants& wants, const Visit& visit) {
  return tree.empty() || visit_items(tree, tree.root(), wants, visit);
}

/// What is near to a point, nearest boxes first.
/// \tparam Search has point(); squared_reach(), of boxes that count; goes_on(d), whether a box whose squared distance
///   was d counts still; look_at(item)
template <class Search> std::size_t visit_near(const Box_tree& tree, const Box_tree::Node& node, Search& search) {
  struct Child {
    double distance;
    std::size_t k;
  };
  std::array<Child, Box_tree::WIDTH> children;
  std::size_t count = 0;
  const double reach = search.squared_reach();
  double distance[Box_tree::WIDTH];
  for (std::size_t k = 0; k < Box_tree::WIDTH; ++k) distance[k] = squared_distance(search.point(), node, k);
  for (std::size_t k = 0; k < node.size; ++k) {
    const double d = distance[k];
    if (!(d <= reach)) continue;
    std::size_t i = count++;
    for (; i > 0 && children[i - 1].distance > d; --i) children[i] = children[i - 1];
    children[i] = {d, k};
  }
  std::size_t nodes = 1;
  for (std::size_t i = 0; i < count && search.goes_on(children[i].distance); ++i) {
    const std::uint32_t child = node.child[children[i].k];
    if (node.is_item(children[i].k)) search.look_at(child);
    else nodes += visit_near(tree, tree.node(child), search);
  }
  return nodes;
}
/// \return how many nodes were looked at
template <class Search> std::size_t for_each_near(const Box_tree& tree, Search& search) {
  return tree.empty() ? 0 : visit_near(tree, tree.root(), search);
}

/// Which boxes of a node have a point in common with a box of another, a bit each: all are looked at without a branch,
/// as which of them do is hard to foretell.
[[nodiscard]] inline unsigned overlaps(const Box_tree::Node& a, std::size_t i, const Box_tree::Node& b) {
  const double x_low = a.x_low[i], x_high = a.x_high[i], y_low = a.y_low[i], y_high = a.y_high[i];
  unsigned bits = 0;
  for (std::size_t j = 0; j < Box_tree::WIDTH; ++j)
    bits |= (unsigned(x_low <= b.x_high[j]) & unsigned(b.x_low[j] <= x_high) & unsigned(y_low <= b.y_high[j]) &
             unsigned(b.y_low[j] <= y_high))
            << j;
  return bits;
}

/// The pairs of items below two nodes, or below one item and a node, whose boxes have a common point.
/// \tparam Visit bool(i, j) with the item of tree a first; all end when it returns false
template <class Visit> class Overlap_search {
  using Node = Box_tree::Node;

 public:
  Overlap_search(const Box_tree& a, const Box_tree& b, const Visit& visit) : a_(a), b_(b), visit_(visit) {}

  bool operator()(const Node& m, const Node& n) {
    for (std::size_t i = 0; i < m.size; ++i)
      if (!row(m, i, n, looked_at(m, i, n))) return false;
    return true;
  }
  /// Visits the pairs of one tree with itself, each once.
  [[nodiscard]] bool within(const Node& m) {
    for (std::size_t i = 0; i < m.size; ++i) {
      if (!m.is_item(i) && !within(a_.node(m.child[i]))) return false;
      if (!row(m, i, m, looked_at(m, i, m) & ~0U << (i + 1))) return false;
    }
    return true;
  }
  /// Boxes that were looked at beside the four of a node.
  [[nodiscard]] std::size_t rows() const { return rows_; }

 private:
  [[nodiscard]] unsigned looked_at(const Node& m, std::size_t i, const Node& n) {
    ++rows_;
    return overlaps(m, i, n);
  }
  // Child i of m with those of n that have their bits set.
  bool row(const Node& m, std::size_t i, const Node& n, unsigned bits) {
    for (std::size_t j = 0; bits != 0; ++j, bits >>= 1)
      if ((bits & 1U) != 0 && !pair(m, i, n, j)) return false;
    return true;
  }
  bool pair(const Node& m, std::size_t i, const Node& n, std::size_t j) {
    const std::uint32_t p = m.child[i], q = n.child[j];
    if (m.is_item(i)) return n.is_item(j) ? visit_(p, q) : row_of_item<false>(m, i, b_.node(q));
    return n.is_item(j) ? row_of_item<true>(n, j, a_.node(p)) : (*this)(a_.node(p), b_.node(q));
  }
  // An item, child i of m, of tree b if IS_OF_B, with what is below a node of the other tree.
  template <bool IS_OF_B> bool row_of_item(const Node& m, std::size_t i, const Node& n) {
    unsigned bits = looked_at(m, i, n);
    for (std::size_t j = 0; bits != 0; ++j, bits >>= 1) {
      if ((bits & 1U) == 0) continue;
      const std::uint32_t p = m.child[i], q = n.child[j];
      if (!(n.is_item(j) ? (IS_OF_B ? visit_(q, p) : visit_(p, q))
                         : row_of_item<IS_OF_B>(m, i, (IS_OF_B ? a_ : b_).node(q))))
        return false;
    }
    return true;
  }

  const Box_tree &a_, &b_;
  const Visit& visit_;
  std::size_t rows_ = 0;
};

/// Calls visit(i, j) for items of two trees whose boxes have a common point, until it returns false.
/// \return whether it never did
template <class Visit> bool for_each_overlap(const Box_tree& a, const Box_tree& b, const Visit& visit) {
  return a.empty() || b.empty() || Overlap_search<Visit>(a, b, visit)(a.root(), b.root());
}

/// Calls visit(i, j) once for each two different items of a tree whose boxes have a common point, until it returns
/// false.
/// \return whether it never did
template <class Visit> bool for_each_overlap(const Box_tree& tree, const Visit& visit) {
  return tree.empty() || Overlap_search<Visit>(tree, tree, visit).within(tree.root());
}

}  // namespace CGAL::Bounding_arcs

#endif
