// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The convex polygon of samples of a drawing, and the pieces that may rise above it, none by more than a tolerance.
//
// A piece is in a rectangle over its chord, as high as its arc and radius.  It is left out where that is inside the
// polygon, else halved until the rectangle is low: near the hull only, so that most of a drawing is looked at once.

#ifndef BOUNDING_ARCS_LIBRARY_QUERY_HULL_SAMPLES_H
#define BOUNDING_ARCS_LIBRARY_QUERY_HULL_SAMPLES_H

#include "../tree/Segment_hierarchy.h"
#include "Work_limit.h"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/convex_hull_2.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <iterator>
#include <optional>
#include <utility>
#include <vector>

namespace CGAL::Bounding_arcs::internal {

/// Corners counterclockwise, none on the line through its neighbours. One or two where all points are on a line.
using Convex_polygon = std::vector<Xy<double>>;

[[nodiscard]] inline Convex_polygon convex_polygon(const Convex_polygon& points) {
  using Point = CGAL::Exact_predicates_inexact_constructions_kernel::Point_2;
  std::vector<Point> all, corners;
  for (const Xy<double>& p : points) all.emplace_back(p.x, p.y);
  CGAL::convex_hull_2(all.begin(), all.end(), std::back_inserter(corners));
  Convex_polygon result;
  for (const Point& p : corners) result.push_back({p.x(), p.y()});
  return result;
}

/// Whether a point is in a polygon or on its boundary, exactly.
/// \complexity logarithmic
[[nodiscard]] inline bool is_in(const Xy<double>& q, const Convex_polygon& polygon) {
  using Point = CGAL::Exact_predicates_inexact_constructions_kernel::Point_2;
  if (polygon.size() < 3) return false;
  const auto is_left = [&](const Xy<double>& a, const Xy<double>& b) {
    return CGAL::orientation(Point(a.x, a.y), Point(b.x, b.y), Point(q.x, q.y)) != CGAL::RIGHT_TURN;
  };
  if (!is_left(polygon.front(), polygon[1])) return false;
  // the last corner that q is left of, seen from the first one
  std::size_t low = 1, high = polygon.size();
  while (high - low > 1) {
    const std::size_t middle = low + (high - low) / 2;
    (is_left(polygon.front(), polygon[middle]) ? low : high) = middle;
  }
  if (high == polygon.size()) return is_left(polygon[low], polygon.front()) && !is_left(polygon.front(), polygon[low]);
  return is_left(polygon[low], polygon[high]);
}

/// How far a piece may be from its chord.
[[nodiscard]] inline double height_of(const Fat_arc_2& fat) {
  return (0.5 * std::fabs(fat.arc.bulge) * euclidean_norm(fat.arc.to - fat.arc.from) + fat.radius) * ROUNDED_UP<8>;
}

/// The corners of the rectangle that holds a piece; rounding moves them by less than the piece's error.
/// \pre the ends of its chord are two points
[[nodiscard]] inline std::array<Xy<double>, 4> rectangle_of(const Fat_arc_2& fat) {
  const Xy<double> chord = fat.arc.to - fat.arc.from;
  const double length = euclidean_norm(chord);
  const Xy<double> along = (1 / length) * chord, across = perp(along);
  const double apex = -0.5 * fat.arc.bulge * length;
  const double low = (std::min)(0.0, apex) - fat.radius, high = (std::max)(0.0, apex) + fat.radius;
  const Xy<double> from = fat.arc.from - fat.radius * along, to = fat.arc.to + fat.radius * along;
  return {from + low * across, from + high * across, to + low * across, to + high * across};
}
/// Whether that rectangle is inside a polygon.
[[nodiscard]] inline bool is_inside(const Fat_arc_2& fat, const Convex_polygon& polygon) {
  if (!(euclidean_norm(fat.arc.to - fat.arc.from) > 0) || polygon.size() < 3) return false;
  for (const Xy<double>& corner : rectangle_of(fat))
    if (!is_in(corner, polygon)) return false;
  return true;
}

/// The longer side of a drawing's box.
[[nodiscard]] inline double extent_of(const Segment_hierarchy& curves) {
  const CGAL::Bbox_2& box = curves.boxes().box();
  return (std::max)(box.xmax() - box.xmin(), box.ymax() - box.ymin());
}
/// Whether low pieces are so many that it pays to tell first which of them matter.
[[nodiscard]] inline bool is_fine(const Segment_hierarchy& curves, double tolerance) {
  constexpr double FINE = 0x1p-20;  // of the extent; pieces are about the root of its inverse
  return tolerance < FINE * extent_of(curves);
}

/// The convex polygon of samples, and the pieces that may rise above it.
class Hull_samples {
 public:
  /// \param tolerance of heights of pieces
  Hull_samples(const Segment_hierarchy& curves, double tolerance)
      : curves_(curves), limit_(most_pieces(curves.number_of_segments())) {
    std::vector<Spiral_piece_2> active;
    for (std::uint32_t s = 0; s < curves.number_of_segments(); ++s) {
      active.push_back(curves.piece(s));
      polygon_.push_back(curves.piece(s).first.point);
      polygon_.push_back(curves.piece(s).last.point);
      error_ = (std::max)(error_, curves.error(s));
    }
    polygon_ = convex_polygon(polygon_);
    while (!active.empty()) {
      std::vector<Spiral_piece_2> next;
      Convex_polygon points = polygon_;
      for (const Spiral_piece_2& p : active) look_at(p, tolerance, next, points);
      polygon_ = convex_polygon(points);
      active = std::move(next);
    }
  }

  /// The hull's corners are within error() of the curves.
  [[nodiscard]] const Convex_polygon& polygon() const { return polygon_; }
  /// All that are not inside the polygon but for error().
  [[nodiscard]] const std::vector<Spiral_piece_2>& pieces() const { return pieces_; }
  /// The hull is within the polygon and a band this wide about it.
  [[nodiscard]] double height() const { return height_ + 2 * error_; }
  [[nodiscard]] double error() const { return error_; }
  /// Whether pieces were left higher, as there were too many.
  [[nodiscard]] bool is_limited() const { return limit_.is_reached(); }

 private:
  void look_at(const Spiral_piece_2& piece, double tolerance, std::vector<Spiral_piece_2>& next,
               Convex_polygon& points) {
    const Fat_arc_2 fat = curves_.region(piece);
    if (is_inside(fat, polygon_)) return;
    constexpr double LEAST = 64;  // times the error: of lower pieces samples need not be convex
    const double height = height_of(fat);
    const bool is_low = height <= (std::max)(tolerance, LEAST * curves_.error(piece.segment));
    const auto middle = is_low || !limit_.spend() ? std::optional<Spiral_halves_2>() : halves(curves_, piece);
    if (!middle) {
      pieces_.push_back(piece);
      height_ = (std::max)(height_, height);
      return;
    }
    next.push_back(middle->first);
    next.push_back(middle->second);
    points.push_back(middle->first.last.point);
  }

  const Segment_hierarchy& curves_;
  Convex_polygon polygon_;
  std::vector<Spiral_piece_2> pieces_;
  double height_ = 0, error_ = 0;
  Work_limit limit_;
};

}  // namespace CGAL::Bounding_arcs::internal

#endif
