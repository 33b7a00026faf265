// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// How the derivatives of a curve begin at a parameter: see End_orders.

#ifndef CGAL_BOUNDING_ARCS_2_SPIRAL_INTERNAL_END_ORDERS_H
#define CGAL_BOUNDING_ARCS_2_SPIRAL_INTERNAL_END_ORDERS_H

#include <CGAL/Bounding_arcs_2/frame/bezier_chord_shape.h>
#include <CGAL/Bounding_arcs_2/number/Double_double.h>
#include <CGAL/Bounding_arcs_2/spiral/internal/Tabulated_bezier.h>
#include <CGAL/Bounding_arcs_2/spiral/spiral_parameters.h>

#include <CGAL/number_utils.h>

#include <boost/container/small_vector.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <type_traits>

namespace CGAL::Bounding_arcs::internal {

// Whether C' is found in doubles so far from 0 that tangent_order is 1, a filter for it. With differences of control
// points up to L and n the degree, C' / n comes from n - 1 rounds of three roundings and one of the differences, each
// of u L at most; C'' / 2 is n (n - 1) L at most and asked to be n / (2 CUT_WIDTH) = n / (8 u) times smaller.
template <class NT> [[nodiscard]] bool has_ordinary_tangent(const Bezier_curve_2<NT>& curve, double t) {
  if constexpr (std::is_same_v<NT, double>) {
    constexpr double LEAST_SIZE = 0x1p-900;  // below, roundings are not in proportion
    constexpr double BLENDS = 3, DIFFERENCE = 1, BEND = 8, SECOND_ORDER = 1, PER_DEGREE = 13, U = HALF_ULP;
    static_assert(PER_DEGREE == BLENDS + DIFFERENCE + BEND + SECOND_ORDER && BEND * U == 2 * CUT_WIDTH,
                  "update the derivation above");
    if (curve.is_rational()) return false;
    const auto& p = curve.control_points();
    boost::container::small_vector<Xy<double>, 8> d(p.size() - 1);
    double size = 0;
    for (std::size_t i = 0; i < d.size(); ++i) {
      d[i] = p[i + 1] - p[i];
      size = (std::max)({size, std::fabs(d[i].x), std::fabs(d[i].y)});
    }
    const double s = 1 - t;
    for (std::size_t n = d.size() - 1; n > 0; --n)
      for (std::size_t i = 0; i < n; ++i) d[i] = s * d[i] + t * d[i + 1];
    return size > LEAST_SIZE &&
           (std::max)(std::fabs(d[0].x), std::fabs(d[0].y)) > PER_DEGREE * curve.degree() * U * size;
  } else {
    return false;
  }
}

// The curve's Taylor vectors about t, up to a common factor, each times its power of a unit parameter. They are made
// from the piece between t and half a unit beside it, inside [0, 1]: outside, the weight may vanish.
template <class T, class NT>
[[nodiscard]] Coefficients<Xy<T>> taylor_vectors(const Tabulated_bezier<NT>& curve, double t) {
  const double step = t < 0.5 ? 0.5 : -0.5;
  auto about_t = relative_piece(curve.template table<T>(), T(t), T(T(t) + T(step))).m;
  double factor = 1;
  for (std::size_t k = 1; k < about_t.size(); ++k) {
    factor /= step;
    about_t[k] = T(factor) * about_t[k];
  }
  return about_t;
}

// The order of the first derivative that does not vanish within CUT_WIDTH of t, as far as its Taylor vector and the
// next tell: a tangent that turns within that width tells nothing of the curve beside it.
template <class NT> [[nodiscard]] std::int16_t tangent_order(const Tabulated_bezier<NT>& curve, double t) {
  if (has_ordinary_tangent(curve.curve(), t)) return 1;
  const auto about_t = taylor_vectors<Double_double>(curve, t);
  const auto size = [&](std::size_t k) {
    return k < about_t.size() ? (std::max)(std::fabs(about_t[k].x.hi), std::fabs(about_t[k].y.hi)) : 0.0;
  };
  for (std::size_t k = 1; k < about_t.size(); ++k)
    if (size(k) > static_cast<double>(k + 1) * CUT_WIDTH * size(k + 1)) return static_cast<std::int16_t>(k);
  return 1;  // a point
}

// The width of parameter within which a bend is none if the next one exceeds it; see End_orders. A fold whose control
// points are rounded has a third derivative of some ulp, and is no cusp for that. Wider, and curvatures are off by more
// than proofs widen them by (2^-44); 32 times narrower, and folds of degree 6 are taken for cusps.
inline constexpr double BEND_WIDTH = 0x1p-46;

template <class NT>
[[nodiscard]] std::int16_t bend_order(const Tabulated_bezier<NT>& curve, double t, std::int16_t order) {
  using Exact = typename Tabulated_bezier<NT>::Exact;
  const auto about_t = taylor_vectors<Exact>(curve, t);
  const auto first = static_cast<std::size_t>(order);
  const auto size = [&](std::size_t j) {
    return j < about_t.size() ? Exact(CGAL::abs(Exact(cross(about_t[first], about_t[j])))) : Exact(0);
  };
  for (std::size_t j = first + 1; j < about_t.size(); ++j)
    if (size(j) > Exact(static_cast<double>(j + 1) * BEND_WIDTH) * size(j + 1)) return static_cast<std::int16_t>(j);
  return 0;
}

}  // namespace CGAL::Bounding_arcs::internal

#endif
