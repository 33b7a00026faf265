// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// What areas are summed of.

#include "../../../src/library/tree/Segment_hierarchy.h"
#include "cases.h"
#include "closed_drawings.h"

#include "../../../src/library/query/Area_sum.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstddef>
#include <random>
#include <utility>
#include <vector>

namespace test_area_sums {
namespace {

using namespace bounding_arcs_test;
namespace ba = CGAL::Bounding_arcs;
using ba::Bounding_arc_tree_2;
using Real = long double;

TEST(Lens, HasTheAreaOfACircularSegment) {
  for (double b = 1; b > 1e-6; b *= 0.9) {
    const Real wide = b, m = 1 + wide * wide, angle = 4 * std::atan(wide);
    const Real exact =
        b > 1e-3 ? m * m / (32 * wide * wide) * (angle - std::sin(angle)) : wide / 3 * (1 + wide * wide / 5);
    EXPECT_NEAR(static_cast<double>(ba::internal::lens_share(b) / exact), 1, b > 0.02 ? 100 * 0x1p-53 : 1e-12) << b;
    EXPECT_EQ(ba::internal::lens_share(-b), -ba::internal::lens_share(b));
  }
  EXPECT_EQ(ba::internal::lens_share(0), 0);
}

// Beside those of exact arithmetic, which lie between two neighbouring doubles.
TEST(Measures, AreaOfDoublesIsThatOfExactArithmetic) {
  std::mt19937 random(2);
  std::uniform_real_distribution<double> unit(-1, 1);
  const Placing places[] = {{}, {1e-9, 0, 0}, {1e9, 0, 0}, {1, 1e8, -3e8}, {1.0 / 3, 0.1, 0.7}};
  int told = 0;
  const int count = cases(500);
  for (int i = 0; i < count; ++i) {
    ba::Drawing_2<double> drawing;
    const Placing& at = places[i % 5];
    const auto point = [&] {
      const double x = unit(random), y = unit(random);
      return at(x, y);
    };
    std::vector<Lattice_curve> chain;
    const auto first = point();
    auto last = first;
    for (std::size_t k = 0, pieces = 2 + random() % 3; k < pieces; ++k) {
      Lattice_points points{last};
      for (std::size_t d = random() % 3; d > 0; --d) points.push_back(point());
      points.push_back(k + 1 == pieces ? first : point());
      last = points.back();
      chain.emplace_back(std::move(points));
    }
    drawing.add(chain);
    const Bounding_arc_tree_2 index(drawing);
    const auto found = ba::internal::double_double_area(index.in_unit());
    if (!found) continue;
    ++told;
    const CGAL::Exact_rational exact = ba::internal::Area_sum(index.in_unit(), false).exact().area;
    EXPECT_TRUE(CGAL::Exact_rational(found->lower) <= exact && exact <= CGAL::Exact_rational(found->upper)) << i;
    EXPECT_EQ(std::nextafter(found->lower, HUGE_VAL), found->upper) << i;
  }
  EXPECT_GT(told, count * 9 / 10);
}

}  // namespace
}  // namespace test_area_sums
