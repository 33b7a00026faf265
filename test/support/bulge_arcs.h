// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Arcs by their ends and bulge, as files give them: points on them and distances from them, without their centers.

#ifndef BOUNDING_ARCS_TEST_BULGE_ARCS_H
#define BOUNDING_ARCS_TEST_BULGE_ARCS_H

#include <CGAL/Bounding_arcs_2/number/Xy.h>

#include <algorithm>
#include <cmath>

namespace bounding_arcs_test {

/// The point of an arc a share of its angle from its start: in half-angle tangents, from the middle of the chord.
/// \tparam Arc has members from, to and bulge
template <class Arc> CGAL::Bounding_arcs::Xy<double> point_on(const Arc& arc, double share) {
  using Point = CGAL::Bounding_arcs::Xy<double>;
  const Point chord = arc.to - arc.from;
  const double b = arc.bulge, u = std::tan((2 * share - 1) * std::atan(b));
  if (std::fabs(b) < 0x1p-1000) return arc.from + share * chord;  // its inverse is not finite
  const double along = (1 + b * b) / b * u / (1 + u * u), across = (b * b - u * u) / (b * (1 + u * u));
  return 0.5 * (arc.from + arc.to) + along / 2 * chord - across / 2 * perp(chord);
}

/// The distance of a point from an arc of at most a half turn.
template <class Arc> double distance_from(const Arc& arc, const CGAL::Bounding_arcs::Xy<double>& q) {
  const auto chord = arc.to - arc.from, v = q - 0.5 * (arc.from + arc.to);
  const double length = std::hypot(chord.x, chord.y), a = length / 2, b = std::fabs(arc.bulge);
  const double ends =
      (std::min)(std::hypot(q.x - arc.from.x, q.y - arc.from.y), std::hypot(q.x - arc.to.x, q.y - arc.to.y));
  if (length == 0) return ends;
  const double x = v.x * (chord.x / length) + v.y * (chord.y / length);
  const double y = (arc.bulge > 0 ? -1 : 1) * (v.y * (chord.x / length) - v.x * (chord.y / length));
  if ((1 - b * b) * (x + a) + 2 * b * y < 0 || (1 - b * b) * (x - a) - 2 * b * y > 0) return ends;
  const double f = b * ((x - a) * (x + a) + y * y) / a + (1 - b * b) * y, square = 1 + b * b;
  return std::fabs(2 * f / (square + std::sqrt((std::max)(0.0, square * square + 4 * b * f / a))));
}

/// What an arc of a closed ring adds to how often the ring runs round a point that is not on it: its chord's crossing
/// of the ray to the right, and the part of its disc between both.
template <class Arc> int winding_of(const Arc& arc, const CGAL::Bounding_arcs::Xy<double>& x) {
  const auto chord = arc.to - arc.from, v = x - arc.from, w = x - arc.to;
  const double side = chord.x * v.y - chord.y * v.x, b = arc.bulge;  // above 0 to the left of the chord
  int winding = 0;
  if (arc.from.y <= x.y && x.y < arc.to.y && side > 0) winding = 1;
  if (arc.to.y <= x.y && x.y < arc.from.y && side < 0) winding = -1;
  if (b == 0 || (b > 0) == (side > 0)) return winding;
  // on the arc's side of the chord: in the disc where the angle under which x sees the chord is larger than the arc's
  const double across = std::fabs(side), along = v.x * w.x + v.y * w.y, turn = std::fabs(b);
  if ((1 - turn * turn) * across > -2 * turn * along) return winding;
  return winding + (b > 0 ? 1 : -1);
}

}  // namespace bounding_arcs_test

#endif
