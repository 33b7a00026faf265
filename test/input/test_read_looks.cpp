// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// What files say of curves beside their course: layers and colours. The page of an SVG file.

#include "../support/curve_text.h"

#include <string>

namespace test_read_looks {
namespace {

using namespace bounding_arcs_test;
using CGAL::Bounding_arcs::Curve_record;

Curve_file read_file(const std::string& text) { return Curve_file::from_text(text, "in", "in"); }

// Groups are written with | between codes and values.
Records dxf(const std::string& entities, const std::string& blocks = "") {
  std::string text =
      "0|SECTION|2|TABLES|0|TABLE|2|LAYER|0|LAYER|2|Red|62|1|0|LAYER|2|Off|62|-3|0|LAYER|2|True|62|5|420|"
      "255|0|LAYER|2|Odd|62|x|0|ENDTAB|0|ENDSEC|0|SECTION|2|BLOCKS|" +
      blocks + "0|ENDSEC|0|SECTION|2|ENTITIES|" + entities + "0|ENDSEC|0|EOF|";
  for (char& c : text)
    if (c == '|') c = '\n';
  Curve_file::Options options;
  options.with_hidden = true;
  return Curve_file::from_text(text, "in", "in", options).curves;
}
std::string line(const std::string& layer, const std::string& colour, const std::string& end = "3") {
  return "0|LINE|8|" + layer + "|" + colour + "10|0|20|0|11|" + end + "|21|4|";
}
Curve_record::Colour colour_of_line(const std::string& layer, const std::string& colour) {
  return dxf(line(layer, colour)).front().colour;
}

TEST(ReadLooks, ColoursOfDxfAreThoseOfTheEntityOrItsLayer) {
  EXPECT_EQ(colour_of_line("Red", ""), (Curve_record::Colour{1, -1}));
  EXPECT_EQ(colour_of_line("rED", "62|256|"), (Curve_record::Colour{1, -1}));
  EXPECT_EQ(colour_of_line("Red", "62|4|"), (Curve_record::Colour{4, -1}));
  EXPECT_EQ(colour_of_line("Red", "62|4|420|66051|"), (Curve_record::Colour{4, 66051}));
  EXPECT_EQ(colour_of_line("Red", "420|66051|"), (Curve_record::Colour{0, 66051}));
  EXPECT_EQ(colour_of_line("True", ""), (Curve_record::Colour{5, 255}));
  EXPECT_EQ(colour_of_line("Off", ""), (Curve_record::Colour{3, -1})) << "a layer that is off";
  EXPECT_EQ(colour_of_line("elsewhere", ""), (Curve_record::Colour{7, -1}));
  EXPECT_EQ(colour_of_line("Red", "62|0|"), (Curve_record::Colour{7, -1})) << "by block outside of one";
}

TEST(ReadLooks, ColoursThatMeanNothingCostNoEntity) {
  for (const char* colour : {"62|x|", "62|999|", "420|-7|", "420|99999999|", "62|1e3|420||"})
    EXPECT_EQ(colour_of_line("Red", colour), (Curve_record::Colour{1, -1})) << colour;
  EXPECT_EQ(colour_of_line("Odd", ""), (Curve_record::Colour{0, -1}));
}

TEST(ReadLooks, ColoursInBlocksAreThoseOfTheInsertion) {
  const std::string block = "0|BLOCK|8|0|2|b|70|0|10|0|20|0|" + line("0", "62|0|", "1") + line("Red", "62|0|", "2") +
                            line("0", "", "3") + line("Red", "", "4") + line("Red", "62|2|", "5") + "0|ENDBLK|";
  const Records records = dxf("0|INSERT|8|True|62|6|2|b|10|7|20|8|", block);
  ASSERT_EQ(records.size(), 5u);
  EXPECT_EQ(records[0].colour, (Curve_record::Colour{6, -1}));
  EXPECT_EQ(records[1].colour, (Curve_record::Colour{6, -1}));
  EXPECT_EQ(records[2].colour, (Curve_record::Colour{5, 255}))
      << "on layer 0 of a block, by the layer of the insertion";
  EXPECT_EQ(records[3].colour, (Curve_record::Colour{1, -1}));
  EXPECT_EQ(records[4].colour, (Curve_record::Colour{2, -1}));
}

Records svg(const std::string& shapes) {
  return read_file(
             "<svg xmlns='http://www.w3.org/2000/svg' "
             "xmlns:inkscape='http://www.inkscape.org/namespaces/inkscape'>" +
             shapes + "</svg>")
      .curves;
}

TEST(ReadLooks, ColoursOfSvgAreThoseOfStrokesOrElseFills) {
  const auto colour = [](const std::string& attributes) {
    return svg("<g stroke='#123456'><rect width='4' height='2' " + attributes + "/></g>").front().colour;
  };
  EXPECT_EQ(colour(""), (Curve_record::Colour{0, 0x123456}));
  EXPECT_EQ(colour("stroke='#F0a'"), (Curve_record::Colour{0, 0xFF00AA}));
  EXPECT_EQ(colour("style='stroke: RGB( 255, 0 ,10)'"), (Curve_record::Colour{0, 0xFF000A}));
  EXPECT_EQ(colour("stroke='rgb(100%,0%,20%)'"), (Curve_record::Colour{0, 0xFF0033}));
  EXPECT_EQ(colour("stroke='none' fill='navy'"), (Curve_record::Colour{0, 0x80}));
  EXPECT_EQ(colour("stroke='none'"), (Curve_record::Colour{0, -1}));
  for (const char* odd : {"#12345", "#12g456", "#-12345", "rgb(1,2)", "rgb(1,2,3", "url(#a)", "currentColor"})
    EXPECT_EQ(colour(std::string("stroke='") + odd + "'"), (Curve_record::Colour{0, -1})) << odd;
}

TEST(ReadLooks, LayersOfSvgAreThoseOfInkscape) {
  const Records records =
      svg("<rect width='4' height='2'/><g inkscape:label='group'><rect width='4' height='2'/></g>"
          "<g inkscape:groupmode='layer' inkscape:label='a &amp; b'><rect width='4' height='2'/>"
          "<g inkscape:groupmode='layer' inkscape:label='c'><g><rect width='4' height='2'/></g></g></g>");
  ASSERT_EQ(records.size(), 4u);
  EXPECT_EQ(records[0].layer, "");
  EXPECT_EQ(records[1].layer, "");
  EXPECT_EQ(records[2].layer, "a & b");
  EXPECT_EQ(records[3].layer, "c");
  // by the namespace, whatever its prefix
  const Records named =
      svg("<g xmlns:ink='http://www.inkscape.org/namespaces/inkscape' ink:groupmode='layer' "
          "ink:label='d'><rect width='4' height='2'/></g><g xmlns:inkscape='http://example.org' "
          "inkscape:groupmode='layer' inkscape:label='e'><rect width='4' height='2'/></g>");
  ASSERT_EQ(named.size(), 2u);
  EXPECT_EQ(named[0].layer, "d");
  EXPECT_EQ(named[1].layer, "");
}

TEST(ReadLooks, PagesOfSvgAreAsTheyStandThere) {
  const auto page = [](const std::string& attributes) {
    return read_file("<svg xmlns='http://www.w3.org/2000/svg' " + attributes + "><rect width='4' height='2'/></svg>")
        .page;
  };
  const auto whole = page("width='40mm' height=' 20mm' viewBox='-1,2 80 40.0' preserveAspectRatio='xMinYMin slice'");
  ASSERT_TRUE(whole);
  EXPECT_EQ(whole->shown_width + whole->shown_height + whole->view_box + whole->aspect_ratio,
            "40mm 20mm-1,2 80 40.0xMinYMin slice");
  EXPECT_EQ(whole->x, -1);
  EXPECT_EQ(whole->y, 2);
  EXPECT_EQ(whole->width, 80);
  EXPECT_EQ(whole->height, 40);
  const auto shown = page("width='1in' height='50'");
  ASSERT_TRUE(shown);
  EXPECT_EQ(shown->width, 96);
  EXPECT_EQ(shown->height, 50);
  EXPECT_EQ(shown->view_box, "");
  for (const char* none : {"", "width='40'", "width='100%' height='100%'", "viewBox='0 0 1'", "width='0' height='4'"})
    EXPECT_FALSE(page(none)) << none;
  EXPECT_FALSE(read_file(R"({"type": "bezier", "degree": 1, "control_points": [[0, 0], [1, 1]]})").page);
}

}  // namespace
}  // namespace test_read_looks
