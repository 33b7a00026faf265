// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// What is made of a medial axis: paths of most clearance, local thickness, necks, ends trimmed by the angle of feet;
// and the bisectors of two curves.

#include "axis_checks.h"
#include "cases.h"
#include "closed_drawings.h"

#include <CGAL/Bounding_arcs_2/medial_axis/bisector.h>
#include <CGAL/Bounding_arcs_2/medial_axis/local_thickness.h>
#include <CGAL/Bounding_arcs_2/medial_axis/medial_axis.h>
#include <CGAL/Bounding_arcs_2/medial_axis/pruned.h>
#include <CGAL/Bounding_arcs_2/medial_axis/thin_places.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <random>
#include <set>
#include <stdexcept>
#include <utility>
#include <vector>

namespace test_axis_uses {
namespace {

using namespace bounding_arcs_test;

// A region with holes, and its axis.
struct Case {
  Drawing drawing;
  Medial_axis_2 axis;
};
Case random_case(std::mt19937& random) {
  Case c;
  c.drawing.add(moved(drawing_of(closed_curve(random, {0, 0}, 5 + random() % 9)), 4, {0, 0}).curves()[0].beziers);
  for (const double x : {-0.6, 0.6}) {
    const Drawing hole = reversed(moved(drawing_of(closed_curve(random, {0, 0}, 4)), 0.3, {x, 0}));
    c.drawing.add(hole.curves()[0].beziers);
  }
  c.axis = axis_of(c.drawing, 1e-4);
  return c;
}

TEST(Necks, AreWhereAShapeIsNarrow) {
  const Drawing hourglass =
      drawing_of(polygon({{0, 0}, {4, 0}, {5, 1.5}, {6, 0}, {10, 0}, {10, 4}, {6, 4}, {5, 2.5}, {4, 4}, {0, 4}}));
  const std::vector<ba::Medial_axis_2::Neck> found = ba::necks(axis_of(hourglass));
  ASSERT_EQ(found.size(), 1u);
  EXPECT_NEAR(found[0].thickness(), 1, 1e-12);
  EXPECT_NEAR(found[0].disc.center.x, 5, 1e-6);
  EXPECT_NEAR(found[0].disc.center.y, 2, 1e-6);
  EXPECT_TRUE(ba::necks(axis_of(drawing_of(polygon({{0, 0}, {6, 0}, {6, 1}, {0, 1}})))).empty());  // corners are none
  EXPECT_TRUE(ba::necks(axis_of(hourglass), found[0].prominence).empty());
  EXPECT_EQ(ba::necks(axis_of(hourglass), found[0].prominence / 2).size(), 1u);
}

TEST(Necks, OfASquareRingAreItsSides) {
  const Drawing ring = both(polygon({{0, 0}, {6, 0}, {6, 6}, {0, 6}}), polygon({{2, 2}, {4, 2}, {4, 4}, {2, 4}}));
  const std::vector<ba::Medial_axis_2::Neck> found = ba::necks(axis_of(ring));
  ASSERT_EQ(found.size(), 4u);
  for (const ba::Medial_axis_2::Neck& neck : found) {
    EXPECT_NEAR(neck.thickness(), 2, 1e-12);
    EXPECT_NEAR(neck.prominence, 2 * std::sqrt(2) / (1 + std::sqrt(2)) - 1, 1e-9);  // the disc in a corner
  }
}

// How far radii rise on the best way from each disc to a smaller one, by looking for it from each of them.
TEST(Necks, AreAllMinimaThatStandOut) {
  std::mt19937 random(5);
  for (int round = 0; round < cases(20); ++round) {
    SCOPED_TRACE(round);
    const Medial_axis_2 axis = random_case(random).axis;
    using Disc = std::pair<std::size_t, std::size_t>;  // edge and sample; of a vertex no edge and its number
    std::map<Disc, double> radius;
    std::map<Disc, std::vector<Disc>> beside;
    for (std::size_t e = 0; e < axis.edges.size(); ++e) {
      const ba::Medial_axis_2::Edge& edge = axis.edges[e];
      const auto disc = [&](std::size_t i) {
        if (i == 0) return Disc(axis.edges.size(), edge.from);
        return i + 1 == edge.samples.size() ? Disc(axis.edges.size(), edge.to) : Disc(e, i);
      };
      for (std::size_t i = 0; i < edge.samples.size(); ++i) radius[disc(i)] = edge.samples[i].radius;
      for (std::size_t i = 1; i < edge.samples.size(); ++i)
        beside[disc(i)].push_back(disc(i - 1)), beside[disc(i - 1)].push_back(disc(i));
    }
    std::vector<std::pair<double, double>> expected, found;
    for (const auto& [from, r] : radius) {
      if (beside[from].size() < 2) continue;
      std::set<std::pair<double, Disc>> rim{{r, from}};
      std::set<Disc> seen{from};
      double highest = r;
      bool is_lowest = true;
      while (is_lowest && !rim.empty()) {
        const auto [height, disc] = *rim.begin();
        rim.erase(rim.begin());
        is_lowest = !(std::pair(height, disc) < std::pair(r, from));  // of equal ones the first
        highest = (std::max)(highest, height);
        for (const Disc& next : beside[disc])
          if (seen.insert(next).second) rim.insert({radius[next], next});
      }
      const double rises = is_lowest ? std::numeric_limits<double>::infinity() : highest - r;
      if (rises > axis.eps) expected.push_back({r, rises});
    }
    for (const ba::Medial_axis_2::Neck& neck : ba::necks(axis)) found.push_back({neck.disc.radius, neck.prominence});
    EXPECT_TRUE(std::is_sorted(found.begin(), found.end(), [](auto a, auto b) { return a.first < b.first; }));
    std::sort(expected.begin(), expected.end());
    std::sort(found.begin(), found.end());
    EXPECT_EQ(found, expected);
  }
}

TEST(ClearancePath, GoesRoundAHoleWhereThereIsRoom) {
  // a square with a hole nearer to its lower side
  const Drawing drawing = both(polygon({{0, 0}, {6, 0}, {6, 6}, {0, 6}}), polygon({{2, 1}, {4, 1}, {4, 3}, {2, 3}}));
  const ba::Bounding_arc_tree_2 index(drawing);
  const Medial_axis_2 axis = axis_of(drawing);
  const Point from{1, 0.25}, to{5, 0.25};
  const auto path = ba::clearance_path(index, axis, from, to);
  ASSERT_TRUE(path);
  EXPECT_EQ(path->stations.front().point, from);
  EXPECT_EQ(path->stations.back().point, to);
  EXPECT_NEAR(path->bottleneck, 0.25, 1e-12);  // where it begins: then the short way below will do
  for (const auto& s : path->stations) EXPECT_LE(s.point.y, 1.5);
  const auto wide = ba::clearance_path(index, axis, {1, 2}, {5, 2});
  ASSERT_TRUE(wide);
  EXPECT_NEAR(wide->bottleneck, 1, 1e-12);
  const auto highest = std::max_element(wide->stations.begin(), wide->stations.end(),
                                        [](const auto& a, const auto& b) { return a.point.y < b.point.y; });
  EXPECT_GE(highest->point.y, 4);                                 // above the hole there are 3, below it 1
  EXPECT_FALSE(ba::clearance_path(index, axis, {1, 2}, {3, 2}));  // in the hole
  EXPECT_FALSE(ba::clearance_path(index, axis, {1, 2}, {9, 2}));
  const auto back = ba::clearance_path(index, axis, {5, 2}, {1, 2});
  ASSERT_TRUE(back);
  EXPECT_NEAR(back->length, wide->length, 1e-9);
}

// On a grid: the most clearance by which cells are connected is no more than the path's, but for the cells' size.
TEST(ClearancePath, HasAsMuchRoomAsAnyOnAGrid) {
  std::mt19937 random(2);
  for (int i = 0; i < cases(4) && !HasFailure(); ++i) {
    SCOPED_TRACE(i);
    const Case c = random_case(random);
    const ba::Bounding_arc_tree_2 index(c.drawing, ba::Decisions::DOUBLE);
    constexpr int SIZE = 80;
    constexpr double CELL = 8.0 / SIZE;
    const auto point = [&](int k) { return Point{-4 + CELL * (k % SIZE + 0.5), -4 + CELL * (k / SIZE + 0.5)}; };
    std::vector<double> room(SIZE * SIZE, -1);
    std::vector<int> inside;
    for (int k = 0; k < SIZE * SIZE; ++k)
      if (ba::locate(index, point(k)) == CGAL::ON_BOUNDED_SIDE)
        room[static_cast<std::size_t>(k)] = ba::closest_point(index, point(k))->distance.lower, inside.push_back(k);
    for (int pair = 0; pair < 4; ++pair) {
      const int from = inside[random() % inside.size()], to = inside[random() % inside.size()];
      const auto path = ba::clearance_path(index, c.axis, point(from), point(to));
      ASSERT_TRUE(path);
      for (const auto& s : path->stations)
        EXPECT_GE(ba::closest_point(index, s.point)->distance.upper, s.clearance - c.axis.eps);
      // flood from one cell in the order of clearance
      std::vector<double> best(room.size(), -1);
      best[static_cast<std::size_t>(from)] = room[static_cast<std::size_t>(from)];
      std::vector<int> heap{from};
      const auto less = [&](int a, int b) {
        return best[static_cast<std::size_t>(a)] < best[static_cast<std::size_t>(b)];
      };
      while (!heap.empty()) {
        std::pop_heap(heap.begin(), heap.end(), less);
        const int k = heap.back();
        heap.pop_back();
        for (const int n : {k - 1, k + 1, k - SIZE, k + SIZE}) {
          if (n < 0 || n >= SIZE * SIZE || room[static_cast<std::size_t>(n)] < 0) continue;
          const double w = std::fmin(best[static_cast<std::size_t>(k)], room[static_cast<std::size_t>(n)]);
          // steps of a cell may not jump over a wall
          if (w <= best[static_cast<std::size_t>(n)] ||
              room[static_cast<std::size_t>(n)] + room[static_cast<std::size_t>(k)] < CELL)
            continue;
          best[static_cast<std::size_t>(n)] = w;
          heap.push_back(n);
          std::push_heap(heap.begin(), heap.end(), less);
        }
      }
      EXPECT_GE(path->bottleneck, best[static_cast<std::size_t>(to)] - CELL);
    }
  }
}

// Two rooms and a corridor.
Drawing dumb_bell() {
  return drawing_of(polygon(
      {{0, 0}, {4, 0}, {4, 1.5}, {8, 1.5}, {8, 0}, {12, 0}, {12, 4}, {8, 4}, {8, 2.5}, {4, 2.5}, {4, 4}, {0, 4}}));
}

TEST(ClearancePath, HasTheRoomOfItsNarrowestPlace) {
  const Drawing drawing = dumb_bell();
  const auto path = ba::clearance_path(ba::Bounding_arc_tree_2(drawing), axis_of(drawing), {2, 2}, {10, 2});
  ASSERT_TRUE(path);
  EXPECT_NEAR(path->bottleneck, 0.5, 1e-9);
  EXPECT_NEAR(path->length, 8, 1e-9);
}

TEST(LocalThickness, IsKnownInADumbBell) {
  const Drawing drawing = dumb_bell();
  const ba::Local_thickness_2 thickness(axis_of(drawing));
  EXPECT_NEAR(thickness({2, 2}), 4, 1e-9);
  EXPECT_NEAR(thickness({6, 2}), 1, 1e-5);
  EXPECT_NEAR(thickness({6, 1.6}), 1, 1e-5);
  EXPECT_LT(thickness({0.1, 0.1}), 1);
  EXPECT_EQ(thickness({6, 1}), 0);
  EXPECT_EQ(ba::Local_thickness_2(Medial_axis_2())({0, 0}), 0);
}

TEST(LocalThickness, IsOfTheLargestOfManyDiscs) {
  std::mt19937 random(4);
  for (int i = 0; i < cases(6) && !HasFailure(); ++i) {
    const Case c = random_case(random);
    const ba::Local_thickness_2 thickness(c.axis);
    std::uniform_real_distribution<double> unit(-4, 4);
    for (int k = 0; k < 200; ++k) {
      const Point q{unit(random), unit(random)};
      double least = 0, most = 0;
      constexpr int STEPS = 16;
      for (const auto& e : c.axis.edges)
        for (std::size_t s = 1; s < e.samples.size(); ++s)
          for (int step = 0; step <= STEPS; ++step) {
            const auto &a = e.samples[s - 1], &b = e.samples[s];
            const double t = static_cast<double>(step) / STEPS, r = a.radius + t * (b.radius - a.radius);
            const Point center = a.center + t * (b.center - a.center);
            const double beyond = std::hypot(q.x - center.x, q.y - center.y) - r;
            if (beyond <= -1e-12) least = std::fmax(least, r);
            // the next one may be as much larger as it is farther on
            const double gap =
                (std::hypot(b.center.x - a.center.x, b.center.y - a.center.y) + std::fabs(b.radius - a.radius)) / STEPS;
            if (beyond <= gap + 1e-12) most = std::fmax(most, r + gap);
          }
      EXPECT_GE(thickness(q), 2 * least - 1e-12);
      EXPECT_LE(thickness(q), 2 * most + 1e-12);
    }
  }
}

TEST(TrimmedAxis, HasNoEndsWithNearFeet) {
  // corners of a rectangle are seen under a right angle
  const Drawing drawing = drawing_of(polygon({{0, 0}, {5, 0}, {5, 2}, {0, 2}}));
  const ba::Bounding_arc_tree_2 index(drawing);
  const Medial_axis_2 axis = axis_of(drawing);
  const double right = std::acos(0.0);
  EXPECT_EQ(ba::trimmed(index, axis, {right - 1e-6, 0}).edges.size(), 5U);
  const Medial_axis_2 middle = ba::trimmed(index, axis, {right + 1e-6, 0});
  ASSERT_EQ(middle.edges.size(), 1U);
  EXPECT_EQ(middle.vertices.size(), 2U);
  expect_sound(drawing, middle, 1e-6);
  EXPECT_NEAR(vertex_at(middle, {1, 1}, 1e-12).radius, 1, 1e-12);
  // of an ellipse, x^2 / 4 + y^2, feet of the disc about (c, 0) are at x = 4 c / 3
  std::vector<Bezier> chain;
  for (const Bezier& quarter : circle({0, 0}, 1)) {
    std::vector<Point> p;
    for (const Point& q : quarter.control_points()) p.push_back({2 * q.x, q.y});
    chain.emplace_back(std::move(p), quarter.weights());
  }
  const Drawing ellipse = drawing_of(chain);
  const Medial_axis_2 less = ba::trimmed(ba::Bounding_arc_tree_2(ellipse), axis_of(ellipse), {0, 0.6});
  EXPECT_NEAR(vertex_at(less, {1.2, 0}, 0.01).center.x, 1.2, 0.01);
  EXPECT_LE(vertex_at(less, {1.2, 0}, 0.01).center.x, 1.2 + 1e-12);
  EXPECT_THROW((void)ba::trimmed(index, axis, {3, 0}), std::invalid_argument);
  EXPECT_THROW((void)ba::trimmed(index, axis, {1, -1}), std::invalid_argument);
}

TEST(TrimmedAxis, KeepsRegionsAndHoles) {
  std::mt19937 random(6);
  for (int i = 0; i < cases(12) && !HasFailure(); ++i) {
    SCOPED_TRACE(i);
    const Case c = random_case(random);
    const ba::Bounding_arc_tree_2 index(c.drawing);
    std::size_t edges = c.axis.edges.size();
    for (const double angle : {0.0, 0.5, 1.0, 2.0}) {
      const Medial_axis_2 less = ba::trimmed(index, c.axis, {angle, 0});
      expect_sound(c.drawing, less, 1e-4);
      EXPECT_LE(less.edges.size(), edges);
      EXPECT_GT(less.edges.size(), 0U);
      edges = less.edges.size();
    }
  }
}

Drawing open(Bezier curve) {
  Drawing drawing;
  drawing.add({std::move(curve)});
  return drawing;
}
std::size_t number_of_samples(const std::vector<std::vector<ba::Bisector_2::Sample>>& chains) {
  std::size_t count = 0;
  for (const auto& chain : chains) count += chain.size();
  return count;
}

TEST(Bisector, OfALineAndAPointIsAParabola) {
  const ba::Bounding_arc_tree_2 focus(open(Bezier({{0.5, 1}, {0.5, 1}})));
  const ba::Bisector_2 bisector(Bezier({{-2, 0}, {2, 0}}), focus, 100);
  for (const double eps : {1e-2, 1e-4, 1e-6}) {
    const auto chains = bisector.sample(eps);
    ASSERT_EQ(chains.size(), 1u);
    EXPECT_EQ(chains[0].front().t, 0);
    EXPECT_EQ(chains[0].back().t, 1);
    for (std::size_t i = 0; i < chains[0].size(); ++i) {
      const auto& s = chains[0][i];
      const double x = s.center.x - 0.5;
      EXPECT_NEAR(s.center.y, (x * x + 1) / 2, 1e-14);
      EXPECT_EQ(s.radius, s.center.y);
      if (i == 0) continue;
      const Point way = s.center - chains[0][i - 1].center;
      EXPECT_LE(std::pow(way.x, 3) / (8 * ba::euclidean_norm(way)), eps) << i;  // of the parabola from its chord
    }
    EXPECT_LT(static_cast<double>(chains[0].size()), 70 + 8 / std::sqrt(eps));
  }
  EXPECT_TRUE(ba::Bisector_2(Bezier({{2, 0}, {-2, 0}}), focus, 100).sample(1e-3).empty());  // that is on its right
}

// Of circles with centers apart by c, in one another, the sum of the distances from both is that of the radii.
TEST(Bisector, OfTwoCirclesIsAnEllipse) {
  const Bezier outer({{2, 0}, {2, 2}, {0, 2}}, {1, 1, 2});
  Drawing inner;
  inner.add(circle({0.3, -0.2}, 0.5));
  const ba::Bounding_arc_tree_2 index(inner);
  const auto chains = ba::Bisector_2(outer, index, 100).sample(1e-5);
  ASSERT_EQ(chains.size(), 1u);
  EXPECT_GT(chains[0].size(), 65u);
  for (const auto& s : chains[0]) {
    EXPECT_NEAR(ba::euclidean_norm(s.center) + ba::euclidean_norm(s.center - Point{0.3, -0.2}), 2.5, 1e-13);
    EXPECT_NEAR(ba::euclidean_norm(s.center) + s.radius, 2, 1e-13);
  }
}

// A curve that is nearer than its centers of curvature only in two parts of the other one.
TEST(Bisector, EndsWhereDiscsDo) {
  Drawing two;
  two.add({Bezier({{-1.2, 1}, {-1, 1}})});
  two.add({Bezier({{1, 1}, {1.2, 1}})});
  const ba::Bounding_arc_tree_2 index(two);
  const ba::Bisector_2 bisector(Bezier({{-2, 0}, {2, 0}}), index, 0.55);
  const auto chains = bisector.sample(1e-4);
  ASSERT_EQ(chains.size(), 2u);
  for (const auto& chain : chains)
    for (const double t : {chain.front().t, chain.back().t}) {
      const double x = std::fabs(4 * t - 2), aside = x < 1 ? 1 - x : x - 1.2;
      EXPECT_NEAR((aside * aside + 1) / 2, 0.55, 1e-14);
      EXPECT_LE(bisector.disc(t)->radius, 0.55);
    }
  EXPECT_EQ(number_of_samples(ba::Bisector_2(Bezier({{-2, 0}, {2, 0}}), index, 0.49).sample(1e-4)), 0u);
  EXPECT_THROW(ba::Bisector_2(Bezier({{-2, 0}, {2, 0}}), index, 0), std::invalid_argument);
  EXPECT_THROW((void)bisector.sample(0), std::invalid_argument);
}

// Rounding decides whether discs as large as the circle of both arcs touch: however often that changes, it ends.
TEST(Bisector, EndsWhereRoundingDecides) {
  const Bezier arc({{1, 0}, {1, 1}, {0, 1}}, {1, 1, 2});
  const ba::Bounding_arc_tree_2 rest(open(Bezier({{0, 1}, {-1, 1}, {-1, 0}}, {1, 1, 2})));
  EXPECT_LT(number_of_samples(ba::Bisector_2(arc, rest, 10).sample(1e-3)), 1000000u);
  const ba::Bounding_arc_tree_2 focus(open(Bezier({{0.5, 1}, {0.5, 1}})));
  const std::size_t finest = number_of_samples(ba::Bisector_2(Bezier({{-2, 0}, {2, 0}}), focus, 100).sample(1e-300));
  EXPECT_EQ(finest, (1u << 18) + 1);
  EXPECT_THROW(ba::Bisector_2(Bezier({{0, 0}, {1e200, 0}}), focus, 1), std::invalid_argument);
}

// Each disc touches both curves and has none of the other one in it.
TEST(Bisector, OfRandomCurvesTouchesBoth) {
  std::mt19937 random(7);
  std::uniform_real_distribution<double> at(-1, 1);
  std::size_t discs = 0;
  for (int i = 0; i < cases(40); ++i) {
    SCOPED_TRACE(i);
    const auto curve = [&](double x, double y) {
      std::vector<Point> points;
      for (int k = 0; k < 4; ++k) points.push_back({x + at(random), y + at(random)});
      return Bezier(points);
    };
    const Bezier a = curve(0, 0);
    const ba::Bounding_arc_tree_2 b(open(curve(0.5, 2.5)));
    for (const auto& chain : ba::Bisector_2(a, b, 10).sample(1e-3))
      for (const auto& s : chain) {
        ++discs;
        const auto from_b = ba::closest_point(b, s.center)->distance;
        EXPECT_LE(from_b.lower, s.radius + 1e-12);
        EXPECT_GE(from_b.upper, s.radius - 1e-12);
        EXPECT_NEAR(ba::euclidean_norm(a.point(s.t) - s.center), s.radius, 1e-13);
        const auto jet = a.taylor_expansion(s.t, 2);
        const double speed = ba::euclidean_norm(jet[1]);
        EXPECT_LE(2 * cross(jet[1], jet[2]) * s.radius, std::pow(speed, 3) * (1 + 1e-12));  // none of `a` is near
      }
  }
  EXPECT_GT(discs, 500u);
}

}  // namespace
}  // namespace test_axis_uses
