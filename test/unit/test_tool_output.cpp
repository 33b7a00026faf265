// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// What the command-line tool prints, read by parsers: the regions of build and their geometry, the rows of compare, the
// counts of verify, and pictures.

#include "bulge_arcs.h"

#include <CGAL/Bounding_arcs_2/curve/Curve_file.h>

#include <nlohmann/json.hpp>
#include <pugixml.hpp>

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <limits>
#include <optional>
#include <set>
#include <sstream>
#include <string>
#include <vector>

#include <unistd.h>

namespace {

using CGAL::Bounding_arcs::Bezier_curve_2;
using CGAL::Bounding_arcs::bezier_pieces;
using CGAL::Bounding_arcs::read_curves;
using CGAL::Bounding_arcs::Xy;
using nlohmann::json;
using Point = Xy<double>;

constexpr double ROUNDING = std::numeric_limits<double>::epsilon();
const std::vector<std::string> METHODS{"bca", "bilens", "sfa"}, KERNELS{"double", "filtered", "exact"};

// The eight bundled curves and their numbers of spiral segments, counted exactly elsewhere.
const std::vector<std::pair<std::string, int>> BUNDLED{{"a_wrench", 75},    {"b_angelfish", 85},  {"c_letter_K", 105},
                                                       {"d_rabbit", 116},   {"e_cat", 120},       {"f_crow", 132},
                                                       {"g_chipmunk", 170}, {"h_maple_leaf", 182}};

std::string bundled(const std::string& name) { return std::string(BOUNDING_ARCS_EXAMPLE_DATA) + '/' + name + ".json"; }

struct Run {
  int status;
  std::string output;
};

/// The tool with arguments that the shell splits.
Run run_tool(const std::string& arguments) {
  const std::string command = std::string("'") + BOUNDING_ARCS_TOOL_PATH + "' " + arguments;
  std::FILE* pipe = ::popen(command.c_str(), "r");
  Run run{-1, ""};
  if (pipe == nullptr) return run;
  std::array<char, 1 << 16> buffer{};
  for (std::size_t n; (n = std::fread(buffer.data(), 1, buffer.size(), pipe)) > 0;) run.output.append(buffer.data(), n);
  run.status = ::pclose(pipe);
  return run;
}

json json_of(const std::string& arguments) {
  const Run run = run_tool(arguments + " --format json");
  EXPECT_EQ(run.status, 0) << arguments;
  json document = json::parse(run.output, nullptr, false);
  EXPECT_FALSE(document.is_discarded()) << arguments << ": no JSON: " << run.output.substr(0, 300);
  return document;
}

/// A curve file of its own for one test.
class Temporary_file {
 public:
  explicit Temporary_file(const std::string& content)
      : path_((std::filesystem::temp_directory_path() / ("tool_output_" + std::to_string(::getpid()) + ".json"))
                  .string()) {
    std::ofstream(path_) << content;
  }
  ~Temporary_file() { std::filesystem::remove(path_); }
  Temporary_file(const Temporary_file&) = delete;
  Temporary_file& operator=(const Temporary_file&) = delete;
  [[nodiscard]] const std::string& path() const { return path_; }

 private:
  std::string path_;
};

void expect_keys(const json& object, const std::set<std::string>& keys) {
  std::set<std::string> found;
  for (const auto& item : object.items()) found.insert(item.key());
  EXPECT_EQ(found, keys) << object.dump().substr(0, 200);
}

Point point_of(const json& xy) { return {xy.at(0).get<double>(), xy.at(1).get<double>()}; }
double distance(const Point& p, const Point& q) { return std::hypot(p.x - q.x, p.y - q.y); }

/// One arc or segment.
struct Piece {
  Point from, to;
  double bulge = 0;
  std::optional<Point> center;
  double radius = 0;

  explicit Piece(const json& piece) : from(point_of(piece.at("from"))), to(point_of(piece.at("to"))) {
    if (piece.at("type") == "segment") return;
    bulge = piece.at("bulge").get<double>();
    if (piece.at("center").is_null()) return;
    center = point_of(piece.at("center"));
    radius = piece.at("radius").get<double>();
  }
  [[nodiscard]] bool is_arc() const { return bulge != 0; }
};

std::vector<Piece> chain_of(const json& pieces) {
  std::vector<Piece> chain;
  for (const json& piece : pieces) chain.emplace_back(piece);
  return chain;
}

double distance_from_chain(const Point& q, const std::vector<Piece>& chain) {
  double least = std::numeric_limits<double>::infinity();
  for (const Piece& piece : chain) least = std::min(least, bounding_arcs_test::distance_from(piece, q));
  return least;
}

/// The greatest distance of samples of one chain from the other.
double sampled_distance(const std::vector<Piece>& samples, const std::vector<Piece>& chain) {
  constexpr int SAMPLES = 16;
  double greatest = 0;
  for (const Piece& piece : samples)
    for (int i = 0; i <= SAMPLES; ++i)
      greatest =
          std::max(greatest, distance_from_chain(bounding_arcs_test::point_on(piece, i / double(SAMPLES)), chain));
  return greatest;
}

void expect_piece(const json& piece, double scale) {
  ASSERT_TRUE(piece.at("type") == "arc" || piece.at("type") == "segment") << piece;
  const Piece p(piece);
  if (!p.is_arc()) return expect_keys(piece, {"type", "from", "to"});
  expect_keys(piece, {"type", "from", "to", "bulge", "center", "radius", "orientation"});
  EXPECT_EQ(piece.at("orientation"), p.bulge > 0 ? "ccw" : "cw") << piece;
  EXPECT_EQ(piece.at("center").is_null(), piece.at("radius").is_null()) << piece;
  if (!p.center) return;
  const double rounding =
      16 * ROUNDING * (p.radius + std::fabs(p.center->x) + std::fabs(p.center->y) + scale);  // of this check
  const double ulps = 4 * 2 * ROUNDING * scale;
  EXPECT_NEAR(distance(p.from, *p.center), p.radius, ulps + rounding) << piece;
  EXPECT_NEAR(distance(p.to, *p.center), p.radius, ulps + rounding) << piece;
  // the centre is on the left of the way from one end to the other if the short way is counterclockwise
  EXPECT_EQ(cross(p.to - p.from, *p.center - p.from) > 0, p.bulge > 0) << piece;
}

void expect_chain(const json& chain, const Point& from, const Point& to, double scale) {
  ASSERT_FALSE(chain.empty());
  for (const json& piece : chain) expect_piece(piece, scale);
  EXPECT_LE(distance(point_of(chain.front().at("from")), from), 8 * ROUNDING * scale) << chain;
  EXPECT_LE(distance(point_of(chain.back().at("to")), to), 8 * ROUNDING * scale) << chain;
  for (std::size_t i = 1; i < chain.size(); ++i) EXPECT_EQ(chain[i].at("from"), chain[i - 1].at("to")) << chain;
}

void expect_region(const json& region, const Bezier_curve_2<double>& bezier, double eps, double scale) {
  expect_keys(region, {"bezier", "t", "thickness", "inner", "outer"});
  const double t0 = region.at("t").at(0), t1 = region.at("t").at(1), thickness = region.at("thickness");
  ASSERT_LT(t0, t1);
  EXPECT_GE(thickness, 0);
  EXPECT_LE(thickness, eps);
  expect_chain(region.at("inner"), bezier.point(t0), bezier.point(t1), scale);
  expect_chain(region.at("outer"), bezier.point(t0), bezier.point(t1), scale);
  EXPECT_EQ(region.at("inner").front().at("from"), region.at("outer").front().at("from"));
  EXPECT_EQ(region.at("inner").back().at("to"), region.at("outer").back().at("to"));
  const std::vector<Piece> inner = chain_of(region.at("inner")), outer = chain_of(region.at("outer"));
  const double rounding = 16 * ROUNDING * scale;
  EXPECT_LE(sampled_distance(inner, outer), thickness + rounding) << region;
  EXPECT_LE(sampled_distance(outer, inner), thickness + rounding) << region;
  constexpr int SAMPLES = 8;
  for (int i = 1; i < SAMPLES; ++i) {
    const Point q = bezier.point(t0 + (t1 - t0) * i / SAMPLES);
    EXPECT_LE(distance_from_chain(q, inner), thickness + rounding) << region;
    EXPECT_LE(distance_from_chain(q, outer), thickness + rounding) << region;
  }
}

// All regions of a curve: in its order, without a gap from 0 to 1 in every piece, neighbours meeting in the same
// numbers.
void expect_regions(const json& curve, const std::vector<Bezier_curve_2<double>>& beziers, double eps) {
  double scale = 0;
  for (const auto& bezier : beziers)
    for (const Point& p : bezier.control_points()) scale = std::max({scale, std::fabs(p.x), std::fabs(p.y)});
  std::size_t bezier = 0;
  double t = 0;
  const json* before = nullptr;
  for (const json& region : curve.at("regions")) {
    if (t == 1) {
      ++bezier;
      t = 0;
    }
    ASSERT_EQ(region.at("bezier").get<std::size_t>(), bezier);
    ASSERT_LT(bezier, beziers.size());
    ASSERT_EQ(region.at("t").at(0).get<double>(), t);
    t = region.at("t").at(1);
    expect_region(region, beziers[bezier], eps, scale);
    if (before != nullptr) {
      EXPECT_EQ(region.at("inner").front().at("from").dump(), before->at("inner").back().at("to").dump());
    }
    before = &region;
  }
  EXPECT_EQ(bezier + 1, beziers.size());
  EXPECT_EQ(t, 1);
  EXPECT_GE(curve.at("regions").size(), curve.at("spirals").get<std::size_t>());
}

void expect_build(const std::string& file, const std::string& method, const std::string& kernel, double eps) {
  SCOPED_TRACE(file + ' ' + method + ' ' + kernel);
  std::ostringstream arguments;
  arguments << "build --method " << method << " --kernel " << kernel << " --eps " << eps << " '" << file << "'";
  const json document = json_of(arguments.str());
  ASSERT_TRUE(document.is_object());
  expect_keys(document, {"method", "eps", "kernel", "curves"});
  EXPECT_EQ(document.at("method"), method);
  EXPECT_EQ(document.at("kernel"), kernel);
  EXPECT_EQ(document.at("eps"), eps);
  const auto records = read_curves(file);
  ASSERT_EQ(document.at("curves").size(), records.size());
  for (std::size_t i = 0; i < records.size(); ++i) {
    const json& curve = document.at("curves")[i];
    expect_keys(curve, {"name", "beziers", "spirals", "regions"});
    const auto beziers = bezier_pieces<double>(records[i]);
    EXPECT_EQ(curve.at("name"), records[i].name);
    EXPECT_EQ(curve.at("beziers"), beziers.size());
    expect_regions(curve, beziers, eps);
  }
}

TEST(ToolBuild, WritesRegionsThatTileABundledCurve) {
  for (const std::string& method : METHODS)
    for (const std::string& kernel : KERNELS) expect_build(bundled("a_wrench"), method, kernel, 1e-3);
  expect_build(bundled("h_maple_leaf"), "bilens", "double", 1e-6);
  expect_build(bundled("d_rabbit"), "sfa", "filtered", 1e-4);
}

TEST(ToolBuild, WritesRegionsThatTileSmallCurves) {
  const Temporary_file file(R"({"curves":[
    {"name":"parabola","type":"bezier","degree":2,"control_points":[[0,0],[0.5,0],[1,1]]},
    {"name":"rational","type":"bezier","degree":3,"control_points":[[0,0],[1,2],[2,-1],[3,1]],"weights":[1,2,1,3]},
    {"name":"line","type":"bezier","degree":1,"control_points":[[0,0],[1,2]]},
    {"name":"cusp","type":"bezier","degree":3,"control_points":[[0,0],[1,1],[0,1],[1,0]]},
    {"name":"quarter","type":"bezier","degree":2,"control_points":[[0,1],[1,1],[1,0]],"weights":[1,1,2]},
    {"name":"closed","type":"bspline","degree":3,"knots":"uniform","periodic":true,
     "control_points":[[0,0],[1,0],[1,2],[0,1],[-1,1]]}]})");
  for (const std::string& method : METHODS)
    for (const std::string& kernel : KERNELS) expect_build(file.path(), method, kernel, 1e-4);
}

TEST(ToolBuild, ClosesAPeriodicCurveInTheSameNumbers) {
  for (const std::string& method : METHODS) {
    const json document = json_of("build --method " + method + " --eps 1e-3 " + bundled("e_cat"));
    const json& regions = document.at("curves").at(0).at("regions");
    EXPECT_EQ(regions.back().at("outer").back().at("to").dump(), regions.front().at("inner").front().at("from").dump());
  }
}

// The worked example: thickness 1 + sqrt 2 - sqrt 5, inner circle through both ends about (0,1), outer one about
// (-1,2).
TEST(ToolBuild, WritesTheWorkedExample) {
  const Temporary_file file(R"({"type":"bezier","degree":2,"control_points":[[0,0],[0.5,0],[1,1]]})");
  for (const std::string& kernel : KERNELS) {
    const json document = json_of("build --method bca --eps 1 --kernel " + kernel + " " + file.path());
    const json& regions = document.at("curves").at(0).at("regions");
    ASSERT_EQ(regions.size(), 1u);
    const Piece inner(regions[0].at("inner").at(0)), outer(regions[0].at("outer").at(0));
    const Point center[2] = {inner.center.value(), outer.center.value()};
    EXPECT_LE(distance(center[0], {-1, 2}), 1e-15) << regions;
    EXPECT_LE(distance(center[1], {0, 1}), 1e-15) << regions;
    EXPECT_NEAR(inner.radius, std::sqrt(5), 1e-15);
    EXPECT_NEAR(outer.radius, 1, 1e-15);
    const double exact = 1 + std::sqrt(2) - std::sqrt(5), upper_bound = regions[0].at("thickness");
    EXPECT_GE(upper_bound, exact - 1e-15);
    EXPECT_LE(upper_bound, exact + 1e-14);
  }
}

TEST(ToolBuild, WritesNamesAsTheyAre) {
  const std::string name = "a\"b\\c\n<d>&\u00e9\u2028 'e'";
  const Temporary_file file(
      json{{"name", name}, {"type", "bezier"}, {"degree", 1}, {"control_points", {{0, 0}, {1, 2}}}}.dump());
  EXPECT_EQ(json_of("build --method bca --eps 1 " + file.path()).at("curves").at(0).at("name"), name);
  EXPECT_EQ(json_of("compare --repeat 1 " + file.path()).at("rows").at(0).at("curve"), name);
}

std::string all_bundled() {
  std::string files;
  for (const auto& curve : BUNDLED) files += ' ' + bundled(curve.first);
  return files;
}

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
        expect_keys(row, {"curve", "beziers", "spirals", "method", "eps", "time_ms", "regions", "arcs", "nodes"});
        expect_keys(row.at("time_ms"), {"min", "median"});
        EXPECT_EQ(row.at("curve"), name);
        EXPECT_EQ(row.at("spirals"), spirals);
        EXPECT_EQ(row.at("eps"), eps);
        EXPECT_EQ(row.at("method"), method);
        const std::size_t regions = row.at("regions");
        EXPECT_EQ(row.at("arcs"), regions * (method == "bilens" ? 4 : 2));
        EXPECT_EQ(row.at("nodes"), 2 * regions - static_cast<std::size_t>(spirals));  // a binary tree a spiral
        EXPECT_GT(row.at("time_ms").at("min").get<double>(), 0);
        EXPECT_LE(row.at("time_ms").at("min").get<double>(), row.at("time_ms").at("median").get<double>());
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
    double eps = 0, least = 0, median = 0, ns = 0, ratio = 0;
    words >> curve >> beziers >> spirals >> eps >> method >> least >> median >> regions >> arcs >> nodes >> ns >> ratio;
    ASSERT_FALSE(words.fail()) << line;
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
    const json finer =
        json_of("verify --method " + method + " --eps 1e-6 " + bundled("a_wrench") + ' ' + bundled("h_maple_leaf"));
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
  std::size_t i = 0;
  for (const pugi::xml_node& group : svg.children("g")) {
    ASSERT_LT(i, curves.size());
    EXPECT_EQ(group.child_value("title"), curves[i].at("name").get<std::string>());
    std::size_t regions = 0;
    for (const pugi::xml_node& path : group.children("path")) {
      const std::string d = path.attribute("d").value();
      EXPECT_EQ(d.find_first_not_of("MALQChZ0123456789.e+- "), std::string::npos) << d;
      if (std::string(path.attribute("class").value()) != "r") continue;
      ++regions;
      ASSERT_FALSE(d.empty());
      EXPECT_EQ(d.front(), 'M');
      EXPECT_EQ(d.back(), 'Z');
      double x = 0, y = 0;
      ASSERT_EQ(std::sscanf(d.c_str(), "M%lf %lf", &x, &y), 2) << d;
      EXPECT_TRUE(0 <= x && x <= box[2] && 0 <= y && y <= box[3]) << d;
    }
    EXPECT_EQ(regions, curves[i].at("regions").size());
    ++i;
  }
  EXPECT_EQ(i, curves.size());
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
    EXPECT_STREQ(document.document_element().child("g").child_value("title"),
                 "a\xEF\xBF\xBD"
                 "b\xEF\xBF\xBD    ]]>\x7F\xC2\x85\xEF\xBF\xAF\xF0\x9F\xBF\xBF");
  }
}

}  // namespace
