// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Derivatives of Bezier curves at any parameter, and jets whose tangent is the one-sided limit where C' vanishes.

#ifndef CGAL_BOUNDING_ARCS_2_CURVE_DERIVATIVES_H
#define CGAL_BOUNDING_ARCS_2_CURVE_DERIVATIVES_H

#include <CGAL/Bounding_arcs_2/curve/Bezier_curve_2.h>

#include <cstddef>
#include <optional>
#include <utility>
#include <vector>

namespace CGAL::Bounding_arcs {

/// The point of a curve and the first two derivatives there.
template <class NT> struct End_jet_2 { Xy<NT> point, first, second; };

namespace internal {
/// Taylor coefficients b_k = binomial(degree, k) Delta^k about t of a Bernstein polynomial, k = 0 .. count - 1.
template <class NT, class T>
[[nodiscard]] std::vector<T> taylor_coefficients(std::vector<T> row, const NT& t, std::size_t count) {
  const std::size_t n = row.size();
  std::vector<T> result;
  NT binomial(1);
  for (std::size_t k = 0; k < count; ++k) {
    if (k >= n) {
      result.emplace_back();
      continue;
    }
    std::vector<T> p = row;
    for (std::size_t m = p.size() - 1; m > 0; --m)
      for (std::size_t i = 0; i < m; ++i) p[i] = NT(NT(1) - t) * p[i] + t * p[i + 1];
    result.push_back(binomial * p.front());
    for (std::size_t i = 0; i + 1 < row.size(); ++i) row[i] = row[i + 1] - row[i];
    row.pop_back();
    binomial = NT(binomial * NT(static_cast<int>(n - 1 - k)) / NT(static_cast<int>(k + 1)));
  }
  return result;
}
}  // namespace internal

/// The Taylor coefficients C^(k)(t) / k!, k = 0 .. order.
/// \guarantee exact over a field; over double each is a sum of differences of the control points
/// \source rational curves by the quotient recurrence: Piegl and Tiller 1997, algorithm A4.2
template <class NT>
[[nodiscard]] std::vector<Xy<NT>> taylor_expansion(const Bezier_curve_2<NT>& curve, const NT& t, int order) {
  const auto count = static_cast<std::size_t>(order) + 1;
  if (!curve.is_rational()) return internal::taylor_coefficients(curve.control_points(), t, count);
  std::vector<Xy<NT>> numerator;
  const Xy<NT> origin = curve.control_points().front();  // keeps the products small
  for (std::size_t i = 0; i < curve.control_points().size(); ++i)
    numerator.push_back(curve.weights()[i] * (curve.control_points()[i] - origin));
  const auto a = internal::taylor_coefficients(std::move(numerator), t, count);
  const auto w = internal::taylor_coefficients(curve.weights(), t, count);
  std::vector<Xy<NT>> c;
  for (std::size_t k = 0; k < count; ++k) {
    Xy<NT> rest = a[k];
    for (std::size_t j = 1; j <= k; ++j) rest = rest - w[j] * c[k - j];
    c.push_back({NT(rest.x / w[0]), NT(rest.y / w[0])});
  }
  c[0] = c[0] + origin;
  return c;
}

/// The derivative of the given order, 0 for the point itself.
template <class NT> [[nodiscard]] Xy<NT> derivative(const Bezier_curve_2<NT>& curve, const NT& t, int order) {
  NT factorial(1);
  for (int k = 2; k <= order; ++k) factorial = NT(factorial * NT(k));
  return factorial * taylor_expansion(curve, t, order).back();
}

/// Point, tangent and second derivative at t, seen from the right (`after`) or from the left.  Where C' vanishes
/// `first` is the limit of the tangent's direction on that side, m times the first Taylor vector that does not vanish,
/// and `second` is 0: the curvature of such an end is not that of a jet.
/// \return nothing when the whole curve is one point
template <class NT>
[[nodiscard]] std::optional<End_jet_2<NT>> end_jet(const Bezier_curve_2<NT>& curve, const NT& t, bool after) {
  // all derivatives of a rational curve vanish only if it is a point; of order degree at the latest one does not
  const auto c = taylor_expansion(curve, t, curve.degree());
  const Xy<NT> zero{};
  for (std::size_t m = 1; m < c.size(); ++m) {
    if (c[m] == zero) continue;
    if (m == 1) return End_jet_2<NT>{c[0], c[1], c.size() > 2 ? NT(2) * c[2] : zero};
    const NT sign(after || m % 2 == 1 ? 1 : -1);
    return End_jet_2<NT>{c[0], NT(sign * NT(static_cast<int>(m))) * c[m], zero};
  }
  return std::nullopt;
}

}  // namespace CGAL::Bounding_arcs

#endif
