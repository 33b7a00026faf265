// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Bounded_side_2 of the traits: points on every piece of a boundary, constructed exactly, and points a little to either
// side of them, for left and right turns with the tight end first and last.

#include <CGAL/Bounding_arcs_2/region/Bca_traits_2.h>
#include <CGAL/Bounding_arcs_2/region/Bilens_traits_2.h>
#include <CGAL/Bounding_arcs_2/region/Spiral_fat_arc_traits_2.h>
#include <CGAL/Bounding_arcs_2/spiral/Bezier_spiral_2.h>

#include <CGAL/Algebraic_kernel_for_circles_2_2.h>
#include <CGAL/CORE_Expr.h>
#include <CGAL/Circular_kernel_2.h>
#include <CGAL/Exact_rational.h>
#include <CGAL/Simple_cartesian.h>

#include <gtest/gtest.h>

#include <string>
#include <vector>

namespace test_bounded_side {
namespace {

using namespace CGAL::Bounding_arcs;
using Exact = CGAL::Exact_rational;
template <class NT>
using Kernel = CGAL::Circular_kernel_2<CGAL::Simple_cartesian<NT>, CGAL::Algebraic_kernel_for_circles_2_2<NT>>;

/// A curve that turns one way with one end tighter: from (t, t^2), so that all four cases have the same place in turn.
struct Case {
  std::string name;
  bool is_mirrored, is_reversed;
};
const std::vector<Case> CASES = {{"left, tight first", false, false},
                                 {"right, tight first", true, false},
                                 {"right, tight last", false, true},
                                 {"left, tight last", true, true}};

Bezier_curve_2<double> curve_of(const Case& c) {
  const double sign = c.is_mirrored ? -1 : 1;
  const Bezier_curve_2<double> curve({{0, 0}, {0.5, 0}, {1, sign}});
  return c.is_reversed ? curve.reversed() : curve;
}
Bezier_spiral_2<double> spiral_of(const Case& c) { return spiral_segments(curve_of(c)).front(); }

template <class NT> Xy<NT> converted(const Xy<double>& p) { return {NT(p.x), NT(p.y)}; }

// A point of a piece that is no end of it: the second intersection of its circle with a line through a contact point
// whose direction is between tangent and chord, without a root.
template <class NT> Xy<NT> point_on(const Boundary_piece_2<NT>& piece) {
  if (piece.is_segment()) return NT(NT(1) / NT(4)) * (NT(3) * piece.from + piece.to);
  const bool at_start = piece.support.point == piece.from;
  const Xy<NT> chord = piece.to - piece.from, tangent = -perp(piece.support.normal);
  const Xy<NT> along = NT(NT(1) / dot(tangent, tangent)) * tangent + NT(NT(1) / dot(chord, chord)) * chord;
  const Xy<NT> direction = at_start ? along : -along;
  const NT scale = NT(2) * dot(piece.support.normal, direction) / (piece.support.curvature * dot(direction, direction));
  return piece.support.point + scale * direction;
}

// Places of points, asked of the traits.
template <class Traits> class Asked {
 public:
  using NT = typename Traits::FT;

  explicit Asked(const Case& c)
      : curve_(curve_of(c)),
        region_(traits_.construct_bounding_region_2_object()(spiral_of(c).template frame<NT>(0, 1, {true, false}))) {}

  [[nodiscard]] CGAL::Bounded_side operator()(const Xy<NT>& q) const {
    return traits_.bounded_side_2_object()(region_, typename Traits::Kernel::Point_2(q.x, q.y));
  }
  [[nodiscard]] Region_boundary_2<NT> boundary() const { return traits_.construct_region_boundary_2_object()(region_); }
  [[nodiscard]] int turn() const { return region_.frame.shape.turn; }
  [[nodiscard]] Xy<NT> curve_point(double t) const {
    std::vector<Xy<NT>> points;
    for (const Xy<double>& p : curve_.control_points()) points.push_back(converted<NT>(p));
    return Bezier_curve_2<NT>(points).point(NT(t));
  }

 private:
  Traits traits_;
  Bezier_curve_2<double> curve_;
  typename Traits::Bounding_region_2 region_;
};

// Points a little off a piece: behind the outer boundary, seen along it, is the side that the curve turns away from.
template <class Traits> void expect_sides_of_pieces(const Asked<Traits>& side, bool is_exact) {
  using NT = typename Traits::FT;
  const Region_boundary_2<NT> boundary = side.boundary();
  for (const bool is_outer : {true, false})
    for (const Boundary_piece_2<NT>& piece : is_outer ? boundary.outer : boundary.inner) {
      SCOPED_TRACE(std::string(is_outer ? "outer " : "inner ") + (piece.is_segment() ? "segment" : "arc"));
      const Xy<NT> q = point_on(piece), normal = piece.support.normal_at(q);
      const NT length = CGAL::abs(normal.x) + CGAL::abs(normal.y), little = NT(0x1p-20);
      const NT sign = NT((side.turn() > 0) == is_outer ? -1 : 1);
      const Xy<NT> outward = NT(sign * little / length) * normal;
      EXPECT_EQ(side(Xy<NT>(q + outward)), CGAL::ON_UNBOUNDED_SIDE);
      EXPECT_EQ(side(Xy<NT>(q - outward)), CGAL::ON_BOUNDED_SIDE);
      if (!is_exact) continue;
      EXPECT_EQ(side(q), CGAL::ON_BOUNDARY);
      EXPECT_EQ(side(piece.from), CGAL::ON_BOUNDARY);
      EXPECT_EQ(side(piece.to), CGAL::ON_BOUNDARY);
    }
}

// \param is_exact zeros are decided, and in short time
template <class Traits> void expect_sides(bool is_exact, bool has_exact_ends) {
  using NT = typename Traits::FT;
  for (const Case& c : CASES) {
    SCOPED_TRACE(c.name);
    const Asked<Traits> side(c);
    expect_sides_of_pieces(side, is_exact);
    for (const double t : {0.125, 0.5, 0.875}) EXPECT_EQ(side(side.curve_point(t)), CGAL::ON_BOUNDED_SIDE) << t;
    const Xy<NT> p0 = side.curve_point(0), p1 = side.curve_point(1), chord = p1 - p0;
    EXPECT_EQ(side(p0), CGAL::ON_BOUNDARY);
    if (has_exact_ends) {
      EXPECT_EQ(side(p1), CGAL::ON_BOUNDARY);
    }
    for (const double along : {-1.0, -0x1p-30, 0.5, 1 + 0x1p-30, 2.0})
      EXPECT_EQ(side(Xy<NT>(p0 + NT(along) * chord)), CGAL::ON_UNBOUNDED_SIDE) << along << " of the chord";
    for (const double across : {-1.0, 1.0})
      for (const double along : {0.0, 0.5, 1.0})
        EXPECT_EQ(side(Xy<NT>(p0 + NT(along) * chord + NT(across) * perp(chord))), CGAL::ON_UNBOUNDED_SIDE);
  }
}

TEST(BoundedSide, OfBcaIsExactOverRationals) { expect_sides<Bca_traits_2<Kernel<Exact>>>(true, true); }
TEST(BoundedSide, OfBcaIsExactOverRoots) { expect_sides<Bca_traits_2<Kernel<CORE::Expr>>>(true, true); }
// zeros of nested roots take minutes
TEST(BoundedSide, OfSpiralFatArcsTellsInsideFromOutsideOverRoots) {
  expect_sides<Spiral_fat_arc_traits_2<Kernel<CORE::Expr>>>(false, false);
}
TEST(BoundedSide, OfBilensTellsInsideFromOutsideOverRoots) {
  expect_sides<Bilens_traits_2<Kernel<CORE::Expr>>>(false, false);
}
TEST(BoundedSide, OverDoubleTellsInsideFromOutside) {
  expect_sides<Bca_traits_2<Kernel<double>>>(false, true);
  expect_sides<Spiral_fat_arc_traits_2<Kernel<double>>>(false, true);
  expect_sides<Bilens_traits_2<Kernel<double>>>(false, true);
}

// A sliver past an inflection: its arcs lie on different sides of the chord, which is inside.
TEST(BoundedSide, HoldsTheChordOfASliverPastAnInflection) {
  const Bca_traits_2<Kernel<Exact>> traits;
  for (const int sign : {1, -1}) {
    const Exact height(sign * 0.25);
    const auto region = traits.construct_bounding_region_2_object()(
        chord_frame<Exact>({{Exact(0), Exact(0)}, {Exact(1), height}, {Exact(0), Exact(0)}},
                           {{Exact(2), Exact(0)}, {Exact(1), Exact(height * Exact(2))}, {Exact(0), Exact(0)}}));
    const auto side = [&](double x, double y) {
      return traits.bounded_side_2_object()(region, Kernel<Exact>::Point_2(Exact(x), Exact(y)));
    };
    const auto boundary = traits.construct_region_boundary_2_object()(region);
    EXPECT_EQ(side(0, 0), CGAL::ON_BOUNDARY);
    EXPECT_EQ(side(2, 0), CGAL::ON_BOUNDARY);
    for (const auto* chain : {&boundary.inner, &boundary.outer}) {
      const Xy<Exact> q = point_on((*chain)[0]);
      EXPECT_EQ(traits.bounded_side_2_object()(region, Kernel<Exact>::Point_2(q.x, q.y)), CGAL::ON_BOUNDARY);
    }
    for (const double y : {-0.03125, 0.03125}) EXPECT_EQ(side(1, y), CGAL::ON_BOUNDED_SIDE) << y;
    for (const double y : {-1.0, 1.0}) EXPECT_EQ(side(1, y), CGAL::ON_UNBOUNDED_SIDE) << y;
    EXPECT_EQ(side(-0.5, 0), CGAL::ON_UNBOUNDED_SIDE);
    EXPECT_EQ(side(2.5, 0), CGAL::ON_UNBOUNDED_SIDE);
  }
}

}  // namespace
}  // namespace test_bounded_side
