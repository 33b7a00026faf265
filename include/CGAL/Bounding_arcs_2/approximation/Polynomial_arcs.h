// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Arcs and biarcs over pieces of a polynomial spiral of fixed degree, in closed form: no sampling, no loops of unknown
// length.  What it does not bound tightly it leaves to arc_deviation.h (doc/arcs.md has the derivations).

#ifndef CGAL_BOUNDING_ARCS_2_APPROXIMATION_POLYNOMIAL_ARCS_H
#define CGAL_BOUNDING_ARCS_2_APPROXIMATION_POLYNOMIAL_ARCS_H

#include <CGAL/Bounding_arcs_2/approximation/arc_deviation.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <limits>

namespace CGAL::Bounding_arcs::internal {

/// The coefficients of a polynomial curve about s from those about 0.
template <std::size_t M>
[[nodiscard]] std::array<Xy<double>, M> shifted(std::array<Xy<double>, M> c, double s) {
  for (std::size_t i = 0; i + 1 < M; ++i)
    for (std::size_t k = M - 1; k-- > i;) c[k] = c[k] + s * c[k + 1];
  return c;
}

/// A polynomial curve of degree N about one of its points.
template <std::size_t N>
struct Taylor {
  std::array<Xy<double>, N + 1> c;           ///< c[0] is the point
  std::array<double, 2 * N + 1> square;      ///< coefficients of |sum over k > 0 of c[k] u^k|^2

  /// \param curve the coefficients about 0 \param s where to expand
  Taylor(const std::array<Xy<double>, N + 1>& curve, double s) : c(shifted(curve, s)), square{} {
    for (std::size_t i = 1; i <= N; ++i) {
      square[2 * i] += dot(c[i], c[i]);
      for (std::size_t j = 1; j < i; ++j) square[i + j] += 2 * dot(c[i], c[j]);
    }
  }

  /// The sum of sizes of the coefficients for a parameter h times as fast, from `origin`.
  [[nodiscard]] double reach(double h, const Xy<double>& origin) const {
    double sum = size_of(origin), power = h = std::fabs(h);
    for (std::size_t k = 1; k <= N; ++k, power *= h) sum += power * size_of(c[k]);
    return sum;
  }
};

/// cosine cross(chord, q) + sine (chord - q).q, zero where the chord's ends are seen from q under one angle, along
/// q = origin + the Taylor polynomial without its c[0], for a parameter h times as fast.
template <std::size_t N>
[[nodiscard]] std::array<double, 2 * N + 1> side_coefficients(const Taylor<N>& q, double h, const Xy<double>& origin,
                                                              const Xy<double>& chord, double cosine, double sine) {
  const Xy<double> turned = cosine * perp(chord), linear = turned + sine * (chord - 2.0 * origin);
  std::array<double, 2 * N + 1> f;
  f[0] = dot(turned + sine * (chord - origin), origin);
  double power = h;
  for (std::size_t k = 1; k <= 2 * N; ++k, power *= h) {
    f[k] = -sine * q.square[k];
    if (k <= N) f[k] += dot(linear, q.c[k]);
    f[k] *= power;
  }
  return f;
}

/// Where to join a biarc over the piece of length h from q: see biarc_joint_parameter; u in [0, 1].
/// \return nan where Halley's method from 1/2 does not stay inside
template <std::size_t N>
[[nodiscard]] double joint_parameter(const Taylor<N>& q, double h, const Xy<double>& chord, double cosine, double sine) {
  const auto f = side_coefficients<N>(q, h, {}, chord, cosine, sine);
  std::array<double, 2 * N - 1> g;  // f = u (1 - u) g
  g[0] = f[1];
  for (std::size_t k = 1; k < g.size(); ++k) g[k] = g[k - 1] + f[k + 1];
  constexpr double CLOSE = 0x1p-18;  // convergence is cubic: the step after one of this size would be below rounding
  constexpr int STEPS = 8;
  double u = 0.5;
  for (int i = 0; i < STEPS; ++i) {
    double value = g.back(), slope = 0, bend = 0;  // bend is half the second derivative
    for (std::size_t k = g.size() - 1; k-- > 0;) {
      bend = slope + u * bend;
      slope = value + u * slope;
      value = g[k] + u * value;
    }
    const double step = value * slope / (slope * slope - value * bend);
    u -= step;
    if (!(u > 0 && u < 1)) break;
    if (std::fabs(step) < CLOSE) return u;
  }
  return std::numeric_limits<double>::quiet_NaN();
}

/// What is known of the largest |f|.
struct Side_range {
  double lower, upper;  ///< lower is the value at one point, or at most that
};

/// At least the largest |side| in [0, 1], where f has roots at 0 (double) and 1 but for rounding: with
/// f = u^2 (1 - u) g and y = |u - 2/3|, u^2 (1 - u) <= 4/27 - y^2 / 3 and |g| <= A + B y + C y^2.
template <std::size_t M>
[[nodiscard]] Side_range largest_of_tangent(const std::array<double, M>& f) {
  constexpr double TOP = 2 / 3.0, HEIGHT = 4 / 27.0;
  double sum = 0, value = 0, slope = 0, bend = 0, power = 1, power_before = 0;
  for (std::size_t k = 0; k + 3 < M; ++k) {  // coefficients of g are the sums
    sum += f[k + 2];
    value += sum * power;
    slope += static_cast<double>(k) * sum * power_before;
    bend += static_cast<double>(k * (k - (k > 0 ? 1 : 0))) / 2 * std::fabs(sum);
    power_before = power;
    power *= TOP;
  }
  sum += f[M - 1];
  const double a = std::fabs(value), room = a / 3 - HEIGHT * bend;
  const double noise = std::fabs(f[0]) + std::fabs(f[1]) + std::fabs(sum), lower = HEIGHT * a - noise;
  if (!(room > 0)) return {lower, std::numeric_limits<double>::infinity()};
  return {lower, HEIGHT * a + HEIGHT * slope * (HEIGHT * slope) / (4 * room) + noise};
}

/// The even part of a polynomial about the middle of [-1/2, 1/2] at 1/12, the square of where x (1/4 - x^2) is largest.
template <std::size_t M>
[[nodiscard]] double even_at_extreme(const std::array<double, M>& f) {
  double value = f[M - 1];
  for (std::size_t k = M - 1; k >= 2; k -= 2) value = f[k - 2] + value / 12;
  return value;
}

/// At least the largest |side| in [-1/2, 1/2] where f has roots at both ends but for rounding: with X = 1/sqrt(12),
/// f = (1/4 - x^2) (g0 + g1 x + (x^2 - 1/12) r(x)), y = |x| - X, x (1/4 - x^2) <= X/6 - 2 X y^2 and
/// (1/4 - x^2) (|x| + X) <= K.
template <std::size_t M>
[[nodiscard]] Side_range largest_of_balanced(const std::array<double, M>& f) {
  constexpr double X = 0.28867513459481288, K = 0.1028;
  // Division of the even and the odd part, in x^2, by 1/4 - x^2 and then by x^2 - 1/12; from the highest power down.
  double g[2] = {0, 0}, ends = 0, rest = 0;
  for (std::size_t parity = 0; parity < 2; ++parity) {
    double above = 0, above_rest = 0, power = 1;
    const std::size_t top = (M - 1) % 2 == parity ? M - 1 : M - 2;
    std::array<double, M / 2 + 1> quotient{};
    std::size_t n = 0;
    for (std::size_t k = top; k >= 2; k -= 2) {
      above = above / 4 - f[k];
      quotient[n++] = above;  // of x^(k - 2)
    }
    ends += std::fabs(f[parity] - (n > 0 ? quotient[n - 1] / 4 : 0));
    for (std::size_t i = 0; i + 1 < n; ++i) {
      above_rest = quotient[i] + above_rest / 12;
      power = 1;
      for (std::size_t k = 0; k < 2 * (n - 2 - i) + parity; ++k) power /= 2;
      rest += std::fabs(above_rest) * power;
    }
    g[parity] = n > 0 ? quotient[n - 1] + above_rest / 12 : 0;
  }
  const double a = std::fabs(g[1]);
  const double noise = std::fabs(g[0]) / 4 + ends;
  return {a * X / 6 - noise, a * X / 6 + rest * K * (rest * K) / (8 * X * a) + noise};
}

/// An arc over a piece and at least the largest distance between the two: infinity where the bound is loose, but where the
/// distance surely exceeds `limit` only some number above that.
struct Fitted_arc {
  double bulge = 0, distance = std::numeric_limits<double>::infinity();

  void set_distance(const Side_range& side, double chord, double reach, std::size_t n, double limit) {
    constexpr double TIGHT = 1.02, NEAR = 1.25;  // of arcs within the limit and no reason for more of them, NEAR will do
    const double square = 1 + bulge * bulge;
    if (side.upper <= NEAR * side.lower) distance = distance_from_side(side.upper, chord, bulge, reach, 1, n);
    if (side.upper <= TIGHT * side.lower || distance <= limit) return;
    const double least = side.lower / (chord * square);
    distance = least > 1.05 * limit ? least : std::numeric_limits<double>::infinity();
  }
};

/// A tangent and its length.
struct Direction {
  Xy<double> tangent;
  double length;
};

/// Whether an arc's feet move forwards for any curve that runs in the box of the chord's ends with tangents between two:
/// the arc's concentric circles run along (1 - bulge^2) chord + 4 bulge perp(q - chord / 2) at q, and q is within chord / 2
/// of the middle. Sufficient only.
[[nodiscard]] inline bool foot_surely_moves_forwards(const Xy<double>& chord, double c, double bulge, const Direction& t0,
                                                     const Direction& t1) {
  const double straight = 1 - bulge * bulge, bent = 2.0625 * std::fabs(bulge) * c;  // 1/32 more than needed, for rounding
  return straight * dot(chord, t0.tangent) > bent * t0.length && straight * dot(chord, t1.tangent) > bent * t1.length;
}

/// The arc of a biarc over the piece of length h from q, where both have the tangent `own`; `other` is that of the curve at
/// the biarc's other end.
template <std::size_t N>
[[nodiscard]] Fitted_arc tangent_arc(const Taylor<N>& q, double h, const Xy<double>& chord, const Direction& own,
                                     const Direction& other, double limit) {
  const double c = std::sqrt(dot(chord, chord));
  Fitted_arc arc;
  arc.bulge = cross(own.tangent, chord) / (own.length * c + dot(own.tangent, chord));
  if (!foot_surely_moves_forwards(chord, c, arc.bulge, own, other)) return arc;
  const auto f = side_coefficients<N>(q, h, {}, chord, 1 - arc.bulge * arc.bulge, 2 * arc.bulge);
  arc.set_distance(largest_of_tangent(f), c, q.reach(h, {}), N + 1, limit);
  return arc;
}

/// The balanced arc over the piece of length h about q, whose point is at `middle` seen from the piece's start.
template <std::size_t N>
[[nodiscard]] Fitted_arc balanced_arc(const Taylor<N>& q, double h, const Xy<double>& middle, const Xy<double>& chord,
                                      const Direction& start, const Direction& end, double limit) {
  const double c = std::sqrt(dot(chord, chord));
  auto f = side_coefficients<N>(q, h, middle, chord, 1, 0);
  const auto b = side_coefficients<N>(q, h, middle, chord, 0, 1);
  const double lambda = -even_at_extreme(f) / even_at_extreme(b);
  Fitted_arc arc;
  arc.bulge = lambda / (1 + std::sqrt(1 + lambda * lambda));
  if (!foot_surely_moves_forwards(chord, c, arc.bulge, start, end)) return arc;
  for (std::size_t k = 0; k < f.size(); ++k) f[k] = (1 - arc.bulge * arc.bulge) * f[k] + 2 * arc.bulge * b[k];
  arc.set_distance(largest_of_balanced(f), c, q.reach(h, middle), N + 1, limit);
  return arc;
}

}  // namespace CGAL::Bounding_arcs::internal

#endif
