// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Every query on the list of hard cases, beside what is known of them and scans in long double.

#include "../../src/library/tree/Segment_hierarchy.h"
#include "cases.h"
#include "convex_polygon.h"
#include "hard_cases.h"
#include "query_drawings.h"

#include <CGAL/Bounding_arcs_2/query/closest_point.h>
#include <CGAL/Bounding_arcs_2/query/convex_hull.h>
#include <CGAL/Bounding_arcs_2/query/distance.h>
#include <CGAL/Bounding_arcs_2/query/enclosing_circle.h>
#include <CGAL/Bounding_arcs_2/query/intersections.h>
#include <CGAL/Bounding_arcs_2/query/measures.h>
#include <CGAL/Bounding_arcs_2/query/point_location.h>
#include <CGAL/Bounding_arcs_2/query/ray_hits.h>

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <string>
#include <tuple>
#include <vector>

namespace test_hard_cases {
namespace {

using namespace bounding_arcs_test;
using ba::Bounding_arc_tree_2;
using ba::Intersection_kind;
using Json = nlohmann::json;
using ba::intersections;

template <class Check> void for_each_case(const char* key, const Check& check) {
  std::size_t checked = 0;
  for (const Case_placing& at : CASE_PLACINGS)
    for (const Hard_case& c : hard_cases(at)) {
      if (*key != '\0' && !c.expected.contains(key)) continue;
      SCOPED_TRACE(c.name + ", " + std::to_string(at.scale) + " times, by " + std::to_string(at.x));
      check(c);
      ++checked;
    }
  EXPECT_GT(checked, 0U);
}

// What coordinates and a length that was told in doubles are rounded by.
double rounding(const Hard_case& c) { return 1e-12 * c.at.scale + 0x1p-44 * std::fabs(c.at.x); }
template <class Bounds> void expect_holds(const Bounds& b, double value, double width) {
  EXPECT_LE(b.lower, value * (1 + 0x1p-52));
  EXPECT_GE(b.upper, value * (1 - 0x1p-52));
  EXPECT_LE(b.upper - b.lower, width);
}

using Found = std::vector<std::tuple<double, double, bool>>;  // x, y, whether it is transversal
Found expected_points(const Hard_case& c) {
  Found points;
  for (const Json& p : c.expected["common"]) {
    const Point q = c.at(p[0].get<double>(), p[1].get<double>());
    points.emplace_back(q.x, q.y, p[2] == "transversal");
  }
  return points;
}
// Near enough to be the point in a range of a curve, which both hold the exact one.
bool is_near(const ba::Intersections_2<>::Intersection& found, double x, double y, const Drawing& a,
             const Hard_case& c) {
  const Scanned_drawing curves(a);
  const auto at = [&](double t) { return curves.at(ba::Curve_place{found.a.curve, found.a.bezier, t}); };
  const Real room = length(at(found.a.t.upper) - at(found.a.t.lower)) + rounding(c);
  return length(Vector{x, y} - widened(found.point)) <= room;
}
void expect_common(const ba::Intersections_2<>& found, const Drawing& a, const Hard_case& c) {
  Found points = expected_points(c);
  EXPECT_EQ(found.points.size(), points.size());
  EXPECT_EQ(found.overlaps.size(), c.expected["overlaps"].get<std::size_t>());
  for (const ba::Intersections_2<>::Intersection& p : found.points) {
    const auto match = std::find_if(points.begin(), points.end(), [&](const auto& q) {
      return is_near(p, std::get<0>(q), std::get<1>(q), a, c) &&
             (std::get<2>(q) ? Intersection_kind::TRANSVERSAL : Intersection_kind::TANGENTIAL) == p.kind;
    });
    ASSERT_NE(match, points.end()) << p.point.x << ' ' << p.point.y;
    points.erase(match);
  }
}

TEST(HardCases, HaveTheKnownIntersections) {
  for_each_case("common", [](const Hard_case& c) {
    const Bounding_arc_tree_2 a(c.a), b(c.b);
    expect_common(intersections(a, b), c.a, c);
    expect_common(intersections(b, a), c.b, c);
    const bool do_meet = !c.expected["common"].empty() || c.expected["overlaps"] != 0;
    EXPECT_EQ(ba::do_intersect(a, b), do_meet);
    if (!c.expected.contains("self")) return;
    const ba::Intersections_2<> own = ba::self_intersections(a);
    EXPECT_EQ(own.points.size(), c.expected["self"].get<std::size_t>());
    EXPECT_TRUE(own.overlaps.empty());
  });
}

TEST(HardCases, InDoublesAloneAreRightOrUndecided) {
  int decided = 0;
  for_each_case("common", [&](const Hard_case& c) {
    const Bounding_arc_tree_2 a(c.a, ba::Decisions::DOUBLE), b(c.b, ba::Decisions::DOUBLE);
    const ba::Intersections_2<> found = intersections(a, b);
    const bool do_meet = !c.expected["common"].empty() || c.expected["overlaps"] != 0;
    const auto verdict = ba::do_intersect(a, b);
    EXPECT_TRUE(!verdict || *verdict == do_meet);
    std::size_t open = 0;
    for (const ba::Intersections_2<>::Intersection& p : found.points) open += p.kind == Intersection_kind::UNDECIDED;
    if (open == 0) {
      expect_common(found, c.a, c);
      ++decided;
      return;
    }
    // what is told is there, and what is not told is in a range that is undecided
    const Found points = expected_points(c);
    EXPECT_LE(found.points.size() - open, points.size());
    for (const ba::Intersections_2<>::Intersection& p : found.points) {
      if (p.kind == Intersection_kind::UNDECIDED) continue;
      EXPECT_TRUE(std::any_of(points.begin(), points.end(),
                              [&](const auto& q) { return is_near(p, std::get<0>(q), std::get<1>(q), c.a, c); }));
    }
  });
  EXPECT_GT(decided, 20);
}

TEST(HardCases, OfExactNumbersAreTheSame) {
  for (const Hard_case& c : hard_cases({})) {
    SCOPED_TRACE(c.name);
    const auto middle = c.records.begin() + static_cast<std::ptrdiff_t>(c.first);
    const Bounding_arc_tree_2 a(ba::drawing<CGAL::Exact_rational>({c.records.begin(), middle})),
        b(ba::drawing<CGAL::Exact_rational>({middle, c.records.end()}));
    if (c.expected.contains("common")) expect_common(intersections(a, b), c.a, c);
    const auto exact = ba::distance(a, b)->distance,
               filtered = ba::distance(Bounding_arc_tree_2(c.a), Bounding_arc_tree_2(c.b))->distance;
    EXPECT_LE(exact.lower, filtered.upper);
    EXPECT_LE(filtered.lower, exact.upper);
  }
}

TEST(HardCases, HaveTheKnownDistances) {
  for_each_case("distance", [](const Hard_case& c) {
    const Bounding_arc_tree_2 a(c.a), b(c.b);
    const double d = c.expected["distance"].get<double>() * c.at.scale;
    expect_holds(ba::distance(a, b)->distance, d, 1e-12 * d + rounding(c));
    expect_holds(ba::distance(b, a)->distance, d, 1e-12 * d + rounding(c));
    if (!c.expected.contains("hausdorff")) return;
    const double h = c.expected["hausdorff"].get<double>() * c.at.scale, tolerance = 1e-6 * c.at.scale;
    expect_holds(ba::hausdorff_distance(a, b, tolerance)->distance, h, 1.001 * tolerance + rounding(c));
    expect_holds(ba::hausdorff_distance(b, a, tolerance)->distance, h, 1.001 * tolerance + rounding(c));
  });
}

// At all control points and about them, beside scans; at some where it is known.
TEST(HardCases, HaveTheClosestPointsOfScans) {
  for_each_case("", [](const Hard_case& c) {
    const Bounding_arc_tree_2 index(c.both);
    const Scanned_drawing scanned(c.both);
    std::vector<Point> points;
    for (const auto& curve : c.both.curves())
      for (const Bezier& piece : curve.beziers)
        for (const Point& p : piece.control_points()) points.push_back(p);
    points.push_back(c.at(0.25, -0.5));
    points.push_back(c.at(1e3, 1e3));
    if (FEW_CASES) points.resize(3);
    for (const Point& q : points) {
      const auto found = ba::closest_point(index, q);
      ASSERT_TRUE(found);
      const Real least = scanned.distance(widened(q));
      EXPECT_LE(found->distance.lower, least);
      EXPECT_GE(found->distance.upper, length(scanned.at(found->place) - widened(q)) * (1 - 0x1p-60L));
      // a flat minimum leaves the root of what distances are rounded by
      EXPECT_LE(found->distance.upper - found->distance.lower, 4e-7 * c.at.scale + rounding(c));
      const auto all = ba::closest_points(index, q, rounding(c));
      ASSERT_FALSE(all.empty());
      EXPECT_LE(all.front().distance.lower, least);
    }
    for (const Json& p : c.expected.value("closest", Json::array()))
      expect_holds(ba::closest_point(index, c.at(p[0].get<double>(), p[1].get<double>()))->distance,
                   p[2].get<double>() * c.at.scale, rounding(c));
  });
}

TEST(HardCases, HaveTheKnownSides) {
  for_each_case("locate", [](const Hard_case& c) {
    const Bounding_arc_tree_2 index(c.both), doubles(c.both, ba::Decisions::DOUBLE);
    for (const Json& p : c.expected["locate"]) {
      const double x = p[0].get<double>(), y = p[1].get<double>();
      const Point q = c.at(x, y);
      if (q.x - c.at.x != c.at.scale * x || q.y - c.at.y != c.at.scale * y) continue;
      const ba::Winding_number w = ba::winding_number(index, q), rough = ba::winding_number(doubles, q);
      EXPECT_EQ(w.state, p[2].is_null() ? ba::Winding_number::State::ON : ba::Winding_number::State::DECIDED);
      EXPECT_EQ(w.number, p[2].is_null() ? 0 : p[2].get<int>()) << p;
      const CGAL::Bounded_side side = p[3] == "on"       ? CGAL::ON_BOUNDARY
                                      : p[3] == "inside" ? CGAL::ON_BOUNDED_SIDE
                                                         : CGAL::ON_UNBOUNDED_SIDE;
      EXPECT_EQ(ba::locate(index, q), side) << p;
      EXPECT_TRUE(rough.state == ba::Winding_number::State::UNDECIDED || rough.number == w.number) << p;
    }
  });
}

TEST(HardCases, HaveTheKnownMeasures) {
  for_each_case("length", [](const Hard_case& c) {
    const Bounding_arc_tree_2 index(c.both);
    const double size = c.at.scale, tolerance = 1e-6 * size, width = 1.001 * tolerance + 1e3 * rounding(c);
    const auto known = [&](const char* key, const ba::Measure_bounds& b, double unit, double most) {
      SCOPED_TRACE(key);
      if (c.expected.contains(key)) expect_holds(b, c.expected[key].get<double>() * unit, most);
    };
    known("length", ba::length(index, tolerance), size, width);
    if (c.expected.contains("area")) known("area", ba::area(index, tolerance * size), size * size, width * size);
    known("diameter", ba::diameter(index, tolerance)->diameter, size, width);
    known("width", ba::width(index, tolerance)->width, size, width);
    known("circle", ba::smallest_enclosing_circle(index, tolerance)->radius, size, width);
  });
}

// The chain of a hull as a polygon.
std::vector<Point> outline(const Bounding_arc_tree_2& index, const ba::Convex_hull<>& hull) {
  std::vector<Point> points;
  constexpr int PARTS = 64;
  for (const ba::Convex_hull<>::Piece& p : hull.pieces)
    for (int i = 0; i < (p.is_bitangent ? 1 : PARTS); ++i) {
      const double t = p.from.t + (p.to.t - p.from.t) * i / PARTS;
      points.push_back(
          index.in_unit().evaluator(index.in_unit().number_of_bezier(p.from.curve, p.from.bezier))(t).point);
    }
  return points;
}
double perimeter(const std::vector<Point>& p) {
  double sum = 0;
  for (std::size_t i = 0; i < p.size(); ++i) sum += ba::euclidean_norm(Point(p[(i + 1) % p.size()] - p[i]));
  return sum;
}

// A convex chain is as long as its own hull, and no sample is outside of it; hits of a ray are where a scan has them.
TEST(HardCases, HaveHullsAndRayHitsOfSamples) {
  for_each_case("", [](const Hard_case& c) {
    const Bounding_arc_tree_2 index(c.both);
    const ba::Convex_hull<> hull = ba::convex_hull(index, 1e-4 * c.at.scale);
    ASSERT_FALSE(hull.pieces.empty());
    const std::vector<Point> chain = outline(index, hull), convex = convex_polygon(chain);
    const double around = perimeter(convex);
    EXPECT_NEAR(perimeter(chain), around, 1e-3 * around + rounding(c));
    for (std::size_t i = 0; convex.size() > 2 && i < convex.size(); ++i) {
      const Point edge = convex[(i + 1) % convex.size()] - convex[i];
      for (std::uint32_t b = 0; b < index.in_unit().number_of_beziers(); ++b)
        for (int k = 0; k <= 8; ++k)  // the outline's chords are lower than 1 / 64^2 of what is round
          EXPECT_GE(cross(edge, index.in_unit().evaluator(b)(k / 8.0).point - convex[i]) / ba::euclidean_norm(edge),
                    -hull.height - 1e-3 * around - rounding(c));
    }
    const Scanned_drawing scanned(c.both);
    const Point q = c.at(-20, -15), d{4, 3};  // through (0, 0)
    double before = 0;
    for (const ba::Ray_hit<>& hit : ba::ray_hits(index, q, d)) {
      EXPECT_LE(before, hit.distance.upper);
      before = hit.distance.lower;
      const Real way = length(scanned.at(hit.place) - widened(q));
      EXPECT_NEAR(static_cast<double>(way - hit.distance.lower), 0, rounding(c));
      EXPECT_NEAR(static_cast<double>(cross(scanned.at(hit.place) - widened(q), Vector{0.8L, 0.6L})), 0, rounding(c));
    }
  });
}

TEST(HardCases, WithAnEmptyDrawingAreNothing) {
  const Bounding_arc_tree_2 none{Drawing()};
  for (const Hard_case& c : hard_cases({})) {
    SCOPED_TRACE(c.name);
    const Bounding_arc_tree_2 index(c.both);
    EXPECT_TRUE(intersections(index, none).points.empty() && intersections(none, index).overlaps.empty());
    EXPECT_EQ(ba::do_intersect(none, index), false);
    EXPECT_FALSE(ba::distance(index, none) || ba::hausdorff_distance(none, index, 1));
  }
}

}  // namespace
}  // namespace test_hard_cases
