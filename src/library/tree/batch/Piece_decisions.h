// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The steps of Piece_filter: many pieces at a time, and piece by piece where that leaves one open.

#ifndef BOUNDING_ARCS_LIBRARY_TREE_BATCH_PIECE_DECISIONS_H
#define BOUNDING_ARCS_LIBRARY_TREE_BATCH_PIECE_DECISIONS_H

#include <CGAL/Bounding_arcs_2/region/thickness_bound.h>
#include <CGAL/Bounding_arcs_2/spiral/Bezier_spiral_2.h>
#include <CGAL/Bounding_arcs_2/tree/Build_options.h>
#include <CGAL/Bounding_arcs_2/tree/Region_nodes.h>
#include <CGAL/Bounding_arcs_2/tree/Spiral_grid.h>
#include <CGAL/Bounding_arcs_2/tree/internal/Piece_filter.h>
#include <CGAL/Bounding_arcs_2/tree/subdivide.h>
#include "../../spiral/Local_curve.h"
#include "Batch_functions.h"
#include "Batch_questions.h"

#include <CGAL/assertions.h>

#include <algorithm>
#include <bitset>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace CGAL::Bounding_arcs::filter {

// Decisions of thickness for pieces of one segment.

/// What is decided of up to 64 pieces.
struct Piece_decision {
  std::uint64_t above = 0;  ///< a bit a piece, the first lowest: the thickness is above eps
  double largest = 0;       ///< upper bound of the thickness of the others
};

/// Thickness against eps for consecutive pieces of one segment: in a batch, and by the traits' functor, with more
/// digits, where that does not decide.
class Piece_decisions {
 public:
  /// `bound` must outlive the object.
  Piece_decisions(const Open_piece& bound, const Batch_functions& functions, const Segment_curve& segment)
      : bound_(bound), grid_(segment.first, segment.last), curve_{segment}, batch_(functions.many(curve_.local.kind)) {}

  Piece_decisions(const Piece_decisions&) = delete;  // refers to itself

  /// Whether there are batches for the segment, without which nothing is to be decided here.
  [[nodiscard]] bool has_batches() const { return batch_ != nullptr; }
  [[nodiscard]] const internal::Spiral_grid& grid() const { return grid_; }
  /// \pre has_batches()
  /// \param upper room for 64 upper bounds of thickness, or null if they are not wanted, which takes less time
  [[nodiscard]] Piece_decision operator()(const Batch_pieces& pieces, double eps, double* upper,
                                          Decision_counts& counts) {
    CGAL_precondition(has_batches());
    if (upper == nullptr && !is_rough_made_ && pieces.may_be_rough()) make_rough();
    const Batch_decision d = batch_(curve_, pieces, eps, upper);
    Piece_decision result{d.above, d.largest};
    std::uint64_t open = pieces.all() & ~(d.above | d.within);
    counts.batch += pieces.count - (open == 0 ? 0 : std::bitset<BATCH_SIZE>(open).count());
    for (int i = 0; open != 0; ++i, open >>= 1) {
      if ((open & 1) == 0) continue;
      const Thickness_bound b = bound_(pieces.begin(i), pieces.end(i), eps);
      if (upper != nullptr) upper[i] = b.upper;
      if (b.within) result.largest = (std::max)(result.largest, b.upper);
      else result.above |= std::uint64_t(1) << i;
      ++(b.was_exact ? counts.exact : counts.bounded);
    }
    return result;
  }

 private:
  // When it is first read: segments of few pieces do without, which saves some per cent of a build at coarse eps.
  void make_rough() {
    is_rough_made_ = true;
    if (make_rough_form(curve_.local, rough_)) curve_.rough = &rough_;
  }

  const Open_piece& bound_;
  internal::Spiral_grid grid_;
  Batch_curve curve_;
  Batch_function batch_;
  Local_form<float> rough_;
  bool is_rough_made_ = false;
};

// Subtrees, level by level.

// The first levels of the segments that come next, decided eight segments at a time.

/// What was decided ahead of one segment.
class Segment_top {
 public:
  Segment_top() = default;
  Segment_top(const Top_answer& answer, std::size_t lane) : answer_(&answer), lane_(lane) {
    while (levels_ < answer.levels && (answer.open[lane] & nodes_of(levels_)) == 0) ++levels_;
  }

  /// How many levels are decided, all their pieces.
  [[nodiscard]] int levels() const { return levels_; }
  /// A bit for each piece of a level: it is there, and too thick. \pre level < levels()
  [[nodiscard]] std::uint64_t above(int level) const {
    CGAL_precondition(level < levels_);
    return (answer_->above[lane_] & nodes_of(level)) >> (std::uint64_t(1) << level);
  }
  [[nodiscard]] double thickness(int level, std::uint64_t place) const {
    return answer_->upper[(std::uint64_t(1) << level) + place].of[lane_];
  }
  /// An upper bound of the thickness of the leaves among them.
  [[nodiscard]] double largest() const { return answer_ != nullptr ? answer_->largest.of[lane_] : 0; }

 private:
  [[nodiscard]] static std::uint64_t nodes_of(int level) {
    const std::uint64_t size = std::uint64_t(1) << level;
    return ((std::uint64_t(1) << size) - 1) << size;
  }

  const Top_answer* answer_ = nullptr;
  std::size_t lane_ = 0;
  int levels_ = 0;
};

/// The first levels of the segments that come next.
class Look_ahead {
  using Spiral = Bezier_spiral_2<double>;

 public:
  /// Decides first levels of segments first[0], ..., first[count - 1], and forgets those before.
  void decide(const Batch_functions& functions, const Spiral* first, std::size_t count, double eps, bool are_kept) {
    first_ = first;
    slots_.assign(count, NONE);
    answers_.clear();
    answers_.reserve(count / LANES + 1);
    Top_question question;
    if (are_kept) question.looseness = 0;
    const auto serves = [&](std::size_t i) {
      return internal::Spiral_grid(first[i].first(), first[i].last()).levels() >= TOP_LEVELS;
    };
    const auto set = [&](std::size_t lane, std::size_t i) {
      const internal::Spiral_grid grid(first[i].first(), first[i].last());
      question.first.of[lane] = grid.first();
      question.length.of[lane] = grid.step(0);
      question.last.of[lane] = grid.last();
      question.eps.of[lane] = internal::reachable(eps, first[i]);
    };
    for_lanes(first, count, question.curves, serves, set, [&](int kind, const std::size_t* places, std::size_t size) {
      const Top_function function = functions.top(kind);
      if (function == nullptr) return;
      for (std::size_t lane = 0; lane < size; ++lane) slots_[places[lane]] = LANES * answers_.size() + lane;
      function(question, answers_.emplace_back());
    });
  }
  /// What was decided of a segment.
  [[nodiscard]] Segment_top top(const Spiral& spiral) const {
    const auto i = static_cast<std::size_t>(&spiral - first_);
    if (i >= slots_.size() || slots_[i] == NONE) return {};
    return {answers_[slots_[i] / LANES], slots_[i] % LANES};
  }

 private:
  static constexpr std::size_t NONE = ~std::size_t(0);
  const Spiral* first_ = nullptr;
  std::vector<std::size_t> slots_;  // of each segment: eight times the place of its answer, and its lane there
  std::vector<Top_answer> answers_;
};

/// Pieces place, ..., place + count - 1 of a level.
/// \param are_kept whether their thickness is
[[nodiscard]] inline Batch_pieces pieces_of(const internal::Spiral_grid& grid, int level, std::uint64_t place,
                                            std::size_t count, bool are_kept = false) {
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
  internal::Subdivision begin(const Segment_top& top, internal::Region_nodes& nodes, Decision_counts& counts) {
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
  [[nodiscard]] internal::Subdivision finish(Piece_decisions& decide, const Segment_top& top, double eps,
                                             std::size_t limit, internal::Region_nodes& nodes,
                                             Decision_counts& counts) {
    Work work{decide, decide.grid(), eps, limit, nodes, counts, top.largest()};
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
  struct Work {
    Piece_decisions& decide;
    const internal::Spiral_grid& grid;
    double eps;
    std::size_t limit;
    internal::Region_nodes& nodes;
    Decision_counts& counts;
    double bound;
    bool is_hopeless = false;

    [[nodiscard]] bool is_over_limit() const { return nodes.size() > limit || is_hopeless; }
  };

  void add(Work& work, int level, std::uint64_t place, std::size_t count) {
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
  static void give_up_hopeless(Work& work, double whole) {
    const double far = internal::hopeless_thickness(work.limit, work.eps);
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
