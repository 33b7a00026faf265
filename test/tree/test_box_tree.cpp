// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Boxes over items: each box is the union of its items', each item is once in the tree, and pairs that overlap are
// those that a plain scan finds, for every number of items up to some levels.

#include "../../src/library/tree/Box_tree.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <random>
#include <set>
#include <utility>
#include <vector>

namespace test_box_tree {
namespace {

using CGAL::Bounding_arcs::Box_tree;
using CGAL::Bounding_arcs::for_each_overlap;

std::vector<CGAL::Bbox_2> random_boxes(std::size_t count, unsigned seed, double size) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> unit(0, 1);
  std::vector<CGAL::Bbox_2> boxes;
  for (std::size_t i = 0; i < count; ++i) {
    const double x = unit(random), y = unit(random);
    boxes.emplace_back(x, y, x + size * unit(random), y + size * unit(random));
  }
  return boxes;
}

// The union of the items below a node; adds them.
CGAL::Bbox_2 expect_unions(const Box_tree& tree, const Box_tree::Node& node, const std::vector<CGAL::Bbox_2>& items,
                           std::multiset<std::uint32_t>& found, int level, int& depth) {
  depth = (std::max)(depth, level);
  CGAL::Bbox_2 all;
  EXPECT_GE(node.size, 1);
  for (std::size_t k = 0; k < node.size; ++k) {
    CGAL::Bbox_2 below;
    if (node.is_item(k)) {
      found.insert(node.child[k]);
      below = items[node.child[k]];
    } else {
      below = expect_unions(tree, tree.node(node.child[k]), items, found, level + 1, depth);
    }
    EXPECT_EQ(node.box(k), below);
    all = k == 0 ? below : all + below;
  }
  return all;
}

TEST(BoxTree, HasUnionsOfItemsEachOnce) {
  EXPECT_TRUE(Box_tree().empty());
  EXPECT_EQ(Box_tree(std::vector<CGAL::Bbox_2>()).size(), 0u);
  for (std::size_t count = 1; count < 300; count += count < 40 ? 1 : 37) {
    const std::vector<CGAL::Bbox_2> items = random_boxes(count, 7, 1);
    const Box_tree tree(items);
    std::multiset<std::uint32_t> found;
    int depth = 0;
    EXPECT_EQ(expect_unions(tree, tree.root(), items, found, 1, depth), tree.box());
    EXPECT_EQ(found.size(), count);
    EXPECT_EQ(std::set<std::uint32_t>(found.begin(), found.end()).size(), count);
    EXPECT_EQ(tree.bytes(), tree.size() * sizeof(Box_tree::Node));
    EXPECT_LE(depth, 1 + std::ceil(std::log(count) / std::log(4)));
  }
}

TEST(BoxTree, FindsAllPairsThatOverlap) {
  for (const std::size_t count : {1u, 2u, 5u, 33u, 200u}) {
    const std::vector<CGAL::Bbox_2> a = random_boxes(count, 1, 0.2), b = random_boxes(count + 3, 2, 0.2);
    const Box_tree tree_a(a), tree_b(b);
    std::multiset<std::pair<std::uint32_t, std::uint32_t>> found, own, expected, expected_own;
    EXPECT_TRUE(for_each_overlap(tree_a, tree_b, [&](std::uint32_t i, std::uint32_t j) {
      found.emplace(i, j);
      return true;
    }));
    EXPECT_TRUE(for_each_overlap(tree_a, [&](std::uint32_t i, std::uint32_t j) {
      own.emplace((std::min)(i, j), (std::max)(i, j));
      return true;
    }));
    for (std::uint32_t i = 0; i < a.size(); ++i) {
      for (std::uint32_t j = 0; j < b.size(); ++j)
        if (do_overlap(a[i], b[j])) expected.emplace(i, j);
      for (std::uint32_t j = i + 1; j < a.size(); ++j)
        if (do_overlap(a[i], a[j])) expected_own.emplace(i, j);
    }
    EXPECT_EQ(found, expected);
    EXPECT_EQ(own, expected_own);
    std::size_t seen = 0;
    const bool went_on = for_each_overlap(tree_a, tree_b, [&](std::uint32_t, std::uint32_t) { return ++seen < 2; });
    EXPECT_EQ(went_on, expected.size() < 2);
  }
}

}  // namespace
}  // namespace test_box_tree
