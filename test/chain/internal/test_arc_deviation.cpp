// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Bounds of the distance of arcs from curves, beside samples.

#include "../../../src/library/chain/Cubic_arcs.h"
#include "../../../src/library/chain/arc_deviation.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <random>
#include <vector>

namespace test_arc_deviation {
namespace {

using namespace CGAL::Bounding_arcs;
using namespace CGAL::Bounding_arcs::internal;
using Real = long double;  // of 64 bits: errors of 1e-19, far below what is looked at

// Beside many more samples; weights are least between those that the bound is made of.
TEST(ArcDeviation, BoundsSidesOfCurvesWithSharpWeights) {
  std::mt19937 random(13);
  std::uniform_real_distribution<double> unit(-1, 1);
  for (int i = 0; i < 200; ++i) {
    const double at = (std::floor(CELLS / 2.0 * (1 + unit(random))) + 0.5) / CELLS,
                 least = std::exp2(4 * unit(random)) / (CELLS * CELLS);
    Local_polynomial q;
    for (const double w : {at * at + least, -2 * at, 1.0}) q.w.push_back(w / (at * at + least));
    for (int k = 0; k < 3; ++k)
      q.m.push_back(i % 2 == 0 ? Xy<double>{0, k == 0 ? 1.0 : 0.0} : Xy<double>{unit(random), unit(random)});
    const Local_arc arc{{1, 0}, i % 4 < 2 ? 0 : 0.2 * unit(random)};
    Real largest = 0;
    for (int k = 0; k <= 4096; ++k) {
      const Real u = Real(k) / 4096, w = (q.w[2] * u + q.w[1]) * u + q.w[0];
      const auto coordinate = [&](auto axis) { return ((axis(q.m[2]) * u + axis(q.m[1])) * u + axis(q.m[0])) / w; };
      const Real x = coordinate([](const auto&p) { return Real(p.x); }),
                 y = coordinate([](const auto&p) { return Real(p.y); }), b = arc.bulge;
      largest = std::max(largest, std::fabs((1 - b * b) * y + 2 * b * ((1 - x) * x - y * y)));
    }
    EXPECT_GE(side_bounds(q, arc).side, largest * (1 - 1e-12L)) << i;
  }
}

// Heights with all roots that they have for certain, of polynomials whose other parts are small or not.
TEST(CubicArcs, BoundHeightsBesideSamples) {
  std::mt19937 random(17);
  std::uniform_real_distribution<double> unit(-1, 1);
  const auto largest = [](const std::vector<double>& f, Real low) {
    Real most = 0;
    for (int k = 0; k <= 2000; ++k) {
      const Real x = low + Real(k) / 2000;
      Real value = 0;
      for (std::size_t i = f.size(); i-- > 0;) value = value * x + f[i];
      most = std::max(most, std::fabs(value));
    }
    return most;
  };
  int known = 0;
  for (int i = 0; i < 2000; ++i) {
    const double share = std::exp2(-12 * std::fabs(unit(random)));
    double g[5];  // of the quotient; its largest part is that which fits leave
    for (double& x : g) x = share * unit(random);
    g[i % 2] = 1;
    const bool is_alone = i % 4 == 1;  // balanced, x + (x^2 - 1/12) r: what is large is known but for squares
    if (is_alone) {
      const double r[3] = {g[2], g[3], g[4]};
      for (std::size_t k : {0u, 2u, 3u, 4u}) g[k] = 0;
      for (std::size_t k = 0; k < 3; ++k) {
        g[k] -= r[k] / 12;
        g[k + 2] += r[k];
      }
    }
    std::vector<double> f(7, 0.0);
    for (std::size_t k = 0; k < 5; ++k) {
      if (i % 2 == 1) {  // (1/4 - x^2) g
        f[k] += g[k] / 4;
        f[k + 2] -= g[k];
      } else if (k < 4) {  // u^2 (1 - u) g
        f[k + 2] += g[k];
        f[k + 3] -= g[k];
      }
    }
    const Bracket range = i % 2 == 1 ? largest_of_balanced(f[0], f[1], f[2], f[3], f[4], f[5], f[6])
                                     : largest_of_tangent(f[2], f[3], f[4], f[5], f[6]);
    const Real exact = largest(f, i % 2 == 1 ? Real(-0.5) : Real(0));
    EXPECT_LE(range.lower, exact * (1 + 1e-5L)) << i;  // of samples that miss the top
    EXPECT_GE(range.upper, exact * (1 - 1e-12L)) << i;
    if (is_alone) {
      EXPECT_LE(range.upper, range.lower * (1 + share * share) + 1e-15) << i;
    }
    known += range.upper <= 1.02 * range.lower;
  }
  EXPECT_GT(known, 500);
}

}  // namespace
}  // namespace test_arc_deviation
