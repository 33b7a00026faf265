// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The angles of a narrow piece, one with small angles between chord and end tangents, as series without square roots.
// With t_i = tan alpha_i: f = (t0 - t1) / 2, g = (t0 + t1) / 2, q = f^2, z = t0 t1; derived in doc/batches.md.

#ifndef CGAL_BOUNDING_ARCS_2_REGION_NARROW_ANGLES_H
#define CGAL_BOUNDING_ARCS_2_REGION_NARROW_ANGLES_H

#include <CGAL/Bounding_arcs_2/region/Batch_bounds.h>
#include <CGAL/Bounding_arcs_2/spiral/Batch_curve.h>

#include <cmath>

namespace CGAL::Bounding_arcs::internal {

/// What bilens and spiral fat arcs need of a narrow piece.
template <class Real>
struct Narrow_piece {
  Real size;                    ///< N = a r + d p
  Real dot0, dot1, product;     ///< p -+ s r, their product
  Real sum;                     ///< a p + s^2 d r, so that g = s sum / product
  bool holds;                   ///< all but N and the knesers are exact to 1 / DIGITS, and N and a are positive for certain
};

/// \param certain how many times its error bound N has to be
/// \param least_bend what a has to be
template <class Real>
[[nodiscard, gnu::always_inline]] inline Narrow_piece<Real> narrow_piece(const Batch_form<Real>& c, const Batch_piece<Real>& g,
                                                                         const Batch_ends<Real>& e, Real certain, Real least_bend) {
  Narrow_piece<Real> n;
  const Real sr = g.half * g.r;
  n.size = g.a * g.r + g.d * g.p;
  n.dot0 = g.p - sr;
  n.dot1 = g.p + sr;
  n.product = n.dot0 * n.dot1;
  n.sum = g.a * g.p + g.square * (g.d * g.r);
  // where |s r| <= p / 1.5, dots are at least p / 3, and twice their product is at least p^2
  n.holds = (Real(1.5) * std::fabs(sr) <= g.p) & (g.p >= 4 * c.least_dot) & (g.chord_square >= c.least_square) &
            (e.square0 >= c.least_tangent) & (e.square1 >= c.least_tangent) & (g.a >= least_bend) &
            (n.size >= certain * c.numerator_error);
  return n;
}

template <class Real>
struct Narrow_angles {
  static constexpr bool LONG = Batch_precision<Real>::LONG_SERIES;
  static constexpr Real LARGEST_PRODUCT = Real(0x1p-10);  ///< of z, and
  static constexpr Real LEAST_RATIO = Real(1.5);          ///< of g to f, so that z >= q; short series do not contain q
  static constexpr Real LARGEST_CHANGE = Real(0x1p-12);   ///< of f: what the series leave out is below 2^-32, or 2^-16 where they are short

  Real f, g, q, z;
  Real skew;       ///< 1 / sqrt(1 + t_i^2) = root() -+ skew; 0 where series are short
  Real base;       ///< 1 / sqrt(1 + z)
  Real sine;       ///< sin delta / f
  bool holds;      ///< both have one sign, and are within the limits

  [[nodiscard, gnu::always_inline]] inline Real root() const { return LONG ? base - q : base; }
  [[nodiscard, gnu::always_inline]] inline Real mean() const { return LONG ? base - Real(0.5) * q : base; }  ///< cos((alpha0 + alpha1) / 2), also root / cos delta
  [[nodiscard, gnu::always_inline]] inline Real mean_more() const { return LONG ? mean() + skew : base; }
  [[nodiscard, gnu::always_inline]] inline Real mean_less() const { return LONG ? mean() - skew : base; }
  [[nodiscard, gnu::always_inline]] inline Real root_more() const { return LONG ? root() + skew : base; }
  [[nodiscard, gnu::always_inline]] inline Real root_less() const { return LONG ? root() - skew : base; }
  [[nodiscard, gnu::always_inline]] inline Real sin_mean() const { return LONG ? g * (base - Real(1.5) * q) : g * base; }
  [[nodiscard, gnu::always_inline]] inline Real cos_delta() const { return LONG ? 1 - Real(0.5) * q : Real(1); }
};

template <class Real>
[[nodiscard, gnu::always_inline]] inline Narrow_angles<Real> narrow_angles(Real f, Real g) {
  Narrow_angles<Real> n;
  n.f = f;
  n.g = g;
  n.q = f * f;
  n.z = Batch_precision<Real>::LONG_SERIES ? g * g - n.q : g * g;
  const Real half_z = Real(0.5) * n.z;
  if constexpr (Batch_precision<Real>::LONG_SERIES) {
    n.skew = f * g * (1 - (n.z + half_z));
    n.base = (1 - half_z) + n.z * n.z * (Real(0.375) - Real(0.3125) * n.z);
    n.sine = 1 - n.z * (1 - n.z * (1 - n.z)) - Real(1.5) * n.q;
  } else {
    n.skew = 0;
    n.base = 1 - half_z;
    n.sine = 1 - n.z;
  }
  const bool is_ordered = Narrow_angles<Real>::LONG ? g >= Narrow_angles<Real>::LEAST_RATIO * f : g >= f;
  n.holds = (n.z <= Narrow_angles<Real>::LARGEST_PRODUCT) & is_ordered & (f <= Narrow_angles<Real>::LARGEST_CHANGE);
  return n;
}

}  // namespace CGAL::Bounding_arcs::internal

#endif
