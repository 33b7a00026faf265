// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Pieces that run together: the same ones, parts of them, other parameters, back and forth, several times.

#include "exact_curves.h"

#include <algorithm>

namespace test_exact_overlaps {
namespace {

using namespace bounding_arcs_test;

std::vector<Curve> pieces() {
  std::mt19937 random(5);
  std::vector<Curve> r{quarter({1, 2}, 3, 1), segment({1, 2}, {4, -2}), graph({0, 0, 0, 1})};
  for (int degree = 2; degree <= 5; ++degree) r.push_back(random_curve(random, degree, 20));
  r.push_back(curve({{0, 0}, {1, 2}, {3, 1}, {4, 0}}, {1, ratio(1, 3), 2, 1}));
  return r;
}

// Other points beside the overlap are pairs at a loop.
void expect_one_overlap(const Piece_intersections& found, const Rational& a0, const Rational& a1, const Rational& b0,
                        const Rational& b1) {
  ASSERT_EQ(found.overlaps.size(), 1u);
  EXPECT_TRUE(is_overlap(found.overlaps[0], a0, a1, b0, b1));
}

TEST(ExactOverlaps, AreFoundOfTheSameReversedElevatedAndSharedParts) {
  for (const Curve& c : pieces()) {
    SCOPED_TRACE(c.degree());
    expect_one_overlap(exact_intersections(c, c), 0, 1, 0, 1);
    expect_one_overlap(exact_intersections(c, c.reversed()), 0, 1, 1, 0);
    expect_one_overlap(exact_intersections(c, elevated(elevated(c))), 0, 1, 0, 1);
    expect_one_overlap(exact_intersections(elevated(c), c.reversed()), 0, 1, 1, 0);
    if (c.is_rational()) continue;
    const Curve head = c.subcurve(0, ratio(2, 3)), tail = c.subcurve(ratio(1, 3), 1);
    expect_one_overlap(exact_intersections(head, tail), ratio(1, 2), 1, 0, ratio(1, 2));
    expect_one_overlap(exact_intersections(c, tail.reversed()), ratio(1, 3), 1, 1, 0);
  }
}

TEST(ExactOverlaps, AreFoundForOtherWeightsOfTheSameCurve) {
  const Curve a = quarter({0, 0}, 1, 0), b = curve({{1, 0}, {1, 1}, {0, 1}}, {1, 3, 18});  // times 1, 3, 9
  expect_overlap(exact_intersections(a, b), 0, 1, 0, 1);
  const Curve line = segment({0, 0}, {1, 3});
  expect_overlap(exact_intersections(line, curve({{0, 0}, {1, 3}}, {1, 5})), 0, 1, 0, 1);
  expect_overlap(exact_intersections(line, elevated(curve({{1, 3}, {0, 0}}, {1, 5}))), 0, 1, 1, 0);
}

TEST(ExactOverlaps, NeighboursOnOneCurveShareAPoint) {
  for (const Curve& c : pieces()) {
    const auto [head, tail] = c.split(ratio(1, 4));
    const Piece_intersections found = exact_intersections(head, tail);
    EXPECT_EQ(found.overlaps.size(), 0u);
    EXPECT_EQ(count_at(found, 1, 0), 1);
    const auto gap = c.split(ratio(1, 4) + Rational(0x1p-50));
    const Piece_intersections apart = exact_intersections(head, gap.second);
    EXPECT_EQ(apart.overlaps.size(), 0u);
    EXPECT_EQ(count_at(apart, 1, 0), 0);
    EXPECT_EQ(exact_intersections(gap.first, tail).overlaps.size(), 1u);
  }
  expect_one(exact_intersections(quarter({0, 0}, 1, 0), quarter({0, 0}, 1, 1)), 1, 0, TANGENTIAL);
  EXPECT_TRUE(exact_intersections(quarter({0, 0}, 1, 0), quarter({0, 0}, 1, 2)).points.empty());
}

TEST(ExactOverlaps, LoopMeetsItselfBesideTheOverlap) {
  const Curve loop = parametric({-1, 0, 1}, {0, -1, 0, 1}, -2, 2);
  const Piece_intersections found = exact_intersections(loop, loop);
  expect_one_overlap(found, 0, 1, 0, 1);
  EXPECT_EQ(found.points.size(), 2u);
  EXPECT_EQ(count_at(found, ratio(1, 4), ratio(3, 4)), 1);
  EXPECT_EQ(count_at(found, ratio(3, 4), ratio(1, 4)), 1);
  for (const Piece_intersections::Intersection& p : found.points) EXPECT_EQ(p.kind, TRANSVERSAL);
  // A cusp is on the overlap, twice.
  expect_overlap(
      exact_intersections(parametric({0, 0, 1}, {0, 0, 0, 1}, -1, 1), parametric({0, 0, 1}, {0, 0, 0, 1}, 1, -1)), 0, 1,
      1, 0);
}

// y = x^2 with x = 4 u (1 - u), which goes from 0 to 1 and back.
TEST(ExactOverlaps, AreTwoWhereACurveIsTracedThereAndBack) {
  const Curve twice = parametric({0, 4, -4}, {0, 0, 16, -32, 16}, 0, 1);
  const Curve once = parametric({0, 1}, {0, 0, 1}, ratio(1, 2), 2);
  const Piece_intersections found = exact_intersections(twice, once);
  EXPECT_EQ(found.points.size(), 0u);
  ASSERT_EQ(found.overlaps.size(), 2u);
  EXPECT_EQ(found.overlaps[0].b_from.lower, 0);
  EXPECT_TRUE(holds(found.overlaps[0].b_to, ratio(1, 3)));
  EXPECT_EQ(found.overlaps[0].a_to.lower, 0.5);
  EXPECT_NEAR(found.overlaps[0].a_from.lower, (1 - std::sqrt(0.5)) / 2, 1e-15);
  EXPECT_EQ(found.overlaps[1].a_from.lower, 0.5);
  EXPECT_EQ(found.overlaps[1].b_to.lower, 0);
  EXPECT_EQ(exact_intersections(twice, twice).overlaps.size(), 4u);
  const Piece_intersections self = exact_self_intersections(twice);
  expect_overlap(self, 0, ratio(1, 2), 1, ratio(1, 2));
  // It turns back at the other curve's end: one parameter there.
  expect_one(exact_intersections(twice, parametric({0, 1}, {0, 0, 1}, 1, 2)), ratio(1, 2), 0, TANGENTIAL);
}

TEST(ExactOverlaps, AreAsManyAsAStraightPieceGoesBackAndForth) {
  const Curve zigzag = curve({{0, 0}, {3, 3}, {-2, -2}, {1, 1}}), line = segment({-1, -1}, {1, 1});
  const Piece_intersections found = exact_intersections(zigzag, line);
  EXPECT_EQ(found.points.size(), 0u);
  ASSERT_EQ(found.overlaps.size(), 3u);
  EXPECT_TRUE(is_overlap(found.overlaps[0], 0, ratio(1, 4), ratio(1, 2), 1));
  EXPECT_TRUE(is_overlap(found.overlaps[1], ratio(1, 4), ratio(3, 4), 1, ratio(1, 2)));
  EXPECT_TRUE(is_overlap(found.overlaps[2], ratio(3, 4), 1, ratio(1, 2), 1));
  EXPECT_EQ(exact_intersections(zigzag, zigzag).overlaps.size(), 9u);
  EXPECT_EQ(exact_self_intersections(zigzag).overlaps.size(), 3u);
  // A line that ends at the turn, and one beyond it.
  const Piece_intersections at_turn = exact_intersections(zigzag, segment({1, 1}, {2, 2}));
  EXPECT_EQ(at_turn.overlaps.size(), 0u);
  ASSERT_EQ(at_turn.points.size(), 2u);
  EXPECT_EQ(count_at(at_turn, ratio(1, 4), 0), 1);
  EXPECT_EQ(count_at(at_turn, 1, 0), 1);
  EXPECT_TRUE(
      exact_intersections(zigzag, segment({Rational(1 + Rational(0x1p-50)), Rational(1 + Rational(0x1p-50))}, {2, 2}))
          .points.empty());
  // A piece that rests without turning is one overlap.
  expect_overlap(exact_intersections(curve({{0, 0}, {1, 0}, {0, 0}, {1, 0}}), segment({0, 0}, {1, 0})), 0, 1, 0, 1);
}

// u in [-3, 3] of ((1 - u^2, 2 u) / (1 + u^2)), 286 degrees; in degree 12 all weights are positive.
Curve long_arc(const Rational& sign) { return parametric({sign, 0, -sign}, {0, 2 * sign}, -3, 3, {1, 0, 1}, 12); }

TEST(ExactOverlaps, LongArcsOfACircleRunTogetherOnBothSides) {
  const Curve right = long_arc(1), left = long_arc(-1);
  const Piece_intersections found = exact_intersections(right, left);
  EXPECT_EQ(found.points.size(), 0u);
  ASSERT_EQ(found.overlaps.size(), 2u);
  // Half a turn takes u to -1/u.
  EXPECT_TRUE(is_overlap(found.overlaps[0], 0, ratio(4, 9), ratio(5, 9), 1));
  EXPECT_TRUE(is_overlap(found.overlaps[1], ratio(5, 9), 1, 0, ratio(4, 9)));
  const Piece_intersections reversed = exact_intersections(right, left.reversed());
  ASSERT_EQ(reversed.overlaps.size(), 2u);
  EXPECT_TRUE(is_overlap(reversed.overlaps[0], 0, ratio(4, 9), ratio(4, 9), 0));
  EXPECT_TRUE(is_overlap(reversed.overlaps[1], ratio(5, 9), 1, 1, ratio(5, 9)));
  EXPECT_TRUE(exact_self_intersections(right).points.empty());
}

// The angle doubled, 573 degrees: it runs over itself from the start to where the last turn begins.
TEST(ExactOverlaps, AreFoundOfACircleThatGoesMoreThanOnceAround) {
  // ((1 - u^2)^2 - 4 u^2, 4 u (1 - u^2)) / (1 + u^2)^2
  const Curve around = parametric({1, 0, -6, 0, 1}, {0, 4, 0, -4}, -3, 3, {1, 0, 2, 0, 1}, 30);
  const Piece_intersections self = exact_self_intersections(around);
  EXPECT_EQ(self.points.size(), 0u);
  // u and -1/u are one point.
  expect_overlap(self, 0, ratio(4, 9), ratio(5, 9), 1);
  const Piece_intersections found = exact_intersections(around, quarter({0, 0}, 1, 0));
  EXPECT_EQ(found.points.size(), 0u);
  EXPECT_EQ(found.overlaps.size(), 2u);  // angles from -286 to -270 and from 0 to 90 degrees
}

TEST(ExactOverlaps, TakeSinglePoints) {
  const Curve dot = curve({{1, 1}, {1, 1}, {1, 1}}), line = segment({0, 0}, {2, 2});
  expect_overlap(exact_intersections(dot, line), 0, 1, ratio(1, 2), ratio(1, 2));
  expect_overlap(exact_intersections(line, dot), ratio(1, 2), ratio(1, 2), 0, 1);
  expect_overlap(exact_intersections(dot, elevated(dot)), 0, 1, 0, 1);
  EXPECT_TRUE(exact_intersections(dot, segment({0, 0}, {2, 3})).overlaps.empty());
  EXPECT_TRUE(exact_self_intersections(dot).overlaps.empty());
}

}  // namespace
}  // namespace test_exact_overlaps
