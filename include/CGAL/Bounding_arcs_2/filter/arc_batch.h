// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Points and bulges of consecutive pieces of a spiral segment at once, in plain loops without branches: narrow forms
// for all, and wide ones for those groups of eight that have a piece which is not narrow.  A piece's numbers are the
// same bits in every batch and on every instruction set.

#ifndef CGAL_BOUNDING_ARCS_2_FILTER_ARC_BATCH_H
#define CGAL_BOUNDING_ARCS_2_FILTER_ARC_BATCH_H

#include <CGAL/Bounding_arcs_2/filter/Arc_points.h>
#include <CGAL/Bounding_arcs_2/filter/Bca_arcs.h>
#include <CGAL/Bounding_arcs_2/filter/bound_batch.h>

#include <cstddef>
#include <cstdint>

namespace CGAL::Bounding_arcs::filter {

/// Where the numbers of consecutive pieces go, one place a piece: its first point and its two bulges. Up to a multiple
/// of eight places are written, and one more of points, the last ones with numbers that nobody reads.
struct Arc_places {
  double *x, *y, *inner, *outer;
};

template <int DEGREE>
[[nodiscard, gnu::always_inline]] inline Xy<double> local_point(const Local_coefficients<double>& c,
                                                                const Arc_points& points, double sigma) {
  double x = c.x[DEGREE], y = c.y[DEGREE];
#pragma GCC unroll 8
  for (int k = DEGREE - 1; k >= 1; --k) {
    x = c.x[k] + sigma * x;
    y = c.y[k] + sigma * y;
  }
  return {points.middle.x + points.unit.x * (sigma * x), points.middle.y + points.unit.y * (sigma * y)};
}

template <class Isa, int DEGREE, bool WIDE, std::size_t SIZE>
void make_arcs(const Local_curve& curve, const Arc_points& points, const double* __restrict begins,
               const double* __restrict ends, std::size_t groups, double* __restrict x, double* __restrict y,
               double* __restrict inner, double* __restrict outer, double* __restrict fails) {
  const double turn = points.turn, room = points.room, direction = curve.direction, middle = curve.middle;
  for (std::size_t j = 0; j < SIZE * groups; ++j) {
    const double from = begins[j] - middle, half = 0.5 * (ends[j] - begins[j]);
    const Xy<double> p = local_point<DEGREE>(curve.form.coefficients, points, direction * from);
    x[j] = p.x;
    y[j] = p.y;
    const Local_piece<double> g = local_piece<DEGREE>(curve.form.coefficients, direction * (from + half), half);
    const Bca_bulges b = WIDE ? Bca_arcs::wide(g) : Bca_arcs::narrow(g);
    inner[j] = turn * b.inner;
    outer[j] = turn * b.outer;
    fails[j] = (b.holds & Bca_arcs::is_within(curve.form, g, b.outer, room)) ? 0.0 : 1.0;
  }
}

/// Of up to 64 pieces.
/// \param breaks count + 1 parameters, and behind them as many more as a multiple of eight pieces takes
/// \tparam SIZE pieces in a group: those of the widest registers, or 1 for few pieces
/// \return a bit a piece, the first lowest, that is not made: neither form holds, or the widening might be too small
template <class Isa, int DEGREE, std::size_t SIZE = GROUP<double>>
std::uint64_t arc_batch(const Local_curve& curve, const Arc_points& points, const double* breaks, std::size_t count,
                        const Arc_places& to) {
  const std::size_t groups = (count + SIZE - 1) / SIZE;
  alignas(BATCH_ALIGNMENT) double fails[BATCH_SIZE];
  make_arcs<Isa, DEGREE, false, SIZE>(curve, points, breaks, breaks + 1, groups, to.x, to.y, to.inner, to.outer, fails);
  const double end = curve.direction * (breaks[SIZE * groups] - curve.middle);
  const Xy<double> last = local_point<DEGREE>(curve.form.coefficients, points, end);
  to.x[SIZE * groups] = last.x;
  to.y[SIZE * groups] = last.y;
  double some = 0;
  for (std::size_t j = 0; j < count; ++j) some = some + fails[j];
  if (some == 0) return 0;
  std::uint64_t open = 0;
  for (std::size_t g = 0; g < groups; ++g) {
    double any = 0, unread[2][SIZE], inner[SIZE], outer[SIZE], wide_fails[SIZE];
    const std::size_t asked = count - SIZE * g < SIZE ? count - SIZE * g : SIZE;
    for (std::size_t i = 0; i < asked; ++i) any = any + fails[SIZE * g + i];
    if (any == 0) continue;
    make_arcs<Isa, DEGREE, true, SIZE>(curve, points, breaks + SIZE * g, breaks + SIZE * g + 1, 1, unread[0], unread[1],
                                       inner, outer, wide_fails);
    for (std::size_t i = 0, j = SIZE * g; i < asked; ++i, ++j) {
      if (fails[j] == 0) continue;
      to.inner[j] = inner[i];
      to.outer[j] = outer[i];
      if (wide_fails[i] != 0) open |= std::uint64_t(1) << j;
    }
  }
  return open;
}

}  // namespace CGAL::Bounding_arcs::filter

#endif
