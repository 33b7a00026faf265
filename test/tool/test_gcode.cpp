// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// G-code of offsets and arcs, run by an interpreter of its own and compared with the curves.

#include "cases.h"
#include "gcode_run.h"
#include "tool.h"

#include "toolpath/order_passes.h"
#include "toolpath/write_gcode.h"

#include <CGAL/Bounding_arcs_2/curve/Curve_file.h>
#include <CGAL/Bounding_arcs_2/query/closest_point.h>
#include <CGAL/Bounding_arcs_2/tree/Bounding_arc_tree_2.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <string>
#include <vector>

namespace test_gcode {
namespace {

using namespace bounding_arcs_test;
namespace ba = CGAL::Bounding_arcs;
namespace tool = bounding_arcs_tool;
using ba::Arc_2;
using ba::Xy;

double distance_from(const ba::Bounding_arc_tree_2& tree, const Xy<double>& p) {
  return ba::closest_point(tree, p)->distance.upper;
}
ba::Bounding_arc_tree_2 tree_of(const std::string& file) {
  return ba::Bounding_arc_tree_2(ba::drawing<double>(ba::read_curve_file(file).curves));
}
std::string text_of(const std::string& arguments) {
  const Run run = run_tool(arguments + " --format gcode 2> /dev/null");
  EXPECT_EQ(run.status, 0) << arguments;
  return run.output;
}
// All pieces of chains of a JSON result, by their length.
double length_of(const nlohmann::json& document, const std::string& list) {
  double length = 0;
  for (const auto& item : document.at(list))
    for (const auto& chain : list == "offsets" ? item.at("chains") : nlohmann::json::array({item}))
      for (const auto& p : chain.at("pieces")) {
        const auto &from = p.at("from"), &to = p.at("to");
        length += ba::length(Arc_2{{from[0], from[1]}, {to[0], to[1]}, p.value("bulge", 0.0)});
      }
  return length;
}
void expect_sound(const Gcode_run& run, double depth, double safe, double shortest) {
  EXPECT_EQ(run.refused, "");
  EXPECT_TRUE(run.has_ended);
  EXPECT_EQ(run.top, safe);
  for (const auto& pass : run.passes) {
    EXPECT_EQ(pass.front().z0, safe);
    EXPECT_EQ(pass.front().z1, -depth);
    for (std::size_t i = 1; i < pass.size(); ++i) {
      EXPECT_EQ(pass[i].z0, -depth);
      EXPECT_EQ(pass[i].z1, -depth);
      if (!pass[i].is_arc()) continue;
      EXPECT_LE(std::fabs(pass[i].turn), 3.15);
      EXPECT_GE(pass[i].length(), 0.9 * shortest);
    }
  }
}
double length_of(const Gcode_run& run) {
  double length = 0;
  for (const auto& pass : run.passes)
    for (const Gcode_step& step : pass) length += step.length();
  return length;
}

// The curves are some units large: as mm, and in each case ten times as large, which has fewer lines for arcs.
TEST(Gcode, OfOffsetsIsAsFarFromTheCurveAsItIsAsked) {
  std::mt19937_64 random(66);
  std::uniform_real_distribution<double> power(-3, -1);
  std::size_t arcs = 0, lines = 0;
  for (int i = 0; i < cases(200); ++i) {
    const std::string file = bundled(BUNDLED[random() % BUNDLED.size()].first);
    const double d = (random() % 2 == 0 ? 1 : -1) * std::pow(10, power(random)), eps = std::fabs(d) / 50;
    const int digits = 3 + static_cast<int>(random() % 4);
    const std::string asked =
        "offset " + file + " --distance=" + std::to_string(d) + " --eps " + std::to_string(eps + 1e-6);
    SCOPED_TRACE(asked + " --digits " + std::to_string(digits));
    const Gcode_run run =
        run_gcode(text_of(asked + " --feed 600 --depth 1.5 --shortest-arc 0.003 --digits " + std::to_string(digits)));
    expect_sound(run, 1.5, 5, 0.003);
    EXPECT_EQ(run.feed, 600);
    const ba::Bounding_arc_tree_2 tree = tree_of(file);
    const double bound = eps + 1e-6 + 3 * std::pow(10, -digits) + 1e-6;
    for (const auto& pass : run.passes)
      for (std::size_t k = 1; k < pass.size(); ++k) {
        ++(pass[k].is_arc() ? arcs : lines);
        for (const double share : {0.25, 0.5, 1.0})
          EXPECT_NEAR(distance_from(tree, pass[k].at(share)), std::fabs(d), bound);
      }
    const double length = length_of(json_of(asked), "offsets");
    EXPECT_NEAR(length_of(run), length, 0.01 * length);
    if (HasFailure()) return;
  }
  EXPECT_GT(arcs, lines / 4);
}

TEST(Gcode, OfArcsFollowsTheCurves) {
  for (const auto& [name, spirals] : BUNDLED) {
    SCOPED_TRACE(name);
    const std::string asked = "arcs --eps 1e-3 " + bundled(name);
    const Gcode_run run = run_gcode(text_of(asked + " --feed 100.5"));
    expect_sound(run, 0, 5, 0.01);
    EXPECT_EQ(run.feed, 100.5);
    ASSERT_EQ(run.passes.size(), 1u);
    EXPECT_EQ(run.titles.front(), "curve " + name);
    const ba::Bounding_arc_tree_2 tree = tree_of(bundled(name));
    for (const Gcode_step& step : run.passes.front())
      for (const double share : {0.5, 1.0}) EXPECT_LE(distance_from(tree, step.at(share)), 1e-3 + 3e-4);
    const double length = length_of(json_of(asked), "curves");
    EXPECT_NEAR(length_of(run), length, 0.01 * length);
  }
}

tool::Tool_pass circle(double x, double y, double r, const std::string& title = "circle") {
  return {title, {{{x - r, y}, {x + r, y}, 1}, {{x + r, y}, {x - r, y}, 1}}, -1};
}
std::vector<std::string> titles_of(const std::vector<tool::Tool_pass>& passes) {
  std::vector<std::string> titles;
  for (const tool::Tool_pass& pass : passes) titles.push_back(pass.title);
  return titles;
}

TEST(PassOrder, CutsWhatLiesInsideFirst) {
  // an inset series with an island that it goes round, and beside it a circle nearer to the tool
  const std::vector<tool::Tool_pass> passes{circle(10, 0, 5, "outer"),  circle(10, 0, 4, "inner"),
                                            circle(10, 0, 1, "island"), circle(10, 0, 2, "round island"),
                                            circle(1, 0, 1, "first"),   circle(30, 0, 1, "last")};
  EXPECT_EQ(titles_of(tool::inside_out(passes)),
            (std::vector<std::string>{"first", "island", "round island", "inner", "outer", "last"}));
  const auto around = tool::passes_around(passes);
  EXPECT_EQ(around[0], std::nullopt);
  EXPECT_EQ(around[1], 0u);
  EXPECT_EQ(around[2], 3u);
  EXPECT_EQ(around[3], 1u);
  EXPECT_EQ(around[4], std::nullopt);
}

TEST(PassOrder, KeepsTheWayRoundAndTurnsOpenOnes) {
  const tool::Tool_pass line{"line", {{{9, 0}, {5, 0}, 0}, {{5, 0}, {2, 0}, 0.5}}, -1};
  const std::vector<tool::Tool_pass> found = tool::inside_out({line, circle(11, 0, 1)});
  ASSERT_EQ(found.size(), 2u);
  EXPECT_EQ(found[0].from(), (Xy<double>{2, 0}));
  EXPECT_EQ(found[0].to(), (Xy<double>{9, 0}));
  EXPECT_EQ(found[0].pieces.front().bulge, -0.5);
  EXPECT_EQ(found[1].from(), (Xy<double>{10, 0}));
  EXPECT_EQ(found[1].pieces.front().bulge, 1);
}

TEST(PassOrder, TakesTheNearestNext) {
  // what is nearer by x alone is farther
  const auto found = titles_of(tool::inside_out(
      {circle(2, 30, 1, "high"), circle(9, 0, 1, "right"), circle(-6, 0, 1, "left"), circle(3, -40, 1, "low")}));
  EXPECT_EQ(found, (std::vector<std::string>{"left", "right", "high", "low"}));
}

TEST(PassOrder, SeesArcsNotChords) {
  // a point between a half circle and its chord, and one between the chord of a dent and the dent
  const tool::Tool_pass lens{"lens", {{{0, 0}, {4, 0}, 1}, {{4, 0}, {0, 0}, -0.5}}, -1};
  EXPECT_EQ(tool::passes_around({lens, circle(2, -1.5, 0.1)})[1], 0u);
  EXPECT_EQ(tool::passes_around({lens, circle(2, -0.5, 0.1)})[1], std::nullopt);
}

// What is written is read back: a text that was changed is refused.
class ReadBack : public testing::Test {
 protected:
  std::vector<tool::Tool_pass> passes_{circle(1, 1, 1), {"line", {{{5, 5}, {6, 5}, 0}}, -2}};
  tool::Gcode_setup setup_ = [] {
    tool::Gcode_setup setup;
    setup.feed = 100;
    return setup;
  }();
  tool::Gcode_program program_ = tool::gcode_program(passes_, setup_);

  void check(const std::string& from, const std::string& to) {
    std::string text = tool::gcode_text(program_, passes_, setup_);
    const std::size_t at = text.find(from);
    ASSERT_NE(at, std::string::npos) << from << " is not in\n" << text;
    text.replace(at, from.size(), to);
    tool::check_gcode(tool::read_gcode(text, setup_), program_, passes_, setup_);
  }
};

TEST_F(ReadBack, TakesWhatIsWritten) { EXPECT_NO_THROW(check("G3", "G3")); }
TEST_F(ReadBack, RefusesWhatDiffers) {
  for (const auto& [from, to] : std::vector<std::pair<std::string, std::string>>{{"G3 X2", "G2 X2"},
                                                                                 {"I1 J0", "I1 J0.001"},
                                                                                 {"X2 Y1", "X2 Y1.0004"},
                                                                                 {"G1 X6 Y5", "G0 X6 Y5"},
                                                                                 {"Z-1", "Z-1.1"},
                                                                                 {"Z5\n(line", "Z4\n(line"},
                                                                                 {"G0 X5 Y5", "G0 X5 Y6"},
                                                                                 {"G1 X6 Y5", "G1 X6 Y5.12345"},
                                                                                 {"G1 X6 Y5\n", ""}})
    EXPECT_THROW(check(from, to), std::invalid_argument) << from << " -> " << to;
}

TEST(GcodeMoves, BreaksArcsThatControllersWouldMiss) {
  tool::Gcode_setup setup;
  setup.feed = 100;
  setup.shortest_arc = 0.01;
  const auto arcs_of = [&](const Arc_2& arc) { return tool::gcode_program({{"arc", {arc}, -1}}, setup).arcs; };
  EXPECT_EQ(arcs_of({{0, 0}, {1, 0}, 0.1}), 1u);
  EXPECT_EQ(arcs_of({{0, 0}, {0.005, 0}, 0.9}), 0u);  // shorter than it is asked for
  EXPECT_EQ(arcs_of({{0, 0}, {100, 0}, 0.02}), 1u);
  EXPECT_EQ(arcs_of({{0, 0}, {100, 0}, 0.01}), 0u);  // a radius of 2500 mm with 4 digits has more than 24 bits
  EXPECT_EQ(arcs_of({{0, 0}, {1, 0}, 1e-5}), 0u);    // as good as a line
  setup.digits = 3;  // a small arc whose rounded center is on its other side would be most of a circle
  const Arc_2 small{{0.2, 0.1}, {1.9, 1.2}, 0.32};
  EXPECT_TRUE(std::isinf(tool::deviation(setup, {0, 0, 0}, {3, {2, 1, 0}, 2, -1}, small)));
  EXPECT_LE(tool::deviation(setup, {0, 0, 0}, {3, {2, 1, 0}, 0, 2}, small), tool::MOVE_ERROR);
  setup.digits = 1;
  for (int i = 0; i < 100; ++i) {  // all that is written is taken, whatever the digits
    const double angle = i * 0.0628;
    const std::vector<tool::Tool_pass> passes{
        {"arc", {{{3.33, 4.44}, {3.33 + 2 * std::cos(angle), 4.44 + 2 * std::sin(angle)}, 0.7}}, -1}};
    const tool::Gcode_program program = tool::gcode_program(passes, setup);
    const std::string text = tool::gcode_text(program, passes, setup);
    EXPECT_EQ(run_gcode(text).refused, "") << text;
    EXPECT_NO_THROW(tool::check_gcode(tool::read_gcode(text, setup), program, passes, setup)) << text;
  }
}

// Arcs of all sizes and bulges, from ones shorter than a unit of the last digit to ones of half a km.
TEST(GcodeMoves, AreTakenByControllersOfSinglePrecision) {
  std::mt19937_64 random(24);
  std::uniform_real_distribution<double> place(-500, 500), power(-5, 2.7), bulge_power(-6, 0), angle(0, 6.28);
  std::size_t arcs = 0;
  for (int i = 0; i < cases(20000); ++i) {
    tool::Gcode_setup setup;
    setup.feed = 100;
    setup.shortest_arc = i % 2 == 0 ? 0.01 : 1e-6;
    setup.digits = 2 + static_cast<int>(random() % 3);
    const Xy<double> from{place(random), place(random)};
    const double chord = std::pow(10, power(random)), turn = angle(random);
    const double bulge = (random() % 2 == 0 ? 1 : -1) * std::pow(10, bulge_power(random));
    const Xy<double> to{from.x + chord * std::cos(turn), from.y + chord * std::sin(turn)};
    const std::vector<tool::Tool_pass> passes{{"arc", {{from, to, bulge}}, -1}};
    const tool::Gcode_program program = tool::gcode_program(passes, setup);
    const std::string text = tool::gcode_text(program, passes, setup);
    const Gcode_run run = run_gcode(text);
    arcs += program.arcs;
    ASSERT_EQ(run.refused, "") << text;
    const Arc_2& arc = passes[0].pieces[0];
    for (const Gcode_step& step : run.passes.front())
      for (const double share : {0.3, 1.0})
        ASSERT_LE(std::fabs(ba::signed_distance(step.at(share), arc)), 3 * std::pow(10, -setup.digits)) << text;
    const double length = length_of(run);
    ASSERT_NEAR(length, ba::length(arc), 0.01 * length + 8 * std::pow(10, -setup.digits)) << text;
  }
  EXPECT_GT(arcs, 0u);
}

TEST(GcodeMoves, RefusesMoreDigitsThanDoublesHave) {
  tool::Gcode_setup setup;
  setup.digits = 9;
  EXPECT_THROW((void)tool::gcode_program({{"far", {{{1e9, 0}, {1e9, 1}, 0}}, -1}}, setup), std::invalid_argument);
}

}  // namespace
}  // namespace test_gcode
