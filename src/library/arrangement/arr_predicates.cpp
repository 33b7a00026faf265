// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Bodies of arrangement/internal/arr_predicates.h.

#include "../overlay/Boundary_sum.h"
#include "../overlay/Meeting_places.h"
#include "exact_places.h"

#include <CGAL/Bounding_arcs_2/arc/Arc_2.h>
#include <CGAL/Bounding_arcs_2/arrangement/internal/arr_predicates.h>
#include <CGAL/Bounding_arcs_2/number/expected.h>
#include "../curve/exact_bezier.h"
#include "../query/query_units.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <limits>
#include <memory>
#include <stdexcept>
#include <utility>

namespace CGAL::Bounding_arcs::internal {

namespace {

[[nodiscard]] Comparison_result compare_coordinates(const Arr_point_2& p, const Arr_point_2& q, bool is_x) {
  const Bracket &a = is_x ? p.data()->x : p.data()->y, &b = is_x ? q.data()->x : q.data()->y;
  if (a.upper < b.lower) return SMALLER;
  if (b.upper < a.lower) return LARGER;
  if (p.data() == q.data() || (a.is_single() && b.is_single())) return EQUAL;
  return static_cast<Comparison_result>(exact_place(*p.data()).compare(exact_place(*q.data()), is_x));
}

}  // namespace

Comparison_result compare_x(const Arr_point_2& p, const Arr_point_2& q) { return compare_coordinates(p, q, true); }

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
[[nodiscard]] Bracket y_at(const Arr_curve_2::Part& c, const Bracket& x) {
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

/// The y of a part's branch at an x in a range, in a range that shrinks with it.
/// \return nothing where the range is too wide
[[nodiscard]] std::optional<Exact_range> exact_y_at(const Arr_curve_2::Part& c, const Exact_range& x, int bits) {
  const Integer_piece& piece = c.data()->exact().piece();
  const auto range_of_parameter = [bits](const Exact_parameter& t) {
    t.refine_to(bits);
    return Exact_range{t.lower(), t.upper()};
  };
  // \return where the branch is at an x, or its end on that side if it ends before
  const auto parameter_at = [&](const Exact_rational& at, bool is_left) {
    for (const Real_root& root : unit_roots(moved(piece.x, piece.w, at))) {
      const Exact_parameter t(root);
      const Branches on = branches_at(*c.data(), t);
      if (on.before <= c.branch() && c.branch() <= on.behind) return range_of_parameter(t);
    }
    const auto& turns = c.data()->exact_turns();
    const std::size_t end = is_left == c.is_rising() ? c.branch() : c.branch() + 1;
    if (end == 0) return range_of_parameter(Exact_parameter(Exact_rational(0)));
    return range_of_parameter(end <= turns.size() ? turns[end - 1] : Exact_parameter(Exact_rational(1)));
  };
  const Exact_range s = parameter_at(x.lower, true), t = parameter_at(x.upper, false);
  return quotients_over(piece.y, piece.w, {(std::min)(s.lower, t.lower), (std::max)(s.upper, t.upper)});
}

[[nodiscard]] Comparison_result compare(const std::optional<Exact_range>& a, const std::optional<Exact_range>& b) {
  if (!a || !b) return EQUAL;
  return a->upper < b->lower ? SMALLER : (b->upper < a->lower ? LARGER : EQUAL);
}

/// The place of a point on the branch that a part is of, if the point is known to be there.
[[nodiscard]] const Arranged_place* known_place(const Arr_point_2& p, const Arr_curve_2::Part& c) {
  for (const Arranged_place& place : p.data()->places)
    if (place.curve == c.data()->number() && place.branch == c.branch()) return &place;
  return nullptr;
}

/// Whether a point of the branch that a part is of is on the part, at its parameter on the curve.
[[nodiscard]] bool is_on_part(const Arr_point_2& p, const Bracket& t, const Arr_curve_2::Part& c) {
  const Bracket &first = c.is_rising() ? c.left_parameter() : c.right_parameter(),
                &last = c.is_rising() ? c.right_parameter() : c.left_parameter();
  if (t.upper < first.lower || last.upper < t.lower) return false;
  if (first.upper < t.lower && t.upper < last.lower) return true;
  return compare_xy(p, c.left()) != SMALLER && compare_xy(p, c.right()) != LARGER;
}

/// Where the branch of a part runs through a point, if it does.
[[nodiscard]] const Arranged_place* place_on(const Arr_curve_2::Part& c, const Arr_point_2& p) {
  if (const Arranged_place* known = known_place(p, c)) return known;
  add_places(*p.data(), *c.data(), {0, 1});
  return known_place(p, c);
}

}  // namespace

Comparison_result compare_y_at_x(const Arr_point_2& p, const Arr_curve_2::Part& c) {
  if (c.is_vertical()) {
    if (compare_coordinates(p, c.left(), false) == SMALLER) return SMALLER;
    return compare_coordinates(p, c.right(), false) == LARGER ? LARGER : EQUAL;
  }
  if (known_place(p, c)) return EQUAL;
  const Bracket y = y_at(c, p.x());
  if (p.y().upper < y.lower) return SMALLER;
  if (y.upper < p.y().lower) return LARGER;
  Exact_place& exact = exact_place(*p.data());
  const auto by_ranges = [&](int bits) {
    return compare(exact.range(false, bits), exact_y_at(c, exact.range(true, bits), bits));
  };
  if (!exact.rational_point())
    if (const Comparison_result r = by_ranges(FIRST_BITS); r != EQUAL) return r;
  if (place_on(c, p)) return EQUAL;
  for (int bits = FIRST_BITS;; bits *= 2)
    if (const Comparison_result r = by_ranges(bits); r != EQUAL) return r;
}

Bracket parameter_at(const Arr_curve_2::Part& c, const Arr_point_2& p) {
  const Arranged_place* place = place_on(c, p);
  if (!place) throw std::logic_error(expected("point", "one on the curve", "one beside it"));
  return place->t;
}

namespace {

/// What a branch of a curve and one of another have of an overlap.
struct Shared_branch {
  bool has_start, has_end;  ///< where the overlap starts and ends; else they go on to the ends of the branches
};
/// Branches belong to each other where both are as many turns from the overlap's start: parts of two curves run
/// together only where these are the same.
[[nodiscard]] std::optional<Shared_branch> shared_branch(const Arranged_meetings::Way& a, std::size_t branch_a,
                                                         const Arranged_meetings::Way& b, std::size_t branch_b) {
  const auto turns_before = [](const Arranged_meetings::Way& way, std::size_t branch) {
    return way.is_forward ? branch - way.first : way.first - branch;  // more than any number beyond the start
  };
  const std::size_t turns = turns_before(a, branch_a), all = turns_before(a, a.last);
  if (turns > all || turns_before(b, branch_b) != turns) return std::nullopt;
  return Shared_branch{turns == 0, turns == all};
}

}  // namespace

std::vector<Arr_common_part> common_parts(const Arr_curve_2::Part& c, const Arr_curve_2::Part& d,
                                          Meetings_of_pairs& meetings) {
  std::vector<Arr_common_part> parts, points;
  const auto add_point = [&](const Arr_point_2& p, unsigned multiplicity) {
    for (Arr_common_part& known : points)
      if (compare_xy(known.point, p) == EQUAL) {
        known.multiplicity = 0;  // places of one point on branches that it is not told of
        return;
      }
    points.push_back({std::nullopt, p, multiplicity});
  };
  // \param left, right the ends of what both branches have in common, if these do not go on there
  const auto add_part = [&](const Arr_point_2* left, const Arr_point_2* right) {
    for (const Arr_curve_2::Part* e : {&c, &d}) {
      if (!left || compare_xy(*left, e->left()) == SMALLER) left = &e->left();
      if (!right || compare_xy(*right, e->right()) == LARGER) right = &e->right();
    }
    const Comparison_result order = compare_xy(*left, *right);
    if (order == EQUAL) add_point(*left, 0);
    if (order == SMALLER)
      parts.push_back({c.part({*left, parameter_at(c, *left)}, {*right, parameter_at(c, *right)}), {}, 0});
  };
  const bool is_one_curve = c.data() == d.data();
  if (is_one_curve && c.branch() == d.branch()) {
    add_part(nullptr, nullptr);
    return parts.empty() ? points : parts;
  }
  const Arranged_meetings& known = meetings.of(c.data(), d.data());
  if (is_one_curve || !known.overlaps.empty())  // neighbouring branches
    for (const Arr_point_2* p : {&c.left(), &c.right()})
      for (const Arr_point_2* q : {&d.left(), &d.right()})
        if (compare_xy(*p, *q) == EQUAL) add_point(*p, 0);
  for (const Arranged_meetings::Overlap& o : known.overlaps)
    for (const bool is_c_first : {true, false}) {  // of one curve either part may be
      if (!is_one_curve && is_c_first != (known.pair->a == c.data())) continue;
      const Arranged_meetings::Way &of_c = is_c_first ? o.a : o.b, &of_d = is_c_first ? o.b : o.a;
      const std::optional<Shared_branch> shared = shared_branch(of_c, c.branch(), of_d, d.branch());
      if (!shared) continue;
      const Arr_point_2 start(o.from), end(o.to);
      const Arr_point_2 *from = shared->has_start ? &start : nullptr, *to = shared->has_end ? &end : nullptr;
      const bool is_to_right = of_c.is_forward == c.is_rising();
      add_part(is_to_right ? from : to, is_to_right ? to : from);
    }
  for (const Arranged_meetings::Point& m : known.points) {
    const Arr_point_2 p(m.point);
    const Arranged_place *on_c = known_place(p, c), *on_d = known_place(p, d);
    if (on_c && on_d && is_on_part(p, on_c->t, c) && is_on_part(p, on_d->t, d)) add_point(p, m.is_transversal ? 1 : 0);
  }
  std::vector<Arr_common_part> result = parts;
  std::copy_if(points.begin(), points.end(), std::back_inserter(result), [&](const Arr_common_part& q) {
    return std::none_of(parts.begin(), parts.end(), [&q](const Arr_common_part& r) {
      return compare_xy(r.part->left(), q.point) != LARGER && compare_xy(q.point, r.part->right()) != LARGER;
    });
  });
  const auto first = [](const Arr_common_part& r) { return r.part ? r.part->left() : r.point; };
  std::sort(result.begin(), result.end(), [&](const Arr_common_part& p, const Arr_common_part& q) {
    return compare_xy(first(p), first(q)) == SMALLER;
  });
  return result;
}

namespace {

/// By tangents, which tell most curves apart; EQUAL where they do not.
[[nodiscard]] Comparison_result compare_slopes(const Arr_curve_2::Part& c, const Bracket& t, const Arr_curve_2::Part& d,
                                               const Bracket& s) {
  const auto tangent = [](const Arr_curve_2::Part& e, const Bracket& at) {
    const Derivative_in_range along = derivative_in(e.data()->evaluator(), at);
    return e.is_rising() ? along : Derivative_in_range{-along.value, along.error};
  };
  const Derivative_in_range of_c = tangent(c, t), of_d = tangent(d, s);
  const double sine = cross(of_c.value, of_d.value);
  const double u = euclidean_norm(of_c.value), v = euclidean_norm(of_d.value);
  const double room = u * of_d.error + v * of_c.error + of_c.error * of_d.error + 8 * HALF_ULP * u * v;
  return sine > room ? SMALLER : (sine < -room ? LARGER : EQUAL);
}

/// A number strictly between the x of two points.
[[nodiscard]] Exact_rational x_between(const Arr_point_2& p, const Arr_point_2& q) {
  if (p.x().upper < q.x().lower) {
    const double x = p.x().upper + (q.x().lower - p.x().upper) / 2;
    if (p.x().upper < x && x < q.x().lower) return Exact_rational(x);
  }
  for (int bits = FIRST_BITS;; bits *= 2) {
    const Exact_range a = exact_place(*p.data()).range(true, bits), b = exact_place(*q.data()).range(true, bits);
    if (a.upper < b.lower) return Exact_rational((a.upper + b.lower) / Exact_rational(2));
  }
}

}  // namespace

Comparison_result compare_y_beside(const Arr_curve_2::Part& c, const Arr_curve_2::Part& d, const Arr_point_2& p,
                                   bool is_right, Meetings_of_pairs& meetings) {
  if (c.is_vertical() || d.is_vertical()) {  // the one that is upright is above to the right, and below to the left
    if (c.is_vertical() && d.is_vertical()) return EQUAL;
    return c.is_vertical() == is_right ? LARGER : SMALLER;
  }
  if (c.data() == d.data() && c.branch() == d.branch()) return EQUAL;
  const Bracket t = parameter_at(c, p), s = parameter_at(d, p);
  if (const Comparison_result r = compare_slopes(c, t, d, s); r != EQUAL) return is_right ? r : CGAL::opposite(r);
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
  for (int bits = FIRST_BITS;; bits *= 2)
    if (const Comparison_result r = compare(exact_y_at(c, {x, x}, bits), exact_y_at(d, {x, x}, bits)); r != EQUAL)
      return r;
}

Measure_bounds boundary_area(const std::vector<std::vector<Boundary_part>>& boundaries, double eps) {
  check_tolerance(eps);
  Boundary_sum sum;
  for (const std::vector<Boundary_part>& boundary : boundaries) {
    for (const Boundary_part& part : boundary) sum.add(exact_bezier(*part.bezier), part.from, part.to);
    sum.close();
  }
  return sum.bounds(eps);
}

}  // namespace CGAL::Bounding_arcs::internal
