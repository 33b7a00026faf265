// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// What rays meet, beside Sturm sequences of the Bezier pieces and where it is known.

#include "cases.h"
#include "closed_drawings.h"
#include "winding_oracle.h"

#include <CGAL/Bounding_arcs_2/query/ray_hits.h>

#include <gtest/gtest.h>

#include <cmath>
#include <cstddef>
#include <random>
#include <stdexcept>
#include <utility>
#include <vector>

namespace test_ray_hits {
namespace {

using namespace bounding_arcs_test;
namespace ba = CGAL::Bounding_arcs;
using ba::Bounding_arc_tree_2;
using ba::Ray_hit;
using Point = ba::Xy<double>;
using Exact = CGAL::Exact_rational;

// The same roots, each once: Sturm sequences tell nothing from a multiple root on.
Powers once(const Powers& p) {
  Powers q = p, d = derived(p);
  while (!d.empty()) {
    q = negative_remainder(q, d);
    std::swap(q, d);
  }
  Powers rest = p, quotient(p.size() - q.size() + 1, Rational(0));
  for (std::size_t k = quotient.size(); k-- > 0;) {
    quotient[k] = rest[k + q.size() - 1] / q.back();
    for (std::size_t i = 0; i < q.size(); ++i) rest[k + i] -= quotient[k] * q[i];
  }
  return quotient;
}

// Distinct parameters in [0, 1) on a ray; -1 where a piece lies along it.
int hits_by_sturm(const Lattice_curve& c, const Point& q, const Point& d) {
  const Turned_curve seen = turned_curve(c, {Rational(q.x), Rational(q.y)}, Rational(d.x), Rational(d.y));
  if (seen.across.empty()) return -1;
  if (seen.along.empty()) return 0;  // all across the ray's start: left out by the test
  const Sturm across(once(seen.across)), along(once(seen.along));
  int count = value(seen.across, 0) == 0 && value(seen.along, 0) >= 0;
  struct Part {
    Rational a, b;
  };
  std::vector<Part> parts{{0, 1}};
  while (!parts.empty()) {
    const Part p = parts.back();
    parts.pop_back();
    const int roots = across.roots(p.a, p.b);
    if (roots == 0) continue;
    if (roots == 1 && value(seen.across, p.b) == 0) {
      count += p.b != 1 && value(seen.along, p.b) >= 0;
      continue;
    }
    if (roots == 1 && value(seen.along, p.a) != 0 && along.roots(p.a, p.b) == 0) {
      count += value(seen.along, p.b) > 0;
      continue;
    }
    const Rational middle = (p.a + p.b) / 2;
    parts.push_back({p.a, middle});
    parts.push_back({middle, p.b});
  }
  return count;
}

TEST(RayHits, AreAsManyAsSturmSequencesCount) {
  std::mt19937 random(1);
  constexpr int SIZE = 3;
  std::uniform_int_distribution<int> coordinate(-2 * SIZE, 2 * SIZE), step(-2, 2);
  int found = 0;
  for (int i = 0; i < cases(800); ++i) {
    const Bounding_arc_tree_2 index(random_lattice_drawing(random, SIZE));
    for (int k = 0; k < 5; ++k) {
      const Point q{coordinate(random) / 2.0 + 0x1p-10, coordinate(random) / 2.0};
      const Point d{static_cast<double>(step(random)), static_cast<double>(step(random))};
      if (d == Point{0, 0}) continue;
      int count = 0;
      bool is_along = false;
      for (const auto& curve : index.drawing().curves())
        for (const auto& bezier : curve.beziers) {
          const Turned_curve seen = turned_curve(bezier, {Rational(q.x), Rational(q.y)}, 1, 0);
          is_along = is_along || meet_in_unit(seen.along, seen.across);
          if (is_along) break;
          const int n = hits_by_sturm(bezier, q, d);
          is_along = is_along || n < 0;
          count += n;
        }
      const std::vector<Ray_hit<>> hits = ba::ray_hits(index, q, d);
      if (!is_along) {
        ASSERT_EQ(hits.size(), static_cast<std::size_t>(count)) << "drawing " << i << " ray " << k;
      }
      for (std::size_t h = 0; h < hits.size(); ++h) {
        const Ray_hit<>& hit = hits[h];
        ++found;
        EXPECT_LE(hit.distance.lower, hit.distance.upper);
        EXPECT_LE(hit.distance.upper - hit.distance.lower, 16 * 0x1p-53 * hit.distance.upper);
        if (h > 0) {
          EXPECT_LE(hits[h - 1].distance.lower, hit.distance.upper);
        }
        const Point way = hit.point - q;
        EXPECT_NEAR(std::hypot(way.x, way.y), hit.distance.upper, 1e-13);
        EXPECT_NEAR(cross(way, d), 0, 1e-13);
      }
    }
    if (HasFatalFailure()) return;
  }
  EXPECT_GT(found, cases(2000));
}

TEST(RayHits, OfACircleAreRightToTheLastDouble) {
  ba::Drawing_2<double> drawing;
  drawing.add(circle_of_quarters({5, 0, 0}));
  const Bounding_arc_tree_2 index(drawing);
  const auto distances = [&](const Point& q, const Point& d) {
    std::vector<double> result;
    for (const Ray_hit<>& hit : ba::ray_hits(index, q, d)) {
      EXPECT_LE(hit.distance.upper - hit.distance.lower, 16 * 0x1p-53 * hit.distance.upper);
      result.push_back(hit.distance.lower / 2 + hit.distance.upper / 2);
    }
    return result;
  };
  using Distances = std::vector<double>;
  EXPECT_EQ(distances({0, 0}, {1, 0}), Distances{5});  // through a joint
  EXPECT_EQ(distances({-7, 3}, {2, 0}), (Distances{3, 11}));
  EXPECT_EQ(distances({-7, 5}, {1, 0}), Distances{7});  // touches, at a joint
  EXPECT_EQ(distances({-7, std::nextafter(5, 6)}, {1, 0}), Distances{});
  EXPECT_EQ(distances({-7, std::nextafter(5, 4)}, {1, 0}).size(), 2U);
  EXPECT_EQ(distances({3, 4}, {1, 0}), Distances{0});  // starts on it
  EXPECT_EQ(distances({3, 4}, {-1, 0}), (Distances{0, 6}));
  EXPECT_EQ(distances({-1, 7}, {4, -3}), Distances{5});  // touches (3, 4), inside a piece
  EXPECT_EQ(distances({8, 0}, {1, 0}), Distances{});
  EXPECT_EQ(distances({0, 0}, {0, -0x1p-1000}), Distances{5});
  EXPECT_EQ(distances({0, 0}, {0x1p900, 0}), Distances{5});
}

TEST(RayHits, AlongAPieceTellWhatBoundsIt) {
  ba::Drawing_2<double> drawing;
  drawing.add(Lattice_curve({{1, 0}, {3, 0}, {2, 0}}));  // there to 7/3, and back
  const Bounding_arc_tree_2 index(drawing);
  const std::vector<Ray_hit<>> hits = ba::ray_hits(index, Point{0, 0}, Point{1, 0});
  ASSERT_EQ(hits.size(), 3U);
  EXPECT_EQ(hits[0].point, (Point{1, 0}));
  EXPECT_EQ(hits[1].point, (Point{2, 0}));
  EXPECT_NEAR(hits[2].point.x, 7.0 / 3, 1e-15);
  for (const Ray_hit<>& hit : hits) EXPECT_TRUE(hit.is_along);
  EXPECT_EQ(ba::ray_hits(index, {1.5, 0}, {1, 0}).size(), 3U);
  EXPECT_EQ(ba::ray_hits(index, {1.5, 0}, {-1, 0}).size(), 2U);
  EXPECT_TRUE(ba::ray_hits(index, {0.5, 0}, {-1, 0}).empty());
}

TEST(RayHits, AreInOrderWhereDoublesAreNot) {
  ba::Drawing_2<double> drawing;
  drawing.add(Lattice_curve({{1, -1}, {1, 1}}));
  drawing.add(Lattice_curve({{0, -1}, {0, 0x1p-80}, {3, 1}}));
  const Bounding_arc_tree_2 index(drawing);
  const std::vector<Ray_hit<>> hits = ba::ray_hits(index, Point{0, 0}, Point{1, 0});
  ASSERT_EQ(hits.size(), 2U);
  EXPECT_EQ(hits[0].place.curve, 1U);
  ba::Drawing_2<double> near;
  near.add(Lattice_curve({{0.75, -1}, {0.75, 1}}));
  near.add(Lattice_curve({{0, -1}, {0, 0x1p-80}, {3, 1}}));  // y = 0 for t less than a half: before 0.75
  near.add(Lattice_curve({{0, -1}, {0, -0x1p-80}, {3, 1}}));
  const Bounding_arc_tree_2 close(near);
  const std::vector<Ray_hit<>> three = ba::ray_hits(close, Point{0, 0}, Point{1, 0});
  ASSERT_EQ(three.size(), 3U);
  EXPECT_EQ(three[0].place.curve, 1U);
  EXPECT_EQ(three[1].place.curve, 0U);
  EXPECT_EQ(three[2].place.curve, 2U);
}

TEST(RayHits, OfNothingAreNoneAndOfNoNumbersAnError) {
  const Bounding_arc_tree_2 index{ba::Drawing_2<double>()};
  EXPECT_TRUE(ba::ray_hits(index, {0, 0}, {1, 0}).empty());
  EXPECT_THROW((void)ba::ray_hits(index, {0, 0}, {0, 0}), std::invalid_argument);
  EXPECT_THROW((void)ba::ray_hits(index, {0, 0}, {std::nan(""), 0}), std::invalid_argument);
}

}  // namespace
}  // namespace test_ray_hits
