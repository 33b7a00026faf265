// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Bodies of query/piece_pair_intersections.h.

#include <CGAL/Bounding_arcs_2/curve/Unit.h>
#include <CGAL/Bounding_arcs_2/curve/served_range.h>
#include <CGAL/Bounding_arcs_2/query/piece_pair_intersections.h>
#include "../curve/exact_bezier.h"
#include "Polygon_search.h"
#include "exact_intersections.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <tuple>

namespace CGAL::Bounding_arcs {

namespace internal {

// Tangents at common ends in doubles, where these tell that they are not parallel.
[[nodiscard]] static bool are_transversal(const Bezier_curve_2<double>& a, double t, const Bezier_curve_2<double>& b,
                                          double s) {
  const Xy<double> u = end_direction(a, t), v = end_direction(b, s);  // each within u of itself
  return std::fabs(cross(u, v)) > 8 * HALF_ULP * (std::fabs(u.x) + std::fabs(u.y)) * (std::fabs(v.x) + std::fabs(v.y));
}

/// Common points of curves of degree at most MOST, where doubles tell them.
template <std::size_t MOST>
[[nodiscard]] std::optional<Piece_intersections> common_points(const Bezier_curve_2<double>& a,
                                                               const Bezier_curve_2<double>& b) {
  const Polygon_search<MOST> search(a, b);
  const Polygon_results& found = search.results();
  Piece_intersections result;
  bool is_open = !found.open.empty();
  for (const Newton_box& root : found.roots) {
    is_open = is_open || !root.is_inside();
    result.points.push_back({root.a, root.b, Intersection_kind::TRANSVERSAL});
  }
  for (const Bracket& end : found.ends) {
    is_open = is_open || !are_transversal(a, end.lower, b, end.upper);
    result.points.push_back({{end.lower, end.lower}, {end.upper, end.upper}, Intersection_kind::TRANSVERSAL});
  }
  if (is_open) return std::nullopt;
  if (result.points.size() > 1)
    std::sort(result.points.begin(), result.points.end(), [](const Piece_intersection& p, const Piece_intersection& q) {
      return std::tie(p.a.lower, p.b.lower) < std::tie(q.a.lower, q.b.lower);
    });
  return result;
}

}  // namespace internal

std::optional<Piece_intersections> intersections_by_doubles(const Bezier_curve_2<double>& a,
                                                            const Bezier_curve_2<double>& b) {
  check_served(a);
  check_served(b);
  const Unit unit = Unit::of_size((std::max)(coordinate_size(a), coordinate_size(b)));
  if (!is_ordinary(unit, a) || !is_ordinary(unit, b)) {
    if (!keeps(unit, a) || !keeps(unit, b)) return std::nullopt;
    return intersections_by_doubles(scaled(a, unit), scaled(b, unit));
  }
  constexpr std::size_t CUBIC = 3, HIGH = 9;
  const int degree = (std::max)(a.degree(), b.degree());
  if (degree <= static_cast<int>(CUBIC)) return internal::common_points<CUBIC>(a, b);
  if (degree <= static_cast<int>(HIGH)) return internal::common_points<HIGH>(a, b);
  return std::nullopt;
}

Piece_intersections intersections(const Bezier_curve_2<double>& a, const Bezier_curve_2<double>& b) {
  if (std::optional<Piece_intersections> found = intersections_by_doubles(a, b)) return *std::move(found);
  return exact_intersections(exact_bezier(a), exact_bezier(b));
}

}  // namespace CGAL::Bounding_arcs
