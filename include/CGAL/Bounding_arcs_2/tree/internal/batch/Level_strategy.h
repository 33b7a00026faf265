// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Subtrees, level by level.

#ifndef CGAL_BOUNDING_ARCS_2_TREE_INTERNAL_BATCH_LEVEL_STRATEGY_H
#define CGAL_BOUNDING_ARCS_2_TREE_INTERNAL_BATCH_LEVEL_STRATEGY_H

#include <CGAL/Bounding_arcs_2/tree/internal/batch/Look_ahead.h>
#include <CGAL/Bounding_arcs_2/tree/internal/batch/Piece_decisions.h>
#include <CGAL/Bounding_arcs_2/tree/internal/bits.h>
#include <CGAL/Bounding_arcs_2/tree/subdivide.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace CGAL::Bounding_arcs::filter {

/// Pieces place, ..., place + count - 1 of a level.
/// \param are_kept whether their thickness is
[[nodiscard]] inline Batch_pieces pieces_of(const Spiral_grid& grid, int level, std::uint64_t place, std::size_t count,
                                            bool are_kept = false) {
  return {count,
          nullptr,
          nullptr,
          grid.first(),
          grid.step(level),
          grid.last(),
          static_cast<double>(place),
          level <= LAST_LONG_LEVEL,
          are_kept};
}

/// The subtree of a segment many pieces at a time: level by level as tree/subdivide.h says, the pieces of a level in
/// batches. The pieces still open on a level are few runs of neighbours, as thickness varies slowly.
class Level_strategy {
 public:
  /// Appends the nodes of the first levels, as far as they were decided ahead.
  /// \return what is known of them \post is_done() tells whether these are all
  Subdivision begin(const Segment_top& top, Region_nodes& nodes, Decision_counts& counts) {
    double thickness[TOP_NODES];
    std::uint64_t there = 1, split = 0;  // places of a level, and nodes, level by level
    std::size_t count = 0;
    next_.clear();
    for (int level = 0; level < top.levels(); ++level) {
      const std::uint64_t above = top.above(level);
      for (std::uint64_t left = there; left != 0; left &= left - 1, ++count) {
        const int place = internal::count_zeros(left);
        split |= (above >> place & 1) << count;
        if (nodes.keeps_thickness()) thickness[count] = top.thickness(level, static_cast<std::uint64_t>(place));
      }
      there = 0;
      for (std::uint64_t left = above; left != 0; left &= left - 1)
        there |= std::uint64_t(3) << 2 * internal::count_zeros(left);
      if (there == 0) break;
    }
    if (count > 0) nodes.append(thickness, split, count);
    counts.batch += count;
    for (std::uint64_t left = there; left != 0; left &= left - 1) {
      const auto place = static_cast<std::uint64_t>(internal::count_zeros(left));
      open_run({place, place + 1});
    }
    return {top.largest(), false};
  }
  /// Whether no piece is left to be decided.
  [[nodiscard]] bool is_done() const { return next_.empty(); }

  /// Appends the nodes that are not there after begin: together the same as those of Bounding_arcs::subdivide.
  /// \param decide Piece_decisions of the segment
  template <class Decide>
  [[nodiscard]] Subdivision finish(Decide& decide, const Segment_top& top, double eps, std::size_t limit,
                                   Region_nodes& nodes, Decision_counts& counts) {
    const Spiral_grid grid(decide.spiral().first(), decide.spiral().last());
    Work<Decide> work{decide, grid, eps, limit, nodes, counts, top.largest()};
    if (top.levels() > 0) give_up_hopeless(work, top.thickness(0, 0));
    for (int level = top.levels(); !next_.empty() && !work.is_over_limit(); ++level) {
      open_.swap(next_);
      next_.clear();
      for (const Run& run : open_)
        for (std::uint64_t place = run.begin; place < run.end; place += BATCH_SIZE)
          add(work, level, place, (std::min<std::size_t>)(run.end - place, BATCH_SIZE));
    }
    return {work.bound, work.is_over_limit()};
  }

 private:
  struct Run {  // pieces begin, ..., end - 1 of a level
    std::uint64_t begin, end;
  };
  template <class Decide> struct Work {
    Decide& decide;
    const Spiral_grid& grid;
    double eps;
    std::size_t limit;
    Region_nodes& nodes;
    Decision_counts& counts;
    double bound;
    bool is_hopeless = false;

    [[nodiscard]] bool is_over_limit() const { return nodes.size() > limit || is_hopeless; }
  };

  template <class Decide> void add(Work<Decide>& work, int level, std::uint64_t place, std::size_t count) {
    double thickness[BATCH_SIZE];
    const bool is_last = level == work.grid.levels();
    const bool wants_thickness = work.nodes.keeps_thickness() || level == 0 || is_last;
    const Piece_decision decision = work.decide(pieces_of(work.grid, level, place, count, wants_thickness), work.eps,
                                                wants_thickness ? thickness : nullptr, work.counts);
    std::uint64_t above = decision.above;
    work.bound = (std::max)(work.bound, decision.largest);
    if (level == 0) give_up_hopeless(work, thickness[0]);
    if (above != 0 && is_last) {
      work.bound = (std::max)(work.bound, *std::max_element(thickness, thickness + count));
      above = 0;
    }
    work.nodes.append(thickness, above, count);
    open_halves(place, above);
  }
  // \param whole an upper bound of the whole segment's thickness
  template <class Decide> static void give_up_hopeless(Work<Decide>& work, double whole) {
    const double far = hopeless_thickness(work.limit, work.eps);
    if (whole > far)
      work.is_hopeless = work.decide(pieces_of(work.grid, 0, 0, 1), far, nullptr, work.counts).above != 0;
  }
  // Opens the halves of the pieces from `place` on whose bits are set.
  void open_halves(std::uint64_t place, std::uint64_t above) {
    while (above != 0) {
      const int first = internal::count_zeros(above), length = internal::count_zeros(~(above >> first));
      const std::uint64_t begin = 2 * (place + static_cast<std::uint64_t>(first));
      open_run({begin, begin + 2 * static_cast<std::uint64_t>(length)});
      if (first + length >= 64) break;
      above &= ~std::uint64_t(0) << (first + length);
    }
  }
  void open_run(const Run& run) {
    if (!next_.empty() && next_.back().end == run.begin) next_.back().end = run.end;
    else next_.push_back(run);
  }
  std::vector<Run> open_, next_;
};

}  // namespace CGAL::Bounding_arcs::filter

#endif
