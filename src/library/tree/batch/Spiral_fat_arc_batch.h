// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The thickness of a spiral fat arc in plain double with bounds on both sides, for batches: the formulas of
// Spiral_fat_arc::thickness (doc/numerics.md) from the batch's figures of a piece, lengths over the chord:
//   reach  = |p_tight i| = l_tight / (beta + sqrt(beta^2 + F turn_rate_flat)),
//            beta = N |T_flat|^2 / kneser_flat + T_tight.D,   F = |T_tight|^2 |M|^4 / (s kneser_flat)
//   corner = b reach / (1 + sqrt(1 + b^2)),   b = 2 K_tight reach
//   tilt   = (sigma sin m - sin delta) / (cos delta + sigma cos m),
//            sigma^2 = s kneser_tight / (turn_rate_tight |M|^2)
//   height = tilt^2 / (K_flat (1 + tilt^2)).
// Thickness is the larger of corner and height, the latter where the outer arc has a tangent parallel to the inner
// segment.  In code sigma is `stretch` and b is `swing`.

#ifndef BOUNDING_ARCS_LIBRARY_TREE_BATCH_SPIRAL_FAT_ARC_BATCH_H
#define BOUNDING_ARCS_LIBRARY_TREE_BATCH_SPIRAL_FAT_ARC_BATCH_H

#include "Batch_bounds.h"
#include "Narrow_angles.h"
#include "Tight_batch.h"

#include <CGAL/Bounding_arcs_2/number/strict_math.h>

#include <algorithm>
#include <cmath>

namespace CGAL::Bounding_arcs::filter {

/// The thickness of a spiral fat arc in plain double with bounds on both sides.
struct Spiral_fat_arc_batch {
  static constexpr bool NEEDS_ENDS = true;

  /// The formulas with the series of Narrow_angles.h and three square roots, as 1 / l = dot_other / (P sqrt(1 + t^2)).
  /// b <= 2^-6 is asked, and tilt < 2^-6 as sigma < 1; their roots and quotients are series, too.
  ///
  /// sigma sin m >= 2.5 sin delta is asked where there is a height, so the difference takes 5/3 times the error of its
  /// first term and 2/3 times that of its second at most; elsewhere 1.25, for 5 and 4 times, as the tilt then only
  /// tells that there is none. Relative errors: corner has 1 of turn_rate_tight, 2 of N, 2 of kneser_flat; height has 2
  /// of kneser_tight, 2 of turn_rate_tight, 2 of N and 1 of turn_rate_flat, turn rates being within rho. As
  /// kneser_tight >= kneser_flat / 4 is asked, the knesers add at most 2 + 8 = 10 times that of kneser_flat. Those
  /// within rho are summed below; as the tilt, itself of many factors, comes in twice, they are four times ROUNDING.
  ///
  /// turn_rate_flat may be small: its error in the radicand must be below rho of it, and where it is uncertain there
  /// must be no height. Whether there is one is compared with tangents for sines, hence the margin CLEAR: sines,
  /// cosines and tangents of narrow pieces differ by 2^-8 of themselves at most, and the tilt by 2^-9 and, for its
  /// errors, 2^-10.
  [[nodiscard]] CGAL_BOUNDING_ARCS_INLINE static Bracket narrow(const Local_form<double>& c,
                                                                const Local_piece<double>& g,
                                                                const Local_ends<double>& e) {
    constexpr double CERTAIN = Local_precision<double>::CERTAIN;
    const Narrow_piece<double> n = narrow_piece(c, g, e, Narrow_angles::LEAST_DOT_RATIO);
    const double numerator = n.numerator, square = g.chord_square;
    const double dot_tight = n.dot0, dot_flat = n.dot1, square_tight = e.square0, square_flat = e.square1;
    const double turn_rate_tight = e.turn_rate0, turn_rate_flat = e.turn_rate1, kneser_tight = e.kneser0,
                 kneser_flat = e.kneser1;
    const double inverse = 1 / n.product, scaled = g.half * inverse, step = g.half * kneser_flat,
                 inverses = 1 / (step * numerator);
    const double of_step = inverses * numerator, of_numerator = inverses * step;
    const Narrow_angles t = narrow_angles(g.half * scaled * numerator, scaled * n.sum);
    const double of_tight = dot_flat * (inverse * (t.root() - t.skew)),
                 of_flat = dot_tight * (inverse * (t.root() + t.skew));  // 1 / l
    // the corner i and the tilt of the inner segment: reach = l_tight / edge, tilt = up / down
    const double squares = square * square, weighed = g.half * squares, error_step = g.half * of_step,
                 length_square = square_tight * square;
    const double beta = error_step * numerator * square_flat + dot_tight, flatness = length_square * (square * of_step);
    const double radicand = beta * beta + flatness * turn_rate_flat, edge = beta + std::sqrt(radicand);
    const double stretch = std::sqrt(g.half * kneser_tight / (turn_rate_tight * square));
    const double turned = stretch * t.sin_mean(), sine = t.f * t.sine, up = turned - sine;
    const double down = t.cos_delta() + stretch * t.mean();
    const bool is_bent = turn_rate_flat >= c.least_turn_rate;
    const double k_flat = is_bent ? weighed * turn_rate_flat * (of_flat * of_flat * of_flat) : 1.0;
    const double divisors = 1 / (down * k_flat * edge), of_edge = divisors * (down * k_flat),
                 raised = up * (divisors * edge);
    const double tilt = raised * k_flat, tilt_square = tilt * tilt, reach = length_square * of_tight * of_edge;
    const double swing = (weighed + weighed) * turn_rate_tight * (of_tight * of_tight) * of_edge,
                 v = swing * swing;  // 2 K_tight reach
    const double height = raised * tilt * (1 - (tilt_square - tilt_square * tilt_square));
    const double at_corner = swing * reach * (0.5 - v * (0.125 - 0.0625 * v));
    // whether the outer arc has a tangent parallel to the inner segment, where that is plain
    const double rise = t.g - t.f, fall = tilt + reach * (t.g + t.g - tilt);
    const bool has_height = rise > fall;
    const double larger = has_height && height > at_corner ? height : at_corner;
    const double error = KNESER_WEIGHT * c.kneser_error * error_step +
                         NUMERATOR_WEIGHT * c.numerator_error * of_numerator +
                         HEIGHT_ROUNDINGS * Local_precision<double>::ROUNDING;
    const bool holds = n.holds & t.holds & are_nested(numerator, n.product, e) &
                       (kneser_flat >= CERTAIN * c.kneser_error) & (KNESER_RATIO * kneser_tight >= kneser_flat) &
                       (turn_rate_tight >= c.least_turn_rate) & (is_bent | !has_height) &
                       (flatness * c.least_turn_rate <= radicand) &
                       (turned >= (has_height ? HEIGHT_RATIO : NO_HEIGHT_RATIO) * sine) & (swing <= LARGEST_SWING) &
                       (std::fabs(rise - fall) >= CLEAR * (rise + fall));
    return scaled_bounds(std::sqrt(square) * (g.half * (2 * c.unit)), larger, error, 0, holds);
  }

  /// The thickness in float, without series and with few divisions. With E_f = kneser_flat (beta + sqrt(beta^2 + F
  /// turn_rate_flat)) and v = (sigma sum - s N) / (P (1 + sigma)), where sum = a p + s^2 d r and tilt = s v,
  ///   corner = 2 s^2 turn_rate_tight |M|^4 kneser_flat^2 / (|T_tight| E_f^2),
  ///   height = 2 s^2 |T_flat|^3 v^2 / turn_rate_flat.
  ///  * Below the thickness is the corner alone: 2 epsilon of N, 2 epsilon of kneser_flat, 22 rho of other figures
  ///    (8 of turn_rate_tight, 2 of |M|^4, 1/2 of |T_tight|, 11/2 of E_f twice). b^2/4 is left out: b <= 2 tan alpha0 /
  ///    (1 + sigma) by reach + sigma <= 1, so with g up to T = 2^-5 and f <= g/1.5 it is below 25/9 T^2.
  ///  * Above it is the larger of corner and height. Where sigma g >= 3 f the tilt has, with sin m for g and sin delta
  ///    for f, 1.5 epsilon + 46 rho: sigma has epsilon/2 + 5 rho and g less than 15 rho, at |s r| <= p/4. The height
  ///    has twice that, 1.5 rho of |T_flat|^3 and 16 rho of turn_rate_flat, whose error is added to it. E is 4 epsilon
  ///    + 88 rho, for both.
  ///  * The outer arc has no height where tilt >= K_flat / sqrt(1 - K_flat^2): from the flat end to i it turns by no
  ///    more than 2 asin K_flat, as i is no farther than the chord is long, and its tangent there starts at an angle of
  ///    2 atan tilt to the inner segment. This is what happens next to inflections. With sigma g >= 1.5 f the error of
  ///    tilt and K_flat is below 2.8%, and 3.1% are asked.
  ///  * reach is bounded by (|T_tight|^2 + |M|^2)/2 kneser_flat / E_f, being |T_tight| |M| times the latter; reach +
  ///    sigma has an error below 1%, and is asked to be at most 0.97. As sigma^2 = 1 - sin alpha0 / K_tight, b = 2
  ///    K_tight reach is then what is said above.
  CGAL_BOUNDING_ARCS_INLINE static void rough(const Local_form<float>& c, const Rough_figures& figures, float half,
                                              std::size_t count, float* __restrict lower, float* __restrict upper) {
    constexpr float CERTAIN = Local_precision<float>::CERTAIN;
    const float of_half = 1 / half;
    for (std::size_t j = 0; j < count; ++j) {
      const Local_piece<float> g = figures.piece(j, half);
      const Local_ends<float> e = figures.ends(j);
      const Narrow_piece<float> n = narrow_piece(c, g, e, float(ROUGH_DOT_RATIO));
      const float beta = n.numerator * e.square1 + e.kneser1 * n.dot0, squares = g.chord_square * g.chord_square;
      const float flatness = (e.kneser1 * of_half) * (e.square0 * squares),
                  radicand = beta * beta + flatness * e.turn_rate1;
      const float edge = beta + std::sqrt(radicand);
      const float above = (e.turn_rate0 * squares) * (e.kneser1 * e.kneser1),
                  below = std::sqrt(e.square0) * (edge * edge);
      const float corner = above / below, sine = half * n.numerator;
      const float stretch = std::sqrt(half * e.kneser0 / (e.turn_rate0 * g.chord_square)), up = stretch * n.sum - sine;
      const float rate = (e.turn_rate1 > 0 ? e.turn_rate1 : 0.0f) + c.turn_rate_error;  // no less than the true one
      const float ratio = up / ((n.product * (1 + stretch)) * rate),
                  curved = std::sqrt(e.square1) * e.square1 * ratio;  // |M| tilt / K_flat
      const bool has_height = curved * curved < ROUGH_CURVED * g.chord_square;
      const float height = curved * (ratio * rate), larger = (has_height & (height > corner)) ? height : corner;
      const float kneser = smaller(e.kneser0, e.kneser1), factor = smaller(above, below);
      const bool is_nested = are_nested(n.numerator, n.product, e);
      const bool holds =
          n.holds & (e.turn_rate0 >= c.least_turn_rate) & (kneser >= CERTAIN * c.kneser_error) & is_nested &
          (half * n.sum <= ROUGH_TANGENT * n.product) & (flatness * c.least_turn_rate <= radicand) & (up + up >= sine) &
          ((e.square0 + g.chord_square) * e.kneser1 <= edge * (2 * ROUGH_LENGTHS - (stretch + stretch))) &
          (factor >= Local_precision<float>::LEAST_PRODUCT);
      const bool is_plain = (e.turn_rate1 >= c.least_turn_rate) & (up >= sine + sine);
      lower[j] = holds ? corner : -1.0f;
      upper[j] = holds & (is_plain | !has_height) ? larger : HUGE_VALF;
    }
  }
  // in parts of rho, where nothing else is said:
  static constexpr int ROUGH_DOT_RATIO = 4;        ///< of p to |s r|
  static constexpr float ROUGH_TANGENT = 0x1p-5f;  ///< T, of the mean angle
  static constexpr double ROUGH_SQUARE = double(ROUGH_TANGENT) * ROUGH_TANGENT / RHO<float>;
  static constexpr double LEAST_TILTED = 1.5, PLAIN_TILTED = 3;  ///< sigma g over f, of pieces at all and with a height
  static constexpr double ROUGH_TURN_RATE = Local_precision<float>::DIGITS / Local_precision<float>::TURN_RATE_DIGITS;
  static constexpr double ROUGH_EDGE = (3 + ROUGH_TURN_RATE) / 2;  ///< of E_f: F and turn_rate_flat in the root
  static constexpr double ROUGH_CORNER = ROUGH_TURN_RATE + 2 + 0.5 + 2 * ROUGH_EDGE;
  static constexpr double ROUGH_B = (1 + 1 / LEAST_TILTED) * (1 + 1 / LEAST_TILTED) * ROUGH_SQUARE;  ///< b^2 / 4
  static constexpr double CORNER_EPSILONS = 2 + 2;  ///< of N and kneser_flat

  static constexpr double ROUGH_STRETCH = (ROUGH_TURN_RATE + 1) / 2;
  static constexpr double ROUGH_G =
      error_of_mean_tangent(ROUGH_TURN_RATE, most_cancelled(ROUGH_DOT_RATIO, LEAST_TILTED));
  static constexpr double ROUGH_TILT = 46, TILT_EPSILONS = 1.5;
  static_assert(ROUGH_STRETCH <= 5 && ROUGH_G <= 15, "update the derivation above");
  // weights of both terms of sigma sin m - sin delta; code asks for what is left, 1/2 and 2 of the second
  static constexpr double FIRST = PLAIN_TILTED / (PLAIN_TILTED - 1), SECOND = FIRST - 1;
  static constexpr double WORST_FIRST = LEAST_TILTED / (LEAST_TILTED - 1), WORST_SECOND = WORST_FIRST - 1;
  // g for sin m, f for sin delta, and 1 + sigma for the divisor, in which sigma is at most one half
  static constexpr double FOR_SIN_MEAN = ROUGH_SQUARE / 2, FOR_SIN_DELTA = ROUGH_SQUARE, FOR_DIVISOR = ROUGH_SQUARE / 2;
  static constexpr double OF_DIVISOR = ROUGH_STRETCH / 2 + FOR_DIVISOR, OF_F = 2;
  static_assert(covers(ROUGH_TILT,
                       FIRST*(ROUGH_STRETCH + ROUGH_G + FOR_SIN_MEAN) + SECOND * (OF_F + FOR_SIN_DELTA) + OF_DIVISOR) &&
                    covers(TILT_EPSILONS, FIRST / 2 + SECOND + 0.25),
                "update the derivation above");
  static constexpr double ROUGH_HEIGHT = 2 * ROUGH_TILT + 1.5 + 2 * ROUGH_TURN_RATE;

  static constexpr double ROUGH_EPSILONS = CORNER_EPSILONS, ROUGH_RHOS = 88;
  static constexpr double ROUGH_ERROR =
      ROUGH_EPSILONS / Local_precision<float>::CERTAIN + ROUGH_RHOS / Local_precision<float>::DIGITS;
  static_assert(ROUGH_ERROR >= with_second_order<float>(CORNER_EPSILONS * EPSILON<float> +
                                                        (ROUGH_CORNER + ROUGH_B + OF_OPERATIONS<float>)*RHO<float>) &&
                    covers(ROUGH_ERROR, with_second_order<float>(2 * TILT_EPSILONS * EPSILON<float> +
                                                                 (ROUGH_HEIGHT + OF_OPERATIONS<float>)*RHO<float>)),
                "update the derivation above");

  /// Square of the least tilt / K_flat that leaves no height for certain.
  static constexpr float ROUGH_CURVED = 1.0625f;
  static constexpr double CURVED_ERROR = with_second_order<float>(
      (WORST_FIRST / 2 + WORST_SECOND + 0.25) * EPSILON<float> +
      (WORST_FIRST * (ROUGH_STRETCH + ROUGH_G + FOR_SIN_MEAN) + WORST_SECOND * (OF_F + FOR_SIN_DELTA) + OF_DIVISOR +
       1.5 + 0.5 + ROUGH_SQUARE / 2 + OF_OPERATIONS<float>)*RHO<float>);
  static_assert(covers(ROUGH_CURVED - 1, (1 + CURVED_ERROR) * (1 + CURVED_ERROR) - 1), "update the derivation above");

  /// The error of both tangents' lengths together, over the chord.
  static constexpr float ROUGH_LENGTHS = 0.97f;
  static constexpr double LENGTHS_ERROR =
      with_second_order<float>(2 * EPSILON<float> + (1 + ROUGH_EDGE + OF_OPERATIONS<float>)*RHO<float>);
  static_assert(LENGTHS_ERROR < 0.01 && ROUGH_LENGTHS * (1 + LENGTHS_ERROR) <= 1 - 2 * LENGTHS_ERROR,
                "update the derivation above");

  /// \param s half the piece's length
  [[nodiscard]] CGAL_BOUNDING_ARCS_INLINE static double rough_unit(double s) { return 2 * s * s; }

  /// The formulas of single pieces, and errors of first order gathered figure by figure (Tight_batch.h).
  [[nodiscard]] CGAL_BOUNDING_ARCS_INLINE static Bracket wide(const Local_form<double>& c, const Local_piece<double>& g,
                                                              const Local_ends<double>& e) {
    constexpr double CERTAIN = Local_precision<double>::CERTAIN, ROUNDING = Local_precision<double>::ROUNDING;
    const Tight_batch t = tight_batch(c, g, e);
    // the corner i and its distance from the tight end's circle
    const double beta = t.numerator * t.square_flat / t.kneser_flat + t.dot_tight;
    const double flatness = t.length_tight * t.length_tight * g.chord_square / (g.half * t.kneser_flat);
    const double radicand = beta * beta + flatness * t.turn_rate_flat,
                 reach = t.length_tight / (beta + std::sqrt(radicand));
    const double swing = 2 * g.half * t.turn_rate_tight * g.chord_square / (t.square_tight * t.length_tight) * reach;
    const double at_corner = swing * reach / (1 + std::sqrt(1 + swing * swing));
    // where the outer arc has a tangent parallel to the inner segment, and its height there
    const double stretch = std::sqrt(g.half * t.kneser_tight / (t.turn_rate_tight * g.chord_square));
    const double sin_mean =
        g.half * (g.a * g.p + g.square * (g.d * g.r)) / (t.length_tight * t.length_flat * t.cos_mean);
    const double turned = stretch * sin_mean, tilt = (turned - t.sin_delta) / (t.cos_delta + stretch * t.cos_mean);
    const double rise_flat = t.cross_flat / t.length_flat, rise_corner = reach * (2 * sin_mean * t.cos_mean);
    const double run = t.dot_flat / t.length_flat - reach * (t.cos_mean * t.cos_mean - sin_mean * sin_mean);
    const double margin = rise_flat - rise_corner - tilt * run;
    const double k_flat = g.half * t.turn_rate_flat * g.chord_square / (t.square_flat * t.length_flat);
    const bool has_height = margin > 0;
    const double height = has_height ? tilt * tilt / (k_flat * (1 + tilt * tilt)) : 0.0;
    // relative errors of first order
    const double rate_error = c.turn_rate_error / t.turn_rate_tight;
    const double mean_error =
        (c.turn_rate_error + ROUNDING * (g.a + std::fabs(g.half * g.d))) * g.p / (g.a * g.p + g.square * (g.d * g.r));
    const double reach_error = t.numerator_error + t.kneser_flat_error + flatness * c.turn_rate_error / radicand;
    const double tilt_error = (turned * (0.5 * (t.kneser_tight_error + rate_error) + mean_error) +
                               t.sin_delta * (t.numerator_error + ROUNDING)) /
                              std::fabs(turned - t.sin_delta);
    const double corner_error = rate_error + 2 * reach_error + ROUNDING;
    const double height_error = 2 * tilt_error + c.turn_rate_error / std::fabs(t.turn_rate_flat) + ROUNDING;
    const double open = g.half * c.turn_rate_error / t.length_flat + ROUNDING * std::fabs(rise_flat) +
                        rise_corner * (reach_error + mean_error) + std::fabs(tilt * run) * (tilt_error + reach_error) +
                        ROUNDING * (rise_corner + std::fabs(tilt));
    const bool holds =
        t.holds & are_nested(t.numerator, t.length_tight * t.length_flat * (t.cos_delta * t.cos_delta), e) &
        (t.turn_rate_tight >= CERTAIN * c.turn_rate_error) & (mean_error > 0) & (std::fabs(margin) >= 2 * open) &
        (!has_height | (t.turn_rate_flat >= CERTAIN * c.turn_rate_error));
    const double larger = at_corner > height ? at_corner : height;
    const double error = has_height && height_error > corner_error ? height_error : corner_error;
    return tight_bounds(t.chord * larger, error, holds);
  }

 private:
  // Constants of a narrow piece, in parts of rho where nothing else is said.
  static constexpr double HEIGHT_RATIO = 2.5, NO_HEIGHT_RATIO = 1.25;  ///< sigma sin m over sin delta
  static constexpr double KNESER_RATIO = 4;                            ///< kneser_flat over kneser_tight
  static constexpr double NARROW_FIRST = HEIGHT_RATIO / (HEIGHT_RATIO - 1), NARROW_SECOND = NARROW_FIRST - 1;
  static constexpr double CORNER_KNESERS = 2, HEIGHT_KNESERS = 2, CORNER_NUMERATORS = 2, HEIGHT_NUMERATORS = 2;
  static_assert(HEIGHT_KNESERS >= 2 * NARROW_FIRST / 2 && HEIGHT_NUMERATORS >= 2 * NARROW_SECOND,
                "update the derivation above");
  static constexpr double KNESER_WEIGHT = 10.5, NUMERATOR_WEIGHT = 2.25;
  static_assert(covers(KNESER_WEIGHT, CORNER_KNESERS + KNESER_RATIO * HEIGHT_KNESERS) &&
                    covers(NUMERATOR_WEIGHT, (std::max)(CORNER_NUMERATORS, HEIGHT_NUMERATORS)),
                "update the derivation above");

  static constexpr double LARGEST_SWING = 0x1p-6;  ///< tan of the turning between tight end and i, seen from the circle
  static constexpr double LARGEST_TILT = Narrow_angles::LARGEST_MEAN / 2;
  static constexpr double STRETCH = 1;  ///< half of turn_rate_tight and of |M|^2
  static constexpr double SIN_MEAN = Narrow_angles::OF_MEAN_TANGENT + Narrow_angles::OF_SIN_MEAN,
                          SIN_DELTA = 2 + Narrow_angles::OF_SINE, DIVISOR = STRETCH + Narrow_angles::OF_MEAN;
  static constexpr double TILT = NARROW_FIRST * (STRETCH + SIN_MEAN) + NARROW_SECOND * SIN_DELTA + DIVISOR;
  static constexpr double LENGTH = 1 + Narrow_angles::OF_COSINE;  ///< l, as one over a dot and a root
  static constexpr double K_FLAT = 1 + 2 + 3 * LENGTH;            ///< turn rate, |M|^4, l^3
  static constexpr double TILT_SERIES =
      LARGEST_TILT * LARGEST_TILT * LARGEST_TILT * LARGEST_TILT * LARGEST_TILT * LARGEST_TILT / RHO<double>;
  static constexpr double HEIGHT = 2 * TILT + K_FLAT + 0.5 + TILT_SERIES + OF_OPERATIONS<double>;
  static constexpr double EDGE = (3 + 1) / 2.0;  ///< beta + root: F, and the error of turn_rate_flat in the root
  static constexpr double CORNER =
      1 + 3 + 1 + 3 * LENGTH + 2 * EDGE + 0.5 + 1;  ///< turn rate, |M|^6, |T|^2, l^3, series
  static_assert(TILT_SERIES <= 1 && covers(LARGEST_TILT, LARGEST_SWING), "update the derivation above");
  static constexpr int HEIGHT_ROUNDINGS = 4;  ///< as the tilt, itself of many factors, comes in twice
  static_assert(covers(HEIGHT_ROUNDINGS * Local_precision<double>::MOST_FACTORS, (std::max)(HEIGHT, CORNER)),
                "update the derivation above");

  static constexpr double OF_SINES = 0x1p-8, OF_TILT_SINES = 0x1p-9, OF_TILT_ERRORS = 0x1p-10;
  static constexpr double WIDEST_FIRST = NO_HEIGHT_RATIO / (NO_HEIGHT_RATIO - 1), WIDEST_SECOND = WIDEST_FIRST - 1;
  static_assert(covers(OF_TILT_ERRORS,
                       (WIDEST_FIRST / 2 * KNESER_RATIO + WIDEST_SECOND) * EPSILON<double> +
                           (WIDEST_FIRST * (STRETCH + SIN_MEAN) + WIDEST_SECOND * SIN_DELTA + DIVISOR) * RHO<double>),
                "update the derivation above");
  static constexpr double CLEAR_ROOM = 2;
  static constexpr double CLEAR = 0x1p-6;  ///< angles are replaced by tangents where only their order counts
  static_assert(covers(CLEAR, CLEAR_ROOM*(OF_SINES + OF_TILT_SINES + OF_TILT_ERRORS)), "update the derivation above");
};

}  // namespace CGAL::Bounding_arcs::filter

#endif
