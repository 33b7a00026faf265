// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The hierarchy of fewest leaves: each spiral segment is cut where all its regions are about as thick as eps allows,
// and the leaves are joined two by two, as evenly as their number lets.

#ifndef CGAL_BOUNDING_ARCS_2_TREE_OPTIMAL_BOUNDING_ARC_TREE_2_H
#define CGAL_BOUNDING_ARCS_2_TREE_OPTIMAL_BOUNDING_ARC_TREE_2_H

#include <CGAL/Bounding_arcs_2/tree/Bounding_arc_tree_2.h>
#include <CGAL/Bounding_arcs_2/tree/equalize_breaks.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL::Bounding_arcs {

/// A place in the hierarchy: a box over spirals, or a region node over neighbouring leaves of one segment.
struct Optimal_tree_handle {
  bool is_region = false;
  int level = 0;             ///< of a box; of a region how far below its segment
  std::size_t index = 0;     ///< of a box in its level; of a region its first leaf among those of all segments
  std::size_t leaves = 0;    ///< of a region
  std::uint32_t spiral = 0;  ///< of a region
};

/// The same traversal as Bounding_arc_tree_2.
/// \tparam Traits a model of BoundingRegionTraits_2
/// \tparam Spiral a model of SpiralSegment_2 over Traits::FT, such as Bezier_spiral_2<double>
template <class Traits, class Spiral>
class Optimal_bounding_arc_tree_2
    : public Spiral_hierarchy<Optimal_bounding_arc_tree_2<Traits, Spiral>, Traits, Spiral, Optimal_tree_handle> {
  using Base = Spiral_hierarchy<Optimal_bounding_arc_tree_2, Traits, Spiral, Optimal_tree_handle>;
  friend Base;

 public:
  using Handle = Optimal_tree_handle;

  /// \param eps the largest thickness of a leaf, in units of the coordinates, positive
  /// \param options those of Bounding_arc_tree_2; thickness is never kept
  /// \throws std::invalid_argument for an eps that is not positive
  /// \guarantee every leaf's thickness is at most eps unless status() says otherwise; that there are few is measured:
  ///   up to 1.03 N*(eps) and one more a segment, see equalize_breaks
  Optimal_bounding_arc_tree_2(std::vector<Spiral> spirals, double eps, const Traits& traits = Traits(),
                              const Build_options& options = {})
      : Base(std::move(spirals), eps, traits, options.instruction_set), measure_(traits, options.instruction_set) {
    first_leaf_.reserve(this->spirals_.size());
    Measured_breaks cut;
    for (const Spiral& s : this->spirals_) {
      first_leaf_.push_back(breaks_.size());
      const double reachable = filter::reachable(eps, s);
      guess(s, cut.breaks);
      const auto measure = [&](const std::vector<double>& breaks, std::vector<double>& measures) {
        evaluate(s, reachable, breaks, measures);
      };
      const bool within = equalize_breaks(cut, reachable, options.max_regions, measure) && eps >= reachable;
      if (!within) status_ = Build_status::RESOLUTION_REACHED;
      bound_ = (std::max)(bound_, *std::max_element(cut.measures.begin(), cut.measures.end()));
      breaks_.insert(breaks_.end(), cut.breaks.begin(), cut.breaks.end());
      foresee();
      if (number_of_nodes() > options.max_regions) {
        clear();
        return;
      }
      if (options.progress) options.progress(first_leaf_.size(), this->spirals_.size());
    }
    this->make_boxes();
  }

  [[nodiscard]] Build_status status() const { return status_; }
  /// The largest thickness of a leaf: what the build reached.
  [[nodiscard]] double bound() const { return bound_; }
  /// At which stage the thickness of each piece that was tried was decided against eps.
  [[nodiscard]] const Decision_counts& decisions() const { return counts_; }

  [[nodiscard]] std::size_t number_of_leaves() const { return breaks_.size() - first_leaf_.size(); }
  [[nodiscard]] std::size_t number_of_nodes() const { return 2 * number_of_leaves() - first_leaf_.size(); }
  /// Arcs of all leaves, as the paper's Table 1 counts them: 2 a region for BCA and SFA, 4 for bilens.
  [[nodiscard]] std::size_t number_of_arcs() const {
    return number_of_leaves() * Traits::Construction::ARCS_PER_REGION;
  }
  /// Bytes held by breaks and boxes, without the curves.
  [[nodiscard]] std::size_t bytes() const {
    return breaks_.capacity() * sizeof(double) + first_leaf_.capacity() * sizeof(std::size_t) + this->boxes_.bytes();
  }

  [[nodiscard]] bool is_leaf(const Handle& h) const { return h.is_region && h.leaves == 1; }
  /// \pre h.is_region
  [[nodiscard]] Region_node node(const Handle& h) const {
    const double ends[] = {breaks_[h.index], breaks_[h.index + h.leaves]};
    const Spiral& s = this->spirals_[h.spiral];
    const bool is_leaf = h.leaves == 1, is_within = is_leaf && status_ == Build_status::COMPLETE;
    return {
        ends[0], ends[1],
        this->decide_.thickness(s, filter::Batch_pieces::between(ends, 1), filter::reachable(this->eps_, s), is_within),
        h.spiral, is_leaf};
  }

 private:
  static constexpr int FIRST_LEVEL = 3;  // of the equal pieces that a segment is first cut into
  static void guess(const Spiral& s, std::vector<double>& breaks) {
    const Spiral_grid grid(s.first(), s.last());
    const int level = grid.levels() > FIRST_LEVEL ? FIRST_LEVEL : 0;
    const std::size_t count = std::size_t(1) << level;
    const filter::Batch_pieces pieces = grid.pieces(level, 0, count);
    breaks.clear();
    for (std::size_t i = 0; i < count; ++i) breaks.push_back(pieces.begin(static_cast<int>(i)));
    breaks.push_back(s.last());
  }
  // Makes room for the breaks of all segments when a part of them is done: memory that grows by doubling is copied, and
  // touched twice.
  void foresee() {
    constexpr std::size_t SAMPLE = 16;
    constexpr double MORE = 1.1;
    if (first_leaf_.size() == this->spirals_.size() / SAMPLE)
      breaks_.reserve(static_cast<std::size_t>(MORE * SAMPLE * static_cast<double>(breaks_.size())));
  }
  // Sets the thickness of every piece; infinity stands where none is known.
  void evaluate(const Spiral& s, double eps, const std::vector<double>& breaks, std::vector<double>& measures) {
    constexpr std::size_t AT_ONCE = filter::BATCH_SIZE;
    measures.resize((breaks.size() - 1 + AT_ONCE - 1) / AT_ONCE * AT_ONCE);
    for (std::size_t i = 0; i + 1 < breaks.size(); i += AT_ONCE) {
      const std::size_t count = (std::min)(breaks.size() - 1 - i, AT_ONCE);
      filter::Batch_pieces pieces = filter::Batch_pieces::between(breaks.data() + i, count);
      pieces.are_long = breaks.size() - 1 <= std::size_t(1) << FIRST_LEVEL;
      static_cast<void>(measure_(s, pieces, eps, measures.data() + i, counts_));
    }
    measures.resize(breaks.size() - 1);
  }

  [[nodiscard]] Handle root_region(std::uint32_t spiral) const {
    const std::size_t first = first_leaf_[spiral],
                      end = spiral + 1 < first_leaf_.size() ? first_leaf_[spiral + 1] : breaks_.size();
    return {true, 0, first, end - first - 1, spiral};
  }
  template <class Visit> void for_each_half(const Handle& h, Visit& visit) const {
    const std::size_t left = (h.leaves + 1) / 2;
    visit(Handle{true, h.level + 1, h.index, left, h.spiral});
    visit(Handle{true, h.level + 1, h.index + left, h.leaves - left, h.spiral});
  }
  void clear() {
    status_ = Build_status::REGION_LIMIT;
    this->spirals_.clear();
    breaks_.clear();
    first_leaf_.clear();
    bound_ = 0;
  }

  // Where breaks go depends on the bounds themselves, not on decisions only: with double's, exact kernels cut where
  // filtered do.
  Piece_decisions<Traits, Spiral, !std::is_floating_point_v<typename Traits::FT>> measure_;
  std::vector<double> breaks_;           // of each segment one more than it has leaves
  std::vector<std::size_t> first_leaf_;  // of each segment, in breaks_
  Decision_counts counts_;
  double bound_ = 0;
  Build_status status_ = Build_status::COMPLETE;
};

}  // namespace CGAL::Bounding_arcs

#endif
