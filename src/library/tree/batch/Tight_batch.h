// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// A batch's figures of a piece seen from its tight end, as Tight_frame_2 is for single pieces, with relative errors:
// what the wide forms of bilens and spiral fat arcs are made of.
//
// Wide pieces may have any angles below a right one; their formulas are those of the single pieces, with square roots.
// Errors of N, knesers and turn rates are formed as quotients, and ROUNDING, of 16 rho, stands for the factors within
// rho in each of the steps where errors are gathered: a dot has rho, and a cross no more than rho of the dot beside it,
// so a length has 2 rho; sin delta = s^2 N / (l0 l1 cos delta) has two lengths and 3 rho of cos delta, which is above
// sqrt(1/2); a corner and K_flat have at most 15, and sin m has 6, or with the error of the turn rates what a p and
// s^2 d r cancel to.

#ifndef BOUNDING_ARCS_LIBRARY_TREE_BATCH_TIGHT_BATCH_H
#define BOUNDING_ARCS_LIBRARY_TREE_BATCH_TIGHT_BATCH_H

#include "Batch_bounds.h"

#include <CGAL/Bounding_arcs_2/number/strict_math.h>
#include "../../spiral/Local_figures.h"

#include <algorithm>
#include <cmath>

namespace CGAL::Bounding_arcs::filter {

/// A batch's figures of a piece seen from its tight end, with relative errors: what the wide forms of bilens and spiral
/// fat arcs are made of.
struct Tight_batch {
  // in parts of rho
  static constexpr double OF_LENGTH = 2, OF_COS_DELTA = 3, OF_SIN_DELTA = 2 * OF_LENGTH + OF_COS_DELTA, OF_CORNER = 15,
                          OF_K_FLAT = 15, OF_SIN_MEAN = 6;
  static_assert(covers(Local_precision<double>::MOST_FACTORS,
                       (std::max)({OF_SIN_DELTA, OF_CORNER, OF_K_FLAT, OF_SIN_MEAN}) + OF_OPERATIONS<double>),
                "update the derivation above");

  double numerator;                  ///< N = a r + d p
  double chord;                      ///< a length of the plane
  double cross_tight, cross_flat;    ///< T x D
  double dot_tight, dot_flat;        ///< T . D
  double length_tight, length_flat;  ///< |T| |D|
  double square_tight, square_flat;  ///< |T|^2
  double turn_rate_tight, turn_rate_flat, kneser_tight, kneser_flat;
  double sin_delta, cos_delta, cos_mean;
  double numerator_error, kneser_tight_error, kneser_flat_error;  ///< relative errors
  bool holds;  ///< a strict spiral for certain, and its figures are that exact
};

[[nodiscard]] CGAL_BOUNDING_ARCS_INLINE Tight_batch tight_batch(const Local_form<double>& c,
                                                                const Local_piece<double>& g,
                                                                const Local_ends<double>& e) {
  constexpr double CERTAIN = Local_precision<double>::CERTAIN;
  Tight_batch t;
  const double dot0 = g.p - g.half * g.r, dot1 = g.p + g.half * g.r, product = dot0 * dot1;
  const double cross0 = g.half * (g.a + g.half * g.d), cross1 = g.half * (g.a - g.half * g.d);
  const double length0 = std::sqrt(dot0 * dot0 + cross0 * cross0), length1 = std::sqrt(dot1 * dot1 + cross1 * cross1);
  const double lengths = length0 * length1, both = cross0 * cross1;
  t.numerator = g.a * g.r + g.d * g.p;
  t.chord = std::sqrt(g.chord_square) * (2 * g.half * c.unit);
  t.cross_tight = cross0;
  t.cross_flat = cross1;
  t.dot_tight = dot0;
  t.dot_flat = dot1;
  t.length_tight = length0;
  t.length_flat = length1;
  t.square_tight = e.square0;
  t.square_flat = e.square1;
  t.turn_rate_tight = e.turn_rate0;
  t.turn_rate_flat = e.turn_rate1;
  t.kneser_tight = e.kneser0;
  t.kneser_flat = e.kneser1;
  t.cos_delta = std::sqrt(0.5 + 0.5 * ((product + both) / lengths));
  t.cos_mean = std::sqrt(0.5 + 0.5 * ((product - both) / lengths));
  t.sin_delta = g.square * t.numerator / (lengths * t.cos_delta);
  t.numerator_error = c.numerator_error / t.numerator;
  t.kneser_tight_error = c.kneser_error / t.kneser_tight;
  t.kneser_flat_error = c.kneser_error / t.kneser_flat;
  t.holds = (dot0 >= c.least_dot) & (dot1 >= c.least_dot) & (g.chord_square >= c.least_square) &
            (e.square0 >= c.least_tangent) & (e.square1 >= c.least_tangent) & (g.a >= CERTAIN * c.turn_rate_error) &
            (t.numerator >= CERTAIN * c.numerator_error) & (t.kneser_tight >= CERTAIN * c.kneser_error) &
            (t.kneser_flat >= CERTAIN * c.kneser_error) & (both > 0) & (product > both) &
            (product + product >= g.p * g.p);
  return t;
}

/// thickness (1 +- error), the error being of first order; nothing where `holds` is false, or where it is more than
/// LARGEST_SUM.
[[nodiscard]] CGAL_BOUNDING_ARCS_INLINE Bracket tight_bounds(double thickness, double error, bool holds) {
  constexpr double UNDERFLOW_LENGTH = Local_precision<double>::UNDERFLOW_LENGTH;
  constexpr double LARGEST = LARGEST_SUM<double>, HIGHER_ORDERS = 0x1p-4, ROOM = 25;
  static_assert(covers(HIGHER_ORDERS * LARGEST, ROOM * (with_second_order<double>(LARGEST) - LARGEST)),
                "update the derivation in Batch_bounds.h");
  const double whole = error * (1 + HIGHER_ORDERS);
  const bool valid = holds & (error <= LARGEST) & (thickness > 0) & (thickness < HUGE_VAL);
  return {valid ? thickness * (1 - whole) - UNDERFLOW_LENGTH : -1.0,
          valid ? thickness * (1 + whole) + UNDERFLOW_LENGTH : HUGE_VAL};
}

}  // namespace CGAL::Bounding_arcs::filter

#endif
