// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// What a curve encloses, by integrals along it (Green), exactly:  area of x dy - y dx over 2, first moments of
// x^2 dy / 2 and -y^2 dx / 2.

#ifndef BOUNDING_ARCS_LIBRARY_CURVE_GREEN_H
#define BOUNDING_ARCS_LIBRARY_CURVE_GREEN_H

#include <CGAL/Bounding_arcs_2/curve/Bezier_curve_2.h>
#include "../polynomial/Integer_polynomial.h"

#include <cstddef>
#include <vector>

namespace CGAL::Bounding_arcs {

/// What a curve encloses: the area, and the first moments in x and y.
template <class NT> struct Enclosed_moments {
  NT area{0}, x{0}, y{0};

  Enclosed_moments& operator+=(const Enclosed_moments& m) {
    area += m.area;
    x += m.x;
    y += m.y;
    return *this;
  }
};
using Exact_moments = Enclosed_moments<Exact_rational>;

/// Over [0, 1]: the mean of the coefficients.
[[nodiscard]] inline Exact_rational integral(const Exact_polynomial& p) {
  const auto& c = p.scaled_coefficients();
  const auto factors = internal::binomials<Exact_rational>(p.degree());
  Exact_rational sum(0);
  for (std::size_t i = 0; i < c.size(); ++i) sum += Exact_rational(c[i] / factors[i]);
  return Exact_rational(sum / Exact_rational(p.degree() + 1));
}

/// Along a polynomial curve seen from an origin.
/// \param with_moments else these stay 0, which takes a tenth of the time
[[nodiscard]] inline Exact_moments moments_along(const Bezier_curve_2<Exact_rational>& curve,
                                                 const Xy<Exact_rational>& origin, bool with_moments) {
  Exact_polynomial::Coefficients xs, ys;
  for (const auto& p : curve.control_points()) {
    xs.push_back(Exact_rational(p.x - origin.x));
    ys.push_back(Exact_rational(p.y - origin.y));
  }
  const Exact_polynomial x(xs), y(ys), dx = x.derivative(), dy = y.derivative();
  Exact_moments m;
  m.area = Exact_rational(integral(x * dy - y * dx) / 2);
  if (!with_moments) return m;
  m.x = Exact_rational(integral(x * x * dy) / 2);
  m.y = Exact_rational(-integral(y * y * dx) / 2);
  return m;
}

/// Along a segment.
[[nodiscard]] inline Exact_moments moments_along(const Xy<Exact_rational>& from, const Xy<Exact_rational>& to,
                                                 const Xy<Exact_rational>& origin) {
  const Xy<Exact_rational> a = from - origin, b = to - origin, d = to - from;
  return {Exact_rational(cross(a, b) / 2), Exact_rational(d.y * (a.x * a.x + a.x * b.x + b.x * b.x) / 6),
          Exact_rational(-d.x * (a.y * a.y + a.y * b.y + b.y * b.y) / 6)};
}

}  // namespace CGAL::Bounding_arcs

#endif
