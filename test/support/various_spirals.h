// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Spirals of all degrees that batches serve.

#ifndef BOUNDING_ARCS_TEST_VARIOUS_SPIRALS_H
#define BOUNDING_ARCS_TEST_VARIOUS_SPIRALS_H

#include "cases.h"
#include "trees.h"

#include <CGAL/Bounding_arcs_2.h>

#include <cmath>
#include <random>
#include <vector>

namespace bounding_arcs_test {

/// Spirals of polynomial and rational curves of degrees from 2 to 9, moved away from the origin, mirrored and turned
/// round.
inline std::vector<Spiral> various_spirals(unsigned seed, int count) {
  std::mt19937 random(seed);
  std::vector<Spiral> spirals;
  for (int i = 0; i < count; ++i) {
    const Bezier curve = random_curve(random, 2 + i % 8, i % 3 == 2);
    std::vector<Point> points = curve.control_points();
    const double scale = std::ldexp(1.0, i % 3 == 0 ? 0 : i % 40 - 20);
    for (Point& p : points) p = {scale * (p.x + i % 4), scale * (i % 2 == 0 ? p.y : -p.y)};
    if (i % 3 == 1) points = {points.rbegin(), points.rend()};
    for (const Spiral& s : ba::spiral_segments(Bezier(points, curve.weights()))) spirals.push_back(s);
  }
  return spirals;
}

}  // namespace bounding_arcs_test

#endif
