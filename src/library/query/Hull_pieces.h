// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The convex polygon of samples of a drawing, and the pieces that may rise above it.
//
// A piece is in a rectangle over its chord, as high as its arc and radius.  Pieces that a search marks are halved, and
// the points where they are cut become samples: near the hull only, so that most of a drawing is looked at once.

#ifndef BOUNDING_ARCS_LIBRARY_QUERY_HULL_PIECES_H
#define BOUNDING_ARCS_LIBRARY_QUERY_HULL_PIECES_H

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

/// The convex polygon of samples, and the pieces that may rise above it.
class Hull_pieces {
 public:
  struct Part {
    Spiral_piece_2 piece;
    Fat_arc_2 fat;
    double height;
    bool is_low = false, is_marked = false;  ///< what is low is not halved any more
  };

  explicit Hull_pieces(const Segment_hierarchy& curves)
      : curves_(curves), limit_(most_pieces(curves.number_of_segments())) {
    for (std::uint32_t s = 0; s < curves.number_of_segments(); ++s) {
      add(curves.piece(s), curves.region(s));
      for (const Spiral_sample& end : {curves.piece(s).first, curves.piece(s).last}) polygon_.push_back(end.point);
      error_ = (std::max)(error_, curves.error(s));
    }
    polygon_ = convex_polygon(polygon_);
  }

  [[nodiscard]] const Segment_hierarchy& curves() const { return curves_; }
  /// The hull's corners are within error() of the curves.
  [[nodiscard]] const Convex_polygon& polygon() const { return polygon_; }
  /// In the order of the curves. What is left out is inside the polygon but for error().
  [[nodiscard]] std::vector<Part>& parts() { return parts_; }
  [[nodiscard]] const std::vector<Part>& parts() const { return parts_; }
  [[nodiscard]] double error() const { return error_; }
  /// The hull is within the polygon and a band this wide about it.
  [[nodiscard]] double height() const {
    double most = 0;
    for (const Part& p : parts_) most = (std::max)(most, p.height);
    return most + 2 * error_;
  }
  /// Whether pieces were left as they were, as there were too many.
  [[nodiscard]] bool is_limited() const { return limit_.is_reached(); }

  /// Leaves out pieces that are inside the polygon before they are low, which those within a tolerance are.
  void drop_inside(double tolerance) {
    const auto is_needless = [this](const Part& p) { return !p.is_low && is_inside(p.fat, polygon_); };
    parts_.erase(std::remove_if(parts_.begin(), parts_.end(), is_needless), parts_.end());
    for (Part& p : parts_) p.is_low = p.is_low || p.height <= (std::max)(tolerance, least_height(p));
  }
  /// Halves pieces until all that are not inside the polygon are within a tolerance, for what is to come later.
  void lower(double tolerance) {
    do {
      drop_inside(tolerance);
      for (Part& p : parts_) p.is_marked = true;
    } while (halve_marked());
    for (Part& p : parts_) p.is_low = false;
  }
  /// Halves the pieces that are marked and not low.
  /// \param wants wants(point): whether a point where they are cut is to be a sample
  /// \return whether there was one
  bool halve_marked() {
    return halve_marked([](const Xy<double>&) { return true; });
  }
  template <class Wants> bool halve_marked(const Wants& wants) {
    const std::vector<Part> before = std::exchange(parts_, {});
    Convex_polygon points = polygon_;
    for (Part p : before) {
      const bool is_asked = std::exchange(p.is_marked, false) && !p.is_low && p.height > least_height(p);
      const auto middle = is_asked && limit_.spend() ? halves(curves_, p.piece) : std::optional<Spiral_halves_2>();
      if (!middle) {
        p.is_low = p.is_low || is_asked;  // as far as can be
        parts_.push_back(p);
        continue;
      }
      add(middle->first, curves_.region(middle->first));
      add(middle->second, curves_.region(middle->second));
      if (wants(middle->first.last.point)) points.push_back(middle->first.last.point);
    }
    const bool is_changed = parts_.size() > before.size();
    if (is_changed) polygon_ = convex_polygon(points);
    return is_changed;
  }

 private:
  void add(const Spiral_piece_2& piece, const Fat_arc_2& fat) { parts_.push_back({piece, fat, height_of(fat)}); }
  // How high a piece has to be to be halved: samples of lower pieces need not be convex.
  [[nodiscard]] double least_height(const Part& p) const {
    constexpr double LEAST = 64;  // times the error
    return LEAST * curves_.error(p.piece.segment);
  }

  const Segment_hierarchy& curves_;
  Convex_polygon polygon_;
  std::vector<Part> parts_;
  double error_ = 0;
  Work_limit limit_;
};

}  // namespace CGAL::Bounding_arcs::internal

#endif
