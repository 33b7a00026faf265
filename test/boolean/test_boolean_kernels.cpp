// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Boolean operations of trees over each kind of kernel: the same outlines, or, over doubles alone, none.

#include "cases.h"
#include "closed_drawings.h"
#include "kernel_trees.h"
#include "outline_checks.h"

#include <CGAL/Bounding_arcs_2.h>
#include <CGAL/Bounding_arcs_2/curve/Drawing_2.h>

#include <CGAL/Exact_rational.h>
#include <CGAL/Simple_cartesian.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <random>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

namespace test_boolean_kernels {

using namespace bounding_arcs_test;
using Exact = CGAL::Exact_rational;

constexpr Boolean_operation OPERATIONS[] = {Boolean_operation::UNION, Boolean_operation::INTERSECTION,
                                            Boolean_operation::DIFFERENCE, Boolean_operation::SYMMETRIC_DIFFERENCE};

template <class Tree> class BooleanKernels : public ::testing::Test {};
using Trees = ::testing::Types<Double_tree, Filtered_tree, Exact_tree>;
TYPED_TEST_SUITE(BooleanKernels, Trees);

TYPED_TEST(BooleanKernels, AgreeWithExactDecisions) {
  constexpr bool IS_DOUBLE = std::is_same_v<TypeParam, Double_tree>;
  int open = 0, count = 0;
  for (int i = 0; i < cases(20); ++i) {
    std::mt19937 random(static_cast<unsigned>(i));
    const Drawing a = random_lattice_drawing(random, 3), b = random_lattice_drawing(random, 3);
    const TypeParam tree_a(a.over<typename TypeParam::FT>()), tree_b(b.over<typename TypeParam::FT>());
    const Operands operands({a, b});
    for (const Boolean_operation operation : OPERATIONS) {
      SCOPED_TRACE("case " + std::to_string(i) + " operation " + std::to_string(static_cast<int>(operation)));
      const Outline_2 found = ba::boolean_operation({&tree_a, &tree_b}, operation);
      ++count;
      if (IS_DOUBLE && found.status != ba::Outline_2::Status::COMPLETE) {
        ++open;
        continue;
      }
      ASSERT_EQ(found.status, ba::Outline_2::Status::COMPLETE);
      EXPECT_EQ(parts_of(found, false), parts_of(operands.outline(operation, Fill_rule::NONZERO), false));
    }
  }
  EXPECT_LT(open, count);
}

// Corners at thirds, which are no doubles: an edge of one triangle runs through a corner of the other, and an edge of
// the third one along that edge.
TEST(BooleanKernels, CountNumbersThatAreNoDoubles) {
  const auto triangle = [](const std::vector<std::pair<int, int>>& corners, int parts) {
    std::vector<ba::Bezier_curve_2<Exact>> chain;
    const auto at = [&](std::size_t i) {
      const auto& [x, y] = corners[i % corners.size()];
      return ba::Xy<Exact>{Exact(x) / Exact(parts), Exact(y) / Exact(parts)};
    };
    for (std::size_t i = 0; i < corners.size(); ++i) chain.emplace_back(std::vector<ba::Xy<Exact>>{at(i), at(i + 1)});
    ba::Drawing_2<Exact> drawing;
    drawing.add(std::move(chain));
    return drawing;
  };
  for (const int parts : {1, 3}) {
    const Exact_tree a(triangle({{0, 0}, {7, 1}, {1, 5}}, parts)), b(triangle({{4, 3}, {9, 4}, {6, 8}}, parts)),
        c(triangle({{7, 1}, {4, 3}, {8, 9}}, parts));
    const Outline_2 touching = ba::intersection(a, b), along = ba::unite(a, c), beside = ba::intersection(a, c);
    EXPECT_EQ(touching.status, ba::Outline_2::Status::COMPLETE);
    EXPECT_TRUE(touching.chains.empty()) << parts;  // a point
    ASSERT_EQ(along.chains.size(), 1u) << parts;
    EXPECT_EQ(along.chains.front().parts.size(), 5u) << parts;  // without what they share
    EXPECT_TRUE(beside.chains.empty()) << parts;
    const ba::Outline_2::Drawn drawn = ba::drawn_outline({&a, &c}, along);
    EXPECT_GE(drawn.moved, (std::max)(a.rounding(), c.rounding())) << parts;
    EXPECT_LE(drawn.moved, 1e-13) << parts;
  }
}

}  // namespace test_boolean_kernels
