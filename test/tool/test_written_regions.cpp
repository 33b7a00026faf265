// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// That regions hold the exact curve as they are written: read back from JSON, widened by what the file tells, and
// proven. Flat and nearly circular pieces above all, whose thickness is far below an ulp of the radius.

#include "tool.h"
#include "trees.h"

#include <CGAL/Bounding_arcs_2.h>
#include <CGAL/Bounding_arcs_2/curve/Curve_file.h>
#include <CGAL/Bounding_arcs_2/region/Arc_region_2.h>
#include <CGAL/Bounding_arcs_2/verify/outside_bound.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <string>
#include <vector>

namespace test_written_regions {
namespace {

using namespace bounding_arcs_test;
using nlohmann::json;

Point point_of(const json& xy) { return {xy.at(0).get<double>(), xy.at(1).get<double>()}; }

ba::Arc_region_2::Side side_of(const json& chain) {
  ba::Arc_region_2::Side side;
  side.size = chain.size();
  for (std::size_t i = 0; i < side.size; ++i)
    side.bulges[i] = chain[i].at("type") == "arc" ? chain[i].at("bulge").get<double>() : 0;
  if (side.size == 2) side.joint = point_of(chain[0].at("to"));
  return side;
}

ba::Arc_region_2 region_of(const json& region, const std::string& method) {
  ba::Arc_region_2 r{point_of(region.at("inner").front().at("from")), point_of(region.at("inner").back().at("to")),
                     side_of(region.at("inner")), side_of(region.at("outer"))};
  if (r.inner.size == 2 || r.outer.size == 2)
    r.form = method == "sfa" ? ba::Region_form::SPIRAL_FAT_ARC : ba::Region_form::BILENS;
  return r;
}

// A piece of the curve's polynomial or rational function, whose cuts are not looked at.
Spiral piece_of(const std::vector<Spiral>& spirals, std::size_t bezier, double t0, double t1) {
  for (const Spiral& s : spirals)
    if (s.place().bezier == bezier && s.first() <= t0 && t1 <= s.last()) return s;
  throw std::runtime_error("a region of no spiral segment");
}

struct Written {
  std::size_t regions = 0, arcs = 0;
  double most_ulps = 0;
};

// Of one curve a file.
Written expect_proven(const std::string& file, const std::string& method, const std::string& options) {
  const json document = json_of("build --certified --method " + method + ' ' + options + ' ' + file);
  const auto records = ba::read_curve_file(file).curves;
  ba::Drawing_2<double> drawing;
  drawing.add(records.front().bezier_pieces<double>(), "curve");
  const std::vector<Spiral> spirals = ba::spiral_segments(drawing);
  Written written;
  for (const json& region : document.at("curves").at(0).at("regions")) {
    const double t0 = region.at("t").at(0), t1 = region.at("t").at(1), widening = region.at("widening");
    const Spiral spiral = piece_of(spirals, region.at("bezier"), t0, t1);
    EXPECT_TRUE(ba::is_within(spiral, t0, t1, boundary_of(region_of(region, method)), widening))
        << file << ' ' << method << ' ' << options << ", t " << t0 << ' ' << t1 << ", widening " << widening;
    const double size = spiral.coordinate_size();
    written.most_ulps = (std::max)(written.most_ulps, widening / (std::nextafter(size, HUGE_VAL) - size));
    for (const char* side : {"inner", "outer"})
      for (const json& piece : region.at(side)) written.arcs += piece.at("type") == "arc";
    ++written.regions;
  }
  return written;
}

TEST(WrittenRegions, OfTheBundledCurvesHoldThem) {
  for (const std::string& method : METHODS)
    for (const char* name : {"a_wrench", "h_maple_leaf"}) {
      const Written w = expect_proven(bundled(name), method, "--eps 1e-3");
      EXPECT_GE(w.regions, 100u);
      EXPECT_LE(w.most_ulps, 8) << name << ' ' << method;
    }
}

class Flat : public testing::TestWithParam<const char*> {};

// Leaves far thinner than an ulp of the coordinates times their radius: their arcs are no segments.
TEST_P(Flat, RegionsHoldTheCurve) {
  const std::string quadratic = "{\"type\":\"bezier\",\"degree\":2,\"control_points\":";
  for (const std::string& curve : {quadratic + "[[0.3,0.7],[0.8,0.7],[1.3,0.70000000033333]]}",
                                   quadratic + "[[0.3,0.7],[0.8,0.7],[1.3,0.7000000000333333]]}",
                                   quadratic + "[[1,0],[1,1.0000000000000333],[0,1.0000000000000333]],"
                                               "\"weights\":[1,1,2]}"}) {
    const Temporary_file file(curve);
    for (const std::string& method : METHODS) {
      const Written w = expect_proven(file.path(), method, std::string("--eps 1e-12 --kernel ") + GetParam());
      EXPECT_GE(w.arcs, 1u) << curve;
      EXPECT_LE(w.most_ulps, 8) << curve << ' ' << method;
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Kernels, Flat, testing::Values("double", "filtered", "exact"),
                         [](const auto& param) { return std::string(param.param); });

}  // namespace
}  // namespace test_written_regions
