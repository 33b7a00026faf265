// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The thickness of a bilens in plain double with bounds on both sides, for batches: the formula of Bilens::thickness from
// the batch's figures of a piece.  With F = A T1.D - B T0.D = 2 s^2 (a r + d p) and l_i = n_i c:
//   sin delta cos delta = |F| / (2 l0 l1),   sin delta / (K0 - sin alpha0) = |a r + d p| n0^2 / (l1 |kneser0| cos delta).

#ifndef CGAL_BOUNDING_ARCS_2_REGION_BILENS_BATCH_H
#define CGAL_BOUNDING_ARCS_2_REGION_BILENS_BATCH_H

#include <CGAL/Bounding_arcs_2/region/Tight_batch.h>

#include <cmath>

namespace CGAL::Bounding_arcs::internal {

struct Bilens_batch {
  static constexpr bool HAS_NARROW = false, NEEDS_ENDS = true;

  [[nodiscard, gnu::always_inline]] static inline Batch_bounds wide(const Batch_curve& c, const Batch_piece<double>& g,
                                                                    const Batch_ends<double>& e) {
    const Tight_batch t = tight_batch(c, g, e);
    const double scale = t.size / t.cos_delta;
    const double ratio_a = scale * t.square_tight / (t.length_flat * t.kneser_tight);
    const double ratio_b = scale * t.square_flat / (t.length_tight * t.kneser_flat);
    const double both = ratio_a * ratio_b, room = 1 - both, change = 2 * t.cos_mean + ratio_a + ratio_b;
    const double outer = t.cross_tight / t.length_tight + t.sin_delta * ratio_b;
    const double inner = t.cross_flat / t.length_flat - t.sin_delta * ratio_a;
    const double thickness = t.chord * 2 * t.sin_delta * room / (change + std::sqrt(change * change + 4 * room * (outer * inner)));
    // to first order: (1 + ...) of the numerator, of room and of the denominator
    const double amplified = both / room;
    const double error = (3 + 2 * amplified) * t.size_error + (1 + amplified) * (t.kneser_tight_error + t.kneser_flat_error) + BATCH_ROUNDING;
    return tight_bounds(thickness, error, t.holds & (room >= LEAST_ROOM));
  }

 private:
  static constexpr double LEAST_ROOM = 0x1p-5;
};

}  // namespace CGAL::Bounding_arcs::internal

#endif
