// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The hierarchy: boxes over spiral segments, and under each segment a binary tree of bounding regions whose leaves are
// at most eps thick.  A node is a piece of a segment; box, thickness and region are made from the curve when asked for.

#ifndef CGAL_BOUNDING_ARCS_2_TREE_BOUNDING_ARC_TREE_2_H
#define CGAL_BOUNDING_ARCS_2_TREE_BOUNDING_ARC_TREE_2_H

#include <CGAL/Bounding_arcs_2/filter/Default_decider.h>
#include <CGAL/Bounding_arcs_2/internal/tree/Equalized_leaves.h>
#include <CGAL/Bounding_arcs_2/internal/tree/Midpoint_nodes.h>
#include <CGAL/Bounding_arcs_2/internal/tree/build_subtrees.h>
#include <CGAL/Bounding_arcs_2/tree/Box_hierarchy.h>
#include <CGAL/Bounding_arcs_2/tree/box_of_piece.h>

#include <CGAL/tags.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <iterator>
#include <optional>
#include <stdexcept>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL::Bounding_arcs {

/// \tparam Traits a model of BoundingRegionTraits_2
/// \tparam Spiral a model of SpiralSegment_2 over Traits::FT, such as Bezier_spiral_2<double>
/// \tparam Decider a model of PieceDecider: Plain_decider<Traits, Spiral> decides pieces one by one, by default a
///   filter does so many at a time where there is one; the tree is the same
template <class Traits_, class Spiral_, class Decider = Default_decider<Traits_, Spiral_>> class Bounding_arc_tree_2 {
 public:
  using Traits = Traits_;
  using Spiral = Spiral_;
  using Handle = Node_handle;
  using Region = typename Traits::Bounding_region_2;

  /// \param eps the largest thickness of a leaf, in units of the coordinates, positive
  /// \param concurrency CGAL::Parallel_tag() builds in as many threads as TBB gives; the tree is the same
  /// \throws std::invalid_argument for an eps that is not positive
  /// \guarantee every leaf's thickness is at most bound(), and that at most eps unless status() says otherwise; that
  ///   equalised leaves are few is measured: up to 1.03 N*(eps) and one more a segment, see equalize_breaks
  /// \complexity linear in the number of nodes, about 2.8 N*(eps) of stored ones; in that of segments for lazy ones
  template <class ConcurrencyTag = CGAL::Sequential_tag>
  Bounding_arc_tree_2(std::vector<Spiral> spirals, double eps, const Build_options& options = {},
                      const Traits& traits = Traits(), ConcurrencyTag concurrency = {})
      : traits_(traits), eps_(eps), options_(options), decide_(traits, options.instruction_set) {
    if (!(eps > 0)) throw std::invalid_argument("eps must be positive");
    midpoints_ = internal::Midpoint_nodes(options_.keep_thickness);
    replace(0, 0, std::move(spirals), concurrency);
    options_.progress = {};
  }

  /// Puts other segments in the place of segments first, ..., last - 1, after control points were moved, say. All
  /// others keep their subtrees. What is then more than allowed leaves the tree empty, as when it is built.
  /// \throws std::out_of_range unless first <= last <= the number of segments
  template <class ConcurrencyTag = CGAL::Sequential_tag>
  void replace(std::size_t first, std::size_t last, std::vector<Spiral> spirals, ConcurrencyTag = {}) {
    if (first > last || last > spirals_.size()) throw std::out_of_range("no such range of spiral segments");
    const std::size_t end = first + spirals.size();
    if (spirals_.empty()) {
      spirals_ = std::move(spirals);
    } else {
      spirals_.erase(at(first), at(last));
      spirals_.insert(at(first), std::make_move_iterator(spirals.begin()), std::make_move_iterator(spirals.end()));
    }
    if (options_.nodes == Node_kind::STORED)
      rebuild<ConcurrencyTag>(midpoints_, internal::Midpoint_nodes(options_.keep_thickness), first, last, end);
    if (options_.nodes == Node_kind::EQUALIZED)
      rebuild<ConcurrencyTag>(leaves_, internal::Equalized_leaves(), first, last, end);
    boxes_ = Box_hierarchy(spirals_.size());
    internal::for_each_range<ConcurrencyTag>(spirals_.size(), [this](std::size_t i, std::size_t j) {
      boxes_.join_items(i, j, [this](std::size_t k) { return box_of_spiral(k); });
    });
    boxes_.join_levels();
  }

  /// COMPLETE where bound() is at most eps.
  [[nodiscard]] Build_status status() const {
    if (is_over_limit_) return Build_status::REGION_LIMIT;
    return bound() <= eps_ ? Build_status::COMPLETE : Build_status::RESOLUTION_REACHED;
  }
  /// No leaf is thicker, and the thickest one is thinner by a few per cent at most, which quick looks do not tell. Of
  /// lazy nodes eps, or the least thickness that coordinates resolve: what leaves will have but where parameters have
  /// no room for as many halvings as that takes. 0 of an empty tree.
  /// \complexity linear in the number of segments
  [[nodiscard]] double bound() const {
    double bound = 0;
    if (options_.nodes == Node_kind::LAZY)
      for (const Spiral& s : spirals_) bound = (std::max)(bound, reachable(eps_, s));
    for (const auto* bounds : {&midpoints_.bounds(), &leaves_.bounds()})
      for (const double b : *bounds) bound = (std::max)(bound, b);
    return bound;
  }
  /// At which stage the thickness of the pieces that were tried in building was decided against eps.
  [[nodiscard]] const Decision_counts& decisions() const { return counts_; }

  [[nodiscard]] const Traits& traits() const { return traits_; }
  [[nodiscard]] const std::vector<Spiral>& spirals() const { return spirals_; }
  /// Of region nodes that are kept: none of lazy ones.
  [[nodiscard]] std::size_t number_of_leaves() const {
    return midpoints_.number_of_leaves() + leaves_.number_of_leaves();
  }
  [[nodiscard]] Node_kind nodes() const { return options_.nodes; }
  /// Of one segment's region nodes that are kept.
  [[nodiscard]] std::size_t number_of_leaves(std::size_t spiral) const {
    if (options_.nodes == Node_kind::STORED) return midpoints_.number_of_leaves(spiral);
    return options_.nodes == Node_kind::EQUALIZED ? leaves_.number_of_leaves(spiral) : 0;
  }
  /// Writes the parameters in which the leaves of a segment end, in curve order.
  /// \param runs room to work in \param ends room for as many as there are leaves
  /// \pre nodes() != Node_kind::LAZY
  void write_leaf_ends(std::size_t spiral, internal::Leaf_runs& runs, double* ends) const {
    if (options_.nodes == Node_kind::EQUALIZED) return leaves_.write_ends(spiral, ends);
    midpoints_.write_ends(spiral, Spiral_grid(spirals_[spiral].first(), spirals_[spiral].last()), runs, ends);
  }
  [[nodiscard]] std::size_t number_of_nodes() const { return midpoints_.number_of_nodes() + leaves_.number_of_nodes(); }
  [[nodiscard]] std::size_t number_of_boxes() const { return boxes_.size(); }
  /// Arcs of all leaves, as the paper's Table 1 counts them: 2 a region for BCA and SFA, 4 for bilens.
  [[nodiscard]] std::size_t number_of_arcs() const {
    return number_of_leaves() * Traits::Construction::ARCS_PER_REGION;
  }
  /// Bytes held by nodes and boxes, without the curves.
  [[nodiscard]] std::size_t bytes() const { return midpoints_.bytes() + leaves_.bytes() + boxes_.bytes(); }

  /// The box over everything; of an empty tree it is empty, too, and has no children.
  [[nodiscard]] Node_handle root() const {
    Node_handle h;
    h.level = boxes_.top_level();
    return h;
  }
  /// The region node over a whole segment.
  [[nodiscard]] Node_handle segment_root(std::uint32_t spiral) const {
    if (options_.nodes == Node_kind::STORED) return midpoints_.root(spiral);
    if (options_.nodes == Node_kind::EQUALIZED) return leaves_.root(spiral);
    Node_handle root;
    visit_pieces(spiral, 0, 0, 1, [&](const Node_handle& h) { root = h; });
    return root;
  }
  [[nodiscard]] bool is_leaf(const Node_handle& h) const { return h.is_leaf; }
  /// Calls visit(child) for each of the children in curve order: one or two, none of a leaf or an empty tree's root.
  template <class Visit> void for_each_child(const Node_handle& h, Visit&& visit) const {
    if (spirals_.empty() || h.is_leaf) return;
    if (h.is_region) {
      if (options_.nodes == Node_kind::STORED) midpoints_.for_each_half(h, visit);
      else if (options_.nodes == Node_kind::EQUALIZED) leaves_.for_each_half(h, visit);
      else visit_pieces(h.spiral, h.level + 1, 2 * h.place, 2, visit);
    } else if (h.level == 0) {
      visit(segment_root(static_cast<std::uint32_t>(h.index)));
    } else {
      Node_handle child;
      child.level = h.level - 1;
      const std::size_t size = boxes_.size_of_level(child.level);
      for (child.index = 2 * h.index; child.index < 2 * h.index + 2 && child.index < size; ++child.index) visit(child);
    }
  }
  /// Depth first in curve order: descend(handle) says whether to go below, and sees leaves too.
  template <class Descend> void traverse(Descend&& descend) const {
    if (!spirals_.empty()) traverse_from(root(), descend);
  }
  /// Calls visit(handle) for every leaf in curve order.
  template <class Visit> void for_each_leaf(Visit&& visit) const {
    traverse([&](const Node_handle& h) {
      if (h.is_leaf) visit(h);
      return true;
    });
  }

  /// \pre h.is_region
  [[nodiscard]] Region_node node(const Node_handle& h) const {
    if (options_.nodes == Node_kind::EQUALIZED) return {leaves_.begin(h), leaves_.end(h), h.spiral, h.is_leaf};
    const Spiral_grid grid(spirals_[h.spiral].first(), spirals_[h.spiral].last());
    return {grid.parameter(h.level, h.place), grid.parameter(h.level, h.place + 1), h.spiral, h.is_leaf};
  }
  /// A box that holds the curve below h: as spirals are monotone in x and y, the box of two end points.
  /// CGAL::Bbox_2(), which holds no point, for the root of an empty tree.
  [[nodiscard]] CGAL::Bbox_2 box(const Node_handle& h) const {
    if (spirals_.empty()) return {};
    if (!h.is_region) return boxes_.box(h.level, h.index, [this](std::size_t i) { return box_of_spiral(i); });
    const Region_node n = node(h);
    return box_of_piece(spirals_[n.spiral], n.t0, n.t1);
  }
  /// The thickness of a region node's exact region rounded up, at most 16 ulp above; what was kept may be 2^-24 above.
  /// \pre h.is_region
  [[nodiscard]] double thickness(const Node_handle& h) const {
    if (options_.nodes == Node_kind::STORED && options_.keep_thickness) return midpoints_.nodes().thickness(h.index);
    const Region_node n = node(h);
    const Spiral& s = spirals_[n.spiral];
    const double eps = reachable(eps_, s);
    std::optional<double> sharp;
    if constexpr (has_accurate_shape_v<Spiral>) sharp = sharp_thickness(traits_.construction(), s, n.t0, n.t1);
    const double upper =
        sharp ? *sharp : traits_.bound_thickness_2_object()(Spiral_piece<Spiral>{s, n.t0, n.t1}, eps).upper;
    return h.is_leaf && is_decided_within(h, eps) ? (std::min)(upper, eps) : upper;
  }
  /// The bounding region of a region node. \pre h.is_region
  [[nodiscard]] Region region(const Node_handle& h) const { return region(node(h)); }
  [[nodiscard]] Region region(const Region_node& n) const {
    return traits_.construct_bounding_region_2_object()(spirals_[n.spiral].template frame<typename Traits::FT>(
        n.t0, n.t1, shape_parts<typename Traits::Construction>()));
  }

 private:
  [[nodiscard]] auto at(std::size_t i) { return spirals_.begin() + static_cast<std::ptrdiff_t>(i); }
  [[nodiscard]] CGAL::Bbox_2 box_of_spiral(std::size_t i) const {
    return box_of_piece(spirals_[i], spirals_[i].first(), spirals_[i].last());
  }
  template <class Descend> void traverse_from(const Node_handle& h, Descend& descend) const {
    if (!descend(h)) return;
    for_each_child(h, [&](const Node_handle& child) { traverse_from(child, descend); });
  }
  // Pieces at the last level may be leaves for want of room.
  [[nodiscard]] bool is_decided_within(const Node_handle& h, double eps) const {
    if (options_.nodes == Node_kind::EQUALIZED) return leaves_.bounds()[h.spiral] <= eps;
    return h.level < Spiral_grid(spirals_[h.spiral].first(), spirals_[h.spiral].last()).levels();
  }
  template <class Visit>
  void visit_pieces(std::uint32_t spiral, int level, std::uint64_t place, unsigned count, const Visit& visit) const {
    const Spiral& s = spirals_[spiral];
    const bool is_last = level == Spiral_grid(s.first(), s.last()).levels();
    const unsigned thick = is_last ? 0 : decide_.are_thick(s, level, place, count, reachable(eps_, s));
    for (unsigned i = 0; i < count; ++i) visit(Node_handle{true, (thick >> i & 1) == 0, level, spiral, 0, place + i});
  }

  // Makes the subtrees of segments first, ..., end - 1, and keeps those of the nodes before for what was before `first`
  // and from `last` on. Empties a tree of more nodes than allowed.
  template <class ConcurrencyTag, class Nodes>
  void rebuild(Nodes& nodes, Nodes empty, std::size_t first, std::size_t last, std::size_t end) {
    Nodes all = empty;
    all.append(nodes, 0, first);
    const std::size_t count = nodes.bounds().size();
    if (internal::build_subtrees<ConcurrencyTag>(decide_, spirals_, first, end, eps_, options_, empty, all, counts_)) {
      all.append(nodes, last, count);
      is_over_limit_ = all.number_of_nodes() > options_.max_nodes;
    } else {
      is_over_limit_ = true;
    }
    if (is_over_limit_) {
      spirals_.clear();
      all = empty;
    }
    all.template complete<ConcurrencyTag>();
    nodes = std::move(all);
  }

  Traits traits_;
  std::vector<Spiral> spirals_;
  double eps_;
  Build_options options_;
  Decider decide_;
  Box_hierarchy boxes_;
  internal::Midpoint_nodes midpoints_;  // empty but for stored nodes
  internal::Equalized_leaves leaves_;   // empty but for equalised nodes
  Decision_counts counts_;
  bool is_over_limit_ = false;
};

}  // namespace CGAL::Bounding_arcs

#endif
