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
// Rational curves have the same figures of other M, Y and Z: Rational_figures.h.

#ifndef CGAL_BOUNDING_ARCS_2_SPIRAL_LOCAL_FIGURES_H
#define CGAL_BOUNDING_ARCS_2_SPIRAL_LOCAL_FIGURES_H

#include <CGAL/Bounding_arcs_2/number/always_inline.h>
#include <CGAL/Bounding_arcs_2/spiral/Local_curve.h>

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

}  // namespace CGAL::Bounding_arcs

#endif
