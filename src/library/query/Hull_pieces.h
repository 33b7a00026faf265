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
#include "query_units.h"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/convex_hull_2.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <iterator>
#include <tuple>
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

/// The convex polygon of few samples of a drawing, and the pieces that the hull's boundary is made of, for tolerances
/// so fine that low pieces are too many: their number grows as the root of 1 / tolerance.
///
/// A piece over an edge of the polygon that turns to the left is a cap: all of it is on the hull where what is before
/// and behind it turns to the left, too.  For a line through a corner has the polygon on its left if its direction is
/// between those of both edges there, and a cap is within its end tangents.  A dent of a sine s at a corner between
/// parts of lengths l and m is no deeper than s times either, and counts as height.
///
///        ___ cap ___          What is no cap is halved until it is inside the polygon or low, which only pieces are
///      a ----------- b        that have the end of a bitangent, some dozens for each.  Where such a piece rises above
///     /   polygon     \       an edge, its cap is halved, too, as the polygon shall come to hold what is beneath.
class Hull_outline {
 public:
  /// \param tolerance of heights of pieces that are no caps
  Hull_outline(const Segment_hierarchy& curves, double tolerance) : hull_(curves), tolerance_(tolerance) {
    do {
      hull_.drop_inside(tolerance);
      find_caps();
      mark_what_is_no_cap();
    } while (hull_.halve_marked());
  }

  [[nodiscard]] const Hull_pieces& hull() const { return hull_; }
  /// How far the hull may be beside caps and edges of the polygon.
  [[nodiscard]] double height() const {
    double most = dent_;
    for (const Hull_pieces::Part& p : hull_.parts()) most = p.is_low ? (std::max)(most, p.height) : most;
    return most + 2 * hull_.error();
  }

 private:
  static constexpr std::size_t NONE = static_cast<std::size_t>(-1);
  // Pieces over an edge of the polygon, in its direction.
  struct Cap {
    int count = 0;
    Xy<double> start, end;  // unit tangents of the only one
    double unsure = 0;
  };

  // Pieces whose ends are neighbouring corners, and which are beyond that edge. An edge with two of them has none.
  void find_caps() {
    const Convex_polygon& polygon = hull_.polygon();
    const std::size_t n = polygon.size();
    std::vector<std::tuple<double, double, std::size_t>> corners;
    for (std::size_t i = 0; i < n; ++i) corners.emplace_back(polygon[i].x, polygon[i].y, i);
    std::sort(corners.begin(), corners.end());
    const auto corner = [&](const Xy<double>& p) {
      const auto found = std::lower_bound(corners.begin(), corners.end(), std::tuple(p.x, p.y, std::size_t(0)));
      return found != corners.end() && polygon[std::get<2>(*found)] == p ? std::get<2>(*found) : NONE;
    };
    caps_.assign(n, Cap());
    edges_.assign(hull_.parts().size(), NONE);
    for (std::size_t i = 0; i < edges_.size(); ++i) {
      const Hull_pieces::Part& part = hull_.parts()[i];
      const Spiral_piece_2& p = part.piece;
      constexpr double GOOD = 0x1p-16;
      const double unsure = (std::max)(p.first.tangent_error, p.last.tangent_error), bulge = part.fat.arc.bulge;
      if (part.is_low || hull_.curves().is_straight(p.segment) || !(unsure <= GOOD) || bulge == 0) continue;
      const bool is_forward = bulge > 0;
      const Spiral_sample &from = is_forward ? p.first : p.last, &to = is_forward ? p.last : p.first;
      const std::size_t a = corner(from.point), b = corner(to.point);
      if (a == NONE || b == NONE || (a + 1) % n != b) continue;
      const double sign = is_forward ? 1 : -1;
      const Xy<double> start = sign * from.tangent, end = sign * to.tangent, chord = to.point - from.point;
      const double room = (unsure + 8 * HALF_ULP) * euclidean_norm(chord) + 2 * hull_.curves().error(p.segment);
      // all of it turns to the left, from one side of the chord to the other
      if (!(cross(start, chord) > room && cross(chord, end) > room && cross(start, end) > 2 * unsure)) continue;
      edges_[i] = a;
      caps_[a] = {caps_[a].count + 1, start, end, unsure};
    }
    for (std::size_t& edge : edges_)
      if (edge != NONE && caps_[edge].count > 1) edge = NONE;
  }

  void mark_what_is_no_cap() {
    std::vector<Hull_pieces::Part>& parts = hull_.parts();
    std::vector<char> is_disturbed(hull_.polygon().size(), 0);
    dent_ = 0;
    for (std::size_t i = 0; i < parts.size(); ++i) {
      if (parts[i].is_low || (edges_[i] != NONE && is_convex(edges_[i]))) continue;
      edges_[i] = NONE;
      disturb(parts[i].fat, is_disturbed);
    }
    for (std::size_t i = 0; i < parts.size(); ++i)
      parts[i].is_marked = edges_[i] == NONE || is_disturbed[edges_[i]] != 0;
  }
  // Whether what is before and behind a cap turns to the left, but for a dent.
  [[nodiscard]] bool is_convex(std::size_t edge) {
    const std::size_t n = hull_.polygon().size(), before = (edge + n - 1) % n, next = (edge + 1) % n;
    const double most = (std::max)(dent_between(before, edge), dent_between(edge, next));
    constexpr double PART = 0.5;  // of what low pieces may be high
    if (!(most <= PART * (std::max)(tolerance_, 64 * hull_.error()))) return false;
    dent_ = (std::max)(dent_, most);
    return true;
  }
  struct Direction {
    Xy<double> unit;
    double unsure;
  };
  [[nodiscard]] Xy<double> side(std::size_t edge) const {
    const Convex_polygon& p = hull_.polygon();
    return p[(edge + 1) % p.size()] - p[edge];
  }
  [[nodiscard]] Direction direction(std::size_t edge, bool at_end) const {
    const Cap& c = caps_[edge];
    if (c.count == 1) return {at_end ? c.end : c.start, c.unsure};
    return {(1 / euclidean_norm(side(edge))) * side(edge), 0};
  }
  // Corners are within the error of the curves, which turns edges: 2 e of a length.
  [[nodiscard]] double dent_between(std::size_t before, std::size_t next) const {
    const Direction u = direction(before, true), v = direction(next, false);
    const double sine = u.unsure + v.unsure + 16 * HALF_ULP - cross(u.unit, v.unit);
    const double shorter = (std::min)(euclidean_norm(side(before)), euclidean_norm(side(next)));
    return sine > 0 ? sine * shorter + 4 * hull_.error() : 0;
  }

  // Marks the edges that a piece may be above of.
  void disturb(const Fat_arc_2& fat, std::vector<char>& is_disturbed) const {
    if (hull_.polygon().size() < 3 || !(euclidean_norm(fat.arc.to - fat.arc.from) > 0)) {
      std::fill(is_disturbed.begin(), is_disturbed.end(), 1);
      return;
    }
    for (const Xy<double>& corner : rectangle_of(fat))
      if (!is_in(corner, hull_.polygon())) is_disturbed[edge_below(corner)] = 1;
  }
  // The edge that is crossed on the way to a point outside from one inside, or one beside it. The corners are in the
  // order of their directions from the point inside, so that half of them are left out at a time.
  [[nodiscard]] std::size_t edge_below(const Xy<double>& q) const {
    const Convex_polygon& p = hull_.polygon();
    const std::size_t n = p.size();
    const Xy<double> inside = (1.0 / 3) * (p[0] + p[n / 3] + p[2 * n / 3]);
    const Xy<double> first = p[0] - inside, to_q = q - inside;
    const bool is_q_left = cross(first, to_q) >= 0;
    const auto is_behind = [&](std::size_t corner) {  // whether the way to q comes after that to a corner
      const Xy<double> way = p[corner] - inside;
      const bool is_left = cross(first, way) >= 0;
      return is_left == is_q_left ? cross(way, to_q) >= 0 : is_left;
    };
    std::size_t low = 0, high = n;
    while (high - low > 1) {
      const std::size_t middle = low + (high - low) / 2;
      (is_behind(middle) ? low : high) = middle;
    }
    return low;
  }

  Hull_pieces hull_;
  double tolerance_, dent_ = 0;
  std::vector<Cap> caps_;           // one an edge
  std::vector<std::size_t> edges_;  // that parts are caps of
};

}  // namespace CGAL::Bounding_arcs::internal

#endif
