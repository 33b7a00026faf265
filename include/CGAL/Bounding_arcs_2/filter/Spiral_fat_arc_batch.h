// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The thickness of a spiral fat arc in plain double with bounds on both sides, for batches: the formulas of
// Spiral_fat_arc::thickness from the batch's figures of a piece, lengths over the chord where nothing else is said:
//   |p_tight i| = l_tight / E,  E = beta + sqrt(beta^2 + l_tight^2 turn_rate_flat M.M / (s kneser_flat)),
//   beta = |a r + d p| |T_flat|^2 / kneser_flat + T_tight.D,  tangent length from the flat end sqrt(s kneser_tight /
//   (turn_rate_tight M.M)).

#ifndef CGAL_BOUNDING_ARCS_2_FILTER_SPIRAL_FAT_ARC_BATCH_H
#define CGAL_BOUNDING_ARCS_2_FILTER_SPIRAL_FAT_ARC_BATCH_H

#include <CGAL/Bounding_arcs_2/filter/Narrow_angles.h>
#include <CGAL/Bounding_arcs_2/filter/Rough_figures.h>
#include <CGAL/Bounding_arcs_2/filter/Tight_batch.h>

#include <cmath>

namespace CGAL::Bounding_arcs::filter {

/// Lower bounds are below the distance of the outer boundary from the inner one, which doc/batches.md proves to be no
/// more than the thickness of any piece around this one. It is less than the thickness only where i lies past the inner
/// arc's joint.
struct Spiral_fat_arc_batch {
  static constexpr bool NEEDS_ENDS = true;

  /// The same formulas with three square roots, as 1 / l = dot_other / (product sqrt(1 + t^2)), |T|^2 = l^2 / M.M.
  [[nodiscard, gnu::always_inline]] static inline Batch_bounds narrow(const Local_form<double>& c,
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
    const double error = 10.5 * c.kneser_error * error_step + 2.25 * c.numerator_error * of_numerator +
                         HEIGHT_ROUNDINGS * Local_precision<double>::ROUNDING;
    const bool holds = n.holds & t.holds & are_nested(numerator, n.product, e) &
                       (kneser_flat >= CERTAIN * c.kneser_error) & (4 * kneser_tight >= kneser_flat) &
                       (turn_rate_tight >= c.least_turn_rate) & (is_bent | !has_height) &
                       (flatness * c.least_turn_rate <= radicand) & (swing * down <= 1.94 * (t.g + t.f)) &
                       (turned >= (has_height ? 2.5 : 1.25) * sine) & (swing <= LARGEST_SWING) &
                       (std::fabs(rise - fall) >= CLEAR * (rise + fall));
    return scaled_bounds(std::sqrt(square) * (g.half * (2 * c.unit)), larger, error, 0, holds);
  }

  /// The same in float without series and with few divisions: with E = kneser_flat edge and v = tilt / s,
  ///   corner = 2 s^2 turn_rate_tight |M|^4 kneser_flat^2 / (|T_tight| E^2),   height = 2 s^2 |T_flat|^3 v^2 /
  ///   turn_rate_flat.
  /// The corner alone is a lower bound. The outer arc has no height where tilt >= K_flat, as it turns by less than
  /// twice that.
  [[gnu::always_inline]] static inline void rough(const Local_form<float>& c, const Rough_figures& figures, float half,
                                                  std::size_t count, float* __restrict lower, float* __restrict upper) {
    constexpr float CERTAIN = Local_precision<float>::CERTAIN;
    const float of_half = 1 / half;
    for (std::size_t j = 0; j < count; ++j) {
      const Local_piece<float> g = figures.piece(j, half);
      const Local_ends<float> e = figures.ends(j);
      const Narrow_piece<float> n = narrow_piece(c, g, e, 4.0f);
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
  static constexpr double ROUGH_ERROR = 4 / Local_precision<float>::CERTAIN + 88 / Local_precision<float>::DIGITS;
  /// \param s half the piece's length
  [[nodiscard, gnu::always_inline]] static inline double rough_unit(double s) { return 2 * s * s; }

  [[nodiscard, gnu::always_inline]] static inline Batch_bounds wide(const Local_form<double>& c,
                                                                    const Local_piece<double>& g,
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
    const double along =
        t.dot_tight + stretch * t.length_tight;  // the inner arc turns by twice atan(cross_tight / along)
    const double wedge = along * along - t.cross_tight * t.cross_tight;
    const double past =
        wedge > 0 ? swing - 1.99 * (t.cross_tight * along) / wedge : 0.0;  // of i past the joint, a tangent
    const double nearer = past > 0 ? 0.5 * past * past * (reach / swing + at_corner) : 0.0;
    const bool holds =
        t.holds & are_nested(t.numerator, t.length_tight * t.length_flat * (t.cos_delta * t.cos_delta), e) &
        (t.turn_rate_tight >= CERTAIN * c.turn_rate_error) & (mean_error > 0) & (std::fabs(margin) >= 2 * open) &
        (!has_height | (t.turn_rate_flat >= CERTAIN * c.turn_rate_error));
    const double larger = at_corner > height ? at_corner : height;
    const double error = has_height && height_error > corner_error ? height_error : corner_error;
    const Batch_bounds b = tight_bounds(t.chord * larger, error, holds);
    return {b.lower > 0 ? b.lower - t.chord * nearer : b.lower, b.upper};
  }

 private:
  static constexpr int HEIGHT_ROUNDINGS = 4;  ///< as the tilt, itself of many factors, comes in twice
  // of a narrow piece:
  static constexpr double LARGEST_SWING = 0x1p-6;  ///< tan of the turning between tight end and i, seen from the circle
  static constexpr double CLEAR = 0x1p-6;          ///< angles are replaced by tangents where only their order counts
  // in float:
  static constexpr float ROUGH_TANGENT = 0x1p-5f;  ///< of the mean angle
  static constexpr float ROUGH_LENGTHS = 0.97f;    ///< of both tangents' lengths together, over the chord
  static constexpr float ROUGH_CURVED =
      1.0625f;  ///< square of the least tilt / K_flat that leaves no height for certain
};

}  // namespace CGAL::Bounding_arcs::filter

#endif
