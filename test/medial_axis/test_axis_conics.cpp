// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Axes as conics: maximal discs between samples are as near as told, and known bisectors are found.

#include "axis_checks.h"
#include "cases.h"
#include "closed_drawings.h"

#include <CGAL/Bounding_arcs_2/curve/Curve_file.h>
#include <CGAL/Bounding_arcs_2/medial_axis/axis_conics.h>
#include <CGAL/Bounding_arcs_2/medial_axis/maximal_disc.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>
#include <stdexcept>
#include <vector>

namespace test_axis_conics {
namespace {

using namespace bounding_arcs_test;
using Conics = std::vector<std::vector<ba::Medial_axis_2::Conic>>;

Conics conics_of(const Drawing& drawing, const Medial_axis_2& axis, double eps) {
  return ba::axis_conics(ba::Bounding_arc_tree_2(drawing), axis, eps);
}

Point at(const ba::Medial_axis_2::Conic& c, double t) {
  const double a = (1 - t) * (1 - t), b = 2 * c.weight * t * (1 - t), d = t * t;
  return (1 / (a + b + d)) * (a * c.points[0] + b * c.points[1] + d * c.points[2]);
}

Point point_of(const Drawing& drawing, const ba::Curve_place& p) {
  return drawing.curves()[p.curve].beziers[p.bezier].point(p.t);
}

double distance_from(const ba::Medial_axis_2::Conic& c, const Point& q) {
  double best = 0, nearest = std::numeric_limits<double>::infinity();
  constexpr int PLACES = 64;
  for (int i = 0; i <= PLACES; ++i) {
    const double d = euclidean_norm(at(c, i / double(PLACES)) - q);
    if (d < nearest) nearest = d, best = i / double(PLACES);
  }
  double low = (std::max)(0.0, best - 1.0 / PLACES), high = (std::min)(1.0, best + 1.0 / PLACES);
  for (int i = 0; i < 60; ++i) {
    const double a = low + (high - low) / 3, b = high - (high - low) / 3;
    if (euclidean_norm(at(c, a) - q) < euclidean_norm(at(c, b) - q)) high = b;
    else low = a;
  }
  return euclidean_norm(at(c, low) - q);
}

// One after the other, from centers of samples to centers of samples.
void expect_chains(const Medial_axis_2& axis, const Conics& conics) {
  ASSERT_EQ(conics.size(), axis.edges.size());
  for (std::size_t e = 0; e < conics.size(); ++e) {
    const auto& samples = axis.edges[e].samples;
    std::size_t next = 0;
    for (const ba::Medial_axis_2::Conic& c : conics[e]) {
      EXPECT_EQ(c.first, next);
      EXPECT_GT(c.last, c.first);
      EXPECT_EQ(c.points[0], samples[c.first].center);
      EXPECT_EQ(c.points[2], samples[c.last].center);
      EXPECT_GT(c.weight, 0);
      next = c.last;
    }
    EXPECT_EQ(next, samples.size() - 1);
  }
}

TEST(AxisConics, AreLinesInASquare) {
  const Drawing square = drawing_of(polygon({{0, 0}, {1, 0}, {1, 1}, {0, 1}}));
  const Medial_axis_2 axis = axis_of(square);
  const Conics conics = conics_of(square, axis, 1e-6);
  expect_chains(axis, conics);
  for (const auto& edge : conics) {
    ASSERT_EQ(edge.size(), 1u);
    const ba::Medial_axis_2::Conic& c = edge[0];
    EXPECT_NEAR(cross(c.points[1] - c.points[0], c.points[2] - c.points[0]), 0, 1e-14);
  }
}

// Places as far from a corner as from a line are on a parabola, with the corner as its focus.
TEST(AxisConics, AreParabolasAtAReflexCorner) {
  const Drawing shape = drawing_of(polygon({{0, 0}, {4, 0}, {4, 3}, {3, 3}, {3, 1}, {0, 1.2}}));
  const Medial_axis_2 axis = axis_of(shape);
  const Point focus{3, 1};
  std::size_t parabolas = 0;
  const Conics conics = conics_of(shape, axis, 1e-9);
  expect_chains(axis, conics);
  for (const auto& edge : conics)
    for (const ba::Medial_axis_2::Conic& c : edge) {
      if (!(c.left.from == c.left.to) && !(c.right.from == c.right.to)) continue;
      const ba::Arc_2& line = c.left.from == c.left.to ? c.right : c.left;
      if (std::fabs(cross(c.points[1] - c.points[0], c.points[2] - c.points[0])) < 1e-6) continue;
      ++parabolas;
      EXPECT_NEAR(c.weight, 1, 1e-9);
      EXPECT_LE(c.error, 1e-9);
      for (const double t : {0.1, 0.5, 0.8}) {
        const Point q = at(c, t);
        EXPECT_NEAR(euclidean_norm(q - focus), std::fabs(signed_distance(q, line)), 1e-12);
      }
    }
  EXPECT_GE(parabolas, 2u);
  EXPECT_LE(parabolas, 6u);  // one a piece of the boundary, not one a sample
}

// Between two circles, one in the other, centers are on an ellipse with their centers as foci.
TEST(AxisConics, AreEllipsesBetweenCircles) {
  const auto circle = [&](double x, double r, bool is_ccw) {
    std::vector<Bezier> pieces;
    const double w = std::sqrt(0.5);
    const Point corners[] = {{r, r}, {-r, r}, {-r, -r}, {r, -r}}, ends[] = {{r, 0}, {0, r}, {-r, 0}, {0, -r}};
    for (int i = 0; i < 4; ++i) {
      const auto to = [&](const Point& p) { return Point{p.x + x, p.y}; };
      const Point a = to(ends[i]), b = to(corners[i]), c = to(ends[(i + 1) % 4]);
      if (is_ccw) pieces.emplace_back(std::vector<Point>{a, b, c}, std::vector<double>{1, w, 1});
      else pieces.insert(pieces.begin(), Bezier(std::vector<Point>{c, b, a}, std::vector<double>{1, w, 1}));
    }
    return pieces;
  };
  const Drawing ring = both(circle(0, 2, true), circle(0.3, 0.5, false));
  const Medial_axis_2 axis = axis_of(ring, 1e-6);
  const Conics conics = conics_of(ring, axis, 1e-9);
  expect_chains(axis, conics);
  std::size_t count = 0;
  for (const auto& edge : conics)
    for (const ba::Medial_axis_2::Conic& c : edge) {
      ++count;
      EXPECT_LT(c.weight, 1);
      for (const double t : {0.0, 0.3, 0.5, 0.9}) {
        const Point q = at(c, t);
        EXPECT_NEAR(euclidean_norm(q) + euclidean_norm(q - Point{0.3, 0}), 2.5, 1e-12);
      }
    }
  EXPECT_LE(count, 16u);
}

// Maximal discs at places of the boundary, which no sample has.
TEST(AxisConics, AreAsNearToMaximalDiscsAsTold) {
  std::mt19937 random(2026);
  std::uniform_real_distribution<double> unit(0, 1);
  std::size_t asked = 0;
  for (int round = 0; round < cases(12); ++round) {
    const Drawing drawing = drawing_of(closed_curve(random, {0, 0}, 5 + random() % 9));
    for (const double eps : {1e-4, 1e-6}) {
      const Medial_axis_2 axis = axis_of(drawing, eps);
      if (axis.status != Status::COMPLETE) continue;
      const ba::Bounding_arc_tree_2 tree(drawing);
      const ba::Maximal_discs_2 discs(tree);
      const Conics conics = ba::axis_conics(tree, axis, eps);
      expect_chains(axis, conics);
      for (std::size_t e = 0; e < conics.size(); ++e)
        for (const ba::Medial_axis_2::Conic& c : conics[e]) {
          const auto &s = axis.edges[e].samples[c.first], &t = axis.edges[e].samples[c.last];
          EXPECT_LE(c.error, eps);
          if (s.left.curve != t.left.curve || s.left.bezier != t.left.bezier || s.left.t == t.left.t) continue;
          const ba::Curve_place place{s.left.curve, s.left.bezier, s.left.t + unit(random) * (t.left.t - s.left.t)};
          const auto disc = discs(place);
          ASSERT_TRUE(disc);
          if (!disc->touches) continue;
          ++asked;
          // A disc is told by the height h of one foot above the other's tangent, way^2 / (2 r): the radius is off by
          // 2 (r / way)^2 times what h is off, and 2^-46 of the size is nothing.
          const Point way = point_of(drawing, *disc->touches) - point_of(drawing, place);
          const double rounding = 1e-12 + 0x1p-44 * disc->radius * disc->radius / dot(way, way);
          const double off = distance_from(c, disc->center);
          EXPECT_LE(off, c.error + rounding) << "edge " << e << " from " << c.first << " to " << c.last;
          EXPECT_NEAR(std::fabs(signed_distance(disc->center, c.left)), disc->radius, c.error + rounding);
        }
    }
  }
  EXPECT_GE(asked, 200u);
}

// A band of six pieces a side with waves of a height from 1e-16 to 0.1: sides are parallel or nearly so.
Drawing wavy_band(std::mt19937& random) {
  std::uniform_real_distribution<double> unit(0, 1);
  const double height = std::pow(10, -1 - 15 * unit(random)), width = 0.2 + unit(random);
  constexpr int PIECES = 6;
  std::vector<Bezier> band;
  double sign = 1;
  const auto add = [&](const Point& from, const Point& to) {
    const Point way = to - from;
    sign = random() % 4 == 0 ? sign : -sign;
    const Point up{0, sign * height};
    band.emplace_back(std::vector<Point>{from, from + 0.33 * way + up, from + 0.67 * way - up, to});
  };
  for (int i = 0; i < PIECES; ++i) add({double(i), 0}, {double(i + 1), 0});
  band.emplace_back(std::vector<Point>{{PIECES, 0}, {PIECES, width}});
  for (int i = PIECES; i > 0; --i) add({double(i), width}, {double(i - 1), width});
  band.emplace_back(std::vector<Point>{{0, width}, {0, 0}});
  return drawing_of(band);
}
double distance_from(const std::vector<ba::Medial_axis_2::Sample>& samples, std::size_t first, std::size_t last,
                     const Point& q) {
  double nearest = std::numeric_limits<double>::infinity();
  for (std::size_t i = first; i < last; ++i) {
    const Point p = samples[i].center, way = samples[i + 1].center - p;
    const double square = dot(way, way), share = square > 0 ? std::clamp(dot(q - p, way) / square, 0.0, 1.0) : 0;
    nearest = (std::min)(nearest, euclidean_norm(p + share * way - q));
  }
  return nearest;
}
// A conic is as near to the lines between its samples as its error and theirs say, and so is its middle control point
// to its ends as these are to each other.
std::size_t expect_within(const Medial_axis_2& axis, const Conics& conics, double size) {
  std::size_t count = 0;
  for (std::size_t e = 0; e < conics.size(); ++e)
    for (const ba::Medial_axis_2::Conic& c : conics[e]) {
      ++count;
      const double chord = euclidean_norm(c.points[2] - c.points[0]), rounding = 1e-12 * size;
      for (const std::size_t end : {0, 2})
        EXPECT_LE(euclidean_norm(c.points[1] - c.points[end]), chord * (1 + 1e-12) + rounding);
      constexpr int PLACES = 16;
      for (int i = 1; i < PLACES; ++i) {
        const double off = distance_from(axis.edges[e].samples, c.first, c.last, at(c, i / double(PLACES)));
        EXPECT_LE(off, c.error + axis.eps + rounding) << "edge " << e << " from " << c.first << " to " << c.last;
      }
      if (testing::Test::HasFailure()) return count;
    }
  return count;
}

// Where both sides are nearly parallel two samples may be one within rounding, and their line has any direction.
TEST(AxisConics, OfWavyBandsStayWithinThem) {
  std::mt19937 random(12345);
  std::size_t count = 0;
  for (int round = 0; round < cases(400) && !HasFailure(); ++round) {
    SCOPED_TRACE(round);
    const Drawing band = wavy_band(random);
    const double eps = round % 2 == 0 ? 1e-3 : 1e-5;
    const Medial_axis_2 axis = axis_of(band, eps);
    if (axis.status != Status::COMPLETE) continue;
    count += expect_within(axis, conics_of(band, axis, eps), 6);
  }
  EXPECT_GE(count, 1000u);
}
// The last two samples of an edge differ by rounding, and the tangents' signs once came of that.
TEST(AxisConics, OfOneSuchBandStayWithinIt) {
  Drawing band;
  for (const auto& record : ba::read_curve_file(BOUNDING_ARCS_TEST_DATA "/axis/wavy_band.json").curves)
    band.add(record.bezier_pieces<double>());
  const Medial_axis_2 axis = axis_of(band, 1e-3);
  ASSERT_EQ(axis.status, Status::COMPLETE);
  expect_within(axis, conics_of(band, axis, 1e-3), 6);
}
TEST(AxisConics, OfSplinesStayWithinThem) {
  std::mt19937 random(77);
  for (int round = 0; round < cases(40) && !HasFailure(); ++round) {
    SCOPED_TRACE(round);
    const Drawing drawing = drawing_of(closed_curve(random, {0, 0}, 5 + random() % 9));
    for (const double eps : {1e-2, 1e-4}) {
      const Medial_axis_2 axis = axis_of(drawing, eps);
      if (axis.status == Status::COMPLETE) expect_within(axis, conics_of(drawing, axis, eps), size_of(drawing));
    }
  }
}

TEST(AxisConics, AreFarFewerThanLines) {
  std::mt19937 random(7);
  std::size_t lines = 0, count = 0;
  for (int round = 0; round < 10; ++round) {
    const Drawing drawing = drawing_of(closed_curve(random, {0, 0}, 8));
    const Medial_axis_2 axis = axis_of(drawing, 1e-6);
    if (axis.status != Status::COMPLETE) continue;
    for (const auto& e : axis.edges) lines += e.samples.size() - 1;
    for (const auto& edge : conics_of(drawing, axis, 1e-6)) count += edge.size();
  }
  EXPECT_LT(4 * count, lines);
}

// A power of two times the drawing has the same conics, times it.
TEST(AxisConics, GrowWithTheDrawing) {
  std::mt19937 random(3);
  const Drawing drawing = drawing_of(closed_curve(random, {0, 0}, 6));
  const double scale = 0x1p300;
  const Drawing large = moved(drawing, scale, {0, 0});
  const Conics small = conics_of(drawing, axis_of(drawing, 1e-4), 1e-4),
               grown = conics_of(large, axis_of(large, scale * 1e-4), scale * 1e-4);
  ASSERT_EQ(small.size(), grown.size());
  for (std::size_t e = 0; e < small.size(); ++e) {
    ASSERT_EQ(small[e].size(), grown[e].size());
    for (std::size_t i = 0; i < small[e].size(); ++i) {
      EXPECT_EQ(scale * small[e][i].points[1], grown[e][i].points[1]);
      EXPECT_EQ(small[e][i].weight, grown[e][i].weight);
    }
  }
}

TEST(AxisConics, RefuseNoTolerance) {
  const Drawing square = drawing_of(polygon({{0, 0}, {1, 0}, {1, 1}, {0, 1}}));
  const Medial_axis_2 axis = axis_of(square);
  EXPECT_THROW(static_cast<void>(conics_of(square, axis, 0)), std::invalid_argument);
  EXPECT_THROW(static_cast<void>(conics_of(square, axis, std::nan(""))), std::invalid_argument);
}

}  // namespace
}  // namespace test_axis_conics
