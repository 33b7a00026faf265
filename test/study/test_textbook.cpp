// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The paper's own steps make the same regions and trees as the stable formulas where nothing is small.

#include <CGAL/Bounding_arcs_2.h>
#include <CGAL/Bounding_arcs_2/study/Textbook.h>

#include <CGAL/CORE_Expr.h>
#include <CGAL/Simple_cartesian.h>

#include <gtest/gtest.h>

#include <cmath>

namespace test_textbook {
namespace {

using namespace CGAL::Bounding_arcs;
using Double_kernel =
    CGAL::Circular_kernel_2<CGAL::Simple_cartesian<double>, CGAL::Algebraic_kernel_for_circles_2_2<double>>;
using Rational = CGAL::Exact_rational;
using Rational_kernel =
    CGAL::Circular_kernel_2<CGAL::Simple_cartesian<Rational>, CGAL::Algebraic_kernel_for_circles_2_2<Rational>>;
using Curve = Bezier_curve_2<double>;

const Curve PARABOLA({{0, 0}, {0.5, 0}, {1, 1}});

template <class Traits> std::size_t number_of_leaves(const Curve& curve, double eps) {
  const Region_hierarchy_2<Traits, Bezier_spiral_2<double>> tree(spiral_segments(curve), eps);
  EXPECT_EQ(tree.status(), Build_status::COMPLETE);
  return tree.number_of_leaves();
}

template <class Traits, class Textbook_traits> void expect_same_trees() {
  const Curve curve({{0, 0.6}, {6.4, 3}, {-2.4, 3.4}, {3, 0}});
  for (const double eps : {0.3, 1e-2, 1e-4})
    EXPECT_EQ((number_of_leaves<Traits>(curve, eps)), (number_of_leaves<Textbook_traits>(curve, eps))) << eps;
}

TEST(TextbookTraits, MakeTheSameTreesWhereNothingIsSmall) {
  expect_same_trees<Bca_traits_2<Double_kernel>, Bca_traits_2<Double_kernel, Textbook_bca>>();
  expect_same_trees<Spiral_fat_arc_traits_2<Double_kernel>,
                    Spiral_fat_arc_traits_2<Double_kernel, Textbook_spiral_fat_arc>>();
  expect_same_trees<Bilens_traits_2<Double_kernel>, Bilens_traits_2<Double_kernel, Textbook_bilens>>();
}

// Boundaries run from end to end, and each joint lies on the circles of both pieces.
template <class Construction> void expect_boundary(const Chord_frame_2<double>& frame) {
  constexpr double ROUNDING = 1e-13;  // sizes are about 1
  const Region_boundary_2<double> textbook = Construction::boundary(frame);
  for (const auto* chain : {&textbook.inner, &textbook.outer}) {
    EXPECT_EQ((*chain)[0].from, frame.p0);
    EXPECT_EQ((*chain)[chain->size() - 1].to, frame.p1);
    for (const Boundary_piece_2<double>& piece : *chain)
      for (const Xy<double>& p : {piece.from, piece.to})
        EXPECT_NEAR(piece.support.side(p) / std::sqrt(dot(piece.support.normal, piece.support.normal)), 0, ROUNDING)
            << Construction::NAME;
  }
}

// The textbook's boundary has the pieces of the stable one: same circles, same ends.
template <class Stable, class Textbook> void expect_same_boundary(const Chord_frame_2<double>& frame) {
  constexpr double ROUNDING = 1e-12;
  expect_boundary<Textbook>(frame);
  const auto a = Stable::boundary(frame), b = Textbook::boundary(frame);
  EXPECT_EQ(a.form, b.form);
  for (const auto& [s, t] : {std::pair(a.inner, b.inner), std::pair(a.outer, b.outer)}) {
    ASSERT_EQ(s.size(), t.size());
    for (std::size_t i = 0; i < s.size(); ++i) {
      EXPECT_NEAR(s[i].to.x, t[i].to.x, ROUNDING);
      EXPECT_NEAR(s[i].to.y, t[i].to.y, ROUNDING);
      ASSERT_EQ(s[i].is_segment(), t[i].is_segment());
      const auto length = [](const Xy<double>& v) { return std::sqrt(dot(v, v)); };
      EXPECT_NEAR(s[i].support.curvature / length(s[i].support.normal),
                  t[i].support.curvature / length(t[i].support.normal), ROUNDING);
      EXPECT_GT(dot(s[i].support.normal, t[i].support.normal), 0);
    }
  }
}

// All four of: turning left or right, tight end first or last.
TEST(TextbookBoundary, IsThatOfTheStableFormulas) {
  for (const double turn : {1.0, -1.0})
    for (const bool reversed : {false, true}) {
      const Xy<double> first{0.1, 0.2}, middle{0.6, 0.2}, last{1.1, 0.2 + turn};
      const Curve curve({reversed ? last : first, middle, reversed ? first : last});
      const auto frame = spiral_segments(curve)[0].frame<double>(0.125, 0.875);
      expect_same_boundary<Bca, Textbook_bca>(frame);
      expect_same_boundary<Spiral_fat_arc, Textbook_spiral_fat_arc>(frame);
      expect_same_boundary<Bilens, Textbook_bilens>(frame);
    }
}

TEST(TextbookBoundary, StepsBackWhereOsculatingCirclesAreLinesOrEqual) {
  const auto straight = spiral_segments(Curve({{0, 0}, {1, 2}}))[0].frame<double>(0, 1);
  const auto arc = spiral_segments(Curve({{1, 0}, {1, 1}, {0, 1}}, {1, 1, 2}))[0].frame<double>(0, 1);
  for (const auto& frame : {straight, arc}) {
    EXPECT_EQ(Textbook_bilens::boundary(frame).form, Region_form::BCA);
    EXPECT_EQ(Textbook_spiral_fat_arc::boundary(frame).form, Region_form::BCA);
    EXPECT_TRUE(std::isfinite(Textbook_bilens::thickness(frame)));
  }
  EXPECT_EQ(Textbook_bca::thickness(straight), 0);
}

// Exact arithmetic does not care which formula it evaluates.
TEST(TextbookTraits, AreExactOverRationalKernels) {
  const auto rational = spiral_segments(PARABOLA)[0].frame<Rational>(0, 1);
  const Bca_traits_2<Rational_kernel, Textbook_bca> traits;
  const auto region = traits.construct_bounding_region_2_object()(rational);
  const CORE::Expr thickness = traits.compute_thickness_2_object()(region);
  EXPECT_TRUE(thickness == CORE::Expr(1) + CGAL::sqrt(CORE::Expr(2)) - CGAL::sqrt(CORE::Expr(5)));
  EXPECT_EQ(traits.compare_thickness_2_object()(region, 0.178), CGAL::LARGER);
  EXPECT_EQ(traits.compare_thickness_2_object()(region, 0.179), CGAL::SMALLER);
}

// Moving a region costs the textbook's thickness digits: the traits compute it in its place.
TEST(TextbookTraits, ThicknessIsComputedInPlace) {
  const Bca_traits_2<Double_kernel, Textbook_bca> traits;
  Chord_frame_2<double> frame = spiral_segments(PARABOLA)[0].frame<double>(0, 1);
  const double here = traits.compute_thickness_2_object()(traits.construct_bounding_region_2_object()(frame));
  const Xy<double> far{1e8 / 3, 1e8 / 7};
  frame.p0 = frame.p0 + far;
  frame.p1 = frame.p1 + far;
  const double there = traits.compute_thickness_2_object()(traits.construct_bounding_region_2_object()(frame));
  EXPECT_NEAR(here, 1 + std::sqrt(2.0) - std::sqrt(5.0), 1e-14);
  EXPECT_GT(std::fabs(there - here), 1e-10);
}

}  // namespace
}  // namespace test_textbook
