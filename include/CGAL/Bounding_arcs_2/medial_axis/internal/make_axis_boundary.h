// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Which sides of which curves have a region, and the rings of elements there.

#ifndef CGAL_BOUNDING_ARCS_2_MEDIAL_AXIS_INTERNAL_MAKE_AXIS_BOUNDARY_H
#define CGAL_BOUNDING_ARCS_2_MEDIAL_AXIS_INTERNAL_MAKE_AXIS_BOUNDARY_H

#include <CGAL/Bounding_arcs_2/curve/Fill_rule.h>
#include <CGAL/Bounding_arcs_2/medial_axis/internal/Axis_boundary.h>
#include <CGAL/Bounding_arcs_2/medial_axis/internal/Axis_job.h>
#include <CGAL/Bounding_arcs_2/query/Winding_search.h>
#include <CGAL/Bounding_arcs_2/tree/Directed_segment.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <utility>
#include <vector>

namespace CGAL::Bounding_arcs::internal {

/// A piece as a ring goes along it.
struct Directed_piece {
  const Spiral_piece_2& piece;
  bool is_reversed;
  [[nodiscard]] const Spiral_sample& first() const { return is_reversed ? piece.last : piece.first; }
  [[nodiscard]] const Spiral_sample& last() const { return is_reversed ? piece.first : piece.last; }
  [[nodiscard]] Xy<double> tangent(const Spiral_sample& end) const { return is_reversed ? -end.tangent : end.tangent; }
  // Signed: the piece turns to one side.
  [[nodiscard]] double curvature(const Spiral_sample& end) const {
    return std::copysign(end.most_curvature / 2 + end.least_curvature / 2, cross(tangent(first()), tangent(last())));
  }
};

class Axis_boundary_maker {
 public:
  /// Makes the boundary of what closed curves fill. \pre none has both sides filled
  Axis_boundary_maker(const Segment_hierarchy& curves, Fill_rule rule, Index_loop loop)
      : curves_(curves), rule_(rule), boundary_(curves) {
    find_sides(loop);
    add_curves();
  }
  /// Makes the boundary of all that is within the last curve, which is closed; the others, within it, are walls.
  [[nodiscard]] static Axis_boundary_maker framed(const Segment_hierarchy& curves) {
    Axis_boundary_maker made(curves);
    made.is_framed_ = true;
    made.add_curves();
    return made;
  }
  /// Makes the boundary of what is to the left of closed curves that may meet themselves and each other at joints.
  /// \param is_ccw of each curve: the region is within it
  [[nodiscard]] static Axis_boundary_maker directed(const Segment_hierarchy& curves, const std::vector<bool>& is_ccw) {
    Axis_boundary_maker made(curves);
    made.is_ccw_ = &is_ccw;
    made.add_curves();
    return made;
  }
  /// Makes the boundary of faces that are cut out by curves: each ring has one on its left.
  [[nodiscard]] static Axis_boundary_maker faces(const Segment_hierarchy& curves,
                                                 const std::vector<std::vector<Directed_segment>>& rings) {
    Axis_boundary_maker made(curves);
    for (std::size_t i = 0; i < rings.size(); ++i) {
      std::vector<Directed_segment> way;
      for (const Directed_segment& s : rings[i])
        if (made.is_long(s.segment)) way.push_back(s);
      // both sides of a curve may be in different rings: these are told apart by numbers of their own
      const auto number = static_cast<std::uint32_t>(i);
      if (!way.empty()) made.add_ring(number, way, made.is_counterclockwise(way));
      else if (!rings[i].empty() && made.is_lone_point(rings[i].front()))
        made.add_point(number, rings[i].front().segment);
    }
    return made;
  }
  /// Returns the numbers of closed curves, which do not cross, whose sides a rule fills both.
  [[nodiscard]] static std::vector<std::uint32_t> curves_within(const Segment_hierarchy& curves, Fill_rule rule,
                                                                Index_loop loop) {
    std::vector<std::uint32_t> within;
    const auto count = static_cast<std::uint32_t>(curves.drawing().curves().size());
    if (rule == Fill_rule::EVEN_ODD || count < 2) return within;  // each of them separates
    Axis_boundary_maker made(curves);
    made.rule_ = rule;
    made.find_sides(loop);
    for (std::uint32_t c = 0; c < count; ++c) {
      const Sides& sides = made.sides_[c];
      if (sides.left && sides.right && sides.are_decided) within.push_back(c);
    }
    return within;
  }
  [[nodiscard]] Axis_boundary boundary() && { return std::move(boundary_); }
  /// Where that is false, a side of a curve could not be told inside from outside.
  [[nodiscard]] bool is_decided() const { return is_decided_; }

 private:
  explicit Axis_boundary_maker(const Segment_hierarchy& curves) : curves_(curves), boundary_(curves) {}
  // By curve; the last one is the end.
  [[nodiscard]] std::vector<std::uint32_t> first_segments() const {
    const auto count = static_cast<std::uint32_t>(curves_.number_of_segments());
    std::vector<std::uint32_t> first(curves_.drawing().curves().size() + 1, count);
    for (std::uint32_t s = count; s-- > 0;) first[curves_.place(s).curve] = s;
    for (std::size_t c = first.size() - 1; c-- > 0;) first[c] = (std::min)(first[c], first[c + 1]);
    return first;
  }
  [[nodiscard]] std::vector<std::uint32_t> long_segments(std::uint32_t first, std::uint32_t last) const {
    std::vector<std::uint32_t> segments;
    for (std::uint32_t s = first; s < last; ++s)
      if (is_long(s)) segments.push_back(s);
    return segments;
  }
  void add_curves() {
    const std::vector<std::uint32_t> first = first_segments();
    for (std::uint32_t c = 0; c + 1 < first.size(); ++c) add_curve(c, first[c], first[c + 1]);
  }
  void add_curve(std::uint32_t curve, std::uint32_t first, std::uint32_t last) {
    const std::vector<std::uint32_t> segments = long_segments(first, last);
    if (segments.empty()) {
      if (is_framed_ && first < last) add_point(curve, first);
      return;
    }
    if (!curves_.drawing().curves()[curve].is_closed) {
      std::vector<Directed_segment> way = side(segments, false);
      for (const Directed_segment& s : side(segments, true)) way.push_back(s);
      add_ring(curve, way, false);
      return;
    }
    if (is_ccw_ != nullptr) {
      add_ring(curve, side(segments, false), (*is_ccw_)[curve]);
      return;
    }
    const bool is_ccw = is_counterclockwise(side(segments, false));
    const bool is_frame = curve + 1 == curves_.drawing().curves().size();
    const Sides sides = !is_framed_ ? sides_[curve] : Sides{!is_frame || is_ccw, !is_frame || !is_ccw};
    is_decided_ = is_decided_ && sides.are_decided;
    if (sides.left) add_ring(curve, side(segments, false), is_ccw);
    if (sides.right) add_ring(curve, side(segments, true), !is_ccw);
  }
  // A curve that is a point has a ring on either side, or one along both.
  [[nodiscard]] bool is_lone_point(const Directed_segment& s) const {
    const Spiral_piece_2& p = curves_.piece(s.segment);
    const auto& curve = curves_.drawing().curves()[curves_.place(s.segment).curve];
    return !s.is_reversed && curve.beziers.size() == 1 && p.first.point == p.last.point;
  }
  // Shorter are points, and what is between two cuts that are nearly one.
  [[nodiscard]] bool is_long(std::uint32_t segment) const {
    const Spiral_piece_2& p = curves_.piece(segment);
    return euclidean_norm(p.last.point - p.first.point) > boundary_.resolution();
  }
  // A ring, which may come to a point more than once, runs round its face from outside unless what is next to its
  // farthest point, to the right, is on its left one of the times that it is there.
  [[nodiscard]] bool is_counterclockwise(const std::vector<Directed_segment>& way) const {
    double most = -std::numeric_limits<double>::infinity();
    for (const Directed_segment& s : way) most = (std::max)(most, directed(s).last().point.x);
    for (std::size_t i = 0; i < way.size(); ++i) {
      const Directed_piece p = directed(way[i]), q = directed(way[(i + 1) % way.size()]);
      if (most - p.last().point.x > boundary_.resolution()) continue;
      const Xy<double> in = p.tangent(p.last()), out = q.tangent(q.first());
      const double turn = turn_between(way[i], way[(i + 1) % way.size()]);
      // from `out` counterclockwise to -`in`; both point to the left or upright
      if (std::fabs(turn) < 1 ? in.y + out.y < 0 : turn < 0) return false;
    }
    return true;
  }

  struct Sides {
    bool left = false, right = false, are_decided = true;
  };
  void find_sides(Index_loop loop) {
    const std::vector<std::uint32_t> first = first_segments();
    sides_.resize(first.size() - 1);
    loop_over_ranges(loop, sides_.size(), [&](std::size_t c, std::size_t end) {
      for (; c < end; ++c) {
        const std::vector<std::uint32_t> segments = long_segments(first[c], first[c + 1]);
        if (!segments.empty()) sides_[c] = sides_of(segments);
      }
    });
  }
  // Counted next to the middle of the longest segment, where it is told at once.
  [[nodiscard]] Sides sides_of(const std::vector<std::uint32_t>& segments) const {
    std::uint32_t longest = segments.front();
    double most = 0;
    for (const std::uint32_t s : segments) {
      const Spiral_piece_2& p = curves_.piece(s);
      const double length = euclidean_norm(p.last.point - p.first.point);
      if (length > most) most = length, longest = s;
    }
    const Spiral_piece_2& p = curves_.piece(longest);
    const Spiral_sample middle = curves_.sample(longest, p.first.t + (p.last.t - p.first.t) / 2);
    // nearer than any other curve: the distance to the rest shrinks with the step only if curves cross
    const double step = 0x1p-30 * most + 64 * curves_.error(longest);
    const Winding_number w = winding_number(curves_, middle.point + step * perp(middle.tangent)),
                         v = winding_number(curves_, middle.point - step * perp(middle.tangent));
    const bool are_decided = w.state == Winding_number::State::DECIDED && v.state == Winding_number::State::DECIDED &&
                             w.number == v.number + 1;
    return {is_filled(rule_, w.number), is_filled(rule_, v.number), are_decided};
  }

  [[nodiscard]] static std::vector<Directed_segment> side(const std::vector<std::uint32_t>& segments,
                                                          bool is_reversed) {
    std::vector<Directed_segment> way;
    for (const std::uint32_t s : segments) way.push_back({s, is_reversed});
    if (is_reversed) std::reverse(way.begin(), way.end());
    return way;
  }
  [[nodiscard]] Directed_piece directed(const Directed_segment& s) const {
    return {curves_.piece(s.segment), s.is_reversed};
  }
  // At the end of an open curve a ring turns round it.
  [[nodiscard]] double turn_between(const Directed_segment& s, const Directed_segment& next) const {
    if (s.segment == next.segment && s.is_reversed != next.is_reversed) return -HALF_TURN;
    return turn_of(directed(s), directed(next));
  }

  void add_ring(std::uint32_t curve, const std::vector<Directed_segment>& way, bool is_outer) {
    boundary_.start_ring(curve, is_outer);
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
  void add_point(std::uint32_t curve, std::uint32_t segment) {
    boundary_.start_ring(curve, false);
    boundary_.add({segment, 0, true, false, 0, 2 * HALF_TURN, curves_.piece(segment).first.point, {1, 0}});
  }
  static constexpr double HALF_TURN = 3.14159265358979323846;

 public:
  /// The angle between two elements at their joint. Where the tangent turns back, the sides tell the sign: at the
  /// distance s from the cusp, with the tangent T and normal N before it, the arms are at
  /// -s T + s^2 / 2 kappa N and -s T - s^2 / 2 kappa' N, and the turn is to the left where the second one is.
  [[nodiscard]] static double turn_of(const Directed_piece& p, const Directed_piece& q) {
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
  static constexpr double LEAST_TURN = 0x1p-21;

 private:
  const Segment_hierarchy& curves_;
  Fill_rule rule_ = Fill_rule::NONZERO;
  bool is_framed_ = false;
  const std::vector<bool>* is_ccw_ = nullptr;
  Axis_boundary boundary_;
  std::vector<Sides> sides_;  // by curve, of those that enclose something by themselves
  bool is_decided_ = true;
};

}  // namespace CGAL::Bounding_arcs::internal

#endif
