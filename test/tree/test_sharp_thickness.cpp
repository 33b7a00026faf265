// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// What a node tells of its thickness against enclosures of 512 bits: never less, and at most 16 ulp more. Random,
// near-linear and near-circular curves, whose pieces next to vertices have little curvature left to be thick by.

#include "random_spirals.h"

#include <CGAL/Bounding_arcs_2.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <vector>

namespace test_sharp_thickness {
namespace {

using namespace bounding_arcs_test;
namespace ba = CGAL::Bounding_arcs;

std::vector<Bezier> near_linear() {
  std::vector<Bezier> curves;
  for (int bits = 4; bits <= 44; bits += 4) {
    const double d = std::ldexp(1.0, -bits) / 3;
    curves.emplace_back(std::vector<Point>{{0.3, 0.7}, {0.8, 0.7}, {1.3, 0.7 + d}});
    curves.emplace_back(std::vector<Point>{{0, 0}, {1.0 / 3, 0}, {2.0 / 3, d / 3}, {1, 4 * d / 3}});
  }
  return curves;
}
std::vector<Bezier> near_circular() {
  std::vector<Bezier> curves;
  for (int bits = 4; bits <= 44; bits += 4) {
    const double d = std::ldexp(1.0, -bits) / 3;
    curves.emplace_back(std::vector<Point>{{1, 0}, {1, 1 + d}, {0, 1 + d}}, std::vector<double>{1, 1, 2});
  }
  return curves;
}
std::vector<Bezier> random_curves() {
  std::mt19937 random(8);
  std::vector<Bezier> curves;
  for (int i = 0; i < 20; ++i) curves.push_back(random_curve(random, 2 + i % 6, i % 3 == 0));
  return curves;
}

template <class Construction> class SharpThickness : public testing::Test {};
using Constructions = testing::Types<ba::Bca, ba::Spiral_fat_arc, ba::Bilens>;
TYPED_TEST_SUITE(SharpThickness, Constructions);

template <class Construction> void expect_sharp(const Piece& piece) {
  constexpr mpfr_prec_t BITS = 512;
  const auto thickness = ba::sharp_thickness(Construction(), piece.spiral, piece.t0, piece.t1);
  ASSERT_TRUE(thickness) << text(piece);
  const auto shape = piece.spiral.shape<Exact>(piece.t0, piece.t1, ba::shape_parts<Construction>());
  const auto exact = ba::thickness_enclosure(Construction(), shape, BITS);
  ASSERT_TRUE(exact) << text(piece);
  EXPECT_GE((ba::Mpfr_interval(Exact(*thickness), BITS) - *exact).upper(), 0) << text(piece);  // not an ulp below
  const double ulp = std::nextafter(exact->upper(), HUGE_VAL) - exact->upper();
  EXPECT_LE(*thickness, exact->lower() + (exact->lower() == 0 ? 0 : 16 * ulp)) << text(piece);
}

TYPED_TEST(SharpThickness, IsAtMostSixteenUlpAboveTheExactOne) {
  for (const auto& curves : {random_curves(), near_linear(), near_circular()})
    for (const Bezier& curve : curves)
      for (const Spiral& spiral : ba::spiral_segments(curve))
        for (int level = 0; level <= 6; level += 2)
          for (int place = 0; place < (std::min)(1 << level, 5); ++place) {  // beside the segment's first end, and all
            const double length = (spiral.last() - spiral.first()) / (1 << level), t0 = spiral.first() + place * length;
            expect_sharp<TypeParam>({spiral, t0, (std::min)(t0 + length, spiral.last())});
            if (testing::Test::HasFatalFailure()) return;
          }
}

}  // namespace
}  // namespace test_sharp_thickness
