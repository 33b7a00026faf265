// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The tangents of half the angles between a piece's chord and its end tangents, in plain double, for batches: what the
// arcs of all regions are made of.
//
// With the crosses and dots of Local_figures.h, t_i = tan alpha_i = cross_i / dot_i, it is
//   tan(alpha / 2) = cross / (dot + sqrt(dot^2 + cross^2)) = t (1/2 - t^2/8 + t^4/16 - 5 t^6/128 + ...).
//
// Error of that.  least_dot / DIGITS =: E bounds the error of a dot, and turn_rate_error those of a and s d together,
// so alpha errs by (s turn_rate_error + E tan alpha) / dot at most, and the tangent of its half by less; tan alpha is
// at most OF_DOT times that.  The roundings of the formula add ROUNDINGS u of it, and twice that of alpha.

#ifndef BOUNDING_ARCS_LIBRARY_TREE_BATCH_HALF_TANGENTS_H
#define BOUNDING_ARCS_LIBRARY_TREE_BATCH_HALF_TANGENTS_H

#include "Batch_bounds.h"

#include <CGAL/Bounding_arcs_2/number/strict_math.h>
#include "../../spiral/Local_figures.h"

#include <cmath>

namespace CGAL::Bounding_arcs::filter {

/// The tangents of half the angles between a piece's chord and its end tangents.
struct Half_tangents {
  double tight, flat;  ///< of alpha0 and alpha1, as Local_figures.h orders ends
  bool holds;

  /// Largest square of tan alpha of a narrow piece: the term after those kept is below 2^-60 of the first.
  static constexpr double NARROW_SQUARE = 0x1p-9;
  static_assert(2 * (33.0 / 2048) * NARROW_SQUARE * NARROW_SQUARE * NARROW_SQUARE * NARROW_SQUARE * NARROW_SQUARE *
                        NARROW_SQUARE <=
                    0x1p-58,
                "update the derivation above");
  static constexpr double MOST = 0.42;  ///< above tan 22.5 degrees: spirals turn by 90 at most
  static constexpr double OF_DOT = 2.43;
  static_assert(OF_DOT >= 2 / (1 - MOST * MOST), "update the derivation above");
  // Sum and product of the cross, two dots, their product, the quotient, two products, series, and the last product;
  // or of squares, root, sum and quotient.
  static constexpr double ROUNDINGS = 12;

  template <bool WIDE> [[nodiscard]] CGAL_BOUNDING_ARCS_INLINE static Half_tangents of(const Local_piece<double>& g) {
    const double step = g.half * g.r, dot0 = g.p - step, dot1 = g.p + step, sd = g.half * g.d;
    if constexpr (WIDE) {
      const double cross0 = g.half * (g.a + sd), cross1 = g.half * (g.a - sd);
      const double tight = cross0 / (dot0 + std::sqrt(dot0 * dot0 + cross0 * cross0));
      const double flat = cross1 / (dot1 + std::sqrt(dot1 * dot1 + cross1 * cross1));
      const bool holds = (std::fabs(tight) <= MOST) & (std::fabs(flat) <= MOST);
      return {tight, flat, holds};
    } else {
      const double inverse = g.half / (dot0 * dot1);
      const double t0 = (g.a + sd) * dot1 * inverse, t1 = (g.a - sd) * dot0 * inverse, q0 = t0 * t0, q1 = t1 * t1;
      const double q = q0 > q1 ? q0 : q1;
      return {t0 * series(q0), t1 * series(q1), q <= NARROW_SQUARE};
    }
  }

  /// tan(x / 2) over t = tan x, where q = t^2 <= NARROW_SQUARE.
  [[nodiscard]] CGAL_BOUNDING_ARCS_INLINE static double series(double q) {
    return 0.5 + q * (-0.125 + q * (0.0625 + q * (-0.0390625 + q * (0.02734375 + q * -0.0205078125))));
  }
};

/// What checks of a piece's arcs need.
struct Arc_errors {
  double half_chord;
  double dot;     ///< the smaller one
  double bend;    ///< the larger half tangent, without sign
  double of_dot;  ///< bound on the error of a dot
  double turn;    ///< an end's angle errs by this over `dot`
  bool holds;     ///< the figures are no smaller than they may be
};
[[nodiscard]] CGAL_BOUNDING_ARCS_INLINE Arc_errors arc_errors(const Local_form<double>& c, const Local_piece<double>& g,
                                                              const Half_tangents& t) {
  constexpr double ERROR = (1 + 0x1p-20) / Local_precision<double>::DIGITS;
  const double step = g.half * g.r, dot0 = g.p - step, dot1 = g.p + step, dot = dot0 < dot1 ? dot0 : dot1;
  const double one = std::fabs(t.tight), other = std::fabs(t.flat), bend = one > other ? one : other,
               of_dot = ERROR * c.least_dot;
  const bool holds = t.holds & (dot >= c.least_dot) & (g.chord_square >= c.least_square);
  return {g.half * std::sqrt(g.chord_square),
          dot,
          bend,
          of_dot,
          (1 + 0x1p-20) * (g.half * c.turn_rate_error + Half_tangents::OF_DOT * bend * of_dot),
          holds};
}

// The arcs of regions whose sides have a joint, over the unit chord: the tight end at 0, the flat end at 1, centers of
// curvature to the left, points as complex numbers.  With e^(-i alpha0) and e^(i alpha1) the directions of the curve at
// its ends, an arc that leaves 0 in the first and ends in z turns by twice the angle of z e^(i alpha0), and its bulge
// is the tangent of half that angle.

/// One side: from the tight end by an arc with the first bulge to the joint, from there by one with the second.
struct Joint_side {
  double x, y;
  double tight, flat;
};

/// The arcs of a region whose sides have a joint, over the unit chord.
struct Joint_arcs {
  Joint_side inner, outer;
  bool holds;
};

/// What a bulge Im / (|q| + Re) of q = Re + i Im is divided by: of wide pieces that, of narrow ones Re alone, and the
/// bulge is had from the quotient by its series.
template <bool WIDE>
[[nodiscard]] CGAL_BOUNDING_ARCS_INLINE double bulge_divisor(double re, [[maybe_unused]] double square) {
  if constexpr (WIDE) return re + std::sqrt(square);
  else return re;
}
template <bool WIDE> [[nodiscard]] CGAL_BOUNDING_ARCS_INLINE double bulge_of(double quotient) {
  if constexpr (WIDE) return quotient;
  else return quotient * Half_tangents::series(quotient * quotient);
}

}  // namespace CGAL::Bounding_arcs::filter

#endif
