// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Nearest points beside scans of the whole drawing in long double, and those that are known.

#include "../../src/library/tree/Segment_hierarchy.h"
#include "cases.h"
#include "query_drawings.h"

#include <CGAL/Bounding_arcs_2/query/closest_point.h>
#include "../../src/library/query/Closest_search.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>
#include <stdexcept>
#include <vector>

namespace test_closest_point {
namespace {

using namespace bounding_arcs_test;
using ba::Bounding_arc_tree_2;
using ba::Closest_point;

// A point about a drawing: anywhere, on it, very near it, in a center of curvature, far away.
Point query_about(const Drawing& drawing, std::mt19937& random) {
  std::uniform_real_distribution<double> unit(-1, 1);
  const auto& curve = drawing.curves()[random() % drawing.curves().size()];
  const Bezier& piece = curve.beziers[random() % curve.beziers.size()];
  const double t = random() % 4 == 0 ? static_cast<double>(random() % 2) : 0.5 + 0.5 * unit(random);
  const auto jet = ba::Bezier_evaluator(piece)(t);
  const Point p = jet.point, normal = perp(jet.first);
  switch (random() % 6) {
    case 0:
      return p;
    case 1:
      return p + std::exp2(-50 * std::fabs(unit(random))) * normal;
    case 2: {
      const double bend = cross(jet.first, jet.second);
      return bend == 0 ? p : p + (dot(jet.first, jet.first) / bend) * normal;
    }
    case 3:
      return p + 1e6 * normal;
    default:
      return p + unit(random) * normal + unit(random) * jet.first;
  }
}

void expect_closest(const Closest_point<>& r, const Scanned_drawing& scanned, const Point& q, double size) {
  const Vector p = widened(q);
  const Real least = scanned.distance(p), there = length(scanned.at(r.place) - p);
  const double rounding = 400 * 0x1p-53 * (size + static_cast<double>(least));
  EXPECT_LE(0, r.distance.lower);
  EXPECT_LE(r.distance.lower, least);
  EXPECT_LE(there, least + rounding);
  EXPECT_GE(r.distance.upper, there - rounding * 0x1p-8);
  EXPECT_LE(r.distance.upper, there + rounding);
  EXPECT_LE(r.distance.upper - r.distance.lower, 40 * rounding);  // of weights, too
  EXPECT_LE(length(widened(r.point) - scanned.at(r.place)), rounding);
}

TEST(ClosestPoint, IsBracketedBesideScans) {
  std::mt19937 random(1);
  for (int i = 0; i < cases(250); ++i) {
    const double scale = i % 5 == 1 ? 1e-9 : (i % 5 == 2 ? 1e9 : 1);
    const Point far = i % 7 == 3 ? Point{1e8 * scale, -1e8 * scale} : Point{};
    const Drawing drawing = moved(random_drawing(random), scale, far);
    const Bounding_arc_tree_2 index(drawing);
    const Scanned_drawing scanned(drawing);
    Closest_point<> before = *ba::closest_point(index, far);
    for (int k = 0; k < 4; ++k) {
      const Point q = query_about(drawing, random);
      const Closest_point<> r = *ba::closest_point(index, q), warm = *ba::closest_point(index, q, before.place);
      const double size = size_of(drawing) + std::fabs(q.x) + std::fabs(q.y);
      SCOPED_TRACE(i);
      expect_closest(r, scanned, q, size);
      expect_closest(warm, scanned, q, size);
      EXPECT_LE(std::fabs(warm.distance.upper - r.distance.upper), 1e-13 * size);
      before = r;
      if (HasFailure()) return;
    }
  }
}

TEST(ClosestPoint, OfKindsOfDegenerateCurvesIsBracketed) {
  Degenerate_curves curves(2);
  std::mt19937 random(2);
  for (const Kind kind : ALL_KINDS) {
    if (kind == Kind::EXTREME_WEIGHTS || kind == Kind::EXTREME_ASPECT) continue;  // scans miss what they do
    for (int i = 0; i < cases(150); ++i) {
      const Drawing drawing = drawing_of(curves(kind));
      const double size = size_of(drawing);
      if (!(size < 0x1p400 && size > 0x1p-400)) continue;  // squares of lengths are numbers
      const Bounding_arc_tree_2 index(drawing);
      const Point q = query_about(drawing, random);
      const Closest_point<> r = *ba::closest_point(index, q);
      const Real least = Scanned_drawing(drawing).distance(widened(q));
      SCOPED_TRACE(name(kind) + std::to_string(i) + ", of size 10^" + std::to_string(std::log10(size)));
      EXPECT_LE(r.distance.lower, least);
      EXPECT_GE(r.distance.upper,
                length(Scanned_drawing(drawing).at(r.place) - widened(q)) * (1 - 0x1p-60L) - 1e-15 * size);
    }
  }
}

// Far from the origin, where a point that is one step of Newton's method on may be a thousand times as far away as that
// which was looked at: the speed is some thirty times what rounding leaves open.
TEST(ClosestPoint, IsNoFartherThanToldNextToCusps) {
  std::mt19937 random(8);
  std::uniform_real_distribution<double> unit(-1, 1);
  for (int i = 0; i < cases(4000); ++i) {
    const double away = std::exp2(22 + 5 * unit(random)), gap = away * std::exp2(-46.5 + 2 * unit(random));
    std::vector<Point> points{{0, 0}, {1, 1}, {random() % 2 == 0 ? gap : -gap, 1}, {1, 0}};  // a cusp but for the gap
    const Point far{away * unit(random), away * unit(random)};
    for (Point& p : points) p = p + far;
    const Bezier curve(points);
    const Bounding_arc_tree_2 index(drawing_of(curve));
    const Point cusp = ba::Bezier_evaluator(curve)(0.5).point;
    for (int k = 0; k < 8; ++k) {
      const Point q = cusp + away * std::exp2(-43 + 4 * unit(random)) * Point{unit(random), unit(random)};
      const Closest_point<> r = *ba::closest_point(index, q);
      ASSERT_LE(ba::euclidean_norm(r.point - q), r.distance.upper) << i;
    }
  }
}

// Where weights differ much a curve runs many roundings of its points from one double parameter to the next: the
// nearest point has none.
TEST(ClosestPoint, BetweenDoubleParametersIsNotMissed) {
  const Bounding_arc_tree_2 steep(
      drawing_of(Bezier({{-1.1883422045501371, -1.1766401032320526},
                         {1.3850014277555007, -1.1204927810779788},
                         {1.1987784544293092, 1.1130865053456014}},
                        {2059.4130425011631, 0.0083851334895530313, 7.630794998503561e-05})));
  EXPECT_LE(ba::closest_point(steep, {1.162170547592964, 1.0653025254408934})->distance.lower, 1e-16);
  std::mt19937 random(9);
  std::uniform_real_distribution<double> unit(-1, 1);
  for (int i = 0; i < cases(400); ++i) {
    std::vector<Point> points;
    std::vector<double> weights;
    for (std::size_t n = 3 + random() % 2; n > 0; --n) {
      points.push_back({unit(random), unit(random)});
      weights.push_back(std::exp2(17 * unit(random)));
    }
    const Bezier curve(points, weights);
    std::reverse(points.begin(), points.end());
    std::reverse(weights.begin(), weights.end());
    const Bounding_arc_tree_2 backwards(drawing_of(Bezier(points, weights)));
    const ba::Bezier_evaluator evaluator(curve);
    for (int k = 0; k < 20; ++k) {
      const Point q = evaluator(std::exp2(-20 * std::fabs(unit(random)))).point;
      EXPECT_LE(ba::closest_point(backwards, q)->distance.lower, evaluator.point_error()) << i << ' ' << k;
    }
    if (HasFailure()) return;
  }
}

TEST(ClosestPoint, InACenterIsOneOfMany) {
  const Bounding_arc_tree_2 index(drawing_of(circle({1, 2}, 3)));
  const auto r = *ba::closest_point(index, {1, 2});
  EXPECT_LE(r.distance.lower, 3);
  EXPECT_GE(r.distance.upper, 3);
  EXPECT_LE(r.distance.upper - r.distance.lower, 4e-13);
  EXPECT_EQ(ba::closest_points(index, {1, 2}, 1e-9).size(), 1U);
  // half of it, and a line behind
  const std::vector<Bezier> whole = circle({0, 0}, 1);
  Drawing half;
  half.add(std::vector<Bezier>{whole[0], whole[1]});
  half.add(segment({-5, -1}, {5, -1}));
  const auto points = ba::closest_points(Bounding_arc_tree_2(half), {0, 0}, 1e-9);
  ASSERT_EQ(points.size(), 2U);
  for (const auto& p : points) EXPECT_NEAR(p.distance.lower, 1, 1e-13);
}

TEST(ClosestPoints, AreAllThatAreLocallyLeast) {
  // one on each side of a square, where joints are no further ones, and its corners from outside
  const std::vector<Point> c{{1, 1}, {-1, 1}, {-1, -1}, {1, -1}};
  std::vector<Bezier> chain;
  for (std::size_t i = 0; i < 4; ++i) chain.push_back(segment(c[i], c[(i + 1) % 4]));
  const Bounding_arc_tree_2 square(drawing_of(chain));
  EXPECT_EQ(ba::closest_points(square, {0, 0}, 1e-9).size(), 4U);
  EXPECT_EQ(ba::closest_points(square, {0.125, 0}, 0.01).size(), 1U);
  EXPECT_EQ(ba::closest_points(square, {0.125, 0}, 0.2).size(), 3U);
  EXPECT_EQ(ba::closest_points(square, {0.125, 0}, 10).size(), 4U);
  const auto corner = ba::closest_points(square, Point{2, 2}, 10);
  ASSERT_EQ(corner.size(), 1U);
  EXPECT_EQ(corner[0].point, c[0]);
  EXPECT_EQ(ba::closest_points(square, {3, 0.5}, 10).size(), 2U);
  // ends of an open curve
  const Bounding_arc_tree_2 line(drawing_of(segment({-1, 0}, {1, 0})));
  EXPECT_EQ(ba::closest_points(line, {5, 1}, 100).size(), 1U);
  // an ellipse from a point of its longer axis: two feet, and the end of the axis behind
  std::vector<Bezier> ellipse;
  for (const Bezier& b : circle({0, 0}, 1)) {
    std::vector<Point> p;
    for (const Point& q : b.control_points()) p.push_back({2 * q.x, q.y});
    ellipse.emplace_back(p, b.weights());
  }
  const Bounding_arc_tree_2 oval(drawing_of(ellipse));
  EXPECT_EQ(ba::closest_points(oval, {0.5, 0}, 0.1).size(), 2U);
  EXPECT_EQ(ba::closest_points(oval, {0.5, 0}, 1).size(), 2U);
  EXPECT_EQ(ba::closest_points(oval, {1.75, 0}, 1e-6).size(), 1U);
  EXPECT_EQ(ba::closest_points(oval, {0, 0}, 1e-6).size(), 2U);
}

// Newton's steps end within 2^-20 of the end of a piece, but nearer than that end, or a curve turns within as much.
TEST(ClosestPoints, AreThereNextToACut) {
  const auto expect_nearest_first = [](const Bezier& curve, const Point& q, double eps) {
    const Bounding_arc_tree_2 index(drawing_of(curve));
    const double nearest = ba::closest_point(index, q)->distance.upper;
    const auto points = ba::closest_points(index, q, eps);
    ASSERT_FALSE(points.empty());
    EXPECT_EQ(points.front().distance.upper, nearest);
  };
  const std::vector<double> weights{313.28220656688768, 0.5086536520832311, 1807.7734366193338};
  expect_nearest_first(Bezier({{1.5, 1.5}, {-1.5, 1}, {0, -1}}, weights), {-0.5, 1}, 1.5e-15);
  expect_nearest_first(Bezier({{-1.5, 1.5}, {-1.5, 1.5}, {1, 0.5}, {0.5, -0.5}, {-1.5, 1.5}},
                              {0.073650762873960759, 7.319341221811037e-05, 0.0031557024485378581, 0.25030853012386622,
                               1088.1889312298986}),
                       {-1.4999999995970996, 1.4999999993956494}, 1.5e-9);
}

// Minima of a sampled distance are as many, and those of a bundle of sorted places are at the places found.
TEST(ClosestPoints, AreAsManyAsSamplesHave) {
  std::mt19937 random(3);
  std::uniform_real_distribution<double> unit(-1, 1);
  constexpr int SAMPLES = 4000;
  std::size_t several = 0;
  for (int i = 0; i < cases(300); ++i) {
    const std::vector<Bezier> chain = closed_curve(random, {0, 0}, 3 + random() % 5);
    const Bounding_arc_tree_2 index(drawing_of(chain));
    const Point q{unit(random), unit(random)};
    const double tolerance = 0.5 * std::fabs(unit(random)) + 0.01;
    const auto found = ba::closest_points(index, q, tolerance);
    std::vector<double> distance;
    for (const Bezier& b : chain)
      for (int k = 0; k < SAMPLES; ++k) {
        const Point way = b.point(static_cast<double>(k) / SAMPLES) - q;
        distance.push_back(std::hypot(way.x, way.y));
      }
    const std::size_t n = distance.size();
    const double most = found.front().distance.upper + tolerance;
    std::size_t least = 0;
    bool is_clear = true;
    for (std::size_t k = 0; k < n; ++k) {
      const double before = distance[(k + n - 1) % n], after = distance[(k + 1) % n];
      if (!(distance[k] <= before && distance[k] < after)) continue;
      is_clear = is_clear && std::fabs(distance[k] - most) > 1e-4;
      least += distance[k] < most;
    }
    if (is_clear) {
      EXPECT_EQ(found.size(), least) << i;
    }
    several += found.size() > 1;
    EXPECT_TRUE(std::is_sorted(found.begin(), found.end(), [](const Closest_point<>& p, const Closest_point<>& r) {
      return p.distance.upper < r.distance.upper;
    }));
  }
  EXPECT_GT(several, static_cast<std::size_t>(cases(300)) / 20);
}

TEST(NearestCurves, AreThoseOfASortedScan) {
  std::mt19937 random(4);
  std::uniform_real_distribution<double> unit(-1, 1);
  for (int i = 0; i < cases(200); ++i) {
    Drawing drawing;
    std::vector<Bounding_arc_tree_2> single;
    const std::size_t count = 1 + random() % 40;
    for (std::size_t k = 0; k < count; ++k) {
      const Drawing one = moved(drawing_of(random_curve(random)), 0.3, {unit(random), unit(random)});
      drawing.add(one.curves()[0].beziers);
      single.emplace_back(one);
    }
    const Bounding_arc_tree_2 index(drawing);
    const Point q{unit(random), unit(random)};
    std::vector<double> distance;
    for (const Bounding_arc_tree_2& s : single) distance.push_back(ba::closest_point(s, q)->distance.upper);
    std::vector<double> sorted = distance;
    std::sort(sorted.begin(), sorted.end());
    for (const std::size_t k : {std::size_t(1), std::size_t(3), count, count + 5}) {
      const auto found = ba::k_nearest_curves(index, q, k);
      ASSERT_EQ(found.size(), (std::min)(k, count));
      for (std::size_t j = 0; j < found.size(); ++j) {
        EXPECT_NEAR(found[j].distance.upper, sorted[j], 1e-13);
        EXPECT_NEAR(found[j].distance.upper, distance[found[j].place.curve], 1e-13);
        EXPECT_LE(found[j].distance.lower, sorted[j]);
      }
    }
  }
  EXPECT_TRUE(ba::k_nearest_curves(Bounding_arc_tree_2(Drawing()), {0, 0}, 3).empty());
  EXPECT_TRUE(ba::k_nearest_curves(Bounding_arc_tree_2(drawing_of(segment({0, 0}, {1, 1}))), {0, 0}, 0).empty());
}

// Of so many pieces all over a square, each a little larger than its share of it.
TEST(ClosestPoint, LooksAtAsManyBoxesAsTheLogarithmOfTheNumberOfPieces) {
  std::vector<double> nodes;
  for (const std::size_t count : {100U, 1000U, 10000U, FEW_CASES ? 10000U : 100000U}) {
    std::mt19937 random(8);
    std::uniform_real_distribution<double> unit(-1, 1);
    Drawing drawing;
    const std::size_t columns = static_cast<std::size_t>(std::sqrt(static_cast<double>(count)));
    const double cell = 2.0 / static_cast<double>(columns);
    for (std::size_t i = 0; i < count; ++i) {
      const Point at{-1 + cell * static_cast<double>(i % columns), -1 + cell * static_cast<double>(i / columns)};
      std::vector<Point> points;
      for (int k = 0; k < 4; ++k) points.push_back(at + cell * Point{unit(random), unit(random)});
      drawing.add(Bezier(points));
    }
    const Bounding_arc_tree_2 index(drawing);
    std::size_t sum = 0;
    constexpr int POINTS = 200;
    for (int i = 0; i < POINTS; ++i) {
      ba::Closest_search search(index.in_unit(), {2 * unit(random), 2 * unit(random)}, HUGE_VAL);
      search.search();
      sum += search.nodes();
    }
    nodes.push_back(static_cast<double>(sum) / POINTS);
  }
  // each ten times as many pieces the tree is 1.7 levels higher
  for (std::size_t i = 1; i < nodes.size(); ++i) EXPECT_LE(nodes[i], nodes[i - 1] + 8) << i;
  EXPECT_LE(nodes.back(), 40);
}

template <class Tag> void expect_all_of(const Bounding_arc_tree_2& index, const std::vector<Point>& points) {
  const auto found = ba::closest_points_of_all<Tag>(index, points);
  const auto plain = ba::closest_points_of_all(index, points);
  ASSERT_EQ(found.size(), points.size());
  for (std::size_t i = 0; i < points.size(); ++i) {
    const Closest_point<> one = *ba::closest_point(index, points[i]);
    EXPECT_NEAR(found[i].distance.upper, one.distance.upper, 1e-14);
    EXPECT_LE(found[i].distance.lower, one.distance.upper);
    EXPECT_EQ(found[i].distance.upper, plain[i].distance.upper);
    EXPECT_EQ(found[i].distance.lower, plain[i].distance.lower);
    EXPECT_EQ(found[i].point, plain[i].point);
  }
}

TEST(ClosestPointsOfAll, AreThoseOfEach) {
  std::mt19937 random(5);
  std::uniform_real_distribution<double> unit(-1, 1);
  const Bounding_arc_tree_2 index(drawing_of(closed_curve(random, {0, 0}, 50)));
  for (const std::size_t count : {0U, 1U, 63U, 64U, 65U, 1000U}) {
    std::vector<Point> points;
    for (std::size_t i = 0; i < count; ++i)
      points.push_back(i % 2 == 0 ? Point{unit(random), unit(random)} : points.back() + Point{1e-3, 0});
    expect_all_of<CGAL::Sequential_tag>(index, points);
#ifdef CGAL_LINKED_WITH_TBB
    expect_all_of<CGAL::Parallel_tag>(index, points);
#endif
  }
  EXPECT_TRUE(ba::closest_points_of_all(Bounding_arc_tree_2(Drawing()), std::vector<Point>{{0, 0}}).empty());
}

TEST(ClosestPoint, RefusesNumbersThatAreNone) {
  const Bounding_arc_tree_2 index(drawing_of(segment({0, 0}, {1, 0}))), none{Drawing()};
  const double nan = std::numeric_limits<double>::quiet_NaN();
  for (const Point& q : {Point{nan, 0}, Point{0, HUGE_VAL}, Point{-HUGE_VAL, nan}}) {
    EXPECT_THROW((void)ba::closest_point(index, q), std::invalid_argument);
    EXPECT_THROW((void)ba::closest_point(none, q), std::invalid_argument);
    EXPECT_THROW((void)ba::closest_points(index, q, 1), std::invalid_argument);
    EXPECT_THROW((void)ba::k_nearest_curves(index, q, 1), std::invalid_argument);
    EXPECT_THROW((void)ba::closest_points_of_all(index, std::vector<Point>{{0, 0}, q}), std::invalid_argument);
  }
  for (const double tolerance : {0.0, -1.0, nan, HUGE_VAL})
    EXPECT_THROW((void)ba::closest_points(index, {0, 0}, tolerance), std::invalid_argument);
  EXPECT_FALSE(ba::closest_point(none, {0, 0}));
  EXPECT_TRUE(ba::closest_points(none, {0, 0}, 1).empty());
}

}  // namespace
}  // namespace test_closest_point
