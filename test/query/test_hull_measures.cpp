// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Widths, diameters and enclosing circles, beside those of many samples and of scans in long double.

#include "../../src/library/tree/Segment_hierarchy.h"
#include "cases.h"
#include "closed_drawings.h"
#include "convex_polygon.h"
#include "query_drawings.h"

#include <CGAL/Bounding_arcs_2/query/convex_hull.h>
#include <CGAL/Bounding_arcs_2/query/enclosing_circle.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <random>
#include <string>
#include <vector>

namespace test_hull_measures {
namespace {

using namespace bounding_arcs_test;
using ba::Bounding_arc_tree_2;
using Points = std::vector<Point>;

// Samples are points of the curves, so no farther apart than the diameter and so on; chords are close to curves.
TEST(HullMeasures, HoldThoseOfManySamples) {
  std::mt19937 random(2);
  const Placing places[] = {{}, {1e-9, 0, 0}, {1e9, 0, 0}, {1, 1e8, -3e8}, {1.0 / 3, 0.1, 0.7}};
  for (int i = 0; i < cases(400); ++i) {
    const Placing& place = places[i % 5];
    const double size = place.scale, room = 1e-2 * size, far = 1e-13 * std::fabs(place.y);
    const Bounding_arc_tree_2 index(random_lattice_drawing(random, 5, place));
    const Points all = convex_polygon(sampled_points(index, 100));
    double diameter = 0, width = all.size() < 3 ? 0 : 1e300;
    for (std::size_t k = 0; k < all.size(); ++k) {
      double farthest = 0;
      const Point edge = all[(k + 1) % all.size()] - all[k];
      for (const Point& q : all) {
        diameter = (std::max)(diameter, ba::euclidean_norm(q - all[k]));
        farthest = (std::max)(farthest, cross(edge, q - all[k]) / ba::euclidean_norm(edge));
      }
      if (all.size() > 2) width = (std::min)(width, farthest);
    }
    const std::string name = "drawing " + std::to_string(i);
    for (const double tolerance : {1e-2 * size, 1e-6 * size}) {
      const std::optional<ba::Width_of_drawing<>> w = ba::width(index, tolerance);
      const std::optional<ba::Diameter_of_drawing<>> d = ba::diameter(index, tolerance);
      const std::optional<ba::Enclosing_circle<>> c = ba::smallest_enclosing_circle(index, tolerance);
      ASSERT_TRUE(w && d && c);
      EXPECT_NEAR(std::hypot(w->along.x, w->along.y), 1, 1e-15) << name;
      for (const ba::Measure_bounds& b : {w->width, d->diameter, c->radius}) {
        EXPECT_LE(b.lower, b.upper) << name;
        EXPECT_LE(b.upper - b.lower, 1.01 * tolerance + 100 * far) << name;
      }
      EXPECT_GE(w->width.upper, width - 1e-13 * size - far) << name;
      EXPECT_LE(w->width.lower, width + room) << name;
      EXPECT_GE(d->diameter.upper, diameter - 1e-13 * size - far) << name;
      EXPECT_LE(d->diameter.lower, diameter + room) << name;
      EXPECT_GE(ba::euclidean_norm(d->second_point - d->first_point), d->diameter.lower) << name;
      double about = 0;
      for (const Point& q : all) about = (std::max)(about, ba::euclidean_norm(q - c->center));
      EXPECT_LE(about, c->radius.upper + 1e-14 * size + far) << name;
      EXPECT_GE(c->radius.upper, diameter / 2 - 1e-13 * size - far) << name;
      EXPECT_LE(c->radius.lower, diameter / std::sqrt(3.0) + room) << name;  // Jung
    }
    if (HasFailure()) return;
  }
}

// Supports and distances by scans in long double.
class Scanned_hull {
 public:
  explicit Scanned_hull(const Drawing& drawing) : curves_(drawing) {}

  Real farthest(const Vector& from) const {
    return -curves_.least([&](const Vector& p) { return -length(p - from); });
  }
  /// Of lines across this angle.
  Real width(Real angle) const {
    const Vector n{std::cos(angle), std::sin(angle)};
    return -curves_.least([&](const Vector& p) { return -dot(n, p); }) -
           curves_.least([&](const Vector& p) { return dot(n, p); });
  }
  Real least_width() const {
    constexpr int ANGLES = 60;
    const Real pi = std::acos(-1.0L);
    Real best = 0, least = HUGE_VALL, half = pi / ANGLES;
    const auto look_at = [&](Real angle) {
      const Real w = width(angle);
      if (w < least) best = angle;
      least = (std::min)(least, w);
    };
    for (int i = 0; i < ANGLES; ++i) look_at(pi * i / ANGLES);
    for (int round = 0; round < 30; ++round, half *= 0.6L) {
      const Real middle = best;
      for (const Real by : {-half / 2, half / 2}) look_at(middle + by);
    }
    return least;
  }
  /// From a point to the point that is farthest from it, and so on. \return at most the diameter
  Real diameter(Vector from) const {
    Real most = 0;
    constexpr int TURNS = 200;  // where curvatures nearly let a pair slide, each turn gains little
    for (int turn = 0; turn < TURNS; ++turn) {
      Vector to = from;
      const Real farther = -curves_.least([&](const Vector& p) {
        if (length(p - from) > length(to - from)) to = p;
        return -length(p - from);
      });
      if (turn > 1 && farther < most + 1e-10L) return (std::max)(most, farther);
      most = (std::max)(most, farther);
      from = to;
    }
    return most;
  }
  Real diameter() const {
    Real most = 0;
    for (std::size_t i = 0; i < curves_.size(); ++i)
      for (int k = 0; k <= 8; ++k) most = (std::max)(most, diameter(curves_.at(i, k / Real(8))));
    return most;
  }

 private:
  Scanned_drawing curves_;
};

// Each bound on its safe side of a scan, and near to it on the other side.
TEST(HullMeasures, AreThoseOfScansInLongDouble) {
  std::mt19937 random(3);
  for (int i = 0; i < cases(4); ++i) {
    const Drawing drawing = random_drawing(random);
    const Bounding_arc_tree_2 index(drawing);
    const Scanned_hull scanned(drawing);
    constexpr double TOLERANCE = 1e-7, ROUNDING = 1e-14, NEAR = 1e-6;
    const std::optional<ba::Width_of_drawing<>> w = ba::width(index, TOLERANCE);
    const std::optional<ba::Diameter_of_drawing<>> d = ba::diameter(index, TOLERANCE);
    const std::optional<ba::Enclosing_circle<>> c = ba::smallest_enclosing_circle(index, TOLERANCE);
    const Real width = scanned.least_width(), diameter = scanned.diameter();
    EXPECT_LE(w->width.lower, width + ROUNDING) << i;
    EXPECT_GE(w->width.upper, scanned.width(std::atan2(Real(w->along.x), -Real(w->along.y))) - ROUNDING) << i;
    EXPECT_NEAR(std::hypot(w->along.x, w->along.y), 1, 1e-15) << i;
    EXPECT_GE(d->diameter.upper, diameter - ROUNDING) << i;
    EXPECT_LE(d->diameter.lower, diameter + NEAR) << i;
    EXPECT_LE(d->diameter.lower, ba::euclidean_norm(d->first_point - d->second_point)) << i;
    const Scanned_drawing curves(drawing);
    EXPECT_LE(d->diameter.lower, length(curves.at(d->first) - curves.at(d->second)) + ROUNDING) << i;
    EXPECT_GE(c->radius.upper, scanned.farthest(widened(c->center)) - ROUNDING) << i;
    // no circle about another center is smaller than the lower bound
    for (int k = 0; k < 8; ++k)
      for (const double by : {1e-5, 1e-2, 0.3}) {
        const Vector beside = widened(c->center) + Vector{by * std::cos(k * 0.785L), by * std::sin(k * 0.785L)};
        EXPECT_LE(c->radius.lower, scanned.farthest(beside) + ROUNDING) << i;
      }
    if (HasFailure()) return;
  }
}

// Brackets of fine tolerances are within those of coarser ones, which go by samples.
TEST(HullMeasures, AreTheSameForFineTolerances) {
  std::mt19937 random(8);
  for (int i = 0; i < cases(100); ++i) {
    const Drawing drawing = random_drawing(random);
    const Bounding_arc_tree_2 index(drawing);
    bool has_circles = false;  // whose pieces are too many for finer ones
    for (std::uint32_t b = 0; b < index.in_unit().number_of_beziers(); ++b)
      has_circles = has_circles || index.in_unit().evaluator(b).is_rational();
    for (const double tolerance : {1e-7, 1e-10, 1e-13}) {
      constexpr double COARSE = 1e-5;
      if (has_circles && tolerance < 1e-7) continue;
      const auto expect_alike = [&](const ba::Measure_bounds& fine, const ba::Measure_bounds& coarse) {
        EXPECT_LE((std::max)(fine.lower, coarse.lower), (std::min)(fine.upper, coarse.upper)) << i;
        if (fine.status == ba::Query_status::COMPLETE) {
          EXPECT_LE(fine.upper - fine.lower, tolerance) << i;
        }
        if (tolerance > 1e-13) {
          EXPECT_EQ(fine.status, ba::Query_status::COMPLETE) << i;
        }
        EXPECT_NE(fine.status, ba::Query_status::LIMIT_REACHED) << i;
      };
      const ba::Measure_bounds width = ba::width(index, tolerance)->width,
                               diameter = ba::diameter(index, tolerance)->diameter;
      // two low pieces
      EXPECT_LE(width.upper - width.lower, tolerance + 400 * error_of(index)) << i;
      EXPECT_LE(diameter.upper - diameter.lower, tolerance + 400 * error_of(index)) << i;
      expect_alike(width, ba::width(index, COARSE)->width);
      expect_alike(diameter, ba::diameter(index, COARSE)->diameter);
      expect_alike(ba::smallest_enclosing_circle(index, tolerance)->radius,
                   ba::smallest_enclosing_circle(index, COARSE)->radius);
    }
    if (HasFailure()) return;
  }
}

}  // namespace
}  // namespace test_hull_measures
