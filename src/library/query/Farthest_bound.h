// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// How far points of a piece of one curve are at most from another curve, by the nearest points of its two ends.
//
// Let a(x), x in [0, 1], run through the piece with the constant speed l, b(x) in any way through points of the other
// curve: no point of the piece is farther than max |D|, D = a - b.  Two choices of b are bounded.
//
// Through the curve between both nearest points, with the constant speed m, where that is a piece of one spiral too:
//   D'' = l^2 k_a n_a - m^2 k_b n_b,  and for f = |D|^2,  -f''/2 <= -(l - m)^2 - l^2 k_a n_a.D + m^2 k_b n_b.D,
// as |D'| >= |l - m|.  D is within |D''| / 8 of a convex combination of its ends, and n is a combination of the normals
// at the ends of a piece with a sum of coefficients between 1 and 1 / cos(turn / 2), so that values at ends bound all.
// Then  |D| <= max(|D0|, |D1|) + |D''| / 8  and  f <= max(f0, f1) + max(0, -f''/2) / 4.
//
// Either of the nearest points b0, b1 alone, m = 0: f <= (1-x) f0 + x f1 + max(0, -f''/2) / 4, and no point of the
// piece is farther than the larger of two such functions' minima allows: where b0 and b1 are on different parts of the
// curve, that is where the lines cross.
//
// All but the last summand is exact in the limit, and it is of second order; of third for curves which are parallel.

#ifndef BOUNDING_ARCS_LIBRARY_QUERY_FARTHEST_BOUND_H
#define BOUNDING_ARCS_LIBRARY_QUERY_FARTHEST_BOUND_H

#include "../tree/Spiral_piece_2.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>

namespace CGAL::Bounding_arcs::internal {

/// A piece of a spiral between two samples, as the bounds use it.
struct Bent_piece {
  double least_length = 0, length = 0;  ///< bounds of the length
  double least = 0, most = 0;           ///< bounds of |curvature|
  double open = 1;                      ///< at least 1 / cos(turn / 2)
  double unsure = 0;                    ///< sines of angles that directions may be off by
  Xy<double> normals[2];                ///< to the side that it turns to
  bool is_known = false;                ///< curvature and directions have bounds

  /// \param error how far the points may be from the exact ones
  Bent_piece(const Spiral_sample& p, const Spiral_sample& q, double error) {
    const Xy<double> chord = q.point - p.point;
    const double size = euclidean_norm(chord);
    constexpr double UP = ROUNDED_UP<16>, GOOD = 0x1p-10, LEAST_COSINE = -0.5;
    unsure = tangent_error(p, q) + TANGENT_ROUNDING;
    least_length = (std::max)(0.0, size * (2 - UP) - 2 * error);
    length = (std::fabs(chord.x) + std::fabs(chord.y)) * UP + 4 * error;
    most = (std::max)(p.most_curvature, q.most_curvature);
    least = (std::min)(p.least_curvature, q.least_curvature);
    const double cosine = dot(p.tangent, q.tangent) - 2 * unsure;
    is_known = most < 0x1p500 && unsure <= GOOD && cosine >= LEAST_COSINE;
    if (!is_known) return;
    open = std::sqrt(2 / (1 + cosine)) * UP;
    length = (std::min)(length, (size + 2 * error) * open * UP);
    // tangents are those of growing parameters, in whatever order the ends are
    const double turn = (cross(p.tangent, q.tangent) < 0) == (p.t <= q.t) ? -1 : 1;
    normals[0] = turn * perp(p.tangent);
    normals[1] = turn * perp(q.tangent);
  }
  /// An upper bound of k n.d for d within `beside` of combinations of two vectors that are no longer than `size`.
  [[nodiscard]] double bend_along(const Xy<double>& d0, const Xy<double>& d1, double size, double beside) const {
    double along = -std::numeric_limits<double>::infinity();
    for (const Xy<double>& n : normals) along = (std::max)({along, dot(n, d0), dot(n, d1)});
    along += 2 * unsure * size;  // twice, as n may be such a sum
    return (along > 0 ? most * along * open : least * along) + most * beside;
  }

  /// An upper bound of l^2 times a number that is at most so large.
  [[nodiscard]] double times_square(double most_factor) const {
    const double l = most_factor > 0 ? length : least_length;
    return l * l * most_factor;
  }
};

/// An upper bound of |D|^2 along a piece by a line through the squares at both ends and so much more.
struct Raised_line {
  double first, last;
};
/// An upper bound of the largest of the lesser of both.
[[nodiscard]] inline double largest_of_lesser(const Raised_line& p, const Raised_line& q) {
  const double start = p.first - q.first, end = p.last - q.last;
  const double of_ends = (std::max)((std::min)(p.first, q.first), (std::min)(p.last, q.last));
  if (start < 0 ? !(end > 0) : !(end < 0)) return of_ends;
  const double share = start / (start - end);
  return (std::max)(of_ends, p.first + share * (p.last - p.first));
}

/// Roundings of the sums below, f0 or f1 being no larger than the square of a size.
[[nodiscard]] inline double rounding_of_rise(const Bent_piece& p, double size) {
  return 32 * HALF_ULP * (size * size + p.length * p.length * (1 + p.most * size));
}

/// The squared distance from one point of the other curve.
[[nodiscard]] inline Raised_line from_point(const Bent_piece& piece, const Xy<double>& d0, const Xy<double>& d1) {
  const double f0 = dot(d0, d0), f1 = dot(d1, d1), square = piece.length * piece.length;
  const double size = std::sqrt((std::max)(f0, f1));
  const double bend = piece.times_square(piece.bend_along(-d0, -d1, size, piece.most * square / 8));
  const double rise =
      (std::max)(0.0, bend - piece.least_length * piece.least_length) / 4 + rounding_of_rise(piece, size);
  return {f0 + rise, f1 + rise};
}

/// An upper bound of |D| where b runs from one nearest point to the other.
[[nodiscard]] inline double from_piece(const Bent_piece& a, const Bent_piece& b, const Xy<double>& d0,
                                       const Xy<double>& d1) {
  const double f = (std::max)(dot(d0, d0), dot(d1, d1)), size = std::sqrt(f);
  double apart = a.unsure + b.unsure;  // of normals
  for (const Xy<double>& n : a.normals)
    for (const Xy<double>& k : b.normals) apart = (std::max)(apart, euclidean_norm(n - k) + a.unsure + b.unsure);
  const double most_a = a.times_square(a.most), most_b = b.times_square(b.most),
               least_a = a.least_length * a.least_length * a.least, least_b = b.least_length * b.least_length * b.least;
  const double second = (std::max)({most_a - least_b, most_b - least_a, 0.0}) +
                        (std::min)(most_a, most_b) * (std::min)(2.0, apart * a.open * b.open);
  const double slip = (std::max)({0.0, a.least_length - b.length, b.least_length - a.length});
  const double fall = a.times_square(a.bend_along(-d0, -d1, size, second / 8)) +
                      b.times_square(b.bend_along(d0, d1, size, second / 8)) - slip * slip;
  const double square = f + (std::max)(0.0, fall) / 4 + rounding_of_rise(a, size) + rounding_of_rise(b, size);
  return (std::min)(size + second / 8 * ROUNDED_UP<16>, std::sqrt(square));
}

}  // namespace CGAL::Bounding_arcs::internal

#endif
