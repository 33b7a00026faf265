// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// What the reader of SVG says beside the curves: the fill rule, what is left out, and what is read otherwise.

#include "../support/curve_text.h"

namespace test_svg_left_out {
namespace {

using namespace bounding_arcs_test;
using CGAL::Bounding_arcs::Fill_rule;

constexpr Fill_rule NONZERO = Fill_rule::NONZERO, EVEN_ODD = Fill_rule::EVEN_ODD;

const std::string FRAME = "d='M0 0h9v9h-9z M2 2h5v5h-5z'";  // a square with another one in it
const std::string STAR = "d='M0 -9 5 7 -9 -3 9 -3 -5 7z'";

std::string path(const std::string& attributes) { return "<path " + attributes + "/>"; }

Fill_rule rule(const std::string& content) { return read_svg_file(content).rule; }

// The notes of a drawing that has a line beside.
std::string notes(const std::string& content, const Curve_file::Options& options = {}) {
  return Curve_file::text_of(read_svg_file("<line x2='1'/>" + content, options).notes);
}

TEST(SvgFillRule, IsThatOfTheShapes) {
  EXPECT_EQ(rule(path(FRAME)), NONZERO);
  EXPECT_EQ(rule(path(FRAME + " fill-rule='evenodd'")), EVEN_ODD);
  EXPECT_EQ(rule(path(FRAME + " fill-rule=' EvenOdd '")), EVEN_ODD);
  EXPECT_EQ(rule(path(FRAME + " style='fill:red; Fill-Rule : evenodd'")), EVEN_ODD);
  EXPECT_EQ(rule(path(FRAME + " fill-rule='evenodd' style='fill-rule:nonzero'")), NONZERO);
  EXPECT_EQ(rule(path(FRAME + " fill-rule='evenodd' style='fill-rule:odd'")), EVEN_ODD);
  EXPECT_EQ(rule(path(FRAME + " style='fill-rule:evenodd!important;fill-rule:nonzero'")), EVEN_ODD);
  // each is painted by itself, so that the inner one is no hole
  EXPECT_EQ(rule("<g fill-rule='evenodd'><circle r='3'/><circle r='1'/></g>"), NONZERO);
}

TEST(SvgFillRule, IsInherited) {
  EXPECT_EQ(rule("<g fill-rule='evenodd'><a>" + path(FRAME) + "</a></g>"), EVEN_ODD);
  EXPECT_EQ(rule("<g fill-rule='evenodd'>" + path(FRAME + " fill-rule='nonzero'") + "</g>"), NONZERO);
  EXPECT_EQ(rule("<g fill-rule='evenodd'>" + path(FRAME + " fill-rule='inherit'") + "</g>"), EVEN_ODD);
  EXPECT_EQ(rule("<g>" + path(FRAME + " fill-rule='evenodd' style='fill-rule:inherit'") + "</g>"), NONZERO);
  EXPECT_EQ(rule("<g fill-rule='evenodd'>" + path(FRAME + " style='fill-rule:initial'") + "</g>"), NONZERO);
  EXPECT_EQ(rule("<defs>" + path(FRAME + " id='p'") + "</defs><use href='#p' fill-rule='evenodd'/>"), EVEN_ODD);
  EXPECT_EQ(rule("<symbol id='s'>" + path(FRAME) + "</symbol><use href='#s' style='fill-rule:evenodd'/>"), EVEN_ODD);
  EXPECT_EQ(Curve_file::from_text(svg(path(FRAME), "fill-rule='evenodd'"), "f", "f").rule, EVEN_ODD);
}

TEST(SvgFillRule, IsThatOfMostShapesForWhichItTells) {
  const std::string odd = " fill-rule='evenodd'";
  const Curve_file frames = read_svg_file(path(FRAME) + path(FRAME + odd) + path(FRAME + odd));
  EXPECT_EQ(frames.rule, EVEN_ODD);
  EXPECT_EQ(Curve_file::text_of(frames.notes), "read all the same: 1 path: has fill-rule nonzero, read as evenodd");
  const Curve_file stars = read_svg_file(path(STAR) + path(STAR + odd));
  EXPECT_EQ(stars.rule, NONZERO);
  EXPECT_EQ(Curve_file::text_of(stars.notes), "read all the same: 1 path: has fill-rule evenodd, read as nonzero");
  const Curve_file one_tells = read_svg_file("<circle r='3'/><rect width='2' height='1'/>" + path(FRAME + odd));
  EXPECT_EQ(one_tells.rule, EVEN_ODD);
  EXPECT_TRUE(one_tells.notes.empty()) << "simple shapes are the same by both";
}

TEST(SvgFillRule, TellsOfShapesThatCrossThemselves) {
  const std::string odd_frame = path(FRAME + " fill-rule='evenodd'");
  for (const char* crossed : {"M0 -9 5 7 -9 -3 9 -3 -5 7z", "M0 0h4l-4 4h4z", "M0 0C20 10-11 10 9 0z",
                              "M5 0a5 5 0 0 1-10 0a5 5 0 0 1 10 0a5 5 0 0 1-10 0a5 5 0 0 1 10 0z"})
    EXPECT_NE(
        Curve_file::text_of(read_svg_file(odd_frame + odd_frame + path("d='" + std::string(crossed) + "'")).notes), "")
        << crossed;
  for (const char* simple : {"M0 0h4v4h-4z", "M0 0v4h4v-4z", "M0 0L4 1 0 2 1 1z", "M5 0A5 5 0 1 1 5-.1z",
                             "M0 0h9v9h-5v-3h3v-4h-5v5h-2z", "M0 0h0h4v4h-4z", "M0 0C9 9 9 9 9 0z", "M3 3h4"})
    EXPECT_EQ(Curve_file::text_of(read_svg_file(odd_frame + path("d='" + std::string(simple) + "'")).notes), "")
        << simple;
}

// What open subpaths of a drawing have inside.
std::vector<Curve_record::Filling> fillings(const std::string& content) {
  std::vector<Curve_record::Filling> result;
  for (const Curve_record& record : read_svg_file(content).curves) result.push_back(record.filling);
  return result;
}
constexpr auto NO_INSIDE = Curve_record::NO_INSIDE, CLOSED = Curve_record::CLOSED, UNKNOWN = Curve_record::UNKNOWN;
using Fillings = std::vector<Curve_record::Filling>;
const std::string OPEN = "d='M0 0h4v4'";

TEST(SvgFilling, IsThatOfTheShape) {
  EXPECT_EQ(fillings(path(OPEN)), Fillings{CLOSED});
  EXPECT_EQ(fillings(path(OPEN + " fill='none'")), Fillings{NO_INSIDE});
  EXPECT_EQ(fillings(path(OPEN + " fill=' None '")), Fillings{NO_INSIDE});
  EXPECT_EQ(fillings(path(OPEN + " fill='transparent'")), Fillings{NO_INSIDE});
  EXPECT_EQ(fillings(path(OPEN + " fill='url(#g)' style='stroke:none'")), Fillings{CLOSED});
  EXPECT_EQ(fillings(path(OPEN + " fill='none' style='fill:#fff'")), Fillings{CLOSED});
  EXPECT_EQ(fillings(path(OPEN + " fill='red' style='fill:none'")), Fillings{NO_INSIDE});
  EXPECT_EQ(fillings("<polyline points='0 0 4 0 4 4'/><path d='M0 0C1 1 2 1 3 0'/>"), (Fillings{CLOSED, CLOSED}));
  EXPECT_EQ(fillings(path("d='M0 0h4v4M9 9h4v4h-4zM0 9h1v1'")), (Fillings{CLOSED, NO_INSIDE, CLOSED}));
}

TEST(SvgFilling, IsInherited) {
  EXPECT_EQ(fillings("<g fill='none'><a>" + path(OPEN) + path(OPEN + " fill='red'") + "</a></g>" + path(OPEN)),
            (Fillings{NO_INSIDE, CLOSED, CLOSED}));
  EXPECT_EQ(
      fillings("<g style='fill:none'>" + path(OPEN + " fill='inherit'") + path(OPEN + " fill='initial'") + "</g>"),
      (Fillings{NO_INSIDE, CLOSED}));
  EXPECT_EQ(fillings("<defs>" + path(OPEN + " id='p'") + "</defs><use href='#p' fill='none'/><use href='#p'/>"),
            (Fillings{NO_INSIDE, CLOSED}));
  EXPECT_EQ(Curve_file::from_text(svg(path(OPEN), "fill='none'"), "f", "f").curves[0].filling, NO_INSIDE);
}

TEST(SvgFilling, IsNothingOfALine) {
  EXPECT_EQ(fillings("<line x2='4' y2='4'/>" + path("d='M0 0L4 4'") + path("d='M0 0L4 4M0 4L4 0'")),
            (Fillings{NO_INSIDE, NO_INSIDE, NO_INSIDE, NO_INSIDE}));
}

TEST(SvgFilling, IsUnknownWhereAStyleSheetTellsIt) {
  const std::string sheet = "<style>.a{fill:none}</style>";
  EXPECT_EQ(fillings(sheet + path(OPEN) + path(OPEN + " fill='none'") + path(OPEN + " style='fill:none'") +
                     "<g style='fill:red'>" + path(OPEN) + path(OPEN + " style='fill:red'") + "</g>"),
            (Fillings{UNKNOWN, UNKNOWN, NO_INSIDE, UNKNOWN, CLOSED}));
  EXPECT_EQ(fillings("<style>.a{fill-rule:evenodd;stroke:red}</style>" + path(OPEN)), Fillings{CLOSED});
  EXPECT_EQ(notes(sheet + path(OPEN)), "");
}

TEST(SvgFilling, ClosesByALine) {
  std::vector<Curve_record> records =
      read_svg_file(path(OPEN) + path(OPEN + " fill='none'") + path("d='M0 0h4v4z'") + path("d='M0 0h4v4L0 0'")).curves;
  EXPECT_EQ(close_filled(records), 1u);
  EXPECT_EQ(polygon(records[0]), (Points{{0, 0}, {4, 0}, {4, 4}, {0, 0}}));
  EXPECT_TRUE(records[0].closed);
  EXPECT_EQ(polygon(records[1]), (Points{{0, 0}, {4, 0}, {4, 4}}));
  EXPECT_EQ(records[2].beziers.size(), 3u);
  EXPECT_EQ(records[3].beziers.size(), 3u);
  EXPECT_EQ(close_filled(records), 0u);
}

TEST(SvgFillRule, TellsOfOpenSubpathsThatAreFilled) {
  const std::string nested = "d='M0 0h9v9h-9 M2 2h5v5h-5' fill-rule='evenodd'";
  EXPECT_EQ(rule(path(nested)), EVEN_ODD);
  EXPECT_EQ(rule(path(nested + " fill='none'")), NONZERO);
  EXPECT_EQ(rule(path("d='M0 -9 5 7 -9 -3 9 -3 -5 7' fill-rule='evenodd'")), EVEN_ODD);
  EXPECT_EQ(rule(path("d='M0 0h9v9h-9' fill-rule='evenodd'")), NONZERO);
  EXPECT_EQ(rule(path("d='M0 0L9 9M0 9L9 0' fill-rule='evenodd'")), NONZERO);
}

TEST(SvgLeftOut, IsCountedByKind) {
  EXPECT_EQ(notes(""), "");
  EXPECT_EQ(notes("<text>A</text><g><text>B<tspan>C</tspan></text></g><image href='x.png'/>"),
            "left out: 2 text: convert it to paths; 1 image: has no curve");
  EXPECT_EQ(notes("<foreignObject/><flowRoot/>"),
            "left out: 1 foreignObject: has no curve; 1 flowRoot: convert it to paths");
  EXPECT_EQ(notes("<defs><text id='t'>A</text></defs>"), "");
  EXPECT_EQ(notes("<defs><text id='t'>A</text></defs><use href='#t'/><use href='#t' x='5'/>"),
            "left out: 2 text: convert it to paths");
  EXPECT_EQ(notes("<title>x</title><desc/><metadata><text/></metadata><o:text xmlns:o='other'/><script/>"
                  "<g display='none'><text>A</text></g><text display='none'/><text visibility='hidden'/>"),
            "left out: 1 g: hidden");
}

TEST(SvgLeftOut, ShapesAndViewportsWithoutSize) {
  EXPECT_EQ(notes("<rect width='3'/><rect height='3'/><circle/><path d=''/><polygon/>"),
            "left out: 2 rect: draws nothing; 1 circle: draws nothing; 1 path: draws nothing; "
            "1 polygon: draws nothing");
  EXPECT_EQ(notes("<svg width='0'><line x2='3'/></svg>"), "left out: 1 svg: has no size");
}

TEST(SvgLeftOut, WhatIsHiddenUnlessAskedFor) {
  const std::string hidden = "<g style='display:none'><line x2='2'/><text>A</text></g><line x2='3' display='none'/>";
  EXPECT_EQ(notes(hidden), "left out: 1 g: hidden; 1 line: hidden");
  EXPECT_EQ(read_svg_file("<line x2='1'/>" + hidden, {true, false}).curves.size(), 3u);
  EXPECT_EQ(notes(hidden, {true, false}), "left out: 1 text: convert it to paths");
  const std::string unseen =
      "<g visibility='hidden'><line x2='2'/><line x2='3' visibility='visible'/></g>"
      "<line x2='4' style='visibility:collapse'/>";
  EXPECT_EQ(notes(unseen), "left out: 2 line: hidden");
  EXPECT_EQ(read_svg_file(unseen).curves.size(), 1u);
  EXPECT_EQ(read_svg_file(unseen, {true, false}).curves.size(), 3u);
  EXPECT_EQ(Curve_file::from_text(svg("<line x2='1'/>", "display='none'"), "f", "f", {true, false}).curves.size(), 1u);
  EXPECT_EQ(message_of([] { (void)read(svg("<line x2='1'/>", "display='none'")); }),
            "shape.json: line 1, column 2, <svg>: no curve in the drawing; left out: 1 svg: hidden");
}

TEST(SvgLeftOut, WhatIsWrongButNotTheDrawing) {
  EXPECT_EQ(notes("\n<path id='p' d='M0 0h1x'/>"),
            "left out: 1 path: cannot be drawn, line 2, column 2, <path id=\"p\">, attribute d, character 7: "
            "expected a path command, found \"x\"");
  EXPECT_EQ(notes("\n\n<rect width='-1'/>\n<rect width='1' height='x'/>"),
            "left out: 2 rect: cannot be drawn, the first: line 3, column 2, <rect>, attribute width, character 1: "
            "expected a size of at least 0, found -1");
  EXPECT_NE(notes("<g transform='spin(3)'><line x2='1'/><line x2='1'/></g>").find("1 g: cannot be drawn, line 1"),
            std::string::npos);
  EXPECT_NE(notes("<svg viewBox='0 0 0 1'><line x2='1'/></svg>").find("1 svg: cannot be drawn"), std::string::npos);
  const Curve_file file = read_svg_file("<path d='M0 0h1'/><path d='M0 0h'/><path d='M0 0h3'/>");
  ASSERT_EQ(file.curves.size(), 2u);
  EXPECT_EQ(file.curves[1].name, "path2") << "numbers count what is read";
}

TEST(SvgLeftOut, UsesThatHaveNoTarget) {
  const auto reason = [](const std::string& use) {
    const std::string text = notes(use), end = "<use>: ";
    return text.substr(text.find(end) + end.size());
  };
  EXPECT_EQ(reason("<use href='#nothing'/>"), "expected an element with the id \"nothing\", found none");
  EXPECT_EQ(reason("<use href='other.svg#a'/>"), "expected a reference into this file, found \"other.svg#a\"");
  EXPECT_EQ(reason("<use/>"), "expected a reference to an element, found none");
  EXPECT_EQ(reason("<g id='a'><use href='#a'/></g>"), "expected no use of an element within itself, found \"#a\"");
  EXPECT_EQ(read_svg_file("<g id='a'><use href='#b'/></g><g id='b'><line x2='1'/><use href='#a'/></g>").curves.size(),
            2u);
}

TEST(SvgLeftOut, IsToldWhereNothingIsLeft) {
  const std::string none = "shape.json: line 1, column 2, <svg>: no curve in the drawing";
  const auto message = [](const std::string& content) { return message_of([&] { (void)read_svg(content); }); };
  EXPECT_EQ(message(""), none);
  EXPECT_EQ(message("<text>A</text>"), none + "; left out: 1 text: convert it to paths");
  EXPECT_EQ(message("<path/><image/><path/>"), none + "; left out: 2 path: draws nothing; 1 image: has no curve");
  EXPECT_EQ(message("<text>A</text><use href='#a'/><circle r='big'/>"),
            "shape.json: line 1, column 57, <use>: expected an element with the id \"a\", found none");
}

TEST(SvgLeftOut, ClippingAndMarkersAreNotApplied) {
  const std::string read = "read all the same: ";
  EXPECT_EQ(notes("<line x2='1' clip-path='url(#c)'/><g style='clip-path:circle(3px)'/><g clip-path='none'/>"),
            read + "1 line: its clip-path cuts nothing off; 1 g: its clip-path cuts nothing off");
  EXPECT_EQ(notes("<line x2='1' mask='url(#m)'/>"), read + "1 line: its mask cuts nothing off");
  EXPECT_EQ(
      notes("<line x2='1' marker-end='url(#m)' marker-start='url(#m)'/><path d='M0 0h1' style='marker:url(#m)'/>"),
      read + "1 line: its markers are left out; 1 path: its markers are left out");
}

TEST(SvgLeftOut, PropertiesThatAreNotRead) {
  const std::string read = "read all the same: ";
  EXPECT_EQ(notes("<circle r='1' style='fill:red;cx:5px'/>"),
            read + "1 circle: geometry in its style attribute is not read, cx");
  EXPECT_EQ(notes("<g style='rotate:5deg'><line x2='1' style='stroke-width:3'/></g>"),
            read + "1 g: geometry in its style attribute is not read, rotate");
  EXPECT_EQ(notes("<line x2='1' transform='scale(2)' style='transform-box: fill-box'/>"),
            read + "1 line: its transform-box is taken for view-box, fill-box");
  EXPECT_EQ(notes("<line x2='1' style='transform-box: fill-box'/>"), "");
}

TEST(SvgLeftOut, StyleSheetsThatWouldMatter) {
  const std::string left_out = "left out: 1 style: style sheets are not read, ";
  EXPECT_EQ(notes("<style>.a{fill-rule:evenodd}</style>"), left_out + "fill-rule");
  EXPECT_EQ(
      notes("<defs><style><![CDATA[ .a { fill : red ; DISPLAY : none } .b{visibility:hidden;} ]]></style></defs>"),
      left_out + "display, visibility");
  EXPECT_EQ(notes("<style>/* a{display:none} */ *{stroke-width:3;fill:red} a:hover{stroke:x}</style>"), "");
  EXPECT_EQ(notes("<style>a{r:3}</style><style>b{mask:x}</style>"),
            "left out: 2 style: style sheets are not read, the first: r");
}

TEST(SvgLeftOut, TheSizeOfADrawingThatSaysNone) {
  const Curve_file file = Curve_file::from_text(svg("<line x2='10%'/>", "viewBox='0 0 0 0'"), "shape.svg", "shape");
  EXPECT_EQ(polygon(file.curves[0])[1], (Point{30, 0}));
  EXPECT_EQ(Curve_file::text_of(file.notes),
            "read all the same: 1 svg: per cent are of 300 by 150, line 1, column 2, <svg>, "
            "attribute viewBox: expected a width and a height above 0, found 0 and 0");
}

// An element that is read in vain counts as one that is read.
TEST(SvgLeftOut, TakesBoundedTime) {
  const std::string broken = "<defs><path id='p' d='M0 0" + repeated("h1", 100000) + "x'/></defs>";
  EXPECT_NE(message_of([&] {
              (void)read_svg(broken + repeated("<use href='#p'/>", 20));
            }).find("expected at most 1000000 elements and pieces added by use elements"),
            std::string::npos);
}

}  // namespace
}  // namespace test_svg_left_out
