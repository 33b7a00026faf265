// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The thickness of a bilens in plain double with bounds on both sides, for batches: the formula of Bilens::thickness
// from the batch's figures of a piece.  With F = A T1.D - B T0.D = 2 s^2 (a r + d p) and l_i = n_i c:
//   sin delta cos delta = |F| / (2 l0 l1),   sin delta / (K0 - sin alpha0) = |a r + d p| n0^2 / (l1 |kneser0| cos
//   delta).

#ifndef CGAL_BOUNDING_ARCS_2_FILTER_BILENS_BATCH_H
#define CGAL_BOUNDING_ARCS_2_FILTER_BILENS_BATCH_H

#include <CGAL/Bounding_arcs_2/filter/Narrow_angles.h>
#include <CGAL/Bounding_arcs_2/filter/Rough_figures.h>
#include <CGAL/Bounding_arcs_2/filter/Tight_batch.h>

#include <cmath>

namespace CGAL::Bounding_arcs::filter {

struct Bilens_batch {
  static constexpr bool NEEDS_ENDS = true;

  /// The same figures with signs, so that nothing depends on which end is the tight one; two divisions and the chord's
  /// square root.  ratio_i = sin delta / (K_i - sin alpha_i) = N |T_i|^2 / (l_(1-i) kneser_i cos delta), and with
  /// v = 4 room K_A K_B / change^2, below 2^-9.9 as change > 1.99, 1 / (1 + sqrt(1 + v)) = 1/2 - v/8 + v^2/16 - ...
  [[nodiscard, gnu::always_inline]] static inline Batch_bounds narrow(const Local_form<double>& c,
                                                                      const Local_piece<double>& g,
                                                                      const Local_ends<double>& e) {
    const Narrow_piece<double> n = narrow_piece(c, g, e, Narrow_angles::LEAST_DOT_RATIO);
    const double product = e.kneser0 * e.kneser1, inverses = 1 / (n.product * product);  // one division for three
    const double inverse = inverses * product, common = n.numerator * inverses;
    const double scaled = g.half * inverse, squared = g.half * scaled;
    const Narrow_angles t = narrow_angles(squared * n.numerator, scaled * n.sum);
    const double mean = t.mean();
    const double ratio0 = common * (mean + t.skew) * (e.square0 * n.dot0 * e.kneser1);
    const double ratio1 = common * (mean - t.skew) * (e.square1 * n.dot1 * e.kneser0);
    const double both = ratio0 * ratio1, room = 1 - both, sum = ratio0 + ratio1, change = 1 / (mean + mean + sum);
    const double contacts = (t.z - t.z * t.z) + t.skew * (ratio1 - ratio0) - t.q * (sum + both);
    const double slope = room * change, v = contacts * (slope * change);  // a quarter of the v above
    const double scale =
        std::sqrt(g.chord_square) * (g.half * (2 * c.unit)) * (t.sine * squared) * (slope * (1 - v * (1 - (v + v))));
    // The thickness has at most 5 times the relative error of N and twice those of the knesers, as both < room.
    const double knesers = 2.25 * c.kneser_error * (inverses * n.product * (e.kneser0 + e.kneser1));
    const bool holds = n.holds & t.holds & (ratio0 > 0) & (ratio1 > 0) & (room >= NARROW_ROOM) &
                       (knesers <= 2.25 / Local_precision<double>::CERTAIN);
    return scaled_bounds(scale, n.numerator, knesers + Local_precision<double>::ROUNDING, 5.5 * c.numerator_error,
                         holds);
  }

  /// The same in float without series, ratio_i as A_i / B_i: 2 s^3 |M| N / P (B0 B1 - A0 A1) / (2 B0 B1 + A0 B1 + A1
  /// B0).
  [[gnu::always_inline]] static inline void rough(const Local_form<float>& c, const Rough_figures& figures, float half,
                                                  std::size_t count, float* __restrict lower, float* __restrict upper) {
    constexpr float CERTAIN = Local_precision<float>::CERTAIN;
    for (std::size_t j = 0; j < count; ++j) {
      const Local_piece<float> g = figures.piece(j, half);
      const Local_ends<float> e = figures.ends(j);
      const float step = half * g.r, dot0 = g.p - step, dot1 = g.p + step, numerator = g.a * g.r + g.d * g.p,
                  sd = half * std::fabs(g.d);
      const float a0 = numerator * e.square0, a1 = numerator * e.square1, b0 = dot1 * e.kneser0, b1 = dot0 * e.kneser1,
                  bb = b0 * b1;
      const float room = bb - a0 * a1, above = numerator * room,
                  below = (dot0 * dot1) * ((bb + bb) + (a0 * b1 + a1 * b0));
      const float thickness = std::sqrt(g.chord_square) * (above / below), dot = smaller(dot0, dot1);
      const float square = smaller(e.square0, e.square1), kneser = smaller(e.kneser0, e.kneser1);
      const float factor = smaller(above, below);
      const bool holds = (dot >= c.least_dot) & (g.chord_square >= c.least_square) & (square >= c.least_tangent) &
                         (g.a >= sd) & (half * ROUGH_SLOPE * (g.a + sd) <= dot) &
                         (numerator >= CERTAIN * c.numerator_error) & (kneser >= CERTAIN * c.kneser_error) &
                         (room >= float(NARROW_ROOM) * bb) & (factor >= Local_precision<float>::LEAST_PRODUCT);
      lower[j] = holds ? thickness : -1.0f;
      upper[j] = holds ? thickness : HUGE_VALF;
    }
  }
  static constexpr double ROUGH_ERROR = 6.5 / Local_precision<float>::CERTAIN + 64 / Local_precision<float>::DIGITS;
  /// \param s half the piece's length
  [[nodiscard, gnu::always_inline]] static inline double rough_unit(double s) { return 2 * s * s * s; }

  [[nodiscard, gnu::always_inline]] static inline Batch_bounds wide(const Local_form<double>& c,
                                                                    const Local_piece<double>& g,
                                                                    const Local_ends<double>& e) {
    const Tight_batch t = tight_batch(c, g, e);
    const double scale = t.numerator / t.cos_delta;
    const double ratio_a = scale * t.square_tight / (t.length_flat * t.kneser_tight);
    const double ratio_b = scale * t.square_flat / (t.length_tight * t.kneser_flat);
    const double both = ratio_a * ratio_b, room = 1 - both, change = 2 * t.cos_mean + ratio_a + ratio_b;
    const double outer = t.cross_tight / t.length_tight + t.sin_delta * ratio_b;
    const double inner = t.cross_flat / t.length_flat - t.sin_delta * ratio_a;
    const double thickness =
        t.chord * 2 * t.sin_delta * room / (change + std::sqrt(change * change + 4 * room * (outer * inner)));
    // to first order: (1 + ...) of the numerator, of room and of the denominator
    const double amplified = both / room;
    const double error =
        (3 + 2 * amplified) * t.numerator_error +
        (1 + amplified) * (t.kneser_tight_error + t.kneser_flat_error + Local_precision<double>::ROUNDING);
    return tight_bounds(thickness, error, t.holds & (room >= LEAST_ROOM));
  }

 private:
  // of 1 - r_a r_b, which is about 3/4, and 2/3 at a vertex:
  static constexpr double NARROW_ROOM = 0.625;
  static constexpr double LEAST_ROOM = 0x1p-5;
  static constexpr float ROUGH_SLOPE = 16;  ///< what the tangents of both angles are below one over, in float
};

}  // namespace CGAL::Bounding_arcs::filter

#endif
