// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The subtrees of halved segments in a row: a node is a bit, whether it is split, and parameters follow from its place.

#ifndef CGAL_BOUNDING_ARCS_2_TREE_INTERNAL_MIDPOINT_NODES_H
#define CGAL_BOUNDING_ARCS_2_TREE_INTERNAL_MIDPOINT_NODES_H

#include <CGAL/Bounding_arcs_2/tree/Region_node.h>
#include <CGAL/Bounding_arcs_2/tree/Region_nodes.h>
#include <CGAL/Bounding_arcs_2/tree/Spiral_grid.h>
#include <CGAL/Bounding_arcs_2/tree/subdivide.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace CGAL::Bounding_arcs::internal {

// The leaves of a halved segment in curve order. Nodes are kept level by level, and thickness varies slowly, so the
// leaves of a level are few runs of neighbours: these are put in order, not the leaves.

class Leaf_runs {
 public:
  /// Writes the parameters in which the leaves of a subtree end, from first to last of them.
  /// \param root its first node \param size how many it has \param ends room for as many as the subtree has leaves
  void write_ends(const Region_nodes& nodes, std::size_t root, std::size_t size, const Spiral_grid& grid, double* ends);

 private:
  struct Run {  // pieces begin, ..., end - 1 of a level
    std::uint64_t begin, end;
    int level;
    [[nodiscard]] std::uint64_t key() const { return begin << (Spiral_grid::MAX_LEVEL - level); }
  };
  void split(std::uint64_t word, int count, int level, std::uint64_t place);
  static void append(std::vector<Run>& runs, const Run& run);

  std::vector<Run> level_, halves_, leaves_;
};

class Midpoint_nodes {
 public:
  explicit Midpoint_nodes(bool keeps_thickness = false) : nodes_(keeps_thickness) {}

  [[nodiscard]] const Region_nodes& nodes() const { return nodes_; }
  [[nodiscard]] std::size_t number_of_leaves() const { return (nodes_.size() + bounds_.size()) / 2; }
  [[nodiscard]] std::size_t number_of_nodes() const { return nodes_.size(); }
  /// An upper bound of the thickness of the leaves of each segment.
  [[nodiscard]] const std::vector<double>& bounds() const { return bounds_; }
  [[nodiscard]] std::size_t bytes() const {
    return nodes_.bytes() + roots_.capacity() * sizeof(std::size_t) + bounds_.capacity() * sizeof(double);
  }

  /// Tells a decider which segments are added next.
  template <class Decider, class Spiral>
  void look_ahead(Decider& decide, const Spiral* first, std::size_t count, double eps) const {
    decide.look_ahead(first, count, eps, nodes_.keeps_thickness());
  }
  /// Appends a segment's subtree. \return false if there would be more than `limit` nodes
  template <class Decider, class Spiral>
  [[nodiscard]] bool add(Decider& decide, const Spiral& spiral, double eps, std::size_t limit,
                         Decision_counts& counts) {
    const Subdivision s = decide.subdivide(spiral, eps, limit, nodes_, counts);
    bounds_.push_back(s.bound);
    roots_.push_back(nodes_.size());
    return !s.is_over_limit;
  }
  /// Appends the subtrees of segments first, ..., last - 1 of another.
  void append(const Midpoint_nodes& other, std::size_t first, std::size_t last) {
    nodes_.append(other.nodes_, other.roots_[first], other.roots_[last]);
    append_segments(other, first, last);
  }
  /// Appends all of others, with Parallel_tag at once.
  template <class ConcurrencyTag> void append_all(const std::vector<Midpoint_nodes>& others) {
    nodes_.template append_all<ConcurrencyTag>(others.size(),
                                               [&](std::size_t i) -> const Region_nodes& { return others[i].nodes_; });
    for (const Midpoint_nodes& other : others) append_segments(other, 0, other.bounds_.size());
  }
  /// Completes the nodes; to be called when all are there.
  void complete() { nodes_.complete(); }

  [[nodiscard]] Node_handle root(std::uint32_t spiral) const {
    return {true, !nodes_.is_split(roots_[spiral]), 0, spiral, roots_[spiral], 0};
  }
  template <class Visit> void for_each_half(const Node_handle& h, const Visit& visit) const {
    // a subtree with n splits has 2n + 1 nodes, so (root - spiral) / 2 splits come before it
    const std::size_t root = roots_[h.spiral], splits = nodes_.splits_before(h.index) - (root - h.spiral) / 2;
    for (std::size_t i = 0; i < 2; ++i) {
      const std::size_t index = root + 2 * splits + 1 + i;
      visit(Node_handle{true, !nodes_.is_split(index), h.level + 1, h.spiral, index, 2 * h.place + i});
    }
  }

  [[nodiscard]] std::size_t number_of_leaves(std::size_t spiral) const {
    return (roots_[spiral + 1] - roots_[spiral] + 1) / 2;
  }
  /// Writes the parameters in which the leaves of a segment end.
  void write_ends(std::size_t spiral, const Spiral_grid& grid, Leaf_runs& runs, double* ends) const {
    runs.write_ends(nodes_, roots_[spiral], roots_[spiral + 1] - roots_[spiral], grid, ends);
  }

 private:
  void append_segments(const Midpoint_nodes& other, std::size_t first, std::size_t last) {
    const std::size_t begin = roots_.back() - other.roots_[first];  // modulo 2^64, as it may be negative
    for (std::size_t i = first; i < last; ++i) {
      roots_.push_back(other.roots_[i + 1] + begin);
      bounds_.push_back(other.bounds_[i]);
    }
  }

  Region_nodes nodes_;                 // segment by segment
  std::vector<std::size_t> roots_{0};  // the first node of each segment, and the number of nodes
  std::vector<double> bounds_;
};

}  // namespace CGAL::Bounding_arcs::internal

#endif
