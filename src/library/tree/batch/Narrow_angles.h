// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The angles of a narrow piece, one with small angles between chord and end tangents, as series without square roots.
// With t_i = tan alpha_i and P = (T0.D)(T1.D):
//   f = (t0 - t1) / 2 = s^2 N / P,   g = (t0 + t1) / 2 = s (a p + s^2 d r) / P,   q = f^2,   z = t0 t1 = g^2 - q.
// As (1 + t0^2)(1 + t1^2) = (1 + z)^2 + 4 q,
//   cos 2 delta = (1 + z) / sqrt((1 + z)^2 + 4 q),     cos 2m = (1 - z) / sqrt((1 + z)^2 + 4 q),
//   sin 2m = 2 g / sqrt((1 + z)^2 + 4 q).

#ifndef BOUNDING_ARCS_LIBRARY_TREE_BATCH_NARROW_ANGLES_H
#define BOUNDING_ARCS_LIBRARY_TREE_BATCH_NARROW_ANGLES_H

#include "Batch_bounds.h"

#include <CGAL/Bounding_arcs_2/number/strict_math.h>
#include "../../spiral/Local_figures.h"

#include <cmath>

namespace CGAL::Bounding_arcs::filter {

/// What bilens and spiral fat arcs need of a narrow piece.
template <class Real> struct Narrow_piece {
  Real numerator;            ///< N = a r + d p
  Real dot0, dot1, product;  ///< p -+ s r, their product
  Real sum;                  ///< a p + s^2 d r, so that g = s sum / product
  bool holds;                ///< all but sum, N and the knesers are exact to rho, and N and a are positive for certain
};

inline constexpr double LEAST_NARROW_RATIO = 1.5;  ///< of p to |s r|
inline constexpr int LEAST_DOTS = 4;               ///< that p is to reach, so that each dot reaches one
static_assert(covers(LEAST_DOTS * (1 - 1 / LEAST_NARROW_RATIO), 1, 1.5), "p / 3 is to be a dot exact to rho");

/// \param least_ratio of p to |s r|, LEAST_NARROW_RATIO or more: |s r| <= p / 1.5, so that dots are p / 3 at least and
///   differ by a factor of 5 at most, and 2 P = 2 (p^2 - s^2 r^2) >= p^2
template <class Real>
[[nodiscard]] CGAL_BOUNDING_ARCS_INLINE Narrow_piece<Real> narrow_piece(const Local_form<Real>& c,
                                                                        const Local_piece<Real>& g,
                                                                        const Local_ends<Real>& e, Real least_ratio) {
  Narrow_piece<Real> n;
  const Real sr = g.half * g.r;
  n.numerator = g.a * g.r + g.d * g.p;
  n.dot0 = g.p - sr;
  n.dot1 = g.p + sr;
  n.product = n.dot0 * n.dot1;
  n.sum = g.a * g.p + g.square * (g.d * g.r);
  n.holds = (least_ratio * std::fabs(sr) <= g.p) & (g.p >= LEAST_DOTS * c.least_dot) &
            (g.chord_square >= c.least_square) & (e.square0 >= c.least_tangent) & (e.square1 >= c.least_tangent) &
            (g.a >= c.least_turn_rate) & (n.numerator >= Local_precision<Real>::CERTAIN * c.numerator_error);
  return n;
}

/// The most by which a p exceeds a p + s^2 d r, where the dots are positive, |s r| <= p / dot_ratio and g >= ratio f >=
/// 0. With x = s d / a, y = -s r / p: g is in proportion to 1 - x y, and f to x - y.  Where the product cancels, x and
/// y have one sign.  If it is negative, f >= 0 tells |x| <= |y|.  If it is positive, 1 - x y >= ratio (x - y), so that
/// x <= (1 + ratio y) / (ratio + y), which grows with y; and y is below 1 / dot_ratio.
[[nodiscard]] constexpr double most_cancelled(double dot_ratio, double ratio) {
  const double y = 1 / dot_ratio, x = (1 + ratio * y) / (ratio + y);
  return 1 / (1 - (x > y ? x : y) * y);
}
/// Relative error of g, in parts of rho: 2 of P, and that of sum = a p + s^2 d r.  The errors of a and s d together are
/// at most turn_rate parts of rho of a (Local_form::turn_rate_error), those of p and s r together those of one dot,
/// which are rho of the least one, and p reaches LEAST_DOTS of these.  As |s r| <= p, and |s d| <= a where crosses are
/// positive, sum errs by a p (turn_rate + 1/LEAST_DOTS) rho at most.
[[nodiscard]] constexpr double error_of_mean_tangent(double turn_rate, double cancelled) {
  return cancelled * (turn_rate + 1.0 / LEAST_DOTS) + 2;
}

/// A piece is narrow when 1.5 f <= g, z <= 2^-10 and f <= 2^-12, so q <= z.  With base = 1 / sqrt(1 + z) = 1 - z/2 +
/// 3 z^2/8 - 5 z^3/16 the series are
///
///   figure                               series                                                    omitted, at most
///   cos alpha_i = 1 / sqrt(1 + t_i^2)    base - q -+ skew, skew = f g (1 - 3 z/2)   3 z q + 3 z^2 f g + 35 z^4/128
///   cos m                                base - q/2                                                     2 z q + z^4
///   cos alpha_i / cos delta              base - q/2 -+ skew                                2 z q + 3 z^2 f g + z^4
///   sin m / g                            base - 3 q/2                                                   4 z q + z^4
///   sin delta / f                        1 - z + z^2 - z^3 - 3 q/2                            4.5 z q + z^4 + 8 q^2
///   cos delta                            1 - q/2                                                                z q
///
/// The first is from t_i^2 = z + 2 q +- 2 f g, as t_0, t_1 = g +- f.  The square root of a sum, where it is about 1, is
/// expanded in the same way.
///
/// f, and with it q and skew, has the relative error of N.  q and skew enter with weights below 2^-16, which the
/// constants of formulas are rounded up for.
struct Narrow_angles {
  static constexpr double LEAST_DOT_RATIO = LEAST_NARROW_RATIO;  ///< what narrow_piece is to ask for
  static constexpr double LARGEST_PRODUCT = 0x1p-10;             ///< of z, and
  static constexpr double LEAST_RATIO = 1.5;                     ///< of g to f, so that z >= q
  static constexpr double LARGEST_CHANGE = 0x1p-12;              ///< of f
  static constexpr double LARGEST_MEAN = 0x1.001p-5;             ///< of g, as g^2 = z + q
  static_assert(LEAST_RATIO * LEAST_RATIO - 1 >= 1 &&
                    covers(LARGEST_MEAN * LARGEST_MEAN, LARGEST_PRODUCT + LARGEST_CHANGE * LARGEST_CHANGE, 1.001),
                "update the derivation above");

  // what the series leave out, in parts of rho
  static constexpr double ZQ = LARGEST_PRODUCT * LARGEST_CHANGE * LARGEST_CHANGE / RHO<double>;
  static constexpr double ZZFG = LARGEST_PRODUCT * LARGEST_PRODUCT * LARGEST_CHANGE * LARGEST_MEAN / RHO<double>;
  static constexpr double ZZZZ = LARGEST_PRODUCT * LARGEST_PRODUCT * LARGEST_PRODUCT * LARGEST_PRODUCT / RHO<double>;
  static constexpr double QQ = LARGEST_CHANGE * LARGEST_CHANGE * LARGEST_CHANGE * LARGEST_CHANGE / RHO<double>;
  static constexpr double OF_COSINE = 3 * ZQ + 3 * ZZFG + 35.0 / 128 * ZZZZ, OF_MEAN = 2 * ZQ + ZZZZ,
                          OF_RATIO = 2 * ZQ + 3 * ZZFG + ZZZZ, OF_SIN_MEAN = 4 * ZQ + ZZZZ,
                          OF_SINE = 4.5 * ZQ + ZZZZ + 8 * QQ, OF_COS_DELTA = ZQ;
  static_assert(OF_COSINE < 2 && OF_MEAN < 2 && OF_RATIO < 2 && OF_SIN_MEAN < 4 && OF_SINE < 4 && OF_COS_DELTA < 1,
                "series are to be as good as the figures in them");
  static constexpr double SKEW_WEIGHT = 0x1p-16;
  static_assert(covers(SKEW_WEIGHT, LARGEST_CHANGE*(LARGEST_MEAN + LARGEST_CHANGE), 2), "update the derivation above");
  /// Relative error of g in parts of rho, and room: as a p and s^2 d r cancel to 5/13 of a p at most, it is 5.25.
  static constexpr double OF_MEAN_TANGENT = 9;
  static_assert(covers(OF_MEAN_TANGENT, error_of_mean_tangent(1, most_cancelled(LEAST_DOT_RATIO, LEAST_RATIO)), 1.75),
                "update the derivation above");

  double f, g, q, z;
  double skew;  ///< 1 / sqrt(1 + t_i^2) = root() -+ skew
  double base;  ///< 1 / sqrt(1 + z)
  double sine;  ///< sin delta / f
  bool holds;   ///< both have one sign, and are within the limits

  [[nodiscard]] CGAL_BOUNDING_ARCS_INLINE double root() const { return base - q; }
  [[nodiscard]] CGAL_BOUNDING_ARCS_INLINE double mean() const {
    return base - 0.5 * q;
  }  ///< cos((alpha0 + alpha1) / 2), also root / cos delta
  [[nodiscard]] CGAL_BOUNDING_ARCS_INLINE double sin_mean() const { return g * (base - 1.5 * q); }
  [[nodiscard]] CGAL_BOUNDING_ARCS_INLINE double cos_delta() const { return 1 - 0.5 * q; }
};

[[nodiscard]] CGAL_BOUNDING_ARCS_INLINE Narrow_angles narrow_angles(double f, double g) {
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
