// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The first levels of eight segments' subtrees at once, a lane a segment.  Most segments end there at a coarse eps, and
// for one of them alone a batch would have one to four pieces.  The same bits as of batches and of single pieces.

#ifndef BOUNDING_ARCS_LIBRARY_TREE_BATCH_TOP_LEVELS_H
#define BOUNDING_ARCS_LIBRARY_TREE_BATCH_TOP_LEVELS_H

#include "bound_batch.h"

#include "Batch_questions.h"

#include <cmath>
#include <cstddef>
#include <cstdint>

namespace CGAL::Bounding_arcs::filter {

/// One node of each segment. \param begin,end in parts of the segments
template <class Isa, class Method, int KIND>
void decide_node(const Top_question& __restrict q, std::uint64_t node, double begin, double end,
                 std::uint64_t* __restrict above, std::uint64_t* __restrict open, double* __restrict largest,
                 double* __restrict upper) {
  const std::uint64_t bit = std::uint64_t(1) << node, parent = std::uint64_t(1) << (node / 2);
  for (std::size_t j = 0; j < LANES; ++j) {
    const double t0 = q.first.of[j] + begin * q.length.of[j], t1 = q.first.of[j] + end * q.length.of[j];
    const double last = q.last.of[j], from = t0 < last ? t0 : last, to = t1 < last ? t1 : last;
    const double half = 0.5 * (to - from), tau = q.curves.direction.of[j] * ((from - q.curves.middle.of[j]) + half);
    const Local_form<double> form = q.curves.template form<KIND>(j);
    const Local_piece<double> piece = local_piece<KIND>(form.coefficients, tau, half);
    Local_ends<double> piece_ends{};
    if constexpr (Method::NEEDS_ENDS) piece_ends = local_ends<KIND>(form.coefficients, tau, piece);
    const Bracket b = bound_figures<Method, true>(form, piece, piece_ends);
    const double eps = q.eps.of[j];
    const bool is_known = b.upper - b.lower <= CLOSE_BOUND * b.lower + q.looseness;
    const double lower = is_known ? b.lower : -1, most = is_known ? b.upper : HUGE_VAL;
    // words as wide as doubles, and no bool of them: it has no vector form
    const std::uint64_t is_there = above[j] & parent, bits = is_there != 0 ? bit : 0;
    const double of_leaf = is_there != 0 ? (most <= eps ? most : 0) : 0;
    above[j] |= lower > eps ? bits : 0;
    open[j] |= lower > eps ? 0 : most <= eps ? 0 : bits;
    largest[j] = of_leaf > largest[j] ? of_leaf : largest[j];
    upper[j] = b.upper;
  }
}

/// Decides the nodes of the first levels, but for those below an open one, and as long as that takes less time than
/// batches of single segments, which have all places of a level at once.
template <class Isa, class Method, int KIND> void decide_top(const Top_question& question, Top_answer& answer) {
  for (std::size_t j = 0; j < LANES; ++j) {
    answer.above[j] = 1;
    answer.open[j] = 0;
    answer.largest.of[j] = 0;
  }
  double length = 1;
  std::uint64_t any = 1;
  int lanes = LANES, places = 1;
  answer.levels = 0;
  // a batch of one segment takes one and a half times as long as a node of eight
  for (std::uint64_t size = 1; size < TOP_NODES && 2 * places <= 3 * lanes; size *= 2, length *= 0.5) {
    for (std::uint64_t place = 0; place < size; ++place) {
      const auto begin = static_cast<double>(static_cast<std::int64_t>(place));
      if ((any >> ((size + place) / 2) & 1) != 0)
        decide_node<Isa, Method, KIND>(question, size + place, begin * length, (begin + 1) * length, answer.above,
                                       answer.open, answer.largest.of, answer.upper[size + place].of);
    }
    any = 0;
    lanes = 0;
    for (std::size_t j = 0; j < LANES; ++j) {
      any |= answer.above[j];
      lanes += answer.above[j] >> size != 0 ? 1 : 0;
    }
    ++answer.levels;
    places = 0;
    for (std::uint64_t i = size; i < 2 * size; ++i) places += 2 * static_cast<int>(any >> i & 1);
  }
}

}  // namespace CGAL::Bounding_arcs::filter

#endif
