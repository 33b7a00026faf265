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
#include <random>
#include <vector>

namespace test_fitting_slack {
namespace {

using namespace CGAL::Bounding_arcs;
using namespace bounding_arcs_test;

constexpr unsigned SEED = 831;

double reach_of(const internal::Local_polynomial& q) {
  double reach = 0;
  for (const Point& v : q.m) reach += internal::size_of(v);
  return reach;
}

// The largest distance between a point that arcs are fitted to and the curve's, over fitting_slack: points of random
// pieces as seen from the piece's computed start, all of that rounded as Spiral_arcs does.
double expect_within_slack(const Spiral& spiral, std::mt19937& random) {
  const double unit = spiral.table<double>().unit();
  const auto fraction = [&] { return std::ldexp(static_cast<double>(random() >> 8), -24); };
  const auto q = internal::local_polynomial(spiral.table<double>(), spiral.first(), spiral.last());
  const Exact slack(fitting_slack(spiral, reach_of(q))), first(spiral.first()),
      length = Exact(Exact(spiral.last()) - first);
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

double largest_share(int degree, bool is_rational, double offset, int curves) {
  std::mt19937 random(SEED + static_cast<unsigned>(degree));
  double largest = 0;
  for (int i = 0; i < curves; ++i) {
    const Bezier plain = random_curve(random, degree, is_rational);
    std::vector<Point> points = plain.control_points();
    for (Point& p : points) p = {p.x + offset, p.y - offset};
    for (const Spiral& spiral : spiral_segments(Bezier(points, plain.weights())))
      largest = (std::max)(largest, expect_within_slack(spiral, random));
  }
  return largest;
}

TEST(FittingSlack, HoldsAndIsNotFarAboveNeeded) {
  for (int degree = 2; degree <= 6; degree += FEW_CASES ? 2 : 1) {
    SCOPED_TRACE(degree);
    // the slack counts ends as it does other points, though they are rounded from twice the digits
    EXPECT_GT(largest_share(degree, false, 0, 60), degree < 6 ? 1.0 / 50 : 1.0 / 80);  // polynomials
    EXPECT_GT(largest_share(degree, false, 0x1p20, 60), 1.0 / 30);                     // points
  }
}

// Squares of ratios of weights stand in it: sound, but far above what these curves need.
TEST(FittingSlack, HoldsForRationalCurves) {
  for (int degree = 2; degree <= 6; degree += FEW_CASES ? 2 : 1) {
    SCOPED_TRACE(degree);
    EXPECT_GT(largest_share(degree, true, 0, 8), 0);
    EXPECT_GT(largest_share(degree, true, 0x1p20, 8), 1.0 / 60);
  }
}

// The terms of doc/arcs.md, "Rounding", written out.
TEST(FittingSlack, IsTheSumOfItsTerms) {
  constexpr double U = 0x1p-53;
  const double root = std::sqrt(2.0);
  std::mt19937 random(SEED);
  for (int degree = 2; degree <= 6; ++degree)
    for (const bool is_rational : {false, true})
      for (const Spiral& spiral : spiral_segments(random_curve(random, degree, is_rational))) {
        const double n = degree, h = spiral.last() - spiral.first(), unit = spiral.table<double>().unit(), reach = 3,
                     size = spiral.coordinate_size(), power = std::pow(1 + 2 * h, n);
        double lightest = 1, heaviest = 1;
        for (const double w : spiral.curve().weights()) {
          lightest = (std::min)(lightest, w);
          heaviest = (std::max)(heaviest, w);
        }
        const double weights = heaviest / lightest;
        const double ends = 2 * root * (3 * n + 1) * (is_rational ? 2 : 1) * U * size + 4 * U * size;
        const double growth = is_rational ? 4 * n * weights * weights * power : power - 1;
        const double table = 2 * root * (6 * n + 8) * U * growth * unit,
                     moved = (8 * n + 16) * weights * U * reach * unit;
        const double expected = ends + table + moved;
        EXPECT_NEAR(fitting_slack(spiral, reach), expected, 1e-12 * expected);
      }
}

}  // namespace
}  // namespace test_fitting_slack
