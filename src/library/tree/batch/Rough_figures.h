// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The figures of a batch's pieces in float: made in one loop and used in the next, as turns of loops with short chains
// of operations overlap, and those of one long loop do not.
//
// Float decides nearly all pieces, and those that it cannot are decided again in double, so its formulas are short:
// products under one or two fraction bars, no series, and one bound E of the relative error for all pieces (ROUGH_ERROR
// of each method) instead of one for each.  E counts the worst that all figures can do together; on random pieces it is
// used up to a twentieth, on pieces sought for it up to a fifteenth.

#ifndef BOUNDING_ARCS_LIBRARY_TREE_BATCH_ROUGH_FIGURES_H
#define BOUNDING_ARCS_LIBRARY_TREE_BATCH_ROUGH_FIGURES_H

#include "Batch_bounds.h"

#include <CGAL/Bounding_arcs_2/number/strict_math.h>
#include "../../spiral/Local_figures.h"
#include "Batch_questions.h"

#include <cstddef>

namespace CGAL::Bounding_arcs::filter {

/// The figures of up to 64 pieces.
struct alignas(BATCH_ALIGNMENT) Rough_figures {
  float chord_square[BATCH_SIZE], p[BATCH_SIZE], r[BATCH_SIZE], a[BATCH_SIZE], d[BATCH_SIZE];
  float square0[BATCH_SIZE], square1[BATCH_SIZE], turn_rate0[BATCH_SIZE], turn_rate1[BATCH_SIZE], kneser0[BATCH_SIZE],
      kneser1[BATCH_SIZE];

  CGAL_BOUNDING_ARCS_INLINE void set(std::size_t j, const Local_piece<float>& g) {
    chord_square[j] = g.chord_square;
    p[j] = g.p;
    r[j] = g.r;
    a[j] = g.a;
    d[j] = g.d;
  }
  CGAL_BOUNDING_ARCS_INLINE void set(std::size_t j, const Local_piece<float>& g, const Local_ends<float>& e) {
    set(j, g);
    square0[j] = e.square0;
    square1[j] = e.square1;
    turn_rate0[j] = e.turn_rate0;
    turn_rate1[j] = e.turn_rate1;
    kneser0[j] = e.kneser0;
    kneser1[j] = e.kneser1;
  }
  /// What was set. \param half half the pieces' length
  [[nodiscard]] CGAL_BOUNDING_ARCS_INLINE Local_piece<float> piece(std::size_t j, float half) const {
    Local_piece<float> g{};
    g.half = half;
    g.square = half * half;
    g.chord_square = chord_square[j];
    g.p = p[j];
    g.r = r[j];
    g.a = a[j];
    g.d = d[j];
    return g;
  }
  [[nodiscard]] CGAL_BOUNDING_ARCS_INLINE Local_ends<float> ends(std::size_t j) const {
    return {square0[j], square1[j], turn_rate0[j], turn_rate1[j], kneser0[j], kneser1[j]};
  }
};

}  // namespace CGAL::Bounding_arcs::filter

#endif
