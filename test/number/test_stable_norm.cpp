// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The length of a vector, however long it is.

#include <CGAL/Bounding_arcs_2/number/stable_norm.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>

namespace {

using CGAL::Bounding_arcs::stable_norm;
using CGAL::Bounding_arcs::Xy;

TEST(StableNorm, IsWithinAnUlpForAllExponents) {
  std::mt19937_64 random(1);
  std::uniform_real_distribution<double> mantissa(1, 2);
  std::uniform_int_distribution<int> exponent(-1021, 1021), apart(-60, 60);
  for (int i = 0; i < 100000; ++i) {
    const int e = exponent(random);
    const Xy<double> v{std::ldexp(mantissa(random), e),
                       -std::ldexp(mantissa(random), std::clamp(e + apart(random), -1021, 1021))};
    // long double has room for the squares
    const long double x = v.x, y = v.y, exact = std::sqrt(x * x + y * y);
    ASSERT_LE(std::fabs(stable_norm(v) - exact), 0x1p-52L * exact) << v.x << ' ' << v.y;
  }
}

TEST(StableNorm, TakesTheLeastAndTheLargestNumbers) {
  constexpr double LEAST = std::numeric_limits<double>::denorm_min(), MOST = std::numeric_limits<double>::max();
  EXPECT_EQ(stable_norm(Xy<double>{0, 0}), 0);
  EXPECT_EQ(stable_norm(Xy<double>{3 * LEAST, -4 * LEAST}), 5 * LEAST);
  EXPECT_EQ(stable_norm(Xy<double>{0, -MOST}), MOST);
  EXPECT_EQ(stable_norm(Xy<double>{3 * (MOST / 8), 4 * (MOST / 8)}), 5 * (MOST / 8));
  EXPECT_TRUE(std::isinf(stable_norm(Xy<double>{MOST, MOST})));
  EXPECT_TRUE(std::isnan(stable_norm(Xy<double>{0, std::nan("")})));
  EXPECT_EQ(stable_norm(Xy<float>{3e-30F, 4e-30F}), 5e-30F);
}

}  // namespace
