// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The chord shapes of a local curve's pieces from few operations and without branches, for any number type.
//
// Figures of a piece.  Symbols are those of doc/numerics.md: c the chord, alpha0 and alpha1 the angles between it and
// the end tangents, delta half their difference, m half their sum, K_i = kappa_i c / 2; doc/symbols.md lists all. About
// the middle tau of a piece of half length s, where C = sum c_k sigma^k:
//   M = sum_{k odd} c_k s^(k-1)              the chord D is 2 s M
//   Z = sum_{k odd > 1} (k-1) c_k s^(k-3)    (T0 + T1) / 2 = M + s^2 Z
//   Y = sum_{k even} k c_k s^(k-2)           (T1 - T0) / 2 = s Y
// With a = M x Y, d = Z x M, r = Y.M, p = M.M + s^2 Z.M, up to powers of 2 s:
//   T0 x D = s (a + s d),  D x T1 = s (a - s d),  T0.D = p - s r,  T1.D = p + s r,
//   (T0 x D)(T1.D) - (D x T1)(T0.D) = 2 s^2 N,  N = a r + d p.
// So sin 2 delta = 2 s^2 N / (l0 l1) with l_i = |T_i| |M|: the thickness of every method is N times a factor, and in N
// no leading terms cancel.
// Rational curves have the same figures of other M, Y and Z.

#ifndef BOUNDING_ARCS_LIBRARY_SPIRAL_LOCAL_FIGURES_H
#define BOUNDING_ARCS_LIBRARY_SPIRAL_LOCAL_FIGURES_H

#include <CGAL/Bounding_arcs_2/number/strict_math.h>
#include "../number/Pair.h"
#include "Local_curve.h"

#include <cstddef>

namespace CGAL::Bounding_arcs {

/// The figures of a piece; names as above.
template <class NT> struct Local_piece {
  NT half;          ///< s
  NT square;        ///< s^2
  NT mx, my;        ///< M
  NT chord_square;  ///< M.M
  NT p, r, a, d;
  NT yx, yy, zx, zy;  ///< Y, Z
  NT zm;              ///< Z.M
};

/// What the two ends of a piece add for constructions that use their curvatures. With n_i = |T_i|, c = |M|:
///   K_i = s turn_rate_i c / n_i^3,
///   K0 - sin alpha0 = s^2 kneser0 / (n0^3 c),  sin alpha1 - K1 = s^2 kneser1 / (n1^3 c).
template <class NT> struct Local_ends {
  NT square0, square1;        ///< |T0|^2, |T1|^2
  NT turn_rate0, turn_rate1;  ///< T x T' there
  NT kneser0, kneser1;
};

/// One coordinate of a polynomial about the middle of a piece of half length s: sums of its coefficients c_k there.
template <class NT> struct Coordinate_parts {
  NT even;  ///< sum_{k even} c_k s^k
  NT odd;   ///< sum_{k odd} c_k s^(k-1), of M
  NT y, z;  ///< of Y and Z
  NT u;     ///< sum_{k even > 2} k (k-2) c_k s^(k-4)
  NT v;  ///< sum_{k odd > 3} (k-1) (k-3) c_k s^(k-5); the second derivative at the ends is y -+ 3 s z + s^2 (u -+ s v)
};

/// Taylor coefficients FIRST .. DEGREE moved by tau: Horner's scheme, once a coefficient.
template <int DEGREE, int FIRST, class NT, std::size_t SIZE>
CGAL_BOUNDING_ARCS_INLINE void move_expansion(NT (&c)[SIZE], const NT& tau) {
  static_assert(SIZE == DEGREE + 1);
#pragma GCC unroll 16
  for (int i = 0; i < DEGREE; ++i)
#pragma GCC unroll 16
    for (int k = DEGREE - 1; k >= (i > FIRST ? i : FIRST); --k) c[k] = c[k] + tau * c[k + 1];
}

/// \tparam FIRST 0, or 1 where c_0, and `even`, are not wanted
template <int DEGREE, int FIRST, class NT, std::size_t SIZE>
[[nodiscard]] CGAL_BOUNDING_ARCS_INLINE Coordinate_parts<NT> coordinate_parts(const NT (&coefficients)[SIZE],
                                                                              const NT& tau, const NT& square) {
  constexpr int ODD = DEGREE % 2 == 1 ? DEGREE : DEGREE - 1, EVEN = DEGREE % 2 == 0 ? DEGREE : DEGREE - 1;
  constexpr std::size_t COUNT = DEGREE + 1;
  NT c[COUNT];
#pragma GCC unroll 16
  for (int k = FIRST; k <= DEGREE; ++k) c[k] = coefficients[k];
  move_expansion<DEGREE, FIRST>(c, tau);
  // sum of weight(k) c_k s^(k - last) for k = first, first - 2, ..., last
  const auto sum = [&](int first, int last, auto weight) {
    if (first < last) return NT(0);
    NT r = weight(first) * c[first];
#pragma GCC unroll 16
    for (int k = first - 2; k >= last; k -= 2) r = weight(k) * c[k] + square * r;
    return r;
  };
  Coordinate_parts<NT> p{};
  p.odd = c[ODD];
#pragma GCC unroll 16
  for (int k = ODD - 2; k >= 1; k -= 2) p.odd = c[k] + square * p.odd;
  if constexpr (FIRST == 0) {
    p.even = c[EVEN];
#pragma GCC unroll 16
    for (int k = EVEN - 2; k >= 0; k -= 2) p.even = c[k] + square * p.even;
  }
  p.y = sum(EVEN, 2, [](int k) { return NT(k); });
  p.z = sum(ODD, 3, [](int k) { return NT(k - 1); });
  p.u = sum(EVEN, 4, [](int k) { return NT(k * (k - 2)); });
  p.v = sum(ODD, 5, [](int k) { return NT((k - 1) * (k - 3)); });
  return p;
}

/// What follows from M, Y and Z, given M.M, a and d.
template <class NT>
[[nodiscard]] CGAL_BOUNDING_ARCS_INLINE Local_piece<NT> piece_of(const NT& s, const NT& mx, const NT& my, const NT& yx,
                                                                 const NT& yy, const NT& zx, const NT& zy, const NT& a,
                                                                 const NT& d) {
  const NT square = s * s, mm = mx * mx + my * my, zm = zx * mx + zy * my;
  return {s, square, mx, my, mm, mm + square * zm, yx * mx + yy * my, a, d, yx, yy, zx, zy, zm};
}

/// The piece of half length s about the parameter middle + tau of a polynomial curve.
template <int DEGREE, class NT, int MOST>
[[nodiscard]] CGAL_BOUNDING_ARCS_INLINE Local_piece<NT> polynomial_piece(const Local_coefficients<NT, MOST>& curve,
                                                                         const NT& tau, const NT& s) {
  const NT square = s * s;
  if constexpr (DEGREE == 3) {
    const NT slope_x = NT(3) * curve.x[3], slope_y = NT(3) * curve.y[3];
    const NT gx = tau * slope_x, gy = tau * slope_y, twice_x = curve.x[2] + curve.x[2],
             twice_y = curve.y[2] + curve.y[2];
    const NT yx = twice_x + (gx + gx), yy = twice_y + (gy + gy);
    const NT mx = (curve.x[1] + tau * (twice_x + gx)) + curve.x[3] * square;
    const NT my = (curve.y[1] + tau * (twice_y + gy)) + curve.y[3] * square;
    const NT zx = curve.x[3] + curve.x[3], zy = curve.y[3] + curve.y[3];
    return piece_of<NT>(s, mx, my, yx, yy, zx, zy,
                        curve.across[0] + tau * (curve.across[1] + tau * curve.across[2]) + square * curve.across[3],
                        curve.change[0] + curve.change[1] * tau);
  } else {
    const Coordinate_parts<NT> x = coordinate_parts<DEGREE, 1>(curve.x, tau, square),
                               y = coordinate_parts<DEGREE, 1>(curve.y, tau, square);
    return piece_of<NT>(s, x.odd, y.odd, x.y, y.y, x.z, y.z, x.odd * y.y - y.odd * x.y, x.z * y.odd - y.z * x.odd);
  }
}

/// |T_i|^2 and what they are made of, see polynomial_ends.
template <class NT> struct End_squares {
  NT v, w;
  NT square0, square1;
};
template <class NT> [[nodiscard]] CGAL_BOUNDING_ARCS_INLINE End_squares<NT> end_squares(const Local_piece<NT>& g) {
  const NT yz = g.yx * g.zx + g.yy * g.zy;
  const NT v = (g.zm + g.zm) + (g.yx * g.yx + g.yy * g.yy) + g.square * (g.zx * g.zx + g.zy * g.zy);
  const NT w = NT(2) * (g.r + g.square * yz), mean = g.chord_square + g.square * v, step = g.half * w;
  return {v, w, mean - step, mean + step};
}

/// With V = 2 Z.M + Y.Y + s^2 Z.Z, W = 2 (r + s^2 Y.Z), upper signs at the start, and F_i = u -+ s v of both axes
/// (Coordinate_parts), which is 0 for cubics:
///   |T_i|^2     = M.M + s^2 V -+ s W
///   turn_rate_i = T_i x T_i' = a +- 3 s d + 2 s^2 Y x Z + s^2 T_i x F_i
///   kneser_i    = turn_rate_i (W -+ s V) + 2 |T_i|^2 (d +- s Y x Z +- s T_i x F_i / 2)
///   K_i = s turn_rate_i |M| / |T_i|^3
///   K0 - sin alpha0 = s^2 kneser_0 / (|T_0|^3 |M|),   sin alpha1 - K1 = s^2 kneser_1 / (|T_1|^3 |M|).
/// They follow from T_i = M + s^2 Z -+ s Y and T_i' = Y -+ 3 s Z + s^2 F_i by expanding the products; kneser_i is that
/// of a single piece's frame up to s^2.
template <int DEGREE, class NT, int MOST>
[[nodiscard]] CGAL_BOUNDING_ARCS_INLINE Local_ends<NT> polynomial_ends(const Local_coefficients<NT, MOST>& curve,
                                                                       const NT& tau, const Local_piece<NT>& g) {
  const End_squares<NT> q = end_squares(g);
  const NT sv = g.half * q.v;
  const NT yz_cross = DEGREE == 3 ? NT(NT(0) - curve.change[1]) : NT(g.yx * g.zy - g.yy * g.zx);
  const NT mean_rate = g.a + (g.square + g.square) * yz_cross, sd = g.half * (NT(3) * g.d), third = g.half * yz_cross;
  Local_ends<NT> e{q.square0, q.square1, mean_rate + sd, mean_rate - sd, NT(0), NT(0)};
  NT third0 = g.d + third, third1 = g.d - third;
  if constexpr (DEGREE > 3) {
    const Coordinate_parts<NT> x = coordinate_parts<DEGREE, 1>(curve.x, tau, g.square),
                               y = coordinate_parts<DEGREE, 1>(curve.y, tau, g.square);
    const NT tx = g.mx + g.square * g.zx, ty = g.my + g.square * g.zy, ux = g.half * g.yx, uy = g.half * g.yy;
    const NT fx = g.half * x.v, fy = g.half * y.v;  // 0 for degree 4
    const NT cross0 = NT(0.5) * g.half * ((tx - ux) * (y.u - fy) - (ty - uy) * (x.u - fx));
    const NT cross1 = NT(0.5) * g.half * ((tx + ux) * (y.u + fy) - (ty + uy) * (x.u + fx));
    third0 = third0 + cross0;
    third1 = third1 - cross1;
    e.turn_rate0 = e.turn_rate0 + (g.half + g.half) * cross0;
    e.turn_rate1 = e.turn_rate1 + (g.half + g.half) * cross1;
  }
  e.kneser0 = e.turn_rate0 * (q.w - sv) + (e.square0 + e.square0) * third0;
  e.kneser1 = e.turn_rate1 * (q.w + sv) + (e.square1 + e.square1) * third1;
  return e;
}

// The chord shapes of a rational local curve's pieces, see Local_figures.h.
//
// Let P = (x, y, w) be the curve in homogeneous coordinates, and, about the middle of a piece of half length s, E, O,
// Y, Z, U, V the vectors of its Coordinate_parts.  At the ends P is E -+ s O and P' is O + s^2 Z -+ s Y, and E is on
// the chord. Seen from there, with e = E_w and q = e^2 - s^2 O_w^2, the product of the weights at the ends, a vector X
// becomes
//   X' = (e (X_x, X_y) - X_w (E_x, E_y)) / q,
// in which no leading terms cancel.  With g = e - s^2 Y_w the chord is D = 2 s M and directions at the ends are
//   T_i = M + s^2 z -+ s y,
//   M = O',  y = Y' - (g O_w + s^2 e Z_w) / q M,  z = Z' + (O_w^2 - e Y_w + s^2 O_w Z_w) / q M,
// as is seen by inserting into T_0 = e / q (P_xy' - P_xy P_w' / P_w).  So all figures follow from M, y and z as for
// polynomials, of tangent vectors that are by e over the other end's weight longer than C'.  Crosses with M do not see
// what is added, so a = M x Y', d = Z' x M.
//
// Curvature is det(P, P', P'') P_w^3 / |P_xy' P_w - P_xy P_w'|^3, hence
//   turn_rate_i = kappa_i |T_i|^3 = (e / q)^3 det(P, P', P'')_i,
// where P'' is Y -+ 3 s Z + s^2 F_i, F_i = U -+ s V.  Expanding the determinant, with X' x Y' for two vectors,
//   turn_rate_i = b_i + s^2 (O_w^2 / q b_i + e / q f_i) -+ 2 s^3 e / q (O_w Y' x Z' + Y_w d + Z_w a),
//   b_i = a +- 3 s d + 2 s^2 Y' x Z',
//   f_i = P_w P' x F_i' +- s (P_w' M x F_i' - F_w M x P'), which is 0 for cubics,
// as e^2 / q = 1 + s^2 O_w^2 / q.  From kneser_0 = (turn_rate_0 M.M - (a + s d) |T_0|^2) / s and the same at the other
// end, with V and W of end_squares,
//   kneser_i = turn_rate_i (W -+ s V) + |T_i|^2 (+-(turn_rate_i - (a +- s d)) / s).

/// Names as above; primed vectors.
template <class NT> struct Rational_parts {
  Coordinate_parts<NT> x, y;  ///< of primed vectors, but for `even`
  Coordinate_parts<NT> w;
  NT inverse;  ///< 1 / q
};

/// One over a product of weights of a piece's ends.
template <class Real> [[nodiscard]] CGAL_BOUNDING_ARCS_INLINE Real inverse_of(const Real& q) { return 1 / q; }
[[nodiscard]] CGAL_BOUNDING_ARCS_INLINE Ranged_magnitude inverse_of(const Ranged_magnitude& q) { return inverse(q); }

template <int DEGREE, class NT, int MOST>
[[nodiscard]] CGAL_BOUNDING_ARCS_INLINE Rational_parts<NT> rational_parts(const Local_coefficients<NT, MOST>& curve,
                                                                          const NT& tau, const NT& square) {
  Rational_parts<NT> p{coordinate_parts<DEGREE, 0>(curve.x, tau, square),
                       coordinate_parts<DEGREE, 0>(curve.y, tau, square),
                       coordinate_parts<DEGREE, 0>(curve.w, tau, square), NT(0)};
  const Coordinate_parts<NT>& w = p.w;
  p.inverse = inverse_of(w.even * w.even - square * (w.odd * w.odd));
  const NT e = w.even * p.inverse;
  const auto seen = [&](Coordinate_parts<NT>& axis) {
    const NT from = axis.even * p.inverse;
    axis.odd = e * axis.odd - w.odd * from;
    axis.y = e * axis.y - w.y * from;
    if constexpr (DEGREE >= 3) axis.z = e * axis.z - w.z * from;
    if constexpr (DEGREE >= 4) axis.u = e * axis.u - w.u * from;
    if constexpr (DEGREE >= 5) axis.v = e * axis.v - w.v * from;
  };
  seen(p.x);
  seen(p.y);
  return p;
}

/// The piece of half length s about the parameter middle + tau.
template <int DEGREE, class NT, int MOST>
[[nodiscard]] CGAL_BOUNDING_ARCS_INLINE Local_piece<NT> rational_piece(const Local_coefficients<NT, MOST>& curve,
                                                                       const NT& tau, const NT& s) {
  const NT square = s * s;
  const Rational_parts<NT> p = rational_parts<DEGREE>(curve, tau, square);
  const Coordinate_parts<NT>&x = p.x, &y = p.y, &w = p.w;
  NT back = (w.even - square * w.y) * w.odd, forth = w.odd * w.odd - w.even * w.y;
  if constexpr (DEGREE >= 3) {
    back = back + square * (w.even * w.z);
    forth = forth + square * (w.odd * w.z);
  }
  back = back * p.inverse;
  forth = forth * p.inverse;
  NT zx = forth * x.odd, zy = forth * y.odd, d = NT(0);
  if constexpr (DEGREE >= 3) {
    zx = x.z + zx;
    zy = y.z + zy;
    d = x.z * y.odd - y.z * x.odd;
  }
  return piece_of<NT>(s, x.odd, y.odd, x.y - back * x.odd, y.y - back * y.odd, zx, zy, x.odd * y.y - y.odd * x.y, d);
}

template <int DEGREE, class NT, int MOST>
[[nodiscard]] CGAL_BOUNDING_ARCS_INLINE Local_ends<NT> rational_ends(const Local_coefficients<NT, MOST>& curve,
                                                                     const NT& tau, const Local_piece<NT>& g) {
  const NT s = g.half, square = g.square, d = g.d;
  const Rational_parts<NT> p = rational_parts<DEGREE>(curve, tau, square);
  const Coordinate_parts<NT>&x = p.x, &y = p.y, &w = p.w;
  const NT e = w.even * p.inverse, of_weights = w.odd * w.odd * p.inverse;
  NT yz = NT(0), third = NT(0), mean = g.a, slope = NT(0);  // b_i = mean +- slope
  if constexpr (DEGREE >= 3) {
    yz = x.y * y.z - y.y * x.z;
    third = w.odd * yz + w.y * d + w.z * g.a;
    mean = mean + (square + square) * yz;
    slope = s * (NT(3) * d);
  }
  third = e * third;
  const NT b0 = mean + slope, b1 = mean - slope;
  NT more0 = of_weights * b0, more1 = of_weights * b1;
  if constexpr (DEGREE >= 4) {
    const auto cross_at_end = [&](const NT& t) {  // f_i, t = -+ s
      const NT px = g.mx + square * x.z + t * x.y, py = g.my + square * y.z + t * y.y,
               pw = w.odd + square * w.z + t * w.y;
      const NT fx = x.u + t * x.v, fy = y.u + t * y.v, fw = w.u + t * w.v;
      return (w.even + t * w.odd) * (px * fy - py * fx) -
             t * (pw * (g.mx * fy - g.my * fx) - fw * (g.mx * py - g.my * px));
    };
    more0 = more0 + e * cross_at_end(NT(0) - s);
    more1 = more1 + e * cross_at_end(s);
  }
  const NT twice = square * (third + third), both = (d + d) - twice, twists = yz + yz;
  const NT rate0 = b0 + (square * more0 - s * twice), rate1 = b1 + (square * more1 + s * twice);
  const End_squares<NT> q = end_squares(g);
  const NT sv = s * q.v;
  return {q.square0,
          q.square1,
          rate0,
          rate1,
          rate0 * (q.w - sv) + q.square0 * (both + s * (twists + more0)),
          rate1 * (q.w + sv) + q.square1 * (both - s * (twists + more1))};
}

/// The piece of half length s about the parameter middle + tau of a curve of any kind.
template <int KIND, class NT, int MOST>
[[nodiscard]] CGAL_BOUNDING_ARCS_INLINE Local_piece<NT> local_piece(const Local_coefficients<NT, MOST>& curve,
                                                                    const NT& tau, const NT& s) {
  if constexpr (is_rational_kind(KIND)) return rational_piece<degree_of_kind(KIND)>(curve, tau, s);
  else return polynomial_piece<KIND>(curve, tau, s);
}
/// The ends of a piece.
template <int KIND, class NT, int MOST>
[[nodiscard]] CGAL_BOUNDING_ARCS_INLINE Local_ends<NT> local_ends(const Local_coefficients<NT, MOST>& curve,
                                                                  const NT& tau, const Local_piece<NT>& g) {
  if constexpr (is_rational_kind(KIND)) return rational_ends<degree_of_kind(KIND)>(curve, tau, g);
  else return polynomial_ends<KIND>(curve, tau, g);
}

}  // namespace CGAL::Bounding_arcs

#endif
