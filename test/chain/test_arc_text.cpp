// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Arcs, regions and chains as text: the forms that their headers tell, and doubles that are read back as they were.

#include <CGAL/Bounding_arcs_2.h>
#include <CGAL/Bounding_arcs_2/region/Arc_region_2.h>

#include <gtest/gtest.h>

#include <iomanip>
#include <random>
#include <sstream>
#include <string>

namespace test_arc_text {
namespace {

namespace ba = CGAL::Bounding_arcs;

template <class Thing> std::string text_of(const Thing& thing) {
  std::ostringstream out;
  out << thing;
  return out.str();
}

TEST(ArcText, IsOneLineOfEndsAndBulge) {
  EXPECT_EQ(text_of(ba::Arc_2{{0, 1.5}, {2, -3}, -0.25}), "0 1.5 -0.25 2 -3");
  EXPECT_EQ(text_of(ba::Arc_2{{0.1, 0}, {1e300, 1}, 0}), "0.10000000000000001 0 0 1.0000000000000001e+300 1");
}

TEST(ArcText, IsReadBackBitForBit) {
  std::mt19937 random(5);
  std::normal_distribution<double> number;
  for (int i = 0; i < 100; ++i) {
    const ba::Arc_2 arc{{number(random), number(random)}, {number(random), number(random)}, number(random)};
    std::istringstream in(text_of(arc));
    ba::Arc_2 read;
    ASSERT_TRUE(in >> read.from.x >> read.from.y >> read.bulge >> read.to.x >> read.to.y);
    EXPECT_EQ(read.from, arc.from);
    EXPECT_EQ(read.to, arc.to);
    EXPECT_EQ(read.bulge, arc.bulge);
  }
}

TEST(ArcText, NeitherMindsTheStreamsFormatNorChangesIt) {
  std::ostringstream out;
  out << std::fixed << std::showpos << std::setprecision(2) << ba::Arc_2{{0, 1.5}, {2, -3}, 0.125} << ' ' << 1.0;
  EXPECT_EQ(out.str(), "0 1.5 0.125 2 -3 +1.00");
}

TEST(RegionText, HasSidesInBrackets) {
  ba::Arc_region_2 region{{0, 0}, {2, 0}, {}, {}};
  region.inner.bulges[0] = 0.25;
  region.outer.size = 2;
  region.outer.bulges[0] = 0.5;
  region.outer.joint = {1, -1};
  region.outer.bulges[1] = 0.125;
  region.widening = 0x1p-50;
  EXPECT_EQ(text_of(region), "0 0 [0.25] [0.5 1 -1 0.125] 2 0 8.8817841970012523e-16");
}

TEST(ChainText, HasCommonPointsOnce) {
  ba::Arc_chain chain;
  EXPECT_EQ(text_of(chain), "");
  chain.arcs.push_back({{{0, 0}, {1, 0}, 0.5}});
  chain.arcs.push_back({{{1, 0}, {2, 1}, 0}});
  EXPECT_EQ(text_of(chain), "0 0 0.5 1 0 0 2 1");
  chain.arcs.push_back({{{5, 5}, {6, 5}, -0.5}});
  EXPECT_EQ(text_of(chain), "0 0 0.5 1 0 0 2 1, 5 5 -0.5 6 5");
}

TEST(ChainText, OfAnOffsetComesBackToItsStart) {
  ba::Offset::Chain chain;
  for (const ba::Arc_2& arc : {ba::Arc_2{{0, 0}, {1, 0}, 1}, ba::Arc_2{{1, 0}, {0, 0}, 1}}) {
    ba::Offset::Piece piece{};
    piece.arc = arc;
    chain.pieces.push_back(piece);
  }
  EXPECT_EQ(text_of(chain), "0 0 1 1 0 1 0 0");
}

}  // namespace
}  // namespace test_arc_text
