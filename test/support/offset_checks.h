// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// What offsets are checked by: areas, winding numbers, the hierarchy's distance, and points on a grid.

#ifndef BOUNDING_ARCS_TEST_OFFSET_CHECKS_H
#define BOUNDING_ARCS_TEST_OFFSET_CHECKS_H

#include "query_drawings.h"

#include <CGAL/Bounding_arcs_2/offset/Offset_source_2.h>
#include <CGAL/Bounding_arcs_2/offset/offset_error.h>
#include <CGAL/Bounding_arcs_2/query/closest_point.h>

#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <vector>

namespace bounding_arcs_test {

using ba::Offset;
using ba::Offset_options;

inline Drawing polygon(const std::vector<Point>& corners, bool is_closed = true) {
  std::vector<Bezier> chain;
  for (std::size_t i = 0; i + 1 < corners.size() + (is_closed ? 1 : 0); ++i)
    chain.push_back(segment(corners[i], corners[(i + 1) % corners.size()]));
  return drawing_of(chain);
}
inline Drawing rectangle(double w, double h) { return polygon({{0, 0}, {w, 0}, {w, h}, {0, h}}); }
inline Drawing backwards(const Drawing& drawing) {
  Drawing result;
  for (const auto& curve : drawing.curves()) {
    std::vector<Bezier> chain;
    for (auto piece = curve.beziers.rbegin(); piece != curve.beziers.rend(); ++piece) {
      auto p = piece->control_points();
      auto w = piece->weights();
      chain.emplace_back(std::vector<Point>(p.rbegin(), p.rend()), std::vector<double>(w.rbegin(), w.rend()));
    }
    result.add(std::move(chain), curve.name);
  }
  return result;
}
inline Drawing both(const Drawing& a, const Drawing& b) {
  Drawing result = a;
  for (const auto& curve : b.curves()) result.add(curve.beziers, curve.name);
  return result;
}

inline double area_of(const Offset& offset) {
  double area = 0;
  for (const auto& chain : offset.chains) area += chain.area;
  return area;
}
inline int winding(const Offset& offset, const Point& x) {
  int sum = 0;
  for (const auto& chain : offset.chains)
    for (const auto& p : chain.pieces) sum += ba::internal::winding_of_arc(p.arc, x);
  return sum;
}
inline Offset_options within(double eps) {
  Offset_options options;
  options.eps = eps;
  return options;
}

// What holds for all: complete, chains that close, directed and nested as told.
inline void expect_sound(const Offset& offset) {
  EXPECT_EQ(offset.status, ba::Offset_status::COMPLETE);
  for (const auto& chain : offset.chains) {
    ASSERT_FALSE(chain.pieces.empty());
    for (std::size_t i = 0; i + 1 < chain.pieces.size(); ++i)
      EXPECT_EQ(chain.pieces[i].arc.to, chain.pieces[i + 1].arc.from);
    if (!chain.is_closed) continue;
    EXPECT_EQ(chain.pieces.back().arc.to, chain.pieces.front().arc.from);
    EXPECT_EQ(chain.is_ccw, chain.area > 0);
    EXPECT_EQ(chain.is_ccw, !chain.parent || !offset.chains[*chain.parent].is_ccw);  // regions and holes take turns
  }
}
// All points of round pieces are within eps of the distance.
inline void expect_at_distance(const Drawing& drawing, const Offset& offset, double eps) {
  const ba::Curve_index_2 index(drawing, ba::Query_decisions::DOUBLE);
  const auto error = ba::offset_error(index, offset, eps / 16);
  if (!error) return;
  EXPECT_GE(error->nearest.lower, -eps * (1 + 1.0 / 16));
  EXPECT_LE(error->farthest.upper, eps * (1 + 1.0 / 16));
}

// Counts on a grid: points farther than eps from the boundary are inside exactly where distance and winding say so.
inline void expect_same_points(const Drawing& drawing, const Offset& offset, double eps, bool only_closed) {
  const ba::Curve_index_2 index(drawing, ba::Query_decisions::DOUBLE);
  const ba::Offset_source_2 source(drawing, within(eps));
  const Offset unmoved = source.at(0);
  constexpr int GRID = 40;
  for (int i = 0; i <= GRID; ++i)
    for (int j = 0; j <= GRID; ++j) {
      const Point q{-2 + 4.0 * i / GRID + 0.0123, -2 + 4.0 * j / GRID + 0.0321};
      const double distance = ba::closest_point(index, q)->distance.upper, d = offset.distance;
      if (std::fabs(distance - std::fabs(d)) <= 2 * eps) continue;
      const bool is_near = distance < std::fabs(d), is_inside = only_closed && winding(unmoved, q) != 0;
      const bool wanted = d > 0 || !only_closed ? is_near || is_inside : is_inside && !is_near;
      ASSERT_EQ(winding(offset, q), wanted ? 1 : 0) << q.x << ' ' << q.y << " d " << d;
    }
}

}  // namespace bounding_arcs_test

#endif
