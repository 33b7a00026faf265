// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// What errors say.

#include <CGAL/Bounding_arcs_2/number/Exact_number.h>
#include <CGAL/Bounding_arcs_2/number/expected.h>

#include <gtest/gtest.h>

#include <cmath>
#include <cstddef>
#include <limits>
#include <stdexcept>
#include <string>

namespace test_expected {
namespace {

using namespace CGAL::Bounding_arcs;

TEST(Expected, NamesTheArgumentWhatWasExpectedAndWhatWasFound) {
  EXPECT_EQ(expected("degree", "at least 1", 0), "degree: expected at least 1, found 0");
  EXPECT_EQ(expected("knots", "6", std::size_t(3)), "knots: expected 6, found 3");
  EXPECT_EQ(expected("curve", "a closed curve", "an open one"), "curve: expected a closed curve, found an open one");
  EXPECT_EQ(expected("point", "finite coordinates", Xy<double>{0.1, HUGE_VAL}),
            "point: expected finite coordinates, found (0.1, inf)");
}

TEST(Expected, WritesNumbersWithTheFewestDigits) {
  EXPECT_EQ(text_of(0.1), "0.1");
  EXPECT_EQ(text_of(0.1 + 0.2), "0.30000000000000004");
  EXPECT_EQ(text_of(-0x1p-1074), "-5e-324");
  for (const double sign : {1.0, -1.0})
    EXPECT_EQ(text_of(std::copysign(std::numeric_limits<double>::quiet_NaN(), sign)), "nan");
  EXPECT_EQ(text_of(0.5, "another one"), "0.5");
  EXPECT_EQ(text_of(CGAL::Exact_rational(0.5), "another one"), "another one");
}

TEST(Expected, ChecksThatANumberIsAboveZero) {
  check_above_zero("eps", std::numeric_limits<double>::denorm_min());
  for (const double wrong : {0.0, -1.0, std::numeric_limits<double>::quiet_NaN()}) {
    try {
      check_above_zero("eps", wrong);
      ADD_FAILURE();
    } catch (const std::invalid_argument& error) {
      EXPECT_EQ(error.what(), "eps: expected a number above 0, found " + text_of(wrong));
    }
  }
}

}  // namespace
}  // namespace test_expected
