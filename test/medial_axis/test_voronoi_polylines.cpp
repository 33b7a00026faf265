// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Medial axes beside Voronoi diagrams of fine polylines: discs of either whose feet are seen under a large angle are
// as near to the other as stability has it (polyline_voronoi.h).

#include "axis_checks.h"
#include "cases.h"
#include "closed_drawings.h"
#include "polyline_voronoi.h"

#include <CGAL/Bounding_arcs_2/curve/Curve_file.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <string>
#include <vector>

namespace test_voronoi_polylines {
namespace {

using namespace bounding_arcs_test;

std::vector<Axis_piece> pieces_of(const Medial_axis_2& axis) {
  std::vector<Axis_piece> pieces;
  for (const auto& e : axis.edges)
    for (std::size_t i = 1; i < e.samples.size(); ++i)
      pieces.push_back(
          {{e.samples[i - 1].center, e.samples[i - 1].radius}, {e.samples[i].center, e.samples[i].radius}});
  return pieces;
}
std::vector<Disc> discs_of(const Medial_axis_2& axis, const Drawing& drawing, double angle) {
  const auto point = [&](const ba::Curve_place& p) { return drawing.curves()[p.curve].beziers[p.bezier].point(p.t); };
  std::vector<Disc> discs;
  for (const auto& e : axis.edges)
    for (const auto& s : e.samples)
      if (angle_at(s.center, point(s.left), point(s.right)) >= angle) discs.push_back({s.center, s.radius});
  return discs;
}

struct Compared {
  std::size_t count = 0;
  double distance = 0, radius = 0;  // the largest ones, to the nearest point and of the radius there
};
// Of discs that stability speaks of, inside.
Compared compared(const std::vector<Disc>& discs, const std::vector<Axis_piece>& pieces,
                  const ba::Bounding_arc_tree_2& index, double least_radius) {
  Compared result;
  for (const Disc& d : discs) {
    if (d.radius < least_radius || ba::locate(index, d.center) != CGAL::ON_BOUNDED_SIDE) continue;
    ++result.count;
    double least = HUGE_VAL, radius = 0;
    for (const Axis_piece& piece : pieces) {
      const Point way = piece.to.center - piece.from.center, to = d.center - piece.from.center;
      const double square = dot(way, way), t = square > 0 ? std::clamp(dot(to, way) / square, 0.0, 1.0) : 0;
      const Point apart = to - t * way;
      if (!(dot(apart, apart) < least)) continue;
      least = dot(apart, apart);
      radius = piece.from.radius + t * (piece.to.radius - piece.from.radius);
    }
    result.distance = (std::max)(result.distance, std::sqrt(least));
    result.radius = (std::max)(result.radius, std::fabs(radius - d.radius));
  }
  return result;
}

constexpr double SHARE = FEW_CASES ? 1e-4 : 1e-5;  // of the size, that polylines are within

// \param angle under which feet are seen of what has to be in the other one, too
void expect_alike(const std::string& name, const Drawing& drawing, double angle) {
  SCOPED_TRACE(name);
  const double h = SHARE * size_of(drawing);
  const ba::Bounding_arc_tree_2 index(drawing);
  const double eps = h / 10;
  const Medial_axis_2 axis = ba::medial_axis(index, eps);
  const Polyline_voronoi voronoi(drawing, h, angle);
  const Stability& stable = voronoi.stability();
  const double least_radius = stable.least_radius();

  const Compared ours = compared(discs_of(axis, drawing, angle), voronoi.pieces(), index, least_radius);
  EXPECT_LE(ours.distance, stable.bound() + h);  // parabolas are within h of their pieces
  // Our axis has no kinks, so that all of it is searched in.
  const Compared theirs = compared(voronoi.discs(), pieces_of(axis), index, least_radius);
  EXPECT_LE(theirs.distance, stable.bound() + eps);
  EXPECT_LE(theirs.radius, theirs.distance + stable.h + 2 * eps);  // it changes by no more than the place
  constexpr std::size_t FEW = FEW_CASES ? 100 : 1000;
  EXPECT_GE(ours.count, FEW);
  EXPECT_GE(theirs.count, FEW);
  testing::Test::RecordProperty(name + std::to_string(angle), std::to_string(ours.distance / h) + " and " +
                                                                  std::to_string(theirs.distance / h) + " h");
}
void expect_alike(const std::string& name, const Drawing& drawing) {
  for (const double angle : {1.0, 2.0}) expect_alike(name, drawing, angle);
}

TEST(MedialAxis, IsTheVoronoiDiagramOfFinePolylines) {
  for (const std::string name : {"a_wrench", "d_rabbit", "h_maple_leaf"})
    expect_alike(name, ba::drawing<double>(
                           ba::read_curve_file(std::string(BOUNDING_ARCS_EXAMPLE_DATA) + "/" + name + ".json").curves));
}

TEST(MedialAxis, IsTheVoronoiDiagramOfFinePolylinesAroundHoles) {
  std::mt19937 random(21);
  Drawing drawing = moved(drawing_of(closed_curve(random, {0, 0}, 9)), 4, {0, 0});
  for (const double x : {-0.6, 0.6}) {
    const Drawing hole = reversed(moved(drawing_of(closed_curve(random, {0, 0}, 5)), 0.4, {x, 0.1}));
    drawing.add(hole.curves().front().beziers);
  }
  expect_alike("two_holes", drawing);
  expect_alike("a_circle", both(polygon({{0, 0}, {6, 0}, {6, 5}, {2, 4}, {0, 6}}), circle({3.5, 2}, 1)));
}

}  // namespace
}  // namespace test_voronoi_polylines
