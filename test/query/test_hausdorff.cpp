// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Hausdorff distances beside those of samples and of points about the farthest of these, and those that are known.

#include "../../src/library/tree/Segment_hierarchy.h"
#include "cases.h"
#include "query_drawings.h"

#include <CGAL/Bounding_arcs_2/query/closest_point.h>
#include <CGAL/Bounding_arcs_2/query/distance.h>
#include "../../src/library/query/Hausdorff_search.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>
#include <stdexcept>
#include <vector>

namespace test_hausdorff {
namespace {

using namespace bounding_arcs_test;
using ba::Bounding_arc_tree_2;

// At most the distance that a is from b where it is farthest, by more samples about the farthest one.
double sampled_distance(const Drawing& a, const Bounding_arc_tree_2& b) {
  constexpr int SAMPLES = 30, AROUND = 4, ROUNDS = 14;
  double farthest = 0;
  for (const auto& curve : a.curves())
    for (const Bezier& piece : curve.beziers) {
      double of_piece = -1, best = 0, half = 1.0 / SAMPLES;
      const auto look = [&](double t) {
        const double d = ba::closest_point(b, piece.point(t))->distance.lower;
        if (d > of_piece) best = t;
        of_piece = (std::max)(of_piece, d);
      };
      for (int i = 0; i <= SAMPLES; ++i) look(static_cast<double>(i) / SAMPLES);
      for (int round = 0; round < ROUNDS && of_piece > 0.9 * farthest; ++round, half /= 3) {
        const double middle = best;
        for (int i = -AROUND; i <= AROUND; ++i) look((std::min)((std::max)(middle + half * i / AROUND, 0.0), 1.0));
      }
      farthest = (std::max)(farthest, of_piece);
    }
  return farthest;
}

void expect_directed(const Drawing& a, const Drawing& b, double tolerance) {
  const Bounding_arc_tree_2 index_a(a), index_b(b);
  const std::optional<ba::Drawing_distance<>> r = ba::directed_hausdorff_distance(index_a, index_b, tolerance);
  ASSERT_TRUE(r);
  const double rounding = 400 * 0x1p-53 * (size_of(a) + size_of(b));
  EXPECT_GE(r->distance.upper, sampled_distance(a, index_b) - rounding * 0x1p-4);
  EXPECT_LE(0, r->distance.lower);
  EXPECT_LE(r->distance.upper - r->distance.lower, tolerance + 20 * rounding);
  // what it is said to be far from is so far, by a scan of all
  const Vector p = Scanned_drawing(a).at(r->a.place), q = Scanned_drawing(b).at(r->b.place);
  const Real scanned = Scanned_drawing(b).distance(p);
  EXPECT_LE(r->distance.lower, scanned);
  EXPECT_LE(length(p - q), r->distance.upper + rounding);
  EXPECT_LE(length(p - q), scanned + rounding);
  EXPECT_LE(length(widened(r->a.point) - p), rounding);
  EXPECT_LE(length(widened(r->b.point) - q), rounding);
}

TEST(Hausdorff, IsBracketedBesideSamples) {
  std::mt19937 random(1);
  std::uniform_real_distribution<double> unit(-1, 1);
  for (int i = 0; i < cases(500); ++i) {
    const double scale = i % 5 == 1 ? 1e-9 : (i % 5 == 2 ? 1e9 : 1);
    const Point far = i % 7 == 3 ? Point{1e8 * scale, -1e8 * scale} : Point{};
    const Drawing a = moved(random_drawing(random), scale, far), b = moved(random_drawing(random), scale, far);
    SCOPED_TRACE(i);
    expect_directed(a, b, scale * (i % 3 == 0 ? 1e-3 : 1e-9));
    if (HasFailure()) return;
  }
}

// The same by scans alone, which share nothing with the search, and on the other side: where the search has it farthest
// it is as far as the lower bound, and no sample is farther than the upper one.
TEST(Hausdorff, IsBracketedBesideScansInLongDouble) {
  std::mt19937 random(6);
  for (int i = 0; i < cases(12); ++i) {
    const Drawing a = random_drawing(random), b = random_drawing(random);
    const Scanned_drawing scanned_a(a), scanned_b(b);
    constexpr int SAMPLES = 12;
    Real farthest = 0;
    for (std::size_t piece = 0; piece < scanned_a.size(); ++piece) {
      Real best = 0, of_piece = -1;
      const auto look = [&](Real t) {
        const Real d = scanned_b.distance(scanned_a.at(piece, t));
        if (d > of_piece) best = t;
        of_piece = (std::max)(of_piece, d);
      };
      for (int k = 0; k <= SAMPLES; ++k) look(Real(k) / SAMPLES);
      Real half = Real(1) / SAMPLES;
      for (int round = 0; round < 12 && of_piece > 0.9L * farthest; ++round, half /= 2) {
        const Real middle = best;
        for (const Real t : {middle - half, middle - half / 2, middle + half / 2, middle + half})
          look((std::min)((std::max)(t, Real(0)), Real(1)));
      }
      farthest = (std::max)(farthest, of_piece);
    }
    const auto r = ba::directed_hausdorff_distance(Bounding_arc_tree_2(a), Bounding_arc_tree_2(b), 1e-9);
    ASSERT_TRUE(r) << i;
    EXPECT_GE(r->distance.upper, farthest - 1e-15L) << i;
    EXPECT_LE(r->distance.lower, scanned_b.distance(scanned_a.at(r->a.place)) + 1e-15L) << i;
    EXPECT_LE(r->distance.upper - r->distance.lower, 1.001e-9) << i;
  }
}

TEST(Hausdorff, OfCurvesThatAreNearlyTheSameIsBracketed) {
  std::mt19937 random(2);
  std::uniform_real_distribution<double> unit(-1, 1);
  for (int i = 0; i < cases(200); ++i) {
    const double apart = std::exp2(-2 - i % 30);
    const Drawing a = drawing_of(closed_curve(random, {0, 0}, 3 + random() % 5));
    Drawing b = i % 2 == 0 ? moved(a, 1 + apart, {}) : moved(a, 1, {apart * unit(random), apart * unit(random)});
    SCOPED_TRACE(i);
    expect_directed(a, b, 1e-6);
  }
}

TEST(Hausdorff, OfCirclesIsKnown) {
  std::mt19937 random(3);
  std::uniform_real_distribution<double> unit(-1, 1);
  for (int i = 0; i < cases(2000); ++i) {
    const double r = std::exp2(3 * unit(random)), s = std::exp2(3 * unit(random));
    const Point p{4 * unit(random), 4 * unit(random)}, q{4 * unit(random), 4 * unit(random)};
    const Bounding_arc_tree_2 a(drawing_of(circle(p, r))), b(drawing_of(circle(q, s)));
    // farthest on the line of the centers, on one side or the other
    const double apart = std::hypot(q.x - p.x, q.y - p.y);
    const double directed = (std::max)(std::fabs(apart + r - s), std::fabs(std::fabs(apart - r) - s)),
                 both = apart + std::fabs(r - s);
    const std::optional<ba::Drawing_distance<>> d = ba::directed_hausdorff_distance(a, b, 1e-9),
                                                h = ba::hausdorff_distance(a, b, 1e-9);
    const double rounding = 1e-13 * (8 + r + s);
    EXPECT_LE(d->distance.lower, directed + rounding) << i;
    EXPECT_GE(d->distance.upper, directed - rounding) << i;
    EXPECT_LE(d->distance.upper - d->distance.lower, 1.001e-9) << i;
    EXPECT_LE(h->distance.lower, both + rounding) << i;
    EXPECT_GE(h->distance.upper, both - rounding) << i;
    EXPECT_LE(h->distance.upper - h->distance.lower, 1.001e-9) << i;
    const Point way = h->a.point - h->b.point;
    EXPECT_NEAR(std::hypot(way.x, way.y), both, 1.001e-9) << i;
    EXPECT_NEAR(std::hypot(h->a.point.x - p.x, h->a.point.y - p.y), r, 1e-10) << i;  // a's point is on a
  }
}

// The nearest point changes from one end to the other where the distance is largest.
TEST(Hausdorff, IsFoundWhereBranchesOfEqualDistanceMeet) {
  Drawing two;
  two.add(segment({0, 0}, {0, 3}));
  two.add(segment({4, 3}, {4, -1}));
  const Bounding_arc_tree_2 a(drawing_of(segment({0, 1}, {4, 1}))), b(two);
  const auto d = ba::directed_hausdorff_distance(a, b, 1e-12);
  EXPECT_LE(d->distance.lower, 2);
  EXPECT_GE(d->distance.upper, 2);
  EXPECT_LE(d->distance.upper - d->distance.lower, 2e-12);
  EXPECT_NEAR(d->a.point.x(), 2, 2e-12);
  // from one end of a chord of a circle to the other, its middle is nearest to all
  const Bounding_arc_tree_2 chord(drawing_of(segment({-1, 0}, {1, 0}))), round(drawing_of(circle({0, 0}, 1)));
  const auto h = ba::hausdorff_distance(chord, round, 1e-12);
  EXPECT_NEAR(h->distance.lower, 1, 2e-12);
  EXPECT_NEAR(h->distance.upper, 1, 2e-12);
}

TEST(Hausdorff, OfOneCurveIsNothing) {
  std::mt19937 random(4);
  for (int i = 0; i < cases(50); ++i) {
    const Bezier curve = random_curve(random);
    const auto parts = curve.split(0.4);
    const Bounding_arc_tree_2 whole(drawing_of(curve)),
        halves(drawing_of(std::vector<Bezier>{parts.first, parts.second}));
    for (const auto* other : {&whole, &halves}) {
      const auto h = ba::hausdorff_distance(whole, *other, 1e-7);
      EXPECT_LE(h->distance.lower, 1e-14);
      EXPECT_LE(h->distance.upper, 1.001e-7);
    }
    const auto h = ba::directed_hausdorff_distance(Bounding_arc_tree_2(drawing_of(parts.first)), whole, 1e-7);
    EXPECT_LE(h->distance.upper, 1.001e-7);
  }
}

TEST(Hausdorff, LooksAtFewPointsOfManyPieces) {
  std::vector<double> points;
  std::mt19937 random(5);
  for (const std::size_t count : {100U, 10000U, FEW_CASES ? 10000U : 100000U}) {
    std::vector<Bezier> a, b;
    const double n = static_cast<double>(count);
    for (std::size_t i = 0; i < count; ++i) {
      const double x = static_cast<double>(i) / n, y = (static_cast<double>(i) + 1) / n;
      a.push_back(Bezier({{x, x * x}, {x + 0.5 / n, x * y}, {y, y * y}}));
      b.push_back(Bezier({{x, -x}, {x + 0.5 / n, -x}, {y, -y}}));
    }
    const Bounding_arc_tree_2 index_a(drawing_of(a)), index_b(drawing_of(b));
    ba::Hausdorff_search search(index_a.in_unit(), index_b.in_unit(), 1e-9);
    search.search();
    points.push_back(static_cast<double>(search.points()));
  }
  EXPECT_LE(points.back(), 8 * points.front());
}

TEST(Hausdorff, IsOfPointsAndOfNothing) {
  const Bounding_arc_tree_2 none{Drawing()}, point(drawing_of(Bezier({{3, 4}, {3, 4}, {3, 4}}))),
      origin(drawing_of(Bezier({{0, 0}, {0, 0}}))), line(drawing_of(segment({0, 0}, {6, 0})));
  EXPECT_FALSE(ba::hausdorff_distance(none, point, 1));
  EXPECT_FALSE(ba::hausdorff_distance(point, none, 1));
  EXPECT_FALSE(ba::directed_hausdorff_distance(none, none, 1));
  EXPECT_NEAR(ba::hausdorff_distance(point, origin, 1e-12)->distance.upper, 5, 2e-12);
  EXPECT_NEAR(ba::directed_hausdorff_distance(point, line, 1e-12)->distance.upper, 4, 2e-12);
  EXPECT_NEAR(ba::hausdorff_distance(point, line, 1e-12)->distance.lower, 5, 2e-12);
  EXPECT_LE(ba::hausdorff_distance(point, point, 1e-12)->distance.upper, 2e-12);
}

TEST(Hausdorff, RefusesTolerancesThatAreNone) {
  const Bounding_arc_tree_2 origin(drawing_of(Bezier({{0, 0}, {0, 0}})));
  for (const double tolerance : {0.0, -1.0, std::numeric_limits<double>::quiet_NaN(), HUGE_VAL})
    EXPECT_THROW((void)ba::hausdorff_distance(origin, origin, tolerance), std::invalid_argument);
}

}  // namespace
}  // namespace test_hausdorff
