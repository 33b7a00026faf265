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

#include <CGAL/Bounding_arcs_2/curve/Bezier_curve_2.h>
#include <CGAL/Bounding_arcs_2/frame/Taylor_table.h>
#include <CGAL/Bounding_arcs_2/internal/Double_double.h>
#include <CGAL/Bounding_arcs_2/internal/Magnitude.h>
#include <CGAL/Bounding_arcs_2/internal/Pair.h>
#include <CGAL/Bounding_arcs_2/internal/spiral/Cubic_expansion.h>
#include <CGAL/Bounding_arcs_2/spiral/Local_curve.h>
#include <CGAL/Bounding_arcs_2/spiral/Local_figures.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>

namespace CGAL::Bounding_arcs {

/// Of a number in doubles, what the exact one, |lo| + error away at most, adds to it.
[[nodiscard]] inline internal::Magnitude rounded_magnitude(double hi, double lo, double error) {
  constexpr double HALF_ULP = internal::Magnitude::HALF_ULP;
  // no less than the error of any double that is rounded, so that errors in float are these times a constant
  const double size = std::fabs(hi), half_ulps = (std::max)((std::fabs(lo) + error) / HALF_ULP, size);
  return {size + HALF_ULP * half_ulps, half_ulps};
}

template <class Target, class Source, class Convert>
[[nodiscard]] Local_coefficients<Target> convert_coefficients(const Local_coefficients<Source>& c, int kind,
                                                              const Convert& number) {
  Local_coefficients<Target> r{};
  for (int k = 1; k <= degree_of_kind(kind); ++k) {
    r.x[k] = number(c.x[k]);
    r.y[k] = number(c.y[k]);
  }
  if (kind != 3) return r;
  for (int k = 0; k < 4; ++k) r.across[k] = number(c.across[k]);
  for (int k = 0; k < 2; ++k) r.change[k] = number(c.change[k]);
  return r;
}

/// Error bounds over all pieces of the segment [first, last]: numerator_error, kneser_error and turn_rate_error are
/// absolute bounds for N, kneser_i, and turn_rate_i or a; least_dot, least_square, least_tangent are
/// DIGITS times the bounds for T_i.D, |M|^2, |T_i|^2, turn_rate_i, so that larger figures have a relative error below
/// 1 / DIGITS.  least_dot counts the errors of s a and s^2 d also: a cross errs by no more than 1 / DIGITS of the dot
/// beside it, and a tangent t of an angle by (1 + |t|) / DIGITS.
template <int KIND>
[[gnu::always_inline]] inline void bound_errors(Local_curve& curve,
                                                const Local_coefficients<internal::Magnitude>& coefficients,
                                                double first, double last) {
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
  constexpr double DIGITS = Local_precision<double>::DIGITS, SLACK = internal::Magnitude::SLACK;
  const double half = (last - first) / 2 * SLACK, reach = (std::max)(last - curve.middle, curve.middle - first) * SLACK;
  const internal::Magnitude s(half, LENGTH_ERROR * half), tau(reach, PLACE_ERROR * reach);
  const Local_piece<internal::Magnitude> f = local_piece<KIND>(coefficients, tau, s);
  const Local_ends<internal::Magnitude> e = local_ends<KIND>(coefficients, tau, f);
  Local_form<double>& form = curve.form;
  form.numerator_error = (f.a * f.r + f.d * f.p).bound() * (1 + SECOND_ORDER);
  form.least_dot = DIGITS * ((f.p + s * f.r).bound() + (s * f.a).bound() + (f.square * f.d).bound());
  form.least_square = DIGITS * f.chord_square.bound();
  form.kneser_error = (std::max)(e.kneser0.bound(), e.kneser1.bound());
  form.turn_rate_error = (std::max)({e.turn_rate0.bound(), e.turn_rate1.bound(), f.a.bound() + (s * f.d).bound()});
  form.least_tangent = DIGITS * (std::max)(e.square0.bound(), e.square1.bound());
  // The largest products in rough formulas, with room for sums of four: those of bilens, in which 1 - r0 r1 has squares
  // of N |T|^2 and of a kneser times a dot, and of the corners of spiral fat arcs, whose F has 1 / s.
  constexpr double MOST_PRODUCT = 0x1p124, MOST_INVERSE = 0x1p20;
  static_assert(4 * MOST_PRODUCT < double((std::numeric_limits<float>::max)()), "update the derivation above");
  const auto largest = [](const auto& x, const auto& y) { return (std::max)(x.size, y.size); };
  const double numerator = (f.a * f.r + f.d * f.p).size, kneser = largest(e.kneser0, e.kneser1),
               turn_rate = (std::max)(largest(e.turn_rate0, e.turn_rate1), f.a.size),
               square = (std::max)({largest(e.square0, e.square1), f.chord_square.size, (f.p + s * f.r).size});
  const double weighed = (numerator + kneser) * square, weighed_square = weighed * weighed,
               radicand = weighed_square + MOST_INVERSE * (square * square * square) * (kneser * turn_rate);
  curve.fits_float = weighed_square * (std::max)({numerator, square * square, turn_rate}) <= MOST_PRODUCT &&
                     radicand * (1 + square) <= MOST_PRODUCT;
}

/// Mirrors and reverses the curve as Local_curve::direction says.
template <int KIND> [[gnu::always_inline]] inline void orient(Local_curve& curve) {
  Local_coefficients<double>& c = curve.form.coefficients;
  const auto negate = [](double& x) { x = -x; };
  const Local_piece<double> f = local_piece<KIND>(c, 0.0, curve.half);
  const bool is_mirrored = f.a * f.r + f.d * f.p < 0;
  if (is_mirrored) {
    curve.mirror = -1;
    std::for_each(c.y, c.y + degree_of_kind(KIND) + 1, negate);
    std::for_each(c.across, c.across + 4, negate);
    std::for_each(c.change, c.change + 2, negate);
  }
  if ((is_mirrored ? -f.a : f.a) < 0) {
    curve.direction = -1;
    for (int k = 1; k <= degree_of_kind(KIND); k += 2)
      for (double* x : {&c.x[k], &c.y[k]}) negate(*x);
    for (double* x : {&c.across[0], &c.across[2], &c.across[3], &c.change[1]}) negate(*x);
  }
}

// Of a curve of this kind, from its coefficients; of kind 0 where bounds leave the range that formulas are for.
template <int KIND>
[[gnu::always_inline]] inline void complete(Local_curve& curve,
                                            const Local_coefficients<internal::Magnitude>& magnitudes, double first,
                                            double last) {
  curve.kind = KIND;
  orient<KIND>(curve);
  bound_errors<KIND>(curve, magnitudes, first, last);
  const Local_form<double>& form = curve.form;
  const auto bounds = {form.numerator_error, form.least_dot,       form.least_square,
                       form.kneser_error,    form.turn_rate_error, form.least_tangent};
  // so that neither inverses nor products of a few figures leave the range of double, nor have bounds lost anything to
  // underflow that counts; coefficients are in units near the largest of their lengths
  constexpr double LEAST = 0x1p-200;
  constexpr double OF_FIVE_FIGURES = LEAST * LEAST * LEAST * LEAST * LEAST;
  static_assert(OF_FIVE_FIGURES >= (std::numeric_limits<double>::min)(), "no formula multiplies more of them");
  if (!((std::min)(bounds) >= LEAST && (std::max)(bounds) <= 1 / LEAST)) curve.kind = 0;
}

/// The local curve of the segment [first, last] of the curve behind `table`; of kind 0 where there is none.
[[nodiscard]] inline Local_curve make_local_curve(const Taylor_table<internal::Double_double>& table, double first,
                                                  double last) {
  using internal::Double_double;
  const int kind = curve_kind(table.degree(), table.is_rational());
  if (kind == 0) return {};
  Local_curve curve(first, last, table.unit());
  const Double_double middle(curve.middle);
  const auto taylor = table.expand(middle, middle + Double_double(1.0));
  Local_coefficients<Double_double> c;
  for (int k = 1; k <= table.degree(); ++k) {
    c.x[k] = taylor.numerator[static_cast<std::size_t>(k)].x;
    c.y[k] = taylor.numerator[static_cast<std::size_t>(k)].y;
  }
  const auto cross_of = [&](int i, int j) { return c.x[i] * c.y[j] - c.y[i] * c.x[j]; };
  c.across[0] = Double_double(2.0) * cross_of(1, 2);
  c.across[1] = Double_double(6.0) * cross_of(1, 3);
  c.across[2] = Double_double(6.0) * cross_of(2, 3);
  c.across[3] = Double_double(-2.0) * cross_of(2, 3);
  c.change[0] = Double_double(-2.0) * cross_of(1, 3);
  c.change[1] = Double_double(-4.0) * cross_of(2, 3);
  curve.form.coefficients = convert_coefficients<double>(c, kind, [](const Double_double& x) { return x.hi; });
  const auto magnitudes = convert_coefficients<internal::Magnitude>(
      c, kind, [](const Double_double& x) { return rounded_magnitude(x.hi, x.lo, x.err); });
  return for_kind(kind, [&](auto of_kind) {
    complete<of_kind()>(curve, magnitudes, first, last);
    return curve;
  });
}

/// The same for segments of one polynomial cubic over double, in a fraction of the time: a filter.
class Cubic_local_curves {
 public:
  Cubic_local_curves(const Bezier_curve_2<double>& cubic, double unit)
      : unit_(unit), width_(0), height_(0),
        terms_(axis(cubic, &Xy<double>::x, width_), axis(cubic, &Xy<double>::y, height_)) {}

  [[nodiscard]] Local_curve operator()(double first, double last) const {
    using internal::Magnitude;
    static constexpr internal::Cubic_expansion_errors ERRORS;
    Local_curve curve(first, last, unit_);
    const Local_coefficients<internal::Pair> c = terms_.expand(curve.middle);
    Local_coefficients<Magnitude> magnitudes{};
    const auto set = [](const internal::Pair& from, double error, double& to, Magnitude& magnitude) {
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
  using Terms = internal::Cubic_terms<internal::Pair>;

  // From differences in units, the largest of which is kept.
  [[nodiscard]] Terms::Axis axis(const Bezier_curve_2<double>& cubic, double Xy<double>::*coordinate,
                                 double& size) const {
    const double inverse = 1 / unit_;
    const auto difference = [&](std::size_t i) {
      const auto& p = cubic.control_points();
      const auto d = internal::Pair::difference(p[i + 1].*coordinate, p[i].*coordinate);
      size = (std::max)(size, std::fabs(d.hi * inverse));
      return internal::Pair{d.hi * inverse, d.lo * inverse};
    };
    const internal::Pair d0 = difference(0), d1 = difference(1), d2 = difference(2);
    return Terms::axis(d0, d1, d2);
  }

  double unit_, width_, height_;
  Terms terms_;
};

}  // namespace CGAL::Bounding_arcs

#endif
