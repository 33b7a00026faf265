// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Curves cut by regions: parts cover their pieces, and points of them are where their side says.

#include "cases.h"
#include "closed_drawings.h"
#include "query_drawings.h"

#include <CGAL/Bounding_arcs_2.h>
#include <CGAL/Bounding_arcs_2/query/point_location.h>

#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <stdexcept>
#include <string>
#include <vector>

namespace test_clip {

using namespace bounding_arcs_test;
using ba::Clipped_2;
using ba::Fill_rule;

Clipped_2 clip(const Drawing& curves, const Drawing& region, Fill_rule rule = Fill_rule::NONZERO) {
  return ba::clip(ba::Bounding_arc_tree_2(curves), ba::Bounding_arc_tree_2(region), rule);
}

/// How many parts are on each side.
struct Sides {
  int inside = 0, outside = 0, on = 0;
};

void expect_right(const Drawing& curves, const Drawing& region, Fill_rule rule, Sides& sides) {
  const Clipped_2 clipped = clip(curves, region, rule);
  ASSERT_EQ(clipped.status, ba::Outline_2::Status::COMPLETE);
  const ba::Bounding_arc_tree_2 hierarchy(region);
  const ba::Point_location_2 location(hierarchy);
  std::size_t next = 0;
  for (std::uint32_t c = 0; c < curves.curves().size(); ++c)
    for (std::uint32_t b = 0; b < curves.curves()[c].beziers.size(); ++b) {
      const auto is_of_piece = [&](const ba::Clipped_2::Part& part) { return part.curve == c && part.bezier == b; };
      ba::Bracket from{0, 0};
      do {
        ASSERT_LT(next, clipped.parts.size());
        const auto& part = clipped.parts[next++];
        ASSERT_TRUE(is_of_piece(part) && part.from.touches(from) && part.from.lower <= part.to.upper);
        from = part.to;
        ++(part.side == CGAL::ON_BOUNDED_SIDE ? sides.inside
                                              : (part.side == CGAL::ON_UNBOUNDED_SIDE ? sides.outside : sides.on));
        constexpr double NEAR = 1e-9;
        for (const double share : {0.2, 0.5, 0.7}) {
          if (part.to.lower <= part.from.upper) break;  // no double is between them
          const Point q =
              curves.curves()[c].beziers[b].point(part.from.upper + share * (part.to.lower - part.from.upper));
          const double away = ba::closest_point(hierarchy, q)->distance.upper;
          if (part.side == CGAL::ON_BOUNDARY) {
            EXPECT_LT(away, NEAR);
          } else if (away > NEAR) {
            EXPECT_EQ(location.locate(q, rule), part.side) << q.x << ' ' << q.y;
          }
        }
      } while (next < clipped.parts.size() && is_of_piece(clipped.parts[next]));
      EXPECT_EQ(from.upper, 1);
    }
  EXPECT_EQ(next, clipped.parts.size());
}

TEST(Clip, PutsPartsOnTheSideThatTheyAreOn) {
  Sides sides;
  for (int i = 0; i < cases(150); ++i) {
    SCOPED_TRACE(i);
    std::mt19937 random(static_cast<unsigned>(i));
    const Drawing region = random_lattice_drawing(random, 3);
    Drawing curves;
    std::vector<Bezier> open = random_lattice_chain(random, 3);
    if (open.size() > 1) open.pop_back();
    curves.add(open);
    if (i % 3 == 0) curves.add(region.curves().front().beziers);  // runs along all of it
    const Bezier& first = region.curves().front().beziers.front();
    if (i % 3 == 1) curves.add({first.subcurve(0, 0.5)});
    expect_right(curves, region, i % 2 == 0 ? Fill_rule::NONZERO : Fill_rule::EVEN_ODD, sides);
    if (HasFailure()) return;
  }
  EXPECT_GT(sides.inside, cases(150) / 4);
  EXPECT_GT(sides.outside, cases(150) / 4);
  EXPECT_GT(sides.on, cases(150) / 4);
}

TEST(Clip, CutsALineByACircle) {
  Drawing line, circle;
  line.add({Bezier({{-2, 0}, {2, 0}})});
  circle.add(circle_of_quarters());
  const Clipped_2 clipped = clip(line, circle);
  ASSERT_EQ(clipped.parts.size(), 3u);
  EXPECT_EQ(clipped.parts[0].side, CGAL::ON_UNBOUNDED_SIDE);
  EXPECT_EQ(clipped.parts[1].side, CGAL::ON_BOUNDED_SIDE);
  EXPECT_EQ(clipped.parts[2].side, CGAL::ON_UNBOUNDED_SIDE);
  EXPECT_NEAR(clipped.parts[1].start.x, -1, 1e-15);
  EXPECT_NEAR(clipped.parts[1].end.x, 1, 1e-15);
  EXPECT_EQ(clipped.parts[1].end, clipped.parts[2].start);
}

TEST(Clip, PutsOnTheBoundaryOnlyWhatRunsAlong) {
  Drawing line, square;
  line.add({Bezier({{-1, 0}, {1, 0}, {3, 0}})});
  square.add(polygon({{0, 0}, {1, 0}, {1, 1}, {0, 1}}));
  const Clipped_2 clipped = clip(line, square);
  ASSERT_EQ(clipped.parts.size(), 3u);
  EXPECT_EQ(clipped.parts[0].side, CGAL::ON_UNBOUNDED_SIDE);
  EXPECT_EQ(clipped.parts[1].side, CGAL::ON_BOUNDARY);
  EXPECT_EQ(clipped.parts[2].side, CGAL::ON_UNBOUNDED_SIDE);
  EXPECT_EQ(clipped.parts[1].start.x, 0);
  EXPECT_EQ(clipped.parts[1].end.x, 1);
}

// Nearer to an edge than the errors of points: exact arithmetic tells.
TEST(Clip, TellsSidesThatDoublesDoNot) {
  Drawing region;
  region.add(polygon({{0, -1}, {1, -1}, {1, 0.5}, {0, 0}}));
  for (const double above : {0x1p-54, -0x1p-54}) {
    Drawing line;
    line.add({Bezier({{0.25, 0.125 + above}, {0.75, 0.375 + above}})});
    const Clipped_2 clipped = clip(line, region);
    ASSERT_EQ(clipped.parts.size(), 1u);
    EXPECT_EQ(clipped.parts.front().side, above > 0 ? CGAL::ON_UNBOUNDED_SIDE : CGAL::ON_BOUNDED_SIDE);
  }
}

// The part before the crossing is shorter than an ulp of what it is part of.
TEST(Clip, KeepsPartsShorterThanAnUlp) {
  Drawing region, from_inside, from_edge;
  region.add(polygon({{0, -1}, {1, -1}, {1, 0}, {0, 0}}));
  from_inside.add({Bezier({{0.5, -0x1p-60}, {0.5, 1}})});
  from_edge.add({Bezier({{0.5, 0}, {0.5, 1}})});
  const Clipped_2 two = clip(from_inside, region), one = clip(from_edge, region);
  EXPECT_EQ(two.status, ba::Outline_2::Status::COMPLETE);
  ASSERT_EQ(two.parts.size(), 2u);
  EXPECT_EQ(two.parts[0].side, CGAL::ON_BOUNDED_SIDE);
  EXPECT_EQ(two.parts[1].side, CGAL::ON_UNBOUNDED_SIDE);
  EXPECT_EQ(one.status, ba::Outline_2::Status::COMPLETE);
  ASSERT_EQ(one.parts.size(), 1u);
  EXPECT_EQ(one.parts[0].side, CGAL::ON_UNBOUNDED_SIDE);
}

TEST(Clip, RefusesOpenRegions) {
  Drawing line;
  line.add({Bezier({{-2, 0}, {2, 0}})});
  EXPECT_THROW(clip(line, line), std::invalid_argument);
}

}  // namespace test_clip
