// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// What is taken from CGAL: control points, arcs of the circular kernel, polygons; arcs and conics as rational
// quadratics.

#include <CGAL/Root_of_traits.h>

#include <CGAL/Bounding_arcs_2/arc/arc_beziers.h>
#include <CGAL/Bounding_arcs_2/exchange/add_to_drawing.h>
#include <CGAL/Bounding_arcs_2/exchange/conic_beziers.h>
#include <CGAL/Bounding_arcs_2/exchange/general_polygon.h>

#include <CGAL/Algebraic_kernel_for_circles_2_2.h>
#include <CGAL/CORE_Expr.h>
#include <CGAL/Circular_kernel_2.h>
#include <CGAL/Exact_rational.h>
#include <CGAL/Polygon_with_holes_2.h>
#include <CGAL/Simple_cartesian.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <stdexcept>
#include <vector>

namespace test_exchange_in {
namespace {

using namespace CGAL::Bounding_arcs;
using FT = CGAL::Exact_rational;
using Linear_kernel = CGAL::Simple_cartesian<FT>;
using Kernel = CGAL::Circular_kernel_2<Linear_kernel, CGAL::Algebraic_kernel_for_circles_2_2<FT>>;

TEST(ArcBeziers, AreExactlyOnTheCircle) {
  const Xy<FT> from{FT(1) / FT(3), FT(2)}, to{FT(5), FT(-1) / FT(7)};
  for (const double size : {1e-9, 0.1, 0.4, 0.42, 0.75, 1.0})
    for (const FT& bulge : {FT(size), FT(-size)}) {
      const auto curves = arc_beziers<FT>(from, to, bulge);
      EXPECT_EQ(curves.size(), size > 0.415 ? 2U : 1U);
      EXPECT_EQ(curves.front().control_points().front(), from);
      EXPECT_EQ(curves.back().control_points().back(), to);
      const Xy<FT> chord = to - from;
      const Xy<FT> center =
          from + FT(FT(1) / FT(2)) * chord + FT((FT(1) - bulge * bulge) / (FT(4) * bulge)) * perp(chord);
      const FT square = dot(from - center, from - center);
      for (const auto& curve : curves)
        for (const FT& t : {FT(FT(1) / FT(3)), FT(FT(1) / FT(2)), FT(1)}) {
          const Xy<FT> p = curve.point(t);
          EXPECT_EQ(FT(dot(p - center, p - center)), square) << bulge;
          if (p != to) {
            EXPECT_EQ(CGAL::sign(cross(chord, p - from)), -CGAL::sign(bulge));
          }
        }
      if (curves.size() == 2) {
        EXPECT_EQ(curves[0].control_points().back(), curves[1].control_points().front());
      }
    }
  EXPECT_EQ(arc_beziers<FT>(from, to, FT(0)).front().degree(), 1);
}

TEST(CurvesOfPoints, TakeKernelPointsAndKeepTheirNumbers) {
  const std::vector<Linear_kernel::Point_2> points{{FT(1) / FT(3), FT(0)}, {FT(1), FT(2)}, {FT(4), FT(5), FT(3)}};
  const auto exact = Bezier_curve_2<FT>(points, {FT(1), FT(2), FT(1)});
  EXPECT_EQ(exact.control_points()[0].x, FT(FT(1) / FT(3)));
  EXPECT_EQ(exact.weight(1), FT(2));
  EXPECT_DOUBLE_EQ(Bezier_curve_2<double>(points).control_points()[0].x, 1.0 / 3);
  const auto spline = B_spline_curve_2<double>(2, points, {0, 0, 0, 1, 1, 1});
  EXPECT_DOUBLE_EQ(spline.bezier_pieces().front().control_points()[2].y, 5.0 / 3);
  EXPECT_THROW((void)Bezier_curve_2<double>(std::vector<Linear_kernel::Point_2>()), std::invalid_argument);
}

// Has the members of an x-monotone curve of Arr_circle_segment_traits_2.
class Part_of_circle {
 public:
  using Kernel = CGAL::Simple_cartesian<double>;
  Part_of_circle(const Xy<double>& from, const Xy<double>& to, const Xy<double>& center, double squared_radius,
                 bool ccw)
      : from_(from.x, from.y), to_(to.x, to.y), circle_({center.x, center.y}, squared_radius),
        orientation_(ccw ? CGAL::COUNTERCLOCKWISE : CGAL::CLOCKWISE) {}
  [[nodiscard]] const Kernel::Point_2& source() const { return from_; }
  [[nodiscard]] const Kernel::Point_2& target() const { return to_; }
  [[nodiscard]] const Kernel::Circle_2& supporting_circle() const { return circle_; }
  [[nodiscard]] CGAL::Orientation orientation() const { return orientation_; }

 private:
  Kernel::Point_2 from_, to_;
  Kernel::Circle_2 circle_;
  CGAL::Orientation orientation_;
};

TEST(ArcsOfKernel, RunAsTheKernelsDo) {
  const Kernel::Circle_2 circle(Kernel::Point_2(FT(1), FT(2)), FT(25));
  const auto at = [](int x, int y) { return Kernel::Circular_arc_point_2(Kernel::Point_2(FT(x), FT(y))); };
  const auto quarter = arcs_of(Kernel::Circular_arc_2(circle, at(6, 2), at(1, 7)));
  ASSERT_EQ(quarter.size(), 1U);
  EXPECT_NEAR(quarter[0].bulge, std::tan(std::atan(1.0) / 2), 1e-15);
  const auto most = arcs_of(Kernel::Circular_arc_2(circle, at(1, 7), at(6, 2)));
  ASSERT_EQ(most.size(), 2U);
  EXPECT_NEAR(most[0].to.x, 1 - 5 * std::sqrt(0.5), 1e-14);
  EXPECT_NEAR(most[0].to.y, 2 - 5 * std::sqrt(0.5), 1e-14);
  EXPECT_NEAR(length(most[0]) + length(most[1]), 7.5 * 3.14159265358979324, 1e-13);
  const auto whole = arcs_of(Kernel::Circular_arc_2(circle));
  ASSERT_EQ(whole.size(), 2U);
  EXPECT_NEAR(length(whole[0]) + length(whole[1]), 10 * 3.14159265358979324, 1e-13);
  const auto line = arcs_of(Kernel::Line_arc_2(Kernel::Point_2(FT(0), FT(1)), Kernel::Point_2(FT(2), FT(3))));
  EXPECT_EQ(line.front().to.y, 3);
  // flat arcs keep the digits of their bulge
  for (const Arc_2& arc : {Arc_2{{0, 0}, {1, 2}, 1e-7}, Arc_2{{0, 0}, {1, 2}, -0.3}, Arc_2{{3, 0}, {1, 2}, -1}}) {
    const Xy<double> chord = arc.to - arc.from, across = perp(chord);
    const double b = arc.bulge, rise = (1 - b * b) / (4 * b);
    const Xy<double> center = arc.from + 0.5 * chord + rise * across;
    const double radius = std::sqrt(dot(chord, chord)) * (1 + b * b) / (4 * std::fabs(b));
    const auto again = arcs_of(Part_of_circle(arc.from, arc.to, center, radius * radius, b > 0));
    ASSERT_EQ(again.size(), 1U);
    EXPECT_NEAR(again[0].bulge, b, 1e-14 * std::fabs(b));
  }
}

TEST(ArcsOfKernel, AreTwoBeyondHalfACircleEitherWay) {
  const Xy<double> center{1, 2}, from{6, 2}, to{1, 7};
  for (const bool is_ccw : {true, false}) {
    const Xy<double>&first = is_ccw ? to : from, &last = is_ccw ? from : to;  // three quarters
    const auto arcs = arcs_of(Part_of_circle(first, last, center, 25, is_ccw));
    ASSERT_EQ(arcs.size(), 2U);
    EXPECT_EQ(arcs[0].from, first);
    EXPECT_EQ(arcs[0].to, arcs[1].from);
    EXPECT_EQ(arcs[1].to, last);
    for (const Arc_2& arc : arcs) EXPECT_NEAR(arc.bulge, (is_ccw ? 1 : -1) * std::tan(3 * std::atan(1.0) / 4), 1e-15);
    EXPECT_NEAR(arcs[0].to.x, 1 - 5 * std::sqrt(0.5), 1e-14);
    EXPECT_NEAR(arcs[0].to.y, 2 - 5 * std::sqrt(0.5), 1e-14);
  }
}

TEST(AddToDrawing, ClosesPolygonsOfSegmentsAndArcs) {
  Drawing_2<double> drawing;
  CGAL::Polygon_2<Linear_kernel> triangle;
  for (const auto& p : {std::pair(0, 0), std::pair(3, 0), std::pair(0, 4)})
    triangle.push_back(Linear_kernel::Point_2(FT(p.first), FT(p.second)));
  add_to_drawing(drawing, triangle, "triangle");
  const std::vector<Arc_2> arcs{{{0, 0}, {2, 0}, 0.3}, {{2, 0}, {2, 3}, -0.2}, {{2, 3}, {0, 0}, 1}};
  const auto polygon = general_polygon(arcs);
  add_to_drawing(drawing, polygon, "arcs");
  add_to_drawing(drawing, Arc_polygon_with_holes_2<>(polygon), "again");
  ASSERT_EQ(drawing.curves().size(), 3U);
  EXPECT_EQ(drawing.curves()[0].beziers.size(), 3U);
  EXPECT_EQ(drawing.curves()[0].name, "triangle");
  for (const auto& curve : drawing.curves()) EXPECT_TRUE(curve.is_closed);
  // every point of the curve is on one of the arcs it was made of
  for (const auto& bezier : drawing.curves()[1].beziers)
    for (const double t : {0.0, 0.3, 0.8}) {
      double nearest = 1;
      for (const Arc_2& arc : arcs) nearest = (std::min)(nearest, std::fabs(signed_distance(bezier.point(t), arc)));
      EXPECT_LE(nearest, 1e-14);
    }
  const CGAL::Polygon_with_holes_2<Linear_kernel> frame(triangle, &triangle, &triangle + 1);
  add_to_drawing(drawing, frame, "frame");
  ASSERT_EQ(drawing.curves().size(), 5U);
  EXPECT_EQ(drawing.curves()[4].beziers.size(), 3U);
  EXPECT_EQ(drawing.curves()[4].name, "frame");
  EXPECT_THROW(add_to_drawing(drawing, CGAL::Polygon_2<Linear_kernel>(), "none"), std::invalid_argument);
  // a boundary that is nothing leaves no other one behind
  const std::size_t count = drawing.curves().size();
  const CGAL::Polygon_2<Linear_kernel> none;
  const CGAL::Polygon_with_holes_2<Linear_kernel> broken(triangle, &none, &none + 1);
  EXPECT_THROW(add_to_drawing(drawing, broken, "broken"), std::invalid_argument);
  EXPECT_EQ(drawing.curves().size(), count);
}

using Expr = CORE::Expr;
using Conic = Conic_equation<Expr>;

// How far the curves are from the conic at most, to first order.
double distance_from(const Conic& conic, const std::vector<Bezier_curve_2<double>>& curves) {
  double most = 0;
  for (const auto& curve : curves)
    for (const double t : {0.0, 0.1, 0.35, 0.5, 0.8, 1.0}) {
      const Xy<Expr> p{Expr(curve.point(t).x), Expr(curve.point(t).y)}, g = conic.gradient(p);
      most = std::max(most, std::fabs(CGAL::to_double(Expr(conic.form(p, p) / (Expr(2) * sqrt(Expr(dot(g, g))))))));
    }
  return most;
}
double turn_of(const std::vector<Bezier_curve_2<double>>& curves) {
  double sum = 0;
  for (const auto& curve : curves) {
    const auto& p = curve.control_points();
    sum += std::atan2(cross(p[1] - p[0], p[2] - p[1]), dot(p[1] - p[0], p[2] - p[1]));
  }
  return sum;
}

TEST(ConicBeziers, AreOnTheConicFromEndToEndTheRightWay) {
  const double pi = 3.14159265358979324;
  const auto at = [](double x, double y) { return Xy<Expr>{Expr(x), Expr(y)}; };
  const Conic ellipse{1, 4, 0, 0, 0, -4}, turned{-1, -4, -1, -3, 0, 16}, hyperbola{0, 0, 1, 0, 0, -1},
      parabola{1, 0, 0, 0, -1, 0};
  const Expr edge = (sqrt(Expr(73)) - 3) / 2;
  const struct {
    const Conic& conic;
    Xy<Expr> from, to;
    bool ccw;
    std::size_t pieces;
    double turn;
  } cases[] = {
      {ellipse, at(2, 0), at(0, 1), true, 1, pi / 2},
      {ellipse, at(2, 0), at(0, 1), false, 3, -1.5 * pi},
      {ellipse, at(2, 0), {Expr(-6) / 5, Expr(4) / 5}, true, 2, std::atan2(6.4, -2.4)},
      {ellipse, at(2, 0), at(-2, 0), true, 2, pi},
      {ellipse, at(0, 1), at(0, 1), false, 4, -2 * pi},
      {ellipse, {Expr(6) / 5, Expr(-4) / 5}, {Expr(6) / 5, Expr(4) / 5}, true, 1, 2 * std::atan2(6.4, 2.4)},
      {turned, {edge, Expr(0)}, {edge, Expr(0)}, true, 4, 2 * pi},
      {hyperbola, at(0.5, 2), at(2, 0.5), true, 1, std::atan(4) - std::atan(0.25)},
      {hyperbola, at(-2, -0.5), at(-0.5, -2), false, 1, std::atan(0.25) - std::atan(4)},
      {parabola, at(-1, 1), at(2, 4), true, 1, std::atan(2) + std::atan(4)},
      {parabola, at(2, 4), at(-1, 1), false, 1, -std::atan(2) - std::atan(4)},
  };
  for (const auto& c : cases) {
    const auto curves = conic_beziers(c.conic, c.from, c.to, c.ccw);
    SCOPED_TRACE(c.turn);
    EXPECT_EQ(curves.size(), c.pieces);
    EXPECT_EQ(curves.front().control_points().front(), (convert<double>(c.from)));
    EXPECT_EQ(curves.back().control_points().back(), (convert<double>(c.to)));
    for (std::size_t i = 0; i + 1 < curves.size(); ++i)
      EXPECT_EQ(curves[i].control_points().back(), curves[i + 1].control_points().front());
    EXPECT_NEAR(turn_of(curves), c.turn, 1e-14);
    EXPECT_LE(distance_from(c.conic, curves), 10 * 7 * 0x1p-53);  // coordinates are at most 7; 4 u, and 6 of evaluation
  }
  EXPECT_THROW((void)conic_beziers(hyperbola, at(0.5, 2), at(-2, -0.5), true), std::invalid_argument);
  EXPECT_THROW((void)conic_beziers(hyperbola, at(0.5, 2), at(2, 0.5), false), std::invalid_argument);
  EXPECT_THROW((void)conic_beziers(Conic{1, 4, 0, 0, 0, 4}, at(2, 0), at(2, 0), true), std::invalid_argument);
  EXPECT_THROW((void)conic_beziers(ellipse, at(0, 0), at(0, 0), true), std::invalid_argument);
  EXPECT_THROW((void)conic_beziers(Conic{0, 0, 1, 0, 0, 0}, at(1, 0), at(0, 1), true), std::invalid_argument);
}

// What is asked of Arr_conic_traits_2's curves, which take long to compile: CGAL's coefficients are integers.
struct Conic_arc {
  CGAL::Orientation turn;
  bool is_full;
  [[nodiscard]] int r() const { return 1; }
  [[nodiscard]] int s() const { return 4; }
  [[nodiscard]] int t() const { return 0; }
  [[nodiscard]] int u() const { return 0; }
  [[nodiscard]] int v() const { return 0; }
  [[nodiscard]] int w() const { return -4; }
  [[nodiscard]] CGAL::Orientation orientation() const { return turn; }
  [[nodiscard]] bool is_full_conic() const { return is_full; }
  [[nodiscard]] CGAL::Simple_cartesian<Expr>::Point_2 source() const { return end(2, 0); }
  [[nodiscard]] CGAL::Simple_cartesian<Expr>::Point_2 target() const { return end(0, 1); }

 private:
  [[nodiscard]] CGAL::Simple_cartesian<Expr>::Point_2 end(int x, int y) const {
    if (is_full) throw std::logic_error("whole conics have no ends");
    return {Expr(x), Expr(y)};
  }
};

TEST(ConicBeziers, TakeArcsSegmentsAndWholeEllipses) {
  const double pi = 3.14159265358979324;
  EXPECT_NEAR(turn_of(conic_beziers(Conic_arc{CGAL::COUNTERCLOCKWISE, false})), pi / 2, 1e-14);
  EXPECT_NEAR(turn_of(conic_beziers(Conic_arc{CGAL::CLOCKWISE, false})), -1.5 * pi, 1e-14);
  EXPECT_NEAR(turn_of(conic_beziers(Conic_arc{CGAL::CLOCKWISE, true})), -2 * pi, 1e-14);
  const auto segment = conic_beziers(Conic_arc{CGAL::COLLINEAR, false});
  ASSERT_EQ(segment.size(), 1U);
  EXPECT_EQ(segment[0].control_points(), (std::vector<Xy<double>>{{2, 0}, {0, 1}}));
}

}  // namespace
}  // namespace test_exchange_in
