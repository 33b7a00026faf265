// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// What is asked of drawings at many scales: answers as numbers that each grow with a power of the scale, so that those
// of a drawing that is 2^k times as large are the same bits but for the exponent.

#ifndef BOUNDING_ARCS_TEST_SCALED_ANSWERS_H
#define BOUNDING_ARCS_TEST_SCALED_ANSWERS_H

#include "query_drawings.h"

#include <CGAL/Bounding_arcs_2/region/region_bounds.h>

#include <gtest/gtest.h>

#include <cmath>
#include <cstddef>
#include <random>
#include <string>
#include <vector>

namespace bounding_arcs_test {

class Answers {
 public:
  /// What comes next.
  void of(const char* what) { what_ = what; }
  void number(double x) { add(x, 0); }
  void count(std::size_t n) { add(static_cast<double>(n), 0); }
  void length(double x) { add(x, 1); }
  void area(double x) { add(x, 2); }
  void point(const Point& p) { length(p.x), length(p.y); }
  void place(const ba::Curve_place& p) { count(p.curve), count(p.bezier), number(p.t); }
  template <class Bounds> void lengths(const Bounds& b) { length(b.lower), length(b.upper); }
  template <class Bounds> void areas(const Bounds& b) { area(b.lower), area(b.upper); }

  [[nodiscard]] std::size_t size() const { return numbers_.size(); }
  /// Whether these are the answers at 2^k times the other's scale.
  void expect_scaled(const Answers& unscaled, int k) const {
    for (std::size_t i = 0; i < size() && i < unscaled.size(); ++i) {
      const Number &n = numbers_[i], &of = unscaled.numbers_[i];
      const double expected = std::ldexp(of.value, k * of.power);
      // bounds of the length of a point are the least doubles, here or in the unit of the drawing
      constexpr double NOTHING = 0x1p-1000;
      const double least = std::fmin(std::fabs(n.value), std::fabs(std::ldexp(n.value, -k * n.power)));
      if (std::fabs(of.value) < NOTHING && least < NOTHING) continue;
      ASSERT_TRUE(n.value == expected || (std::isnan(n.value) && std::isnan(expected)))
          << "at 2^" << k << ": " << n.what << ", number " << i << " is " << n.value << " and not " << expected;
    }
    ASSERT_EQ(size(), unscaled.size()) << "at 2^" << k;
  }

 private:
  struct Number {
    double value;
    int power;
    const char* what;
  };
  void add(double x, int power) { numbers_.push_back({x, power, what_}); }

  std::vector<Number> numbers_;
  const char* what_ = "";
};

/// Drawings of a size of about 1/16, so that what is around them is in range at 2^500, too.
inline Drawing small_drawing(const Drawing& drawing) { return moved(drawing, 0x1p-4 / size_of(drawing), {0, 0}); }

/// So many exponents of each hundred between -500 and 500, and both ends: all of them where these are a hundred.
inline std::vector<int> exponents(std::mt19937& random, int each_hundred) {
  std::vector<int> result{-500, 500};
  constexpr int LEAST = -500, MOST = 500, STEP = 100;
  for (int k = LEAST; k < MOST; k += STEP)
    for (int i = 0; i < each_hundred; ++i)
      result.push_back(each_hundred < STEP ? k + static_cast<int>(random() % STEP) : k + i % STEP);
  return result;
}

}  // namespace bounding_arcs_test

#endif
