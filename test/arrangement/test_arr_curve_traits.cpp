// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Functors of the traits for CGAL's arrangements, against the same in 100 digits, and on curves made for them.

#include "arr_functors.h"
#include "cases.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <functional>
#include <iterator>
#include <random>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace bounding_arcs_test::arr_curve_traits {

void expect_on_random_curves(const std::function<void(const Functors&)>& expect) {
  std::size_t compared = 0, cut = 0;
  for (int i = 0; i < cases(1); ++i) {
    std::mt19937 random(static_cast<unsigned>(i));
    const Functors functors(random);
    SCOPED_TRACE("case " + std::to_string(i));
    expect(functors);
    if (testing::Test::HasFailure()) return;
    compared += functors.compared;
    cut += functors.cut;
  }
  EXPECT_GT(compared, 0U);
  testing::Test::RecordProperty("compared", std::to_string(compared));
  testing::Test::RecordProperty("cut", std::to_string(cut));
}

TEST(ArrCurveTraits, ComparePoints) { expect_on_random_curves(std::mem_fn(&Functors::expect_points_compared)); }
TEST(ArrCurveTraits, ComparePointsWithCurves) {
  expect_on_random_curves(std::mem_fn(&Functors::expect_points_above_curves));
}
TEST(ArrCurveTraits, CompareCurvesBesidePoints) {
  expect_on_random_curves(std::mem_fn(&Functors::expect_curves_above_each_other));
}
TEST(ArrCurveTraits, FindWhatCurvesHaveInCommon) {
  expect_on_random_curves(std::mem_fn(&Functors::expect_common_points));
}
TEST(ArrCurveTraits, CutPiecesWhereTheyTurn) {
  expect_on_random_curves(std::mem_fn(&Functors::expect_parts_of_pieces));
}
TEST(ArrCurveTraits, TellDirections) { expect_on_random_curves(std::mem_fn(&Functors::expect_directions)); }
TEST(ArrCurveTraits, ApproximateWhatIsGiven) { expect_on_random_curves(std::mem_fn(&Functors::expect_approximations)); }

// An upright curve is above all others to the right of its lower end, and below them to the left of its upper one.
TEST(ArrCurveTraits, TakeUprightCurves) {
  const Traits traits;
  const auto parts = parts_of(traits, {ba::Arr_curve_2(Bezier({{1, 0}, {1, 3}, {1, -1}, {1, 2}})),
                                       ba::Arr_curve_2(Bezier({{0, 0}, {1, 0}, {2, 0}}))});
  ASSERT_EQ(parts.size(), 4U);  // up, back down, up again
  EXPECT_TRUE(parts[0].is_vertical() && parts[1].is_vertical() && parts[2].is_vertical());
  EXPECT_FALSE(parts[1].is_directed_right());
  const Point at(1, 0);
  EXPECT_EQ(traits.compare_y_at_x_2_object()(at, parts[0]), CGAL::EQUAL);
  EXPECT_EQ(traits.compare_y_at_x_right_2_object()(parts[0], parts[3], at), CGAL::LARGER);
  EXPECT_EQ(traits.compare_y_at_x_left_2_object()(parts[0], parts[3], at), CGAL::SMALLER);
  EXPECT_EQ(common_of(traits, parts[0], parts[1]).parts.size(), 1U);  // the fold
  EXPECT_EQ(common_of(traits, parts[0], parts[3]).points.size(), 1U);
}

// A point of one way of a fold is on its way back, too.
TEST(ArrCurveTraits, FindPointsOnBothWaysOfAFold) {
  const Traits traits;
  const auto fold = parts_of(traits, {ba::Arr_curve_2(Bezier({{1, -3}, {-2, 1}, {1, -3}}))});
  const auto loop = parts_of(traits, {ba::Arr_curve_2(Bezier({{-1, 0}, {0, 0}, {-1, -3}, {-1, 0}}, {1, 2, 2, 1}))});
  ASSERT_EQ(fold.size(), 2U);
  int count = 0;
  for (const Part& c : loop)
    for (const Point& p : common_of(traits, fold[1], c).points) {
      ++count;
      EXPECT_EQ(traits.compare_y_at_x_2_object()(p, fold[0]), CGAL::EQUAL);
      EXPECT_EQ(traits.compare_y_at_x_2_object()(p, fold[1]), CGAL::EQUAL);
    }
  EXPECT_GT(count, 0);
}

// Points may outlive the curves that they were found on.
TEST(ArrCurveTraits, KnowTurnsWhoseCurvesAreGone) {
  const Traits traits;
  const Point turn = parts_of(traits, {ba::Arr_curve_2(Bezier({{0, 0}, {196, 49}, {49, 147}}))}).at(0).right();
  const Part line = parts_of(traits, {ba::Arr_curve_2(Bezier({{111, 71}, {113, 73}}))}).at(0);
  EXPECT_EQ(traits.compare_y_at_x_2_object()(turn, line), CGAL::EQUAL);  // it is (112, 72), at t = 4/7
}

TEST(ArrCurveTraits, KnowCommonPointsWhoseCurvesAreGone) {
  const Traits traits;
  const auto common = [&](const Bezier& a, const Bezier& b) {
    const auto parts = parts_of(Traits(), {ba::Arr_curve_2(a), ba::Arr_curve_2(b)});
    return common_of(Traits(), parts.at(0), parts.at(1)).points.at(0);
  };
  const Bezier parabola({{0, 0}, {1, 0}, {2, 4}}), level({{0, 2}, {2, 2}}), upright({{1, 0}, {1, 3}});
  const Point root = common(parabola, level), same = common(level, parabola), one = common(upright, parabola);
  EXPECT_EQ(traits.compare_xy_2_object()(root, same), CGAL::EQUAL);
  EXPECT_EQ(traits.compare_x_2_object()(root, one), CGAL::LARGER);
  EXPECT_EQ(traits.compare_xy_2_object()(one, Point(1, 1)), CGAL::EQUAL);
  const Part line = parts_of(traits, {ba::Arr_curve_2(Bezier({{0, 1}, {2, 3}}))}).at(0);  // above it by root 2 - 1
  EXPECT_EQ(traits.compare_y_at_x_2_object()(root, line), CGAL::SMALLER);
}

// y = 2^52 (x - 1/2)^2 crosses a level line 2^-58 above its lowest point at x = 1/2 -+ 2^-55: nearer to 1/2 than any
// double.
struct Hairpin {
  Hairpin() {
    const auto curve = [](const std::vector<ba::Xy<double>>& points) { return ba::Arr_curve_2(Bezier(points)); };
    level = parts_of(traits, {curve({{0, 0x1p-58}, {1, 0x1p-58}})}).at(0);
    hairpin = parts_of(traits, {curve({{0, 0x1p50}, {0.5, -0x1p50}, {1, 0x1p50}})}).at(0);
    upright = parts_of(traits, {curve({{0x1p-58, 0}, {0x1p-58, 1}})}).at(0);
    turned = parts_of(traits, {curve({{0x1p50, 0}, {-0x1p50, 0.5}, {0x1p50, 1}})});
  }
  Traits traits;
  Part level, hairpin, upright;
  std::vector<Part> turned;
};

TEST(ArrCurveTraits, TellCrossingsApartThatNoDoubleIsBetween) {
  const Hairpin h;
  const std::vector<Point> points = common_of(h.traits, h.hairpin, h.level).points;
  ASSERT_EQ(points.size(), 2U);
  const auto compare = h.traits.compare_xy_2_object();
  EXPECT_EQ(compare(points[0], points[1]), CGAL::SMALLER);
  EXPECT_EQ(compare(points[0], Point(0.5, 0x1p-58)), CGAL::SMALLER);
  EXPECT_EQ(compare(points[1], Point(0.5, 0x1p-58)), CGAL::LARGER);
  const auto right = h.traits.compare_y_at_x_right_2_object();
  const auto left = h.traits.compare_y_at_x_left_2_object();
  EXPECT_EQ(right(h.hairpin, h.level, points[0]), CGAL::SMALLER);
  EXPECT_EQ(left(h.hairpin, h.level, points[0]), CGAL::LARGER);
  EXPECT_EQ(right(h.hairpin, h.level, points[1]), CGAL::LARGER);
  EXPECT_EQ(left(h.hairpin, h.level, points[1]), CGAL::SMALLER);
}

// Of either branch one, on the other side of the turn.
TEST(ArrCurveTraits, TellOnWhichBranchCrossingsAreNextToATurn) {
  const Hairpin h;
  ASSERT_EQ(h.turned.size(), 2U);
  const std::vector<Point> below = common_of(h.traits, h.turned[0], h.upright).points,
                           above = common_of(h.traits, h.upright, h.turned[1]).points;
  ASSERT_EQ(below.size(), 1U);
  ASSERT_EQ(above.size(), 1U);
  EXPECT_EQ(h.traits.compare_xy_2_object()(below[0], Point(0x1p-58, 0.5)), CGAL::SMALLER);
  EXPECT_EQ(h.traits.compare_xy_2_object()(above[0], Point(0x1p-58, 0.5)), CGAL::LARGER);
  EXPECT_EQ(h.traits.compare_x_2_object()(h.turned[0].left(), below[0]), CGAL::SMALLER);  // the turn
}

TEST(ArrCurveTraits, SplitOffPartsThatAreShorterThanAnUlp) {
  const Hairpin h;
  const std::vector<Point> points = common_of(h.traits, h.hairpin, h.level).points;
  for (const Part& whole : {h.hairpin, h.level, h.traits.construct_opposite_2_object()(h.level)}) {
    Part first, rest, middle, last, merged;
    h.traits.split_2_object()(whole, points[0], first, rest);
    h.traits.split_2_object()(rest, points[1], middle, last);
    EXPECT_TRUE(h.traits.equal_2_object()(middle.left(), points[0]));
    EXPECT_TRUE(h.traits.equal_2_object()(middle.right(), points[1]));
    EXPECT_EQ(middle.is_rising(), whole.is_rising());
    EXPECT_EQ(h.traits.compare_endpoints_xy_2_object()(middle), h.traits.compare_endpoints_xy_2_object()(whole));
    EXPECT_EQ(h.traits.compare_y_at_x_2_object()(Point(0.5, 0x1p-57), middle), CGAL::LARGER);
    EXPECT_EQ(h.traits.compare_y_at_x_2_object()(Point(0.5, -0x1p-80), middle), CGAL::SMALLER);
    EXPECT_TRUE(common_of(h.traits, first, last).points.empty());
    EXPECT_EQ(common_of(h.traits, middle, whole).parts.size(), 1U);
    h.traits.merge_2_object()(last, middle, merged);
    EXPECT_TRUE(h.traits.equal_2_object()(merged, rest));
  }
}

// y, or x, comes down from 5e30 and turns 8e-5 before 2e13, where an ulp is 4e-3, at the parameter 1 - 4e-18.
TEST(ArrCurveTraits, CutPiecesThatTurnWithinTheLastDouble) {
  const Traits traits;
  const auto upright = parts_of(traits, {ba::Arr_curve_2(Bezier({{0, 5e30}, {0, 0}, {0, 2e13}}))}),
             arch = parts_of(traits, {ba::Arr_curve_2(Bezier({{5e30, 0}, {0, 1}, {2e13, 2}}))});
  for (const auto* parts : {&upright, &arch}) {
    ASSERT_EQ(parts->size(), 2U);
    EXPECT_FALSE((*parts)[0].is_directed_right());
    EXPECT_TRUE((*parts)[1].is_directed_right());
    EXPECT_TRUE(traits.equal_2_object()((*parts)[0].left(), (*parts)[1].left()));
    EXPECT_EQ(traits.compare_xy_2_object()((*parts)[1].left(), (*parts)[1].right()), CGAL::SMALLER);
  }
  const Common fold = common_of(traits, upright[0], upright[1]);
  ASSERT_EQ(fold.parts.size(), 1U);
  EXPECT_TRUE(traits.equal_2_object()(fold.parts[0], upright[1]));
  EXPECT_EQ(common_of(traits, arch[0], arch[1]).points.size(), 1U);
}

// A parabola crosses the axis in the root of 2, and a line that rises by 2^-200 some 2^-201 behind it.
TEST(ArrCurveTraits, TellPointsApartThatHundredsOfBitsTell) {
  const Traits traits;
  const auto part = [&](const Bezier& b) { return parts_of(traits, {ba::Arr_curve_2(b)}).front(); };
  const Part parabola = part(Bezier({{1, -1}, {1.5, 0}, {2, 2}})), axis = part(Bezier({{1, 0}, {2, 0}})),
             tilted = part(Bezier({{1, 0x1p-200}, {2, 0x1p-199}}));
  const Point p = common_of(traits, parabola, axis).points.at(0), q = common_of(traits, parabola, tilted).points.at(0);
  EXPECT_EQ(traits.compare_x_2_object()(p, q), CGAL::SMALLER);
  EXPECT_EQ(traits.compare_xy_2_object()(q, p), CGAL::LARGER);
  EXPECT_EQ(traits.compare_y_at_x_2_object()(q, axis), CGAL::LARGER);
}

// The part of a polynomial cubic between two parameters, by its polar form. Without a rounding for small dyadic
// numbers.
Bezier part_of_cubic(const Bezier& cubic, double from, double to) {
  std::vector<ba::Xy<double>> points;
  for (int i = 0; i < 4; ++i) {
    std::vector<ba::Xy<double>> p = cubic.control_points();
    for (int k = 0; k < 3; ++k) {
      const double t = k < i ? to : from;
      for (std::size_t j = 0; j + 1 < p.size(); ++j) p[j] = p[j] + t * (p[j + 1] - p[j]);
      p.pop_back();
    }
    points.push_back(p.front());
  }
  return Bezier(points);
}

// Both are x-monotone and run through the point together.
void expect_equal_beside(const Bezier& first, const Bezier& second, const Point& at) {
  const Traits traits;
  const Part c = parts_of(traits, {ba::Arr_curve_2(first)}).at(0),
             d = parts_of(traits, {ba::Arr_curve_2(second)}).at(0);
  for (const auto& [e, f] : {std::pair(c, d), std::pair(d, c), std::pair(c, traits.construct_opposite_2_object()(d))}) {
    EXPECT_EQ(traits.compare_y_at_x_right_2_object()(e, f, at), CGAL::EQUAL) << e << " and " << f << " at " << at;
    EXPECT_EQ(traits.compare_y_at_x_left_2_object()(e, f, at), CGAL::EQUAL) << e << " and " << f << " at " << at;
  }
}

TEST(ArrCurveTraits, AreEqualBesidePointsInsideOverlapsOfLines) {
  expect_equal_beside(Bezier({{0, 0}, {4, 0}}), Bezier({{-1, 0}, {3, 0}}), {1, 0});
  expect_equal_beside(Bezier({{0, 0}, {4, 0}}), Bezier({{1, 0}, {3, 0}}), {2, 0});
  expect_equal_beside(Bezier({{0, 0}, {4, 8}}), Bezier({{3, 6}, {-1, -2}}), {1, 2});
  expect_equal_beside(Bezier({{0, 0}, {1, 1}, {4, 4}}), Bezier({{-1, -1}, {3, 3}}), {0x1p-30, 0x1p-30});
}

TEST(ArrCurveTraits, AreEqualBesidePointsInsideOverlapsOfCubics) {
  const Bezier whole({{0, 0}, {64, 192}, {128, -128}, {192, 64}});
  const auto part = [&](double from, double to) { return part_of_cubic(whole, from, to); };
  const auto p = whole.control_points();
  const Bezier raised({p[0], 0.25 * p[0] + 0.75 * p[1], 0.5 * p[1] + 0.5 * p[2], 0.75 * p[2] + 0.25 * p[3], p[3]}),
      weighted(p, {1, 2, 4, 8});
  for (const double t : {0.375, 0.5, 0.625}) {
    const auto at = whole.point(t);
    const Point q(at.x, at.y);
    expect_equal_beside(part(0, 0.75), part(0.25, 1), q);
    expect_equal_beside(part(0.75, 0), part(0.25, 1), q);
    expect_equal_beside(whole, part(0.25, 0.75), q);
    expect_equal_beside(raised, part(0.25, 1), q);
    expect_equal_beside(weighted, part(0, 0.75), q);
    expect_equal_beside(weighted, raised, q);
  }
}

TEST(ArrCurveTraits, TurnDirections) {
  const Traits traits;
  const Part part = parts_of(traits, {ba::Arr_curve_2(Bezier({{1, 0}, {0, 0}}))}).front();
  EXPECT_EQ(traits.compare_endpoints_xy_2_object()(part), CGAL::LARGER);
  const Part other = traits.construct_opposite_2_object()(part);
  EXPECT_EQ(traits.compare_endpoints_xy_2_object()(other), CGAL::SMALLER);
  EXPECT_TRUE(traits.equal_2_object()(part, other));
  EXPECT_FALSE(traits.are_mergeable_2_object()(part, other));
}

TEST(ArrCurveTraits, TellPlacesOfTheCurvesGiven) {
  const Traits traits;
  ba::Drawing_2<double> drawing;
  drawing.add({Bezier({{0, 0}, {1, 2}, {2, 0}}), Bezier({{2, 0}, {3, 0}})}, "a");
  drawing.add({Bezier({{0, 1}, {2, 1}})}, "b");
  const auto parts = parts_of(traits, ba::arr_curves(drawing));
  ASSERT_EQ(parts.size(), 3U);
  EXPECT_EQ(parts[1].curve().piece(), 1U);
  EXPECT_EQ(parts[2].curve().curve(), 1U);
  const Point touched = common_of(traits, parts[0], parts[2]).points.at(0);
  EXPECT_LE(touched.x().lower, 1);
  EXPECT_GE(touched.x().upper, 1);
  Part left, right;
  traits.split_2_object()(parts[0], touched, left, right);
  EXPECT_EQ(left.right_parameter().lower, 0.5);
  EXPECT_EQ(right.left_parameter().upper, 0.5);
}

TEST(ArrCurveTraits, ApproximateCurvesAsNearAsAsked) {
  const Traits traits;
  const Part part = parts_of(traits, {ba::Arr_curve_2(Bezier({{0, 0}, {1, 2}, {2, 0}}))}).front();
  std::vector<Traits::Approximate_point_2> line;
  traits.approximate_2_object()(part, 1e-4, std::back_inserter(line), false);
  ASSERT_GT(line.size(), 50U);
  EXPECT_LT(line.size(), 200U);
  EXPECT_EQ(line.front().x(), 2);
  for (std::size_t i = 0; i + 1 < line.size(); ++i) {
    const double x = (line[i].x() + line[i + 1].x()) / 2, y = (line[i].y() + line[i + 1].y()) / 2;
    EXPECT_NEAR(y, x * (2 - x), 1e-4);
  }
}

TEST(ArrCurveTraits, RefuseCurvesOutOfRange) {
  EXPECT_THROW(ba::Arr_curve_2(Bezier({{0, 0}, {HUGE_VAL, 0}})), std::invalid_argument);
}

}  // namespace bounding_arcs_test::arr_curve_traits
