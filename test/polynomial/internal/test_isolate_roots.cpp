// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Roots of polynomials on [0,1] and the numbers that find them: the Bernstein basis, double-double error bounds, sign
// variations, multiple and neighbouring roots.

#include "../support/Sturm.h"
#include "cases.h"
#include "isolate_roots.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <random>
#include <vector>

namespace test_isolate_roots {
namespace {

using namespace CGAL::Bounding_arcs;
using namespace bounding_arcs_test;
using Doubles = internal::Short_list<double>;

// The product of the linear polynomials t - root, in the Bernstein basis.
Bernstein_polynomial<Rational> with_roots(const std::vector<Rational>& roots) {
  Bernstein_polynomial<Rational> p(std::vector<Rational>{1});
  for (const Rational& r : roots) p = p * Bernstein_polynomial<Rational>({Rational(-r), Rational(1 - r)});
  return p;
}

TEST(BernsteinPolynomial, HalvesRestrictionAndDerivativeAgreeWithValues) {
  const Bernstein_polynomial<Rational> p({1, -3, 2, 7}), d = p.derivative();
  const Rational third = Rational(1) / 3;
  const auto [left, right] = p.halves();
  EXPECT_EQ(left(third), p(third / 2));
  EXPECT_EQ(right(third), p((1 + third) / 2));
  EXPECT_EQ(p.restricted(third, 1 - third, 1, 0)(third), p(third + (1 - third) * third));
  EXPECT_EQ((p.elevated(6) - p)(third), 0);
  EXPECT_EQ(p.coefficient(2), 2);
  EXPECT_EQ(d(third), value(derived(from_bernstein({1, -3, 2, 7})), third));
}

TEST(DoubleDouble, ErrorBoundHoldsUnderCancellationAndUnderflow) {
  std::mt19937 engine(3);
  std::uniform_real_distribution<double> mantissa(-1, 1);
  for (int round = 0; round < cases(300); ++round) {
    const int exponent = round % 10 == 0 ? -520 : -round % 7;
    Double_double x(1.0 / 3);
    Rational exact(1.0 / 3);
    for (int step = 0; step < 12; ++step) {
      const double a = std::ldexp(mantissa(engine), exponent), b = mantissa(engine);
      x = (x * Double_double(a) + Double_double(b)) * x - Double_double(b) * x;
      exact = (exact * Rational(a) + Rational(b)) * exact - Rational(b) * exact;
      const Rational error = exact - Rational(x.hi) - Rational(x.lo);
      ASSERT_LE(CGAL::abs(error), Rational(x.err)) << "round " << round << " step " << step;
      const int sign = static_cast<int>(CGAL::sign(exact));
      ASSERT_EQ(x.sign().value_or(sign), sign);
    }
  }
}

TEST(SignVariations, BoundsCountEveryChoiceOfUnknownSigns) {
  const auto bounds = [](const std::vector<int>& signs) {
    internal::Sign_variations v;
    for (const int s : signs) v.append(s);
    return std::array<int, 3>{v.fewest, v.most(), v.first};
  };
  EXPECT_EQ(bounds({1, 0, -1}), (std::array<int, 3>{1, 1, 1}));
  EXPECT_EQ(bounds({-1, 0, -1}), (std::array<int, 3>{0, 2, -1}));
  EXPECT_EQ(bounds({0, 1}), (std::array<int, 3>{0, 1, 1}));
  EXPECT_EQ(bounds({0, 0, 0}), (std::array<int, 3>{0, 2, 0}));
  EXPECT_EQ(bounds({1, -1, 0, 0, -1}), (std::array<int, 3>{1, 3, 1}));
  EXPECT_EQ(bounds({}), (std::array<int, 3>{0, 0, 0}));
}

TEST(IsolateRoots, CountsMultipleRootsOnceAndRoundsThem) {
  const Rational third = Rational(1) / 3, fifth = Rational(1) / 5;
  EXPECT_EQ(isolate_roots(with_roots({third, third})).roots, Doubles({1.0 / 3}));
  EXPECT_EQ(isolate_roots(with_roots({third, third, third, fifth})).roots, Doubles({0.2, 1.0 / 3}));
  EXPECT_EQ(isolate_roots(with_roots({Rational(0.5), Rational(0.5), fifth, fifth})).roots, Doubles({0.2, 0.5}));
}

TEST(IsolateRoots, MergesOnlyRootsThatRoundAlike) {
  const Rational third = Rational(1) / 3, tiny = Rational(1e-20), small = Rational(1e-12);
  EXPECT_EQ(isolate_roots(with_roots({third, third + tiny})).roots, Doubles({1.0 / 3}));
  EXPECT_EQ(isolate_roots(with_roots({third, third + small})).roots.size(), 2u);
  const double next = std::nextafter(0.3, 1.0);
  EXPECT_EQ(isolate_roots(with_roots({Rational(0.3), Rational(next)})).roots, Doubles({0.3, next}));
}

TEST(IsolateRoots, RoundsRootsHalfWayBetweenDoublesToTheEvenOne) {
  const double a = 1 - 0x1p-2, b = std::nextafter(a, 1.0), c = std::nextafter(b, 1.0);
  const Rational ab = (Rational(a) + Rational(b)) / 2, bc = (Rational(b) + Rational(c)) / 2;
  EXPECT_EQ(isolate_roots(with_roots({ab})).roots, Doubles({a}));
  double low = a;
  for (int k = 0; k < 100; ++k) {
    const double high = std::nextafter(low, 1.0), even = k % 2 == 0 ? low : high;
    const Rational tie = (Rational(low) + Rational(high)) / 2;
    EXPECT_EQ(isolate_roots(with_roots({tie, Rational(0.1), Rational(1) / 7})).roots, Doubles({0.1, 1.0 / 7, even}));
    low = high;
  }
  EXPECT_EQ(isolate_roots(with_roots({ab, ab})).roots, Doubles({a}));
  EXPECT_EQ(isolate_roots(with_roots({bc, bc, Rational(0.25)})).roots, Doubles({0.25, c}));
}

TEST(IsolateRoots, TreatsRootsWithinRoundingOfTheEndsAsEnds) {
  const Rational inside(0x1p-50), near(0x1p-54);
  EXPECT_EQ(isolate_roots(with_roots({0, near, near, inside, 1 - inside, 1 - near, 1})).roots,
            Doubles({0x1p-50, 1 - 0x1p-50}));
  EXPECT_EQ(isolate_roots(with_roots({Rational(1e-30), Rational(0.5), 1 - Rational(1e-30)})).roots, Doubles({0.5}));
  EXPECT_EQ(isolate_roots(with_roots({Rational(1e-30), Rational(0x1p-52)})).roots, Doubles({0x1p-52}));
  EXPECT_EQ(isolate_roots(with_roots({Rational(1e-13), Rational(2e-13)})).roots, Doubles({1e-13, 2e-13}));
  EXPECT_TRUE(isolate_roots(Bernstein_polynomial<Rational>()).is_zero);
  EXPECT_FALSE(isolate_roots(with_roots({2})).is_zero);
}

}  // namespace
}  // namespace test_isolate_roots
