// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// What eager and lazy hierarchies share: spiral segments, boxes over them, and traversal.

#ifndef CGAL_BOUNDING_ARCS_2_TREE_SPIRAL_HIERARCHY_H
#define CGAL_BOUNDING_ARCS_2_TREE_SPIRAL_HIERARCHY_H

#include <CGAL/Bounding_arcs_2/filter/Piece_decisions.h>
#include <CGAL/Bounding_arcs_2/internal/tree/for_each_index.h>
#include <CGAL/Bounding_arcs_2/tree/Box_hierarchy.h>
#include <CGAL/Bounding_arcs_2/tree/Spiral_grid.h>
#include <CGAL/Bounding_arcs_2/tree/box_of_piece.h>

#include <cstddef>
#include <cstdint>
#include <stdexcept>
#include <utility>
#include <vector>

namespace CGAL::Bounding_arcs {

/// One node of a subtree: a piece [t0, t1] of a spiral segment.
struct Region_node {
  double t0, t1;
  double thickness;      ///< at least the thickness of the piece's region
  std::uint32_t spiral;  ///< the index of the spiral segment
  bool is_leaf;
};

/// \tparam Derived has is_leaf(handle), node(handle), root_region(spiral) and for_each_half(handle, visit) for its
///   Handle of members is_region, level and index
template <class Derived, class Traits_, class Spiral_, class Handle_> class Spiral_hierarchy {
 public:
  using Traits = Traits_;
  using Spiral = Spiral_;
  using Handle = Handle_;
  using Region = typename Traits::Bounding_region_2;

  [[nodiscard]] const Traits& traits() const { return traits_; }
  [[nodiscard]] const std::vector<Spiral>& spirals() const { return spirals_; }
  [[nodiscard]] std::size_t number_of_boxes() const { return boxes_.size(); }

  /// The box over everything; of an empty tree it is empty, too, and has no children.
  [[nodiscard]] Handle root() const {
    Handle h{};
    h.level = boxes_.top_level();
    return h;
  }
  /// Calls visit(child) for each of the children in curve order: one or two, none of a leaf or an empty tree's root.
  template <class Visit> void for_each_child(const Handle& h, Visit&& visit) const {
    if (h.is_region) {
      if (!self().is_leaf(h)) self().for_each_half(h, visit);
    } else if (spirals_.empty()) {
      return;
    } else if (h.level == 0) {
      visit(self().root_region(static_cast<std::uint32_t>(h.index)));
    } else {
      const std::size_t size = boxes_.size_of_level(h.level - 1);
      for (std::size_t i = 2 * h.index; i < 2 * h.index + 2 && i < size; ++i) {
        Handle child{};
        child.level = h.level - 1;
        child.index = i;
        visit(child);
      }
    }
  }
  /// A box that holds the curve below h: as spirals are monotone in x and y, the box of two end points.
  /// CGAL::Bbox_2(), which holds no point, for the root of an empty tree.
  [[nodiscard]] CGAL::Bbox_2 box(const Handle& h) const {
    if (spirals_.empty()) return {};
    if (!h.is_region) return boxes_.box(h.level, h.index, [this](std::size_t i) { return box_of_spiral(i); });
    const Region_node n = self().node(h);
    return box_of_piece(spirals_[n.spiral], n.t0, n.t1);
  }
  /// The bounding region of a region node. \pre h.is_region
  [[nodiscard]] Region region(const Handle& h) const { return region(self().node(h)); }
  [[nodiscard]] Region region(const Region_node& n) const {
    return traits_.construct_bounding_region_2_object()(spirals_[n.spiral].template frame<typename Traits::FT>(
        n.t0, n.t1, shape_parts<typename Traits::Construction>()));
  }

  /// Depth first in curve order: descend(handle) says whether to go below, and sees leaves too.
  template <class Descend> void traverse(Descend&& descend) const {
    if (!spirals_.empty()) traverse_from(root(), descend);
  }
  /// Calls visit(node) for every leaf in curve order.
  template <class Visit> void for_each_leaf(Visit&& visit) const {
    traverse([&](const Handle& h) {
      if (self().is_leaf(h)) visit(self().node(h));
      return true;
    });
  }

 protected:
  Spiral_hierarchy(std::vector<Spiral> spirals, double eps, const Traits& traits, Instruction_set set)
      : traits_(traits), spirals_(std::move(spirals)), eps_(eps), decide_(traits, set) {
    if (!(eps > 0)) throw std::invalid_argument("eps must be positive");
  }
  // Boxes are made by join_boxes for all segments and join_levels; where nothing else is done with the segments, at
  // once.
  void join_boxes(std::size_t begin, std::size_t end) {
    boxes_.join_items(begin, end, [this](std::size_t i) { return box_of_spiral(i); });
  }
  template <class ConcurrencyTag = CGAL::Sequential_tag> void make_boxes() {
    boxes_ = Box_hierarchy(spirals_.size());
    internal::for_each_range<ConcurrencyTag>(spirals_.size(),
                                             [this](std::size_t begin, std::size_t end) { join_boxes(begin, end); });
    boxes_.join_levels();
  }

  /// The node of piece h.place of the 2^h.level equal ones of a segment.
  [[nodiscard]] Region_node grid_node(const Handle& h, bool is_leaf, bool with_thickness) const {
    const Spiral& s = spirals_[h.spiral];
    const Spiral_grid grid(s.first(), s.last());
    const filter::Batch_pieces piece = grid.pieces(h.level, h.place);
    const bool is_within =
        is_leaf && h.level < grid.levels();  // pieces at the last level may be leaves for want of room
    return {piece.begin(0), piece.end(0),
            with_thickness ? decide_.thickness(s, piece, filter::reachable(eps_, s), is_within) : 0.0, h.spiral,
            is_leaf};
  }

  Traits traits_;
  std::vector<Spiral> spirals_;
  double eps_;
  Piece_decisions<Traits, Spiral> decide_;
  Box_hierarchy boxes_;

 private:
  [[nodiscard]] const Derived& self() const { return static_cast<const Derived&>(*this); }
  [[nodiscard]] CGAL::Bbox_2 box_of_spiral(std::size_t i) const {
    return box_of_piece(spirals_[i], spirals_[i].first(), spirals_[i].last());
  }
  template <class Descend> void traverse_from(const Handle& h, Descend& descend) const {
    if (!descend(h)) return;
    for_each_child(h, [&](const Handle& child) { traverse_from(child, descend); });
  }
};

}  // namespace CGAL::Bounding_arcs

#endif
