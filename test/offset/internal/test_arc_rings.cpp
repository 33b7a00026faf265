// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Winding numbers of rings of arcs. What would take time as the square of their number is counted, not timed.

#include "bulge_arcs.h"

#include "../../../src/library/offset/Arc_boxes.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstddef>
#include <random>
#include <vector>

namespace test_arc_rings {
namespace {

using namespace bounding_arcs_test;
using namespace CGAL::Bounding_arcs;
using namespace CGAL::Bounding_arcs::internal;
using Point = Xy<double>;

// Arcs round a center, of about a radius, from corner to corner.
std::vector<Arc_2> ring(const Point& center, double radius, std::size_t arcs, std::mt19937& random) {
  std::uniform_real_distribution<double> share(0.8, 1.2), bulge(-0.2, 0.4);
  std::vector<Point> corners;
  for (std::size_t i = 0; i < arcs; ++i) {
    const double angle = 6.283185307179586 * static_cast<double>(i) / static_cast<double>(arcs),
                 r = radius * share(random);
    corners.push_back({center.x + r * std::cos(angle), center.y + r * std::sin(angle)});
  }
  std::vector<Arc_2> result;
  for (std::size_t i = 0; i < arcs; ++i) result.push_back({corners[i], corners[(i + 1) % arcs], bulge(random)});
  return result;
}

TEST(ArcRings, WindAsOftenAsTheirArcsDo) {
  std::mt19937 random(1);
  std::uniform_real_distribution<double> coordinate(-1.5, 1.5);
  for (const std::size_t arcs : {2U, 3U, 16U, 17U, 100U, 1000U}) {
    SCOPED_TRACE(arcs);
    const std::vector<Arc_2> of_ring = ring({0, 0}, 1, arcs, random);
    const auto arc_of = [&](std::size_t k) -> const Arc_2& { return of_ring[k]; };
    Arc_rings rings;
    rings.add(arcs, arc_of);
    rings.finish();
    for (int i = 0; i < 2000; ++i) {
      Point x{coordinate(random), coordinate(random)};
      if (i % 4 == 1) x.y = of_ring[random() % arcs].from.y;  // at a corner's height
      if (i % 4 == 2) x.x = of_ring[random() % arcs].from.x;
      int expected = 0, found = 0;
      for (const Arc_2& arc : of_ring) expected += winding_of(arc, x);
      rings.for_each_about(x, [&](std::size_t r) { found += rings.winding(r, x, arc_of); });
      ASSERT_EQ(found, expected) << x.x << " " << x.y;
    }
  }
}

// How many arcs are looked at to tell which rings of a row run round a point of each.
double arcs_looked_at(std::size_t count, std::size_t arcs) {
  std::mt19937 random(2);
  std::vector<std::vector<Arc_2>> row;
  for (std::size_t i = 0; i < count; ++i) row.push_back(ring({3.0 * static_cast<double>(i), 0}, 1, arcs, random));
  std::size_t looked_at = 0;
  const auto arcs_of = [&](std::size_t r) {
    return [&looked_at, &own = row[r]](std::size_t k) -> const Arc_2& {
      ++looked_at;
      return own[k];
    };
  };
  Arc_rings rings;
  for (std::size_t i = 0; i < count; ++i) rings.add(arcs, arcs_of(i));
  rings.finish();
  looked_at = 0;
  for (std::size_t i = 0; i < count; ++i) {
    int winding = 0;
    const Point x{3.0 * static_cast<double>(i), 0.01};
    rings.for_each_about(x, [&](std::size_t r) { winding += rings.winding(r, x, arcs_of(r)); });
    EXPECT_EQ(winding, 1);
  }
  return static_cast<double>(looked_at) / static_cast<double>(count);
}

TEST(ArcRings, LookAtNoMoreArcsInALongerRow) { EXPECT_LE(arcs_looked_at(4000, 12), 1.1 * arcs_looked_at(40, 12)); }

TEST(ArcRings, LookAtFewOfManyArcs) { EXPECT_LE(arcs_looked_at(2, 1 << 16), 16 * arcs_looked_at(2, 1 << 6)); }

}  // namespace
}  // namespace test_arc_rings
