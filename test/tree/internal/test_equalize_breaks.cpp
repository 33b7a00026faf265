// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Break points of equal measure: the number of regions against N*, and measures that are no cube of a length.

#include "bundled_spirals.h"
#include "cases.h"
#include "trees.h"

#include "../../../src/library/tree/equalize_breaks.h"
#include "../../../src/study/slope_integral.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

namespace test_equalize_breaks {
namespace {

using namespace CGAL::Bounding_arcs;
using bounding_arcs_test::FEW_CASES;
using bounding_arcs_test::Kernel;
using bounding_arcs_test::Spiral;
using bounding_arcs_test::Spiral_source;

// Regions of a spiral with equal thickness at most eps; checks order and measures.
template <class Traits> std::size_t expect_equalized(const Spiral& spiral, double eps) {
  const auto bound = Traits().bound_thickness_2_object();
  Measured_breaks r;
  r.breaks = {spiral.first(), spiral.last()};
  const bool reached =
      equalize_breaks(r, eps, 1'000'000, [&](const std::vector<double>& b, std::vector<double>& thickness) {
        for (std::size_t i = 0; i + 1 < b.size(); ++i)
          thickness[i] = bound(Spiral_source{spiral, b[i], b[i + 1]}, eps).upper;
      });
  EXPECT_TRUE(reached);
  EXPECT_EQ(r.breaks.front(), spiral.first());
  EXPECT_EQ(r.breaks.back(), spiral.last());
  for (std::size_t i = 0; i < r.measures.size(); ++i) {
    EXPECT_LT(r.breaks[i], r.breaks[i + 1]);
    EXPECT_LE(r.measures[i], eps);
    EXPECT_EQ(r.measures[i], bound(Spiral_source{spiral, r.breaks[i], r.breaks[i + 1]}, eps).upper);
  }
  return r.measures.size();
}

template <class Traits> void expect_few_regions(double factor, double eps) {
  for (const auto& curve : bounding_arcs_test::bundled_curves()) {
    double least = 0;
    std::size_t regions = 0;
    for (const Spiral& s : curve.spirals) {
      least += std::cbrt(factor / eps) * slope_integral(s);
      regions += expect_equalized<Traits>(s, eps);
    }
    EXPECT_LE(static_cast<double>(regions), 1.03 * least + static_cast<double>(curve.spirals.size())) << curve.name;
  }
}

TEST(EqualizeBreaks, NeedsFewRegions) {
  for (const double eps : {1e-5, 1e-8}) {
    expect_few_regions<Bca_traits_2<Kernel>>(cubic_factor::BCA, eps);
    if (FEW_CASES) break;
    expect_few_regions<Spiral_fat_arc_traits_2<Kernel>>(cubic_factor::SPIRAL_FAT_ARC, eps);
    expect_few_regions<Bilens_traits_2<Kernel>>(cubic_factor::BILENS, eps);
  }
}

using Measure = double (*)(double, double);

Measured_breaks equalized(double eps, std::size_t limit, Measure measure, bool& reached) {
  Measured_breaks r;
  r.breaks = {0, 1};
  reached = equalize_breaks(r, eps, limit, [&](const std::vector<double>& b, std::vector<double>& m) {
    for (std::size_t i = 0; i + 1 < b.size(); ++i) m[i] = measure(b[i], b[i + 1]);
  });
  return r;
}

TEST(EqualizeBreaks, MakesMeasuresNearlyEqual) {
  const auto cube = [](double a, double b) { return std::pow(std::pow(b, 1.75) - std::pow(a, 1.75), 3); };
  bool reached = false;
  const Measured_breaks r = equalized(1e-6, 1000, cube, reached);
  EXPECT_TRUE(reached);
  EXPECT_LE(r.measures.size(), 102u);  // 100 at least
  EXPECT_GT(*std::min_element(r.measures.begin(), r.measures.end()), 0.9e-6);
}

TEST(EqualizeBreaks, AlsoWorksWhereTheCubeIsNoGuide) {
  const auto linear = [](double a, double b) { return b - a; };
  const auto jump = [](double a, double b) { return a <= 0.3 && b > 0.3 ? 1.0 : std::pow(b - a, 3); };
  const auto unmeasured = [](double a, double b) {
    return b - a > 0.01 ? std::numeric_limits<double>::infinity() : b - a;
  };
  bool reached = false;
  EXPECT_LE(equalized(1e-3, 10000, linear, reached).measures.size(), 2048u);
  EXPECT_TRUE(reached);
  EXPECT_LE(equalized(1e-2, 10000, unmeasured, reached).measures.size(), 256u);
  EXPECT_TRUE(reached);
  const Measured_breaks r = equalized(1e-3, 10000, jump, reached);  // never below eps, however short
  EXPECT_FALSE(reached);
  EXPECT_EQ(*std::max_element(r.measures.begin(), r.measures.end()), 1);
}

// Measures of no use: as large as running error bounds are where all digits are lost.
TEST(EqualizeBreaks, KeepsBreaksInOrderWhereMeasuresAreHuge) {
  const auto huge = [](double a, double b) { return b - a > 0.01 ? 1e230 / (b - a) : 0.5; };
  const auto largest = [](double a, double b) { return b - a > 0.01 ? 1e308 : 0.5; };
  for (const Measure measure : {Measure(huge), Measure(largest)})
    for (const double eps : {1.0, 1e-5}) {
      bool reached = false;
      const std::vector<double> breaks = equalized(eps, 1000, measure, reached).breaks;
      for (std::size_t i = 0; i + 1 < breaks.size(); ++i) EXPECT_LE(breaks[i], breaks[i + 1]) << eps;
      EXPECT_EQ(reached, eps == 1);
    }
}

// Three pieces are within eps, but by so much that two are tried, in vain: the result is of three again.
TEST(EqualizeBreaks, MeasuresEveryPieceOfTheResult) {
  const auto measure = [](double a, double b) { return b - a > 0.4 ? 1.1 : b - a > 0.3 ? 0.1 : 0.0; };
  bool reached = false;
  const Measured_breaks r = equalized(1, 100, measure, reached);
  EXPECT_TRUE(reached);
  EXPECT_EQ(r.breaks.size(), 4u);
  EXPECT_EQ(r.measures.size(), r.breaks.size() - 1);
  EXPECT_LE(*std::max_element(r.measures.begin(), r.measures.end()), 1);
}

// Measures that stay just above eps until pieces are short: none may pass for within.
TEST(EqualizeBreaks, TakesNoMeasureForLessThanItIs) {
  const auto slightly_above = [](double a, double b) { return b - a > 1e-3 ? 1.005 : 0.5; };
  const auto by_an_ulp = [](double a, double b) { return b - a > 1e-3 ? 1 + 0x1p-52 : 1.0; };
  const auto at_eps = [](double a, double b) { return b - a > 0.5 ? 1.005 : 1.0; };
  for (const Measure measure : {Measure(slightly_above), Measure(by_an_ulp)}) {
    bool reached = false;
    const Measured_breaks r = equalized(1, 100000, measure, reached);
    EXPECT_TRUE(reached);
    EXPECT_GE(r.measures.size(), 1000u);
    EXPECT_LE(*std::max_element(r.measures.begin(), r.measures.end()), 1);
    EXPECT_GT(equalized(1, 100, measure, reached).measures.front(), 1);  // too few, and told so
    EXPECT_FALSE(reached);
  }
  bool reached = false;
  EXPECT_EQ(equalized(1, 100, at_eps, reached).measures.size(), 2u);  // no measure for more than it is, either
  EXPECT_TRUE(reached);
}

TEST(EqualizeBreaks, StopsAtTheLimit) {
  const auto cube = [](double a, double b) { return std::pow(b - a, 3); };
  bool reached = true;
  EXPECT_LE(equalized(1e-12, 100, cube, reached).measures.size(), 8 * 101u);
  EXPECT_FALSE(reached);
}

TEST(EqualizeBreaks, GivesUpSoonWhereTheLimitIsFarTooLow) {
  const Measure cube = [](double a, double b) { return std::pow(b - a, 3); };
  for (const double eps : {1e-24, 1e-300}) {  // 10^8 pieces, and more than there are doubles
    bool reached = true;
    const Measured_breaks r = equalized(eps, 10'000'000, cube, reached);
    EXPECT_FALSE(reached);
    EXPECT_TRUE(r.is_limit_far);
    EXPECT_LE(r.measures.size(), 8 * 4096u);
  }
  bool reached = false;
  EXPECT_FALSE(equalized(1e-15, 10'000'000, cube, reached).is_limit_far);
  EXPECT_TRUE(reached);
}

TEST(EqualizeBreaks, MakesAsManyPiecesAsTheLimit) {
  const Measure measure = [](double a, double b) { return (b * b * b - a * a * a) * (b - a) * (b - a); };
  for (const double eps : {1e-3, 1e-5, 1e-7}) {
    bool reached = false;
    const std::size_t count = equalized(eps, 100'000, measure, reached).measures.size();
    ASSERT_TRUE(reached);
    EXPECT_EQ(equalized(eps, count, measure, reached).measures.size(), count);
    EXPECT_TRUE(reached) << eps;
  }
}

TEST(EqualizeBreaks, LeavesZeroMeasuresAlone) {
  bool reached = false;
  EXPECT_EQ(equalized(
                1e-3, 100, [](double, double) { return 0.0; }, reached)
                .measures.size(),
            1u);
  EXPECT_TRUE(reached);
  const auto half_flat = [](double a, double b) { return std::pow(std::max(b, 0.5) - std::max(a, 0.5), 3); };
  EXPECT_LE(equalized(1e-6, 1000, half_flat, reached).measures.size(), 56u);  // 50 at least
  EXPECT_TRUE(reached);
}

}  // namespace
}  // namespace test_equalize_breaks
