// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Arcs and biarcs over pieces of a polynomial spiral of degree up to 3, in closed form: no sampling, no branches, so
// that loops over many pieces run in SIMD registers.  What it does not bound tightly it leaves to arc_deviation.h
// (doc/arcs.md has the derivations).

#ifndef BOUNDING_ARCS_LIBRARY_CHAIN_CUBIC_ARCS_H
#define BOUNDING_ARCS_LIBRARY_CHAIN_CUBIC_ARCS_H

#include <CGAL/Bounding_arcs_2/number/Bracket.h>
#include <CGAL/Bounding_arcs_2/number/strict_math.h>
#include <CGAL/Bounding_arcs_2/tree/Build_options.h>
#include "../tree/Instruction_sets.h"

#include <cmath>

/// How fast what is put over a short piece of curve comes near to it:
/// h^3 |dkappa/ds| times one of these is the measure of a short piece of length h; N*(eps) = (factor / eps)^(1/3) times
/// slope_integral pieces is the least number as eps goes to 0.  Derived in doc/arcs.md.
namespace CGAL::Bounding_arcs::cubic_factor {

inline constexpr double BCA = 1 / 24.0, SPIRAL_FAT_ARC = 1 / 6.0, BILENS = 1 / 48.0;  // thickness
inline constexpr double ARC = 1 / 124.70765814495915;                          // 72 sqrt(3): balanced arc, distance
inline constexpr double BIARC = 1 / 324.0;                                     // balanced biarc, distance
inline constexpr double ONE_SIDED_ARC = 2 / 81.0, ONE_SIDED_BIARC = 1 / 96.0;  // boundaries of BCA and bilens

}  // namespace CGAL::Bounding_arcs::cubic_factor

namespace CGAL::Bounding_arcs::internal {

/// Xy<double> for code that is compiled for several instruction sets: all of it has to be inlined there.
struct Plane_vector {
  double x, y;

  CGAL_BOUNDING_ARCS_INLINE friend Plane_vector operator-(Plane_vector p, Plane_vector q) {
    return {p.x - q.x, p.y - q.y};
  }
  CGAL_BOUNDING_ARCS_INLINE friend Plane_vector operator*(double s, Plane_vector p) { return {s * p.x, s * p.y}; }
  CGAL_BOUNDING_ARCS_INLINE friend double cross(Plane_vector p, Plane_vector q) { return p.x * q.y - p.y * q.x; }
  CGAL_BOUNDING_ARCS_INLINE friend double dot(Plane_vector p, Plane_vector q) { return p.x * q.x + p.y * q.y; }
  CGAL_BOUNDING_ARCS_INLINE friend double size_of(Plane_vector p) { return std::fabs(p.x) + std::fabs(p.y); }
};

/// c1 u + c2 u^2 + c3 u^3. Members are numbers, as compilers keep no nested structures in registers.
struct Cubic {
  double x1, y1, x2, y2, x3, y3;

  CGAL_BOUNDING_ARCS_INLINE Plane_vector c1() const { return {x1, y1}; }
  CGAL_BOUNDING_ARCS_INLINE Plane_vector c2() const { return {x2, y2}; }
  CGAL_BOUNDING_ARCS_INLINE Plane_vector c3() const { return {x3, y3}; }
  CGAL_BOUNDING_ARCS_INLINE Plane_vector operator()(double u) const {
    return {u * (x1 + u * (x2 + u * x3)), u * (y1 + u * (y2 + u * y3))};
  }
  /// Returns the curve seen from its place at u.
  CGAL_BOUNDING_ARCS_INLINE Cubic from(double u) const {
    const double x = u * x3, y = u * y3;
    return {x1 + u * (2 * x2 + 3 * x), y1 + u * (2 * y2 + 3 * y), x2 + 3 * x, y2 + 3 * y, x3, y3};
  }
  /// The sum of sizes of the coefficients for a parameter h times as fast, h >= 0.
  CGAL_BOUNDING_ARCS_INLINE double reach(double h) const {
    return h * (size_of(c1()) + h * (size_of(c2()) + h * size_of(c3())));
  }
};

/// The coefficients of |cubic|^2.
struct Squares {
  double s2, s3, s4, s5, s6;
};
[[nodiscard]] CGAL_BOUNDING_ARCS_INLINE Squares squares(const Cubic& q) {
  const Plane_vector c1 = q.c1(), c2 = q.c2(), c3 = q.c3();
  return {dot(c1, c1), 2 * dot(c1, c2), dot(c2, c2) + 2 * dot(c1, c3), 2 * dot(c2, c3), dot(c3, c3)};
}

/// Where to join a biarc over the piece of length h that starts at q: a parameter u in [0, 1] whose point sees the
/// chord under half the turn from there to `end`, the same curve seen from the piece's end.
/// \return nan where Halley's method from 1/2 does not arrive inside
[[nodiscard]] CGAL_BOUNDING_ARCS_INLINE double joint_parameter(const Cubic& q, const Cubic& end, double h,
                                                               Plane_vector chord) {
  const Squares s = squares(q);
  const Plane_vector t0 = q.c1(), t1 = end.c1();
  const double cosine = std::sqrt(s.s2) * std::sqrt(dot(t1, t1)) + dot(t0, t1), sine = cross(t0, t1);
  // cosine cross(chord, q) + sine (chord - q).q = u (1 - u) (g0 + g1 u + ...)
  const Plane_vector linear{sine * chord.x - cosine * chord.y, sine * chord.y + cosine * chord.x};
  const double h2 = h * h, h3 = h2 * h;
  const double g0 = h * dot(linear, q.c1());
  const double g1 = g0 + h2 * (dot(linear, q.c2()) - sine * s.s2);
  const double g2 = g1 + h3 * (dot(linear, q.c3()) - sine * s.s3);
  const double g3 = g2 - h2 * h2 * (sine * s.s4), g4 = g3 - h2 * h3 * (sine * s.s5);
  constexpr double CLOSE = 0x1p-18;  // convergence is cubic: the step after one of this size would be below rounding
  constexpr int STEPS = 3;           // one more than most need
  double u = 0.5, step = 0;
#pragma GCC unroll 3
  for (int i = 0; i < STEPS; ++i) {
    const double a3 = g3 + u * g4, a2 = g2 + u * a3, a1 = g1 + u * a2, value = g0 + u * a1;
    const double b3 = a3 + u * g4, b2 = a2 + u * b3, slope = a1 + u * b2;
    const double half_bend = b2 + u * (b3 + u * g4);
    step = value * slope / (slope * slope - value * half_bend);
    u -= step;
  }
  return ((u > 0) & (u < 1) & (std::fabs(step) < CLOSE)) ? u : std::nan("");
}

/// An arc over a piece and at least the largest distance between the two: infinity where the bound is loose, but where
/// the distance surely exceeds the limit asked for only some number above that.
struct Fitted_arc {
  double bulge, distance;
};

/// An upper bound of the largest distance from a circle of curvature `curvature`, or what Fitted_arc has instead of it.
/// \param h of the largest height of a piece over the circle: its distance d times 1 - d / (2 radius), d positive
///   inside. The lower bound is the height at one point, or at most that
/// \param reach the sum of |coefficients| of the piece; \param inverse of the chord's length
[[nodiscard]] CGAL_BOUNDING_ARCS_INLINE double distance_from_height(const Bracket& h, double curvature, double reach,
                                                                    double inverse, double limit) {
  constexpr double TIGHT = 1.02, NEAR = 1.25;  // of arcs within the limit and no reason for more of them, NEAR will do
  constexpr double ROUNDING = 64 * HALF_ULP;   // see doc/arcs.md
  constexpr double SURELY = 1.05;              // for what tells heights from distances
  const double height = h.upper + ROUNDING * reach * (2 + reach * inverse), bend = 2 * std::fabs(curvature) * height;
  const double distance = height * (1 + bend) * (1 + ROUNDING);  // 1 + bend for 1 / (1 - bend / 2)
  const bool is_tight = (h.upper <= TIGHT * h.lower) & (bend < 1);
  const bool will_do = (h.upper <= NEAR * h.lower) & (bend < 1) & (distance <= limit);
  return (is_tight | will_do) ? distance : (h.lower > SURELY * limit ? h.lower : HUGE_VAL);
}

/// An upper bound of the largest |f|, f = f2 u^2 + ... + f6 u^6 on [0, 1] with a root at 1 but for rounding: with
/// f = u^2 (1 - u) g and y = |u - 2/3|, u^2 (1 - u) <= 4/27 - y^2 / 3 and |g| <= A + B y + C y^2.
[[nodiscard]] CGAL_BOUNDING_ARCS_INLINE Bracket largest_of_tangent(double f2, double f3, double f4, double f5,
                                                                   double f6) {
  constexpr double TOP = 2 / 3.0, HEIGHT = 4 / 27.0;
  const double g1 = f2 + f3, g2 = g1 + f4, g3 = g2 + f5, rest = g3 + f6;  // g0 = f2
  const double a = std::fabs(f2 + TOP * (g1 + TOP * (g2 + TOP * g3))),
               b = HEIGHT * (g1 + TOP * (2 * g2 + 3 * TOP * g3));
  const double room = a / 3 - HEIGHT * (std::fabs(g2) + 3 * std::fabs(g3)), noise = std::fabs(rest);
  return {HEIGHT * a - noise, room > 0 ? HEIGHT * a + b * b / (4 * room) + noise : HUGE_VAL};
}

/// Feet on an arc move forwards where its concentric circles, anywhere within |chord| / 2 of the chord's middle, make
/// acute angles with the tangents t at both ends (doc/arcs.md). With psi the angle of chord and arc at its ends, that
/// is so where cos(psi) chord.t > sin(psi) |chord| |t|. The margin is for rounding; it refuses no arc of use.
inline constexpr double FOOT_MARGIN = 1 + 1 / 32.0;

/// The arc of a biarc over a piece that runs from `own` by the parameter h, backwards if that is negative, to the
/// biarc's joint at `chord`; both have the tangent of `own`. `other` is the curve's at the biarc's other end.
/// \param forward the sign of h
/// The bulge is that of the arc in the curve's direction.
[[nodiscard]] CGAL_BOUNDING_ARCS_INLINE Fitted_arc tangent_arc(const Cubic& own, Plane_vector other, double h,
                                                               double forward, Plane_vector chord, double limit) {
  const Squares s = squares(own);
  const double length = std::sqrt(s.s2), scale = 1 / length, length_other = std::sqrt(dot(other, other));
  const double square = dot(chord, chord), c = std::sqrt(square), inverse = 1 / square;
  const double across = cross(own.c1(), chord), along = forward * dot(own.c1(), chord);
  const double along_other = forward * dot(other, chord);
  const double bent = FOOT_MARGIN * std::fabs(across) * c;
  const bool moves_forwards =
      (along > 0) & (along * along > bent * length) & (along * along_other > bent * length_other);
  // cross(c1, q) - k |q|^2 is zero on the circle: |c1| times the height over it
  const double k = across * inverse, h2 = h * h, h3 = h2 * h, scale2 = scale * h2, scale3 = scale * h3;
  const double f2 = scale2 * (cross(own.c1(), own.c2()) - k * s.s2),
               f3 = scale3 * (cross(own.c1(), own.c3()) - k * s.s3);
  const double f4 = -scale2 * h2 * (k * s.s4), f5 = -scale3 * h2 * (k * s.s5), f6 = -scale3 * h3 * (k * s.s6);
  const Bracket range = largest_of_tangent(f2, f3, f4, f5, f6);
  const double distance = distance_from_height(range, 2 * k * scale, own.reach(forward * h), inverse * c, limit);
  return {across / (length * c + along), moves_forwards ? distance : HUGE_VAL};
}

/// An upper bound of the largest |f|, f = f0 + ... + f6 x^6 on [-1/2, 1/2] with roots at both ends but for rounding:
/// with X = 1/sqrt(12), f = (1/4 - x^2) (g0 + g1 x + (x^2 - 1/12) r(x)), y = |x| - X, x (1/4 - x^2) <= X/6 - 2 X y^2
/// and (1/4 - x^2) (|x| + X) <= K.
[[nodiscard]] CGAL_BOUNDING_ARCS_INLINE Bracket largest_of_balanced(double f0, double f1, double f2, double f3,
                                                                    double f4, double f5, double f6) {
  constexpr double X = 0.28867513459481288, K = 0.1028;
  // the quotients of the even and of the odd part by 1/4 - x^2
  const double p4 = -f6, p2 = p4 / 4 - f4, p0 = p2 / 4 - f2, p3 = -f5, p1 = p3 / 4 - f3;
  const double ends = std::fabs(f0 - p0 / 4) + std::fabs(f1 - p1 / 4);
  // and of those by x^2 - 1/12: r = r0 + p3 x + p4 x^2
  constexpr double TWELFTH = 1 / 12.0;
  const double r0 = p2 + p4 * TWELFTH, g0 = p0 + r0 * TWELFTH, g1 = std::fabs(p1 + p3 * TWELFTH);
  const double rest = K * (std::fabs(r0) + std::fabs(p3) / 2 + std::fabs(p4) / 4), noise = std::fabs(g0) / 4 + ends;
  return {g1 * (X / 6) - noise, g1 * (X / 6) + rest * rest / (8 * X * g1) + noise};
}

/// The balanced arc over the piece [s0, s1] of `curve`, whose ends are `chord` apart.
[[nodiscard]] CGAL_BOUNDING_ARCS_INLINE Fitted_arc balanced_arc(const Cubic& curve, double s0, double s1,
                                                                Plane_vector chord, double limit) {
  const double middle = (s0 + s1) / 2, h = s1 - s0;
  const Plane_vector c0 = curve(middle) - curve(s0), t0 = curve.from(s0).c1(), t1 = curve.from(s1).c1();
  const Cubic q = curve.from(middle);
  const Squares s = squares(q);
  const double h2 = h * h, h3 = h2 * h, h4 = h2 * h2;
  // f + lambda b is zero on the circle that makes an angle of tangent lambda with the chord
  const Plane_vector along = chord - 2.0 * c0;
  const double f0 = cross(chord, c0), b0 = dot(chord - c0, c0);
  const double f1 = h * cross(chord, q.c1()), b1 = h * dot(along, q.c1());
  const double f2 = h2 * cross(chord, q.c2()), b2 = h2 * (dot(along, q.c2()) - s.s2);
  const double f3 = h3 * cross(chord, q.c3()), b3 = h3 * (dot(along, q.c3()) - s.s3);
  const double b4 = -h4 * s.s4, b5 = -h4 * h * s.s5, b6 = -h3 * h3 * s.s6;
  // even parts where x (1/4 - x^2) is largest, x^2 = 1/12
  constexpr double TWELFTH = 1 / 12.0;
  const double lambda = -(f0 + f2 * TWELFTH) / (b0 + (b2 + (b4 + b6 * TWELFTH) * TWELFTH) * TWELFTH);
  const double square = dot(chord, chord), secant = std::sqrt(1 + lambda * lambda), c = std::sqrt(square);
  const double bent = FOOT_MARGIN * lambda * c, bent2 = bent * bent, along0 = dot(chord, t0), along1 = dot(chord, t1);
  const double square0 = dot(t0, t0), square1 = dot(t1, t1);
  const bool moves_forwards =
      (along0 > 0) & (along1 > 0) & (along0 * along0 > bent2 * square0) & (along1 * along1 > bent2 * square1);
  const double inverse = 1 / c, scale = inverse / secant, turned = scale * lambda;
  const Bracket range =
      largest_of_balanced(scale * (f0 + lambda * b0), scale * (f1 + lambda * b1), scale * (f2 + lambda * b2),
                          scale * (f3 + lambda * b3), turned * b4, turned * b5, turned * b6);
  const double distance = distance_from_height(range, 2 * turned, q.reach(h / 2) + size_of(c0), inverse, limit);
  return {lambda / (1 + secant), moves_forwards ? distance : HUGE_VAL};
}

/// Up to 64 pieces of spiral segments, of one or of many, and the arcs over them, in columns.  The loops are plain;
/// compiled for wider registers (src/library/chain/arc_loops.cpp) they give the same bits, as each operation rounds by
/// itself.
struct Arc_columns {
  static constexpr std::size_t SIZE = 64;
  using Column = double[SIZE];

  std::size_t count = 0;
  // The segment: its curve is start + unit (c1 s + c2 s^2 + c3 s^3), s in [0, 1], but `end` at 1.
  Column x1, y1, x2, y2, x3, y3, start_x, start_y, end_x, end_y, unit, inverse_unit;
  Column limit;   ///< the largest distance asked for, in units
  Column s0, s1;  ///< the piece
  // The arcs; of balanced ones only the first.
  Column from_x, from_y, joint_x, joint_y, to_x, to_y, joint, bulge0, bulge1;
  Column distance0, distance1;  ///< in units, as in Fitted_arc
};

/// Biarcs over all pieces, and over what follows up to a multiple of 8, where nobody reads them; balanced arcs in the
/// same way. Compiled for each instruction set (arc_loops.cpp).
template <class Isa> void fit_biarcs(Arc_columns& columns);
template <class Isa> void fit_balanced(Arc_columns& columns);

using Arc_function = void (*)(Arc_columns&);

/// The loops of one kind.
[[nodiscard]] inline Arc_function arc_function(bool are_biarcs, Build_options::Instruction_set set) {
  return function_for(set,
                      [&](auto isa) { return are_biarcs ? &fit_biarcs<decltype(isa)> : &fit_balanced<decltype(isa)>; });
}

}  // namespace CGAL::Bounding_arcs::internal

#endif
