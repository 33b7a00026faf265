// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Boxes over items in a row: every level against the union of its items, for every number of items up to some levels.

#include <CGAL/Bounding_arcs_2/internal/tree/for_each_index.h>
#include <CGAL/Bounding_arcs_2/tree/Box_hierarchy.h>

#include <CGAL/tags.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <random>
#include <vector>

namespace test_box_hierarchy {
namespace {

using CGAL::Bounding_arcs::Box_hierarchy;

std::vector<CGAL::Bbox_2> random_boxes(std::size_t count) {
  std::mt19937 random(701);
  std::uniform_real_distribution<double> unit(0, 1);
  std::vector<CGAL::Bbox_2> boxes;
  for (std::size_t i = 0; i < count; ++i) {
    const double x = 10 * unit(random), y = 10 * unit(random);
    boxes.emplace_back(x, y, x + unit(random), y + unit(random));
  }
  return boxes;
}

TEST(BoxHierarchy, JoinsTheItemsBelowEachBox) {
  for (std::size_t count = 1; count <= 140; ++count) {
    const std::vector<CGAL::Bbox_2> items = random_boxes(count);
    const auto item = [&](std::size_t i) { return items[i]; };
    Box_hierarchy boxes(count);
    CGAL::Bounding_arcs::internal::for_each_range<CGAL::Sequential_tag>(
        count, [&](std::size_t begin, std::size_t end) { boxes.join_items(begin, end, item); });
    boxes.join_levels();
    std::size_t all = 0;
    for (int level = 0; level <= boxes.top_level(); ++level) {
      const std::size_t width = std::size_t(1) << level;
      ASSERT_EQ(boxes.size_of_level(level), (count + width - 1) / width);
      all += boxes.size_of_level(level);
      for (std::size_t k = 0; k < boxes.size_of_level(level); ++k) {
        CGAL::Bbox_2 joined = items[k * width];
        for (std::size_t i = k * width; i < (std::min)((k + 1) * width, count); ++i) joined += items[i];
        EXPECT_EQ(boxes.box(level, k, item), joined) << count << " items, level " << level << ", box " << k;
      }
    }
    EXPECT_EQ(boxes.size_of_level(boxes.top_level()), 1u);
    EXPECT_EQ(boxes.size(), all);
  }
}

TEST(BoxHierarchy, IsEmptyWithoutItems) {
  EXPECT_EQ(Box_hierarchy().size(), 0u);
  EXPECT_EQ(Box_hierarchy(0).size(), 0u);
}

}  // namespace
}  // namespace test_box_hierarchy
