// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Areas, lengths and centroids of B-splines, whose inserted knots are rounded, are those of the exact curves.

#include "../../src/library/curve/green.h"
#include "../../src/library/tree/Segment_hierarchy.h"
#include "cases.h"

#include <CGAL/Bounding_arcs_2/query/measures.h>

#include <gtest/gtest.h>

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <random>
#include <vector>

namespace test_spline_measures {
namespace {

using namespace bounding_arcs_test;
namespace ba = CGAL::Bounding_arcs;
using ba::area;
using ba::Bounding_arc_tree_2;
using ba::centroid;
using ba::Measure_bounds;

// B-splines of a drawing in doubles, whose inserted knots are rounded.
struct Random_b_spline {
  std::mt19937 random;

  ba::B_spline_curve_2<double> operator()(bool is_rational) {
    std::uniform_real_distribution<double> coordinate(-1, 1), step(0.1, 1);
    const int degree = 1 + static_cast<int>(random() % 4);
    const std::size_t n = static_cast<std::size_t>(degree) + 2 + random() % 6;
    std::vector<ba::Xy<double>> points;
    std::vector<double> weights, knots;
    for (std::size_t i = 0; i < n; ++i) {
      const double x = coordinate(random);
      points.push_back({x, coordinate(random)});
    }
    if (is_rational)
      for (std::size_t i = 0; i < n; ++i) weights.push_back(step(random));
    if (random() % 2 == 0) return ba::B_spline_curve_2<double>::periodic(degree, points, {}, weights);
    if (random() % 2 == 0) {  // one period of knots, some of them double
      double t = coordinate(random);
      for (std::size_t i = 0; i <= n; ++i)
        knots.push_back(t += i > 0 && random() % 8 == 0 && degree > 1 ? 0 : step(random));
      if (!has_runs(knots)) return ba::B_spline_curve_2<double>::periodic(degree, points, knots, weights);
      knots.clear();
    }
    points.back() = points.front();  // clamped
    for (int i = 0; i <= degree; ++i) knots.push_back(0);
    for (std::size_t i = static_cast<std::size_t>(degree) + 1; i < n; ++i) knots.push_back(knots.back() + step(random));
    for (int i = 0; i <= degree; ++i) knots.push_back(i == 0 ? knots.back() + step(random) : knots.back());
    return ba::B_spline_curve_2<double>(degree, points, knots, weights);
  }
  // Of three or more, or at an end.
  static bool has_runs(const std::vector<double>& knots) {
    for (std::size_t i = 2; i < knots.size(); ++i)
      if (knots[i] == knots[i - 2]) return true;
    return knots[0] == knots[1] || knots[knots.size() - 1] == knots[knots.size() - 2];
  }
};

TEST(Area, OfBSplinesIsThatOfTheirExactCurves) {
  Random_b_spline curves{std::mt19937(71)};
  int differ = 0;
  for (int i = 0; i < cases(300); ++i) {
    const auto curve = curves(false);
    CGAL::Exact_rational exact(0), of_pieces(0);
    for (const auto& piece : curve.over<CGAL::Exact_rational>().bezier_pieces())
      exact += ba::moments_along(piece, {0, 0}, false).area;
    ba::Drawing_2<double> drawing;
    drawing.add(curve);
    const Bounding_arc_tree_2 index(drawing);
    for (std::uint32_t b = 0; b < index.in_unit().number_of_beziers(); ++b)
      of_pieces += ba::moments_along(index.in_unit().exact_bezier(b), {0, 0}, false).area;
    const Measure_bounds found = area(index, 0);
    EXPECT_TRUE(CGAL::Exact_rational(found.lower) <= exact && exact <= CGAL::Exact_rational(found.upper)) << i;
    EXPECT_LE(found.upper, std::nextafter(found.lower, HUGE_VAL)) << i;
    differ += of_pieces < CGAL::Exact_rational(found.lower) || CGAL::Exact_rational(found.upper) < of_pieces;
  }
  EXPECT_GT(differ, cases(300) / 10);  // of the pieces in doubles
}

// Knots that are rounded leave a gap between the exact ends, which doubles do not tell.
TEST(Area, OfABSplineThatDoublesCloseIsThatOfItsPieces) {
  const std::vector<ba::Xy<double>> points{{0, 0}, {3, 0}, {3, 2}, {0, 2}, {0, 0}, {3, 0}, {3, 2}};
  std::vector<double> knots;
  for (int i = 0; i < 11; ++i) knots.push_back(5.7 / 3 * i);
  const ba::B_spline_curve_2<double> curve(3, points, knots);
  const auto exact = curve.over<CGAL::Exact_rational>().bezier_pieces();
  ASSERT_NE(exact.front().control_points().front(), exact.back().control_points().back());
  ba::Drawing_2<double> drawing, pieces;
  drawing.add(curve);
  pieces.add(drawing.curves().front().beziers);
  ASSERT_TRUE(drawing.curves().front().is_closed);
  EXPECT_EQ(area(Bounding_arc_tree_2(drawing), 0).lower, area(Bounding_arc_tree_2(pieces), 0).lower);
}

TEST(Measures, OfBSplinesAreThoseOfTheirExactCurves) {
  Random_b_spline curves{std::mt19937(72)};
  constexpr double TOLERANCE = 1e-9;
  for (int i = 0; i < cases(20); ++i) {
    const auto curve = curves(i % 2 == 0);
    ba::Drawing_2<double> rounded;
    rounded.add(curve);
    ba::Drawing_2<CGAL::Exact_rational> exact;
    exact.add(curve.over<CGAL::Exact_rational>());
    const Bounding_arc_tree_2 index(rounded), exact_index(exact);
    const auto expect_same = [&](const Measure_bounds& a, const Measure_bounds& b) {
      EXPECT_EQ(a.lower, b.lower) << i;
      EXPECT_EQ(a.upper, b.upper) << i;
    };
    expect_same(area(index, TOLERANCE), area(exact_index, TOLERANCE));
    expect_same(length(index, TOLERANCE), length(exact_index, TOLERANCE));
    const auto a = centroid(index, TOLERANCE), b = centroid(exact_index, TOLERANCE);
    ASSERT_EQ(a.has_value(), b.has_value());
    if (!a) continue;
    expect_same(a->x, b->x);
    expect_same(a->y, b->y);
  }
}

}  // namespace
}  // namespace test_spline_measures
