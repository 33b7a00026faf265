// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Bounding_arcs_2/verify/Stability_study.h>

#include "random_spirals.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <string>
#include <vector>

namespace {

using namespace CGAL::Bounding_arcs;
using bounding_arcs_test::random_curve;
using Curve = Bezier_curve_2<double>;

constexpr unsigned SEED = 20261121;
constexpr double ULP = 0x1p-52;

// The largest relative error of the rows that match; -1 where there is none.
double worst(const std::vector<Stability_row>& rows, const std::string& method, const std::string& formula, const std::string& quantity) {
  double error = -1;
  for (const Stability_row& r : rows)
    if (r.kernel == "double" && r.formula == formula && (method.empty() || r.method == method) &&
        (quantity.empty() || r.quantity == quantity))
      error = std::max(error, r.rel_error);
  return error;
}

std::vector<Stability_row> rows_of(const Curve& curve) {
  const auto spirals = spiral_segments(curve);
  EXPECT_EQ(spirals.size(), 1u);
  return stability_rows(spirals[0], 0, 1);
}

Curve near_linear(double delta) { return Curve({{0, 0}, {0.5, 0}, {1, delta}}); }
Curve near_circular(double delta) { return Curve({{1, 0}, {1, 1 + delta}, {0, 1 + delta}}, {1, 1, 2}); }  // quarter ellipse

TEST(StableFormulas, KeepTheirDigitsOnNearLinearPieces) {
  for (int exponent = 0; exponent <= 100; ++exponent) {
    const auto rows = rows_of(near_linear(std::pow(10.0, -exponent)));
    EXPECT_EQ(rows.size(), 3u * 2u * (3u + 4u + 4u));
    EXPECT_LE(worst(rows, "", "stable", ""), 16 * ULP) << "delta 1e-" << exponent;
  }
}

TEST(StableFormulas, KeepTheirDigitsOnNearCircularPieces) {
  for (int bits = 0; bits <= 52; ++bits) {
    const auto rows = rows_of(near_circular(std::ldexp(1.0, -bits)));
    EXPECT_LE(worst(rows, "", "stable", ""), 16 * ULP) << "delta 2^-" << bits;
    EXPECT_GE(worst(rows, "bilens", "stable", "joint"), 0) << "delta 2^-" << bits;
  }
}

TEST(StableFormulas, KeepTheirDigitsWhileASpiralIsHalved) {
  const auto spirals = spiral_segments(Curve({{0, 0}, {0.5, 0.1}, {1, 0.4}, {1.2, 0.9}}));
  for (const auto& spiral : spirals)
    for (int bits = 0; bits <= 40; ++bits) {
      const double t0 = spiral.first() + (spiral.last() - spiral.first()) / 3;
      const auto rows = stability_rows(spiral, t0, t0 + std::ldexp(spiral.last() - t0, -bits));
      EXPECT_LE(worst(rows, "", "stable", ""), 16 * ULP) << "2^-" << bits;
    }
}

TEST(StableFormulas, KeepTheirDigitsOnRandomSpirals) {
  std::mt19937 random(SEED);
  std::uniform_real_distribution<double> scale(-12, 12), size_of_move(-8, 8);
  double largest = 0;
  int pieces = 0;
  for (int i = 0; i < 60; ++i) {
    const Curve base = random_curve(random);
    const double s = std::pow(10.0, scale(random)), move = s * std::pow(10.0, size_of_move(random));
    std::vector<Xy<double>> points;
    for (const Xy<double>& p : base.control_points()) points.push_back({s * p.x + move, s * p.y - move});
    for (const auto& spiral : spiral_segments(Curve(points, base.weights()))) {
      const double h = std::ldexp(spiral.last() - spiral.first(), -static_cast<int>(random() % 20));
      const auto rows = stability_rows(spiral, spiral.first(), spiral.first() + h);
      if (rows.empty()) continue;
      ++pieces;
      largest = std::max(largest, worst(rows, "", "stable", ""));
      EXPECT_LE(worst(rows, "", "stable", ""), 16 * ULP) << "curve " << i << ", t " << spiral.first() << " + " << h;
    }
  }
  EXPECT_GT(pieces, 200);
  RecordProperty("worst_in_ulp", std::to_string(largest / ULP));
}

TEST(TextbookFormulas, AgreeWithTheStableOnesWhereNothingIsSmall) {
  std::mt19937 random(SEED);
  int pieces = 0;
  for (int i = 0; i < 200; ++i) {
    const Curve curve = random_curve(random);
    for (const auto& spiral : spiral_segments(curve)) {
      const auto f = spiral.shape<double>(spiral.first(), spiral.last());
      const auto t = internal::tight_frame(f);
      const bool is_large = t.usable && t.chord > 0.05 && t.sin_delta > 0.02 && t.k_flat > 0.02 && t.k_tight < 20;
      if (!is_large) continue;
      ++pieces;
      EXPECT_LE(worst(stability_rows(spiral, spiral.first(), spiral.last()), "", "textbook", ""), 1e-8) << "curve " << i;
    }
  }
  EXPECT_GT(pieces, 50);
}

TEST(TextbookFormulas, LoseAllDigitsWhereThePaperSaysSo) {
  for (int exponent = 8; exponent <= 16; ++exponent)
    for (const char* method : {"bca", "bilens"})
      EXPECT_GT(worst(rows_of(near_linear(std::pow(10.0, -exponent))), method, "textbook", "thickness"), 0.1)
          << method << ", delta 1e-" << exponent;
}

}  // namespace
