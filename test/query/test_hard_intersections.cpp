// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Intersections of curves of which doubles tell little: uneven weights, small waves, high degrees.

#include "../../src/library/tree/Segment_hierarchy.h"
#include "cases.h"
#include "intersection_checks.h"

#include <CGAL/Bounding_arcs_2/query/intersections.h>
#include "../../src/library/curve/exact_bezier.h"
#include "../../src/library/query/exact_intersections.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numeric>
#include <random>
#include <vector>

namespace test_hard_intersections {
namespace {

using namespace bounding_arcs_test;
namespace ba = CGAL::Bounding_arcs;
using Bezier = ba::Bezier_curve_2<double>;
using Points = std::vector<ba::Xy<double>>;

// Weights between 10^-decades and 10^decades: parameters are coarser than coordinates where the curve is fast.
Bezier uneven_piece(std::mt19937& random, int degree, double decades) {
  std::uniform_real_distribution<double> coordinate(-1, 1), exponent(-decades, decades);
  Points points;
  std::vector<double> weights;
  for (int i = 0; i <= degree; ++i) {
    const double x = coordinate(random), y = coordinate(random);
    points.push_back({x, y});
    weights.push_back(std::pow(10, exponent(random)));
  }
  return Bezier(points, weights);
}

TEST(Intersections, OfUnevenWeightsAreTheExactOnes) {
  std::mt19937 random(4);
  const int count = cases(150);
  for (int i = 0; i < count; ++i) {
    const Bezier p = uneven_piece(random, 3 + i % 3, 3);
    const ba::Bounding_arc_tree_2 a = index_of({p});
    expect_same(ba::exact_self_intersections(a.in_unit().exact_bezier(0)), ba::self_intersections(a), text_of(p));
  }
}

// The middle of such a curve has waves of 1e-6 of its size and less, of which doubles tell little.
Bezier with_small_waves(int degree) {
  Points points;
  for (int i = 0; i <= degree; ++i) points.push_back({std::cos(2.7 * i), std::sin(1.9 * i)});
  return Bezier(points);
}
TEST(Intersections, InSmallWavesAreThoseOfElimination) {
  for (int degree = 8; degree <= 13; ++degree) {
    const Bezier curve = with_small_waves(degree);
    const auto found = ba::self_intersections(index_of({curve})).points;
    const auto exact = ba::exact_self_intersections(ba::exact_bezier(curve)).points;
    ASSERT_EQ(found.size(), exact.size()) << degree;
    for (std::size_t i = 0; i < found.size(); ++i) {
      EXPECT_TRUE(found[i].a.t.touches(exact[i].a) && found[i].b.t.touches(exact[i].b)) << degree;
      EXPECT_EQ(found[i].kind, exact[i].kind) << degree;
    }
  }
}
// Elimination takes a quarter of a minute, and tells these.
TEST(Intersections, InSmallWavesOfDegreeTwentyAreFound) {
  Points points = with_small_waves(20).control_points();
  points.back() = points.front();
  const auto found = ba::self_intersections(index_of({Bezier(points)})).points;
  const double expected[][2] = {{0.13633924787028015, 0.28232709792915298},
                                {0.13643698180746291, 0.24498892866188111},
                                {0.31117314888602857, 0.41596069363158148}};
  ASSERT_EQ(found.size(), 3u);
  for (std::size_t i = 0; i < found.size(); ++i) {
    EXPECT_LE(found[i].a.t.lower, expected[i][0] + 1e-16);
    EXPECT_GE(found[i].a.t.upper, expected[i][0] - 1e-16);
    EXPECT_LE(found[i].b.t.lower, expected[i][1] + 1e-16);
    EXPECT_GE(found[i].b.t.upper, expected[i][1] - 1e-16);
  }
}

// Crossings of the polygon of samples with itself; sides next to each other have none.
std::size_t sampled_crossings(const std::vector<Bezier>& chain) {
  constexpr int SAMPLES = 1 << 14;
  Points points;
  for (const Bezier& piece : chain)
    for (int i = 0; i < SAMPLES; ++i) points.push_back(piece.point(double(i) / SAMPLES));
  std::vector<std::size_t> sides(points.size() - 1);
  std::iota(sides.begin(), sides.end(), std::size_t(0));
  const auto least = [&](std::size_t i) { return (std::min)(points[i].x, points[i + 1].x); };
  std::sort(sides.begin(), sides.end(), [&](std::size_t i, std::size_t j) { return least(i) < least(j); });
  const auto are_parted = [&](std::size_t i, std::size_t j) {  // the ends of side j by the line of side i
    const auto along = points[i + 1] - points[i];
    return (cross(along, points[j] - points[i]) < 0) != (cross(along, points[j + 1] - points[i]) < 0);
  };
  std::size_t count = 0;
  for (std::size_t k = 0; k < sides.size(); ++k) {
    const std::size_t i = sides[k];
    const double most = (std::max)(points[i].x, points[i + 1].x);
    for (std::size_t m = k + 1; m < sides.size() && least(sides[m]) <= most; ++m) {
      const std::size_t j = sides[m];
      if (i + 1 != j && j + 1 != i && are_parted(i, j) && are_parted(j, i)) ++count;
    }
  }
  return count;
}

// Elimination would take minutes for each of them: where doubles leave a curve open beside a cut, it runs ahead.
TEST(Intersections, OfUnevenWeightsInHighDegreesAreThoseOfSamples) {
  std::size_t points = 0;
  for (const unsigned seed : {1U, 2U, 3U, 4U}) {
    std::mt19937 random(seed);
    const Bezier p = uneven_piece(random, 32, 1), q = uneven_piece(random, 24, 1);
    Points next = q.control_points();
    next.front() = p.control_points().back();
    const std::vector<Bezier> chain{p, Bezier(next, q.weights())};
    const ba::Intersections_2<> found = ba::self_intersections(index_of(chain));
    EXPECT_EQ(found.points.size(), sampled_crossings(chain)) << seed;
    EXPECT_TRUE(found.overlaps.empty()) << seed;
    points += found.points.size();
  }
  EXPECT_GT(points, 8U);
}

TEST(Intersections, OfPartsThatRunAheadAreNone) {
  const auto exact = [](const Bezier& b) { return ba::exact_bezier(b); };
  const auto loop = exact(Bezier(Points{{0, 0}, {3, 2}, {-2, 2}, {1, 0}}));
  EXPECT_FALSE(ba::runs_ahead(loop, 0, 1));
  EXPECT_TRUE(ba::runs_ahead(loop, 0, 0.25));
  EXPECT_TRUE(ba::runs_ahead(loop, 0.5, 0.5 + 0x1p-50));
  const auto cusp = exact(Bezier(Points{{0, 0}, {1, 1}, {0, 1}, {1, 0}}));  // at 1/2
  EXPECT_FALSE(ba::runs_ahead(cusp, 0.5 - 0x1p-40, 0.5 + 0x1p-40));
  EXPECT_TRUE(ba::runs_ahead(cusp, 0.5 + 0x1p-20, 0.5 + 0x1p-19));
  const auto fast = exact(Bezier(Points{{0, 0}, {1, 1}, {2, 0}}, {1, 0x1p-4, 0x1p-8}));
  EXPECT_TRUE(ba::runs_ahead(fast, 0, 1));
}

}  // namespace
}  // namespace test_hard_intersections
