// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Subtrees, level by level.

#ifndef CGAL_BOUNDING_ARCS_2_TREE_INTERNAL_BATCH_LEVEL_STRATEGY_H
#define CGAL_BOUNDING_ARCS_2_TREE_INTERNAL_BATCH_LEVEL_STRATEGY_H

#include <CGAL/Bounding_arcs_2/tree/internal/batch/Piece_decisions.h>
#include <CGAL/Bounding_arcs_2/tree/internal/bits.h>
#include <CGAL/Bounding_arcs_2/tree/subdivide.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace CGAL::Bounding_arcs::filter {

/// The last level whose pieces are likely to turn by too much for narrow forms: a segment turns by some half of a right
/// angle as a rule. Were they tried first everywhere, coarse builds would take 2 to 9 per cent longer.
inline constexpr int LAST_LONG_LEVEL = 3;

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

/// The pieces of the first three levels, level by level: one batch takes no longer than one of them would. Without it a
/// build at eps 1e-4 takes 1.4 times as long, of spiral fat arcs 1.8 times.
struct Top_pieces {
  static constexpr int LEVELS = 3;
  static constexpr std::size_t COUNT = (std::size_t(1) << LEVELS) - 1;
  double begins[COUNT], ends[COUNT];

  /// \pre grid.levels() >= LEVELS
  explicit Top_pieces(const Spiral_grid& grid) {
    for (int level = 0, i = 0; level < LEVELS; ++level)
      for (std::uint64_t k = 0; k < std::uint64_t(1) << level; ++k, ++i) {
        begins[i] = grid.parameter(level, k);
        ends[i] = grid.parameter(level, k + 1);
      }
  }
  [[nodiscard]] Batch_pieces pieces(bool are_kept) const { return {COUNT, begins, ends, 0, 0, 0, 0, true, are_kept}; }
};

/// The subtree of a segment many pieces at a time: level by level as tree/subdivide.h says, the pieces of a level in
/// batches. The pieces still open on a level are few runs of neighbours, as thickness varies slowly.
class Level_strategy {
 public:
  /// Appends a segment's nodes: the same as Bounding_arcs::subdivide.
  /// \param decide Piece_decisions of the segment
  template <class Decide>
  [[nodiscard]] Subdivision subdivide(Decide& decide, double eps, std::size_t limit, Region_nodes& nodes,
                                      Decision_counts& counts) {
    const Spiral_grid grid(decide.spiral().first(), decide.spiral().last());
    Work<Decide> work(decide, grid, eps, limit, nodes, counts);
    next_.assign(1, {0, 1});
    for (int level = 0; !next_.empty() && !work.is_over_limit(); ++level) {
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
    Work(Decide& decider, const Spiral_grid& segment, double tolerance, std::size_t most_nodes, Region_nodes& to,
         Decision_counts& count)
        : decide(decider), grid(segment), eps(tolerance), limit(most_nodes), nodes(to), counts(count) {}

    Decide& decide;
    const Spiral_grid& grid;
    double eps;
    std::size_t limit;
    Region_nodes& nodes;
    Decision_counts& counts;
    double bound = 0;
    bool is_hopeless = false, has_top = false;
    Piece_decision top;                // of the first levels, and
    double top_thickness[BATCH_SIZE];  // set with it
    [[nodiscard]] bool is_over_limit() const { return nodes.size() > limit || is_hopeless; }
  };

  template <class Decide> void add(Work<Decide>& work, int level, std::uint64_t place, std::size_t count) {
    double thickness[BATCH_SIZE];
    const bool is_last = level == work.grid.levels();
    const bool wants_thickness = work.nodes.keeps_thickness() || level == 0 || is_last;
    if (level == 0) decide_top(work);
    const Piece_decision decision = work.has_top && level < Top_pieces::LEVELS
                                        ? part_of_top(work, level, place, count, thickness)
                                        : work.decide(pieces_of(work.grid, level, place, count, wants_thickness),
                                                      work.eps, wants_thickness ? thickness : nullptr, work.counts);
    std::uint64_t above = decision.above;
    work.bound = (std::max)(work.bound, decision.largest);
    if (const double far = hopeless_thickness(work.limit, work.eps); level == 0 && thickness[0] > far)
      work.is_hopeless = work.decide(pieces_of(work.grid, 0, 0, 1), far, nullptr, work.counts).above != 0;
    if (above != 0 && is_last) {
      work.bound = (std::max)(work.bound, *std::max_element(thickness, thickness + count));
      above = 0;
    }
    work.nodes.append(thickness, above, count);
    while (above != 0) {
      const int first = internal::count_zeros(above), length = internal::count_zeros(~(above >> first));
      const std::uint64_t begin = 2 * (place + static_cast<std::uint64_t>(first));
      open_run({begin, begin + 2 * static_cast<std::uint64_t>(length)});
      if (first + length >= 64) break;
      above &= ~std::uint64_t(0) << (first + length);
    }
  }
  // A segment behind one that is a leaf is likely to be one, too: its root is asked alone, which takes a third of a
  // batch.
  template <class Decide> void decide_top(Work<Decide>& work) {
    work.has_top = work.grid.levels() >= Top_pieces::LEVELS;
    if (!work.has_top) return;
    if (is_leaf_likely_ && !work.nodes.keeps_thickness()) {
      const double upper = work.decide.bounds(work.grid.first(), work.grid.last(), work.eps).upper;
      if (upper <= work.eps) {
        work.top = {0, upper};
        work.top_thickness[0] = upper;
        ++work.counts.batch;
        return;
      }
    }
    const Top_pieces top(work.grid);
    work.top = work.decide(top.pieces(work.nodes.keeps_thickness()), work.eps, work.top_thickness, work.counts);
    is_leaf_likely_ = (work.top.above & 1) == 0;
  }
  template <class Decide>
  [[nodiscard]] static Piece_decision part_of_top(const Work<Decide>& work, int level, std::uint64_t place,
                                                  std::size_t count, double* thickness) {
    const std::uint64_t begin = (std::uint64_t(1) << level) - 1 + place;
    Piece_decision part;
    part.above = work.top.above >> begin & ~(~std::uint64_t(0) << count);
    for (std::size_t i = 0; i < count; ++i) {
      thickness[i] = work.top_thickness[begin + i];
      if ((part.above >> i & 1) == 0) part.largest = (std::max)(part.largest, thickness[i]);
    }
    return part;
  }
  void open_run(const Run& run) {
    if (!next_.empty() && next_.back().end == run.begin) next_.back().end = run.end;
    else next_.push_back(run);
  }
  std::vector<Run> open_, next_;
  bool is_leaf_likely_ = false;
};

}  // namespace CGAL::Bounding_arcs::filter

#endif
