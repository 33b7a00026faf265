// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Searches over curves of which doubles tell little: each ends, by an answer or at its limit of work, and its bracket
// holds what many digits tell.

#include "../../src/library/tree/Segment_hierarchy.h"
#include "cases.h"
#include "extreme_pairs.h"

#include <CGAL/Bounding_arcs_2/arc/arc_beziers.h>
#include <CGAL/Bounding_arcs_2/offset/offset_bracket.h>
#include <CGAL/Bounding_arcs_2/query/closest_point.h>
#include <CGAL/Bounding_arcs_2/query/convex_hull.h>
#include <CGAL/Bounding_arcs_2/query/distance.h>
#include <CGAL/Bounding_arcs_2/query/enclosing_circle.h>
#include <CGAL/Bounding_arcs_2/query/intersections.h>
#include <CGAL/Bounding_arcs_2/query/measures.h>
#include <CGAL/Bounding_arcs_2/query/ray_hits.h>
#include "../../src/library/query/Distance_search.h"
#include "../../src/library/query/Hausdorff_search.h"
#include "../../src/library/query/query_units.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <iostream>
#include <random>
#include <string>

namespace test_extreme_pairs {

using namespace bounding_arcs_test;
using ba::Bounding_arc_tree_2;
using ba::Decisions;
using ba::intersections;
using ba::Query_status;

Bounding_arc_tree_2 index_of(const Bezier& curve) { return Bounding_arc_tree_2(drawing_of(curve), Decisions::DOUBLE); }
std::string name_of(const Curve_pair& pair) { return json_of(pair.a) + "\n" + json_of(pair.b); }
// Of coordinates, and some number where all of them are 0.
double size_of(const Curve_pair& pair) {
  const double of_a = bounding_arcs_test::size_of(drawing_of(pair.a)),
               of_b = bounding_arcs_test::size_of(drawing_of(pair.b));
  return (std::max)({of_a, of_b, 0x1p-30});
}

// How many of them ended how.
struct Tally {
  int complete = 0, resolution = 0, limit = 0;
  void add(Query_status status) {
    ++(status == Query_status::COMPLETE ? complete : (status == Query_status::LIMIT_REACHED ? limit : resolution));
  }
};
std::ostream& operator<<(std::ostream& out, const Tally& t) {
  return out << t.complete << " complete, " << t.resolution << " at the resolution, " << t.limit << " at the limit";
}

template <class Bounds>
void expect_bracket(const Bounds& b, Query_status status, double tolerance, const std::string& name) {
  EXPECT_TRUE(std::isfinite(b.lower) && std::isfinite(b.upper) && b.lower <= b.upper) << name;
  if (status == Query_status::COMPLETE) {
    EXPECT_LE(b.upper - b.lower, tolerance) << name;
  }
}

// What regions and Newton's steps take for certain. Roundings of the digits to doubles are one more.
TEST(ExtremePairs, HaveDerivativesWithinTheirErrors) {
  Extreme_pairs pairs(3);
  std::mt19937 random(3);
  std::uniform_real_distribution<double> exponent(-50, 0);
  double most = 0;
  for (int i = 0; i < cases(300); ++i) {
    const Bezier curve = pairs().a;
    const ba::Bezier_evaluator evaluator(curve);
    const Precise_curve precise(curve);
    const double s = std::exp2(exponent(random)), t = i % 3 == 0 ? s : (i % 3 == 1 ? 1 - s : std::sqrt(s));
    const auto jet = evaluator(t);
    const auto errors = evaluator.errors_at(t, jet);
    const auto [first, second] = precise.derivatives(t);
    const double rounding = 0x1p-52;
    const double of_first = ba::euclidean_norm(jet.first - first), of_second = ba::euclidean_norm(jet.second - second);
    EXPECT_LE(of_first, errors.first + rounding * ba::euclidean_norm(first)) << json_of(curve) << " t " << t;
    EXPECT_LE(of_second, errors.second + rounding * ba::euclidean_norm(second)) << json_of(curve) << " t " << t;
    EXPECT_LE(errors.first, evaluator.first_error());
    EXPECT_LE(errors.second, evaluator.second_error());
    most = (std::max)(most, of_first / errors.first);
  }
  EXPECT_GT(most, 0.01);  // no bound that is far too wide
}

TEST(ExtremePairs, EndWithinTheirLimits) {
  Extreme_pairs pairs(1);
  Tally distances, farthest, measures;
  for (int i = 0; i < cases(60); ++i) {
    const Curve_pair pair = pairs();
    const Bounding_arc_tree_2 a = index_of(pair.a), b = index_of(pair.b);
    const std::size_t segments = a.in_unit().number_of_segments() + b.in_unit().number_of_segments();
    const std::string name = name_of(pair);
    const double size = size_of(pair), eps = (i % 2 == 0 ? 1e-9 : 1e-15) * size;
    ba::Distance_search distance(a.in_unit(), b.in_unit(), 0, 1e-12);
    distance.search();
    EXPECT_LE(distance.pairs(), 4 * ba::work_of_pairs(segments)) << name;
    const auto least = distance.result();
    expect_bracket(least->distance, least->status, 1e-12 * least->distance.upper, name);
    distances.add(least->status);
    ba::Hausdorff_search hausdorff(a.in_unit(), b.in_unit(), eps);
    hausdorff.search();
    EXPECT_LE(hausdorff.points(), ba::work_of_points(segments) / 4) << name;
    const auto most = hausdorff.result();
    expect_bracket(most.distance, most.status, eps, name);
    farthest.add(most.status);
    const Point q = pair.b.control_points().front();
    const auto nearest = ba::closest_point(a, q)->distance;
    EXPECT_LE(nearest.lower, nearest.upper) << name;
    const auto all = ba::closest_points(a, q, eps);
    ASSERT_FALSE(all.empty()) << name;
    EXPECT_LE(all.front().distance.lower, nearest.upper) << name;
    static_cast<void>(intersections(a, b));
    static_cast<void>(ba::self_intersections(a));
    static_cast<void>(ba::ray_hits(a, q, {1, 0.3}));
    for (const ba::Measure_bounds& m : {ba::length(a, eps), ba::width(a, eps)->width, ba::diameter(a, eps)->diameter,
                                        ba::smallest_enclosing_circle(a, eps)->radius}) {
      expect_bracket(m, m.status, eps, name);
      measures.add(m.status);
    }
    static_cast<void>(ba::convex_hull(a, eps));
    if (HasFailure()) return;
  }
  std::cout << "distances: " << distances << "\nHausdorff distances: " << farthest << "\nmeasures: " << measures
            << '\n';
}

// The least distance is that of some two points; those of samples are not less.  From the farthest point the other
// curve is as far as is told, and no sample is farther.
TEST(ExtremePairs, HaveBracketsThatHoldWhatManyDigitsTell) {
  Extreme_pairs pairs(2);
  constexpr double ROUNDING = 1e-15;  // of the digits' own results
  for (int i = 0; i < cases(24); ++i) {
    const Curve_pair pair = pairs();
    const Bounding_arc_tree_2 a = index_of(pair.a), b = index_of(pair.b);
    const Precise_curve curve_a(pair.a), curve_b(pair.b);
    const std::string name = name_of(pair);
    const double size = size_of(pair), eps = 1e-7 * size, room = ROUNDING * size;
    const auto least = ba::distance(a, b);
    EXPECT_LE(curve_a.at(least->a.place.t).distance(curve_b.at(least->b.place.t)), least->distance.upper + room)
        << name;
    const auto most = ba::directed_hausdorff_distance(a, b, eps);
    EXPECT_GE(curve_b.distance(curve_a.at(most->a.place.t)), most->distance.lower - room) << name;
    const std::size_t step = curve_a.places().size() / 10;
    for (std::size_t k = static_cast<std::size_t>(i) % step; k < curve_a.places().size(); k += step) {
      const auto& p = curve_a.places()[k];
      const Point q{static_cast<double>(p.point_x), static_cast<double>(p.point_y)};
      const auto found = ba::closest_point(b, q);
      const double at_found = curve_b.at(found->place.t).distance(p);
      EXPECT_LE(at_found, found->distance.upper + room) << name;
      const double d = (std::min)(at_found, curve_b.distance(p));
      EXPECT_LE(found->distance.lower, d + room) << name;
      EXPECT_GE(d, least->distance.lower - room) << name;
      EXPECT_LE(d, most->distance.upper + room) << name << "\nt " << p.t;
    }
    if (HasFailure()) return;
  }
}

// A cut where a line turns back is a double beyond that place: the derivative there runs against the segment.
TEST(ExtremePairs, HaveFeetBesideATurnWithinAnUlp) {
  const Bezier line({{1.5, -1}, {0.5, 0}, {1, -0.5}},
                    {62437.223512688288, 0.00023835409049396532, 0.00060176489193546393});
  const Bounding_arc_tree_2 curves = index_of(line);
  const ba::Arc_2 segment{{1.5, -1}, {1, -0.5}, 0};
  for (int i = 1; i < 40; ++i) {
    const Point q = ba::point(segment, i / 40.0) + Point{-0.4, -0.4};
    const auto found = ba::closest_point(curves, q);
    EXPECT_LE(found->distance.lower, 0.4 * std::sqrt(2.0) + 1e-14) << i;
    EXPECT_GE(found->distance.upper, 0.4 * std::sqrt(2.0) - 1e-14) << i;
    // of two pieces, too
    const auto least = ba::distance(curves, index_of(Bezier({q, q + Point{-1, -1}})));
    EXPECT_LE(least->distance.lower, 0.4 * std::sqrt(2.0) + 1e-14) << i;
  }
}

// All points of the arc are about as far from a tip of the curve that has a radius of 1e-7: halves of the longer one
// tell no more.
TEST(ExtremePairs, HaveTheDistanceOfAnArcAboutATip) {
  const Bezier tip({{-0.13520953081144604, 0.48509511454784504},
                    {-0.52481652426686809, -0.97689780575935459},
                    {-0.056620111635532488, 0.77689466750371339}});
  const Bezier arc = ba::arc_beziers({-0.76496004562637743, -0.29561985529441182},
                                     {-0.43263880835471985, -0.63120831737099337}, 0.27117416103567221)
                         .front();
  const Bounding_arc_tree_2 a = index_of(arc), b = index_of(tip);
  for (const double eps : {1e-6, 1e-7, 1e-9}) {
    ba::Distance_search search(a.in_unit(), b.in_unit(), eps, 0);
    search.search();
    EXPECT_EQ(search.result()->status, Query_status::COMPLETE) << eps;
    EXPECT_NEAR(search.result()->distance.lower, 0.467429, 1e-6) << eps;
    EXPECT_LT(search.pairs(), 2000u) << eps;
  }
}

}  // namespace test_extreme_pairs
