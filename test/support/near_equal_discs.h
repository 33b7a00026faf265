// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Drawings whose maximal discs are many, or touch many places within rounding: fields of splines, regular polygons that
// are moved by rounding, grids of equal circles and squares with holes that are nearly symmetric.

#ifndef BOUNDING_ARCS_TEST_NEAR_EQUAL_DISCS_H
#define BOUNDING_ARCS_TEST_NEAR_EQUAL_DISCS_H

#include "query_drawings.h"

#include <cmath>
#include <cstddef>
#include <random>
#include <utility>
#include <vector>

namespace bounding_arcs_test {

/// A closed uniform cubic B-spline.
inline std::vector<Bezier> closed_spline(const std::vector<Point>& control) {
  std::vector<Bezier> chain;
  const std::size_t n = control.size();
  const auto joint = [&](std::size_t i) {
    return (1.0 / 6) * (control[i % n] + 4.0 * control[(i + 1) % n] + control[(i + 2) % n]);
  };
  for (std::size_t i = 0; i < n; ++i) {
    const Point p = control[(i + 1) % n], q = control[(i + 2) % n];
    chain.push_back(Bezier({joint(i), (1.0 / 3) * (2.0 * p + q), (1.0 / 3) * (p + 2.0 * q), joint(i + 1)}));
  }
  return chain;
}

/// Random closed splines, one in each cell of a grid; cells are 3 wide.
inline Drawing spline_field(std::mt19937& random, std::size_t columns, std::size_t rows) {
  std::uniform_real_distribution<double> radius(0.6, 1.2);
  Drawing drawing;
  for (std::size_t i = 0; i < columns * rows; ++i) {
    const double x = 3.0 * static_cast<double>(i % columns), y = 3.0 * static_cast<double>(i / columns);
    std::vector<Point> control;
    for (std::size_t k = 0, n = 5 + random() % 5; k < n; ++k) {
      const double angle = 6.283185307179586 * static_cast<double>(k) / static_cast<double>(n), r = radius(random);
      control.push_back({x + r * std::cos(angle), y + r * std::sin(angle)});
    }
    drawing.add(closed_spline(control));
  }
  return drawing;
}

/// A number that is off by at most so many units in its last place, or in that of 1.
inline double nearly(std::mt19937& random, double x, int ulps) {
  if (ulps == 0) return x;
  const int by = static_cast<int>(random() % (2 * static_cast<unsigned>(ulps) + 1)) - ulps;
  return x + by * 0x1p-52 * (std::max)(std::fabs(x), 1.0);
}
inline Point nearly(std::mt19937& random, const Point& p, int ulps) {
  const double x = nearly(random, p.x, ulps);
  return {x, nearly(random, p.y, ulps)};
}

/// The corners of a regular polygon as doubles have them, off by a few units in the last place.
inline std::vector<Point> regular_corners(std::mt19937& random, std::size_t n, const Point& center, double radius,
                                          double turn, int ulps) {
  std::vector<Point> corners;
  for (std::size_t k = 0; k < n; ++k) {
    const double angle = turn + 6.283185307179586 * static_cast<double>(k) / static_cast<double>(n);
    corners.push_back(nearly(random, center + radius * Point{std::cos(angle), std::sin(angle)}, ulps));
  }
  return corners;
}
inline std::vector<Bezier> closed_chain(const std::vector<Point>& corners) {
  std::vector<Bezier> chain;
  for (std::size_t i = 0; i < corners.size(); ++i)
    chain.push_back(segment(corners[i], corners[(i + 1) % corners.size()]));
  return chain;
}

/// Equal circles, squares or points at the places of a grid that may be turned, each moved by rounding.
inline Drawing nearly_a_grid(std::mt19937& random, std::size_t columns, std::size_t rows, double turn, int ulps) {
  Drawing drawing;
  const std::size_t kind = random() % 3;
  const Point along{std::cos(turn), std::sin(turn)}, up{-along.y, along.x};
  for (std::size_t i = 0; i < columns * rows; ++i) {
    const Point at = static_cast<double>(i % columns) * along + static_cast<double>(i / columns) * up,
                p = nearly(random, at, ulps);
    if (kind == 0) drawing.add(circle(p, 0.25));
    else if (kind == 1) drawing.add(closed_chain(regular_corners(random, 4, p, 0.25, turn, ulps)));
    else drawing.add(Bezier({p, p}));
  }
  return drawing;
}

/// Points on a circle.
inline Drawing cocircular_points(std::mt19937& random, std::size_t n, const Point& center, double radius, int ulps) {
  Drawing drawing;
  for (const Point& p : regular_corners(random, n, center, radius, 0.1, ulps)) drawing.add(Bezier({p, p}));
  return drawing;
}

/// A square with holes at its quarters' middles, or one in its own, all but symmetric; to be filled by the even-odd
/// rule.
inline Drawing square_with_holes(std::mt19937& random, const Point& center, double turn, int ulps) {
  Drawing drawing = drawing_of(closed_chain(regular_corners(random, 4, center, 2, turn, ulps)));
  const std::size_t corners = 3 + random() % 6;
  const auto add_hole = [&](const Point& at, double radius) {
    const Point p = nearly(random, at, ulps);
    if (corners == 8) drawing.add(circle(p, radius));
    else drawing.add(closed_chain(regular_corners(random, corners, p, radius, turn, ulps)));
  };
  if (random() % 2 == 0) add_hole(center, 0.5);
  else
    for (const Point& p : regular_corners(random, 4, center, 0.8, turn, ulps)) add_hole(p, 0.25);
  return drawing;
}

}  // namespace bounding_arcs_test

#endif
