// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// What curves cut the plane into: random drawings, and those in which they have found something.

#include "cases.h"
#include "overlaid.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstddef>
#include <limits>
#include <random>
#include <vector>

namespace test_random_overlays {

using namespace bounding_arcs_test;

/// What random drawings found, one of each kind, and how many vertices, edges and faces there are.
struct Found {
  std::vector<Bezier> curves;
  std::size_t vertices, edges, faces;
};
void expect_found(const Found& found) {
  Drawing drawing;
  for (const Bezier& b : found.curves) drawing.add(b);
  const Overlaid overlaid({drawing});
  expect_counts(overlaid.cells(), found.vertices, found.edges, found.faces);
  std::mt19937 random(1);
  expect_sound(overlaid, random);
}

// A line through a loop next to its start, whose ways there are compared nearer than the line's end is known.
TEST(Overlay, OrdersWaysNextToARootOfAPolynomial) {
  expect_found({{Bezier({{-2.2200000000000002, -2.2204460492503131e-16},
                         {0, 2.2199999999999989},
                         {0, 2.2200000000000002},
                         {-2.2200000000000002, -2.2204460492503131e-16}}),
                 segment({-2.2199999999999993, -2.2204460492503131e-16}, {-0.55499999999999983, 1.6649999999999998})},
                5,
                6,
                3});
}

TEST(Overlay, HasPointsOnCurvesAtParametersThatAreNoDoubles) {
  expect_found(
      {{Bezier({{0, 2}, {0, -3}}, {3, 1}), Bezier({{2, 1}, {-2, 3}, {1, -3}, {2, 1}}), Bezier({{0, 1}, {0, 1}})},
       4,
       5,
       3});
  expect_found(
      {{Bezier({{3, 2}, {1, 1}, {-3, -1}}), Bezier({{0, 3}, {2, -1}}, {2, 2}), Bezier({{1, 1}, {1, 1}})}, 5, 4, 1});
}

// A ray at the height of a vertex where one curve has a cut of its own and another one starts.
TEST(Overlay, SendsRaysThroughVertices) {
  expect_found({{Bezier({{0, 3}, {3, -2}, {0, 3}, {3, 0}}), segment({-1, 0}, {0, 3}),
                 Bezier({{1.5, 0.75}, {-2, 2}, {3, 0}}), Bezier({{3, 0}, {2.5, -0.5}, {1.5, -0.5}}),
                 Bezier({{1.5, -0.5}, {1, 2}, {-3, -2}, {-1, 0}}), Bezier({{-0.5, 1.5}, {-3, -3}, {-2, 2}, {0, 3}})},
                7,
                10,
                5});
}

// Two crossings whose brackets are the same on one curve or on both: which parameters belong together is told exactly.
TEST(Overlay, PairsParametersOfCrossingsNextToEachOther) {
  expect_found({{segment({0, -0.20000000000000001}, {0, 0.10000000000000003}),
                 Bezier({{0.20000000000000001, 0.19999999999999998}, {0, -0.099999999999999992}}, {3, 1}),
                 Bezier({{0, -0.099999999999999992},
                         {0.3000000000000001, 0.10000000000000001},
                         {0.19999999999999996, 0.20000000000000004}}),
                 Bezier({{0.19999999999999996, 0.20000000000000004},
                         {-0.19999999999999998, -0.20000000000000007},
                         {0.20000000000000001, 0.19999999999999998}})},
                7,
                9,
                4});
  const double left = -1.4799999999999998, right = -0.7400000000000001, low = -2.2200000000000006;
  const Point start{-1.4799999999999995, 2.2199999999999993}, below{start.x, 2.2199999999999989};
  expect_found({{Bezier({start, {left, -1.4800000000000002}, {right, low}, start}),
                 Bezier({below, {left, -1.4799999999999995}, {right, low}, below})},
                4,
                8,
                6});
}

// A control point some ulp beside the end: the curve turns there, nearer to the end than cuts are told.
TEST(Overlay, HasCrossingsBehindTurnsNextToAnEnd) {
  const Point corner{-7.3999999999999995, 11.1};
  expect_found(
      {{Bezier({{3.6999999999999997, -11.1}, {-3.7000000000000006, -11.1}, {-11.1, 3.7000000000000002}, corner}),
        Bezier({corner,
                {-7.4000000000000004, 11.100000000000005},
                {-11.100000000000003, 2.2204460492503131e-16},
                {-7.3999999999999986, -7.4000000000000004}}),
        Bezier({{-6.0125000000000011, -2.7750000000000008},
                {-7.4000000000000004, 4.4408920985006262e-16},
                {-7.3999999999999995, 11.100000000000001}})},
       10,
       13,
       5});
}

// A rational piece that folds along a line encloses nothing, however it is cut.
TEST(Overlay, HasAreasBesideFoldedRationalLines) {
  Drawing drawing;
  for (const Bezier& b :
       {Bezier({{-0.5, 1}, {2, 0}}), Bezier({{2, 0}, {3, -3}, {0.375, -0.75}}),
        Bezier({{0.375, -0.75}, {-0.5, -1}, {-1, -1}, {1, 0}}), Bezier({{1, 0}, {2, 0}, {1, 2}, {-1, 1}}),
        Bezier({{3, -3}, {3, -3}, {-3, 3}, {3, -3}}, {3, 1, 2, 3})})
    drawing.add(b);
  const Overlaid found({drawing});
  ASSERT_EQ(found.cells().faces.size(), 2u);
  const ba::Measure_bounds area = found.area(1, 1e-12);
  EXPECT_EQ(area.status, ba::Query_status::COMPLETE);
  EXPECT_NEAR(area.lower, 2.7037487764390669, 1e-12);
}

/// x times a unit, some ulp away; those next to 0 are those of 1.
double nudged(std::mt19937& random, double x, double unit, int most) {
  const int ulps = std::uniform_int_distribution<int>(-most, most)(random);
  double y = x * unit;
  if (y == 0) return ulps * 0x1p-52;
  for (int i = 0; i < std::abs(ulps); ++i) y = std::nextafter(y, ulps < 0 ? -HUGE_VAL : HUGE_VAL);
  return y;
}
Drawing nudged(std::mt19937& random, const Drawing& drawing, double unit, int most) {
  Drawing result;
  for (const auto& curve : drawing.curves()) {
    std::vector<Bezier> chain;
    std::vector<Point> first;
    for (std::size_t i = 0; i < curve.beziers.size(); ++i) {
      std::vector<Point> points;
      for (const Point& p : curve.beziers[i].control_points()) {
        const double x = nudged(random, p.x, unit, most);
        points.push_back({x, nudged(random, p.y, unit, most)});
      }
      if (i > 0) points.front() = chain.back().control_points().back();
      if (i == 0) first = points;
      if (curve.is_closed && i + 1 == curve.beziers.size()) points.back() = first.front();
      chain.emplace_back(std::move(points), curve.beziers[i].weights());
    }
    result.add(std::move(chain));
  }
  return result;
}

/// Up to three operands on a small lattice: closed curves, open ones and points, and what shares parts with others.
std::vector<Drawing> random_operands(std::mt19937& random) {
  std::vector<Drawing> operands;
  for (std::size_t k = 0, count = 1 + random() % 3; k < count; ++k) {
    const bool is_related = k > 0 && random() % 2 == 0;
    operands.push_back(is_related ? related_drawing(operands.back(), random, 3, random() % 3 == 0)
                                  : random_lattice_drawing(random, 3));
  }
  Drawing& last = operands.back();
  std::vector<Bezier> open = random_lattice_chain(random, 3);
  if (random() % 3 == 0 && open.size() > 1) {
    open.pop_back();
    last.add(open);
  }
  if (random() % 4 == 0) {
    const double x = static_cast<double>(random() % 7) - 3, y = static_cast<double>(random() % 7) - 3;
    last.add(Bezier({{x, y}, {x, y}}));
  }
  return operands;
}

TEST(Overlay, IsSoundOnSmallLattices) {
  int count = 0;
  for (int i = 0; i < cases(40) && !::testing::Test::HasFailure(); ++i) {
    SCOPED_TRACE(i);
    std::mt19937 random(static_cast<unsigned>(i));
    const ba::Overlay_2::Options options{random() % 2 == 0};
    count += expect_sound(Overlaid(random_operands(random), options), random);
  }
  EXPECT_GT(count, 4 * cases(40));
}

TEST(Overlay, IsSoundWhereCurvesAreSomeUlpApart) {
  int count = 0;
  for (int i = 0; i < cases(30) && !::testing::Test::HasFailure(); ++i) {
    SCOPED_TRACE(i);
    std::mt19937 random(static_cast<unsigned>(i));
    const ba::Overlay_2::Options options{random() % 2 == 0};
    constexpr double UNITS[] = {1, 0.1, 1 / 3.0, 0.74, 3.7};
    const double unit = UNITS[random() % 5];
    std::vector<Drawing> operands;
    for (const Drawing& d : random_operands(random)) {
      operands.push_back(nudged(random, d, unit, 2));
      if (random() % 2 == 0) operands.push_back(nudged(random, d, unit, 2));
    }
    count += expect_sound(Overlaid(operands, options), random);
  }
  EXPECT_GT(count, 4 * cases(30));
}
}  // namespace test_random_overlays
