// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Bodies of arrangement/internal/arr_predicates.h.

#include <CGAL/Bounding_arcs_2/arc/Arc_2.h>
#include <CGAL/Bounding_arcs_2/arrangement/internal/Exact_place.h>
#include <CGAL/Bounding_arcs_2/arrangement/internal/arr_predicates.h>
#include <CGAL/Bounding_arcs_2/curve/exact_bezier.h>
#include <CGAL/Bounding_arcs_2/number/expected.h>
#include <CGAL/Bounding_arcs_2/query/exact_intersections.h>
#include <CGAL/Bounding_arcs_2/query/meeting_places.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <memory>
#include <stdexcept>
#include <utility>

namespace CGAL::Bounding_arcs::internal {

namespace {

[[nodiscard]] Comparison_result opposite(Comparison_result r) { return static_cast<Comparison_result>(-r); }

/// Whether points share a place on a curve, which makes them one.
[[nodiscard]] bool share_a_place(const Arranged_point& p, const Arranged_point& q) {
  for (const Arranged_place& a : p.places)
    for (const Arranged_place& b : q.places) {
      if (a.curve != b.curve || !a.t.touches(b.t)) continue;
      if (a.t.is_single() && b.t.is_single()) return true;
      if (p.is_double() || q.is_double()) continue;
      Real_root *t = exact_parameter(p, a), *s = exact_parameter(q, b);
      if (t != nullptr && s != nullptr && t->compare(*s) == 0) return true;
    }
  return false;
}

}  // namespace

Comparison_result compare_coordinates_exactly(const Arranged_point& p, const Arranged_point& q, bool is_x) {
  if (p.x.touches(q.x) && p.y.touches(q.y) && share_a_place(p, q)) return EQUAL;
  return static_cast<Comparison_result>(exact_coordinate(p, is_x).compare(exact_coordinate(q, is_x)));
}

Comparison_result compare_xy(const Arr_point_2& p, const Arr_point_2& q) {
  if (p.data() == q.data()) return EQUAL;
  if (const Comparison_result x = compare_x(p, q); x != EQUAL) return x;
  const Comparison_result y = compare_coordinates(p, q, false);
  if (y == EQUAL) {  // both know now what either one knows
    const auto places = p.data()->places;
    for (const Arranged_place& place : q.data()->places) add_place(*p.data(), place);
    for (const Arranged_place& place : places) add_place(*q.data(), place);
  }
  return y;
}

namespace {

/// The y of a part at an x that is somewhere in a range, in doubles around it; the whole line where they fail.
[[nodiscard]] Bracket y_at(const Arr_x_monotone_curve_2& c, const Bracket& x) {
  constexpr double INFINITE = std::numeric_limits<double>::infinity();
  const Bezier_evaluator& curve = c.data()->evaluator();
  const double way = c.is_rising() ? 1 : -1, error = curve.point_error();
  const double first = (std::min)(c.left_parameter().lower, c.right_parameter().lower),
               last = (std::max)(c.left_parameter().upper, c.right_parameter().upper);
  double low = first, high = last;
  const double aim = x.middle(), left = c.left().x().middle(), width = c.right().x().middle() - left;
  double t = width > 0 ? first + (last - first) *
                                     std::clamp(way > 0 ? (aim - left) / width : 1 - (aim - left) / width, 0.0, 1.0)
                       : low + (high - low) / 2;
  Curve_jet jet = curve(t);
  double miss = way * (jet.point.x - aim);
  constexpr int MOST = 100;
  for (int i = 0; i < MOST && std::fabs(miss) > error; ++i) {
    (miss < 0 ? low : high) = t;
    const double step = t - miss / (way * jet.first.x);
    t = step > low && step < high ? step : low + (high - low) / 2;
    if (t <= low || t >= high) break;
    jet = curve(t);
    miss = way * (jet.point.x - aim);
  }
  // Parameters on both sides of it whose x is beyond the range for certain, or the ends.
  double reach = (4 * error + x.width() + std::fabs(miss)) / std::fabs(jet.first.x) + 4 * HALF_ULP;
  constexpr int TIMES = 8;
  for (int i = 0; i < TIMES; ++i, reach *= 8) {
    const double t0 = (std::max)(first, t - reach), t1 = (std::min)(last, t + reach);
    const Bracket over = way > 0 ? x : Bracket{-x.upper, -x.lower};
    if (t0 > first && !(way * curve(t0).point.x + error < over.lower)) continue;
    if (t1 < last && !(way * curve(t1).point.x - error > over.upper)) continue;
    const double at = t0 + (t1 - t0) / 2, half = (t1 - t0) / 2 * (1 + 8 * HALF_ULP) + 4 * HALF_ULP;
    const Curve_jet there = curve(at);
    const double speed = (std::min)(c.data()->first_bound(),
                                    std::fabs(there.first.y) + curve.first_error() + curve.second_bound() * half);
    const double room = (error + speed * half) * (1 + 8 * HALF_ULP) + HALF_ULP * 4 * std::fabs(there.point.y);
    return {there.point.y - room, there.point.y + room};
  }
  return {-INFINITE, INFINITE};
}

/// An end's parameter, between rational numbers that are nearer the more bits are asked for.
[[nodiscard]] Exact_range end_parameter(const Arr_x_monotone_curve_2& c, bool is_left, int bits) {
  const Bracket& t = is_left ? c.left_parameter() : c.right_parameter();
  const Arranged_point& p = *(is_left ? c.left() : c.right()).data();
  if (!t.is_single() && !p.is_double())
    if (Real_root* root = exact_parameter(p, {c.data()->number(), t})) {
      root->refine_to(bits);
      return {root->lower(), root->upper()};
    }
  return {Exact_rational(t.lower), Exact_rational(t.upper)};
}

/// The y of a part at an x in a range, in a range that shrinks with it.
[[nodiscard]] std::optional<Exact_range> exact_y_at(const Arr_x_monotone_curve_2& c, const Exact_range& x, int bits) {
  const Integer_piece& piece = *c.data()->exact();
  const Exact_range left = end_parameter(c, true, bits), right = end_parameter(c, false, bits);
  const bool is_rising = c.is_rising();
  // the side of x at which the part is at t
  const auto side = [&piece](const Exact_rational& t, const Exact_rational& at) {
    const auto value = [&t](const Univariate& p) { return values_over(p, {t, t}).lower; };
    return static_cast<int>(CGAL::sign(Exact_rational(value(piece.x) - at * value(piece.w))));
  };
  const Exact_rational &from = is_rising ? left.upper : left.lower, &to = is_rising ? right.lower : right.upper;
  const Exact_rational least = Exact_rational(1) / Exact_rational(power_of_two(bits));
  // \return the nearest parameter found whose x is on that side of `at`; the end beyond, if there is none
  const auto beyond = [&](const Exact_rational& at, bool is_left) {
    Exact_rational near = is_left ? from : to, far = is_left ? to : from;
    const int wanted = is_left ? -1 : 1;
    if (side(near, at) * wanted < 0)
      return is_left ? (is_rising ? left.lower : left.upper) : (is_rising ? right.upper : right.lower);
    while (CGAL::abs(Exact_rational(far - near)) > least) {
      const Exact_rational half = (near + far) / Exact_rational(2);
      (side(half, at) * wanted >= 0 ? near : far) = half;
    }
    return near;
  };
  const Exact_rational s = beyond(x.lower, true), t = beyond(x.upper, false);
  return quotients_over(piece.y, piece.w, {(std::min)(s, t), (std::max)(s, t)});
}

[[nodiscard]] Comparison_result compare(const Exact_range& a, const Exact_range& b) {
  return a.upper < b.lower ? SMALLER : (b.upper < a.lower ? LARGER : EQUAL);
}

constexpr int FIRST_BITS = 96, MOST_BITS = 1 << 14;

[[noreturn]] void fail() {
  throw std::logic_error(expected("points and curves of an arrangement", "what 16384 bits tell apart", "nearer ones"));
}

/// Whether a place is on the part for certain, or not, as far as brackets tell.
[[nodiscard]] bool is_within(const Bracket& t, const Arr_x_monotone_curve_2& c) {
  const Bracket &a = c.is_rising() ? c.left_parameter() : c.right_parameter(),
                &b = c.is_rising() ? c.right_parameter() : c.left_parameter();
  return a.upper < t.lower && t.upper < b.lower;
}
[[nodiscard]] bool may_be_within(const Bracket& t, const Arr_x_monotone_curve_2& c) {
  const Bracket &a = c.is_rising() ? c.left_parameter() : c.right_parameter(),
                &b = c.is_rising() ? c.right_parameter() : c.left_parameter();
  return a.lower <= t.upper && t.lower <= b.upper;
}
}  // namespace

bool is_on_part(const Arr_point_2& p, const Bracket& t, const Arr_x_monotone_curve_2& c) {
  if (is_within(t, c)) return true;
  if (!may_be_within(t, c)) return false;
  if (compare_xy(p, c.left()) == EQUAL || compare_xy(p, c.right()) == EQUAL) return true;
  // next to an end, on this side of it or beyond
  const auto is_before = [&](const Bracket& end, bool is_left) {
    Real_root* root =
        t.is_single() || p.data()->is_double() ? nullptr : exact_parameter(*p.data(), {c.data()->number(), t});
    for (int bits = FIRST_BITS; bits <= MOST_BITS; bits *= 2) {
      const Exact_range s = end_parameter(c, is_left, bits);
      if (root != nullptr) root->refine_to(bits);
      const Exact_range own = root != nullptr ? Exact_range{root->lower(), root->upper()}
                                              : Exact_range{Exact_rational(t.lower), Exact_rational(t.upper)};
      if (const Comparison_result r = compare(own, s); r != EQUAL) return r == SMALLER;
    }
    return t.middle() < end.middle();
  };
  return is_before(c.left_parameter(), true) != c.is_rising() && is_before(c.right_parameter(), false) == c.is_rising();
}

namespace {

/// The parameter at which a point that overlaps run through is on the other curve of an overlap.
[[nodiscard]] std::optional<Bracket> place_by_overlap(const Arr_point_2& p, const Arranged_curve& own,
                                                      const Arr_x_monotone_curve_2& c) {
  const Real_root* t = exact_parameter(*p.data(), p.data()->places.front());
  if (t == nullptr) return std::nullopt;
  for (Real_root& s : unit_roots(places_of(*c.data()->exact(), *own.exact(), t->polynomial()))) {
    const Bracket range = s.range();
    const Arranged_curve::Box box = c.data()->at(range);
    if (box.x.touches(p.x()) && box.y.touches(p.y()) && may_be_within(range, c)) return range;
  }
  return std::nullopt;
}

/// Where the part runs through a point, if it does.
[[nodiscard]] std::optional<Bracket> place_on(const Arr_x_monotone_curve_2& c, const Arr_point_2& p,
                                              Meetings_of_pairs& meetings) {
  if (p.data() == c.left().data()) return c.left_parameter();
  if (p.data() == c.right().data()) return c.right_parameter();
  const Arranged_point& point = *p.data();
  const std::uint64_t number = c.data()->number();
  for (const Arranged_place& place : point.places)
    if (place.curve == number && is_on_part(p, place.t, c)) return place.t;
  for (const bool is_left : {true, false})
    if (const Arr_point_2& end = is_left ? c.left() : c.right();
        end.x().touches(p.x()) && end.y().touches(p.y()) && compare_xy(end, p) == EQUAL)
      return is_left ? c.left_parameter() : c.right_parameter();
  const auto found = [&](const Bracket& t) {
    add_place(point, {number, t});
    return t;
  };
  if (point.is_double()) {
    const Xy<Exact_rational> at{Exact_rational(point.x.lower), Exact_rational(point.y.lower)};
    for (const Bracket& t : exact_parameters_at(exact_bezier(c.data()->bezier()), at))
      if (is_on_part(p, t, c)) return found(t);
    return std::nullopt;
  }
  // A curve that the point is on meets this one there, or it is not on this one.
  Arranged_curve_handle own = point.curve ? point.curve : point.turning.lock();
  if (!own && point.turning_bezier)  // the point has outlived its curve
    own = std::make_shared<const Arranged_curve>(*point.turning_bezier, 0, 0);
  if (own) {
    const Bracket& at = point.places.front().t;
    const Arranged_meetings& known = meetings.of(own, c.data());
    for (const auto& m : known.points)
      for (const bool is_second : {false, true}) {  // of one curve with itself, either place may be it
        if (is_second && own != c.data()) break;
        const Bracket &t = is_second ? m.s : m.t, &s = is_second ? m.t : m.s;
        if (!t.touches(at) || !may_be_within(s, c)) continue;
        if (compare_xy(p, Arr_point_2(m.point)) == EQUAL && is_on_part(p, s, c)) return found(s);
      }
    const auto is_apart = [&at](const Bracket& from, const Bracket& to) {
      return at.upper < (std::min)(from.lower, to.lower) || (std::max)(from.upper, to.upper) < at.lower;
    };
    for (const auto& o : known.overlaps) {
      if (is_apart(o.t_from, o.t_to) && (own != c.data() || is_apart(o.s_from, o.s_to))) continue;
      if (const auto s = place_by_overlap(p, *own, c))
        if (is_on_part(p, *s, c)) return found(*s);
    }
  }
  return std::nullopt;
}

}  // namespace

Comparison_result compare_y_at_x(const Arr_point_2& p, const Arr_x_monotone_curve_2& c, Meetings_of_pairs& meetings) {
  if (p.data() == c.left().data() || p.data() == c.right().data()) return EQUAL;
  if (c.is_vertical()) {
    if (compare_coordinates(p, c.left(), false) == SMALLER) return SMALLER;
    return compare_coordinates(p, c.right(), false) == LARGER ? LARGER : EQUAL;
  }
  const Bracket y = y_at(c, p.x());
  if (p.y().upper < y.lower) return SMALLER;
  if (y.upper < p.y().lower) return LARGER;
  if (place_on(c, p, meetings)) return EQUAL;
  for (int bits = FIRST_BITS; bits <= MOST_BITS; bits *= 2) {
    const auto at = exact_y_at(c, coordinate_range(*p.data(), true, bits), bits);
    if (!at) continue;
    if (const Comparison_result r = compare(coordinate_range(*p.data(), false, bits), *at); r != EQUAL) return r;
  }
  fail();
}

Bracket parameter_at(const Arr_x_monotone_curve_2& c, const Arr_point_2& p, Meetings_of_pairs& meetings) {
  if (const auto t = place_on(c, p, meetings)) return *t;
  CGAL_precondition_msg(false, "point: expected one on the curve, found one beside it");
  return c.left_parameter();
}

namespace {

/// By tangents, which tell most curves apart; EQUAL where they do not.
[[nodiscard]] Comparison_result compare_slopes(const Arr_x_monotone_curve_2& c, const Bracket& t,
                                               const Arr_x_monotone_curve_2& d, const Bracket& s) {
  Xy<double> tangent[2];
  double error[2];
  for (const int i : {0, 1}) {
    const Arr_x_monotone_curve_2& e = i == 0 ? c : d;
    const Bracket& at = i == 0 ? t : s;
    const Bezier_evaluator& curve = e.data()->evaluator();
    const Curve_jet jet = curve(at.middle());
    tangent[i] = (e.is_rising() ? 1.0 : -1.0) * jet.first;
    error[i] = curve.errors_at(at.middle(), jet).first + at.width() * curve.second_bound();
  }
  const double sine = cross(tangent[0], tangent[1]);
  const double u = euclidean_norm(tangent[0]), v = euclidean_norm(tangent[1]);
  const double room = u * error[1] + v * error[0] + error[0] * error[1] + 8 * HALF_ULP * u * v;
  return sine > room ? SMALLER : (sine < -room ? LARGER : EQUAL);
}

/// A number strictly between the x of two points.
[[nodiscard]] Exact_rational x_between(const Arr_point_2& p, const Arr_point_2& q) {
  if (p.x().upper < q.x().lower) {
    const double x = p.x().upper + (q.x().lower - p.x().upper) / 2;
    if (p.x().upper < x && x < q.x().lower) return Exact_rational(x);
  }
  for (int bits = FIRST_BITS; bits <= MOST_BITS; bits *= 2) {
    const Exact_range a = coordinate_range(*p.data(), true, bits), b = coordinate_range(*q.data(), true, bits);
    if (a.upper < b.lower) return Exact_rational((a.upper + b.lower) / Exact_rational(2));
  }
  fail();
}

}  // namespace

Comparison_result compare_y_beside(const Arr_x_monotone_curve_2& c, const Arr_x_monotone_curve_2& d,
                                   const Arr_point_2& p, bool is_right, Meetings_of_pairs& meetings) {
  if (c.is_vertical() || d.is_vertical()) {  // the one that is upright is above to the right, and below to the left
    if (c.is_vertical() && d.is_vertical()) return EQUAL;
    return c.is_vertical() == is_right ? LARGER : SMALLER;
  }
  if (c.data() == d.data() && c.branch() == d.branch()) return EQUAL;
  const Bracket t = parameter_at(c, p, meetings), s = parameter_at(d, p, meetings);
  if (const Comparison_result r = compare_slopes(c, t, d, s); r != EQUAL) return is_right ? r : opposite(r);
  // Between p and the next place where the curves meet or one of them ends, one is above the other one.
  Arr_point_2 next = is_right ? c.right() : c.left();
  const Comparison_result beyond = is_right ? LARGER : SMALLER;
  const auto take = [&](const Arr_point_2& q) {
    if (compare_xy(q, p) == beyond && compare_x(next, q) == beyond) next = q;
  };
  take(is_right ? d.right() : d.left());
  for (const Arr_common_part& common : common_parts(c, d, meetings)) {
    if (!common.part) {
      take(common.point);
      continue;
    }
    const Arr_point_2 &near = is_right ? common.part->left() : common.part->right(),
                      &far = is_right ? common.part->right() : common.part->left();
    if (compare_xy(near, p) != beyond && compare_xy(far, p) == beyond) return EQUAL;
    take(near);
  }
  const Exact_rational x = is_right ? x_between(p, next) : x_between(next, p);
  const auto [low, high] = CGAL::to_interval(x);
  const Bracket c_y = y_at(c, {low, high}), d_y = y_at(d, {low, high});
  if (c_y.upper < d_y.lower) return SMALLER;
  if (d_y.upper < c_y.lower) return LARGER;
  for (int bits = FIRST_BITS; bits <= MOST_BITS; bits *= 2) {
    const auto a = exact_y_at(c, {x, x}, bits), b = exact_y_at(d, {x, x}, bits);
    if (!a || !b) continue;
    if (const Comparison_result r = compare(*a, *b); r != EQUAL) return r;
  }
  fail();
}

}  // namespace CGAL::Bounding_arcs::internal
