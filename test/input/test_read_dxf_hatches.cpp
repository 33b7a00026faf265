// Copyright (c) 2026 The Bounding Arcs authors.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Outlines of hatches in DXF files: read where no other curves draw them.

#include "../support/dxf_text.h"

#include <cmath>
#include <string>

namespace test_read_dxf_hatches {
namespace {

using namespace bounding_arcs_test;
using CGAL::Bounding_arcs::Curve_file;

std::string hatch(const std::string& paths) {
  return "0|HATCH|8|0|10|0|20|0|30|0|2|SOLID|70|1|71|0|91|1|" + paths + "75|1|76|1|98|1|10|50|20|50|";
}
const std::string OUTLINE_READ = "read all the same: 1 HATCH: by its outline, which no other curves draw";

TEST(ReadDxf, ReadsOutlinesOfHatchesThatNothingElseDraws) {
  const std::string polyline = "92|2|72|1|73|1|93|2|10|0|20|0|42|1|10|2|20|0|42|0|97|0|";
  expect_length(2 + PI, hatch(polyline), OUTLINE_READ);
  EXPECT_TRUE(read_entities(hatch(polyline)).curves.front().closed);
  // edges in another order and direction: the upper half of a circle clockwise from (0, 0), and its chord
  const std::string arc = "72|2|10|1|20|0|40|1|50|180|51|360|73|0|";
  expect_length(2 + PI, hatch("92|1|93|2|" + arc + "72|1|10|0|20|0|11|2|21|0|97|0|"), OUTLINE_READ);
  const auto points = [](const Curve_file& file) { return file.curves.front().beziers.front().point(0.5); };
  EXPECT_GT(points(read_entities(hatch("92|1|93|2|" + arc + "72|1|10|2|20|0|11|0|21|0|97|0|"))).y, 0.5);
  // a quarter of an ellipse from the angle of 45 degrees, at (1, 1) / sqrt(1.25), counterclockwise and clockwise
  const double at = 2 / std::sqrt(5.0);
  const std::string place = std::to_string(at);
  for (const bool is_ccw : {true, false}) {
    const std::string y = is_ccw ? place : "-" + place, top = is_ccw ? "1" : "-1";
    const std::string ellipse = "72|3|10|0|20|0|11|2|21|0|40|0.5|50|45|51|90|73|" + std::string(is_ccw ? "1|" : "0|");
    const Curve_file file = read_entities(hatch("92|1|93|3|" + ellipse + "72|1|10|0|20|" + top + "|11|0|21|0|" +
                                                "72|1|10|0|20|0|11|" + place + "|21|" + y + "|97|1|330|2F|"));
    ASSERT_EQ(file.curves.size(), 1u);
    EXPECT_TRUE(file.curves.front().closed);
    EXPECT_LT(std::fabs(file.curves.front().beziers.front().point(0).y - (is_ccw ? at : -at)), 1e-5);
  }
  const std::string spline =
      "72|4|94|1|73|0|74|0|95|5|96|3|40|0|40|0|40|1|40|2|40|2|10|0|20|0|10|3|20|4|10|3|20|0|97|0|";
  expect_length(12, hatch("92|1|93|2|72|1|10|0|20|0|11|3|21|0|" + spline + "97|0|"), OUTLINE_READ);
  expect_length(2 * PI, hatch("92|1|93|1|72|2|10|9|20|0|40|1|50|0|51|360|73|1|97|0|"), OUTLINE_READ);
}

TEST(ReadDxf, LeavesOutlinesOfHatchesOutThatOtherCurvesDraw) {
  const std::string around = "92|2|72|0|73|1|93|4|10|0|20|0|10|4|20|0|10|4|20|3|10|0|20|3|97|0|";
  const std::string lines =
      "0|LINE|8|1|10|-1|20|0|11|9|21|0|0|LWPOLYLINE|8|2|90|4|70|0|10|4|20|0.000002|10|4|20|3|10|0|"
      "20|3|10|0|20|-1|";
  const std::string drawn = "1 HATCH: its outline is drawn by other curves";
  expect_length(10 + 3 + 4 + 4, lines + hatch(around), "left out: " + drawn);
  expect_length(10 + 3 + 4 + 4, hatch(around) + lines, "left out: " + drawn);
  // a circle in two halves, where the file draws a circle
  expect_length(2 * PI,
                "0|CIRCLE|8|0|10|1|20|0|40|1|" + hatch("92|2|72|1|73|1|93|2|10|0|20|0|42|1|10|2|20|0|42|1|97|0|"),
                "left out: " + drawn);
  // one of two outlines; twice the same; around a text
  const std::string other = "92|2|72|0|73|1|93|3|10|20|20|0|10|24|20|0|10|24|20|3|97|0|";
  expect_length(21 + 12, lines + hatch(around + other), OUTLINE_READ);
  expect_length(12, hatch(other) + hatch(other), "left out: " + drawn + "; " + OUTLINE_READ);
  expect_length(12, hatch(other + "92|11" + around.substr(4)), OUTLINE_READ);
  expect_left_out("1 HATCH: no outline", hatch("92|11" + around.substr(4)));
  expect_left_out("1 HATCH: no outline", "0|HATCH|8|0|10|0|20|0|91|0|");
  expect_left_out("1 HATCH: an outline that is not closed", hatch("92|1|93|1|72|1|10|0|20|0|11|3|21|0|97|0|"));
  expect_left_out("1 HATCH: an edge of another kind", hatch("92|1|93|1|72|9|10|0|20|0|97|0|"));
}

// Angles come with as few as six digits behind the point, so that a turn ends beside itself.

}  // namespace
}  // namespace test_read_dxf_hatches
