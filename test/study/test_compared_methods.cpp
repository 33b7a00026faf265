// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The methods that the three are compared with: thickness by closed forms, orders of convergence and the constants
// before them, proofs of containment and thickness, and that these fail for regions that are too small.

#include <CGAL/Bounding_arcs_2/region/Bilens.h>
#include <CGAL/Bounding_arcs_2/region/Spiral_fat_arc.h>
#include <CGAL/Bounding_arcs_2/spiral/Bezier_spiral_2.h>
#include <CGAL/Bounding_arcs_2/study/Search_study.h>
#include <CGAL/Bounding_arcs_2/study/boxes_and_hulls.h>
#include <CGAL/Bounding_arcs_2/study/fat_arcs.h>
#include <CGAL/Bounding_arcs_2/verify/verify_region.h>

#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <vector>

namespace test_compared_methods {
namespace {

using namespace CGAL::Bounding_arcs;
using Curve = Bezier_curve_2<double>;
using Spiral = Bezier_spiral_2<double>;

const Curve PARABOLA({{0, 0}, {0.5, 0}, {1, 1}});  // (t, t^2), a vertex and a tangent along an axis at t = 0
const Curve CUBIC({{0, 0}, {0.25, 0.5}, {1, 1}, {2, 1.125}});

template <class Construction> double thickness(const Spiral& spiral, double t0, double t1) {
  return Construction::thickness(spiral.shape<double>(t0, t1, shape_parts<Construction>()));
}

TEST(ComparedMethods, HaveTheThicknessOfAParabolasPieceInClosedForm) {
  const Spiral spiral = spiral_segments(PARABOLA).front();
  const double ulps = 1e-15;
  EXPECT_NEAR(thickness<Axis_box>(spiral, 0, 1), 1, ulps);
  EXPECT_NEAR(thickness<Axis_box>(spiral, 0, 0.5), 0.25, ulps);
  EXPECT_NEAR(thickness<Control_hull>(spiral, 0, 1), std::sqrt(0.125), ulps);      // of (1/2, 0) from y = x
  EXPECT_NEAR(thickness<Oriented_box>(spiral, 0, 1), std::sqrt(0.125) / 2, ulps);  // of the curve
  // n = (-3, 11)/16, k = 1/2 and k |q|^2 - 2 n.q = t (1 - t) (1 - 2 t) (3 + 2 t)/8
  const double square = 130.0 / 256, reach = std::sqrt(3.0) / 18 * 5 / 8, n = std::sqrt(square);
  const double least = reach / (n + std::sqrt(square + reach / 2)) + reach / (n + std::sqrt(square - reach / 2));
  const double room = 6e-11;  // that the constant sqrt(3)/18 is rounded up by
  EXPECT_GE(thickness<Three_point_fat_arc>(spiral, 0, 1), least);
  EXPECT_LE(thickness<Three_point_fat_arc>(spiral, 0, 1), least * (1 + room));
}

TEST(ComparedMethods, HaveTheThicknessOfAQuarterCircleInClosedForm) {
  const double half = std::sqrt(0.5);
  const Spiral spiral = spiral_segments(Curve({{1, 0}, {1, 1}, {0, 1}}, {1, half, 1})).front();
  const double ulps = 1e-15;
  EXPECT_NEAR(thickness<Axis_box>(spiral, 0, 1), 1, ulps);
  EXPECT_NEAR(thickness<Control_hull>(spiral, 0, 1), half, ulps);
  EXPECT_NEAR(thickness<Oriented_box>(spiral, 0, 1), half / 2, ulps);  // 1 - half, but for the change of weights
  EXPECT_LE(thickness<Three_point_fat_arc>(spiral, 0, 1), ulps);
  EXPECT_LE(thickness<Fat_biarc>(spiral, 0, 1), ulps);
}

// The distance of the curve from the arc or biarc itself is what the strip has to be as wide as: never more, and nearly
// as much where pieces are short.
template <class Construction> void expect_tight(double share) {
  const Spiral spiral = spiral_segments(CUBIC).front();
  for (int k = 0; k < 20; ++k) {
    const double width = std::ldexp(0.5, -k);
    const auto shape = spiral.accurate_shape(0.25, 0.25 + width, shape_parts<Construction>());
    const auto outline = Construction::boundary(shape.at_origin());
    ASSERT_EQ(outline.form, Outline_form::STRIP);
    const auto curve = study::control_polynomials(shape);
    double nearest = 1;  // of the distances to the outer side, over the thickness
    const std::size_t arcs = outline.outer.size() - 2, samples = 64;
    for (std::size_t i = 1; i < samples; ++i) {
      const double t = static_cast<double>(i) / samples, w = curve.weight(t);
      const Xy<double> q = shape.unit * Xy<double>{curve.x(t) / w, curve.y(t) / w};
      const auto& arc = outline.outer[arcs == 1 || 2 * i < samples ? 1 : 2];
      const double length = std::hypot(arc.support.normal.x, arc.support.normal.y);
      const double distance = std::fabs(arc.support.side(q)) / (2 * length);
      nearest = std::min(nearest, distance / Construction::thickness(shape));
    }
    EXPECT_GE(nearest, 0) << k;
    if (k > 5 && k < 9) {  // before rounding shows
      EXPECT_LE(nearest, share) << k;
    }
  }
}
TEST(ComparedMethods, HaveStripsNoWiderThanNeeded) {
  expect_tight<Three_point_fat_arc>(0.02);
  expect_tight<Fat_biarc>(0.02);
}

// thickness / size^p of the shortest pieces, over the constant that theory has: with k the curvature where they are,
// k' its slope by arc length.
template <class Construction>
void expect_order(const Curve& curve, double t, double order, double constant, double within = 0.001) {
  const Spiral spiral = spiral_segments(curve).front();
  const std::vector<Piece_size> all = piece_sizes(Construction(), spiral, t, 0.25, 30);
  ASSERT_EQ(all.size(), 30u);
  const std::vector<Piece_size> short_ones(all.begin() + 10, all.end());
  EXPECT_NEAR(convergence_order(short_ones), order, 0.02 * order) << Construction::NAME;
  EXPECT_NEAR(all.back().thickness / std::pow(all.back().size, order), constant, within * constant)
      << Construction::NAME;
}

TEST(ComparedMethods, ConvergeAsTheoryTells) {
  const double t = 0.25, u = 1 - t;
  const Xy<double> d1{0.75 * u * u + 4.5 * u * t + 3 * t * t, 1.5 * u * u + 3 * u * t + 0.375 * t * t};
  const Xy<double> d2{2 * (u * 1.5 + t * 0.75), 2 * (u * 0 + t * -1.125)};
  const Xy<double> d3{6 * (2 - 3 * 1 + 3 * 0.25 - 0), 6 * (1.125 - 3 * 1 + 3 * 0.5 - 0)};
  const double speed = std::sqrt(dot(d1, d1)), bend = cross(d1, d2);
  const double curvature = std::fabs(bend) / std::pow(speed, 3);
  const double slope = std::fabs(cross(d1, d3) / std::pow(speed, 4) - 3 * bend * dot(d1, d2) / std::pow(speed, 6));
  expect_order<Bca>(CUBIC, t, 3, slope / 24);
  expect_order<Spiral_fat_arc>(CUBIC, t, 3, slope / 6, 0.01);  // 1 - O(sqrt(size)) of it
  expect_order<Bilens>(CUBIC, t, 3, slope / 48);
  expect_order<Three_point_fat_arc>(CUBIC, t, 3, slope * std::sqrt(3.0) / 108);
  expect_order<Fat_biarc>(CUBIC, t, 3, slope / 162);
  expect_order<Oriented_box>(CUBIC, t, 2, curvature / 8);
  expect_order<Control_hull>(CUBIC, t, 2, curvature / 6);
  expect_order<Axis_box>(CUBIC, t, 1, std::min(std::fabs(d1.x), std::fabs(d1.y)) / speed);
}

// At t = 0 the parabola is y = x^2 with curvature 2 and curvature' = 0, curvature'' = -24: x = s - 2 s^3/3.
TEST(ComparedMethods, ConvergeFasterAtAVertexAndAlongAnAxis) {
  expect_order<Axis_box>(PARABOLA, 0, 2, 1);
  for (const auto& orders :
       {convergence_order(piece_sizes(Bca(), spiral_segments(PARABOLA).front(), 0, 0.01, 20)),
        convergence_order(piece_sizes(Three_point_fat_arc(), spiral_segments(PARABOLA).front(), 0, 0.01, 20)),
        convergence_order(piece_sizes(Fat_biarc(), spiral_segments(PARABOLA).front(), 0, 0.01, 20))})
    EXPECT_NEAR(orders, 4, 0.02);
}

const std::vector<Curve>& curves() {
  static const std::vector<Curve> CURVES{
      PARABOLA,
      CUBIC,
      Curve({{0, 0}, {1, 2}, {2, -1}, {3, 1}}),                                // an inflection
      Curve({{0, 0.6}, {6.4, 3}, {-2.4, 3.4}, {3, 0}}),                        // a loop
      Curve({{1, 0}, {1, 1}, {0, 1}}, {1, 3, 1}),                              // a hyperbola
      Curve({{0, 0}, {1, 0.1}, {2, 1}, {2.5, 3}, {2, 4}}, {1, 0.5, 2, 1, 1}),  // a rational quartic
      Curve({{0, 0}, {1, 0}, {1.5, 0.3}, {2, 1}, {2.1, 2}, {1.5, 3}}),         // a quintic
      Curve({{0, 0}, {0, 0}, {1, 0}, {1, 1}}),                                 // C' = 0 at its start
      Curve({{1e9, 1e9}, {1e9 + 1, 1e9}, {1e9 + 2, 1e9 + 1}}),                 // far away
      Curve({{0, 0}, {1e-20, 1e-20}, {1, 2}, {3, 1}}),
      Curve({{0, 0}, {1, 1e-14}, {2, -1e-14}, {3, 0}}),  // nearly straight
      Curve({{0.1, 0.1}, {0.2, 0.2}, {0.30000000000000004, 0.3}, {0.4, 0.4}}),
      Curve({{0, 0}, {1, 1}, {3, 3}})};  // straight
  return CURVES;
}

// Every leaf and inner piece to some depth.
template <class Construction, class Check> void for_each_piece(const Check& check) {
  for (const Curve& curve : curves())
    for (const Spiral& spiral : spiral_segments(curve))
      for (const int parts : {1, 2, 16})
        for (int i = 0; i < parts; i += 3) {
          const double step = (spiral.last() - spiral.first()) / parts;
          const double t0 = i == 0 ? spiral.first() : spiral.first() + i * step;
          const double t1 = i + 1 == parts ? spiral.last() : spiral.first() + (i + 1) * step;
          check(spiral, t0, t1);
        }
}

template <class Construction> class Each : public testing::Test {};
using All = testing::Types<Axis_box, Oriented_box, Control_hull, Three_point_fat_arc, Fat_biarc>;
struct Names {
  template <class Construction> static std::string GetName(int) { return Construction::NAME; }
};
TYPED_TEST_SUITE(Each, All, Names);

TYPED_TEST(Each, RegionIsProvenToHoldTheCurveAndToBeThin) {
  std::size_t proven = 0, slivers = 0;
  for_each_piece<TypeParam>([&](const Spiral& spiral, double t0, double t1) {
    const auto shape = spiral.template shape<Bounded_double>(t0, t1, shape_parts<TypeParam>());
    const double upper = certified_upper(TypeParam::thickness(shape));
    const double eps = (std::max)(upper, 1e-12 * spiral.coordinate_size());  // no less than parameters resolve
    const Region_proof proof = verify_region<TypeParam>(spiral, t0, t1, eps);
    EXPECT_TRUE(proof.holds()) << t0 << ' ' << t1 << " of " << spiral.curve().control_points()[1].x;
    proven += proof.containment == Containment::PROVEN;
    slivers += proof.containment == Containment::PROVEN_AS_SLIVER;
    EXPECT_TRUE(verify_thickness<TypeParam>(spiral, t0, t1, upper)) << t0 << ' ' << t1;
    const bool is_exact = spiral.is_straight() || upper < 1e-12;
    if (!is_exact) {
      EXPECT_FALSE(verify_thickness<TypeParam>(spiral, t0, t1, 0.49 * upper)) << t0 << ' ' << t1;
    }
  });
  EXPECT_GT(proven, 100u);
  EXPECT_LT(slivers, proven / 10);
}

// The region with what is on its outer side a fifth nearer to the piece's start.
template <class Construction> struct Cut_down : Construction {
  template <class NT> [[nodiscard]] static Region_outline_2<NT> boundary(const Chord_frame_2<NT>& frame) {
    auto outline = Construction::boundary(frame);
    const NT share = NT(4) / NT(5);
    if constexpr (Construction::BOUNDARY_NEEDS_SQUARE_ROOT) {
      if (outline.form != Outline_form::STRIP) return outline;
      const Xy<NT> step = share * (outline.outer[0].to - frame.p0);  // to the new arcs, along the normal
      for (std::size_t i = 1; i + 1 < outline.outer.size(); ++i) {
        Contact_circle_2<NT>& c = outline.outer[i].support;
        const Xy<NT> n = NT(NT(1) / square_root(dot(c.normal, c.normal))) * c.normal;
        const NT gap = square_root(dot(step, step)) / NT(4), side(outline.inner_is_left ? 1 : -1);
        c.point = c.point + NT(side * gap) * n;  // an offset by gap has another curvature by a factor near 1
      }
    } else {
      for (auto* chain : {&outline.inner, &outline.outer})
        for (auto& piece : *chain) {
          piece.from = frame.p0 + share * (piece.from - frame.p0);
          piece.to = frame.p0 + share * (piece.to - frame.p0);
          piece = segment_between(piece.from, piece.to);
        }
    }
    return outline;
  }
};

TYPED_TEST(Each, RegionThatIsTooSmallIsNotProven) {
  const Spiral spiral = spiral_segments(CUBIC).front();
  for (const double width : {0.0625, 0.015625})
    EXPECT_FALSE(verify_region<Cut_down<TypeParam>>(spiral, 0.25, 0.25 + width).holds()) << width;
}

TYPED_TEST(Each, RegionHasTheCurveOnItsBoundedSide) {
  for_each_piece<TypeParam>([&](const Spiral& spiral, double t0, double t1) {
    using Exact = CGAL::Exact_rational;
    if (spiral.is_straight()) return;
    const auto frame = spiral.template frame<double>(t0, t1, shape_parts<TypeParam>());
    const auto outline = TypeParam::boundary(frame);
    const double thickness = TypeParam::thickness(frame.shape);
    const auto middle = spiral.template point<Exact>(t0 + (t1 - t0) / 3);
    const Xy<double> q{CGAL::to_double(middle.x), CGAL::to_double(middle.y)};
    if (thickness < 1e-12 * spiral.coordinate_size()) return;  // rounding of the curve's point shows
    EXPECT_EQ(bounded_side(outline, q), CGAL::ON_BOUNDED_SIDE) << t0 << ' ' << t1;
    const Xy<double> chord = frame.p1 - frame.p0, n = (3 * thickness / std::hypot(chord.x, chord.y)) * perp(chord);
    EXPECT_EQ(bounded_side(outline, q + n), CGAL::ON_UNBOUNDED_SIDE) << t0 << ' ' << t1;
    EXPECT_EQ(bounded_side(outline, q - n), CGAL::ON_UNBOUNDED_SIDE) << t0 << ' ' << t1;
    EXPECT_EQ(bounded_side(outline, frame.p0 - 0.01 * chord), CGAL::ON_UNBOUNDED_SIDE) << t0 << ' ' << t1;
  });
}

}  // namespace
}  // namespace test_compared_methods
