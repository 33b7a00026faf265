// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The thickness of a BCA in plain double with bounds on both sides, for batches.

#ifndef CGAL_BOUNDING_ARCS_2_FILTER_BCA_BATCH_H
#define CGAL_BOUNDING_ARCS_2_FILTER_BCA_BATCH_H

#include <CGAL/Bounding_arcs_2/filter/Rough_figures.h>
#include <CGAL/Bounding_arcs_2/spiral/Local_curve.h>

#include <cmath>

namespace CGAL::Bounding_arcs::filter {

struct Bca_batch {
  static constexpr bool NEEDS_ENDS = false;

  /// With t_i = tan alpha_i: tan(alpha0/2) - tan(alpha1/2) as a series in z = t0 t1 and f = (t0 - t1) / 2, from
  /// t / (1 + sqrt(1 + t^2)) = t/2 - t^3/8 + t^5/16 - 5 t^7/128 + ...; one square root and one division.
  [[nodiscard, gnu::always_inline]] static inline Batch_bounds narrow(const Local_form<double>& c,
                                                                      const Local_piece<double>& g) {
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

  /// The same in float with a shorter series: s^3 |M| N / P (1 - 3/4 z), from N with its error added and taken off.
  [[gnu::always_inline]] static inline void rough(const Local_form<float>& c, const Rough_figures& figures, float half,
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
  static constexpr double ROUGH_ERROR = 8 / Local_precision<float>::DIGITS;
  /// \param s half the piece's length
  [[nodiscard, gnu::always_inline]] static inline double rough_unit(double s) { return s * s * s; }

  /// For any angles: with A, B the crosses and l_i = n_i |D|, A l1 - B l0 = (A^2 l1^2 - B^2 l0^2) / (A l1 + B l0), so
  /// tan(alpha0/2) - tan(alpha1/2) = (A T1.D - B T0.D)(1 + (A T1.D + B T0.D) / (A l1 + B l0)) / (d0 d1).
  [[nodiscard, gnu::always_inline]] static inline Batch_bounds wide(const Local_form<double>& c,
                                                                    const Local_piece<double>& g) {
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
  static constexpr double NARROW_PRODUCT = 0x1p-10;  ///< largest tan alpha0 tan alpha1 of a narrow piece
  static constexpr double NARROW_CHANGE = 0x1p-22;   ///< largest square of half tan alpha0 - tan alpha1 of one
  static constexpr float ROUGH_PRODUCT = 0x1p-7f,
                         ROUGH_CHANGE = 0x1p-7f;  ///< the same in float, but without the square
  static constexpr double LEAST_TURN = 0x1p-16;   ///< of a wide piece: sum of crosses over dots
};

}  // namespace CGAL::Bounding_arcs::filter

#endif
