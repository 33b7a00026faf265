// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The biarcs of bilens in plain double, for batches.  Over the unit chord (Half_tangents.h), with m half the sum of the
// end angles and delta half their difference, all biarcs with these end directions have their joints on one circle,
//   z = 1 / (1 + rho e^(i m)),                                   rho > 0,
// where rho = r_b on the outer side and 1 / r_a on the inner one, r_a = sin delta / a, r_b = sin delta / b: this is
// biarc_joint (region/Tight_axes.h) with e^(-i alpha0 + i m) = e^(-i delta).  The chords' angles with the directions at
// the ends are those of
//   e^(i alpha0) + rho e^(i delta)     and     e^(-i delta) + rho e^(i alpha1),
// both of length Q = |1 + rho e^(i m)|, and not larger than end angles.  With t, f the tangents of half the angles
//   e^(i m) = (1 + i t)(1 + i f) R,  e^(i delta) = (1 + i t)(1 - i f) R,  R = ((1 + t^2)(1 + f^2))^(-1/2).
//
// Errors, as they move a side, in units of half the chord:
//  * rho.  A biarc with another rho is another one of the family, which meets the circle of joints at the angle delta:
//    as |dz / d ln rho| = rho / Q^2 <= 1 / (2 + 2 cos 45 degrees) < 0.3, the joint moves off the biarc by 0.3 tan delta
//    of the chord times the relative error of rho, and all other points by less. That error is the sum of those of N,
//    a kneser, a |T|^2 and the length of the other end's tangent times the chord, 2 E / dot; tan delta is at most s^2 N
//    / P, and at most bend.
//  * the end angles (Half_tangents.h).  One alone turns the circle of joints, whose middle moves by an eighth of that
//    of the chord, and changes the arcs' turns, each by that at most, which moves an arc by an eighth of its own chord
//    or less than 2/3 of the whole one: 0.21 of the chord in all, for both 0.84 of its half.
//  * roundings of z, relative ones.  Along the chord, from which tangents turn away by alpha <= 2 bend at most, z is up
//    to 0.75 long and errs by 17 u (4 of 1 + rho e^(i m), 7 of Q^2, 6 of division and products); across it is up to 0.3
//    sin m <= 0.6 bend and errs by 20 u.  In the plane, differences of points and products add 4 u of its length.
//  * roundings of bulges, 15 u, over half of 2/3 of the chord at most, and of half tangents.
// All of them together are to be within the room: first / P + others / dot <= room, times all that is divided by. What
// underflows there is far below the room; what overflows holds nothing.

#ifndef BOUNDING_ARCS_LIBRARY_TREE_BATCH_BILENS_ARCS_H
#define BOUNDING_ARCS_LIBRARY_TREE_BATCH_BILENS_ARCS_H

#include "Bca_arcs.h"
#include "Half_tangents.h"

#include <CGAL/Bounding_arcs_2/number/strict_math.h>

#include <cmath>

namespace CGAL::Bounding_arcs::filter {

/// The biarcs of bilens in plain double.
struct Bilens_arcs {
  static constexpr double MOST_MOVED = Bca_arcs::MOST_MOVED;  ///< in which a bilens lies

  template <bool WIDE>
  [[nodiscard]] CGAL_BOUNDING_ARCS_INLINE static Joint_arcs of(const Local_form<double>& c,
                                                               const Local_piece<double>& g,
                                                               const Local_ends<double>& e, double room) {
    constexpr double CERTAIN = Local_precision<double>::CERTAIN;
    const Half_tangents h = Half_tangents::of<WIDE>(g);
    const double t = h.tight, f = h.flat, tt = t * t, ff = f * f, tf = t * f, g0 = 1 + tt, g1 = 1 + ff;
    double root;  // R
    if constexpr (WIDE) root = 1 / std::sqrt(g0 * g1);
    else root = inverse_root(tt + ff + tt * ff);
    const double r0 = g0 * root, r1 = g1 * root;  // r0 r1 = 1
    const double cos_mean = (1 - tf) * root, sin_mean = (t + f) * root;
    const double cos_delta = (1 + tf) * root, sin_delta = (t - f) * root;
    const double of0 = r1 * root, of1 = r0 * root;  // 1 / g0, 1 / g1
    const double cos0 = (1 - tt) * of0, sin0 = (t + t) * of0, cos1 = (1 - ff) * of1, sin1 = (f + f) * of1;
    // the ratios r_a = N |T0|^2 / (l1 kneser0 cos delta), r_b = N |T1|^2 / (l0 kneser1 cos delta)
    const double step = g.half * g.r, dot0 = g.p - step, dot1 = g.p + step, product = dot0 * dot1;
    const double numerator = g.a * g.r + g.d * g.p, common = numerator / (product * (e.kneser0 * e.kneser1) * (1 + tf));
    const double ra = common * (dot0 * e.kneser1) * (e.square0 * ((1 - ff) * r0));
    const double rb = common * (dot1 * e.kneser0) * (e.square1 * ((1 - tt) * r1));
    const double outer_square = 1 + rb * (rb + (cos_mean + cos_mean)),
                 inner_square = 1 + ra * (ra + (cos_mean + cos_mean));
    // bulges of both arcs of both sides, and 1 / Q^2, by one division
    const double outer0 = bulge_divisor<WIDE>(cos0 + rb * cos_delta, outer_square),
                 outer1 = bulge_divisor<WIDE>(cos_delta + rb * cos1, outer_square),
                 inner0 = bulge_divisor<WIDE>(ra * cos0 + cos_delta, inner_square),
                 inner1 = bulge_divisor<WIDE>(ra * cos_delta + cos1, inner_square);
    const double outers = outer0 * outer1, inners = inner0 * inner1, outer_all = outers * outer_square,
                 inner_all = inners * inner_square, inverse = 1 / (outer_all * inner_all);
    const double of_outer = inverse * inner_all, of_inner = inverse * outer_all;
    const double outer_z = of_outer * outers, inner_z = of_inner * inners * ra;
    const double outer_bulges = of_outer * outer_square, inner_bulges = of_inner * inner_square;
    const Joint_side outer{(1 + rb * cos_mean) * outer_z, -(rb * sin_mean) * outer_z,
                           bulge_of<WIDE>((sin0 + rb * sin_delta) * (outer_bulges * outer1)),
                           bulge_of<WIDE>((rb * sin1 - sin_delta) * (outer_bulges * outer0))};
    const Joint_side inner{(ra + cos_mean) * inner_z, -sin_mean * inner_z,
                           bulge_of<WIDE>((ra * sin0 + sin_delta) * (inner_bulges * inner1)),
                           bulge_of<WIDE>((sin1 - ra * sin_delta) * (inner_bulges * inner0))};
    const Arc_errors errors = arc_errors(c, g, h);
    const double kneser = e.kneser0 < e.kneser1 ? e.kneser0 : e.kneser1,
                 square = e.square0 < e.square1 ? e.square0 : e.square1, divisor = kneser * square;
    const double angles = ANGLES * errors.turn + OF_LENGTHS * (errors.bend * errors.of_dot);
    const double roundings = errors.dot * (OF_PLANE + OF_BEND * errors.bend);
    const double of_ratios =
        0.6 * (g.square * errors.half_chord) *
        (c.numerator_error * divisor + numerator * (c.kneser_error * square + c.least_tangent * ERROR * kneser));
    const double left = room * errors.dot - errors.half_chord * (angles + roundings), most = left * (product * divisor);
    const bool holds = errors.holds & (square >= c.least_tangent) & (numerator >= CERTAIN * c.numerator_error) &
                       (kneser >= CERTAIN * c.kneser_error) & are_nested(numerator, product, e) &
                       (of_ratios * errors.dot <= most) & (most < HUGE_VAL);
    return {inner, outer, holds};
  }

 private:
  // 1 / sqrt(1 + y), y <= 2^-10: the next term is below 2^-62.
  [[nodiscard]] CGAL_BOUNDING_ARCS_INLINE static double inverse_root(double y) {
    return 1 + y * (-0.5 + y * (0.375 + y * (-0.3125 + y * (0.2734375 + y * -0.24609375))));
  }
  static constexpr double MOST_Y = Half_tangents::NARROW_SQUARE / 2;
  static_assert(MOST_Y == 0x1p-10 && 0.2256 * (MOST_Y * MOST_Y * MOST_Y) * (MOST_Y * MOST_Y * MOST_Y) < 0x1p-62,
                "update the derivation above");

  static constexpr double U = Local_precision<double>::HALF_ULP, ERROR = (1 + 0x1p-8) / Local_precision<double>::DIGITS;
  static constexpr double ANGLES = 0.85, OF_LENGTHS = 0.6 * 2;
  static constexpr double ALONG = 2 * 0.75 * 17 * 2, ACROSS = 2 * 0.6 * 20, OF_BULGES = 15 * 2.0 / 3,
                          OF_TANGENTS = ANGLES * 2 * Half_tangents::ROUNDINGS;
  static constexpr double OF_PLANE = 2 * 0.75 * 4 * U, OF_BEND = 108 * U;
  static_assert(covers(OF_BEND, (ALONG + ACROSS + OF_BULGES + OF_TANGENTS) * U, 1.1), "update the derivation above");
};

}  // namespace CGAL::Bounding_arcs::filter

#endif
