// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Local curves with their error bounds, once for all programs; apart from spirals.cpp, where so much code would keep
// that for cubics from being inlined.

#include "make_local_curve.h"

#include <CGAL/Bounding_arcs_2/spiral/internal/Tabulated_bezier.h>

namespace CGAL::Bounding_arcs::internal {

Local_curve make_local_curve(const Taylor_table<Double_double>& table, double first, double last) {
  const int kind = curve_kind(table.degree(), table.is_rational());
  if (kind == 0) return {};
  Local_curve curve(first, last, table.unit());
  const Double_double middle(curve.middle);
  const auto taylor = table.expand(middle, middle + Double_double(1.0));
  Local_coefficients<Double_double> c;
  const Double_double one(1.0), inverse = table.is_rational() ? one / taylor.weight[0] : one;
  for (std::size_t k = 1; k <= static_cast<std::size_t>(table.degree()); ++k) {
    c.x[k] = taylor.numerator[k].x;
    c.y[k] = taylor.numerator[k].y;
    if (!table.is_rational()) continue;
    c.w[k] = inverse * taylor.weight[k];
    c.x[k] = inverse * (c.x[k] - c.w[k] * taylor.numerator[0].x);
    c.y[k] = inverse * (c.y[k] - c.w[k] * taylor.numerator[0].y);
  }
  const auto cross_of = [&](int i, int j) { return c.x[i] * c.y[j] - c.y[i] * c.x[j]; };
  c.across[0] = Double_double(2.0) * cross_of(1, 2);
  c.across[1] = Double_double(6.0) * cross_of(1, 3);
  c.across[2] = Double_double(6.0) * cross_of(2, 3);
  c.across[3] = Double_double(-2.0) * cross_of(2, 3);
  c.change[0] = Double_double(-2.0) * cross_of(1, 3);
  c.change[1] = Double_double(-4.0) * cross_of(2, 3);
  convert_coefficients(
      c, kind, [](const Double_double& x) { return x.hi; }, curve.form.coefficients);
  return for_kind(kind, [&](auto of_kind) {
    const auto number = [of_kind](const Double_double& x) {
      if constexpr (is_rational_kind(of_kind())) return rounded_range(x.hi, x.lo, x.err);
      else return rounded_magnitude(x.hi, x.lo, x.err);
    };
    Local_coefficients<decltype(number(Double_double()))> numbers;
    convert_coefficients(c, kind, number, numbers);
    complete<of_kind()>(curve, numbers, first, last);
    return curve;
  });
}

Kept_local_curve kept_local_curve(const Taylor_table<Double_double>& table, double first, double last) {
  return kept(make_local_curve(table, first, last));
}

}  // namespace CGAL::Bounding_arcs::internal
