// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The overlays of test/data/overlay, by the tool and by the library, beside their right answers.

#include "kernel_trees.h"
#include "outline_areas.h"
#include "overlay_checks.h"
#include "tool.h"

#include <CGAL/Bounding_arcs_2/curve/Curve_file.h>

#include <boost/pending/disjoint_sets.hpp>

#include <gtest/gtest.h>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <cstddef>
#include <fstream>
#include <ostream>
#include <random>
#include <set>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace test_overlay_data {

using namespace bounding_arcs_test;
using nlohmann::json;

const std::string FOLDER = std::string(BOUNDING_ARCS_TEST_DATA) + "/overlay/";

/// An entry of index.json.
struct Case {
  json entry;

  [[nodiscard]] std::string command() const { return entry.at("command"); }
  [[nodiscard]] std::string arguments() const {
    std::string text = command() == "arrange" ? "arrange" : "boolean " + command();
    for (const std::string file : entry.at("files")) text += " '" + FOLDER + file + '\'';
    return command() == "arrange" ? text : text + " --rule " + entry.at("rule").get<std::string>();
  }
  [[nodiscard]] std::string name() const {
    std::string text = entry.at("name").get<std::string>() + '_' + command();
    std::replace_if(
        text.begin(), text.end(), [](unsigned char c) { return std::isalnum(c) == 0; }, '_');
    return text;
  }
  friend std::ostream& operator<<(std::ostream& out, const Case& c) {
    return out << c.entry.at("description") << ": " << c.entry.at("right");
  }
};
std::vector<Case> cases_of(bool are_arranged) {
  std::vector<Case> result;
  for (const json& entry : json::parse(std::ifstream(FOLDER + "index.json")))
    if ((entry.at("command") == "arrange") == are_arranged) result.push_back({entry});
  return result;
}

template <class Value> void expect_field(const json& expected, const char* key, const Value& found) {
  if (expected.contains(key)) {
    EXPECT_EQ(expected.at(key).get<Value>(), found) << key;
  }
}

class ArrangedData : public testing::TestWithParam<Case> {};

// Every edge has its two sides in the faces that it names, and Euler's relation holds.
void expect_consistent(const json& cells) {
  const json &vertices = cells.at("vertices"), &edges = cells.at("edges"), &faces = cells.at("faces");
  std::set<std::pair<std::size_t, bool>> sides;
  std::vector<std::size_t> degrees(vertices.size(), 0);
  boost::disjoint_sets_with_storage<> parts(vertices.size());
  for (std::size_t v = 0; v < vertices.size(); ++v) parts.make_set(v);
  for (const json& e : edges) {
    const std::size_t from = e.at("from"), to = e.at("to");
    ++degrees.at(from);
    ++degrees.at(to);
    parts.union_set(from, to);
  }
  std::size_t components = 0;
  for (std::size_t v = 0; v < vertices.size(); ++v) {
    EXPECT_EQ(degrees[v], vertices[v].at("degree")) << "vertex " << v;
    components += parts.find_set(v) == v ? 1 : 0;
  }
  EXPECT_EQ(vertices.size() + faces.size(), edges.size() + 1 + components);
  for (std::size_t f = 0; f < faces.size(); ++f)
    for (const json& boundary : faces[f].at("boundaries"))
      for (const json& side : boundary) {
        const std::size_t edge = side.at("edge");
        const bool is_forwards = side.at("forwards");
        EXPECT_TRUE(sides.emplace(edge, is_forwards).second) << "a side of two faces, edge " << edge;
        EXPECT_EQ(f, edges.at(edge).at(is_forwards ? "left" : "right"));
      }
  EXPECT_EQ(sides.size(), 2 * edges.size());
}

TEST_P(ArrangedData, IsRight) {
  const json cells = json_of(GetParam().arguments()), &expected = GetParam().entry.at("expected");
  if (HasFailure()) return;
  const std::size_t vertices = cells.at("vertices").size(), edges = cells.at("edges").size();
  expect_field(expected, "vertices", vertices);
  expect_field(expected, "edges", edges);
  // curves may be cut, or not, where their x turns
  expect_field(expected, "edges_less_vertices", static_cast<long>(edges) - static_cast<long>(vertices));
  expect_field(expected, "faces", cells.at("faces").size());
  expect_consistent(cells);
  bool has_area = false;
  for (const json& face : cells.at("faces")) {
    if (!face.at("bounded")) continue;
    const double lower = face.at("area").at(0), upper = face.at("area").at(1);
    EXPECT_LE(lower, upper);
    EXPECT_GT(upper, 0);
    constexpr double NEAR = 1e-9;
    has_area = has_area || std::fabs(0.5 * (lower + upper) - expected.value("face_of_area", 0.0)) < NEAR;
  }
  if (expected.contains("face_of_area")) {
    EXPECT_TRUE(has_area);
  }
}

INSTANTIATE_TEST_SUITE_P(Cases, ArrangedData, testing::ValuesIn(cases_of(true)),
                         [](const auto& param) { return param.param.name(); });

class CombinedData : public testing::TestWithParam<Case> {};

Operation operation_of(const Case& c) {
  for (const Boolean_operation operation : {Boolean_operation::UNION, Boolean_operation::INTERSECTION,
                                            Boolean_operation::DIFFERENCE, Boolean_operation::SYMMETRIC_DIFFERENCE})
    for (const Fill_rule rule : {Fill_rule::NONZERO, Fill_rule::EVEN_ODD})
      if (const Operation how{operation, rule, rule};
          words_of(how) == c.command() + " --rule " + c.entry.at("rule").get<std::string>())
        return how;
  throw std::invalid_argument(c.name());
}
std::vector<std::size_t> parts_of_chains(const json& curves) {
  std::vector<std::size_t> parts;
  for (const json& curve : curves) parts.push_back(curve.at("pieces").size());
  std::sort(parts.begin(), parts.end());
  return parts;
}
void expect_fields(const json& expected, const Combined& made) {
  const auto& curves = made.rounded.curves();
  expect_field(expected, "chains", curves.size());
  if (expected.contains("box")) {
    const auto box = box_of(made.rounded);
    EXPECT_EQ(expected.at("box").get<std::vector<double>>(),
              (std::vector<double>{box.xmin(), box.ymin(), box.xmax(), box.ymax()}));
  }
  if (expected.contains("area")) {
    EXPECT_NEAR(area_of(made.rounded, 1e-9), expected.at("area").get<double>(), 1e-9);
  }
  if (expected.contains("shared_vertex")) {
    const Point vertex{expected.at("shared_vertex").at(0), expected.at("shared_vertex").at(1)};
    for (const auto& curve : curves)
      EXPECT_TRUE(std::any_of(curve.beziers.begin(), curve.beziers.end(),
                              [&](const Bezier& b) { return b.control_points().front() == vertex; }));
  }
}

TEST_P(CombinedData, IsRight) {
  const Case& c = GetParam();
  const json &expected = c.entry.at("expected"), &files = c.entry.at("files");
  const Drawing a = ba::read_drawing(FOLDER + files.at(0).get<std::string>()),
                b = files.size() == 1 ? Drawing() : ba::read_drawing(FOLDER + files.at(1).get<std::string>());
  const Operation how = operation_of(c);
  Asked_points points;
  std::mt19937 random(1);
  std::vector<Combined> made{checked<Filtered_tree>(a, b, how, random, points),
                             checked<Exact_tree>(a, b, how, random, points)};
  for (const Combined& m : made) expect_fields(expected, m);
  if (expected.value("areas_add_up", false)) require_areas<Filtered_tree>(a, b, how.rule_a, how.rule_b);
  const json written = json_of(c.arguments());
  ASSERT_FALSE(HasFailure());
  EXPECT_EQ(written.at("status"), "complete");
  // chains that bound nothing once they are rounded are not written
  const ba::Bounding_arc_tree_2 tree_a(a), tree_b(b);
  EXPECT_EQ(written.at("curves").size(), ba::drawn_outline({&tree_a, &tree_b}, made[0].outline).outline.chains.size());
  expect_field(expected, "parts", parts_of_chains(written.at("curves")));
}

INSTANTIATE_TEST_SUITE_P(Cases, CombinedData, testing::ValuesIn(cases_of(false)),
                         [](const auto& param) { return param.param.name(); });

}  // namespace test_overlay_data
