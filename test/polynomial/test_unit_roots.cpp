// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Exact roots in [0,1] of polynomials whose factors are known.

#include "cases.h"

#include "../../src/library/polynomial/Integer_polynomial.h"
#include "../../src/library/polynomial/Real_root.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>
#include <vector>

namespace {

namespace ba = CGAL::Bounding_arcs;
using ba::Integer;

struct Rational_root {
  int numerator, denominator, multiplicity;
  [[nodiscard]] CGAL::Exact_rational value() const { return CGAL::Exact_rational(numerator) / denominator; }
};

// Roots at and between the ends, and outside; those with k factors are there k times.
ba::Univariate random_polynomial(std::mt19937& random, std::vector<Rational_root>& roots) {
  const auto below = [&random](int n) { return static_cast<int>(random() % static_cast<unsigned>(n)); };
  ba::Univariate p(Integer(1 + below(5)));
  const std::vector<Rational_root> places{{0, 1, 0}, {1, 1, 0}, {1, 2, 0}, {1, 3, 0}, {5, 7, 0}, {-1, 2, 0}, {4, 3, 0}};
  for (Rational_root r : places) {
    constexpr int MOST = 3;
    r.multiplicity = (std::max)(0, below(2 * MOST) - MOST + 1);
    for (int i = 0; i < r.multiplicity; ++i)
      p = p * ba::polynomial<Integer>({Integer(-r.numerator), Integer(r.denominator)});
    if (r.multiplicity > 0 && 0 <= r.numerator && r.numerator <= r.denominator) roots.push_back(r);
  }
  // without real roots
  for (int i = below(3); i > 0; --i) p = p * ba::polynomial<Integer>({Integer(1 + below(9)), Integer(-1), Integer(1)});
  std::sort(roots.begin(), roots.end(), [](const auto& q, const auto& r) { return q.value() < r.value(); });
  return p;
}

void expect_roots(const ba::Univariate& p, const std::vector<Rational_root>& expected) {
  const std::vector<ba::Real_root> found = ba::unit_roots(p);
  ASSERT_EQ(found.size(), expected.size()) << p;
  for (std::size_t i = 0; i < found.size(); ++i) {
    EXPECT_LE(found[i].lower(), expected[i].value()) << p;
    EXPECT_GE(found[i].upper(), expected[i].value()) << p;
  }
}

}  // namespace

TEST(UnitRoots, AreThoseOfTheFactorsEachWithItsMultiplicity) {
  std::mt19937 random(1);
  for (int i = 0; i < bounding_arcs_test::cases(2000); ++i) {
    std::vector<Rational_root> roots, simple, multiple;
    const ba::Univariate p = random_polynomial(random, roots);
    for (const Rational_root& r : roots) (r.multiplicity == 1 ? simple : multiple).push_back(r);
    expect_roots(p, roots);
    const ba::Root_multiplicities m = ba::unit_root_multiplicities(p);
    expect_roots(m.simple, simple);
    expect_roots(m.multiple, multiple);
  }
}

TEST(UnitRoots, ShareADivisorWhereBothAreZero) {
  std::mt19937 random(2);
  const ba::Univariate at_one = ba::polynomial<Integer>({Integer(-1), Integer(1)}),
                       at_half = ba::polynomial<Integer>({Integer(-1), Integer(2)});
  for (int i = 0; i < bounding_arcs_test::cases(200); ++i) {
    std::vector<Rational_root> roots;
    const ba::Univariate p = random_polynomial(random, roots);
    for (const ba::Univariate& factor : {at_one, at_half, at_one * at_half}) {
      const int shared = ba::common_divisor(factor, p).degree();
      const auto is_shared = [&](const Rational_root& r) { return factor.sign_at(r.value()) == CGAL::ZERO; };
      EXPECT_EQ(shared, std::count_if(roots.begin(), roots.end(), is_shared)) << p;
    }
  }
}
