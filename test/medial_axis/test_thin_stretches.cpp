// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Where shapes are thinner than a limit: bars, wedges, fins, necks and rings; and corners, which are no thin places.

#include "axis_checks.h"
#include "cases.h"
#include "closed_drawings.h"

#include <CGAL/Bounding_arcs_2/medial_axis/medial_axis.h>
#include <CGAL/Bounding_arcs_2/medial_axis/thin_places.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>
#include <stdexcept>
#include <vector>

namespace test_thin_stretches {
namespace {

using namespace bounding_arcs_test;

constexpr double DEGREE = 3.14159265358979323846 / 180, UNLIMITED = std::numeric_limits<double>::infinity();

std::vector<ba::Medial_axis_2::Thin_stretch> stretches_of(const Drawing& drawing, double limit,
                                                          double corner = ba::THIN_CORNER) {
  const Medial_axis_2 axis = axis_of(drawing);
  EXPECT_EQ(axis.status, Status::COMPLETE);
  return ba::thin_stretches(axis, limit, corner);
}
std::vector<Point> ends_of(const ba::Medial_axis_2::Thin_stretch& s) {
  Point from = s.samples.front().center, to = s.samples.back().center;
  if (to.x < from.x) std::swap(from, to);
  return {from, to};
}
void expect_near(const Point& p, const Point& q) {
  EXPECT_NEAR(p.x, q.x, 1e-9);
  EXPECT_NEAR(p.y, q.y, 1e-9);
}

TEST(ThinStretches, OfABarAreAllOfItsMiddle) {
  const Drawing bar = drawing_of(polygon({{0, 0}, {5, 0}, {5, 0.8}, {0, 0.8}}));
  const auto found = stretches_of(bar, 1);
  ASSERT_EQ(found.size(), 1u);
  EXPECT_NEAR(found[0].thickness(), 0.8, 1e-12);
  EXPECT_NEAR(found[0].length, 4.2, 1e-12);
  expect_near(ends_of(found[0])[0], {0.4, 0.4});
  expect_near(ends_of(found[0])[1], {4.6, 0.4});
  // as thick as the limit is not below it, however that is rounded
  EXPECT_TRUE(stretches_of(bar, 0.8).empty());
  EXPECT_TRUE(stretches_of(moved(bar, 1.0 / 3, {1, 7}), 0.8 / 3).empty());
}

// Axes that are all corners keep the largest disc.
TEST(ThinStretches, OfCornersAreNone) {
  for (const auto& corners :
       {std::vector<Point>{{0, 0}, {6, 0}, {6, 6}, {0, 6}}, std::vector<Point>{{0, 0}, {6, 0}, {3, 3 * std::sqrt(3.0)}},
        std::vector<Point>{{0, 0}, {9, 0}, {9, 4}, {5, 4}, {5, 9}, {0, 9}}}) {
    const Drawing shape = drawing_of(polygon(corners));
    EXPECT_TRUE(stretches_of(shape, 0.9 * stretches_of(shape, UNLIMITED)[0].thickness()).empty());
    EXPECT_TRUE(stretches_of(shape, 3).empty());
    const auto all = stretches_of(shape, 9);
    ASSERT_GE(all.size(), 1u);
    EXPECT_GT(all[0].thickness(), 3);
  }
  const auto square = stretches_of(drawing_of(polygon({{0, 0}, {1, 0}, {1, 1}, {0, 1}})), 2);
  ASSERT_EQ(square.size(), 1u);
  ASSERT_EQ(square[0].samples.size(), 1u);
  EXPECT_NEAR(square[0].thickness(), 1, 1e-12);
  expect_near(square[0].disc().center, {0.5, 0.5});
}

// A corner of half the width at its base is as long as that over the tangent of half its angle.
TEST(ThinStretches, OfAWedgeReachItsTip) {
  for (const double degrees : {20.0, 50.0, 70.0}) {
    const double half = std::tan(degrees / 2 * DEGREE) * 10;
    const Drawing wedge = drawing_of(polygon({{0, 0}, {10, -half}, {20, -half}, {20, half}, {10, half}}));
    const auto found = stretches_of(wedge, 0.5);
    if (degrees > 60) {
      EXPECT_TRUE(found.empty());
      EXPECT_EQ(stretches_of(wedge, 0.5, 80 * DEGREE).size(), 1u);
      continue;
    }
    ASSERT_EQ(found.size(), 1u);
    EXPECT_EQ(found[0].thickness(), 0);
    EXPECT_EQ(found[0].disc().center, (Point{0, 0}));
    const double length = 0.25 / std::sin(degrees / 2 * DEGREE);
    EXPECT_NEAR(found[0].length, length, 1e-9);
    expect_near(ends_of(found[0])[0], {0, 0});
    expect_near(ends_of(found[0])[1], {length, 0});
    EXPECT_TRUE(stretches_of(wedge, 0.5, (degrees - 5) * DEGREE).empty());
  }
}

// A block with a fin that has a blunt end, and one that is narrower in the middle.
TEST(ThinStretches, OfFinsAndNecksEndWhereTheShapeIsThicker) {
  const Drawing fin = drawing_of(polygon({{0, 0}, {10, 0}, {10, 4}, {6, 4}, {5.75, 8}, {5.25, 8}, {5, 4}, {0, 4}}));
  const auto of_fin = stretches_of(fin, 0.9);
  ASSERT_EQ(of_fin.size(), 1u);
  EXPECT_NEAR(of_fin[0].disc().center.x, 5.5, 1e-9);
  EXPECT_GT(of_fin[0].disc().center.y, 7.5);
  EXPECT_NEAR(of_fin[0].thickness(), 0.5, 0.1);
  EXPECT_GT(of_fin[0].length, 2);
  const Drawing hourglass =
      drawing_of(polygon({{0, 0}, {4, 0}, {5, 1.5}, {6, 0}, {10, 0}, {10, 4}, {6, 4}, {5, 2.5}, {4, 4}, {0, 4}}));
  const auto of_neck = stretches_of(hourglass, 1.2);
  ASSERT_EQ(of_neck.size(), 1u);
  EXPECT_NEAR(of_neck[0].thickness(), 1, 1e-12);
  EXPECT_NEAR(of_neck[0].samples.front().radius, 0.6, 1e-12);
  EXPECT_NEAR(of_neck[0].samples.back().radius, 0.6, 1e-12);
  const double half = std::sqrt(0.36 - 0.25);  // of the chord that both corners see under 0.6
  EXPECT_NEAR(ends_of(of_neck[0])[0].x, 5 - half, 1e-5);
  EXPECT_NEAR(ends_of(of_neck[0])[1].x, 5 + half, 1e-5);
  EXPECT_TRUE(stretches_of(hourglass, 1).empty());
}

TEST(ThinStretches, OfARingGoAround) {
  const Drawing ring = both(polygon({{0, 0}, {6, 0}, {6, 6}, {0, 6}}), polygon({{2, 2}, {4, 2}, {4, 4}, {2, 4}}));
  const auto found = stretches_of(ring, 3);  // corners' discs are 2.34 thick
  ASSERT_EQ(found.size(), 1u);
  EXPECT_EQ(found[0].samples.front().center, found[0].samples.back().center);
  EXPECT_NEAR(found[0].thickness(), 2, 1e-12);
  EXPECT_EQ(stretches_of(ring, 2.1).size(), 4u);  // its sides
  for (const ba::Medial_axis_2::Thin_stretch& s : stretches_of(ring, 2.1))
    for (const ba::Medial_axis_2::Sample& at : s.samples) EXPECT_NE(at.left.curve, at.right.curve);
}

// Where three bars of one shape meet there are three stretches.
TEST(ThinStretches, EndWhereTheAxisBranches) {
  const Drawing tee = drawing_of(polygon({{0, 0}, {9, 0}, {9, 1}, {5, 1}, {5, 6}, {4, 6}, {4, 1}, {0, 1}}));
  EXPECT_EQ(stretches_of(tee, 1.5).size(), 3u);
  EXPECT_EQ(stretches_of(tee, 1).size(), 0u);
}

TEST(ThinStretches, OfADiscAreOneDisc) {
  const double w = std::sqrt(0.5);
  std::vector<Bezier> circle;
  const Point ends[] = {{1, 0}, {0, 1}, {-1, 0}, {0, -1}}, corners[] = {{1, 1}, {-1, 1}, {-1, -1}, {1, -1}};
  for (int i = 0; i < 4; ++i)
    circle.emplace_back(std::vector<Point>{ends[i], corners[i], ends[(i + 1) % 4]}, std::vector<double>{1, w, 1});
  const auto found = stretches_of(drawing_of(circle), 2.5);
  ASSERT_EQ(found.size(), 1u);
  EXPECT_NEAR(found[0].thickness(), 2, 1e-12);
  EXPECT_EQ(found[0].length, 0);
  EXPECT_TRUE(stretches_of(drawing_of(circle), 2).empty());
}

// All discs are below the limit, and what is left of the axis without a limit is below it nowhere else.
TEST(ThinStretches, AreWhatIsBelowTheLimitOfAllStretches) {
  std::mt19937 random(61);
  std::size_t seen = 0;
  for (int round = 0; round < cases(30); ++round) {
    SCOPED_TRACE(round);
    const Drawing drawing = drawing_of(closed_curve(random, {0, 0}, 5 + random() % 9));
    const Medial_axis_2 axis = axis_of(drawing, 1e-5);
    if (axis.status != Status::COMPLETE) continue;
    const auto all = ba::thin_stretches(axis, UNLIMITED);
    ASSERT_FALSE(all.empty());
    double most = 0;
    for (const auto& v : axis.vertices) most = (std::max)(most, v.radius);
    for (const double share : {0.3, 0.7}) {
      double expected = 0, found = 0;
      for (const ba::Medial_axis_2::Thin_stretch& s : all)
        for (std::size_t i = 1; i < s.samples.size(); ++i) {
          const auto &a = s.samples[i - 1], &b = s.samples[i];
          const double low = (std::min)(a.radius, b.radius), high = (std::max)(a.radius, b.radius), r = share * most;
          const double part = high <= r ? 1 : low >= r ? 0 : (r - low) / (high - low);
          expected += part * euclidean_norm(b.center - a.center);
        }
      for (const ba::Medial_axis_2::Thin_stretch& s : ba::thin_stretches(axis, 2 * share * most)) {
        ++seen;
        found += s.length;
        for (const ba::Medial_axis_2::Sample& at : s.samples) {
          EXPECT_LE(at.radius, share * most * (1 + 1e-12));
          EXPECT_GE(at.radius, s.disc().radius);
        }
        for (std::size_t i = 1; i + 1 < s.samples.size(); ++i) {
          const Point way = s.samples[i + 1].center - s.samples[i - 1].center;
          const auto side_of = [&](const ba::Curve_place& p) {
            return cross(way, drawing.curves()[p.curve].beziers[p.bezier].point(p.t) - s.samples[i].center);
          };
          EXPECT_GT(side_of(s.samples[i].left), side_of(s.samples[i].right));
        }
      }
      EXPECT_NEAR(found, expected, 1e-9 * size_of(drawing));
    }
  }
  EXPECT_GE(seen, 10u);
}

TEST(ThinStretches, OfARoomInAFrameAreGaps) {
  Drawing lines;
  lines.add(Bezier({{0, 0}, {4, 0}})), lines.add(Bezier({{0, 0.3}, {4, 0.3}}));
  ba::Medial_axis_2::Options options;
  options.is_framed = true;
  const Medial_axis_2 axis = ba::medial_axis(ba::Bounding_arc_tree_2(ba::framed(lines, 2)), 1e-6, options);
  const auto found = ba::thin_stretches(axis, 0.5);
  ASSERT_EQ(found.size(), 1u);
  EXPECT_NEAR(found[0].thickness(), 0.3, 1e-12);
  EXPECT_GE(found[0].length, 4);
}

TEST(ThinStretches, GrowWithTheDrawing) {
  const double scale = 0x1p200;
  const Drawing bar = drawing_of(polygon({{0, 0}, {5, 0}, {5, 0.8}, {0, 0.8}}));
  const auto small = ba::thin_stretches(axis_of(bar), 1),
             large = ba::thin_stretches(axis_of(moved(bar, scale, {0, 0}), scale * 1e-6), scale);
  ASSERT_EQ(small.size(), large.size());
  EXPECT_EQ(large[0].length, scale * small[0].length);
  EXPECT_EQ(large[0].thickness(), scale * small[0].thickness());
}

TEST(ThinStretches, RefuseNoLimitAndNoCorner) {
  const Medial_axis_2 axis = axis_of(drawing_of(polygon({{0, 0}, {5, 0}, {5, 1}, {0, 1}})));
  for (const double wrong : {0.0, -1.0, std::nan("")}) {
    EXPECT_THROW(static_cast<void>(ba::thin_stretches(axis, wrong)), std::invalid_argument);
    EXPECT_THROW(static_cast<void>(ba::thin_stretches(axis, 1, wrong)), std::invalid_argument);
  }
  EXPECT_THROW(static_cast<void>(ba::thin_stretches(axis, 1, 3.2)), std::invalid_argument);
  EXPECT_TRUE(ba::thin_stretches({}, 1).empty());
}

}  // namespace
}  // namespace test_thin_stretches
