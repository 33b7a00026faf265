// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// What arcs allow for rounding of end points and polynomials, against exact curve points.

#include "cases.h"
#include "random_spirals.h"

#include "../../../src/library/chain/Spiral_arcs.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <random>
#include <vector>

namespace test_fitting_slack {
namespace {

using namespace CGAL::Bounding_arcs;
using namespace bounding_arcs_test;

constexpr unsigned SEED = 831;

// The largest distance between a point that arcs are fitted to and the curve's, over fitting_slack: points of random
// pieces as seen from the piece's computed start, all of that rounded as Spiral_arcs does.
double expect_within_slack(const Spiral& spiral, std::mt19937& random) {
  const double unit = spiral.table<double>().unit();
  const auto fraction = [&] { return std::ldexp(static_cast<double>(random() >> 8), -24); };
  const auto q = internal::local_polynomial(spiral.table<double>(), spiral.first(), spiral.last());
  const Exact slack(fitting_slack(spiral, q)), first(spiral.first()), length = Exact(Exact(spiral.last()) - first);
  const auto curve = spiral.exact_curve();
  const Point start = spiral.point(spiral.first());
  double largest = 0;
  for (int k = 0; k < 6; ++k) {
    const double begin = k == 0 ? 0 : fraction(), width = (1 - begin) * (k % 2 == 0 ? 1 : 0.125), u = fraction();
    const Point from = begin == 0 ? start : start + unit * q(begin), offset = q.piece(begin, width)(u);
    const auto exact = curve.point(Exact(first + length * (Exact(begin) + Exact(width) * Exact(u))));
    const Exact x = Exact(Exact(from.x) + Exact(unit) * Exact(offset.x) - exact.x),
                y = Exact(Exact(from.y) + Exact(unit) * Exact(offset.y) - exact.y);
    const Exact square = Exact((x * x + y * y) / (slack * slack));
    EXPECT_LE(square, Exact(1)) << text({spiral, begin, width});
    largest = (std::max)(largest, std::sqrt(CGAL::to_double(square)));
  }
  return largest;
}

/// \param spread weights are within this factor of each other; 0 of a polynomial
double largest_share(int degree, double spread, double offset, int curves) {
  std::mt19937 random(SEED + static_cast<unsigned>(degree));
  double largest = 0;
  for (int i = 0; i < curves; ++i) {
    std::vector<Point> points = random_curve(random, degree, false).control_points();
    for (Point& p : points) p = {p.x + offset, p.y - offset};
    std::vector<double> weights;
    for (std::size_t k = 0; spread > 0 && k < points.size(); ++k)
      weights.push_back(std::pow(spread, std::ldexp(static_cast<double>(random()), -32)));
    for (const Spiral& spiral : spiral_segments(Bezier(points, weights)))
      largest = (std::max)(largest, expect_within_slack(spiral, random));
  }
  return largest;
}

TEST(FittingSlack, HoldsAndIsNotFarAboveNeeded) {
  for (int degree = 2; degree <= 6; degree += FEW_CASES ? 2 : 1) {
    SCOPED_TRACE(degree);
    // the slack counts ends as it does other points, though they are rounded from twice the digits
    EXPECT_GT(largest_share(degree, 0, 0, 60), degree < 6 ? 1.0 / 50 : 1.0 / 80);  // polynomials
    EXPECT_GT(largest_share(degree, 0, 0x1p20, 60), 1.0 / 30);                     // points
  }
}

// However much weights differ, no more digits are lost.
TEST(FittingSlack, HoldsForRationalCurves) {
  for (int degree = 2; degree <= 6; degree += FEW_CASES ? 2 : 1)
    for (const double spread : {1.0, 1e3, 1e12}) {
      SCOPED_TRACE(degree);
      SCOPED_TRACE(spread);
      EXPECT_GT(largest_share(degree, spread, 0, 4), 1.0 / 2000);      // polynomials
      EXPECT_GT(largest_share(degree, spread, 0x1p20, 4), 1.0 / 100);  // points
    }
}

// The terms of doc/arcs.md, "Rounding", written out.
TEST(FittingSlack, IsTheSumOfItsTerms) {
  constexpr double U = 0x1p-53;
  const double root = std::sqrt(2.0);
  std::mt19937 random(SEED);
  for (int degree = 2; degree <= 6; ++degree)
    for (const Spiral& spiral : spiral_segments(random_curve(random, degree, false))) {
      const double n = degree, h = spiral.last() - spiral.first(), unit = spiral.table<double>().unit(), reach = 3,
                   size = spiral.coordinate_size();
      const double ends = 2 * root * (3 * n + 1) * U * size + 4 * U * size;
      const double table = 2 * root * (6 * n + 8) * U * (std::pow(1 + 2 * h, n) - 1) * unit;
      const double expected = ends + table + (8 * n + 16) * U * reach * unit;
      EXPECT_NEAR(fitting_slack(spiral, reach), expected, 1e-12 * expected);
    }
}

// The values of a piece's weight are between its Bezier coefficients: by its blossom, one argument after the other.
double least_coefficient(const std::vector<double>& weights, double t0, double t1) {
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t ends = 0; ends < weights.size(); ++ends) {
    std::vector<double> w = weights;
    for (std::size_t k = 0; w.size() > 1; ++k) {
      const double t = k < ends ? t1 : t0;
      for (std::size_t i = 0; i + 1 < w.size(); ++i) w[i] = (1 - t) * w[i] + t * w[i + 1];
      w.pop_back();
    }
    least = (std::min)(least, w[0]);
  }
  return least;
}

// As above, "Rounding with weights": what the slack holds beside ends and moved coefficients.
TEST(FittingSlack, CountsTheTermsOfWeights) {
  std::mt19937 random(SEED);
  for (int degree = 2; degree <= 6; ++degree) {
    std::vector<double> weights;
    for (int k = 0; k <= degree; ++k) weights.push_back(std::exp2(20 * std::ldexp(static_cast<double>(random()), -32)));
    const auto points = random_curve(random, degree, false).control_points();
    for (const Spiral& spiral : spiral_segments(Bezier(points, weights))) {
      const double n = degree, t = spiral.first(), h = spiral.last() - t,
                   least = least_coefficient(weights, t, spiral.last());
      double terms = 0, binomial = 1, size = 0;
      for (int i = 0; i <= degree; binomial *= (n - i) / (i + 1), ++i) {
        const auto k = static_cast<std::size_t>(i);
        terms += binomial * weights[k] * std::pow(1 - t + h, n - i) * std::pow(t + h, i);
        size = (std::max)({size, std::fabs(points[k].x - points[0].x), std::fabs(points[k].y - points[0].y)});
      }
      const Weight_bounds bounds = weight_bounds(weights, t, spiral.last());
      EXPECT_NEAR(bounds.growth, terms / least, 1e-12 * terms / least);
      EXPECT_NEAR(bounds.least, least / least_coefficient(weights, t, t), 1e-12 * bounds.least);
      const auto q = internal::local_polynomial(spiral.table<double>(), t, spiral.last());
      EXPECT_GT(fitting_slack(spiral, q), std::sqrt(2.0) * (24 * n + 56) * 0x1p-53 * terms / least * size);
    }
  }
}

}  // namespace
}  // namespace test_fitting_slack
