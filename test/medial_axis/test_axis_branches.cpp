// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// An axis as few long ways: that of bars, of combs, of rings, of discs and of random shapes, and cut at a radius.

#include "axis_checks.h"
#include "cases.h"
#include "closed_drawings.h"

#include <CGAL/Bounding_arcs_2/medial_axis/axis_branches.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>
#include <set>
#include <stdexcept>
#include <utility>
#include <vector>

namespace test_axis_branches {
namespace {

using namespace bounding_arcs_test;

std::vector<double> lengths_of(const std::vector<ba::Medial_axis_2::Branch>& branches) {
  std::vector<double> lengths;
  for (const ba::Medial_axis_2::Branch& b : branches) lengths.push_back(b.length);
  return lengths;
}

TEST(AxisBranches, OfABarAreALongOneAndTheOtherCorners) {
  const Medial_axis_2 axis = axis_of(drawing_of(polygon({{0, 0}, {5, 0}, {5, 2}, {0, 2}})));
  const auto found = ba::axis_branches(axis);
  ASSERT_EQ(found.size(), 3u);
  EXPECT_NEAR(found[0].length, 3 + 2 * std::sqrt(2.0), 1e-9);
  EXPECT_NEAR(found[1].length, std::sqrt(2.0), 1e-9);
  EXPECT_NEAR(found[2].length, std::sqrt(2.0), 1e-9);
  EXPECT_NEAR(found[1].samples.front().radius, 1, 1e-9);
  EXPECT_EQ(found[1].samples.back().radius, 0);
}

// A bar 2 wide, of which the middle has larger discs than 0.5: four corners are left, each as deep as that.
TEST(AxisBranches, EndWhereDiscsGetLarger) {
  const Medial_axis_2 axis = axis_of(drawing_of(polygon({{0, 0}, {5, 0}, {5, 2}, {0, 2}})));
  const auto found = ba::axis_branches(axis, 0.5);
  ASSERT_EQ(found.size(), 4u);
  for (std::size_t i = 0; i < 4; ++i) {
    EXPECT_EQ(found[i].part, i);
    EXPECT_NEAR(found[i].length, std::sqrt(0.5), 1e-9);
    EXPECT_EQ((std::max)(found[i].samples.front().radius, found[i].samples.back().radius), 0.5);
  }
  EXPECT_EQ(ba::axis_branches(axis, 1 + 1e-9).size(), 3u);
  EXPECT_THROW((void)ba::axis_branches(axis, 0), std::invalid_argument);
  EXPECT_THROW((void)ba::axis_branches(axis, std::nan("")), std::invalid_argument);
}

TEST(AxisBranches, OfADiscAndARingAreAPlaceAndAWayRound) {
  const auto disc = ba::axis_branches(axis_of(drawing_of(circle({3, 4}, 2))));
  ASSERT_EQ(disc.size(), 1u);
  ASSERT_EQ(disc[0].samples.size(), 1u);
  EXPECT_NEAR(disc[0].samples[0].radius, 2, 1e-9);
  EXPECT_TRUE(ba::axis_branches(axis_of(drawing_of(circle({3, 4}, 2))), 1.9).empty());
  const auto ring = ba::axis_branches(axis_of(both(circle({0, 0}, 3), circle({0, 0}, 2))));
  ASSERT_EQ(ring.size(), 1u);
  EXPECT_EQ(ring[0].samples.front().center, ring[0].samples.back().center);
  EXPECT_NEAR(ring[0].length, 5 * 3.14159265358979, 1e-3);
}

// All lines between samples of the axis, the same as those of branches, where radii are no larger.
using Line = std::pair<std::pair<double, double>, std::pair<double, double>>;
Line line_of(const ba::Medial_axis_2::Sample& s, const ba::Medial_axis_2::Sample& t) {
  const std::pair<double, double> a{s.center.x, s.center.y}, b{t.center.x, t.center.y};
  return a < b ? Line{a, b} : Line{b, a};
}
TEST(AxisBranches, HaveEachLineOfTheAxisOnce) {
  std::mt19937 random(77);
  std::uniform_real_distribution<double> share(0.1, 1.2);
  for (int i = 0; i < cases(60); ++i) {
    const Drawing drawing = drawing_of(closed_curve(random, {0, 0}, 4 + random() % 8));
    const Medial_axis_2 axis = axis_of(drawing, 1e-3);
    ASSERT_EQ(axis.status, Status::COMPLETE);
    double most = 0;
    for (const ba::Medial_axis_2::Vertex& v : axis.vertices) most = (std::max)(most, v.radius);
    const double largest = i % 2 == 0 ? std::numeric_limits<double>::infinity() : share(random) * most;
    std::multiset<Line> wanted, found;
    std::size_t ends = 0;  // lines that are cut
    for (const ba::Medial_axis_2::Edge& e : axis.edges)
      for (std::size_t k = 1; k < e.samples.size(); ++k) {
        const ba::Medial_axis_2::Sample &s = e.samples[k - 1], &t = e.samples[k];
        if ((std::max)(s.radius, t.radius) <= largest) wanted.insert(line_of(s, t));
        else ends += (std::min)(s.radius, t.radius) <= largest ? 1 : 0;
      }
    const auto branches = ba::axis_branches(axis, largest);
    std::size_t part = 0;
    for (const ba::Medial_axis_2::Branch& b : branches) {
      EXPECT_TRUE(b.part == part || b.part == part + 1);
      part = b.part;
      double length = 0;
      for (std::size_t k = 1; k < b.samples.size(); ++k) {
        const ba::Medial_axis_2::Sample &s = b.samples[k - 1], &t = b.samples[k];
        EXPECT_LE((std::max)(s.radius, t.radius), largest);
        length += std::hypot(t.center.x - s.center.x, t.center.y - s.center.y);
        const bool is_cut = (s.radius == largest || t.radius == largest) && wanted.count(line_of(s, t)) == 0;
        if (is_cut) --ends;
        else found.insert(line_of(s, t));
      }
      EXPECT_NEAR(length, b.length, 1e-9 * (1 + length));
    }
    EXPECT_EQ(found, wanted) << "shape " << i;
    EXPECT_EQ(ends, 0u) << "shape " << i;
    for (std::size_t k = 1; k < branches.size(); ++k)
      EXPECT_TRUE(branches[k].part == branches[k - 1].part || branches[k].length <= branches[0].length)
          << "a part does not begin with its longest";
  }
}

// A way through a vertex takes two of its edges: half as many ways as vertices of an odd degree are needed, or one.
TEST(AxisBranches, AreAsFewAsCanBe) {
  std::mt19937 random(13);
  for (int i = 0; i < cases(40); ++i) {
    const auto outer = closed_curve(random, {0, 0}, 4 + random() % 8);
    const Medial_axis_2 axis = axis_of(i % 2 == 0 ? drawing_of(outer) : both(outer, circle({0.05, 0.03}, 0.2)), 1e-3);
    ASSERT_EQ(axis.status, Status::COMPLETE);
    const auto degrees = axis.degrees();
    if (*std::max_element(degrees.begin(), degrees.end()) > 3) continue;
    const auto odd = static_cast<std::size_t>(
        std::count_if(degrees.begin(), degrees.end(), [](std::size_t degree) { return degree % 2 == 1; }));
    EXPECT_EQ(ba::axis_branches(axis).size(), (std::max)(odd / 2, std::size_t(1))) << "shape " << i;
  }
}

// A comb: its back, with the longest tooth, comes first; then the other teeth, each from the back.
TEST(AxisBranches, ComeLongestFirst) {
  const Medial_axis_2 axis = axis_of(drawing_of(polygon({{0, 0},
                                                         {9, 0},
                                                         {9, 4},
                                                         {8, 4},
                                                         {8, 1},
                                                         {6, 1},
                                                         {6, 3},
                                                         {5, 3},
                                                         {5, 1},
                                                         {2, 1},
                                                         {2, 5},
                                                         {1, 5},
                                                         {1, 1},
                                                         {0, 1}})));
  const auto found = ba::axis_branches(axis);
  const std::vector<double> lengths = lengths_of(found);
  EXPECT_TRUE(std::is_sorted(lengths.rbegin(), lengths.rend()));
  EXPECT_GT(lengths[0], 12);
  std::set<std::pair<double, double>> cut;
  for (const ba::Medial_axis_2::Branch& b : found) {
    const Point from = b.samples.front().center;
    EXPECT_TRUE(cut.empty() || cut.count({from.x, from.y}) == 1);
    for (const ba::Medial_axis_2::Sample& s : b.samples) cut.insert({s.center.x, s.center.y});
  }
}

}  // namespace
}  // namespace test_axis_branches
