// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Medial axes: what geometry says of simple shapes, discs without curves in them by the hierarchy, as many leaves as
// there are maxima of curvature with empty discs, and Euler's relation.

#include "axis_checks.h"
#include "cases.h"
#include "closed_drawings.h"
#include "query_drawings.h"

#include <CGAL/Bounding_arcs_2/curve/Curve_file.h>
#include <CGAL/Bounding_arcs_2/medial_axis/maximal_disc.h>
#include <CGAL/Bounding_arcs_2/medial_axis/pruned.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <stdexcept>
#include <string>
#include <vector>

namespace test_medial_axis {
namespace {

using namespace bounding_arcs_test;
// Of a smooth counterclockwise curve: maxima of curvature whose discs are empty, by scanning in long double.
std::size_t counted_leaves(const Drawing& drawing) {
  const Scanned_drawing scan(drawing);
  constexpr int SAMPLES = 128;
  constexpr Real STEP = Real(1) / SAMPLES, H = 1e-5L;
  const auto jet = [&](std::size_t piece, Real t, Real h) {  // by differences, about a point a little off ends
    t = (std::min)((std::max)(t, h), 1 - h);
    const Vector p = scan.at(piece, t - h), q = scan.at(piece, t), r = scan.at(piece, t + h);
    return std::pair<Vector, Vector>{(1 / (2 * h)) * (r - p), (1 / (h * h)) * ((r - q) - (q - p))};
  };
  const auto curvature = [&](std::size_t piece, Real t) {
    const auto [d, dd] = jet(piece, t, H);
    return cross(d, dd) / std::pow(dot(d, d), Real(1.5));
  };
  std::vector<std::pair<std::size_t, Real>> places;
  std::vector<Real> values;
  for (std::size_t i = 0; i < scan.size(); ++i)
    for (int k = 0; k < SAMPLES; ++k) {
      places.emplace_back(i, (k + Real(0.5)) * STEP);
      values.push_back(curvature(i, places.back().second));
    }
  std::size_t count = 0;
  for (std::size_t i = 0, n = values.size(); i < n; ++i) {
    if (!(values[i] > 0 && values[i] > values[(i + n - 1) % n] && values[i] >= values[(i + 1) % n])) continue;
    auto [piece, t] = places[i];
    for (Real step = STEP / 2; step > 1e-9L; step /= 2)
      for (const Real s : {t - step, t + step})
        if (s > 0 && s < 1 && curvature(piece, s) > curvature(piece, t)) t = s;
    const auto [d, dd] = jet(piece, t, H);
    const Real r = 1 / curvature(piece, t), speed = std::sqrt(dot(d, d));
    const Vector center = scan.at(piece, t) + (r / speed) * Vector{-d.y, d.x};
    constexpr Real SHARE = 1e-5L;  // scanning misses the radius of the sharpest tips by that
    if (scan.distance(center) > r * (1 - SHARE)) ++count;
  }
  return count;
}

TEST(MedialAxis, HasTheVerticesOfARectangle) {
  const Drawing drawing = drawing_of(polygon({{0, 0}, {5, 0}, {5, 2}, {0, 2}}));
  for (const Drawing& d : {drawing, reversed(drawing)}) {
    const Medial_axis_2 axis = axis_of(d);
    expect_sound(d, axis, 1e-12);
    EXPECT_EQ(axis.vertices.size(), 6U);
    EXPECT_NEAR(vertex_at(axis, {1, 1}, 1e-12).radius, 1, 1e-12);
    EXPECT_EQ(vertex_at(axis, {4, 1}, 1e-12).touches.size(), 3U);
    EXPECT_EQ(vertex_at(axis, {0, 2}, 0).radius, 0);
  }
  const Medial_axis_2 square = axis_of(drawing_of(polygon({{0, 0}, {2, 0}, {2, 2}, {0, 2}})));
  EXPECT_EQ(square.vertices.size(), 5U);  // one of four edges
  EXPECT_EQ(vertex_at(square, {1, 1}, 1e-12).touches.size(), 4U);
}

TEST(MedialAxis, OfAnEllipseIsBetweenItsCentersOfCurvature) {
  std::vector<Bezier> chain;
  for (const Bezier& quarter : circle({0, 0}, 1)) {
    std::vector<Point> p;
    for (const Point& q : quarter.control_points()) p.push_back({2 * q.x, q.y});
    chain.emplace_back(std::move(p), quarter.weights());
  }
  const Medial_axis_2 axis = axis_of(drawing_of(chain));
  expect_sound(drawing_of(chain), axis, 1e-6);
  ASSERT_EQ(axis.edges.size(), 1U);
  EXPECT_NEAR(vertex_at(axis, {1.5, 0}, 1e-12).radius, 0.5, 1e-12);
  EXPECT_NEAR(vertex_at(axis, {-1.5, 0}, 1e-12).radius, 0.5, 1e-12);
  for (const auto& s : axis.edges[0].samples) {
    EXPECT_NEAR(s.center.y, 0, 1e-12);
    EXPECT_NEAR(s.radius, std::sqrt(1 - s.center.x * s.center.x / 3), 1e-12);
  }
}

TEST(MedialAxis, IsACircleInARing) {
  const Medial_axis_2 axis = axis_of(both(circle({0, 0}, 2), circle({0, 0}, 1)));
  expect_sound(both(circle({0, 0}, 2), circle({0, 0}, 1)), axis, 1e-6);
  ASSERT_EQ(axis.edges.size(), 1U);  // from one vertex to itself
  for (const auto& s : axis.edges[0].samples) {
    EXPECT_NEAR(std::hypot(s.center.x, s.center.y), 1.5, 1e-12);
    EXPECT_NEAR(s.radius, 0.5, 1e-12);
  }
  const Drawing frame = both(polygon({{0, 0}, {6, 0}, {6, 6}, {0, 6}}), circle({2.5, 3.25}, 1));
  const Medial_axis_2 around = axis_of(frame);
  expect_sound(frame, around, 1e-6);
  EXPECT_EQ(around.holes, 1U);
  EXPECT_EQ(leaves_of(around), 4U);
  const Medial_axis_2 disc = axis_of(drawing_of(circle({1, 2}, 0.75)));
  ASSERT_EQ(disc.vertices.size(), 1U);
  EXPECT_NEAR(disc.vertices[0].radius, 0.75, 1e-12);
}

TEST(MedialAxis, OfAStadiumIsASegment) {
  const auto right = circle({2, 0}, 1), left = circle({0, 0}, 1);
  const Drawing drawing =
      drawing_of({segment({0, -1}, {2, -1}), right[3], right[0], segment({2, 1}, {0, 1}), left[1], left[2]});
  const Medial_axis_2 axis = axis_of(drawing);
  expect_sound(drawing, axis, 1e-12);
  ASSERT_EQ(axis.edges.size(), 1U);
  EXPECT_NEAR(vertex_at(axis, {0, 0}, 1e-12).radius, 1, 1e-12);
  EXPECT_NEAR(vertex_at(axis, {2, 0}, 1e-12).radius, 1, 1e-12);
}

TEST(MedialAxis, OfAnLHasAParabola) {
  const Drawing drawing = drawing_of(polygon({{0, 0}, {5, 0}, {5, 1}, {2, 1}, {2, 4}, {0, 4}}));
  const Medial_axis_2 axis = axis_of(drawing);
  expect_sound(drawing, axis, 1e-6);
  EXPECT_EQ(leaves_of(axis), 5U);  // not the reflex corner
  EXPECT_NEAR(vertex_at(axis, {4.5, 0.5}, 1e-12).radius, 0.5, 1e-12);
  EXPECT_NEAR(vertex_at(axis, {1, 1}, 1e-12).radius, 1, 1e-12);
  for (const auto& e : axis.edges)
    for (const auto& s : e.samples) {
      if (!(s.center.x > 1 && s.center.x < 2 && s.center.y < 1)) continue;  // as far from (2, 1) as from y = 0
      EXPECT_NEAR(std::hypot(s.center.x - 2, s.center.y - 1), s.center.y, 1e-12);
    }
}

TEST(MedialAxis, HasTheLeavesOfBundledCurves) {
  for (const std::string name : {"a_wrench", "b_angelfish", "d_rabbit", "h_maple_leaf"}) {
    SCOPED_TRACE(name);
    const Drawing drawing =
        ba::drawing<double>(ba::read_curve_file(std::string(BOUNDING_ARCS_EXAMPLE_DATA) + "/" + name + ".json").curves);
    const std::size_t leaves = counted_leaves(drawing);
    for (const double eps : {1e-3, 1e-5}) {
      const Medial_axis_2 axis = axis_of(drawing, eps);
      expect_sound(drawing, axis, eps);
      EXPECT_EQ(leaves_of(axis), leaves);
    }
  }
}

TEST(MedialAxis, IsSoundForRandomCurvesWithHoles) {
  std::mt19937 random(5);
  for (int i = 0; i < cases(40) && !HasFailure(); ++i) {
    SCOPED_TRACE(i);
    Drawing drawing;
    const double scale = std::exp2(static_cast<int>(random() % 40) - 20);
    const Drawing outer = moved(drawing_of(closed_curve(random, {0, 0}, 5 + random() % 9)), 4 * scale, {0, 0});
    drawing.add(outer.curves().front().beziers);
    for (const double x : {-0.6, 0.6}) {
      const Drawing hole = reversed(moved(drawing_of(closed_curve(random, {0, 0}, 4)), 0.3 * scale, {x * scale, 0}));
      if (random() % 2 == 0) drawing.add(hole.curves().front().beziers);
    }
    expect_sound(drawing, axis_of(drawing, 1e-4 * scale), 1e-4 * scale);
  }
}

TEST(MedialAxis, RefusesWhatIsOpen) {
  EXPECT_THROW((void)axis_of(drawing_of(segment({0, 0}, {1, 0}))), std::invalid_argument);
  EXPECT_THROW((void)axis_of(drawing_of(circle({0, 0}, 1)), 0), std::invalid_argument);
  EXPECT_TRUE(axis_of(Drawing()).vertices.empty());
}

TEST(MedialAxis, PrunesWhatSticksOutLittle) {
  // a rectangle with a nick: its corner's branch goes, those of the rectangle stay
  const Drawing drawing = drawing_of(polygon({{0, 0}, {2, 0}, {2.05, -0.05}, {2.1, 0}, {5, 0}, {5, 2}, {0, 2}}));
  const Medial_axis_2 axis = axis_of(drawing), less = ba::pruned(axis, 0.2);
  EXPECT_EQ(leaves_of(axis), 5U);
  EXPECT_EQ(leaves_of(less), 4U);
  expect_sound(drawing, less, 1e-6);
  EXPECT_EQ(ba::pruned(axis, 0).edges.size(), axis.edges.size());
  EXPECT_EQ(ba::pruned(axis, 100).edges.size(), 1U);
}

// What goes sticks out by less of the disc where it began, though it went branch by branch.
TEST(MedialAxis, PrunesNothingThatSticksOutByMore) {
  // a bar with a skewed bump: of its two corners one goes first, and is farther from the bar
  const Drawing drawing =
      drawing_of(polygon({{0, 0}, {20, 0}, {20, 4}, {11.5, 4}, {11.861, 5.135}, {10.532, 5.861}, {8.5, 4}, {0, 4}}));
  const Medial_axis_2 axis = axis_of(drawing);
  for (double least = 0.1; least < 3; least += 0.1) {
    const Medial_axis_2 less = ba::pruned(axis, least);
    const auto is_left = [&](const ba::Medial_axis_2::Vertex& v) {
      return std::any_of(less.edges.begin(), less.edges.end(), [&](const auto& e) {
        return std::any_of(e.samples.begin(), e.samples.end(), [&](const auto& s) { return s.center == v.center; });
      });
    };
    for (const auto& v : axis.vertices) {
      double out = HUGE_VAL;
      for (const auto& base : axis.vertices)
        if (is_left(base))
          out = (std::min)(out,
                           std::hypot(v.center.x - base.center.x, v.center.y - base.center.y) + v.radius - base.radius);
      EXPECT_LT(out, least) << v.center.x << ' ' << v.center.y;
    }
  }
}

TEST(MaximalDisc, TouchesWhatIsAcross) {
  const ba::Bounding_arc_tree_2 index(drawing_of(polygon({{0, 0}, {5, 0}, {5, 2}, {0, 2}})));
  const ba::Maximal_discs_2 discs(index);
  const auto disc = discs({0, 0, 0.5});
  ASSERT_TRUE(disc && disc->touches);
  EXPECT_NEAR(disc->radius, 1, 1e-12);
  EXPECT_EQ(disc->touches->bezier, 2U);
  EXPECT_NEAR(disc->touches->t, 0.5, 1e-6);
  EXPECT_NEAR(discs({0, 0, 0.1})->radius, 0.5, 1e-12);  // the corner's bisector
  EXPECT_THROW((void)discs({0, 7, 0.5}), std::invalid_argument);
  const auto largest = ba::largest_inscribed_disc(index, ba::medial_axis(index, 1e-6));
  EXPECT_LE(largest->radius.lower, 1);
  EXPECT_GE(largest->radius.upper, 1);
  EXPECT_LE(largest->radius.upper - largest->radius.lower, 2e-6);
}

}  // namespace
}  // namespace test_medial_axis
