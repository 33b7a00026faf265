// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The regions that the command-line tool builds, read by a parser: they tile the curve, are as thick as they say and
// hold it, in every method and kernel.

#include "bulge_arcs.h"
#include "tool.h"

#include <CGAL/Bounding_arcs_2/curve/Curve_file.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <sstream>
#include <string>
#include <vector>

namespace test_tool_regions {
namespace {

using namespace bounding_arcs_test;
using CGAL::Bounding_arcs::Bezier_curve_2;
using CGAL::Bounding_arcs::read_curve_file;
using nlohmann::json;
using Point = CGAL::Bounding_arcs::Xy<double>;

constexpr double ROUNDING = std::numeric_limits<double>::epsilon();

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
  for (const Piece& piece : chain) least = std::min(least, distance_from(piece, q));
  return least;
}

/// The greatest distance of samples of one chain from the other.
double sampled_distance(const std::vector<Piece>& samples, const std::vector<Piece>& chain) {
  constexpr int SAMPLES = 16;
  double greatest = 0;
  for (const Piece& piece : samples)
    for (int i = 0; i <= SAMPLES; ++i)
      greatest = std::max(greatest, distance_from_chain(point_on(piece, i / double(SAMPLES)), chain));
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
  // the center is on the left of the way from one end to the other if the short way is counterclockwise
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
  const auto records = read_curve_file(file).curves;
  ASSERT_EQ(document.at("curves").size(), records.size());
  for (std::size_t i = 0; i < records.size(); ++i) {
    const json& curve = document.at("curves")[i];
    expect_keys(curve, {"name", "beziers", "spirals", "regions"});
    const auto beziers = records[i].bezier_pieces<double>();
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

}  // namespace
}  // namespace test_tool_regions
