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
#include <memory>
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

namespace {

/// The values of p over a range. \pre the range is in [0, infinity)
[[nodiscard]] Exact_range values_over(const Univariate& p, const Exact_range& t) {
  Exact_range value{Exact_rational(0), Exact_rational(0)};
  for (int i = p.degree(); i >= 0; --i) {
    const Exact_rational c(coefficient(p, i));
    value = {Exact_rational(value.lower * (CGAL::is_negative(value.lower) ? t.upper : t.lower) + c),
             Exact_rational(value.upper * (CGAL::is_negative(value.upper) ? t.lower : t.upper) + c)};
  }
  return value;
}

}  // namespace

std::optional<Exact_range> quotients_over(const Univariate& n, const Univariate& d, const Exact_range& t) {
  const Exact_range p = values_over(n, t), q = values_over(d, t);
  if (!CGAL::is_positive(q.lower)) return std::nullopt;
  return Exact_range{Exact_rational(p.lower / (CGAL::is_negative(p.lower) ? q.lower : q.upper)),
                     Exact_rational(p.upper / (CGAL::is_negative(p.upper) ? q.upper : q.lower))};
}

namespace {

/// The numerator of p(from + u (to - from)), u in [0,1], in Bernstein's form; from and to over 2^k.
[[nodiscard]] Bernstein_polynomial<Integer> over_range(const Univariate& p, const Integer& from, const Integer& to,
                                                       int k) {
  const Univariate way = polynomial<Integer>({from, Integer(to - from)});
  Univariate value(Integer(0));
  Integer power(1);
  for (int i = p.degree(); i >= 0; --i) {
    value = value * way + Univariate(Integer(coefficient(p, i) * power));
    power *= power_of_two(k);
  }
  return to_bernstein(value, p.degree());
}

/// n(t) / d(t) as a number of its own. \pre d is positive on [0,1]
[[nodiscard]] Exact_parameter coordinate_at(const Univariate& n, const Univariate& d, const Exact_parameter& t) {
  Univariate common = CGAL::gcd(n, d);  // elsewhere on the curve; all numbers would be roots of the resultant
  if (CGAL::sign(Integer(coefficient(common, 0))) == CGAL::NEGATIVE) common = -common;
  const Univariate x = CGAL::integral_division(n, common), w = CGAL::integral_division(d, common);
  std::vector<Univariate> by_t;  // x(t) - x w(t), coefficients in x
  for (int j = 0; j <= (std::max)(x.degree(), w.degree()); ++j)
    by_t.push_back(polynomial<Integer>({coefficient(x, j), Integer(-coefficient(w, j))}));
  const Univariate m = t.polynomial();
  std::vector<Univariate> constants;
  for (int j = 0; j <= m.degree(); ++j) constants.emplace_back(coefficient(m, j));
  const Univariate all = CGAL::resultant(polynomial(constants), polynomial(by_t));
  const auto roots = std::make_shared<const Univariate>(square_free(all));
  constexpr int SPARE_BITS = 8;
  for (int bits = FIRST_BITS;; bits *= 2) {
    t.refine_to(bits);
    const std::optional<Exact_range> range = quotients_over(x, w, {t.lower(), t.upper()});
    if (!range) continue;
    if (range->lower == range->upper) return Exact_parameter(range->lower);
    const int k = bits + SPARE_BITS;
    const auto scaled = [k](const Exact_rational& bound) {
      const auto [numerator, denominator] = decomposed(Exact_rational(bound * Exact_rational(power_of_two(k))));
      return Integer(numerator / denominator);
    };
    const Integer from = scaled(range->lower) - Integer(1), to = scaled(range->upper) + Integer(1);
    const auto over = over_range(*roots, from, to, k);
    const auto& c = over.scaled_coefficients();
    if (c.front() != Integer(0) && c.back() != Integer(0) && sign_variations(over).most() == 1)
      return Exact_parameter(Real_root(roots, from, to, k));
  }
}

}  // namespace

std::optional<Exact_point> Exact_place::rational_point() const {
  if (!curve_) return Exact_point{coordinates_[0]->lower(), coordinates_[1]->lower()};
  if (t_->lower() != t_->upper()) return std::nullopt;
  return curve_->point(t_->lower());
}

Exact_range Exact_place::range(bool is_x, int bits) const {
  if (!curve_) return {coordinates_[is_x ? 0 : 1]->lower(), coordinates_[is_x ? 0 : 1]->lower()};
  const Integer_piece& piece = curve_->piece();
  for (;; bits *= 2) {
    t_->refine_to(bits);
    if (auto range = quotients_over(is_x ? piece.x : piece.y, piece.w, {t_->lower(), t_->upper()})) return *range;
  }
}

const Exact_parameter& Exact_place::coordinate(bool is_x) {
  std::optional<Exact_parameter>& number = coordinates_[is_x ? 0 : 1];
  if (!number) number = coordinate_at(is_x ? curve_->piece().x : curve_->piece().y, curve_->piece().w, *t_);
  return *number;
}

int Exact_place::compare(Exact_place& other, bool is_x) {
  const Exact_range a = range(is_x, FIRST_BITS), b = other.range(is_x, FIRST_BITS);
  if (a.upper < b.lower) return -1;
  if (b.upper < a.lower) return 1;
  if (curve_ && curve_ == other.curve_ && t_->compare(*other.t_) == 0) return 0;
  return coordinate(is_x).compare(other.coordinate(is_x));
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
