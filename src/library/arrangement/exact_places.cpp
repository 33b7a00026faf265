// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Bodies of exact_places.h.

#include "exact_places.h"

#include <CGAL/Bounding_arcs_2/number/expected.h>
#include "../curve/exact_bezier.h"

#include <algorithm>
#include <memory>
#include <stdexcept>

namespace CGAL::Bounding_arcs::internal {

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
    if (candidate.is_at(at)) found.push_back(candidate.t());
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
