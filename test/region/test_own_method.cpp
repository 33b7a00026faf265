// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// A method in one header gets the tree, pictures, proofs of thickness and sizes to compare from the library, and needs
// nothing of the filter.

#include "Commands.h"
#include "Sagitta.h"
#include "hierarchy_implementation.h"

#include <CGAL/Simple_cartesian.h>

#include <gtest/gtest.h>

#include <cmath>
#include <memory>
#include <sstream>
#include <string>
#include <vector>

namespace test_own_method {
namespace {

using namespace bounding_arcs_tool;
using bounding_arcs_test::Sagitta;
namespace ba = CGAL::Bounding_arcs;
using Kernel_2 = detail::Circular<CGAL::Simple_cartesian<double>>;
using Spiral = ba::Bezier_spiral_2<double>;
template <class Construction>
using Hierarchy =
    detail::Hierarchy_of<ba::Region_hierarchy_2<ba::Bounding_region_traits_2<Kernel_2, Construction>, Spiral>>;

const ba::Bezier_curve_2<double>& curve() {
  static const ba::Bezier_curve_2<double> c({{0, 0}, {1, 2}, {2, -1}, {3, 1}});
  return c;
}
template <class Construction> std::size_t regions(double eps) {
  return Hierarchy<Construction>(ba::spiral_segments(curve()), eps, ba::Build_options()).size().regions;
}

TEST(OwnMethod, HasATreeWithoutTheFilter) {
  const double eps = 1e-3;
  const Hierarchy<Sagitta> hierarchy(ba::spiral_segments(curve()), eps, ba::Build_options());
  EXPECT_EQ(hierarchy.status(), Status::COMPLETE);
  EXPECT_LE(hierarchy.bound(), eps);
  std::size_t count = 0;
  hierarchy.for_each_region([&](const Output_region& r) {
    ++count;
    EXPECT_LE(r.thickness, eps);
    ASSERT_EQ(r.outer.size(), 1u);
    EXPECT_EQ(r.inner[0].bulge, 0);
    const double half = std::hypot(r.outer[0].to.x - r.outer[0].from.x, r.outer[0].to.y - r.outer[0].from.y) / 2;
    EXPECT_NEAR(std::fabs(r.outer[0].bulge) * half, r.thickness, 1e-9 * r.thickness);
    EXPECT_TRUE(has_written_thickness(r, 0));
  });
  EXPECT_EQ(count, hierarchy.size().regions);
  EXPECT_EQ(hierarchy.size().arcs, count);
}

// Its thickness falls with the square of the length, that of bounding circular arcs with the cube.
TEST(OwnMethod, IsComparedWithTheOthers) {
  EXPECT_NEAR(std::log(static_cast<double>(regions<Sagitta>(1e-8)) / static_cast<double>(regions<Sagitta>(1e-4))) /
                  std::log(1e4),
              0.5, 0.03);
  EXPECT_NEAR(std::log(static_cast<double>(regions<ba::Bca>(1e-8)) / static_cast<double>(regions<ba::Bca>(1e-4))) /
                  std::log(1e4),
              1 / 3.0, 0.03);
}

TEST(OwnMethod, IsDrawn) {
  const Hierarchy<Sagitta> hierarchy(ba::spiral_segments(curve()), 0.1, ba::Build_options());
  Loaded_curve loaded;
  loaded.record.name = "own";
  loaded.record.degree = 3;
  loaded.record.control_points = curve().control_points();
  std::ostringstream svg;
  draw_svg(svg, {{&loaded, &hierarchy}}, Sagitta::NAME, {"#ddd", "#555"}, 0.1);
  EXPECT_NE(svg.str().find("<title>sagitta, eps 0.1: " + std::to_string(hierarchy.size().regions) + " regions"),
            std::string::npos);
  EXPECT_NE(svg.str().find("fill:#ddd"), std::string::npos);
}

}  // namespace
}  // namespace test_own_method
