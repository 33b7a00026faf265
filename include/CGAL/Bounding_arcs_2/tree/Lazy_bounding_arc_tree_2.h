// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The hierarchy without its nodes: only the segments and the boxes over them are kept, and regions are made and halved
// as a traversal goes below.  A query that sees few nodes pays for those alone.

#ifndef CGAL_BOUNDING_ARCS_2_TREE_LAZY_BOUNDING_ARC_TREE_2_H
#define CGAL_BOUNDING_ARCS_2_TREE_LAZY_BOUNDING_ARC_TREE_2_H

#include <CGAL/Bounding_arcs_2/filter/Midpoint_subdivision.h>
#include <CGAL/Bounding_arcs_2/tree/Spiral_hierarchy.h>

#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace CGAL::Bounding_arcs {

/// A place in a lazy hierarchy: a box over spirals, or a region node.
struct Lazy_tree_handle {
  bool is_region = false;
  int level = 0;             ///< of a box; of a region how often its segment was halved
  std::size_t index = 0;     ///< of a box in its level
  std::uint64_t place = 0;   ///< of a region: piece `place` of the segment's 2^level
  std::uint32_t spiral = 0;  ///< of a region
  bool is_split = false;     ///< of a region
};

/// The same traversal as Bounding_arc_tree_2, and the same nodes.
/// \tparam Traits a model of BoundingRegionTraits_2
/// \tparam Spiral a model of SpiralSegment_2 over Traits::FT, such as Bezier_spiral_2<double>
template <class Traits, class Spiral>
class Lazy_bounding_arc_tree_2
    : public Spiral_hierarchy<Lazy_bounding_arc_tree_2<Traits, Spiral>, Traits, Spiral, Lazy_tree_handle> {
  using Base = Spiral_hierarchy<Lazy_bounding_arc_tree_2, Traits, Spiral, Lazy_tree_handle>;
  friend Base;

 public:
  using Handle = Lazy_tree_handle;

  /// \param eps the largest thickness of a leaf, in units of the coordinates, positive
  /// \throws std::invalid_argument for an eps that is not positive
  /// \complexity linear in the number of segments
  Lazy_bounding_arc_tree_2(std::vector<Spiral> spirals, double eps, const Traits& traits = Traits(),
                           Instruction_set set = Instruction_set::BEST)
      : Base(std::move(spirals), eps, traits, set) {
    this->make_boxes();
  }

  [[nodiscard]] bool is_leaf(const Handle& h) const { return h.is_region && !h.is_split; }
  /// \pre h.is_region
  [[nodiscard]] Region_node node(const Handle& h) const { return this->grid_node(h, !h.is_split, true); }

 private:
  [[nodiscard]] Handle root_region(std::uint32_t spiral) const {
    Handle root;
    const auto keep = [&](const Handle& h) { root = h; };
    visit_pieces(spiral, 0, 0, 1, keep);
    return root;
  }
  template <class Visit> void for_each_half(const Handle& h, Visit& visit) const {
    visit_pieces(h.spiral, h.level + 1, 2 * h.place, 2, visit);
  }

  template <class Visit>
  void visit_pieces(std::uint32_t spiral, int level, std::uint64_t place, std::size_t count, Visit& visit) const {
    const Spiral& s = this->spirals_[spiral];
    const Spiral_grid grid(s.first(), s.last());
    Decision_counts ignored;
    const Piece_decision d =
        this->decide_(s, grid.pieces(level, place, count), filter::reachable(this->eps_, s), nullptr, ignored);
    for (std::size_t i = 0; i < count; ++i)
      visit(Handle{true, level, 0, place + i, spiral, ((d.above >> i) & 1) != 0 && level < grid.levels()});
  }
};

}  // namespace CGAL::Bounding_arcs

#endif
