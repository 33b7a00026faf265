// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The curves that DXF files draw, and what is left out of them: entities, blocks, layers, paper space, broken files.

#include "../support/dxf_text.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace test_read_dxf_curves {
namespace {

using namespace bounding_arcs_test;
using CGAL::Bounding_arcs::Curve_file;

TEST(ReadDxf, TakesBulgesOfAllVertices) {
  const std::string vertices = "10|0|20|0|10|2|20|0|42|1|", light = "0|LWPOLYLINE|8|0|90|2|70|";
  expect_length(2 + PI, light + "1|" + vertices);
  expect_length(2, light + "0|" + vertices);  // the last one plays no part in an open one
  expect_length(2 + PI, light + "1|10|0|20|0|42|1|10|2|20|0|");
  expect_length(2 * PI, light + "1|10|0|20|0|42|1|10|2|20|0|42|1|");
  const std::string heavy = "0|POLYLINE|8|0|66|1|70|1|" + VERTEX + "10|0|20|0|" + VERTEX + "10|2|20|0|42|1|0|SEQEND|";
  expect_length(2 + PI, heavy);
  // it is on the side to which the last vertex's arc turns
  const Curve_file file = read_entities(light + "1|" + vertices);
  EXPECT_TRUE(file.curves.front().closed);
  double highest = 0;
  for (const Bezier& piece : file.curves.front().beziers) highest = std::max(highest, piece.point(0.5).y);
  EXPECT_GT(highest, 0.7);
}

TEST(ReadDxf, BelievesVerticesBeforeTheirCount) {
  const std::string vertices = "10|0|20|0|10|4|20|0|10|4|20|3|";
  const std::string note = "read all the same: 1 LWPOLYLINE: its count of vertices is wrong";
  for (const std::string count : {"2", "0", "4", "2000000000", "-1"})
    expect_length(12, "0|LWPOLYLINE|8|0|90|" + count + "|70|1|" + vertices, note);
  expect_length(12, "0|LWPOLYLINE|8|0|70|1|" + vertices);
  expect_length(12, "0|LWPOLYLINE|8|0|70|1|" + vertices + "90|3|");
  // splines have counts of knots and points, too
  const std::string spline = "40|0|40|0|40|1|40|1|10|0|20|0|10|3|20|4|";
  for (const std::string counts : {"72|2|73|1|", "72|2000000000|73|99|", ""})
    expect_length(5, "0|SPLINE|8|0|70|8|71|1|" + counts + spline);
}

// hatch PATHS: one of these outlines.
TEST(ReadDxf, TakesRangesBesideATurnForTurns) {
  const auto arc = [](const std::string& to) { return "0|ARC|8|0|10|9|20|0|40|1|50|0|51|" + to + "|"; };
  const auto ellipse = [](const std::string& from, const std::string& to) {
    return "0|ELLIPSE|8|0|10|9|20|0|11|1|21|0|40|1|41|" + from + "|42|" + to + "|";
  };
  const std::string note = ": nearly a full turn, read as one";
  for (const char* to : {"360.0000001", "359.9999999", "360.00001", "359.99995", "360.001", "359.9999"})
    expect_length(2 * PI, arc(to), "read all the same: 1 ARC" + note);
  for (const char* to : {"6.283185", "6.2831854", "6.28318531"})
    expect_length(2 * PI, ellipse("0", to), "read all the same: 1 ELLIPSE" + note);
  using Range = std::pair<const char*, const char*>;
  for (const auto& [from, to] : {Range{"3.141593", "9.424778"},
                                 {"0", "6.2832"},
                                 {"0.0", "6.28319"},
                                 {"0", "6.283"},
                                 {"1.5708", "7.854"},
                                 {"0.5236", "6.8068"},
                                 {"-3.1416", "3.1416"},
                                 {"3.1416", "9.4248"}})
    expect_length(2 * PI, ellipse(from, to), "read all the same: 1 ELLIPSE" + note);
  expect_length(2 * PI, arc("360"));
  expect_length(2 * PI, ellipse("0", "6.283185307179586"));
  expect_length(2 * PI * 359 / 360, arc("359"));
  expect_length(PI / 180 * 1e-3, arc("0.001"));
  expect_length(PI / 180 * 1e-3, arc("360.00100"));  // which five digits tell
  expect_length(2 * PI * 359.9 / 360, arc("359.9"));
  expect_length(6.2833 - 2 * PI, ellipse("0", "6.2833"));
  EXPECT_TRUE(read_entities(arc("359.9999999")).curves.front().closed);
  // a turn further than an angle is rounded either way, and is a turn
  for (int i = 0; i < 100; ++i) {
    const std::string from = std::to_string(0.0617 * i), to = std::to_string(0.0617 * i + 2 * PI);
    const Curve_file file = read_entities(ellipse(from, to));
    EXPECT_TRUE(file.curves.front().closed) << from;
    EXPECT_NEAR(length_of(file), 2 * PI, NEAR) << from;
  }
}

TEST(ReadDxf, ReadsOnceWhatIsThereTwice) {
  const std::string circle = "0|CIRCLE|8|A|10|9|20|0|40|1|", other = "0|CIRCLE|8|B|10|9|20|0|40|1|";
  expect_length(2 * PI, circle + circle, "left out: 1 CIRCLE: there twice");
  expect_length(2 * PI, circle + circle + circle, "left out: 2 CIRCLE: there twice");
  expect_length(4 * PI, circle + other);  // on two layers it may be meant
  expect_length(5, LINE + "0|LINE|8|0|10|3|20|4|11|0|21|0|", "left out: 1 LINE: there twice");  // backwards
  expect_length(10, LINE + "0|LINE|8|0|10|0|20|0|11|3|21|-4|");
  expect_length(4 * PI, circle + "0|CIRCLE|8|A|10|9|20|0|40|1|210|0|220|0|230|-1|");  // mirrored, at -9
}

TEST(ReadDxf, TakesFlagsAsBits) {
  const std::string vertices = "10|0|20|0|10|4|20|0|10|4|20|3|";
  expect_length(12, "0|LWPOLYLINE|8|0|90|3|70|1025|" + vertices);
  expect_length(7, "0|LWPOLYLINE|8|0|90|3|70|65536|" + vertices);
  expect_length(12, "0|LWPOLYLINE|8|0|90|3|70|4294967297|" + vertices);
}

TEST(ReadDxf, SeesPolylinesInSpaceFromAbove) {
  const std::string vertices =
      VERTEX + "10|0|20|0|30|0|" + VERTEX + "10|4|20|0|30|1|42|1|" + VERTEX + "10|4|20|3|30|2|0|SEQEND|";
  expect_length(7, "0|POLYLINE|8|0|66|1|70|8|" + vertices);
  expect_length(12, "0|POLYLINE|8|0|66|1|70|9|" + vertices);
  expect_length(7, "0|POLYLINE|8|0|66|1|70|8|210|0.6|220|0|230|0.8|" + vertices);
  expect_left_out("1 POLYLINE: a mesh", "0|POLYLINE|8|0|66|1|70|16|71|2|72|2|" + vertices);
  expect_left_out("1 POLYLINE: a mesh of faces", "0|POLYLINE|8|0|66|1|70|64|" + vertices);
}

TEST(ReadDxf, LeavesTheFrameOfASplineOut) {
  const std::string fitted = VERTEX + "10|0|20|0|70|8|" + VERTEX + "10|3|20|4|70|8|";
  const std::string frame = VERTEX + "10|100|20|0|70|16|" + VERTEX + "10|0|20|100|70|16|";
  expect_length(5, "0|POLYLINE|8|0|66|1|70|4|" + frame + fitted + "0|SEQEND|");
  expect_left_out("1 POLYLINE: length 0", "0|POLYLINE|8|0|66|1|70|4|" + frame + "0|SEQEND|");
}

TEST(ReadDxf, CutsSplinesWhereAKnotIsThereOnceMoreThanTheDegree) {
  const std::string head = "0|SPLINE|8|0|70|8|71|1|", knots = "40|0|40|0|40|1|40|1|40|2|40|2|";
  const Curve_file gap = read_entities(head + knots + "10|0|20|0|10|1|20|0|10|2|20|0|10|3|20|0|");
  ASSERT_EQ(gap.curves.size(), 2u);
  EXPECT_EQ(names_of(gap), "spline1.1 spline1.2");
  EXPECT_EQ(polygon(gap.curves[0]), (Points{{0, 0}, {1, 0}}));
  EXPECT_EQ(polygon(gap.curves[1]), (Points{{2, 0}, {3, 0}}));
  // without a gap it is one curve
  const Curve_file whole = read_entities(head + knots + "10|0|20|0|10|1|20|0|10|1|20|0|10|3|20|0|");
  ASSERT_EQ(whole.curves.size(), 1u);
  EXPECT_EQ(polygon(whole.curves[0]), (Points{{0, 0}, {1, 0}, {3, 0}}));
  // once more still, and at the ends: a point plays no part
  const Curve_file more = read_entities(
      head + "40|0|40|0|40|1|40|1|40|1|40|2|40|2|10|0|20|0|10|1|20|0|10|9|20|9|10|2|20|0|" + "10|3|20|0|");
  ASSERT_EQ(more.curves.size(), 2u);
  EXPECT_EQ(polygon(more.curves[1]), (Points{{2, 0}, {3, 0}}));
  const Curve_file ends =
      read_entities(head + "40|0|40|0|40|0|40|1|40|1|40|1|10|9|20|9|10|0|20|0|10|1|20|0|10|9|20|9|");
  ASSERT_EQ(ends.curves.size(), 1u);
  EXPECT_EQ(polygon(ends.curves[0]), (Points{{0, 0}, {1, 0}}));
  // both parts have their own weights
  const Curve_file weights =
      read_entities(head + knots + "41|1|41|2|41|3|41|3|10|0|20|0|10|1|20|0|10|2|20|0|10|3|20|0|");
  ASSERT_EQ(weights.curves.size(), 2u);
  EXPECT_EQ(weights.curves[0].beziers.front().weights(), (std::vector<double>{1, 2}));
  EXPECT_FALSE(weights.curves[1].beziers.front().is_rational());
}

TEST(ReadDxf, TakesWeightsWhereverTheyStand) {
  const std::string head = "0|SPLINE|8|0|70|4|71|2|40|0|40|0|40|0|40|1|40|1|40|1|", half = "0.7071067811865476|";
  expect_length(PI / 2, head + "10|1|20|0|41|1|10|1|20|1|41|" + half + "10|0|20|1|41|1|");
  expect_length(PI / 2, head + "41|1|41|" + half + "41|1|10|1|20|0|10|1|20|1|10|0|20|1|");
  expect_length(PI / 2, head + "10|1|20|0|10|1|20|1|10|0|20|1|41|1|41|" + half + "41|1|");
  expect_length(PI / 2, head + "10|1|20|0|30|0|10|1|20|1|30|0|41|" + half + "10|0|20|1|30|0|");
  expect_left_out("1 SPLINE: a wrong number of weights", head + "41|1|10|1|20|0|10|1|20|1|10|0|20|1|");
  expect_left_out("1 SPLINE: a wrong number of weights", head + "10|1|20|0|10|1|20|1|41|1|41|1|10|0|20|1|");
}

TEST(ReadDxf, TakesPlanesFromBothSidesAndAlmostZ) {
  const std::string arc = "0|ARC|8|0|10|0|20|0|40|1|50|0|51|90|", x = "210|", z = "|220|0|230|";
  const auto start = [&](const std::string& plane) {
    return read_entities(arc + plane).curves.front().beziers.front().point(0);
  };
  EXPECT_EQ(start(""), (Point{1, 0}));
  EXPECT_EQ(start(x + "1e-12" + z + "1|"), (Point{1, 0}));
  EXPECT_EQ(start(x + "1e-12" + z + "-1|"), (Point{-1, 0}));
  EXPECT_EQ(start(x + "0" + z + "7|"), (Point{1, 0}));
  for (const std::string& entity :
       {arc, std::string("0|CIRCLE|8|0|10|0|20|0|40|1|"), std::string("0|ELLIPSE|8|0|10|0|20|0|11|1|21|0|40|0.5|"),
        std::string("0|LWPOLYLINE|8|0|90|2|70|0|10|0|20|0|10|1|20|0|")}) {
    const std::string kind = entity.substr(2, entity.find('|', 2) - 2);
    expect_left_out("1 " + kind + ": in a tilted plane", entity + x + "0.6" + z + "0.8|");
    expect_left_out("1 " + kind + ": in a tilted plane", entity + x + "1e-6" + z + "1|");
    expect_left_out("1 " + kind + ": in a tilted plane", entity + x + "1" + z + "0|");
    expect_left_out("1 " + kind + ": extrusion 0 0 0", entity + x + "0" + z + "0|");
  }
  // lines and splines are in the world's coordinates
  expect_length(5, LINE + x + "0.6" + z + "0.8|");
  expect_length(5, LINE + x + "0" + z + "-1|");
  expect_length(5, LINE + x + "0" + z + "0|");
  expect_length(5, "0|SPLINE|8|0|71|1|40|0|40|0|40|1|40|1|10|0|20|0|10|3|20|4|210|0.6|220|0|230|0.8|");
}

TEST(ReadDxf, LeavesEntitiesWithoutACurveOut) {
  expect_left_out("1 CIRCLE: radius 0", "0|CIRCLE|8|0|10|1|20|1|40|0|");
  expect_left_out("1 ARC: radius 0", "0|ARC|8|0|10|1|20|1|40|0|50|0|51|90|");
  expect_left_out("1 CIRCLE: radius below 0", "0|CIRCLE|8|0|10|1|20|1|40|-1|");
  expect_left_out("1 ELLIPSE: an axis of length 0", "0|ELLIPSE|8|0|10|1|20|1|11|0|21|0|40|0.5|");
  expect_left_out("1 ELLIPSE: an axis of length 0", "0|ELLIPSE|8|0|10|1|20|1|11|1|21|0|40|0|");
  expect_left_out("1 LINE: length 0", "0|LINE|8|0|10|1|20|1|11|1|21|1|");
  expect_left_out("1 LWPOLYLINE: length 0", "0|LWPOLYLINE|8|0|90|1|10|1|20|1|");
  expect_left_out("1 POLYLINE: length 0", "0|POLYLINE|8|0|66|1|0|SEQEND|");
  expect_left_out("1 SPLINE: no control points", "0|SPLINE|8|0|71|3|72|0|73|0|74|0|");
  expect_left_out("1 SPLINE: length 0", "0|SPLINE|8|0|71|3|74|2|11|1|21|1|11|1|21|1|");
  expect_left_out("1 SPLINE: a fit point with x or y alone", "0|SPLINE|8|0|71|3|74|2|11|0|21|0|11|1|");
  const std::string knots = "40|0|40|0|40|1|40|1|", points = "10|0|20|0|10|1|20|0|";
  expect_left_out("1 SPLINE: no degree from 1 to 32", "0|SPLINE|8|0|71|0|" + knots + points);
  expect_left_out("1 SPLINE: no degree from 1 to 32", "0|SPLINE|8|0|71|33|" + knots + points);
  expect_left_out("1 SPLINE: a wrong number of knots", "0|SPLINE|8|0|71|2|" + knots + points);
  expect_left_out("1 SPLINE: a weight that is not above 0, or huge",
                  "0|SPLINE|8|0|71|1|" + knots + "10|0|20|0|41|1|10|1|20|1|41|-1|");
  const std::string falling = message_of([&] { (void)read_entities("0|SPLINE|71|1|40|0|40|1|40|0|40|1|" + points); });
  EXPECT_NE(falling.find("left out: 1 SPLINE: "), std::string::npos) << falling;
}

TEST(ReadDxf, CountsOtherKindsByTheirNames) {
  const std::string at = "|8|0|10|0|20|0|";
  std::string entities, notes;
  for (const std::string kind : {"TEXT", "MTEXT", "DIMENSION", "POINT", "3DFACE", "IMAGE"}) {
    expect_left_out("1 " + kind + ": no curve", "0|" + kind + at);
    entities += "0|" + kind + at + "0|" + kind + at;
    notes += (notes.empty() ? "2 " : "; 2 ") + kind + ": no curve";
  }
  expect_left_out(notes, entities);
  for (const std::string kind : {"REGION", "3DSOLID", "MESH", "A NEW KIND"})
    expect_left_out("1 " + kind + ": a kind that is not read", "0|" + kind + at);
  // sheets have windows, which are nothing of a drawing; nor are objects, classes and variables
  const std::string rest = section("HEADER", "9|$EXTMIN|10|x|20|nan|") + section("CLASSES", "0|CLASS|1|LINE|") +
                           section("OBJECTS", "0|DICTIONARY|3|a|0|LINE|10|0|20|0|11|9|21|9|");
  const Curve_file file = read_text(lines(rest + section("ENTITIES", "0|VIEWPORT|8|0|" + LINE) + "0|EOF|"));
  EXPECT_EQ(file.curves.size(), 1u);
  EXPECT_TRUE(file.notes.empty()) << Curve_file::text_of(file.notes);
}

// A corner of two lines, half a unit to each side: groups 41 are along miters.
TEST(ReadDxf, DrawsTheElementsOfAnMline) {
  const double way = 0.5 * std::sqrt(2.0);
  const auto vertex = [](const std::string& place, const std::string& miter, double w, const std::string& more = "0|") {
    const std::string left = std::to_string(w), right = std::to_string(-w);
    return place + "31|0|" + miter + "33|0|74|2|41|" + left + "|41|" + more + "75|0|74|2|41|" + right + "|41|0|75|0|";
  };
  const double third = std::sqrt(0.5);
  const std::string head = "0|MLINE|8|0|2|STANDARD|40|1|70|1|72|3|73|2|10|0|20|0|30|0|", along = "12|1|22|0|32|0|",
                    miter = "13|" + std::to_string(-third) + "|23|" + std::to_string(third) + "|",
                    first = vertex("11|0|21|0|", along + "13|0|23|1|", 0.5),
                    rest =
                        vertex("11|10|21|0|", along + miter, way) + vertex("11|10|21|10|", along + "13|-1|23|0|", 0.5);
  const Curve_file file = read_entities(head + "71|1|" + first + rest);
  ASSERT_EQ(file.curves.size(), 2U);
  EXPECT_TRUE(file.notes.empty());
  EXPECT_NEAR(length_of(file), 19 + 21, NEAR);
  EXPECT_EQ(file.curves[0].beziers.front().point(0), (Point{0, 0.5}));
  EXPECT_EQ(file.curves[1].beziers.back().point(1), (Point{10.5, 10}));
  EXPECT_FALSE(file.curves[0].closed);
  EXPECT_TRUE(read_entities(head + "71|3|" + first + rest).curves[0].closed);
  const Curve_file cut = read_entities(head + "71|1|" + vertex("11|0|21|0|", along + "13|0|23|1|", 0.5, "1|") + rest);
  EXPECT_NE(Curve_file::text_of(cut.notes).find("1 MLINE: cut, read without its gaps"), std::string::npos)
      << Curve_file::text_of(cut.notes);
  EXPECT_NEAR(length_of(cut), 19 + 21, NEAR);
  expect_left_out("1 MLINE: length 0", head + "71|1|" + first);
  expect_left_out("1 MLINE: no elements", head + "71|1|11|0|21|0|11|1|21|0|");
  expect_left_out("1 MLINE: a vertex with other elements", head + "71|1|" + first + "11|10|21|0|13|0|23|1|74|1|41|0|");
}

// The third corner is across from the second.
TEST(ReadDxf, DrawsTheOutlineOfASolid) {
  const std::string corners = "|8|0|10|0|20|0|11|4|21|0|12|0|22|3|";
  for (const std::string kind : {"SOLID", "TRACE"}) {
    expect_length(14, "0|" + kind + corners + "13|4|23|3|");
    expect_length(12, "0|" + kind + corners + "13|0|23|3|");
    expect_length(12, "0|" + kind + corners);
  }
  EXPECT_TRUE(read_entities("0|SOLID" + corners).curves[0].closed);
  EXPECT_EQ(read_entities("0|SOLID" + corners + "230|-1|").curves[0].beziers.front().point(1), (Point{-4, 0}));
  expect_left_out("1 SOLID: no group 12", "0|SOLID|8|0|10|0|20|0|11|4|21|0|");
  expect_left_out("1 SOLID: length 0", "0|SOLID|8|0|10|1|20|1|11|1|21|1|12|1|22|1|");
}

TEST(ReadDxf, LeavesEntitiesWithWrongGroupsOut) {
  const std::string line = "0|LINE|8|0|10|1|20|1|11|4|";
  expect_left_out("1 LINE: no group 21", line);
  for (const std::string word : {"x", "", "nan", "1,5", "0x1"})
    expect_left_out("1 LINE: expected a number, found \"" + word + "\" in group 21", line + "21|" + word + "|");
  for (const std::string word : {"1e302", "-1e302"})
    expect_left_out("1 LINE: expected at most 2^1000, found \"" + word + "\" in group 21", line + "21|" + word + "|");
  expect_left_out("1 LWPOLYLINE: expected an integer, found \"one\" in group 70",
                  "0|LWPOLYLINE|8|0|90|2|70|one|10|0|20|0|10|1|20|0|");
  expect_left_out("1 LWPOLYLINE: a vertex with x or y alone", "0|LWPOLYLINE|8|0|90|2|10|0|10|1|20|0|");
  expect_left_out("1 SPLINE: a control point with x or y alone", "0|SPLINE|71|1|40|0|40|0|40|1|40|1|10|0|10|1|20|0|");
  expect_length(5, "0|LINE|8|0|10|+1|20| 1 |11|4.0|21|5E0|1010|x|1071|y|");  // data of other programs is not looked at
}

TEST(ReadDxf, PlacesBlocksWithTheirLayers) {
  const std::string block = "0|BLOCK|8|0|2|b|70|0|10|1|20|1|" + LINE + "0|LINE|8|own|10|0|20|0|11|3|21|4|0|ENDBLK|";
  const std::string insert = "0|INSERT|8|p|2|B|10|7|20|8|";  // the case of names does not count
  EXPECT_EQ(names_of(read_entities(insert, block)), "p own");
  EXPECT_EQ(read_entities(insert, block).curves.front().beziers.front().point(0), (Point{6, 7}));
  expect_left_out("1 INSERT: its block is missing", "0|INSERT|8|p|2|c|10|7|20|8|", block);
  expect_left_out("1 INSERT: its block is in another file", insert, "0|BLOCK|8|0|2|b|70|4|10|0|20|0|1|b.dwg|0|ENDBLK|");
  expect_left_out("1 INSERT: in its own block", insert, "0|BLOCK|2|b|70|0|10|0|20|0|" + insert + "0|ENDBLK|");
  const std::string other = "0|INSERT|8|p|2|a|10|7|20|8|";
  expect_left_out("1 INSERT: in its own block", insert,
                  "0|BLOCK|2|b|70|0|10|0|20|0|" + other + "0|ENDBLK|0|BLOCK|2|a|10|0|20|0|" + insert + "0|ENDBLK|");
  expect_left_out("1 INSERT: scale 0", insert + "41|0|", block);
  expect_left_out("1 INSERT: more than 1000 rows or columns", insert + "70|1001|44|1|", block);
  expect_left_out("1 INSERT: in a tilted plane", insert + "210|1|220|0|230|1|", block);
  expect_left_out("1 INSERT: extrusion 0 0 0", insert + "210|0|220|0|230|0|", block);
  // many rows and columns that nothing inserts take no memory
  const std::string many = repeated(insert + "70|1000|71|1000|44|1|45|1|", 1000);
  EXPECT_EQ(read_entities(LINE, block + "0|BLOCK|2|many|10|0|20|0|" + many + "0|ENDBLK|").curves.size(), 1u);
  // what is wrong in a block counts once, where it is inserted
  const std::string bad = "0|BLOCK|2|b|70|0|10|0|20|0|0|CIRCLE|8|0|10|0|20|0|40|0|0|MTEXT|8|0|0|ENDBLK|";
  expect_left_out("1 CIRCLE: radius 0; 1 MTEXT: no curve", insert + insert, bad);
  EXPECT_TRUE(read_entities(LINE, bad).notes.empty());
  // deeper and deeper
  std::string nest = "0|BLOCK|2|b0|70|0|10|0|20|0|" + LINE + "0|ENDBLK|";
  for (int i = 1; i < 70; ++i)
    nest +=
        "0|BLOCK|2|b" + std::to_string(i) + "|10|0|20|0|0|INSERT|2|b" + std::to_string(i - 1) + "|10|0|20|0|0|ENDBLK|";
  expect_left_out("1 INSERT: nested deeper than 64 blocks", "0|INSERT|2|b69|10|0|20|0|", nest);
  EXPECT_EQ(read_entities("0|INSERT|2|b63|10|0|20|0|", nest).curves.size(), 1u);
}

std::string layer(const std::string& name, int colour, int flags) {
  return "0|LAYER|2|" + name + "|70|" + std::to_string(flags) + "|62|" + std::to_string(colour) + "|";
}
std::string line_on(const std::string& name, const std::string& more = "") {
  return LINE.substr(0, 9) + name + LINE.substr(10) + more;
}

TEST(ReadDxf, LeavesOutWhatIsHidden) {
  const std::string tables =
      "0|TABLE|2|LAYER|" + layer("off", -7, 0) + layer("frozen", 7, 1) + layer("locked", 7, 4) + "0|ENDTAB|";
  const std::string block = "0|BLOCK|2|b|10|0|20|0|" + LINE + line_on("seen") + line_on("OFF") + "0|ENDBLK|";
  const auto found = [&](const std::string& entities, bool with_hidden = false) {
    const Curve_file file = read_text(dxf(line_on("shown") + entities, block, tables), {with_hidden, false});
    return names_of(file) + "; " + Curve_file::text_of(file.notes);
  };
  const std::string off = "on a layer that is off", frozen = "on a frozen layer";
  EXPECT_EQ(found(line_on("off") + line_on("Off")), "shown; left out: 2 LINE: " + off);
  EXPECT_EQ(found(line_on("frozen")), "shown; left out: 1 LINE: " + frozen);
  EXPECT_EQ(found(line_on("locked") + line_on("unknown")), "shown locked unknown; ");
  EXPECT_EQ(found(line_on("a", "60|1|")), "shown; left out: 1 LINE: invisible");
  EXPECT_EQ(found(line_on("a", "60|0|")), "shown a; ");
  EXPECT_EQ(found("0|MTEXT|8|off|"), "shown; left out: 1 MTEXT: " + off);
  EXPECT_EQ(found(line_on("off") + line_on("frozen") + line_on("a", "60|1|"), true), "shown off frozen a; ");
  // of a block that is inserted on a layer that is off, only what is on layer 0 goes with it
  const std::string insert = "|2|b|10|0|20|0|";
  EXPECT_EQ(found("0|INSERT|8|a" + insert), "shown a seen; left out: 1 LINE: " + off);
  EXPECT_EQ(found("0|INSERT|8|off" + insert), "shown seen; left out: 2 LINE: " + off);
  EXPECT_EQ(found("0|INSERT|8|frozen" + insert), "shown; left out: 1 INSERT: " + frozen);
  EXPECT_EQ(found("0|INSERT|8|a|60|1" + insert), "shown; left out: 1 INSERT: invisible");
  EXPECT_EQ(found("0|INSERT|8|frozen" + insert, true), "shown frozen seen OFF; ");
}

TEST(ReadDxf, LeavesPaperSpaceOut) {
  const auto found = [&](const std::string& entities, const std::string& blocks, bool with_paper = false) {
    const Curve_file file = read_text(dxf(line_on("model") + entities, blocks), {false, with_paper});
    return names_of(file) + "; " + Curve_file::text_of(file.notes);
  };
  const std::string note = "model; left out: 1 LINE: in paper space";
  EXPECT_EQ(found(line_on("a", "67|1|"), ""), note);
  EXPECT_EQ(found(line_on("a", "67|0|"), ""), "model a; ");
  EXPECT_EQ(found(line_on("a", "67|1|"), "", true), "model a; ");
  for (const std::string name : {"*Paper_Space", "*PAPER_SPACE0", "$PAPER_SPACE"}) {
    const std::string block = "0|BLOCK|2|" + name + "|10|0|20|0|" + line_on("sheet") + "0|ENDBLK|";
    EXPECT_EQ(found("", block), note);
    EXPECT_EQ(found("", block, true), "sheet model; ");
    EXPECT_EQ(found("0|INSERT|8|0|2|" + name + "|10|0|20|0|", block), note + "; 1 INSERT: its block is missing");
  }
  const std::string block = "0|BLOCK|2|*Model_Space|10|0|20|0|" + line_on("too") + "0|ENDBLK|";
  EXPECT_EQ(found("", block), "too model; ");
}

TEST(ReadDxf, ReadsFilesWithoutTheirEnd) {
  const std::string eof = "read all the same: 1 file: no EOF at its end";
  const std::string head = "0|SECTION|2|ENTITIES|" + LINE;
  const auto notes = [&](const std::string& text) {
    const Curve_file file = read_text(lines(text));
    EXPECT_NEAR(length_of(file), 5, NEAR) << text;
    return Curve_file::text_of(file.notes);
  };
  EXPECT_EQ(notes(head + "0|ENDSEC|0|EOF"), "");
  EXPECT_EQ(notes(head + "0|ENDSEC|0|EOF|garbage"), "");
  EXPECT_EQ(notes(head + "0|ENDSEC|"), eof);
  EXPECT_EQ(notes(head + "0|ENDSEC||"), eof);
  EXPECT_EQ(notes(head + "0|ENDSEC|0"), eof);
  // an entity that may be half of one is none
  EXPECT_EQ(notes(head + LINE), "left out: 1 LINE: the file ends in it; " + eof);
  EXPECT_EQ(notes(head + LINE + "0"), "left out: 1 LINE: the file ends in it; " + eof);
  const std::string polyline = "0|POLYLINE|8|0|66|1|" + VERTEX + "10|0|20|0|" + VERTEX + "10|9|20|0|";
  EXPECT_EQ(notes(head + polyline), "left out: 1 POLYLINE: the file ends in it; " + eof);
  EXPECT_EQ(message_of([&] { (void)read_text(lines("0|SECTION|2|ENTITIES|" + LINE)); }),
            "in.dxf: file: no curve in the drawing; left out: 1 LINE: the file ends in it; " + eof);
}

TEST(ReadDxf, TakesLongLinesAndAnyEnds) {
  const std::string text = "0|TEXT|8|0|1|" + std::string(100000, 'x') + "|";
  expect_left_out("1 TEXT: no curve", text);
  const std::string zeros(2000, '0');
  expect_length(5, "0|LINE|8|0|10|0." + zeros + "|20|0|11|3|21|" + zeros + "4|");
  std::string with_returns;
  for (const char c : dxf(LINE)) with_returns += c == '\n' ? "\r\n" : std::string(1, c);
  for (const std::string& file : {with_returns, "\xEF\xBB\xBF" + dxf(LINE), "\n\r\n" + dxf(LINE),
                                  lines("999|a comment|") + dxf(lines("999|another|") + LINE)})
    EXPECT_EQ(names_of(read_text(file)), "line1");
}

TEST(ReadDxf, RefusesWhatIsNoGroup) {
  const auto message = [](const std::string& text) { return message_of([&] { (void)read_text(lines(text)); }); };
  EXPECT_EQ(message("0|SECTION|2|ENTITIES|ten|1|"), "in.dxf: line 5: expected a group code, found \"ten\"");
  EXPECT_EQ(message("0|SECTION|2|ENTITIES|1072|1|"), "in.dxf: line 5: expected a group code, found \"1072\"");
  EXPECT_EQ(message("0|SECTION|2|ENTITIES||1|"), "in.dxf: line 5: expected a group code, found \"\"");
  EXPECT_EQ(message("0|SECTION|"),
            "in.dxf: file: no curve in the drawing; read all the same: 1 file: no EOF at its end");
}

TEST(ReadDxf, NamesFilesOfOtherPrograms) {
  const auto message = [](const std::string& text) { return message_of([&] { (void)read_text(text); }); };
  const std::string head = "in.dxf: line 1, column 1: expected JSON, SVG or text DXF, found ";
  EXPECT_EQ(message("AutoCAD Binary DXF\r\n"), head + "a binary DXF file, which is not read: save it as text");
  for (const std::string version : {"AC1015", "AC1032"})
    EXPECT_EQ(message(version), head + "a DWG file, which is not read: save it as DXF");
  EXPECT_EQ(message("solid part"), head + "a file that begins with \"solid part\"");
  EXPECT_EQ(message("%PDF-1.7"), head + "a file that begins with \"%PDF-1.7\"");
}

}  // namespace
}  // namespace test_read_dxf_curves
