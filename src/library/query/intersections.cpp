// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Bodies of query/intersections.h, and those of exact_intersections.h for line segments.
//
// Orientations of three ends tell where each end is; along one line coordinates do.  The parameter of a point p on a
// segment from a to b is (p.x - a.x) / (b.x - a.x), or that by y where it is longer.  Where both differences are
// doubles, their quotient errs by half an ulp; otherwise it is a quotient of rational numbers.

#include <CGAL/Bounding_arcs_2/number/Exact_number.h>
#include <CGAL/Bounding_arcs_2/query/intersections.h>
#include "Intersection_search.h"
#include "query_units.h"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/number_utils.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>

namespace CGAL::Bounding_arcs {

namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Ends = std::array<Xy<double>, 2>;

[[nodiscard]] int orientation(const Xy<double>& p, const Xy<double>& q, const Xy<double>& r) {
  const auto point = [](const Xy<double>& v) { return Kernel::Point_2(v.x, v.y); };
  return static_cast<int>(CGAL::orientation(point(p), point(q), point(r)));
}

/// Whether u - v is a double, by the error of the rounded difference (Knuth 1969).
[[nodiscard]] bool is_exact_difference(double u, double v, double difference) {
  const double back = u - difference, rest = difference + back;
  return (u - rest) + (back - v) == 0;
}

/// The parameter of a point of a segment.
[[nodiscard]] Bracket parameter(const Ends& s, const Xy<double>& p) {
  if (p == s[0]) return {0, 0};
  if (p == s[1]) return {1, 1};
  const bool by_x = std::fabs(s[1].x - s[0].x) >= std::fabs(s[1].y - s[0].y);
  const double from = by_x ? s[0].x : s[0].y, to = by_x ? s[1].x : s[1].y, at = by_x ? p.x : p.y;
  const double way = to - from, part = at - from, t = part / way;
  constexpr double INFINITE = std::numeric_limits<double>::infinity(), LEAST = 0x1p-900;
  if (std::fabs(part) > LEAST && t > LEAST && is_exact_difference(to, from, way) &&
      is_exact_difference(at, from, part)) {
    if (std::fma(t, way, -part) == 0) return {t, t};
    return {std::nextafter(t, -INFINITE), (std::min)(1.0, std::nextafter(t, INFINITE))};
  }
  const Exact_rational exact =
      (Exact_rational(at) - Exact_rational(from)) / (Exact_rational(to) - Exact_rational(from));
  const auto [low, high] = CGAL::to_interval(exact);
  return {low, high};
}

/// Where an end of the one is on the other one, between the ends of that or at one of them.
[[nodiscard]] bool is_between(const Ends& s, const Xy<double>& p) {
  const auto [x_low, x_high] = std::minmax(s[0].x, s[1].x);
  const auto [y_low, y_high] = std::minmax(s[0].y, s[1].y);
  return x_low <= p.x && p.x <= x_high && y_low <= p.y && p.y <= y_high;
}

[[nodiscard]] Piece_intersections on_one_line(const Ends& a, const Ends& b) {
  const auto axis = std::fabs(a[1].x - a[0].x) >= std::fabs(a[1].y - a[0].y) ? &Xy<double>::x : &Xy<double>::y;
  const bool a_rises = a[0].*axis < a[1].*axis, b_rises = b[0].*axis < b[1].*axis;
  const Xy<double>&a_low = a[a_rises ? 0 : 1], &a_high = a[a_rises ? 1 : 0], &b_low = b[b_rises ? 0 : 1],
        &b_high = b[b_rises ? 1 : 0];
  const Xy<double>&low = a_low.*axis < b_low.*axis ? b_low : a_low,
        &high = a_high.*axis < b_high.*axis ? a_high : b_high;
  Piece_intersections result;
  if (low.*axis > high.*axis) return result;
  if (low.*axis == high.*axis) {
    result.points.push_back({parameter(a, low), parameter(b, low), Intersection_kind::TANGENTIAL});
    return result;
  }
  const Xy<double>&from = a_rises ? low : high, &to = a_rises ? high : low;
  result.overlaps.push_back({parameter(a, from), parameter(a, to), parameter(b, from), parameter(b, to)});
  return result;
}

}  // namespace

std::optional<Piece_intersections> line_intersections(const Bezier_curve_2<double>& first,
                                                      const Bezier_curve_2<double>& second) {
  const auto &p = first.control_points(), &q = second.control_points();
  const Ends a{p[0], p[1]}, b{q[0], q[1]};
  const int b0 = orientation(a[0], a[1], b[0]), b1 = orientation(a[0], a[1], b[1]);
  if (b0 == 0 && b1 == 0) return on_one_line(a, b);
  if (b0 * b1 > 0) return Piece_intersections{};
  const int a0 = orientation(b[0], b[1], a[0]), a1 = orientation(b[0], b[1], a[1]);
  if (a0 * a1 > 0) return Piece_intersections{};
  if (b0 != 0 && b1 != 0 && a0 != 0 && a1 != 0) return std::nullopt;
  // one end is on the other line, or one of each is
  Piece_intersections result;
  const Xy<double>& at = b0 == 0 ? b[0] : (b1 == 0 ? b[1] : (a0 == 0 ? a[0] : a[1]));
  if (is_between(a, at) && is_between(b, at))
    result.points.push_back({parameter(a, at), parameter(b, at), Intersection_kind::TRANSVERSAL});
  return result;
}

Piece_intersections::Intersection line_crossing(const Bezier_curve_2<double>& first,
                                                const Bezier_curve_2<double>& second) {
  using Point = Xy<Exact_rational>;
  const auto &p = first.control_points(), &q = second.control_points();
  const Point a = convert<Exact_rational>(p[0]), along = convert<Exact_rational>(p[1]) - a,
              b = convert<Exact_rational>(q[0]), across = convert<Exact_rational>(q[1]) - b, way = b - a;
  const Exact_rational sine = cross(along, across);
  const auto bracket = [](const Exact_rational& t) {
    const auto [low, high] = CGAL::to_interval(t);
    return Bracket{low, high};
  };
  return {bracket(Exact_rational(cross(way, across) / sine)), bracket(Exact_rational(cross(way, along) / sine)),
          Intersection_kind::TRANSVERSAL};
}

}  // namespace CGAL::Bounding_arcs

namespace CGAL::Bounding_arcs::internal {

Intersections_2<> intersections(const Bounding_arc_tree_2& a, const Bounding_arc_tree_2& b) {
  const Common_unit both(a, b);
  return out(both.unit(), Intersection_search(both.a(), both.b()).all());
}

Intersections_2<> self_intersections(const Bounding_arc_tree_2& a) {
  return out(a.unit(), Intersection_search(a.in_unit()).all());
}

}  // namespace CGAL::Bounding_arcs::internal

namespace CGAL::Bounding_arcs {

std::optional<bool> do_intersect(const Bounding_arc_tree_2& a, const Bounding_arc_tree_2& b) {
  const Common_unit both(a, b);
  return Intersection_search(both.a(), both.b()).any();
}

}  // namespace CGAL::Bounding_arcs
