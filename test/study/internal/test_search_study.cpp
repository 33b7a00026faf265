// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The searches over all eight kinds of region come to the same answers, and what regions hold is in them.

#include "../../../src/library/tree/Segment_hierarchy.h"
#include "cases.h"
#include "extreme_pairs.h"
#include "hard_cases.h"
#include "query_drawings.h"

#include <CGAL/Bounding_arcs_2/query/closest_point.h>
#include <CGAL/Bounding_arcs_2/query/distance.h>
#include <CGAL/Bounding_arcs_2/query/intersections.h>
#include <CGAL/Bounding_arcs_2/study/Search_study.h>
#include <CGAL/Bounding_arcs_2/tree/Bounding_arc_tree_2.h>
#include "../../../src/study/regions_in_hand.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <random>
#include <string>
#include <type_traits>
#include <vector>

namespace test_search_study {
namespace {

using namespace bounding_arcs_test;
using ba::Region_kind;

constexpr Region_kind KINDS[] = {Region_kind::BCA,          Region_kind::SFA,       Region_kind::BILENS,
                                 Region_kind::FAT_ARC,      Region_kind::FAT_BIARC, Region_kind::BOX,
                                 Region_kind::ORIENTED_BOX, Region_kind::HULL};

bool has_straight_sides(Region_kind kind) {
  return kind == Region_kind::BOX || kind == Region_kind::ORIENTED_BOX || kind == Region_kind::HULL;
}

// The answers are the library's own, too.
void expect_the_same_of_all_kinds(const ba::Search_tasks& tasks, bool has_centers = false) {
  const ba::Search_report bca = ba::search_report(Region_kind::BCA, tasks);
  const ba::Bounding_arc_tree_2 curves(tasks.curves), crossing(tasks.crossing), apart(tasks.apart);
  const auto least = ba::distance(curves, apart, tasks.eps);
  const auto common = ba::intersections(curves, crossing);
  const std::size_t points = tasks.points.size();
  ASSERT_EQ(bca.distances.size(), 2 * points + 2);
  EXPECT_EQ(bca.common.points.size(), common.points.size());
  EXPECT_EQ(bca.common.overlaps.size(), common.overlaps.size());
  EXPECT_EQ(bca.distances[2 * points].lower, least->distance.lower);
  for (std::size_t i = 0; i < points; ++i) {
    const auto found = ba::closest_point(curves, tasks.points[i]);
    EXPECT_EQ(bca.distances[i].lower, found->distance.lower);
    EXPECT_LE(bca.distances[points + i].lower, found->distance.upper);  // by regions alone
    EXPECT_GE(bca.distances[points + i].upper, found->distance.lower);
  }
  for (const Region_kind kind : KINDS) {
    if (has_centers && has_straight_sides(kind)) continue;
    const ba::Search_report report = ba::search_report(kind, tasks);
    EXPECT_TRUE(have_same_answers(bca, report)) << static_cast<int>(kind);
  }
}

TEST(SearchStudy, OfHardCasesIsTheSameForAllKinds) {
  std::size_t turn = 0;
  for (const Hard_case& c : hard_cases({})) {
    SCOPED_TRACE(c.name);
    if (turn++ % 2 == 1) continue;  // every other one, as all of them take long
    if (c.a.curves().empty() || c.b.curves().empty()) continue;
    ba::Search_tasks tasks = ba::search_tasks(c.a, 2, 1e-3 * (std::max)(1.0, size_of(c.a)));
    tasks.crossing = tasks.apart = c.b;
    // from the center of a circle straight sides leave all of it open, down to the limit of work
    expect_the_same_of_all_kinds(tasks, c.name.find("circle") != std::string::npos);
    if (HasFailure()) return;
  }
}

TEST(SearchStudy, OfRandomCurvesIsTheSameForAllKinds) {
  std::mt19937 random(11);
  std::uniform_real_distribution<double> unit(-1, 1), exponent(-6, 6);
  for (int i = 0; i < cases(20); ++i) {
    Drawing drawing;
    for (std::size_t n = 1 + random() % 3; n > 0; --n) {
      std::vector<Point> p;
      std::vector<double> w;
      const bool is_rational = random() % 2 == 0;
      for (std::size_t k = 2 + random() % 5; k > 0; --k) {
        p.push_back({unit(random), unit(random)});
        if (is_rational) w.push_back(std::exp2(exponent(random) / 3));
      }
      drawing.add(Bezier(p, w));
    }
    SCOPED_TRACE(i);
    expect_the_same_of_all_kinds(ba::search_tasks(drawing, 3, i % 2 == 0 ? 1e-3 : 1e-4));
    if (HasFailure()) return;
  }
}

TEST(SearchStudy, OfExtremeWeightsIsTheSameForAllKinds) {
  Extreme_pairs pairs(12);
  for (int i = 0; i < cases(6); ++i) {
    const Curve_pair pair = pairs();
    ba::Search_tasks tasks = ba::search_tasks(drawing_of(pair.a), 2, 1e-3);
    tasks.apart = drawing_of(pair.b);
    SCOPED_TRACE(json_of(pair.a) + "\n" + json_of(pair.b));
    expect_the_same_of_all_kinds(tasks);
    if (HasFailure()) return;
  }
}

// Samples of a piece are at the distance that its region tells, whose bounds are as far apart as it is wide.
template <class Construction> auto with_regions(const ba::Bounding_arc_tree_2& drawing) {
  const auto make = &ba::study::region_in_hand<Construction>;
  using Region = decltype(make(drawing.in_unit(), drawing.in_unit().piece(0)));
  return ba::study::Region_hierarchy<Region>(drawing.in_unit(), make);
}
template <class Construction> class RegionInHand : public ::testing::Test {};
using Constructions = ::testing::Types<ba::Bca, ba::Spiral_fat_arc, ba::Bilens, ba::Three_point_fat_arc, ba::Fat_biarc,
                                       ba::Axis_box, ba::Oriented_box, ba::Control_hull>;
TYPED_TEST_SUITE(RegionInHand, Constructions);

TYPED_TEST(RegionInHand, HoldsItsPiece) {
  std::mt19937 random(5);
  std::uniform_real_distribution<double> unit(-1, 1);
  for (int i = 0; i < cases(200); ++i) {
    std::vector<Point> p;
    for (std::size_t k = 3 + random() % 3; k > 0; --k) p.push_back({unit(random), unit(random)});
    const ba::Bounding_arc_tree_2 drawing(drawing_of(Bezier(p)));
    const auto curves = with_regions<TypeParam>(drawing);
    for (std::uint32_t s = 0; s < curves.number_of_segments(); ++s) {
      ba::Spiral_piece_2 piece = curves.piece(s);
      for (int level = 0; level < 12; ++level) {
        const auto region = curves.region(piece);
        for (int k = 0; k <= 16; ++k) {
          const double t = piece.first.t + (piece.last.t - piece.first.t) * k / 16;
          const Point q = curves.sample(s, t).point;
          ASSERT_LE(distance_bounds(q, region).lower, curves.error(s)) << i << ' ' << s << ' ' << level << ' ' << t;
        }
        const Point q{unit(random), unit(random)};
        const auto d = distance_bounds(q, region);
        const double to_end = ba::euclidean_norm(q - piece.first.point);
        EXPECT_LE(d.lower, to_end + curves.error(s));
        EXPECT_LE(d.lower, d.upper);
        EXPECT_FALSE(are_apart(region, region));
        EXPECT_EQ(least_distance(region, region), 0);
        const auto parts = halves(curves, piece);
        if (!parts) break;
        const auto first = curves.region(parts->first), second = curves.region(parts->second);
        EXPECT_FALSE(are_apart(first, second));  // they have an end in common
        EXPECT_EQ(least_distance(first, second), 0);
        piece = random() % 2 == 0 ? parts->first : parts->second;
      }
    }
  }
}

// By the cube of the length for the first five, by its square for an oriented box and a hull.
TYPED_TEST(RegionInHand, GetsAsThinAsItsKindDoes) {
  const ba::Bounding_arc_tree_2 drawing(drawing_of(Bezier({{0, 0}, {0.25, 0.5}, {1, 1}, {2, 1.125}})));
  const auto curves = with_regions<TypeParam>(drawing);
  ba::Spiral_piece_2 piece = curves.piece(0);
  double wide = 0;
  for (int level = 0; level < 9; ++level) {
    if (level == 3) wide = half_width(curves.region(piece));
    piece = halves(curves, piece)->first;
  }
  const double order = std::log2(wide / half_width(curves.region(piece))) / 6;
  const double expected = std::is_same_v<TypeParam, ba::Axis_box> ? 1
                          : std::is_same_v<TypeParam, ba::Oriented_box> || std::is_same_v<TypeParam, ba::Control_hull>
                              ? 2
                              : 3;
  EXPECT_NEAR(order, expected, 0.25);
}

}  // namespace
}  // namespace test_search_study
