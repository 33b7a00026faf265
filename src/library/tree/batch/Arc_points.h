// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The points of a segment for regions in hand, and how far these regions may be from the exact curve.
//
// A point is C(middle), rounded from twice the digits, and the local polynomial's way from there.  With u = 2^-53, h
// the segment's half length and c_k its Taylor coefficients, each coordinate errs by half an ulp of the largest one for
// C(middle), as much for the last sum, and for the way, by Horner's scheme, (3 k + 1) u |c_k| h^k in its k-th term: one
// of the coefficient, k of sigma, k products and k sums.  The ends of the segment err by half an ulp.
//
// The widening.  A curve piece lies in its region R of exact numbers.  In doubles a side p0 + (p1 - p0) z, z over the
// unit chord, has both ends moved by a vector no longer than e, its joint by rounding, and its bulges changed by db.  A
// point moves by e (|1 - z| + |z|) <= MOST_MOVED e for the first, which each method tells for its regions, and c/2 db
// for the last: two arcs over one chord c are so far from each other.  What lies between the sides moves as they do.
// A joint is p0 + (p1 - p0) z in doubles: half an ulp in each coordinate of the sum, and what the product errs by is
// part of what z does.  So the piece is within
//   MOST_MOVED e + 0.71 ulp + what joints and bulges err by
// of R in doubles.
//
// Ends are rounded parameters, up to half an ulp, u / 2 or less, beyond the true cut: the curve beyond it, no longer
// than d = u V / 2 with V >= |C'|, is no part of the spiral.  It is within d of the end, and that end and the
// directions there move the region by less than 2 d: the chord's direction turns by d / c and the tangent's by kappa d
// <= 2 d / c, which is half that in a bulge.  Where regions have osculating circles it matters only that they stay
// nested, that is, beyond vertices: there they stand still, as kappa' = 0, and what touches them moves along.
//
// So the widening is 8 ulp of the largest coordinate for all segments where this leaves room for what joints and
// bulges err by (Bca_arcs.h, Bilens_arcs.h, Spiral_fat_arc_arcs.h), 1 ulp at least. Segments as long as the whole
// drawing may need more, and have as much as leaves 2 ulp, but no more than regions that are made one by one.
// Coarse pieces, whose own size makes bulges err by more, have 64 ulp more, which is nothing beside their thickness:
// made one by one, a tenth of the regions at an eps of 1e-3 would take most of the time.

#ifndef BOUNDING_ARCS_LIBRARY_TREE_BATCH_ARC_POINTS_H
#define BOUNDING_ARCS_LIBRARY_TREE_BATCH_ARC_POINTS_H

#include <CGAL/Bounding_arcs_2/number/Xy.h>
#include <CGAL/Bounding_arcs_2/number/strict_math.h>
#include <CGAL/Bounding_arcs_2/spiral/Segment_place.h>
#include "../../spiral/Local_curve.h"
#include "Batch_questions.h"

#include <cmath>
#include <cstddef>

namespace CGAL::Bounding_arcs::filter {

inline constexpr int WIDENING_ULPS = 8, LEAST_ROOM_ULPS = 1, WIDER_ROOM_ULPS = 2, COARSE_ROOM_ULPS = 64;

/// Bounds of a rational curve's weights in the segment: the least and the largest of their Bernstein coefficients.
struct Weights {
  double least, most;
};
template <int KIND>
[[nodiscard]] CGAL_BOUNDING_ARCS_INLINE Weights weights_of(const Local_form<double>& form, double half) {
  constexpr int DEGREE = degree_of_kind(KIND);
  double c[std::size_t(DEGREE) + 1],
      power = 1;  // Taylor coefficients about the segment's start, in units of its length
#pragma GCC unroll 16
  for (int k = 0; k <= DEGREE; ++k, power *= half) c[k] = form.coefficients.w[k] * power;
#pragma GCC unroll 16
  for (int i = 0; i < DEGREE; ++i)
#pragma GCC unroll 16
    for (int k = DEGREE - 1; k >= i; --k) c[k] -= c[k + 1];
  power = 1;
#pragma GCC unroll 16
  for (int k = 0; k <= DEGREE; ++k, power *= 2) c[k] *= power;
  Weights w{HUGE_VAL, 0};
#pragma GCC unroll 16
  for (int i = 0; i <= DEGREE; ++i) {
    double sum = 0, ratio = 1;  // binomial(i, k) / binomial(DEGREE, k)
#pragma GCC unroll 16
    for (int k = 0; k <= i; ++k) {
      sum += ratio * c[k];
      ratio = ratio * (i - k) / (DEGREE - k > 0 ? DEGREE - k : 1);
    }
    w = {sum < w.least ? sum : w.least, sum > w.most ? sum : w.most};
  }
  return w;
}

/// \param half of the segment's length
/// \tparam Arcs of the regions to be made
template <class Arcs, int KIND>
[[nodiscard]] CGAL_BOUNDING_ARCS_INLINE Arc_room arc_room(const Local_form<double>& form, double half,
                                                          const Point_sizes& sizes) {
  constexpr double U = Local_precision<double>::HALF_ULP, OF_JOINTS = HAS_JOINTS<Arcs> ? 0.71 : 0;
  constexpr int DEGREE = degree_of_kind(KIND);
  const auto& c = form.coefficients;
  Xy<double> most, way, speed;  // bounds of the numerator, its error in u, and its derivative
  double weight_error = 0, weight_speed = 0, power = 1;
#pragma GCC unroll 16
  for (int k = 1; k <= DEGREE; ++k) {
    const double errors = 3 * k + 1, x = std::fabs(c.x[k]) * power, y = std::fabs(c.y[k]) * power;
    speed = {speed.x + k * x, speed.y + k * y};
    most = {most.x + x * half, most.y + y * half};
    way = {way.x + errors * (x * half), way.y + errors * (y * half)};
    if constexpr (is_rational_kind(KIND)) {
      const double w = std::fabs(c.w[k]) * power;
      weight_speed += k * w;
      weight_error += errors * (w * half);
    }
    power *= half;
  }
  if constexpr (is_rational_kind(KIND)) {
    constexpr double SLACK = 1 + 0x1p-20;  // for second order
    const Weights weights = weights_of<KIND>(form, half);
    const double inverse = SLACK / weights.least, of_weight = (weight_error + weights.most) * inverse + 1;
    way = {inverse * (way.x + most.x * of_weight), inverse * (way.y + most.y * of_weight)};
    weight_speed *= inverse;
    speed = {inverse * (speed.x + most.x * weight_speed), inverse * (speed.y + most.y * weight_speed)};
  }
  const double unit = form.unit, ulp = sizes.ulp, ex = ulp + U * (way.x * unit), ey = ulp + U * (way.y * unit),
               points = Arcs::MOST_MOVED * std::sqrt(ex * ex + ey * ey) + OF_JOINTS * ulp,
               beyond = U * (std::sqrt(speed.x * speed.x + speed.y * speed.y) * unit);
  const double needed = points + beyond, usual = WIDENING_ULPS * ulp;
  const double widening = usual - needed >= LEAST_ROOM_ULPS * ulp ? usual : needed + WIDER_ROOM_ULPS * ulp;
  constexpr double LEAST = 0x1p-900, MOST = 0x1p900;  // between which C(middle) is that accurate
  const double size = sizes.coordinate_size;
  const bool has_room = (size >= LEAST) & (size <= MOST) & ((widening == usual) | (widening <= sizes.most_widening));
  const double room = has_room ? (widening - needed) / unit : -1;
  // What may be missing beside cuts counts where it is more than polynomial curves may have, whose |C'| is at most
  // twice the degree times the largest coordinate.
  const double of_polynomials = CUT_WIDTH * (2 * DEGREE * size);
  const double missing = sizes.cut_error > of_polynomials ? sizes.cut_error : 0;
  const double coarse = COARSE_ROOM_ULPS * ulp;
  return {widening + missing, room, widening + coarse + missing, room + coarse / unit};
}

}  // namespace CGAL::Bounding_arcs::filter

#endif
