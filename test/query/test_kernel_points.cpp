// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Points of the kernels that CGAL's users have go in at each door, and the same kernel's come out.

#include <CGAL/Bounding_arcs_2.h>

#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Exact_rational.h>
#include <CGAL/Simple_cartesian.h>

#include <gtest/gtest.h>

#include <cmath>
#include <type_traits>
#include <vector>

namespace test_kernel_points {
namespace {

using namespace CGAL::Bounding_arcs;
template <class Linear>
using Circular = CGAL::Circular_kernel_2<Linear, CGAL::Algebraic_kernel_for_circles_2_2<typename Linear::FT>>;

template <class Kernel> class KernelPoints : public ::testing::Test {};
using Kernels =
    ::testing::Types<CGAL::Epick, CGAL::Epeck, CGAL::Simple_cartesian<double>,
                     CGAL::Simple_cartesian<CGAL::Exact_rational>, Circular<CGAL::Epick>, Circular<CGAL::Epeck>,
                     Circular<CGAL::Simple_cartesian<double>>, Circular<CGAL::Simple_cartesian<CGAL::Exact_rational>>>;
TYPED_TEST_SUITE(KernelPoints, Kernels);

/// A square about the origin of side 4, and a smaller one to the right.
Drawing_2<double> square(double x, double r) {
  Drawing_2<double> drawing;
  const Xy<double> p[] = {{x - r, -r}, {x + r, -r}, {x + r, r}, {x - r, r}};
  std::vector<Bezier_curve_2<double>> sides;
  for (int i = 0; i < 4; ++i) sides.emplace_back(std::vector<Xy<double>>{p[i], p[(i + 1) % 4]});
  drawing.add(std::move(sides));
  return drawing;
}

TYPED_TEST(KernelPoints, GoInAndComeOut) {
  using K = TypeParam;
  using Point = typename K::Point_2;
  const Bounding_arc_tree_2 tree(square(0, 2)), other(square(6, 1));
  const Point q(1, 0);
  const auto at = [](const Point& p) { return Xy<double>{CGAL::to_double(p.x()), CGAL::to_double(p.y())}; };
  const Point nearest = closest_point(tree, q)->point;
  EXPECT_EQ(at(nearest), (Xy<double>{2, 0}));
  EXPECT_EQ(closest_point(tree, q, closest_point(tree, q)->place)->point, nearest);
  EXPECT_EQ(closest_points(tree, q, 1e-3).front().point, nearest);
  EXPECT_EQ(k_nearest_curves(tree, q, 1).front().point, nearest);
  EXPECT_EQ(signed_distance(tree, q)->point, nearest);
  EXPECT_EQ(closest_points_of_all(tree, std::vector<Point>{q}).front().point, nearest);
  EXPECT_EQ(signed_distances_of_all(tree, std::vector<Point>{q}).front().point, nearest);
  EXPECT_EQ(ray_hits(tree, q, typename K::Vector_2(1, 0)).front().point, nearest);
  EXPECT_EQ(locate(tree, q), CGAL::ON_BOUNDED_SIDE);
  EXPECT_EQ(winding_number(tree, q).number, 1);
  EXPECT_EQ(Point_location_2(tree).locate(nearest), CGAL::ON_BOUNDARY);
  const Point a = distance<K>(tree, other)->a.point;
  EXPECT_EQ(at(a).x, 2);
  EXPECT_EQ(at(Point(distance<K>(tree, other, 1e-3)->a.point)).x, 2);
  const Point far = directed_hausdorff_distance<K>(other, tree, 1e-9)->a.point;
  EXPECT_EQ(at(far).x, 7);
  EXPECT_EQ(at(Point(hausdorff_distance<K>(other, tree, 1e-9)->a.point)).x, 5);
  const Point crossing = intersections<K>(tree, Bounding_arc_tree_2(line_drawing(tree, q, typename K::Vector_2(0, 1))))
                             .points.front()
                             .point;
  EXPECT_EQ(at(crossing).x, 1);
  EXPECT_TRUE(self_intersections<K>(tree).points.empty());
  const Point corner = convex_hull<K>(tree, 1e-9).pieces.front().from_point;
  EXPECT_EQ(std::abs(at(corner).x), 2);
  const typename K::Vector_2 along = width<K>(tree, 1e-9)->along;
  EXPECT_NEAR(std::hypot(CGAL::to_double(along.x()), CGAL::to_double(along.y())), 1, 1e-12);
  EXPECT_EQ(std::abs(at(Point(diameter<K>(tree, 1e-9)->first_point)).y), 2);
  const Point center = smallest_enclosing_circle<K>(tree, 1e-9)->center;
  EXPECT_NEAR(at(center).x, 0, 1e-9);
  const Medial_axis_2 axis = medial_axis(tree, 1e-4);
  EXPECT_TRUE(clearance_path(tree, axis, q, Point(0, 1)));
  EXPECT_EQ(ray_drawing(tree, q, typename K::Vector_2(1, 1)).curves().size(), 1U);
  EXPECT_EQ(segment_drawing(q, Point(0, 1)).curves().size(), 1U);
  EXPECT_EQ(circle_drawing(q, 1).curves().size(), 1U);
}

TYPED_TEST(KernelPoints, AreControlPoints) {
  using Point = typename TypeParam::Point_2;
  const std::vector<Point> points{Point(0, 0), Point(1, 2), Point(2, 0)};
  const Bezier_curve_2<double> arch(points), weighted(points, {1, 2, 1});
  EXPECT_EQ(arch.control_points()[1], (Xy<double>{1, 2}));
  EXPECT_EQ(weighted.weights()[1], 2);
  const Point three[] = {points[0], points[1], points[2]};
  EXPECT_EQ(Bezier_curve_2<CGAL::Exact_rational>(three).control_points()[2].x, 2);
  EXPECT_EQ(closest_points_of_all(Bounding_arc_tree_2(arch), three).size(), 3U);
  const B_spline_curve_2<double> spline(2, points, {0, 0, 0, 1, 1, 1});
  EXPECT_EQ(spline.bezier_pieces().front().control_points()[1], (Xy<double>{1, 2}));
  EXPECT_EQ(B_spline_curve_2<double>::periodic(2, points).control_points()[1], (Xy<double>{1, 2}));
  EXPECT_EQ(B_spline_curve_2<double>::uniform(2, points).control_points()[1], (Xy<double>{1, 2}));
}

// Coordinates that no double has decide.
TYPED_TEST(KernelPoints, AreTakenAsTheyAre) {
  using FT = typename TypeParam::FT;
  if constexpr (!std::is_floating_point_v<FT>) {
    const Bounding_arc_tree_2 tree(square(0, 2));
    const FT tiny = FT(1) / FT(CGAL::Exact_rational("1000000000000000000000000000000")), two(2);
    EXPECT_EQ(locate(tree, typename TypeParam::Point_2(FT(two - tiny), FT(0))), CGAL::ON_BOUNDED_SIDE);
    EXPECT_EQ(locate(tree, typename TypeParam::Point_2(FT(two + tiny), FT(0))), CGAL::ON_UNBOUNDED_SIDE);
    EXPECT_EQ(ray_hits(tree, typename TypeParam::Point_2(FT(0), FT(two + tiny)), {1, 0}).size(), 0U);
    EXPECT_EQ(ray_hits(tree, typename TypeParam::Point_2(FT(0), FT(two - tiny)), {1, 0}).size(), 1U);
  }
}

TEST(KernelPoints, AreOfTheDefaultKernelWhereNoneIsNamed) {
  const Bounding_arc_tree_2 tree(square(0, 2));
  const auto found = closest_point(tree, {1, 0});
  static_assert(std::is_same_v<decltype(found->point), CGAL::Epick::Point_2>);
  EXPECT_EQ(found->point, CGAL::Epick::Point_2(2, 0));
  static_assert(std::is_same_v<decltype(distance(tree, tree)->a.point), CGAL::Epick::Point_2>);
  EXPECT_EQ(ray_hits(tree, {0, 1}, {1, 0}).size(), 1U);
  EXPECT_EQ(k_nearest_curves(tree, {1, 0}, 3).size(), 1U);
}

}  // namespace
}  // namespace test_kernel_points
