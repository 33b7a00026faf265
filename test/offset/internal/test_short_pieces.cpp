// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Short pieces of chains, left out or kept.

#include "exact_sweep.h"
#include "offset_checks.h"

#include "../../../src/library/offset/offset_chains.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstddef>
#include <vector>

namespace test_short_pieces {
namespace {

using namespace bounding_arcs_test;

constexpr double PI = 3.141592653589793;

ba::Offset::Chain chain_of(const std::vector<Point>& corners) {
  ba::Offset::Chain chain;
  for (std::size_t i = 0; i < corners.size(); ++i)
    chain.pieces.push_back({{corners[i], corners[(i + 1) % corners.size()], 0}, {0, 0, 0}, 1});
  chain.area = ba::internal::size_of(chain.pieces).area;
  chain.is_ccw = chain.area > 0;
  return chain;
}
// A chain with a short piece, whose neighbours may not be led on over another chain, nor farther than what is left.
TEST(ShortPieces, AreLeftOutOnlyWhereNothingCrosses) {
  constexpr double EPS = 1, ROOM = 1e-14, SHORT = 1.0 / 32;
  const std::vector<Point> corners{{0, 0}, {10, 0}, {10, SHORT}, {20, 10}, {0, 10}};
  const auto count = [&](const std::vector<ba::Offset::Chain>& others, double most) {
    Offset offset;
    offset.chains.push_back(chain_of(corners));
    offset.chains.insert(offset.chains.end(), others.begin(), others.end());
    const double moved = ba::leave_out_short(offset, EPS, most, ROOM);
    EXPECT_LE(moved, most);
    EXPECT_TRUE(do_not_cross(offset.chains));
    return offset.chains[0].pieces.size();
  };
  EXPECT_EQ(count({}, EPS / 4), 4U);
  EXPECT_EQ(count({}, SHORT / 2), 5U);
  // tips between where neighbours are and where they would be led on to
  const ba::Offset::Chain below = chain_of({{12, -1}, {15, 5 + SHORT / 4}, {25, -1}}),
                          above = chain_of({{5, SHORT / 4}, {6, 1}, {4, 1}});
  EXPECT_EQ(count({below}, EPS / 4), 4U);
  EXPECT_EQ(count({above}, EPS / 4), 4U);
  EXPECT_EQ(count({below, above}, EPS / 4), 5U);
}
// What turns back is cut off where rounding would tell on which side it goes back.
TEST(ShortPieces, LeaveTipsBlunt) {
  constexpr double WIDTH = 1e-13, ROOM = 1e-12;
  Offset offset;
  offset.chains.push_back(chain_of({{0, 0}, {10, 0}, {10, WIDTH}, {7, 3}, {0, 3}}));
  offset.chains[0].pieces[2].arc.bulge = -std::tan(PI / 8);  // begins parallel to the first piece, the other way
  EXPECT_EQ(ba::leave_out_short(offset, 1e-3, 1e-4, ROOM), 0);
  EXPECT_EQ(offset.chains[0].pieces.size(), 5U);
  offset.chains[0].pieces[1].arc.to.x = offset.chains[0].pieces[2].arc.from.x = 10 + WIDTH / 4;
  EXPECT_EQ(ba::put_together(offset, 1e-4, ROOM), 0);
  EXPECT_EQ(offset.chains[0].pieces.size(), 5U);
  offset.chains[0].pieces[2].arc.bulge = 0;
  EXPECT_GT(ba::leave_out_short(offset, 1e-3, 1e-4, ROOM), 0);
  EXPECT_EQ(offset.chains[0].pieces.size(), 4U);
}

}  // namespace
}  // namespace test_short_pieces
