// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// A spiral segment of a polynomial curve about its middle parameter, and the chord shapes of its pieces from few
// operations and without branches, so that loops over many pieces run in SIMD registers.
//
// About the middle tau of a piece of half length s, where C = sum c_k s^k:
//   chord / 2s        M = sum_{k odd} c_k s^(k-1)
//   (T0 + T1) / 2       = M + s^2 Z,  Z = sum_{k odd > 1} (k-1) c_k s^(k-3)
//   (T1 - T0) / 2       = s Y,        Y = sum_{k even} k c_k s^(k-2)
// and with a = M x Y, d = Z x M, r = Y.M, p = M.M + s^2 Z.M, in which no leading terms cancel:
//   T0 x chord ~ s a + s^2 d,  chord x T1 ~ s a - s^2 d,  T0.chord ~ p - s r,  T1.chord ~ p + s r.

#ifndef CGAL_BOUNDING_ARCS_2_SPIRAL_BATCH_CURVE_H
#define CGAL_BOUNDING_ARCS_2_SPIRAL_BATCH_CURVE_H

namespace CGAL::Bounding_arcs::internal {

/// Largest degree that batches are compiled for; pieces of other curves are bounded one by one.
inline constexpr int MAX_BATCH_DEGREE = 5;

/// Taylor coefficients about the middle of a spiral segment. Of a cubic also those of a and d as polynomials in tau and
/// s^2, formed more accurately than in double.
template <class NT>
struct Batch_coefficients {
  NT x[MAX_BATCH_DEGREE + 1], y[MAX_BATCH_DEGREE + 1];
  NT bend[4];    ///< a = bend0 + bend1 tau + bend2 tau^2 + bend3 s^2
  NT change[2];  ///< d = change0 + change1 tau
};

/// A spiral segment as batches see it: coefficients and bounds that hold for all its pieces.
struct Batch_curve {
  int degree = 0;     ///< 3 for all degrees up to 3; 0: not for batches
  double middle = 0;  ///< the parameter expanded about
  double unit = 1;    ///< one unit of the coefficients, as a length of the plane
  Batch_coefficients<double> coefficients{};
  double numerator_error = 0;  ///< bound on the rounding error of a r + d p
  double least_dot = 0;        ///< where p, M.M and p^2 - s^2 r^2 are at least these, they have relative errors below
  double least_square = 0;     ///< 2^-33, and a s, d s^2 errors below 2^-33 p
  double least_product = 0;
  double kneser_error = 0;     ///< bounds on the rounding errors of kneser0, kneser1 and bend0, bend1
  double bend_error = 0;
  double least_tangent = 0;    ///< |T|^2 above this has a relative error below 2^-33
};

/// What a batch reads of a piece; names as above.
template <class NT>
struct Batch_piece {
  NT half;          ///< s
  NT square;        ///< s^2
  NT mx, my;        ///< M
  NT chord_square;  ///< M.M
  NT p, r, a, d;
};

/// What the two ends of a piece add for constructions that use their curvatures. With n_i = |T_i|, c = |M|:
///   K_i = s bend_i c / n_i^3,  K0 - sin alpha0 = s^2 kneser0 / (n0^3 c),  sin alpha1 - K1 = s^2 kneser1 / (n1^3 c).
template <class NT>
struct Batch_ends {
  NT square0, square1;  ///< |T0|^2, |T1|^2
  NT bend0, bend1;      ///< T x T' there
  NT kneser0, kneser1;
};

/// Taylor coefficients 1 .. DEGREE moved by tau: Horner's scheme, once a coefficient.
template <int DEGREE, class NT>
[[gnu::always_inline]] inline void move_expansion(NT (&c)[DEGREE + 1], const NT& tau) {
#pragma GCC unroll 8
  for (int i = 0; i < DEGREE; ++i)
#pragma GCC unroll 8
    for (int k = DEGREE - 1; k >= (i > 1 ? i : 1); --k) c[k] = c[k] + tau * c[k + 1];
}

/// The piece of half length s about the parameter middle + tau.
template <int DEGREE, class NT>
[[nodiscard, gnu::always_inline]] inline Batch_piece<NT> batch_piece(const Batch_coefficients<NT>& curve, const NT& tau, const NT& s) {
  const NT square = s * s;
  if constexpr (DEGREE == 3) {
    const NT slope_x = NT(3) * curve.x[3], slope_y = NT(3) * curve.y[3];
    const NT gx = tau * slope_x, gy = tau * slope_y, twice_x = curve.x[2] + curve.x[2], twice_y = curve.y[2] + curve.y[2];
    const NT yx = twice_x + (gx + gx), yy = twice_y + (gy + gy);
    const NT mx = (curve.x[1] + tau * (twice_x + gx)) + curve.x[3] * square;
    const NT my = (curve.y[1] + tau * (twice_y + gy)) + curve.y[3] * square;
    const NT mm = mx * mx + my * my;
    const NT rise_x = curve.x[3] + curve.x[3], rise_y = curve.y[3] + curve.y[3];
    return {s, square, mx, my, mm, mm + square * (rise_x * mx + rise_y * my), yx * mx + yy * my,
            curve.bend[0] + tau * (curve.bend[1] + tau * curve.bend[2]) + square * curve.bend[3],
            curve.change[0] + curve.change[1] * tau};
  } else {
    NT cx[DEGREE + 1], cy[DEGREE + 1];
#pragma GCC unroll 8
    for (int k = 1; k <= DEGREE; ++k) {
      cx[k] = curve.x[k];
      cy[k] = curve.y[k];
    }
    move_expansion<DEGREE>(cx, tau);
    move_expansion<DEGREE>(cy, tau);
    constexpr int ODD = DEGREE % 2 == 1 ? DEGREE : DEGREE - 1, EVEN = DEGREE % 2 == 0 ? DEGREE : DEGREE - 1;
    NT mx = cx[ODD], my = cy[ODD], zx = NT(ODD - 1) * cx[ODD], zy = NT(ODD - 1) * cy[ODD];
#pragma GCC unroll 8
    for (int k = ODD - 2; k >= 1; k -= 2) {
      mx = cx[k] + square * mx;
      my = cy[k] + square * my;
    }
#pragma GCC unroll 8
    for (int k = ODD - 2; k >= 3; k -= 2) {
      zx = NT(k - 1) * cx[k] + square * zx;
      zy = NT(k - 1) * cy[k] + square * zy;
    }
    NT yx = NT(EVEN) * cx[EVEN], yy = NT(EVEN) * cy[EVEN];
#pragma GCC unroll 8
    for (int k = EVEN - 2; k >= 2; k -= 2) {
      yx = NT(k) * cx[k] + square * yx;
      yy = NT(k) * cy[k] + square * yy;
    }
    const NT mm = mx * mx + my * my;
    return {s, square, mx, my, mm, mm + square * (zx * mx + zy * my), yx * mx + yy * my, mx * yy - my * yx, zx * my - zy * mx};
  }
}

/// One end of a piece, h = 2s from the start and -2s from the end, seen from there as C = sum c_k h^k:
///   |T|^2,  T x C'',  (T x C'') ((D - T) / |s|).(D + T) - 4 |T|^2 sum_{k >= 3} h^(k-3) T x c_k.
template <int DEGREE, class NT>
[[gnu::always_inline]] inline void batch_end(const Batch_coefficients<NT>& curve, const NT& tau, const NT& h, const NT& mx,
                                             const NT& my, NT& square, NT& bend, NT& kneser) {
  NT cx[DEGREE + 1], cy[DEGREE + 1];
#pragma GCC unroll 8
  for (int k = 1; k <= DEGREE; ++k) {
    cx[k] = curve.x[k];
    cy[k] = curve.y[k];
  }
  move_expansion<DEGREE>(cx, tau);
  move_expansion<DEGREE>(cy, tau);
  NT third;  // of the sum, -2 times
  if constexpr (DEGREE == 3) {
    bend = curve.bend[0] + tau * (curve.bend[1] + tau * curve.bend[2]);
    third = curve.change[0] + curve.change[1] * tau;
  } else {
    bend = NT(2) * (cx[1] * cy[2] - cy[1] * cx[2]);
    NT tail = cx[1] * cy[DEGREE] - cy[1] * cx[DEGREE];
#pragma GCC unroll 8
    for (int k = DEGREE - 1; k >= 3; --k) tail = (cx[1] * cy[k] - cy[1] * cx[k]) + h * tail;
    third = NT(-2) * tail;
  }
  NT dx = cx[DEGREE], dy = cy[DEGREE];  // (D - T) / h
#pragma GCC unroll 8
  for (int k = DEGREE - 1; k >= 2; --k) {
    dx = cx[k] + h * dx;
    dy = cy[k] + h * dy;
  }
  square = cx[1] * cx[1] + cy[1] * cy[1];
  kneser = NT(2) * (bend * (dx * (mx + cx[1]) + dy * (my + cy[1])) + square * third);
}

template <int DEGREE, class NT>
[[nodiscard, gnu::always_inline]] inline Batch_ends<NT> batch_ends(const Batch_coefficients<NT>& curve, const NT& tau,
                                                                   const Batch_piece<NT>& piece) {
  Batch_ends<NT> e;
  const NT h = piece.half + piece.half;
  batch_end<DEGREE>(curve, NT(tau - piece.half), h, piece.mx, piece.my, e.square0, e.bend0, e.kneser0);
  batch_end<DEGREE>(curve, NT(tau + piece.half), NT(NT(0) - h), piece.mx, piece.my, e.square1, e.bend1, e.kneser1);
  return e;
}

}  // namespace CGAL::Bounding_arcs::internal

#endif
