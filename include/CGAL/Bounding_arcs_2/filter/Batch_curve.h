// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// A spiral segment as batches see it: its local curve, and the same in float.

#ifndef CGAL_BOUNDING_ARCS_2_FILTER_BATCH_CURVE_H
#define CGAL_BOUNDING_ARCS_2_FILTER_BATCH_CURVE_H

#include <CGAL/Bounding_arcs_2/spiral/make_local_curve.h>

#include <algorithm>
#include <cmath>

namespace CGAL::Bounding_arcs::filter {

struct Batch_curve {
  const Local_curve& local;
  const Local_form<float>* rough = nullptr;  ///< its lengths are in units of local.form.unit; null: not to be used
};

/// Sets the form in float, where it serves: errors of the first order are those of double times the ratio of half an
/// ulp.
[[nodiscard]] inline bool make_rough_form(const Local_curve& curve, Local_form<float>& rough) {
  constexpr double RATIO = 0x1p29 * (1 + 0x1p-10);  // with the slack that Magnitude has for double
  // no product of a few figures leaves the range of float; coefficients are larger only where a unit near them has no
  // inverse
  constexpr double LEAST_SQUARE = 0x1p-8, LEAST_ERROR = 0x1p-40, MOST_COEFFICIENT = 0x1p7;
  constexpr double LARGEST_PARAMETER = 1 + 0x1p-40;  // 1, and what the sum below is rounded by
  const Local_form<double>& form = curve.form;
  for (int k = 1; k <= MAX_LOCAL_DEGREE; ++k)
    if (!((std::max)(std::fabs(form.coefficients.x[k]), std::fabs(form.coefficients.y[k])) <= MOST_COEFFICIENT))
      return false;
  if (!(curve.largest_chord >= LEAST_SQUARE && std::fabs(curve.middle) + curve.half <= LARGEST_PARAMETER)) return false;
  if (!(RATIO * (std::min)({form.numerator_error, form.kneser_error, form.turn_rate_error}) >= LEAST_ERROR))
    return false;
  const auto up = [](double x) { return static_cast<float>(x * (1 + 0x1p-20)); };
  const auto least = [&](double x) {
    return up(x * (RATIO * Local_precision<float>::DIGITS / Local_precision<double>::DIGITS));
  };
  rough.coefficients = convert_coefficients<float>(form.coefficients, [](double x) { return static_cast<float>(x); });
  rough.numerator_error = up(RATIO * form.numerator_error);
  rough.kneser_error = up(RATIO * form.kneser_error);
  rough.turn_rate_error = up(RATIO * form.turn_rate_error);
  rough.least_dot = least(form.least_dot);
  rough.least_square = least(form.least_square);
  rough.least_turn_rate = up(RATIO * Local_precision<float>::TURN_RATE_DIGITS * form.turn_rate_error);
  rough.least_tangent = least(form.least_tangent);
  return true;
}

}  // namespace CGAL::Bounding_arcs::filter

#endif
