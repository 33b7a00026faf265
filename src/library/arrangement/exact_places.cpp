// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Bodies of Exact_place.h.

#include "Exact_place.h"

#include <CGAL/Bounding_arcs_2/number/expected.h>
#include "../curve/exact_bezier.h"

#include <algorithm>
#include <memory>
#include <stdexcept>

namespace CGAL::Bounding_arcs::internal {

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

Arranged_pair::Arranged_pair(Arranged_curve_handle first, Arranged_curve_handle second)
    : a(std::move(first)), b(std::move(second)) {}
Arranged_pair::~Arranged_pair() = default;

const Exact_common& exact_common(const Arranged_pair& pair) {
  return pair.exact([&pair] {
    const Integer_piece &p = pair.a->exact().piece(), &q = pair.b->exact().piece();
    if (pair.a == pair.b) return Exact_common{false, exact_meetings(p, Parameter_order::RISING)};
    // over a point of a straight piece there are several parameters, which is the slow case for the second piece
    const bool is_b_first = q.is_straight() && !p.is_straight();
    return Exact_common{is_b_first, is_b_first ? exact_meetings(q, p) : exact_meetings(p, q)};
  });
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

namespace {

/// Where two curves meet, on the one that comes first.
[[nodiscard]] Exact_place exact_crossing(const Arranged_point& p) {
  const Exact_curve &a = p.pair->a->exact(), &b = p.pair->b->exact();
  if (std::optional<Exact_parameter> t = crossing_of_segments(a, b)) return {a, *std::move(t)};
  const Exact_common& common = exact_common(*p.pair);
  const Bracket& range = common.is_b_first ? p.s : p.t;
  for (const Exact_meeting& m : common.found.points)
    if (Exact_parameter t(m.t); t.is_in(range)) return {common.is_b_first ? b : a, std::move(t)};
  throw std::logic_error(expected("common point of curves", "an exact parameter in its bracket", "none"));
}

/// All parameters at which a curve runs through a point.
[[nodiscard]] std::vector<Exact_parameter> parameters_at(const Exact_curve& c, Exact_place& at) {
  std::vector<Exact_parameter> found;
  if (const std::optional<Exact_point> p = at.rational_point()) {
    for (const Real_root& t : exact_roots_at(c.piece(), *p)) found.emplace_back(t);
    return found;
  }
  for (const Real_root& t : unit_roots(places_of(c.piece(), at.curve()->piece(), at.t().polynomial()))) {
    Exact_place candidate(c, Exact_parameter(t));
    if (candidate.compare(at, true) == 0 && candidate.compare(at, false) == 0) found.push_back(candidate.t());
  }
  return found;
}

}  // namespace

Exact_place& exact_place(const Arranged_point& p) {
  if (p.exact) return *p.exact;
  if (p.is_double())
    p.exact = std::make_shared<Exact_place>(Exact_point{Exact_rational(p.x.lower), Exact_rational(p.y.lower)});
  else if (p.turning) p.exact = std::make_shared<Exact_place>(p.turning->exact(), p.turning->exact_turns()[p.turn]);
  else if (p.t.is_single())
    p.exact = std::make_shared<Exact_place>(p.pair->a->exact(), Exact_parameter(Exact_rational(p.t.lower)));
  else p.exact = std::make_shared<Exact_place>(exact_crossing(p));
  return *p.exact;
}

const Exact_curve& Arranged_curve::exact() const {
  return exact_([this] { return Exact_curve(exact_bezier(bezier())); });
}

const std::vector<Exact_parameter>& Arranged_curve::exact_turns() const {
  return exact_turns_([this] {
    const Integer_piece& piece = exact().piece();
    return turns_of(is_vertical() ? piece.y : piece.x, piece.w);
  });
}

Branches branches_at(const Arranged_curve& c, const Exact_parameter& t) {
  Branches at{0, 0};
  for (const Exact_parameter& turn : c.exact_turns()) {
    const int order = turn.compare(t);
    if (order < 0) ++at.before;
    if (order <= 0) ++at.behind;
  }
  return at;
}

void add_places(const Arranged_point& p, const Arranged_curve& c, const Bracket& range) {
  for (const Exact_parameter& t : parameters_at(c.exact(), exact_place(p))) {
    const Bracket at = t.range();
    if (!at.touches(range)) continue;
    const Branches on = branches_at(c, t);
    add_place(p, {c.number(), on.before, at});
    add_place(p, {c.number(), on.behind, at});
  }
}

}  // namespace CGAL::Bounding_arcs::internal
