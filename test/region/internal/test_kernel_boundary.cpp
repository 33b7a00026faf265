// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Boundaries as Circular_arc_2 and Line_arc_2 over floating numbers, against exact arithmetic: every piece is as near
// to what it stands for as it says, arcs pass their ends so near, and the exact curve lies in the region so widened.

#include "trees.h"

#include <CGAL/Bounding_arcs_2/verify/Certified_traits_2.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>
#include <variant>
#include <vector>

namespace test_kernel_boundary {
namespace {

using namespace CGAL::Bounding_arcs;
using namespace bounding_arcs_test;
using Exact_point = Xy<Exact>;

template <class FT> Exact exact(const FT& x) { return Exact_number<FT>::make(x); }
template <class P> Exact_point exact_point(const P& p) { return {exact(p.x()), exact(p.y())}; }
Exact_point exact_point(const Point& p) { return {exact(p.x), exact(p.y)}; }
double length(const Exact_point& v) { return std::hypot(CGAL::to_double(v.x), CGAL::to_double(v.y)); }

/// Where a point is against a curve: how far, and past its right side by how much.
struct Place {
  double distance, right;
};

template <class Arc> Place place_by_arc(const Arc& arc, bool is_reversed, const Exact_point& q) {
  const Exact_point z = exact_point(arc.supporting_circle().center()), v = q - z;
  const Exact square = exact(arc.supporting_circle().squared_radius());
  const Exact_point a = exact_point(arc.source()) - z, b = exact_point(arc.target()) - z;
  const Exact sum(length(v) + std::sqrt(CGAL::to_double(square)));
  const double past = CGAL::to_double(Exact((dot(v, v) - square) / sum));
  const bool is_within =
      cross(a, b) >= 0 ? cross(a, v) >= 0 && cross(v, b) >= 0 : !(cross(b, v) > 0 && cross(v, a) > 0);
  return {is_within ? std::fabs(past) : std::min(length(v - a), length(v - b)), is_reversed ? -past : past};
}
template <class Segment> Place place_by_segment(const Segment& segment, const Exact_point& q) {
  const Exact_point a = exact_point(segment.source()), chord = exact_point(segment.target()) - a, v = q - a;
  if (chord == Exact_point()) return {length(v), length(v)};
  const double right = -CGAL::to_double(Exact(cross(chord, v) / Exact(length(chord))));
  const bool is_within = dot(chord, v) >= 0 && dot(chord, chord) >= dot(chord, v);
  return {is_within ? std::fabs(right) : std::min(length(v), length(v - chord)), right};
}
template <class K> Place place(const Kernel_piece_2<K>& piece, const Exact_point& q) {
  const auto* arc = std::get_if<typename K::Circular_arc_2>(&piece.curve);
  if (arc != nullptr) return place_by_arc(*arc, piece.reversed, q);
  return place_by_segment(std::get<typename K::Line_arc_2>(piece.curve), q);
}

/// By how much a point is past the right side of the nearest piece of a chain, beyond that piece's deviation.
template <class K> double past_right(const std::vector<Kernel_piece_2<K>>& chain, const Exact_point& q, int right) {
  double least = std::numeric_limits<double>::infinity(), past = 0;
  for (const auto& piece : chain) {
    const Place at = place(piece, q);
    if (at.distance < least) past = (right * at.right > 0 ? at.distance : 0) - piece.deviation;
    least = std::min(least, at.distance);
  }
  return past;
}

/// A point of the arc over a chord with this bulge, s from 0 to 1.
Exact_point arc_point(const Exact_point& from, const Exact_point& to, const Exact& bulge, const Exact& s) {
  // the rational quadratic with middle weight w = (1 - b^2) / (1 + b^2) and w times its control point
  const Exact w = (1 - bulge * bulge) / (1 + bulge * bulge), r = 1 - s;
  const Exact_point chord = to - from, middle = Exact(Exact(1) / 2) * (from + to);
  const Exact_point control = w * middle - Exact(bulge / (1 + bulge * bulge)) * perp(chord);
  const Exact_point sum = Exact(r * r) * from + Exact(2 * r * s) * control + Exact(s * s) * to;
  return Exact(1 / (r * r + 2 * w * r * s + s * s)) * sum;
}
double bulge_of(const Boundary_piece_2<double>& p) {
  if (p.is_segment()) return 0;
  const auto at = [&](const Point& end) {
    const Point n = p.support.normal - p.support.curvature * (end - p.support.point);
    const Point t = -perp(n), c = p.to - p.from;
    return cross(t, c) / (std::hypot(t.x, t.y) * std::hypot(c.x, c.y) + dot(t, c));
  };
  return (at(p.from) - at(p.to)) / 2;
}

double ulp(double x) { return std::nextafter(std::fabs(x), std::numeric_limits<double>::infinity()) - std::fabs(x); }

// One piece as the kernel has it, against the library's own.
template <class K> void expect_as_near_as_it_says(const Kernel_piece_2<K>& piece, const Boundary_piece_2<double>& own) {
  constexpr double ROUNDING = 1 + 1e-9;  // of distances computed here
  const double chord = std::hypot(own.to.x - own.from.x, own.to.y - own.from.y);
  const double size =
      std::max({std::fabs(own.from.x), std::fabs(own.from.y), std::fabs(own.to.x), std::fabs(own.to.y)});
  const bool has_squares = chord < 1e-300 || (chord > 1e-150 && chord < 1e150);
  EXPECT_LE(piece.deviation, std::max(20 * ulp(size), (has_squares ? 0x1p-26 : 1) * chord));
  if (const auto* arc = std::get_if<typename K::Circular_arc_2>(&piece.curve)) {
    for (const auto& end : {arc->source(), arc->target()})
      EXPECT_LE(std::fabs(place_by_arc(*arc, false, exact_point(end)).right), piece.deviation * ROUNDING);
  }
  const double bulge = bulge_of(own);
  if (!(std::fabs(bulge) <= 1)) return;  // ends as near as rounding brings them
  for (const double s : {0.0, 0.1, 0.3, 0.5, 0.8, 1.0}) {
    const Exact_point q = arc_point(exact_point(own.from), exact_point(own.to), Exact(bulge), Exact(s));
    EXPECT_LE(place(piece, q).distance, piece.deviation * ROUNDING + 1e-30 * size);
  }
}

struct Counts {
  std::size_t arcs = 0, segments = 0, flat_arcs = 0;  // pieces, and segments that are arcs of the library
};

template <class K>
void expect_chain(const std::vector<Kernel_piece_2<K>>& chain, const Boundary_chain_2<double>& own, Counts& counts) {
  ASSERT_EQ(chain.size(), own.size());
  for (std::size_t i = 0; i < chain.size(); ++i) {
    expect_as_near_as_it_says(chain[i], own[i]);
    const bool is_arc = chain[i].curve.index() == 0;
    ++(is_arc ? counts.arcs : counts.segments);
    if (!is_arc && !own[i].is_segment()) ++counts.flat_arcs;
  }
}

template <class Traits> void expect_boundaries_hold(const Bezier& curve, double eps, Counts& counts) {
  const Certified_traits_2<Traits> traits;
  const Region_hierarchy_2<Traits, Spiral> tree(spiral_segments(curve), eps);
  tree.for_each_leaf([&](const Node_handle& h) {
    const Region_node n = tree.node(h);
    const Spiral& spiral = tree.spirals()[n.spiral];
    SCOPED_TRACE(text({spiral, n.t0, n.t1}));
    const auto region = tree.region(n);
    const auto boundary = traits.construct_boundary_2_object()(region);
    const auto certified = traits.construct_certified_region_2_object()(spiral, n.t0, n.t1);
    expect_chain(boundary.inner, certified.boundary.inner, counts);
    expect_chain(boundary.outer, certified.boundary.outer, counts);
    const int turn = region.frame.shape.turn;
    const auto exact = spiral.exact_curve();
    for (const double s : {0.0, 0.01, 0.2, 0.5, 0.7, 0.99, 1.0}) {
      const Exact_point q = exact.point(Exact(s == 1 ? n.t1 : n.t0 + s * (n.t1 - n.t0)));
      EXPECT_LE(past_right(boundary.outer, q, turn), certified.widening) << "outer, at " << s;
      EXPECT_LE(past_right(boundary.inner, q, -turn), certified.widening) << "inner, at " << s;
    }
  });
}

// A cubic that turns to and fro, this high over its length, of this size and so far from the origin.
Bezier zigzag(std::mt19937& random, double height, double size, double offset) {
  std::uniform_real_distribution<double> noise(-0.3, 0.3);
  std::vector<Point> points;
  for (int i = 0; i < 4; ++i) {
    const double x = i + noise(random), y = height * ((i % 2 == 0 ? -1 : 1) + noise(random));
    points.push_back({offset + size * x, offset + size * y});
  }
  return Bezier(points);
}

template <class Traits> class KernelBoundary : public testing::Test {};
TYPED_TEST_SUITE(KernelBoundary, All_traits);

TYPED_TEST(KernelBoundary, HoldsCurvesAtInflections) {
  Counts counts;
  expect_boundaries_hold<TypeParam>(Bezier({{0, 0}, {1, 1.3}, {2, -1.1}, {3.3, .2}}), 1e-2, counts);
  std::mt19937 random(511);
  for (int i = 0; i < 10; ++i) expect_boundaries_hold<TypeParam>(zigzag(random, 1, 1, 0), 1e-3, counts);
  EXPECT_GT(counts.arcs, 100u);
  if (TypeParam::Construction::NEEDS_CURVATURE) {
    EXPECT_GT(counts.segments, 0u);
  }
}

TYPED_TEST(KernelBoundary, HoldsFlatCurvesOfEverySizeAnywhere) {
  Counts counts;
  std::mt19937 random(512);
  std::uniform_real_distribution<double> digits(0, 16);
  for (const double size : {1e-9, 1e-5, 1.0, 1e4, 1e9})
    for (const double offset : {0.0, 1e8})
      for (int i = 0; i < 6; ++i) {
        const Bezier curve = zigzag(random, std::pow(10, -digits(random)), size, offset);
        expect_boundaries_hold<TypeParam>(curve, 1e-3 * size, counts);
      }
  EXPECT_GT(counts.arcs, 50u);
  EXPECT_GT(counts.flat_arcs, 50u);
}

// Squares of these lengths are out of range, so that no circle has center and squared radius in doubles.
TYPED_TEST(KernelBoundary, HasSegmentsWhereSquaresOverflow) {
  for (const double size : {1e-170, 1e160}) {
    Counts counts;
    expect_boundaries_hold<TypeParam>(Bezier({{0, 0}, {size, 0}, {size, size}}), 1e300, counts);
  }
}

template <class NT> void expect_arcs_near_their_ends() {
  using Traits = Bca_traits_2<Circular<CGAL::Simple_cartesian<NT>>>;
  const Bezier_curve_2<NT> curve({{NT(0), NT(0)}, {NT(1), NT(1.3)}, {NT(2), NT(-1.1)}, {NT(3.3), NT(0.2)}});
  const Region_hierarchy_2<Traits, Bezier_spiral_2<NT>> tree(spiral_segments(curve), 1e-2);
  tree.for_each_leaf([&](const Node_handle& h) {
    const Region_node n = tree.node(h);
    const auto boundary = tree.traits().construct_boundary_2_object()(tree.region(n));
    for (const auto& piece : {boundary.inner[0], boundary.outer[0]}) {
      EXPECT_LE(piece.deviation, std::max(50.0 * static_cast<double>(std::numeric_limits<NT>::epsilon()), 0x1p-53));
      const auto* arc = std::get_if<typename Traits::Kernel::Circular_arc_2>(&piece.curve);
      if (arc == nullptr) continue;
      for (const auto& end : {arc->source(), arc->target()})
        EXPECT_LE(std::fabs(place_by_arc(*arc, false, exact_point(end)).right), piece.deviation);
    }
  });
}
// What a piece's support misses the piece's ends by is a part of the deviation: here it is most of it.
TEST(RoundedArc, IsAsFarFromASupportThatMissesItsEnds) {
  constexpr double OFF = 1e-4;
  const Point from{0, 0}, to{std::sin(1.0), 1 - std::cos(1.0)};  // on the unit circle about (0, 1)
  const internal::Rounded_arc_2<double> arc = internal::rounded_arc<double>({from, to, {{0, OFF}, {0, 1}, 1}});
  ASSERT_GT(arc.squared_radius, 0);
  // about the support's center, with a radius between the distances of both ends
  EXPECT_GE(arc.deviation, std::fabs(std::sqrt(arc.squared_radius) - 1));
  EXPECT_LE(arc.deviation, 4 * OFF);
}

TEST(KernelBoundaryOfOtherNumbers, HasArcsNearTheirEnds) {
  expect_arcs_near_their_ends<float>();
  expect_arcs_near_their_ends<long double>();
}

}  // namespace
}  // namespace test_kernel_boundary
