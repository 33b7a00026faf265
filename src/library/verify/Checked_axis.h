// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// What all steps of a check of an axis know and what they have found so far: curves, the axis, and its cells, which are
// between two samples that follow each other, on one side of their edge.
//
//     c_begin ------ c_end      The part of the boundary runs from one foot to the other with the region on its left.
//     At
//        |    cell    |         a corner both feet are one point, and the cell is a triangle.
//        |            |
//   begin ---------> end

#ifndef BOUNDING_ARCS_LIBRARY_VERIFY_CHECKED_AXIS_H
#define BOUNDING_ARCS_LIBRARY_VERIFY_CHECKED_AXIS_H

#include <CGAL/Bounding_arcs_2/curve/Unit.h>
#include <CGAL/Bounding_arcs_2/number/stable_norm.h>
#include <CGAL/Bounding_arcs_2/verify/verify_axis.h>
#include "Axis_checker_curves.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace CGAL::Bounding_arcs::verify {

[[nodiscard]] inline double distance(const Xy<double>& p, const Xy<double>& q) { return stable_norm(p - q); }
/// By how much a point is beside a circle, at most.
[[nodiscard]] inline double miss_of(const Checked_point& p, const Xy<double>& center, double radius) {
  return most_of(length(checked(center) - p.point) - Checked_number(radius));
}

struct Axis_tile {
  Curve_place begin, end;  ///< of one Bezier piece
  const Medial_axis_2::Sample* first;
  const Medial_axis_2::Sample* last;
  bool is_point;  ///< shorter than what counts as nothing
};
[[nodiscard]] inline Curve_place place_at(const Axis_tile& tile, double share) {
  Curve_place p = tile.begin;
  p.t += share * (tile.end.t - tile.begin.t);
  return p;
}
/// The cells on both sides of the line between two samples.
struct Cells {
  Axis_tile left, right;
};

class Checked_axis {
 public:
  using Fault = Axis_verification::Fault;
  static constexpr double MOST = 0x1p-40;  ///< of the size

  const Drawing_2<double>& curves;
  const Medial_axis_2& axis;
  const Axis_verification::Options& options;
  std::vector<Curve_sides> sides;
  Curves_in_boxes boxes;        ///< of what discs may touch; in a frame that is all, as they are numbered
  double size, moved_by, room;  ///< lengths below the latter are nothing
  Axis_verification result;

  /// Curves and axis have a size near 1.
  Checked_axis(const Drawing_2<double>& of_curves, const Medial_axis_2& of_axis,
               const Axis_verification::Options& with_options)
      : curves(of_curves), axis(of_axis), options(with_options), sides(sides_of_curves(curves, options)),
        boxes(with_a_side(curves, sides)), size(curves.coordinate_size()),
        moved_by(axis.moved > 0 ? (std::min)(axis.moved, MOST * size) : 0), room(MOST * size + moved_by) {}

  void find(Fault fault, std::string place, double amount = 0) {
    constexpr std::size_t MOST_FINDINGS = 100;
    if (++result.faults <= MOST_FINDINGS) result.findings.push_back({fault, std::move(place), amount});
  }
  /// What is moved by less is told with the bound.
  [[nodiscard]] double small() const {
    constexpr double SHARE = 1.0 / 16;  // of eps
    return (std::max)(room, SHARE * axis.eps);
  }

  [[nodiscard]] const Bezier_curve_2<double>& piece(const Curve_place& p) const {
    return curves.curves()[p.curve].beziers[p.bezier];
  }
  [[nodiscard]] Checked_point jet(const Curve_place& p) const { return point_at(piece(p), p.t); }
  /// The point of a place, in the middle of its enclosure.
  [[nodiscard]] Xy<double> point(const Curve_place& p) const { return middle(jet(p).point); }
  /// A place on one more piece of its curve, where it is at the joint of two.
  [[nodiscard]] std::vector<Curve_place> names_of(const Curve_place& p) const {
    std::vector<Curve_place> names{p};
    const auto& curve = curves.curves()[p.curve];
    const auto count = curve.beziers.size();
    const Xy<double> point = piece(p).point(p.t);
    const auto is_at = [&](const Xy<double>& end) {
      const Xy<double> way = point - end;
      return std::hypot(way.x, way.y) <= room;
    };
    // beyond an end, and beyond pieces that are no longer than rounding
    for (const bool is_forward : {false, true}) {
      Curve_place at = p;
      const auto& points = piece(p).control_points();
      bool goes_on = (p.t < 0.5) != is_forward && is_at(is_forward ? points.back() : points.front());
      while (goes_on && names.size() <= count &&
             (curve.is_closed || (is_forward ? at.bezier + 1 < count : at.bezier > 0))) {
        const auto next = (at.bezier + (is_forward ? 1 : count - 1)) % count;
        at = {p.curve, static_cast<decltype(p.bezier)>(next), is_forward ? 0.0 : 1.0};
        names.push_back(at);
        const auto& of_next = piece(at).control_points();
        goes_on = std::all_of(of_next.begin(), of_next.end(), is_at);
      }
    }
    return names;
  }

  /// The part of the boundary between two feet.
  /// \param begin, end each foot as a place, on all pieces that have it
  /// \return nothing where they are on no common piece
  [[nodiscard]] std::optional<Axis_tile> tile_between(const std::vector<Curve_place>& begin,
                                                      const std::vector<Curve_place>& end,
                                                      const Medial_axis_2::Sample& first,
                                                      const Medial_axis_2::Sample& last) const {
    std::optional<Axis_tile> tile;
    // a closed curve of few pieces has two ways: discs between touch one of them
    double least = std::numeric_limits<double>::infinity();
    const Xy<double> center = 0.5 * (first.center + last.center);
    const double radius = 0.5 * (first.radius + last.radius);
    for (const Curve_place& b : begin)
      for (const Curve_place& e : end) {
        if (b.curve != e.curve || b.bezier != e.bezier) continue;
        const Xy<double> middle = piece(b).point(b.t + 0.5 * (e.t - b.t)), way = middle - center,
                         from = piece(b).point(b.t) - middle, to = piece(b).point(e.t) - middle;
        const double miss = std::fabs(std::hypot(way.x, way.y) - radius);
        const bool is_point = std::hypot(from.x, from.y) + std::hypot(to.x, to.y) <= room;
        if (miss < least) least = miss, tile = Axis_tile{b, e, &first, &last, is_point};
      }
    return tile;
  }

  /// The disc that touches half way along one tile and anywhere on the other one. Halving: (q - p).(Tq - Tp) grows
  /// along q's tile.
  [[nodiscard]] std::optional<Medial_axis_2::Sample> disc_between(const Cells& cells) const {
    const bool is_half_of_left = cells.right.is_point;
    const Axis_tile &tile = is_half_of_left ? cells.left : cells.right,
                    &other = is_half_of_left ? cells.right : cells.left;
    Tile_jet p{};
    if (tile.is_point) {
      const Xy<double> at = point(tile.begin), way = 0.5 * (tile.first->center + tile.last->center) - at;
      const double far = stable_norm(way);
      if (!(far > 0)) return std::nullopt;
      p = {at, {way.y / far, -way.x / far}};
    } else {
      p = jet_at(tile, 0.5);
    }
    Tile_jet q{};
    double low = 0, high = 1;
    if (other.is_point) q.point = point(other.begin);
    constexpr int STEPS = 40;
    for (int i = 0; i < STEPS && !other.is_point; ++i) {
      const double share = 0.5 * (low + high);
      q = jet_at(other, share);
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

 private:
  // A point of a tile; the tangent has the region on its left.
  struct Tile_jet {
    Xy<double> point, tangent;
  };
  [[nodiscard]] Tile_jet jet_at(const Axis_tile& tile, double share) const {
    const Checked_point p = jet(place_at(tile, share));
    const Xy<double> d = middle(p.derivative);
    const double speed = stable_norm(d) * (tile.end.t < tile.begin.t ? -1 : 1);
    return {middle(p.point), {d.x / speed, d.y / speed}};
  }
};

}  // namespace CGAL::Bounding_arcs::verify

#endif
