// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Queries by a tree, over each kind of kernel: points of the kernel go in and come out, and the traits decide how what
// doubles leave open is answered.

#include "hard_cases.h"
#include "kernel_trees.h"
#include "query_drawings.h"

#include <CGAL/Bounding_arcs_2.h>
#include <CGAL/Bounding_arcs_2/curve/converted_drawing.h>
#include <CGAL/Bounding_arcs_2/medial_axis/medial_axis.h>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Exact_rational.h>
#include <CGAL/Simple_cartesian.h>

#include <gtest/gtest.h>

#include <cmath>
#include <stdexcept>
#include <string>
#include <type_traits>
#include <vector>

namespace test_tree_queries {
namespace {

using namespace bounding_arcs_test;
using Exact = CGAL::Exact_rational;
using Bounds = ba::Bracket;

template <class Tree> constexpr bool IS_EXACT = !std::is_same_v<Tree, Double_tree>;
template <class Tree> Tree tree_of(const Drawing& drawing) { return Tree(ba::converted<typename Tree::FT>(drawing)); }
template <class Tree> typename Tree::Point_2 point_of(double x, double y) {
  return typename Tree::Point_2(typename Tree::FT(x), typename Tree::FT(y));
}

template <class A, class B> void expect_overlap(const A& a, const B& b) {
  EXPECT_LE(a.lower, b.upper);
  EXPECT_LE(b.lower, a.upper);
}

template <class Tree> class TreeQueries : public ::testing::Test {};
using Trees = ::testing::Types<Double_tree, Filtered_tree, Exact_tree>;
TYPED_TEST_SUITE(TreeQueries, Trees);

TYPED_TEST(TreeQueries, OfHardCasesAreThoseOfTheFilteredKernel) {
  for (const Hard_case& c : hard_cases({})) {
    SCOPED_TRACE(c.name);
    const TypeParam a = tree_of<TypeParam>(c.a), b = tree_of<TypeParam>(c.b);
    const Filtered_tree of_a(c.a), of_b(c.b);
    const auto found = ba::intersections(a, b);
    const auto known = ba::intersections(of_a, of_b);
    std::size_t open = 0;
    for (const auto& p : found.points) open += p.kind == ba::Intersection_kind::UNDECIDED;
    if (IS_EXACT<TypeParam>) {
      EXPECT_EQ(open, 0U);
    }
    if (open == 0) {
      EXPECT_EQ(found.points.size(), known.points.size());
      EXPECT_EQ(found.overlaps.size(), known.overlaps.size());
    }
    if (const auto verdict = ba::do_intersect(a, b)) EXPECT_EQ(verdict, ba::do_intersect(of_a, of_b));
    else EXPECT_FALSE(IS_EXACT<TypeParam>);
    expect_overlap(ba::distance(a, b)->distance, ba::distance(of_a, of_b)->distance);
    expect_overlap(ba::distance(a, b, 1e-3)->distance, ba::distance(of_a, of_b)->distance);
    expect_overlap(ba::hausdorff_distance(a, b, 1e-2)->distance, ba::hausdorff_distance(of_a, of_b, 1e-3)->distance);
    expect_overlap(ba::length(a, 1e-3), ba::length(of_a, 1e-4));
    expect_overlap(ba::width(a, 1e-3)->width, ba::width(of_a, 1e-4)->width);
    expect_overlap(ba::diameter(a, 1e-3)->diameter, ba::diameter(of_a, 1e-4)->diameter);
    expect_overlap(ba::smallest_enclosing_circle(a, 1e-3)->radius, ba::smallest_enclosing_circle(of_a, 1e-4)->radius);
    EXPECT_EQ(ba::convex_hull(a, 1e-3).pieces.size(), ba::convex_hull(of_a, 1e-3).pieces.size());
    const auto q = point_of<TypeParam>(0.3, -0.7);
    expect_overlap(ba::closest_point(a, q)->distance, ba::closest_point(of_a, {0.3, -0.7})->distance);
    EXPECT_EQ(ba::k_nearest_curves(a, q, 2).size(), ba::k_nearest_curves(of_a, {0.3, -0.7}, 2).size());
    EXPECT_FALSE(ba::closest_points(a, q, 1e-6).empty());
    EXPECT_EQ(ba::ray_hits(a, q, {1, 1}).size(), ba::ray_hits(of_a, {0.3, -0.7}, {1, 1}).size());
  }
}

// Points come back as the kernel's, on the curve.
TYPED_TEST(TreeQueries, AnswerInTheKernelsPoints) {
  const TypeParam tree = tree_of<TypeParam>(drawing_of(segment({0, 0}, {4, 0})));
  const typename TypeParam::Point_2 q = point_of<TypeParam>(1, 2);
  const auto near = ba::closest_point(tree, q);
  EXPECT_EQ(near->point, point_of<TypeParam>(1, 0));
  EXPECT_NEAR(near->distance.upper, 2, 1e-14);
  EXPECT_EQ(ba::closest_point(tree, q, near->place)->point, near->point);
  const std::vector<typename TypeParam::Point_2> points{q, point_of<TypeParam>(9, 0)};
  const auto all = ba::closest_points_of_all(tree, points);
  ASSERT_EQ(all.size(), 2U);
  EXPECT_EQ(all[1].point, point_of<TypeParam>(4, 0));
  EXPECT_FALSE(ba::closest_point(TypeParam(ba::Drawing_2<typename TypeParam::FT>()), q));
}

TYPED_TEST(TreeQueries, KnowTheInside) {
  const TypeParam tree = tree_of<TypeParam>(drawing_of(circle({0, 0}, 1)));
  const ba::Point_location_2 location(tree);
  EXPECT_EQ(location.locate(point_of<TypeParam>(0.5, 0.25)), ba::Point_side::INSIDE);
  EXPECT_EQ(ba::winding_number(tree, point_of<TypeParam>(3, 0)).number, 0);
  const ba::Point_side on = ba::locate(tree, point_of<TypeParam>(1, 0));
  if (IS_EXACT<TypeParam>) EXPECT_EQ(on, ba::Point_side::ON);
  else EXPECT_TRUE(on == ba::Point_side::ON || on == ba::Point_side::UNDECIDED);
  EXPECT_LT(ba::signed_distance(tree, point_of<TypeParam>(0, 0))->distance.upper, 0);
  expect_overlap(ba::area(tree, 1e-9), Bounds{3.14159265, 3.14159266});
  EXPECT_EQ(ba::medial_axis(tree, 1e-4).vertices.size(), 1U);
  const TypeParam open = tree_of<TypeParam>(drawing_of(segment({0, 0}, {4, 0})));
  EXPECT_THROW((void)ba::locate(open, point_of<TypeParam>(0, 0)), std::invalid_argument);
}

// Neither the triangle's corners nor the points are doubles.
TEST(TreeQueries, OverExactKernelsAreOfExactCoordinates) {
  const Exact third = Exact(1) / 3, tiny = Exact(1) / Exact("1000000000000000000000000000000000000000");
  ba::Drawing_2<Exact> drawing;
  using Curve = ba::Bezier_curve_2<Exact>;
  const ba::Xy<Exact> o{Exact(0), Exact(0)}, x{third, Exact(0)}, y{Exact(0), third};
  drawing.add({Curve({o, x}), Curve({x, y}), Curve({y, o})});
  const Exact_tree tree(drawing);
  using Point = Exact_tree::Point_2;
  const Exact a = Exact(1) / 9, b = Exact(2) / 9;
  EXPECT_EQ(ba::locate(tree, Point(a, b)), ba::Point_side::ON);
  EXPECT_EQ(ba::locate(tree, Point(Exact(a - tiny), b)), ba::Point_side::INSIDE);
  EXPECT_EQ(ba::locate(tree, Point(Exact(a + tiny), b)), ba::Point_side::OUTSIDE);
  EXPECT_EQ(ba::locate(tree, Point(a, Exact(b - tiny))), ba::Point_side::INSIDE);
  EXPECT_EQ(ba::locate(tree, Point(third, Exact(0))), ba::Point_side::ON);
  EXPECT_EQ(ba::locate(tree, Point(Exact(third + tiny), Exact(0))), ba::Point_side::OUTSIDE);
  EXPECT_EQ(ba::locate(tree, Point(Exact(-tiny), Exact(third / 2))), ba::Point_side::OUTSIDE);
  EXPECT_EQ(ba::locate(tree, Point(tiny, Exact(third / 2))), ba::Point_side::INSIDE);
  EXPECT_EQ(ba::locate(tree, Point(tiny, Exact(-tiny))), ba::Point_side::OUTSIDE);
  // from a point as far as the corner's rounding from (1, 0)
  const auto near = ba::closest_point(tree, Point(Exact(4) / 3, Exact(0)));
  EXPECT_LE(near->distance.lower, 1);
  EXPECT_GE(near->distance.upper, 1);
  EXPECT_LE(near->distance.upper - near->distance.lower, 1e-14);
}

// A ray touches (t, t^2 + 1/3) where it is on that height, with numbers that are no doubles.
TEST(TreeQueries, RaysOverExactKernelsAreOfExactStartsAndDirections) {
  const Exact third = Exact(1) / 3, tiny = Exact(1) / Exact("1000000000000000000000000000000000000000");
  const Exact_tree tree(ba::Bezier_curve_2<Exact>(
      {{Exact(-1), Exact(1 + third)}, {Exact(0), Exact(third - 1)}, {Exact(1), Exact(1 + third)}}));
  using Point = Exact_tree::Point_2;
  using Vector = Exact_tree::Traits::Kernel::Vector_2;
  EXPECT_EQ(ba::ray_hits(tree, Point(Exact(-2), third), Vector(1, 0)).size(), 1U);
  EXPECT_EQ(ba::ray_hits(tree, Point(Exact(-2), Exact(third - tiny)), Vector(1, 0)).size(), 0U);
  EXPECT_EQ(ba::ray_hits(tree, Point(Exact(-2), Exact(third + tiny)), Vector(1, 0)).size(), 2U);
  // the tangent in t = 1/3, from where it is on the line t = -1
  const Exact slope = 2 * third, height = third + third * third - slope * (1 + third);
  EXPECT_EQ(ba::ray_hits(tree, Point(Exact(-1), height), Vector(Exact(1), slope)).size(), 1U);
  EXPECT_EQ(ba::ray_hits(tree, Point(Exact(-1), height), Vector(Exact(1), Exact(slope - tiny))).size(), 0U);
  EXPECT_EQ(ba::ray_hits(tree, Point(Exact(-1), height), Vector(Exact(1), Exact(slope + tiny))).size(), 2U);
}

// A tree of regions is asked as well as one without an eps, and moved control points are seen.
TEST(TreeQueries, OfTreesWithLeavesAreTheSame) {
  const Bezier wave({{0, 2}, {1, 4}, {2, 0}, {3, 3}}), flat({{0, 0}, {1, 1}, {2, 1}, {3, 0}});
  Filtered_tree stored(wave, 1e-3);
  const Filtered_tree from_spirals(ba::spiral_segments(wave), 1e-3), lazy(wave), of_flat(flat);
  EXPECT_GT(stored.number_of_leaves(), 0U);
  EXPECT_EQ(lazy.number_of_leaves(), 0U);
  EXPECT_EQ(lazy.spirals().size(), stored.spirals().size());
  const Filtered_tree::Point_2 q(1, 1);
  const auto known = ba::closest_point(lazy, q)->distance;
  EXPECT_EQ(ba::closest_point(stored, q)->distance.upper, known.upper);
  EXPECT_EQ(ba::closest_point(from_spirals, q)->distance.upper, known.upper);
  stored.replace(0, stored.spirals().size(), ba::spiral_segments(flat));
  EXPECT_EQ(ba::closest_point(stored, q)->distance.upper, ba::closest_point(of_flat, q)->distance.upper);
}

// A tree keeps its drawing, names and all, and the curves that queries have made of it.
TEST(TreeQueries, AreTheSameAfterAReplacementThatThrows) {
  ba::Drawing_2<double> drawing;
  drawing.add(Bezier({{0, 2}, {1, 4}, {2, 0}, {3, 3}}), "wave");
  drawing.add(Bezier({{5, 0}, {6, 1}}), "line");
  const Filtered_tree::Point_2 q(1, 1);
  Filtered_tree lazy(drawing), stored(drawing, 1e-3);
  for (Filtered_tree* tree : {&lazy, &stored}) {
    const auto* curves = &tree->curves();
    const auto known = ba::closest_point(*tree, q)->distance;
    const std::size_t count = tree->spirals().size();
    EXPECT_THROW(tree->replace(0, count + 1, {}), std::out_of_range);
    EXPECT_THROW(tree->replace(2, 1, ba::spiral_segments(Bezier({{0, 0}, {1, 1}}))), std::out_of_range);
    EXPECT_EQ(&tree->curves(), curves);
    ASSERT_EQ(tree->drawing().curves().size(), 2U);
    EXPECT_EQ(tree->drawing().curves()[0].name, "wave");
    EXPECT_EQ(tree->spirals().size(), count);
    EXPECT_EQ(ba::closest_point(*tree, q)->distance.upper, known.upper);
  }
}

}  // namespace
}  // namespace test_tree_queries
