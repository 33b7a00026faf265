// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The first levels of the segments that come next, decided eight segments at a time.

#ifndef CGAL_BOUNDING_ARCS_2_TREE_INTERNAL_BATCH_LOOK_AHEAD_H
#define CGAL_BOUNDING_ARCS_2_TREE_INTERNAL_BATCH_LOOK_AHEAD_H

#include <CGAL/Bounding_arcs_2/spiral/Curve_kind.h>
#include <CGAL/Bounding_arcs_2/tree/Piece_source.h>
#include <CGAL/Bounding_arcs_2/tree/Spiral_grid.h>
#include <CGAL/Bounding_arcs_2/tree/internal/batch/Batch_function.h>
#include <CGAL/assertions.h>

#include <cstddef>
#include <cstdint>
#include <vector>

namespace CGAL::Bounding_arcs::filter {

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
template <class Spiral> class Look_ahead {
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
      return Spiral_grid(first[i].first(), first[i].last()).levels() >= TOP_LEVELS;
    };
    const auto set = [&](std::size_t lane, std::size_t i) {
      const Spiral_grid grid(first[i].first(), first[i].last());
      question.first.of[lane] = grid.first();
      question.length.of[lane] = grid.step(0);
      question.last.of[lane] = grid.last();
      question.eps.of[lane] = reachable(eps, first[i]);
    };
    for_lanes(first, count, question.curves, serves, set, [&](int kind, const std::size_t* places, std::size_t size) {
      const Top_function function = functions.of_top(kind);
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

}  // namespace CGAL::Bounding_arcs::filter

#endif
