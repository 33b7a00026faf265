// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Offsets of many curves: parents of chains, winding numbers of rings, and curves that are trimmed apart. What would
// take time as the square of their number is counted, not timed.

#include "offset_checks.h"

#include <CGAL/Bounding_arcs_2/offset/Offset_source_2.h>

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

// The parent of each chain, as all chains tell one by one.
void expect_smallest_around(const std::vector<ba::Offset::Chain>& chains) {
  for (std::size_t i = 0; i < chains.size(); ++i) {
    const Point x = point(chains[i].pieces.front().arc, 0.5);
    const ba::Offset::Chain* smallest = nullptr;
    for (const ba::Offset::Chain& other : chains) {
      int winding = 0;
      for (const ba::Offset::Piece& p : other.pieces) winding += winding_of(p.arc, x);
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
      for (const ba::Offset::Chain& chain : offset_curves(group, d, within(1e-6)).chains) {
        ASSERT_LT(next, together.chains.size());
        const ba::Offset::Chain& same = together.chains[next++];
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
