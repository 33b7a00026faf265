// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Queries by a tree: points of a kernel go in and come out, and the tree says how what doubles leave open is answered.

#include "../../src/library/tree/Segment_hierarchy.h"
#include "cases.h"
#include "hard_cases.h"
#include "kernel_trees.h"
#include "query_drawings.h"

#include <CGAL/Bounding_arcs_2.h>
#include <CGAL/Bounding_arcs_2/curve/Drawing_2.h>
#include <CGAL/Bounding_arcs_2/medial_axis/medial_axis.h>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Exact_rational.h>
#include <CGAL/Simple_cartesian.h>

#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>
#include <memory>
#include <random>
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
template <class Tree> Tree tree_of(const Drawing& drawing) { return Tree(drawing.over<typename Tree::FT>()); }
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

// What segments are, bit for bit.
void expect_same_segments(const ba::Segment_hierarchy& a, const ba::Segment_hierarchy& b) {
  ASSERT_EQ(a.number_of_segments(), b.number_of_segments());
  ASSERT_EQ(a.number_of_beziers(), b.number_of_beziers());
  EXPECT_EQ(a.hidden_tips(), b.hidden_tips());
  for (std::uint32_t i = 0; i < a.number_of_segments(); ++i) {
    EXPECT_EQ(a.bezier_of(i), b.bezier_of(i));
    EXPECT_EQ(a.piece(i).segment, i);
    for (const auto end : {&ba::Spiral_piece_2::first, &ba::Spiral_piece_2::last}) {
      EXPECT_EQ((a.piece(i).*end).t, (b.piece(i).*end).t);
      EXPECT_EQ((a.piece(i).*end).point, (b.piece(i).*end).point);
    }
    EXPECT_EQ(a.place(i).curve, b.place(i).curve);
    EXPECT_EQ(a.place(i).bezier, b.place(i).bezier);
    EXPECT_EQ(a.region(i).radius, b.region(i).radius);
    EXPECT_EQ(a.error(i), b.error(i));
    EXPECT_EQ(a.is_straight(i), b.is_straight(i));
  }
  for (std::uint32_t i = 0; i < a.number_of_beziers(); ++i) {
    EXPECT_EQ(a.bezier(i).control_points(), b.bezier(i).control_points());
    EXPECT_EQ(a.rounding(i), b.rounding(i));
    EXPECT_EQ(a.curve_of_bezier(i), b.curve_of_bezier(i));
    EXPECT_EQ(a.is_point(i), b.is_point(i));
  }
}
void expect_same_segments(const ba::Bounding_arc_tree_2& tree, const ba::Bounding_arc_tree_2& other) {
  expect_same_segments(tree.in_unit(), other.in_unit());
}
// Control points an ulp from an end: what doubles tell of the direction there is another one.
const Bezier WITH_HIDDEN_TIP({{1, 1}, {1 + 0x1p-52, 1}, {3, 4}, {5, 1}});

// Trees as one forest are what the tree of all their curves is.
TEST(TreeQueries, AreNumberedThroughInAForest) {
  std::mt19937 random(9);
  for (int i = 0; i < cases(40); ++i) {
    Drawing all;
    std::vector<std::shared_ptr<const ba::Segment_hierarchy>> members;
    for (int k = 0; k < 3; ++k) {
      Drawing drawing = random_drawing(random);
      if (random() % 2 == 0) drawing.add(WITH_HIDDEN_TIP);
      if (random() % 4 == 0) drawing.add(Bezier({{2, 2}, {2, 2}}));
      if (random() % 8 == 0) drawing = Drawing();
      all.add(drawing);
      members.push_back(ba::Bounding_arc_tree_2(drawing).in_unit({}));
    }
    const ba::Segment_hierarchy forest(members);
    SCOPED_TRACE(i);
    expect_same_segments(forest, ba::Bounding_arc_tree_2(all).in_unit());
    EXPECT_EQ(forest.drawing().curves().size(), all.curves().size());
    if (HasFailure()) return;
  }
}

// The chain with each control point moved by a part of 1e-3.
std::vector<Bezier> nudged(const std::vector<Bezier>& chain, std::mt19937& random) {
  std::uniform_real_distribution<double> part(-1e-3, 1e-3);
  std::vector<Bezier> result;
  for (const Bezier& piece : chain) {
    std::vector<Point> points = piece.control_points();
    for (std::size_t k = 0; k < points.size(); ++k) {
      if (k == 0 && !result.empty()) points[k] = result.back().control_points().back();
      else points[k] = points[k] + Point{part(random), part(random)};
    }
    result.emplace_back(points, piece.weights());
  }
  return result;
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
  EXPECT_EQ(location.locate(point_of<TypeParam>(0.5, 0.25)), CGAL::ON_BOUNDED_SIDE);
  EXPECT_EQ(ba::winding_number(tree, point_of<TypeParam>(3, 0)).number, 0);
  const CGAL::Uncertain<CGAL::Bounded_side> on = ba::locate(tree, point_of<TypeParam>(1, 0));
  if (IS_EXACT<TypeParam>) EXPECT_EQ(on, CGAL::ON_BOUNDARY);
  else EXPECT_TRUE(!is_certain(on) || on == CGAL::ON_BOUNDARY);
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
  EXPECT_EQ(ba::locate(tree, Point(a, b)), CGAL::ON_BOUNDARY);
  EXPECT_EQ(ba::locate(tree, Point(Exact(a - tiny), b)), CGAL::ON_BOUNDED_SIDE);
  EXPECT_EQ(ba::locate(tree, Point(Exact(a + tiny), b)), CGAL::ON_UNBOUNDED_SIDE);
  EXPECT_EQ(ba::locate(tree, Point(a, Exact(b - tiny))), CGAL::ON_BOUNDED_SIDE);
  EXPECT_EQ(ba::locate(tree, Point(third, Exact(0))), CGAL::ON_BOUNDARY);
  EXPECT_EQ(ba::locate(tree, Point(Exact(third + tiny), Exact(0))), CGAL::ON_UNBOUNDED_SIDE);
  EXPECT_EQ(ba::locate(tree, Point(Exact(-tiny), Exact(third / 2))), CGAL::ON_UNBOUNDED_SIDE);
  EXPECT_EQ(ba::locate(tree, Point(tiny, Exact(third / 2))), CGAL::ON_BOUNDED_SIDE);
  EXPECT_EQ(ba::locate(tree, Point(tiny, Exact(-tiny))), CGAL::ON_UNBOUNDED_SIDE);
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
  using Vector = Exact_tree::Kernel::Vector_2;
  EXPECT_EQ(ba::ray_hits(tree, Point(Exact(-2), third), Vector(1, 0)).size(), 1U);
  EXPECT_EQ(ba::ray_hits(tree, Point(Exact(-2), Exact(third - tiny)), Vector(1, 0)).size(), 0U);
  EXPECT_EQ(ba::ray_hits(tree, Point(Exact(-2), Exact(third + tiny)), Vector(1, 0)).size(), 2U);
  // the tangent in t = 1/3, from where it is on the line t = -1
  const Exact slope = 2 * third, height = third + third * third - slope * (1 + third);
  EXPECT_EQ(ba::ray_hits(tree, Point(Exact(-1), height), Vector(Exact(1), slope)).size(), 1U);
  EXPECT_EQ(ba::ray_hits(tree, Point(Exact(-1), height), Vector(Exact(1), Exact(slope - tiny))).size(), 0U);
  EXPECT_EQ(ba::ray_hits(tree, Point(Exact(-1), height), Vector(Exact(1), Exact(slope + tiny))).size(), 2U);
}

// A tree whose curves were replaced answers as a new one does, and its copy as before.
TEST(TreeQueries, SeeCurvesThatWereReplaced) {
  std::mt19937 random(64);
  for (int i = 0; i < cases(200); ++i) {
    SCOPED_TRACE(i);
    Drawing drawing = random_drawing(random), all = drawing;
    for (const auto& curve : random_drawing(random).curves()) all.add(curve.beziers);
    if (i % 4 == 0) all.add(WITH_HIDDEN_TIP);
    Filtered_tree tree(all);
    for (int time = 0; time < 4; ++time) {
      const Filtered_tree before = tree;
      const auto known = ba::closest_point(before, {0.3, -0.7})->distance.upper;
      const std::size_t count = all.curves().size(), first = random() % count,
                        last = first + random() % (count - first + 1);
      // as many curves, one that is moved a little, or any others
      Drawing others = random_drawing(random);
      if (time % 2 == 1 && last > first) {
        others = Drawing();
        for (std::size_t k = first; k < last; ++k) others.add(nudged(all.curves()[k].beziers, random));
      }
      all.replace(first, last, others);
      tree.replace(first, last, others);
      const Filtered_tree made(all);
      EXPECT_TRUE(tree.is_valid());
      expect_same_segments(tree, made);
      EXPECT_EQ(ba::closest_point(before, {0.3, -0.7})->distance.upper, known);
      EXPECT_EQ(ba::closest_point(tree, {0.3, -0.7})->distance.upper,
                ba::closest_point(made, {0.3, -0.7})->distance.upper);
      EXPECT_EQ(ba::self_intersections(tree).points.size(), ba::self_intersections(made).points.size());
      EXPECT_EQ(ba::length(tree, 1e-6).lower, ba::length(made, 1e-6).lower);
    }
  }
}

// Whatever is wrong with the others, the tree keeps its drawing, names and all, and answers as before.
TEST(TreeQueries, AreTheSameAfterAReplacementThatThrows) {
  Drawing drawing;
  drawing.add(Bezier({{0, 2}, {1, 4}, {2, 0}, {3, 3}}), "wave");
  drawing.add(Bezier({{5, 0}, {6, 1}}), "line");
  Filtered_tree tree(drawing);
  const auto known = ba::closest_point(tree, {1, 1})->distance.upper;
  const Drawing other = drawing_of(segment({0, 0}, {1, 1})), without_number = drawing_of(segment({0, 0}, {1, NAN}));
  EXPECT_THROW(tree.replace(0, 3, other), std::out_of_range);
  EXPECT_THROW(tree.replace(2, 1, other), std::out_of_range);
  EXPECT_THROW(tree.replace(0, 1, without_number), std::invalid_argument);
  ASSERT_EQ(tree.drawing().curves().size(), 2U);
  EXPECT_EQ(tree.drawing().curves()[0].name, "wave");
  EXPECT_TRUE(tree.is_valid());
  EXPECT_EQ(ba::closest_point(tree, {1, 1})->distance.upper, known);
}

// Regions follow the tree that they are of.
TEST(TreeQueries, HaveRegionsThatFollow) {
  Drawing drawing;
  for (int i = 0; i < 5; ++i) drawing.add(Bezier({{2.0 * i, 2}, {1, 4}, {2, i * 1.0}, {3, 3}}));
  Filtered_tree tree(drawing);
  ba::Region_hierarchy_2<> regions(tree, 1e-4);
  const Drawing other = drawing_of(Bezier({{0, 0}, {4, 1}, {-2, 1}, {3, 0}}));
  tree.replace(2, 3, other);
  regions.follow(tree, 2, 3);
  const ba::Region_hierarchy_2<> made(tree, 1e-4);
  EXPECT_TRUE(regions.is_valid());
  ASSERT_EQ(regions.number_of_leaves(), made.number_of_leaves());
  std::vector<double> ends, expected;
  regions.for_each_leaf([&](const ba::Node_handle& h) { ends.push_back(regions.node(h).t1); });
  made.for_each_leaf([&](const ba::Node_handle& h) { expected.push_back(made.node(h).t1); });
  EXPECT_EQ(ends, expected);
  const Filtered_tree one(other);
  EXPECT_THROW(regions.follow(one, 0, 1), std::invalid_argument);
  EXPECT_THROW(regions.follow(tree, 2, 6), std::out_of_range);
  EXPECT_THROW(regions.follow(tree, 3, 2), std::out_of_range);
  EXPECT_EQ(regions.number_of_leaves(), made.number_of_leaves());
}

TEST(TreeQueries, OfNoCurvesHaveNoBoxAndNoInsets) {
  const Filtered_tree tree{Drawing()};
  EXPECT_EQ(tree.box(), CGAL::Bbox_2());
  EXPECT_TRUE(ba::insets(tree, 0.1, 1e-3).empty());
  EXPECT_TRUE(tree.is_valid());
}

// Extreme weights make cuts that are coarser than coordinates: regions are those of the curve by itself.
TEST(TreeQueries, HaveRegionsBetweenCoarseCuts) {
  const Bezier coarse({{0, 0}, {1, 2}, {3, -1}, {4, 0}}, {1, 0x1p20, 0x1p-20, 1}),
      plain({{0, 5}, {1, 7}, {3, 4}, {4, 5}});
  Drawing drawing = drawing_of(plain);
  for (int i = 0; i < 3; ++i) drawing.add(coarse);
  const Filtered_tree tree(drawing);
  const auto ours = ba::spiral_segments(tree), known = ba::spiral_segments(drawing);
  ASSERT_EQ(ours.size(), known.size());
  EXPECT_GT(tree.in_unit().number_of_segments(), known.size());
  for (std::size_t i = 0; i < known.size(); ++i) {
    EXPECT_EQ(ours[i].first(), known[i].first());
    EXPECT_EQ(ours[i].last(), known[i].last());
    EXPECT_EQ(ours[i].place().last, known[i].place().last);
  }
}

}  // namespace
}  // namespace test_tree_queries
