// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Trees with and without the filter have the same nodes: on all curves that it serves and some that it does not, in all
// kernels, halved and equalised.

#include "trees.h"

#include <CGAL/Bounding_arcs_2.h>

#include <CGAL/Cartesian.h>

#include <gtest/gtest.h>

#include <random>
#include <string>
#include <utility>
#include <vector>

namespace test_without_filter {
namespace {

using namespace bounding_arcs_test;
using CGAL::Bounding_arcs::Build_options;
using CGAL::Bounding_arcs::Node_handle;
using Exact_kernel = Circular<CGAL::Cartesian<CGAL::Exact_rational>>;

struct Curves {
  std::string name;
  std::vector<Spiral> spirals;
};

std::vector<Curves> curves() {
  std::mt19937 random(440);
  std::vector<Curves> all;
  for (const auto& [name, degree, is_rational] :
       {std::tuple("quadratics", 2, false), std::tuple("cubics", 3, false), std::tuple("quartics", 4, false),
        std::tuple("quintics", 5, false), std::tuple("degree 6", 6, false), std::tuple("degree 9", 9, false),
        std::tuple("degree 10", 10, false), std::tuple("rational quadratics", 2, true),
        std::tuple("rational cubics", 3, true), std::tuple("rational quartics", 4, true),
        std::tuple("rational, degree 6", 6, true)}) {
    Curves c{name, {}};
    while (c.spirals.size() < 12)
      for (const Spiral& s : ba::spiral_segments(random_curve(random, degree, is_rational))) c.spirals.push_back(s);
    all.push_back(std::move(c));
  }
  return all;
}

template <class Traits> using Regions = ba::Region_hierarchy_2<Traits, Spiral>;

template <class Traits>
std::vector<std::pair<double, bool>> nodes(const Curves& c, double eps, const Build_options& o) {
  const Regions<Traits> tree(c.spirals, eps, o);
  EXPECT_EQ(tree.status(), ba::Build_status::COMPLETE) << c.name;
  EXPECT_LE(tree.bound(), eps);
  std::vector<std::pair<double, bool>> nodes;
  tree.traverse([&](const Node_handle& h) {
    if (h.is_region) nodes.emplace_back(tree.node(h).t1, h.is_leaf);
    return true;
  });
  return nodes;
}

template <class Traits> void expect_same_nodes(const std::vector<double>& tolerances) {
  std::size_t by_filter = 0;
  for (const Curves& c : curves())
    for (const double eps : tolerances)
      for (const Build_options::Nodes kind : {Build_options::Nodes::STORED, Build_options::Nodes::EQUALIZED}) {
        Build_options with = nodes_of_kind(kind), without = with, plain = with;
        without.instruction_set = ba::Build_options::Instruction_set::NONE;
        plain.is_filtered = false;
        const auto filtered = nodes<Traits>(c, eps, with);
        EXPECT_EQ(filtered, nodes<Traits>(c, eps, plain)) << c.name << ", eps " << eps;
        EXPECT_EQ(filtered, nodes<Traits>(c, eps, without)) << c.name << ", eps " << eps;
        by_filter += Regions<Traits>(c.spirals, eps, with).decisions().batch;
        EXPECT_EQ(Regions<Traits>(c.spirals, eps, without).decisions().batch, 0u);
        EXPECT_EQ(Regions<Traits>(c.spirals, eps, plain).decisions().batch, 0u);
      }
#ifdef BOUNDING_ARCS_WITHOUT_FILTER
  EXPECT_EQ(by_filter, 0u);
#else
  EXPECT_GT(by_filter, 500u);
#endif
}

template <class Traits> class Without_filter : public testing::Test {};
TYPED_TEST_SUITE(Without_filter, All_traits);

TYPED_TEST(Without_filter, NodesAreTheSame) { expect_same_nodes<TypeParam>({1e-2, 1e-4, 1e-6, 1e-8}); }

TEST(WithoutFilter, NodesOfExactKernelsAreTheSame) {
  expect_same_nodes<ba::Bca_traits_2<Exact_kernel>>({1e-2, 1e-4});
  expect_same_nodes<ba::Spiral_fat_arc_traits_2<Exact_kernel>>({1e-2});
}

}  // namespace
}  // namespace test_without_filter
