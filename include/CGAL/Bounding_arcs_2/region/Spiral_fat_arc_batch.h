// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The thickness of a spiral fat arc in plain double with bounds on both sides, for batches: the formulas of
// Spiral_fat_arc::thickness from the batch's figures of a piece, lengths over the chord where nothing else is said:
//   |p_tight i| = l_tight / E,  E = beta + sqrt(beta^2 + l_tight^2 bend_flat M.M / (s kneser_flat)),
//   beta = |a r + d p| |T_flat|^2 / kneser_flat + T_tight.D,  tangent length from the flat end sqrt(s kneser_tight / (bend_tight M.M)).

#ifndef CGAL_BOUNDING_ARCS_2_REGION_SPIRAL_FAT_ARC_BATCH_H
#define CGAL_BOUNDING_ARCS_2_REGION_SPIRAL_FAT_ARC_BATCH_H

#include <CGAL/Bounding_arcs_2/region/Tight_batch.h>

#include <cmath>

namespace CGAL::Bounding_arcs::internal {

struct Spiral_fat_arc_batch {
  static constexpr bool HAS_NARROW = false, NEEDS_ENDS = true;

  [[nodiscard, gnu::always_inline]] static inline Batch_bounds wide(const Batch_curve& c, const Batch_piece<double>& g,
                                                                    const Batch_ends<double>& e) {
    const Tight_batch t = tight_batch(c, g, e);
    // the corner i and its distance from the tight end's circle
    const double beta = t.size * t.square_flat / t.kneser_flat + t.dot_tight;
    const double flatness = t.length_tight * t.length_tight * g.chord_square / (g.half * t.kneser_flat);
    const double radicand = beta * beta + flatness * t.bend_flat, reach = t.length_tight / (beta + std::sqrt(radicand));
    const double bend = 2 * g.half * t.bend_tight * g.chord_square / (t.square_tight * t.length_tight) * reach;
    const double at_corner = bend * reach / (1 + std::sqrt(1 + bend * bend));
    // where the outer arc has a tangent parallel to the inner segment, and its height there
    const double stretch = std::sqrt(g.half * t.kneser_tight / (t.bend_tight * g.chord_square));
    const double sin_mean = g.half * (std::fabs(g.a) * g.p + std::copysign(1.0, g.a) * g.square * (g.d * g.r)) / (t.length_tight * t.length_flat * t.cos_mean);
    const double turned = stretch * sin_mean, tilt = (turned - t.sin_delta) / (t.cos_delta + stretch * t.cos_mean);
    const double rise_flat = t.cross_flat / t.length_flat, rise_corner = reach * (2 * sin_mean * t.cos_mean);
    const double run = t.dot_flat / t.length_flat - reach * (t.cos_mean * t.cos_mean - sin_mean * sin_mean);
    const double margin = rise_flat - rise_corner - tilt * run;
    const double k_flat = g.half * t.bend_flat * g.chord_square / (t.square_flat * t.length_flat);
    const bool has_height = margin > 0;
    const double height = has_height ? tilt * tilt / (k_flat * (1 + tilt * tilt)) : 0.0;
    // relative errors of first order
    const double bend_error = c.bend_error / t.bend_tight, mean_error = c.bend_error / std::fabs(g.a) + BATCH_ROUNDING;
    const double reach_error = t.size_error + t.kneser_flat_error + flatness * c.bend_error / radicand;
    const double tilt_error = (turned * (0.5 * (t.kneser_tight_error + bend_error) + mean_error) + t.sin_delta * t.size_error) /
                              std::fabs(turned - t.sin_delta);
    const double corner_error = bend_error + 2 * reach_error + BATCH_ROUNDING;
    const double height_error = 2 * tilt_error + c.bend_error / std::fabs(t.bend_flat) + BATCH_ROUNDING;
    const double open = std::fabs(rise_flat) * mean_error * 2 + rise_corner * (reach_error + mean_error) + std::fabs(tilt * run) * (tilt_error + reach_error) + BATCH_ROUNDING * (rise_corner + std::fabs(tilt));
    const bool holds = t.holds & (t.bend_tight >= CERTAIN * c.bend_error) & (std::fabs(margin) >= 2 * open) &
                       (!has_height | (t.bend_flat >= CERTAIN * c.bend_error));
    const double larger = at_corner > height ? at_corner : height;
    const double error = has_height && height_error > corner_error ? height_error : corner_error;
    return tight_bounds(t.chord * larger, error, holds);
  }
};

}  // namespace CGAL::Bounding_arcs::internal

#endif
