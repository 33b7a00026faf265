// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The parts of the boundary that the feet of two discs run along, for proofs.

#ifndef BOUNDING_ARCS_LIBRARY_MEDIAL_AXIS_LINE_PARTS_H
#define BOUNDING_ARCS_LIBRARY_MEDIAL_AXIS_LINE_PARTS_H

#include <CGAL/Bounding_arcs_2/medial_axis/Medial_axis_2.h>
#include "../tree/Segment_hierarchy.h"
#include "Axis_boundary.h"
#include "Bounding_parts.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>
#include <utility>
#include <vector>

namespace CGAL::Bounding_arcs::internal {

// The lines between an axis's samples, each with what both feet run along.
//
//   s --------------> t       The region is to the left of the boundary: left feet run from t to s along it, right ones
//   left    <----             from s to t.
//   right   ---->

/// What a foot runs along from one disc to another one: a part of a segment, or a point.
struct Foot_run {
  std::uint32_t segment = 0;
  double from = 0, to = 0;  ///< t
  bool is_point = false;
  Xy<double> point{};  ///< where it is one

  /// Whether the curve's parameter grows in the direction of the run.
  [[nodiscard]] bool is_growing() const { return from < to; }
};

/// A line between the centers of two discs.
struct Axis_line {
  Touching_disc first, last;
  Foot_run left, right;                            ///< both from the first disc to the last one
  double share = 1;                                ///< of a line between samples, where this is a part of one
  Touching_disc beyond[2] = {{{}, -1}, {{}, -1}};  ///< the edge's samples before and behind, or of radius -1
  const std::vector<Xy<double>>* others[2] = {nullptr, nullptr};  ///< points of curves, touched by a vertex at an end
};

/// Finds what feet run along.
class Foot_runs {
 public:
  /// \param least lengths below are nothing
  /// \param room ends that are no farther apart may be one joint, where feet have no segment in common otherwise
  explicit Foot_runs(const Bounding_parts& parts, double least, double room = 0)
      : curves_(parts.segments), least_(least), room_((std::max)(least, room)) {
    const std::size_t count = curves_.number_of_segments();
    first_.assign(curves_.number_of_beziers() + 1, 0);
    for (std::uint32_t i = 0; i < count; ++i)
      ++first_[curves_.number_of_bezier(curves_.place(i).curve, curves_.place(i).bezier) + 1];
    for (std::size_t i = 1; i < first_.size(); ++i) first_[i] += first_[i - 1];
    std::vector<std::uint32_t> last(parts.joints.size(), NONE);  // by joint
    next_ = last;
    for (std::uint32_t e = 0; e < next_.size(); ++e) {
      std::uint32_t& before = last[parts.joints[e]];
      if (before == NONE) next_[e] = e;
      else next_[e] = std::exchange(next_[before], e);
      before = e;
    }
  }

  /// A place nearer to where a center is on the normal, of the same segment; ends of segments stay.  Distances hardly
  /// change along the boundary, so feet may be off where discs are not.
  [[nodiscard]] Curve_place on_normal(const Curve_place& p, const Xy<double>& center) const {
    const std::uint32_t bezier = curves_.number_of_bezier(p.curve, p.bezier);
    const Bezier_evaluator& curve = curves_.evaluator(bezier);
    const auto aside = [&](const Curve_jet& j) { return dot(center - j.point, j.first); };
    const Curve_jet jet = curve(p.t);
    const double square = dot(jet.first, jet.first), steep = square - dot(center - jet.point, jet.second);
    if (!(std::fabs(aside(jet)) > least_ * std::sqrt(square)) || !(steep > 0)) return p;
    const auto segment = segment_at(bezier, p.t);
    if (!segment) return p;
    const Spiral_piece_2 piece = curves_.piece(*segment);
    if (p.t <= piece.first.t || p.t >= piece.last.t) return p;
    Curve_place moved = p;
    moved.t = std::clamp(p.t + aside(jet) / steep, piece.first.t, piece.last.t);  // a step of Newton's
    return std::fabs(aside(curve(moved.t))) < 0.5 * std::fabs(aside(jet)) ? moved : p;
  }

  /// \return nothing where two feet are on no common segment
  [[nodiscard]] std::optional<Foot_run> between(const Curve_place& a, const Curve_place& b) const {
    if (a.curve == b.curve && a.bezier == b.bezier && a.t == b.t) return point_run(a);
    std::optional<Foot_run> best = between(names(a, least_), names(b, least_));
    if (!best && least_ < room_) best = between(names(a, room_), names(b, room_));
    const bool is_nothing = best && (euclidean_norm(point(a) - point(b)) <= least_ || length(*best) <= least_);
    return is_nothing ? point_run(a) : best;
  }
  [[nodiscard]] Xy<double> point(const Curve_place& p) const { return point_at(curves_, p); }
  /// The first segment of a Bezier piece that does not end before a parameter, or the last one.
  [[nodiscard]] std::optional<std::uint32_t> segment_at(std::uint32_t bezier, double t) const {
    std::uint32_t s = first_[bezier];
    if (s == first_[bezier + 1]) return std::nullopt;
    while (s + 1 < first_[bezier + 1] && curves_.piece(s).last.t < t) ++s;
    return s;
  }
  /// Points of the boundary on the Bezier piece of a place: middles and ends of segments.
  [[nodiscard]] std::vector<Xy<double>> points_beside(const Curve_place& p) const {
    const std::uint32_t bezier = curves_.number_of_bezier(p.curve, p.bezier);
    std::vector<Xy<double>> points;
    for (std::uint32_t s = first_[bezier]; s < first_[bezier + 1]; ++s) {
      const Spiral_piece_2 piece = curves_.piece(s);
      for (const double t : {piece.first.t, 0.5 * (piece.first.t + piece.last.t), piece.last.t})
        points.push_back(curves_.sample(s, t).point);
    }
    return points;
  }

  /// A place as one of a segment.
  struct Name {
    std::uint32_t segment;
    double t;
  };
  /// The names of a place: one at a joint is on all segments that end there. The first is that of its own segment.
  [[nodiscard]] std::vector<Name> names(const Curve_place& p) const { return names(p, least_); }

 private:
  [[nodiscard]] static std::optional<Foot_run> between(const std::vector<Name>& of_a, const std::vector<Name>& of_b) {
    std::optional<Foot_run> best;
    std::pair<std::size_t, double> least;  // first those that have the names that were given, then the shortest
    for (std::size_t i = 0; i < of_a.size(); ++i)
      for (std::size_t k = 0; k < of_b.size(); ++k) {
        if (of_a[i].segment != of_b[k].segment) continue;
        const std::pair<std::size_t, double> rank{(i > 0) + (k > 0), std::fabs(of_b[k].t - of_a[i].t)};
        if (best && !(rank < least)) continue;
        least = rank;
        best = Foot_run{of_a[i].segment, of_a[i].t, of_b[k].t};
      }
    return best;
  }
  [[nodiscard]] double length(const Foot_run& run) const {
    return euclidean_norm(curves_.sample(run.segment, run.to).point - curves_.sample(run.segment, run.from).point);
  }
  [[nodiscard]] std::vector<Name> names(const Curve_place& p, double room) const {
    std::vector<Name> names;
    const std::uint32_t bezier = curves_.number_of_bezier(p.curve, p.bezier);
    const std::optional<std::uint32_t> s = segment_at(bezier, p.t);
    if (!s) return names;
    const Spiral_piece_2 own = curves_.piece(*s);
    if (own.first.t <= p.t && p.t <= own.last.t) names.push_back({*s, p.t});
    const Xy<double> at = point(p);
    add_at_joints(*s, at, room, names);
    // where the curve bounds nothing between, rounding puts a joint there
    if (names.empty() && *s > first_[bezier]) add_at_joints(*s - 1, at, room, names);
    return names;
  }
  void add_at_joints(std::uint32_t segment, const Xy<double>& at, double room, std::vector<Name>& names) const {
    const Spiral_piece_2 piece = curves_.piece(segment);
    const bool has_own = !names.empty();
    for (const bool is_last : {false, true}) {
      if (!(euclidean_norm((is_last ? piece.last : piece.first).point - at) <= room)) continue;
      std::uint32_t e = 2 * segment + is_last;
      do {
        const std::uint32_t other = e / 2;
        const Spiral_piece_2 end = curves_.piece(other);
        if (!has_own || other != segment) names.push_back({other, e % 2 == 1 ? end.last.t : end.first.t});
        e = next_[e];
      } while (e != 2 * segment + is_last);
    }
  }
  [[nodiscard]] Foot_run point_run(const Curve_place& p) const { return {0, 0, 0, true, point(p)}; }

  const Segment_hierarchy& curves_;
  double least_, room_;
  static constexpr std::uint32_t NONE = Bounding_parts::NO_LABEL;
  std::vector<std::uint32_t> first_;  // segments of each Bezier piece
  std::vector<std::uint32_t> next_;   // by end, 2 segment + (1 at its last one): the next one in its joint
};

/// A part of the boundary in its direction: a fat arc, or a point, and samples at both ends.
struct Line_part {
  bool is_point = false, is_left = false;
  std::uint32_t segment = 0;
  Fat_arc_2 fat{};
  Spiral_sample begin, end;
  double error = 0;  ///< of its points
  [[nodiscard]] const Spiral_sample& at(bool is_first) const { return is_first != is_left ? begin : end; }
};

/// What an arc's circle is from a place on the arc's left: the distance, its gradient, and the curvature of the circle
/// about the arc's center through the place.
struct Arc_sight {
  double distance;
  Xy<double> gradient;
  double curvature;
};
/// \param arc a point where both ends are equal
[[nodiscard]] inline Arc_sight sight(const Xy<double>& q, const Arc_2& arc) {
  if (arc.from == arc.to) {
    const Xy<double> way = q - arc.from;
    const double d = euclidean_norm(way);
    return {d, (1 / d) * way, -1 / d};
  }
  const double b = arc.bulge;
  const Arc_view v = view(q, arc);
  return {2 * v.side / ((1 + b * b) * v.chord + v.apart), (-1 / v.apart) * v.w, 4 * b / v.apart};
}

class Line_parts {
 public:
  Line_parts(const Segment_hierarchy& curves, double size) : curves_(curves), size_(size) {
    for (std::uint32_t i = 0; i < curves.number_of_segments(); ++i) error_ = (std::max)(error_, curves.error(i));
  }
  static constexpr double UNBOUNDED = std::numeric_limits<double>::infinity();

  [[nodiscard]] double size() const { return size_; }
  /// The error of any point.
  [[nodiscard]] double error() const { return error_; }

  [[nodiscard]] Line_part part(const Foot_run& run, bool is_left) const {
    Line_part p;
    p.is_left = is_left, p.is_point = run.is_point, p.segment = run.segment;
    if (run.is_point) {
      p.begin.point = p.end.point = p.fat.arc.from = p.fat.arc.to = run.point;
      p.fat.radius = 8 * HALF_ULP * size_;
      return p;
    }
    const bool is_growing = run.is_growing() != is_left;
    const double begin = is_left ? run.to : run.from, end = is_left ? run.from : run.to;
    p.error = curves_.error(run.segment);
    p.begin = sample(run.segment, begin), p.end = sample(run.segment, end);
    p.fat = curves_.region(is_growing ? Spiral_piece_2{run.segment, p.begin, p.end}
                                      : Spiral_piece_2{run.segment, p.end, p.begin});
    if (!is_growing) {
      p.fat.arc = reversed(p.fat.arc);
      p.begin.tangent = -p.begin.tangent, p.end.tangent = -p.end.tangent;
    }
    // a piece that is hardly longer than the error
    if (p.fat.radius >= euclidean_norm(p.fat.arc.to - p.fat.arc.from)) {
      p.is_point = true;
      p.fat.arc.from = p.fat.arc.to = 0.5 * (p.begin.point + p.end.point);
    }
    return p;
  }
  [[nodiscard]] Spiral_sample sample(std::uint32_t segment, double t) const { return sample_at(curves_, segment, t); }

 private:
  const Segment_hierarchy& curves_;
  double size_, error_ = 0;
};

}  // namespace CGAL::Bounding_arcs::internal

#endif
