// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The angles of a narrow piece, one with small angles between chord and end tangents, as series without square roots.
// With t_i = tan alpha_i: f = (t0 - t1) / 2, g = (t0 + t1) / 2, q = f^2, z = t0 t1; derived in doc/batches.md.

#ifndef CGAL_BOUNDING_ARCS_2_FILTER_NARROW_ANGLES_H
#define CGAL_BOUNDING_ARCS_2_FILTER_NARROW_ANGLES_H

#include <CGAL/Bounding_arcs_2/filter/Batch_bounds.h>
#include <CGAL/Bounding_arcs_2/spiral/Local_curve.h>

#include <cmath>

namespace CGAL::Bounding_arcs::filter {

/// What bilens and spiral fat arcs need of a narrow piece.
template <class Real> struct Narrow_piece {
  Real numerator;            ///< N = a r + d p
  Real dot0, dot1, product;  ///< p -+ s r, their product
  Real sum;                  ///< a p + s^2 d r, so that g = s sum / product
  bool holds;  ///< all but N and the knesers are exact to 1 / DIGITS, and N and a are positive for certain
};

/// \param least_ratio of p to |s r|, 1.5 or more, so that dots are p / 3 at least and twice their product p^2
template <class Real>
[[nodiscard, gnu::always_inline]] inline Narrow_piece<Real> narrow_piece(const Local_form<Real>& c,
                                                                         const Local_piece<Real>& g,
                                                                         const Local_ends<Real>& e, Real least_ratio) {
  Narrow_piece<Real> n;
  const Real sr = g.half * g.r;
  n.numerator = g.a * g.r + g.d * g.p;
  n.dot0 = g.p - sr;
  n.dot1 = g.p + sr;
  n.product = n.dot0 * n.dot1;
  n.sum = g.a * g.p + g.square * (g.d * g.r);
  n.holds = (least_ratio * std::fabs(sr) <= g.p) & (g.p >= 4 * c.least_dot) & (g.chord_square >= c.least_square) &
            (e.square0 >= c.least_tangent) & (e.square1 >= c.least_tangent) & (g.a >= c.least_turn_rate) &
            (n.numerator >= Local_precision<Real>::CERTAIN * c.numerator_error);
  return n;
}

struct Narrow_angles {
  static constexpr double LEAST_DOT_RATIO = 1.5;      ///< what narrow_piece is to ask for
  static constexpr double LARGEST_PRODUCT = 0x1p-10;  ///< of z, and
  static constexpr double LEAST_RATIO = 1.5;          ///< of g to f, so that z >= q
  static constexpr double LARGEST_CHANGE = 0x1p-12;   ///< of f: what the series leave out is below 2^-32

  double f, g, q, z;
  double skew;  ///< 1 / sqrt(1 + t_i^2) = root() -+ skew
  double base;  ///< 1 / sqrt(1 + z)
  double sine;  ///< sin delta / f
  bool holds;   ///< both have one sign, and are within the limits

  [[nodiscard, gnu::always_inline]] inline double root() const { return base - q; }
  [[nodiscard, gnu::always_inline]] inline double mean() const {
    return base - 0.5 * q;
  }  ///< cos((alpha0 + alpha1) / 2), also root / cos delta
  [[nodiscard, gnu::always_inline]] inline double sin_mean() const { return g * (base - 1.5 * q); }
  [[nodiscard, gnu::always_inline]] inline double cos_delta() const { return 1 - 0.5 * q; }
};

[[nodiscard, gnu::always_inline]] inline Narrow_angles narrow_angles(double f, double g) {
  Narrow_angles n;
  n.f = f;
  n.g = g;
  n.q = f * f;
  n.z = g * g - n.q;
  const double half_z = 0.5 * n.z;
  n.skew = f * g * (1 - (n.z + half_z));
  n.base = (1 - half_z) + n.z * n.z * (0.375 - 0.3125 * n.z);
  n.sine = 1 - n.z * (1 - n.z * (1 - n.z)) - 1.5 * n.q;
  n.holds = (n.z <= Narrow_angles::LARGEST_PRODUCT) & (g >= Narrow_angles::LEAST_RATIO * f) &
            (f <= Narrow_angles::LARGEST_CHANGE);
  return n;
}

}  // namespace CGAL::Bounding_arcs::filter

#endif
