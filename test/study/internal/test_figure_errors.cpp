// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Errors of lines and of directions, as studies of stability measure them.

#include "../../../src/study/figure_errors.h"

#include <gtest/gtest.h>

namespace test_figure_errors {
namespace {

using namespace CGAL::Bounding_arcs;

TEST(FigureErrors, OfLinesAndDirectionsHaveClosedForms) {
  const auto exact = [](double x, double y) { return Xy<Mpfr_interval>{Mpfr_interval(x), Mpfr_interval(y)}; };
  const Line_figure<double> upright{2, 0, -6};  // x = 3
  EXPECT_EQ(study::deviation_of_line(upright, {1, 5}, exact(2, 0)).absolute, 0);
  EXPECT_EQ(study::deviation_of_line(upright, {1, 5}, exact(4, 0)).relative, 0.5);
  EXPECT_EQ(study::deviation_of_line<double>({0, 0, 1}, {1, 5}, exact(4, 0)).relative, 1);
  EXPECT_NEAR(study::deviation_of_direction<double>({3, 0x1p-30}, exact(5, 0)).relative, 0x1p-30 / 3, 0x1p-80);
  EXPECT_EQ(study::deviation_of_direction<double>({-1, 0}, exact(5, 0)).relative, 1);
}

}  // namespace
}  // namespace test_figure_errors
