// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The filter's code for one or two pieces, once for all programs and instruction sets.

#include "Instruction_sets.h"
#include "batch/Bca_batch.h"
#include "batch/Bilens_batch.h"
#include "batch/Spiral_fat_arc_batch.h"
#include "batch/arc_batch.h"
#include "batch/bound_batch.h"

#include <CGAL/Bounding_arcs_2/tree/Build_options.h>
#include "../spiral/Local_curve.h"
#include "../spiral/make_local_curve.h"
#include "batch/Batch_questions.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace CGAL::Bounding_arcs::filter {

template <class Method> Bound_function one_function(int kind) {
  return for_kind(kind, [](auto k) -> Bound_function { return &bound_one<Method, k()>; });
}
template <class Arcs> Arc_function few_function(int kind) {
  return for_kind(kind, [](auto k) -> Arc_function { return &arc_batch<One_by_one, Arcs, k(), 1>; });
}
template <class Arcs> Arc_room arc_room(const Local_curve& curve, const Point_sizes& sizes) {
  Arc_room room{};
  for_kind(curve.kind, [&](auto k) { room = arc_room<Arcs, k()>(curve.form, curve.half, sizes); });
  return room;
}

#define BOUNDING_ARCS_OF_METHOD(Method, Arcs)        \
  template Bound_function one_function<Method>(int); \
  template Arc_function few_function<Arcs>(int);     \
  template Arc_room arc_room<Arcs>(const Local_curve&, const Point_sizes&)
BOUNDING_ARCS_OF_METHOD(Bca_batch, Bca_arcs);
BOUNDING_ARCS_OF_METHOD(Spiral_fat_arc_batch, Spiral_fat_arc_arcs);
BOUNDING_ARCS_OF_METHOD(Bilens_batch, Bilens_arcs);

// A segment's form in float.
//
// To first order errors are proportional to half an ulp, and the bounds of double (spiral/make_local_curve.h) count for
// coefficients, tau and s what these have in float.  So the bounds of float are those of double times the ratio of half
// ulps, 2^29, and 1 + 2^-11 for its larger sizes: the slack of Magnitude, 2^13 half ulps, would be that many of float.
// Lengths are in units of the coefficients, so that neither tiny nor huge curves matter.
//
// Float is used for pieces with s >= LEAST_STEP / 2 = 2^-20 (bound_batch.h) of a curve over [0, 1] whose bounds for N,
// knesers and turn rates are 2^-40 at least, and whose least dots and squares, DIGITS times the bounds of their
// errors, 2^-19. Then, with CERTAIN and TURN_RATE_DIGITS times their errors, N and knesers are above 2^-32, turn rates
// above 2^-30, and products of two dots and two knesers, N^2 |T0|^2 |T1|^2 among them, above 2^-102.  Where larger
// products of these might still underflow, numerator and denominator are asked to be LEAST_PRODUCT at least. Upper
// limits are Local_curve::fits_float.
bool make_rough_form(const Local_curve& curve, Local_form<float>& rough) {
  constexpr double HALF_ULPS = Local_precision<float>::HALF_ULP / Local_precision<double>::HALF_ULP;
  constexpr double LARGER_SIZES = (Magnitude::SLACK - 1) * HALF_ULPS;
  static_assert(LARGER_SIZES == 0x1p-11, "update the derivation above");
  constexpr double RATIO = HALF_ULPS * (1 + LARGER_SIZES);
  constexpr double LEAST_DOT = 0x1p-19, LEAST_ERROR = 0x1p-40;
  constexpr double LEAST_CERTAIN = Local_precision<float>::CERTAIN * LEAST_ERROR;
  constexpr double LEAST_TURN_RATE = Local_precision<float>::TURN_RATE_DIGITS * LEAST_ERROR;
  static_assert(LEAST_CERTAIN == 0x1p-32 && LEAST_TURN_RATE == 0x1p-30 &&
                    LEAST_DOT * LEAST_DOT * LEAST_CERTAIN * LEAST_CERTAIN >=
                        double((std::numeric_limits<float>::min)()) / Local_precision<float>::HALF_ULP,
                "update the derivation above");
  constexpr double LARGEST_PARAMETER = 1 + 0x1p-40;  // 1, and what the sum below is rounded by
  const Local_form<double>& form = curve.form;
  if (!(curve.fits_float && std::fabs(curve.middle) + curve.half <= LARGEST_PARAMETER)) return false;
  if (!(RATIO * (std::min)({form.numerator_error, form.kneser_error, form.turn_rate_error}) >= LEAST_ERROR))
    return false;
  const auto up = [](double x) { return static_cast<float>(x * (1 + 0x1p-20)); };
  const auto least = [&](double x) {
    return up(x * (RATIO * Local_precision<float>::DIGITS / Local_precision<double>::DIGITS));
  };
  if (!((std::min)({least(form.least_dot), least(form.least_square), least(form.least_tangent)}) >= LEAST_DOT))
    return false;
  convert_coefficients(
      form.coefficients, curve.kind, [](double x) { return static_cast<float>(x); }, rough.coefficients);
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
