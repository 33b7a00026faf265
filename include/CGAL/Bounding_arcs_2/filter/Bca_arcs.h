// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The bulges of BCAs in plain double, for batches.
//
// With the crosses and dots of Local_curve.h, t_i = tan alpha_i = cross_i / dot_i, a bulge is
//   tan(alpha / 2) = cross / (dot + sqrt(dot^2 + cross^2)) = t (1/2 - t^2/8 + t^4/16 - 5 t^6/128 + ...).
//
// Its error.  least_dot / DIGITS =: E bounds the errors of a dot and of s a and s^2 d together, so alpha errs by E /
// dot at most, and a bulge by no more, as angles are below a right one; the roundings of the formula add ROUNDINGS u of
// the bulge.  Both move the arc by that times half the chord, which is to be within `room` (Arc_points.h).

#ifndef CGAL_BOUNDING_ARCS_2_FILTER_BCA_ARCS_H
#define CGAL_BOUNDING_ARCS_2_FILTER_BCA_ARCS_H

#include <CGAL/Bounding_arcs_2/filter/Arc_points.h>
#include <CGAL/Bounding_arcs_2/filter/Batch_bounds.h>
#include <CGAL/Bounding_arcs_2/spiral/Local_curve.h>

#include <cmath>

namespace CGAL::Bounding_arcs::filter {

struct Bca_bulges {
  double outer, inner;  ///< the larger and the smaller; next to a vertex rounding may tell which end's is which
  bool holds;
};

struct Bca_arcs {
  /// Largest square of tan alpha of a narrow piece: the term after those kept is below 2^-60 of the first.
  static constexpr double NARROW_SQUARE = 0x1p-9;
  static_assert(2 * (33.0 / 2048) * NARROW_SQUARE * NARROW_SQUARE * NARROW_SQUARE * NARROW_SQUARE * NARROW_SQUARE *
                        NARROW_SQUARE <=
                    0x1p-58,
                "update the derivation above");
  // Two dots, their product, the quotient, two products, series, and the last product; or of squares, root, sum and
  // quotient.
  static constexpr double ROUNDINGS = 10;

  [[nodiscard, gnu::always_inline]] static inline Bca_bulges narrow(const Local_piece<double>& g) {
    const double step = g.half * g.r, dot0 = g.p - step, dot1 = g.p + step, sd = g.half * g.d;
    const double inverse = g.half / (dot0 * dot1);
    const double t0 = (g.a + sd) * dot1 * inverse, t1 = (g.a - sd) * dot0 * inverse, q0 = t0 * t0, q1 = t1 * t1;
    const double q = q0 > q1 ? q0 : q1;
    return ordered(t0 * series(q0), t1 * series(q1), q <= NARROW_SQUARE);
  }
  [[nodiscard, gnu::always_inline]] static inline Bca_bulges wide(const Local_piece<double>& g) {
    const double step = g.half * g.r, dot0 = g.p - step, dot1 = g.p + step, sd = g.half * g.d;
    const double cross0 = g.half * (g.a + sd), cross1 = g.half * (g.a - sd);
    const double tight = cross0 / (dot0 + std::sqrt(dot0 * dot0 + cross0 * cross0));
    const double flat = cross1 / (dot1 + std::sqrt(dot1 * dot1 + cross1 * cross1));
    constexpr double MOST = 0.42;  // above tan 22.5
    return ordered(tight, flat, (std::fabs(tight) <= MOST) & (std::fabs(flat) <= MOST));
  }
  /// Whether what bulges err by is within the room.
  [[nodiscard, gnu::always_inline]] static inline bool is_within(const Local_form<double>& c,
                                                                 const Local_piece<double>& g, double bulge,
                                                                 double room) {
    constexpr double U = Local_precision<double>::HALF_ULP, ERROR = 1 / Local_precision<double>::DIGITS;
    const double step = g.half * g.r, dot0 = g.p - step, dot1 = g.p + step, dot = dot0 < dot1 ? dot0 : dot1;
    const double half_chord = g.half * std::sqrt(g.chord_square);
    return (dot >= c.least_dot) & (g.chord_square >= c.least_square) &
           (half_chord * (c.least_dot * (ERROR * (1 + 0x1p-20)) + dot * (ROUNDINGS * U * bulge)) <= room * dot);
  }

 private:
  [[nodiscard, gnu::always_inline]] static inline Bca_bulges ordered(double tight, double flat, bool holds) {
    return {tight > flat ? tight : flat, tight > flat ? flat : tight, holds};
  }
  [[nodiscard, gnu::always_inline]] static inline double series(double q) {
    return 0.5 + q * (-0.125 + q * (0.0625 + q * (-0.0390625 + q * (0.02734375 + q * -0.0205078125))));
  }
};

}  // namespace CGAL::Bounding_arcs::filter

#endif
