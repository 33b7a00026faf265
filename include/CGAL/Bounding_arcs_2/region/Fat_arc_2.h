// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// A fat arc: one arc and a radius about it, the form in which a BCA answers questions, one distance a node.
//
//         .-- b0 --.         Arcs over one chord of length L with bulges b and b' are within L/2 |b - b'| of each
//     .---          ---.     other, point by point: all points whose chord's ends are seen under one ratio of distances
// from                  to   move on a circle.  A spiral is between the two that touch it in its ends, so each of its
//                            points is within r = L/4 |b0 - b1| of the arc with the mean bulge.  That moves the curve,
//                            which joins the same ends, onto the whole arc, so distances from a point to curve and arc
//                            differ by at most r.  The curve's own region of exact numbers is moved by the widening at
//                            most.

#ifndef CGAL_BOUNDING_ARCS_2_REGION_FAT_ARC_2_H
#define CGAL_BOUNDING_ARCS_2_REGION_FAT_ARC_2_H

#include <CGAL/Bounding_arcs_2/arc/Arc_2.h>
#include <CGAL/Bounding_arcs_2/arc/arc_pair.h>
#include <CGAL/Bounding_arcs_2/number/Bracket.h>

#include <algorithm>
#include <cmath>

namespace CGAL::Bounding_arcs {

/// All points of the piece are within `radius` of the arc, and all of the arc within that of the piece.
struct Fat_arc_2 {
  Arc_2 arc;
  double radius = 0;
};

/// Half of the region's width: distances from it and from its piece differ by no more.
[[nodiscard]] inline double half_width(const Fat_arc_2& fat) { return fat.radius; }

namespace internal {
/// What distances from a point at most so far from both ends of an arc err by, with what is added to them.
[[nodiscard]] inline double distance_room(double distance, double chord, double widening) {
  constexpr double OF_SUMS = 20 * HALF_ULP;  // of r, the mean bulge and three sums with the widening
  return widening + (ARC_DISTANCE_ERROR + OF_SUMS) * (distance + chord + widening);
}
}  // namespace internal

/// Bounds of the distance from a point to the exact piece.
[[nodiscard]] inline Bracket distance_bounds(const Xy<double>& q, const Fat_arc_2& fat) {
  const double d = std::fabs(signed_distance(q, fat.arc));
  const double room = internal::distance_room(d, euclidean_norm(fat.arc.to - fat.arc.from), fat.radius);
  return {(std::max)(0.0, d - room), d + room};
}

/// A lower bound of the distance of the exact pieces in two fat arcs.
/// \guarantee certified; where the nearest points are not ends of both, short by the radii and some roundings only
[[nodiscard]] inline double least_distance(const Fat_arc_2& a, const Fat_arc_2& b) {
  const internal::Arc_form of_a(a.arc), of_b(b.arc);
  if (of_a.length == 0) return (std::max)(0.0, distance_bounds(a.arc.from, b).lower - a.radius);
  if (of_b.length == 0) return (std::max)(0.0, distance_bounds(b.arc.from, a).lower - b.radius);
  const double farthest = euclidean_norm(a.arc.from - b.arc.from) + of_a.length + of_b.length;
  const double d = (std::max)(internal::least_distance_to_circle(a.arc, of_a, b.arc, of_b, farthest),
                              internal::least_distance_to_circle(b.arc, of_b, a.arc, of_a, farthest));
  return (std::max)(0.0, (d - (a.radius + b.radius)) * ROUNDED_DOWN<4>);
}

/// Whether the spirals in two fat arcs for certain have no point in common; false may mean that it is not known.
/// A fat arc is within the parallelogram over its chord, widened by its radius: apart in the direction across a chord.
/// Products of vectors no longer than `size` round by 4 u each.
[[nodiscard]] inline bool are_apart(const Fat_arc_2& a, const Fat_arc_2& b) {
  const Xy<double> chord_a = a.arc.to - a.arc.from, chord_b = b.arc.to - b.arc.from;
  const Xy<double> apex_a = (-0.5 * a.arc.bulge) * perp(chord_a), apex_b = (-0.5 * b.arc.bulge) * perp(chord_b);
  const Xy<double> between = b.arc.from - a.arc.from;
  const double room = a.radius + b.radius;
  const auto separated = [&](const Xy<double>& chord, const Xy<double>& own_apex, const Xy<double>& other_chord,
                             const Xy<double>& other_apex, const Xy<double>& way) {
    const double own = cross(chord, own_apex), start = cross(chord, way), along = cross(chord, other_chord),
                 apex = cross(chord, other_apex);
    const double low = start + (std::min)(along, 0.0) + (std::min)(apex, 0.0),
                 high = start + (std::max)(along, 0.0) + (std::max)(apex, 0.0);
    const double length = euclidean_norm(chord);
    const double size =
        std::fabs(way.x) + std::fabs(way.y) + 2 * (std::fabs(other_chord.x) + std::fabs(other_chord.y)) + length;
    const double slack = length * (room * ROUNDED_UP<8> + 16 * HALF_ULP * size);
    return low - (std::max)(own, 0.0) > slack || (std::min)(own, 0.0) - high > slack;
  };
  return internal::are_boxes_apart(a.arc, b.arc, room) || separated(chord_a, apex_a, chord_b, apex_b, between) ||
         separated(chord_b, apex_b, chord_a, apex_a, -between);
}

}  // namespace CGAL::Bounding_arcs

#endif
