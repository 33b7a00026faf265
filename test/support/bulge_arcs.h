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

}  // namespace bounding_arcs_test

#endif
