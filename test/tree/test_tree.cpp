// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The hierarchy: leaves that tile every spiral within the tolerance, the order and shape of nodes, traversal, boxes.

#include "cases.h"
#include "trees.h"

#include <CGAL/Bounding_arcs_2.h>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Simple_cartesian.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <set>
#include <stdexcept>
#include <tuple>
#include <utility>
#include <vector>

namespace test_tree {
namespace {

using namespace CGAL::Bounding_arcs;
using namespace bounding_arcs_test;

template <class Traits> class Tree : public testing::Test {};
TYPED_TEST_SUITE(Tree, All_traits);

// Of curves of degree 2 to 5, which the filter serves, and of rational ones of higher degree, which it does not.
std::vector<Spiral> served_and_other_spirals(unsigned seed, int curves) {
  std::mt19937 random(seed);
  std::vector<Spiral> spirals;
  for (int i = 0; i < curves; i += FEW_CASES ? 2 : 1)
    for (const Bezier& curve : {random_curve(random, 2 + i % 4, false), random_curve(random, 2 + i % 4, true),
                                random_curve(random, 6 + i % 4, true)})
      for (const Spiral& s : ba::spiral_segments(curve)) spirals.push_back(s);
  return spirals;
}

TYPED_TEST(Tree, HasLeavesThatTileEverySpiralWithinTheTolerance) {
  const std::vector<Spiral> spirals = served_and_other_spirals(401, 4);
  std::size_t served = 0;
  for (const Spiral& s : spirals) served += s.local_curve().kind() > 0;
  ASSERT_TRUE(served > 3 && served + 3 < spirals.size());
  for (const double eps : {1e-1, 1e-2, 1e-3, 1e-5, 1e-7, 1e-11}) {
    if (FEW_CASES && eps < 1e-5) break;
    SCOPED_TRACE("seed 401, -log10 of eps " + std::to_string(-std::log10(eps)));
    const Region_hierarchy_2<TypeParam, Spiral> tree(spirals, eps);
    EXPECT_EQ(tree.status(), Build_status::COMPLETE);
    std::size_t leaves = 0, spiral = 0;
    double reached = spirals.front().first(), largest = 0;
    const bool is_fine = eps < 1e-7;  // leaves are many then: some are looked at
    tree.for_each_leaf([&](const Node_handle& h) {
      const Region_node n = tree.node(h);
      EXPECT_TRUE(n.is_leaf && h.is_leaf);
      if (n.spiral != spiral) {
        EXPECT_EQ(reached, spirals[spiral].last());
        EXPECT_EQ(n.spiral, ++spiral);
        reached = spirals[spiral].first();
      }
      EXPECT_EQ(n.t0, reached);
      EXPECT_LT(n.t0, n.t1);
      reached = n.t1;
      if (++leaves % (is_fine ? 50 : 1) != 0) return;
      largest = std::max(largest, tree.thickness(h));
      // the former is rounded, the latter rounded up
      EXPECT_LE(tree.traits().compute_thickness_2_object()(tree.region(n)), tree.thickness(h) * (1 + 0x1p-40));
    });
    EXPECT_EQ(spiral + 1, spirals.size());
    EXPECT_EQ(reached, spirals.back().last());
    EXPECT_EQ(leaves, tree.number_of_leaves());
    EXPECT_EQ(tree.number_of_nodes(), 2 * leaves - spirals.size());
    EXPECT_EQ(tree.number_of_arcs(), leaves * TypeParam::Construction::ARCS_PER_REGION);
    EXPECT_LE(largest, tree.bound());
    EXPECT_LE(tree.bound(), eps);
    if (!is_fine) {
      EXPECT_GE(largest, 0.95 * tree.bound());  // a few per cent
    }
  }
}

// A leaf that is just as thick as eps, which no bound ahead of time can tell, is in the tree's bound like any other,
// and so are some that floats decide.
TYPED_TEST(Tree, HasABoundThatIsReached) {
  constexpr int PIECES = 16;
  for (const Spiral& spiral : served_and_other_spirals(412, 4)) {
    double eps = 0;
    for (int i = 0; i < PIECES; ++i) {
      const double step = (spiral.last() - spiral.first()) / PIECES;
      const Spiral_source piece{spiral, spiral.first() + i * step, spiral.first() + (i + 1) * step};
      eps = std::max(eps, TypeParam().bound_thickness_2_object()(piece, 1).upper);
    }
    if (eps == 0) continue;
    for (const double tolerance : {eps, 1.125 * eps, 1.5 * eps}) {
      const Region_hierarchy_2<TypeParam, Spiral> tree({spiral}, tolerance);
      double largest = 0;
      tree.for_each_leaf([&](const Node_handle& h) { largest = std::max(largest, tree.thickness(h)); });
      EXPECT_GE(tree.bound(), largest);
    }
  }
}

// Held against the thickness in exact arithmetic, not against what the tree tells of itself.
TYPED_TEST(Tree, SplitsWhatIsTooThickAndNothingElse) {
  const auto& construction = typename TypeParam::Construction();
  for (const double eps : {1e-2, 1e-4, 1e-6}) {
    const Region_hierarchy_2<TypeParam, Spiral> tree(served_and_other_spirals(402, 4), eps);
    std::size_t leaves = 0, inner = 0;
    tree.traverse([&](const auto& h) {
      if (!h.is_region) return true;
      const Region_node n = tree.node(h);
      const Spiral_source piece{tree.spirals()[n.spiral], n.t0, n.t1};
      EXPECT_EQ(h.is_leaf, (bound_thickness<double, true>(construction, piece, eps).within)) << n.t0 << ' ' << n.t1;
      ++(h.is_leaf ? leaves : inner);
      return true;
    });
    EXPECT_EQ(leaves, tree.number_of_leaves());
    EXPECT_EQ(leaves + inner, tree.number_of_nodes());
    EXPECT_GT(leaves, tree.spirals().size());
  }
}

TYPED_TEST(Tree, IsTheSameWhetherThicknessIsKeptOrNot) {
  for (const double eps : {1e-2, 1e-4, 1e-6}) {
    const std::vector<Spiral> spirals = served_and_other_spirals(403, 4);
    Build_options options;
    options.keep_thickness = true;
    const Region_hierarchy_2<TypeParam, Spiral> kept(spirals, eps, options), made(spirals, eps);
    ASSERT_EQ(kept.number_of_nodes(), made.number_of_nodes());
    EXPECT_GE(kept.bytes(), made.bytes() + kept.number_of_nodes() * sizeof(double));
    std::vector<std::pair<Region_node, double>> nodes;
    kept.traverse([&](const auto& h) {
      if (h.is_region) nodes.emplace_back(kept.node(h), kept.thickness(h));
      return true;
    });
    std::size_t i = 0;
    made.traverse([&](const auto& h) {
      if (!h.is_region) return true;
      const Region_node n = made.node(h);
      const auto& [k, thickness] = nodes[i++];
      EXPECT_TRUE(n.t0 == k.t0 && n.t1 == k.t1 && n.spiral == k.spiral && n.is_leaf == k.is_leaf);
      // a batch's bound is above the sharp one, by its rounding of 2^-29, up to 2^5 times that for wide pieces
      EXPECT_LE(made.thickness(h), thickness);
      EXPECT_LE(thickness, made.thickness(h) * (1 + 0x1p-24));
      return true;
    });
    EXPECT_EQ(i, nodes.size());
  }
}

TEST(BcaTree, HalvesWhatItSplits) {
  const Bca_tree tree(random_spirals(403, 5), 1e-6);
  tree.traverse([&](const auto& h) {
    if (!h.is_region || tree.is_leaf(h)) return true;
    std::vector<Region_node> children;
    tree.for_each_child(h, [&](const auto& child) { children.push_back(tree.node(child)); });
    const Region_node n = tree.node(h);
    EXPECT_EQ(children.size(), 2u);
    EXPECT_EQ(children[0].t0, n.t0);
    EXPECT_EQ(children[0].t1, children[1].t0);
    EXPECT_EQ(children[1].t1, n.t1);
    EXPECT_NEAR(children[0].t1, (n.t0 + n.t1) / 2, 1e-15);
    EXPECT_TRUE(children[0].spiral == n.spiral && children[1].spiral == n.spiral);
    return true;
  });
}

TEST(BcaTree, IsTraversedWholeAndPruned) {
  for (const int curves : {1, 2, 7}) {
    const Bca_tree tree(random_spirals(404, curves), 1e-4);
    std::vector<std::pair<std::uint32_t, double>> leaves, visited;
    std::set<std::size_t> regions;
    std::size_t boxes = 0;
    tree.for_each_leaf([&](const Node_handle& h) {
      const Region_node n = tree.node(h);
      leaves.emplace_back(n.spiral, n.t0);
    });
    tree.traverse([&](const auto& h) {
      if (tree.is_leaf(h)) visited.emplace_back(tree.node(h).spiral, tree.node(h).t0);
      if (h.is_region) EXPECT_TRUE(regions.insert(h.index).second);
      else ++boxes;
      return true;
    });
    EXPECT_TRUE(std::is_sorted(leaves.begin(), leaves.end()));
    for (std::size_t i = 1; i < visited.size(); ++i)  // of a segment in curve order, segments in that of the boxes
      EXPECT_TRUE(visited[i - 1].first != visited[i].first || visited[i - 1].second < visited[i].second);
    std::sort(visited.begin(), visited.end());
    EXPECT_EQ(visited, leaves);
    EXPECT_EQ(regions.size(), tree.number_of_nodes());
    EXPECT_EQ(boxes, tree.number_of_boxes());

    std::size_t roots = 0;
    tree.traverse([&](const auto& h) {
      roots += h.is_region;
      return !h.is_region;
    });
    EXPECT_EQ(roots, tree.spirals().size());
    int once = 0;
    tree.traverse([&](const auto&) { return ++once < 0; });
    EXPECT_EQ(once, 1);
  }
}

TEST(BcaTree, HasBoxesThatHoldTheCurveBelow) {
  const Bca_tree tree(random_spirals(405, 4), 1e-3);
  std::vector<CGAL::Bbox_2> path;
  const std::function<void(const Bca_tree::Handle&)> descend = [&](const Bca_tree::Handle& h) {
    path.push_back(tree.box(h));
    if (h.is_region) {
      const Region_node n = tree.node(h);
      for (int i = 0; i <= 8; ++i) {
        const double t = n.t0 + (n.t1 - n.t0) * i / 8;
        const Xy<Exact> q = tree.spirals()[n.spiral].exact_curve().point(Exact(t));
        for (const CGAL::Bbox_2& b : path)
          EXPECT_TRUE(Exact(b.xmin()) <= q.x && q.x <= Exact(b.xmax()) && Exact(b.ymin()) <= q.y &&
                      q.y <= Exact(b.ymax()))
              << "seed 405, spiral " << n.spiral << ", t " << t;
      }
    }
    tree.for_each_child(h, descend);
    path.pop_back();
  };
  descend(tree.root());
}

struct Parabola {
  [[nodiscard]] End_jet_2<double> jet(double t) const { return {{t, t * t}, {1, 2 * t}, {0, 2}}; }
};

// Points that err by far less than an ulp, which added to them changes nothing.
TEST(BcaTree, HasBoxesThatHoldWhatPointsErrBy) {
  using Own = Jet_spiral_2<Parabola>;
  const Own spiral({}, 0.25, 1, 1e-20);
  const Region_hierarchy_2<Bca_traits_2<Kernel>, Own> tree({spiral}, 1);
  const CGAL::Bbox_2 box = tree.box(tree.root());
  const Exact error(spiral.point_error());
  EXPECT_TRUE(Exact(box.xmin()) <= Exact(0.25) - error && Exact(box.xmax()) >= 1 + error) << box;
  EXPECT_TRUE(Exact(box.ymin()) <= Exact(0.0625) - error && Exact(box.ymax()) >= 1 + error) << box;
  EXPECT_LE(box.xmax(), 1 + 1e-15);
}

template <class Tree> std::vector<std::tuple<double, double, double, std::uint32_t, bool>> nodes_of(const Tree& tree) {
  std::vector<std::tuple<double, double, double, std::uint32_t, bool>> nodes;
  tree.traverse([&](const auto& h) {
    if (!h.is_region) return true;
    const Region_node n = tree.node(h);
    EXPECT_EQ(n.is_leaf, tree.is_leaf(h));
    nodes.emplace_back(n.t0, n.t1, tree.thickness(h), n.spiral, n.is_leaf);
    return true;
  });
  return nodes;
}

TYPED_TEST(Tree, IsTheSameWhenItIsLazy) {
  for (const double eps : {1e-1, 1e-3, 1e-6}) {
    const std::vector<Spiral> spirals = served_and_other_spirals(409, 4);
    const Region_hierarchy_2<TypeParam, Spiral> eager(spirals, eps);
    const Region_hierarchy_2<TypeParam, Spiral> lazy(spirals, eps, nodes_of_kind(Build_options::Nodes::LAZY));
    EXPECT_EQ(nodes_of(lazy), nodes_of(eager));
    EXPECT_EQ(lazy.number_of_boxes(), eager.number_of_boxes());
  }
}

#ifdef CGAL_LINKED_WITH_TBB
TYPED_TEST(Tree, IsTheSameWhenItIsBuiltInParallel) {
  const std::vector<Spiral> spirals = random_spirals(410, 300);
  ASSERT_GT(spirals.size(), 1100u);  // many tasks, and enough for one to foresee the number of nodes
  const double eps = FEW_CASES ? 1e-2 : 1e-4;
  for (const bool keep : {false, true}) {
    if (FEW_CASES && keep) break;
    Build_options options;
    options.keep_thickness = keep;
    std::size_t told = 0;
    options.progress = [&](std::size_t done, std::size_t all) {
      EXPECT_EQ(done, ++told);
      EXPECT_EQ(all, spirals.size());
    };
    const Region_hierarchy_2<TypeParam, Spiral> parallel(spirals, eps, options, {}, CGAL::Parallel_tag());
    EXPECT_EQ(told, spirals.size());
    options.progress = {};
    const Region_hierarchy_2<TypeParam, Spiral> sequential(spirals, eps, options);
    EXPECT_EQ(nodes_of(parallel), nodes_of(sequential));
    EXPECT_EQ(parallel.bound(), sequential.bound());
  }
}
#endif

TYPED_TEST(Tree, IsTheSameAfterSegmentsWereReplaced) {
  const std::vector<Spiral> all = random_spirals(411, 12);
  const auto part = [&](std::size_t first, std::size_t last) {
    return std::vector<Spiral>(all.begin() + static_cast<std::ptrdiff_t>(first),
                               all.begin() + static_cast<std::ptrdiff_t>(last));
  };
  const std::size_t n = all.size();
  ASSERT_GT(n, 20u);
  for (const auto& [first, last, from, to] :
       {std::tuple(std::size_t(3), std::size_t(5), n - 6, n), std::tuple(std::size_t(0), std::size_t(10), n - 1, n),
        std::tuple(std::size_t(9), std::size_t(10), n - 5, n - 5), std::tuple(std::size_t(0), std::size_t(9), n, n),
        std::tuple(std::size_t(4), std::size_t(4), n - 3, n)}) {
    for (const auto& [nodes, keep] :
         {std::pair(Build_options::Nodes::STORED, false), std::pair(Build_options::Nodes::STORED, true),
          std::pair(Build_options::Nodes::EQUALIZED, false)}) {
      Build_options options;
      options.nodes = nodes;
      options.keep_thickness = keep;
      Region_hierarchy_2<TypeParam, Spiral> tree(part(0, 10), 1e-5, options);
      tree.replace(first, last, part(from, to));
      std::vector<Spiral> expected = part(0, first);
      for (const Spiral& s : part(from, to)) expected.push_back(s);
      for (const Spiral& s : part(last, 10)) expected.push_back(s);
      const Region_hierarchy_2<TypeParam, Spiral> whole(expected, 1e-5, options);
      EXPECT_EQ(nodes_of(tree), nodes_of(whole));
      EXPECT_EQ(tree.bound(), whole.bound());
      EXPECT_EQ(tree.number_of_boxes(), whole.number_of_boxes());
    }
  }
}

// Nothing of the tree is changed until all of what it is changed to is there.
TYPED_TEST(Tree, IsAsItWasAfterAReplacementThatThrows) {
  const std::vector<Spiral> spirals = random_spirals(411, 12);
  const std::size_t n = spirals.size();
  for (const Build_options::Nodes nodes :
       {Build_options::Nodes::STORED, Build_options::Nodes::EQUALIZED, Build_options::Nodes::LAZY}) {
    Build_options options;
    options.nodes = nodes;
    Region_hierarchy_2<TypeParam, Spiral> tree(spirals, 1e-3, options);
    const auto expected = nodes_of(tree);
    EXPECT_THROW(tree.replace(3, n + 1, {}), std::out_of_range);
    EXPECT_THROW(tree.replace(4, 3, spirals), std::out_of_range);
    EXPECT_THROW(tree.replace(n + 1, n + 1, spirals), std::out_of_range);
    EXPECT_EQ(tree.spirals().size(), n);
    EXPECT_EQ(nodes_of(tree), expected);
  }
}

}  // namespace
}  // namespace test_tree
