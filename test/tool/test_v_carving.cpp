// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// V-carving as G-code, run by an interpreter of its own: the bit touches the curves all along, and is nowhere deeper.

#include "cases.h"
#include "gcode_run.h"
#include "tool.h"

#include "toolpath/order_passes.h"

#include <CGAL/Bounding_arcs_2/curve/Curve_file.h>
#include <CGAL/Bounding_arcs_2/query/closest_point.h>
#include <CGAL/Bounding_arcs_2/tree/Bounding_arc_tree_2.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <string>
#include <utility>
#include <vector>

namespace test_v_carving {
namespace {

using namespace bounding_arcs_test;
namespace ba = CGAL::Bounding_arcs;
namespace tool = bounding_arcs_tool;
using ba::Xy;
using nlohmann::json;

constexpr double HALF_DEGREE = 3.14159265358979323846 / 360;

// How long the axis is where discs are no larger.
double length_within(const json& axis, double largest) {
  double length = 0;
  for (const json& edge : axis.at("edges")) {
    const json& line = edge.at("polyline");
    for (std::size_t i = 1; i < line.size(); ++i) {
      const auto at = [&](std::size_t k, std::size_t c) { return line[k][c].get<double>(); };
      const double whole = std::hypot(at(i, 0) - at(i - 1, 0), at(i, 1) - at(i - 1, 1));
      const double low = (std::min)(at(i, 2), at(i - 1, 2)), high = (std::max)(at(i, 2), at(i - 1, 2));
      if (high <= largest) length += whole;
      else if (low <= largest) length += whole * (largest - low) / (high - low);
    }
  }
  return length;
}

TEST(VCarving, TouchesTheCurvesAllAlong) {
  std::mt19937_64 random(60);
  std::uniform_real_distribution<double> angle(20, 150), power(-2.5, -1);
  std::size_t pockets = 0, branches = 0;
  for (int i = 0; i < cases(24); ++i) {
    const std::string file = bundled(BUNDLED[random() % BUNDLED.size()].first);
    const double bit = angle(random), steep = 1 / std::tan(bit * HALF_DEGREE), eps = 2e-4;
    const double most = std::pow(10, power(random)) * (std::max)(steep, 0.3);
    const std::string asked = "medial-axis " + file + " --eps " + std::to_string(eps);
    const std::string bounds = " --v-bit " + std::to_string(bit) + " --max-depth " + std::to_string(most);
    SCOPED_TRACE(asked + bounds);
    const auto carved = run_tool(asked + bounds + " --format gcode --feed 300 --digits 6 2> /dev/null");
    ASSERT_EQ(carved.status, 0);
    const Gcode_run run = run_gcode(carved.output);
    EXPECT_EQ(run.refused, "");
    const ba::Bounding_arc_tree_2 tree(ba::drawing<double>(ba::read_curve_file(file).curves));
    // the command line has six digits of angle and depth
    const double room = eps + 1e-5 * (1 + steep), radius = most / steep;
    double carved_length = 0;
    for (std::size_t k = 0; k < run.passes.size(); ++k) {
      const bool is_pocket = run.titles[k] == "pocket";
      ++(is_pocket ? pockets : branches);
      for (std::size_t n = 0; n < run.passes[k].size(); ++n) {
        const Gcode_step& step = run.passes[k][n];
        if (!is_pocket && n > 0) carved_length += step.length();
        for (const double share : {0.5, 1.0}) {
          if (n == 0 && share < 1) continue;  // the way down
          const double z = step.z0 + share * (step.z1 - step.z0);
          EXPECT_LE(z, 0);
          EXPECT_GE(z, -most - 1e-6);
          EXPECT_TRUE(!is_pocket || std::fabs(z + most) < 1e-6);
          const double distance = ba::closest_point(tree, step.at(share))->distance.upper;
          EXPECT_NEAR(distance * steep, -z, room);
        }
      }
    }
    const double length = length_within(json_of(asked), radius);
    EXPECT_NEAR(carved_length, length, 0.01 * length + 1e-3);
    if (HasFailure()) return;
  }
  EXPECT_GT(pockets, 0u);
  EXPECT_GT(branches, 0u);
}

TEST(PassOrder, CutsGroupByGroupTheNearestNext) {
  const auto line = [](const char* title, double x0, double x1) {
    return tool::Tool_pass{title, {{{x0, 0}, {x1, 0}, 0}}, 0, {0, -1}};
  };
  // the second group is nearer to the tool; in it the trunk is first, then what starts nearest
  const auto found = tool::group_by_group({line("far trunk", 20, 30), line("far branch", 21, 22), line("trunk", 2, 9),
                                           line("branch", 3, 2.5), line("twig", 8, 8.5)},
                                          {0, 0, 1, 1, 1});
  std::vector<std::string> titles;
  for (const tool::Tool_pass& pass : found) titles.push_back(pass.title);
  EXPECT_EQ(titles, (std::vector<std::string>{"trunk", "twig", "branch", "far trunk", "far branch"}));
  EXPECT_EQ(found[1].heights, (std::vector<double>{0, -1})) << "no plunge to its deep end, which is nearer";
  const auto on = tool::group_by_group({line("trunk", 2, 9), line("on", 12, 9), line("level", 12, 13)}, {0, 0, 0});
  EXPECT_EQ(on[1].title, "on");
  EXPECT_EQ(on[1].from(), (Xy<double>{9, 0})) << "from its deep end, where the bit is; with its heights";
  EXPECT_EQ(on[1].heights, (std::vector<double>{-1, 0}));
}

}  // namespace
}  // namespace test_v_carving
