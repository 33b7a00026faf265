// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Joining curves of files: layers, what a file fills, and how far apart the digits of a file put ends.

#include <CGAL/Bounding_arcs_2/curve/Curve_file.h>

#include <gtest/gtest.h>

#include <cmath>
#include <string>

namespace test_join_records {
namespace {

using namespace CGAL::Bounding_arcs;

Curve_file read_dxf(const std::string& entities) {
  std::string text = "0|SECTION|2|ENTITIES|" + entities + "0|ENDSEC|0|EOF|";
  for (char& c : text)
    if (c == '|') c = '\n';
  return Curve_file::from_text(text, "a.dxf", "a");
}
std::string line(const std::string& layer, const std::string& x0, const std::string& y0, const std::string& x1,
                 const std::string& y1) {
  return "0|LINE|8|" + layer + "|10|" + x0 + "|20|" + y0 + "|11|" + x1 + "|21|" + y1 + "|";
}

constexpr double DEGREE = 0.017453292519943295;

TEST(JoinRecords, AJoinedRecordIsAPathWithNameAndLayerOfTheFirst) {
  Curve_file file = read_dxf(line("Cut", "0", "0", "4", "0") + line("Cut", "4", "3", "4", "0") +
                             "0|CIRCLE|8|0|10|2|20|1|40|0.5|" + line("Cut", "4", "3", "0", "0"));
  EXPECT_EQ(file.curves[0].layer, "Cut");
  EXPECT_EQ(file.curves[2].layer, "0");
  const Joined_curves joined = join_curves(file.curves, file.rounding);
  ASSERT_EQ(file.curves.size(), 2u);
  EXPECT_EQ(file.curves[0].name, "Cut.1");
  EXPECT_EQ(file.curves[0].layer, "Cut");
  EXPECT_EQ(file.curves[0].type, Curve_record::PATH);
  EXPECT_TRUE(file.curves[0].closed);
  EXPECT_EQ(file.curves[1].name, "circle1");
  EXPECT_EQ(joined.joined, std::vector<std::size_t>{0});
  ASSERT_EQ(joined.parts.size(), 2u);
  EXPECT_EQ(joined.parts[0][2].curve, 3u);
  EXPECT_EQ(joined.parts[1][0].curve, 2u);
  EXPECT_TRUE(joined.drawing.curves()[0].is_closed);
}

TEST(JoinRecords, LayersGoApartAtAPlaceThatTheyShare) {
  Curve_file file = read_dxf(line("a", "0", "0", "4", "0") + line("b", "4", "0", "9", "9") +
                             line("a", "4", "0", "4", "3") + line("b", "4", "0", "5", "9"));
  (void)join_curves(file.curves, 0);
  ASSERT_EQ(file.curves.size(), 2u);
  EXPECT_EQ(file.curves[0].layer, "a");
  EXPECT_EQ(file.curves[1].layer, "b");
}

TEST(JoinRecords, WhatAFileFillsIsJoinedOnlyWhereThatIsAskedFor) {
  const std::string svg =
      "<svg xmlns=\"http://www.w3.org/2000/svg\"><path d=\"M0 0h8v8\"/><path d=\"M0 0v8h8\"/>"
      "<g fill=\"none\"><path d=\"M20 0h8v8\"/><path d=\"M20 0v8h8\"/></g></svg>";
  Curve_file file = Curve_file::from_text(svg, "a.svg", "a");
  (void)join_curves(file.curves, file.rounding, false);
  ASSERT_EQ(file.curves.size(), 3u);
  EXPECT_EQ(close_filled(file.curves), 2u);
  EXPECT_TRUE(file.curves[2].closed);
  EXPECT_TRUE(file.curves[2].y_is_down);
  file = Curve_file::from_text(svg, "a.svg", "a");
  (void)join_curves(file.curves, file.rounding);
  EXPECT_EQ(file.curves.size(), 2u);
}

TEST(JoinRecords, ASplineKeepsItsKnotsUnlessItIsJoined) {
  const std::string spline =
      "{\"type\":\"bspline\",\"degree\":2,\"control_points\":[[0,0],[1,2],[2,0]],\"knots\":[0,0,0,5,5,5]}";
  const std::string json =
      "{\"curves\":[" + spline + ",{\"type\":\"bezier\",\"degree\":1,\"control_points\":[[2,0],[9,0]]}]}";
  Curve_file file = Curve_file::from_text(json, "a.json", "a");
  EXPECT_EQ(file.rounding, 0);
  std::vector<Curve_record> alone{file.curves[0]};
  (void)join_curves(alone, 0.1);
  EXPECT_EQ(alone[0].type, Curve_record::BSPLINE);
  (void)join_curves(file.curves, 0);
  ASSERT_EQ(file.curves.size(), 1u);
  EXPECT_EQ(file.curves[0].type, Curve_record::PATH);
  EXPECT_EQ(file.curves[0].degree, 2);
}

TEST(JoinRecords, RoundingIsThatOfDoublesOrOfTheDigitsOfAFile) {
  const double of_doubles = 0x1p-40 * 100;
  EXPECT_EQ(read_dxf(line("0", "0", "0", "100", "50")).rounding, of_doubles);
  EXPECT_EQ(read_dxf(line("0", "0.5", "0.125", "1000000", "50")).rounding, 1e4 * of_doubles) << "too few digits";
  EXPECT_NEAR(read_dxf(line("0", "0.000000", "0", "100.000000", "50")).rounding, 3e-6, 1e-12);
  EXPECT_NEAR(read_dxf(line("0", "1.5e-05", "0", "100", "50")).rounding, 3e-6, 1e-12);
  EXPECT_EQ(read_dxf(line("0", "0.000001", "0", "0.01", "0.01")).rounding, 0x1p-40 * 0.01) << "that would be details";
  // Angles in degrees with four digits move either end of an arc of radius 50 by half as much as their last place.
  const std::string arc = "0|ARC|8|0|10|0.000000|20|0|40|50.000000|50|0.0000|51|";
  const Curve_file of_angles = read_dxf(arc + "90.0000|" + line("0", "0", "0", "1", "1"));
  EXPECT_NEAR(of_angles.rounding, 3e-6, 1e-10);
  EXPECT_NEAR(of_angles.curves[0].end_error, 50 * 1e-4 * DEGREE / 2, 1e-10);
  EXPECT_EQ(of_angles.curves[1].end_error, 0) << "a line has no angles";
  const Curve_file of_degrees = read_dxf(arc.substr(0, arc.size() - 10) + "0|51|90|");
  EXPECT_NEAR(of_degrees.rounding, 3e-6, 1e-10);
  EXPECT_EQ(of_degrees.curves[0].end_error, 0) << "whole degrees";
  EXPECT_EQ(read_dxf("0|ARC|8|0|10|0|20|0|40|1|50|0.0000|51|90.0000|").curves[0].end_error, 1e-4 * (DEGREE / 2));
}

TEST(JoinRecords, AnglesOfFewDigitsCountForTheEndsOfTheirArcsAlone) {
  const std::string triangle = line("0", "0.0", "0", "60.0", "0") + line("0", "60", "0.0001", "30", "40") +
                               line("0", "30", "40", "0", "0"),
                    ellipse = "0|ELLIPSE|8|0|10|30|20|15|11|5.0|21|0|40|0.5|41|0|42|3.1416|";
  Curve_file loose = read_dxf(triangle + ellipse);
  (void)join_curves(loose.curves, loose.rounding);
  ASSERT_EQ(loose.curves.size(), 2u);
  EXPECT_TRUE(loose.curves[0].closed);
  // The ellipse's own end is off by 1.8e-5, in a file whose lengths have six digits.
  const std::string half = line("0", "0.000001", "40.000000", "60", "40") + line("0", "35", "15", "25", "15.000000");
  Curve_file closed = read_dxf(half + ellipse);
  (void)join_curves(closed.curves, closed.rounding);
  ASSERT_EQ(closed.curves.size(), 2u);
  EXPECT_TRUE(closed.curves[1].closed);
}

}  // namespace
}  // namespace test_join_records
