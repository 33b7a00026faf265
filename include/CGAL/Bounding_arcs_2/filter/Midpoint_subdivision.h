// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Halves spiral segments until every piece's region is thin enough, level by level, so that the pieces of a level are
// bounded in batches.  The pieces still open on a level are few runs of neighbours, as thickness varies slowly.

#ifndef CGAL_BOUNDING_ARCS_2_FILTER_MIDPOINT_SUBDIVISION_H
#define CGAL_BOUNDING_ARCS_2_FILTER_MIDPOINT_SUBDIVISION_H

#include <CGAL/Bounding_arcs_2/filter/Piece_decisions.h>
#include <CGAL/Bounding_arcs_2/internal/tree/Region_nodes.h>
#include <CGAL/Bounding_arcs_2/tree/Spiral_grid.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace CGAL::Bounding_arcs::filter {

/// What is known of subdivided segments beside their nodes.
struct Subdivision_result {
  Decision_counts counts;
  double bound = 0;                    ///< at least the thickness of every leaf, at most eps if that was reached
  bool is_resolution_reached = false;  ///< eps was below what coordinates or parameters resolve, somewhere
  bool is_over_limit = false;

  void add(const Subdivision_result& other) {
    counts.add(other.counts);
    bound = (std::max)(bound, other.bound);
    is_resolution_reached |= other.is_resolution_reached;
    is_over_limit |= other.is_over_limit;
  }
};

template <class Traits, class Spiral> class Midpoint_subdivision {
 public:
  /// \param limit the most nodes to make
  Midpoint_subdivision(const Piece_decisions<Traits, Spiral>& decide, double eps, std::size_t limit,
                       bool keeps_thickness)
      : decide_(decide), eps_(eps), limit_(limit), nodes_(keeps_thickness) {}

  /// Appends the subtree of a segment. Does nothing once is_over_limit().
  void add(const Spiral& spiral) {
    const double eps = reachable(eps_, spiral);
    if (eps_ < eps) is_resolution_reached_ = true;
    const Spiral_grid grid(spiral.first(), spiral.last());
    has_top_ = false;
    int level = start(spiral, grid, eps);
    for (; !next_.empty() && !is_over_limit(); ++level) {
      open_.swap(next_);
      next_.clear();
      for (const Run& run : open_) {
        if (level < run.split_below) {
          nodes_.append_split(run.end - run.begin);
          open_run({2 * run.begin, 2 * run.end, run.split_below});
        } else {
          for (std::uint64_t place = run.begin; place < run.end; place += BATCH_SIZE)
            add(spiral, grid, level, place, (std::min<std::size_t>)(run.end - place, BATCH_SIZE), eps);
        }
      }
    }
    next_.clear();
    levels_before_ = level;
  }

  /// Makes room for `times` as many nodes as there are, and some more: memory that grows by doubling is copied, and
  /// touched twice.
  void foresee(double times) {
    constexpr double MORE = 1.1;
    nodes_.reserve((std::min)(static_cast<std::size_t>(MORE * times * static_cast<double>(nodes_.size())), limit_));
  }

  [[nodiscard]] bool is_over_limit() const { return nodes_.size() > limit_ || is_hopeless_; }
  [[nodiscard]] internal::Region_nodes& nodes() { return nodes_; }
  [[nodiscard]] Subdivision_result result() const { return {counts_, bound_, is_resolution_reached_, is_over_limit()}; }

 private:
  // Thickness falls with the cube of length, so about the cube root of a segment's over eps pieces are needed: where
  // that is this far above the limit no time is spent on what would end there.
  static constexpr double FAR_ABOVE = 8;

  struct Run {  // pieces begin, ..., end - 1 of a level
    std::uint64_t begin, end;
    int split_below;  // the pieces and those below them are known to be split on levels before this one
  };

  // The first level to decide, with its runs in next_. Where the thickness of a part tells that of the whole, levels
  // can be decided before those above them, which then need no look.
  [[nodiscard]] int start(const Spiral& spiral, const Spiral_grid& grid, double eps) {
    next_.assign(1, {0, 1, 0});
    if constexpr (Piece_decisions<Traits, Spiral>::MAY_BE_INHERITED) {
      constexpr int LEVEL = 3, PIECES = 1 << LEVEL;
      if (nodes_.keeps_thickness() || grid.levels() <= LEVEL || levels_before_ <= LEVEL) return 0;
      double thickness[BATCH_SIZE];
      if (decide_(spiral, grid.pieces(LEVEL, 0, PIECES), eps, thickness, counts_).inherited != (1 << PIECES) - 1)
        return 0;
      nodes_.append_split(2 * PIECES - 1);
      next_.clear();
      for (int i = 0; i < PIECES; ++i) {
        // thickness falls by 8 a level, about
        const int below = (std::min)(std::ilogb(thickness[i] / eps), 3 * (grid.levels() - LEVEL - 1)) / 3;
        const auto place = static_cast<std::uint64_t>(i);
        // a level of more pieces than nodes allowed would take longer than to find out that there are too many
        const bool known = below > 1 && std::uint64_t(1) << below <= limit_ &&
                           are_above(spiral, grid, LEVEL + below, place << below, std::uint64_t(1) << below, eps);
        open_run({2 * place, 2 * place + 2, known ? LEVEL + below + 1 : 0});
      }
      return LEVEL + 1;
    }
    return 0;
  }
  [[nodiscard]] bool are_above(const Spiral& spiral, const Spiral_grid& grid, int level, std::uint64_t place,
                               std::uint64_t count, double eps) {
    for (std::uint64_t done = 0; done < count; done += BATCH_SIZE) {
      const Batch_pieces pieces = grid.pieces(level, place + done, (std::min<std::size_t>)(count - done, BATCH_SIZE));
      if (decide_(spiral, pieces, eps, nullptr, counts_).inherited != pieces.all()) return false;
    }
    return true;
  }

  void add(const Spiral& spiral, const Spiral_grid& grid, int level, std::uint64_t place, std::size_t count,
           double eps) {
    double thickness[BATCH_SIZE];
    const bool is_last = level == grid.levels(), wants_thickness = nodes_.keeps_thickness() || level == 0 || is_last;
    if (level == 0) decide_top(spiral, grid, eps);
    const Piece_decision decision =
        has_top_ && level < Spiral_grid::TOP_LEVELS
            ? part_of_top(level, place, count, thickness)
            : decide_(spiral, grid.pieces(level, place, count), eps, wants_thickness ? thickness : nullptr, counts_);
    std::uint64_t above = decision.above;
    bound_ = (std::max)(bound_, decision.largest);
    if (level == 0) {
      const double most = FAR_ABOVE * static_cast<double>(limit_);
      is_hopeless_ = thickness[0] > eps * (most * most * most);
    }
    if (above != 0 && is_last) {
      is_resolution_reached_ = true;
      bound_ = (std::max)(bound_, *std::max_element(thickness, thickness + count));
      above = 0;
    }
    nodes_.append(thickness, above, count);
    while (above != 0) {
      const int first = count_zeros(above), length = count_zeros(~(above >> first));
      const std::uint64_t begin = 2 * (place + static_cast<std::uint64_t>(first));
      open_run({begin, begin + 2 * static_cast<std::uint64_t>(length), 0});
      if (first + length >= 64) break;
      above &= ~std::uint64_t(0) << (first + length);
    }
  }
  // Decides the first levels at once where that takes no longer than one of them.
  void decide_top(const Spiral& spiral, const Spiral_grid& grid, double eps) {
    has_top_ = decide_.has_batch(spiral) && grid.levels() >= Spiral_grid::TOP_LEVELS;
    if (has_top_) top_ = decide_(spiral, grid.top().pieces(), eps, top_thickness_, counts_);
  }
  [[nodiscard]] Piece_decision part_of_top(int level, std::uint64_t place, std::size_t count, double* thickness) const {
    const std::uint64_t begin = (std::uint64_t(1) << level) - 1 + place;
    Piece_decision part;
    part.above = top_.above >> begin & ~(~std::uint64_t(0) << count);
    for (std::size_t i = 0; i < count; ++i) {
      thickness[i] = top_thickness_[begin + i];
      if ((part.above >> i & 1) == 0) part.largest = (std::max)(part.largest, thickness[i]);
    }
    return part;
  }
  void open_run(const Run& run) {
    const bool joins = !next_.empty() && next_.back().end == run.begin && next_.back().split_below == run.split_below;
    if (joins) next_.back().end = run.end;
    else next_.push_back(run);
  }
  // Zeros below the lowest set bit; 64 of 0.
  [[nodiscard]] static int count_zeros(std::uint64_t word) {
    if (word == 0) return 64;
    int n = 0;
    for (int step = 32; step > 0; step /= 2)
      if ((word & (~std::uint64_t(0) >> (64 - step))) == 0) {
        word >>= step;
        n += step;
      }
    return n;
  }

  const Piece_decisions<Traits, Spiral>& decide_;
  double eps_;
  std::size_t limit_;
  double bound_ = 0;
  bool is_hopeless_ = false;
  bool has_top_ = false;
  Piece_decision top_;  // of the first levels of the segment at hand
  double top_thickness_[BATCH_SIZE];
  int levels_before_ = 0;  // of the segment before, which the next one is likely to be like
  bool is_resolution_reached_ = false;
  Decision_counts counts_;
  internal::Region_nodes nodes_;
  std::vector<Run> open_, next_;
};

}  // namespace CGAL::Bounding_arcs::filter

#endif
