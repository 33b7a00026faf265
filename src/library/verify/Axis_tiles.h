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

#include <cmath>
#include <cstddef>
#include <limits>
#include <optional>
#include <vector>

namespace CGAL::Bounding_arcs::verify {

struct Axis_tile {
  Curve_place begin, end;  ///< of one Bezier piece
  const Medial_sample* first;
  const Medial_sample* last;
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
/// \param room lengths below are nothing
/// \return nothing where they are on no common piece
[[nodiscard]] inline std::optional<Axis_tile> tile_between(const Drawing_2<double>& curves, const Curve_place& begin,
                                                           const Curve_place& end, const Medial_sample& first,
                                                           const Medial_sample& last, double room) {
  std::optional<Axis_tile> tile;
  if (begin.curve != end.curve) return tile;
  // a closed curve of few pieces has two ways: discs between touch one of them
  double least = std::numeric_limits<double>::infinity();
  const Xy<double> center = 0.5 * (first.center + last.center);
  const double radius = 0.5 * (first.radius + last.radius);
  for (const Curve_place& b : names_of(curves, begin, room))
    for (const Curve_place& e : names_of(curves, end, room)) {
      if (b.bezier != e.bezier) continue;
      const Bezier_curve_2<double>& piece = curves.curves()[b.curve].beziers[b.bezier];
      const Xy<double> middle = piece.point(b.t + 0.5 * (e.t - b.t)), way = middle - center,
                       from = piece.point(b.t) - middle, to = piece.point(e.t) - middle;
      const double miss = std::fabs(std::hypot(way.x, way.y) - radius);
      const bool is_point = std::hypot(from.x, from.y) + std::hypot(to.x, to.y) <= room;
      if (miss < least) least = miss, tile = Axis_tile{b, e, &first, &last, is_point};
    }
  return tile;
}

}  // namespace CGAL::Bounding_arcs::verify

#endif
