// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Kernels with exact decisions split alike: filtered ones over doubles, rationals, and expressions with square roots.

#include "trees.h"

#include <CGAL/Bounding_arcs_2.h>

#include <CGAL/CORE_Expr.h>
#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Simple_cartesian.h>

#include <gtest/gtest.h>

namespace test_tree_kernels {
namespace {

using namespace CGAL::Bounding_arcs;
using namespace bounding_arcs_test;
using Rational = Circular<CGAL::Simple_cartesian<Exact>>;
using Lazy = Circular<CGAL::Exact_predicates_exact_constructions_kernel>;
using Roots = Circular<CGAL::Simple_cartesian<CORE::Expr>>;

using Splits = std::vector<std::pair<double, double>>;

// The parameters of all nodes, which say where every split was made.
template <class Traits, class NT = typename Traits::FT> Splits splits(const Bezier& curve, double eps) {
  const Region_hierarchy_2<Traits, Bezier_spiral_2<NT>> tree(spiral_segments(curve.over<NT>()), eps);
  EXPECT_LE(tree.bound(), eps);
  Splits parameters;
  tree.traverse([&](const auto& h) {
    if (h.is_region) parameters.emplace_back(tree.node(h).t0, tree.node(h).t1);
    return true;
  });
  return parameters;
}

constexpr unsigned SEED = 501;

template <class Check> void for_random_curves(Check check) {
  std::mt19937 random(SEED);
  for (const auto& [degree, is_rational] :
       {std::pair(2, false), std::pair(3, false), std::pair(2, true), std::pair(5, false)}) {
    const Bezier curve = random_curve(random, degree, is_rational);
    for (const double eps : {1e-3, 1e-6}) {
      SCOPED_TRACE("seed 501, degree " + std::to_string(degree) + ", eps " + std::to_string(eps));
      check(curve, eps);
    }
  }
}

TEST(BcaTreeOverKernels, SplitsAlikeWhereverDecisionsAreExact) {
  for_random_curves([](const Bezier& curve, double eps) {
    const Splits exact = splits<Bca_traits_2<Rational>>(curve, eps);
    EXPECT_EQ((splits<Bca_traits_2<Filtered>, double>(curve, eps)), exact);
    EXPECT_EQ((splits<Bca_traits_2<Filtered>, Exact>(curve, eps)), exact);
    EXPECT_EQ(splits<Bca_traits_2<Lazy>>(curve, eps), exact);
  });
}

TEST(SpiralFatArcTreeOverKernels, SplitsAlikeWhereverDecisionsAreExact) {
  for_random_curves([](const Bezier& curve, double eps) {
    const Splits exact = splits<Spiral_fat_arc_traits_2<Roots>>(curve, eps);
    EXPECT_EQ((splits<Spiral_fat_arc_traits_2<Filtered>, double>(curve, eps)), exact);
    EXPECT_EQ((splits<Spiral_fat_arc_traits_2<Filtered>, Exact>(curve, eps)), exact);
    EXPECT_EQ(splits<Spiral_fat_arc_traits_2<Rational>>(curve, eps), exact);
  });
}

TEST(BilensTreeOverKernels, SplitsAlikeWhereverDecisionsAreExact) {
  for_random_curves([](const Bezier& curve, double eps) {
    const Splits exact = splits<Bilens_traits_2<Roots>>(curve, eps);
    EXPECT_EQ((splits<Bilens_traits_2<Filtered>, double>(curve, eps)), exact);
    EXPECT_EQ((splits<Bilens_traits_2<Filtered>, Exact>(curve, eps)), exact);
  });
}

// The thickness lies between two neighbouring doubles, and the tolerance is either of them.
TEST(TreeOverKernels, TellsTheThicknessFromTheNearestTolerances) {
  const Bezier parabola({{0, 0}, {0.5, 0}, {1, 1}});
  const auto thickness = [&] {
    const auto spiral = spiral_segments(parabola.over<CORE::Expr>()).front();
    return Bca::thickness(spiral.shape<CORE::Expr>(0, 1));
  }();
  const double below = CGAL::to_interval(thickness).first, above = CGAL::to_interval(thickness).second;
  ASSERT_LT(below, above);
  for (double eps = std::nextafter(below, 0.0); eps <= std::nextafter(above, 1.0); eps = std::nextafter(eps, 1.0)) {
    const bool is_whole = !(CORE::Expr(eps) < thickness);
    EXPECT_EQ((splits<Bca_traits_2<Filtered>, double>(parabola, eps).size() == 1), is_whole);
    EXPECT_EQ(splits<Bca_traits_2<Rational>>(parabola, eps).size() == 1, is_whole);
  }
}

}  // namespace
}  // namespace test_tree_kernels
