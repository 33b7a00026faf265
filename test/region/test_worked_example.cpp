// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The worked example of the paper, C(t) = (t, t^2) on [0,1]: every number of it, over every kind of kernel.  Exact
// kernels give exactly these numbers, floating ones come within ULPS units in the last place.

#include <CGAL/Bounding_arcs_2.h>

#include <CGAL/CORE_Expr.h>
#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Exact_rational.h>
#include <CGAL/Simple_cartesian.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <type_traits>
#include <variant>

namespace test_worked_example {
namespace {

using namespace CGAL::Bounding_arcs;
using Expr = CORE::Expr;

// The distance of i from the circle goes with the square of a quotient: up to nine roundings of half an ulp at the
// start of a binade, of which float happens to meet more than four ulps.
template <class FT> constexpr int ULPS = std::is_same_v<FT, double> ? 4 : 5;

template <class LinearKernel>
using Circular =
    CGAL::Circular_kernel_2<LinearKernel, CGAL::Algebraic_kernel_for_circles_2_2<typename LinearKernel::FT>>;

template <class FT> Expr expression(const FT& x) {
  if constexpr (std::is_floating_point_v<FT>) {
    const double high = static_cast<double>(x);
    return Expr(high) + Expr(static_cast<double>(x - FT(high)));
  } else {
    return convert<Expr>(x);
  }
}

// Exactly equal, or for floating numbers within ULPS of a figure of that size.
template <class FT> void expect_number(const FT& found, const Expr& wanted, double size) {
  const Expr error = abs(expression(found) - wanted);
  if constexpr (std::is_floating_point_v<FT>)
    EXPECT_LE(error, Expr(std::ldexp(ULPS<FT> * double(std::numeric_limits<FT>::epsilon()), std::ilogb(size))))
        << "found " << found << ", wanted " << wanted.doubleValue();
  else EXPECT_EQ(error, Expr(0)) << "found " << CGAL::to_double(found) << ", wanted " << wanted.doubleValue();
}
template <class FT> void expect_number(const FT& found, const Expr& wanted) {
  expect_number(found, wanted, wanted.doubleValue());
}
template <class FT> void expect_point(const Xy<FT>& found, const Expr& x, const Expr& y) {
  const double size = std::max(std::fabs(x.doubleValue()), std::fabs(y.doubleValue()));
  expect_number(found.x, x, x == Expr(0) ? size : std::fabs(x.doubleValue()));
  expect_number(found.y, y, y == Expr(0) ? size : std::fabs(y.doubleValue()));
}
template <class FT>
void expect_circle(const Contact_circle_2<FT>& circle, const Expr& x, const Expr& y, const Expr& squared_radius) {
  expect_point(circle.center(), x, y);
  expect_number(circle.squared_radius(), squared_radius);
}

// The chord frame of the parabola; of (t, -t^2) when it is mirrored, of C(1 - t) when it is reversed.
template <class FT> Chord_frame_2<FT> parabola(bool mirrored = false, bool reversed = false) {
  const FT sign(mirrored ? -1 : 1);
  const Bezier_curve_2<FT> curve({{FT(0), FT(0)}, {FT(1) / FT(2), FT(0)}, {FT(1), sign}});
  const auto spirals = spiral_segments(reversed ? curve.reversed() : curve);
  EXPECT_EQ(spirals.size(), 1u);
  return spirals.front().template frame<FT>(0, 1);
}

template <class Arc, class Piece, class Point>
void expect_piece(const Piece& piece, const Point& from, const Point& to, bool reversed) {
  const Arc* arc = std::get_if<Arc>(&piece.curve);
  ASSERT_NE(arc, nullptr);
  EXPECT_EQ(piece.reversed, reversed);
  const auto &first = reversed ? arc->target() : arc->source(), &last = reversed ? arc->source() : arc->target();
  EXPECT_TRUE(first.x() == from.x && first.y() == from.y);
  EXPECT_TRUE(last.x() == to.x && last.y() == to.y);
}

template <class LinearKernel> class WorkedExample : public testing::Test {
 protected:
  using Kernel = Circular<LinearKernel>;
  using FT = typename Kernel::FT;
  using Circular_arc = typename Kernel::Circular_arc_2;
  using Line_arc = typename Kernel::Line_arc_2;
  static constexpr bool HAS_ROOTS = has_square_root_v<FT>;
};

using Linear_kernels =
    testing::Types<CGAL::Simple_cartesian<float>, CGAL::Simple_cartesian<double>, CGAL::Simple_cartesian<long double>,
                   CGAL::Exact_predicates_inexact_constructions_kernel, CGAL::Simple_cartesian<CGAL::Exact_rational>,
                   CGAL::Exact_predicates_exact_constructions_kernel, CGAL::Simple_cartesian<Expr>>;
TYPED_TEST_SUITE(WorkedExample, Linear_kernels);

TYPED_TEST(WorkedExample, HasItsBoundingCircularArcs) {
  const Bca_traits_2<typename TestFixture::Kernel> traits;
  const auto region = traits.construct_bounding_region_2_object()(parabola<typename TestFixture::FT>());
  const auto boundary = traits.construct_region_boundary_2_object()(region);
  ASSERT_EQ(boundary.form, Region_form::BCA);
  expect_circle(boundary.outer[0].support, 0, 1, 1);
  expect_circle(boundary.inner[0].support, -1, 2, 5);
  const Expr thickness = Expr(1) + sqrt(Expr(2)) - sqrt(Expr(5));
  expect_number(traits.compute_thickness_2_object()(region), thickness);
  const auto compare = traits.compare_thickness_2_object();
  EXPECT_EQ(compare(region, 0.1782), CGAL::SMALLER);
  EXPECT_EQ(compare(region, 0.1781), CGAL::LARGER);
}

TYPED_TEST(WorkedExample, HasItsSpiralFatArc) {
  using FT = typename TestFixture::FT;
  const Spiral_fat_arc_traits_2<typename TestFixture::Kernel> traits;
  const auto region = traits.construct_bounding_region_2_object()(parabola<FT>());
  const Expr s = sqrt(Expr(19)) - Expr(4), half = Expr(1) / Expr(2);
  expect_number(traits.compute_thickness_2_object()(region), sqrt(s * s + half * half) - half);
  if constexpr (TestFixture::HAS_ROOTS) {
    const auto boundary = traits.construct_region_boundary_2_object()(region);
    ASSERT_EQ(boundary.form, Region_form::SPIRAL_FAT_ARC);
    expect_circle(boundary.inner[0].support, 0, half, half * half);
    expect_circle(boundary.outer[1].support, -4, Expr(7) / Expr(2), Expr(125) / Expr(4));
    const Xy<FT> j = boundary.inner[0].to, i = boundary.outer[0].to, tangent = boundary.inner[1].to - j;
    expect_point(j, Expr(2) / Expr(5), Expr(1) / Expr(5));
    expect_point(i, s, 0);
    expect_number(square_root(dot(tangent, tangent)), 1);
  } else {
    const auto boundary = traits.construct_boundary_2_object()(region);
    const auto& arc = std::get<typename TestFixture::Circular_arc>(boundary.inner[0].curve);
    EXPECT_EQ(arc.supporting_circle().center(), typename TestFixture::Kernel::Point_2(FT(0), FT(1) / FT(2)));
    EXPECT_EQ(arc.supporting_circle().squared_radius(), FT(1) / FT(4));
    EXPECT_TRUE(arc.target().x() == FT(2) / FT(5) && arc.target().y() == FT(1) / FT(5));
    const auto& far = std::get<typename TestFixture::Circular_arc>(boundary.outer[1].curve);
    EXPECT_EQ(far.supporting_circle().center(), typename TestFixture::Kernel::Point_2(FT(-4), FT(7) / FT(2)));
    EXPECT_EQ(far.supporting_circle().squared_radius(), FT(125) / FT(4));
    EXPECT_TRUE(far.source().x() == CGAL::make_root_of_2(FT(-4), FT(1), FT(19)) && far.source().y() == FT(0));
  }
}

TYPED_TEST(WorkedExample, HasItsBilensWhereThereAreSquareRoots) {
  using FT = typename TestFixture::FT;
  if constexpr (TestFixture::HAS_ROOTS) {
    const Bilens_traits_2<typename TestFixture::Kernel> traits;
    const auto region = traits.construct_bounding_region_2_object()(parabola<FT>());
    const auto boundary = traits.construct_region_boundary_2_object()(region);
    ASSERT_EQ(boundary.form, Region_form::BILENS);
    const Expr root = sqrt(Expr(5)), two(2), four(4), radius = (Expr(3) * root + Expr(5)) / four;
    const Expr height = Expr(3) * (Expr(5) * root + Expr(7)) / Expr(76);
    const Expr zx = -(Expr(1) + root) / two, zy = (Expr(7) + root) / four;
    expect_circle(boundary.inner[0].support, 0, Expr(1) / two, Expr(1) / four);
    expect_circle(boundary.inner[1].support, zx, zy, radius * radius);
    expect_circle(boundary.outer[0].support, 0, height, height * height);
    expect_circle(boundary.outer[1].support, -4, Expr(7) / two, Expr(125) / four);
    const Expr distance = sqrt(zx * zx + (zy - height) * (zy - height));
    const Expr thickness = height + distance - radius;
    EXPECT_NEAR(thickness.doubleValue(), 0.060065058155073692, 1e-17);
    expect_number(traits.compute_thickness_2_object()(region), thickness);
  } else {
    EXPECT_TRUE(Bilens::BOUNDARY_NEEDS_SQUARE_ROOT);
  }
}

// A curve that turns right is bounded by clockwise arcs, which the kernel keeps the other way round.
TYPED_TEST(WorkedExample, BecomesKernelArcsThatKnowTheirDirection) {
  using FT = typename TestFixture::FT;
  using Arc = typename TestFixture::Circular_arc;
  using Line = typename TestFixture::Line_arc;
  for (const bool mirrored : {false, true}) {
    for (const bool reversed : {false, true}) {
      const bool clockwise = mirrored != reversed;
      const Chord_frame_2<FT> frame = parabola<FT>(mirrored, reversed);
      const Bca_traits_2<typename TestFixture::Kernel> bca;
      const auto arcs = bca.construct_boundary_2_object()(bca.construct_bounding_region_2_object()(frame));
      expect_piece<Arc>(arcs.inner.at(0), frame.p0, frame.p1, clockwise);
      expect_piece<Arc>(arcs.outer.at(0), frame.p0, frame.p1, clockwise);

      const Spiral_fat_arc_traits_2<typename TestFixture::Kernel> sfa;
      const auto fat = sfa.construct_boundary_2_object()(sfa.construct_bounding_region_2_object()(frame));
      const std::size_t tight = reversed ? 1 : 0;
      ASSERT_EQ(fat.inner.size(), 2u);
      ASSERT_EQ(fat.outer.size(), 2u);
      EXPECT_TRUE(std::holds_alternative<Arc>(fat.inner[tight].curve));
      EXPECT_EQ(fat.inner[tight].reversed, clockwise);
      EXPECT_EQ(std::holds_alternative<Line>(fat.inner[1 - tight].curve), TestFixture::HAS_ROOTS);
      EXPECT_TRUE(std::holds_alternative<Line>(fat.outer[tight].curve));
      EXPECT_FALSE(fat.outer[tight].reversed);
      EXPECT_TRUE(std::holds_alternative<Arc>(fat.outer[1 - tight].curve));
      EXPECT_EQ(fat.outer[1 - tight].reversed, clockwise);
    }
  }
}

TEST(WorkedExampleOverRationals, IsRefusedByBilensForWantOfSquareRoots) {
  EXPECT_FALSE(has_square_root_v<CGAL::Exact_rational>);
  EXPECT_FALSE(has_square_root_v<CGAL::Exact_predicates_exact_constructions_kernel::FT>);
  EXPECT_TRUE(has_square_root_v<Expr>);
}

}  // namespace
}  // namespace test_worked_example
