// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Bodies of Exact_curve.h.
//
// In one sector x and y are strictly monotone, but along an axis, where one way goes at high_end.  At the x of a point
// p of the one, the other one is above or below p: neither meets the other between the common point and there.  So
// order needs no tangent, and no number but rational ones.

#include "Exact_curve.h"

#include <CGAL/Bounding_arcs_2/number/expected.h>

#include <CGAL/number_utils.h>

#include <algorithm>
#include <stdexcept>
#include <utility>

namespace CGAL::Bounding_arcs::internal {

Exact_curve::Exact_curve(Bezier_curve_2<Exact_rational> bezier) : bezier_(std::move(bezier)), piece_(bezier_) {}

Exact_point Exact_curve::point(const Exact_rational& t) const {
  const Exact_rational w = value_at(piece_.w, t);
  return {Exact_rational(value_at(piece_.x, t) / w), Exact_rational(value_at(piece_.y, t) / w)};
}

const std::vector<Exact_parameter>& Exact_curve::turns() {
  if (!turns_) {
    turns_.emplace();
    for (const Univariate* n : {&piece_.x, &piece_.y}) {
      const Univariate change = derivative_numerator(*n, piece_.w);
      if (change.is_zero()) continue;
      for (const Real_root& t : unit_roots(odd_part(change))) turns_->emplace_back(t);
    }
    std::sort(turns_->begin(), turns_->end(),
              [](const Exact_parameter& p, const Exact_parameter& q) { return p.compare(q) < 0; });
  }
  return *turns_;
}

std::optional<Exact_parameter> crossing_of_segments(const Exact_curve& a, const Exact_curve& b) {
  if (!a.is_segment() || !b.is_segment()) return std::nullopt;
  const auto &p = a.bezier().control_points(), &q = b.bezier().control_points();
  const Exact_point along = p.back() - p.front(), across = q.back() - q.front(), way = q.front() - p.front();
  const Exact_rational sine = cross(along, across);
  if (CGAL::is_zero(sine)) return std::nullopt;
  return Exact_parameter(Exact_rational(cross(way, across) / sine));
}

int Exact_way::sector() const {
  constexpr int SECTORS[3][3] = {{5, 4, 3}, {6, -1, 2}, {7, 0, 1}};  // by signs of x, then of y
  return SECTORS[x_sign + 1][y_sign + 1];
}

Exact_way exact_way(Exact_curve& curve, const Exact_parameter& from, const Exact_parameter& end) {
  const bool is_forward = from.compare(end) < 0;
  const Exact_parameter* limit = &end;
  for (const Exact_parameter& turn : curve.turns())
    if (is_forward ? from.compare(turn) < 0 && turn.compare(*limit) < 0
                   : turn.compare(from) < 0 && limit->compare(turn) < 0)
      limit = &turn;
  const Exact_rational to = is_forward ? number_between(from, *limit) : number_between(*limit, from);
  // two rational places on the way, which is monotone
  const Exact_rational near = (to + (is_forward ? from.upper() : from.lower())) / Exact_rational(2);
  const Exact_point way = curve.point(to) - curve.point(near);
  return {&curve, &from, to, static_cast<int>(CGAL::sign(way.x)), static_cast<int>(CGAL::sign(way.y))};
}

namespace {

/// Goes nearer and nearer to the start of a way.
class Nearing {
 public:
  explicit Nearing(const Exact_way& way) : way_(way), t_(way.to), is_forward_(way.from->compare(way.to) < 0) {}

  [[nodiscard]] const Exact_rational& t() const { return t_; }
  void go_on() {
    constexpr int MOST = 1 << 12;  // ways from one point need no more but where curves differ by 2^-4096
    if (++count_ == MOST) throw std::logic_error(expected("order round a vertex", "ways from one point", "from two"));
    do way_.from->refine();
    while (is_forward_ ? bound() >= t_ : bound() <= t_);
    t_ = (bound() + t_) / Exact_rational(2);
  }

 private:
  [[nodiscard]] Exact_rational bound() const { return is_forward_ ? way_.from->upper() : way_.from->lower(); }

  const Exact_way& way_;
  Exact_rational t_;
  bool is_forward_;
  int count_ = 0;
};

/// The sign of y at the only parameter between two others at which x is 0, in homogeneous coordinates.
[[nodiscard]] int sign_between(const Univariate& x, const Univariate& y, Exact_rational low, Exact_rational high) {
  const auto at_low = CGAL::sign(value_at(x, low));
  constexpr int MOST = 1 << 12;  // where ways do not meet again, as for Nearing
  for (int i = 0; i < MOST; ++i) {
    const Exact_range over = values_over(y, {low, high});
    if (CGAL::is_positive(over.lower)) return 1;
    if (CGAL::is_negative(over.upper)) return -1;
    const Exact_rational half = (low + high) / Exact_rational(2);
    const auto at_half = CGAL::sign(value_at(x, half));
    if (at_half == CGAL::ZERO) {
      const auto sign = CGAL::sign(value_at(y, half));
      if (sign == CGAL::ZERO) break;
      return static_cast<int>(sign);
    }
    (at_half == at_low ? low : high) = half;
  }
  throw std::logic_error(expected("order round a vertex", "ways that do not meet again", "a common point"));
}

}  // namespace

bool is_counterclockwise_of(const Exact_way& q, const Exact_way& p) {
  // p's point at a parameter so near that q runs beyond its x
  const Exact_rational beyond = q.curve->point(q.to).x;
  const auto is_ahead = [&](const Exact_rational& x, const Exact_rational& of) {
    return p.x_sign > 0 ? of < x : x < of;
  };
  Nearing of_p(p), of_q(q);
  Exact_point at = p.curve->point(of_p.t());
  while (!is_ahead(beyond, at.x)) {
    of_p.go_on();
    at = p.curve->point(of_p.t());
  }
  do of_q.go_on();
  while (!is_ahead(at.x, q.curve->point(of_q.t()).x));
  const Exact_rational& near = of_q.t();
  const Integer_piece& piece = q.curve->piece();
  const int above = sign_between(moved(piece.x, piece.w, at.x), moved(piece.y, piece.w, at.y), (std::min)(near, q.to),
                                 (std::max)(near, q.to));
  return above == p.x_sign;
}

}  // namespace CGAL::Bounding_arcs::internal
