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

TEST(NearEqualDiscs, OfRandomSplines) {
  // one maximum of curvature in 1500 splines is so close to a joint that the curve beyond is in its disc by rounding
  for (int i = 0; i < cases(30) && !HasFailure(); ++i) {
    SCOPED_TRACE(i);
    std::mt19937 random(static_cast<unsigned>(i));
    expect_framed(spline_field(random, 10, 10), random);
  }
}

TEST(NearEqualDiscs, OfManySplinesInOneFrame) {
  // where parts are cut from a large drawing, searches in them start from what is near
  std::mt19937 random(5);
  expect_framed(spline_field(random, 25, 25), random);
}

TEST(NearEqualDiscs, OfASplineThatRunsAlongADisc) {
  // halves of its pieces were looked at as far as parameters could be halved
  const Drawing drawing =
      ba::drawing<double>(ba::read_curves(std::string(BOUNDING_ARCS_TEST_DATA) + "/axis/fifteen_splines.json"));
  std::mt19937 random(7);
  const CGAL::Bbox_2 box = ba::control_box(drawing);
  expect_framed(drawing, random, 0.1 * (std::max)(box.xmax() - box.xmin(), box.ymax() - box.ymin()));
}

}  // namespace
}  // namespace test_near_equal_discs
