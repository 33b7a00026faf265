// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// How the derivatives of a curve begin at a parameter: see End_orders.

#ifndef CGAL_BOUNDING_ARCS_2_SPIRAL_INTERNAL_END_ORDERS_H
#define CGAL_BOUNDING_ARCS_2_SPIRAL_INTERNAL_END_ORDERS_H

#include <CGAL/Bounding_arcs_2/frame/Taylor_table.h>
#include <CGAL/Bounding_arcs_2/frame/bezier_chord_shape.h>
#include <CGAL/Bounding_arcs_2/number/Double_double.h>

#include <CGAL/number_utils.h>

#include <cstddef>
#include <cstdint>

namespace CGAL::Bounding_arcs::internal {

// The curve's Taylor vectors about t, up to a common factor, each times its power of a unit parameter. They are made
// from the piece between t and half a unit beside it, inside [0, 1]: outside, the weight may vanish.
template <class T> [[nodiscard]] Coefficients<Xy<T>> taylor_vectors(const Taylor_table<T>& table, double t) {
  const double step = t < 0.5 ? 0.5 : -0.5;
  auto about_t = relative_piece(table, T(t), T(T(t) + T(step))).m;
  double factor = 1;
  for (std::size_t k = 1; k < about_t.size(); ++k) {
    factor /= step;
    about_t[k] = T(factor) * about_t[k];
  }
  return about_t;
}

// The order of the first derivative that does not vanish within CUT_WIDTH of t, as far as its Taylor vector and the
// next tell: a tangent that turns within that width tells nothing of the curve beside it.
[[nodiscard]] std::int16_t tangent_order(const Taylor_table<Double_double>& table, double t);

// The width of parameter within which a bend is none if the next one exceeds it; see End_orders. A fold whose control
// points are rounded has a third derivative of some ulp, and is no cusp for that. Wider, and curvatures are off by more
// than proofs widen them by (2^-44); 32 times narrower, and folds of degree 6 are taken for cusps.
inline constexpr double BEND_WIDTH = 0x1p-46;

template <class Exact>
[[nodiscard]] std::int16_t bend_order(const Taylor_table<Exact>& table, double t, std::int16_t order) {
  const auto about_t = taylor_vectors(table, t);
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
