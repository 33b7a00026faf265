// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The point of a piece of a spiral segment that is nearest to a point q.
//
// With f(s) = |C - q|^2, s the arc length, the unit tangent T and normal n,
//   f' / 2 = (C - q).T,   f'' / 2 = 1 - kappa (q - C).n  >=  m,
// where m comes from the largest curvature and the largest (q - C).n of the piece.  Where f' has one sign, an end is
// nearest.  Where m > 0, there is one nearest point, which Newton's steps find, and in whatever point they end, with
// g = (C - q).T, the least distance is at least sqrt(f - g^2 / m): so the bracket does not hang on how well they
// converged, and pieces whose bracket is beyond what is looked for are left after the first step.

#ifndef BOUNDING_ARCS_LIBRARY_QUERY_FOOT_H
#define BOUNDING_ARCS_LIBRARY_QUERY_FOOT_H

#include "../tree/Segment_hierarchy.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>

namespace CGAL::Bounding_arcs::internal {

/// Bounds of the distance of the exact curve by that of a point which is within `error` of it.
[[nodiscard]] inline Bracket bounds_of_point(double distance, double error) {
  const double room = error + 4 * HALF_ULP * distance;
  return {(std::max)(0.0, distance - room), distance + room};
}

/// An upper bound of the length of a piece, which is as long as its box is wide and high at most.
[[nodiscard]] inline double most_length(const Spiral_piece_2& p, double error) {
  const Xy<double> chord = p.last.point - p.first.point;
  return (std::fabs(chord.x) + std::fabs(chord.y)) * ROUNDED_UP<4> + 4 * error;
}

/// How far computed first derivatives are from those of the exact curve.
[[nodiscard]] inline double derivative_error(const Segment_hierarchy& curves, std::uint32_t bezier) {
  const Bezier_evaluator& curve = curves.evaluator(bezier);
  return curve.first_error() + curve.first_change(curves.rounding(bezier));
}
/// Returns that error at one parameter.
[[nodiscard]] inline double derivative_error(const Bezier_evaluator& curve, double rounding, double t,
                                             const Curve_jet& jet) {
  const double error = curve.errors_at(t, jet).first;
  return error + curve.first_change(rounding, error);
}

/// What the curve is at a parameter of a piece. A cut at a cusp, or where a line turns back, is rounded, as a rule to a
/// double that is past it by less than its ulp: there the derivative runs backwards, against the direction in which the
/// piece ends, and is turned round.
[[nodiscard]] inline Curve_jet jet_of_piece(const Bezier_evaluator& curve, const Spiral_sample& first,
                                            const Spiral_sample& last, double t) {
  Curve_jet jet = curve(t);
  const bool runs_back =
      (t == first.t && dot(jet.first, first.tangent) < 0) || (t == last.t && dot(jet.first, last.tangent) < 0);
  if (runs_back) jet.first = -jet.first;
  return jet;
}

/// How f behaves over a piece.
struct Foot_convexity {
  double least = 0;                            ///< m
  bool is_rising = false, is_falling = false;  ///< f' has one sign
};
/// A piece is as long as its box is wide and high at most, and each point within half of that of an end.  From there
/// (q - C).T changes by 1 + kappa |q - C| per length, (q - C).n by kappa |(q - C).T|.  T is between the tangents at the
/// ends, less than half a turn apart, so that f' has the sign that both have for all of the box.
[[nodiscard]] inline Foot_convexity foot_convexity(const Xy<double>& q, const Spiral_piece_2& piece, double error) {
  const Xy<double> u0 = q - piece.first.point, u1 = q - piece.last.point, chord = u0 - u1;
  const Xy<double>&d0 = piece.first.tangent, &d1 = piece.last.tangent;
  constexpr double UP = ROUNDED_UP<16>;
  const double size = most_length(piece, error);
  const double most = (std::sqrt((std::max)(dot(u0, u0), dot(u1, u1))) + size) * UP;
  const double room = (tangent_error(piece.first, piece.last) + TANGENT_ROUNDING) * most + 2 * error;
  const double along0 = dot(u0, d0), along1 = dot(u1, d1), beside0 = dot(u1, d0), beside1 = dot(u0, d1);
  const double across0 = std::fabs(chord.x * d0.x) + std::fabs(chord.y * d0.y),
               across1 = std::fabs(chord.x * d1.x) + std::fabs(chord.y * d1.y);
  Foot_convexity result;
  const double middle0 = along0 + beside0, middle1 = along1 + beside1, twice = 2 * room;
  result.is_rising = middle0 < -(across0 + twice) && middle1 < -(across1 + twice);
  result.is_falling = middle0 > across0 + twice && middle1 > across1 + twice;
  const double curvature = (std::max)(piece.first.most_curvature, piece.last.most_curvature);
  if (!(curvature < std::numeric_limits<double>::max())) return result;
  const double turn = cross(d0, d1) < 0 ? -1 : 1, half = size / 2 * UP;
  const double along =
      (std::min)(most, (std::max)(std::fabs(along0), std::fabs(along1)) + (1 + curvature * most) * half + room);
  const double inward = turn > 0 ? (std::max)(cross(d0, u0), cross(d1, u1)) : -(std::min)(cross(d0, u0), cross(d1, u1));
  result.least = 1 - curvature * (std::max)(0.0, inward + curvature * along * half + room) * UP;
  return result;
}

/// The nearest point of a piece over which f is convex.
class Foot {
 public:
  enum class Outcome { FOUND, TOO_FAR, UNKNOWN };

  /// \param convexity m > 0
  /// \param most what is farther is not looked for
  Foot(const Segment_hierarchy& curves, const Xy<double>& q, const Spiral_piece_2& piece, double convexity, double most)
      : curve_(curves.evaluator(curves.bezier_of(piece.segment))), q_(q), convexity_(convexity),
        error_(curves.error(piece.segment)), rounding_(curves.rounding(curves.bezier_of(piece.segment))),
        first_(piece.first), last_(piece.last), length_(most_length(piece, error_)), t0_(piece.first.t),
        t1_(piece.last.t), low_(t0_), high_(t1_) {
    // along a circle both are sines of angles on the way to the foot
    const double before = dot(q - piece.first.point, piece.first.tangent),
                 behind = dot(piece.last.point - q, piece.last.tangent);
    t = !(before > 0) ? t0_ : (!(behind > 0) ? t1_ : t0_ + before / (before + behind) * (t1_ - t0_));
    const double limit = most + 2 * error_;
    find(limit * limit);
  }

  Outcome outcome = Outcome::UNKNOWN;
  double t = 0;         ///< where the distance is what the bracket says
  double better_t = 0;  ///< one step on, which is not looked at; nearer but where the speed is hardly known
  Bracket distance{};

 private:
  void find(double square_limit) {
    constexpr int MOST_STEPS = 60;
    for (int step = 1;; ++step) {
      look();
      const double drop = least_square_speed_ > 0 ? fall_ / least_square_speed_ * fall_ / convexity_
                                                  : std::numeric_limits<double>::infinity();
      if (drop * ROUNDED_UP<32> <= square_ - square_limit) {
        outcome = Outcome::TOO_FAR;
        return;
      }
      if (std::fabs(slope_) <= fall_ - std::fabs(slope_)) break;  // no sign
      if (slope_ > 0) high_ = t;
      else low_ = t;
      if (is_at_end()) break;
      const double next = step_from_here();
      if (next == t) break;
      // what is left to gain is nothing beside the error: one more step for the point's sake
      if (drop <= error_ * (std::max)(std::fabs(way_.x), std::fabs(way_.y))) {
        finish();
        better_t = next;
        return;
      }
      if (step == MOST_STEPS) break;  // t is what was looked at
      t = next;
    }
    finish();
    better_t = t;
  }
  // Sums of coordinates stand for norms in what slope and speed may be wrong by.
  void look() {
    const Curve_jet jet = jet_of_piece(curve_, first_, last_, t);
    const double first_error = derivative_error(curve_, rounding_, t, jet);
    way_ = jet.point - q_;
    slope_ = dot(way_, jet.first);
    square_ = dot(way_, way_);
    const double square_speed = dot(jet.first, jet.first);
    rate_ = square_speed + dot(way_, jet.second);
    const double speed = std::fabs(jet.first.x) + std::fabs(jet.first.y), far = std::fabs(way_.x) + std::fabs(way_.y);
    fall_ = std::fabs(slope_) + ((speed + first_error) * error_ + far * (first_error + 8 * HALF_ULP * speed));
    least_square_speed_ = square_speed * ROUNDED_DOWN<32> - 2 * first_error * speed;
  }
  [[nodiscard]] bool is_at_end() const { return slope_ > 0 ? t == t0_ : t == t1_; }
  [[nodiscard]] double step_from_here() const {
    const double next = rate_ > 0 ? t - slope_ / rate_ : t;
    if (rate_ > 0 && next == t) return t;  // the foot is between this double and the next one
    if (next > low_ && next < high_) return next;
    if (!(next > low_) && low_ == t0_ && t != t0_ && rate_ > 0) return t0_;
    if (!(next < high_) && high_ == t1_ && t != t1_ && rate_ > 0) return t1_;
    return low_ + (high_ - low_) / 2;
  }
  // f'' / 2 >= m: the least is at most g^2 / m below, and as f'' > 0, at most 2 g times the length
  void finish() {
    if (!(least_square_speed_ > 0)) return;  // no direction
    const bool is_end = (t == t0_ && slope_ >= 0) || (t == t1_ && slope_ <= 0);
    const double fall = is_end ? fall_ - std::fabs(slope_) : fall_, d = std::sqrt(square_);
    const double g = fall / std::sqrt(least_square_speed_),
                 drop = g * (std::min)(g / convexity_, 2 * length_) * ROUNDED_UP<32>;
    const double beside = drop < square_ ? drop / (d + std::sqrt(square_ - drop)) : d;
    distance = bounds_of_point(d, error_);
    distance.lower = (std::max)(0.0, distance.lower - beside * ROUNDED_UP<8>);
    outcome = Outcome::FOUND;
  }

  const Bezier_evaluator& curve_;
  Xy<double> q_;
  double convexity_, error_, rounding_;
  const Spiral_sample &first_, &last_;
  double length_, t0_, t1_, low_, high_;
  Xy<double> way_;
  double slope_ = 0, square_ = 0, rate_ = 0;
  // at least |slope| and at most the speed's square of the exact curve
  double fall_ = 0, least_square_speed_ = 0;
};

}  // namespace CGAL::Bounding_arcs::internal

#endif
