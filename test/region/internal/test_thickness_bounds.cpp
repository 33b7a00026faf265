// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Thickness in double: certified bounds against exact values, and its digits on nearly straight pieces.

#include "cases.h"
#include "chord_invariants.h"
#include "random_spirals.h"
#include "trees.h"

#include <CGAL/Bounding_arcs_2/region/Bilens.h>
#include <CGAL/Bounding_arcs_2/region/Spiral_fat_arc.h>
#include <CGAL/Bounding_arcs_2/region/thickness_bound.h>

#include <CGAL/CORE_Expr.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <type_traits>

namespace test_thickness_bounds {
namespace {

using namespace CGAL::Bounding_arcs;
using namespace bounding_arcs_test;
using Expr = CORE::Expr;

constexpr int DEEPEST = 45;  // halvings: pieces down to 2^-45 of a spiral segment

template <class Construction> void expect_enclosed(const Piece& p, const Chord_shape_2<Exact>& exact) {
  const Construction construction;
  const auto bounded = p.spiral.shape<Bounded_double>(p.t0, p.t1);
  const Bounded_double thickness = construction.thickness(bounded);
  EXPECT_EQ(construction.thickness(p.spiral.shape<double>(p.t0, p.t1)), thickness.value()) << Construction::NAME;
  // Signs of nearly constant curvature are noise: there the double region is a BCA, and its thickness that of a BCA.
  const bool alike = bounded.proper == exact.proper || std::is_same_v<Construction, Bca>;
  const auto range =
      alike ? internal::thickness_interval(construction, exact) : internal::thickness_interval(Bca(), exact);
  EXPECT_LE(thickness.lower(), range.sup()) << Construction::NAME;
  EXPECT_GE(thickness.upper(), range.inf()) << Construction::NAME;
  EXPECT_LE(range.sup() - range.inf(), 1e-8 * range.sup()) << Construction::NAME;
}

TEST(ThicknessInBoundedDouble, EnclosesTheExactThickness) {
  constexpr unsigned SEED = 102;
  for (const Piece& p : random_pieces(SEED, cases(5000), DEEPEST)) {
    SCOPED_TRACE(text(p) + ", seed 102");
    const Chord_shape_2<Exact> exact = p.spiral.shape<Exact>(p.t0, p.t1);
    expect_enclosed<Bca>(p, exact);
    expect_enclosed<Spiral_fat_arc>(p, exact);
    expect_enclosed<Bilens>(p, exact);
    if (testing::Test::HasFailure()) return;
  }
}

TEST(BoundedDouble, TakesTheLargerErrorOfTwoToTheirMaximum) {
  const Bounded_double sure(2.0), unsure(1.0, 4.0), larger = CGAL::Bounding_arcs::larger(sure, unsure);
  EXPECT_EQ(larger.value(), 2);
  EXPECT_GE(larger.upper(), 5);
  EXPECT_EQ(CGAL::Bounding_arcs::larger(unsure, sure).upper(), larger.upper());
}

TEST(BoundedDouble, CutsAnErrorBoundToWhatALimitLeavesPossible) {
  const auto limit = [] { return Bounded_double(3.0, 0.5); };
  const Bounded_double cut = limited(Bounded_double(1.0, 100.0), limit);
  EXPECT_EQ(cut.value(), 1);
  EXPECT_GE(cut.upper(), 3.5);
  EXPECT_LT(cut.upper(), 3.6);
  EXPECT_LE(cut.lower(), 0);
  EXPECT_EQ(limited(Bounded_double(1.0, 0.25), limit).upper(), Bounded_double(1.0, 0.25).upper());
  EXPECT_TRUE(std::isnan(limited(Bounded_double(std::nan("")), limit).value()));
}

TEST(BoundedDouble, KeepsWhatLongDoubleHoldsBeyondDouble) {
  const long double x = 1 + std::numeric_limits<long double>::epsilon();
  const auto bounded = convert<Bounded_double>(x);
  EXPECT_EQ(bounded.value(), 1);
  EXPECT_EQ(bounded.upper() > 1, x > 1);
  EXPECT_EQ(convert<Bounded_double>(0.5L).error_bound(), 0);
}

// Of parabolas over (-w, w) it is that of the two tangents' meeting point, which is as far below the vertex as the
// chord is above it.
TEST(TriangleHeight, IsThatOfTheEndTangents) {
  for (const double w : {0.5, 0.25, 0x1p-10, 0x1p-20}) {
    const auto at = [](double u) { return End_jet_2<Bounded_double>{{u, u * u}, {1.0, 2 * u}, {0.0, 2.0}}; };
    const double height = internal::triangle_height(chord_frame(at(-w), at(w)).shape);
    EXPECT_GE(height, 2 * w * w);
    EXPECT_LE(height, 2 * w * w * (1 + 1e-9));
  }
}

// Of parabolas from the vertex on, tight at one end: the tangents meet half-way to the other end.
TEST(TriangleHeight, IsThatOfTheTighterEnd) {
  const auto at = [](double u) { return End_jet_2<Bounded_double>{{u, u * u}, {1.0, 2 * u}, {0.0, 2.0}}; };
  const double exact = 0.5 / std::sqrt(2.0),
               of_isosceles = std::sqrt(2.0) / 2;  // the latter with both angles 45 degrees
  for (const double u : {-1.0, 0.0}) {
    const double height = internal::triangle_height(chord_frame(at(u), at(u + 1)).shape);
    EXPECT_GE(height, exact);
    EXPECT_NEAR(height, of_isosceles, 1e-9);
  }
}

TEST(BcaThickness, KeepsItsDigitsOnNearlyStraightPieces) {
  double worst = 0;
  for (const double d : {1.0, 1e-2, 1e-5, 1e-8, 1e-12, 1e-30, 1e-100, 1e-250}) {
    const Bezier_curve_2<double> curve({{0, 0}, {1.0 / 3, 0}, {2.0 / 3, d / 3}, {1, d + d / 3}});
    const Spiral spiral = spiral_segments(curve).front();
    const auto curve_exactly = spiral.exact_curve();
    const auto f = convert_frame(chord_frame(end_jet(curve_exactly, true), end_jet(curve_exactly, false)));
    const Expr c = sqrt(dot(f.shape.chord, f.shape.chord));
    const auto half_angle_tangent = [&](const Expr& sine, const Xy<Expr>& t) {
      return Expr(sine / (sqrt(dot(t, t)) * c + dot(t, f.shape.chord)));
    };
    const Expr exact =
        c / Expr(2) *
        (half_angle_tangent(f.shape.cross1, f.shape.tangent1) - half_angle_tangent(f.shape.cross0, f.shape.tangent0));
    const Expr found(Bca::thickness(spiral.shape<double>(0, 1)));
    worst = std::max(worst, std::fabs(Expr((found - abs(exact)) / exact).doubleValue()));
    EXPECT_LE(worst, 1e-15) << "d = " << d;
  }
}

// Running errors of numbers near the least double are no bounds: 1e230, of a curve that is 64 long.
TEST(ThicknessBound, OfWhatIsAlmostALineIsNoErrorBound) {
  const Bezier_curve_2<double> curve({{0x1p-928, -32}, {0, -65}, {0x1p-1072, -96.5}});
  const Spiral spiral = spiral_segments(curve).front();
  const Spiral_source piece{spiral, 0, 1};
  EXPECT_TRUE(Bca_traits_2<Kernel>().bound_thickness_2_object()(piece, 1).within);
  EXPECT_TRUE(Spiral_fat_arc_traits_2<Kernel>().bound_thickness_2_object()(piece, 1).within);
  EXPECT_TRUE(Bilens_traits_2<Kernel>().bound_thickness_2_object()(piece, 1).within);
}

}  // namespace
}  // namespace test_thickness_bounds
