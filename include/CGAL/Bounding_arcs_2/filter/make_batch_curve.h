// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Makes the batch form of a spiral segment, with its error bounds for all pieces at once.

#ifndef CGAL_BOUNDING_ARCS_2_FILTER_MAKE_BATCH_CURVE_H
#define CGAL_BOUNDING_ARCS_2_FILTER_MAKE_BATCH_CURVE_H

#include <CGAL/Bounding_arcs_2/filter/Batch_curve.h>
#include <CGAL/Bounding_arcs_2/frame/Taylor_table.h>
#include <CGAL/Bounding_arcs_2/internal/Double_double.h>
#include <CGAL/Bounding_arcs_2/internal/Magnitude.h>

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace CGAL::Bounding_arcs::filter {

/// The double next to a double-double, and how far it is from the exact value at most.
[[nodiscard]] inline internal::Magnitude rounded_magnitude(const internal::Double_double& x) {
  // no less than the error of any double that is rounded, so that errors in float are these times a constant
  return {std::fabs(x.hi), ((std::max)(std::fabs(x.lo), internal::Magnitude::HALF_ULP * std::fabs(x.hi)) + x.err) *
                               internal::Magnitude::SLACK};
}

template <class Target, class Source, class Convert>
[[nodiscard]] Batch_coefficients<Target> convert_coefficients(const Batch_coefficients<Source>& c,
                                                              const Convert& number) {
  Batch_coefficients<Target> r;
  for (int k = 0; k <= MAX_BATCH_DEGREE; ++k) {
    r.x[k] = number(c.x[k]);
    r.y[k] = number(c.y[k]);
  }
  for (int k = 0; k < 4; ++k) r.bend[k] = number(c.bend[k]);
  for (int k = 0; k < 2; ++k) r.change[k] = number(c.change[k]);
  return r;
}

/// Error bounds over all pieces of the segment [first, last].
/// \return the size of M.M
template <int DEGREE>
double bound_errors(Batch_curve& curve, const Batch_coefficients<internal::Magnitude>& coefficients, double first,
                    double last) {
  // of tau and s, in units of half an ulp: a batch of floats has them from places of pieces and the step between them
  constexpr double PLACE_ERROR = 8, LENGTH_ERROR = 2;
  constexpr double DIGITS = Batch_precision<double>::DIGITS, HALF_ULP = internal::Magnitude::HALF_ULP,
                   SLACK = internal::Magnitude::SLACK;
  const double half = (last - first) / 2 * SLACK, reach = (std::max)(last - curve.middle, curve.middle - first) * SLACK;
  const internal::Magnitude s(half, LENGTH_ERROR * HALF_ULP * half), tau(reach, PLACE_ERROR * HALF_ULP * reach);
  const Batch_piece<internal::Magnitude> f = batch_piece<DEGREE>(coefficients, tau, s);
  const Batch_ends<internal::Magnitude> e = batch_ends<DEGREE>(coefficients, tau, f);
  Batch_form<double>& form = curve.form;
  // a little more than its own error, for the second order of errors that go with it
  form.numerator_error = (f.a * f.r + f.d * f.p).error * (1 + 0x1p-10);
  form.least_dot = DIGITS * ((f.p + s * f.r).error + (s * f.a).error + (f.square * f.d).error);
  form.least_square = DIGITS * f.chord_square.error;
  form.kneser_error = (std::max)(e.kneser0.error, e.kneser1.error);
  form.bend_error = (std::max)({e.bend0.error, e.bend1.error, f.a.error + (s * f.d).error});
  form.least_bend = Batch_precision<double>::BEND_DIGITS * form.bend_error;
  form.least_tangent = DIGITS * (std::max)(e.square0.error, e.square1.error);
  return f.chord_square.size;
}

/// The same in float, where it serves: errors of the first order are those of double times the ratio of half an ulp.
inline void make_rough_form(Batch_curve& curve, double square, double first, double last) {
  constexpr double RATIO = 0x1p29 * (1 + 0x1p-10);  // with the slack that Magnitude has for double
  // no product of a few figures leaves the range of float; coefficients are larger only where a unit near them has no
  // inverse
  constexpr double LEAST_SQUARE = 0x1p-8, LEAST_ERROR = 0x1p-40, MOST_COEFFICIENT = 0x1p7;
  const Batch_form<double>& form = curve.form;
  for (int k = 1; k <= MAX_BATCH_DEGREE; ++k)
    if (!((std::max)(std::fabs(form.coefficients.x[k]), std::fabs(form.coefficients.y[k])) <= MOST_COEFFICIENT)) return;
  if (!(square >= LEAST_SQUARE && first >= -1 && last <= 1)) return;
  if (!(RATIO * (std::min)({form.numerator_error, form.kneser_error, form.bend_error}) >= LEAST_ERROR)) return;
  const auto up = [](double x) { return static_cast<float>(x * (1 + 0x1p-20)); };
  const auto least = [&](double x) {
    return up(x * (RATIO * Batch_precision<float>::DIGITS / Batch_precision<double>::DIGITS));
  };
  curve.rough.coefficients =
      convert_coefficients<float>(form.coefficients, [](double x) { return static_cast<float>(x); });
  curve.rough.numerator_error = up(RATIO * form.numerator_error);
  curve.rough.kneser_error = up(RATIO * form.kneser_error);
  curve.rough.bend_error = up(RATIO * form.bend_error);
  curve.rough.least_dot = least(form.least_dot);
  curve.rough.least_square = least(form.least_square);
  curve.rough.least_bend = up(RATIO * Batch_precision<float>::BEND_DIGITS * form.bend_error);
  curve.rough.least_tangent = least(form.least_tangent);
  curve.has_rough = true;
}

/// Sets the coefficients of a and d, with the curve reversed and mirrored as Batch_curve::direction says.
/// \param half half the segment's length
inline void orient(Batch_curve& curve, Batch_coefficients<internal::Double_double>& c, double half) {
  const auto set_products = [&c] {
    const auto cross_of = [&](int i, int j) { return c.x[i] * c.y[j] - c.y[i] * c.x[j]; };
    c.bend[0] = internal::Double_double(2.0) * cross_of(1, 2);
    c.bend[1] = internal::Double_double(6.0) * cross_of(1, 3);
    c.bend[2] = internal::Double_double(6.0) * cross_of(2, 3);
    c.bend[3] = internal::Double_double(-2.0) * cross_of(2, 3);
    c.change[0] = internal::Double_double(-2.0) * cross_of(1, 3);
    c.change[1] = internal::Double_double(-4.0) * cross_of(2, 3);
  };
  const auto negate = [](internal::Double_double& x) { x = internal::Double_double(0.0) - x; };
  const auto whole = [&] {
    const auto coefficients = convert_coefficients<double>(c, [](const internal::Double_double& x) { return x.hi; });
    return batch_piece<MAX_BATCH_DEGREE>(coefficients, 0.0, half);
  };
  const Batch_piece<double> f = whole();
  if (f.a * f.r + f.d * f.p < 0) std::for_each(c.y, c.y + MAX_BATCH_DEGREE + 1, negate);
  if (whole().a < 0) {
    curve.direction = -1;
    for (int k = 1; k <= MAX_BATCH_DEGREE; k += 2) {
      negate(c.x[k]);
      negate(c.y[k]);
    }
  }
  set_products();
}

/// The batch form of the segment [first, last] of the curve behind `table`; of degree 0 where there is none.
[[nodiscard]] inline Batch_curve make_batch_curve(const Taylor_table<internal::Double_double>& table, double first,
                                                  double last) {
  Batch_curve curve;
  if (table.is_rational() || table.degree() > MAX_BATCH_DEGREE) return curve;
  curve.middle = first + (last - first) / 2;
  curve.form.unit = table.unit();
  const internal::Double_double middle(curve.middle);
  const auto taylor = table.expand(middle, middle + internal::Double_double(1.0));
  Batch_coefficients<internal::Double_double> c;
  const int degree = table.degree();
  for (int k = 1; k <= degree; ++k) {
    c.x[k] = taylor.numerator[static_cast<std::size_t>(k)].x;
    c.y[k] = taylor.numerator[static_cast<std::size_t>(k)].y;
  }
  orient(curve, c, (last - first) / 2);
  curve.form.coefficients = convert_coefficients<double>(c, [](const internal::Double_double& x) { return x.hi; });
  const auto magnitudes = convert_coefficients<internal::Magnitude>(c, rounded_magnitude);
  curve.degree = (std::max)(degree, 3);
  const double square = curve.degree == 3   ? bound_errors<3>(curve, magnitudes, first, last)
                        : curve.degree == 4 ? bound_errors<4>(curve, magnitudes, first, last)
                                            : bound_errors<5>(curve, magnitudes, first, last);
  const Batch_form<double>& form = curve.form;
  const auto bounds = {form.numerator_error, form.least_dot,  form.least_square,
                       form.kneser_error,    form.bend_error, form.least_tangent};
  // so that neither inverses nor products of a few figures leave the range of double
  constexpr double LEAST = 0x1p-200;
  if (!((std::min)(bounds) >= LEAST && (std::max)(bounds) <= 1 / LEAST)) curve.degree = 0;
  else make_rough_form(curve, square, first, last);
  return curve;
}

}  // namespace CGAL::Bounding_arcs::filter

#endif
