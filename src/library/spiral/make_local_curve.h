// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Makes the local curve of a spiral segment, with its error bounds.

#ifndef BOUNDING_ARCS_LIBRARY_SPIRAL_MAKE_LOCAL_CURVE_H
#define BOUNDING_ARCS_LIBRARY_SPIRAL_MAKE_LOCAL_CURVE_H

#include <CGAL/Bounding_arcs_2/curve/Bezier_curve_2.h>
#include <CGAL/Bounding_arcs_2/frame/Taylor_table.h>
#include <CGAL/Bounding_arcs_2/number/Double_double.h>
#include <CGAL/Bounding_arcs_2/number/strict_math.h>
#include "../number/Pair.h"
#include "Local_curve.h"
#include "Local_figures.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <type_traits>

// The error bounds of a local curve, for all its pieces at once.
//
// Errors known ahead.  The code of a piece's figures runs once per segment over pairs (size, error) (Magnitude), with
// all arguments as large as they get in the segment.  The result bounds the rounding error of each figure for all its
// pieces at once, errors of the coefficients included, which are rounded from double-doubles.
//
// To first order errors are proportional to half an ulp, and Magnitude has no terms of second order, as sizes bound
// computed values, too.  So the bounds of float are those of double times a constant
// (tree/single_loops.cpp), provided that the errors of what goes in are in that ratio: coefficients count
// half an ulp at least, and tau and s as many as they have in float.

namespace CGAL::Bounding_arcs {

/// The magnitude of a number in doubles, with what the exact number, |lo| + error away at most, adds to it.
[[nodiscard]] inline Magnitude rounded_magnitude(double hi, double lo, double error) {
  // no less than the error of any double that is rounded, so that errors in float are these times a constant
  const double size = std::fabs(hi), half_ulps = (std::max)((std::fabs(lo) + error) / HALF_ULP, size);
  return {size + HALF_ULP * half_ulps, half_ulps};
}

[[nodiscard]] inline Ranged_magnitude rounded_range(double hi, double lo, double error) {
  const Magnitude m = rounded_magnitude(hi, lo, error);
  return {hi, m.bound(), m.half_ulps};
}

/// Sets those that a kind of curves has.
template <class Source, class Convert, class Target>
void convert_coefficients(const Local_coefficients<Source>& c, int kind, const Convert& number,
                          Local_coefficients<Target>& r) {
  for (int k = 1; k <= degree_of_kind(kind); ++k) {
    r.x[k] = number(c.x[k]);
    r.y[k] = number(c.y[k]);
    if (is_rational_kind(kind)) r.w[k] = number(c.w[k]);
  }
  r.set_middle(kind);
  if (kind != 3) return;
  for (int k = 0; k < 4; ++k) r.across[k] = number(c.across[k]);
  for (int k = 0; k < 2; ++k) r.change[k] = number(c.change[k]);
}

/// Error bounds over all pieces of a segment with such tau and s, and more than those that are there already:
/// numerator_error, kneser_error and turn_rate_error are absolute bounds for N, kneser_i, and turn_rate_i or a;
/// least_dot, least_square, least_tangent are DIGITS times the bounds for T_i.D, |M|^2, |T_i|^2, turn_rate_i, so that
/// larger figures have a relative error below 1 / DIGITS.  least_dot counts the errors of s a and s^2 d also: a cross
/// errs by no more than 1 / DIGITS of the dot beside it, and a tangent t of an angle by (1 + |t|) / DIGITS.
template <int KIND, class Number, int MOST>
CGAL_BOUNDING_ARCS_INLINE void bound_errors(Local_curve& curve, const Local_coefficients<Number, MOST>& coefficients,
                                            const Number& tau, const Number& s) {
  // a little more than its own error, for the second order of errors that go with it
  constexpr double SECOND_ORDER = 0x1p-10;
  constexpr double DIGITS = Local_precision<double>::DIGITS;
  const Local_piece<Number> f = local_piece<KIND>(coefficients, tau, s);
  const Local_ends<Number> e = local_ends<KIND>(coefficients, tau, f);
  Local_form<double>& form = curve.form;
  const auto raise = [](double& bound, double x) { bound = x > bound ? x : bound; };
  raise(form.numerator_error, (f.a * f.r + f.d * f.p).bound() * (1 + SECOND_ORDER));
  raise(form.least_dot, DIGITS * ((f.p + s * f.r).bound() + (s * f.a).bound() + (f.square * f.d).bound()));
  raise(form.least_square, DIGITS * f.chord_square.bound());
  raise(form.kneser_error, (std::max)(e.kneser0.bound(), e.kneser1.bound()));
  raise(form.turn_rate_error,
        (std::max)({e.turn_rate0.bound(), e.turn_rate1.bound(), f.a.bound() + (s * f.d).bound()}));
  raise(form.least_tangent, DIGITS * (std::max)(e.square0.bound(), e.square1.bound()));
  // The largest products in rough formulas, with room for sums of four: those of bilens, in which 1 - r0 r1 has squares
  // of N |T|^2 and of a kneser times a dot, and of the corners of spiral fat arcs, whose F has 1 / s.
  constexpr double MOST_PRODUCT = 0x1p124, MOST_INVERSE = 0x1p20;
  static_assert(4 * MOST_PRODUCT < double((std::numeric_limits<float>::max)()), "update the derivation above");
  const double numerator = (f.a * f.r + f.d * f.p).size, kneser = (std::max)(e.kneser0.size, e.kneser1.size),
               turn_rate = (std::max)({e.turn_rate0.size, e.turn_rate1.size, f.a.size}),
               square = (std::max)({e.square0.size, e.square1.size, f.chord_square.size, (f.p + s * f.r).size});
  const double weighed = (numerator + kneser) * square, weighed_square = weighed * weighed,
               radicand = weighed_square + MOST_INVERSE * (square * square * square) * (kneser * turn_rate);
  curve.fits_float = curve.fits_float &&
                     weighed_square * (std::max)({numerator, square * square, turn_rate}) <= MOST_PRODUCT &&
                     radicand * (1 + square) <= MOST_PRODUCT;
}

/// Bounds the errors over all pieces of [first, last].  By sizes, tau and s are at most as large as in the whole
/// segment, or for degrees above 5, where that counts, in one of four rectangles: as |tau| + s is no more than the
/// segment reaches from its middle, s is smaller where tau is large.  Rational curves need more for quotients by
/// weights: ranges of tau are looked at one by one, the more of them the more weights change.
template <int KIND, class Number, int MOST>
CGAL_BOUNDING_ARCS_INLINE void bound_all_errors(Local_curve& curve,
                                                const Local_coefficients<Number, MOST>& coefficients, double first,
                                                double last) {
  // Errors of tau and s, in units of half an ulp.  A batch of floats has tau = (place + 1/2) step + offset, where place
  // and step count twice, as that product is at most 2 reach and so are the roundings in it; a batch of doubles has
  // three roundings of numbers up to reach.
  constexpr double PLACE = 2 * 1, STEP = 2 * 1, PRODUCT = 2 * 1, OFFSET = 1, SUM = 1, OF_DOUBLES = 3;
  constexpr double PLACE_ERROR = 8;
  static_assert(PLACE_ERROR == PLACE + STEP + PRODUCT + OFFSET + SUM && OF_DOUBLES <= PLACE_ERROR,
                "update the derivation above");
  // s is rounded to float once; room for the roundings in double behind it, of parameters no larger than 1
  constexpr double LENGTH = 1, LENGTH_ROOM = 1;
  constexpr double LENGTH_ERROR = 2;
  static_assert(LENGTH_ERROR == LENGTH + LENGTH_ROOM, "update the derivation above");
  constexpr double SLACK = Magnitude::SLACK;
  const double half = (last - first) / 2 * SLACK, reach = (std::max)(last - curve.middle, curve.middle - first) * SLACK;
  curve.fits_float = true;
  if constexpr (std::is_same_v<Number, Magnitude>) {
    constexpr int RECTANGLES = KIND <= 5 ? 1 : 4;
    for (int i = 0; i < RECTANGLES; ++i) {
      const double longest = (std::min)(half, reach * (RECTANGLES - i) / RECTANGLES);
      bound_errors<KIND>(curve, coefficients, Number(reach * (i + 1) / RECTANGLES, PLACE_ERROR * reach),
                         Number(longest, LENGTH_ERROR * longest));
    }
  } else {
    constexpr double LEAST_RANGES = 4, MOST_RANGES = 64, PER_CHANGE = 48;
    double change = 0;
    for (int k = degree_of_kind(KIND); k > 0; --k) change = (change + coefficients.w[k].size) * reach;
    const double ranges = std::floor((std::min)(MOST_RANGES, LEAST_RANGES + PER_CHANGE * change));
    for (int i = 0; i < ranges; ++i) {
      const double width = reach / ranges, middle = (2 * i + 1) * width - reach;
      const double longest = (std::min)(half, reach - (std::max)(0.0, std::fabs(middle) - width)) / 2;
      bound_errors<KIND>(curve, coefficients, Number(middle, width * SLACK, PLACE_ERROR * reach),
                         Number(longest, longest, 2 * LENGTH_ERROR * longest));
    }
  }
}

/// Mirrors and reverses the curve as Local_curve::direction says.
template <int KIND> CGAL_BOUNDING_ARCS_INLINE void orient(Local_curve& curve) {
  Local_coefficients<double>& c = curve.form.coefficients;
  const auto negate = [](double& x) { x = -x; };
  const Local_piece<double> f = local_piece<KIND>(c, 0.0, curve.half);
  const bool is_mirrored = f.a * f.r + f.d * f.p < 0;
  if (is_mirrored) {
    curve.mirror = -1;
    std::for_each(c.y + 1, c.y + degree_of_kind(KIND) + 1, negate);
    if (KIND == 3) {
      std::for_each(c.across, c.across + 4, negate);
      std::for_each(c.change, c.change + 2, negate);
    }
  }
  if ((is_mirrored ? -f.a : f.a) < 0) {
    curve.direction = -1;
    for (int k = 1; k <= degree_of_kind(KIND); k += 2) {
      negate(c.x[k]);
      negate(c.y[k]);
      if constexpr (is_rational_kind(KIND)) negate(c.w[k]);
    }
    if (KIND == 3)
      for (double* x : {&c.across[0], &c.across[2], &c.across[3], &c.change[1]}) negate(*x);
  }
}

// Completes a curve of this kind from its coefficients; the kind becomes 0 where bounds leave the range of the
// formulas.
template <int KIND, class Number, int MOST>
CGAL_BOUNDING_ARCS_INLINE void complete(Local_curve& curve, const Local_coefficients<Number, MOST>& magnitudes,
                                        double first, double last) {
  curve.kind = KIND;
  orient<KIND>(curve);
  bound_all_errors<KIND>(curve, magnitudes, first, last);
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

}  // namespace CGAL::Bounding_arcs

// The numbers of Local_coefficients for all segments of a polynomial cubic: with differences d_i of control points,
//   C' = a + 2 b t + 3 c t^2,  a = 3 d0,  b = 3 (d1 - d0),  c = d2 - 2 d1 + d0,
// the Taylor vectors about t are c1 = C', c2 = b + 3 c t and c3 = c, and their crosses, with g0 = 2 a x b,
// g1 = 2 a x c and g2 = 2 b x c,
//   2 c1 x c2 = g0 + 3 g1 t + 3 g2 t^2,  2 c1 x c3 = g1 + 2 g2 t,  2 c2 x c3 = g2.

namespace CGAL::Bounding_arcs::internal {

/// Over Pair, or Pair_magnitude with parameter 1.
template <class T> struct Cubic_terms {
  struct Axis {
    T a, b, c, c3;
  };
  Axis x, y;
  T g0, g1, g2;

  static constexpr T thrice(const T& z) { return twice(z) + z; }
  static constexpr Axis axis(const T& d0, const T& d1, const T& d2) {
    const T bend = d1 - d0, c = (d2 - d1) - bend;
    return {thrice(d0), thrice(bend), c, thrice(c)};
  }
  static constexpr T twice_cross(const T& px, const T& py, const T& qx, const T& qy) {
    return twice(px * qy - py * qx);
  }
  constexpr Cubic_terms(const Axis& u, const Axis& v)
      : x(u), y(v), g0(twice_cross(u.a, v.a, u.b, v.b)), g1(twice_cross(u.a, v.a, u.c, v.c)),
        g2(twice_cross(u.b, v.b, u.c, v.c)) {}

  constexpr Local_coefficients<T, 3> expand(double t) const {
    Local_coefficients<T, 3> r;
    const T h = t * g2, k = g1 + h, slope = k + h, g6 = thrice(g2);
    r.x[2] = x.b + t * x.c3;
    r.y[2] = y.b + t * y.c3;
    r.x[1] = x.a + t * (x.b + r.x[2]);
    r.y[1] = y.a + t * (y.b + r.y[2]);
    r.x[3] = x.c;
    r.y[3] = y.c;
    r.across[0] = g0 + t * thrice(k);
    r.across[1] = thrice(slope);
    r.across[2] = g6;
    r.across[3] = -g2;
    r.change[0] = -slope;
    r.change[1] = -twice(g2);
    return r;
  }
};

/// The errors of the numbers of x or y, and of products, for differences up to 1.
struct Cubic_expansion_errors {
  double coordinate = 0, product = 0;

  constexpr Cubic_expansion_errors() {
    using Terms = Cubic_terms<Pair_magnitude>;
    const Pair_magnitude d{1, HALF_ULP, 0};
    const Terms::Axis axis = Terms::axis(d, d, d);
    const Local_coefficients<Pair_magnitude, 3> c = Terms(axis, axis).expand(1);
    for (const Pair_magnitude& x : c.x) coordinate = x.error > coordinate ? x.error : coordinate;
    for (const Pair_magnitude& x : c.across) product = x.error > product ? x.error : product;
    for (const Pair_magnitude& x : c.change) product = x.error > product ? x.error : product;
  }
};

}  // namespace CGAL::Bounding_arcs::internal

namespace CGAL::Bounding_arcs {

namespace internal {

/// The local curve of the segment [first, last] of the curve behind `table`; of kind 0 where there is none.
[[nodiscard]] Local_curve make_local_curve(const Taylor_table<Double_double>& table, double first, double last);

/// What a segment keeps of a local curve.
[[nodiscard]] inline Kept_local_curve kept(const Local_curve& curve) {
  return {Stored_local_curve(curve), Stored_local_curve::key(curve)};
}

}  // namespace internal

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

}  // namespace CGAL::Bounding_arcs

#endif
