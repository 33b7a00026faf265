// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Least distances of drawings beside scans of both, and those that are known.

#include "../../src/library/tree/Segment_hierarchy.h"
#include "cases.h"
#include "query_drawings.h"

#include <CGAL/Bounding_arcs_2/query/distance.h>
#include "../../src/library/query/Distance_search.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>
#include <stdexcept>
#include <vector>

namespace test_distance {
namespace {

using namespace bounding_arcs_test;
using ba::Bounding_arc_tree_2;

// At least the distance of two drawings: from samples of both, and from nearer ones about the nearest pair.
Real scanned_distance(const Scanned_drawing& a, const Scanned_drawing& b) {
  constexpr int SAMPLES = 20, AROUND = 3, ROUNDS = 60;
  struct Pair {
    Real distance = HUGE_VALL, s = 0, t = 0;
    std::size_t i = 0, j = 0;
  } best;
  const auto look = [&](std::size_t i, Real s, std::size_t j, Real t) {
    const Real d = length(a.at(i, s) - b.at(j, t));
    if (d < best.distance) best = {d, s, t, i, j};
  };
  for (std::size_t i = 0; i < a.size(); ++i)
    for (std::size_t j = 0; j < b.size(); ++j)
      for (int k = 0; k <= SAMPLES; ++k)
        for (int l = 0; l <= SAMPLES; ++l) look(i, Real(k) / SAMPLES, j, Real(l) / SAMPLES);
  const auto within = [](Real t) { return (std::min)((std::max)(t, Real(0)), Real(1)); };
  Real half = Real(1) / SAMPLES;
  for (int round = 0; round < ROUNDS; ++round, half *= 0.6L) {
    const Pair middle = best;
    for (int k = -AROUND; k <= AROUND; ++k)
      for (int l = -AROUND; l <= AROUND; ++l)
        look(middle.i, within(middle.s + half * k / AROUND), middle.j, within(middle.t + half * l / AROUND));
  }
  return best.distance;
}

void expect_bracket(const Drawing& a, const Drawing& b, double tolerance, Real scanned) {
  const Bounding_arc_tree_2 index_a(a), index_b(b);
  constexpr double TINY = 1e-300;  // of curves that meet
  const double eps = tolerance * static_cast<double>(scanned) + TINY;
  const std::optional<ba::Drawing_distance<>> r = ba::distance(index_a, index_b, eps);
  ASSERT_TRUE(r);
  // of high degrees, points of curves are known less well
  const double rounding =
      (std::max)(400 * 0x1p-53 * (size_of(a) + size_of(b)), 4 * (error_of(index_a) + error_of(index_b)));
  EXPECT_LE(r->distance.lower, scanned);
  EXPECT_LE(0, r->distance.lower);
  const Real of_points = length(Scanned_drawing(a).at(r->a.place) - Scanned_drawing(b).at(r->b.place));
  EXPECT_GE(r->distance.upper, of_points * (1 - 0x1p-60L) - rounding * 0x1p-8);
  EXPECT_LE(r->distance.upper, of_points + rounding);
  EXPECT_LE(r->distance.upper - r->distance.lower, eps + 20 * rounding);
  EXPECT_LE(length(widened(r->a.point) - Scanned_drawing(a).at(r->a.place)), rounding);
  EXPECT_LE(length(widened(r->b.point) - Scanned_drawing(b).at(r->b.place)), rounding);
}

TEST(Distance, IsBracketedBesideScans) {
  std::mt19937 random(1);
  std::uniform_real_distribution<double> unit(-1, 1);
  for (int i = 0; i < cases(250); ++i) {
    const double apart = i % 2 == 0 ? 3 : 0, scale = i % 5 == 1 ? 1e-9 : (i % 5 == 2 ? 1e9 : 1);
    const Point far = i % 7 == 3 ? Point{1e8 * scale, -1e8 * scale} : Point{};
    const Drawing a = moved(random_drawing(random), scale, far),
                  b = moved(random_drawing(random), scale,
                            far + scale * Point{apart * unit(random), apart * unit(random)});
    SCOPED_TRACE(i);
    expect_bracket(a, b, i % 3 == 0 ? 1e-4 : 1e-12, scanned_distance(Scanned_drawing(a), Scanned_drawing(b)));
    if (HasFailure()) return;
  }
}

TEST(Distance, OfCirclesIsKnown) {
  std::mt19937 random(2);
  std::uniform_real_distribution<double> unit(-1, 1);
  for (int i = 0; i < cases(2000); ++i) {
    const double r = std::exp2(3 * unit(random)), s = std::exp2(3 * unit(random));
    const Point p{4 * unit(random), 4 * unit(random)}, q{4 * unit(random), 4 * unit(random)};
    const Real apart = length(widened(p) - widened(q));
    const Real distance = (std::max)({apart - r - s, r - s - apart, s - r - apart, Real(0)});
    const auto d =
        ba::distance(Bounding_arc_tree_2(drawing_of(circle(p, r))), Bounding_arc_tree_2(drawing_of(circle(q, s))));
    // the control points of a circle are rounded, which moves it by less
    const double rounding = 1e-13 * (8 + r + s);
    EXPECT_LE(d->distance.lower, distance + rounding) << i;
    EXPECT_GE(d->distance.upper, distance - rounding) << i;
    EXPECT_LE(d->distance.upper - d->distance.lower, 1e-12 * d->distance.upper + rounding) << i;
  }
}

TEST(Distance, OfCurvesAtOneDistanceEnds) {
  const Bounding_arc_tree_2 one(drawing_of(circle({0, 0}, 1))), two(drawing_of(circle({0, 0}, 2)));
  const auto d = ba::distance(one, two);
  EXPECT_NEAR(d->distance.upper, 1, 1e-13);
  EXPECT_NEAR(d->distance.lower, 1, 1e-12);
  const Bounding_arc_tree_2 low(drawing_of(segment({0, 0}, {5, 1}))), high(drawing_of(segment({-1, 2}, {9, 4})));
  EXPECT_NEAR(ba::distance(low, high)->distance.lower, std::sqrt(11.0 * 11 / 26), 1e-12);
  EXPECT_NEAR(ba::distance(low, high)->distance.upper, std::sqrt(11.0 * 11 / 26), 1e-12);
  // a parabola and itself, moved, which crosses it in the middle
  const Bounding_arc_tree_2 parabola(drawing_of(Bezier({{-1, 1}, {0, -1}, {1, 1}}))),
      beside(drawing_of(Bezier({{-1 + 1e-3, 1}, {0 + 1e-3, -1}, {1 + 1e-3, 1}})));
  EXPECT_EQ(ba::distance(parabola, beside)->distance.lower, 0);
  EXPECT_LE(ba::distance(parabola, beside)->distance.upper, 2e-13);
}

// One spiral segment, bent away from a line: in its middle the distance stands still, and is largest.
TEST(Distance, IsOfTheEndOfAnArch) {
  const Bounding_arc_tree_2 arch(drawing_of(Bezier({{0, 1}, {0.3, 1}, {1, 0}}))),
      line(drawing_of(segment({-3, 2.04}, {2, -3.06})));  // 1.02 x + y = -1.02
  ASSERT_EQ(arch.in_unit().number_of_segments(), 1U);
  const double least = 2.02 / std::hypot(1.02, 1.0);  // of (0, 1)
  for (const auto& d : {ba::distance(arch, line), ba::distance(line, arch)}) {
    EXPECT_NEAR(d->distance.lower, least, 1e-11);
    EXPECT_NEAR(d->distance.upper, least, 1e-11);
  }
}

TEST(Distance, IsNothingOfCurvesThatMeet) {
  std::mt19937 random(3);
  for (int i = 0; i < cases(300); ++i) {
    const Bezier curve = random_curve(random);
    const auto parts = curve.split(0.25 + 0.5 * (i % 10) / 10);
    const Bounding_arc_tree_2 whole(drawing_of(curve)), first(drawing_of(parts.first)), last(drawing_of(parts.second));
    for (const auto& [a, b] : {std::pair(&whole, &whole), std::pair(&first, &last), std::pair(&whole, &last)}) {
      const auto d = ba::distance(*a, *b);
      EXPECT_EQ(d->distance.lower, 0);
      EXPECT_LE(d->distance.upper, 4e-13 * size_of(drawing_of(curve)));
    }
  }
  // touching circles and a line
  const Bounding_arc_tree_2 one(drawing_of(circle({0, 0}, 1))), two(drawing_of(circle({3, 0}, 2))),
      inner(drawing_of(circle({0.5, 0}, 0.5))), line(drawing_of(segment({1, -3}, {1, 5})));
  for (const auto* other : {&two, &inner, &line, &one}) {
    EXPECT_EQ(ba::distance(one, *other)->distance.lower, 0);
    EXPECT_LE(ba::distance(one, *other)->distance.upper, 2e-13);
  }
}

// Nearest points of nested curves are where both bend to one side, and arcs say nothing of lines apart.
TEST(Distance, OfNestedCurvesIsBracketed) {
  std::mt19937 random(4);
  for (int i = 0; i < cases(100); ++i) {
    const Drawing outer = drawing_of(closed_curve(random, {0, 0}, 5 + random() % 20)),
                  inner = moved(drawing_of(closed_curve(random, {0, 0}, 5 + random() % 20)),
                                std::exp2(-static_cast<double>(i % 6)), {0.01 * (i % 7), 0});
    expect_bracket(outer, inner, 1e-12, scanned_distance(Scanned_drawing(outer), Scanned_drawing(inner)));
  }
}

// Two rows of waves that fall off on both sides.
TEST(Distance, LooksAtAsManyPairsAsTheLogarithmOfTheNumberOfPieces) {
  std::vector<double> pairs;
  for (const int count : {100, 10000, FEW_CASES ? 10000 : 100000}) {
    const auto height = [&](double x) { return -std::fabs(x - count / 3.0) / 2; };
    std::vector<Bezier> chain;
    for (int i = 0; i < count; ++i)
      chain.push_back(Bezier({{1.0 * i, height(i)},
                              {i + 0.3, height(i) + 0.4 + 1e-3 * ((i * 7919) % 101)},
                              {i + 0.7, height(i + 1) - 0.3},
                              {i + 1.0, height(i + 1)}}));
    const Bounding_arc_tree_2 a(drawing_of(chain)), b(moved(drawing_of(chain), -1, {count / 1.5 + 0.37, 3}));
    ba::Distance_search search(a.in_unit(), b.in_unit(), 0, 1e-12);
    search.search();
    EXPECT_LE(search.result()->distance.upper - search.result()->distance.lower, 1e-14 * count);
    pairs.push_back(static_cast<double>(search.pairs()));
  }
  EXPECT_LE(pairs.back(), 8 * pairs.front());
  EXPECT_LE(pairs.back(), 2.5 * pairs[1]);
}

TEST(Distance, IsOfPointsAndOfNothing) {
  const Bounding_arc_tree_2 none{Drawing()}, point(drawing_of(Bezier({{3, 4}, {3, 4}, {3, 4}}))),
      origin(drawing_of(Bezier({{0, 0}, {0, 0}}))), line(drawing_of(segment({-9, 1}, {9, 1})));
  EXPECT_FALSE(ba::distance(none, point));
  EXPECT_FALSE(ba::distance(point, none));
  EXPECT_FALSE(ba::distance(none, none));
  EXPECT_NEAR(ba::distance(point, origin)->distance.lower, 5, 1e-13);
  EXPECT_NEAR(ba::distance(point, origin)->distance.upper, 5, 1e-13);
  EXPECT_NEAR(ba::distance(point, line)->distance.lower, 3, 1e-13);
  EXPECT_EQ(ba::distance(point, point)->distance.lower, 0);
}

TEST(Distance, RefusesTolerancesThatAreNone) {
  const Bounding_arc_tree_2 origin(drawing_of(Bezier({{0, 0}, {0, 0}})));
  for (const double tolerance : {0.0, -1.0, std::numeric_limits<double>::quiet_NaN(), HUGE_VAL}) {
    EXPECT_THROW((void)ba::distance(origin, origin, tolerance), std::invalid_argument);
  }
}

}  // namespace
}  // namespace test_distance
