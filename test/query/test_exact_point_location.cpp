// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// One piece with itself, the parameters of a point on a piece, and crossings of a ray.

#include "cases.h"
#include "exact_curves.h"
#include "ray_crossings.h"

#include <cmath>

namespace test_exact_point_location {
namespace {

using namespace bounding_arcs_test;

std::vector<Bracket> parameters_at(const Curve& c, const Point& p) {
  std::vector<Bracket> at;
  for (Real_root& t : exact_roots_at(Integer_piece(c), p)) at.push_back(t.range());
  return at;
}

TEST(ExactSelfIntersections, AreOneOfALoopOrClosedPieceAndNoneOfACusp) {
  const Curve loop = parametric({-1, 0, 1}, {0, -1, 0, 1}, -2, 2);
  expect_one(exact_self_intersections(loop), ratio(1, 4), ratio(3, 4), TRANSVERSAL);
  expect_one(exact_self_intersections(elevated(elevated(loop))), ratio(1, 4), ratio(3, 4), TRANSVERSAL);
  expect_one(exact_self_intersections(parametric({-1, 0, 1}, {0, -1, 0, 1}, -1, 1)), 0, 1, TRANSVERSAL);
  EXPECT_TRUE(exact_self_intersections(parametric({-1, 0, 1}, {0, -1, 0, 1}, -1, ratio(99, 100))).points.empty());
  EXPECT_TRUE(exact_self_intersections(parametric({0, 0, 1}, {0, 0, 0, 1}, -1, 1)).points.empty());  // a cusp
  const Rational small = Rational(0x1p-25);  // a loop with parameters 2^-24 apart
  const Piece_intersections tiny =
      exact_self_intersections(parametric({0, 0, 1}, {0, Rational(-small * small), 0, 1}, -1, 1));
  expect_one(tiny, (1 - small) / 2, (1 + small) / 2, TRANSVERSAL);
  EXPECT_TRUE(exact_self_intersections(segment({0, 0}, {1, 1})).points.empty());
  EXPECT_TRUE(exact_self_intersections(curve({{0, 0}, {1, 2}, {3, 1}})).points.empty());
  // A closed quarter with a weight of its own, in rationals.
  expect_one(exact_self_intersections(curve({{0, 0}, {3, 2}, {-2, 2}, {0, 0}}, {1, 2, 3, 1})), 0, 1, TRANSVERSAL);
}

TEST(ExactSelfIntersections, TouchOfItselfIsTangential) {
  // x = u^2, y = u (u^2 - 1)^2: at u = -1 and 1 both directions are (2 u, 0).
  const Piece_intersections found = exact_self_intersections(parametric({0, 0, 1}, {0, 1, 0, -2, 0, 1}, -2, 2));
  expect_one(found, ratio(1, 4), ratio(3, 4), TANGENTIAL);
}

TEST(ExactSelfIntersections, TriplePointIsThreePairs) {
  // Both coordinates vanish at u = -1, 0 and 1.
  const Curve triple = parametric({0, -1, 0, 1}, {0, 0, -1, 0, 1}, -2, 2);
  const Piece_intersections found = exact_self_intersections(triple);
  EXPECT_EQ(count_at(found, ratio(1, 4), ratio(1, 2)), 1);
  EXPECT_EQ(count_at(found, ratio(1, 4), ratio(3, 4)), 1);
  EXPECT_EQ(count_at(found, ratio(1, 2), ratio(3, 4)), 1);
  const std::vector<Bracket> at = parameters_at(triple, Point{0, 0});
  ASSERT_EQ(at.size(), 3u);
  for (int i = 0; i < 3; ++i) EXPECT_EQ(at[static_cast<std::size_t>(i)].lower, 0.25 * (i + 1));
}

TEST(ExactParameters, AreAllFoundExactly) {
  const Curve a = curve({{0, 0}, {1, 3}, {2, -1}, {4, 1}}, {1, 2, 1, 3});
  for (const int i : {0, 1, 3, 7, 10}) {
    const std::vector<Bracket> at = parameters_at(a, a.point(ratio(i, 10)));
    ASSERT_EQ(at.size(), 1u) << i;
    EXPECT_TRUE(holds(at[0], ratio(i, 10)));
    EXPECT_EQ(at[0].lower == at[0].upper, i % 10 == 0);
  }
  const Point on = a.point(ratio(1, 3)), beside{on.x, Rational(on.y + Rational(0x1p-60))};
  EXPECT_TRUE(parameters_at(a, beside).empty());
  EXPECT_EQ(parameters_at(curve({{0, 0}, {1, 0}, {0, 0}}), Point{ratio(1, 4), 0}).size(), 2u);
}

Ray_crossings sum(const std::vector<Curve>& chain, const Point& q) {
  Ray_crossings r;
  for (const Curve& c : chain) {
    const Ray_crossings one = exact_ray_crossings(c, q);
    r.winding += one.winding;
    r.is_on = r.is_on || one.is_on;
  }
  return r;
}

TEST(ExactRayCrossings, WindOnceAroundACircleOfQuarters) {
  std::vector<Curve> circle;
  for (int i = 0; i < 4; ++i) circle.push_back(quarter({0, 0}, 1, i));
  const Rational gap = Rational(0x1p-60);
  for (const Point& q : {Point{0, 0}, Point{Rational(gap - 1), 0}, Point{Rational(1 - gap), 0}, Point{0, ratio(1, 2)},
                         Point{0, Rational(gap - 1)}, Point{0, Rational(1 - gap)}})
    EXPECT_TRUE(sum(circle, q).winding == 1 && !sum(circle, q).is_on) << q.x << " " << q.y;
  for (const Point& q : {Point{-2, 0}, Point{2, 0}, Point{-2, 1}, Point{-2, -1}, Point{Rational(-1 - gap), 0},
                         Point{0, Rational(1 + gap)}, Point{-1, Rational(-1 - gap)}})
    EXPECT_TRUE(sum(circle, q).winding == 0 && !sum(circle, q).is_on) << q.x << " " << q.y;
  for (const Point& q : {Point{1, 0}, Point{0, 1}, Point{-1, 0}, Point{0, -1}, Point{ratio(3, 5), ratio(4, 5)}})
    EXPECT_TRUE(sum(circle, q).is_on) << q.x << " " << q.y;
}

TEST(ExactRayCrossings, LevelPiecesAndTouchesCount) {
  // A square with sides on the ray, and one with dents that touch it from above and below.
  const std::vector<Curve> square{segment({0, 0}, {1, 0}), segment({1, 0}, {1, 1}), segment({1, 1}, {0, 1}),
                                  segment({0, 1}, {0, 0})};
  EXPECT_EQ(sum(square, {-1, 0}).winding, 0);
  EXPECT_EQ(sum(square, {-1, 1}).winding, 0);
  EXPECT_EQ(sum(square, {ratio(1, 2), ratio(1, 2)}).winding, 1);
  EXPECT_TRUE(sum(square, {ratio(1, 2), 1}).is_on && sum(square, {ratio(1, 2), 0}).is_on);
  for (const int side : {1, -1}) {
    const std::vector<Curve> closed{segment({-2, -3}, {2, -3}), segment({2, -3}, {1, side}),
                                    parametric({0, -1}, {0, 0, side}, -1, 1), segment({-1, side}, {-2, -3})};
    EXPECT_EQ(sum(closed, {ratio(-1, 2), 0}).winding, side > 0 ? 1 : 0) << side;
    EXPECT_EQ(sum(closed, {-9, 0}).winding, 0) << side;
    EXPECT_TRUE(sum(closed, {0, 0}).is_on) << side;
  }
}

// The angle that the curve turns around q, sampled.
int sampled_winding(const std::vector<Curve>& chain, const Point& q) {
  double angle = 0;
  for (const Curve& c : chain) {
    std::vector<Xy<double>> p;
    for (const Point& x : c.control_points()) p.push_back({CGAL::to_double(x.x - q.x), CGAL::to_double(x.y - q.y)});
    const Bezier_curve_2<double> d(p);
    constexpr int STEPS = 2000;
    for (int i = 0; i < STEPS; ++i) {
      const auto from = d.point(i / double(STEPS)), to = d.point((i + 1) / double(STEPS));
      angle += std::atan2(cross(from, to), dot(from, to));
    }
  }
  return static_cast<int>(std::lround(angle / (2 * std::acos(-1.0))));
}

TEST(ExactRayCrossings, RandomChainsOfCubicsWindAsTheirAngleDoes) {
  std::mt19937 random(6);
  std::uniform_int_distribution<int> number(-6, 6);
  int inside = 0;
  for (int i = 0; i < cases(40); ++i) {
    std::vector<Curve> chain;
    for (int k = 0; k < 3; ++k) chain.push_back(random_curve(random, 3, 6));
    for (std::size_t k = 0; k < 3; ++k) {
      std::vector<Point> p = chain[k].control_points();
      p.back() = chain[(k + 1) % 3].control_points().front();
      chain[k] = Curve(p);
    }
    for (int k = 0; k < 10; ++k) {
      const Point q{ratio(number(random), 2), Rational(number(random))};
      const Ray_crossings r = sum(chain, q);
      if (r.is_on) continue;
      EXPECT_EQ(r.winding, sampled_winding(chain, q)) << i << " " << q.x << " " << q.y;
      inside += r.winding != 0 ? 1 : 0;
    }
  }
  EXPECT_GT(inside, 10);
}

}  // namespace
}  // namespace test_exact_point_location
