// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Convex hulls, beside those of many samples and where they are known.

#include "../../src/library/tree/Segment_hierarchy.h"
#include "cases.h"
#include "closed_drawings.h"
#include "convex_polygon.h"
#include "query_drawings.h"

#include <CGAL/Bounding_arcs_2/query/convex_hull.h>
#include <CGAL/Bounding_arcs_2/query/enclosing_circle.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <random>
#include <stdexcept>
#include <string>
#include <vector>

namespace test_convex_hull {
namespace {

using namespace bounding_arcs_test;
namespace ba = CGAL::Bounding_arcs;
using ba::Bounding_arc_tree_2;
using ba::Convex_hull;
using Point = ba::Xy<double>;
using Points = std::vector<Point>;

Point at(const Bounding_arc_tree_2& index, const ba::Curve_place& place) {
  return index.in_unit().evaluator(index.in_unit().number_of_bezier(place.curve, place.bezier))(place.t).point;
}
// The chain of a hull as a polygon.
Points outline(const Bounding_arc_tree_2& index, const Convex_hull<>& hull) {
  Points points;
  constexpr int PARTS = 256;
  for (const Convex_hull<>::Piece& p : hull.pieces) {
    points.push_back(p.from_point);
    if (p.is_bitangent) continue;
    for (int i = 1; i < PARTS; ++i) {
      ba::Curve_place place = p.from;
      place.t += (p.to.t - p.from.t) * i / PARTS;
      points.push_back(at(index, place));
    }
  }
  return points;
}
double signed_area(const Points& p) {
  double sum = 0;
  for (std::size_t i = 0; i < p.size(); ++i) sum += cross(Point(p[i] - p[0]), Point(p[(i + 1) % p.size()] - p[0])) / 2;
  return sum;
}

// A closed chain on the curves, convex and about all samples, but for `room`.
void expect_hull(const Bounding_arc_tree_2& index, const Convex_hull<>& hull, double room, const std::string& name) {
  ASSERT_FALSE(hull.pieces.empty()) << name;
  for (std::size_t i = 0; i < hull.pieces.size(); ++i) {
    const Convex_hull<>::Piece &p = hull.pieces[i], &next = hull.pieces[(i + 1) % hull.pieces.size()];
    EXPECT_LE(ba::euclidean_norm(p.to_point - next.from_point), 1e-3 * room) << name;
    EXPECT_LE(ba::euclidean_norm(at(index, p.from) - p.from_point), 1e-3 * room) << name;
    EXPECT_LE(ba::euclidean_norm(at(index, p.to) - p.to_point), 1e-3 * room) << name;
    if (!p.is_bitangent) {
      EXPECT_EQ(p.from.curve, p.to.curve) << name;
      EXPECT_EQ(p.from.bezier, p.to.bezier) << name;
    }
  }
  const Points chain = outline(index, hull), convex = convex_polygon(chain);
  for (const Point& q : sampled_points(index, 40)) {
    double out = 0;
    for (std::size_t i = 0; i < convex.size() && convex.size() > 2; ++i) {
      const Point edge = convex[(i + 1) % convex.size()] - convex[i];
      out = (std::max)(out, -cross(edge, q - convex[i]) / ba::euclidean_norm(edge));
    }
    // of the outline's own chords 1 / 256^2 of what they turn by
    EXPECT_LE(out, room) << name;
  }
  // as much inside as its own convex hull
  EXPECT_NEAR(signed_area(chain), signed_area(convex), 40 * room * room + 1e-3 * std::fabs(signed_area(convex)) * room)
      << name;
}

TEST(ConvexHull, IsAboutAllSamplesOfRandomDrawings) {
  std::mt19937 random(1);
  const Placing places[] = {{}, {1e-9, 0, 0}, {1e9, 0, 0}, {1, 1e8, -3e8}, {1.0 / 3, 0.1, 0.7}};
  int bitangents = 0, curves = 0;
  for (int i = 0; i < cases(1000); ++i) {
    const Placing& place = places[i % 5];
    const Bounding_arc_tree_2 index(random_lattice_drawing(random, 5, place));
    const Convex_hull<> hull = ba::convex_hull(index, 1e-6 * place.scale);
    EXPECT_LE(hull.height, 1.01e-6 * place.scale + 1e-13 * std::fabs(place.y) * 100);
    expect_hull(index, hull, 5e-3 * place.scale, "drawing " + std::to_string(i));
    for (const Convex_hull<>::Piece& p : hull.pieces) ++(p.is_bitangent ? bitangents : curves);
    if (HasFailure()) return;
  }
  EXPECT_GT(bitangents, cases(1000));
  EXPECT_GT(curves, cases(1000));
}

TEST(ConvexHull, OfOneCircleIsTheCircle) {
  ba::Drawing_2<double> drawing;
  drawing.add(circle_of_quarters({5, 1, 2}));
  const Bounding_arc_tree_2 index(drawing);
  const Convex_hull<> hull = ba::convex_hull(index, 1e-6);
  ASSERT_EQ(hull.pieces.size(), 4U);
  for (const Convex_hull<>::Piece& p : hull.pieces) {
    EXPECT_FALSE(p.is_bitangent);
    EXPECT_EQ(p.from.t, 0);
    EXPECT_EQ(p.to.t, 1);
  }
  const auto circle = ba::smallest_enclosing_circle(index, 1e-9);
  ASSERT_TRUE(circle);
  EXPECT_LE(circle->radius.lower, 5);
  EXPECT_GE(circle->radius.upper, 5);
  EXPECT_LT(circle->radius.upper - circle->radius.lower, 1e-9);
  const auto width = ba::width(index, 1e-7);
  const std::optional<ba::Diameter_of_drawing<>> diameter = ba::diameter(index, 1e-7);
  ASSERT_TRUE(width && diameter);
  for (const ba::Measure_bounds& b : {width->width, diameter->diameter}) {
    EXPECT_LE(b.lower, 10);
    EXPECT_GE(b.upper, 10);
    EXPECT_LT(b.upper - b.lower, 1e-7);
  }
  EXPECT_NEAR(ba::euclidean_norm(diameter->second_point - diameter->first_point), 10, 1e-7);
  EXPECT_NEAR(ba::euclidean_norm(at(index, diameter->first) - diameter->first_point), 0, 1e-14);
}

// Circles with radii 5 and 1, centers 8 apart: touched where the normal's share along is (5 - 1) / 8.
TEST(ConvexHull, OfTwoCirclesHasTheirBitangentsAtFullPrecision) {
  ba::Drawing_2<double> drawing;
  drawing.add(circle_of_quarters({5, 0, 0}));
  drawing.add(circle_of_quarters({1, 8, 0}));
  const Bounding_arc_tree_2 index(drawing);
  for (const double tolerance : {1e-2, 1e-5}) {
    const Convex_hull<> hull = ba::convex_hull(index, tolerance);
    const double high = std::sqrt(3.0) / 2;
    int found = 0;
    for (const Convex_hull<>::Piece& p : hull.pieces) {
      if (!p.is_bitangent) continue;
      ++found;
      const bool is_upper = p.from_point.y > 0;
      const Point left = is_upper ? p.to_point : p.from_point, right = is_upper ? p.from_point : p.to_point;
      const double side = is_upper ? 1 : -1;
      EXPECT_NEAR(left.x, 2.5, 1e-13);
      EXPECT_NEAR(left.y, side * 5 * high, 1e-13);
      EXPECT_NEAR(right.x, 8.5, 1e-13);
      EXPECT_NEAR(right.y, side * high, 1e-13);
    }
    EXPECT_EQ(found, 2);
    // three quarters and two parts of the large one, parts of the small one
    EXPECT_EQ(hull.pieces.size(), 2U + 4U + 2U);
  }
  EXPECT_NEAR(ba::diameter(index, 1e-9)->diameter.lower, 14, 1e-9);
  EXPECT_NEAR(ba::width(index, 1e-6)->width.upper, 10, 1e-6);
  const auto circle = ba::smallest_enclosing_circle(index, 1e-10);
  EXPECT_NEAR(circle->radius.lower, 7, 1e-10);
  EXPECT_NEAR(circle->radius.upper, 7, 1e-10);
  EXPECT_NEAR(circle->center.x(), 2, 1e-9);
}

TEST(ConvexHull, LeavesOutWhatIsHollow) {
  ba::Drawing_2<double> drawing;  // a segment and a parabola hollow on its other side
  drawing.add({Lattice_curve({{0, 0}, {2, 0}}), Lattice_curve({{2, 0}, {2, 2}}),
               Lattice_curve({{2, 2}, {1, 0}, {0, 2}}), Lattice_curve({{0, 2}, {0, 0}})});
  const Bounding_arc_tree_2 index(drawing);
  const Convex_hull<> hull = ba::convex_hull(index, 1e-6);
  ASSERT_EQ(hull.pieces.size(), 4U);
  int bitangents = 0;
  for (const Convex_hull<>::Piece& p : hull.pieces)
    if (p.is_bitangent) {
      ++bitangents;
      EXPECT_EQ(p.from_point, (Point{2, 2}));
      EXPECT_EQ(p.to_point, (Point{0, 2}));
    }
  EXPECT_EQ(bitangents, 1);
  EXPECT_NEAR(ba::width(index, 1e-9)->width.lower, 2, 1e-9);
  EXPECT_NEAR(ba::diameter(index, 1e-9)->diameter.upper, std::sqrt(8.0), 1e-9);
  EXPECT_NEAR(ba::smallest_enclosing_circle(index, 1e-9)->radius.upper, std::sqrt(2.0), 1e-9);
}

// One segment, lower than the tolerance: its samples are corners of the polygon next to each other.
TEST(ConvexHull, LeavesOutWhatIsHollowByLessThanTheTolerance) {
  for (const double depth : {1e-8, -1e-8}) {
    ba::Drawing_2<double> drawing;
    drawing.add({Lattice_curve({{0, 0}, {2, 0}}), Lattice_curve({{2, 0}, {1.2 - depth, 0.4 - 2 * depth}, {0, 1}}),
                 Lattice_curve({{0, 1}, {0, 0}})});
    const Bounding_arc_tree_2 index(drawing);
    ASSERT_EQ(index.in_unit().number_of_segments(), 3U);
    const Convex_hull<> hull = ba::convex_hull(index, 1e-6);
    ASSERT_EQ(hull.pieces.size(), 3U);
    for (const Convex_hull<>::Piece& p : hull.pieces) {
      const bool is_hollow = depth > 0 && p.from_point == Point{2, 0};
      EXPECT_EQ(p.is_bitangent, is_hollow);
    }
  }
}

TEST(ConvexHull, IsFlatForPointsAndLinesAndEmptyForNothing) {
  const Bounding_arc_tree_2 none{ba::Drawing_2<double>()};
  EXPECT_TRUE(ba::convex_hull(none, 1e-3).pieces.empty());
  EXPECT_FALSE(ba::width(none, 0));
  EXPECT_FALSE(ba::diameter(none, 0));
  EXPECT_FALSE(ba::smallest_enclosing_circle(none, 0));
  EXPECT_THROW((void)ba::convex_hull(none, -1), std::invalid_argument);
  ba::Drawing_2<double> point;
  point.add(Lattice_curve({{4, 5}, {4, 5}}));
  const Bounding_arc_tree_2 single(point);
  ASSERT_EQ(ba::convex_hull(single, 0).pieces.size(), 1U);
  EXPECT_EQ(ba::convex_hull(single, 0).pieces[0].to_point, ba::Default_kernel::Point_2(4, 5));
  EXPECT_LE(ba::width(single, 0)->width.upper, 1e-12);
  EXPECT_LE(ba::diameter(single, 0)->diameter.upper, 1e-12);
  EXPECT_LE(ba::smallest_enclosing_circle(single, 0)->radius.upper, 1e-12);
  ba::Drawing_2<double> line;
  line.add(Lattice_curve({{0, 0}, {2, 2}, {3, 3}}));
  const Bounding_arc_tree_2 straight(line);
  const Convex_hull<> both = ba::convex_hull(straight, 0);
  ASSERT_EQ(both.pieces.size(), 2U);
  EXPECT_FALSE(both.pieces[0].is_bitangent);
  EXPECT_EQ(both.pieces[0].from_point, both.pieces[1].to_point);
  EXPECT_LE(ba::width(straight, 0)->width.upper, 1e-12);
  EXPECT_NEAR(ba::diameter(straight, 0)->diameter.lower, std::sqrt(18.0), 1e-12);
  EXPECT_NEAR(ba::smallest_enclosing_circle(straight, 0)->radius.lower, std::sqrt(4.5), 1e-12);
}

// How far a hull's chain reaches in a direction: parts of curves turn to one side, so that thirds find the farthest.
Real reach(const Scanned_drawing& curves, const Convex_hull<>& hull, const Vector& n) {
  Real most = -HUGE_VALL;
  for (const Convex_hull<>::Piece& p : hull.pieces) {
    Real low = p.from.t, high = p.to.t;
    const auto at = [&](Real t) { return dot(n, curves.at_place(p.from, t)); };
    most = (std::max)({most, at(low), dot(n, widened(p.to_point))});
    if (p.is_bitangent) continue;
    for (int step = 0; step < 80; ++step) {
      const Real left = low + (high - low) / 3, right = high - (high - low) / 3, a = at(left), b = at(right);
      most = (std::max)({most, a, b});
      (a < b ? low : high) = a < b ? left : right;
    }
  }
  return most;
}

// However fine the tolerance, pieces are few, and the chain reaches as far as the curves do.
TEST(ConvexHull, KeepsPartsWholeAtFineTolerances) {
  std::mt19937 random(7);
  for (int i = 0; i < cases(40); ++i) {
    const Drawing drawing = random_drawing(random);
    const Bounding_arc_tree_2 index(drawing);
    const Scanned_drawing curves(drawing);
    for (const double tolerance : {1e-8, 1e-12, 0.0}) {
      const Convex_hull<> hull = ba::convex_hull(index, tolerance);
      EXPECT_NE(hull.status, ba::Query_status::LIMIT_REACHED) << i;
      EXPECT_LE(hull.pieces.size(), 4 * index.in_unit().number_of_segments()) << i;
      EXPECT_LE(hull.height, tolerance + 300 * error_of(index)) << i;
      for (int k = 0; k < 7; ++k) {
        const Real angle = 0.9L * k + 0.01L * i;
        const Vector n{std::cos(angle), std::sin(angle)};
        const Real farthest = -curves.least([&](const Vector& p) { return -dot(n, p); });
        EXPECT_NEAR(static_cast<double>(reach(curves, hull, n) - farthest), 0, hull.height + 1e-13) << i;
      }
    }
    if (HasFailure()) return;
  }
}

// Each piece has a twin, so that none is the cap of an edge: all are halved, and each round looks at all of them.
TEST(ConvexHull, EndsForACurveTracedTwice) {
  const Bezier curve({{-0.5, -1.5}, {-1.5, 1}, {0.5, -1.5}, {-1.5, 1}, {-0.5, -1.5}});
  const Bounding_arc_tree_2 curves(drawing_of(curve), ba::Decisions::DOUBLE);
  const auto hull = ba::convex_hull(curves, 1e-15);
  EXPECT_EQ(hull.status, ba::Query_status::LIMIT_REACHED);
  EXPECT_LT(hull.height, 1e-10);
}

}  // namespace
}  // namespace test_convex_hull
