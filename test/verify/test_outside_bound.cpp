// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// How far a piece is out of a boundary: the bound is no less than exact samples, not much more, and sees one ulp.

#include "degenerate_curves.h"
#include "random_spirals.h"

#include <CGAL/Bounding_arcs_2.h>
#include <CGAL/Bounding_arcs_2/verify/outside_bound.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

namespace test_outside_bound {
namespace {

using namespace CGAL::Bounding_arcs;
using namespace bounding_arcs_test;

template <class FT> Chord_frame_2<FT> frame_over(const Piece& p) {
  std::vector<Xy<FT>> points;
  std::vector<FT> weights;
  for (const Point& q : p.spiral.curve().control_points()) points.push_back({FT(q.x), FT(q.y)});
  for (const double w : p.spiral.curve().weights()) weights.push_back(FT(w));
  const Bezier_curve_2<FT> curve(points, weights);
  const Taylor_table<FT> table(curve, length_unit(curve));
  return {curve.point(FT(p.t0)), curve.point(FT(p.t1)),
          bezier_chord_shape(table, FT(p.t0), FT(p.t1), {}, p.spiral.orders(p.t0, p.t1))};
}

using Pieces = std::vector<Boundary_piece_2<double>>;
Boundary_chain_2<double> chain_of(const Pieces& pieces) {
  return pieces.size() == 1 ? Boundary_chain_2<double>(pieces[0]) : Boundary_chain_2<double>(pieces[0], pieces[1]);
}

Region_boundary_2<double> moved(Region_boundary_2<double> boundary, const Point& by) {
  for (auto* chain : {&boundary.inner, &boundary.outer}) {
    Pieces pieces(chain->begin(), chain->end());
    for (auto& p : pieces) p = {p.from + by, p.to + by, {p.support.point + by, p.support.normal, p.support.curvature}};
    *chain = chain_of(pieces);
  }
  return boundary;
}

double length(const Point& v) { return std::hypot(v.x, v.y); }

// The distance of samples of the piece from the lune of a BCA, in long double: at least this much sticks out.
template <class FT> double sampled_outside(const Piece& p, const Region_boundary_2<FT>& b) {
  using Long = long double;
  const Bezier_curve_2<Exact> curve = p.spiral.exact_curve();
  const int turn = b.outer[0].support.curvature < 0 ? -1 : 1;
  Long most = 0;
  for (int i = 0; i <= 64; ++i) {
    const Exact t = Exact(p.t0) + (Exact(p.t1) - Exact(p.t0)) * i / 64;
    const Xy<Exact> q = curve.point(t);
    for (const bool outer : {true, false}) {
      const Boundary_piece_2<FT>& arc = (outer ? b.outer : b.inner)[0];
      const auto exact = [](const Xy<FT>& x) {
        return Xy<Exact>{Exact_number<FT>::make(x.x), Exact_number<FT>::make(x.y)};
      };
      const Xy<Exact> v = q - exact(arc.support.point), n = exact(arc.support.normal);
      const Exact k = Exact_number<FT>::make(arc.support.curvature);
      const Xy<Exact> along = Exact(-1) * perp(Xy<Exact>(n - k * v));  // beside the arc's ends the distance is another
      if (dot(along, Xy<Exact>(q - exact(arc.from))) < 0 || dot(along, Xy<Exact>(q - exact(arc.to))) > 0) continue;
      const int side = outer ? turn : -turn;
      const Long excess = CGAL::to_double(Exact(side * (k * dot(v, v) - 2 * dot(n, v)))),
                 normal = std::hypot(Long(arc.support.normal.x), Long(arc.support.normal.y));
      if (!(excess > 0)) continue;
      Long nearest = excess / (normal + std::sqrt(normal * normal + side * arc.support.curvature * excess));
      for (const Xy<FT>& end : {arc.from, arc.to}) {
        const Xy<Exact> way = q - exact(end);
        nearest = (std::min)(nearest, std::hypot(Long(CGAL::to_double(way.x)), Long(CGAL::to_double(way.y))));
      }
      most = (std::max)(most, nearest);
    }
  }
  return static_cast<double>(most);
}

template <class Construction> class OutsideBound : public testing::Test {};
using Constructions = testing::Types<Bca, Spiral_fat_arc, Bilens>;
TYPED_TEST_SUITE(OutsideBound, Constructions);

TYPED_TEST(OutsideBound, IsAFewUlpForDoubleBoundaries) {
  for (const int depth : {0, 6, 20}) {
    for (const Piece& p : random_pieces(41, 300, depth)) {
      const double bound = outside_bound(p.spiral, p.t0, p.t1, TypeParam::boundary(p.spiral.frame<double>(p.t0, p.t1)));
      EXPECT_LE(bound, 16 * std::numeric_limits<double>::epsilon()) << text(p);
    }
  }
}

TYPED_TEST(OutsideBound, IsTheDistanceByWhichABoundaryIsMoved) {
  for (const Piece& p : random_pieces(42, 100, 8)) {
    const Chord_frame_2<double> frame = p.spiral.frame<double>(p.t0, p.t1);
    const double chord = length(frame.p1 - frame.p0), thickness = TypeParam::thickness(frame.shape);
    if (!(thickness < 1e-4 * chord) || p.t0 == p.spiral.first() || p.t1 == p.spiral.last()) continue;
    for (int i = 0; i < 8; ++i) {
      const double angle = 0.3 + i * 0.785, distance = 0.05 * chord;
      const Point by{distance * std::cos(angle), distance * std::sin(angle)};
      const double bound = outside_bound(p.spiral, p.t0, p.t1, moved(TypeParam::boundary(frame), by));
      // the moved region's points are at most the thickness away from a copy of the curve
      const double across = std::fabs(cross(by, frame.p1 - frame.p0)) / chord;
      EXPECT_GE(bound, 0.9 * across - thickness) << text(p) << ", angle " << angle;
      EXPECT_LE(bound, 1.1 * distance + thickness) << text(p) << ", angle " << angle;
    }
  }
}

TYPED_TEST(OutsideBound, SeesEveryArcThatIsMovedIntoTheRegion) {
  int arcs = 0;
  for (const Piece& p : random_pieces(46, 60, 8)) {
    const Chord_frame_2<double> frame = p.spiral.frame<double>(p.t0, p.t1);
    const double chord = length(frame.p1 - frame.p0), thickness = TypeParam::thickness(frame.shape);
    if (!(thickness < 0.01 * chord && thickness > 1e-9 * chord) || p.t0 == p.spiral.first() || p.t1 == p.spiral.last())
      continue;
    const Region_boundary_2<double> boundary = TypeParam::boundary(frame);
    for (const bool outer : {true, false}) {
      const auto& chain = outer ? boundary.outer : boundary.inner;
      for (std::size_t i = 0; i < chain.size(); ++i) {
        if (length(chain[i].to - chain[i].from) < 0.1 * chord) continue;
        Pieces pieces(chain.begin(), chain.end());
        Contact_circle_2<double>& circle = pieces[i].support;  // which the curve touches at an end
        const double distance = thickness / 16,
                     way = (outer ? 1 : -1) * frame.shape.turn * distance / length(circle.normal);
        circle.point = circle.point + way * circle.normal;
        circle.curvature /= 1 - way * circle.curvature;
        Region_boundary_2<double> narrower = boundary;
        (outer ? narrower.outer : narrower.inner) = chain_of(pieces);
        EXPECT_GE(outside_bound(p.spiral, p.t0, p.t1, narrower), distance / 4)
            << text(p) << (outer ? ", outer " : ", inner ") << i;
        ++arcs;
      }
    }
  }
  EXPECT_GT(arcs, 40);
}

TYPED_TEST(OutsideBound, SeesPointsPastTheEnds) {
  for (const Piece& p : random_pieces(43, 100, 8)) {
    const Chord_frame_2<double> frame = p.spiral.frame<double>(p.t0, p.t1);
    const double middle = p.t0 + (p.t1 - p.t0) / 2;
    const Chord_frame_2<double> half = p.spiral.frame<double>(p.t0, middle);
    const double missing = length(frame.p1 - half.p1);
    const double bound = outside_bound(p.spiral, p.t0, p.t1, TypeParam::boundary(half));
    EXPECT_GE(bound, (1 - 1e-9) * missing) << text(p);
  }
}

TYPED_TEST(OutsideBound, IsInfiniteForNumbersThatAreNone) {
  const Piece p = random_pieces(44, 1, 3).front();
  for (const double x : {std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity()})
    EXPECT_EQ(
        outside_bound(p.spiral, p.t0, p.t1, moved(TypeParam::boundary(p.spiral.frame<double>(p.t0, p.t1)), {x, 0})),
        std::numeric_limits<double>::infinity());
}

template <class FT> void expect_near_samples() {
  for (const Piece& p : random_pieces(45, 60, 4)) {
    const Region_boundary_2<FT> boundary = Bca::boundary(frame_over<FT>(p));
    const double bound = outside_bound(p.spiral, p.t0, p.t1, boundary);
    EXPECT_GE(bound, (1 - 1e-6) * sampled_outside(p, boundary)) << text(p);
    EXPECT_LE(bound, 200 * static_cast<double>(std::numeric_limits<FT>::epsilon())) << text(p);
  }
}
TEST(OutsideBound, IsNotBelowSamplesOfFloatBoundaries) { expect_near_samples<float>(); }
TEST(OutsideBound, IsNotBelowSamplesOfDoubleBoundaries) { expect_near_samples<double>(); }
TEST(OutsideBound, IsNotBelowSamplesOfLongDoubleBoundaries) { expect_near_samples<long double>(); }

// The ends of whose regions are at nearly a right angle to the way of the curve there, or are discs.
TEST(OutsideBound, IsAFewUlpBesideFoldsOfThinCurves) {
  Degenerate_curves curves(47);
  int discs = 0, pieces = 0;
  for (int i = 0; i < 100; ++i)
    for (const Spiral& spiral : spiral_segments(curves(Kind::THIN))) {
      const Piece p{spiral, spiral.first(), spiral.last()};
      const Region_boundary_2<double> boundary = Bca::boundary(spiral.frame<double>(p.t0, p.t1));
      const double size = spiral.coordinate_size(), ulp = std::nextafter(size, HUGE_VAL) - size;
      const double bound = outside_bound(spiral, p.t0, p.t1, boundary, ulp / 2);
      EXPECT_LE(bound, 32 * ulp) << text(p);
      const double chord = length(boundary.inner[0].to - boundary.inner[0].from);
      if (chord < 0x1p20 * ulp || size > 0x1p100 || size < 0x1p-100) continue;  // where samples tell nothing
      EXPECT_GE((std::max)(bound, ulp / 2), (1 - 1e-6) * sampled_outside(p, boundary)) << text(p);
      discs += boundary.inner[0].support.normal == -boundary.outer[0].support.normal;
      ++pieces;
    }
  EXPECT_GT(discs, 2);
  EXPECT_GT(pieces, 200);
}

// The curve is farthest from its chord between the ends of the parts that a search looks at.
TEST(OutsideBound, IsNotBelowSamplesOfAChord) {
  for (const Piece& p : random_pieces(47, 100, 6)) {
    const Chord_frame_2<double> frame = p.spiral.frame<double>(p.t0, p.t1);
    const Boundary_chain_2<double> chord({frame.p0, frame.p1, {frame.p0, perp(frame.p1 - frame.p0), 0}});
    const Region_boundary_2<double> boundary{chord, chord};
    const double bound = outside_bound(p.spiral, p.t0, p.t1, boundary), height = sampled_outside(p, boundary);
    EXPECT_GE(bound, (1 - 1e-9) * height) << text(p);
    EXPECT_LE(bound, 1.2 * height + 16 * std::numeric_limits<double>::epsilon()) << text(p);
  }
}

TEST(OutsideBound, IsZeroWhereNothingIsRounded) {
  const Bezier parabola({{0, 0}, {0.5, 0}, {1, 1}});  // (t, t^2)
  const Spiral spiral = spiral_segments(parabola).front();
  EXPECT_EQ(outside_bound(spiral, 0, 1, Bca::boundary(spiral.frame<double>(0, 1))), 0);
  EXPECT_TRUE(is_within(spiral, 0, 1, Bca::boundary(spiral.frame<double>(0, 1)), 0));
}

TEST(OutsideBound, FindsOneUlp) {
  const Bezier parabola({{0, 0}, {0.5, 0}, {1, 1}});
  const Spiral spiral = spiral_segments(parabola).front();
  const Region_boundary_2<double> boundary = Bca::boundary(spiral.frame<double>(0, 1));
  const double ulp = std::numeric_limits<double>::epsilon();
  const double bound = outside_bound(spiral, 0, 1, moved(boundary, {0, ulp}));
  EXPECT_GE(bound, ulp);
  EXPECT_LE(bound, 1.2 * ulp);
  EXPECT_FALSE(is_within(spiral, 0, 1, moved(boundary, {0, ulp}), 0.9 * ulp));
  EXPECT_TRUE(is_within(spiral, 0, 1, moved(boundary, {0, ulp}), 1.2 * ulp));
}

}  // namespace
}  // namespace test_outside_bound
