// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Offsets of closed polylines with bulges, against brute force: random ones, whose neighbours cross, too, and drawings
// with specks, far smaller or thinner than eps, which move an offset by its distance where they are lost.

#include "bulge_loops.h"
#include "cases.h"
#include "exact_sweep.h"
#include "offset_checks.h"
#include "offset_oracle.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <random>
#include <string>
#include <vector>

namespace test_offset_families {
namespace {

using namespace bounding_arcs_test;

constexpr double TURN = 6.283185307179586;

// A point somewhere, or about as far as d from a loop.
Point random_place(std::mt19937& random, const Arc_loops& loops, double d) {
  std::uniform_real_distribution<double> unit(0, 1);
  const Arc_loop& loop = loops[random() % loops.size()];
  const auto& arc = loop[random() % loop.size()];
  const double angle = TURN * unit(random);
  const double away = random() % 2 == 0 ? 10 * unit(random) : d * (0.9 + 0.2 * unit(random));
  return point_on(arc, unit(random)) + away * Point{std::cos(angle), std::sin(angle)};
}

// Its area, points, and that nothing crosses.
void expect_right(std::mt19937& random, const Arc_loops& loops, double d, const Offset_options& options) {
  constexpr int POINTS = 100, LINES = 1500, MANY_LINES = 100000;
  SCOPED_TRACE("d " + std::to_string(d) + ", eps " + std::to_string(options.eps));
  const Offset offset = offset_curves(drawing_of(loops), d, options);
  EXPECT_NE(offset.status, ba::Offset::Status::UNRESOLVED);
  const Offset_oracle oracle(loops, options.rule, d);
  const double most = 2 * (std::max)(options.eps, offset.error);
  for (int i = 0; i < POINTS; ++i) {
    const Point q = random_place(random, loops, std::fabs(d));
    const double depth = oracle.depth(q);
    if (std::fabs(depth) > most) {
      EXPECT_EQ(winding(offset, q), depth > 0 ? 1 : 0) << q.x << ' ' << q.y << ' ' << depth;
    }
  }
  double length = 0;
  for (const auto& chain : offset.chains)
    for (const auto& p : chain.pieces) length += ba::length(p.arc);
  const double area = area_of(offset), room = most * (length + 1);
  double expected = oracle.area(LINES, 0.5);
  if (std::fabs(area - expected) > room + 1e-3 * (1 + expected)) expected = oracle.area(MANY_LINES, 0.5);
  EXPECT_NEAR(area, expected, room + 1e-3 * (1 + expected));
  EXPECT_TRUE(do_not_cross(offset.chains));
}

Offset_options random_options(std::mt19937& random, double d) {
  const double eps[] = {1e-1, 1e-2, 1e-3, 1e-4, 1e-6};
  Offset_options options = within((std::min)(eps[random() % 5], std::fabs(d) / 4));
  options.rule = random() % 2 == 0 ? ba::Fill_rule::NONZERO : ba::Fill_rule::EVEN_ODD;
  return options;
}
double random_distance(std::mt19937& random) {
  const double sizes[] = {0.05, 0.07, 0.25, 0.6, 1, 3};
  return (random() % 2 == 0 ? 1 : -1) * sizes[random() % 6];
}

// The same drawing, told in other ways, and others like it.
std::vector<Arc_loops> relatives(const Arc_loops& loops) {
  std::vector<Arc_loops> result{loops};
  const auto add = [&](const auto& changed) {
    Arc_loops all;
    for (const Arc_loop& loop : loops) all.push_back(changed(loop));
    result.push_back(all);
  };
  add([](const Arc_loop& l) { return reversed(l); });
  add([](const Arc_loop& l) { return mirrored(l); });
  add([](const Arc_loop& l) { return from_another_start(l, 1); });
  add([](const Arc_loop& l) { return from_another_start(l, 2); });
  add([](const Arc_loop& l) { return with_vertex(l, 0, 0.3); });
  add([](const Arc_loop& l) { return with_vertex(l, 1, 0.7); });
  add([](const Arc_loop& l) { return placed(l, 1, {0.1, -0.7}); });
  add([](const Arc_loop& l) { return placed(l, 1.3, {0, 0}); });
  return result;
}

TEST(OffsetFamilies, OfNeighboursThatCrossAreWhole) {
  std::mt19937 random(1);
  const Arc_loop arc_and_line = loop_of({{6, 0}, {0, 0}, {5, 3}, {8, 4}}, {1.0 / 3}),
                 notch = loop_of({{0, -2}, {1.3, -2}, {1, 0}, {2, 0}, {2, 1}, {0, 1}}, {0, 0, 1});
  for (const Arc_loop& loop : {arc_and_line, notch})
    for (const Arc_loops& loops : relatives({loop}))
      for (const double d : {0.05, 0.6, -0.03, -0.3})
        for (const double eps : {1e-2, 1e-4}) expect_right(random, loops, d, within(eps));
}

// The same curve, a degree higher.
Bezier elevated(const Bezier& c) {
  const auto& p = c.control_points();
  const auto n = static_cast<double>(c.degree() + 1);
  std::vector<Point> q{p.front()};
  for (std::size_t i = 1; i < p.size(); ++i) {
    const double share = static_cast<double>(i) / n;
    q.push_back(share * p[i - 1] + (1 - share) * p[i]);
  }
  q.push_back(p.back());
  return Bezier(q);
}

// Coarse chains of cubics cross as often as the curves.
TEST(OffsetFamilies, OfCubicsThatCrossNeighboursAreWhole) {
  std::vector<Bezier> chain{Bezier({{6, 0}, {4, 1.5}, {2, 1.5}, {0, 0}}), segment({0, 0}, {5, 3.7}),
                            segment({5, 3.7}, {8, 4}), segment({8, 4}, {6, 0})};
  const Drawing drawing = drawing_of(chain);
  std::vector<Drawing> all{drawing, backwards(drawing), moved(drawing, 1, {0.1, -0.7}), moved(drawing, -1, {0, 0})};
  std::rotate(chain.begin(), chain.begin() + 1, chain.end());
  all.push_back(drawing_of(chain));
  for (Bezier& c : chain) c = elevated(c);
  all.push_back(drawing_of(chain));
  for (const double d : {0.05, -0.05}) {
    const double fine = area_of(offset_curves(drawing, d, within(1e-8)));
    EXPECT_GT(fine, 5);
    for (const Drawing& relative : all)
      for (const double eps : {1e-2, 1e-3, 1e-4, 1e-6}) {
        const Offset offset = offset_curves(relative, d, within(eps));
        expect_sound(offset);
        EXPECT_NEAR(area_of(offset), fine, 40 * eps);
      }
  }
}

TEST(OffsetFamilies, OfRandomBulgeLoopsAreThoseOfBruteForce) {
  for (int k = 0; k < cases(200); ++k) {
    SCOPED_TRACE(k);
    std::mt19937 random(static_cast<unsigned>(k));
    Arc_loops loops{random_bulge_loop(random)};
    if (loops[0].empty()) continue;
    if (k % 4 == 0) loops.push_back(placed(loops[0], 0.7, {0.4, -0.3}));
    const double d = random_distance(random);
    expect_right(random, loops, d, random_options(random, d));
    if (HasFailure()) return;
  }
}

TEST(OffsetFamilies, OfSpecksAreKept) {
  std::mt19937 random(2);
  const Arc_loop square = loop_of({{-5, -5}, {5, -5}, {5, 5}, {-5, 5}}, {}),
                 tiny = loop_of({{0.8e-5, -0.8e-5}, {-0.3e-5, -0.7e-5}, {0.9e-5, -0.7e-5}}, {}),
                 triangle = loop_of({{0, 0}, {1, 0}, {0, 1}}, {}), slit = loop_of({{-1, 0}, {1, 1e-7}, {2, 0}}, {});
  const auto check = [&](const Arc_loops& loops, double d, double eps) {
    for (const Arc_loops& all : relatives(loops)) expect_right(random, all, d, within(eps));
  };
  check({tiny}, 0.3, 0.01);
  check({tiny}, -0.3, 0.01);
  for (const double size : {1e-2, 1e-4, 1e-6, 1e-8})
    for (const double x : {7.0, 0.0})
      for (const Arc_loop& speck : {triangle, reversed(triangle)})
        for (const double d : {-0.5, 0.5}) check({square, placed(speck, size, {x, 0})}, d, 0.05);
  for (const Arc_loop& loop : {slit, reversed(slit)})
    for (const double d : {-0.5, 0.5}) check({square, loop}, d, 0.05);
}

// Holes much smaller or thinner than eps, whose arcs follow them as well as those of a large one do.
TEST(OffsetFamilies, OfSmallEllipsesAreKept) {
  for (const double size : {1.0, 1e-1, 1e-3, 1e-5, 1e-7})
    for (const double aspect : {0.1, 1e-3, 1e-5}) {
      if (size * aspect < 5 * 0x1p-40) continue;  // rounding
      std::vector<Bezier> hole;
      for (const Bezier& c : circle({0, 0}, 1)) {
        std::vector<Point> p;
        for (const Point& q : c.control_points()) p.push_back({size * q.x, -aspect * size * q.y});
        hole.emplace_back(std::move(p), c.weights());
      }
      const Drawing drawing = both(polygon({{-5, -5}, {5, -5}, {5, 5}, {-5, 5}}), drawing_of(hole));
      const Offset inset = offset_curves(drawing, -1, within(0.05));
      expect_sound(inset);
      EXPECT_EQ(inset.chains.size(), 2U) << size << ' ' << aspect;
      const double of_hole = TURN / 2 + 4 * size + 6 * aspect * size;
      EXPECT_NEAR(area_of(inset), 64 - of_hole, 0.05 * 10 + aspect * size) << size << ' ' << aspect;
    }
}

TEST(OffsetFamilies, OfDrawingsWithSpecksAreThoseOfBruteForce) {
  for (int k = 0; k < cases(150); ++k) {
    SCOPED_TRACE(k);
    std::mt19937 random(static_cast<unsigned>(k));
    Arc_loops loops{random_bulge_loop(random)};
    if (loops[0].empty()) loops.clear();
    for (std::size_t i = 0, count = 1 + random() % 3; i < count; ++i) loops.push_back(random_speck(random));
    const double d = random_distance(random);
    expect_right(random, loops, d, random_options(random, d));
    if (HasFailure()) return;
  }
}

}  // namespace
}  // namespace test_offset_families
