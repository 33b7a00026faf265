// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// How near two arcs come at least, without centers.
//
// Let G be the form of arc b whose zeros are its circle, d = 2 G / (A + |w|) the distance from it, A = (1 + b^2) L and
// |w|^2 = A^2 - 8 b G, grad G = -w (arc/Arc_2.h).  Arc a of length-L' chord, that turns by 2 phi, c = cos phi, is a
// rational quadratic with weights 1, c, 1 and the derivative L' T at its ends, T the unit tangents.  On a circle G is
// linear but for a constant, on a line it is quadratic, so that in both cases
//   G(a(x)) = (G0 (1-x)^2 + 2 G1 x (1-x) + G2 x^2) / ((1-x)^2 + 2 c x (1-x) + x^2),  G1 = c G0 - e,  e = w.(L' T) / 2.
// Say 0 < G0 <= G2; else the other end is first, or G has another sign or two.  G falls from there iff e > 0, and then
// its least is G0 - y, where the numerator less (G0 - y) times the denominator has a double zero, (c y - e)^2 =
// y (y + G2 - G0):
//   y = 2 e^2 / (p + sqrt(p^2 + 4 sin^2 phi e^2)),   p = G2 - G0 + 2 c e,
// with no difference of numbers that are nearly equal but G2 - G0.
//
// Error.  Let r be the largest distance of ends of a from ends of b: L, L' <= 2 r.  G errs by (6 L r + 10 |b| r^2) u
// and u |G| <= (L + 2 |b| r) r u; w by (12 |b| r + 3 L + 3 |w|) u with |w| <= 4 |b| r + L, L' T by 10 u L', which makes
// e err by (50 |b| r^2 + 18 L r) u; all of that together by less than (25 L r + 65 |b| r^2) u =: v in each coefficient.
// As the denominator is at least 1/2, so much moves the least of G by 2 v, and y, 10 u of itself and no larger than L'
// |w| (e <= L' |w| / 2 and y <= e / c or e / sin phi), by less than v.  Roundings of d are rounded towards 0.

#ifndef CGAL_BOUNDING_ARCS_2_ARC_ARC_PAIR_H
#define CGAL_BOUNDING_ARCS_2_ARC_ARC_PAIR_H

#include <CGAL/Bounding_arcs_2/arc/Arc_2.h>

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace CGAL::Bounding_arcs {

namespace internal {
/// What both ways of a pair of arcs have in common of one of them.
struct Arc_form {
  Xy<double> chord;
  double length, cosine, sine;
  Xy<double> tangents[2];  ///< of the length of the chord
  explicit Arc_form(const Arc_2& arc) : chord(arc.to - arc.from), length(euclidean_norm(chord)) {
    const double b = arc.bulge, scale = 1 / (1 + b * b);
    cosine = (1 - b * b) * scale;
    sine = 2 * b * scale;
    tangents[0] = cosine * chord - sine * perp(chord);
    tangents[1] = cosine * chord + sine * perp(chord);
  }
};

/// A lower bound of the distance of arc a from all of the circle of b.
/// \param farthest at least the distance of an end of one from an end of the other
[[nodiscard]] inline double least_distance_to_circle(const Arc_2& a, const Arc_form& of_a, const Arc_2& b,
                                                     const Arc_form& of_b, double farthest) {
  const double twice = 2 * b.bulge, m = 1 - b.bulge * b.bulge;
  const Xy<double> ends[2] = {a.from, a.to};
  double g[2];
  for (std::size_t i = 0; i < 2; ++i) {
    const Xy<double> u0 = ends[i] - b.from, u1 = ends[i] - b.to;
    g[i] = m * cross(of_b.chord, u0) - twice * dot(u0, u1);
  }
  if (!(g[0] * g[1] > 0)) return 0;
  const double sign = g[0] < 0 ? -1 : 1;
  const std::size_t end = sign * g[1] < sign * g[0] ? 1 : 0;
  const Xy<double> w = twice * ((ends[end] - b.from) + (ends[end] - b.to)) - m * perp(of_b.chord);
  const double e = (end == 0 ? 0.5 : -0.5) * sign * dot(w, of_a.tangents[end]);
  double least = sign * g[end];
  if (e > 0) {
    const double p = sign * (g[1 - end] - g[end]) + 2 * of_a.cosine * e, q = 2 * of_a.sine * e;
    least -= 2 * e * e / (p + std::sqrt(p * p + q * q));
  }
  constexpr double OF_FORM = 3 * 25 * HALF_ULP, OF_BULGE = 3 * 65 * HALF_ULP, UP = ROUNDED_UP<16>;
  least -= (OF_FORM * of_b.length + OF_BULGE * std::fabs(b.bulge) * farthest) * farthest;
  if (!(least > 0)) return 0;
  const double whole = (1 + b.bulge * b.bulge) * of_b.length, square = whole * whole, part = 4 * twice * sign * least;
  const double apart = (square - part) + 16 * HALF_ULP * (square + std::fabs(part));
  return 2 * least / ((whole + std::sqrt((std::max)(0.0, apart))) * UP);
}

/// Whether the boxes of two spirals over the chords of arcs are apart by more than room: spirals are monotone in both
/// coordinates.
[[nodiscard]] inline bool are_boxes_apart(const Arc_2& a, const Arc_2& b, double room) {
  const auto apart = [room](double p, double q, double r, double s) {
    const double size = (std::max)(std::fabs(p), std::fabs(r));
    const double slack = room + 4 * HALF_ULP * (size + room);
    return (std::min)(p, q) - (std::max)(r, s) > slack || (std::min)(r, s) - (std::max)(p, q) > slack;
  };
  return apart(a.from.x, a.to.x, b.from.x, b.to.x) || apart(a.from.y, a.to.y, b.from.y, b.to.y);
}
}  // namespace internal

}  // namespace CGAL::Bounding_arcs

#endif
