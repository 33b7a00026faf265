// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Closed polylines with bulges, as drawings of workpieces have them: random ones, whose arcs may cross, neighbours'
// too; specks, which are far smaller than a tolerance; and relatives of one.

#ifndef BOUNDING_ARCS_TEST_BULGE_LOOPS_H
#define BOUNDING_ARCS_TEST_BULGE_LOOPS_H

#include "offset_oracle.h"

#include <CGAL/Bounding_arcs_2/arc/arc_beziers.h>
#include <CGAL/Bounding_arcs_2/curve/Drawing_2.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <random>
#include <utility>
#include <vector>

namespace bounding_arcs_test {

using Arc_loops = std::vector<Arc_loop>;

inline Arc_loop loop_of(const std::vector<CGAL::Bounding_arcs::Xy<double>>& corners,
                        const std::vector<double>& bulges) {
  Arc_loop loop;
  for (std::size_t i = 0; i < corners.size(); ++i)
    if (corners[i] != corners[(i + 1) % corners.size()])
      loop.push_back({corners[i], corners[(i + 1) % corners.size()], i < bulges.size() ? bulges[i] : 0});
  return loop;
}
inline CGAL::Bounding_arcs::Drawing_2<double> drawing_of(const Arc_loops& loops) {
  CGAL::Bounding_arcs::Drawing_2<double> drawing;
  for (const Arc_loop& loop : loops) {
    std::vector<CGAL::Bounding_arcs::Bezier_curve_2<double>> curves;
    for (const Loop_arc& a : loop)
      for (auto& curve : CGAL::Bounding_arcs::arc_beziers<double>(a.from, a.to, a.bulge))
        curves.push_back(std::move(curve));
    if (!curves.empty()) drawing.add(std::move(curves));
  }
  return drawing;
}

/// Of three to eight corners in a square of side 10 about the origin, on a grid for half of them, half of them
/// straight.
inline Arc_loop random_bulge_loop(std::mt19937& random) {
  std::uniform_real_distribution<double> place(-5, 5);
  std::uniform_int_distribution<int> on_grid(-5, 5), eighths(-8, 8), parts(-1024, 1024);
  const std::size_t count = 3 + random() % 6;
  const bool is_on_grid = random() % 2 == 0, has_eighths = random() % 4 == 0;
  std::vector<CGAL::Bounding_arcs::Xy<double>> corners;
  std::vector<double> bulges;
  for (std::size_t i = 0; i < count; ++i) {
    const double x = is_on_grid ? on_grid(random) : place(random), y = is_on_grid ? on_grid(random) : place(random);
    corners.push_back({x, y});
    bulges.push_back(random() % 2 == 0 ? 0 : has_eighths ? eighths(random) / 8.0 : parts(random) / 1024.0);
  }
  return loop_of(corners, bulges);
}

/// A loop, scaled and moved.
inline Arc_loop placed(Arc_loop loop, double scale, const CGAL::Bounding_arcs::Xy<double>& by) {
  for (Loop_arc& a : loop) a = {scale * a.from + by, scale * a.to + by, a.bulge};
  return loop;
}
inline Arc_loop reversed(const Arc_loop& loop) {
  Arc_loop result;
  for (auto a = loop.rbegin(); a != loop.rend(); ++a) result.push_back({a->to, a->from, -a->bulge});
  return result;
}
inline Arc_loop mirrored(Arc_loop loop) {
  for (Loop_arc& a : loop) a = {{-a.from.x, a.from.y}, {-a.to.x, a.to.y}, -a.bulge};
  return loop;
}
inline Arc_loop from_another_start(Arc_loop loop, std::size_t k) {
  std::rotate(loop.begin(), loop.begin() + static_cast<std::ptrdiff_t>(k % loop.size()), loop.end());
  return loop;
}
/// With a vertex more, a share of an arc from its start.
inline Arc_loop with_vertex(Arc_loop loop, std::size_t k, double share) {
  Loop_arc& a = loop[k % loop.size()];
  const auto p = point_on(a, share);
  const Loop_arc rest{p, a.to, std::tan(std::atan(a.bulge) * (1 - share))};
  a = {a.from, p, std::tan(std::atan(a.bulge) * share)};
  loop.insert(loop.begin() + static_cast<std::ptrdiff_t>(k % loop.size()) + 1, rest);
  return loop;
}

/// A loop far smaller than others, 10^-1 to 10^-8 of their size, or as thin as that.
inline Arc_loop random_speck(std::mt19937& random) {
  std::uniform_real_distribution<double> place(-4, 4), power(-8, -1), half(-0.5, 0.5);
  const double size = std::pow(10, power(random)), length = random() % 3 == 0 ? std::pow(10, power(random)) : size;
  const CGAL::Bounding_arcs::Xy<double> center{place(random), place(random)};
  std::vector<CGAL::Bounding_arcs::Xy<double>> corners;
  std::vector<double> bulges;
  for (std::size_t i = 0, n = 3 + random() % 3; i < n; ++i) {
    const double angle = 6.283185307179586 * (static_cast<double>(i) + half(random) / 2) / static_cast<double>(n);
    corners.push_back(center + CGAL::Bounding_arcs::Xy<double>{length * std::cos(angle), size * std::sin(angle)});
    bulges.push_back(random() % 2 == 0 ? 0 : std::round(512 * half(random)) / 512);
  }
  Arc_loop loop = loop_of(corners, bulges);
  return random() % 2 == 0 ? loop : reversed(loop);
}

}  // namespace bounding_arcs_test

#endif
