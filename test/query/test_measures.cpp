// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Length, area and centroid, beside sums over fine parts in long double and where they are known.

#include "../../src/library/tree/Segment_hierarchy.h"
#include "cases.h"
#include "closed_drawings.h"
#include "measure_checks.h"

#include <CGAL/Bounding_arcs_2/query/measures.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <random>
#include <stdexcept>
#include <string>
#include <vector>

namespace test_measures {
namespace {

using namespace bounding_arcs_test;
namespace ba = CGAL::Bounding_arcs;
using ba::Bounding_arc_tree_2;
using ba::Measure_bounds;
using Real = long double;
using Real_point = ba::Xy<Real>;

// By the trapezoid rule on 2^k parts, extrapolated as often; moments about the start.
struct Measures {
  Real area = 0, x = 0, y = 0;
};
Measures measures_of(const Lattice_curve& c, const Real_point& o) {
  std::vector<Real_point> p;
  std::vector<Real> w;
  for (int i = 0; i <= c.degree(); ++i) {
    const auto& q = c.control_points()[static_cast<std::size_t>(i)];
    p.push_back({q.x - o.x, q.y - o.y});
    w.push_back(c.weight(i));
  }
  const ba::Bezier_curve_2<Real> curve(p, w);
  const auto polygon = [&](int n) {
    Measures m;
    Real_point a = curve.point(0);
    for (int i = 1; i <= n; ++i) {
      const Real_point b = curve.point(Real(i) / n), d = b - a;
      m.area += cross(a, b) / 2;
      m.x += d.y * (a.x * a.x + a.x * b.x + b.x * b.x) / 6;
      m.y -= d.x * (a.y * a.y + a.y * b.y + b.y * b.y) / 6;
      a = b;
    }
    return m;
  };
  constexpr int PARTS = 256;
  const Measures r = polygon(PARTS), s = polygon(2 * PARTS), t = polygon(4 * PARTS);
  // errors in squares and fourth powers of the step
  const auto extrapolated = [](Real a, Real b, Real e) {
    const Real f = b + (b - a) / 3, g = e + (e - b) / 3;
    return g + (g - f) / 15;
  };
  return {extrapolated(r.area, s.area, t.area), extrapolated(r.x, s.x, t.x), extrapolated(r.y, s.y, t.y)};
}
Measures measures_of(const Lattice_drawing& drawing, const Real_point& o) {
  Measures sum;
  for (const auto& curve : drawing.curves())
    for (const auto& c : curve.beziers) {
      const Measures m = measures_of(c, o);
      sum.area += m.area;
      sum.x += m.x;
      sum.y += m.y;
    }
  return sum;
}

TEST(Measures, HoldSumsOverFineParts) {
  std::mt19937 random(1);
  const Placing places[] = {{}, {1e-9, 0, 0}, {1e9, 0, 0}, {1, 1e8, -3e8}, {1.0 / 3, 0.1, 0.7}};
  for (int i = 0; i < cases(300); ++i) {
    const Placing& place = places[i % 5];
    const Bounding_arc_tree_2 index(random_lattice_drawing(random, 3, place));
    const std::string name = "drawing " + std::to_string(i);
    const auto& start = index.in_unit().piece(0).first.point;
    const Real_point o{start.x, start.y};
    const Measures m = measures_of(index.drawing(), o);
    const Real size = place.scale, far = std::fabs(place.y) * 0x1p-53L * size;
    for (const double tolerance : {1e-2, 1e-5, 1e-8}) {
      const Measure_bounds length = ba::length(index, tolerance * place.scale);
      EXPECT_LE(length.upper - length.lower, tolerance * size + 1e-11 * size + 1e6 * far / size) << name;
      const Measure_bounds area = ba::area(index, tolerance * place.scale * place.scale);
      expect_holds(area, m.area, 1e-9L * size * size, name);
      EXPECT_LE(area.upper - area.lower, tolerance * size * size * 1.001L + 1e-11L * size * size + 1e6 * far) << name;
      const auto centroid = ba::centroid(index, tolerance);
      if (std::fabs(m.area) < 1e-2L * size * size) continue;
      ASSERT_TRUE(centroid) << name;
      expect_holds(centroid->x, o.x + m.x / m.area, 1e-7L * size, name);
      expect_holds(centroid->y, o.y + m.y / m.area, 1e-7L * size, name);
      // what is known of the area is divided by it
      const Real share = (std::max)(Real(1), size * size / std::fabs(m.area));
      EXPECT_LE(centroid->x.upper - centroid->x.lower,
                64 * tolerance * size + 1e-8L * size + 1e-14L * std::fabs(o.x) + 1e7L * share * far / size);
    }
    if (HasFailure()) return;
  }
}

TEST(Measures, OfACircleAreKnown) {
  const double pi = std::acos(-1.0);
  for (const Placing& place : {Placing{}, Placing{5, 3, 4}, Placing{1e-9, 0, 0}, Placing{1e9, 0, 0}}) {
    ba::Drawing_2<double> drawing;
    drawing.add(circle_of_quarters(place));
    const Bounding_arc_tree_2 index(drawing);
    const double r = place.scale;
    const Measure_bounds length = ba::length(index, 1e-12 * r), area = ba::area(index, 1e-12 * r * r);
    expect_holds(length, 2 * pi * r, 0, "length");
    expect_holds(area, pi * r * r, 0, "area");
    EXPECT_LT(length.upper - length.lower, 1e-12 * r);
    EXPECT_LT(area.upper - area.lower, 2e-12 * r * r);
    const auto centroid = ba::centroid(index, 1e-9);
    ASSERT_TRUE(centroid);
    expect_holds(centroid->x, place.x, 0, "x");
    expect_holds(centroid->y, place.y, 0, "y");
    EXPECT_LT(centroid->x.upper - centroid->x.lower, 4e-9 * r);
  }
}

// A quarter of an ellipse with both half axes, by weights that are 1, c sqrt(1/2) and c^2: however thin it is, and
// however unevenly its parameter runs.
TEST(Measures, OfEllipsesAreAsTightAsDoublesTell) {
  const double pi = std::acos(-1.0);
  for (const double y : {1.0, 1e-3, 1e-9})
    for (const double c : {1.0, 0.3, 1e-4, 1e4}) {
      ba::Drawing_2<double> drawing;
      drawing.add({Lattice_curve({{1, 0}, {1, y}, {0, y}}, {1, c * std::sqrt(0.5), c * c}),
                   Lattice_curve({{0, y}, {0, 0}}), Lattice_curve({{0, 0}, {1, 0}})});
      const Bounding_arc_tree_2 index(drawing);
      const double room = c < 1e-3 || c > 1e3 ? 1e-12 : 2e-14;  // parts of which there are more, sum up more rounding
      const Measure_bounds area = ba::area(index, 0);
      expect_holds(area, pi / 4 * y, 4e-16 * y, "area");
      EXPECT_LT(area.upper - area.lower, room * y) << c;
      const auto centroid = ba::centroid(index, 0);
      ASSERT_TRUE(centroid);
      expect_holds(centroid->x, 4 / (3 * pi), 4e-16, "x");
      expect_holds(centroid->y, 4 / (3 * pi) * y, 4e-16 * y, "y");
      EXPECT_LT(centroid->x.upper - centroid->x.lower, 10 * room) << c;
      EXPECT_LT(centroid->y.upper - centroid->y.lower, 10 * room * y) << c;
    }
}

// A quarter of a circle by curves of higher degrees: intervals tell nothing of differences of high orders.
TEST(Measures, OfHighDegreesAreKnown) {
  using Homogeneous = std::array<double, 3>;
  const double root = std::sqrt(0.5);
  std::vector<Homogeneous> quarter{{1, 0, 1}, {root, root, root}, {0, 1, 1}};
  for (int degree = 3; degree <= 32; ++degree) {
    std::vector<Homogeneous> raised(quarter.size() + 1, Homogeneous{});
    for (std::size_t i = 0; i < quarter.size(); ++i)
      for (std::size_t k = 0; k < 3; ++k) {
        raised[i][k] += static_cast<double>(quarter.size() - i) / degree * quarter[i][k];
        raised[i + 1][k] += static_cast<double>(i + 1) / degree * quarter[i][k];
      }
    quarter = raised;
    std::vector<ba::Xy<double>> points;
    std::vector<double> weights;
    for (const Homogeneous& p : quarter) {
      points.push_back({p[0] / p[2], p[1] / p[2]});
      weights.push_back(p[2]);
    }
    ba::Drawing_2<double> drawing;
    drawing.add({Lattice_curve(points, weights), Lattice_curve({points.back(), {0, 0}}),
                 Lattice_curve({{0, 0}, points.front()})});
    const Measure_bounds area = ba::area(Bounding_arc_tree_2(drawing), 0);
    expect_holds(area, std::acos(-1.0) / 4, 1e-14, "area");
    EXPECT_LT(area.upper - area.lower, 1e-11) << degree;
  }
}

TEST(Measures, OfPolynomialCurvesAreTheNearestDoubles) {
  ba::Drawing_2<double> drawing;
  drawing.add(polygon({{1e8, 1e8}, {1e8 + 3, 1e8}, {1e8 + 3, 1e8 + 1}, {1e8, 1e8 + 1}}));
  const Bounding_arc_tree_2 rectangle(drawing);
  EXPECT_EQ(ba::area(rectangle, 0).lower, 3);
  EXPECT_EQ(ba::area(rectangle, 0).upper, 3);
  const auto centroid = ba::centroid(rectangle, 0);
  ASSERT_TRUE(centroid);
  EXPECT_EQ(centroid->x.lower, 1e8 + 1.5);
  EXPECT_EQ(centroid->y.upper, 1e8 + 0.5);
  drawing.add(polygon({{1e8, 1e8}, {1e8, 1e8 + 1}, {1e8 + 1, 1e8 + 1}, {1e8 + 1, 1e8}}));  // a hole
  EXPECT_EQ(ba::area(Bounding_arc_tree_2(drawing), 0).lower, 2);
  ba::Drawing_2<double> parabola;
  parabola.add({Lattice_curve({{0, 0}, {1, 2}, {2, 0}}), Lattice_curve({{2, 0}, {0, 0}})});
  EXPECT_NEAR(ba::area(Bounding_arc_tree_2(parabola), 0).lower, -4.0 / 3, 1e-15);
}

TEST(Measures, OfRationalNumbersHoldTheExactOnes) {
  using Exact = CGAL::Exact_rational;
  const auto third = [](int x, int y) { return ba::Xy<Exact>{Exact(x) / 3, Exact(y) / 3}; };
  ba::Drawing_2<Exact> drawing;  // a quarter of a circle with radius 1 / 3 as a rational curve, and two edges
  using Curve = ba::Bezier_curve_2<Exact>;
  drawing.add({Curve({third(1, 0), third(1, 1), third(0, 1)}, {1, 1, 2}), Curve({third(0, 1), third(0, 0)}),
               Curve({third(0, 0), third(1, 0)})});
  const Bounding_arc_tree_2 index(drawing);
  const Real pi = std::acos(-1.0L);
  const Measure_bounds area = ba::area(index, 1e-15), length = ba::length(index, 1e-14);
  expect_holds(area, pi / 36, 0, "area");
  expect_holds(length, pi / 6 + 2 / 3.0L, 0, "length");
  EXPECT_LT(area.upper - area.lower, 4e-14);
  const auto centroid = ba::centroid(index, 1e-10);
  ASSERT_TRUE(centroid);
  expect_holds(centroid->x, 4 / (9 * pi), 0, "x");
  EXPECT_LT(centroid->x.upper - centroid->x.lower, 1e-9);
}

TEST(Measures, AreKnownForCuspsPointsAndNothing) {
  ba::Drawing_2<double> cusp;  // (t^2, t^3) for t in [-1, 1]
  cusp.add(Lattice_curve({{1, -1}, {-1.0 / 3, 1}, {-1.0 / 3, -1}, {1, 1}}));
  const Measure_bounds length = ba::length(Bounding_arc_tree_2(cusp), 1e-10);
  expect_holds(length, 2 * (13 * std::sqrt(13.0L) - 8) / 27, 1e-15L, "cusp");
  EXPECT_LT(length.upper - length.lower, 1e-9);
  EXPECT_THROW((void)ba::area(Bounding_arc_tree_2(cusp), 1), std::invalid_argument);
  ba::Drawing_2<double> point;
  point.add(Lattice_curve({{4, 5}, {4, 5}}));
  const Bounding_arc_tree_2 single(point);
  EXPECT_LE(ba::length(single, 0).upper, 1e-13);
  EXPECT_FALSE(ba::centroid(single, 0));
  const Bounding_arc_tree_2 none{ba::Drawing_2<double>()};
  for (const Measure_bounds& m : {ba::length(none, 0), ba::area(none, 0), ba::area(single, 0)}) {
    EXPECT_EQ(m.lower, 0);
    EXPECT_EQ(m.upper, 0);
  }
  EXPECT_FALSE(ba::centroid(none, 0));
  EXPECT_THROW((void)ba::length(none, std::nan("")), std::invalid_argument);
}

}  // namespace
}  // namespace test_measures
