// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Where two arcs cross, without centers.
//
// The arc f from F with the chord D and the bulge b, m = exp(2 i atan b), runs through
//   q(v) = F + v D / g,  g = v + (1 - v) m,  v from 0 to 1,  |g|^2 = (1 - v)^2 + 2 Re(m) v (1 - v) + v^2,
// a Moebius map that takes 0 and 1 to the ends.  With side(q), whose zeros are the circle of e (arc/Arc_2.h), the
// product side(q(v)) |g|^2 is quadratic in v: side is |q|^2 and linear terms, and |q - F|^2 = v^2 |D|^2 / |g|^2.  Its
// Bernstein coefficients are side(F), c1 and side(T), T the other end, with
//   2 c1 = 2 Re(m) side(F) + G.(D conj m),  G = grad side(F) = (1 - b_e^2) perp(D_e) - 2 b_e ((F - A) + (F - B)).
// The outer ones are the same bits for two arcs f that meet, so that a chain of arcs crosses a circle once, not never
// and not twice, where its ends are on different sides.  Flat arcs and segments need nothing else.

#ifndef BOUNDING_ARCS_LIBRARY_ARC_ARC_CROSSINGS_H
#define BOUNDING_ARCS_LIBRARY_ARC_ARC_CROSSINGS_H

#include <CGAL/Bounding_arcs_2/arc/Arc_2.h>

#include <algorithm>
#include <cmath>

namespace CGAL::Bounding_arcs {

/// A common point of two arcs e and f.
struct Arc_crossing {
  double u, v;      ///< Moebius parameters on e and f
  bool f_to_right;  ///< f runs from the left of e to its right there
};
/// Up to two points in which two arcs cross.
struct Arc_crossings {
  Arc_crossing at[2];
  int count = 0;
  /// Rounding decides whether and how they meet: on one circle, touching, or at an end of one of them.
  bool is_doubtful = false;
};

[[nodiscard]] inline double side_of_circle(const Xy<double>& q, const Arc_2& arc) {
  const Xy<double> chord = arc.to - arc.from, u0 = q - arc.from, u1 = q - arc.to;
  return (1 - arc.bulge * arc.bulge) * cross(chord, u0) - 2 * arc.bulge * dot(u0, u1);
}

/// The unit vector m of an arc.
[[nodiscard]] inline Xy<double> moebius_turn(const Arc_2& arc) {
  const double b = arc.bulge, scale = 1 / (1 + b * b);
  return {(1 - b * b) * scale, 2 * b * scale};
}
[[nodiscard]] inline Xy<double> moebius_point(const Arc_2& arc, double v) {
  if (v <= 0) return arc.from;
  if (v >= 1) return arc.to;
  const Xy<double> m = moebius_turn(arc), d = arc.to - arc.from;
  const Xy<double> g{v + (1 - v) * m.x, (1 - v) * m.y};
  const double scale = v / dot(g, g);
  return arc.from + Xy<double>{scale * (d.x * g.x + d.y * g.y), scale * (d.y * g.x - d.x * g.y)};
}
/// The parameter of a point of the arc's circle: v (D - z + z m) = z m, z = q - F.
[[nodiscard]] inline double moebius_parameter(const Arc_2& arc, const Xy<double>& q) {
  const Xy<double> m = moebius_turn(arc), d = arc.to - arc.from, z = q - arc.from;
  const Xy<double> zm{z.x * m.x - z.y * m.y, z.x * m.y + z.y * m.x}, n = d - z + zm;
  return dot(zm, n) / dot(n, n);
}
/// The bulge of the part of an arc from u to v: it turns by the share of the angle, and an angle seen from the circle
/// is half of that at the center.  arg g(v) - arg g(u) is the angle between the chords from the start.
[[nodiscard]] inline double bulge_between(const Arc_2& arc, double u, double v) {
  if (arc.bulge == 0 || (u <= 0 && v >= 1)) return arc.bulge;
  const Xy<double> m = moebius_turn(arc);
  const Xy<double> g{u + (1 - u) * m.x, (1 - u) * m.y}, h{v + (1 - v) * m.x, (1 - v) * m.y};
  return std::tan(std::atan2(cross(h, g), dot(g, h)) / 2);
}

/// The Bernstein coefficients of side(q(v)) |g|^2, of the circle of e along f.
struct Side_along {
  double c0, c1, c2;
};
[[nodiscard]] inline Side_along side_along(const Arc_2& e, const Arc_2& f) {
  const Xy<double> d = f.to - f.from, m = moebius_turn(f), chord = e.to - e.from;
  const double c0 = side_of_circle(f.from, e), c2 = side_of_circle(f.to, e), b = e.bulge;
  const Xy<double> gradient = (1 - b * b) * perp(chord) - 2 * b * ((f.from - e.from) + (f.from - e.to));
  const Xy<double> turned{d.x * m.x + d.y * m.y, d.y * m.x - d.x * m.y};
  return {c0, m.x * c0 + 0.5 * dot(gradient, turned), c2};
}

/// \param room what rounding may move a point by: parameters of e that far outside are taken for the ends
[[nodiscard]] inline Arc_crossings crossings(const Arc_2& e, const Arc_2& f, double room) {
  Arc_crossings result;
  const auto [c0, c1, c2] = side_along(e, f);
  const bool left0 = c0 >= 0, left2 = c2 >= 0;
  const double length = euclidean_norm(e.to - e.from);
  const double flat = (1 + e.bulge * e.bulge) * length * room;  // side is that times distance / 2
  const double slack = (std::min)(room / length, 0x1p-6);
  const auto is_on = [slack](double u) { return u >= -slack && u <= 1 + slack; };
  if (std::fabs(c0) <= flat && is_on(moebius_parameter(e, f.from))) result.is_doubtful = true;
  if (std::fabs(c2) <= flat && is_on(moebius_parameter(e, f.to))) result.is_doubtful = true;
  if (std::fabs(c0) <= flat && std::fabs(c2) <= flat && std::fabs(c1) <= flat) {
    result.is_doubtful = result.is_doubtful || is_on(moebius_parameter(e, moebius_point(f, 0.5)));
    if (left0 == left2) return result;
  }
  if (left0 == left2 && left0 == (c1 >= 0)) return result;
  const double square = c1 * c1 - c0 * c2, bend = std::fabs(c0 - 2 * c1 + c2);
  // the lens between both is as deep as square / bend where ends are on one side
  const bool touches = left0 == left2 && std::fabs(square) <= flat * bend;
  if (touches && is_on(moebius_parameter(e, moebius_point(f, (c0 - c1) / (c0 - 2 * c1 + c2)))))
    result.is_doubtful = true;
  if (square < 0) return result;
  // (c0 - 2 c1 + c2) v^2 - 2 (c0 - c1) v + c0: at (h + root) / a it rises, at (h - root) / a it falls
  const double root = std::sqrt(square), a = c0 - 2 * c1 + c2, h = c0 - c1;
  const double rising = h >= 0 ? (h + root) / a : c0 / (h - root), falling = h >= 0 ? c0 / (h + root) : (h - root) / a;
  const auto add = [&](double v, bool falls) {
    v = v >= 0 ? (std::min)(v, 1.0) : 0;
    const double u = moebius_parameter(e, moebius_point(f, v));
    if (!is_on(u)) return;
    result.is_doubtful = result.is_doubtful || u <= slack || u >= 1 - slack;
    result.at[result.count++] = {(std::min)((std::max)(u, 0.0), 1.0), v, falls};
  };
  if (left0 != left2) {
    add(left0 ? falling : rising, left0);
  } else {
    add(falling, true);
    add(rising, false);
  }
  return result;
}

/// Whether two arcs, of which f starts where e ends, have another common point, or nearly do.  There side(F) is 0, so
/// that the product is v (2 c1 (1 - v) + c2 v), whose other zero is 2 c1 / (2 c1 - c2).
[[nodiscard]] inline bool meet_again(const Arc_2& e, const Arc_2& f, double room) {
  const auto [c0, c1, c2] = side_along(e, f);
  const double length = euclidean_norm(e.to - e.from), flat = (1 + e.bulge * e.bulge) * length * room;
  const double slack = (std::min)(room / length, 0x1p-6);
  const auto is_on = [&](const Xy<double>& q) {
    const double u = moebius_parameter(e, q);
    return u >= -slack && u <= 1 + slack;
  };
  if (std::fabs(c1) <= flat && std::fabs(c2) <= flat) return is_on(moebius_point(f, 0.5));  // on one circle
  if (f.to == e.from) return false;
  if (std::fabs(c2) <= flat) return is_on(f.to);
  if ((c1 > 0) == (c2 > 0)) return false;
  const Xy<double> q = moebius_point(f, 2 * c1 / (2 * c1 - c2));
  return euclidean_norm(q - f.from) > 2 * room && is_on(q);
}

}  // namespace CGAL::Bounding_arcs

#endif
