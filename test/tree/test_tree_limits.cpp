// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The hierarchy over degenerate curves and a user's own, and at the limits of resolution, memory and sense.

#include "cases.h"
#include "trees.h"

#include <CGAL/Bounding_arcs_2.h>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Simple_cartesian.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <random>
#include <stdexcept>

namespace test_tree_limits {
namespace {

using namespace CGAL::Bounding_arcs;
using namespace bounding_arcs_test;

template <class Traits> class TreeLimits : public testing::Test {};
TYPED_TEST_SUITE(TreeLimits, All_traits);

// Zero handles, cusps, loops, lines, folded lines and points, at scales from 1e-150 to 1e150.
TYPED_TEST(TreeLimits, TakesDegenerateCurvesAsNormalInput) {
  const std::vector<Bezier> curves{
      Bezier({{0, 0}, {0, 0}, {1, 0}, {3, 3}}),  Bezier({{3, 3}, {1, 0}, {0, 0}, {0, 0}}),
      Bezier({{0, 0}, {0, 0}, {1, 1}, {1, 1}}),  Bezier({{0, 0}, {0, 0}, {0, 0}, {1, 1}, {1, 3}}),
      Bezier({{0, 0}, {1, 1}, {0, 1}, {1, 0}}),  Bezier({{0, 0}, {2, 1}, {-1, 1}, {1, 0}}),
      Bezier({{0, 0}, {3, 0}, {-1, 2}, {0, 0}}), Bezier({{0, 0}, {1, -1}, {-1, -0.5}, {3, 1.5}}),
      Bezier({{0, 0}, {2, 0}, {1, 0}}),          Bezier({{0, 0}, {0.1, 0.1}, {1, 1}}),
      Bezier({{1, 1}, {1, 1}, {1, 1}}),          Bezier({{0, 0}, {0, 0}, {1, 0}, {3, 3}}, {1, 3, 2, 1})};
  for (std::size_t i = 0; i < curves.size(); ++i) {
    for (const double scale : {1.0, 1e-150, 1e150}) {
      SCOPED_TRACE("curve " + std::to_string(i) + " times 10^" + std::to_string(std::log10(scale)));
      std::vector<Point> points = curves[i].control_points();
      for (Point& p : points) p = scale * p;
      const std::vector<Spiral> spirals = spiral_segments(Bezier(points, curves[i].weights()));
      for (const double eps : {1e-6 * scale, 1e-9 * scale}) {
        if (FEW_CASES && eps < 1e-7 * scale) break;
        const Region_hierarchy_2<TypeParam, Spiral> tree(spirals, eps);
        EXPECT_EQ(tree.status(), Build_status::COMPLETE);
        EXPECT_LE(tree.bound(), eps);
        EXPECT_LT(tree.number_of_leaves(), 500 * std::cbrt(1e-6 * scale / eps));
      }
    }
  }
}

// A circle but for the rounding of its weight: all differences of curvature are noise, and no region is thick.
TYPED_TEST(TreeLimits, DoesNotSplitRoundedCircularArcs) {
  for (const double scale : {1.0, 1e-150, 1e150}) {
    const Bezier arc({{scale, 0}, {scale, scale}, {0, scale}}, {1, std::sqrt(0.5), 1});
    const std::vector<Spiral> spirals = spiral_segments(arc);
    const Region_hierarchy_2<TypeParam, Spiral> coarse(spirals, 1e-6 * scale), fine(spirals, 1e-13 * scale);
    EXPECT_EQ(coarse.number_of_leaves(), spirals.size()) << "scale " << scale;
    EXPECT_LE(fine.number_of_leaves(), 2 * spirals.size()) << "scale " << scale;
    EXPECT_LE(coarse.bound(), 1e-11 * scale);
  }
}

TEST(BcaTree, SaysWhatItReachedBelowTheResolutionOfCoordinates) {
  const std::vector<Spiral> spirals = spiral_segments(Bezier({{0, 0}, {0.5, 0}, {1, 1}}));
  if (!FEW_CASES) {
    const Bca_tree fine(spirals, 1e-20);
    EXPECT_EQ(fine.status(), Build_status::RESOLUTION_REACHED);
    EXPECT_GT(fine.bound(), 1e-20);
    EXPECT_LE(fine.bound(), 2 * spirals[0].point_error());
    fine.for_each_leaf([&](const Node_handle& h) { EXPECT_LE(fine.thickness(h), fine.bound()); });
  }
  EXPECT_EQ(Bca_tree(spirals, 1e-14).status(), Build_status::COMPLETE);

  // coordinates near 1e6 with details of 1e-3
  const Bca_tree far(spiral_segments(Bezier({{1e6, 1e6}, {1e6 + 5e-4, 1e6}, {1e6 + 1e-3, 1e6 + 1e-3}})), 1e-12);
  EXPECT_EQ(far.status(), Build_status::RESOLUTION_REACHED);
  EXPECT_LE(far.bound(), 1e-8);
}

// No children, leaves or boxes, and nothing that a traversal comes to.
template <class Tree> void expect_empty(const Tree& tree) {
  const auto fail = [](const auto&) -> bool { throw std::logic_error("an empty tree has nothing to visit"); };
  tree.for_each_child(tree.root(), fail);
  tree.traverse(fail);
  tree.for_each_leaf(fail);
  EXPECT_EQ(tree.box(tree.root()), CGAL::Bbox_2());
  EXPECT_FALSE(tree.root().is_region);
  EXPECT_FALSE(tree.is_leaf(tree.root()));
  EXPECT_EQ(tree.spirals().size() + tree.number_of_boxes(), 0u);
}
template <class Tree> void expect_nothing_counted(const Tree& tree, Build_status status) {
  expect_empty(tree);
  EXPECT_EQ(tree.status(), status);
  EXPECT_EQ(tree.bound(), 0);
  EXPECT_EQ(tree.number_of_leaves() + tree.number_of_nodes() + tree.number_of_arcs(), 0u);
}

TYPED_TEST(TreeLimits, AnEmptyTreeIsATree) {
  expect_nothing_counted(Region_hierarchy_2<TypeParam, Spiral>({}, 1e-3), Build_status::COMPLETE);
#ifdef CGAL_LINKED_WITH_TBB
  expect_nothing_counted(Region_hierarchy_2<TypeParam, Spiral>({}, 1e-3, {}, TypeParam(), CGAL::Parallel_tag()),
                         Build_status::COMPLETE);
#endif
  expect_nothing_counted(
      Region_hierarchy_2<TypeParam, Spiral>({}, 1e-3, nodes_of_kind(Build_options::Nodes::EQUALIZED)),
      Build_status::COMPLETE);
  expect_empty(Region_hierarchy_2<TypeParam, Spiral>({}, 1e-3, nodes_of_kind(Build_options::Nodes::LAZY)));

  const std::vector<Spiral> spirals = random_spirals(412, 3);
  Build_options options;
  options.max_nodes = spirals.size() - 1;
  Region_hierarchy_2<TypeParam, Spiral> tree(spirals, 1e-3, options);
  expect_nothing_counted(tree, Build_status::REGION_LIMIT);
  options.nodes = Build_options::Nodes::EQUALIZED;
  const Region_hierarchy_2<TypeParam, Spiral> optimal(spirals, 1e-3, options);
  expect_nothing_counted(optimal, Build_status::REGION_LIMIT);
  tree.replace(0, 0, {});
  expect_nothing_counted(tree, Build_status::COMPLETE);
}

TYPED_TEST(TreeLimits, AnEmptyTreeTakesSegments) {
  const std::vector<Spiral> spirals = random_spirals(413, 3);
  const Region_hierarchy_2<TypeParam, Spiral> expected(spirals, 1e-3);
  Region_hierarchy_2<TypeParam, Spiral> tree({}, 1e-3);
  for (int round = 0; round < 2; ++round) {
    tree.replace(0, 0, spirals);
    EXPECT_EQ(tree.number_of_nodes(), expected.number_of_nodes());
    EXPECT_EQ(tree.box(tree.root()), expected.box(expected.root()));
    tree.replace(0, spirals.size(), {});
    expect_empty(tree);
    EXPECT_EQ(tree.number_of_nodes(), 0u);
  }
}

TEST(BcaTree, IsEmptyBeyondTheRegionLimit) {
  const std::vector<Spiral> spirals = random_spirals(406, 3);
  const std::size_t nodes = Bca_tree(spirals, 1e-4).number_of_nodes();
  Build_options options;
  options.max_nodes = nodes;
  EXPECT_EQ(Bca_tree(spirals, 1e-4, options).number_of_nodes(), nodes);
  options.max_nodes = nodes - 1;
  const Bca_tree tree(spirals, 1e-4, options);
  EXPECT_EQ(tree.status(), Build_status::REGION_LIMIT);
  expect_nothing_counted(tree, Build_status::REGION_LIMIT);
}

TEST(BcaTree, IsNotFilledBeyondTheRegionLimit) {
  const std::vector<Spiral> spirals = random_spirals(409, 3);
  const auto half = static_cast<std::ptrdiff_t>(spirals.size() / 2);
  const std::vector<Spiral> first(spirals.begin(), spirals.begin() + half),
      second(spirals.begin() + half, spirals.end());
  const std::size_t nodes = Bca_tree(spirals, 1e-4).number_of_nodes(), end = first.size();
  for (const std::size_t missing : {0u, 1u}) {
    Build_options options;
    options.max_nodes = nodes - missing;
    Bca_tree last(first, 1e-4, options), before(second, 1e-4, options);
    last.replace(end, end, second);
    before.replace(0, 0, first);
    for (Bca_tree* tree : {&last, &before}) {
      EXPECT_EQ(tree->status(), missing == 0 ? Build_status::COMPLETE : Build_status::REGION_LIMIT);
      EXPECT_EQ(tree->number_of_nodes(), missing == 0 ? nodes : 0u);
      EXPECT_EQ(tree->spirals().size(), missing == 0 ? spirals.size() : 0u);
    }
    if (missing == 0) continue;
    last.replace(0, 0, first);  // what is empty takes segments again
    EXPECT_EQ(last.status(), Build_status::COMPLETE);
    EXPECT_EQ(last.number_of_nodes(), Bca_tree(first, 1e-4).number_of_nodes());
    EXPECT_EQ(last.number_of_boxes(), Bca_tree(first, 1e-4).number_of_boxes());
  }
}

// Low levels are looked at first after a segment that went low, but not levels of more pieces than nodes are allowed.
TEST(BcaTree, LooksAtNoMorePiecesThanTheRegionLimit) {
  using Exact_spiral = Bezier_spiral_2<Exact>;
  std::vector<Exact_spiral> spirals;
  for (const double size : {1.0, 1e28})
    for (const Exact_spiral& s : spiral_segments(Bezier_curve_2<Exact>(
             {{Exact(0), Exact(0)}, {Exact(size), Exact(0.3 * size)}, {Exact(2 * size), Exact(1.5 * size)}})))
      spirals.push_back(s);
  Build_options options;
  options.max_nodes = 10000;
  const Region_hierarchy_2<Bca_traits_2<Kernel>, Exact_spiral> tree(spirals, 1e-4, options);
  EXPECT_EQ(tree.status(), Build_status::REGION_LIMIT);
  EXPECT_LT(tree.decisions().all(), 10 * options.max_nodes);
}

#ifdef CGAL_LINKED_WITH_TBB
TEST(BcaTree, StopsInAllThreadsAtTheRegionLimit) {
  const std::vector<Spiral> spirals(20000, spiral_segments(Bezier({{0, 0}, {0.5, 0}, {1, 1}})).front());
  const auto told_until_limit = [&](double eps, std::size_t limit) {
    std::size_t told = 0;
    Build_options options;
    options.max_nodes = limit;
    options.progress = [&](std::size_t, std::size_t) { ++told; };
    const Bca_tree tree(spirals, eps, options, {}, CGAL::Parallel_tag());
    EXPECT_EQ(tree.status(), Build_status::REGION_LIMIT);
    return told;
  };
  EXPECT_LT(told_until_limit(1e-4, 2000), spirals.size() / 2);  // too many in all, in no task
  EXPECT_LT(told_until_limit(1e-40, 100), 50u);                 // each segment is seen to need too many
}
#endif

TEST(BcaTree, RefusesAToleranceThatIsNotPositive) {
  const std::vector<Spiral> spirals = random_spirals(407, 1);
  using Limits = std::numeric_limits<double>;
  for (const double eps : {0.0, -1.0, -Limits::infinity(), Limits::quiet_NaN()})
    EXPECT_THROW(Bca_tree(spirals, eps), std::invalid_argument);
  EXPECT_EQ(Bca_tree({}, 1.0).number_of_nodes(), 0u);
  EXPECT_EQ(Bca_tree(spirals, Limits::infinity()).number_of_leaves(), spirals.size());
}

TEST(BcaTree, TellsItsProgress) {
  const std::vector<Spiral> spirals = random_spirals(408, 2);
  std::vector<std::size_t> done;
  Build_options options;
  options.progress = [&](std::size_t i, std::size_t n) {
    EXPECT_EQ(n, spirals.size());
    done.push_back(i);
  };
  const Bca_tree tree(spirals, 1e-3, options);
  ASSERT_EQ(done.size(), spirals.size());
  for (std::size_t i = 0; i < done.size(); ++i) EXPECT_EQ(done[i], i + 1);
}

// The involute of the unit circle: curvature 1/t falls monotonically, in closed form.
struct Involute {
  [[nodiscard]] End_jet_2<double> jet(double t) const {
    const double c = std::cos(t), s = std::sin(t);
    return {{c + t * s, s - t * c}, {t * c, t * s}, {c - t * s, s + t * c}};
  }
};

template <class Traits> void expect_involute_tiled(double eps) {
  using Own = Jet_spiral_2<Involute>;
  // monotone in x and y within a quadrant
  const std::vector<Own> spirals{Own({}, 0.5, 1.5, 1e-15), Own({}, 1.6, 3.1, 1e-15)};
  const Region_hierarchy_2<Traits, Own> tree(spirals, eps);
  EXPECT_EQ(tree.status(), Build_status::COMPLETE);
  EXPECT_LE(tree.bound(), eps);
  EXPECT_GT(tree.number_of_leaves(), 2u);
  tree.for_each_leaf([&](const Node_handle& h) {
    const Region_node n = tree.node(h);
    const auto region = tree.traits().construct_region_boundary_2_object()(tree.region(n));
    const Point middle = Involute().jet(n.t0 + (n.t1 - n.t0) / 2).point;
    EXPECT_EQ(bounded_side(region, middle), CGAL::ON_BOUNDED_SIDE) << n.t0 << ", " << n.t1;
  });
}

TEST(JetSpiral, IsBoundedByEveryRegion) {
  for (const double eps : {1e-2, 1e-4, 1e-7}) {
    expect_involute_tiled<Bca_traits_2<Kernel>>(eps);
    expect_involute_tiled<Spiral_fat_arc_traits_2<Kernel>>(eps);
    expect_involute_tiled<Bilens_traits_2<Kernel>>(eps);
  }
}

// The parabola (u, u^2), all of it within 64 spacings of parameters: u = 2^46 (t - 1).
struct Hasty_parabola {
  [[nodiscard]] End_jet_2<double> jet(double t) const {
    const double u = 0x1p46 * (t - 1);
    return {{u, u * u}, {1, 2 * u}, {0, 2}};
  }
};

TEST(JetSpiral, IsHalvedAsFarAsParametersGo) {
  using Own = Jet_spiral_2<Hasty_parabola>;
  const Own spiral({}, 1, 1 + 0x1p-46, 1e-15);
  constexpr int LEVELS = 4;  // of 64 spacings: the least pieces have four of them
  for (const Build_options::Nodes kind : {Build_options::Nodes::STORED, Build_options::Nodes::LAZY}) {
    const Region_hierarchy_2<Bca_traits_2<Kernel>, Own> tree({spiral}, 1e-9, nodes_of_kind(kind));
    std::size_t leaves = 0;
    double largest = 0;
    tree.for_each_leaf([&](const Node_handle& h) {
      ++leaves;
      largest = std::max(largest, tree.thickness(h));
    });
    EXPECT_EQ(leaves, std::size_t(1) << LEVELS);
    EXPECT_GT(largest, 1e-9);
    if (kind == Build_options::Nodes::LAZY) continue;  // what its leaves reach is not known before
    EXPECT_EQ(tree.status(), Build_status::RESOLUTION_REACHED);
    EXPECT_GE(tree.bound(), largest);
  }
}

}  // namespace
}  // namespace test_tree_limits
