// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Makes the local curve of a spiral segment, with its error bounds.

#ifndef CGAL_BOUNDING_ARCS_2_SPIRAL_MAKE_LOCAL_CURVE_H
#define CGAL_BOUNDING_ARCS_2_SPIRAL_MAKE_LOCAL_CURVE_H

#include <CGAL/Bounding_arcs_2/curve/Bezier_curve_2.h>
#include <CGAL/Bounding_arcs_2/frame/Taylor_table.h>
#include <CGAL/Bounding_arcs_2/number/Double_double.h>
#include <CGAL/Bounding_arcs_2/number/Pair.h>
#include <CGAL/Bounding_arcs_2/spiral/internal/Cubic_expansion.h>
#include <CGAL/Bounding_arcs_2/spiral/internal/local_errors.h>

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace CGAL::Bounding_arcs {

/// The local curve of the segment [first, last] of the curve behind `table`; of kind 0 where there is none.
/// \tparam Double_double Double_double
template <class Double_double>
[[nodiscard]] Local_curve make_local_curve(const Taylor_table<Double_double>& table, double first, double last) {
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

/// Makes local curves of the segments of one polynomial cubic over double, in a fraction of the time: a filter.
class Cubic_local_curves {
 public:
  Cubic_local_curves(const Bezier_curve_2<double>& cubic, double unit)
      : unit_(unit), width_(0), height_(0),
        terms_(axis(cubic, &Xy<double>::x, width_), axis(cubic, &Xy<double>::y, height_)) {}

  [[nodiscard]] Local_curve operator()(double first, double last) const {
    static constexpr internal::Cubic_expansion_errors ERRORS;
    Local_curve curve(first, last, unit_);
    const Local_coefficients<Pair, 3> c = terms_.expand(curve.middle);
    Local_coefficients<Magnitude, 3> magnitudes;
    const auto set = [](const Pair& from, double error, double& to, Magnitude& magnitude) {
      to = from.hi + from.lo;
      magnitude = rounded_magnitude(to, (from.hi - to) + from.lo, error);
    };
    Local_coefficients<double>& d = curve.form.coefficients;
    const double x_error = ERRORS.coordinate * width_, y_error = ERRORS.coordinate * height_,
                 product_error = ERRORS.product * (width_ * height_);
    for (int k = 1; k <= 3; ++k) {
      set(c.x[k], x_error, d.x[k], magnitudes.x[k]);
      set(c.y[k], y_error, d.y[k], magnitudes.y[k]);
    }
    for (int k = 0; k < 4; ++k) set(c.across[k], product_error, d.across[k], magnitudes.across[k]);
    for (int k = 0; k < 2; ++k) set(c.change[k], product_error, d.change[k], magnitudes.change[k]);
    complete<3>(curve, magnitudes, first, last);
    return curve;
  }

 private:
  using Terms = internal::Cubic_terms<Pair>;

  // From differences in units, the largest of which is kept.
  [[nodiscard]] Terms::Axis axis(const Bezier_curve_2<double>& cubic, double Xy<double>::*coordinate,
                                 double& size) const {
    const double inverse = 1 / unit_;
    const auto difference = [&](std::size_t i) {
      const auto& p = cubic.control_points();
      const auto d = Pair::difference(p[i + 1].*coordinate, p[i].*coordinate);
      size = (std::max)(size, std::fabs(d.hi * inverse));
      return Pair{d.hi * inverse, d.lo * inverse};
    };
    const Pair d0 = difference(0), d1 = difference(1), d2 = difference(2);
    return Terms::axis(d0, d1, d2);
  }

  double unit_, width_, height_;
  Terms terms_;
};

// compiled in the library
extern template Local_curve make_local_curve(const Taylor_table<Double_double>&, double, double);

}  // namespace CGAL::Bounding_arcs

#endif
