// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Bodies of Exact_curve.h.
//
// In one sector x and y are strictly monotone, but along an axis, where one way goes at most.  At the x of a point of
// the one, the other one is above or below that point: neither meets the other between the common point and there.  So
// order needs no tangent.

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

std::vector<Exact_parameter> turns_of(const Univariate& n, const Univariate& w) {
  std::vector<Exact_parameter> turns;
  const Univariate change = derivative_numerator(n, w);
  if (change.is_zero()) return turns;
  for (const Real_root& t : unit_roots(odd_part(change)))
    if (Exact_parameter turn(t); turn.compare(Exact_rational(0)) > 0 && turn.compare(Exact_rational(1)) < 0)
      turns.push_back(std::move(turn));
  return turns;
}

const std::vector<Exact_parameter>& Exact_curve::turns() {
  if (!turns_) {
    turns_ = turns_of(piece_.x, piece_.w);
    const std::vector<Exact_parameter> of_y = turns_of(piece_.y, piece_.w);
    turns_->insert(turns_->end(), of_y.begin(), of_y.end());
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

/// The sign of a way's y less that of a point, at the point's x. \pre the way has that x
[[nodiscard]] int sign_above(const Exact_way& way, const Exact_point& p) {
  const Integer_piece& piece = way.curve->piece();
  for (Real_root& t : unit_roots(moved(piece.x, piece.w, p.x))) {
    const Exact_parameter at(t);
    const int from = way.from->compare(at), to = at.compare(way.to);
    if (from != 0 && from * to >= 0) return t.sign_of(moved(piece.y, piece.w, p.y));
  }
  return 0;
}

}  // namespace

bool is_counterclockwise_of(const Exact_way& q, const Exact_way& p) {
  const Exact_point of_p = p.curve->point(p.to), of_q = q.curve->point(q.to);
  const bool is_p_nearer = p.x_sign > 0 ? of_p.x < of_q.x : of_q.x < of_p.x;
  const int above = is_p_nearer ? sign_above(q, of_p) : -sign_above(p, of_q);  // of q
  if (above == 0)
    throw std::logic_error(expected("order round a vertex", "ways that do not meet again", "a common point"));
  return above == p.x_sign;
}

}  // namespace CGAL::Bounding_arcs::internal
