// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
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

#ifndef CGAL_BOUNDING_ARCS_2_SPIRAL_RATIONAL_FIGURES_H
#define CGAL_BOUNDING_ARCS_2_SPIRAL_RATIONAL_FIGURES_H

#include <CGAL/Bounding_arcs_2/number/Ranged_magnitude.h>
#include <CGAL/Bounding_arcs_2/number/always_inline.h>
#include <CGAL/Bounding_arcs_2/spiral/Local_figures.h>

namespace CGAL::Bounding_arcs {

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
