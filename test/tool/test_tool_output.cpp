// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// What the command-line tool prints beside regions, read by parsers: the rows of compare, the counts of verify, and
// pictures.

#include "cases.h"
#include "tool.h"

#include <pugixml.hpp>

#include <algorithm>
#include <array>
#include <cstdio>
#include <sstream>
#include <string>
#include <vector>

namespace test_tool_output {
namespace {

using namespace bounding_arcs_test;
using nlohmann::json;

TEST(ToolCompare, HasARowPerCurveEpsAndMethod) {
  const json document = json_of("compare --eps 1e-3,1e-5 --repeat 2" + all_bundled());
  expect_keys(document, {"rows"});
  const json& rows = document.at("rows");
  ASSERT_EQ(rows.size(), BUNDLED.size() * 2 * METHODS.size());
  std::size_t i = 0;
  for (const auto& [name, spirals] : BUNDLED)
    for (const double eps : {1e-3, 1e-5})
      for (const std::string& method : METHODS) {
        const json& row = rows[i++];
        SCOPED_TRACE(row.dump());
        expect_keys(row, {"curve", "beziers", "spirals", "method", "eps", "segmentation_ms", "time_ms", "regions_ms",
                          "regions", "arcs", "nodes"});
        for (const char* times : {"segmentation_ms", "time_ms", "regions_ms"}) {
          expect_keys(row.at(times), {"min", "median"});
          EXPECT_GT(row.at(times).at("min").get<double>(), 0) << times;
          EXPECT_LE(row.at(times).at("min").get<double>(), row.at(times).at("median").get<double>()) << times;
        }
        EXPECT_EQ(row.at("curve"), name);
        EXPECT_EQ(row.at("spirals"), spirals);
        EXPECT_EQ(row.at("eps"), eps);
        EXPECT_EQ(row.at("method"), method);
        const std::size_t regions = row.at("regions");
        EXPECT_EQ(row.at("arcs"), regions * (method == "bilens" ? 4 : 2));
        EXPECT_EQ(row.at("nodes"), 2 * regions - static_cast<std::size_t>(spirals));  // a binary tree a spiral
      }
}

TEST(ToolCompare, PrintsTheSameNumbersAsATable) {
  const std::string arguments =
      "compare --eps 1e-3 --methods sfa,bca --repeat 1 " + bundled("a_wrench") + ' ' + bundled("f_crow");
  const json rows = json_of(arguments).at("rows");
  std::istringstream table(run_tool(arguments).output);
  std::string line;
  std::getline(table, line);
  EXPECT_NE(line.find("regions"), std::string::npos);
  std::vector<std::size_t> sums{0, 0};
  for (std::size_t i = 0; i < rows.size() + 2; ++i) {
    ASSERT_TRUE(std::getline(table, line));
    std::istringstream words(line);
    std::string curve, method;
    std::size_t beziers = 0, spirals = 0, regions = 0, arcs = 0, nodes = 0;
    double eps = 0, cut = 0, build = 0, arcs_made = 0, sum = 0, ns = 0, ratio = 0;
    words >> curve >> beziers >> spirals >> eps >> method >> cut >> build >> arcs_made >> sum;
    words >> regions >> arcs >> nodes >> ns >> ratio;
    ASSERT_FALSE(words.fail()) << line;
    EXPECT_NEAR(sum, cut + build + arcs_made, 2e-4) << line;
    if (i < rows.size()) {
      EXPECT_EQ(curve, rows[i].at("curve"));
      EXPECT_EQ(method, rows[i].at("method"));
      EXPECT_EQ(spirals, rows[i].at("spirals"));
      EXPECT_EQ(regions, rows[i].at("regions"));
      EXPECT_EQ(arcs, rows[i].at("arcs"));
      EXPECT_EQ(nodes, rows[i].at("nodes"));
      sums[i % 2] += regions;
    } else {
      EXPECT_EQ(curve, "all");
      EXPECT_EQ(regions, sums[i % 2]);
    }
    EXPECT_TRUE(i % 2 == 1 || ratio == 1) << line;  // the first method is the reference
  }
}

TEST(VerifyOutput, ProvesCertifiedRegionsOfAllBundledCurves) {
  for (const std::string& method : METHODS)
    for (const std::string kernel : {"double", "filtered"}) {
      const json document =
          json_of("verify --certified --method " + method + " --kernel " + kernel + " --eps 1e-4" + all_bundled());
      EXPECT_EQ(document["kernel"], kernel);
      EXPECT_GT(document["regions"], 0);
      EXPECT_EQ(document["proven"], document["regions"]);
      EXPECT_TRUE(document["failed"].empty());
      const double widening = document["widening"], ulps = document["widening_ulp"];
      EXPECT_GT(widening, 0);
      EXPECT_GT(ulps, 0.1);
      EXPECT_LE(ulps, 4) << method << ' ' << kernel;
    }
}

TEST(ToolVerify, ProvesEveryRegionOfTheBundledCurves) {
  for (const std::string& method : METHODS) {
    const json document = json_of("verify --method " + method + " --eps 1e-3" + all_bundled());
    EXPECT_EQ(document.at("method"), method);
    EXPECT_EQ(document.at("proven"), document.at("regions"));
    EXPECT_EQ(document.at("failed"), json::array());
    std::size_t regions = 0;
    const json rows = json_of("compare --repeat 1 --eps 1e-3 --methods " + method + all_bundled()).at("rows");
    for (const json& row : rows) regions += row.at("regions").get<std::size_t>();
    EXPECT_EQ(document.at("regions"), regions);
    if (bounding_arcs_test::FEW_CASES) continue;
    const json finer = json_of("verify --method " + method + " --eps 1e-6 " + bundled("a_wrench"));
    EXPECT_EQ(finer.at("proven"), finer.at("regions"));
    EXPECT_EQ(finer.at("failed"), json::array());
  }
}

TEST(ToolVerify, ProvesRegionsOfEveryKernel) {
  for (const std::string& method : METHODS)
    for (const std::string& kernel : KERNELS) {
      const json document =
          json_of("verify --method " + method + " --kernel " + kernel + " --eps 1e-3 " + bundled("a_wrench"));
      EXPECT_EQ(document.at("kernel"), kernel);
      EXPECT_EQ(document.at("failed"), json::array());
    }
}

void expect_picture(const std::string& file, const std::string& method, const std::string& eps) {
  SCOPED_TRACE(file + ' ' + method);
  const std::string arguments = "build --method " + method + " --eps " + eps + ' ' + file;
  const Run run = run_tool(arguments + " --format svg");
  ASSERT_EQ(run.status, 0);
  pugi::xml_document picture;
  const auto parsed = picture.load_buffer(run.output.data(), run.output.size());
  ASSERT_TRUE(parsed) << parsed.description();
  const pugi::xml_node svg = picture.document_element();
  EXPECT_STREQ(svg.name(), "svg");
  EXPECT_STREQ(svg.attribute("xmlns").value(), "http://www.w3.org/2000/svg");
  std::istringstream viewbox(svg.attribute("viewBox").value());
  std::array<double, 4> box{};
  for (double& x : box) viewbox >> x;
  ASSERT_FALSE(viewbox.fail());
  EXPECT_GT(box[2], 0);
  EXPECT_GT(box[3], 0);
  const json curves = json_of(arguments).at("curves");
  std::string layers;
  for (const pugi::xml_node& layer : svg.children("g")) {
    const std::string name = layer.attribute("id").value();
    layers += name + ' ';
    EXPECT_STREQ(layer.attribute("inkscape:groupmode").value(), "layer");
    EXPECT_EQ(layer.attribute("inkscape:label").value(), name);
    std::size_t i = 0;
    for (const pugi::xml_node& group : layer.children("g")) {
      ASSERT_LT(i, curves.size());
      EXPECT_EQ(group.child_value("title"), curves[i].at("name").get<std::string>());
      const std::size_t regions = curves[i++].at("regions").size();
      std::size_t starts = 0, closed = 0;
      for (const pugi::xml_node& path : group.children("path")) {
        const std::string d = path.attribute("d").value();
        EXPECT_EQ(d.find_first_not_of("MALQChZ0123456789.e+- "), std::string::npos) << d;
        ASSERT_FALSE(d.empty());
        EXPECT_EQ(d.front(), 'M');
        starts += static_cast<std::size_t>(std::count(d.begin(), d.end(), 'M'));
        closed += d.back() == 'Z';
        double x = 0, y = 0;
        ASSERT_EQ(std::sscanf(d.c_str(), "M%lf %lf", &x, &y), 2) << d;
        EXPECT_TRUE(0 <= x && x <= box[2] && 0 <= y && y <= box[3]) << d;
      }
      if (name != "curves") {  // of which one with a common end is closed
        EXPECT_EQ(closed, name == "regions" ? regions : 0);
        EXPECT_EQ(starts, regions + (name == "ends" ? 1 : 0)) << name;
      }
    }
    EXPECT_EQ(i, curves.size()) << name;
  }
  EXPECT_EQ(layers, "regions inner outer curves ends ");
}

TEST(ToolPicture, IsWellFormedWithOnePathARegion) {
  for (const std::string& method : METHODS) expect_picture(bundled("b_angelfish"), method, "0.02");
  expect_picture(bundled("a_wrench") + ' ' + bundled("h_maple_leaf"), "bca", "1e-4");
}

TEST(ToolPicture, TakesAnyCurveAndName) {
  const char* const curves[] = {R"("degree":1,"control_points":[[0.1,0.7],[0.1,0.7]])",
                                R"("degree":1,"control_points":[[1,1],[2,1]])",
                                R"("degree":2,"control_points":[[0,0],[1e-300,0],[1e-300,1e-300]])",
                                R"("degree":2,"control_points":[[0,0],[1e300,0],[1e300,1e300]])",
                                R"("degree":2,"control_points":[[1000000,0],[1000000.001,0],[1000000.001,0.001]])",
                                R"("degree":4,"control_points":[[0,0],[1,0],[1,1],[2,3],[1,1]],"weights":[1,2,1,1,3])"};
  for (const std::string curve : curves)
    for (const std::string& method : METHODS) {
      const Temporary_file file(R"({"name":"<a & \"b\"> é","type":"bezier",)" + curve + "}");
      expect_picture(file.path(), method, curve.find("e300") != curve.npos ? "1e299" : "1e-3");
    }
}

// XML 1.0 has no way to write some characters that JSON has, and "]]>" may not stand in content; parsers that are not
// strict let both pass.
TEST(ToolPicture, HoldsNoCharacterThatXmlForbids) {
  const Temporary_file file(R"({"type":"bezier","degree":1,"control_points":[[0,0],[1,1]],)"
                            R"("name":"a\uffffb\ufffe\u0000\u0001\u000b\u001f]]>\u007f\u0085\uffef\ud83f\udfff"})");
  for (const std::string command : {"build --method bca --eps 1", "arcs --eps 1"}) {
    const std::string picture = run_tool(command + " --format svg " + file.path()).output;
    for (const std::string forbidden : {"\xEF\xBF\xBE", "\xEF\xBF\xBF", "]]>"})
      EXPECT_EQ(picture.find(forbidden), std::string::npos) << command;
    for (const char c : picture) EXPECT_TRUE(static_cast<unsigned char>(c) >= 0x20 || c == '\n') << command;
    pugi::xml_document document;
    ASSERT_TRUE(document.load_buffer(picture.data(), picture.size()));
    EXPECT_STREQ(document.document_element().child("g").child("g").child_value("title"),
                 "a\xEF\xBF\xBD"
                 "b\xEF\xBF\xBD    ]]>\x7F\xC2\x85\xEF\xBF\xAF\xF0\x9F\xBF\xBF");
  }
}

}  // namespace
}  // namespace test_tool_output
