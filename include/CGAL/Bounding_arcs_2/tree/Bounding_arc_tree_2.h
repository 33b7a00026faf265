// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The hierarchy: boxes over spiral segments, and under each segment a binary tree of bounding regions, halved at the
// parameter midpoint until the thickness is at most eps.  A node keeps its thickness; parameters follow from its place, and
// its region is made again from the curve when asked for.

#ifndef CGAL_BOUNDING_ARCS_2_TREE_BOUNDING_ARC_TREE_2_H
#define CGAL_BOUNDING_ARCS_2_TREE_BOUNDING_ARC_TREE_2_H

#include <CGAL/Bounding_arcs_2/tree/Box_hierarchy.h>
#include <CGAL/Bounding_arcs_2/tree/Midpoint_subdivision.h>
#include <CGAL/Bounding_arcs_2/tree/box_of_piece.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <stdexcept>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL::Bounding_arcs {

/// How a build ended.
enum class Build_status {
  COMPLETE,            ///< every leaf's thickness is at most eps
  RESOLUTION_REACHED,  ///< eps is below what coordinates or parameters resolve; see Bounding_arc_tree_2::bound
  REGION_LIMIT         ///< more regions than allowed would be needed; the tree is empty
};

struct Build_options {
  std::size_t max_regions = 20'000'000;  ///< nodes of all subtrees together
  std::function<void(std::size_t, std::size_t)> progress;  ///< called with spirals done and spirals in all
  /// Keep each node's thickness, 8 bytes, instead of computing it again when it is asked for. Over exact number types,
  /// where that takes long, it is kept in any case.
  bool keep_thickness = false;
  Instruction_set instruction_set = Instruction_set::BEST;  ///< of batches; results do not depend on it
};

/// One node of a subtree: a piece [t0, t1] of a spiral segment.
struct Region_node {
  double t0, t1;
  double thickness;      ///< at least the thickness of the piece's region
  std::uint32_t spiral;  ///< the index of the spiral segment
  bool is_leaf;
};

/// \tparam Traits a model of BoundingRegionTraits_2
/// \tparam Spiral a model of SpiralSegment_2 over Traits::FT, such as Bezier_spiral_2<double>
template <class Traits_, class Spiral_>
class Bounding_arc_tree_2 {
 public:
  using Traits = Traits_;
  using Spiral = Spiral_;
  using Region = typename Traits::Bounding_region_2;

  /// A place in the hierarchy: a box over spirals, or a region node.
  struct Handle {
    bool is_region = false;
    int level = 0;             ///< of a box; of a region how often its segment was halved
    std::size_t index = 0;     ///< of a box in its level, or of a region node
    std::uint64_t place = 0;   ///< of a region: piece `place` of the segment's 2^level
    std::uint32_t spiral = 0;  ///< of a region
  };

  /// \param eps the largest thickness of a leaf, in units of the coordinates, positive
  /// \throws std::invalid_argument for an eps that is not positive
  /// \complexity linear in the number of nodes, about 2.8 N*(eps)
  Bounding_arc_tree_2(std::vector<Spiral> spirals, double eps, const Traits& traits = Traits(),
                      const Build_options& options = {})
      : traits_(traits), spirals_(std::move(spirals)), eps_(eps), decide_(traits, options.instruction_set) {
    if (!(eps > 0)) throw std::invalid_argument("eps must be positive");
    const bool keeps_thickness = options.keep_thickness || !std::is_floating_point_v<typename Traits::FT>;
    internal::Midpoint_subdivision<Traits, Spiral> subdivision(decide_, eps, options.max_regions, keeps_thickness);
    for (const Spiral& s : spirals_) {
      roots_.push_back(subdivision.nodes().size());
      subdivision.add(s);
      if (subdivision.is_over_limit()) {
        *this = Bounding_arc_tree_2(traits, Build_status::REGION_LIMIT);
        return;
      }
      if (options.progress) options.progress(roots_.size(), spirals_.size());
    }
    nodes_ = std::move(subdivision.nodes());
    nodes_.complete();
    counts_ = subdivision.counts();
    bound_ = subdivision.bound();
    if (subdivision.is_resolution_reached()) status_ = Build_status::RESOLUTION_REACHED;
    std::vector<CGAL::Bbox_2> boxes;
    for (const Spiral& s : spirals_) boxes.push_back(box_of_piece(s, s.first(), s.last()));
    boxes_ = Box_hierarchy(std::move(boxes));
  }

  [[nodiscard]] Build_status status() const { return status_; }
  /// The largest thickness of a leaf: what the build reached.
  [[nodiscard]] double bound() const { return bound_; }
  [[nodiscard]] const Traits& traits() const { return traits_; }
  [[nodiscard]] const std::vector<Spiral>& spirals() const { return spirals_; }
  /// At which stage the thickness of each node was decided against eps.
  [[nodiscard]] const Decision_counts& decisions() const { return counts_; }

  [[nodiscard]] std::size_t number_of_leaves() const { return (nodes_.size() + spirals_.size()) / 2; }
  [[nodiscard]] std::size_t number_of_nodes() const { return nodes_.size(); }
  [[nodiscard]] std::size_t number_of_boxes() const { return boxes_.size(); }
  /// Arcs of all leaves, as the paper's Table 1 counts them: 2 a region for BCA and SFA, 4 for bilens.
  [[nodiscard]] std::size_t number_of_arcs() const { return number_of_leaves() * Traits::Construction::ARCS_PER_REGION; }
  /// Bytes held by nodes, boxes and roots, without the curves.
  [[nodiscard]] std::size_t bytes() const {
    return nodes_.bytes() + boxes_.bytes() + roots_.capacity() * sizeof(std::size_t);
  }

  /// \pre there is at least one spiral
  [[nodiscard]] Handle root() const { return {false, static_cast<int>(boxes_.levels()) - 1, 0, 0, 0}; }
  [[nodiscard]] bool is_leaf(const Handle& h) const { return h.is_region && !nodes_.is_split(h.index); }
  /// \pre h.is_region
  [[nodiscard]] Region_node node(const Handle& h) const {
    const Spiral& s = spirals_[h.spiral];
    const Spiral_grid grid(s.first(), s.last());
    const internal::Batch_pieces piece = grid.pieces(h.level, h.place);
    return {piece[0], piece[1], thickness(h, piece), h.spiral, !nodes_.is_split(h.index)};
  }
  /// Calls visit(child) for each of the one or two children in curve order.
  template <class Visit>
  void for_each_child(const Handle& h, Visit&& visit) const {
    if (h.is_region) {
      if (is_leaf(h)) return;
      const std::size_t root = roots_[h.spiral], splits_before = nodes_.splits_before(h.index) - (root - h.spiral) / 2;
      const std::size_t child = root + 2 * splits_before + 1;
      visit(Handle{true, h.level + 1, child, 2 * h.place, h.spiral});
      visit(Handle{true, h.level + 1, child + 1, 2 * h.place + 1, h.spiral});
    } else if (h.level == 0) {
      visit(Handle{true, 0, roots_[h.index], 0, static_cast<std::uint32_t>(h.index)});
    } else {
      visit(Handle{false, h.level - 1, 2 * h.index, 0, 0});
      if (2 * h.index + 1 < boxes_.size_of_level(static_cast<std::size_t>(h.level) - 1)) visit(Handle{false, h.level - 1, 2 * h.index + 1, 0, 0});
    }
  }

  /// A box that holds the curve below h: as spirals are monotone in x and y, the box of two end points.
  [[nodiscard]] CGAL::Bbox_2 box(const Handle& h) const {
    if (!h.is_region) return boxes_.box(static_cast<std::size_t>(h.level), h.index);
    const Region_node n = node(h);
    return box_of_piece(spirals_[n.spiral], n.t0, n.t1);
  }
  /// The bounding region of a region node. \pre h.is_region
  [[nodiscard]] Region region(const Handle& h) const { return region(node(h)); }
  [[nodiscard]] Region region(const Region_node& n) const {
    return traits_.construct_bounding_region_2_object()(
        spirals_[n.spiral].template frame<typename Traits::FT>(n.t0, n.t1, internal::shape_parts<typename Traits::Construction>()));
  }

  /// Depth first in curve order: descend(handle) says whether to go below, and sees leaves too.
  template <class Descend>
  void traverse(Descend&& descend) const {
    if (!spirals_.empty()) traverse_from(root(), descend);
  }
  /// Calls visit(node) for every leaf in curve order.
  template <class Visit>
  void for_each_leaf(Visit&& visit) const {
    traverse([&](const Handle& h) {
      if (is_leaf(h)) visit(node(h));
      return true;
    });
  }

 private:
  Bounding_arc_tree_2(const Traits& traits, Build_status status)
      : traits_(traits), decide_(traits, Instruction_set::BEST), status_(status) {}

  [[nodiscard]] double thickness(const Handle& h, const internal::Batch_pieces& piece) const {
    if (nodes_.keeps_thickness()) return nodes_.thickness(h.index);
    const Spiral& s = spirals_[h.spiral];
    return decide_.thickness(s, piece, internal::reachable(eps_, s));
  }

  template <class Descend>
  void traverse_from(const Handle& h, Descend& descend) const {
    if (!descend(h)) return;
    for_each_child(h, [&](const Handle& child) { traverse_from(child, descend); });
  }

  Traits traits_;
  std::vector<Spiral> spirals_;
  double eps_ = 0, bound_ = 0;
  Piece_decisions<Traits, Spiral> decide_;
  internal::Region_nodes nodes_;     // segment by segment
  std::vector<std::size_t> roots_;   // the first node of each segment
  Box_hierarchy boxes_;
  Decision_counts counts_;
  Build_status status_ = Build_status::COMPLETE;
};

}  // namespace CGAL::Bounding_arcs

#endif
