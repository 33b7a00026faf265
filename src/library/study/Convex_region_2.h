// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Regions with straight sides as searches ask them: a box along the axes, and a convex polygon, which an oriented box
// and a hull of control points are.

#ifndef BOUNDING_ARCS_LIBRARY_STUDY_CONVEX_REGION_2_H
#define BOUNDING_ARCS_LIBRARY_STUDY_CONVEX_REGION_2_H

#include <CGAL/Bounding_arcs_2/number/stable_norm.h>
#include <CGAL/Bounding_arcs_2/region/Fat_arc_2.h>

#include <CGAL/Bbox_2.h>

#include <boost/container/static_vector.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace CGAL::Bounding_arcs {

/// The piece is in the box, and both of its ends are given.
struct Piece_box_2 {
  CGAL::Bbox_2 box;
  Xy<double> from, to;
};

/// The piece is within `radius` of a convex polygon, counterclockwise, and both of its ends are given.
struct Convex_region_2 {
  static constexpr std::size_t MOST_POINTS = 15;  ///< more points are given as the box along the chord that holds them
  boost::container::static_vector<Xy<double>, MOST_POINTS + 1> points;  ///< one more while a hull is made
  double radius = 0;
  Xy<double> from, to;
};

[[nodiscard]] inline double half_width(const Piece_box_2& p) {
  return 0.5 * (std::min)(p.box.xmax() - p.box.xmin(), p.box.ymax() - p.box.ymin());
}
[[nodiscard]] inline double half_width(const Convex_region_2& p) {
  double height = 0;
  const Xy<double> chord = p.to - p.from;
  const double length = euclidean_norm(chord);
  for (const Xy<double>& q : p.points) height = (std::max)(height, std::fabs(cross(chord, q - p.from)));
  return p.radius + (length > 0 ? 0.5 * height / length : 0);
}

/// What is added to lengths that are sums and products of coordinates no larger than this.
[[nodiscard]] inline double rounding_of_lengths(double size) { return 32 * HALF_ULP * size; }

/// The distance from a segment.
[[nodiscard]] inline double distance_from_segment(const Xy<double>& q, const Xy<double>& a, const Xy<double>& b) {
  const Xy<double> side = b - a, way = q - a;
  const double square = dot(side, side), share = square > 0 ? std::clamp(dot(way, side) / square, 0.0, 1.0) : 0;
  return euclidean_norm(way - share * side);
}
/// An upper bound of the distance from the nearer end of a piece, which is a point of it.
[[nodiscard]] inline double distance_from_ends(const Xy<double>& q, const Xy<double>& from, const Xy<double>& to) {
  return (std::min)(euclidean_norm(q - from), euclidean_norm(q - to));
}

[[nodiscard]] inline Bracket distance_bounds(const Xy<double>& q, const Piece_box_2& p) {
  const double dx = (std::max)({p.box.xmin() - q.x, q.x - p.box.xmax(), 0.0}),
               dy = (std::max)({p.box.ymin() - q.y, q.y - p.box.ymax(), 0.0});
  const double diagonal = p.box.xmax() - p.box.xmin() + p.box.ymax() - p.box.ymin(),
               upper = distance_from_ends(q, p.from, p.to);
  const double room = rounding_of_lengths(upper + diagonal);
  return {(std::max)(0.0, stable_norm(Xy<double>{dx, dy}) - room), upper + diagonal * 0x1p-40 + room};
}
[[nodiscard]] inline double least_distance(const Piece_box_2& p, const Piece_box_2& q) {
  const double dx = (std::max)({p.box.xmin() - q.box.xmax(), q.box.xmin() - p.box.xmax(), 0.0}),
               dy = (std::max)({p.box.ymin() - q.box.ymax(), q.box.ymin() - p.box.ymax(), 0.0});
  return stable_norm(Xy<double>{dx, dy}) * ROUNDED_DOWN<8>;
}
[[nodiscard]] inline bool are_apart(const Piece_box_2& p, const Piece_box_2& q) { return !do_overlap(p.box, q.box); }

/// The distance of a point from the polygon, 0 inside; one without an area has no inside.
[[nodiscard]] inline double distance_from_polygon(const Xy<double>& q, const Convex_region_2& p) {
  bool is_inside = false;
  for (std::size_t i = 2; i < p.points.size(); ++i)
    is_inside = is_inside || cross(p.points[i - 1] - p.points[0], p.points[i] - p.points[0]) > 0;
  double least = HUGE_VAL;
  for (std::size_t i = 0; i < p.points.size(); ++i) {
    const Xy<double>&a = p.points[i], &b = p.points[(i + 1) % p.points.size()];
    is_inside = is_inside && cross(b - a, q - a) >= 0;
    least = (std::min)(least, distance_from_segment(q, a, b));
  }
  return is_inside ? 0 : least;
}
[[nodiscard]] inline Bracket distance_bounds(const Xy<double>& q, const Convex_region_2& p) {
  const double upper = distance_from_ends(q, p.from, p.to) + p.radius,
               room = rounding_of_lengths(upper + euclidean_norm(p.to - p.from));
  return {(std::max)(0.0, distance_from_polygon(q, p) - p.radius - room), upper + room};
}
/// How far all of q is at least beyond a side of p, of all sides the largest.
[[nodiscard]] inline double separation(const Convex_region_2& p, const Convex_region_2& q) {
  double most = 0;
  for (std::size_t i = 0; i < p.points.size(); ++i) {
    const Xy<double>&a = p.points[i], &b = p.points[(i + 1) % p.points.size()];
    const double length = euclidean_norm(b - a);
    if (!(length > 0)) continue;
    double least = HUGE_VAL;
    for (const Xy<double>& c : q.points) least = (std::min)(least, cross(c - a, b - a));
    most = (std::max)(most, least / length);
  }
  return most;
}
/// The distance between polygons that a side of one keeps apart, by that of corners of each from sides of the other.
[[nodiscard]] inline double least_distance(const Convex_region_2& p, const Convex_region_2& q) {
  const double radii = p.radius + q.radius,
               size = euclidean_norm(p.from - q.from) + euclidean_norm(p.to - p.from) + euclidean_norm(q.to - q.from);
  if (!(separation(p, q) > 0) && !(separation(q, p) > 0)) return 0;
  double least = HUGE_VAL;
  for (const Xy<double>& c : q.points) least = (std::min)(least, distance_from_polygon(c, p));
  for (const Xy<double>& c : p.points) least = (std::min)(least, distance_from_polygon(c, q));
  return (std::max)(0.0, least - radii - rounding_of_lengths(size));
}
[[nodiscard]] inline bool are_apart(const Convex_region_2& p, const Convex_region_2& q) {
  const double radii = p.radius + q.radius,
               size = euclidean_norm(p.from - q.from) + euclidean_norm(p.to - p.from) + euclidean_norm(q.to - q.from);
  return (std::max)(separation(p, q), separation(q, p)) > radii + rounding_of_lengths(size);
}

}  // namespace CGAL::Bounding_arcs

#endif
