// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The thickness of a BCA in plain double with bounds on both sides, for batches.

#ifndef BOUNDING_ARCS_LIBRARY_TREE_BATCH_BCA_BATCH_H
#define BOUNDING_ARCS_LIBRARY_TREE_BATCH_BCA_BATCH_H

#include "Batch_bounds.h"

#include <CGAL/Bounding_arcs_2/number/strict_math.h>
#include "../../spiral/Local_figures.h"

#include <cmath>

namespace CGAL::Bounding_arcs::filter {

/// The thickness of a BCA in plain double with bounds on both sides.
struct Bca_batch {
  static constexpr bool NEEDS_ENDS = false;

  /// With t_i = tan alpha_i, f, q and z as in Narrow_angles.h, from
  ///   tan(alpha/2) = t / (1 + sqrt(1 + t^2)) = t/2 - t^3/8 + t^5/16 - 5 t^7/128 + ...
  /// follows
  ///   tan(alpha0/2) - tan(alpha1/2) = f (1 - 3 z/4 + 5 z^2/8 - 35 z^3/64 - q (1 - 5 z/2))
  /// for |z| <= 2^-10, q <= 2^-22; omitted are z^4/2 and 2 q^2 + 4 z^2 q, below 2^-38. One square root, one division.
  ///
  /// Thickness is N times a function that falls as |N| grows, while itself it grows. So the bounds N +-
  /// numerator_error, times the factor at the computed N, hold even where N has no certain sign; numerator_error has a
  /// part in 2^10 added (make_local_curve.h) for the slope of the factor. All else is within ROUNDING: two dots in P,
  /// half of |M|^2, and z, which enters with 3/4. A cross errs by rho of the dot beside it at most, and each dot by rho
  /// of itself, so t_i errs by 2 rho and z by 4 rho |t|, where t is the larger of t0, t1.
  [[nodiscard]] CGAL_BOUNDING_ARCS_INLINE static Bracket narrow(const Local_form<double>& c,
                                                                const Local_piece<double>& g,
                                                                const Local_ends<double>& /*not read*/) {
    const double numerator = g.a * g.r + g.d * g.p, step = g.half * g.r, dot0 = g.p - step, dot1 = g.p + step;
    const double product = dot0 * dot1, inverse = g.square / product,
                 z = (g.a * g.a - g.square * (g.d * g.d)) * inverse;
    const double f = numerator * inverse, ff = f * f;
    const double series = 0.5 - z * (0.375 - z * (0.3125 - 0.2734375 * z)) - ff * (0.5 - 1.25 * z);
    const double scale = std::sqrt(g.chord_square) * (g.half * (2 * c.unit)) * series * inverse;
    const bool holds = (dot0 >= c.least_dot) & (dot1 >= c.least_dot) & (g.chord_square >= c.least_square) &
                       (std::fabs(z) <= NARROW_PRODUCT) & (ff <= NARROW_CHANGE);
    return scaled_bounds(scale, std::fabs(numerator), Local_precision<double>::ROUNDING, c.numerator_error, holds);
  }

  // of narrow, in parts of rho
  static constexpr double NARROW_PRODUCT = 0x1p-10;   ///< largest tan alpha0 tan alpha1 of a narrow piece
  static constexpr double NARROW_CHANGE = 0x1p-22;    ///< largest square of half tan alpha0 - tan alpha1 of one
  static constexpr double NARROW_TANGENT = 0x1.1p-5;  ///< largest tan alpha then: sqrt(z + q) + sqrt(q)
  static_assert(covers((NARROW_TANGENT - 0x1p-11) * (NARROW_TANGENT - 0x1p-11), NARROW_PRODUCT + NARROW_CHANGE) &&
                    NARROW_CHANGE == 0x1p-11 * 0x1p-11,
                "update the derivation above");
  static constexpr double OF_PRODUCT = 2, OF_CHORD = 0.5, OF_Z = 0.75 * 4 * NARROW_TANGENT;
  static constexpr double OF_SERIES =
      (NARROW_PRODUCT * NARROW_PRODUCT * NARROW_PRODUCT * NARROW_PRODUCT / 2 + 2 * NARROW_CHANGE * NARROW_CHANGE +
       4 * NARROW_PRODUCT * NARROW_PRODUCT * NARROW_CHANGE) /
      RHO<double>;
  static constexpr double NARROW_ROOM = 6;  ///< ROUNDING is that of the formulas with more factors
  static_assert(covers(Local_precision<double>::ROUNDING,
                       with_second_order<double>((OF_PRODUCT + OF_CHORD + OF_Z + OF_SERIES +
                                                  OF_OPERATIONS<double>)*RHO<double>),
                       1.25 * NARROW_ROOM),
                "update the derivation above");

  /// The thickness in float, with a shorter series: s^3 |M| N/P (1 - 3 z/4) for |z| and f up to 2^-7, from N with its
  /// error added and taken off. What is left out of the series, 5 z^2/8, is then below rho/3, and q below rho/2. P errs
  /// by 2 rho, |M| by 1/2, z by 0.3 as above: below 4, and E is 8 rho.
  CGAL_BOUNDING_ARCS_INLINE static void rough(const Local_form<float>& c, const Rough_figures& figures, float half,
                                              std::size_t count, float* __restrict lower, float* __restrict upper) {
    for (std::size_t j = 0; j < count; ++j) {
      const Local_piece<float> g = figures.piece(j, half);
      const float step = half * g.r, dot0 = g.p - step, dot1 = g.p + step, product = dot0 * dot1, inverse = 1 / product,
                  sd = half * g.d;
      const float numerator = g.a * g.r + g.d * g.p, most = std::fabs(numerator) + c.numerator_error,
                  z = g.square * ((g.a + sd) * (g.a - sd)) * inverse;
      const float scale = std::sqrt(g.chord_square) * inverse * (1 - 0.75f * z);
      const float dot = smaller(dot0, dot1), product_size = std::fabs(z);
      const bool holds = (dot >= c.least_dot) & (g.chord_square >= c.least_square) & (product_size <= ROUGH_PRODUCT) &
                         (g.square * most <= ROUGH_CHANGE * product);
      lower[j] = holds ? scale * (most - (c.numerator_error + c.numerator_error)) : -1.0f;
      upper[j] = holds ? scale * most : HUGE_VALF;
    }
  }
  static constexpr float ROUGH_PRODUCT = 0x1p-7f, ROUGH_CHANGE = 0x1p-7f;  ///< largest |z| and f
  static constexpr double ROUGH_TANGENT = 0.1;                             ///< above sqrt(z + q) + sqrt(q)
  static_assert(covers((ROUGH_TANGENT - ROUGH_CHANGE) * (ROUGH_TANGENT - ROUGH_CHANGE),
                       double(ROUGH_PRODUCT) + double(ROUGH_CHANGE) * ROUGH_CHANGE, 2),
                "update the derivation above");
  static constexpr double ROUGH_OF_Z = 0.75 * 4 * ROUGH_TANGENT,
                          ROUGH_OF_SERIES =
                              (5.0 / 8 * ROUGH_PRODUCT * ROUGH_PRODUCT + double(ROUGH_CHANGE) * ROUGH_CHANGE) /
                              RHO<float>;
  static constexpr double ROUGH_SUM = OF_PRODUCT + OF_CHORD + ROUGH_OF_Z + ROUGH_OF_SERIES + OF_OPERATIONS<float>;
  static constexpr double ROUGH_PARTS = 4, ROUGH_ROOM = 2;  ///< room for the error of N in q and z
  static constexpr double ROUGH_ERROR = ROUGH_ROOM * ROUGH_PARTS / Local_precision<float>::DIGITS;
  static_assert(covers(ROUGH_PARTS, ROUGH_SUM) && ROUGH_ERROR >= with_second_order<float>(ROUGH_SUM * RHO<float>),
                "update the derivation above");
  /// \param s half the piece's length
  [[nodiscard]] CGAL_BOUNDING_ARCS_INLINE static double rough_unit(double s) { return s * s * s; }

  /// For any angles below a right one: with A, B the crosses, l_i = |T_i| |D| and d_i = l_i + T_i.D, as A l1 - B l0 =
  /// (A^2 l1^2 - B^2 l0^2) / (A l1 + B l0),
  ///   tan(alpha0/2) - tan(alpha1/2) = 2 s^2 N (1 + (A T1.D + B T0.D) / (A l1 + B l0)) / (d0 d1)
  /// with A, B >= 0 and A l1 + B l0 >= 2^-16 P. The quotient is nearly 1 for small angles, and an error of A shifts
  /// both its parts alike: what is left is that error times the difference of the cosines, below rho. Other figures add
  /// 2 rho in each length, hence in each d_i, 1/2 of |M|, and 3 of lengths and dots in the quotient, which is at most
  /// as large as the 1 beside it. Bounds of N as above.
  [[nodiscard]] CGAL_BOUNDING_ARCS_INLINE static Bracket wide(const Local_form<double>& c, const Local_piece<double>& g,
                                                              const Local_ends<double>& /*not read*/) {
    const double numerator = g.a * g.r + g.d * g.p, step = g.half * g.r, dot0 = g.p - step, dot1 = g.p + step;
    const double cross0 = g.half * (g.a + g.half * g.d), cross1 = g.half * (g.a - g.half * g.d);
    const double length0 = std::sqrt(dot0 * dot0 + cross0 * cross0), length1 = std::sqrt(dot1 * dot1 + cross1 * cross1);
    const double sum = cross0 * length1 + cross1 * length0, cosines = cross0 * dot1 + cross1 * dot0;
    const double scale = std::sqrt(g.chord_square) * (g.half * (2 * c.unit)) * g.square * (sum + cosines) /
                         (sum * ((length0 + dot0) * (length1 + dot1)));
    const bool holds = (dot0 >= c.least_dot) & (dot1 >= c.least_dot) & (g.chord_square >= c.least_square) &
                       (smaller(cross0, cross1) >= 0) & (sum >= LEAST_TURN * (dot0 * dot1));
    return scaled_bounds(scale, std::fabs(numerator), Local_precision<double>::ROUNDING, c.numerator_error, holds);
  }

 private:
  static constexpr double LEAST_TURN =
      0x1p-16;  ///< of a wide piece: sum of crosses over dots, as quotients by 0 are not
  static constexpr double OF_DIVISORS = 2 * 2, OF_SHIFTS = 2, OF_QUOTIENT = 0.5 * 3, WIDE_ROOM = 2;
  static_assert(covers(Local_precision<double>::ROUNDING,
                       with_second_order<double>((OF_DIVISORS + OF_CHORD + OF_SHIFTS + OF_QUOTIENT +
                                                  OF_OPERATIONS<double>)*RHO<double>),
                       1.25 * WIDE_ROOM),
                "update the derivation above");
};

}  // namespace CGAL::Bounding_arcs::filter

#endif
