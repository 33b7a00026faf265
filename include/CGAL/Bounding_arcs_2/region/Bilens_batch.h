// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The thickness of a bilens in plain double with bounds on both sides, for batches: the formula of Bilens::thickness from
// the batch's figures of a piece.  With F = A T1.D - B T0.D = 2 s^2 (a r + d p) and l_i = n_i c:
//   sin delta cos delta = |F| / (2 l0 l1),   sin delta / (K0 - sin alpha0) = |a r + d p| n0^2 / (l1 |kneser0| cos delta).

#ifndef CGAL_BOUNDING_ARCS_2_REGION_BILENS_BATCH_H
#define CGAL_BOUNDING_ARCS_2_REGION_BILENS_BATCH_H

#include <CGAL/Bounding_arcs_2/region/Narrow_angles.h>
#include <CGAL/Bounding_arcs_2/region/Tight_batch.h>

#include <cmath>

namespace CGAL::Bounding_arcs::internal {

struct Bilens_batch {
  static constexpr bool NEEDS_ENDS = true, NEEDS_BENDS = false;

  /// The same figures with signs, so that nothing depends on which end is the tight one; two divisions and the chord's
  /// square root.  ratio_i = sin delta / (K_i - sin alpha_i) = N |T_i|^2 / (l_(1-i) kneser_i cos delta), and with
  /// v = 4 room K_A K_B / change^2, below 2^-9.9 as change > 1.99, 1 / (1 + sqrt(1 + v)) = 1/2 - v/8 + v^2/16 - ...
  template <class Real>
  [[nodiscard, gnu::always_inline]] static inline Batch_bounds<Real> narrow(const Batch_form<Real>& c, const Batch_piece<Real>& g,
                                                                      const Batch_ends<Real>& e) {
    constexpr Real CERTAIN = Batch_precision<Real>::CERTAIN / 2;  // no sign depends on it, and weights have room
    // a comes in by z only, of which short series need few digits
    const Narrow_piece<Real> n = narrow_piece(c, g, e, CERTAIN, Batch_precision<Real>::LONG_SERIES ? c.least_bend : CERTAIN * c.bend_error);
    const Real product = e.kneser0 * e.kneser1, inverses = 1 / (n.product * product);  // one division for three
    const Real inverse = inverses * product, common = n.size * inverses;
    const Real scaled = g.half * inverse, squared = g.half * scaled;
    const Narrow_angles<Real> t = narrow_angles(squared * n.size, scaled * n.sum);
    const Real ratio0 = common * t.mean_more() * (e.square0 * n.dot0 * e.kneser1), mean = t.mean();
    const Real ratio1 = common * t.mean_less() * (e.square1 * n.dot1 * e.kneser0);
    const Real both = ratio0 * ratio1, room = 1 - both, sum = ratio0 + ratio1, change = 1 / (mean + mean + sum);
    const Real slope = room * change;
    Real factor = slope;
    if constexpr (t.LONG) {
      const Real contacts = (t.z - t.z * t.z) + t.skew * (ratio1 - ratio0) - t.q * (sum + both);
      const Real v = contacts * (slope * change);  // a quarter of the v above
      factor = slope * (1 - v * (1 - (v + v)));
    }
    const Real scale = std::sqrt(g.chord_square) * (g.half * (2 * c.unit)) * (t.sine * squared) * factor;
    // The thickness has at most 5 times the relative error of N and twice those of the knesers, as both < room.
    const Real knesers = Real(2.25) * c.kneser_error * (inverses * n.product * (e.kneser0 + e.kneser1));
    const bool holds = n.holds & t.holds & (ratio0 > 0) & (ratio1 > 0) & (room >= Real(NARROW_ROOM)) &
                       (knesers <= Real(2.25) / CERTAIN);
    return scaled_bounds(scale, n.size, knesers + Batch_precision<Real>::ROUNDING, Real(5.5) * c.numerator_error, holds);
  }

  [[nodiscard, gnu::always_inline]] static inline Batch_bounds<double> wide(const Batch_form<double>& c, const Batch_piece<double>& g,
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
    const double error = (3 + 2 * amplified) * t.size_error + (1 + amplified) * (t.kneser_tight_error + t.kneser_flat_error + Batch_precision<double>::ROUNDING);
    return tight_bounds(thickness, error, t.holds & (room >= LEAST_ROOM));
  }

 private:
  // of 1 - r_a r_b, which is about 3/4, and 2/3 at a vertex:
  static constexpr double NARROW_ROOM = 0.625;
  static constexpr double LEAST_ROOM = 0x1p-5;
};

}  // namespace CGAL::Bounding_arcs::internal

#endif
