// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The sides of spiral fat arcs in plain double, for batches.  Over the unit chord (Half_tangents.h), with sigma^2 = a /
// K0 the square of the tangent from the flat end to the tight end's circle, so that sin alpha0 / K0 = 1 - sigma^2, the
// inner side's joint, at which its arc has turned by twice the angle of sigma + e^(i alpha0), is
//   j = (1 - sigma^2) / (1 + sigma e^(i alpha0)).
// The outer side's is i = reach e^(-i alpha0), and its arc turns by twice the angle from 1 - i to e^(i alpha1).  In
// figures of a piece, with beta and F of Spiral_fat_arc_batch.h times s kneser1,
//   i = s kneser1 (dot0 - i cross0) / (beta + sqrt(beta^2 + F turn_rate1)),
//   beta = s (N |T1|^2 + kneser1 dot0),   F = s kneser1 |T0|^2 |M|^4,   sigma^2 = s kneser0 / (turn_rate0 |M|^2).
//
// Errors, as they move a side, in units of half the chord:
//  * sigma.  The inner side with another sigma is that of another circle at the tight end, K = sin alpha0 / (1 -
//    sigma^2); its arc is |j| <= (1 - sigma^2) / (1 + sigma^2)^(1/2) long and moves off by 2 dK |j|^2 <= 2 sin alpha0
//    d(sigma^2) <= 4 t d(sigma^2), and the segment from its end by less.
//  * reach.  The outer side with another reach is that of another circle at the flat end. The corner moves along a line
//    that makes the angle 2 (delta + arg(1 - i)) with the arc there, by reach times the relative error of reach, where
//    delta <= t - f. i = k / (b + sqrt(b^2 + c)) errs in each of its factors by no more than these, with weights up to
//    1: N, kneser1, |T|^2 and half of another, M.M, a dot; and half of what F of its error is of the radicand.
//  * the end angles (Half_tangents.h).  On the inner side, alpha0 alone moves j by 0.17 of the chord and changes the
//    arc's turn by half, and so its middle by a quarter of the chord. On the outer side alpha0 moves i by reach <= 0.7
//    of the chord, and alpha1 the arc by a quarter of it: 1.9 of half the chord at most.
//  * roundings of j, relative ones.  Along the chord, from which tangents turn away by alpha <= 2 bend at most, j errs
//    by 23 u (9 of the square, 5 of division and products, 9 of other factors); across it is up to alpha0 / 2 <= bend
//    of half its length long and errs by 22 u.  The errors of i, along its side, are 6 u.  In the plane, differences of
//    points and products add 4 u of lengths.
//  * roundings of bulges, 15 u over half the chord, the outer one's from a direction that errs by as much; and of half
//    tangents.
// Small parts of the room are for N, M.M and turn rates each, and what is left for knesers, |T|^2, E, angles and
// roundings together, times what is divided by.

#ifndef BOUNDING_ARCS_LIBRARY_TREE_BATCH_SPIRAL_FAT_ARC_ARCS_H
#define BOUNDING_ARCS_LIBRARY_TREE_BATCH_SPIRAL_FAT_ARC_ARCS_H

#include "Bca_arcs.h"
#include "Half_tangents.h"

#include <CGAL/Bounding_arcs_2/number/strict_math.h>

#include <algorithm>
#include <cmath>

namespace CGAL::Bounding_arcs::filter {

/// The sides of spiral fat arcs in plain double.
struct Spiral_fat_arc_arcs {
  static constexpr double MOST_MOVED = Bca_arcs::MOST_MOVED;  ///< which is asked of the corner

  template <bool WIDE>
  [[nodiscard]] CGAL_BOUNDING_ARCS_INLINE static Joint_arcs of(const Local_form<double>& c,
                                                               const Local_piece<double>& g,
                                                               const Local_ends<double>& e, double room) {
    constexpr double CERTAIN = Local_precision<double>::CERTAIN;
    const Half_tangents h = Half_tangents::of<WIDE>(g);
    const double t = h.tight, f = h.flat, tt = t * t, ff = f * f, g0 = 1 + tt, cos0 = 1 - tt, sin0 = t + t,
                 cos1 = 1 - ff, sin1 = f + f;  // times 1 + t^2 and 1 + f^2
    const double stretch_square = g.half * e.kneser0 / (e.turn_rate0 * g.chord_square),
                 stretch = std::sqrt(stretch_square);
    // j = (1 - sigma^2) (1 + sigma e^(-i alpha0)) / |1 + sigma e^(i alpha0)|^2
    const double inner_x = stretch * g0 + cos0, inner_square = inner_x * inner_x + sin0 * sin0;
    const double inner_divisor = bulge_divisor<WIDE>(inner_x, inner_square);
    // i, and the direction from it to the flat end, times the divisor
    const double step = g.half * g.r, dot0 = g.p - step, dot1 = g.p + step, product = dot0 * dot1;
    const double numerator = g.a * g.r + g.d * g.p, sk = g.half * e.kneser1;
    const double beta = g.half * (numerator * e.square1) + sk * dot0,
                 flatness = sk * (e.square0 * (g.chord_square * g.chord_square)),
                 radicand = beta * beta + flatness * e.turn_rate1, divisor = beta + std::sqrt(radicand);
    const double cross0 = g.half * (g.a + g.half * g.d), ix = sk * dot0, iy = sk * cross0;
    const double wx = divisor - ix, wy = iy, re = cos1 * wx + sin1 * wy, im = sin1 * wx - cos1 * wy;
    const double outer_divisor = bulge_divisor<WIDE>(re, re * re + im * im);
    const double inners = inner_divisor * inner_square, outers = divisor * outer_divisor,
                 inverse = 1 / (inners * outers * wx);
    const double of_inner = inverse * (outers * wx), of_outer = inverse * (inners * wx);
    const double joint = (1 - stretch_square) * g0 * (of_inner * inner_divisor), corner = of_outer * outer_divisor;
    const Joint_side inner{(g0 + stretch * cos0) * joint, -(stretch * sin0) * joint,
                           bulge_of<WIDE>(sin0 * (of_inner * inner_square)), 0.0};
    const Joint_side outer{ix * corner, -(iy * corner), 0.0, bulge_of<WIDE>(im * (of_outer * divisor))};
    const Arc_errors errors = arc_errors(c, g, h);
    const double aside = outer.x - 0.5, shape = aside * aside * OF_ELLIPSE_X + outer.y * outer.y * OF_ELLIPSE_Y;
    const double kneser = e.kneser0 < e.kneser1 ? e.kneser0 : e.kneser1,
                 square = e.square0 < e.square1 ? e.square0 : e.square1;
    const double reach = outer.x - outer.y, corner_angle = (t > f ? t - f : 0.0) + wy * (inverse * (inners * outers));
    const double inner_moved = 4 * errors.half_chord * (t * stretch_square),
                 outer_moved = 4 * errors.half_chord * (corner_angle * reach);
    const double moved = inner_moved > outer_moved ? inner_moved : outer_moved;
    const double angles =
        ANGLES * errors.turn + OF_REACH * (corner_angle * reach) * (errors.of_dot + 12 * U * errors.dot);
    const double roundings = errors.dot * (OF_PLANE + OF_BEND * errors.bend);
    const double of_ends = moved * (c.kneser_error * square + 1.5 * (c.least_tangent * ERROR) * kneser);
    const double left = FOR_OTHERS * room * errors.dot - errors.half_chord * (angles + roundings),
                 most_of_ends = left * (kneser * square);
    const bool holds = errors.holds & (t >= 0) & (shape <= 1) & (square >= c.least_tangent) &
                       (numerator >= CERTAIN * c.numerator_error) & (kneser >= CERTAIN * c.kneser_error) &
                       (e.turn_rate0 >= c.least_turn_rate) & (stretch_square < 1) & are_nested(numerator, product, e) &
                       (outer_moved * c.numerator_error <= FOR_NUMERATOR * room * numerator) &
                       (moved * (c.least_square * ERROR) <= FOR_CHORD * room * g.chord_square) &
                       (inner_moved * c.turn_rate_error <= FOR_TURN_RATE * room * e.turn_rate0) &
                       (outer_moved * (flatness * c.turn_rate_error) <= FOR_TURN_RATE * room * radicand) &
                       (of_ends * errors.dot <= most_of_ends) & (most_of_ends < HUGE_VAL);
    return {inner, outer, holds};
  }

 private:
  static constexpr double U = Local_precision<double>::HALF_ULP, ERROR = (1 + 0x1p-8) / Local_precision<double>::DIGITS;
  static constexpr double FOR_NUMERATOR = 0.1, FOR_CHORD = 0.03, FOR_TURN_RATE = 0.03, FOR_OTHERS = 0.84;
  static_assert(FOR_NUMERATOR + FOR_CHORD + FOR_TURN_RATE + FOR_OTHERS <= 1, "these are all parts");
  static constexpr double OF_REACH = 4;
  static constexpr double LARGEST_NARROW = 0x1p-5;
  static_assert(LARGEST_NARROW * LARGEST_NARROW <= Half_tangents::NARROW_SQUARE, "the series is to hold");
  /// |z| + |1 - z| <= MOST_MOVED is an ellipse.
  static constexpr double OF_ELLIPSE_X = 4 / (MOST_MOVED * MOST_MOVED),
                          OF_ELLIPSE_Y = 4 / (MOST_MOVED * MOST_MOVED - 1);
  static constexpr double ANGLES = 1.9;
  static_assert(covers(ANGLES, (std::max)(2 * (0.17 + 0.25), 2 * (0.7 + 0.25)), 1.1), "update the derivation above");
  static constexpr double OF_TANGENTS = ANGLES * 2 * Half_tangents::ROUNDINGS;
  static constexpr double OF_INNER = 2 * 23 * 2 + 2 * 22 + 15, OF_OUTER = 2 * 0.7 * 6 * 2 + 2 * 15;
  static constexpr double OF_PLANE = 2 * 4 * U, OF_BEND = 204 * U;
  static_assert(covers(OF_BEND, ((std::max)(OF_INNER, OF_OUTER) + OF_TANGENTS) * U, 1.1),
                "update the derivation above");
};

}  // namespace CGAL::Bounding_arcs::filter

#endif
