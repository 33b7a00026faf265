// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Offsets of many curves: parents of chains, winding numbers of rings, and curves that are trimmed apart. What would
// take time as the square of their number is counted, not timed.

#include "offset_checks.h"

#include <CGAL/Bounding_arcs_2/offset/Offset_source_2.h>
#include <CGAL/Bounding_arcs_2/offset/internal/Arc_rings.h>
#include <CGAL/Bounding_arcs_2/offset/internal/offset_chains.h>

#include <gtest/gtest.h>

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <random>
#include <vector>

namespace test_many_curves {
namespace {

using namespace bounding_arcs_test;
using ba::Arc_2;

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
    ba::internal::Arc_rings rings;
    rings.add(arcs, arc_of);
    rings.finish();
    for (int i = 0; i < 2000; ++i) {
      Point x{coordinate(random), coordinate(random)};
      if (i % 4 == 1) x.y = of_ring[random() % arcs].from.y;  // at a corner's height
      if (i % 4 == 2) x.x = of_ring[random() % arcs].from.x;
      int expected = 0, found = 0;
      for (const Arc_2& arc : of_ring) expected += ba::internal::winding_of_arc(arc, x);
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
  ba::internal::Arc_rings rings;
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

// The parent of each chain, as all chains tell one by one.
void expect_smallest_around(const std::vector<ba::Offset_chain>& chains) {
  for (std::size_t i = 0; i < chains.size(); ++i) {
    const Point x = point(chains[i].pieces.front().arc, 0.5);
    const ba::Offset_chain* smallest = nullptr;
    for (const ba::Offset_chain& other : chains) {
      int winding = 0;
      for (const ba::Offset_piece& p : other.pieces) winding += ba::internal::winding_of_arc(p.arc, x);
      const bool is_around = &other != &chains[i] && winding != 0;
      if (is_around && (smallest == nullptr || std::fabs(other.area) < std::fabs(smallest->area))) smallest = &other;
    }
    ASSERT_EQ(chains[i].parent.has_value(), smallest != nullptr) << i;
    if (smallest != nullptr) {
      EXPECT_EQ(&chains[*chains[i].parent], smallest) << i;
    }
  }
}

// Circles in circles beside circles, each level in another direction.
void add_nest(Drawing& drawing, const Point& center, double radius, int depth, bool is_reversed) {
  const Drawing one = is_reversed ? backwards(drawing_of(circle(center, radius))) : drawing_of(circle(center, radius));
  for (const auto& curve : one.curves()) drawing.add(curve.beziers);
  if (depth == 0) return;
  for (const double side : {-0.5, 0.5})
    add_nest(drawing, {center.x + side * radius, center.y + 0.1 * side * radius}, 0.4 * radius, depth - 1,
             !is_reversed);
}

TEST(ManyCurves, HaveTheSmallestChainAroundForAParent) {
  Drawing drawing;
  for (const double x : {0.0, 3.0, 6.0}) add_nest(drawing, {x, 0}, 1, 4, false);
  for (const double d : {0.001, -0.001}) {
    const Offset offset = offset_curves(drawing, d, within(1e-5));
    expect_sound(offset);
    EXPECT_EQ(offset.chains.size(), drawing.curves().size());
    expect_smallest_around(offset.chains);
  }
}

TEST(ManyCurves, AreToldWhereTheyBoundNothing) {
  const auto left_out = [](const Drawing& drawing, ba::Fill_rule rule) {
    Offset_options options = within(1e-5);
    options.rule = rule;
    return offset_source(drawing, options).left_out();
  };
  using Numbers = std::vector<std::uint32_t>;
  const auto circles = [](const std::vector<double>& centers, const std::vector<double>& radii) {
    Drawing drawing;
    for (std::size_t i = 0; i < radii.size(); ++i) drawing.add(circle({centers[i], 0}, radii[i]));
    return drawing;
  };
  const Drawing nested = circles({0, 0, 0}, {3, 2, 1}), apart = circles({0, 9}, {1, 2}),
                twice = circles({0, 0}, {1, 1}),
                across = circles({0, 1, 1.5}, {2, 2, 0.25});  // the last one is where both others are
  EXPECT_EQ(left_out(nested, ba::Fill_rule::NONZERO), (Numbers{1, 2}));
  EXPECT_EQ(left_out(nested, ba::Fill_rule::EVEN_ODD), Numbers());
  EXPECT_EQ(left_out(apart, ba::Fill_rule::NONZERO), Numbers());
  EXPECT_EQ(left_out(twice, ba::Fill_rule::EVEN_ODD), (Numbers{0, 1}));
  EXPECT_EQ(left_out(across, ba::Fill_rule::NONZERO), (Numbers{2}));
  EXPECT_EQ(left_out(across, ba::Fill_rule::EVEN_ODD), Numbers());
}

TEST(ManyCurves, AreTrimmedApartAsTheyAreAlone) {
  Drawing all;
  std::vector<Drawing> alone;
  std::mt19937 random(3);
  std::uniform_real_distribution<double> size(0.5, 1.4);
  for (int i = 0; i < 30; ++i) {  // of three neighbours the offsets meet
    Drawing group;
    for (int k = 0; k < 3; ++k) group.add(circle({20.0 * i + 2.5 * k, 0}, size(random)));
    for (const auto& curve : group.curves()) all.add(curve.beziers);
    alone.push_back(std::move(group));
  }
  for (const double d : {0.6, 1.2, -0.3}) {
    SCOPED_TRACE(d);
    const Offset together = offset_curves(all, d, within(1e-6));
    expect_sound(together);
    expect_at_distance(all, together, 1e-6);  // where offsets meet they are trimmed
    std::size_t next = 0;
    for (const Drawing& group : alone)
      for (const ba::Offset_chain& chain : offset_curves(group, d, within(1e-6)).chains) {
        ASSERT_LT(next, together.chains.size());
        const ba::Offset_chain& same = together.chains[next++];
        ASSERT_EQ(same.pieces.size(), chain.pieces.size());
        for (std::size_t i = 0; i < chain.pieces.size(); ++i) {
          EXPECT_EQ(same.pieces[i].arc.from, chain.pieces[i].arc.from);
          EXPECT_EQ(same.pieces[i].arc.bulge, chain.pieces[i].arc.bulge);
        }
      }
    EXPECT_EQ(next, together.chains.size());
  }
}

}  // namespace
}  // namespace test_many_curves
