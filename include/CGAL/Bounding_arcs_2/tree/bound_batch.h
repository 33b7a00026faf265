// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Thickness against eps for up to 64 consecutive pieces of a spiral segment at once.  The loops are plain; compiled for
// wider registers (src/kernels/batch_kernels.cpp) they give the same bits, as each operation rounds by itself.

#ifndef CGAL_BOUNDING_ARCS_2_TREE_BOUND_BATCH_H
#define CGAL_BOUNDING_ARCS_2_TREE_BOUND_BATCH_H

#include <CGAL/Bounding_arcs_2/region/Batch_bounds.h>
#include <CGAL/Bounding_arcs_2/spiral/Batch_curve.h>

#include <cmath>
#include <cstddef>
#include <cstdint>

namespace CGAL::Bounding_arcs::internal {

inline constexpr std::size_t BATCH_SIZE = 64;

/// Up to 64 consecutive pieces: the breaks between them, listed or equally far apart.
struct Batch_pieces {
  std::size_t count = 0;
  const double* breaks = nullptr;            ///< count + 1 of them, or null for first + i step, i = start, start + 1, ...
  double first = 0, step = 0, last = 0, start = 0;  ///< none of them beyond last
  bool are_long = false;  ///< likely to turn by too much for narrow forms, which are then not tried

  [[nodiscard, gnu::always_inline]] inline double grid(int i) const {
    const double t = first + (start + i) * step;
    return t < last ? t : last;
  }
  [[nodiscard]] double operator[](int i) const { return breaks != nullptr ? breaks[i] : grid(i); }
};

/// A bit a piece, the first piece in the lowest bit. Pieces in neither word are not decided.
struct Batch_decision {
  std::uint64_t within = 0;  ///< thickness <= eps for certain
  std::uint64_t above = 0;   ///< thickness > eps for certain, and so is that of every piece which contains this one
  double largest = 0;        ///< upper bound of the thickness of those within
};

template <class Isa, class Method, int DEGREE, bool WIDE>
void bound_all(const Batch_curve& c, const double* t, std::size_t groups, double* __restrict lower, double* __restrict upper) {
  for (std::size_t j = 0; j < 8 * groups; ++j) {
    const double half = 0.5 * (t[j + 1] - t[j]), tau = (t[j] - c.middle) + half;
    const Batch_piece<double> piece = batch_piece<DEGREE>(c.coefficients, tau, half);
    Batch_bounds b;
    if constexpr (Method::NEEDS_ENDS) {
      const Batch_ends<double> ends = batch_ends<DEGREE>(c.coefficients, tau, piece);
      if constexpr (WIDE) b = Method::wide(c, piece, ends);
      else b = Method::narrow(c, piece, ends);
    } else {
      if constexpr (WIDE) b = Method::wide(c, piece);
      else b = Method::narrow(c, piece);
    }
    lower[j] = b.lower;
    upper[j] = b.upper;
  }
}

/// Bit j at place j, as shifts by different amounts have no vector form in the narrowest registers.
struct Bits {
  std::uint64_t bit[BATCH_SIZE] = {};
  constexpr Bits() {
    for (std::size_t j = 0; j < BATCH_SIZE; ++j) bit[j] = std::uint64_t(1) << j;
  }
};
inline constexpr Bits BITS;

template <class Isa>
Batch_decision decide_all(std::size_t groups, const double* lower, const double* upper, double eps) {
  std::uint64_t within = 0, above = 0;
  for (std::size_t j = 0; j < 8 * groups; ++j) {
    within |= upper[j] <= eps ? BITS.bit[j] : 0;
    above |= lower[j] > eps ? BITS.bit[j] : 0;
  }
  double largest[8] = {};
  for (std::size_t g = 0; g < groups; ++g)
#pragma GCC unroll 1  // so that the eight become one register
    for (std::size_t j = 0; j < 8; ++j) {
      const double x = upper[8 * g + j] <= eps ? upper[8 * g + j] : 0;
      largest[j] = x > largest[j] ? x : largest[j];
    }
  for (std::size_t n = 4; n > 0; n /= 2)
    for (std::size_t j = 0; j < n; ++j) largest[j] = largest[j + n] > largest[j] ? largest[j + n] : largest[j];
  return {within, above, largest[0]};
}

/// The breaks of the pieces, and of more up to a multiple of 8, whose bounds nobody reads.
template <class Isa>
void write_breaks(const Batch_pieces& pieces, std::size_t groups, double* t) {
  if (pieces.breaks != nullptr)
    for (std::size_t i = 0; i <= 8 * groups; ++i) t[i] = pieces.breaks[i < pieces.count ? i : pieces.count];
  else
    for (int i = 0; i <= static_cast<int>(8 * groups); ++i) t[i] = pieces.grid(i);
}

/// Decides the pieces and writes an upper bound of each thickness.
/// \param upper room for 64
/// \param Isa a tag type, one for each instruction set that this is compiled for
template <class Isa, class Method, int DEGREE>
Batch_decision bound_batch(const Batch_curve& curve, const Batch_pieces& pieces, double eps, double* upper) {
  double t[BATCH_SIZE + 1], lower[BATCH_SIZE];
  const std::size_t groups = (pieces.count + 7) / 8;
  const std::uint64_t all = ~std::uint64_t(0) >> (BATCH_SIZE - pieces.count);
  write_breaks<Isa>(pieces, groups, t);
  const bool narrow_first = Method::HAS_NARROW && !pieces.are_long;
  if (narrow_first) bound_all<Isa, Method, DEGREE, !Method::HAS_NARROW>(curve, t, groups, lower, upper);
  else bound_all<Isa, Method, DEGREE, true>(curve, t, groups, lower, upper);
  for (std::size_t j = pieces.count; j < 8 * groups; ++j) upper[j] = HUGE_VAL;
  Batch_decision d = decide_all<Isa>(groups, lower, upper, eps);
  if (narrow_first && ((d.within | d.above) & all) != all) {
    for (std::size_t g = 0; g < groups; ++g) {
      if (((d.within | d.above | ~all) >> (8 * g) & 0xff) == 0xff) continue;
      double wide_lower[8], wide_upper[8];
      bound_all<Isa, Method, DEGREE, true>(curve, t + 8 * g, 1, wide_lower, wide_upper);
      for (std::size_t i = 0, j = 8 * g; i < 8 && j < pieces.count; ++i, ++j)
        if (!(upper[j] < HUGE_VAL)) {
          upper[j] = wide_upper[i];
          lower[j] = wide_lower[i];
        }
    }
    d = decide_all<Isa>(groups, lower, upper, eps);
  }
  return {d.within & all, d.above & all, d.largest};
}

}  // namespace CGAL::Bounding_arcs::internal

#endif
