// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Trees with optimal splits: leaves that tile every segment within the tolerance, as few as asked, and what happens at
// limits.

#include "bundled_spirals.h"
#include "cases.h"
#include "trees.h"

#include <CGAL/Bounding_arcs_2/tree/Region_hierarchy_2.h>
#include "../../../src/library/chain/Cubic_arcs.h"
#include "../../../src/study/slope_integral.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>
#include <memory>
#include <vector>

namespace test_optimal_tree {
namespace {

using namespace CGAL::Bounding_arcs;
using namespace bounding_arcs_test;

template <class Traits> class Optimal_tree : public testing::Test {};
TYPED_TEST_SUITE(Optimal_tree, All_traits);

// Leaves in curve order tile all segments, each within eps as single pieces are decided.
template <class Traits> void expect_tiles(const Region_hierarchy_2<Traits, Spiral>& tree, double eps) {
  const auto bound = Traits().bound_thickness_2_object();
  std::uint32_t spiral = 0;
  double reached = tree.spirals().front().first();
  tree.for_each_leaf([&](const Node_handle& h) {
    const Region_node n = tree.node(h);
    if (n.spiral != spiral) {
      EXPECT_EQ(reached, tree.spirals()[spiral].last());
      EXPECT_EQ(n.spiral, ++spiral);
      reached = tree.spirals()[spiral].first();
    }
    EXPECT_EQ(n.t0, reached);
    EXPECT_LT(n.t0, n.t1);
    EXPECT_LE(tree.thickness(h), eps);
    EXPECT_TRUE(bound(Spiral_source{tree.spirals()[n.spiral], n.t0, n.t1}, eps).within);
    reached = n.t1;
  });
  EXPECT_EQ(spiral + 1, tree.spirals().size());
  EXPECT_EQ(reached, tree.spirals().back().last());
}

TYPED_TEST(Optimal_tree, TilesSegmentsWithinTheTolerance) {
  for (const double eps : {1e-3, 1e-6}) {
    if (FEW_CASES && eps < 1e-4) break;
    const Region_hierarchy_2<TypeParam, Spiral> tree(random_spirals(420, 20), eps,
                                                     nodes_of_kind(Build_options::Nodes::EQUALIZED));
    EXPECT_EQ(tree.status(), Build_status::COMPLETE);
    EXPECT_LE(tree.bound(), eps);
    expect_tiles(tree, eps);
  }
}

template <class Traits> void expect_few_leaves(double factor) {
  constexpr double EPS = 1e-8;
  for (const auto& curve : bundled_curves()) {
    double least = 0;
    for (const Spiral& s : curve.spirals) least += std::cbrt(factor / EPS) * slope_integral(s);
    const Region_hierarchy_2<Traits, Spiral> tree(curve.spirals, EPS, nodes_of_kind(Build_options::Nodes::EQUALIZED));
    EXPECT_EQ(tree.status(), Build_status::COMPLETE);
    EXPECT_LE(static_cast<double>(tree.number_of_leaves()), 1.03 * least + static_cast<double>(curve.spirals.size()))
        << curve.name;
  }
}
TEST(OptimalTree, HasFewLeavesOnBundledCurves) {
  if (FEW_CASES) return;
  expect_few_leaves<Bca_traits_2<Kernel>>(cubic_factor::BCA);
  expect_few_leaves<Spiral_fat_arc_traits_2<Kernel>>(cubic_factor::SPIRAL_FAT_ARC);
  expect_few_leaves<Bilens_traits_2<Kernel>>(cubic_factor::BILENS);
}

TEST(OptimalTree, HasOneLeafASegmentWhereThatIsEnough) {
  const Bca_tree tree(random_spirals(421, 20), 1e3, nodes_of_kind(Build_options::Nodes::EQUALIZED));
  EXPECT_EQ(tree.number_of_leaves(), tree.spirals().size());
  expect_tiles(tree, 1e3);
}

TEST(OptimalTree, IsEmptyOverTheLimit) {
  Build_options options;
  options.max_nodes = 100;
  options.nodes = Build_options::Nodes::EQUALIZED;
  const Bca_tree tree(random_spirals(422, 20), 1e-6, options);
  EXPECT_EQ(tree.status(), Build_status::REGION_LIMIT);
  EXPECT_EQ(tree.number_of_leaves() + tree.spirals().size(), 0u);
}

TEST(OptimalTree, StopsWhereCoordinatesResolveNoMore) {
  std::vector<Spiral> spirals = random_spirals(423, 2);
  if (FEW_CASES) spirals.resize(1, spirals.front());
  const Bca_tree tree(spirals, 1e-300, nodes_of_kind(Build_options::Nodes::EQUALIZED));
  EXPECT_EQ(tree.status(), Build_status::RESOLUTION_REACHED);
  EXPECT_GE(tree.number_of_leaves(), spirals.size());
}

// A segment so short that eight pieces of it have no parameters.
TEST(OptimalTree, HoldsSegmentsOfAFewUlps) {
  const Spiral s = random_spirals(424, 1).front();
  const double last = std::nextafter(std::nextafter(0.5, 1), 1);
  const auto curve = std::make_shared<const Tabulated_bezier<double>>(s.curve());
  const Bca_tree tree({Spiral(curve, 0.5, last, End_orders{1, 1}, false)}, 1e-6,
                      nodes_of_kind(Build_options::Nodes::EQUALIZED));
  EXPECT_EQ(tree.number_of_leaves(), 1u);
}

}  // namespace
}  // namespace test_optimal_tree
