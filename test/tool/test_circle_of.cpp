// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The circle of a written arc is there just where its doubles miss no end of the arc by more than 4 ulp of the
// coordinates, by exact numbers, also where that is a close decision.

#include "Hierarchy.h"

#include <CGAL/Exact_rational.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

namespace test_circle_of {
namespace {

using bounding_arcs_tool::Arc_2;
using bounding_arcs_tool::circle_of;
using bounding_arcs_tool::Output_circle;
using Exact = CGAL::Exact_rational;
using Point = bounding_arcs_tool::Xy<double>;

// The doubles that are nearest to center and radius, as good as doubles make them.
Output_circle rounded_circle(const Arc_2& arc) {
  const double b = arc.bulge;
  const Point chord = arc.to - arc.from;
  return {arc.from + 0.5 * chord + ((1 - b) * (1 + b) / (4 * b)) * perp(chord),
          std::hypot(chord.x, chord.y) * (1 + b * b) / (4 * std::fabs(b))};
}

// | |v|^2 - r^2 | / 2r, what an end misses the circle by but for some 2^-50 of it, over ulp of the coordinates.
double miss(const Point& p, const Output_circle& circle, double ulp) {
  const Exact x = Exact(p.x) - Exact(circle.center.x), y = Exact(p.y) - Exact(circle.center.y), r(circle.radius);
  return CGAL::to_double(Exact(abs(Exact(x * x + y * y - r * r)) / (2 * r * Exact(ulp))));
}

TEST(CircleOf, IsThereWhereItsDoublesMissNoEndByMoreThanFourUlp) {
  std::mt19937_64 random(1);
  std::uniform_real_distribution<double> coordinate(-1, 1), bulge_bits(-40, 0), size_bits(-30, 30);
  int with = 0, without = 0, close = 0;
  for (int i = 0; i < 20000; ++i) {
    const double size = std::exp2(size_bits(random)), bulge = std::exp2(bulge_bits(random));
    const Point from{coordinate(random), coordinate(random)}, way{coordinate(random), coordinate(random)};
    const Arc_2 arc{size * from, size * (from + std::exp2(bulge_bits(random) / 4) * way),
                    random() % 2 == 0 ? bulge : -bulge};
    const Output_circle circle = rounded_circle(arc);
    const double largest =
                     std::max({std::fabs(arc.from.x), std::fabs(arc.from.y), std::fabs(arc.to.x), std::fabs(arc.to.y)}),
                 ulp = std::nextafter(largest, HUGE_VAL) - largest,
                 missed = std::max(miss(arc.from, circle, ulp), miss(arc.to, circle, ulp));
    const auto found = circle_of(arc);
    EXPECT_EQ(found.has_value(), missed <= 4) << missed << " ulp, case " << i;
    if (found) {
      EXPECT_EQ(found->center, circle.center);
      EXPECT_EQ(found->radius, circle.radius);
    }
    (found ? with : without) += 1;
    close += std::fabs(missed - 4) < 0.1;
  }
  EXPECT_GT(with, 4000);
  EXPECT_GT(without, 4000);
  EXPECT_GT(close, 10);
}

}  // namespace
}  // namespace test_circle_of
