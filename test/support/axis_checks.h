// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// What is checked of every axis, and drawings with holes.

#ifndef BOUNDING_ARCS_TEST_AXIS_CHECKS_H
#define BOUNDING_ARCS_TEST_AXIS_CHECKS_H

#include "query_drawings.h"

#include <CGAL/Bounding_arcs_2/boolean/boolean_operations.h>
#include <CGAL/Bounding_arcs_2/medial_axis/medial_axis.h>
#include <CGAL/Bounding_arcs_2/query/closest_point.h>
#include <CGAL/Bounding_arcs_2/query/point_location.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <vector>

namespace bounding_arcs_test {

using ba::Medial_axis_2;
using Status = ba::Medial_axis_2::Status;

inline Drawing reversed(const Drawing& drawing) {
  Drawing result;
  for (const auto& curve : drawing.curves()) {
    std::vector<Bezier> chain;
    for (auto piece = curve.beziers.rbegin(); piece != curve.beziers.rend(); ++piece)
      chain.push_back(piece->reversed());
    result.add(std::move(chain), curve.name);
  }
  return result;
}
inline Drawing both(const std::vector<Bezier>& outer, const std::vector<Bezier>& inner) {
  Drawing drawing = drawing_of(outer);
  const Drawing hole = reversed(drawing_of(inner));
  drawing.add(hole.curves().front().beziers);
  return drawing;
}
inline Medial_axis_2 axis_of(const Drawing& drawing, double eps = 1e-6) {
  return ba::medial_axis(ba::Bounding_arc_tree_2(drawing), eps);
}

inline std::size_t leaves_of(const Medial_axis_2& axis) {
  const auto all = axis.degrees();
  return static_cast<std::size_t>(std::count(all.begin(), all.end(), 1U));
}
// The vertex at a point. It has to be there.
inline const ba::Medial_axis_2::Vertex& vertex_at(const Medial_axis_2& axis, const Point& p, double room) {
  for (const auto& v : axis.vertices)
    if (std::hypot(v.center.x - p.x, v.center.y - p.y) <= room) return v;
  ADD_FAILURE() << "no vertex at " << p.x << " " << p.y;
  static const ba::Medial_axis_2::Vertex none;
  return none;
}

// What bounds the regions that closed curves fill: parts of them.
inline Drawing walls_of(const Drawing& drawing, ba::Fill_rule rule) {
  const ba::Bounding_arc_tree_2 tree(drawing);
  return ba::drawn_outline({&tree}, ba::outline(tree, rule), {false}).drawing;
}

// Complete, with Euler's relation; no disc has a wall in it, each touches at both feet, and between samples both are
// so within eps. Where curves cross, their parameters are known within some 1e-14.
inline void expect_sound(const Drawing& drawing, const Drawing& walls, const Medial_axis_2& axis, double eps,
                         double rounding) {
  const ba::Bounding_arc_tree_2 index(walls, ba::Decisions::DOUBLE);
  const double room = rounding * size_of(drawing);
  EXPECT_EQ(axis.status, Status::COMPLETE);
  EXPECT_EQ(axis.vertices.size() + axis.holes, axis.edges.size() + axis.regions);
  EXPECT_LE(axis.error, room);
  const auto expect_distance = [&](const Point& p, double r, double tolerance) {
    const auto d = ba::closest_point(index, p)->distance;
    EXPECT_GE(d.upper, r - tolerance);  // next to cusps d.lower may be far below
    EXPECT_LE(d.upper, r + tolerance);
  };
  const auto expect_foot = [&](const ba::Curve_place& p, const Point& center, double r) {
    const Point q = drawing.curves()[p.curve].beziers[p.bezier].point(p.t);
    EXPECT_NEAR(std::hypot(q.x - center.x, q.y - center.y), r, room);
  };
  for (const auto& v : axis.vertices)
    for (const auto& p : v.touches) expect_foot(p, v.center, v.radius);
  for (const auto& e : axis.edges) {
    ASSERT_GE(e.samples.size(), 2U);
    EXPECT_EQ(e.samples.front().center, axis.vertices[e.from].center);
    EXPECT_EQ(e.samples.back().center, axis.vertices[e.to].center);
    for (std::size_t i = 0; i < e.samples.size() && !testing::Test::HasFailure(); ++i) {
      const auto& s = e.samples[i];
      expect_distance(s.center, s.radius, room);
      expect_foot(s.left, s.center, s.radius);
      expect_foot(s.right, s.center, s.radius);
      if (i == 0) continue;
      const auto& before = e.samples[i - 1];
      expect_distance(0.5 * (before.center + s.center), 0.5 * (before.radius + s.radius), eps);
    }
  }
}

// The same where all curves are walls.
inline void expect_sound(const Drawing& drawing, const Medial_axis_2& axis, double eps, double rounding = 2e-13) {
  expect_sound(drawing, drawing, axis, eps, rounding);
}

// The axis of a drawing whose last curve is a frame.
inline Medial_axis_2 framed_axis_of(const Drawing& drawing, double eps = 1e-6) {
  ba::Medial_axis_2::Options options;
  options.is_framed = true;
  return ba::medial_axis(ba::Bounding_arc_tree_2(drawing), eps, options);
}

inline double distance(const Point& q, const Point& a, const Point& b) {
  const Point way = b - a;
  const double square = way.x * way.x + way.y * way.y;
  const double t = square > 0 ? ((q.x - a.x) * way.x + (q.y - a.y) * way.y) / square : 0;
  const Point foot = a + std::clamp(t, 0.0, 1.0) * way;
  return std::hypot(q.x - foot.x, q.y - foot.y);
}
// Nothing is missing: from random points inside, discs that touch where the point is nearest grow, by bisection
// with distances, until they touch elsewhere; their centers are on the axis.
template <class Is_inside>
void expect_whole(const Drawing& drawing, const Medial_axis_2& axis, std::mt19937& random, int count,
                  const Is_inside& is_inside) {
  const ba::Bounding_arc_tree_2 index(drawing, ba::Decisions::DOUBLE);
  const double size = size_of(drawing);
  std::uniform_real_distribution<double> coordinate(-size, size);
  for (int i = 0; i < count; ++i) {
    const Point q{coordinate(random), coordinate(random)};
    const auto nearest = ba::closest_point(index, q);
    const double d = nearest->distance.lower;
    if (!(d > 1e-3 * size) || !is_inside(q)) continue;
    const Point p = nearest->point, way = q - p, normal = (1 / std::hypot(way.x, way.y)) * way;
    double low = d, high = 8 * size;
    for (int k = 0; k < 60; ++k) {
      const double r = (low + high) / 2;
      (ba::closest_point(index, p + r * normal)->distance.upper < r - 1e-9 * size ? high : low) = r;
    }
    const Point center = p + low * normal;
    double least = HUGE_VAL;
    for (const auto& v : axis.vertices) least = (std::min)(least, distance(center, v.center, v.center));
    for (const auto& e : axis.edges)
      for (std::size_t k = 1; k < e.samples.size(); ++k)
        least = (std::min)(least, distance(center, e.samples[k - 1].center, e.samples[k].center));
    // where discs grow along a curve that hardly bends away, 1e-9 of the distance is much of the radius
    EXPECT_LE(least, 2e-3 * size) << "at " << center.x << " " << center.y << ", radius " << low;
  }
}
// The same of a drawing whose last curve is a frame.
inline void expect_whole(const Drawing& drawing, const Medial_axis_2& axis, std::mt19937& random, int count) {
  const ba::Bounding_arc_tree_2 frame(drawing_of(drawing.curves().back().beziers));
  expect_whole(drawing, axis, random, count,
               [&](const Point& q) { return ba::locate(frame, q) == CGAL::ON_BOUNDED_SIDE; });
}

}  // namespace bounding_arcs_test

#endif
