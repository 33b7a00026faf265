// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "fit_spline.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>

namespace bounding_arcs_tool {
namespace {

using Point = Xy<double>;

// Rows low[i] x[i - 1] + middle[i] x[i] + high[i] x[i + 1] = right[i]; the middle outweighs both sides.
struct Rows {
  std::vector<double> low, middle, high;
  std::vector<Point> right;

  void add(double l, double m, double h, const Point& r) {
    low.push_back(l);
    middle.push_back(m);
    high.push_back(h);
    right.push_back(r);
  }
};

std::vector<Point> solved(Rows rows) {
  const std::size_t n = rows.middle.size();
  for (std::size_t i = 1; i < n; ++i) {
    const double factor = rows.low[i] / rows.middle[i - 1];
    rows.middle[i] -= factor * rows.high[i - 1];
    rows.right[i] = rows.right[i] - factor * rows.right[i - 1];
  }
  std::vector<Point> x(n);
  for (std::size_t i = n; i-- > 0;)
    x[i] = 1 / rows.middle[i] * (i + 1 < n ? rows.right[i] - rows.high[i] * x[i + 1] : rows.right[i]);
  return x;
}

// Solves rows of which the first has the last unknown, too, and the last the first one (Sherman and Morrison 1950).
std::vector<Point> solved_around(Rows rows) {
  const std::size_t last = rows.middle.size() - 1;
  const double beside_first = rows.low.front(), beside_last = rows.high.back(), gamma = -rows.middle.front();
  rows.middle.front() -= gamma;
  rows.middle.back() -= beside_last * beside_first / gamma;
  Rows unit = rows;
  unit.right.assign(last + 1, {0, 0});
  unit.right.front() = {gamma, gamma};
  unit.right.back() = {beside_last, beside_last};
  std::vector<Point> x = solved(std::move(rows));
  const std::vector<Point> z = solved(std::move(unit));
  const double share = beside_first / gamma;
  const Point factor = 1 / (1 + z.front().x + share * z.back().x) * (x.front() + share * x.back());
  for (std::size_t i = 0; i <= last; ++i) x[i] = x[i] - z[i].x * factor;
  return x;
}

}  // namespace

Dxf_curve fit_spline(std::vector<Point> points, const std::optional<Point>& start_tangent,
                     const std::optional<Point>& end_tangent, bool is_closed) {
  points.erase(std::unique(points.begin(), points.end()), points.end());
  while (is_closed && points.size() > 1 && points.front() == points.back()) points.pop_back();
  constexpr std::size_t FEWEST_AROUND = 3;  // two are passed to and fro
  if (points.size() < FEWEST_AROUND) is_closed = false;
  if (points.size() < 2) return {};
  if (is_closed) points.push_back(points.front());
  const std::size_t spans = points.size() - 1;
  std::vector<double> h;
  std::vector<Point> along;  // unit vectors
  for (std::size_t i = 0; i < spans; ++i) {
    const Point d = points[i + 1] - points[i];
    h.push_back(std::hypot(d.x, d.y));
    along.push_back(1 / h[i] * d);
  }
  Rows rows;  // of derivatives at the points
  const auto inner = [&](std::size_t before, std::size_t behind) {
    rows.add(h[behind], 2 * (h[before] + h[behind]), h[before],
             3 * (h[behind] * along[before] + h[before] * along[behind]));
  };
  if (is_closed) inner(spans - 1, 0);
  else if (start_tangent) rows.add(0, 1, 0, *start_tangent);
  else rows.add(0, 2, 1, 3 * along.front());
  for (std::size_t i = 1; i < spans; ++i) inner(i - 1, i);
  if (!is_closed && end_tangent) rows.add(0, 1, 0, *end_tangent);
  if (!is_closed && !end_tangent) rows.add(1, 2, 0, 3 * along.back());
  std::vector<Point> speeds = is_closed ? solved_around(std::move(rows)) : solved(std::move(rows));
  if (is_closed) speeds.push_back(speeds.front());
  Dxf_curve curve;
  for (std::size_t i = 0; i < spans; ++i)
    curve.emplace_back(std::vector<Point>{points[i], points[i] + h[i] / 3 * speeds[i],
                                          points[i + 1] - h[i] / 3 * speeds[i + 1], points[i + 1]});
  return curve;
}

}  // namespace bounding_arcs_tool
