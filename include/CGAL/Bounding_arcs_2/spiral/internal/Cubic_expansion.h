// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The numbers of Local_coefficients for all segments of a polynomial cubic: with differences d_i of control points,
//   C' = a + 2 b t + 3 c t^2,  a = 3 d0,  b = 3 (d1 - d0),  c = d2 - 2 d1 + d0,
// the Taylor vectors about t are c1 = C', c2 = b + 3 c t and c3 = c, and their crosses, with g0 = 2 a x b,
// g1 = 2 a x c and g2 = 2 b x c,
//   2 c1 x c2 = g0 + 3 g1 t + 3 g2 t^2,  2 c1 x c3 = g1 + 2 g2 t,  2 c2 x c3 = g2.

#ifndef CGAL_BOUNDING_ARCS_2_SPIRAL_INTERNAL_CUBIC_EXPANSION_H
#define CGAL_BOUNDING_ARCS_2_SPIRAL_INTERNAL_CUBIC_EXPANSION_H

#include <CGAL/Bounding_arcs_2/curve/Bezier_curve_2.h>
#include <CGAL/Bounding_arcs_2/number/Magnitude.h>
#include <CGAL/Bounding_arcs_2/number/Pair.h>
#include <CGAL/Bounding_arcs_2/spiral/Local_curve.h>

namespace CGAL::Bounding_arcs::internal {

// Over Pair, or Pair_magnitude with parameter 1.
template <class T> struct Cubic_terms {
  struct Axis {
    T a, b, c, c3;
  };
  Axis x, y;
  T g0, g1, g2;

  static constexpr T thrice(const T& z) { return twice(z) + z; }
  static constexpr Axis axis(const T& d0, const T& d1, const T& d2) {
    const T bend = d1 - d0, c = (d2 - d1) - bend;
    return {thrice(d0), thrice(bend), c, thrice(c)};
  }
  static constexpr T twice_cross(const T& px, const T& py, const T& qx, const T& qy) {
    return twice(px * qy - py * qx);
  }
  constexpr Cubic_terms(const Axis& u, const Axis& v)
      : x(u), y(v), g0(twice_cross(u.a, v.a, u.b, v.b)), g1(twice_cross(u.a, v.a, u.c, v.c)),
        g2(twice_cross(u.b, v.b, u.c, v.c)) {}

  constexpr Local_coefficients<T, 3> expand(double t) const {
    Local_coefficients<T, 3> r;
    const T h = t * g2, k = g1 + h, slope = k + h, g6 = thrice(g2);
    r.x[2] = x.b + t * x.c3;
    r.y[2] = y.b + t * y.c3;
    r.x[1] = x.a + t * (x.b + r.x[2]);
    r.y[1] = y.a + t * (y.b + r.y[2]);
    r.x[3] = x.c;
    r.y[3] = y.c;
    r.across[0] = g0 + t * thrice(k);
    r.across[1] = thrice(slope);
    r.across[2] = g6;
    r.across[3] = -g2;
    r.change[0] = -slope;
    r.change[1] = -twice(g2);
    return r;
  }
};

// The errors of the numbers of x or y, and of products, for differences up to 1.
struct Cubic_expansion_errors {
  double coordinate = 0, product = 0;

  constexpr Cubic_expansion_errors() {
    using Terms = Cubic_terms<Pair_magnitude>;
    const Pair_magnitude d{1, HALF_ULP, 0};
    const Terms::Axis axis = Terms::axis(d, d, d);
    const Local_coefficients<Pair_magnitude, 3> c = Terms(axis, axis).expand(1);
    for (const Pair_magnitude& x : c.x) coordinate = x.error > coordinate ? x.error : coordinate;
    for (const Pair_magnitude& x : c.across) product = x.error > product ? x.error : product;
    for (const Pair_magnitude& x : c.change) product = x.error > product ? x.error : product;
  }
};

}  // namespace CGAL::Bounding_arcs::internal

#endif
