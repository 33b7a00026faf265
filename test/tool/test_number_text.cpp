// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Numbers as text are what printf makes of them by %.17g, byte for byte, where they are made in a faster way, where
// that begins and ends, and beyond.

#include "number_text.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <limits>
#include <random>
#include <string>

namespace test_number_text {
namespace {

#ifdef BOUNDING_ARCS_FEW_CASES
constexpr int CASES = 20'000;
#else
constexpr int CASES = 300'000;
#endif

std::string printed(double x) {
  char text[64];
  std::snprintf(text, sizeof text, "%.17g", x);
  return text;
}

void expect_as_printed(double x) {
  ASSERT_EQ(bounding_arcs_tool::number(x), printed(x));
  ASSERT_EQ(bounding_arcs_tool::number(-x), printed(-x));
}

double any_double(std::mt19937_64& random) {
  const std::uint64_t bits = random();
  double x = 0;
  std::memcpy(&x, &bits, sizeof x);
  return x;
}

TEST(NumberText, IsThatOfPrintfForAnyBits) {
  std::mt19937_64 random(1);
  for (int i = 0; i < CASES; ++i)
    if (const double x = any_double(random); std::isfinite(x)) expect_as_printed(x);
  for (const double x : {0.0, 1.0, std::numeric_limits<double>::denorm_min(), std::numeric_limits<double>::min(),
                         std::numeric_limits<double>::max()})
    expect_as_printed(x);
}

TEST(NumberText, IsThatOfPrintfForUsualSizes) {
  std::mt19937_64 random(2);
  std::uniform_real_distribution<double> mantissa(1, 2);
  for (int i = 0; i < CASES; ++i) {
    const int exponent = static_cast<int>(random() % 140) - 80;
    expect_as_printed(std::ldexp(mantissa(random), exponent));
  }
  for (int i = 0; i < CASES / 10; ++i) expect_as_printed(i / 1000.0);
}

// A fraction of b bits has b digits, the last a 5: with 18 - b digits before it, it is in the middle of two numbers.
TEST(NumberText, RoundsTiesToEven) {
  EXPECT_EQ(bounding_arcs_tool::number(0x1p49 + 0.125), "562949953421312.12");
  EXPECT_EQ(bounding_arcs_tool::number(0x1p49 + 0.375), "562949953421312.38");
  std::mt19937_64 random(3);
  for (int bits = 2; bits <= 16; ++bits) {
    std::uniform_int_distribution<std::uint64_t> whole(
        static_cast<std::uint64_t>(std::pow(10.0, 17 - bits)),
        (std::min)((std::uint64_t(1) << (53 - bits)) - 1, static_cast<std::uint64_t>(std::pow(10.0, 18 - bits)) - 1));
    for (int i = 0; i < CASES / 30; ++i) {
      const double odd = 2 * static_cast<double>(random() % (std::uint64_t(1) << (bits - 1))) + 1;
      expect_as_printed(static_cast<double>(whole(random)) + std::ldexp(odd, -bits));
    }
  }
}

TEST(NumberText, IsThatOfPrintfNextToPowersOfTen) {
  for (int power = -330; power < 309; ++power) {
    const double ten = std::strtod(("1e" + std::to_string(power)).c_str(), nullptr);
    double below = ten, above = ten;
    for (int i = 0; i < 8; ++i) {
      expect_as_printed(below);
      expect_as_printed(above);
      below = std::nextafter(below, 0);
      above = std::nextafter(above, HUGE_VAL);
    }
  }
}

}  // namespace
}  // namespace test_number_text
