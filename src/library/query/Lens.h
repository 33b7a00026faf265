// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Length of a piece of a spiral: it lies between those of the arcs that touch it in its ends, as the three are convex
// curves one inside the other. And the area between an arc and its chord.
//
// Over a chord of length L an arc with bulge b is  L (1 + b^2) atan(b) / b  long, and between them is
//   A = L^2 / (8 b^2) ((1 + b^2)^2 atan b - b (1 - b^2))
//     = L^2 b / 3 (1 + b^2 / 5 - b^4 / 35 + ... + (-1)^k 3 b^(2k-2) / ((2k+1) (2k-1) (2k-3)) + ...),
// from circular sectors with the angle 4 atan b.  Both grow with |b|.  A is positive for a left turn: run through on
// the arc instead of the chord, a counterclockwise curve has more inside.

#ifndef BOUNDING_ARCS_LIBRARY_QUERY_LENS_H
#define BOUNDING_ARCS_LIBRARY_QUERY_LENS_H

#include <CGAL/Bounding_arcs_2/number/Bracket.h>
#include "../tree/Segment_hierarchy.h"
#include "query_units.h"

#include <algorithm>
#include <cmath>

namespace CGAL::Bounding_arcs::internal {

/// The factors of the series above, by k; a table, as quotients are not made while it is compiled where rounding
/// counts.
struct Lens_series {
  static constexpr int LAST_TERM = 10;
  double of[LAST_TERM + 1] = {};
  constexpr Lens_series() {
    for (int k = 2; k <= LAST_TERM; ++k) of[k] = (k % 2 == 0 ? 3.0 : -3.0) / ((2 * k + 1) * (2 * k - 1) * (2 * k - 3));
  }
};
inline constexpr Lens_series LENS_SERIES;

/// A / L^2.
/// \guarantee within 100 u of itself: the series errs by its first term left out, 2^-51 of itself, and 20 roundings;
///   the other form has differences that are at least b^2 of what they are made of, which multiplies 6 roundings by 16
[[nodiscard]] inline double lens_share(double b) {
  constexpr double SERIES = 0.25, FLAT = 0x1p-10;  // below that, b^6 is nothing beside 1
  const double square = b * b;
  if (std::fabs(b) > SERIES) {
    const double m = 1 + square;
    return (m * m * std::atan(b) - b * (1 - square)) / (8 * square);
  }
  double sum = 0;
  for (int k = std::fabs(b) < FLAT ? 3 : Lens_series::LAST_TERM; k >= 2; --k) sum = square * (LENS_SERIES.of[k] + sum);
  return b / 3 * (1 + sum);
}
[[nodiscard]] inline double length_share(double b) {
  constexpr double FLAT = 0x1p-30;  // below, atan b is b, and b^2 nothing beside 1
  return std::fabs(b) < FLAT ? 1 : (1 + b * b) * (std::atan(b) / b);
}

/// A piece between its samples: chord, and bulges of the arcs that touch the exact piece, between two bounds.
///
/// As in fat_arc a bulge errs by 1.1 times what the angles do; the chord by 2 e.
struct Lens {
  Xy<double> from, to;
  double chord, error;
  bool has_bulges;  ///< false where directions are open: a box is all that is known
  Bracket bulge{};

  Lens(const Spiral_piece_2& piece, double e) : from(piece.first.point), to(piece.last.point), error(e) {
    const End_bulges bulges(piece, e);
    chord = bulges.length;
    has_bulges = bulges.are_known();
    if (!has_bulges) return;
    const double b0 = bulges.first, b1 = bulges.last, room = 1.1 * bulges.angle_error;
    bulge = {std::clamp((std::min)(b0, b1) - room, -1.0, 1.0), std::clamp((std::max)(b0, b1) + room, -1.0, 1.0)};
  }

  /// The length of the exact piece; 4 e for the chord and for slivers beside its ends.
  [[nodiscard]] Bracket length() const {
    constexpr double DOWN = ROUNDED_DOWN<16>, UP = ROUNDED_UP<16>;
    const double low = chord, high = std::fabs(to.x - from.x) + std::fabs(to.y - from.y);
    if (!has_bulges) return {(std::max)(0.0, low * DOWN - 4 * error), high * UP + 4 * error};
    const bool has_both_signs = bulge.lower < 0 && bulge.upper > 0;
    const double b0 = std::fabs(bulge.lower), b1 = std::fabs(bulge.upper);
    const double least = has_both_signs ? 0 : (std::min)(b0, b1), most = (std::max)(b0, b1);
    return {(std::max)(0.0, low * length_share(least) * DOWN - 4 * error),
            (std::min)(low * length_share(most), high) * UP + 4 * error};
  }
};

/// What a piece leaves open of a sum.
struct Open_part {
  double width = 0;
  bool is_final = true;  ///< halving does not help
};

/// Returns pieces of a drawing fine enough for a sum over them: the one that leaves most open is halved, until all
/// together leave open no more than a tolerance, or halving does not help, or there are as many as a limit allows.
/// \param open gives the Open_part of a piece
/// \param limit of halvings; where it is reached the rest stays as it is
/// \return the pieces in any order
template <class Open>
[[nodiscard]] std::vector<Spiral_piece_2> refine_sum(const Segment_hierarchy& curves,
                                                     const std::vector<Spiral_piece_2>& pieces, double tolerance,
                                                     const Open& open, Work_limit& limit) {
  struct Entry {
    Open_part open;
    Spiral_piece_2 piece;
  };
  const auto is_less = [](const Entry& a, const Entry& b) { return a.open.width < b.open.width; };
  std::vector<Spiral_piece_2> done;
  std::vector<Entry> heap;
  double sum = 0;
  heap.reserve(pieces.size());
  for (const Spiral_piece_2& p : pieces) heap.push_back({open(p), p});
  for (const Entry& e : heap) sum += e.open.width;
  std::make_heap(heap.begin(), heap.end(), is_less);
  while (!heap.empty() && !(sum <= tolerance)) {
    if (!heap.front().open.is_final && !limit.spend()) break;
    std::pop_heap(heap.begin(), heap.end(), is_less);
    const Entry widest = heap.back();
    heap.pop_back();
    const auto middle = widest.open.is_final ? std::optional<Spiral_halves_2>() : halves(curves, widest.piece);
    if (!middle) {
      done.push_back(widest.piece);
      continue;
    }
    const Entry parts[2] = {{open(middle->first), middle->first}, {open(middle->second), middle->second}};
    sum += (parts[0].open.width + parts[1].open.width) - widest.open.width;
    for (const Entry& e : parts) {
      heap.push_back(e);
      std::push_heap(heap.begin(), heap.end(), is_less);
    }
  }
  for (const Entry& e : heap) done.push_back(e.piece);
  return done;
}

}  // namespace CGAL::Bounding_arcs::internal

#endif
