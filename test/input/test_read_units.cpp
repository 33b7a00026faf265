// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// How long a unit of the coordinates is: by the header of a DXF file, by width, height and viewBox of an SVG file.

#include "../support/curve_text.h"

#include <iterator>
#include <string>

namespace test_read_units {
namespace {

using namespace bounding_arcs_test;

double unit_of(const std::string& text) {
  return CGAL::Bounding_arcs::Curve_file::from_text(text, "in", "in").unit_in_mm;
}

// Groups are written with | between codes and values.
double dxf_unit(std::string header) {
  std::string text =
      "0|SECTION|2|HEADER|" + header + "0|ENDSEC|0|SECTION|2|ENTITIES|0|LINE|8|0|10|0|20|0|11|3|21|4|0|ENDSEC|0|EOF|";
  for (char& c : text)
    if (c == '|') c = '\n';
  return unit_of(text);
}
double insunits(const std::string& value) { return dxf_unit("9|$INSUNITS|70|" + value + "|"); }

double svg_unit(const std::string& attributes) {
  return unit_of("<svg xmlns='http://www.w3.org/2000/svg' " + attributes + "><rect width='4' height='2'/></svg>");
}

TEST(ReadUnits, OfDxfAreThoseOfItsReference) {
  const double units[] = {0,
                          25.4,
                          304.8,
                          1609344,
                          1,
                          10,
                          1e3,
                          1e6,
                          2.54e-5,
                          0.0254,
                          914.4,
                          1e-7,
                          1e-6,
                          1e-3,
                          1e2,
                          1e4,
                          1e5,
                          1e12,
                          1.495978707e14,
                          9.4607304725808e18,
                          3.0856775814913673e19};
  for (std::size_t i = 0; i < std::size(units); ++i) EXPECT_DOUBLE_EQ(insunits(std::to_string(i)), units[i]) << i;
  const double survey_foot = 304.8006096012192;
  EXPECT_DOUBLE_EQ(insunits("21"), survey_foot);
  EXPECT_DOUBLE_EQ(insunits("22"), survey_foot / 12);
  EXPECT_DOUBLE_EQ(insunits("23"), survey_foot * 3);
  EXPECT_DOUBLE_EQ(insunits("24"), survey_foot * 5280);
}

TEST(ReadUnits, OfDxfAreNoneWithoutANumberThatHasOne) {
  for (const char* value : {"25", "-1", "9223372036854775807", "x", "", "1.5"}) EXPECT_EQ(insunits(value), 0) << value;
  EXPECT_EQ(dxf_unit(""), 0);
  EXPECT_EQ(dxf_unit("9|$INSUNITS|"), 0);
  EXPECT_EQ(dxf_unit("9|$LUNITS|70|1|9|$MEASUREMENT|70|1|"), 0);
  EXPECT_EQ(dxf_unit("9|$LUNITS|70|2|9|$INSUNITS|70|5|9|$LUPREC|70|4|"), 10);
}

TEST(ReadUnits, OfSvgAreThoseOfItsSizeAndViewBox) {
  const std::string box = " viewBox='0 0 80 80'";
  EXPECT_EQ(svg_unit("width='40mm' height='40mm'" + box), 0.5);
  EXPECT_EQ(svg_unit("width=' 4cm ' height='4CM'" + box), 0.5);
  EXPECT_EQ(svg_unit("width='80in' height='80in'" + box), 25.4);
  EXPECT_DOUBLE_EQ(svg_unit("width='72pt' height='72pt'" + box), 25.4 / 80);
  EXPECT_DOUBLE_EQ(svg_unit("width='6pc' height='6pc'" + box), 25.4 / 80);
  EXPECT_EQ(svg_unit("width='80q' height='80Q'" + box), 0.25);
  EXPECT_DOUBLE_EQ(svg_unit("width='40px' height='40px'" + box), 25.4 / 192);
  EXPECT_EQ(svg_unit("width='40mm'" + box), 0.5) << "the height is as the viewBox has it";
  EXPECT_EQ(svg_unit("height='40mm' width='100%'" + box), 0.5);
  EXPECT_DOUBLE_EQ(svg_unit("width='40mm' height='40mm'"), 25.4 / 96) << "pixels without a viewBox";
}

TEST(ReadUnits, OfSvgFollowItsAspectRatio) {
  const std::string flat = "width='80mm' height='40mm' viewBox='0 0 80 80' ";
  EXPECT_EQ(svg_unit(flat), 0.5);
  EXPECT_EQ(svg_unit(flat + "preserveAspectRatio='xMinYMin slice'"), 1);
  EXPECT_EQ(svg_unit(flat + "preserveAspectRatio='none'"), 0) << "of two lengths";
  EXPECT_EQ(svg_unit("width='80mm' height='80mm' viewBox='0 0 80 80' preserveAspectRatio='none'"), 1);
}

TEST(ReadUnits, OfSvgAreNoneWithoutAPhysicalSize) {
  const std::string box = " viewBox='0 0 80 80'";
  for (const char* size : {"", "width='40' height='40'", "width='100%' height='100%'", "width='4em' height='4ex'",
                           "width='0mm' height='-4mm'", "width='mm' height='4 mm 5'", "width='4ell'",
                           "width='1e301mm' height='1e301mm' viewBox='0 0 1e-300 1e-300'"}) {
    const std::string text = size;
    EXPECT_EQ(svg_unit(text + (text.find("viewBox") == text.npos ? box : "")), 0) << text;
  }
}

TEST(ReadUnits, OfJsonAreNone) {
  EXPECT_EQ(unit_of(R"({"type": "bezier", "degree": 1, "control_points": [[0, 0], [1, 1]]})"), 0);
}

}  // namespace
}  // namespace test_read_units
