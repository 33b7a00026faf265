// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Points of curves rounded from twice the digits: of polynomial ones sum binomial(n, k) t^k (k-th difference of the
// first control points), by Horner's scheme.

#ifndef BOUNDING_ARCS_LIBRARY_SPIRAL_ACCURATE_POINT_H
#define BOUNDING_ARCS_LIBRARY_SPIRAL_ACCURATE_POINT_H

#include <CGAL/Bounding_arcs_2/curve/Bezier_curve_2.h>
#include <CGAL/Bounding_arcs_2/number/Double_double.h>
#include <CGAL/assertions.h>
#include "../number/Pair.h"
#include "Local_curve.h"

#include <cstddef>

namespace CGAL::Bounding_arcs {

/// A coordinate at t from those of the control points, see accurate_point.
template <std::size_t N>
[[nodiscard]] CGAL_BOUNDING_ARCS_INLINE double accurate_coordinate(const double (&points)[N + 1], double t) {
  Pair d[N + 1] = {{points[0], 0}};
#pragma GCC unroll 16
  for (std::size_t i = 1; i <= N; ++i) d[i] = Pair::difference(points[i], points[i - 1]);
#pragma GCC unroll 16
  for (std::size_t k = 2; k <= N; ++k)  // d[k] becomes the k-th difference, and below it is done
#pragma GCC unroll 16
    for (std::size_t i = N; i >= k; --i) d[i] = d[i] - d[i - 1];
  Pair sum = d[N];
  double binomial = 1;
  for (std::size_t k = N; k-- > 1;) {
    binomial = binomial * static_cast<double>(k + 1) / static_cast<double>(N - k);
    const Pair term =
        binomial == 3 ? d[k] + twice(d[k]) : binomial * d[k];  // of cubics; the same bits in half the time
    sum = term + t * sum;
  }
  sum = d[0] + t * sum;
  return sum.hi + sum.lo;
}

/// \return each coordinate within half an ulp and 2^-80 of the largest coordinate: a k-th difference is a sum of 2^k
///   coordinates, so all terms together are at most 3^9 times the largest coordinate, and fewer than 2^7 operations err
///   by 2^-102 of them each
/// \pre polynomial, of degree 1 to MAX_LOCAL_DEGREE, 0 <= t <= 1, coordinates well within the range of double
[[nodiscard]] inline Xy<double> accurate_point(const Bezier_curve_2<double>& curve, double t) {
  CGAL_precondition(!curve.is_rational() && 0 <= t && t <= 1);
  const auto& p = curve.control_points();
  if (t == 0) return p.front();
  if (t == 1) return p.back();
  const auto point = [&](auto degree) -> Xy<double> {
    constexpr std::size_t N = degree();
    double x[N + 1], y[N + 1];
    for (std::size_t i = 0; i <= N; ++i) {
      x[i] = p[i].x;
      y[i] = p[i].y;
    }
    return {accurate_coordinate<N>(x, t), accurate_coordinate<N>(y, t)};
  };
  static_assert(MAX_LOCAL_DEGREE == 9, "these are all degrees");
  switch (curve.degree()) {
    case 1:
      return point(Kind_constant<1>());
    case 2:
      return point(Kind_constant<2>());
    case 3:
      return point(Kind_constant<3>());
    case 4:
      return point(Kind_constant<4>());
    case 5:
      return point(Kind_constant<5>());
    case 6:
      return point(Kind_constant<6>());
    case 7:
      return point(Kind_constant<7>());
    case 8:
      return point(Kind_constant<8>());
    default:
      return point(Kind_constant<9>());
  }
}

/// A point of a rational curve as accurate, by de Casteljau's scheme in homogeneous coordinates. Its terms have one
/// sign in the weight, so that less than 2^8 operations on each err by no more than that many parts in 2^100.
[[nodiscard]] inline Xy<double> accurate_rational_point(const Bezier_curve_2<double>& curve, double t) {
  const auto& p = curve.control_points();
  if (t == 0) return p.front();
  if (t == 1) return p.back();
  Double_double x[MAX_RATIONAL_DEGREE + 1], y[MAX_RATIONAL_DEGREE + 1], w[MAX_RATIONAL_DEGREE + 1];
  const std::size_t degree = p.size() - 1;
  for (std::size_t i = 0; i <= degree; ++i) {
    w[i] = curve.weights()[i];
    x[i] = w[i] * Double_double(p[i].x);
    y[i] = w[i] * Double_double(p[i].y);
  }
  const Double_double one(1.0), s(t), rest = one - s;
  for (std::size_t n = degree; n > 0; --n)
    for (std::size_t i = 0; i < n; ++i)
      for (auto* c : {x, y, w}) c[i] = rest * c[i] + s * c[i + 1];
  const auto rounded = [](const Double_double& z) { return z.hi + z.lo; };
  return {rounded(x[0] / w[0]), rounded(y[0] / w[0])};
}

}  // namespace CGAL::Bounding_arcs

#endif
