// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The search for the point of a drawing nearest to a point.
//
// Boxes, then fat arcs of segments leave out what is too far.  What is left is a piece for which the squared distance
// to q is strictly convex in arc length s, or it is halved: with f(s) = |C - q|^2 and the unit tangent T and normal n,
//   f' / 2 = (C - q).T,   f'' / 2 = 1 - kappa (q - C).n  >=  m  >  0,
// where m comes from the largest curvature and the largest (q - C).n of the piece.  Then it has one foot, which
// Newton's steps find, and in whatever point they end, with g = (C - q).T, the least distance is at least sqrt(f - g^2
// / m): so the bracket does not hang on how well they converged.  If the point is an end of the piece and f grows from
// there, no point of the piece is nearer.

#ifndef CGAL_BOUNDING_ARCS_2_INTERNAL_QUERY_CLOSEST_SEARCH_H
#define CGAL_BOUNDING_ARCS_2_INTERNAL_QUERY_CLOSEST_SEARCH_H

#include <CGAL/Bounding_arcs_2/query/Curve_index_2.h>
#include <CGAL/Bounding_arcs_2/query/Query_point.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <optional>

namespace CGAL::Bounding_arcs::internal {

/// What fat arcs tell of a distance where their pieces are as short as can be: twice what distance_room has for it, and
/// the radius of a piece without thickness, with as much again.
[[nodiscard]] inline double distance_resolution(double error, double distance) {
  return 8 * error + 4 * (ARC_DISTANCE_ERROR + 20 * ARC_HALF_ULP) * distance;
}

[[nodiscard]] inline double squared_distance(const Xy<double>& q, const Box_tree::Node& n, std::size_t k) {
  const double dx = (std::max)((std::max)(n.x_low[k] - q.x, q.x - n.x_high[k]), 0.0),
               dy = (std::max)((std::max)(n.y_low[k] - q.y, q.y - n.y_high[k]), 0.0);
  return dx * dx + dy * dy;
}

/// One search: pieces are looked at in any order, and what is found is the nearest of all.
class Closest_search {
 public:
  /// \param most nothing farther is looked for
  Closest_search(const Curve_index_2& index, const Xy<double>& q, double most)
      : index_(index), q_(q), upper_(most), lower_(most) {}

  [[nodiscard]] double upper() const { return upper_; }
  /// Looks at all segments whose boxes are no farther than what was found.
  void search() {
    if (!index_.empty()) descend(index_.boxes().root());
  }
  /// Looks at one segment.
  void look_at(std::uint32_t segment) {
    const double lower = distance_bounds_of(segment);
    if (lower < upper_) refine(index_.piece(segment), lower);
  }
  /// Looks at a piece of one.
  void look_at(const Spiral_piece_2& piece, const Fat_arc_2& fat) {
    const double lower = distance_bounds(q_, fat).lower;
    if (lower < upper_) refine(piece, lower);
  }
  /// Takes a point of the drawing for the nearest until a nearer one is found.
  void start_from(std::uint32_t segment, const Spiral_sample& sample) {
    const double d = euclidean_norm(sample.point - q_), error = index_.error(segment);
    offer({upper_, bounds_of(d, error).upper}, segment, sample);
  }
  /// The segment of what was found. \pre there is something
  [[nodiscard]] std::uint32_t segment() const { return segment_; }
  /// At most the distance of all that was looked at, or `most` where that is less.
  [[nodiscard]] double lower() const { return (std::min)(lower_, upper_); }
  /// \return nothing where all is farther than `most`
  [[nodiscard]] std::optional<Closest_point> result() const {
    if (!place_) return std::nullopt;
    return Closest_point{{(std::min)(lower_, upper_), upper_}, point_, *place_};
  }

 private:
  struct Child {
    double distance;
    std::uint32_t index;
    bool is_item;
  };
  void descend(const Box_tree::Node& node) {
    std::array<Child, Box_tree::WIDTH> children;
    std::size_t count = 0;
    const double most = upper_ * upper_ * (1 + 8 * ARC_HALF_ULP);
    for (std::size_t k = 0; k < node.size; ++k) {
      const double d = squared_distance(q_, node, k);
      if (!(d <= most)) continue;
      std::size_t i = count++;  // nearer ones first
      for (; i > 0 && children[i - 1].distance > d; --i) children[i] = children[i - 1];
      children[i] = {d, node.child[k], node.is_item(k)};
    }
    for (std::size_t i = 0; i < count; ++i) {
      if (!(children[i].distance <= upper_ * upper_ * (1 + 8 * ARC_HALF_ULP))) return;
      if (children[i].is_item) look_at(children[i].index);
      else descend(index_.boxes().node(children[i].index));
    }
  }
  [[nodiscard]] double distance_bounds_of(std::uint32_t segment) const {
    return distance_bounds(q_, index_.fat(segment)).lower;
  }
  // What is within `most` but is not looked at is at least this far.
  void leave_out(double lower) { lower_ = (std::min)(lower_, lower); }

  void offer(const Distance_bounds& d, std::uint32_t segment, const Spiral_sample& s) {
    leave_out(d.lower);
    if (place_ && !(d.upper < upper_)) return;
    if (d.upper > upper_) return;
    upper_ = d.upper;
    point_ = s.point;
    segment_ = segment;
    place_ = index_.place_at(segment, s.t);
  }
  [[nodiscard]] Distance_bounds bounds_of(double distance, double error) const {
    const double room = error + 4 * ARC_HALF_ULP * distance;
    return {(std::max)(0.0, distance - room), distance + room};
  }

  void refine(const Spiral_piece_2& piece, double lower) {
    const Convexity f = convexity(piece);
    if (f.is_rising || f.is_falling) return finish_at_end(piece, f.is_rising ? piece.first : piece.last);
    constexpr double LEAST = 0x1p-6;  // below, halving is worth more than a foot that is hard to tell
    if (f.least >= LEAST && finish_convex(piece, f.least)) return;
    const double error = index_.error(piece.segment);
    // the ends are points of the curve: what is found first keeps others short
    const double resolution = distance_resolution(error, upper_);
    const auto middle = halves(index_, piece);
    if (!middle || lower >= upper_ - resolution) return give_up(piece, lower);
    const Fat_arc_2 fat[2] = {index_.fat(middle->first), index_.fat(middle->second)};
    const Distance_bounds d[2] = {distance_bounds(q_, fat[0]), distance_bounds(q_, fat[1])};
    const Xy<double> way = middle->first.last.point - q_;
    offer({lower_, bounds_of(euclidean_norm(way), error).upper}, piece.segment, middle->first.last);
    const std::size_t nearer = d[1].lower < d[0].lower ? 1 : 0;
    for (const std::size_t i : {nearer, 1 - nearer}) {
      if (!(d[i].lower < upper_)) continue;
      refine(i == 0 ? middle->first : middle->second, d[i].lower);
    }
  }
  // Nothing more can be told of this piece.
  void give_up(const Spiral_piece_2& piece, double lower) {
    const double error = index_.error(piece.segment);
    for (const Spiral_sample* s : {&piece.first, &piece.last})
      offer({lower, bounds_of(euclidean_norm(s->point - q_), error).upper}, piece.segment, *s);
  }

  // No point of the piece is nearer than this end of it.
  void finish_at_end(const Spiral_piece_2& piece, const Spiral_sample& end) {
    offer(bounds_of(euclidean_norm(end.point - q_), index_.error(piece.segment)), piece.segment, end);
  }

  // How f behaves over a piece.
  struct Convexity {
    double least = 0;                            // at most f'' / 2, everywhere
    bool is_rising = false, is_falling = false;  // f' has one sign
  };
  // (q - C).n changes by kappa |(q - C).T| an arc length, (C - q).T by |1 - kappa (q - C).n|, and |q - C| is more than
  // both; a piece is as long as its box is wide and high at most.
  [[nodiscard]] Convexity convexity(const Spiral_piece_2& piece) const {
    const double curvature = (std::max)(piece.first.most_curvature, piece.last.most_curvature);
    if (!(curvature < std::numeric_limits<double>::max())) return {};
    const Xy<double> u0 = q_ - piece.first.point, u1 = q_ - piece.last.point,
                     chord = piece.last.point - piece.first.point;
    const Xy<double>&d0 = piece.first.tangent, &d1 = piece.last.tangent;
    constexpr double UP = 1 + 16 * ARC_HALF_ULP;
    const double error = index_.error(piece.segment);
    const double size = (std::fabs(chord.x) + std::fabs(chord.y)) * UP + 4 * error;
    const double most = ((std::max)(euclidean_norm(u0), euclidean_norm(u1)) + size) * UP;
    const double room =
        ((std::max)(piece.first.tangent_error, piece.last.tangent_error) + 8 * ARC_HALF_ULP) * most + error;
    const double turn = cross(d0, d1) < 0 ? -1 : 1;
    const double ends = (std::max)({turn * cross(d0, u0), turn * cross(d1, u1), 0.0});
    const double inward = ends + curvature * most * size / 2 + room;
    const double change = (1 + curvature * most) * size * UP + room;
    return {1 - curvature * (std::min)(inward, most + room) * UP, -dot(u0, d0) > change, dot(u1, d1) > change};
  }

  // \return false if the piece may have several feet
  bool finish_convex(const Spiral_piece_2& piece, double convexity) {
    const Bezier_evaluator& curve = index_.evaluator(index_.bezier_of(piece.segment));
    const double error = index_.error(piece.segment);
    const double t0 = piece.first.t, t1 = piece.last.t;
    double low = t0, high = t1;
    // the chord's foot
    const Xy<double> chord = piece.last.point - piece.first.point;
    const double share = dot(chord, q_ - piece.first.point) / dot(chord, chord);
    double t = share > 0 && share < 1 ? t0 + share * (t1 - t0) : (share >= 1 ? t1 : t0);
    constexpr int MOST_STEPS = 60;
    Curve_jet jet;
    double slope = 0, speed = 0;
    for (int step = 0; step < MOST_STEPS; ++step) {
      jet = curve(t);
      const Xy<double> way = jet.point - q_;
      slope = dot(way, jet.first);
      speed = euclidean_norm(jet.first);
      // what the slope may be wrong by
      const double unsure = speed * error + euclidean_norm(way) * curve.first_error();
      if (std::fabs(slope) <= unsure) break;
      if (slope > 0) high = t;
      else low = t;
      if (slope > 0 ? t == t0 : t == t1) break;
      const double rate = speed * speed + dot(way, jet.second);
      double next = rate > 0 ? t - slope / rate : t;
      if (!(next > low)) next = low == t0 && t != t0 && rate > 0 ? t0 : low + (high - low) / 2;
      else if (!(next < high)) next = high == t1 && t != t1 && rate > 0 ? t1 : low + (high - low) / 2;
      if (next == t || !(low <= next && next <= high)) break;
      t = next;
    }
    const Xy<double> way = jet.point - q_;
    const double distance = euclidean_norm(way);
    const bool is_at_end = (t == t0 && slope >= 0) || (t == t1 && slope <= 0);
    // f'' / 2 >= convexity: the least is g^2 / convexity below
    double beside = 0;
    if (!(speed > 0)) return false;
    const double wrong = error + distance * (curve.first_error() / speed + 8 * ARC_HALF_ULP);
    const double g = is_at_end ? wrong : std::fabs(slope) / speed + wrong;
    const double drop = g * g / convexity;
    beside = drop < distance * distance ? drop / (distance + std::sqrt(distance * distance - drop)) : distance;
    Distance_bounds d = bounds_of(distance, error);
    d.lower = (std::max)(0.0, d.lower - beside * (1 + 8 * ARC_HALF_ULP));
    Spiral_sample foot;
    foot.t = t;
    foot.point = jet.point;
    offer(d, piece.segment, foot);
    return true;
  }

  const Curve_index_2& index_;
  Xy<double> q_;
  double upper_, lower_;
  Xy<double> point_;
  std::uint32_t segment_ = 0;
  std::optional<Curve_place> place_;
};

}  // namespace CGAL::Bounding_arcs::internal

#endif
