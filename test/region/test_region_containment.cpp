// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Points of the curve lie in its region, by exact signs: many over rationals for BCA, few over CORE::Expr for the
// regions that need square roots, also where an end is an inflection or a cusp, and under the fallback policies.

#include "cases.h"
#include "random_spirals.h"

#include <CGAL/Bounding_arcs_2.h>

#include <CGAL/CORE_Expr.h>
#include <CGAL/Simple_cartesian.h>

#include <gtest/gtest.h>

namespace test_region_containment {
namespace {

using namespace CGAL::Bounding_arcs;
using namespace bounding_arcs_test;
using Expr = CORE::Expr;
template <class NT>
using Kernel = CGAL::Circular_kernel_2<CGAL::Simple_cartesian<NT>, CGAL::Algebraic_kernel_for_circles_2_2<NT>>;

constexpr Shape_parts ALL_PARTS{true, true};

// Places of points i / n of [t0, t1] against a region, end points left out unless asked for.
template <class NT, class Construction>
void expect_contained(const Piece& p, int n, const Construction& construction = {}) {
  const Bezier_curve_2<Exact> curve = p.spiral.exact_curve();
  const auto point = [&](const Exact& t) { return convert<NT>(curve.point(t)); };
  const Chord_frame_2<NT> frame{point(Exact(p.t0)), point(Exact(p.t1)), p.spiral.shape<NT>(p.t0, p.t1, ALL_PARTS)};
  const Region_boundary_2<NT> region = construction.boundary(frame);
  for (int i = 1; i < n; ++i) {
    const Exact t = Exact(p.t0) + (Exact(p.t1) - Exact(p.t0)) * Exact(i) / Exact(n);
    EXPECT_EQ(bounded_side(region, point(t)), CGAL::ON_BOUNDED_SIDE) << text(p) << ", sample " << i << " of " << n;
  }
}

Piece first_spiral(const std::vector<Point>& points, const std::vector<double>& weights = {}) {
  const Spiral spiral = spiral_segments(Bezier(points, weights)).front();
  return {spiral, spiral.first(), spiral.last()};
}

TEST(BcaRegion, ContainsEverySampleOfARandomSpiral) {
  for (const Piece& p : random_pieces(301, cases(300), 12)) {
    expect_contained<Exact, Bca>(p, 16);
    if (testing::Test::HasFailure()) return;
  }
}

TEST(BcaRegion, HasItsEndPointsOnTheBoundaryAndTheCenterOfTheChordOutside) {
  for (const Piece& p : random_pieces(302, 100, 6)) {
    const Bezier_curve_2<Exact> curve = p.spiral.exact_curve();
    const Chord_frame_2<Exact> f{curve.point(Exact(p.t0)), curve.point(Exact(p.t1)), p.spiral.shape<Exact>(p.t0, p.t1)};
    const auto region = Bca::boundary(f);
    EXPECT_EQ(bounded_side(region, f.p0), CGAL::ON_BOUNDARY) << text(p);
    EXPECT_EQ(bounded_side(region, f.p1), CGAL::ON_BOUNDARY) << text(p);
    const Xy<Exact> middle = Exact(Exact(1) / 2) * (f.p0 + f.p1), away = perp(Xy<Exact>(f.p1 - f.p0));
    EXPECT_EQ(bounded_side(region, middle), CGAL::ON_UNBOUNDED_SIDE) << text(p);
    EXPECT_EQ(bounded_side(region, Xy<Exact>(f.p0 + away)), CGAL::ON_UNBOUNDED_SIDE) << text(p);
  }
}

template <class Construction> class RegionWithRoots : public testing::Test {};
using Constructions = testing::Types<Spiral_fat_arc, Bilens>;
TYPED_TEST_SUITE(RegionWithRoots, Constructions);

TYPED_TEST(RegionWithRoots, ContainsSamplesOfARandomSpiral) {
  std::mt19937 random(303);
  int count = 0;
  while (count < 60) {
    for (const Spiral& spiral : spiral_segments(random_curve(random, 3, count % 2 == 1))) {
      // an inner piece: at a rounded vertex the end value of curvature is not its extreme
      const double third = (spiral.last() - spiral.first()) / 3;
      const Piece p{spiral, spiral.first() + third, spiral.last() - third};
      if (!p.spiral.shape<double>(p.t0, p.t1).proper) continue;
      expect_contained<Expr, TypeParam>(p, 8);
      ++count;
    }
  }
}

TYPED_TEST(RegionWithRoots, LeavesNeighbouringPointsOutside) {
  const Piece p = first_spiral({{0, 0}, {0.5, 0}, {1, 1}});  // (t, t^2)
  const auto region = TypeParam::boundary(p.spiral.frame<Expr>(0, 1));
  for (const Point& q : {Point{0.5, 0.5}, Point{0.5, 0.1}, Point{0.1, 0.1}, Point{0.9, 0.7}, Point{0, 1}, Point{1, 0}})
    EXPECT_EQ(bounded_side(region, convert<Expr>(q)), CGAL::ON_UNBOUNDED_SIDE) << q.x << ", " << q.y;
  EXPECT_EQ(bounded_side(region, Xy<Expr>{0, 0}), CGAL::ON_BOUNDARY);
}

template <class Construction> void expect_contained_at_special_ends() {
  const double third = 1.0 / 3, half = 0.5;
  // an inflection at the start, (t, t^3); a cusp, (t^2, t^3); zero handles with finite curvature, (t^2, t^4)
  for (const auto& points : std::vector<std::vector<Point>>{{{0, 0}, {3, 0}, {6, 0}, {9, 9}},
                                                            {{0, 0}, {0, 0}, {1, 0}, {3, 3}},
                                                            {{0, 0}, {0, 0}, {1, 0}, {3, 0}, {6, 6}}}) {
    for (const auto& weights : std::vector<std::vector<double>>{{}, {1, half, third, half, 1}}) {
      const std::size_t n = points.size();
      std::vector<double> w = weights;
      if (!w.empty()) w.resize(n);
      std::vector<Point> backwards(points.rbegin(), points.rend());
      for (const auto& order : {points, backwards}) {
        const auto spirals = spiral_segments(Bezier(order, w));
        const Spiral& spiral = order == points ? spirals.front() : spirals.back();
        const Piece p{spiral, spiral.first(), spiral.last()};
        expect_contained<Expr, Construction>(p, 3);
        const double thickness = Construction::thickness(spiral.template shape<double>(p.t0, p.t1));
        EXPECT_GT(thickness, 1e-4);
        EXPECT_LT(thickness, 3);
      }
    }
  }
}

TEST(BcaRegion, ContainsSpiralsWithInflectionOrCuspAtAnEnd) { expect_contained_at_special_ends<Bca>(); }
TYPED_TEST(RegionWithRoots, ContainsSpiralsWithInflectionOrCuspAtAnEnd) {
  expect_contained_at_special_ends<TypeParam>();
}

// C' = (u^2, u) with u = 3 t - 1: the cusp lies between two doubles.
TYPED_TEST(RegionWithRoots, ContainsBothSpiralsAtACuspInsideACurve) {
  const auto spirals = spiral_segments(Bezier({{0, 0}, {1, -1}, {-1, -0.5}, {3, 1.5}}));
  ASSERT_EQ(spirals.size(), 2u);
  for (const Spiral& spiral : spirals) {
    const Piece p{spiral, spiral.first(), spiral.last()};
    const auto frame = spiral.frame(p.t0, p.t1);
    EXPECT_EQ(frame.shape.infinite0, &spiral == &spirals.back());
    EXPECT_EQ(frame.shape.infinite1, &spiral == &spirals.front());
    EXPECT_NE(TypeParam::boundary(frame).form, Region_form::BCA);
    expect_contained<Expr, TypeParam>(p, 5);
    expect_contained<Exact, Bca>(p, 5);
  }
}

TYPED_TEST(RegionWithRoots, KeepsItsFormAtInflectionsAndCusps) {
  const Piece inflection = first_spiral({{0, 0}, {3, 0}, {6, 0}, {9, 9}});
  const Piece cusp = first_spiral({{0, 0}, {0, 0}, {1, 0}, {3, 3}});
  const auto level = inflection.spiral.frame(inflection.t0, inflection.t1);
  const auto sharp = cusp.spiral.frame(cusp.t0, cusp.t1);
  EXPECT_EQ(level.shape.curvature0, 0);
  EXPECT_TRUE(sharp.shape.infinite0);
  for (const auto& frame : {level, sharp}) EXPECT_NE(TypeParam::boundary(frame).form, Region_form::BCA);
  EXPECT_TRUE(TypeParam::boundary(level).outer[0].is_segment());
  EXPECT_EQ(TypeParam::boundary(sharp).inner.size(), 1u);
}

TYPED_TEST(RegionWithRoots, BecomesABcaWhereEndCurvaturesDifferByLessThanTheTolerance) {
  const Piece p = first_spiral({{0, 0}, {0.5, 0}, {1, 1}});
  const auto frame = p.spiral.frame(0, 0.5);  // curvatures 2 and 2 / 2^(3/2)
  const Near_circular_to_bca<TypeParam> above{{}, 1.3}, below{{}, 1.29};
  static_assert(TypeParam::NEEDS_CURVATURE && Near_circular_to_bca<TypeParam>::NEEDS_CURVATURE);
  EXPECT_EQ(above.boundary(frame).form, Region_form::BCA);
  EXPECT_EQ(above.thickness(frame.shape), Bca::thickness(frame.shape));
  EXPECT_EQ(below.boundary(frame).form, TypeParam::boundary(frame).form);
  EXPECT_NE(below.boundary(frame).form, Region_form::BCA);
  EXPECT_EQ(below.thickness(frame.shape), TypeParam::thickness(frame.shape));
  expect_contained<Expr>({p.spiral, 0, 0.5}, 3, above);
  expect_contained<Expr>({p.spiral, 0, 0.5}, 3, below);
}

TEST(NearLinearToChord, BecomesChordAndCircleWhereThePieceIsFlat) {
  const double h = 0x1p-6;
  for (const double sign : {1.0, -1.0}) {
    const Piece p = first_spiral({{0, 0}, {0.5, 0}, {1, sign}});
    const auto frame = p.spiral.frame<double>(0, h, ALL_PARTS);  // half-angle tangents of about h / 2
    const Near_linear_to_chord above{{}, h}, below{{}, h / 4};
    EXPECT_EQ(below.boundary(frame).form, Region_form::BCA);
    EXPECT_EQ(below.thickness(frame.shape), Bca::thickness(frame.shape));
    const auto region = above.boundary(frame);
    ASSERT_EQ(region.form, Region_form::CHORD_AND_CIRCLE);
    EXPECT_TRUE(region.inner[0].is_segment());
    EXPECT_GE(above.thickness(frame.shape), h * h / 4);  // the height of the curve over its chord
    EXPECT_LE(above.thickness(frame.shape), h * h);
    // the circle passes the middle control point, which lies at twice that height
    EXPECT_NEAR(region.outer[0].support.side(Point{h / 2, 0}), 0, 1e-12);
    expect_contained<Expr>({p.spiral, 0, h}, 4, above);
    expect_contained<Expr>({p.spiral, 0, h}, 4, below);
  }
}

}  // namespace
}  // namespace test_region_containment
