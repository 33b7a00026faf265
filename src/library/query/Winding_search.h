// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// How often closed curves run round a point: what crosses the ray from it to the right, upwards 1, downwards -1.
//
// The curves are moved a little: each piece between two samples becomes a way from the one computed point to the other.
// As long as both the piece and that way are in a set without holes that q is not in, nothing is changed by that, and
// what crosses the ray follows from comparing doubles: no root is computed, and a ray that touches a curve or meets a
// corner is nothing special.  Sets are
//   the box of the piece;
//   a strip over the chord, as high as arc and radius;     the strip: left or right of q as the chord is
//   the fat arc.  Between chord and arc, q is run round     .---.
//   once more than the chord tells.                        / q   \   <- more than the chord: -1 left to right
// Tubes round arcs of up to half a circle have no holes: nowhere is the distance from the arc greater than all about.
// A piece that q is not told apart from is halved, and in the end decided by exact arithmetic, with the ways from the
// computed to the exact ends added; those ways count for the next piece the other way round.

#ifndef BOUNDING_ARCS_LIBRARY_QUERY_WINDING_SEARCH_H
#define BOUNDING_ARCS_LIBRARY_QUERY_WINDING_SEARCH_H

#include <CGAL/Bounding_arcs_2/number/convert.h>
#include <CGAL/Bounding_arcs_2/query/Query_point.h>
#include <CGAL/Bounding_arcs_2/query/kernel_points.h>
#include "../tree/Segment_hierarchy.h"
#include "exact_intersections.h"

#include <CGAL/number_utils.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <optional>

namespace CGAL::Bounding_arcs {

/// Counts how often closed curves run round a point: what crosses the ray from it to the right, upwards 1, downwards
/// -1.
class Winding_search {
 public:
  /// \param q in the unit of the curves
  Winding_search(const Segment_hierarchy& curves, const Asked_point& q)
      : Winding_search(curves, q, curves.decisions()) {}
  Winding_search(const Segment_hierarchy& curves, const Asked_point& q, Decisions decisions)
      : curves_(curves), decisions_(decisions), asked_(q), q_(q.point), error_(q.error) {
    if (q.exact) y_is_more_ = static_cast<int>(CGAL::sign(Exact_rational(q.exact->y - Exact_rational(q_.y))));
  }

  void search() {
    const auto is_met = [this](const Box_tree::Node& node, std::size_t k) { return may_meet(node.box(k)); };
    for_each_item(curves_.boxes(), is_met, [this](const Box_tree::Node& node, std::size_t k) {
      const Spiral_piece_2 piece = curves_.piece(node.child[k]);
      if (is_left_of(node.x_low[k])) number_ += rise(piece);
      else look_at(piece, curves_.region(node.child[k]), curves_.error(piece.segment));
      return !is_on_;
    });
  }
  /// Counts what one piece crosses. The sum over closed chains of pieces is how often they run round the point.
  /// \param error how far the piece's computed points may be from the exact curve's
  [[nodiscard]] int crossings_of(const Spiral_piece_2& piece, double error) {
    const int before = number_;
    count(piece, error);
    return number_ - before;
  }

  [[nodiscard]] int number() const { return number_; }
  /// How often curves rise through the point: to the left of it the number is that much more.
  [[nodiscard]] int passing() const { return passing_; }
  [[nodiscard]] bool is_on() const { return is_on_; }
  /// Pieces were left open, as no exact arithmetic was asked for.
  [[nodiscard]] bool is_undecided() const { return is_undecided_; }

 private:
  // The ray from the point to the right; a curve beside it crosses nothing.
  [[nodiscard]] bool may_meet(const CGAL::Bbox_2& box) const {
    return box.ymin() <= q_.y + error_ && q_.y - error_ <= box.ymax() && q_.x - error_ <= box.xmax();
  }
  [[nodiscard]] bool is_left_of(double x) const { return q_.x + error_ < x; }

  // Doubles next to the exact height, which was rounded to the nearest one, are on the same side of both.
  [[nodiscard]] bool is_below(double y) const { return y < q_.y || (y == q_.y && y_is_more_ > 0); }
  [[nodiscard]] int rise(const Spiral_piece_2& p) const {
    return static_cast<int>(is_below(p.first.point.y)) - static_cast<int>(is_below(p.last.point.y));
  }

  void count(const Spiral_piece_2& piece, double error) {
    const CGAL::Bbox_2 box = curves_.box(piece, error);
    if (!may_meet(box)) return;
    if (is_left_of(box.xmin())) number_ += rise(piece);
    else look_at(piece, fat_arc(piece, error), error);
  }
  // q may be in the box.
  void look_at(const Spiral_piece_2& piece, const Fat_arc_2& fat, double error) {
    if (const std::optional<int> crossings = beside(piece, fat, error)) {
      number_ += *crossings;
      return;
    }
    constexpr double THIN = 4;  // times the error: halving makes fat arcs no thinner
    const bool is_short = !(euclidean_norm(fat.arc.to - fat.arc.from) > SHORT * error);
    const auto middle =
        is_short || fat.radius <= THIN * error ? std::optional<Spiral_halves_2>() : halves(curves_, piece);
    if (!middle) return decide(piece);
    count(middle->first, error);
    count(middle->second, error);
  }

  // Chord and arc as the way.  Its ends are doubles, so nothing is moved but the curve within the fat arc; the chord
  // matters where q is off it by more than the rounding of h, products of vectors no longer than the box: 16 u L.
  [[nodiscard]] std::optional<int> beside(const Spiral_piece_2& piece, const Fat_arc_2& fat, double error) const {
    const Xy<double> chord = fat.arc.to - fat.arc.from;
    const double length = euclidean_norm(chord);
    if (!(length > SHORT * error)) return std::nullopt;
    const double height = cross(chord, q_ - fat.arc.from) / length, apex = -0.5 * fat.arc.bulge * length;
    const double room = 32 * HALF_ULP * length + 2 * error_;
    if (!(std::fabs(height) > room)) return std::nullopt;
    const int way = rise(piece), side = height > 0 ? 1 : -1;
    const int of_chord = way == side ? way : 0;
    const bool is_off_strip =
        height > (std::max)(0.0, apex) + fat.radius + room || height < (std::min)(0.0, apex) - fat.radius - room;
    if (is_off_strip) return of_chord;
    const double d = signed_distance(q_, fat.arc);
    if (!(std::fabs(d) > internal::distance_room(std::fabs(d), length, fat.radius + error_))) return std::nullopt;
    // the arc is on the other side of the chord than its center, to the right for a left turn
    const int turn = fat.arc.bulge > 0 ? 1 : -1;
    const bool is_between = fat.arc.bulge != 0 && side == -turn && (d > 0) == (turn > 0);
    return of_chord + (is_between ? turn : 0);
  }

  void decide(const Spiral_piece_2& piece) {
    if (decisions_ == Decisions::DOUBLE) {
      is_undecided_ = true;
      return;
    }
    const Exact_crossings crossings = exact_crossings(
        asked_.exactly(), curves_.exact_bezier(curves_.bezier_of(piece.segment)), piece.first.t, piece.last.t,
        convert<Exact_rational>(piece.first.point), convert<Exact_rational>(piece.last.point));
    number_ += crossings.number;
    passing_ += crossings.passing;
    is_on_ = is_on_ || crossings.is_on;
  }

  // Times the error: of a chord no longer than that no side is told.
  static constexpr double SHORT = 64;

  const Segment_hierarchy& curves_;
  Decisions decisions_;
  Asked_point asked_;
  Xy<double> q_;
  double error_;       // of its coordinates
  int y_is_more_ = 0;  // the sign of what its height was rounded by
  int number_ = 0, passing_ = 0;
  bool is_on_ = false, is_undecided_ = false;
};

/// Returns how often the curves run round a point, which is in their unit.
[[nodiscard]] inline Winding_number winding_number(const Segment_hierarchy& curves, const Asked_point& q) {
  Winding_search search(curves, q);
  search.search();
  if (search.is_on()) return {Winding_number::State::ON, 0};
  if (search.is_undecided()) return {Winding_number::State::UNDECIDED, 0};
  return {Winding_number::State::DECIDED, search.number()};
}

}  // namespace CGAL::Bounding_arcs

#endif
