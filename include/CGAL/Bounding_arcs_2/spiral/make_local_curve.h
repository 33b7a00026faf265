// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Makes the local curve of a spiral segment, with its error bounds for all pieces at once.

#ifndef CGAL_BOUNDING_ARCS_2_SPIRAL_MAKE_LOCAL_CURVE_H
#define CGAL_BOUNDING_ARCS_2_SPIRAL_MAKE_LOCAL_CURVE_H

#include <CGAL/Bounding_arcs_2/frame/Taylor_table.h>
#include <CGAL/Bounding_arcs_2/internal/Double_double.h>
#include <CGAL/Bounding_arcs_2/internal/Magnitude.h>
#include <CGAL/Bounding_arcs_2/spiral/Local_curve.h>

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace CGAL::Bounding_arcs {

/// The double next to a double-double, and how far it is from the exact value at most.
[[nodiscard]] inline internal::Magnitude rounded_magnitude(const internal::Double_double& x) {
  // no less than the error of any double that is rounded, so that errors in float are these times a constant
  return {std::fabs(x.hi), ((std::max)(std::fabs(x.lo), internal::Magnitude::HALF_ULP * std::fabs(x.hi)) + x.err) *
                               internal::Magnitude::SLACK};
}

template <class Target, class Source, class Convert>
[[nodiscard]] Local_coefficients<Target> convert_coefficients(const Local_coefficients<Source>& c,
                                                              const Convert& number) {
  Local_coefficients<Target> r;
  for (int k = 0; k <= MAX_LOCAL_DEGREE; ++k) {
    r.x[k] = number(c.x[k]);
    r.y[k] = number(c.y[k]);
  }
  for (int k = 0; k < 4; ++k) r.across[k] = number(c.across[k]);
  for (int k = 0; k < 2; ++k) r.change[k] = number(c.change[k]);
  return r;
}

/// Error bounds over all pieces of the segment [first, last].
template <int DEGREE>
void bound_errors(Local_curve& curve, const Local_coefficients<internal::Magnitude>& coefficients, double first,
                  double last) {
  // of tau and s, in units of half an ulp: a batch of floats has them from places of pieces and the step between them
  constexpr double PLACE_ERROR = 8, LENGTH_ERROR = 2;
  constexpr double DIGITS = Local_precision<double>::DIGITS, HALF_ULP = internal::Magnitude::HALF_ULP,
                   SLACK = internal::Magnitude::SLACK;
  const double half = (last - first) / 2 * SLACK, reach = (std::max)(last - curve.middle, curve.middle - first) * SLACK;
  const internal::Magnitude s(half, LENGTH_ERROR * HALF_ULP * half), tau(reach, PLACE_ERROR * HALF_ULP * reach);
  const Local_piece<internal::Magnitude> f = local_piece<DEGREE>(coefficients, tau, s);
  const Local_ends<internal::Magnitude> e = local_ends<DEGREE>(coefficients, tau, f);
  Local_form<double>& form = curve.form;
  // a little more than its own error, for the second order of errors that go with it
  form.numerator_error = (f.a * f.r + f.d * f.p).error * (1 + 0x1p-10);
  form.least_dot = DIGITS * ((f.p + s * f.r).error + (s * f.a).error + (f.square * f.d).error);
  form.least_square = DIGITS * f.chord_square.error;
  form.kneser_error = (std::max)(e.kneser0.error, e.kneser1.error);
  form.turn_rate_error = (std::max)({e.turn_rate0.error, e.turn_rate1.error, f.a.error + (s * f.d).error});
  form.least_turn_rate = Local_precision<double>::TURN_RATE_DIGITS * form.turn_rate_error;
  form.least_tangent = DIGITS * (std::max)(e.square0.error, e.square1.error);
  curve.largest_chord = f.chord_square.size;
}

/// Sets the coefficients of a and d, with the curve reversed and mirrored as Local_curve::direction says.
/// \param half half the segment's length
inline void orient(Local_curve& curve, Local_coefficients<internal::Double_double>& c, double half) {
  const auto set_products = [&c] {
    const auto cross_of = [&](int i, int j) { return c.x[i] * c.y[j] - c.y[i] * c.x[j]; };
    c.across[0] = internal::Double_double(2.0) * cross_of(1, 2);
    c.across[1] = internal::Double_double(6.0) * cross_of(1, 3);
    c.across[2] = internal::Double_double(6.0) * cross_of(2, 3);
    c.across[3] = internal::Double_double(-2.0) * cross_of(2, 3);
    c.change[0] = internal::Double_double(-2.0) * cross_of(1, 3);
    c.change[1] = internal::Double_double(-4.0) * cross_of(2, 3);
  };
  const auto negate = [](internal::Double_double& x) { x = internal::Double_double(0.0) - x; };
  const auto whole = [&] {
    const auto coefficients = convert_coefficients<double>(c, [](const internal::Double_double& x) { return x.hi; });
    return local_piece<MAX_LOCAL_DEGREE>(coefficients, 0.0, half);
  };
  const Local_piece<double> f = whole();
  if (f.a * f.r + f.d * f.p < 0) std::for_each(c.y, c.y + MAX_LOCAL_DEGREE + 1, negate);
  if (whole().a < 0) {
    curve.direction = -1;
    for (int k = 1; k <= MAX_LOCAL_DEGREE; k += 2) {
      negate(c.x[k]);
      negate(c.y[k]);
    }
  }
  set_products();
}

/// The local curve of the segment [first, last] of the curve behind `table`; of degree 0 where there is none.
[[nodiscard]] inline Local_curve make_local_curve(const Taylor_table<internal::Double_double>& table, double first,
                                                  double last) {
  Local_curve curve;
  if (table.is_rational() || table.degree() > MAX_LOCAL_DEGREE) return curve;
  curve.middle = first + (last - first) / 2;
  curve.half = (last - first) / 2;
  curve.form.unit = table.unit();
  const internal::Double_double middle(curve.middle);
  const auto taylor = table.expand(middle, middle + internal::Double_double(1.0));
  Local_coefficients<internal::Double_double> c;
  const int degree = table.degree();
  for (int k = 1; k <= degree; ++k) {
    c.x[k] = taylor.numerator[static_cast<std::size_t>(k)].x;
    c.y[k] = taylor.numerator[static_cast<std::size_t>(k)].y;
  }
  orient(curve, c, (last - first) / 2);
  curve.form.coefficients = convert_coefficients<double>(c, [](const internal::Double_double& x) { return x.hi; });
  const auto magnitudes = convert_coefficients<internal::Magnitude>(c, rounded_magnitude);
  curve.degree = (std::max)(degree, 3);
  if (curve.degree == 3) bound_errors<3>(curve, magnitudes, first, last);
  else if (curve.degree == 4) bound_errors<4>(curve, magnitudes, first, last);
  else bound_errors<5>(curve, magnitudes, first, last);
  const Local_form<double>& form = curve.form;
  const auto bounds = {form.numerator_error, form.least_dot,       form.least_square,
                       form.kneser_error,    form.turn_rate_error, form.least_tangent};
  // so that neither inverses nor products of a few figures leave the range of double
  constexpr double LEAST = 0x1p-200;
  if (!((std::min)(bounds) >= LEAST && (std::max)(bounds) <= 1 / LEAST)) curve.degree = 0;
  return curve;
}

}  // namespace CGAL::Bounding_arcs

#endif
