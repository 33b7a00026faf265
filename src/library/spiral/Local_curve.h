// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// A spiral segment about its middle parameter in doubles, with bounds of all rounding errors in the figures of its
// pieces (Local_figures.h).
//
// A segment's curve is taken mirrored, and reversed (Local_curve::direction), so that it turns left with its tight end
// first; on pieces beyond a vertex or inflection, which rounded ends of segments may leave, the signs that formulas ask
// for do not hold.

#ifndef BOUNDING_ARCS_LIBRARY_SPIRAL_LOCAL_CURVE_H
#define BOUNDING_ARCS_LIBRARY_SPIRAL_LOCAL_CURVE_H

#include <CGAL/Bounding_arcs_2/number/strict_math.h>
#include <CGAL/Bounding_arcs_2/spiral/internal/Stored_local_curve.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <initializer_list>
#include <type_traits>

namespace CGAL::Bounding_arcs {

// Kinds of local curves: the code of batches is compiled for some degrees, and a curve of another one is taken for one
// of the next higher, with leading coefficients of 0.

/// Largest degree of curves that have a local curve.
inline constexpr int MAX_LOCAL_DEGREE = 9, MAX_RATIONAL_DEGREE = 5;
/// What the kinds of rational curves have more than those of polynomials, which are degrees. 0 is no kind.
inline constexpr int RATIONAL = 16;

[[nodiscard]] constexpr int degree_of_kind(int kind) { return kind % RATIONAL; }
[[nodiscard]] constexpr bool is_rational_kind(int kind) { return kind >= RATIONAL; }

/// The kind of a curve's local curve, 0 where there is none.
[[nodiscard]] constexpr int curve_kind(int degree, bool is_rational) {
  if (degree > (is_rational ? MAX_RATIONAL_DEGREE : MAX_LOCAL_DEGREE)) return 0;
  if (is_rational) return RATIONAL + (degree <= 2 ? 2 : degree == 3 ? 3 : 5);
  if (degree <= 3) return 3;
  return degree <= 5 ? degree : degree <= 7 ? 7 : 9;
}

template <int KIND> using Kind_constant = std::integral_constant<int, KIND>;

/// Calls f(Kind_constant<kind>()), for a kind that there is.
/// \return what f does, or without a kind a value of this type
template <class Call> [[nodiscard]] auto for_kind(int kind, const Call& f) -> decltype(f(Kind_constant<3>())) {
  switch (kind) {
    case 3:
      return f(Kind_constant<3>());
    case 4:
      return f(Kind_constant<4>());
    case 5:
      return f(Kind_constant<5>());
    case 7:
      return f(Kind_constant<7>());
    case 9:
      return f(Kind_constant<9>());
    case RATIONAL + 2:
      return f(Kind_constant<RATIONAL + 2>());
    case RATIONAL + 3:
      return f(Kind_constant<RATIONAL + 3>());
    case RATIONAL + 5:
      return f(Kind_constant<RATIONAL + 5>());
    default:
      return decltype(f(Kind_constant<3>()))();
  }
}

/// Taylor coefficients about the middle of a spiral segment, relative to the point there. A rational curve also has
/// those of the weight, over the weight at the middle, and x and y are numerators over it. A cubic also has those of a
/// and d as polynomials in tau and s^2, formed more accurately than in double.
/// \tparam MOST the largest degree that there is room for
template <class NT, int MOST = MAX_LOCAL_DEGREE> struct Local_coefficients {
  static constexpr std::size_t SIZE = MOST + 1, WEIGHTS = (std::min)(MOST, MAX_RATIONAL_DEGREE) + 1;
  NT x[SIZE], y[SIZE];
  NT w[WEIGHTS];
  NT across[4];  ///< a = across0 + across1 tau + across2 tau^2 + across3 s^2
  NT change[2];  ///< d = change0 + change1 tau

  /// Sets what is the same of all curves, and read of rational ones.
  void set_middle(int kind) {
    if (!is_rational_kind(kind)) return;
    x[0] = y[0] = NT(0);
    w[0] = NT(1);
  }
};

/// A spiral segment in one floating type: coefficients, and bounds that hold for all its pieces.
template <class Real> struct Local_form {
  Real unit = 1;  ///< of thickness, in units of the coefficients' lengths
  /// Coefficients of the segment's kind. Others are not set, nor read: zeros would be 12 of the 16 ns of unpacking a
  /// cubic's.
  Local_coefficients<Real> coefficients;
  Real numerator_error = 0;  ///< bound on the rounding error of N = a r + d p
  Real least_dot = 0;  ///< where p -+ s r are at least this they have relative errors below 1 / DIGITS, and a s and d
                       ///< s^2 errors below 1 / DIGITS times them
  Real least_square = 0;  ///< M.M above this has a relative error below 1 / DIGITS
  Real kneser_error = 0;  ///< bounds on the rounding errors of kneser0, kneser1 and turn_rate0, turn_rate1
  Real turn_rate_error = 0;
  Real least_turn_rate = 0;  ///< a turn rate, or a, above this has a relative error below 1 / TURN_RATE_DIGITS
  Real least_tangent = 0;    ///< |T|^2 above this has a relative error below 1 / DIGITS
};

/// What the figures of pieces are held to.  The derivations of formulas call rho = 1 / DIGITS and epsilon = 1 /
/// CERTAIN:
///  * Where a dot, a square, or |T_i|^2 reaches its least value in Local_form, which is DIGITS times the bound of its
///    error, its relative error is at most rho; that of a turn rate, or of a, 1 / TURN_RATE_DIGITS.
///  * N and the knesers vanish to first order at vertices, so their errors are carried along as they are.  Where one is
///    at least CERTAIN times the bound of its error, it has the right sign and a relative error of at most epsilon.
template <class Real> struct Local_precision;
/// The precision of double.
template <> struct Local_precision<double> {
  static constexpr double HALF_ULP = Bounding_arcs::HALF_ULP;
  /// A figure may be this many times smaller than its segment's sizes, whose rounding errors it has, before it fails:
  /// near cusps and inflections.
  static constexpr double CANCELLATION = 0x1p20;
  static constexpr double DIGITS = 1 / (HALF_ULP * CANCELLATION), TURN_RATE_DIGITS = DIGITS;
  static_assert(DIGITS == 0x1p33, "the derivations of the series of src/library/tree/batch/ count in parts of this");
  /// Relative error that the roundings of a batch's formula, and what its series leave out, add to the errors of
  /// numerator and knesers. Each formula has the sum of its own beside it.
  static constexpr double MOST_FACTORS = 16;  ///< no formula has more figures that are exact to 1 / DIGITS as factors
  static constexpr double ROUNDING = MOST_FACTORS / DIGITS;
  /// A figure this many times its error bound has a certain sign.
  static constexpr double CERTAIN = 0x1p14;
  /// The roundings of the formulas themselves: no more operations follow each other. Part of every sum in
  /// src/library/tree/batch/.
  static constexpr double OPERATIONS = 200, OPERATION_ROUNDINGS = 0x1p-12;  ///< the latter in parts of 1 / DIGITS
  static_assert(OPERATIONS * HALF_ULP <= OPERATION_ROUNDINGS / DIGITS,
                "update the derivations of formulas in src/library/tree/batch/");
  /// More than products near the least number lose of lengths, with the curve's own unit.
  static constexpr double UNDERFLOW_LENGTH = 0x1p-1000;
};
/// The precision of float.
template <> struct Local_precision<float> {
  static constexpr double HALF_ULP = 0x1p-24;
  static constexpr double CANCELLATION = 0x1p11;  ///< the same, in float
  static constexpr float DIGITS = float(1 / (HALF_ULP * CANCELLATION)), CERTAIN = 0x1p8f;
  static_assert(DIGITS == 0x1p13f && DIGITS == 32 * CERTAIN,
                "the derivations of rough forms count in parts of this, with an epsilon of 32 rho");
  /// Turn rates, and a, have 8 rho: fewer digits, as next to an inflection they are small at every level.
  static constexpr float TURN_RATE_DIGITS = 0x1p10f;
  static constexpr double OPERATIONS = 60, OPERATION_ROUNDINGS = 1 / 30.0;
  static_assert(OPERATIONS * HALF_ULP <= OPERATION_ROUNDINGS / DIGITS,
                "update the derivations of formulas in src/library/tree/batch/");
  /// Numerators and denominators at least this large have lost nothing to underflow.
  static constexpr float LEAST_PRODUCT = 0x1p-100f;
};

/// A spiral segment about the middle of its parameters.
struct Local_curve {
  Local_curve() = default;
  Local_curve(double first, double last, double unit) : middle(first + (last - first) / 2), half((last - first) / 2) {
    form.unit = unit;
  }

  int kind = 0;          ///< see curve_kind; 0: there is none
  double middle = 0;     ///< the parameter t expanded about
  double half = 0;       ///< the segment's half length
  double direction = 1;  ///< tau = direction (t - middle), and y may be mirrored, so that a > 0 and a r + d p > 0: the
                         ///< curve turns left, and curvature falls, as tau grows
  double mirror = 1;     ///< -1 where y is mirrored
  bool fits_float = false;  ///< products of figures in rough formulas are in the range of float
  Local_form<double> form;
};

/// Copies the numbers that a segment keeps of its local curve.
struct Stored_local_curve_access {
  // How many numbers are stored.
  [[nodiscard]] static constexpr int size(int kind) {
    return kind == 3 ? Stored_local_curve::OWN : (is_rational_kind(kind) ? 3 : 2) * degree_of_kind(kind);
  }

  // Calls copy with every stored number and its place in a local curve.
  template <class Curve, class Copy, class Stored, class Number>
  static void exchange(Curve& curve, Copy copy, Stored& stored, Number* number) {
    auto& form = curve.form;
    if (curve.kind == 3) exchange_numbers<3>(form.coefficients, copy, number);  // most are cubics: no switch, no call
    else for_kind(curve.kind, [&](auto kind) { exchange_numbers<kind()>(form.coefficients, copy, number); });
    auto* bound = stored.bounds_;
    for (auto* x : {&form.numerator_error, &form.least_dot, &form.least_square, &form.kneser_error,
                    &form.turn_rate_error, &form.least_tangent})
      copy(*bound++, *x);
  }
  template <int KIND, class Coefficients, class Copy, class Number>
  CGAL_BOUNDING_ARCS_INLINE static void exchange_numbers(Coefficients& c, Copy copy, Number* number) {
    for (int k = 1; k <= degree_of_kind(KIND); ++k) {
      copy(*number++, c.x[k]);
      copy(*number++, c.y[k]);
      if constexpr (is_rational_kind(KIND)) copy(*number++, c.w[k]);
    }
    if constexpr (KIND == 3) {
      for (auto& x : c.across) copy(*number++, x);
      for (auto& x : c.change) copy(*number++, x);
    }
  }
};

inline Stored_local_curve::Stored_local_curve(const Local_curve& curve) {
  using Access = Stored_local_curve_access;
  static_assert(MOST == std::max(2 * MAX_LOCAL_DEGREE, 3 * MAX_RATIONAL_DEGREE));
  if (Access::size(curve.kind) > OWN) beside_ = new Beside;
  Access::exchange(
      curve, [](double& stored, double x) { stored = x; }, *this, beside_ ? beside_->numbers : numbers_);
}

inline Stored_local_curve::Key Stored_local_curve::key(const Local_curve& curve) {
  const int flags = (curve.direction < 0 ? Key::REVERSED : 0) | (curve.mirror < 0 ? Key::MIRRORED : 0) |
                    (curve.fits_float ? Key::FITS_FLOAT : 0);
  return {static_cast<std::uint8_t>(curve.kind), static_cast<std::uint8_t>(flags)};
}

inline Segment_curve::operator Local_curve() const {
  using Key = Stored_local_curve::Key;
  Local_curve curve(first, last, unit);
  curve.kind = key.kind;
  curve.direction = (key.flags & Key::REVERSED) != 0 ? -1 : 1;
  curve.mirror = (key.flags & Key::MIRRORED) != 0 ? -1 : 1;
  curve.fits_float = (key.flags & Key::FITS_FLOAT) != 0;
  Stored_local_curve_access::exchange(
      curve, [](double stored, double& x) { x = stored; }, numbers,
      numbers.beside_ ? numbers.beside_->numbers : numbers.numbers_);
  curve.form.coefficients.set_middle(key.kind);
  curve.form.least_turn_rate = Local_precision<double>::TURN_RATE_DIGITS * curve.form.turn_rate_error;
  return curve;
}

}  // namespace CGAL::Bounding_arcs

#endif
