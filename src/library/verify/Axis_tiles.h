// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The cells of an axis: between two samples that follow each other, on one side of their edge.
//
//     c_begin ------ c_end      The part of the boundary runs from one foot to the other with the region on its left.
//     At
//        |    cell    |         a corner both feet are one point, and the cell is a triangle.
//        |            |
//   begin ---------> end

#ifndef BOUNDING_ARCS_LIBRARY_VERIFY_AXIS_TILES_H
#define BOUNDING_ARCS_LIBRARY_VERIFY_AXIS_TILES_H

#include <CGAL/Bounding_arcs_2/curve/Drawing_2.h>
#include <CGAL/Bounding_arcs_2/medial_axis/Medial_axis_2.h>
#include <CGAL/Bounding_arcs_2/number/stable_norm.h>
#include "Axis_checker_curves.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <optional>
#include <vector>

namespace CGAL::Bounding_arcs::verify {

struct Axis_tile {
  Curve_place begin, end;  ///< of one Bezier piece
  const Medial_axis_2::Sample* first;
  const Medial_axis_2::Sample* last;
  bool is_point;  ///< shorter than what counts as nothing
};

/// A place on one more piece of its curve, where it is at the joint of two.
/// \param room how far from the joint that may be
[[nodiscard]] inline std::vector<Curve_place> names_of(const Drawing_2<double>& curves, const Curve_place& p,
                                                       double room) {
  std::vector<Curve_place> names{p};
  const auto& curve = curves.curves()[p.curve];
  const auto count = curve.beziers.size();
  const Bezier_curve_2<double>& piece = curve.beziers[p.bezier];
  const auto is_at = [&](const Xy<double>& end) {
    const Xy<double> way = piece.point(p.t) - end;
    return std::hypot(way.x, way.y) <= room;
  };
  if (p.t < 0.5 && (p.bezier > 0 || curve.is_closed) && is_at(piece.control_points().front()))
    names.push_back({p.curve, static_cast<decltype(p.bezier)>((p.bezier + count - 1) % count), 1});
  if (p.t > 0.5 && (p.bezier + 1 < count || curve.is_closed) && is_at(piece.control_points().back()))
    names.push_back({p.curve, static_cast<decltype(p.bezier)>((p.bezier + 1) % count), 0});
  return names;
}

/// The part of the boundary between two feet.
/// \param begin, end each foot as a place, on all pieces that have it
/// \param room lengths below are nothing
/// \return nothing where they are on no common piece
[[nodiscard]] inline std::optional<Axis_tile> tile_between(const Drawing_2<double>& curves,
                                                           const std::vector<Curve_place>& begin,
                                                           const std::vector<Curve_place>& end,
                                                           const Medial_axis_2::Sample& first,
                                                           const Medial_axis_2::Sample& last, double room) {
  std::optional<Axis_tile> tile;
  // a closed curve of few pieces has two ways: discs between touch one of them
  double least = std::numeric_limits<double>::infinity();
  const Xy<double> center = 0.5 * (first.center + last.center);
  const double radius = 0.5 * (first.radius + last.radius);
  for (const Curve_place& b : begin)
    for (const Curve_place& e : end) {
      if (b.curve != e.curve || b.bezier != e.bezier) continue;
      const Bezier_curve_2<double>& piece = curves.curves()[b.curve].beziers[b.bezier];
      const Xy<double> middle = piece.point(b.t + 0.5 * (e.t - b.t)), way = middle - center,
                       from = piece.point(b.t) - middle, to = piece.point(e.t) - middle;
      const double miss = std::fabs(std::hypot(way.x, way.y) - radius);
      const bool is_point = std::hypot(from.x, from.y) + std::hypot(to.x, to.y) <= room;
      if (miss < least) least = miss, tile = Axis_tile{b, e, &first, &last, is_point};
    }
  return tile;
}

// A disc of the axis between two samples, and how far it is from the line between them.

[[nodiscard]] inline const Bezier_curve_2<double>& piece_at(const Drawing_2<double>& curves, const Curve_place& p) {
  return curves.curves()[p.curve].beziers[p.bezier];
}
/// The point of a place, in the middle of its enclosure.
[[nodiscard]] inline Xy<double> middle_at(const Drawing_2<double>& curves, const Curve_place& p) {
  const Checked_vector q = point_at(piece_at(curves, p), p.t).point;
  return {CGAL::to_double(q.x), CGAL::to_double(q.y)};
}

/// A point of a tile; the tangent has the region on its left.
struct Tile_jet {
  Xy<double> point, tangent;
};
[[nodiscard]] inline Tile_jet jet_at(const Drawing_2<double>& curves, const Axis_tile& tile, double share) {
  const Checked_point p = point_at(piece_at(curves, tile.begin), tile.begin.t + share * (tile.end.t - tile.begin.t));
  const auto middle = [](const Checked_vector& v) { return Xy<double>{CGAL::to_double(v.x), CGAL::to_double(v.y)}; };
  const Xy<double> d = middle(p.derivative);
  const double speed = stable_norm(d) * (tile.end.t < tile.begin.t ? -1 : 1);
  return {middle(p.point), {d.x / speed, d.y / speed}};
}
[[nodiscard]] inline Curve_place place_at(const Axis_tile& tile, double share) {
  Curve_place p = tile.begin;
  p.t += share * (tile.end.t - tile.begin.t);
  return p;
}
/// The cells on both sides of the line between two samples.
struct Cells {
  Axis_tile left, right;
};
/// The disc that touches half way along one tile and anywhere on the other one. Halving: (q - p).(Tq - Tp) grows along
/// q's tile. \param size of the drawing
[[nodiscard]] inline std::optional<Medial_axis_2::Sample> disc_between(const Drawing_2<double>& curves,
                                                                       const Cells& cells, double size) {
  const bool is_half_of_left = cells.right.is_point;
  const Axis_tile &tile = is_half_of_left ? cells.left : cells.right,
                  &other = is_half_of_left ? cells.right : cells.left;
  Tile_jet p{};
  if (tile.is_point) {
    const Xy<double> at = middle_at(curves, tile.begin), way = 0.5 * (tile.first->center + tile.last->center) - at;
    const double far = stable_norm(way);
    if (!(far > 0)) return std::nullopt;
    p = {at, {way.y / far, -way.x / far}};
  } else {
    p = jet_at(curves, tile, 0.5);
  }
  Tile_jet q{};
  double low = 0, high = 1;
  if (other.is_point) q.point = middle_at(curves, other.begin);
  constexpr int STEPS = 40;
  for (int i = 0; i < STEPS && !other.is_point; ++i) {
    const double share = 0.5 * (low + high);
    q = jet_at(curves, other, share);
    (dot(q.point - p.point, q.tangent - p.tangent) > 0 ? high : low) = share;
  }
  const Xy<double> way = q.point - p.point, normal = perp(p.tangent);
  const double height = dot(way, normal), far = stable_norm(way);
  constexpr double LEAST = 0x1p-22;
  if (!(far > LEAST * size) || !(height > 0)) return std::nullopt;
  const double radius = far * far / (2 * height);
  const Curve_place half = place_at(tile, 0.5), foot = place_at(other, other.is_point ? 0 : 0.5 * (low + high));
  return Medial_axis_2::Sample{p.point + radius * normal, radius, is_half_of_left ? half : foot,
                               is_half_of_left ? foot : half};
}
/// How far a disc is from the line between two others, centers and radii together.
[[nodiscard]] inline double distance_from_line(const Medial_axis_2::Sample& d, const Medial_axis_2::Sample& s,
                                               const Medial_axis_2::Sample& t) {
  const Xy<double> chord = t.center - s.center, way = d.center - s.center;
  const double square = dot(chord, chord), share = square > 0 ? std::clamp(dot(way, chord) / square, 0.0, 1.0) : 0;
  return stable_norm(way - share * chord) + std::fabs(s.radius + share * (t.radius - s.radius) - d.radius);
}

}  // namespace CGAL::Bounding_arcs::verify

#endif
