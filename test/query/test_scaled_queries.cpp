// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Queries of drawings of any size: the same bits but for the scale, and points and shapes at the ends of the range.

#include "cases.h"
#include "closed_drawings.h"
#include "scaled_answers.h"

#include <CGAL/Bounding_arcs_2/query/closest_point.h>
#include <CGAL/Bounding_arcs_2/query/convex_hull.h>
#include <CGAL/Bounding_arcs_2/query/distance.h>
#include <CGAL/Bounding_arcs_2/query/enclosing_circle.h>
#include <CGAL/Bounding_arcs_2/query/intersections.h>
#include <CGAL/Bounding_arcs_2/query/measures.h>
#include <CGAL/Bounding_arcs_2/query/ray_hits.h>
#include <CGAL/Bounding_arcs_2/query/shapes.h>
#include <CGAL/Bounding_arcs_2/query/signed_distance.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>
#include <stdexcept>
#include <utility>
#include <vector>

namespace test_scaled_queries {
namespace {

using namespace bounding_arcs_test;
using ba::Bounding_arc_tree_2;
using ba::Decisions;
using ba::intersections;

void add(Answers& to, const ba::Closest_point<>& p) { to.lengths(p.distance), to.point(p.point), to.place(p.place); }
void add(Answers& to, const ba::Drawing_distance<>& d) {
  to.lengths(d.distance);
  for (const ba::Drawing_distance<>::End* p : {&d.a, &d.b}) to.point(p->point), to.place(p->place);
}
void add(Answers& to, const ba::Bracket& t) { to.number(t.lower), to.number(t.upper); }
void add(Answers& to, const ba::Intersections_2<>& found) {
  for (const auto& i : found.points) {
    to.point(i.point), to.count(static_cast<std::size_t>(i.kind));
    add(to, i.a.t), add(to, i.b.t);
  }
  for (const auto& o : found.overlaps) add(to, o.a_from.t), add(to, o.a_to.t), add(to, o.b_from.t), add(to, o.b_to.t);
  to.count(found.points.size()), to.count(found.overlaps.size());
}

void ask_points(Answers& to, const Bounding_arc_tree_2& index, double scale, bool is_closed) {
  for (const Point& q :
       {Point{0.01, 0.02}, Point{-0.03, 0.05}, Point{0.125, 0}, Point{0.25, -0.7}, Point{0x1p-30, 0}}) {
    const Point p = scale * q;
    to.of("closest point");
    add(to, *ba::closest_point(index, p));
    add(to, *ba::closest_point(index, p, {0, 0, 0.5}));
    to.of("closest points");
    for (const auto& c : ba::closest_points(index, p, scale * 0.01)) add(to, c);
    to.of("nearest curves");
    for (const auto& c : ba::k_nearest_curves(index, p, 2)) add(to, c);
    to.of("ray");
    for (const auto& hit : ba::ray_hits(index, p, {-3, 1})) to.place(hit.place), to.lengths(hit.distance);
    if (!is_closed) continue;
    to.of("winding number");
    const ba::Winding_number w = ba::winding_number(index, p);
    to.count(static_cast<std::size_t>(w.state)), to.number(w.number);
    to.of("signed distance");
    to.lengths(ba::signed_distance(index, p)->distance);
  }
  to.of("closest points of all");
  for (const auto& c : ba::closest_points_of_all(index, std::vector<Point>{{0, 0}, scale * Point{0.01, 0.01}}))
    add(to, c);
}

void ask_shape(Answers& to, const Bounding_arc_tree_2& index, double scale, bool is_closed) {
  const double eps = scale * 1e-6;
  to.of("hull");
  const ba::Convex_hull<> hull = ba::convex_hull(index, eps);
  to.length(hull.height);
  for (const auto& p : hull.pieces) to.place(p.from), to.place(p.to), to.point(p.from_point), to.point(p.to_point);
  to.of("width");
  to.lengths(ba::width(index, eps)->width);
  to.of("diameter");
  const ba::Diameter_of_drawing<> diameter = *ba::diameter(index, eps);
  to.lengths(diameter.diameter), to.point(diameter.first_point), to.place(diameter.second);
  to.of("circle");
  const ba::Enclosing_circle<> circle = *ba::smallest_enclosing_circle(index, eps);
  to.point(circle.center), to.lengths(circle.radius);
  to.of("length");
  to.lengths(ba::length(index, eps));
  to.of("box");
  to.length(index.box().xmin()), to.length(index.box().ymax());
  if (!is_closed) return;
  to.of("area");
  to.areas(ba::area(index, eps * scale));
  to.of("centroid");
  if (const auto c = ba::centroid(index, 1e-6)) to.lengths(c->x), to.lengths(c->y);
}

Answers answers(const Drawing& a, const Drawing& b, double scale, Decisions decisions) {
  const Bounding_arc_tree_2 of_a(moved(a, scale, {0, 0}), decisions), of_b(moved(b, scale, {0, 0}), decisions);
  const auto& curves = a.curves();
  const bool is_closed = std::all_of(curves.begin(), curves.end(), [](const auto& c) { return c.is_closed; });
  Answers to;
  ask_points(to, of_a, scale, is_closed);
  ask_shape(to, of_a, scale, is_closed);
  to.of("distance");
  add(to, *ba::distance(of_a, of_b, 1e-9 * scale));
  to.of("Hausdorff distance");
  add(to, *ba::hausdorff_distance(of_a, of_b, scale * 1e-4));
  to.of("intersections");
  add(to, intersections(of_a, of_b));
  to.of("self-intersections");
  add(to, ba::self_intersections(of_a));
  to.of("whether curves meet");
  const auto meet = ba::do_intersect(of_a, of_b);
  to.count(meet ? (*meet ? 1U : 0U) : 2U);
  to.of("intersections with a circle");
  add(to,
      intersections(of_a, Bounding_arc_tree_2(ba::circle_drawing(scale * Point{0.01, 0}, scale * 0.04), decisions)));
  to.of("intersections of two pieces");
  for (const auto& p :
       intersections(of_a.drawing().curves()[0].beziers[0], of_b.drawing().curves()[0].beziers[0]).points)
    add(to, p.a), add(to, p.b);
  return to;
}

Drawing closed_drawing(std::mt19937& random) {
  Drawing drawing;
  drawing.add(closed_curve(random, {0, 0}, 5));
  drawing.add(circle({0.5, 0.25}, 0.6));
  drawing.add(random_lattice_chain(random, 3));
  return drawing;
}

void expect_same_at_all_scales(const Drawing& a, const Drawing& b, Decisions decisions,
                               const std::vector<int>& exponents) {
  const Answers unscaled = answers(a, b, 1, decisions);
  EXPECT_GT(unscaled.size(), 100U);
  for (const int k : exponents) {
    answers(a, b, std::ldexp(1.0, k), decisions).expect_scaled(unscaled, k);
    if (testing::Test::HasFailure()) return;
  }
}

TEST(ScaledQueries, AreTheSameBitsButForTheScale) {
  std::mt19937 random(1);
  for (int i = 0; i < 4; ++i) {
    SCOPED_TRACE(i);
    const Drawing a = small_drawing(i % 2 == 0 ? random_drawing(random) : closed_drawing(random)),
                  b = small_drawing(random_drawing(random));
    const auto decisions = i < 2 ? Decisions::EXACT : Decisions::DOUBLE;
    expect_same_at_all_scales(a, b, decisions, exponents(random, cases(1)));
    if (HasFailure()) return;
  }
}

// Weights, of which only ratios matter, as large and as small as they may be.
TEST(ScaledQueries, AreTheSameBitsForAllSizesOfWeights) {
  std::mt19937 random(2);
  const Drawing other = small_drawing(random_drawing(random));
  const auto weighed = [](double by) {
    Drawing drawing;
    drawing.add(Bezier({{0, 0}, {0.03, 0.06}, {0.06, -0.01}}, {by, 3 * by, 2 * by}));
    return drawing;
  };
  const Answers known = answers(weighed(1), other, 1, Decisions::EXACT);
  for (const int k : {-498, -300, 300, 498}) {
    answers(weighed(std::ldexp(1.0, k)), other, 1, Decisions::EXACT).expect_scaled(known, 0);
    answers(weighed(std::ldexp(1.0, k)), other, std::ldexp(1.0, -k), Decisions::EXACT).expect_scaled(known, -k);
    if (HasFailure()) return;
  }
}

// Numbers that are no doubles: thirds.
TEST(ScaledQueries, OfExactNumbersAreTheSameBits) {
  using Rational = CGAL::Exact_rational;
  const auto drawing = [](int k) {
    const Rational unit = Rational(std::ldexp(1.0, k)) / Rational(3);
    const auto at = [&](int x, int y) { return ba::Xy<Rational>{Rational(unit * x), Rational(unit * y)}; };
    ba::Drawing_2<Rational> result;
    result.add(ba::Bezier_curve_2<Rational>({at(0, 0), at(1, 1), at(1, 0), at(0, 0)}));
    return result;
  };
  const auto ask = [&](int k) {
    const double scale = std::ldexp(1.0, k);
    Answers to;
    ask_points(to, Bounding_arc_tree_2(drawing(k)), scale, true);
    ask_shape(to, Bounding_arc_tree_2(drawing(k)), scale, true);
    to.of("distance");
    add(to, *ba::distance(Bounding_arc_tree_2(drawing(k)),
                          Bounding_arc_tree_2(drawing_of(segment({scale, 0}, {0, scale})))));
    return to;
  };
  const Answers unscaled = ask(0);
  for (const int k : {-490, -41, 100, 490}) {
    ask(k).expect_scaled(unscaled, k);
    if (HasFailure()) return;
  }
}

// Two drawings of which one is far larger, in any order: distances are those from a point.
TEST(ScaledQueries, OfTwoSizesAreTold) {
  const Bounding_arc_tree_2 unit(drawing_of(segment({1, 1}, {1, -1}))),
      speck(drawing_of(segment({0, 0}, {0x1p-400, 0}))), huge(drawing_of(circle({0, 0}, 0x1p400)));
  for (const auto& found : {*ba::distance(unit, speck), *ba::distance(speck, unit)}) {
    EXPECT_LE(found.distance.lower, 1);
    EXPECT_GE(found.distance.upper, 1);
    EXPECT_NEAR(found.distance.upper, 1, 1e-12);
  }
  for (const auto& found : {*ba::distance(unit, huge), *ba::distance(huge, speck)})
    EXPECT_NEAR(found.distance.upper * 0x1p-400, 1, 1e-12);
  EXPECT_NEAR(ba::hausdorff_distance(huge, unit, 0x1p380)->distance.upper * 0x1p-400, 1, 1e-5);
  EXPECT_TRUE(intersections(unit, huge).points.empty());
  const Bounding_arc_tree_2 through(drawing_of(segment({0, -0x1p450}, {0, 0x1p450})));
  EXPECT_EQ(intersections(speck, through).points.size(), 1U);
  EXPECT_EQ(intersections(through, huge).points.size(), 2U);
}

// Curves beside others that are far larger: squares of their distances are no doubles any more.
TEST(ScaledQueries, HoldDistancesToSpecks) {
  std::mt19937 random(4);
  std::uniform_real_distribution<double> unit(-1, 1);
  for (int i = 0; i < cases(100) && !HasFailure(); ++i) {
    SCOPED_TRACE(i);
    const double scale = std::ldexp(1.0, static_cast<int>(random() % 401)),
                 speck = scale * std::ldexp(1.0, -static_cast<int>(random() % 1001));
    Drawing drawing = moved(random_drawing(random), speck, {0, 0});
    drawing.add(segment({2 * scale, scale}, {2 * scale, -scale}));
    const Scanned_drawing scanned(drawing);
    const Bounding_arc_tree_2 index(drawing, Decisions::DOUBLE);
    for (int k = 0; k < 4; ++k) {
      const Point q = 2 * speck * Point{unit(random), unit(random)};
      const Real known = scanned.distance(widened(q));
      const ba::Closest_point<> found = *ba::closest_point(index, q);
      EXPECT_LE(found.distance.lower, known * (1 + 0x1p-40L));
      EXPECT_GE(found.distance.upper, known * (1 - 0x1p-40L));
      EXPECT_LE(found.distance.upper - found.distance.lower,
                0x1p-36 * (found.distance.upper + speck) + 0x1p-200 * scale);
    }
  }
}
TEST(ScaledQueries, FindCommonPointsOfSpecks) {
  std::mt19937 random(5);
  for (int i = 0; i < cases(40) && !HasFailure(); ++i) {
    SCOPED_TRACE(i);
    const Drawing a = random_drawing(random), b = random_drawing(random);
    const double scale = std::ldexp(1.0, static_cast<int>(random() % 401)),
                 speck = scale * std::ldexp(1.0, -static_cast<int>(random() % 900));
    const auto beside = [&](const Drawing& drawing, double x) {
      Drawing result = moved(drawing, speck, {0, 0});
      result.add(segment({x * scale, scale}, {x * scale, -scale}));
      return Bounding_arc_tree_2(result);
    };
    const auto known = intersections(Bounding_arc_tree_2(a), Bounding_arc_tree_2(b)),
               found = intersections(beside(a, 2), beside(b, 3));
    EXPECT_EQ(found.points.size(), known.points.size());
    EXPECT_EQ(found.overlaps.size(), known.overlaps.size());
    EXPECT_EQ(ba::self_intersections(beside(a, 2)).points.size(),
              ba::self_intersections(Bounding_arc_tree_2(a)).points.size());
  }
}

// A coordinate that no double in the drawing's unit is near to: told by exact numbers.
TEST(ScaledQueries, CountTheSmallestCoordinates) {
  const double huge = 0x1p490;
  const Bounding_arc_tree_2 index(
      drawing_of(polygon({{0x1p-1000, -huge}, {huge, -huge}, {huge, huge}, {0x1p-1000, huge}})));
  EXPECT_EQ(ba::locate(index, {0, 0}), CGAL::ON_UNBOUNDED_SIDE);
  EXPECT_EQ(ba::locate(index, {1, 0}), CGAL::ON_BOUNDED_SIDE);
  EXPECT_THROW(static_cast<void>(ba::locate(index, {0x1p-1001, 0})), std::invalid_argument);
}

// Curves as small as doubles are, whose area is none.
TEST(ScaledQueries, AreBracketsAtTheEndOfTheRange) {
  const double tiny = std::numeric_limits<double>::denorm_min();
  const Bounding_arc_tree_2 index(drawing_of(polygon({{0, 0}, {4 * tiny, 0}, {4 * tiny, 3 * tiny}})));
  const ba::Measure_bounds area = ba::area(index, 0), length = ba::length(index, 0);
  EXPECT_EQ(area.lower, 0);
  EXPECT_EQ(area.upper, tiny);
  EXPECT_LE(length.lower, 12 * tiny);
  EXPECT_GE(length.upper, 12 * tiny);
  EXPECT_LE(length.upper, 13 * tiny);
  EXPECT_EQ(ba::locate(index, {3 * tiny, tiny}), CGAL::ON_BOUNDED_SIDE);
}

// As far as they are served, and no farther.
TEST(ScaledQueries, ServePointsToTheEndOfTheRange) {
  std::mt19937 random(3);
  std::uniform_real_distribution<double> unit(-1, 1);
  for (int i = 0; i < cases(60) && !HasFailure(); ++i) {
    SCOPED_TRACE(i);
    const Drawing drawing = random_drawing(random);
    const Bounding_arc_tree_2 index(drawing, Decisions::DOUBLE);
    const double size = 2 * size_of(drawing), far = std::ldexp(1.0, 1 + static_cast<int>(random() % 499));
    const Point q = far * Point{unit(random), unit(random)};
    const ba::Closest_point<> found = *ba::closest_point(index, q);
    const double d = std::hypot(q.x, q.y), room = size + 0x1p-48 * d;
    EXPECT_GE(found.distance.upper, d - room);
    EXPECT_LE(found.distance.lower, d + room);
    EXPECT_LE(found.distance.upper - found.distance.lower, 0x1p-40 * d + 0x1p-40);
    EXPECT_FALSE(ba::closest_points(index, q, 1e-9).empty());
    EXPECT_FALSE(ba::k_nearest_curves(index, q, 2).empty());
    static_cast<void>(ba::ray_hits(index, q, -q));
  }
}
TEST(ScaledQueries, RefusePointsOutOfRange) {
  for (const double scale : {1.0, 0x1p-400, 0x1p400}) {
    const Bounding_arc_tree_2 index(drawing_of(circle({0, 0}, scale)));
    for (const double far : {1.1 * 0x1p500, 1.4e154, 1e300, 1e308}) {
      EXPECT_THROW(static_cast<void>(ba::closest_point(index, {far, 0})), std::invalid_argument);
      EXPECT_THROW(static_cast<void>(ba::closest_points(index, {0, far}, 1)), std::invalid_argument);
      EXPECT_THROW(static_cast<void>(ba::k_nearest_curves(index, {far, far}, 1)), std::invalid_argument);
      EXPECT_THROW(static_cast<void>(ba::locate(index, {0, -far})), std::invalid_argument);
      EXPECT_THROW(static_cast<void>(ba::ray_hits(index, {far, 0}, {1, 0})), std::invalid_argument);
      EXPECT_THROW(static_cast<void>(ba::closest_points_of_all(index, std::vector<Point>{{far, 0}})),
                   std::invalid_argument);
    }
  }
  const Bounding_arc_tree_2 small(drawing_of(circle({0, 0}, 0x1p-400)));
  EXPECT_THROW(static_cast<void>(ba::closest_point(small, {0x1p150, 0})), std::invalid_argument);
}

// Lines reach beyond a drawing as large as they may be.
TEST(ScaledQueries, MeetLinesAtAllScales) {
  for (int k = -500; k <= 500; k += 50) {
    const double scale = std::ldexp(1.0, k);
    const Bounding_arc_tree_2 index(drawing_of(circle({0, 0}, scale)));
    const Bounding_arc_tree_2 line(ba::line_drawing(index, {0, 0.5 * scale}, {3, 1})),
        ray(ba::ray_drawing(index, {0, 0.5 * scale}, {3, 1}));
    EXPECT_EQ(intersections(index, line).points.size(), 2U) << k;
    EXPECT_EQ(intersections(index, ray).points.size(), 1U) << k;
  }
}

}  // namespace
}  // namespace test_scaled_queries
