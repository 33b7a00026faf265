// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Offsets: at their distance, by the hierarchy; of areas that are known, or that fine polygons and counting tell; and
// where everything touches everything.

#include "cases.h"
#include "offset_checks.h"

#include <CGAL/Bounding_arcs_2/curve/Curve_file.h>
#include <CGAL/Bounding_arcs_2/offset/Offset_source_2.h>
#include <CGAL/Bounding_arcs_2/offset/offset_bracket.h>
#include <CGAL/Bounding_arcs_2/offset/offset_series.h>

#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <stdexcept>
#include <string>
#include <vector>

namespace test_offset {
namespace {

using namespace bounding_arcs_test;

constexpr double PI = 3.14159265358979323846;

TEST(Offset, OfACircleIsOne) {
  const Drawing drawing = drawing_of(circle({1, 2}, 0.5));
  for (const double d : {0.25, -0.25, 3.0, -0.499}) {
    SCOPED_TRACE(d);
    for (const Drawing& c : {drawing, backwards(drawing)}) {
      const Offset offset = offset_curves(c, d, within(1e-9));
      expect_sound(offset);
      ASSERT_EQ(offset.chains.size(), 1U);
      EXPECT_NEAR(area_of(offset), PI * (0.5 + d) * (0.5 + d), 1e-12 * (1 + d * d));
      expect_at_distance(c, offset, 1e-9);
    }
  }
  for (const double d : {-0.5, -0.7, -0.9999, -1.0, -5.0})
    EXPECT_TRUE(offset_curves(drawing, d, within(1e-6)).chains.empty()) << d;
}

TEST(Offset, HasTheAreaOfARectangleWithItsJoins) {
  const double w = 3, h = 2;
  for (const Drawing& r : {rectangle(w, h), backwards(rectangle(w, h))}) {
    for (const double d : {0.25, 1.0, 7.0}) {
      SCOPED_TRACE(d);
      Offset_options options = within(1e-6);
      const Offset round = offset_curves(r, d, options);
      expect_sound(round);
      expect_at_distance(r, round, 1e-6);
      const double sides = w * h + 2 * d * (w + h);
      EXPECT_NEAR(area_of(round), sides + PI * d * d, 1e-12 * (1 + d * d));
      options.join = ba::Offset::Join::MITER;
      EXPECT_NEAR(area_of(offset_curves(r, d, options)), sides + 4 * d * d, 1e-12 * (1 + d * d));
      options.miter_limit = 1.2;  // below the root of 2
      EXPECT_NEAR(area_of(offset_curves(r, d, options)), sides + 2 * d * d, 1e-12 * (1 + d * d));
      options.join = ba::Offset::Join::BEVEL;
      EXPECT_NEAR(area_of(offset_curves(r, d, options)), sides + 2 * d * d, 1e-12 * (1 + d * d));
    }
    for (const double d : {0.25, 0.9, 0.999}) {
      const Offset inner = offset_curves(r, -d, within(1e-6));
      expect_sound(inner);
      EXPECT_NEAR(area_of(inner), (w - 2 * d) * (h - 2 * d), 1e-12) << d;
      expect_at_distance(r, inner, 1e-6);
    }
    for (const double d : {1.0, 1.1, 1.5, 2.0, 30.0}) {
      const Offset none = offset_curves(r, -d, within(1e-6));
      EXPECT_EQ(none.status, ba::Offset::Status::COMPLETE) << d;
      EXPECT_TRUE(none.chains.empty()) << d;
    }
  }
}

TEST(Offset, OfASegmentIsAStadium) {
  const Drawing drawing = drawing_of(segment({1, 1}, {4, 5}));
  for (const double d : {0.3, -0.3}) {  // a band has no sign
    Offset_options options = within(1e-6);
    const Offset round = offset_curves(drawing, d, options);
    expect_sound(round);
    expect_at_distance(drawing, round, 1e-6);
    EXPECT_NEAR(area_of(round), 5 * 0.6 + PI * 0.09, 1e-13);
    options.cap = ba::Offset::Cap::BUTT;
    EXPECT_NEAR(area_of(offset_curves(drawing, d, options)), 5 * 0.6, 1e-13);
    options.cap = ba::Offset::Cap::SQUARE;
    EXPECT_NEAR(area_of(offset_curves(drawing, d, options)), 5.6 * 0.6, 1e-13);
  }
}

TEST(Offset, OfOneSideIsOpen) {
  const Drawing corner = polygon({{0, 0}, {2, 0}, {2, 2}}, false);
  Offset_options options = within(1e-6);
  options.side = ba::Offset::Side::LEFT;
  const Offset left = offset_curves(corner, 0.5, options);
  ASSERT_EQ(left.chains.size(), 1U);
  EXPECT_FALSE(left.chains[0].is_closed);
  ASSERT_EQ(left.chains[0].pieces.size(), 2U);  // trimmed at the inner side of the corner
  EXPECT_EQ(left.chains[0].pieces.front().arc.from, (Point{0, 0.5}));
  EXPECT_NEAR(left.chains[0].pieces.front().arc.to.x, 1.5, 1e-13);
  EXPECT_EQ(left.chains[0].pieces.back().arc.to, (Point{1.5, 2}));
  options.side = ba::Offset::Side::RIGHT;
  const Offset right = offset_curves(corner, 0.5, options);
  ASSERT_EQ(right.chains.size(), 1U);
  EXPECT_EQ(right.chains[0].pieces.front().arc.from, (Point{0, -0.5}));
  EXPECT_EQ(right.chains[0].pieces.back().arc.to, (Point{2.5, 2}));
}

TEST(Offset, OfOneSideOfClosedCurvesIsInsetOrOutset) {
  const std::vector<Point> corners{{0, 0}, {10, 0}, {10, 8}, {0, 8}};
  const Drawing ccw = polygon(corners, true), cw = polygon({corners.rbegin(), corners.rend()}, true);
  Offset_options options = within(1e-6);
  const auto area = [&](const Drawing& drawing, ba::Offset::Side side, double d) {
    options.side = side;
    const Offset offset = offset_curves(drawing, d, options);
    EXPECT_TRUE(offset.is_valid());
    EXPECT_EQ(offset.status, ba::Offset::Status::COMPLETE);
    double sum = 0;
    for (const auto& chain : offset.chains) {
      EXPECT_TRUE(chain.is_closed);
      sum += chain.area;
    }
    return sum;
  };
  const double outset = 80 + 2 * 18 + PI;
  for (const double d : {1.0, -1.0}) {
    EXPECT_NEAR(area(ccw, ba::Offset::Side::LEFT, d), 48, 1e-12);
    EXPECT_NEAR(area(ccw, ba::Offset::Side::RIGHT, d), outset, 1e-12);
    EXPECT_NEAR(area(cw, ba::Offset::Side::RIGHT, d), -48, 1e-12);  // it runs as the curve does
    EXPECT_NEAR(area(cw, ba::Offset::Side::LEFT, d), -outset, 1e-12);
  }
  EXPECT_EQ(area(ccw, ba::Offset::Side::LEFT, 4.5), 0);  // the inside is all nearer
  options.rule = ba::Fill_rule::EVEN_ODD;
  EXPECT_NEAR(area(ccw, ba::Offset::Side::LEFT, 1), 48, 1e-12);
  // a hole: what is left of both runs in the ring between them
  const Drawing ring = both(ccw, polygon({{3, 3}, {3, 5}, {7, 5}, {7, 3}}, true));
  EXPECT_NEAR(area(ring, ba::Offset::Side::LEFT, 0.5), 9 * 7 - (4 * 2 + 2 * 0.5 * 6 + PI / 4), 1e-12);
  EXPECT_NEAR(area(ring, ba::Offset::Side::RIGHT, 0.5), 80 + 2 * 0.5 * 18 + PI / 4 - 3 * 1, 1e-12);
  // nested ones that both run counterclockwise
  const Drawing nested = both(ccw, polygon({{3, 3}, {7, 3}, {7, 5}, {3, 5}}, true));
  EXPECT_NEAR(area(nested, ba::Offset::Side::LEFT, 0.5), 9 * 7 + 3 * 1, 1e-12);
}

TEST(Offset, HasTheAreaOfDegenerateDrawingsInClosedForm) {
  const Drawing point = drawing_of(Bezier({{1, 1}, {1, 1}}));
  EXPECT_NEAR(area_of(offset_curves(point, 2, within(1e-6))), 4 * PI, 1e-12);
  EXPECT_TRUE(offset_curves(Drawing(), 1, within(1e-6)).chains.empty());

  // two lines, apart by less, as much and more than both bands
  for (const double gap : {1.9, 2.0, 2.1}) {
    const Drawing lines = both(drawing_of(segment({0, 0}, {10, 0})), drawing_of(segment({0, gap}, {10, gap})));
    const Offset offset = offset_curves(lines, 1, within(1e-4));
    expect_sound(offset);
    const double apart = 2 * (20 + PI), ends = 2 * std::acos(gap / 2) - gap / 2 * std::sqrt(4 - gap * gap);
    EXPECT_NEAR(area_of(offset), gap < 2 ? apart - 10 * (2 - gap) - ends : apart, 50 * 1e-4) << gap;
    expect_at_distance(lines, offset, 1e-4);
  }
  // a line beside a disc runs round nothing
  const Drawing beside = both(drawing_of(circle({0, 0}, 0.5)), drawing_of(segment({3, -5}, {3, 5})));
  EXPECT_NEAR(area_of(offset_curves(beside, 0.25, within(1e-6))), PI * 0.75 * 0.75 + 5 + PI / 16, 1e-5);
  EXPECT_NEAR(area_of(offset_curves(beside, -0.25, within(1e-6))), PI / 16 + 5 + PI / 16, 1e-5);
  // a ring: the rule, and the distance at which both sides meet
  const Drawing ring = both(drawing_of(circle({0, 0}, 1)), drawing_of(circle({0, 0}, 2)));
  Offset_options options = within(1e-6);
  options.rule = ba::Fill_rule::EVEN_ODD;
  EXPECT_NEAR(area_of(offset_curves(ring, -0.25, options)), PI * (1.75 * 1.75 - 1.25 * 1.25), 1e-4);
  EXPECT_NEAR(area_of(offset_curves(ring, 0.25, options)), PI * (2.25 * 2.25 - 0.75 * 0.75), 1e-4);
  EXPECT_NEAR(area_of(offset_curves(ring, 1, options)), 9 * PI, 1e-4);
  EXPECT_EQ(offset_curves(ring, -0.5, options).status, ba::Offset::Status::COMPLETE);
  EXPECT_NEAR(area_of(offset_curves(ring, -0.5, options)), 0, 1e-4);
  EXPECT_TRUE(offset_curves(ring, -0.6, options).chains.empty());
  // the same square twice, and one that has a side in common
  const Drawing square = rectangle(1, 1);
  expect_sound(offset_curves(both(square, square), 0.1, within(1e-6)));
  EXPECT_NEAR(area_of(offset_curves(both(square, square), 0.1, within(1e-6))), 1.4 + 0.01 * PI, 1e-5);
  const Offset pair = offset_curves(both(square, moved(square, 1, {1, 0})), 0.1, within(1e-6));
  expect_sound(pair);
  EXPECT_NEAR(area_of(pair), 2 + 0.6 + 0.01 * PI, 1e-5);
}

TEST(Offset, IsExactlyTheRadiusOfAnArc) {
  // rounded corners of radius 1/2 shrink to corners
  const double r = 0.5, s = 2 - r;
  std::vector<Bezier> chain;
  const Point corners[4] = {{2, -2}, {2, 2}, {-2, 2}, {-2, -2}};
  Point at{-s, -2};
  for (const Point& c : corners) {
    const Point before = at, along{c.x - before.x, c.y - before.y};
    const double length = std::hypot(along.x, along.y);
    const Point u = (1 / length) * along, from = c - r * u, to = c + r * Point{-u.y, u.x};
    chain.push_back(segment(before, from));
    chain.emplace_back(std::vector<Point>{from, c, to}, std::vector<double>{1, 1, 2});
    at = to;
  }
  const Drawing drawing = drawing_of(chain);
  for (const double d : {0.499, 0.5, 0.501}) {
    const Offset offset = offset_curves(drawing, -d, within(1e-6));
    expect_sound(offset);
    const double side = 4 - 2 * d, round = (std::max)(0.0, r - d);
    EXPECT_NEAR(area_of(offset), side * side - (4 - PI) * round * round, 1e-11) << d;
    expect_at_distance(drawing, offset, 1e-6);
  }
}

TEST(Offset, IsSoundForRandomClosedCurves) {
  std::mt19937 random(7);
  std::uniform_real_distribution<double> unit(-1, 1);
  for (int k = 0; k < cases(60); ++k) {
    Drawing drawing;
    const int count = 1 + static_cast<int>(random() % 2);
    for (int c = 0; c < count; ++c) {
      const Drawing curve =
          drawing_of(closed_curve(random, {0.5 * unit(random), 0.5 * unit(random)}, 3 + random() % 6));
      drawing = both(drawing, random() % 3 == 0 ? backwards(curve) : curve);
    }
    const double eps = k % 2 == 0 ? 1e-3 : 1e-6, d = 0.8 * unit(random);
    Offset_options options = within(eps);
    options.rule = random() % 3 == 0 ? ba::Fill_rule::EVEN_ODD : ba::Fill_rule::NONZERO;
    SCOPED_TRACE(std::to_string(k) + ", d " + std::to_string(d));
    const Offset offset = offset_curves(drawing, d, options);
    expect_sound(offset);
    expect_at_distance(drawing, offset, eps, options.rule);
    expect_same_points(drawing, offset, eps, true, options.rule);
    if (HasFailure()) return;
  }
}

TEST(Offset, IsSoundForRandomOpenCurves) {
  std::mt19937 random(8);
  std::uniform_real_distribution<double> unit(-1, 1);
  for (int k = 0; k < cases(60); ++k) {
    Drawing drawing;
    for (std::size_t c = 0; c < 1 + random() % 3; ++c) {
      std::vector<Point> p;
      for (int i = 0; i < 4; ++i) p.push_back({unit(random), unit(random)});
      drawing.add(Bezier(p));
    }
    const double eps = k % 2 == 0 ? 1e-3 : 1e-6, d = 0.01 + 0.5 * std::fabs(unit(random));
    SCOPED_TRACE(std::to_string(k) + ", d " + std::to_string(d));
    const Offset offset = offset_curves(drawing, d, within(eps));
    expect_sound(offset);
    expect_at_distance(drawing, offset, eps);
    expect_same_points(drawing, offset, eps, false);
    if (HasFailure()) return;
  }
}

TEST(Offset, OfBundledCurvesIsCertified) {
  for (const char* name : {"a_wrench", "c_letter_K", "f_crow", "h_maple_leaf"}) {
    const Drawing drawing =
        ba::drawing<double>(ba::read_curve_file(std::string(BOUNDING_ARCS_EXAMPLE_DATA) + "/" + name + ".json").curves);
    for (const double eps : {2e-4, 2e-6}) {
      const ba::Offset_source_2 source = offset_source(drawing, within(eps));
      for (const double d : {0.02, -0.02, 0.1, -0.1, 0.4, -0.4}) {
        SCOPED_TRACE(std::string(name) + " " + std::to_string(d));
        const Offset offset = source.at(d);
        expect_sound(offset);
        expect_at_distance(drawing, offset, eps);
        expect_same_points(drawing, offset, eps, true);
      }
    }
  }
}

// What a rule makes of a drawing inwards, checked in all ways.
Offset inwards(const Drawing& drawing, double d, ba::Fill_rule rule = ba::Fill_rule::NONZERO) {
  Offset_options options = within(1e-6);
  options.rule = rule;
  const Offset offset = offset_curves(drawing, -d, options);
  expect_sound(offset);
  expect_at_distance(drawing, offset, options.eps, rule);
  expect_same_points(drawing, offset, options.eps, true, rule);
  return offset;
}

TEST(OffsetInwards, OfOverlappingCirclesIsThatOfTheirUnion) {
  const Drawing left = drawing_of(circle({-0.5, 0}, 1)), right = drawing_of(circle({0.5, 0}, 1)),
                pair = both(left, right);
  // sectors of two thirds, and an equilateral triangle above and below without a sector about the inner corner
  const auto area = [](double d) { return (1 - d) * (1 - d) * 4 * PI / 3 + std::sqrt(0.75) - d * d * PI / 3; };
  for (const Drawing& drawing : {pair, backwards(pair), both(pair, left)})
    for (const double d : {0.1, 0.5, 0.8}) {
      SCOPED_TRACE(d);
      const Offset offset = inwards(drawing, d);
      EXPECT_EQ(offset.chains.size(), 1U);
      EXPECT_NEAR(area_of(offset), area(d), 1e-6);
    }
  EXPECT_EQ(inwards(pair, 0.9).chains.size(), 2U);  // farther than the inner corners are from each other
  EXPECT_TRUE(inwards(pair, 1.01).chains.empty());
  // where one of the discs is a point, offsets on both sides of it cross again
  inwards(both(drawing_of(circle({0, -1}, 1)), drawing_of(circle({-1, 0}, 1.5))), 1);
  const Point tip{-0.53, 0}, along{0.766, 0.643};  // here what is left of them turns by less than half a circle
  const Drawing wedge = polygon({tip, tip + 6.0 * Point{along.x, -along.y}, tip + 6.0 * along});
  inwards(both(drawing_of(circle({0, 0}, 1)), wedge), 1);
  // where both sides of the lens count, it is a hole
  const Offset against = inwards(both(left, backwards(right)), 0.1), odd = inwards(pair, 0.1, ba::Fill_rule::EVEN_ODD);
  EXPECT_EQ(odd.chains.size(), 2U);
  EXPECT_NEAR(area_of(against), area_of(odd), 1e-6);
  // what is made of offsets
  EXPECT_NEAR(area_of(ba::opening(ba::Bounding_arc_tree_2(pair), 0.1, 1e-6)), area(0), 1e-5);
  const ba::Offset::Bounds bracket = ba::offset_bracket(ba::Bounding_arc_tree_2(pair), -0.1, 1e-4);
  EXPECT_LT(area_of(bracket.inside), area(0.1));
  EXPECT_GT(area_of(bracket.outside), area(0.1));
  EXPECT_NEAR(area_of(bracket.inside), area_of(bracket.outside), 1e-4 * 9);
  const Offset outline = offset_source(pair, within(1e-6)).outline();
  expect_sound(outline);
  EXPECT_NEAR(area_of(outline), area(0), 1e-5);
}

TEST(OffsetInwards, OfNestedCirclesFollowsTheRule) {
  const Drawing outer = drawing_of(circle({0, 0}, 2)), inner = drawing_of(circle({0, 0}, 1)),
                point = drawing_of(circle({0.5, 0}, 0.25));
  const double ring = PI * (1.75 * 1.75 - 1.25 * 1.25), disc = PI * 1.75 * 1.75;
  EXPECT_NEAR(area_of(inwards(both(outer, inner), 0.25)), disc, 1e-5);
  EXPECT_NEAR(area_of(inwards(backwards(both(outer, inner)), 0.25)), disc, 1e-5);
  EXPECT_NEAR(area_of(inwards(both(outer, backwards(inner)), 0.25)), ring, 1e-5);
  EXPECT_NEAR(area_of(inwards(both(outer, inner), 0.25, ba::Fill_rule::EVEN_ODD)), ring, 1e-5);
  // the middle of three is a wall, and the innermost is a hole if both of the others run the other way
  EXPECT_NEAR(area_of(inwards(both(both(outer, inner), point), 1.5)), PI / 4, 1e-5);
  EXPECT_NEAR(area_of(inwards(both(both(outer, backwards(inner)), point), 0.125)),
              PI * (1.875 * 1.875 - 1.125 * 1.125 + 0.125 * 0.125), 1e-5);
  // an outline runs round regions whichever way curves do
  const Offset outline = offset_source(backwards(both(outer, backwards(inner))), within(1e-6)).outline();
  expect_sound(outline);
  EXPECT_NEAR(area_of(outline), 3 * PI, 1e-5);
  EXPECT_TRUE(offset_source(drawing_of(segment({0, 0}, {1, 0})), within(1e-6)).outline().chains.empty());
}

TEST(OffsetInwards, OfCurvesThatCrossThemselvesFollowsTheRule) {
  std::vector<Point> star;
  for (int i = 0; i < 5; ++i) star.push_back({1.5 * std::sin(0.8 * PI * i), 1.5 * std::cos(0.8 * PI * i)});
  const Offset whole = inwards(polygon(star), 0.1), rays = inwards(polygon(star), 0.05, ba::Fill_rule::EVEN_ODD);
  EXPECT_EQ(whole.chains.size(), 1U);
  EXPECT_EQ(rays.chains.size(), 5U);
  // both lobes of an eight are enclosed, either way round
  const Drawing eight = polygon({{-1.5, -1}, {1.5, 1}, {1.5, -1}, {-1.5, 1}});
  for (const ba::Fill_rule rule : {ba::Fill_rule::NONZERO, ba::Fill_rule::EVEN_ODD})
    EXPECT_EQ(inwards(eight, 0.1, rule).chains.size(), 2U);
}

TEST(OffsetInwards, OfCurvesThatShareSidesHasNoWallsThere) {
  const Drawing square = rectangle(1, 1), beside = moved(square, 1, {1, 0});
  EXPECT_NEAR(area_of(inwards(both(square, beside), 0.1)), 1.8 * 0.8, 1e-5);
  EXPECT_NEAR(area_of(inwards(both(square, beside), 0.1, ba::Fill_rule::EVEN_ODD)), 1.8 * 0.8, 1e-5);
  EXPECT_NEAR(area_of(inwards(both(square, square), 0.1)), 0.8 * 0.8, 1e-5);
  EXPECT_TRUE(inwards(both(square, square), 0.1, ba::Fill_rule::EVEN_ODD).chains.empty());
  EXPECT_TRUE(inwards(both(square, backwards(square)), 0.1).chains.empty());
  // a cross of two strips: joins are those of its inner corners, and insets go on to its middle
  const Drawing cross = both(moved(rectangle(3, 1), 1, {-1.5, -0.5}), moved(rectangle(1, 3), 1, {-0.5, -1.5}));
  const double mitered = 2 * 2.8 * 0.8 - 0.8 * 0.8;
  EXPECT_NEAR(area_of(inwards(cross, 0.1)), mitered + 0.01 * (4 - PI), 1e-5);
  Offset_options options = within(1e-6);
  options.join = ba::Offset::Join::MITER;
  EXPECT_NEAR(area_of(offset_curves(cross, -0.1, options)), mitered, 1e-5);
  EXPECT_EQ(ba::insets(ba::Bounding_arc_tree_2(cross), 0.2, 1e-6).size(), 3U);
}

TEST(Offset, KnowsWhereItComesFrom) {
  std::mt19937 random(9);
  const Drawing drawing = drawing_of(closed_curve(random, {0, 0}, 7));
  const double eps = 1e-5, d = 0.2;
  for (const auto& chain : offset_curves(drawing, d, within(eps)).chains)
    for (const auto& p : chain.pieces) {
      const auto far = [&](const Point& q, std::uint32_t bezier, double t) {
        return ba::euclidean_norm(q - drawing.curves()[p.source.curve].beziers[bezier].point(t));
      };
      EXPECT_NEAR(far(p.arc.from, p.source.bezier, p.source.t), d, 1e-3);
      EXPECT_NEAR(far(p.arc.to, p.bezier_of_end(), p.t_end), d, 1e-3);
    }
}

// What doubles do not resolve of the first of two offsets is told of both.
TEST(Offset, OfAnOffsetTellsWhatTheFirstOneTold) {
  const Point corners[] = {{1000, 0}, {0, 1000}, {-1000, 0}, {0, -1000}, {1000, 0}};
  constexpr double HANDLE = 0.55;
  std::vector<Bezier> round;
  for (int i = 0; i < 4; ++i) {
    const Point &p = corners[i], &q = corners[i + 1];
    round.push_back(Bezier({p, p + HANDLE * q, q + HANDLE * p, q}));
  }
  const ba::Bounding_arc_tree_2 tree(drawing_of(round));
  int first = 0;
  for (double eps = 1e-6; eps > 1e-12; eps /= 4) {
    const ba::Offset inside = ba::offset(tree, -10, eps / 2);
    EXPECT_GE(ba::opening(tree, 10, eps).status, inside.status) << eps;
    first += inside.status == ba::Offset::Status::COMPLETE ? 0 : 1;
  }
  EXPECT_GT(first, 0);
}

TEST(Offset, RefusesWhatIsNoNumber) {
  const Drawing square = rectangle(1, 1);
  EXPECT_THROW((void)offset_curves(square, 1, within(0)), std::invalid_argument);
  EXPECT_THROW((void)offset_curves(square, NAN, within(1e-3)), std::invalid_argument);
  Offset_options options;
  options.miter_limit = 0.5;
  EXPECT_THROW((void)offset_curves(square, 1, options), std::invalid_argument);
}

}  // namespace
}  // namespace test_offset
