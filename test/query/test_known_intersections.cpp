// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Intersections of drawings in cases whose answers are known.

#include "intersection_checks.h"

#include <CGAL/Bounding_arcs_2/query/intersections.h>
#include <CGAL/Bounding_arcs_2/query/shapes.h>
#include "../../src/library/curve/exact_bezier.h"
#include "../../src/library/query/exact_intersections.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstddef>
#include <vector>

namespace test_known_intersections {
namespace {

using namespace bounding_arcs_test;
namespace ba = CGAL::Bounding_arcs;
using ba::intersections;
using Bezier = ba::Bezier_curve_2<double>;
using Points = std::vector<ba::Xy<double>>;
using Kind = ba::Intersection_kind;

ba::Bounding_arc_tree_2 polygon(const Points& p) {
  std::vector<Bezier> sides;
  for (std::size_t i = 0; i + 1 < p.size(); ++i) sides.emplace_back(Points{p[i], p[i + 1]});
  return index_of(sides);
}

// y = x^2 over [-1, 1] and its mirror image moved up by `gap`: none, a touching point, or two.
TEST(Intersections, OfParabolasThatAlmostTouchAreCounted) {
  for (const int exponent : {20, 30, 50})
    for (const int sign : {-1, 0, 1}) {
      const double gap = sign * std::ldexp(1.0, -exponent);
      const Bezier up(Points{{-1, 1}, {0, -1}, {1, 1}}), down(Points{{-1, -1 - gap}, {0, 1 - gap}, {1, -1 - gap}});
      const ba::Intersections_2<> found = intersections(index_of({up}), index_of({down}));
      ASSERT_EQ(found.points.size(), sign > 0 ? 0U : (sign == 0 ? 1U : 2U)) << exponent << " " << sign;
      for (const ba::Intersections_2<>::Intersection& p : found.points)
        EXPECT_EQ(p.kind, sign == 0 ? Kind::TANGENTIAL : Kind::TRANSVERSAL);
    }
}

TEST(Intersections, OfAVerticalSegmentThroughACuspIsOnePoint) {
  const Bezier cusp(Points{{0, 0}, {2, 2}, {0, 2}, {2, 0}}), straight(Points{{1, 0}, {1, 1}, {1, 1.5}, {1, 3}});
  const ba::Intersections_2<> found = intersections(index_of({cusp}), index_of({straight}));
  ASSERT_EQ(found.points.size(), 1U);
  EXPECT_EQ(found.points[0].kind, Kind::TANGENTIAL);
  EXPECT_TRUE(found.overlaps.empty());
  EXPECT_TRUE(ba::self_intersections(index_of({cusp})).points.empty());
}

TEST(Intersections, AtJointsCountOnce) {
  const ba::Bounding_arc_tree_2 square = polygon({{0, 0}, {2, 0}, {2, 2}, {0, 2}, {0, 0}});
  const ba::Intersections_2<> diagonal = intersections(square, polygon({{-1, -1}, {1, 1}, {3, 3}}));
  ASSERT_EQ(diagonal.points.size(), 2U);
  EXPECT_EQ(diagonal.points[0].a.bezier, 0U);
  EXPECT_EQ(diagonal.points[0].a.t.upper, 0);
  EXPECT_EQ(diagonal.points[1].a.bezier, 2U);
  const ba::Intersections_2<> corner = intersections(square, polygon({{2, 2}, {3, 2}, {3, 3}}));
  ASSERT_EQ(corner.points.size(), 1U);
  EXPECT_EQ(corner.points[0].kind, Kind::TANGENTIAL);  // with the side that goes on straight
  EXPECT_TRUE(ba::self_intersections(square).points.empty());
  const ba::Intersections_2<> eight = ba::self_intersections(polygon({{0, 0}, {1, 1}, {2, 2}, {2, 0}, {1, 1}, {0, 2}}));
  ASSERT_EQ(eight.points.size(), 1U);
  EXPECT_EQ(eight.points[0].kind, Kind::TRANSVERSAL);
}

TEST(Intersections, OfOneCurveGivenTwiceIsOneOverlap) {
  const Bezier curve(Points{{0, 0}, {1, 3}, {2, -3}, {3, 1}});
  const auto halves = curve.split(0.5);
  for (const auto& other : {std::vector<Bezier>{curve},
                            {curve.reversed()},
                            {halves.first, halves.second},
                            {halves.second.reversed(), halves.first.reversed()}}) {
    const ba::Intersections_2<> found = intersections(index_of({curve}), index_of(other));
    EXPECT_TRUE(found.points.empty());
    ASSERT_EQ(found.overlaps.size(), 1U);
    EXPECT_EQ(found.overlaps[0].a_from.t.lower, 0);
    EXPECT_EQ(found.overlaps[0].a_to.t.upper, 1);
  }
  const ba::Intersections_2<> half = intersections(index_of({curve}), index_of({halves.second}));
  ASSERT_EQ(half.overlaps.size(), 1U);
  EXPECT_EQ(half.overlaps[0].a_from.t.lower, 0.5);
  EXPECT_TRUE(half.points.empty());
  const ba::Bounding_arc_tree_2 square = polygon({{0, 0}, {2, 0}, {2, 2}, {0, 2}, {0, 0}});
  const ba::Intersections_2<> ring = intersections(square, square);
  EXPECT_TRUE(ring.points.empty());
  ASSERT_EQ(ring.overlaps.size(), 1U);
  EXPECT_EQ(ring.overlaps[0].a_to.bezier, 3U);
}

TEST(Intersections, WithCirclesLinesAndArcsAreKnown) {
  const ba::Bounding_arc_tree_2 unit(ba::circle_drawing({0, 0}, 1)), inner(ba::circle_drawing({0, 0}, 0.5)),
      beside(ba::circle_drawing({2, 0}, 1)), within(ba::circle_drawing({0.5, 0}, 0.5)),
      across(ba::circle_drawing({1, 0}, 1));
  EXPECT_TRUE(intersections(unit, inner).points.empty());
  EXPECT_EQ(intersections(unit, unit).overlaps.size(), 1U);
  for (const ba::Bounding_arc_tree_2* touching : {&beside, &within}) {
    const ba::Intersections_2<> found = intersections(unit, *touching);
    ASSERT_EQ(found.points.size(), 1U);
    EXPECT_EQ(found.points[0].kind, Kind::TANGENTIAL);
    EXPECT_EQ(found.points[0].point, (ba::Xy<double>{1, 0}));
  }
  const ba::Intersections_2<> two = intersections(unit, across);
  ASSERT_EQ(two.points.size(), 2U);
  EXPECT_NEAR(two.points[0].point.y, std::sqrt(0.75), 1e-15);
  EXPECT_NEAR(two.points[1].point.y, -std::sqrt(0.75), 1e-15);
  EXPECT_EQ(intersections(unit, ba::Bounding_arc_tree_2(ba::line_drawing(unit, {0, 1}, {1, 0}))).points.size(), 1U);
  EXPECT_EQ(intersections(unit, ba::Bounding_arc_tree_2(ba::line_drawing(unit, {0, 1e-3}, {7, 1}))).points.size(), 2U);
  EXPECT_EQ(intersections(unit, ba::Bounding_arc_tree_2(ba::ray_drawing(unit, {0, 1e-3}, {7, 1}))).points.size(), 1U);
  EXPECT_EQ(intersections(unit, ba::Bounding_arc_tree_2(ba::ray_drawing(unit, {3, 0}, {1, 0}))).points.size(), 0U);
  EXPECT_EQ(intersections(unit, ba::Bounding_arc_tree_2(ba::segment_drawing({0, 0}, {0.5, 0.5}))).points.size(), 0U);
  for (const double bulge : {1.0, 0.25, 0x1p-40, 0.0, -0.5}) {
    // half of the circle about the chord's middle, and flatter arcs: all meet the vertical axis once, where b says
    const ba::Bounding_arc_tree_2 arc(ba::arc_drawing({{-1, 0}, {1, 0}, bulge}));
    const ba::Intersections_2<> found =
        intersections(arc, ba::Bounding_arc_tree_2(ba::line_drawing(arc, {0, 0}, {0, 1})));
    ASSERT_EQ(found.points.size(), 1U) << bulge;
    EXPECT_NEAR(found.points[0].point.y, -bulge, 1e-15);
  }
  EXPECT_EQ(intersections(unit, ba::Bounding_arc_tree_2(ba::arc_drawing({{-1, 0}, {1, 0}, 1}))).overlaps.size(), 1U);
}

TEST(Intersections, OfCurvesWithNumbersThatAreNoDoublesAreThoseOfTheExactCurves) {
  using Exact = CGAL::Exact_rational;
  const Exact third = Exact(1) / Exact(3);
  ba::Drawing_2<Exact> line, touching, above;
  line.add(ba::Bezier_curve_2<Exact>({{Exact(0), third}, {Exact(1), third}}));
  // y = 1/3 + (x - 1/2)^2, and 2^-80 above
  touching.add(ba::Bezier_curve_2<Exact>(
      {{Exact(0), third + Exact(0.25)}, {Exact(0.5), third - Exact(0.25)}, {Exact(1), third + Exact(0.25)}}));
  const Exact higher = third + Exact(std::ldexp(1.0, -80));
  above.add(ba::Bezier_curve_2<Exact>(
      {{Exact(0), higher + Exact(0.25)}, {Exact(0.5), higher - Exact(0.25)}, {Exact(1), higher + Exact(0.25)}}));
  const ba::Bounding_arc_tree_2 a(line);
  const ba::Intersections_2<> one = intersections(a, ba::Bounding_arc_tree_2(touching));
  ASSERT_EQ(one.points.size(), 1U);
  EXPECT_EQ(one.points[0].kind, Kind::TANGENTIAL);
  EXPECT_TRUE(intersections(a, ba::Bounding_arc_tree_2(above)).points.empty());
  EXPECT_EQ(ba::do_intersect(a, ba::Bounding_arc_tree_2(above, ba::Decisions::DOUBLE)), std::nullopt);
}

// Doubles tell of equal segments that they are, of one with other weights they do not. That stays open beside the
// others.
TEST(Intersections, BesideAnOverlapStayOpen) {
  const ba::Xy<double> a{-3, 2}, b{0, -3}, c{1, -2};
  for (const auto decisions : {ba::Decisions::DOUBLE, ba::Decisions::EXACT}) {
    const ba::Bounding_arc_tree_2 p = index_of({Bezier({a, b}), Bezier({b, c}, {3, 2})}, decisions),
                                  q = index_of({Bezier({a, b}), Bezier({b, c})}, decisions);
    const auto common = intersections(p, q);
    EXPECT_EQ(common.overlaps.size(), 1U);
    const bool is_open = decisions == ba::Decisions::DOUBLE;
    ASSERT_EQ(common.points.size(), is_open ? 1U : 0U);
    if (!is_open) continue;
    EXPECT_EQ(common.points.front().kind, Kind::UNDECIDED);
    EXPECT_TRUE(touch(common.points.front().a.t, {0.5, 0.5}));
  }
}

// Ends of lines that miss others by 1e-11 to 1e-14: a crossing beside two ends that are not one point is a crossing.
TEST(Intersections, BesideEndsThatAreNotOneAreFound) {
  const std::vector<Bezier> lines{Bezier(Points{{0, 0}, {-2, -2}}), Bezier(Points{{-2, -1.9999999999908515}, {4, -2}}),
                                  Bezier(Points{{3.9999999981730983, -2.0000000018269017}, {-3, -2}}),
                                  Bezier(Points{{-2.999999916418225, -1.9999999164182252}, {-1, -2}}),
                                  Bezier(Points{{-1, -2.0000000000000067}, {-2, 1}})};
  for (const Bezier& p : lines)
    for (const Bezier& q : lines) {
      if (&p == &q) continue;
      EXPECT_EQ(ba::intersections(index_of({p}), index_of({q})).points.size(),
                ba::exact_intersections(ba::exact_bezier(p), ba::exact_bezier(q)).points.size())
          << text_of(p) << text_of(q);
    }
}

TEST(Intersections, OfNothingAreNone) {
  const ba::Bounding_arc_tree_2 nothing{ba::Drawing_2<double>()}, segment = polygon({{0, 0}, {1, 1}});
  EXPECT_TRUE(intersections(nothing, segment).points.empty());
  EXPECT_TRUE(ba::self_intersections(nothing).points.empty());
  EXPECT_EQ(ba::do_intersect(nothing, nothing), false);
  const ba::Bounding_arc_tree_2 point = polygon({{0.5, 0.5}, {0.5, 0.5}});
  EXPECT_EQ(ba::do_intersect(point, segment), true);
  EXPECT_EQ(ba::do_intersect(polygon({{0.5, 0.25}, {0.5, 0.25}}), segment), false);
}

}  // namespace
}  // namespace test_known_intersections
