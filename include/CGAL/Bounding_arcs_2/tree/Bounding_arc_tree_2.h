// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The hierarchy: boxes over spiral segments, and under each segment a binary tree of bounding regions, halved at the
// parameter midpoint until the thickness is at most eps.  A node is a bit, whether it is split: parameters follow from
// its place, thickness and region are made again from the curve when asked for.

#ifndef CGAL_BOUNDING_ARCS_2_TREE_BOUNDING_ARC_TREE_2_H
#define CGAL_BOUNDING_ARCS_2_TREE_BOUNDING_ARC_TREE_2_H

#include <CGAL/Bounding_arcs_2/filter/subdivide_spirals.h>
#include <CGAL/Bounding_arcs_2/tree/Spiral_hierarchy.h>

#include <CGAL/tags.h>

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
  std::size_t max_regions = 20'000'000;                    ///< nodes of all subtrees together
  std::function<void(std::size_t, std::size_t)> progress;  ///< called with spirals done and spirals in all
  /// Keep each node's thickness as it was bounded when the tree was built, 8 bytes, instead of computing it again, and
  /// more sharply, when it is asked for. Over exact number types, where that takes long, it is kept in any case.
  bool keep_thickness = false;
  Instruction_set instruction_set = Instruction_set::BEST;  ///< of batches; results do not depend on it
};

/// A place in the hierarchy: a box over spirals, or a region node.
struct Tree_handle {
  bool is_region = false;
  int level = 0;             ///< of a box; of a region how often its segment was halved
  std::size_t index = 0;     ///< of a box in its level, or of a region node
  std::uint64_t place = 0;   ///< of a region: piece `place` of the segment's 2^level
  std::uint32_t spiral = 0;  ///< of a region
};

/// \tparam Traits a model of BoundingRegionTraits_2
/// \tparam Spiral a model of SpiralSegment_2 over Traits::FT, such as Bezier_spiral_2<double>
/// \tparam ConcurrencyTag Parallel_tag builds in as many threads as TBB gives; the tree is the same
template <class Traits, class Spiral, class ConcurrencyTag = CGAL::Sequential_tag>
class Bounding_arc_tree_2
    : public Spiral_hierarchy<Bounding_arc_tree_2<Traits, Spiral, ConcurrencyTag>, Traits, Spiral, Tree_handle> {
  using Base = Spiral_hierarchy<Bounding_arc_tree_2, Traits, Spiral, Tree_handle>;
  friend Base;

 public:
  using Handle = Tree_handle;

  /// \param eps the largest thickness of a leaf, in units of the coordinates, positive
  /// \throws std::invalid_argument for an eps that is not positive
  /// \complexity linear in the number of nodes, about 2.8 N*(eps)
  Bounding_arc_tree_2(std::vector<Spiral> spirals, double eps, const Traits& traits = Traits(),
                      const Build_options& options = {})
      : Base(std::move(spirals), eps, traits, options.instruction_set), max_nodes_(options.max_regions),
        nodes_(options.keep_thickness || !std::is_floating_point_v<typename Traits::FT>) {
    boxes_ = Box_hierarchy(spirals_.size());
    insert(
        0, spirals_.size(), [this](std::size_t i, std::size_t j) { this->join_boxes(i, j); }, options.progress);
    if (finish()) boxes_.join_levels();
  }

  /// Puts other segments in the place of segments first, ..., last - 1, after control points were moved, say. All
  /// others keep their subtrees. What is then more than allowed leaves the tree empty, as when it is built.
  /// \throws std::out_of_range unless first <= last <= the number of segments
  void replace(std::size_t first, std::size_t last, std::vector<Spiral> spirals) {
    if (first > last || last > spirals_.size()) throw std::out_of_range("no such range of spiral segments");
    if (status_ == Build_status::REGION_LIMIT)
      status_ = Build_status::COMPLETE;  // nothing is left of what was too much
    const internal::Region_nodes old = std::move(nodes_);
    const std::vector<std::size_t> roots = std::move(roots_);
    nodes_ = internal::Region_nodes(old.keeps_thickness());
    roots_.clear();
    const auto place = [&](std::size_t i) { return spirals_.begin() + static_cast<std::ptrdiff_t>(i); };
    spirals_.erase(place(first), place(last));
    spirals_.insert(place(first), spirals.begin(), spirals.end());
    nodes_.append(old, 0, roots[first]);
    roots_.assign(roots.begin(), roots.begin() + static_cast<std::ptrdiff_t>(first));
    insert(first, first + spirals.size(), [](std::size_t, std::size_t) {}, {});
    const std::size_t moved = nodes_.size() - roots[last];  // modulo 2^64, as it may be negative
    roots_.pop_back();
    for (std::size_t i = last; i < roots.size(); ++i) roots_.push_back(roots[i] + moved);
    nodes_.append(old, roots[last], old.size());
    if (finish()) this->template make_boxes<ConcurrencyTag>();
  }

  [[nodiscard]] Build_status status() const { return status_; }
  /// What the build reached: no leaf is thicker, and the thickest one is thinner by a few per cent at most, which quick
  /// looks do not tell. At most eps when status() is COMPLETE. After `replace`, of all leaves there ever were.
  [[nodiscard]] double bound() const { return bound_; }
  /// At which stage the thickness of each node was decided against eps.
  [[nodiscard]] const Decision_counts& decisions() const { return counts_; }

  [[nodiscard]] std::size_t number_of_leaves() const { return (nodes_.size() + spirals_.size()) / 2; }
  [[nodiscard]] std::size_t number_of_nodes() const { return nodes_.size(); }
  /// Arcs of all leaves, as the paper's Table 1 counts them: 2 a region for BCA and SFA, 4 for bilens.
  [[nodiscard]] std::size_t number_of_arcs() const {
    return number_of_leaves() * Traits::Construction::ARCS_PER_REGION;
  }
  /// Bytes held by nodes, boxes and roots, without the curves.
  [[nodiscard]] std::size_t bytes() const {
    return nodes_.bytes() + boxes_.bytes() + roots_.capacity() * sizeof(std::size_t);
  }

  [[nodiscard]] bool is_leaf(const Handle& h) const { return h.is_region && !nodes_.is_split(h.index); }
  /// \pre h.is_region
  [[nodiscard]] Region_node node(const Handle& h) const {
    const Region_node n = this->grid_node(h, !nodes_.is_split(h.index), !nodes_.keeps_thickness());
    return {n.t0, n.t1, nodes_.keeps_thickness() ? nodes_.thickness(h.index) : n.thickness, n.spiral, n.is_leaf};
  }

 private:
  using Base::boxes_;
  using Base::spirals_;

  [[nodiscard]] Handle root_region(std::uint32_t spiral) const { return {true, 0, roots_[spiral], 0, spiral}; }
  template <class Visit> void for_each_half(const Handle& h, Visit& visit) const {
    // a subtree with n splits has 2n + 1 nodes, so (root - spiral) / 2 splits come before it
    const std::size_t root = roots_[h.spiral], splits = nodes_.splits_before(h.index) - (root - h.spiral) / 2;
    for (std::size_t i = 0; i < 2; ++i)
      visit(Handle{true, h.level + 1, root + 2 * splits + 1 + i, 2 * h.place + i, h.spiral});
  }

  // Appends the subtrees of segments begin, ..., end - 1 and, as one more root, the end of them.
  template <class Done>
  void insert(std::size_t begin, std::size_t end, const Done& done,
              const std::function<void(std::size_t, std::size_t)>& progress) {
    const filter::Subdivision_result r = filter::subdivide_spirals<ConcurrencyTag>(
        this->decide_, spirals_, begin, end, this->eps_, max_nodes_, nodes_, roots_, done, progress);
    counts_.add(r.counts);
    bound_ = (std::max)(bound_, r.bound);
    if (r.is_resolution_reached) status_ = Build_status::RESOLUTION_REACHED;
    if (r.is_over_limit) status_ = Build_status::REGION_LIMIT;
  }
  // To be called when all subtrees are there; empties a tree of more nodes than allowed and returns false.
  bool finish() {
    if (status_ != Build_status::REGION_LIMIT && nodes_.size() <= max_nodes_) {
      nodes_.template complete<ConcurrencyTag>();
      return true;
    }
    status_ = Build_status::REGION_LIMIT;
    nodes_ = internal::Region_nodes(nodes_.keeps_thickness());
    roots_.assign(1, 0);
    spirals_.clear();
    boxes_ = Box_hierarchy();
    bound_ = 0;
    return false;
  }

  std::size_t max_nodes_;
  internal::Region_nodes nodes_;    // segment by segment
  std::vector<std::size_t> roots_;  // the first node of each segment, and the number of nodes
  Decision_counts counts_;
  double bound_ = 0;
  Build_status status_ = Build_status::COMPLETE;
};

}  // namespace CGAL::Bounding_arcs

#endif
