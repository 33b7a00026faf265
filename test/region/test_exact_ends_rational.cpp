// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Over rational kernels regions end in the exact points of the curve and arcs pass through them, whatever number type
// the spirals have.

#include "exact_ends.h"

#include <CGAL/Exact_predicates_exact_constructions_kernel.h>

#include <utility>

namespace test_exact_ends_rational {
namespace {

using namespace CGAL::Bounding_arcs;
using namespace bounding_arcs_test;
using Rational = Circular<CGAL::Simple_cartesian<Exact>>;
using Gmp = Circular<CGAL::Simple_cartesian<CGAL::Gmpq>>;
using Epeck = Circular<CGAL::Exact_predicates_exact_constructions_kernel>;

template <class NT> class ExactEndsOverRationals : public testing::Test {};
using Numbers = testing::Types<float, double, long double, Exact, CGAL::Gmpq, Epeck::FT>;
TYPED_TEST_SUITE(ExactEndsOverRationals, Numbers);

TYPED_TEST(ExactEndsOverRationals, LieOnTheArcsOfBca) { expect_exact_ends<Bca_traits_2<Rational>, TypeParam>(1e-3); }
// Over other rationals than the first, numbers of no kernel, of another and of its own.
TEST(ExactEnds, LieOnTheArcsOfBcaOverOtherRationals) {
  expect_exact_ends<Bca_traits_2<Gmp>, long double>(1e-3);
  expect_exact_ends<Bca_traits_2<Gmp>, Epeck::FT>(1e-3);
  expect_exact_ends<Bca_traits_2<Gmp>, CGAL::Gmpq>(1e-3);
  expect_exact_ends<Bca_traits_2<Epeck>, long double>(1e-3);
  expect_exact_ends<Bca_traits_2<Epeck>, CGAL::Gmpq>(1e-3);
  expect_exact_ends<Bca_traits_2<Epeck>, Epeck::FT>(1e-3);
}

TEST(ExactEnds, LieOnArcsOfTheKernel) {
  expect_exact_ends_in_kernel<Bca_traits_2<Epeck>, double>(1e-3);
  expect_exact_ends_in_kernel<Spiral_fat_arc_traits_2<Epeck>, double>(1e-1);
  expect_exact_ends_in_kernel<Spiral_fat_arc_traits_2<Rational>, double>(1e-1);
}

// A kernel of more digits than the spirals does not get their rounded ends.
TEST(FrameEnds, AreRoundedOnceToKernelsOfMoreDigits) {
  const auto exact = cubic<Exact>([](int n) { return exact_thirtieth<Exact, float>(n); }, false);
  for (const auto& s : spiral_segments(cubic<float>([](int n) { return thirtieth<float>(n); }, false))) {
    const auto frame = s.frame<double>(s.first(), s.last());
    for (const auto& [t, end] : {std::pair(s.first(), frame.p0), std::pair(s.last(), frame.p1)}) {
      const auto expected = exact.point(Exact(t));
      EXPECT_DOUBLE_EQ(end.x, CGAL::to_double(expected.x));
      EXPECT_DOUBLE_EQ(end.y, CGAL::to_double(expected.y));
    }
  }
}

// Shapes rounded from double-doubles: these must hold what long double has more than double.
TEST(FrameShapes, AreAccurateForCurvesOverLongDouble) {
  const auto curve = cubic<long double>([](int n) { return thirtieth<long double>(n); }, false);
  for (const auto& s : spiral_segments(curve)) {
    const auto shape = s.accurate_shape(s.first(), s.last());
    const auto exact = s.shape<Exact>(s.first(), s.last());
    EXPECT_DOUBLE_EQ(shape.chord.x, CGAL::to_double(exact.chord.x));
    EXPECT_DOUBLE_EQ(shape.cross_change, CGAL::to_double(exact.cross_change));
    EXPECT_DOUBLE_EQ(shape.kneser0, CGAL::to_double(exact.kneser0));
    EXPECT_DOUBLE_EQ(shape.kneser1, CGAL::to_double(exact.kneser1));
  }
}

}  // namespace
}  // namespace test_exact_ends_rational
