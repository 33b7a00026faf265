// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The convex polygon of few samples of a drawing, and the pieces that the hull's boundary is made of, for tolerances
// so fine that low pieces are too many: their number grows as the root of 1 / tolerance.
//
// A piece over an edge of the polygon that turns to the left is a cap: all of it is on the hull where what is before
// and behind it turns to the left, too.  For a line through a corner has the polygon on its left if its direction is
// between those of both edges there, and a cap is within its end tangents.  A dent of a sine s at a corner between
// parts of lengths l and m is no deeper than s times either, and counts as height.
//
//        ___ cap ___          What is no cap is halved until it is inside the polygon or low, which only pieces are
//      a ----------- b        that have the end of a bitangent, some dozens for each.  Where such a piece rises above
//     /   polygon     \       an edge, its cap is halved, too, as the polygon shall come to hold what is beneath.

#ifndef BOUNDING_ARCS_LIBRARY_QUERY_HULL_OUTLINE_H
#define BOUNDING_ARCS_LIBRARY_QUERY_HULL_OUTLINE_H

#include "Hull_pieces.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <tuple>
#include <vector>

namespace CGAL::Bounding_arcs::internal {

/// The convex polygon of few samples, and the pieces that the boundary of the hull is made of.
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
