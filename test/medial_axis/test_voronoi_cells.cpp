// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Voronoi cells: they tile the regions, and the curve of a cell is the nearest one to its places.

#include "axis_checks.h"
#include "cases.h"
#include "closed_drawings.h"
#include "near_equal_discs.h"

#include <CGAL/Bounding_arcs_2.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <map>
#include <random>
#include <utility>
#include <vector>

namespace test_voronoi_cells {
namespace {

using namespace bounding_arcs_test;
using Tree = ba::Bounding_arc_tree_2;

double area_of(const std::vector<Point>& polygon) {
  double twice = 0;
  for (std::size_t i = 0; i < polygon.size(); ++i) twice += cross(polygon[i], polygon[(i + 1) % polygon.size()]);
  return twice / 2;
}
// How often a polygon winds round a point.
int winding(const std::vector<Point>& polygon, const Point& q) {
  int result = 0;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const Point a = polygon[i] - q, b = polygon[(i + 1) % polygon.size()] - q;
    if ((a.y > 0) != (b.y > 0) && (cross(a, b) > 0) == (b.y > 0)) result += b.y > 0 ? 1 : -1;
  }
  return result;
}
Medial_axis_2 framed_axis(const Tree& tree, double eps) {
  ba::Medial_axis_2::Options options;
  options.is_framed = true;
  return ba::medial_axis(tree, eps, options);
}

TEST(VoronoiCells, OfTheSidesOfARectangleAreTrianglesAndTrapezoids) {
  Drawing sides;
  const std::vector<Point> corners{{0, 0}, {4, 0}, {4, 2}, {0, 2}};
  Drawing closed = drawing_of(closed_chain(corners));
  const Tree of_one(closed);
  const Medial_axis_2 axis = ba::medial_axis(of_one, 1e-6);
  const auto one = ba::voronoi_cells(of_one, axis);  // one curve has all of the rectangle, and is on both sides
  ASSERT_EQ(one.size(), 1U);
  EXPECT_TRUE(one[0].is_whole);
  EXPECT_FALSE(one[0].is_reversed);
  EXPECT_NEAR(area_of(one[0].polygon(of_one, axis, 1)), 8, 1e-12);
  for (const auto& part : one[0].rim) EXPECT_EQ(part.beyond, 0U);

  for (std::size_t i = 0; i < 4; ++i) sides.add(Bezier({corners[i], corners[(i + 1) % 4]}));
  const Tree tree(ba::framed(sides, 1));
  const Medial_axis_2 all = framed_axis(tree, 1e-6);
  double inside[4] = {};
  for (const auto& cell : ba::voronoi_cells(tree, all)) {
    const double area = area_of(cell.polygon(tree, all, 1));
    EXPECT_GT(area, 0);
    if (cell.curve < 4 && !cell.is_reversed) inside[cell.curve] += area;
  }
  for (std::size_t i = 0; i < 4; ++i) EXPECT_NEAR(inside[i], i % 2 == 0 ? 3 : 1, 1e-12) << i;
}

TEST(VoronoiCells, OfACircleIsItsDisc) {
  const double root = std::sqrt(0.5);
  const std::vector<Point> corners{{1, 0}, {1, 1}, {0, 1}, {-1, 1}, {-1, 0}, {-1, -1}, {0, -1}, {1, -1}, {1, 0}};
  std::vector<Bezier> quarters;
  for (std::size_t i = 0; i < 8; i += 2)
    quarters.push_back(Bezier({corners[i], corners[i + 1], corners[i + 2]}, {1, root, 1}));
  Drawing circle;
  circle.add(quarters);
  const Tree tree(circle);
  const Medial_axis_2 axis = ba::medial_axis(tree, 1e-6);
  const auto cells = ba::voronoi_cells(tree, axis);
  ASSERT_EQ(cells.size(), 1U);
  EXPECT_TRUE(cells[0].rim.empty());
  EXPECT_NEAR(area_of(cells[0].polygon(tree, axis, 256)), 3.141592653589793, 1e-4);
}

const double SCALES[] = {1e-14, 1e-3, 1, 1e3, 1e5, 1e14};

// The cells of a drawing in a frame 1 away, all times a scale. Together they are the frame.
struct Scaled_cells {
  Scaled_cells(const Drawing& drawing, double scale)
      : scale(scale), tree(ba::framed(moved(drawing, scale, {0, 0}), scale)), axis(framed_axis(tree, 1e-3 * scale)),
        cells(ba::voronoi_cells(tree, axis)) {
    EXPECT_EQ(axis.status, Status::COMPLETE);
    const std::vector<Bezier>& frame = tree.drawing().curves().back().beziers;
    const Point way = (1 / scale) * (frame[1].control_points().back() - frame[0].control_points().front());
    double sum = 0;
    for (const auto& cell : cells) sum += area(cell);
    EXPECT_NEAR(sum, way.x * way.y, 1e-4 * way.x * way.y) << scale;
  }
  [[nodiscard]] double area(const Medial_axis_2::Cell& cell) const {
    std::vector<Point> polygon;
    for (const Point& p : cell.polygon(tree, axis, 256)) polygon.push_back((1 / scale) * p);
    return area_of(polygon);
  }
  // Of the cells on one side of a curve.
  [[nodiscard]] std::vector<Medial_axis_2::Cell> of(std::uint32_t curve, bool is_reversed) const {
    std::vector<Medial_axis_2::Cell> result;
    for (const auto& cell : cells)
      if (cell.curve == curve && cell.is_reversed == is_reversed) result.push_back(cell);
    return result;
  }

  double scale;
  Tree tree;
  Medial_axis_2 axis;
  std::vector<Medial_axis_2::Cell> cells;
};

const double QUARTER = std::atan(1.0);  // of the unit disc

// The arc from (1, 0) to (0, 1) about 0.
Bezier quarter_arc() { return circle_of_quarters().front(); }

TEST(VoronoiCells, HaveTheSectorOfAnArcThatMeetsOtherCurves) {
  for (const double scale : SCALES) {
    Drawing one = drawing_of({quarter_arc()});
    one.add(Bezier({{1, 0}, {3, -1}}));
    const auto sector = Scaled_cells(one, scale).of(0, false);
    ASSERT_EQ(sector.size(), 1U) << scale;
    EXPECT_EQ(sector[0].first.t, 0);
    EXPECT_EQ(sector[0].last.t, 1);
    EXPECT_FALSE(sector[0].is_whole);

    Drawing two = drawing_of({quarter_arc()});
    two.add(Bezier({{1, 0}, {1, -1}}));
    two.add(Bezier({{0, 1}, {-1, 1}}));
    const Scaled_cells of_two(two, scale);
    const auto alone = of_two.of(0, false);
    ASSERT_EQ(alone.size(), 1U) << scale;
    EXPECT_TRUE(alone[0].rim.empty());
    EXPECT_NEAR(of_two.area(alone[0]), QUARTER, 1e-4);
    const Point center = (1 / scale) * of_two.axis.vertices[alone[0].vertex].center;
    EXPECT_NEAR(center.x, 0, 1e-12);
    EXPECT_NEAR(center.y, 0, 1e-12);

    const Scaled_cells of_way(drawing_of({Bezier({{3, -1}, {1, 0}}), quarter_arc(), Bezier({{0, 1}, {0, 5}})}), scale);
    EXPECT_EQ(of_way.of(0, false).size(), 1U) << scale;
  }
}

TEST(VoronoiCells, HaveASectorForEachCurveRoundADisc) {
  for (const double scale : SCALES) {
    Drawing drawing;
    for (const Bezier& quarter : circle_of_quarters()) drawing.add(quarter);
    const Scaled_cells found(drawing, scale);
    for (std::uint32_t i = 0; i < 4; ++i) {
      const auto sector = found.of(i, false);
      ASSERT_EQ(sector.size(), 1U) << scale;
      EXPECT_TRUE(sector[0].rim.empty());
      EXPECT_FALSE(sector[0].is_whole);
      EXPECT_NEAR(found.area(sector[0]), QUARTER, 1e-4);
    }
  }
}

TEST(VoronoiCells, OfALoopLeadFromACrossingBackToIt) {
  for (const double scale : SCALES) {
    const Scaled_cells found(drawing_of({Bezier({{-26, 19}, {-50, -22}, {11, -10}, {-40, 21}})}), scale);
    int loops = 0;
    for (const auto& cell : found.cells) {
      if (cell.curve != 0) continue;
      EXPECT_FALSE(cell.is_whole) << scale;
      EXPECT_NE(cell.first.t, cell.last.t) << scale;
      const bool is_loop = !cell.is_reversed && cell.first.t > 0 && cell.last.t < 1;
      if (!is_loop) continue;
      ++loops;
      EXPECT_NEAR(cell.first.t, 0.049840958, 1e-9) << scale;
      EXPECT_NEAR(cell.last.t, 0.911753533, 1e-9) << scale;
    }
    EXPECT_EQ(loops, 1) << scale;
  }
}

TEST(VoronoiCells, AreWholeWhereRunsGoRoundAClosedCurve) {
  for (const double scale : SCALES) {
    // a line crosses the circle once: a run within goes from there all round
    Drawing crossed = drawing_of(circle_of_quarters());
    crossed.add(Bezier({{0.25, 0.5}, {2, 2}}));
    // one Bezier curve with a corner
    const Drawing drop = drawing_of({Bezier({{0, 0}, {4, 4}, {-4, 4}, {0, 0}})});
    for (const Drawing& drawing : {crossed, drop}) {
      const Scaled_cells found(drawing, scale);
      for (const bool is_reversed : {false, true}) {
        const auto cells = found.of(0, is_reversed);
        ASSERT_EQ(cells.size(), 1U) << scale;
        EXPECT_TRUE(cells[0].is_whole) << scale << ' ' << is_reversed;
      }
    }
  }
}

TEST(VoronoiCells, BeginAndEndAtParametersThatAreNotNegative) {
  Drawing drawing = drawing_of({Bezier({{-2, 4}, {-1, 4}, {-1, 5}}, {1, std::sqrt(0.5), 1})});
  drawing.add(Bezier({{-2, 4}, {-3, 4}}));
  const Scaled_cells found(drawing, 1);
  for (const auto& cell : found.cells)
    for (const double t : {cell.first.t, cell.last.t}) EXPECT_FALSE(std::signbit(t)) << cell.curve;
  for (const auto& edge : found.axis.edges)
    for (const auto& s : edge.samples)
      for (const double t : {s.left.t, s.right.t}) EXPECT_FALSE(std::signbit(t)) << s;
}

// Checks areas and the curves of random places.
void expect_cells(const Drawing& framed, std::mt19937& random, int count) {
  const Tree tree(framed);
  const double eps = 1e-4;
  const Medial_axis_2 axis = framed_axis(tree, eps);
  ASSERT_EQ(axis.status, Status::COMPLETE);
  const auto cells = ba::voronoi_cells(tree, axis);
  std::vector<std::vector<Point>> polygons;
  double area = 0;
  std::map<std::pair<std::size_t, std::size_t>, int> lines;  // of edges, each from both sides
  for (const auto& cell : cells) {
    polygons.push_back(cell.polygon(tree, axis, 64));
    area += area_of(polygons.back());
    for (const auto& part : cell.rim)
      for (std::size_t i = (std::min)(part.first, part.last); i < (std::max)(part.first, part.last); ++i)
        ++lines[{part.edge, i}];
  }
  std::size_t all = 0;
  for (const auto& e : axis.edges) all += e.samples.size() - 1;
  EXPECT_EQ(lines.size(), all);
  for (const auto& [line, times] : lines) EXPECT_EQ(times, 2);
  const auto& frame = framed.curves().back();
  double width[2] = {}, low[2] = {HUGE_VAL, HUGE_VAL};
  for (const auto& piece : frame.beziers)
    for (const Point& p : piece.control_points()) {
      low[0] = (std::min)(low[0], p.x), low[1] = (std::min)(low[1], p.y);
      width[0] = (std::max)(width[0], p.x), width[1] = (std::max)(width[1], p.y);
    }
  for (int k : {0, 1}) width[k] -= low[k];
  EXPECT_NEAR(area, width[0] * width[1], 2e-4 * area);
  std::uniform_real_distribution<double> unit(0, 1);
  int checked = 0;
  for (int i = 0; i < count; ++i) {
    const Point q{low[0] + width[0] * unit(random), low[1] + width[1] * unit(random)};
    const auto two = ba::k_nearest_curves(tree, {q.x, q.y}, 2);
    if (two.size() < 2 || two[1].distance.lower - two[0].distance.upper < 4 * eps) continue;
    if (two[0].distance.lower < 1e-2) continue;  // polygons cut off what is next to a curve
    int windings = 0;
    for (std::size_t k = 0; k < cells.size(); ++k) {
      const int w = winding(polygons[k], q);
      windings += w;
      if (w == 0) continue;
      EXPECT_EQ(cells[k].curve, two[0].place.curve) << q.x << ' ' << q.y;
    }
    EXPECT_EQ(windings, 1) << q.x << ' ' << q.y;
    ++checked;
  }
  EXPECT_GT(checked, count / 2);
}

TEST(VoronoiCells, TileAFrameOfRandomSplines) {
  std::mt19937 random(5);
  for (int i = cases(12); i > 0; --i)
    expect_cells(ba::framed(spline_field(random, 1 + random() % 3, 1 + random() % 3), 1), random, 100);
}

TEST(VoronoiCells, TileAFrameOfPointsAndOpenCurves) {
  std::mt19937 random(6);
  std::uniform_real_distribution<double> unit(0, 1);
  for (int i = cases(12); i > 0; --i) {
    Drawing drawing;
    for (int k = 0; k < 8; ++k) {
      const Point at{3.0 * k, 2 * unit(random)};
      const auto near = [&] { return at + Point{1.2 * unit(random), 1.2 * unit(random)}; };
      const Point joint = near();
      if (k % 4 == 0) drawing.add(Bezier({at, at}));
      else if (k % 4 == 1) drawing.add(Bezier({at, near()}));
      else if (k % 4 == 2) drawing.add(Bezier({at, near(), near(), near()}));
      else drawing.add({Bezier({at, joint}), Bezier({joint, near()})});
    }
    expect_cells(ba::framed(drawing, 1), random, 100);
  }
}

TEST(VoronoiCells, TileAFrameOfCurvesThatCross) {
  std::mt19937 random(7);
  std::uniform_real_distribution<double> unit(0, 4);
  for (int i = cases(12); i > 0; --i) {
    Drawing drawing;
    for (int k = 0; k < 4; ++k) drawing.add(Bezier({{unit(random), unit(random)}, {unit(random), unit(random)}}));
    expect_cells(ba::framed(drawing, 1), random, 100);
  }
}

}  // namespace
}  // namespace test_voronoi_cells
