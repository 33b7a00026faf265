// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Axes of drawings with very many discs, and with discs that touch many places within rounding: none is refused, and
// all is there.

#include "axis_checks.h"
#include "cases.h"
#include "near_equal_discs.h"

#include <CGAL/Bounding_arcs_2/curve/Curve_file.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <random>
#include <string>

namespace test_near_equal_discs {
namespace {

using namespace bounding_arcs_test;

void expect_framed(const Drawing& drawing, std::mt19937& random, double margin = 1) {
  const Drawing all = ba::framed(drawing, margin);
  const Medial_axis_2 axis = framed_axis_of(all, 1e-4);
  expect_sound(all, axis, 1e-4);
  expect_whole(all, axis, random, 4);
}

TEST(NearEqualDiscs, AreAllKeptOfRandomSplines) {
  for (int i = 0; i < cases(10) && !HasFailure(); ++i) {
    SCOPED_TRACE(i);
    std::mt19937 random(static_cast<unsigned>(i));
    expect_framed(spline_field(random, 10, 10), random);
  }
}

TEST(NearEqualDiscs, AreAllKeptOfManySplinesInOneFrame) {
  // where parts are cut from a large drawing, searches in them start from what is near
  std::mt19937 random(5);
  expect_framed(spline_field(random, 25, 25), random);
}

TEST(NearEqualDiscs, AreAllKeptOfASplineThatRunsAlongADisc) {
  // halves of its pieces were looked at as far as parameters could be halved
  const Drawing drawing = ba::drawing<double>(
      ba::read_curve_file(std::string(BOUNDING_ARCS_TEST_DATA) + "/axis/fifteen_splines.json").curves);
  std::mt19937 random(7);
  const CGAL::Bbox_2 box = drawing.control_box();
  expect_framed(drawing, random, 0.1 * (std::max)(box.xmax() - box.xmin(), box.ymax() - box.ymin()));
}

// How a drawing is moved, turned and rounded.
struct Rounding {
  int ulps;
  double turn, scale;
  Point center;
};
Rounding random_rounding(std::mt19937& random) {
  std::uniform_real_distribution<double> unit(-1, 1);
  const int ulps = static_cast<int>(random() % 4);
  const double turn = random() % 2 == 0 ? 0 : unit(random), scale = std::exp2(4 * unit(random)), x = unit(random),
               far = random() % 2 == 0 ? 0 : 10;
  return {ulps, turn, scale, {far * x, far * unit(random)}};
}

TEST(NearEqualDiscs, AreAllKeptOfRegularPolygons) {
  std::mt19937 random(11);
  for (int i = 0; i < cases(60) && !HasFailure(); ++i) {
    SCOPED_TRACE(i);
    const Rounding r = random_rounding(random);
    const std::size_t n = 3 + random() % (random() % 2 == 0 ? 20 : 400);
    const Drawing drawing = drawing_of(closed_chain(regular_corners(random, n, r.center, r.scale, r.turn, r.ulps)));
    const Medial_axis_2 axis = axis_of(drawing, 1e-4);
    expect_sound(drawing, axis, 1e-4);
    EXPECT_EQ(leaves_of(axis), n);
    if (i % 4 == 0) expect_framed(drawing, random);
  }
}

TEST(NearEqualDiscs, AreAllKeptOfGridsAndCirclesOfPoints) {
  std::mt19937 random(13);
  for (int i = 0; i < cases(60) && !HasFailure(); ++i) {
    SCOPED_TRACE(i);
    const Rounding r = random_rounding(random);
    const std::size_t columns = 1 + random() % 6, rows = 1 + random() % 6;
    expect_framed(i % 2 == 0 ? nearly_a_grid(random, columns, rows, r.turn, r.ulps)
                             : cocircular_points(random, columns * rows + 2, r.center, r.scale, r.ulps),
                  random);
  }
}

TEST(NearEqualDiscs, AreAllKeptOfSquaresWithHoles) {
  std::mt19937 random(17);
  ba::Medial_axis_2::Options options;
  options.rule = ba::Fill_rule::EVEN_ODD;
  for (int i = 0; i < cases(100) && !HasFailure(); ++i) {
    SCOPED_TRACE(i);
    const Rounding r = random_rounding(random);
    const Drawing drawing = square_with_holes(random, r.center, r.turn, r.ulps);
    const ba::Bounding_arc_tree_2 index(drawing);
    const Medial_axis_2 axis = ba::medial_axis(index, 1e-4, options);
    expect_sound(drawing, axis, 1e-4);
    expect_whole(drawing, axis, random, 4,
                 [&](const Point& q) { return ba::locate(index, q, options.rule) == CGAL::ON_BOUNDED_SIDE; });
  }
}

}  // namespace
}  // namespace test_near_equal_discs
