// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// How raw offsets are cut into loops where parts touch.

#include "../../../src/library/offset/Tolerant_trimmer.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace test_tolerant_trimmer {
namespace {

using namespace CGAL::Bounding_arcs;
using namespace CGAL::Bounding_arcs::internal;
using Point = Xy<double>;

// A square with one side twice, straight and bent outwards by less than the reach: loops have one of both.
TEST(TolerantTrimmer, TellsHowFarLoopsAreFromTheBoundary) {
  constexpr double REACH = 0x1p-8;
  for (const double height : {0.2 * REACH, 0.9 * REACH})
    for (const bool is_bent_first : {false, true}) {
      const Point corners[] = {{0, 0}, {0, 1}, {1, 1}, {1, 0}};
      const double bulge = -2 * height;
      Raw_offset raw;
      const auto add = [&](std::size_t i, double b) {
        raw.edges.push_back({{corners[i], corners[(i + 1) % 4], b}, 0, Offset::Kind::CURVE, false, false, false, 0});
      };
      add(0, is_bent_first ? bulge : 0);
      for (std::size_t i = 1; i < 4; ++i) add(i, 0);
      add(0, is_bent_first ? 0 : bulge);
      raw.runs = {{0, 4, true}, {4, 5, false}};
      const Arc_2 side{corners[0], corners[1], bulge};
      const auto is_right = [&](const Point& p) {
        return p.x > 0 || (p.y > 0 && p.y < 1 && p.x > -4 * height * p.y * (1 - p.y));
      };
      const auto covers = [&](const Point& p) { return is_right(p) && p.x < 1 && p.y > 0 && p.y < 1; };
      Tolerant_trimmer trimmer(raw, covers, 0x1p-40, REACH);
      ASSERT_TRUE(trimmer.trim());
      ASSERT_EQ(trimmer.loops().size(), 1U);
      double farthest = 0;
      for (const Raw_part& part : trimmer.loops()[0])
        for (int k = 0; k <= 8; ++k) {
          const Point p = point(part.arc, k / 8.0);
          if (p.x < 0.1 && p.y > 0.1 && p.y < 0.9) farthest = (std::max)(farthest, std::fabs(signed_distance(p, side)));
        }
      EXPECT_LE(farthest, trimmer.error()) << height;
      EXPECT_LE(trimmer.error(), 4 * REACH);
    }
}

TEST(TolerantTrimmer, TellsWherePartsMakeNoLoop) {
  Raw_offset raw;
  raw.edges.push_back({{{3, 1}, {5, 2}, 0}, 0, Offset::Kind::CURVE, true, false, false, 0});
  raw.runs.push_back({0, 1, false});
  const auto covers = [](const Point& p) { return p.y > 1 + (p.x - 3) / 2; };  // on one side, and the edge ends
  Tolerant_trimmer trimmer(raw, covers, 0x1p-40, 0x1p-10);
  ASSERT_FALSE(trimmer.trim());
  const Point& p = trimmer.unresolved();
  EXPECT_TRUE(p == (Point{3, 1}) || p == (Point{5, 2})) << p.x << ' ' << p.y;
}

}  // namespace
}  // namespace test_tolerant_trimmer
