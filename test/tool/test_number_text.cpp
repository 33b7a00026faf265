// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Numbers as text have the fewest digits that read back, as the standard library finds them, where they are made in a
// faster way, where that begins and ends, and beyond.

#include "number_text.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstdint>
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

std::string of_library(double x) {
  const double size = std::fabs(x);
  const bool is_plain = size == 0 || (size >= 1e-4 && size < 1e16);
  char text[64];
  return {text, std::to_chars(text, text + sizeof text, x,
                              is_plain ? std::chars_format::fixed : std::chars_format::scientific)
                    .ptr};
}

void expect_shortest(double x) {
  ASSERT_EQ(bounding_arcs_tool::number(x), of_library(x));
  ASSERT_EQ(bounding_arcs_tool::number(-x), of_library(-x));
  ASSERT_EQ(std::strtod(bounding_arcs_tool::number(x).c_str(), nullptr), x);
}

double any_double(std::mt19937_64& random) {
  const std::uint64_t bits = random();
  double x = 0;
  std::memcpy(&x, &bits, sizeof x);
  return x;
}

TEST(NumberText, IsShortestForAnyBits) {
  std::mt19937_64 random(1);
  for (int i = 0; i < CASES; ++i)
    if (const double x = any_double(random); std::isfinite(x)) expect_shortest(x);
  for (const double x : {0.0, 1.0, std::numeric_limits<double>::denorm_min(), std::numeric_limits<double>::min(),
                         std::numeric_limits<double>::max()})
    expect_shortest(x);
}

TEST(NumberText, IsShortestForUsualSizes) {
  std::mt19937_64 random(2);
  std::uniform_real_distribution<double> mantissa(1, 2);
  for (int i = 0; i < CASES; ++i) {
    const int exponent = static_cast<int>(random() % 140) - 80;
    expect_shortest(std::ldexp(mantissa(random), exponent));
  }
  for (int i = 0; i < CASES / 10; ++i) expect_shortest(i / 1000.0);
}

TEST(NumberText, IsWhatWasTyped) {
  for (const char* typed : {"0.1", "-0.1", "0.3", "25.4", "1e-06", "2.5e-10", "0.0001", "100000", "1234567.5", "1e+16",
                            "1e-05", "1e+300", "0.5", "2", "-0"}) {
    EXPECT_EQ(bounding_arcs_tool::number(std::strtod(typed, nullptr)), typed);
  }
}

// A fraction of b bits has b digits, the last a 5: with 18 - b digits before it, it is in the middle of two numbers.
TEST(NumberText, RoundsTiesToEven) {
  EXPECT_EQ(bounding_arcs_tool::number(0x1p49 + 0.125), "562949953421312.1");
  EXPECT_EQ(bounding_arcs_tool::number(0x1p49 + 0.375), "562949953421312.4");
  EXPECT_EQ(bounding_arcs_tool::number(196894262895204.125), "196894262895204.12");
  std::mt19937_64 random(3);
  for (int bits = 2; bits <= 16; ++bits) {
    std::uniform_int_distribution<std::uint64_t> whole(
        static_cast<std::uint64_t>(std::pow(10.0, 17 - bits)),
        (std::min)((std::uint64_t(1) << (53 - bits)) - 1, static_cast<std::uint64_t>(std::pow(10.0, 18 - bits)) - 1));
    for (int i = 0; i < CASES / 30; ++i) {
      const double odd = 2 * static_cast<double>(random() % (std::uint64_t(1) << (bits - 1))) + 1;
      expect_shortest(static_cast<double>(whole(random)) + std::ldexp(odd, -bits));
    }
  }
}

TEST(NumberText, IsShortestNextToPowersOfTen) {
  for (int power = -330; power < 309; ++power) {
    const double ten = std::strtod(("1e" + std::to_string(power)).c_str(), nullptr);
    double below = ten, above = ten;
    for (int i = 0; i < 8; ++i) {
      expect_shortest(below);
      expect_shortest(above);
      below = std::nextafter(below, 0);
      above = std::nextafter(above, HUGE_VAL);
    }
  }
}

}  // namespace
}  // namespace test_number_text
