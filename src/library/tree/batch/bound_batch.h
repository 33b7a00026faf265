// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Thickness against eps for up to 64 consecutive pieces of a spiral segment at once.  The loops are plain, without
// branches, over a segment's Taylor coefficients; compiled for wider registers (src/library/tree/batch_loops.cpp) they
// give the same bits, as each operation rounds by itself.  For each piece they give lower < thickness < upper, or say
// that the formula does not hold.
//
// Where only the comparison with eps is wanted, a batch runs in float first, which decides nearly all pieces in half
// the time.  Those that it cannot decide run in double: with a narrow form, and with a wide one those groups of eight
// that have a piece which is not narrow.  Pieces with eps still between their bounds are bounded one by one with more
// digits (Piece_decisions.h).  No stage decides otherwise than the exact thickness.

#ifndef BOUNDING_ARCS_LIBRARY_TREE_BATCH_BOUND_BATCH_H
#define BOUNDING_ARCS_LIBRARY_TREE_BATCH_BOUND_BATCH_H

#include "Batch_bounds.h"

#include <CGAL/Bounding_arcs_2/number/strict_math.h>
#include "../../spiral/Local_figures.h"
#include "../../tree/Instruction_sets.h"
#include "Batch_questions.h"

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <limits>
#include <type_traits>

namespace CGAL::Bounding_arcs::filter {

template <class Method, bool WIDE>
[[nodiscard]] CGAL_BOUNDING_ARCS_INLINE Bracket bound_figures(const Local_form<double>& c, const Local_piece<double>& g,
                                                              const Local_ends<double>& e) {
  if constexpr (WIDE) return Method::wide(c, g, e);
  else return Method::narrow(c, g, e);
}

/// Bounds of one piece: the bits that a batch has for it.
/// \param is_long see Batch_pieces::are_long
template <class Method, int KIND>
[[nodiscard]] Bracket bound_one(const Local_curve& c, double begin, double end, double eps, bool is_long) {
  const double half = 0.5 * (end - begin), tau = c.direction * ((begin - c.middle) + half);
  const Local_piece<double> piece = local_piece<KIND>(c.form.coefficients, tau, half);
  Local_ends<double> piece_ends{};
  if constexpr (Method::NEEDS_ENDS) piece_ends = local_ends<KIND>(c.form.coefficients, tau, piece);
  if (!is_long) {
    const Bracket b = bound_figures<Method, false>(c.form, piece, piece_ends);
    if (b.upper < HUGE_VAL || b.lower > eps) return b;
  }
  return bound_figures<Method, true>(c.form, piece, piece_ends);
}

template <class Isa, class Method, int KIND, bool WIDE>
void bound_all(const Local_curve& c, const double* begins, const double* ends, std::size_t groups,
               double* __restrict lower, double* __restrict upper) {
  for (std::size_t j = 0; j < GROUP<double> * groups; ++j) {
    const double half = 0.5 * (ends[j] - begins[j]), tau = c.direction * ((begins[j] - c.middle) + half);
    const Local_piece<double> piece = local_piece<KIND>(c.form.coefficients, tau, half);
    Local_ends<double> piece_ends{};
    if constexpr (Method::NEEDS_ENDS) piece_ends = local_ends<KIND>(c.form.coefficients, tau, piece);
    const Bracket b = bound_figures<Method, WIDE>(c.form, piece, piece_ends);
    lower[j] = b.lower;
    upper[j] = b.upper;
  }
}

/// Bit j at place j, as shifts by different amounts have no vector form in the narrowest registers.
template <class Word> struct Bits {
  Word bit[8 * sizeof(Word)] = {};
  constexpr Bits() {
    for (std::size_t j = 0; j < 8 * sizeof(Word); ++j) bit[j] = Word(1) << j;
  }
};
template <class Word> inline constexpr Bits<Word> BITS;

/// The words of a decision that fit into registers. Through memory, two halves that are written apart and read as one
/// wait for each other, 3 per cent of a build at eps 1e-10.
struct Batch_bits {
  std::uint64_t within = 0, above = 0;
};

/// \param within_eps, above_eps what decides, not the same where bounds are to be widened
/// \param most set to the largest upper bound of those within, where it is larger
template <class Isa, class Real>
Batch_bits decide_all(std::size_t groups, const Real* lower, const Real* upper, Real within_eps, Real above_eps,
                      double& most) {
  using Word =
      std::conditional_t<sizeof(Real) == sizeof(std::uint32_t), std::uint32_t, std::uint64_t>;  // as wide as a lane
  constexpr std::size_t SIZE = GROUP<Real>;
  Batch_bits d;
  Real largest[SIZE] = {};
  for (std::size_t g = 0; g < groups; ++g, lower += SIZE, upper += SIZE) {
    Word within = 0, above = 0;
#pragma GCC unroll 1  // so that the group becomes one register
    for (std::size_t j = 0; j < SIZE; ++j) within |= upper[j] <= within_eps ? BITS<Word>.bit[j] : 0;
#pragma GCC unroll 1
    for (std::size_t j = 0; j < SIZE; ++j) above |= lower[j] > above_eps ? BITS<Word>.bit[j] : 0;
    d.within |= std::uint64_t(within) << (g * SIZE);
    d.above |= std::uint64_t(above) << (g * SIZE);
    if (within == 0) continue;
#pragma GCC unroll 1
    for (std::size_t j = 0; j < SIZE; ++j) {
      const Real x = upper[j] <= within_eps ? upper[j] : 0;
      largest[j] = x > largest[j] ? x : largest[j];
    }
  }
  if (d.within == 0) return d;
  Word bits[SIZE], of_most = 0;  // positive numbers are in the order of their bits
  std::memcpy(bits, largest, sizeof bits);
#pragma GCC unroll 1
  for (std::size_t j = 0; j < SIZE; ++j) of_most = bits[j] > of_most ? bits[j] : of_most;
  std::memcpy(largest, &of_most, sizeof of_most);
  most = largest[0] > most ? largest[0] : most;
  return d;
}

/// Bounds in float: lower (1 - E) <= thickness <= upper (1 + E) in units of Method::rough_unit, E being
/// Method::ROUGH_ERROR; -1 and infinity where they are not known.
template <class Isa, class Method, int KIND>
void bound_roughly(const Local_curve& c, const Local_form<float>& form, const Batch_pieces& pieces, std::size_t groups,
                   float* __restrict lower, float* __restrict upper) {
  const auto start = static_cast<float>(pieces.start) + 0.5f, step = static_cast<float>(c.direction * pieces.step);
  const auto offset = static_cast<float>(c.direction * (pieces.first - c.middle)),
             half = static_cast<float>(0.5 * pieces.step);
  const std::size_t count = GROUP<float> * groups;
  Rough_figures figures;
  for (std::size_t j = 0; j < count; ++j) {
    const float tau = (start + static_cast<float>(static_cast<int>(j))) * step + offset;
    const Local_piece<float> piece = local_piece<KIND>(form.coefficients, tau, half);
    if constexpr (Method::NEEDS_ENDS) figures.set(j, piece, local_ends<KIND>(form.coefficients, tau, piece));
    else figures.set(j, piece);
  }
  Method::rough(form, figures, half, count, lower, upper);
}

/// Decides in float what is plain, in half the time of double.
/// \param d nothing decided
/// \pre pieces.may_be_rough()
template <class Isa, class Method, int KIND>
void decide_roughly(const Local_curve& curve, const Local_form<float>& form, const Batch_pieces& pieces, double eps,
                    Batch_decision& d) {
  // four times the rounding of a double to float, which is more than that and the roundings of these few doubles
  constexpr double ROUNDING = 4 * Local_precision<float>::HALF_ULP, UP = 1 + ROUNDING, DOWN = 1 - ROUNDING;
  constexpr double LEAST = 0x1p-60, MOST = 0x1p100;  // well within what float holds
  static_assert(LEAST * Local_precision<float>::HALF_ULP > double((std::numeric_limits<float>::min)()) &&
                    MOST / Local_precision<float>::HALF_ULP < double((std::numeric_limits<float>::max)()),
                "eps is to be rounded as normal floats are");
  const double unit = curve.form.unit * Method::rough_unit(0.5 * pieces.step), rough_eps = eps / unit;
  if (!(rough_eps >= LEAST && rough_eps <= MOST)) return;
  const std::size_t groups = (pieces.count + GROUP<float> - 1) / GROUP<float>;
  alignas(BATCH_ALIGNMENT) float lower[BATCH_SIZE];
  alignas(BATCH_ALIGNMENT) float upper[BATCH_SIZE];
  bound_roughly<Isa, Method, KIND>(curve, form, pieces, groups, lower, upper);
  const auto within_eps = static_cast<float>(rough_eps * (DOWN / (1 + Method::ROUGH_ERROR)));
  const auto above_eps = static_cast<float>(rough_eps * (UP / (1 - Method::ROUGH_ERROR)));
  for (std::size_t j = pieces.count; j < GROUP<float> * groups; ++j) upper[j] = HUGE_VALF;
  const Batch_bits bits = decide_all<Isa>(groups, lower, upper, within_eps, above_eps, d.largest);
  d.within = bits.within;
  d.above = bits.above & pieces.all();
  d.largest = smaller(d.largest * (unit * (1 + Method::ROUGH_ERROR) * UP), eps);  // within_eps was rounded, perhaps up
}

/// How far an upper bound that is kept may be above the thickness, in parts of it. Others are left open, and then had
/// from more digits: kept thicknesses and measures of pieces (tree/internal/Piece_decider.h) are the same by all
/// ways.
inline constexpr double CLOSE_BOUND = 0x1p-24;
[[nodiscard]] CGAL_BOUNDING_ARCS_INLINE bool is_close(double lower, double upper) {
  return upper - lower <= CLOSE_BOUND * lower;
}

/// Decides in double those groups of eight that have open pieces, narrow forms first where they are likely to hold.
/// \param upper room for 64
/// \param are_kept whether they are wanted, and have to be close
template <class Isa, class Method, int KIND>
void decide_groups(const Local_curve& curve, const Batch_pieces& pieces, double eps, double* upper, bool are_kept,
                   Batch_decision& d) {
  constexpr std::size_t SIZE = GROUP<double>;
  alignas(BATCH_ALIGNMENT) double own_begins[BATCH_SIZE + 1];
  alignas(BATCH_ALIGNMENT) double own_ends[BATCH_SIZE];
  alignas(BATCH_ALIGNMENT) double lower[BATCH_SIZE];
  const double *begins = own_begins, *ends = own_begins + 1;
  const std::size_t groups = (pieces.count + SIZE - 1) / SIZE;
  const std::uint64_t asked = pieces.all() & ~(d.within | d.above);
  std::uint64_t open = asked, loose = 0;
  const auto is_open = [&](std::size_t g) { return (open >> (SIZE * g) & 0xff) != 0; };
  const auto forget = [&](std::size_t begin, std::size_t end) {
    for (std::size_t j = begin; j < end; ++j) {
      lower[j] = -1;
      upper[j] = HUGE_VAL;
    }
  };
  const auto decide = [&] {
    forget(pieces.count, SIZE * groups);
    for (std::size_t j = 0; are_kept && j < pieces.count; ++j) {
      if (!(upper[j] < HUGE_VAL) || is_close(lower[j], upper[j])) continue;
      loose |= std::uint64_t(1) << j;
      forget(j, j + 1);
    }
    const Batch_bits bits = decide_all<Isa>(groups, lower, upper, eps, eps, d.largest);
    d.within |= bits.within & asked;
    d.above |= bits.above & asked;
    open &= ~(d.within | d.above);
  };
  // up to a multiple of the group there are pieces whose bounds nobody reads
  if (pieces.begins == nullptr) {
    for (int i = 0; i <= static_cast<int>(SIZE * groups); ++i) own_begins[i] = pieces.grid(i);
  } else {
    for (std::size_t i = 0; i < SIZE * groups; ++i) {
      own_begins[i] = pieces.begins[i < pieces.count ? i : 0];
      own_ends[i] = pieces.ends[i < pieces.count ? i : 0];
    }
    ends = own_ends;
  }
  for (std::size_t first = 0, end; first < groups; first = end) {
    for (end = first + 1; end < groups && is_open(end) == is_open(first);) ++end;
    const std::size_t j = SIZE * first;
    if (!is_open(first)) forget(j, SIZE * end);
    else if (pieces.are_long)
      bound_all<Isa, Method, KIND, true>(curve, begins + j, ends + j, end - first, lower + j, upper + j);
    else bound_all<Isa, Method, KIND, false>(curve, begins + j, ends + j, end - first, lower + j, upper + j);
  }
  decide();
  if (pieces.are_long || open == 0) return;
  for (std::size_t g = 0; g < groups; ++g) {
    if (!is_open(g)) continue;
    double wide_lower[SIZE], wide_upper[SIZE];
    bound_all<Isa, Method, KIND, true>(curve, begins + SIZE * g, ends + SIZE * g, 1, wide_lower, wide_upper);
    for (std::size_t i = 0, j = SIZE * g; i < SIZE; ++i, ++j)
      if (!(upper[j] < HUGE_VAL) && (loose >> j & 1) == 0) {
        upper[j] = wide_upper[i];
        lower[j] = wide_lower[i];
      }
  }
  decide();
}

/// Decides the pieces.
/// \param upper room for 64 upper bounds of thickness, or null if they are not wanted, which takes less time
/// \tparam Isa a tag type, one for each instruction set that this is compiled for
template <class Isa, class Method, int KIND>
Batch_decision bound_batch(const Batch_curve& curve, const Batch_pieces& pieces, double eps, double* upper) {
  Batch_decision d;
  if (upper == nullptr && curve.rough != nullptr && pieces.may_be_rough()) {
    decide_roughly<Isa, Method, KIND>(curve.local, *curve.rough, pieces, eps, d);
    if ((d.within | d.above) == pieces.all()) return d;
  }
  alignas(BATCH_ALIGNMENT) double unread[BATCH_SIZE];
  decide_groups<Isa, Method, KIND>(curve.local, pieces, eps, upper != nullptr ? upper : unread,
                                   upper != nullptr && pieces.are_kept, d);
  return d;
}

// The first levels of eight segments' subtrees at once, a lane a segment.  Most segments end there at a coarse eps, and
// for one of them alone a batch would have one to four pieces.  The same bits as of batches and of single pieces.

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
