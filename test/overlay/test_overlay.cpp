// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// What curves cut the plane into: known drawings.

#include "closed_drawings.h"
#include "overlaid.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdint>
#include <optional>
#include <random>
#include <stdexcept>
#include <utility>
#include <vector>

namespace test_overlay {

using namespace bounding_arcs_test;

std::vector<Bezier> square(double low, double high) {
  return polygon({{low, low}, {high, low}, {high, high}, {low, high}});
}
std::vector<Bezier> reversed(std::vector<Bezier> chain) {
  std::reverse(chain.begin(), chain.end());
  for (Bezier& b : chain) b = b.reversed();
  return chain;
}

TEST(Overlay, HasTwoCirclesThatCross) {
  const Overlaid found({drawing_of(circle_of_quarters()), drawing_of(circle_of_quarters({1, 1, 0}))});
  expect_counts(found.cells(), 2, 4, 4);
  for (const auto& v : found.cells().vertices) {
    EXPECT_NEAR(v.point.x, 0.5, 1e-15);
    EXPECT_NEAR(std::fabs(v.point.y), std::sqrt(0.75), 1e-15);
    EXPECT_LT(v.y.width(), 4e-14);
  }
  EXPECT_EQ(windings_of(found.cells()), (std::vector<std::vector<int>>{{0, 0}, {0, 1}, {1, 0}, {1, 1}}));
  const double disc = 3.14159265358979324, lens = 2 * disc / 3 - std::sqrt(3.0) / 2;
  const std::vector<double> areas = found.areas();
  EXPECT_NEAR(areas[0], lens, 1e-11);
  EXPECT_NEAR(areas[1], disc - lens, 1e-11);
  EXPECT_NEAR(areas[2], disc - lens, 1e-11);
  // each circle has 4 joints, too
  expect_counts(Overlaid(found.drawings(), AT_JOINTS).cells(), 10, 12, 4);
}

// Far away, where the ends of parts of arcs are rounded by much more than what areas leave open.
TEST(Overlay, HasAreasOfFacesBetweenArcs) {
  const double common = 2 * std::acos(-1.0) / 3 - std::sqrt(3) / 2, only = std::acos(-1.0) - common;
  for (const double far : {0.0, 1024.0}) {
    const Overlaid found(
        {drawing_of(circle_of_quarters({1, far, -far})), drawing_of(circle_of_quarters({1, far + 1, -far}))});
    expect_counts(found.cells(), 2, 4, 4);
    for (std::uint32_t f = 1; f < 4; ++f) {
      const ba::Measure_bounds area = found.area(f, 1e-13);
      const double exact = found.cells().windings(f) == std::vector<int>{1, 1} ? common : only;
      EXPECT_TRUE(area.lower <= exact + 1e-15 && exact - 1e-15 <= area.upper) << area.lower << ' ' << exact;
      EXPECT_EQ(area.status, ba::Query_status::COMPLETE) << area.upper - area.lower;
    }
  }
}

TEST(Overlay, HasClosedCurvesWithoutVertices) {
  const Drawing circle = drawing_of(circle_of_quarters());
  const Overlaid found({circle}), cut({drawing_of(Bezier({{0, 0}, {3, 0}, {0, 3}, {0, 0}}))}, AT_JOINTS);
  expect_counts(found.cells(), 0, 1, 2);
  EXPECT_FALSE(found.cells().edges.front().from || found.cells().edges.front().to);
  EXPECT_EQ(found.cells().edges.front().sources.front().parts.size(), 4u);
  EXPECT_TRUE(found.cells().edges.front().sources.front().is_closed);
  expect_counts(cut.cells(), 1, 1, 2);
  EXPECT_EQ(cut.cells().edges.front().from, 0u);
  EXPECT_EQ(cut.cells().edges.front().to, 0u);
}

TEST(Overlay, HasOneEdgeWhereCurvesRunTogether) {
  const std::vector<Bezier> a = square(0, 2);
  Drawing both;
  both.add(a);
  both.add(reversed(a));
  const Overlaid same({drawing_of(a), both});
  expect_counts(same.cells(), 4, 4, 2);
  for (const ba::Overlay_2::Edge& e : same.cells().edges) {
    ASSERT_EQ(e.sources.size(), 3u);
    int against = 0;
    for (const ba::Overlay_2::Source& s : e.sources) {
      against += s.is_reversed ? 1 : 0;
      ASSERT_EQ(s.parts.size(), 1u);
      EXPECT_EQ(s.parts.front().from.lower, s.is_reversed ? 1 : 0);
      EXPECT_EQ(s.parts.front().to.lower, s.is_reversed ? 0 : 1);
    }
    EXPECT_EQ(against, 1);
  }
  EXPECT_EQ(windings_of(same.cells()), (std::vector<std::vector<int>>{{0, 0}, {1, 0}}));
  // a part of a side: three quarters of a longer line
  const Overlaid along({drawing_of(a), drawing_of(segment({-1, 0}, {3, 0}))});
  expect_counts(along.cells(), 4, 4, 2);
  const auto shared = std::find_if(along.cells().edges.begin(), along.cells().edges.end(),
                                   [](const ba::Overlay_2::Edge& e) { return e.sources.size() == 2; });
  ASSERT_NE(shared, along.cells().edges.end());
  EXPECT_EQ(shared->sources[1].parts.front().from.lower, 0.25);
  EXPECT_EQ(shared->sources[1].parts.front().to.upper, 0.75);
  EXPECT_FALSE(shared->sources[1].is_closed);
}

TEST(Overlay, HasFacesWithinFaces) {
  Drawing first, second;  // a ring, and in its hole a square with a stroke beside it
  first.add(square(0, 9));
  first.add(reversed(square(1, 8)));
  second.add(square(2, 4));
  second.add(segment({5, 5}, {6, 6}));
  const Overlaid found({first, second});
  expect_counts(found.cells(), 2, 4, 4);
  std::mt19937 random(1);
  EXPECT_EQ(expect_sound(found, random), 4);
  std::map<std::vector<int>, std::size_t> boundaries;
  for (std::uint32_t f = 1; f < found.cells().faces.size(); ++f)
    boundaries[found.cells().windings(f)] = found.cells().faces[f].boundaries.size();
  EXPECT_EQ(boundaries, (std::map<std::vector<int>, std::size_t>{{{1, 0}, 2}, {{0, 0}, 3}, {{0, 1}, 1}}));
  EXPECT_EQ(found.cells().faces[0].boundaries.size(), 1u);
  for (const ba::Overlay_2::Face& face : found.cells().faces)
    for (const auto& boundary : face.boundaries)
      if (face.boundaries.size() == 3 && boundary.size() == 2) {  // both sides of the stroke
        EXPECT_EQ(boundary[0].edge, boundary[1].edge);
        EXPECT_NE(&boundary, &face.boundaries.front());
      }
  const std::vector<double> areas = found.areas(1e-9);
  EXPECT_EQ(areas, (std::vector<double>{4, 32, 45}));
}

TEST(Overlay, HasPointsThatAreCurves) {
  Drawing points;
  points.add(square(0, 4));
  points.add(reversed(square(1, 3)));
  for (const Point& p : {Point{2, 2}, Point{2, 2}, Point{0.5, 2}, Point{0, 2}, Point{7, 7}})
    points.add(Bezier({p, p, p}));
  for (const ba::Overlay_2::Options& options : {ba::Overlay_2::Options{}, AT_JOINTS}) {
    const Overlaid found({points}, options);
    // (0, 2) cuts the outer square once
    expect_counts(found.cells(), options.at_joints ? 12 : 4, options.at_joints ? 9 : 2, 3);
    std::mt19937 random(1);
    expect_sound(found, random);
    std::map<double, int> winding;  // of the face of points without edges, by x
    for (const ba::Overlay_2::Vertex& v : found.cells().vertices)
      if (v.face) winding[v.point.x] = found.cells().windings(*v.face).front();
    EXPECT_EQ(winding, (std::map<double, int>{{0.5, 1}, {2, 0}, {7, 0}}));
    for (const ba::Overlay_2::Vertex& v : found.cells().vertices)
      EXPECT_TRUE(!(v.point == Point{2, 2}) || found.cells().faces[*v.face].is_bounded);
  }
}

TEST(Overlay, HasOpenCurvesThatRunRoundNothing) {
  Drawing open;  // a U over the square, its ends outside
  open.add({segment({-1, 3}, {-1, 1}), segment({-1, 1}, {3, 1}), segment({3, 1}, {3, 3})});
  const Overlaid found({open, drawing_of(square(0, 2))});
  expect_counts(found.cells(), 4, 5, 3);
  EXPECT_EQ(windings_of(found.cells()), (std::vector<std::vector<int>>{{0, 0}, {0, 1}, {0, 1}}));
  for (const double area : found.areas()) EXPECT_NEAR(area, 2, 1e-15);
}

TEST(Overlay, TakesManyTreesAndNone) {
  const Filtered_tree a(drawing_of(square(0, 4))), b(drawing_of(square(2, 6))), c(drawing_of(square(3, 5)));
  const Overlay_2 cells = ba::overlay({&a, &b, &c});
  expect_counts(cells, 4, 8, 6);
  EXPECT_EQ(windings_of(cells),
            (std::vector<std::vector<int>>{{0, 0, 0}, {0, 1, 0}, {0, 1, 1}, {1, 0, 0}, {1, 1, 0}, {1, 1, 1}}));
  for (std::uint32_t f = 1; f < cells.faces.size(); ++f) {
    const int all = cells.windings(f)[0] + cells.windings(f)[1] + cells.windings(f)[2];
    EXPECT_TRUE(all != 3 || std::fabs(cells.face_area({&a, &b, &c}, f, 1e-9).lower - 1) < 1e-15);
  }
  expect_counts(ba::overlay(std::vector<const ba::Bounding_arc_tree_2*>{}), 0, 0, 1);
  expect_counts(ba::overlay(Filtered_tree(Drawing())), 0, 0, 1);
  expect_counts(ba::overlay(a, b), 2, 4, 4);
  EXPECT_THROW((void)cells.face_area({&a, &b, &c}, 0, 1e-9), std::invalid_argument);
  EXPECT_THROW((void)cells.face_area({&a, &b, &c}, 1, -1), std::invalid_argument);
}

// A curve that runs round itself twice has a face in which it does.
TEST(Overlay, CountsTurnsOfACurve) {
  const Overlaid found({drawing_of(Bezier({{0, 0}, {4, 4}, {-3, 4}, {1, 0}})),
                        drawing_of(polygon({{0, 0}, {2, 0}, {2, 2}, {0, 2}, {0, 0}, {1, 0}, {1, 1}, {0, 1}}))});
  const auto windings = windings_of(found.cells());
  EXPECT_EQ(windings.back().back(), 2);
  std::mt19937 random(1);
  EXPECT_GT(expect_sound(found, random), 4);
}

// An end two ulp beside the end of another segment, and a hairpin between two lines: edges and faces of some ulp.
TEST(Overlay, HasEdgesShorterThanAnUlp) {
  Drawing ends, hairpin;
  const double end = std::nextafter(1.0, 2.0);
  ends.add(segment({0, 0}, {end, 0}));
  ends.add(segment({1, 0}, {1, 1}));
  expect_counts(Overlaid({ends}).cells(), 4, 3, 1);
  hairpin.add(Bezier({{0, 1}, {1e-15, -1}, {2e-15, 1}}));
  hairpin.add(segment({-1, 0.5}, {1, 0.5}));
  const Overlaid found({hairpin});
  expect_counts(found.cells(), 6, 6, 2);
  EXPECT_GT(found.area(1, 1e-30).upper, 0);
  EXPECT_LT(found.area(1, 1e-9).upper, 1e-15);
  // corners of the unit square nearer to each other than the parameters of either side tell
  Drawing corner;
  corner.add(segment({-1, 0}, {1, 0}));
  corner.add(segment({0, -0x1p-70}, {0x1p-70, 0x1p-71}));
  corner.add(segment({0x1p-70, -0x1p-70}, {0, 0x1p-71}));
  expect_counts(Overlaid({corner}).cells(), 9, 9, 2);
}

// Two crossings with the same parameters on one curve and nearly so on the other; any brackets hold them, but only some
// hold both. A curve meets another one where that is going and coming back.
TEST(Overlay, TellsMeetingsApartThatShareBrackets) {
  Drawing near, folded;
  near.add(Bezier({{0.30000000000000004, 0.1}, {0.2, 0.1}, {0.30000000000000004, -0.1}}));
  near.add(Bezier({{0.30000000000000004, -0.30000000000000004},
                   {0.20000000000000007, 0.2},
                   {0.29999999999999993, 0.09999999999999998}}));
  expect_counts(Overlaid({near}).cells(), 7, 8, 3);
  folded.add(Bezier({{0.33333333333333326, -1}, {-2.873591008795568e-16, -0.33333333333333304}, {-1, -1}}));
  folded.add(Bezier({{-1, -1}, {0.6666666666666662, -0.33333333333333304}, {-1, -1}}));
  expect_counts(Overlaid({folded}).cells(), 4, 4, 2);
}

// A line that turns back nearer to its end than parameters tell, where two control points are one.
TEST(Overlay, HasFoldsBesideEnds) {
  const double y = -2.9999999999999991;
  const Bezier line({{-2, y}, {std::nextafter(-0.5, 0), y}, {-0.5, y}, {-0.5, y}});
  for (const Bezier& b : {line, line.reversed()}) expect_counts(Overlaid({drawing_of({b})}).cells(), 3, 2, 1);
}

TEST(Overlay, HoldsPointsThatAreNoDoubles) {
  ba::Drawing_2<Number> drawing;
  const auto add = [&](const Exact_point& p, const Exact_point& q) {
    drawing.add(ba::Bezier_curve_2<Number>(std::vector<Exact_point>{p, q}));
  };
  const Number third = Number(1) / Number(3);
  add({Number(0), third}, {Number(1), third});
  add({third, Number(0)}, {third, Number(1)});
  const Exact_tree tree(drawing);
  const Overlay_2 cells = ba::overlay(tree);
  expect_counts(cells, 5, 4, 1);
  int count = 0;
  for (const ba::Overlay_2::Vertex& v : cells.vertices) {
    if (!(std::fabs(v.point.x - v.point.y) < 1e-9)) continue;
    ++count;
    for (const ba::Bracket& b : {v.x, v.y}) {
      EXPECT_TRUE(Number(b.lower) < third && third < Number(b.upper));
      EXPECT_LT(b.width(), 1e-14);
    }
  }
  EXPECT_EQ(count, 1);
}

TEST(Overlay, IsUndecidedWhereDoublesAlone) {
  const Double_tree a(drawing_of(circle_of_quarters())), b(drawing_of(circle_of_quarters({1, 2, 0})));
  const Overlay_2 cells = ba::overlay(a, b);
  EXPECT_EQ(cells.status, ba::Overlay_2::Status::UNDECIDED);
  EXPECT_TRUE(cells.faces.empty() && cells.edges.empty() && cells.vertices.empty());
  ASSERT_TRUE(cells.undecided);
  EXPECT_NEAR(cells.undecided->at.x, 1, 1e-6);
  EXPECT_NE(cells.undecided->a.operand, cells.undecided->b.operand);
}

}  // namespace test_overlay
