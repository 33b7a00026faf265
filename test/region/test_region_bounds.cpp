// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// What regions in hand tell of the curves in them, beside points of these curves in long double.

#include "cases.h"
#include "region_samples.h"
#include "trees.h"

#include <CGAL/Bounding_arcs_2.h>
#include <CGAL/Bounding_arcs_2/region/region_bounds.h>
#include <CGAL/Bounding_arcs_2/tree/Region_columns.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <vector>

namespace test_region_bounds {
namespace {

using namespace bounding_arcs_test;
using ba::Arc_region_2;
using ba::Bracket;

// A piece of a curve with its region; the curve in long double.
struct Held {
  ba::Bezier_curve_2<Real> curve;
  Real t0, t1;
  Arc_region_2 region;
  double thickness;

  [[nodiscard]] Vector at(int i, int count) const { return curve.point(t0 + (t1 - t0) * i / count); }
  // From samples, and from nearer ones about the nearest of them as long as that helps.
  [[nodiscard]] Real distance(const Vector& q) const {
    Real middle = (t0 + t1) / 2, half = (t1 - t0) / 2, least = HUGE_VALL;
    for (int round = 0; round < 24; ++round, half /= 4) {
      Real best = middle;
      for (int i = -8; i <= 8; ++i) {
        const Real t = (std::min)((std::max)(middle + half * i / 8, t0), t1), d = length(q - curve.point(t));
        if (d < least) best = t;
        least = (std::min)(least, d);
      }
      middle = best;
    }
    return (std::min)(least, length(q - curve.point(t1)));
  }
};

// Regions of curves of several degrees: those of leaves at some eps, near the origin and far from it, tiny ones.
template <class Traits> std::vector<Held> various_regions(unsigned seed, int count) {
  std::mt19937 random(seed);
  std::vector<Held> regions;
  ba::Region_columns columns;
  for (int i = 0; i < count; ++i) {
    const Bezier curve = random_curve(random, 2 + i % 4, false);
    const double scale = i % 5 == 3 ? 1e-3 : (i % 5 == 4 ? 1e-140 : 1), away = i % 5 == 3 ? 1e6 : 0;
    std::vector<Point> points;
    for (const Point& p : curve.control_points()) points.push_back({scale * p.x + away, scale * p.y - away});
    const ba::Region_hierarchy_2<Traits, Spiral> tree(ba::spiral_segments(Bezier(points)),
                                                      scale * (i % 2 == 0 ? 1e-1 : 1e-5));
    std::vector<Vector> exact;
    for (const Point& p : points) exact.push_back(widened(p));
    make_regions(tree, columns);
    for (std::size_t s = 0; s + 1 < columns.first.size(); ++s)
      for (std::size_t row = columns.first[s]; row + 1 < columns.first[s + 1]; row += 1 + random() % 20)
        regions.push_back({ba::Bezier_curve_2<Real>(exact), columns.t[row], columns.t[row + 1], columns.region(row, s),
                           scale * (i % 2 == 0 ? 1e-1 : 1e-5)});
  }
  return regions;
}

// Points about a region, from inside it to far away.
std::vector<Point> points_about(const Arc_region_2& region, std::mt19937& random) {
  std::uniform_real_distribution<double> unit(-1, 1);
  const Point chord = region.to - region.from;
  std::vector<Point> points{region.from, region.to};
  for (const double away : {1e-9, 1e-3, 0.1, 1.0, 30.0})
    for (int i = 0; i < 4; ++i)
      points.push_back(region.from + 0.5 * (1 + unit(random)) * chord + (away * unit(random)) * perp(chord) +
                       (away * unit(random)) * chord);
  for (const auto* side : {&region.inner, &region.outer})
    for (std::size_t i = 0; i < side->size; ++i) points.push_back(ba::point(ba::arc_of(region, *side, i), 0.4));
  return points;
}

template <class Traits> class RegionBounds : public testing::Test {};
using All = testing::Types<ba::Bca_traits_2<Kernel>, ba::Spiral_fat_arc_traits_2<Kernel>, ba::Bilens_traits_2<Kernel>>;
TYPED_TEST_SUITE(RegionBounds, All);

TYPED_TEST(RegionBounds, HoldTheDistanceOfAPoint) {
  std::mt19937 random(1);
  std::size_t inside = 0, total = 0;
  for (const Held& held : various_regions<TypeParam>(2, cases(20)))
    for (const Point& q : points_about(held.region, random)) {
      const Real distance = held.distance(widened(q));
      const Bracket b = ba::distance_bounds(q, held.region);
      EXPECT_LE(b.lower, distance);
      EXPECT_GE(b.upper, distance);
      EXPECT_GE(b.lower, 0);
      const double room =
          2 * held.region.widening +
          200 * 0x1p-53 *
              (b.upper + 40 * std::hypot(held.region.to.x - held.region.from.x, held.region.to.y - held.region.from.y));
      EXPECT_LE(b.upper - b.lower, 2 * held.thickness + 2 * room);
      inside += b.lower == 0;
      ++total;
    }
  EXPECT_LT(inside, total / 2);
}

TYPED_TEST(RegionBounds, HoldTheCurveInABox) {
  for (const Held& held : various_regions<TypeParam>(3, cases(20))) {
    const CGAL::Bbox_2 box = ba::box(held.region);
    for (int i = 0; i <= 16; ++i) {
      const Vector p = held.at(i, 16);
      EXPECT_TRUE(box.xmin() <= p.x && p.x <= box.xmax() && box.ymin() <= p.y && p.y <= box.ymax());
    }
  }
}

TYPED_TEST(RegionBounds, HoldTheTangents) {
  std::size_t known = 0, total = 0;
  for (const Held& held : various_regions<TypeParam>(4, cases(20))) {
    const auto cone = ba::tangent_cone(held.region);
    ++total;
    if (!cone) continue;
    ++known;
    const Vector first = widened(cone->first), last = widened(cone->last);
    EXPECT_GE(cone->turn * cross(first, last), 0);
    const auto& p = held.curve.control_points();
    std::vector<Vector> differences;
    for (std::size_t i = 0; i + 1 < p.size(); ++i) differences.push_back(p[i + 1] - p[i]);
    const auto tangent = [&](Real t) {
      std::vector<Vector> d = differences;
      for (std::size_t n = d.size(); n-- > 1;)
        for (std::size_t i = 0; i < n; ++i) d[i] = Real(1 - t) * d[i] + t * d[i + 1];
      return d[0];
    };
    for (int i = 0; i <= 8; ++i) {
      const Vector t = tangent(held.t0 + (held.t1 - held.t0) * i / 8);
      EXPECT_GE(cone->turn * cross(first, t), 0);
      EXPECT_GE(cone->turn * cross(t, last), 0);
      EXPECT_GT(dot(Vector(Real(1 / length(first)) * first + Real(1 / length(last)) * last), t), 0);
    }
  }
  EXPECT_GT(known, total / 2);
}

TYPED_TEST(RegionBounds, HoldTheDistanceOfTwoCurves) {
  std::mt19937 random(5);
  const std::vector<Held> regions = various_regions<TypeParam>(6, (std::max)(2, cases(20)));
  std::size_t apart = 0, total = 0;
  for (int i = 0; i < (FEW_CASES ? 100 : 400); ++i) {
    const Held &a = regions[random() % regions.size()], &b = regions[random() % regions.size()];
    const Bracket bounds = ba::distance_bounds(a.region, b.region);
    Real least = HUGE_VALL;  // of samples: the curves are no farther
    for (int j = 0; j <= 16; ++j) least = (std::min)(least, b.distance(a.at(j, 16)));
    EXPECT_LE(bounds.lower, least);
    EXPECT_LE(bounds.lower, bounds.upper);
    // ends are samples, and seen from the other region they are within two thicknesses of what they are
    const Real of_ends =
        (std::min)({b.distance(a.at(0, 1)), b.distance(a.at(1, 1)), a.distance(b.at(0, 1)), a.distance(b.at(1, 1))});
    EXPECT_GE(bounds.upper, least - length(a.at(1, 1) - a.at(0, 1)) / 16);
    EXPECT_LE(bounds.upper, of_ends + 2 * (a.thickness + b.thickness) + 1e-13L * (of_ends + 1));
    EXPECT_EQ(ba::are_apart(a.region, b.region), bounds.lower > 0);
    apart += bounds.lower > 0;
    ++total;
  }
  EXPECT_GT(apart, total / 2);
  for (std::size_t i = 0; i + 1 < regions.size(); ++i)
    if (regions[i].region.to == regions[i + 1].region.from) {
      EXPECT_FALSE(ba::are_apart(regions[i].region, regions[i + 1].region));
    }
}

// In numbers that tell a rectangle from the strip that its sides make, and arcs from what is over their chords.
TEST(RegionsApart, AreToldByRectanglesAndArcs) {
  const auto region = [](const Point& from, const Point& to) {
    Arc_region_2 r{from, to, {1, {0.2, 0}, {}}, {1, {0.25, 0}, {}}};
    r.widening = 1e-12;
    return r;
  };
  const Arc_region_2 a = region({0, 0}, {4, 0});  // over it, down to -0.5
  EXPECT_TRUE(ba::are_apart(a, region({5, 0}, {9, 0})));
  EXPECT_TRUE(ba::are_apart(a, region({0, 1}, {4, 1})));
  EXPECT_TRUE(ba::are_apart(a, region({0, -0.51}, {4, -0.51})));
  EXPECT_TRUE(ba::are_apart(a, region({0, -0.4}, {4, -0.4})));  // beside it
  EXPECT_FALSE(ba::are_apart(a, region({0, -0.05}, {4, -0.05})));
  EXPECT_TRUE(ba::are_apart(a, region({0, 0.6}, {4, 0.6 + 1e-3})));
  // between 1.5, which is left of 2 by the height of a, and what is left by the turn of both and their thicknesses
  const double lower = ba::distance_bounds(a, region({0, -2}, {4, -2})).lower;
  EXPECT_GT(lower, 1.7);
  EXPECT_LT(lower, 2);
  EXPECT_NEAR(ba::distance_bounds(a, region({5, 0}, {9, 0})).upper, 1, 0.2);
}

// Both arcs of a side are of one circle, so that it is highest in the middle, wherever its joint is.
TEST(RectangleOfARegion, HoldsItsOuterSide) {
  for (const double angle : {0.01, 0.3, 1.5})  // of the whole arc
    for (const double share : {0.01, 0.2, 0.5, 0.9})
      for (const double turn : {1.0, -1.0}) {
        const double radius = 0.5 / std::sin(angle / 2);
        const auto at = [&](double x) {
          const double phi = angle * (x - 0.5);
          return Point{0.5 + radius * std::sin(phi), turn * radius * (std::cos(angle / 2) - std::cos(phi))};
        };
        const auto bulge = [&](double x) { return turn * std::tan(x * angle / 4); };
        const Arc_region_2 r{{0, 0}, {1, 0}, {1, {0, 0}, {}}, {2, {bulge(share), bulge(1 - share)}, at(share)}};
        const ba::Region_rectangle rectangle = ba::rectangle(r);
        for (int i = 0; i <= 64; ++i) EXPECT_TRUE(ba::is_near(at(i / 64.0), rectangle, 1e-14)) << angle << " " << share;
        EXPECT_LE(ba::euclidean_norm(rectangle.across), 2 * std::fabs(at(0.5).y) + 1e-14);
      }
}

// The curve may be beyond an end by less than the end's coordinates resolve, on whichever side of the axes.
TEST(BoxOfARegion, HoldsWhatIsWithinATinyWidening) {
  for (const double sx : {1.0, -1.0})
    for (const double sy : {1.0, -1.0}) {
      Arc_region_2 r{{sx, sy}, {3 * sx, 2 * sy}, {1, {0.1, 0}, {}}, {1, {0.2, 0}, {}}};
      r.widening = 0x1p-54;
      const CGAL::Bbox_2 box = ba::box(r);
      EXPECT_LT(box.xmin(), (std::min)(r.from.x, r.to.x));
      EXPECT_GT(box.xmax(), (std::max)(r.from.x, r.to.x));
      EXPECT_LT(box.ymin(), (std::min)(r.from.y, r.to.y));
      EXPECT_GT(box.ymax(), (std::max)(r.from.y, r.to.y));
    }
}

// An end of the wider of two segments is the point next to the other.
TEST(DistanceOfRegions, AllowsForTheWideningOfTheNearerEnd) {
  constexpr double WIDENING = 0.125;
  Arc_region_2 a{{0, 0}, {1, 0}, {1, {0, 0}, {}}, {1, {0, 0}, {}}}, b = a;
  b.from = {0.5, 1};
  b.to = {0.5, 2};
  a.widening = 0;
  b.widening = WIDENING;
  for (const auto& bounds : {ba::distance_bounds(a, b), ba::distance_bounds(b, a)}) {
    EXPECT_GE(bounds.upper, 1 + WIDENING);
    EXPECT_LE(bounds.upper, 1 + WIDENING + 1e-12);
    EXPECT_LE(bounds.lower, 1 - WIDENING);
    EXPECT_GE(bounds.lower, 1 - WIDENING - 1e-12);
  }
}

TEST(Thickness, OfAFatArcIsRoundedUp) {
  std::mt19937 random(7);
  std::uniform_real_distribution<double> unit(-1, 1);
  for (int i = 0; i < 1000; ++i) {
    const double b = 0.4 * unit(random);
    const Arc_region_2 r{{unit(random), unit(random)},
                         {unit(random), unit(random)},
                         {1, {b, 0}, {}},
                         {1, {b * (1 + std::exp2(-50 * std::fabs(unit(random)))), 0}, {}}};
    const Real exact =
        length(widened(r.to) - widened(r.from)) / 2 * std::fabs(Real(r.outer.bulges[0]) - r.inner.bulges[0]);
    EXPECT_GE(ba::thickness(r), exact * (1 - 0x1p-60L));
    EXPECT_LE(ba::thickness(r), exact * (1 + 16 * 0x1p-53L));
  }
}

}  // namespace
}  // namespace test_region_bounds
