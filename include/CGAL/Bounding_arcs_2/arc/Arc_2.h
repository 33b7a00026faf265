// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// An arc by its ends and its bulge, and what is asked of it: distance, nearest point, points and directions, length,
// box.  Nothing goes through the center, so that all holds for flat arcs and segments, too.
//
//            z                  D = to - from, L = |D|, u0 = q - from, u1 = q - to, b the bulge, and phi = 2 atan b the
//                               angle between the chord and the tangents at the ends.  With center z and radius R:
//  from ___________ to            4 b R = (1 + b^2) L,
//       \__     __/              4 b (q - z) = 2 b (u0 + u1) - (1 - b^2) perp(D) =: w.
//          -----                -w is the left normal at q of the circles about z, and of lines along D where b = 0.
//
// Errors are given to first order in u = 2^-53, for lengths between 2^-500 and 2^500, whose products are numbers.

#ifndef CGAL_BOUNDING_ARCS_2_ARC_ARC_2_H
#define CGAL_BOUNDING_ARCS_2_ARC_ARC_2_H

#include <CGAL/Bounding_arcs_2/number/Bracket.h>
#include <CGAL/Bounding_arcs_2/number/Xy.h>
#include <CGAL/Bounding_arcs_2/number/stable_norm.h>
#include <CGAL/Bounding_arcs_2/number/strict_math.h>

#include <CGAL/Bbox_2.h>
#include <CGAL/assertions.h>

#include <algorithm>
#include <cmath>
#include <iosfwd>
#include <limits>

namespace CGAL::Bounding_arcs {

/// The arc `from` -> `to` that turns by 4 atan(bulge), to the left for a positive bulge; 0 is the segment.
/// Invariant: |bulge| <= 1, at most half a circle. Equal ends are an arc, too: a point.
/// \code
/// const Arc_2 half_circle{{0, 0}, {2, 0}, 1};
/// const Xy<double> lowest = point(half_circle, 0.5);        // (1, -1)
/// const double d = signed_distance({1, 0}, half_circle);    // 1: to the left of it
/// \endcode
struct Arc_2 {
  Xy<double> from, to;
  double bulge = 0;

  /// Tells whether ends and bulge are numbers, and the bulge is one of at most half a circle.
  [[nodiscard]] bool is_valid() const {
    return std::isfinite(from.x) && std::isfinite(from.y) && std::isfinite(to.x) && std::isfinite(to.y) &&
           std::fabs(bulge) <= 1;
  }
  /// The angle 2 atan b between the chord and the tangents at the ends, half of what the arc turns by.
  [[nodiscard]] double half_turn() const { return 2 * std::atan(bulge); }
};

/// Signed curvature of the arc with a bulge over a chord, positive for a left turn. \pre the chord has a length
/// \guarantee within 6.2 u of itself, proven by test/gappa/arc_curvature.g
template <class NT> [[nodiscard]] NT curvature(const Xy<NT>& chord, const NT& bulge) {
  return NT(NT(4) * bulge / ((NT(1) + bulge * bulge) * euclidean_norm(chord)));
}
/// Signed curvature, positive for a left turn. \pre different ends \guarantee within 6.2 u of itself, proven by
/// test/gappa/arc_curvature.g
[[nodiscard]] inline double curvature(const Arc_2& arc) {
  CGAL_precondition(arc.from != arc.to);
  return curvature(arc.to - arc.from, arc.bulge);
}

/// The radius. \pre not a segment \guarantee as curvature
[[nodiscard]] inline double radius(const Arc_2& arc) { return std::fabs(1 / curvature(arc)); }
/// The center, rounded to doubles, which costs flat arcs digits that the bulge has. \pre not a segment
[[nodiscard]] inline Xy<double> center(const Arc_2& arc) {
  CGAL_precondition(arc.bulge != 0);
  const Xy<double> chord = arc.to - arc.from;
  return arc.from + 0.5 * chord + ((1 - arc.bulge) * (1 + arc.bulge) / (4 * arc.bulge)) * perp(chord);
}
/// Returns the arc run through the other way.
[[nodiscard]] inline Arc_2 reversed(const Arc_2& arc) { return {arc.to, arc.from, -arc.bulge}; }

/// \guarantee within 10 u of itself: L 3 u, 1 + b^2 2 u, the arc tangent and the quotient 2 u each
[[nodiscard]] inline double length(const Arc_2& arc) {
  const double b = arc.bulge, chord = euclidean_norm(arc.to - arc.from);
  constexpr double FLAT = 0x1p-30;  // below, atan b is b, and b^2 nothing beside 1
  return std::fabs(b) < FLAT ? chord : chord * ((1 + b * b) * (std::atan(b) / b));
}

/// The point a share s in [0, 1] of the length from the start, the ends themselves at 0 and 1.
///
/// A chord from the start to the point has the length L sin(s phi) / sin phi, and the direction of D turned by
/// -(1 - s) phi; from s = 1/2 on the same is seen from the other end. The quotient errs by 10 u of itself, the turned
/// vector by 11 u L: angles by 4 u of themselves, sine and cosine by 2 u, D, products and sum by 3 u.
/// \guarantee within 21 u L and half an ulp of the result
[[nodiscard]] inline Xy<double> point(const Arc_2& arc, double s) {
  const bool is_near_start = s <= 0.5;
  const double share = is_near_start ? s : 1 - s, phi = arc.half_turn();
  const double part = arc.bulge == 0 ? share : std::sin(share * phi) / std::sin(phi), turn = (1 - share) * phi;
  const Xy<double> chord = arc.to - arc.from;
  const Xy<double> along = (part * std::cos(turn)) * chord, across = (part * std::sin(turn)) * perp(chord);
  return is_near_start ? arc.from + (along - across) : arc.to - (along + across);
}

/// The unit tangent in the point a share s of the length from the start: D turned by (2 s - 1) phi.
/// \pre different ends
/// \guarantee within 16 u: of the direction of D 2 u, of its length 4 u, of angle, sine and cosine 6 u, of products and
///   sum 3 u
[[nodiscard]] inline Xy<double> tangent(const Arc_2& arc, double s) {
  CGAL_precondition(arc.from != arc.to);
  const double turn = (2 * s - 1) * arc.half_turn(), c = std::cos(turn), d = std::sin(turn);
  const Xy<double> chord = arc.to - arc.from;
  return (1 / euclidean_norm(chord)) * (c * chord + d * perp(chord));
}
/// The unit normal to the left.
[[nodiscard]] inline Xy<double> normal(const Arc_2& arc, double s) { return perp(tangent(arc, s)); }

/// How an arc is seen from a point; names as above.
template <class NT> struct Arc_view {
  Xy<NT> u0, u1, w;
  NT chord, apart;  ///< L, |w|
  NT side;          ///< (1 - b^2) cross(D, u0) - 2 b u0.u1, positive to the left of the circle
  int nearest_end;  ///< 0, 1, or -1 where the foot is on the arc
};
/// How an arc is seen from q.
template <class NT>
[[nodiscard]] CGAL_BOUNDING_ARCS_INLINE Arc_view<NT> view(const Xy<NT>& q, const Xy<NT>& from, const Xy<NT>& to,
                                                          const NT& b) {
  const NT twice = NT(2) * b, m = NT(1) - b * b;
  const Xy<NT> chord = to - from, u0 = q - from, u1 = q - to;
  const Xy<NT> w = twice * (u0 + u1) - m * perp(chord);
  const NT across = cross(chord, u0), beyond = twice * across, along0 = dot(chord, u0), along1 = dot(chord, u1);
  const bool is_on_arc = m * along0 > beyond && m * along1 + beyond < NT(0);
  const int end = is_on_arc ? -1 : (along0 + along1 < NT(0) ? 0 : 1);
  return {u0, u1, w, euclidean_norm(chord), euclidean_norm(w), NT(m * across - twice * dot(u0, u1)), end};
}
/// How an arc is seen from q.
[[nodiscard]] CGAL_BOUNDING_ARCS_INLINE Arc_view<double> view(const Xy<double>& q, const Arc_2& arc) {
  return view(q, arc.from, arc.to, arc.bulge);
}
/// The distance of a point from the circle of an arc with bulge b, negative to the right. \param apart |w|
template <class NT>
[[nodiscard]] CGAL_BOUNDING_ARCS_INLINE NT distance_to_circle(const Arc_view<NT>& v, const NT& apart, const NT& b) {
  return NT(NT(2) * v.side / ((NT(1) + b * b) * v.chord + apart));
}

/// Error of a distance from a point, in parts of the distance of the arc's farther end; derived at signed_distance.
inline constexpr double ARC_DISTANCE_ERROR = 60 * HALF_ULP;

/// The distance from a point to an arc, negative to the right of the arc's circle.
///
/// With G = side, (1 + b^2)^2 L^2 - |w|^2 = 8 b G, so R - |q - z| = 2 G / ((1 + b^2) L + |w|): no center, and right for
/// b = 0.  The foot is on the arc where q is before the normal at its start and behind that at its end; T_i.u_i tell,
/// T_i = (1 - b^2) D -+ 2 b perp(D), else an end is nearest.
///
/// Error.  Let r be the larger of |u0| and |u1|, A = (1 + b^2) L.  D, u0 and u1 err by u of themselves, cross and dot
/// by 4 u L r and 4 u r^2, G by (6 L r + 10 |b| r^2) u and u |G|, |w| by (12 |b| r + 3 L + 3 |w|) u, A by 6 u A.  As
/// |u0 + u1| >= 2 r - L, 4 |b| r <= 1.5 (A + |w|).  With d = 2 G / (A + |w|) and |d| <= r that makes
///   2 (6 L r + 10 |b| r^2) / (A + |w|) <= 20 r,  |d|,  |d| (6 A + 12 |b| r + 3 L + 3 |w|) / (A + |w|) <= 14 |d|,  2
///   |d|,
/// 37 u r together, which test/gappa/arc_distance.g proves.  T_i.u_i errs by 11 u r |T_i|; where that takes an end for
/// the foot or the foot for an end, q is so near the normal there that both distances differ by at most 22 u r.
/// \source the circle's equation in the chord's frame, as no text gives it without the center
/// \guarantee within ARC_DISTANCE_ERROR times the distance of the farther end, r <= |distance| + L
[[nodiscard]] CGAL_BOUNDING_ARCS_INLINE double signed_distance(const Xy<double>& q, const Arc_2& arc) {
  const Arc_view<double> v = view(q, arc);
  if (v.nearest_end < 0) return distance_to_circle(v, v.apart, arc.bulge);
  return std::copysign(euclidean_norm(v.nearest_end == 0 ? v.u0 : v.u1), v.side);
}

/// The square of the distance.
[[nodiscard]] inline double squared_distance(const Xy<double>& q, const Arc_2& arc) {
  const double d = signed_distance(q, arc);
  return d * d;
}

/// The point of an arc nearest to q, or one of them.
/// \guarantee within 2 ARC_DISTANCE_ERROR r and half an ulp of the arc's circle, and as far from q as the arc is but
///   for that: w errs by (12 |b| r + 3 L + |w|) u, which turns q + d w / |w| about q
[[nodiscard]] inline Xy<double> nearest_point(const Xy<double>& q, const Arc_2& arc) {
  const Arc_view<double> v = view(q, arc);
  // the square of |w| may be less than the least number next to the center
  const double apart = stable_norm(v.w);
  if (v.nearest_end >= 0 || apart == 0) return v.nearest_end == 1 ? arc.to : arc.from;  // all are where q is z
  const double way = distance_to_circle(v, apart, arc.bulge) / apart;
  // q + d w / |w|, seen from the nearer end
  return dot(v.u0, v.u0) < dot(v.u1, v.u1) ? arc.from + (v.u0 + way * v.w) : arc.to + (v.u1 + way * v.w);
}

/// The unit normal to the left, at q, of the circles about the arc's center; of the arc itself where q is on it.
/// \pre q is not the center \guarantee within 8 u + (12 |b| r + 3 L) u / |w|, so within 16 u in points of the arc
[[nodiscard]] inline Xy<double> normal_at(const Xy<double>& q, const Arc_2& arc) {
  const Arc_view<double> v = view(q, arc);
  return (-1 / stable_norm(v.w)) * v.w;
}
/// The unit tangent there.
[[nodiscard]] inline Xy<double> tangent_at(const Xy<double>& q, const Arc_2& arc) {
  const Xy<double> n = normal_at(q, arc);
  return {n.y, -n.x};
}

/// A box that holds the arc.
///
/// Ends and, where the tangent turns past an axis, one more point: beyond the apex, where it is along D, by
/// D_x^2 / ((L + |D_y|) kappa L), kappa L = 4 |b| / (1 + b^2). That follows from 1 - cos a = sin^2 a / (1 + cos a).
/// There |D_x| <= 2 |b| L / (1 + b^2), so the way is at most L / 2, and it errs by less than 16 u L, the apex by 4 u L
/// and two ulp; a tangent whose sign is rounded makes a difference of its square only.
/// \guarantee certified, and at most 2^-48 L and 3 ulp larger on each side than the smallest
[[nodiscard]] inline CGAL::Bbox_2 box(const Arc_2& arc) {
  const double b = arc.bulge, m = 1 - b * b, square = 1 + b * b;
  const Xy<double> chord = arc.to - arc.from, turned = perp(chord);
  const double size = euclidean_norm(chord);
  const Xy<double> t0 = m * chord - (2 * b) * turned, t1 = m * chord + (2 * b) * turned;
  const Xy<double> apex = arc.from + (0.5 * chord - (0.5 * b) * turned);
  const auto range = [&](double Xy<double>::*axis, double Xy<double>::*other) {
    const double p = arc.from.*axis, q = arc.to.*axis;
    Bracket r{(std::min)(p, q), (std::max)(p, q)};
    if (t0.*axis * (t1.*axis) < 0 && b != 0) {
      const double way = chord.*axis * (chord.*axis) * square / (4 * std::fabs(b) * (size + std::fabs(chord.*other)));
      if (t0.*axis > 0) r.upper = (std::max)(r.upper, apex.*axis + way);
      else r.lower = (std::min)(r.lower, apex.*axis - way);
    }
    constexpr double OF_CHORD = 24 * HALF_ULP, OF_COORDINATES = 3 * HALF_ULP;
    const double margin = OF_CHORD * size + OF_COORDINATES * (std::max)(-r.lower, r.upper);
    return Bracket{r.lower - margin, r.upper + margin};
  };
  const Bracket x = range(&Xy<double>::x, &Xy<double>::y), y = range(&Xy<double>::y, &Xy<double>::x);
  return {x.lower, y.lower, x.upper, y.upper};
}

/// Writes an arc as `from.x from.y bulge to.x to.y`, on the line, with 17 digits, which tell every double apart.
std::ostream& operator<<(std::ostream& out, const Arc_2& arc);

}  // namespace CGAL::Bounding_arcs

#endif
