// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Curve files as drawings: the order, names, ends and parameters of their curves.

#include "../support/curve_text.h"

#include <CGAL/Bounding_arcs_2/curve/Drawing_2.h>

namespace test_read_drawing {
namespace {

using namespace bounding_arcs_test;
using CGAL::Bounding_arcs::drawing;
using CGAL::Bounding_arcs::Drawing_2;
using CGAL::Bounding_arcs::read_drawing;
using Parameters = std::vector<double>;

const char* const FOUR_CURVES = R"({"curves": [
  {"name": "clamped", "type": "bspline", "degree": 2, "closed": true,
   "control_points": [[0, 0], [1, 2], [3, 1], [4, 4], [5, 0]], "knots": [-1, -1, -1, 0.5, 0.5, 4, 4, 4]},
  {"name": "line", "type": "bezier", "degree": 1, "control_points": [[0, 0], [1, 0]]},
  {"name": "ring", "type": "nurbs", "degree": 2, "periodic": true, "weights": [1, 2, 1],
   "control_points": [[0, 0], [1, 0], [0, 1]], "knots": [0, 0.25, 2, 3]},
  {"name": "loose", "type": "bspline", "degree": 2, "control_points": [[0, 0], [1, 0], [1, 1], [2, 1]],
   "knots": "uniform"}]})";

TEST(ReadDrawing, KeepsTheOrderNamesAndEndsOfCurvesInJson) {
  const auto curves = drawing<double>(read(FOUR_CURVES)).curves();
  ASSERT_EQ(curves.size(), 4u);
  EXPECT_EQ(curves[0].name, "clamped");
  EXPECT_EQ(curves[1].name, "line");
  EXPECT_EQ(curves[2].name, "ring");
  EXPECT_EQ(curves[3].name, "loose");
  EXPECT_FALSE(curves[0].is_closed) << "the file says that it is closed, but its ends differ";
  EXPECT_FALSE(curves[1].is_closed);
  EXPECT_TRUE(curves[2].is_closed);
  EXPECT_FALSE(curves[3].is_closed);
}

TEST(ReadDrawing, TakesTheKnotsInTheDomainForParameters) {
  const auto d = drawing<double>(read(FOUR_CURVES));
  EXPECT_EQ(d.curves()[0].parameters, (Parameters{-1, 0.5, 4}));
  EXPECT_EQ(d.curves()[1].parameters, (Parameters{0, 1}));
  EXPECT_EQ(d.curves()[2].parameters, (Parameters{0, 0.25, 2, 3}));
  EXPECT_EQ(d.curves()[3].parameters, (Parameters{2, 3, 4}));
  EXPECT_EQ(d.parameter(0, 1, 0.5), 2.25);
  for (const auto& curve : d.curves()) EXPECT_EQ(curve.beziers.size() + 1, curve.parameters.size()) << curve.name;
}

TEST(ReadDrawing, MakesACurveOfEachSubpathOfAnSvg) {
  const auto d =
      drawing<double>(read_svg("<path id='a' d='M 0 0 L 4 0 L 4 4 Z M 1 1 C 1 2 2 2 2 1'/>"
                               "<path d='M 5 5 q 1 1 2 0'/>"));
  ASSERT_EQ(d.curves().size(), 3u);
  EXPECT_EQ(d.curves()[0].name, "a.1");
  EXPECT_EQ(d.curves()[1].name, "a.2");
  EXPECT_EQ(d.curves()[2].name, "path2");
  EXPECT_TRUE(d.curves()[0].is_closed);
  EXPECT_FALSE(d.curves()[1].is_closed);
  EXPECT_EQ(d.curves()[0].parameters, (Parameters{0, 1, 2, 3}));
  EXPECT_EQ(d.curves()[1].parameters, (Parameters{0, 1}));
  EXPECT_EQ(d.curves()[1].beziers[0].control_points(), (Points{{1, 1}, {1, 2}, {2, 2}, {2, 1}}));
}

TEST(ReadDrawing, TakesTheNumbersOfTheFileExactlyOverARational) {
  const auto d = drawing<Exact>(read(R"({"type": "bspline", "degree": 1, "knots": [0, 0.1, 0.7, 0.8],
                                         "control_points": [[0.1, 0], [0.2, 0.3]]})"));
  EXPECT_EQ(d.curves()[0].name, "shape");
  EXPECT_EQ(d.curves()[0].parameters, (std::vector<Exact>{Exact(0.1), Exact(0.7)}));
  EXPECT_EQ(d.curves()[0].beziers[0].control_points()[1].y, Exact(0.3));
}

TEST(ReadDrawing, ReadsABundledCurve) {
  const Drawing_2<double> d = read_drawing(BOUNDING_ARCS_EXAMPLE_DATA "/a_wrench.json");
  ASSERT_EQ(d.curves().size(), 1u);
  EXPECT_EQ(d.curves()[0].name, "a_wrench");
  EXPECT_TRUE(d.curves()[0].is_closed);
  EXPECT_EQ(d.curves()[0].parameters.front(), 0);
  EXPECT_EQ(d.curves()[0].parameters.back(), static_cast<double>(d.curves()[0].beziers.size()));
}

TEST(ReadDrawing, KeepsFilePlaceAndReasonInErrors) {
  EXPECT_EQ(message_of([] { (void)read_drawing("no/such.json"); }),
            "no/such.json: file: cannot be opened: No such file or directory");
  const std::string file = BOUNDING_ARCS_TEST_DATA "/../input/test_read_drawing.cpp";
  EXPECT_EQ(message_of([&] { (void)read_drawing(file); }).find(file + ": line 1, column 1: "), 0u);
  EXPECT_EQ(message_of([] {
              (void)drawing<double>(read(R"({"curves": [{"type": "bezier", "degree": 1, "control_points": [[0, "x"],
                                                         [1, 1]]}]})"));
            }),
            R"(shape.json: curves[0].control_points[0][1]: expected a finite number, found "x")");
}

}  // namespace
}  // namespace test_read_drawing
