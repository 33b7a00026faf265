// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Makes the local curve of a spiral segment, with its error bounds for all pieces at once.
//
// Errors known ahead.  The code of a piece's figures runs once per segment over pairs (size, error) (Magnitude), with
// all arguments as large as they get in the segment.  The result bounds the rounding error of each figure for all its
// pieces at once, errors of the coefficients included, which are rounded from double-doubles.
//
// To first order errors are proportional to half an ulp, and Magnitude has no terms of second order, as sizes bound
// computed values, too.  So the bounds of float are those of double times a constant (filter/Batch_curve.h), provided
// that the errors of what goes in are in that ratio: coefficients count half an ulp at least, and tau and s as many as
// they have in float.

#ifndef CGAL_BOUNDING_ARCS_2_SPIRAL_MAKE_LOCAL_CURVE_H
#define CGAL_BOUNDING_ARCS_2_SPIRAL_MAKE_LOCAL_CURVE_H

#include <CGAL/Bounding_arcs_2/frame/Taylor_table.h>
#include <CGAL/Bounding_arcs_2/internal/Double_double.h>
#include <CGAL/Bounding_arcs_2/internal/Magnitude.h>
#include <CGAL/Bounding_arcs_2/spiral/Local_curve.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>

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

/// Error bounds over all pieces of the segment [first, last]: numerator_error, kneser_error and turn_rate_error are
/// absolute bounds for N, kneser_i, and turn_rate_i or a; least_dot, least_square, least_tangent, least_turn_rate are
/// DIGITS times the bounds for T_i.D, |M|^2, |T_i|^2, turn_rate_i, so that larger figures have a relative error below
/// 1 / DIGITS.  least_dot counts the errors of s a and s^2 d also: a cross errs by no more than 1 / DIGITS of the dot
/// beside it, and a tangent t of an angle by (1 + |t|) / DIGITS.
template <int DEGREE>
void bound_errors(Local_curve& curve, const Local_coefficients<internal::Magnitude>& coefficients, double first,
                  double last) {
  // Of tau and s, in units of half an ulp.  A batch of floats has tau = (place + 1/2) step + offset, where place and
  // step count twice, as that product is at most 2 reach and so are the roundings in it; a batch of doubles has three
  // roundings of numbers up to reach.
  constexpr double PLACE = 2 * 1, STEP = 2 * 1, PRODUCT = 2 * 1, OFFSET = 1, SUM = 1, OF_DOUBLES = 3;
  constexpr double PLACE_ERROR = 8;
  static_assert(PLACE_ERROR == PLACE + STEP + PRODUCT + OFFSET + SUM && OF_DOUBLES <= PLACE_ERROR,
                "update the derivation above");
  // s is rounded to float once; room for the roundings in double behind it, of parameters no larger than 1
  constexpr double LENGTH = 1, LENGTH_ROOM = 1;
  constexpr double LENGTH_ERROR = 2;
  static_assert(LENGTH_ERROR == LENGTH + LENGTH_ROOM, "update the derivation above");
  // a little more than its own error, for the second order of errors that go with it
  constexpr double SECOND_ORDER = 0x1p-10;
  constexpr double DIGITS = Local_precision<double>::DIGITS, HALF_ULP = internal::Magnitude::HALF_ULP,
                   SLACK = internal::Magnitude::SLACK;
  const double half = (last - first) / 2 * SLACK, reach = (std::max)(last - curve.middle, curve.middle - first) * SLACK;
  const internal::Magnitude s(half, LENGTH_ERROR * HALF_ULP * half), tau(reach, PLACE_ERROR * HALF_ULP * reach);
  const Local_piece<internal::Magnitude> f = local_piece<DEGREE>(coefficients, tau, s);
  const Local_ends<internal::Magnitude> e = local_ends<DEGREE>(coefficients, tau, f);
  Local_form<double>& form = curve.form;
  form.numerator_error = (f.a * f.r + f.d * f.p).error * (1 + SECOND_ORDER);
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
  // so that neither inverses nor products of a few figures leave the range of double; coefficients are in units near
  // the largest of their lengths
  constexpr double LEAST = 0x1p-200;
  constexpr double OF_FIVE_FIGURES = LEAST * LEAST * LEAST * LEAST * LEAST;
  static_assert(OF_FIVE_FIGURES >= (std::numeric_limits<double>::min)(), "no formula multiplies more of them");
  if (!((std::min)(bounds) >= LEAST && (std::max)(bounds) <= 1 / LEAST)) curve.degree = 0;
  return curve;
}

}  // namespace CGAL::Bounding_arcs

#endif
