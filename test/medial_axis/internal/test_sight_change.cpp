// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Bounds of how the distance from an arc's circle changes about a place, against what it is at places there.

#include "cases.h"

#include "../../../src/library/medial_axis/Line_prover.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace test_sight_change {
namespace {

namespace ba = CGAL::Bounding_arcs;
using Point = ba::Xy<double>;
using ba::internal::Arc_sight;
using ba::internal::Sight_change;

// A place, a line through it, and a rectangle along the line in which the circle is seen.
struct View {
  ba::Arc_2 arc;
  Point at, along;
  double way, reach;

  [[nodiscard]] Arc_sight from(double x, double y) const {
    return ba::internal::sight(at + x * along + y * perp(along), arc);
  }
  [[nodiscard]] double across(const Arc_sight& s) const { return dot(perp(along), s.gradient); }
};

// Points, and arcs that turn either way, with rectangles of all sizes that are bounded.
class Source {
 public:
  View view() {
    View v{{point(), point(), 0}, point(), {1, 0}, 0, 0};
    if (random_() % 3 == 0) v.arc.to = v.arc.from;
    else v.arc.bulge = unit_(random_);
    const double angle = 4 * unit_(random_);
    v.along = {std::cos(angle), std::sin(angle)};
    const double room = 0.5 / std::fabs(v.from(0, 0).curvature), share = 0.5 + 0.5 * unit_(random_);
    v.way = room * share * std::exp2(-8 * std::fabs(unit_(random_)));
    v.reach = (room - v.way) * std::exp2(-1 - 16 * std::fabs(unit_(random_)));
    return v;
  }
  double unit() { return unit_(random_); }

 private:
  Point point() { return {unit_(random_), unit_(random_)}; }
  std::mt19937 random_{61};
  std::uniform_real_distribution<double> unit_{-1, 1};
};

TEST(SightChange, HoldsGradientsAndSecondDerivativesAllAbout) {
  constexpr double ROUNDING = 1e-9;  // of circles that are nearly lines
  Source random;
  int bounded = 0, far = 0;
  for (int i = 0; i < bounding_arcs_test::cases(20000) && !testing::Test::HasFailure(); ++i) {
    const View v = random.view();
    const Arc_sight middle = v.from(0, 0);
    const Sight_change change = ba::internal::sight_change(middle, v.across(middle), v.way, v.reach);
    if (!std::isfinite(change.turn)) continue;
    ++bounded;
    const double width = change.second.width(), slack = ROUNDING * change.tightest;
    for (int k = 0; k < 8; ++k) {
      // corners of the rectangle first
      const double x = v.way * (k < 4 ? k % 2 * 2 - 1 : random.unit()),
                   y = v.reach * (k < 4 ? k / 2 * 2 - 1 : random.unit());
      const Arc_sight s = v.from(x, y);
      const double second = -s.curvature * v.across(s) * v.across(s);
      EXPECT_LE(euclidean_norm(s.gradient - middle.gradient), change.turn + ROUNDING) << i;
      EXPECT_LE(std::fabs(s.curvature), change.tightest + slack) << i;
      EXPECT_GE(second, change.second.lower - slack) << i;
      EXPECT_LE(second, change.second.upper + slack) << i;
      EXPECT_LE(std::fabs(second), change.most_second() + slack) << i;
      far += std::fabs(second - change.second.middle()) > width / 16;
    }
  }
  EXPECT_GT(bounded, bounding_arcs_test::cases(5000));
  EXPECT_GT(far, bounding_arcs_test::cases(2000));  // bounds are not much wider than what they hold
}

}  // namespace
}  // namespace test_sight_change
