// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Isolated common points of two pieces: cases with known answers, and random ones against plain subdivision.

#include "cases.h"
#include "exact_curves.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace test_exact_intersections {
namespace {

using namespace bounding_arcs_test;

const Curve axis = segment({-1, 0}, {1, 0});

Powers power(int n) {
  Powers p(static_cast<std::size_t>(n) + 1, Rational(0));
  p.back() = 1;
  return p;
}

bool meet(const Bracket& p, const Bracket& q) { return p.lower <= q.upper && q.lower <= p.upper; }

TEST(ExactIntersections, TouchOfEveryOrderIsOnePoint) {
  for (int n = 2; n <= 9; ++n) {
    SCOPED_TRACE(n);
    expect_one(exact_intersections(graph(power(n)), axis), ratio(1, 2), ratio(1, 2), TANGENTIAL);
    expect_one(exact_intersections(axis, graph(power(n))), ratio(1, 2), ratio(1, 2), TANGENTIAL);
  }
}

TEST(ExactIntersections, ContactOfAChosenOrderIsFoundWithOtherPoints) {
  std::mt19937 random(1);
  for (int degree = 2; degree <= 6; ++degree)
    for (int order = 1; order <= degree; ++order) {
      const Curve a = random_curve(random, degree, 9);
      // (t - 1/3)^order (1, 2) is added.
      Bernstein_polynomial<Rational> p(Powers{1});
      for (int i = 0; i < order; ++i) p = p * Bernstein_polynomial<Rational>(Powers{ratio(-1, 3), ratio(2, 3)});
      const auto apart = p.elevated(degree);
      std::vector<Point> points = a.control_points();
      for (int i = 0; i <= degree; ++i)
        points[static_cast<std::size_t>(i)] =
            points[static_cast<std::size_t>(i)] + apart.coefficient(i) * Point{Rational(1), Rational(2)};
      const Piece_intersections found = exact_intersections(a, Curve(points));
      ASSERT_EQ(count_at(found, ratio(1, 3), ratio(1, 3)), 1) << degree << " " << order;
      for (const Piece_intersections::Intersection& x : found.points) {
        if (!holds(x.a, ratio(1, 3)) || !holds(x.b, ratio(1, 3))) continue;
        EXPECT_EQ(x.kind, order == 1 ? TRANSVERSAL : TANGENTIAL) << degree << " " << order;
      }
    }
}

TEST(ExactIntersections, NearTouchIsNoneOrTwo) {
  for (const int bits : {20, 30, 50, 100}) {
    SCOPED_TRACE(bits);
    const Rational gap = Rational(std::ldexp(1.0, -bits)), x = Rational(std::ldexp(1.0, -bits / 2));
    const Curve parabola = graph({0, 0, 1});
    EXPECT_TRUE(exact_intersections(parabola, segment({-1, -gap}, {1, -gap})).points.empty());
    const Piece_intersections two = exact_intersections(parabola, segment({-1, gap}, {1, gap}));
    ASSERT_EQ(two.points.size(), 2u);
    EXPECT_EQ(count_at(two, (1 - x) / 2, (1 - x) / 2), 1);
    EXPECT_EQ(count_at(two, (1 + x) / 2, (1 + x) / 2), 1);
    EXPECT_EQ(two.points[0].kind, TRANSVERSAL);
    EXPECT_LE(two.points[0].a.upper, two.points[1].a.lower);
  }
}

TEST(ExactIntersections, NearTouchOfHigherOrderIsNoneOrTwo) {
  const Rational gap = Rational(0x1p-40), x = Rational(0x1p-10);
  const Curve quartic = graph({0, 0, 0, 0, 1});
  EXPECT_TRUE(exact_intersections(quartic, segment({-1, -gap}, {1, -gap})).points.empty());
  const Piece_intersections two = exact_intersections(quartic, segment({-1, gap}, {1, gap}));
  EXPECT_EQ(two.points.size(), 2u);
  EXPECT_EQ(count_at(two, (1 - x) / 2, (1 - x) / 2) + count_at(two, (1 + x) / 2, (1 + x) / 2), 2);
}

TEST(ExactIntersections, GapAtAnEndIsSeen) {
  const Rational gap = Rational(0x1p-50);
  const Curve arc = quarter({0, 0}, 1, 0);
  EXPECT_TRUE(exact_intersections(arc, segment({1 + gap, -1}, {1 + gap, 1})).points.empty());
  EXPECT_TRUE(exact_intersections(arc, segment({Rational(1 - gap), -1}, {Rational(1 - gap), 0})).points.empty());
  expect_one(exact_intersections(arc, segment({1, -1}, {1, 1})), 0, ratio(1, 2), TANGENTIAL);
  const Rational end = 1 - Rational(1e-14);
  EXPECT_TRUE(exact_intersections(segment({0, 0}, {end, 0}), segment({1, -1}, {1, 1})).points.empty());
  expect_one(exact_intersections(segment({0, 0}, {1, 0}), segment({1, -1}, {1, 1})), 1, ratio(1, 2), TRANSVERSAL);
}

TEST(ExactIntersections, StraightCubicThroughACuspIsOnePoint) {
  const Curve cusp = parametric({0, 0, 1}, {0, 0, 0, 1}, -1, 1);
  const Curve vertical = curve({{0, -1}, {0, ratio(-1, 4)}, {0, ratio(1, 4)}, {0, 1}});
  expect_one(exact_intersections(cusp, vertical), ratio(1, 2), ratio(1, 2), TANGENTIAL);
  expect_one(exact_intersections(vertical, cusp), ratio(1, 2), ratio(1, 2), TANGENTIAL);
  // Nor is there another one between two cusps at one point.
  expect_one(exact_intersections(cusp, parametric({0, 0, 1}, {0, 0, 0, -3}, -1, 1)), ratio(1, 2), ratio(1, 2),
             TANGENTIAL);
  // A straight piece that comes to rest on the other one without turning has no tangent there.
  expect_one(exact_intersections(parametric({0, 0, 0, 1}, {0, 0, 0, 2}, -1, 1), axis), ratio(1, 2), ratio(1, 2),
             TANGENTIAL);
}

TEST(ExactIntersections, CommonEndsAreExact) {
  std::mt19937 random(2);
  for (int i = 0; i < cases(20); ++i) {
    const Curve a = random_curve(random, 3, 9), b = random_curve(random, 3, 9);
    std::vector<Point> points = b.control_points();
    for (const bool is_first : {true, false}) {
      const Point moved_by = a.control_points().back() - (is_first ? points.front() : points.back());
      std::vector<Point> moved;
      for (const Point& p : points) moved.push_back(p + moved_by);
      const Piece_intersections found = exact_intersections(a, Curve(moved));
      const double end = is_first ? 0 : 1;
      int exact = 0;
      for (const Piece_intersections::Intersection& x : found.points)
        exact += x.a.lower == 1 && x.b.lower == end && x.b.upper == end ? 1 : 0;
      EXPECT_EQ(exact, 1);
    }
  }
}

TEST(ExactIntersections, CirclesTouchInsideAndOutsideAndConcentricOnesDoNot) {
  const Curve unit = quarter({0, 0}, 1, 0);
  const Piece_intersections inside = exact_intersections(unit, quarter({ratio(3, 10), ratio(4, 10)}, ratio(1, 2), 0));
  ASSERT_EQ(inside.points.size(), 1u);
  EXPECT_EQ(inside.points[0].kind, TANGENTIAL);
  EXPECT_EQ(inside.points[0].a.lower, inside.points[0].b.lower);
  const Piece_intersections outside = exact_intersections(unit, quarter({ratio(9, 10), ratio(12, 10)}, ratio(1, 2), 2));
  ASSERT_EQ(outside.points.size(), 1u);
  EXPECT_EQ(outside.points[0].kind, TANGENTIAL);
  EXPECT_TRUE(exact_intersections(unit, quarter({0, 0}, Rational(1 - Rational(0x1p-50)), 0)).points.empty());
  const Curve near = quarter({ratio(9, 10) + Rational(0x1p-50), ratio(12, 10)}, ratio(1, 2), 2);
  EXPECT_TRUE(exact_intersections(unit, near).points.empty());
  // The circle of curvature at a parabola's vertex, a touch of order four at the end of both quarters.
  const Curve parabola = graph({0, 0, 1});
  expect_one(exact_intersections(parabola, quarter({0, ratio(1, 2)}, ratio(1, 2), 2)), ratio(1, 2), 1, TANGENTIAL);
  expect_one(exact_intersections(parabola, quarter({0, ratio(1, 2)}, ratio(1, 2), 3)), ratio(1, 2), 0, TANGENTIAL);
}

TEST(ExactIntersections, AreCountedAtInflectionsAndDoublePoints) {
  const Curve wave = graph({0, 0, 0, 1});
  expect_one(exact_intersections(wave, segment({-1, 1}, {1, -1})), ratio(1, 2), ratio(1, 2), TRANSVERSAL);
  EXPECT_EQ(exact_intersections(wave, segment({-1, -1}, {1, 1})).points.size(), 3u);
  const Curve loop = parametric({-1, 0, 1}, {0, -1, 0, 1}, -2, 2);
  for (const Curve& line :
       {segment({-2, 2}, {1, -1}), curve({{-2, 2}, {0, 0}, {ratio(1, 2), ratio(-1, 2)}, {1, -1}})}) {
    const Piece_intersections ab = exact_intersections(loop, line), ba = exact_intersections(line, loop);
    // y = -x is a tangent of the branch at u = -1.
    ASSERT_EQ(ab.points.size(), 2u);
    ASSERT_EQ(ba.points.size(), 2u);
    EXPECT_TRUE(holds(ab.points[0].a, ratio(1, 4)) && holds(ab.points[1].a, ratio(3, 4)));
    for (int i = 0; i < 2; ++i) {
      const auto k = static_cast<std::size_t>(i);
      EXPECT_EQ(ab.points[k].kind, i == 0 ? TANGENTIAL : TRANSVERSAL);
      EXPECT_EQ(ba.points[k].kind, i == 0 ? TANGENTIAL : TRANSVERSAL);
      EXPECT_TRUE(meet(ba.points[k].b, ab.points[k].a) && meet(ba.points[k].a, ab.points[k].b));
    }
  }
  // Two loops with a common double point, four pairs, and a touch.
  const Curve other = parametric({-1, 0, 1}, {0, -3, 0, 3}, -2, 2);
  const Piece_intersections four = exact_intersections(loop, other);
  EXPECT_EQ(four.points.size(), 5u);
  EXPECT_EQ(count_at(four, ratio(1, 2), ratio(1, 2)), 1);
  for (const int i : {1, 3})
    for (const int j : {1, 3}) EXPECT_EQ(count_at(four, ratio(i, 4), ratio(j, 4)), 1);
}

TEST(ExactIntersections, WeightsOfAllSizesMoveNoPoint) {
  const Rational huge = Rational(0x1p200);
  const Curve line = curve({{-1, 0}, {0, 0}, {1, 0}}, {1, huge, 1 / huge});
  const Piece_intersections found = exact_intersections(graph({ratio(-1, 4), 0, 1}), line);
  ASSERT_EQ(found.points.size(), 2u);
  for (const Piece_intersections::Intersection& p : found.points) EXPECT_EQ(p.kind, TRANSVERSAL);
  EXPECT_TRUE(holds(found.points[0].a, ratio(1, 4)));
  EXPECT_TRUE(holds(found.points[1].a, ratio(3, 4)));
  EXPECT_GT(found.points[1].b.upper, 1 - 0x1p-50);
  EXPECT_LT(found.points[0].b.lower, 0x1p-150);
  EXPECT_GT(found.points[0].b.upper, 0x1p-250);
}

// Pairs of parts whose boxes meet, halved until they are small; as grid cells of parameters.
struct Subdivision {
  static constexpr int DEPTH = 18;
  std::vector<std::pair<double, double>> left;
  void run(const Bezier_curve_2<double>& a, const Bezier_curve_2<double>& b, double t, double s, int depth) {
    if (!meet(a, b)) return;
    if (depth == DEPTH) {
      left.emplace_back(t, s);
      return;
    }
    const auto [a0, a1] = a.split(0.5);
    const auto [b0, b1] = b.split(0.5);
    const double half = std::ldexp(1.0, -depth - 1);
    run(a0, b0, t, s, depth + 1), run(a0, b1, t, s + half, depth + 1);
    run(a1, b0, t + half, s, depth + 1), run(a1, b1, t + half, s + half, depth + 1);
  }
  static bool meet(const Bezier_curve_2<double>& a, const Bezier_curve_2<double>& b) {
    const auto apart = [&](auto coordinate) {
      double a0 = 1e9, a1 = -1e9, b0 = 1e9, b1 = -1e9;
      for (const auto& p : a.control_points()) a0 = std::min(a0, coordinate(p)), a1 = std::max(a1, coordinate(p));
      for (const auto& p : b.control_points()) b0 = std::min(b0, coordinate(p)), b1 = std::max(b1, coordinate(p));
      return a1 < b0 || b1 < a0;
    };
    return !apart([](const auto& p) { return p.x; }) && !apart([](const auto& p) { return p.y; });
  }
};

Bezier_curve_2<double> in_doubles(const Curve& c) {
  std::vector<Xy<double>> p;
  for (const Point& q : c.control_points()) p.push_back({CGAL::to_double(q.x), CGAL::to_double(q.y)});
  return Bezier_curve_2<double>(p);
}

// Dyadic halves of small integers are exact in doubles for so few levels, so that no point is lost.
TEST(ExactIntersections, RandomCubicsHaveThePointsThatSubdivisionFinds) {
  std::mt19937 random(3);
  // Where tangents are parallel, boxes meet for a long way.
  const auto tolerance = [](const Piece_intersections::Intersection& p) {
    return p.kind == TANGENTIAL ? 0x1p-5 : 0x1p-12;
  };
  std::size_t all = 0;
  for (int i = 0; i < cases(600); ++i) {
    const Curve a = random_curve(random, 3, 3 + i % 4), b = random_curve(random, i % 2 == 0 ? 3 : 2, 3);
    const Piece_intersections found = exact_intersections(a, b);
    if (!found.overlaps.empty()) continue;
    Subdivision cells;
    cells.run(in_doubles(a), in_doubles(b), 0, 0, 0);
    const auto is_near = [&](const Piece_intersections::Intersection& p, const std::pair<double, double>& c) {
      const double near = tolerance(p);
      return std::abs(p.a.lower - c.first) < near && std::abs(p.b.lower - c.second) < near;
    };
    all += found.points.size();
    for (const Piece_intersections::Intersection& p : found.points)
      EXPECT_TRUE(std::any_of(cells.left.begin(), cells.left.end(), [&](const auto& c) { return is_near(p, c); })) << i;
    for (const auto& c : cells.left)
      EXPECT_TRUE(std::any_of(found.points.begin(), found.points.end(), [&](const auto& p) { return is_near(p, c); }))
          << i << " at " << c.first << " " << c.second;
    for (std::size_t k = 1; k < found.points.size(); ++k) {
      const auto &p = found.points[k - 1], &q = found.points[k];
      EXPECT_TRUE(p.a.lower != q.a.lower || p.b.lower != q.b.lower) << i;
    }
  }
  EXPECT_GT(all, 100u);
}

TEST(ExactIntersections, ChosenPointIsFoundInEveryDegree) {
  std::mt19937 random(4);
  for (int m = 1; m <= 7; ++m)
    for (int n = 1; n <= 7; n += m < 5 ? 1 : 2) {
      const Curve a = random_curve(random, m, 9), b = random_curve(random, n, 9);
      const Rational t = ratio(1, 3), s = ratio(5, 8);
      std::vector<Point> moved;
      for (const Point& p : b.control_points()) moved.push_back(p + a.point(t) - b.point(s));
      const Piece_intersections found = exact_intersections(a, Curve(moved)),
                                swapped = exact_intersections(Curve(moved), a);
      EXPECT_EQ(count_at(found, t, s), 1) << m << " " << n;
      EXPECT_EQ(swapped.points.size(), found.points.size()) << m << " " << n;
      for (const Piece_intersections::Intersection& p : found.points) {
        const auto x = in_doubles(a).point(p.a.lower), y = in_doubles(Curve(moved)).point(p.b.lower);
        EXPECT_NEAR(x.x, y.x, 1e-12);
        EXPECT_NEAR(x.y, y.y, 1e-12);
        EXPECT_TRUE(p.a.lower == p.a.upper || std::nextafter(std::nextafter(p.a.lower, 2.0), 2.0) >= p.a.upper);
      }
    }
}

}  // namespace
}  // namespace test_exact_intersections
