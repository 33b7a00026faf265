// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Over a kernel with square roots regions end in the exact points of the curve and arcs pass through them, whatever
// number type the spirals have.

#include "exact_ends.h"

#include <CGAL/CORE_Expr.h>
#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/Exact_predicates_exact_constructions_kernel_with_sqrt.h>

namespace test_exact_ends_roots {
namespace {

using namespace CGAL::Bounding_arcs;
using namespace bounding_arcs_test;
using Roots = Circular<CGAL::Exact_predicates_exact_constructions_kernel_with_sqrt>;
using Core = Circular<CGAL::Simple_cartesian<CORE::Expr>>;

template <class NT> class ExactEndsOverRoots : public testing::Test {};
using Numbers = testing::Types<float, double, long double, Exact, CGAL::Gmpq, CGAL::Epeck::FT, CORE::Expr>;
TYPED_TEST_SUITE(ExactEndsOverRoots, Numbers);

TYPED_TEST(ExactEndsOverRoots, LieOnTheArcsOfBca) { expect_exact_ends<Bca_traits_2<Roots>, TypeParam>(1e-2); }

TEST(ExactEnds, LieOnTheArcsOfBcaOverExpressions) { expect_exact_ends<Bca_traits_2<Core>, double>(1e-2); }

// Joints have nested roots, which takes expressions long to see to be on a circle: ends alone.
template <class Traits> void expect_exact_chain_ends() {
  const auto expect_chain_ends = [](const Traits& traits, const auto& region, const auto& from, const auto& to) {
    const auto boundary = traits.construct_region_boundary_2_object()(region);
    for (const auto* chain : {&boundary.inner, &boundary.outer}) {
      const auto &first = (*chain)[0], &last = (*chain)[chain->size() - 1];
      EXPECT_EQ(first.from, from);
      EXPECT_EQ(last.to, to);
      EXPECT_EQ(first.support.side(from), 0);
      EXPECT_EQ(last.support.side(to), 0);
    }
  };
  for_exact_leaves<Traits, double>(1e-1, expect_chain_ends);
}
TEST(ExactEnds, LieOnTheArcsOfSpiralFatArcs) { expect_exact_chain_ends<Spiral_fat_arc_traits_2<Roots>>(); }
TEST(ExactEnds, LieOnTheArcsOfBilens) { expect_exact_chain_ends<Bilens_traits_2<Roots>>(); }

}  // namespace
}  // namespace test_exact_ends_roots
