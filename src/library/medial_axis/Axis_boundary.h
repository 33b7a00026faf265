// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The boundary of regions as what discs from inside touch: rings of elements, each run through with the region on its
// left.  An element is a spiral segment, or the corner between two where discs may touch from a range of directions (a
// reflex corner).
//
//   segment: u = t or, where the curve runs the other way, u = -t
//   corner:  u = the angle by which the tangent has turned clockwise
//
// An open curve is one ring, which runs along its left side, round its end, which is a corner of half a turn, back
// along its right side and round its start.  A point is a ring of one corner, of a whole turn.

#ifndef BOUNDING_ARCS_LIBRARY_MEDIAL_AXIS_AXIS_BOUNDARY_H
#define BOUNDING_ARCS_LIBRARY_MEDIAL_AXIS_AXIS_BOUNDARY_H

#include "../tree/Segment_hierarchy.h"
#include "Bounding_parts.h"
#include "Hidden_turns.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <tuple>
#include <utility>
#include <vector>

namespace CGAL::Bounding_arcs::internal {

struct Boundary_element {
  std::uint32_t segment;  ///< of a corner the one before it, or the point
  std::uint32_t ring;
  bool is_corner, is_reversed;
  double first, last;             ///< u; first < last
  Xy<double> point{}, tangent{};  ///< of a corner, at u = 0
  double turn = 0;                ///< of a segment, to the left at its end

  /// Joints that turn to the left by less are no tips. Beyond the disc of radius r that touches both sides of a corner,
  /// which turns by an angle a, its tip is r a^2 / 8 long: with ten times less, tips would be lost in the coordinates'
  /// rounding.
  static constexpr double LEAST_TURN = 0x1p-21;
  /// Joints that turn to the left by less may be rounded off: tips of sharper ones are told in doubles.
  static constexpr double ROUNDED_TURN = 0x1p-18;
  /// Whether it ends in a corner that is a leaf.
  [[nodiscard]] bool is_before_tip() const { return turn > LEAST_TURN; }
};

/// A place on the boundary.
struct Boundary_place {
  std::uint32_t element = 0;
  double u = 0;
};

/// What discs need of a place: the region is to the left of the tangent.
struct Boundary_jet {
  Xy<double> point, tangent;
  double speed;  ///< |dC/du|, 0 at a corner
  double turn;   ///< by what angle the tangent turns for du, to the left
  [[nodiscard]] Xy<double> normal() const { return perp(tangent); }
};

struct Boundary_ring {
  std::uint32_t begin, end;  ///< elements, in order
  bool is_outer;             ///< runs counterclockwise: the region is within it
};

/// The sample at a parameter of a segment, or at an end of it.
[[nodiscard]] inline Spiral_sample sample_at(const Segment_hierarchy& curves, std::uint32_t segment, double t) {
  const Spiral_piece_2 piece = curves.piece(segment);
  return t == piece.first.t ? piece.first : (t == piece.last.t ? piece.last : curves.sample(segment, t));
}

/// A spiral segment as a ring goes along it.
struct Directed_piece {
  Spiral_piece_2 piece;
  bool is_reversed;
  [[nodiscard]] const Spiral_sample& first() const { return is_reversed ? piece.last : piece.first; }
  [[nodiscard]] const Spiral_sample& last() const { return is_reversed ? piece.first : piece.last; }
  [[nodiscard]] Xy<double> tangent(const Spiral_sample& end) const { return is_reversed ? -end.tangent : end.tangent; }
  // Signed: the piece turns to one side.
  [[nodiscard]] double curvature(const Spiral_sample& end) const {
    return std::copysign(end.most_curvature / 2 + end.least_curvature / 2, cross(tangent(first()), tangent(last())));
  }
};

/// The angle between two elements at their joint. Where the tangent turns back, the sides tell the sign: at the
/// distance s from the cusp, with the tangent T and normal N before it, the arms are at
/// -s T + s^2 / 2 kappa N and -s T - s^2 / 2 kappa' N, and the turn is to the left where the second one is.
[[nodiscard]] inline double turn_of(const Directed_piece& p, const Directed_piece& q) {
  const Xy<double> in = p.tangent(p.last()), out = q.tangent(q.first());
  const double turn = std::atan2(cross(in, out), dot(in, out));
  constexpr double HALF_TURN = 3.14159265358979323846, CUSP = HALF_TURN - 0x1p-20, KNOWN = 4;  // times errors
  // at ends of curves that were given tangents are known better than where curves cross, or touch
  const auto is_given = [](const Spiral_sample& s) { return s.t == 0 || s.t == 1; };
  const double errors = p.last().tangent_error + q.first().tangent_error + TANGENT_ROUNDING,
               known = is_given(p.last()) && is_given(q.first()) ? HALF_TURN - KNOWN * errors : CUSP;
  if (std::fabs(turn) < (std::max)(CUSP, known)) return turn;
  const double sum = p.curvature(p.last()) + q.curvature(q.first());
  if (sum != 0 && !std::isnan(sum)) return std::copysign(std::fabs(turn), -sum);
  const Xy<double>&from = p.first().point, &at = p.last().point, &to = q.last().point;
  return std::copysign(std::fabs(turn), cross(at - from, to - at));
}

class Axis_boundary {
 public:
  static constexpr std::uint32_t NONE = static_cast<std::uint32_t>(-1);

  /// How far curves may be beside what is seen of them, in sizes: two roundings of coordinates.
  static constexpr double HIDDEN_HEIGHT = 0x1p-45;

  /// \param parts must outlive this
  /// \param hidden how far curves may be beside what is seen of them, in sizes
  explicit Axis_boundary(const Bounding_parts& parts, double hidden = HIDDEN_HEIGHT)
      : curves_(parts.segments), of_segment_(curves_.number_of_segments(), {NONE, NONE}),
        size_(coordinate_size_of(curves_)), hidden_turns_(curves_, size_, hidden * size_) {
    for (const Bounding_ring& ring : parts.rings) {
      std::vector<Directed_segment> way;
      for (const Directed_segment& s : ring.way)
        if (is_long(s.segment)) way.push_back(s);
      if (!way.empty()) add_ring(way, ring.is_outer);
      else if (is_lone_point(ring.way) || is_dot(ring)) add_point(ring.way.front().segment);
    }
  }

  [[nodiscard]] const Segment_hierarchy& curves() const { return curves_; }
  /// A segment without turns that are hidden at its ends.
  [[nodiscard]] Spiral_piece_2 seen_piece(std::uint32_t segment) const {
    const Seen_segment* seen = hidden_turns_.seen(segment);
    return seen != nullptr ? seen->piece : curves_.piece(segment);
  }
  [[nodiscard]] const std::vector<Boundary_element>& elements() const { return elements_; }
  [[nodiscard]] const Boundary_element& element(std::uint32_t i) const { return elements_[i]; }
  [[nodiscard]] const std::vector<Boundary_ring>& rings() const { return rings_; }
  /// The elements that a segment is, one for each side of it that has a region, or NONE; of a point the corner.
  using Sides = std::array<std::uint32_t, 2>;
  [[nodiscard]] const Sides& sides(std::uint32_t segment) const { return of_segment_[segment]; }
  /// What of a segment is on its other side; NONE where no region is, and of corners.
  [[nodiscard]] std::uint32_t back_of(std::uint32_t e) const {
    const Boundary_element& element = elements_[e];
    return element.is_corner ? NONE : of_segment_[element.segment][element.is_reversed ? 0 : 1];
  }
  /// Calls visit(element) for the sides of a segment, and for the corners beside these.
  template <class Visit> void for_each_element_of(std::uint32_t segment, const Visit& visit) const {
    for (const std::uint32_t e : of_segment_[segment]) {
      if (e == NONE) continue;
      visit(e);
      if (elements_[e].is_corner) continue;  // a point
      for (const std::uint32_t corner : {before(e), after(e)})
        if (elements_[corner].is_corner) visit(corner);
    }
  }
  /// A part of an element that is no corner.
  [[nodiscard]] Spiral_piece_2 piece(std::uint32_t e, double u0, double u1) const {
    const Boundary_element& element = elements_[e];
    if (element.is_reversed) std::tie(u0, u1) = std::pair(-u1, -u0);
    return {element.segment, sample_at(curves_, element.segment, u0), sample_at(curves_, element.segment, u1)};
  }
  /// The distance between the ends of a segment.
  [[nodiscard]] double length(std::uint32_t segment) const {
    const Spiral_piece_2 p = curves_.piece(segment);
    return euclidean_norm(p.last.point - p.first.point);
  }
  /// The largest |coordinate|.
  [[nodiscard]] double size() const { return size_; }
  /// An upper bound of the radius of any disc within the curves.
  [[nodiscard]] double largest_radius() const {
    if (curves_.empty()) return 0;
    const CGAL::Bbox_2& box = curves_.boxes().box();
    return (box.xmax() - box.xmin()) + (box.ymax() - box.ymin());
  }
  /// Distances that differ by less are not told apart: some tens of roundings of coordinates.
  [[nodiscard]] double resolution() const { return 0x1p-46 * size_; }
  /// Whether elements of a length that turn into each other by an angle are smooth there: neither leaves the other
  /// one's tangent by more than rounding.
  [[nodiscard]] bool is_smooth(double turn, double length) const {
    constexpr double ROUNDING = 64;  // times the resolution
    return !(std::fabs(turn) * length > ROUNDING * resolution());
  }
  /// How far curves may be beside what is seen of them; 0 where no turns are hidden.
  [[nodiscard]] double hidden_height() const { return hidden_turns_.height(); }
  [[nodiscard]] double largest_rounded_turn() const { return largest_rounded_turn_; }
  /// Points that are no farther apart may be one joint.
  [[nodiscard]] double joint_size() const { return 4 * resolution(); }

  [[nodiscard]] std::uint32_t after(std::uint32_t e) const {
    const Boundary_ring& r = rings_[elements_[e].ring];
    return e + 1 == r.end ? r.begin : e + 1;
  }
  [[nodiscard]] std::uint32_t before(std::uint32_t e) const {
    const Boundary_ring& r = rings_[elements_[e].ring];
    return e == r.begin ? r.end - 1 : e - 1;
  }

  [[nodiscard]] double parameter(const Boundary_place& p) const {
    return elements_[p.element].is_reversed ? -p.u : p.u;
  }
  /// The angle by which the tangent of a corner has turned when its normal points in a direction, next to the corner's
  /// range.
  [[nodiscard]] double angle_of(std::uint32_t corner, const Xy<double>& direction) const {
    const Boundary_element& e = elements_[corner];
    const double middle = 0.5 * (e.first + e.last), c = std::cos(middle), s = std::sin(middle);
    const Xy<double> tangent{c * e.tangent.x + s * e.tangent.y, c * e.tangent.y - s * e.tangent.x};
    return middle + std::atan2(dot(direction, tangent), cross(tangent, direction));
  }

  /// The place of a point of a segment on one of its elements.
  [[nodiscard]] Boundary_place place(std::uint32_t element, double t) const {
    return {element, elements_[element].is_reversed ? -t : t};
  }
  [[nodiscard]] Curve_place curve_place(const Boundary_place& p) const {
    const Boundary_element& e = elements_[p.element];
    const double t = e.is_corner ? (e.is_reversed ? curves_.piece(e.segment).first.t : curves_.piece(e.segment).last.t)
                                 : parameter(p);
    return curves_.place_at(e.segment, t);
  }

  [[nodiscard]] Boundary_jet operator()(const Boundary_place& p) const {
    const Boundary_element& e = elements_[p.element];
    if (e.is_corner) {
      const double c = std::cos(p.u), s = std::sin(p.u);
      return {e.point, {c * e.tangent.x + s * e.tangent.y, c * e.tangent.y - s * e.tangent.x}, 0, -1};
    }
    const double t = e.is_reversed ? -p.u : p.u, sign = e.is_reversed ? -1 : 1;
    const Bezier_evaluator& curve = curves_.evaluator(curves_.bezier_of(e.segment));
    const Curve_jet jet = curve(t);
    const auto end_tangent = [&](bool is_first) {
      const Spiral_piece_2 piece = seen_piece(e.segment);
      return is_first ? piece.first.tangent : piece.last.tangent;
    };
    if (curves_.is_straight(e.segment)) {
      const Xy<double> d = end_tangent(true);
      return {jet.point, sign * d, std::fabs(dot(jet.first, d)), 0};
    }
    const Seen_segment* seen = hidden_turns_.seen(e.segment);
    if (seen != nullptr && !(seen->from < t && t < seen->to))
      return {jet.point, sign * end_tangent(t <= seen->from), euclidean_norm(jet.first), 0};
    const double square = dot(jet.first, jet.first), speed = std::sqrt(square);
    const bool is_end = p.u == e.first || p.u == e.last;
    constexpr double FAR = 0x1p10;  // from a cusp: elsewhere a derivative is many times what it errs by
    const Xy<double> d = is_end                                        ? end_tangent((p.u == e.first) != e.is_reversed)
                         : speed > FAR * curve.errors_at(t, jet).first ? (1 / speed) * jet.first
                                                                       : tangent_by_cusp(e.segment, t, jet.first);
    return {jet.point, sign * d, speed, square > 0 ? sign * cross(jet.first, jet.second) / square : 0};
  }

  /// By how much the boundary turns at a place where elements turn into each other by so little that there is no
  /// corner; 0 elsewhere.
  [[nodiscard]] double turn_of_joint(const Boundary_place& p) const {
    const Boundary_element& e = elements_[p.element];
    const bool is_last = p.u == e.last;
    if (e.is_corner || (!is_last && p.u != e.first)) return 0;
    const std::uint32_t other = is_last ? after(p.element) : before(p.element);
    const double turn = is_last ? e.turn : elements_[other].turn;
    return elements_[other].is_corner || std::fabs(turn) >= Boundary_element::ROUNDED_TURN ? 0 : turn;
  }
  /// By how much the tangent turns on from that of a place's element to that of the disc there, at such a joint.
  ///
  /// A disc with a tangent that is off by b is as far as b^2 / (2 x) in a side whose curvature is less than its own by
  /// x. It is as far in what is before as in what is behind where both b are as the roots of both x.
  [[nodiscard]] double turn_to_disc(const Boundary_place& p, double radius) const {
    const double turn = turn_of_joint(p);
    if (turn == 0) return 0;
    const bool is_last = p.u == elements_[p.element].last;
    double share = 0.5;
    if (turn * radius > resolution()) {
      const std::uint32_t i = is_last ? after(p.element) : before(p.element);
      const auto root = [&](const Boundary_place& at) {
        const double excess = 1 / radius - curvature(at).value;
        return excess > 0 ? std::sqrt(excess) : 0;
      };
      const double own = root(p), other = root({i, is_last ? elements_[i].first : elements_[i].last});
      if (std::isfinite(own) && std::isfinite(other) && own + other > 0) share = own / (own + other);
    }
    return (is_last ? share : -share) * turn;
  }

  /// Curvature at an end of an element that is no corner, with what it may be wrong by. It is infinite at a cusp, and
  /// where rounding has made something of a cusp that turns within the piece by an unknown amount.
  struct Curvature {
    double value, error;
  };
  [[nodiscard]] Curvature curvature(const Boundary_place& p) const {
    const Boundary_element& e = elements_[p.element];
    if (curves_.is_straight(e.segment)) return {0, 0};
    const Spiral_piece_2 piece = seen_piece(e.segment);
    const Spiral_sample& s = parameter(p) == piece.first.t ? piece.first : piece.last;
    const double bend = cross(piece.first.tangent, piece.last.tangent) * (e.is_reversed ? -1 : 1);
    const Curvature cusp{std::copysign(std::numeric_limits<double>::infinity(), bend), 0};
    if (!(s.most_curvature < std::numeric_limits<double>::max())) return cusp;
    if (hidden_turns_.seen(e.segment) != nullptr)
      return {std::copysign(0.5 * (s.most_curvature + s.least_curvature), bend), s.most_curvature - s.least_curvature};
    const Boundary_jet jet = (*this)(p);
    const Curvature result{jet.turn / jet.speed, s.most_curvature - s.least_curvature};
    const double length = euclidean_norm(piece.last.point - piece.first.point);
    return result.error >= std::fabs(result.value) && result.error * length > 1 ? cusp : result;
  }

 private:
  static constexpr double HALF_TURN = 3.14159265358979323846;

  void start_ring(bool is_outer) {
    const auto begin = static_cast<std::uint32_t>(elements_.size());
    rings_.push_back({begin, begin, is_outer});
  }
  void add(Boundary_element e) {
    e.ring = static_cast<std::uint32_t>(rings_.size() - 1);
    const auto i = static_cast<std::uint32_t>(elements_.size());
    if (!e.is_corner || rings_.back().begin == i) of_segment_[e.segment][e.is_reversed ? 1 : 0] = i;
    elements_.push_back(e);
    rings_.back().end = i + 1;
    if (e.turn < Boundary_element::ROUNDED_TURN) largest_rounded_turn_ = (std::max)(largest_rounded_turn_, e.turn);
  }
  // A curve that is a point has a ring on either side, or one along both. A part without length is none.
  [[nodiscard]] bool is_lone_point(const std::vector<Directed_segment>& way) const {
    const std::uint32_t segment = way.front().segment;
    const auto& points = curves_.bezier(curves_.bezier_of(segment)).control_points();
    const auto is_it = [&](const Directed_segment& s) { return s.segment == segment; };
    const auto is_there = [&](const Xy<double>& p) { return p == points.front(); };
    return !way.front().is_reversed && std::all_of(way.begin(), way.end(), is_it) &&
           std::all_of(points.begin(), points.end(), is_there);
  }
  // A closed curve that is no longer than that is one to what is around it.
  [[nodiscard]] bool is_dot(const Bounding_ring& ring) const {
    const auto has_length = [&](const Directed_segment& s) { return length(s.segment) > 0; };
    return !ring.is_outer && std::any_of(ring.way.begin(), ring.way.end(), has_length);
  }
  // Shorter are points, and what is between two cuts that are nearly one.
  [[nodiscard]] bool is_long(std::uint32_t segment) const { return length(segment) > resolution(); }
  // How far the Bezier piece goes on from the joint behind a segment, there or, backwards, before it.
  template <bool IS_FORWARD> [[nodiscard]] double reach(const std::vector<Directed_segment>& way, std::size_t i) const {
    const std::size_t n = way.size(), first = IS_FORWARD ? (i + 1) % n : i;
    const std::uint32_t bezier = curves_.bezier_of(way[first].segment);
    double sum = 0;
    for (std::size_t k = 0, j = first; k < n && curves_.bezier_of(way[j].segment) == bezier; ++k) {
      sum += length(way[j].segment);
      j = IS_FORWARD ? (j + 1) % n : (j + n - 1) % n;
    }
    return sum;
  }
  [[nodiscard]] Directed_piece directed(const Directed_segment& s) const {
    return {seen_piece(s.segment), s.is_reversed};
  }
  void add_ring(const std::vector<Directed_segment>& way, bool is_outer) {
    start_ring(is_outer);
    for (std::size_t i = 0; i < way.size(); ++i) {
      const Directed_segment& s = way[i];
      const Directed_piece p = directed(s);
      const double sign = s.is_reversed ? -1 : 1;
      const Directed_segment& next = way[(i + 1) % way.size()];
      // at the end of an open curve a ring turns round it
      const bool is_back = s.segment == next.segment && s.is_reversed != next.is_reversed;
      const double turn = is_back ? -HALF_TURN : turn_of(p, directed(next));
      add({s.segment, 0, false, s.is_reversed, sign * p.first().t, sign * p.last().t, {}, {}, turn});
      // round a corner of a short element discs turn all the same
      const bool is_little = turn > -Boundary_element::ROUNDED_TURN;
      if (!(turn < 0) || is_smooth(turn, largest_radius()) ||
          (is_little && is_smooth(turn, (std::min)(reach<false>(way, i), reach<true>(way, i)))))
        continue;
      add({s.segment, 0, true, s.is_reversed, 0, -turn, p.last().point, p.tangent(p.last())});
    }
  }
  void add_point(std::uint32_t segment) {
    start_ring(false);
    add({segment, 0, true, false, 0, 2 * HALF_TURN, curves_.piece(segment).first.point, {1, 0}});
  }

  [[nodiscard]] static double coordinate_size_of(const Segment_hierarchy& curves) {
    double size = 0;
    for (std::uint32_t i = 0; i < curves.number_of_beziers(); ++i)
      size = (std::max)(size, curves.evaluator(i).coordinate_size());
    return size;
  }
  // Beside a cusp a derivative may be rounding alone. The tangent is between those of the segment's ends.
  [[nodiscard]] Xy<double> tangent_by_cusp(std::uint32_t segment, double t, const Xy<double>& derivative) const {
    const Spiral_piece_2 piece = curves_.piece(segment);
    const Xy<double>&first = piece.first.tangent, &last = piece.last.tangent;
    const double turn = cross(first, last), length = euclidean_norm(derivative);
    const bool is_between = length > 0 && turn * cross(first, derivative) >= 0 && turn * cross(derivative, last) >= 0 &&
                            dot(derivative, first + last) > 0;
    if (is_between) return (1 / length) * derivative;
    return t - piece.first.t < piece.last.t - t ? first : last;
  }

  const Segment_hierarchy& curves_;
  std::vector<Boundary_element> elements_;
  std::vector<Boundary_ring> rings_;
  std::vector<Sides> of_segment_;
  double size_ = 0, largest_rounded_turn_ = 0;
  Hidden_turns hidden_turns_;
};

/// The disc that touches two places from inside, where it touches the second one with the tangent it has there; the
/// radius is that from both normals, p + r n = q + r m, and may be negative.
struct Touching_disc {
  Xy<double> center;
  double radius;
  /// By how much a point is beside its circle.
  [[nodiscard]] double gap(const Xy<double>& p) const { return std::fabs(euclidean_norm(p - center) - radius); }
  friend bool operator==(const Touching_disc& a, const Touching_disc& b) {
    return a.center == b.center && a.radius == b.radius;
  }
};
[[nodiscard]] inline Touching_disc disc_of(const Boundary_jet& p, const Boundary_jet& q) {
  const Xy<double> way = q.point - p.point, n = p.normal(), m = q.normal(), change = n - m;
  const double square = dot(change, change), r = square > 0 ? dot(way, change) / square : 0;
  return {0.5 * ((p.point + r * n) + (q.point + r * m)), r};
}

}  // namespace CGAL::Bounding_arcs::internal

#endif
