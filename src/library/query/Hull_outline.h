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

#include "../tree/Segment_hierarchy.h"
#include "Hull_samples.h"
#include "Work_limit.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <numeric>
#include <optional>
#include <utility>
#include <vector>

namespace CGAL::Bounding_arcs::internal {

/// The convex polygon of few samples, and the pieces that the boundary of the hull is made of.
class Hull_outline {
 public:
  /// \param tolerance of heights of pieces that are no caps
  Hull_outline(const Segment_hierarchy& curves, double tolerance)
      : curves_(curves), tolerance_(tolerance), limit_(most_pieces(curves.number_of_segments())) {
    for (std::uint32_t s = 0; s < curves.number_of_segments(); ++s) {
      active_.push_back({curves.piece(s), curves.region(s)});
      polygon_.push_back(curves.piece(s).first.point);
      polygon_.push_back(curves.piece(s).last.point);
      error_ = (std::max)(error_, curves.error(s));
    }
    polygon_ = convex_polygon(polygon_);
    while (look_at_all()) {
    }
    for (const Active& a : active_) pieces_.push_back(a.piece);
  }

  [[nodiscard]] const Convex_polygon& polygon() const { return polygon_; }
  [[nodiscard]] const std::vector<Spiral_piece_2>& pieces() const { return pieces_; }
  /// How far the hull may be beside caps and edges of the polygon.
  [[nodiscard]] double height() const { return height_ + 2 * error_; }
  [[nodiscard]] double error() const { return error_; }
  /// Whether pieces were left higher, as there were too many.
  [[nodiscard]] bool is_limited() const { return limit_.is_reached(); }

 private:
  static constexpr std::size_t NONE = static_cast<std::size_t>(-1);
  struct Active {
    Spiral_piece_2 piece;
    Fat_arc_2 fat;
    std::size_t edge = NONE;  // that it may be the cap of
  };
  // Over an edge of the polygon, in its direction.
  struct Cap {
    std::size_t piece = NONE;
    Xy<double> start, end;  // unit tangents
    double unsure = 0;
  };

  // \return whether a piece was halved
  bool look_at_all() {
    std::vector<Active> kept, next;
    for (Active& a : active_) {
      if (is_inside(a.fat, polygon_)) continue;
      if (height_of(a.fat) <= least_height(a)) keep_low(a);
      else kept.push_back(a);
    }
    active_.clear();
    find_caps(kept);
    std::vector<char> is_disturbed(polygon_.size(), 0);
    double dent = 0;
    for (Active& a : kept) {
      if (a.edge != NONE && is_convex(a.edge, dent)) continue;
      a.edge = NONE;
      disturb(a, is_disturbed);
    }
    Convex_polygon points = polygon_;
    bool is_changed = false;
    for (const Active& a : kept) {
      if (a.edge != NONE && is_disturbed[a.edge] == 0) {
        active_.push_back(a);
        continue;
      }
      const auto middle = limit_.spend() ? halves(curves_, a.piece) : std::optional<Spiral_halves_2>();
      if (!middle) {
        keep_low(a);
        continue;
      }
      is_changed = true;
      active_.push_back({middle->first, curves_.region(middle->first)});
      active_.push_back({middle->second, curves_.region(middle->second)});
      points.push_back(middle->first.last.point);
    }
    if (is_changed) polygon_ = convex_polygon(points);
    else height_ = (std::max)(height_, dent);
    return is_changed;
  }
  // How high a piece has to be to be halved: samples of lower pieces need not be convex.
  [[nodiscard]] double least_height(const Active& a) const {
    constexpr double LEAST = 64;  // times the error
    return (std::max)(tolerance_, LEAST * curves_.error(a.piece.segment));
  }
  void keep_low(const Active& a) {
    pieces_.push_back(a.piece);
    height_ = (std::max)(height_, height_of(a.fat));
  }

  // Pieces whose ends are neighbouring corners, and which are beyond that edge. An edge with two of them has none.
  void find_caps(std::vector<Active>& kept) {
    const std::size_t n = polygon_.size();
    caps_.assign(n, Cap());
    std::vector<std::size_t> order(n);
    std::iota(order.begin(), order.end(), std::size_t(0));
    const auto before = [](const Xy<double>& p, const Xy<double>& q) { return p.x != q.x ? p.x < q.x : p.y < q.y; };
    std::sort(order.begin(), order.end(),
              [&](std::size_t i, std::size_t k) { return before(polygon_[i], polygon_[k]); });
    const auto corner = [&](const Xy<double>& p) {
      const auto i = std::lower_bound(order.begin(), order.end(), p,
                                      [&](std::size_t k, const Xy<double>& q) { return before(polygon_[k], q); });
      return i != order.end() && polygon_[*i] == p ? *i : NONE;
    };
    for (std::size_t i = 0; i < kept.size(); ++i) {
      kept[i].edge = NONE;
      const Spiral_piece_2& p = kept[i].piece;
      constexpr double GOOD = 0x1p-16;
      const double unsure = (std::max)(p.first.tangent_error, p.last.tangent_error), bulge = kept[i].fat.arc.bulge;
      if (curves_.is_straight(p.segment) || !(unsure <= GOOD) || bulge == 0) continue;
      const bool is_forward = bulge > 0;
      const Spiral_sample &from = is_forward ? p.first : p.last, &to = is_forward ? p.last : p.first;
      const std::size_t a = corner(from.point), b = corner(to.point);
      if (a == NONE || b == NONE || (a + 1) % n != b) continue;
      const double sign = is_forward ? 1 : -1;
      const Xy<double> start = sign * from.tangent, end = sign * to.tangent, chord = to.point - from.point;
      const double room = (unsure + 8 * HALF_ULP) * euclidean_norm(chord) + 2 * curves_.error(p.segment);
      // all of it turns to the left, from one side of the chord to the other
      if (!(cross(start, chord) > room && cross(chord, end) > room && cross(start, end) > 2 * unsure)) continue;
      kept[i].edge = a;
      if (caps_[a].piece == NONE) {
        caps_[a] = {i, start, end, unsure};
        continue;
      }
      if (kept[caps_[a].piece].edge == a) kept[caps_[a].piece].edge = NONE;
      kept[i].edge = NONE;
      caps_[a].unsure = std::numeric_limits<double>::infinity();
    }
    for (const Active& a : kept)
      if (a.edge != NONE && !(caps_[a.edge].unsure < 1)) caps_[a.edge] = Cap();
  }
  // Whether what is before and behind a cap turns to the left, but for a dent.
  [[nodiscard]] bool is_convex(std::size_t edge, double& dent) const {
    const std::size_t n = polygon_.size(), before = (edge + n - 1) % n, next = (edge + 1) % n;
    const double at_start = dent_at(edge_end(before), edge_start(edge), length(before), length(edge)),
                 at_end = dent_at(edge_end(edge), edge_start(next), length(edge), length(next));
    const double most = (std::max)(at_start, at_end);
    constexpr double PART = 0.5;  // of what low pieces may be high
    if (!(most <= PART * (std::max)(tolerance_, 64 * error_))) return false;
    dent = (std::max)(dent, most);
    return true;
  }
  struct Direction {
    Xy<double> unit;
    double unsure;
  };
  [[nodiscard]] double length(std::size_t edge) const {
    return euclidean_norm(polygon_[(edge + 1) % polygon_.size()] - polygon_[edge]);
  }
  [[nodiscard]] Direction direction(std::size_t edge) const {
    const Xy<double> way = polygon_[(edge + 1) % polygon_.size()] - polygon_[edge];
    return {(1 / euclidean_norm(way)) * way, 0};
  }
  [[nodiscard]] Direction edge_start(std::size_t edge) const {
    const Cap& c = caps_[edge];
    return c.piece == NONE || !(c.unsure < 1) ? direction(edge) : Direction{c.start, c.unsure};
  }
  [[nodiscard]] Direction edge_end(std::size_t edge) const {
    const Cap& c = caps_[edge];
    return c.piece == NONE || !(c.unsure < 1) ? direction(edge) : Direction{c.end, c.unsure};
  }
  // Corners are within the error of the curves, which turns edges: 2 e of a length.
  [[nodiscard]] double dent_at(const Direction& u, const Direction& v, double before, double behind) const {
    const double sine = u.unsure + v.unsure + 16 * HALF_ULP - cross(u.unit, v.unit);
    return sine > 0 ? sine * (std::min)(before, behind) + 4 * error_ : 0;
  }

  // Marks the edges that a piece may be above of.
  void disturb(const Active& a, std::vector<char>& is_disturbed) const {
    if (polygon_.size() < 3 || !(euclidean_norm(a.fat.arc.to - a.fat.arc.from) > 0)) {
      std::fill(is_disturbed.begin(), is_disturbed.end(), 1);
      return;
    }
    for (const Xy<double>& corner : rectangle_of(a.fat))
      if (!is_in(corner, polygon_)) is_disturbed[edge_below(corner)] = 1;
  }
  // The edge that is crossed on the way to a point outside from one inside, or one beside it. The corners are in the
  // order of their directions from the point inside, so that half of them are left out at a time.
  [[nodiscard]] std::size_t edge_below(const Xy<double>& q) const {
    const std::size_t n = polygon_.size();
    const Xy<double> inside = (1.0 / 3) * (polygon_[0] + polygon_[n / 3] + polygon_[2 * n / 3]);
    const Xy<double> first = polygon_[0] - inside, to_q = q - inside;
    const bool is_q_left = cross(first, to_q) >= 0;
    const auto is_behind = [&](std::size_t corner) {  // whether the way to q comes after that to a corner
      const Xy<double> way = polygon_[corner] - inside;
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

  const Segment_hierarchy& curves_;
  double tolerance_, height_ = 0, error_ = 0;
  Convex_polygon polygon_;
  std::vector<Active> active_;
  std::vector<Cap> caps_;  // one an edge
  std::vector<Spiral_piece_2> pieces_;
  Work_limit limit_;
};

}  // namespace CGAL::Bounding_arcs::internal

#endif
