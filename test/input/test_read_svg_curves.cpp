// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The curves that SVG files draw: path commands, arcs, shapes, transforms, units and names.

#include "../support/curve_text.h"

#include <algorithm>
#include <cmath>
#include <random>
#include <sstream>

namespace test_read_svg_curves {
namespace {

using namespace bounding_arcs_test;

constexpr unsigned SEED = 20262;

TEST(ReadSvg, TakesEveryFileOfTheTestData) {
  const std::pair<const char*, std::size_t> files[] = {
      {"02_chess_knight", 13}, {"05_playing_cards_tango", 10}, {"09_padania_flag", 9}, {"displayed", 7},
      {"entities", 7},         {"every_path_command", 5},      {"namespaces", 5},      {"nested_transforms", 12},
      {"shapes_and_use", 9},   {"transform_origin", 24},       {"units", 13},          {"uses", 18},
      {"viewports", 24}};
  for (const auto& [name, records] : files) {
    const auto read_records =
        read_curve_file((fs::path(BOUNDING_ARCS_TEST_DATA) / "svg" / name).string() + ".svg").curves;
    EXPECT_EQ(read_records.size(), records) << name;
    for (const Curve_record& record : read_records) expect_joined(record);
  }
}

TEST(ReadSvg, DrawsLinesWithImplicitRepetition) {
  const auto records = read_path("M10 10 20,10H30V20h-5v5l-5-5z m1 1 2 0 0 2");
  ASSERT_EQ(records.size(), 2u);
  EXPECT_EQ(records[0].name, "path1.1");
  EXPECT_EQ(polygon(records[0]),
            (Points{{10, 10}, {20, 10}, {30, 10}, {30, 20}, {25, 20}, {25, 25}, {20, 20}, {10, 10}}));
  EXPECT_TRUE(records[0].closed);
  EXPECT_EQ(polygon(records[1]), (Points{{11, 11}, {13, 11}, {13, 13}}));
  EXPECT_FALSE(records[1].closed);
  EXPECT_EQ(polygon(read_path("M0 0h1 2 3v1 2")[0]), (Points{{0, 0}, {1, 0}, {3, 0}, {6, 0}, {6, 1}, {6, 3}}));
}

TEST(ReadSvg, MirrorsControlPointsOnlyAfterTheirOwnKind) {
  EXPECT_EQ(polygon(read_path("M0 0C1 1 2 1 3 0S5-1 6 0s2 2 3 0")[0]),
            (Points{{0, 0}, {1, 1}, {2, 1}, {3, 0}, {4, -1}, {5, -1}, {6, 0}, {7, 1}, {8, 2}, {9, 0}}));
  EXPECT_EQ(polygon(read_path("M0 0Q1 2 2 0T4 0t2 0")[0]),
            (Points{{0, 0}, {1, 2}, {2, 0}, {3, -2}, {4, 0}, {5, 2}, {6, 0}}));
  EXPECT_EQ(polygon(read_path("M0 0Q1 2 2 0S4 1 5 0")[0]), (Points{{0, 0}, {1, 2}, {2, 0}, {2, 0}, {4, 1}, {5, 0}}));
  EXPECT_EQ(polygon(read_path("M0 0L1 1T2 0")[0]), (Points{{0, 0}, {1, 1}, {1, 1}, {2, 0}}));
  EXPECT_EQ(polygon(read_path("M0 0Q1 2 2 0H3T4 0")[0]), (Points{{0, 0}, {1, 2}, {2, 0}, {3, 0}, {3, 0}, {4, 0}}));
}

TEST(ReadSvg, ClosesOnlyWhatIsOpen) {
  EXPECT_EQ(read_path("M0 0L1 0 1 1 0 0z")[0].beziers.size(), 3u);
  EXPECT_EQ(read_path("M0 0L1 0 1 1z")[0].beziers.size(), 3u);
  EXPECT_EQ(read_path("M5 5zM0 0zzL1 0z").size(), 1u);
  EXPECT_EQ(polygon(read_path("M0 0L1 0zL0 1")[1]), (Points{{0, 0}, {0, 1}}));
}

TEST(ReadSvg, LeavesOutPiecesThatArePoints) {
  EXPECT_EQ(polygon(read_path("M0 0L0 0 4 0C4 0 4 0 4 0L4 4 4 4z")[0]), (Points{{0, 0}, {4, 0}, {4, 4}, {0, 0}}));
  EXPECT_EQ(polygon(read_path("M1 1L1 1 1 1")[0]), (Points{{1, 1}, {1, 1}}));  // of a dot one is left
  EXPECT_EQ(polygon(read_path("M1 1L1 1 1 1m1 1h1")[1]), (Points{{2, 2}, {3, 2}}));
}

TEST(ReadSvg, ReadsNumbersWithoutSpacesBetween) {
  EXPECT_EQ(polygon(read_path("M.5.5L-1-.5+2e1,1E-1")[0]), (Points{{0.5, 0.5}, {-1, -0.5}, {20, 0.1}}));
  EXPECT_EQ(polygon(read_path("M0 0L0." + repeated("0", 400) + "1 1e-999")[0])[1], (Point{0, 0}));
  const auto arcs = read_path("M0 0a.5.5 0 0 1 .5-.5a.5.5 0 01.5.5");
  EXPECT_EQ(arcs[0].beziers.front().control_points().back(), (Point{0.5, -0.5}));
  EXPECT_EQ(arcs[0].beziers.back().control_points().back(), (Point{1, 0}));
}

// The center of an arc by the formulas of the SVG standard (appendix F.6.5), as an oracle: the arc is drawn without it.
struct Ellipse {
  double cx, cy, rx, ry, angle;
  // 0 on the ellipse.
  double residual(const Point& p) const {
    const double x = std::cos(angle) * (p.x - cx) + std::sin(angle) * (p.y - cy);
    const double y = -std::sin(angle) * (p.x - cx) + std::cos(angle) * (p.y - cy);
    return std::hypot(x / rx, y / ry) - 1;
  }
};

Ellipse standard_ellipse(Point from, Point to, double rx, double ry, double angle, bool large, bool sweep) {
  const double c = std::cos(angle), s = std::sin(angle);
  const double x = c * (from.x - to.x) / 2 + s * (from.y - to.y) / 2,
               y = -s * (from.x - to.x) / 2 + c * (from.y - to.y) / 2;
  const double scale = std::max(1.0, std::hypot(x / rx, y / ry));
  rx *= scale, ry *= scale;
  const double q = x * x / (rx * rx) + y * y / (ry * ry);
  const double k = (large == sweep ? -1 : 1) * std::sqrt(std::max(0.0, (1 - q) / q));
  const double u = k * rx * y / ry, v = -k * ry * x / rx;
  return {c * u - s * v + (from.x + to.x) / 2, s * u + c * v + (from.y + to.y) / 2, rx, ry, angle};
}

TEST(ReadSvg, DrawsArcsOnTheStandardEllipseTheRightWayRound) {
  std::mt19937 random(SEED);
  std::uniform_real_distribution<double> unit(-1, 1);
  for (int round = 0; round < 400; ++round) {
    const Point to{unit(random), unit(random)};
    const double rx = 0.1 + std::abs(unit(random)), ry = 0.1 + std::abs(unit(random)), degrees = 400 * unit(random);
    const bool large = round % 2 == 0, sweep = round % 4 < 2;
    std::ostringstream data;
    data.precision(17);
    data << "M0 0A" << rx << ' ' << ry << ' ' << degrees << ' ' << large << sweep << to.x << ' ' << to.y;
    SCOPED_TRACE("seed " + std::to_string(SEED) + ": " + data.str());
    const auto records = read_path(data.str());
    const Ellipse ellipse = standard_ellipse({0, 0}, to, rx, ry, degrees * 3.14159265358979323846 / 180, large, sweep);
    double turned = 0;  // the angle about the center, in the circle that the ellipse is the image of
    Point before{0, 0};
    const auto angle = [&](const Point& p) {
      const double x = std::cos(ellipse.angle) * (p.x - ellipse.cx) + std::sin(ellipse.angle) * (p.y - ellipse.cy);
      const double y = -std::sin(ellipse.angle) * (p.x - ellipse.cx) + std::cos(ellipse.angle) * (p.y - ellipse.cy);
      return std::atan2(y / ellipse.ry, x / ellipse.rx);
    };
    for (const Bezier& piece : records[0].beziers)
      for (int i = 1; i <= 8; ++i) {
        const Point p = piece.point(i / 8.0);
        EXPECT_NEAR(ellipse.residual(p), 0, 1e-7);
        turned += std::remainder(angle(p) - angle(before), 2 * 3.14159265358979323846);
        before = p;
      }
    EXPECT_EQ(before, to);
    EXPECT_EQ(turned > 0, sweep);
    const bool scaled = ellipse.rx > rx;
    EXPECT_TRUE(scaled || (std::abs(turned) > 3.14159) == large) << turned;
    EXPECT_LE(std::abs(turned) / static_cast<double>(records[0].beziers.size()), 1.5708);
  }
}

TEST(ReadSvg, DrawsFlatArcsAccurately) {
  const auto piece = read_path("M0 0A1e9 1e9 0 0 0 2 0")[0].beziers.at(0);
  EXPECT_NEAR(piece.point(0.5).y, 0.5e-9, 1e-24);
}

TEST(ReadSvg, CutsHalfACircleInTwo) {
  const auto records = read_path("M0 0A5 5 0 0 1 10 0");
  ASSERT_EQ(records[0].beziers.size(), 2u);
  EXPECT_NEAR(records[0].beziers[0].control_points()[2].y, -5, 1e-14);
  EXPECT_EQ(records[0].degree, 2);
}

TEST(ReadSvg, DrawsDegenerateArcsAsTheStandardSays) {
  EXPECT_EQ(polygon(read_path("M0 0A0 5 0 0 1 10 0")[0]), (Points{{0, 0}, {10, 0}}));
  EXPECT_EQ(read_path("M0 0A5 5 0 0 1 0 0L1 1")[0].beziers.size(), 1u);
  EXPECT_NEAR(read_path("M0 0A1 1 0 0 1 10 0")[0].beziers[0].control_points()[2].y, -5, 1e-14);
}

TEST(ReadSvg, DrawsBasicShapes) {
  const auto records =
      read_curve_file((fs::path(BOUNDING_ARCS_TEST_DATA) / "svg" / "shapes_and_use.svg").string()).curves;
  const auto named = [&](const std::string& name) {
    for (const Curve_record& record : records)
      if (record.name == name) return record;
    ADD_FAILURE() << "no " << name;
    return records.front();
  };
  const double y = 96 / 2.54;
  EXPECT_EQ(polygon(named("sharp")), (Points{{96, y}, {116, y}, {116, y + 10}, {96, y + 10}, {96, y}}));
  EXPECT_EQ(named("round").beziers.size(), 8u);
  EXPECT_EQ(named("oval").beziers.size(), 4u);
  EXPECT_NEAR(named("oval").beziers[0].point(0.5).x, 10 + 3 * std::sqrt(0.5), 1e-14);
  EXPECT_NEAR(named("oval").beziers[0].point(0.5).y, 20 + 4 * std::sqrt(0.5), 1e-14);
  EXPECT_EQ(polygon(named("open")), (Points{{0, 0}, {1, 0}, {1, 1}}));
  EXPECT_EQ(polygon(named("loop")), (Points{{0, 0}, {1, 0}, {1, 1}, {0, 0}}));
  EXPECT_EQ(polygon(named("turned")), (Points{{10, 22}, {10, 24}}));
  EXPECT_EQ(polygon(named("dot"))[0], (Point{6, 6}));
  EXPECT_EQ(polygon(named("line2")), (Points{{100, 50}, {120, 70}}));
  EXPECT_EQ(polygon(named("nested")), (Points{{50, 50}, {60, 55}}));
}

TEST(ReadSvg, RoundsARectAsFarAsItGoes) {
  for (const char* rect :
       {"<rect x='.1' y='.7' width='.6' height='.1' rx='9'/>", "<rect x='.1' y='.2' width='.2' height='.4' rx='9'/>"}) {
    const auto records = read_svg(rect);
    EXPECT_EQ(records[0].beziers.size(), 4u) << rect;
    expect_joined(records[0]);
  }
}

TEST(ReadSvg, FitsAViewboxIntoItsViewport) {
  const auto end = [](const std::string& ratio) {
    return polygon(read_svg("<svg width='40' height='20' viewBox='0 0 10 10' preserveAspectRatio='" + ratio +
                            "'><line x2='10' y2='10'/></svg>")[0]);
  };
  EXPECT_EQ(end("xMidYMid"), (Points{{10, 0}, {30, 20}}));
  EXPECT_EQ(end("xMinYMax meet"), (Points{{0, 0}, {20, 20}}));
  EXPECT_EQ(end("xMaxYMin meet"), (Points{{20, 0}, {40, 20}}));
  EXPECT_EQ(end("xMidYMid slice"), (Points{{0, -10}, {40, 30}}));
  EXPECT_EQ(end("xMidYMin slice"), (Points{{0, 0}, {40, 40}}));
  EXPECT_EQ(end("none"), (Points{{0, 0}, {40, 20}}));
  EXPECT_EQ(end(" defer xMinYMin\nmeet "), (Points{{0, 0}, {20, 20}}));
  for (const char* invalid : {"xMin", "xminYMin", "xMinYMin meet x", "xMinYMin fill", "slice", "xMinYMinslice", "1"})
    EXPECT_EQ(end(invalid), (Points{{10, 0}, {30, 20}})) << invalid;
}

TEST(ReadSvg, AppliesEveryTransformInOrder) {
  const auto image = [](const std::string& transform) {
    return polygon(read_svg("<line x1='1' y1='2' x2='0' y2='0' transform='" + transform + "'/>")[0])[0];
  };
  EXPECT_EQ(image("matrix(1 2,3 4 5,6)"), (Point{12, 16}));
  EXPECT_EQ(image("matrix(1 2 3 4 5 6) matrix(7 8 9 10 11 12)"), (Point{161, 238}));
  EXPECT_EQ(image("translate(3)"), (Point{4, 2}));
  EXPECT_EQ(image("scale(2)"), (Point{2, 4}));
  EXPECT_EQ(image("scale(2, 3)"), (Point{2, 6}));
  EXPECT_EQ(image("rotate(-450)"), (Point{2, -1}));
  EXPECT_EQ(image("rotate(180 1 0)"), (Point{1, -2}));
  EXPECT_NEAR(image("skewX(45)").x, 3, 1e-15);
  EXPECT_NEAR(image("skewY(45)").y, 3, 1e-15);
  EXPECT_EQ(image("translate(1,1)scale(2) , rotate(90)"), (Point{-3, 3}));
  EXPECT_NEAR(image("rotate(30)").x, std::cos(std::acos(-1) / 6) - 1, 1e-15);
}

// Where the points (0, 0) and (1, 0) come to lie.
Points unit_line(const std::string& attributes) {
  return polygon(read(svg("<line x2='1' " + attributes + "/>", "viewBox='-7 -9 40 20'"))[0]);
}

TEST(ReadSvg, TurnsAboutTheOriginOfATransform) {
  const auto turned = [](const std::string& origin) { return unit_line("transform='scale(-1)' " + origin)[0]; };
  const auto at = [&](const std::string& origin) { return turned("transform-origin='" + origin + "'"); };
  EXPECT_EQ(at("3 4"), (Point{6, 8}));
  EXPECT_EQ(at("1in"), (Point{192, 20}));
  EXPECT_EQ(at("25% 3px"), (Point{20, 6}));
  EXPECT_EQ(at(" center "), (Point{40, 20}));
  EXPECT_EQ(at("top"), (Point{40, 0}));
  EXPECT_EQ(at("bottom 10%"), (Point{8, 40}));
  EXPECT_EQ(at("center RIGHT"), (Point{80, 20}));
  EXPECT_EQ(at("left center 5px"), (Point{0, 20}));
  EXPECT_EQ(turned("style='transform-origin: 3px 0' transform-origin='8 8'"), (Point{6, 0}));
  EXPECT_EQ(unit_line("transform-origin='3 4'")[0], (Point{0, 0}));
  EXPECT_EQ(polygon(read_svg("<g transform='scale(-1)' transform-origin='3 4'><line x2='1'/></g>")[0])[0],
            (Point{6, 8}));
}

TEST(ReadSvg, ReadsTransformsInStyleAttributes) {
  const auto ends = [](const std::string& transform) { return unit_line("style='transform:" + transform + "'"); };
  EXPECT_EQ(ends("matrix(1, 2, 3, 4, 5, 6)"), (Points{{5, 6}, {6, 8}}));
  EXPECT_EQ(ends("translate(3pt, 1%)"), (Points{{4, 0.2}, {5, 0.2}}));
  EXPECT_EQ(ends("translate( 10% )"), (Points{{4, 0}, {5, 0}}));
  EXPECT_EQ(ends("translateX(1px)translateY(2px) scale(3)"), (Points{{1, 2}, {4, 2}}));
  EXPECT_EQ(ends("scaleX(50%) translate(1px, 1px)"), (Points{{0.5, 1}, {1, 1}}));
  EXPECT_EQ(ends("scaleY(2) translate(0, 1px)"), (Points{{0, 2}, {1, 2}}));
  for (const char* quarter : {"rotate(90deg)", "rotate(100grad)", "rotate(.25turn)", "ROTATE(-270DEG)"})
    EXPECT_EQ(ends(quarter), (Points{{0, 0}, {0, 1}})) << quarter;
  EXPECT_NEAR(ends("rotate(1rad)")[1].x, std::cos(1.0), 1e-15);
  EXPECT_NEAR(ends("skewY(45deg)")[1].y, 1, 1e-15);
  EXPECT_NEAR(ends("skewx(45deg) translate(0, 1px)")[0].x, 1, 1e-15);
  EXPECT_NEAR(ends("skew(0, 45deg)")[1].y, 1, 1e-15);
  EXPECT_EQ(ends("none; fill: red"), (Points{{0, 0}, {1, 0}}));
  EXPECT_EQ(unit_line("style='transform: scale(2)' transform='scale(5)'")[1], (Point{2, 0}));
}

TEST(ReadSvg, ReportsBadTransformsInStyleAttributes) {
  const std::pair<const char*, const char*> transforms[] = {
      {"rotate(90)", "character 10: expected a unit (deg, grad, rad or turn), found \")\""},
      {"translate(3)", "character 12: expected a unit, such as px, found \")\""},
      {"translate(3px 4px)", "character 15: expected \",\", found \"4px)\""},
      {"rotate3d(1, 1, 1, 45deg)", "character 7: expected \"(\", found \"3d(1\""},
      {"perspective(3px)", "character 1: expected a transform function of the plane, found \"perspective(3px)\""},
      {"scale(1, 2, 3)", "character 11: expected \")\", found \",\""},
      {"scale", "character 6: expected \"(\", found the end"}};
  for (const auto& [transform, reason] : transforms)
    EXPECT_NE(message_of([&, t = std::string(transform)] {
                unit_line("style='transform:" + t + "'");
              }).find("attribute transform in style, " + std::string(reason)),
              std::string::npos)
        << transform;
  for (const char* origin : {"left right", "top 3 bottom", "1 2 3 4", "1 2px 3furlongs x", "3lightyears", "top bottom"})
    EXPECT_NE(message_of([&] {
                unit_line("transform='scale(2)' transform-origin='" + std::string(origin) + "'");
              }).find("attribute transform-origin"),
              std::string::npos)
        << origin;
  EXPECT_NE(message_of([] { unit_line("transform='scale(2)' style='transform-origin:3 4'"); }).find("such as px"),
            std::string::npos);
}

TEST(ReadSvg, KnowsUnits) {
  const auto x = [](const std::string& length) {
    return polygon(read(svg("<line x1='" + length + "' x2='0'/>", "width='50' height='20'"))[0])[0].x;
  };
  for (const auto& [length, units] : std::vector<std::pair<std::string, double>>{{"3", 3},
                                                                                 {"3px", 3},
                                                                                 {"3pt", 4},
                                                                                 {"1pc", 16},
                                                                                 {"25.4mm", 96},
                                                                                 {"2.54cm", 96},
                                                                                 {"1in", 96},
                                                                                 {"101.6q", 96},
                                                                                 {"1em", 16},
                                                                                 {"10%", 5},
                                                                                 {" -1IN ", -96}})
    EXPECT_DOUBLE_EQ(x(length), units) << length;
}

TEST(ReadSvg, TakesTheFirstSupportedChoiceOfASwitch) {
  const auto records = read_svg(
      "<switch><g requiredExtensions='x'><line id='a' x2='1'/></g><line id='b' x2='1'/><line id='c' x2='1'/></switch>");
  ASSERT_EQ(records.size(), 1u);
  EXPECT_EQ(records[0].name, "b");
}

TEST(ReadSvg, LeavesOutWhatAsksForExtensionsOrOtherLanguages) {
  const auto count = [](const std::string& attribute) {
    return read_svg("<line x2='1'/><g " + attribute + "><line x2='2'/></g>").size();
  };
  EXPECT_EQ(count("requiredExtensions='x'"), 1u);
  EXPECT_EQ(count("systemLanguage='de, fr'"), 1u);
  EXPECT_EQ(count("systemLanguage=''"), 1u);
  EXPECT_EQ(count("systemLanguage='de, en-GB'"), 2u);
  EXPECT_EQ(count("systemLanguage='EN'"), 2u);
}

TEST(ReadSvg, TakesTheLastDisplayOfAStyleBeforeTheAttribute) {
  const auto is_read = [](const std::string& attributes) {
    return read_svg("<line x2='1'/><line x2='2' " + attributes + "/>").size() == 2;
  };
  EXPECT_FALSE(is_read("display=' none '"));
  EXPECT_TRUE(is_read("display='none' style='display:inline'"));
  EXPECT_FALSE(is_read("display='inline' style='fill:red; DISPLAY : None'"));
  EXPECT_TRUE(is_read("style='display:none;display:block'"));
  EXPECT_FALSE(is_read("style='display:none ! important;display:block'"));
  EXPECT_TRUE(is_read("style='display:none!important;display:block!important'"));
  EXPECT_TRUE(is_read("style='/*display:none*/'"));
  EXPECT_TRUE(is_read("style='/*;display:none'"));
  EXPECT_FALSE(is_read("style='/**/display:/*in*/none/*line'"));
  EXPECT_TRUE(is_read("style='-x-display:none' display='block'"));
  EXPECT_TRUE(is_read("style='fill:url(a;display:none;b)'"));
  EXPECT_TRUE(is_read("style='font:\";display:none;\"'"));
}

TEST(ReadSvg, TellsElementsByTheirNamespaces) {
  const std::string uri = "'http://www.w3.org/2000/svg'";
  const auto size = [](const std::string& text) { return read(text).size(); };
  EXPECT_EQ(size("<s:svg xmlns:s=" + uri + "><s:line x2='1'/><line x2='2'/></s:svg>"), 2u);
  EXPECT_EQ(size("<s:svg xmlns:s=" + uri + " xmlns='x'><s:line x2='1'/><line x2='2'/></s:svg>"), 1u);
  EXPECT_EQ(size("<svg xmlns=" + uri + "><g xmlns='x'><path/></g><g><t:g xmlns:t=" + uri +
                 "><t:line x2='1'/></t:g></g><line x2='2'/><t:line x2='3'/></svg>"),
            2u);
  EXPECT_EQ(size("<svg:svg><svg:line x2='1'/><line x2='2'/></svg:svg>"), 2u);
  EXPECT_EQ(size("<svg xmlns='&ns_svg;' xmlns:xlink='&ns_xlink;'><line id='a' x2='1'/><use xlink:href='#a'/></svg>"),
            2u);
  EXPECT_EQ(size("<svg xmlns:l='http://www.w3.org/1999/xlink'><line id='a' x2='1'/><use l:href='#a'/></svg>"), 2u);
  EXPECT_EQ(size("<svg xmlns:xlink='x'><line id='a' x2='1'/><use xlink:href='#a'/></svg>"), 2u);
  EXPECT_EQ(message_of([&] { size("<svg xmlns='x'/>"); }),
            "shape.json: line 1, column 2, <an element of another namespace>: expected the root element svg, found "
            "another one");
  EXPECT_EQ(
      message_of([&] { size("<svg xmlns=" + uri + ">\n<s:g xmlns:s=" + uri + "><s:circle r='-1'/></s:g></svg>"); }),
      "shape.json: line 2, column 44, <circle>, attribute r, character 1: expected a size of at least 0, found -1");
}

TEST(ReadSvg, DrawsNothingInAViewportWithoutSize) {
  EXPECT_EQ(read_svg("<line x2='1'/><svg width='0' viewBox='0 0 1 1'><line x2='2'/></svg>").size(), 1u);
  EXPECT_EQ(read_svg("<line x2='1'/><svg height='0%'><line x2='2'/></svg>").size(), 1u);
  EXPECT_EQ(read_svg("<symbol id='s'><line x2='1'/></symbol><use href='#s' x='5'/><use href='#s' width='0'/>").size(),
            1u);
}

TEST(ReadSvg, MakesNamesValidUtf8) {
  EXPECT_EQ(read_svg("<line id='a\xFF\xFE"
                     "b' x2='1'/>")[0]
                .name,
            "a\xEF\xBF\xBD"
            "b");
  EXPECT_EQ(read("<?xml version='1.0' encoding='ISO-8859-1'?>" + svg("<line id='\xE9' x2='1'/>"))[0].name, "\xC3\xA9");
}

TEST(ReadSvg, KeepsEndsTogetherUnderAnyTransform) {
  for (const Curve_record& record : read_svg(
           "<g transform='rotate(33) skewX(7) scale(1e-3 1e5)'><path d='M.1.2c.3.1.7.9.2.4a3 2 20 1 1-.3.1q1 1 2 .1z"
           "m.1.1l1 1 2 .1z'/><circle cx='-.1' r='.3'/><rect width='.3' height='.7' rx='.1'/></g>"))
    expect_joined(record);
}

}  // namespace
}  // namespace test_read_svg_curves
