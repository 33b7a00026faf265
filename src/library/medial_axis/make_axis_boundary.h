// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The elements of a boundary from its rings: segments, and corners between them.

#ifndef BOUNDING_ARCS_LIBRARY_MEDIAL_AXIS_MAKE_AXIS_BOUNDARY_H
#define BOUNDING_ARCS_LIBRARY_MEDIAL_AXIS_MAKE_AXIS_BOUNDARY_H

#include "../tree/Directed_segment.h"
#include "Axis_boundary.h"
#include "Bounding_parts.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace CGAL::Bounding_arcs::internal {

/// A spiral segment as a ring goes along it.
struct Directed_piece {
  Spiral_piece_2 piece;
  bool is_reversed;
  [[nodiscard]] const Spiral_sample& first() const { return is_reversed ? piece.last : piece.first; }
  [[nodiscard]] const Spiral_sample& last() const { return is_reversed ? piece.first : piece.last; }
  [[nodiscard]] Xy<double> tangent(const Spiral_sample& end) const { return is_reversed ? -end.tangent : end.tangent; }
  // Signed: the piece turns to one side.
  [[nodiscard]] double curvature(const Spiral_sample& end) const {
    return std::copysign(end.most_curvature / 2 + end.least_curvature / 2, cross(tangent(first()), tangent(last())));
  }
};

/// The angle between two elements at their joint. Where the tangent turns back, the sides tell the sign: at the
/// distance s from the cusp, with the tangent T and normal N before it, the arms are at
/// -s T + s^2 / 2 kappa N and -s T - s^2 / 2 kappa' N, and the turn is to the left where the second one is.
[[nodiscard]] inline double turn_of(const Directed_piece& p, const Directed_piece& q) {
  const Xy<double> in = p.tangent(p.last()), out = q.tangent(q.first());
  const double turn = std::atan2(cross(in, out), dot(in, out));
  constexpr double CUSP = 3.14159265358979 - 0x1p-20;
  if (std::fabs(turn) < CUSP) return turn;
  const double sum = p.curvature(p.last()) + q.curvature(q.first());
  if (sum != 0 && !std::isnan(sum)) return std::copysign(std::fabs(turn), -sum);
  const Xy<double>&from = p.first().point, &at = p.last().point, &to = q.last().point;
  return std::copysign(std::fabs(turn), cross(at - from, to - at));
}
/// Joints that turn by less are smooth. Beyond the disc of radius r that touches both sides of a corner, which turns
/// by an angle a, its tip is r a^2 / 8 long: with ten times less, tips would be lost in the coordinates' rounding.
inline constexpr double LEAST_TURN = 0x1p-21;

class Axis_boundary_maker {
 public:
  explicit Axis_boundary_maker(const Bounding_parts& parts) : curves_(parts.segments), boundary_(parts.segments) {
    for (const Bounding_ring& ring : parts.rings) {
      std::vector<Directed_segment> way;
      for (const Directed_segment& s : ring.way)
        if (is_long(s.segment)) way.push_back(s);
      if (!way.empty()) add_ring(way, ring.is_outer);
      else if (is_lone_point(ring.way)) add_point(ring.way.front().segment);
    }
  }
  [[nodiscard]] Axis_boundary boundary() && { return std::move(boundary_); }

 private:
  static constexpr double HALF_TURN = 3.14159265358979323846;

  // A curve that is a point has a ring on either side, or one along both. A part without length is none.
  [[nodiscard]] bool is_lone_point(const std::vector<Directed_segment>& way) const {
    const std::uint32_t segment = way.front().segment;
    const auto& points = curves_.bezier(curves_.bezier_of(segment)).control_points();
    const auto is_it = [&](const Directed_segment& s) { return s.segment == segment; };
    const auto is_there = [&](const Xy<double>& p) { return p == points.front(); };
    return !way.front().is_reversed && std::all_of(way.begin(), way.end(), is_it) &&
           std::all_of(points.begin(), points.end(), is_there);
  }
  // Shorter are points, and what is between two cuts that are nearly one.
  [[nodiscard]] bool is_long(std::uint32_t segment) const {
    const Spiral_piece_2 p = curves_.piece(segment);
    return euclidean_norm(p.last.point - p.first.point) > boundary_.resolution();
  }
  [[nodiscard]] Directed_piece directed(const Directed_segment& s) const {
    return {curves_.piece(s.segment), s.is_reversed};
  }
  // At the end of an open curve a ring turns round it.
  [[nodiscard]] double turn_between(const Directed_segment& s, const Directed_segment& next) const {
    if (s.segment == next.segment && s.is_reversed != next.is_reversed) return -HALF_TURN;
    return turn_of(directed(s), directed(next));
  }
  void add_ring(const std::vector<Directed_segment>& way, bool is_outer) {
    boundary_.start_ring(is_outer);
    for (std::size_t i = 0; i < way.size(); ++i) {
      const Directed_segment& s = way[i];
      const Directed_piece p = directed(s);
      const double sign = s.is_reversed ? -1 : 1;
      boundary_.add({s.segment, 0, false, s.is_reversed, sign * p.first().t, sign * p.last().t});
      const double turn = turn_between(s, way[(i + 1) % way.size()]);
      if (!(turn < -LEAST_TURN)) continue;
      boundary_.add({s.segment, 0, true, s.is_reversed, 0, -turn, p.last().point, p.tangent(p.last())});
    }
  }
  void add_point(std::uint32_t segment) {
    boundary_.start_ring(false);
    boundary_.add({segment, 0, true, false, 0, 2 * HALF_TURN, curves_.piece(segment).first.point, {1, 0}});
  }

  const Segment_hierarchy& curves_;
  Axis_boundary boundary_;
};

/// \param parts must outlive the boundary
[[nodiscard]] inline Axis_boundary axis_boundary(const Bounding_parts& parts) {
  return Axis_boundary_maker(parts).boundary();
}

}  // namespace CGAL::Bounding_arcs::internal

#endif
