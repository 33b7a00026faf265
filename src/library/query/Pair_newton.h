// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The nearest points of two pieces over which the squared distance is strictly convex (Piece_pair.h): Newton's steps,
// held in the rectangle of both parameters.
//
// Where half the second derivatives by the arc lengths are at least m, f is at least f0 + 2 g.x + m |x|^2, and that is
// at least f0 - |g|^2 / m, where components of g by which no x in the rectangle makes f fall are left out: so the
// bracket does not hang on how well the steps converged.

#ifndef BOUNDING_ARCS_LIBRARY_QUERY_PAIR_NEWTON_H
#define BOUNDING_ARCS_LIBRARY_QUERY_PAIR_NEWTON_H

#include "../tree/Segment_hierarchy.h"
#include "Foot.h"

#include <algorithm>
#include <cmath>

namespace CGAL::Bounding_arcs::internal {

/// One of two curves: where a step is in its range.
class Newton_side {
 public:
  Newton_side(const Segment_hierarchy& curves, const Spiral_piece_2& piece)
      : curve_(curves.evaluator(curves.bezier_of(piece.segment))),
        rounding_(curves.rounding(curves.bezier_of(piece.segment))), first_(piece.first), last_(piece.last),
        error(curves.error(piece.segment)), low_(piece.first.t), high_(piece.last.t), t(low_ + (high_ - low_) / 2) {}

  void evaluate() {
    jet = jet_of_piece(curve_, first_, last_, t);
    speed = euclidean_norm(jet.first);
    first_error_ = derivative_error(curve_, rounding_, t, jet);
  }
  /// \param way from the other curve's point
  void look(const Xy<double>& way) {
    slope = dot(way, jet.first);
    rate = speed * speed + dot(way, jet.second);
    is_pinned = (t == low_ && slope >= 0) || (t == high_ && slope <= 0);
    noise = is_moving() ? euclidean_norm(way) * (first_error_ / least_speed() + 8 * HALF_ULP) : 0;
  }
  /// The amount by which f may fall along the curve per length at least; all is unknown where the curve has no
  /// direction.
  [[nodiscard]] double fall(double error_of_points) const {
    return (is_pinned ? 0 : std::fabs(slope) / least_speed()) + noise + error_of_points;
  }
  [[nodiscard]] bool move(double by) {
    const double before = t;
    t = (std::min)((std::max)(t + by, low_), high_);
    return t != before;
  }
  [[nodiscard]] double least_speed() const { return speed * ROUNDED_DOWN<8> - first_error_; }
  [[nodiscard]] bool is_moving() const { return least_speed() > 0; }

 private:
  const Bezier_evaluator& curve_;
  double rounding_, first_error_ = 0;
  const Spiral_sample &first_, &last_;

 public:
  double error;

 private:
  double low_, high_;

 public:
  double t, speed = 0, slope = 0, rate = 0, noise = 0;
  bool is_pinned = false;
  Curve_jet jet;
};

class Pair_newton {
 public:
  Pair_newton(const Segment_hierarchy& curves_a, const Spiral_piece_2& piece_a, const Segment_hierarchy& curves_b,
              const Spiral_piece_2& piece_b)
      : a(curves_a, piece_a), b(curves_b, piece_b) {
    constexpr int MOST_STEPS = 40;
    for (int step = 0; step < MOST_STEPS; ++step) {
      look();
      if (!a.is_moving() || !b.is_moving() || is_done() || !make_step()) return;
    }
    look();
  }

  /// Bounds of the least distance. \param least a positive number, at most the least eigenvalue
  [[nodiscard]] Bracket bounds(double least) const {
    const double error = a.error + b.error, room = error + 4 * HALF_ULP * distance;
    if (!a.is_moving() || !b.is_moving()) return {0, distance + room};
    const double fall_a = a.fall(error), fall_b = b.fall(error), square = distance * distance;
    const double drop = (fall_a * fall_a + fall_b * fall_b) / least;
    const double beside = drop < square ? drop / (distance + std::sqrt(square - drop)) : distance;
    return {(std::max)(0.0, distance - beside * ROUNDED_UP<8> - room), distance + room};
  }

  Newton_side a, b;
  double distance = 0;

 private:
  void look() {
    a.evaluate();
    b.evaluate();
    const Xy<double> way = a.jet.point - b.jet.point;
    a.look(way);
    b.look(-way);
    distance = euclidean_norm(way);
  }
  [[nodiscard]] bool is_done() const {
    const auto is_zero = [&](const Newton_side& x) {
      return x.is_pinned || std::fabs(x.slope) <= x.speed * (x.noise + a.error + b.error);
    };
    return is_zero(a) && is_zero(b);
  }
  [[nodiscard]] bool make_step() {
    const double mixed = -dot(a.jet.first, b.jet.first), determinant = a.rate * b.rate - mixed * mixed;
    double da = 0, db = 0;
    if (!a.is_pinned && !b.is_pinned && a.rate > 0 && determinant > 0) {
      da = (mixed * b.slope - b.rate * a.slope) / determinant;
      db = (mixed * a.slope - a.rate * b.slope) / determinant;
    } else {
      const auto alone = [](const Newton_side& x) {
        return x.is_pinned ? 0 : -x.slope / (x.rate > 0 ? x.rate : x.speed * x.speed);
      };
      da = alone(a);
      db = alone(b);
    }
    const bool moves_a = a.move(da), moves_b = b.move(db);
    return moves_a || moves_b;
  }
};

}  // namespace CGAL::Bounding_arcs::internal

#endif
