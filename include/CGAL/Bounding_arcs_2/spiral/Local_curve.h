// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// A spiral segment of a polynomial curve about its middle parameter in doubles, with bounds of all its rounding errors,
// and the chord shapes of its pieces from few operations and without branches.
//
// Figures of a piece.  Symbols are those of doc/numerics.md: c the chord, alpha0 and alpha1 the angles between it and
// the end tangents, delta half their difference, m half their sum, K_i = kappa_i c / 2; doc/symbols.md lists all. About
// the middle tau of a piece of half length s, where C = sum c_k sigma^k:
//   M = sum_{k odd} c_k s^(k-1)              the chord D is 2 s M
//   Z = sum_{k odd > 1} (k-1) c_k s^(k-3)    (T0 + T1) / 2 = M + s^2 Z
//   Y = sum_{k even} k c_k s^(k-2)           (T1 - T0) / 2 = s Y
// With a = M x Y, d = Z x M, r = Y.M, p = M.M + s^2 Z.M, up to powers of 2 s:
//   T0 x D = s (a + s d),  D x T1 = s (a - s d),  T0.D = p - s r,  T1.D = p + s r,
//   (T0 x D)(T1.D) - (D x T1)(T0.D) = 2 s^2 N,  N = a r + d p.
// So sin 2 delta = 2 s^2 N / (l0 l1) with l_i = |T_i| |M|: the thickness of every method is N times a factor, and in N
// no leading terms cancel.
//
// A segment's curve is taken mirrored, and reversed (Local_curve::direction), so that it turns left with its tight end
// first; on pieces beyond a vertex or inflection, which rounded ends of segments may leave, the signs that formulas ask
// for do not hold.

#ifndef CGAL_BOUNDING_ARCS_2_SPIRAL_LOCAL_CURVE_H
#define CGAL_BOUNDING_ARCS_2_SPIRAL_LOCAL_CURVE_H

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <initializer_list>

namespace CGAL::Bounding_arcs {

/// Largest degree of curves that have such a form.
inline constexpr int MAX_LOCAL_DEGREE = 5;

/// Taylor coefficients about the middle of a spiral segment. Of a cubic also those of a and d as polynomials in tau and
/// s^2, formed more accurately than in double.
template <class NT> struct Local_coefficients {
  NT x[MAX_LOCAL_DEGREE + 1], y[MAX_LOCAL_DEGREE + 1];
  NT across[4];  ///< a = across0 + across1 tau + across2 tau^2 + across3 s^2
  NT change[2];  ///< d = change0 + change1 tau
};

/// A spiral segment in one floating type: coefficients, and bounds that hold for all its pieces.
template <class Real> struct Local_form {
  Real unit = 1;  ///< of thickness, in units of the coefficients' lengths
  Local_coefficients<Real> coefficients{};
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
template <> struct Local_precision<double> {
  static constexpr double HALF_ULP = 0x1p-53;
  /// A figure may be this many times smaller than its segment's sizes, whose rounding errors it has, before it fails:
  /// near cusps and inflections.
  static constexpr double CANCELLATION = 0x1p20;
  static constexpr double DIGITS = 1 / (HALF_ULP * CANCELLATION), TURN_RATE_DIGITS = DIGITS;
  static_assert(DIGITS == 0x1p33, "the derivations of the series of filter/ count in parts of this");
  /// Relative error that the roundings of a batch's formula, and what its series leave out, add to the errors of
  /// numerator and knesers. Each formula has the sum of its own beside it.
  static constexpr double MOST_FACTORS = 16;  ///< no formula has more figures that are exact to 1 / DIGITS as factors
  static constexpr double ROUNDING = MOST_FACTORS / DIGITS;
  /// A figure this many times its error bound has a certain sign.
  static constexpr double CERTAIN = 0x1p14;
  /// The roundings of the formulas themselves: no more operations follow each other. Part of every sum in filter/.
  static constexpr double OPERATIONS = 200, OPERATION_ROUNDINGS = 0x1p-12;  ///< the latter in parts of 1 / DIGITS
  static_assert(OPERATIONS * HALF_ULP <= OPERATION_ROUNDINGS / DIGITS, "update the derivations of formulas in filter/");
  /// More than products near the least number lose of lengths, with the curve's own unit.
  static constexpr double UNDERFLOW_LENGTH = 0x1p-1000;
};
template <> struct Local_precision<float> {
  static constexpr double HALF_ULP = 0x1p-24;
  static constexpr double CANCELLATION = 0x1p11;  ///< the same, in float
  static constexpr float DIGITS = float(1 / (HALF_ULP * CANCELLATION)), CERTAIN = 0x1p8f;
  static_assert(DIGITS == 0x1p13f && DIGITS == 32 * CERTAIN,
                "the derivations of rough forms count in parts of this, with an epsilon of 32 rho");
  /// Turn rates, and a, have 8 rho: fewer digits, as next to an inflection they are small at every level.
  static constexpr float TURN_RATE_DIGITS = 0x1p10f;
  static constexpr double OPERATIONS = 60, OPERATION_ROUNDINGS = 1 / 30.0;
  static_assert(OPERATIONS * HALF_ULP <= OPERATION_ROUNDINGS / DIGITS, "update the derivations of formulas in filter/");
  /// Numerators and denominators at least this large have lost nothing to underflow.
  static constexpr float LEAST_PRODUCT = 0x1p-100f;
};

/// A spiral segment about the middle of its parameters.
struct Local_curve {
  Local_curve() = default;
  Local_curve(double first, double last, double unit) : middle(first + (last - first) / 2), half((last - first) / 2) {
    form.unit = unit;
  }

  int degree = 0;            ///< 3 for all degrees up to 3; 0: there is none, of rational curves and of high degrees
  double middle = 0;         ///< the parameter t expanded about
  double half = 0;           ///< the segment's half length
  double largest_chord = 0;  ///< M.M is at most about this for all pieces
  double direction = 1;  ///< tau = direction (t - middle), and y may be mirrored, so that a > 0 and a r + d p > 0: the
                         ///< curve turns left, and curvature falls, as tau grows
  double mirror = 1;     ///< -1 where y is mirrored
  Local_form<double> form;
};

/// A local curve as segments keep it: without what follows from the segment's ends and the rest.
class Stored_local_curve {
 public:
  Stored_local_curve() = default;
  explicit Stored_local_curve(const Local_curve& curve)
      : degree_(static_cast<std::uint8_t>(curve.degree)), direction_(curve.direction < 0 ? -1 : 1),
        mirror_(curve.mirror < 0 ? -1 : 1) {
    exchange(
        curve, [](double& stored, double x) { stored = x; }, *this);
  }

  /// \param first,last,unit those of the local curve that was stored
  [[nodiscard]] Local_curve local_curve(double first, double last, double unit) const {
    Local_curve curve(first, last, unit);
    curve.degree = degree_;
    curve.direction = direction_;
    curve.mirror = mirror_;
    exchange(
        curve, [](double stored, double& x) { x = stored; }, *this);
    Local_form<double>& form = curve.form;
    form.least_turn_rate = Local_precision<double>::TURN_RATE_DIGITS * form.turn_rate_error;
    // M is the mean of C' over the piece, and so in each coordinate at most its Taylor series with signs left away
    double x = 0, y = 0;
    for (int k = MAX_LOCAL_DEGREE; k > 0; --k) {
      x = k * std::fabs(form.coefficients.x[k]) + curve.half * x;
      y = k * std::fabs(form.coefficients.y[k]) + curve.half * y;
    }
    curve.largest_chord = x * x + y * y;
    return curve;
  }

 private:
  // Calls copy with every stored number and its place in a local curve.
  template <class Curve, class Copy, class Stored> static void exchange(Curve& curve, Copy copy, Stored& stored) {
    auto* number = stored.numbers_;
    auto& c = curve.form.coefficients;
    for (int k = 1; k <= stored.degree_; ++k) {
      copy(*number++, c.x[k]);
      copy(*number++, c.y[k]);
    }
    if (stored.degree_ == 3) {
      for (auto& x : c.across) copy(*number++, x);
      for (auto& x : c.change) copy(*number++, x);
    }
    auto& form = curve.form;
    number = stored.bounds_;
    for (auto* x : {&form.numerator_error, &form.least_dot, &form.least_square, &form.kneser_error,
                    &form.turn_rate_error, &form.least_tangent})
      copy(*number++, *x);
  }

  double numbers_[12] = {}, bounds_[6] = {};
  std::uint8_t degree_ = 0;
  std::int8_t direction_ = 1, mirror_ = 1;
};

/// The figures of a piece; names as above.
template <class NT> struct Local_piece {
  NT half;          ///< s
  NT square;        ///< s^2
  NT mx, my;        ///< M
  NT chord_square;  ///< M.M
  NT p, r, a, d;
  NT yx, yy, zx, zy;  ///< Y, Z
  NT zm;              ///< Z.M
};

/// What the two ends of a piece add for constructions that use their curvatures. With n_i = |T_i|, c = |M|:
///   K_i = s turn_rate_i c / n_i^3,
///   K0 - sin alpha0 = s^2 kneser0 / (n0^3 c),  sin alpha1 - K1 = s^2 kneser1 / (n1^3 c).
template <class NT> struct Local_ends {
  NT square0, square1;        ///< |T0|^2, |T1|^2
  NT turn_rate0, turn_rate1;  ///< T x T' there
  NT kneser0, kneser1;
};

/// Taylor coefficients 1 .. DEGREE moved by tau: Horner's scheme, once a coefficient.
template <std::size_t DEGREE, class NT>
[[gnu::always_inline]] inline void move_expansion(NT (&c)[DEGREE + 1], const NT& tau) {
#pragma GCC unroll 8
  for (std::size_t i = 0; i < DEGREE; ++i)
#pragma GCC unroll 8
    for (std::size_t k = DEGREE - 1; k >= (i > 1 ? i : 1); --k) c[k] = c[k] + tau * c[k + 1];
}

/// The piece of half length s about the parameter middle + tau.
template <int DEGREE, class NT>
[[nodiscard, gnu::always_inline]] inline Local_piece<NT> local_piece(const Local_coefficients<NT>& curve, const NT& tau,
                                                                     const NT& s) {
  const NT square = s * s;
  if constexpr (DEGREE == 3) {
    const NT slope_x = NT(3) * curve.x[3], slope_y = NT(3) * curve.y[3];
    const NT gx = tau * slope_x, gy = tau * slope_y, twice_x = curve.x[2] + curve.x[2],
             twice_y = curve.y[2] + curve.y[2];
    const NT yx = twice_x + (gx + gx), yy = twice_y + (gy + gy);
    const NT mx = (curve.x[1] + tau * (twice_x + gx)) + curve.x[3] * square;
    const NT my = (curve.y[1] + tau * (twice_y + gy)) + curve.y[3] * square;
    const NT mm = mx * mx + my * my;
    const NT zx = curve.x[3] + curve.x[3], zy = curve.y[3] + curve.y[3], zm = zx * mx + zy * my;
    return {s,
            square,
            mx,
            my,
            mm,
            mm + square * zm,
            yx * mx + yy * my,
            curve.across[0] + tau * (curve.across[1] + tau * curve.across[2]) + square * curve.across[3],
            curve.change[0] + curve.change[1] * tau,
            yx,
            yy,
            zx,
            zy,
            zm};
  } else {
    constexpr std::size_t SIZE = DEGREE + 1;
    NT cx[SIZE], cy[SIZE];
#pragma GCC unroll 8
    for (int k = 1; k <= DEGREE; ++k) {
      cx[k] = curve.x[k];
      cy[k] = curve.y[k];
    }
    move_expansion<DEGREE>(cx, tau);
    move_expansion<DEGREE>(cy, tau);
    constexpr int ODD = DEGREE % 2 == 1 ? DEGREE : DEGREE - 1, EVEN = DEGREE % 2 == 0 ? DEGREE : DEGREE - 1;
    NT mx = cx[ODD], my = cy[ODD], zx = NT(ODD - 1) * cx[ODD], zy = NT(ODD - 1) * cy[ODD];
#pragma GCC unroll 8
    for (int k = ODD - 2; k >= 1; k -= 2) {
      mx = cx[k] + square * mx;
      my = cy[k] + square * my;
    }
#pragma GCC unroll 8
    for (int k = ODD - 2; k >= 3; k -= 2) {
      zx = NT(k - 1) * cx[k] + square * zx;
      zy = NT(k - 1) * cy[k] + square * zy;
    }
    NT yx = NT(EVEN) * cx[EVEN], yy = NT(EVEN) * cy[EVEN];
#pragma GCC unroll 8
    for (int k = EVEN - 2; k >= 2; k -= 2) {
      yx = NT(k) * cx[k] + square * yx;
      yy = NT(k) * cy[k] + square * yy;
    }
    const NT mm = mx * mx + my * my, zm = zx * mx + zy * my;
    return {s,  square, mx, my, mm, mm + square * zm, yx * mx + yy * my, mx * yy - my * yx, zx * my - zy * mx,
            yx, yy,     zx, zy, zm};
  }
}

/// With V = 2 Z.M + Y.Y + s^2 Z.Z, W = 2 (r + s^2 Y.Z), upper signs at the start, and e_i = c4 -+ s c5, where c_k are
/// the coefficients about the middle:
///   |T_i|^2     = M.M + s^2 V -+ s W
///   turn_rate_i = T_i x T_i' = a +- 3 s d + 2 s^2 Y x Z + 8 s^2 T_i x e_i
///   kneser_i    = turn_rate_i (W -+ s V) + 2 |T_i|^2 (d +- s Y x Z +- 4 s T_i x e_i)
///   K_i = s turn_rate_i |M| / |T_i|^3
///   K0 - sin alpha0 = s^2 kneser_0 / (|T_0|^3 |M|),   sin alpha1 - K1 = s^2 kneser_1 / (|T_1|^3 |M|).
/// They follow from T_i = M + s^2 Z -+ s Y by expanding the products; kneser_i is that of a single piece's frame up to
/// s^2.
template <int DEGREE, class NT>
[[nodiscard, gnu::always_inline]] inline Local_ends<NT> local_ends(const Local_coefficients<NT>& curve, const NT& tau,
                                                                   const Local_piece<NT>& g) {
  const NT yz = g.yx * g.zx + g.yy * g.zy;
  const NT v = (g.zm + g.zm) + (g.yx * g.yx + g.yy * g.yy) + g.square * (g.zx * g.zx + g.zy * g.zy);
  const NT w = NT(2) * (g.r + g.square * yz), mean = g.chord_square + g.square * v, step = g.half * w, sv = g.half * v;
  const NT yz_cross = DEGREE == 3 ? NT(NT(0) - curve.change[1]) : NT(g.yx * g.zy - g.yy * g.zx);
  const NT mean_rate = g.a + (g.square + g.square) * yz_cross, sd = g.half * (NT(3) * g.d), third = g.half * yz_cross;
  Local_ends<NT> e{mean - step, mean + step, mean_rate + sd, mean_rate - sd, NT(0), NT(0)};
  NT third0 = g.d + third, third1 = g.d - third;
  if constexpr (DEGREE > 3) {
    const NT ex = DEGREE == 4 ? curve.x[4] : NT(curve.x[4] + NT(5) * tau * curve.x[5]);
    const NT ey = DEGREE == 4 ? curve.y[4] : NT(curve.y[4] + NT(5) * tau * curve.y[5]);
    const NT tx = g.mx + g.square * g.zx, ty = g.my + g.square * g.zy, ux = g.half * g.yx, uy = g.half * g.yy;
    const NT fx = g.half * curve.x[5], fy = g.half * curve.y[5];  // 0 for degree 4
    const NT cross0 = NT(4) * g.half * ((tx - ux) * (ey - fy) - (ty - uy) * (ex - fx));
    const NT cross1 = NT(4) * g.half * ((tx + ux) * (ey + fy) - (ty + uy) * (ex + fx));
    third0 = third0 + cross0;
    third1 = third1 - cross1;
    e.turn_rate0 = e.turn_rate0 + (g.half + g.half) * cross0;
    e.turn_rate1 = e.turn_rate1 + (g.half + g.half) * cross1;
  }
  e.kneser0 = e.turn_rate0 * (w - sv) + (e.square0 + e.square0) * third0;
  e.kneser1 = e.turn_rate1 * (w + sv) + (e.square1 + e.square1) * third1;
  return e;
}

}  // namespace CGAL::Bounding_arcs

#endif
