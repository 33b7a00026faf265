// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The thickness of a bilens in plain double with bounds on both sides, for batches: the formula of Bilens::thickness
// (doc/numerics.md) from the batch's figures of a piece.  With F = A T1.D - B T0.D = 2 s^2 N and l_i = |T_i| |D|:
//   sin delta cos delta = |F| / (2 l0 l1),
//   r_i = sin delta / |K_i - sin alpha_i| = N |T_i|^2 / (l_j kneser_i cos delta), j the other end.

#ifndef BOUNDING_ARCS_LIBRARY_TREE_BATCH_BILENS_BATCH_H
#define BOUNDING_ARCS_LIBRARY_TREE_BATCH_BILENS_BATCH_H

#include "Batch_bounds.h"
#include "Narrow_angles.h"
#include "Tight_batch.h"

#include <CGAL/Bounding_arcs_2/number/strict_math.h>

#include <algorithm>
#include <cmath>

namespace CGAL::Bounding_arcs::filter {

/// The thickness of a bilens in plain double with bounds on both sides.
struct Bilens_batch {
  static constexpr bool NEEDS_ENDS = true;

  /// As 1 / (l_j cos delta) = (T_i.D / P)(cos m +- skew), with Narrow_angles.h, the thickness becomes
  ///   2 c sin delta (1 - r0 r1) / (2 cos m + r0 + r1) / (1 + sqrt(1 + v)),
  ///   v = 4 (1 - r0 r1) K_A K_B / (2 cos m + r0 + r1)^2,
  ///   K_A K_B = z - z^2 + skew (r1 - r0) - q (r0 + r1 + r0 r1),
  /// in which signs make all four cases one, so that nothing depends on which end is the tight one. As 2 cos m > 1.99,
  /// v <= 2^-9.9, and 1 - v/4 + v^2/8 is kept of 2 / (1 + sqrt(1 + v)). Two divisions and the chord's square root.
  ///
  /// With room = 1 - r0 r1 >= 5/8 (it is 3/4 for short pieces and 2/3 at a vertex) the relative error of r0 r1 comes in
  /// with weight r0 r1 / room <= 0.6, and that of r0 + r1 with weight 1 at most: N is there 1 + 1.2 + 1 < 5 times, each
  /// kneser 1.6 < 2 times, and room above that is for v and what adds to the first order. Roundings are 2 rho (P in f),
  /// 1/2 (|M|), 2.4 + 2 (|T_i|^2 and a dot in each ratio), and of series 2.3 (sin delta), 2.2 times those of the ratios
  /// and of cos m, which is no more, 2 (z^3 in K_A K_B) and 1 (5 v^3/64): below 15, beside ROUNDING = 16 rho.
  [[nodiscard]] CGAL_BOUNDING_ARCS_INLINE static Bracket narrow(const Local_form<double>& c,
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
    const double knesers = KNESER_WEIGHT * c.kneser_error * (inverses * n.product * (e.kneser0 + e.kneser1));
    const bool holds = n.holds & t.holds & (ratio0 > 0) & (ratio1 > 0) & (room >= NARROW_ROOM) &
                       (knesers <= KNESER_WEIGHT / Local_precision<double>::CERTAIN);
    return scaled_bounds(scale, n.numerator, knesers + Local_precision<double>::ROUNDING,
                         NUMERATOR_WEIGHT * c.numerator_error, holds);
  }

  /// The thickness in float, without series: with A_i = N |T_i|^2, B_i = (T_j.D) kneser_i, so that r_i = A_i / B_i cos
  /// alpha_j / cos delta,
  ///   2 s^3 |M| (N/P) (B0 B1 - A0 A1) / (2 B0 B1 + A0 B1 + A1 B0).
  /// Tangents up to T = 2^-4 are left out. Each figure takes, in parts of T^2 = 32 rho: sin delta for f 1, room (r0 r1
  /// <= 0.6 of it) 0.6, 2 cos m + r0 + r1 0.5, v/4 0.28, as
  ///   (sin alpha + sin delta r_b)(sin alpha + sin delta r_a) / (2 + r0 + r1)^2
  /// is less than that. Two of them make the formula larger and two smaller: all four are at most 1.5 T^2 in one
  /// direction, 48 rho, and the figures have 7 rho, as above. N comes in with 3.2, and both knesers with 2.2, in all
  /// 5.4 epsilon. E is 6.5 epsilon + 64 rho.
  CGAL_BOUNDING_ARCS_INLINE static void rough(const Local_form<float>& c, const Rough_figures& figures, float half,
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
  // of 1 - r_a r_b, which is about 3/4, and 2/3 at a vertex:
  static constexpr double NARROW_ROOM = 0.625;
  static constexpr double RATIOS = (1 - NARROW_ROOM) / NARROW_ROOM;  ///< weight of r0 r1 in room
  static constexpr double OF_N = 1 + 2 * RATIOS + 1, OF_KNESER = RATIOS + 1, OF_KNESERS = 2 * RATIOS + 1;
  static constexpr double OF_FIGURES = 2 + 0.5 + 4 * RATIOS + 2;  ///< P, |M|, and two in each ratio, in parts of rho

  static constexpr float ROUGH_SLOPE = 16;  ///< what the tangents of both angles are below one over, in float
  static constexpr double ROUGH_SQUARE = 1.0 / (ROUGH_SLOPE * ROUGH_SLOPE) / RHO<float>;  ///< T^2 in parts of rho
  static constexpr double FOR_SIN_DELTA = 1, FOR_ROOM = RATIOS, FOR_SUM = 0.5, FOR_V = 0.28, ONE_WAY = 1.5;
  static_assert(covers(ONE_WAY, (std::max)(FOR_SIN_DELTA + FOR_V, FOR_ROOM + FOR_SUM)), "update the derivation above");
  static constexpr double ROUGH_RHOS = 64, ROUGH_EPSILONS = 6.5;
  static_assert(covers(ROUGH_RHOS, ONE_WAY* ROUGH_SQUARE + OF_FIGURES + OF_OPERATIONS<float>) &&
                    covers(ROUGH_EPSILONS, OF_N + OF_KNESERS),
                "update the derivation above");
  static constexpr double ROUGH_ERROR =
      ROUGH_EPSILONS / Local_precision<float>::CERTAIN + ROUGH_RHOS / Local_precision<float>::DIGITS;
  static_assert(ROUGH_ERROR >=
                    with_second_order<float>((OF_N + OF_KNESERS) * EPSILON<float> +
                                             (ONE_WAY * ROUGH_SQUARE + OF_FIGURES + OF_OPERATIONS<float>)*RHO<float>),
                "update the derivation above");
  /// \param s half the piece's length
  [[nodiscard]] CGAL_BOUNDING_ARCS_INLINE static double rough_unit(double s) { return 2 * s * s * s; }

  /// The formula of single pieces. The error of r0 r1 is multiplied by r0 r1 / (1 - r0 r1) (amplified), so it is asked
  /// that 1 - r0 r1 >= 2^-5 (LEAST_ROOM). To first order N is once in sin delta, twice amplified in room, and once in
  /// the ratios of the sum; each kneser is once amplified in room, and both together once in the sum; ROUNDING is
  /// counted as a kneser is.
  [[nodiscard]] CGAL_BOUNDING_ARCS_INLINE static Bracket wide(const Local_form<double>& c, const Local_piece<double>& g,
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
    const double amplified = both / room;
    const double error =
        (WIDE_N + 2 * amplified) * t.numerator_error +
        (1 + amplified) * (t.kneser_tight_error + t.kneser_flat_error + Local_precision<double>::ROUNDING);
    return tight_bounds(thickness, error, t.holds & (room >= LEAST_ROOM));
  }

 private:
  static constexpr double NUMERATOR_WEIGHT = 5.5, KNESER_WEIGHT = 2.25;
  static constexpr double MORE_OF_N = 1.5, MORE_OF_KNESERS = 1.25;  ///< room for v, q and skew
  static_assert(covers(NUMERATOR_WEIGHT, OF_N* MORE_OF_N) && covers(KNESER_WEIGHT, OF_KNESER* MORE_OF_KNESERS),
                "update the derivation above");
  static constexpr double LEAST_SUM = 1.99;        ///< below 2 cos m
  static constexpr double LARGEST_V = 0x1.13p-10;  ///< 2^-9.9
  static_assert(covers(LARGEST_V, 4 * Narrow_angles::LARGEST_PRODUCT / (LEAST_SUM * LEAST_SUM)),
                "update the derivation above");
  static constexpr double OF_SERIES = Narrow_angles::OF_SINE +
                                      (2 * RATIOS + 1) * (std::max)(Narrow_angles::OF_MEAN, Narrow_angles::OF_RATIO) +
                                      Narrow_angles::LARGEST_PRODUCT * Narrow_angles::LARGEST_PRODUCT *
                                          Narrow_angles::LARGEST_PRODUCT / LEAST_SUM / LEAST_SUM / RHO<double> +
                                      5.0 / 64 * LARGEST_V * LARGEST_V * LARGEST_V / RHO<double>;
  static_assert(covers(Local_precision<double>::MOST_FACTORS, OF_FIGURES + OF_SERIES + OF_OPERATIONS<double>),
                "update the derivation above");
  static_assert(NUMERATOR_WEIGHT * EPSILON<double> + KNESER_WEIGHT * EPSILON<double> +
                        Local_precision<double>::ROUNDING >=
                    with_second_order<double>((OF_N + OF_KNESER) * EPSILON<double> +
                                              (OF_FIGURES + OF_SERIES + OF_OPERATIONS<double>)*RHO<double>),
                "update the derivation above");
  /// With less of 1 - r0 r1, errors of epsilon of N and of knesers, both twice, are more than tight_bounds lets pass.
  static constexpr double LEAST_ROOM = 0x1p-5;
  static_assert(covers(2 * LARGEST_SUM<double>, 4 * EPSILON<double> / LEAST_ROOM), "update the derivation above");
  static constexpr double WIDE_N = 1 + 1 + 1;  ///< the last one is room, for the root
};

}  // namespace CGAL::Bounding_arcs::filter

#endif
