// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Certified regions: their widening is some ulp, is proven in exact arithmetic too, and holds slivers and cusps;
// without it, or around smaller regions, nothing is proven.

#include "../../src/library/verify/Outside_proof.h"
#include "cases.h"
#include "degenerate_curves.h"
#include "random_spirals.h"

#include <CGAL/Bounding_arcs_2.h>
#include <CGAL/Bounding_arcs_2/verify/Certified_traits_2.h>
#include <CGAL/Bounding_arcs_2/verify/verify_region.h>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Simple_cartesian.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <type_traits>
#include <vector>

namespace test_certified_regions {
namespace {

using namespace CGAL::Bounding_arcs;
using namespace bounding_arcs_test;
template <class Linear>
using Circular = CGAL::Circular_kernel_2<Linear, CGAL::Algebraic_kernel_for_circles_2_2<typename Linear::FT>>;
using Kernel = Circular<CGAL::Simple_cartesian<double>>;

double size_of(const Bezier& curve) {
  double size = 0;
  for (const Point& p : curve.control_points()) size = (std::max)({size, std::fabs(p.x), std::fabs(p.y)});
  return size;
}
double ulp(double x) { return std::nextafter(x, std::numeric_limits<double>::infinity()) - x; }

Bezier moved_and_scaled(const Bezier& curve, const Point& by, double scale) {
  std::vector<Point> points;
  for (const Point& p : curve.control_points()) points.push_back({scale * (p.x + by.x), scale * (p.y + by.y)});
  return Bezier(points, curve.weights());
}

// The same rounded region, wherever it comes from, has to be proven in exact arithmetic alone.
template <class FT> bool is_within_exactly(const Piece& p, const Certified_region_2<FT>& region) {
  return verify::Outside_proof<Exact>({p.spiral, p.t0, p.t1}, region.boundary, region.widening).bound() <=
         region.widening;
}

// With every arc moved inward by a distance: the circles' curvatures change so that their radii do.
template <class FT> Region_boundary_2<FT> shrunk(Region_boundary_2<FT> boundary, FT distance) {
  const FT turn = boundary.outer[0].support.curvature + boundary.outer[boundary.outer.size() - 1].support.curvature;
  const auto inward = [&](Boundary_chain_2<FT>& chain, FT side) {
    std::vector<Boundary_piece_2<FT>> pieces(chain.begin(), chain.end());
    for (Boundary_piece_2<FT>& p : pieces) {
      const FT length = std::hypot(p.support.normal.x, p.support.normal.y),
               way = (turn < 0 ? -side : side) * distance / length;
      p.support.point = p.support.point + way * p.support.normal;
      p.support.curvature /= 1 - way * p.support.curvature;
    }
    chain = pieces.size() == 1 ? Boundary_chain_2<FT>(pieces[0]) : Boundary_chain_2<FT>(pieces[0], pieces[1]);
  };
  inward(boundary.outer, FT(1));
  inward(boundary.inner, FT(-1));
  return boundary;
}

template <class Traits> class CertifiedRegion : public testing::Test {
 protected:
  const Certified_traits_2<Traits> traits;
  auto region(const Piece& p) const { return traits.construct_certified_region_2_object()(p.spiral, p.t0, p.t1); }
  // Every piece of the curve's spirals halved to this depth, at their two ends and in the middle.
  template <class Visit> static void for_each_piece(const Bezier& curve, int depth, const Visit& visit) {
    for (const Spiral& spiral : spiral_segments(curve)) {
      double a = spiral.first(), b = spiral.last();
      for (int level = 0; level <= depth && a < b; ++level) {
        visit(Piece{spiral, spiral.first(), b});
        visit(Piece{spiral, a, spiral.last()});
        const double middle = spiral.first() + (spiral.last() - spiral.first()) / 2;
        if (level > 0 && middle < b) visit(Piece{spiral, middle, spiral.last()});
        b = spiral.first() + (b - spiral.first()) / 2;
        a = spiral.last() - (spiral.last() - a) / 2;
        if (!(spiral.first() < b && a < spiral.last())) break;
      }
    }
  }
  // Proven, finite, and widened by no more than so many ulp of the curve's coordinates.
  void expect_certified(const Piece& p, double ulps) const {
    const auto r = region(p);
    ASSERT_TRUE(std::isfinite(r.widening)) << text(p);
    EXPECT_TRUE(is_within(p.spiral, p.t0, p.t1, r.boundary, r.widening)) << text(p);
    EXPECT_LE(r.widening, ulps * ulp(size_of(p.spiral.curve()))) << text(p);
  }
};
using All_traits = testing::Types<Bca_traits_2<Kernel>, Spiral_fat_arc_traits_2<Kernel>, Bilens_traits_2<Kernel>,
                                  Bilens_traits_2<Circular<CGAL::Exact_predicates_inexact_constructions_kernel>>>;
TYPED_TEST_SUITE(CertifiedRegion, All_traits);

TYPED_TEST(CertifiedRegion, IsWidenedByAFewUlpAroundRandomSpirals) {
  for (const int depth : {0, 5, 12, 30})
    for (const Piece& p : random_pieces(51, 150, depth)) this->expect_certified(p, 8);
}

TYPED_TEST(CertifiedRegion, IsProvenInExactArithmeticToo) {
  for (const Piece& p : random_pieces(52, 60, 8)) EXPECT_TRUE(is_within_exactly(p, this->region(p))) << text(p);
}

TYPED_TEST(CertifiedRegion, KeepsToAFewUlpFarFromTheOriginAndInAnyUnit) {
  std::mt19937 random(53);
  for (int i = 0; i < 12; ++i) {
    const Bezier curve = random_curve(random, 3, i % 2 == 0);
    for (const double offset : {1e3, 1e8})
      this->for_each_piece(moved_and_scaled(curve, {offset, -offset}, 1), 6,
                           [&](const Piece& p) { this->expect_certified(p, 8); });
    for (const double unit : {0x1p-498, 0x1p+498})
      this->for_each_piece(moved_and_scaled(curve, {}, unit), 6, [&](const Piece& p) { this->expect_certified(p, 8); });
  }
}

TYPED_TEST(CertifiedRegion, HoldsSliversAndCusps) {
  const std::vector<Bezier> curves{
      Bezier({{0, 0}, {0.1, 0.3}, {0.7, 0.9}, {1, 0.1}}),            // a vertex that is no double
      Bezier({{0, 0}, {1, 1}, {0, 1}, {1, 0}}),                      // a cusp at 1/2
      Bezier({{0, 0}, {1, -1}, {-1, -0.5}, {3, 1.5}}),               // a cusp at 1/3
      Bezier({{0, 0}, {0.7, 0.7}, {0, 0.7}, {0.7, 0}}),              // a cusp that rounding has pulled apart
      Bezier({{0, 0}, {1, 1}, {1e-6, 1}, {1, 0}}),                   // almost a cusp: half a circle of radius 1e-7
      Bezier({{0, 0}, {2, 1}, {-1, -0.5}, {4, 2}}),                  // a line folded back
      Bezier({{0.1, 0.1}, {0.2, 0.2}, {0.30000000000000004, 0.3}}),  // a line but for rounding
      Bezier({{0, 0}, {0, 0}, {1, 0}, {3, 2}}),
      Bezier({{0, 0}, {2, 3}, {3, 0}, {3, 0}}),
      Bezier({{1, 0}, {1, 1}, {0, 1}}, {1, 0.70710678118654757, 1}),  // an arc but for rounding
      Bezier({{0, 0}, {1, 1e-200}, {2, 3e-200}, {3, 0}}),
      Bezier({{0.1, 0.7}, {0.1, 0.7}})};
  for (const Bezier& curve : curves)
    this->for_each_piece(curve, 40, [&](const Piece& p) { this->expect_certified(p, 8); });
}

// Cut ends depend on the goal of the search in steps: found with one goal, proven with another.
TYPED_TEST(CertifiedRegion, IsProvenWhereTheGoalDecides) {
  const Bezier curve(
      {{0, 0},
       {1.3575893584667441e+42, 9.4422111978645243e+131},
       {-7.8043713757899806e+143, 1.5608742751579961e+144},
       {3.1217510083307114e+144, 3.2773529591901464e+138},
       {3.1217485503159922e+144, 0}},
      {0.0059231699401545062, 4.8724327451984122, 3.650200982190257, 0.09393122898980466, 1.6031065258437724});
  const Spiral spiral = spiral_segments(curve).back();
  this->expect_certified({spiral, spiral.first(), spiral.last()}, 8);
}

TYPED_TEST(CertifiedRegion, CannotBeShrunkByMoreThanItsThickness) {
  for (const Piece& p : random_pieces(54, 100, 8)) {
    const auto r = this->region(p);
    if (r.boundary.outer[0].is_segment() && r.boundary.inner[0].is_segment()) continue;
    const auto frame = p.spiral.template frame<double>(p.t0, p.t1);
    const double thickness = this->traits.construction().thickness(frame.shape),
                 chord = std::hypot(frame.p1.x - frame.p0.x, frame.p1.y - frame.p0.y);
    if (!(thickness < 0.01 * chord)) continue;
    EXPECT_FALSE(is_within(p.spiral, p.t0, p.t1, shrunk(r.boundary, thickness + 2 * r.widening), r.widening))
        << text(p);
  }
}

TYPED_TEST(CertifiedRegion, NeedsItsWideningSomewhere) {
  int needed = 0;
  for (const Piece& p : random_pieces(55, 100, 8))
    needed += !is_within(p.spiral, p.t0, p.t1, this->region(p).boundary, 0);
  EXPECT_GT(needed, 50);
}

// Where a curve leaves its end aside of its way with a radius far below its length, no bilens in doubles holds it, and
// the BCA that is there instead is as thick as the piece is long over some: its parts are not.
TYPED_TEST(CertifiedRegion, IsAsThinAsEpsWhateverItStepsBackTo) {
  Degenerate_curves curves(57);
  int others = 0, parts = 0;  // BCAs that are not the traits' own, and regions beyond one a leaf
  for (int i = 0; i < cases(30); ++i) {
    const Bezier curve = i == 0 ? Bezier({{0, 0}, {1e-9, 0}, {0.999999999, 1e-9}, {1, 0}}) : curves(Kind::STEEP_ENDS);
    const double eps = i == 0 ? 1e-3 : curves.eps(curve);
    if (size_of(curve) < 0x1p-500 || size_of(curve) > 0x1p500) continue;  // not served
    const Region_hierarchy_2<TypeParam, Spiral> tree(spiral_segments(curve), eps);
    if (tree.status() != Build_status::COMPLETE) continue;
    tree.for_each_leaf([&](const Node_handle& h) {
      const Region_node n = tree.node(h);
      const Spiral& spiral = tree.spirals()[n.spiral];
      double end = n.t0;
      const auto certified = this->traits.construct_certified_region_2_object();
      certified(spiral, n.t0, n.t1, eps, [&](double t0, double t1, const auto& region) {
        EXPECT_EQ(t0, end);
        end = t1;
        others += region.is_other;
        ++parts;
        if (!region.is_certified) return;
        EXPECT_LE(region.thickness, eps) << text(Piece{spiral, t0, t1});
        EXPECT_TRUE(is_within(spiral, t0, t1, region.boundary, region.widening)) << text(Piece{spiral, t0, t1});
        if (region.is_other) {
          EXPECT_TRUE(verify_thickness<Bca>(spiral, t0, t1, region.thickness));
        }
      });
      EXPECT_EQ(end, n.t1);
      --parts;
    });
  }
  if (std::is_same_v<typename TypeParam::Construction, Bca> || FEW_CASES) return;
  EXPECT_GT(others, 0);
  EXPECT_GT(parts, 0);
}

// Double-doubles tell little of high degrees; rational numbers do.
TYPED_TEST(CertifiedRegion, IsThereForHighDegrees) {
  std::mt19937 random(58);
  for (const int degree : {20, 32}) {
    const Bezier curve = random_curve(random, degree, false);
    const std::vector<Spiral> spirals = spiral_segments(curve);
    for (const Spiral& s : {spirals.front(), spirals.back()}) this->expect_certified({s, s.first(), s.last()}, 8);
  }
}

TEST(CertifiedTree, KeepsTheRegionsOfItsTraits) {
  const Bezier curve({{0, 0.6}, {6.4, 3}, {-2.4, 3.4}, {3, 0}});
  using Traits = Certified_traits_2<Bca_traits_2<Kernel>>;
  const Region_hierarchy_2<Traits, Spiral> tree(spiral_segments(curve), 1e-3);
  const Region_hierarchy_2<Bca_traits_2<Kernel>, Spiral> plain(spiral_segments(curve), 1e-3);
  EXPECT_EQ(tree.number_of_leaves(), plain.number_of_leaves());
  tree.for_each_leaf([&](const Node_handle& h) {
    const Region_node n = tree.node(h);
    const Spiral& spiral = tree.spirals()[n.spiral];
    const auto region = tree.traits().construct_certified_region_2_object()(spiral, n.t0, n.t1);
    const auto boundary = tree.traits().construct_region_boundary_2_object()(tree.region(n));
    EXPECT_EQ(region.boundary.outer[0].support.curvature, boundary.outer[0].support.curvature);
    EXPECT_TRUE(is_within(spiral, n.t0, n.t1, boundary, region.widening));
  });
}

TEST(CertifiedRegion, IsThereForFloatAndLongDouble) {
  const auto expect_widening = [](auto number, double most) {
    using FT = decltype(number);
    std::mt19937 random(56);
    for (int i = 0; i < 20; ++i) {
      const Bezier curve = random_curve(random, 3, false);
      std::vector<Xy<FT>> points;
      for (const Point& p : curve.control_points()) points.push_back({FT(p.x), FT(p.y)});
      const Certified_traits_2<Bca_traits_2<Circular<CGAL::Simple_cartesian<FT>>>> traits;
      for (const auto& spiral : spiral_segments(Bezier_curve_2<FT>(points))) {
        const auto region = traits.construct_certified_region_2_object()(spiral, spiral.first(), spiral.last());
        EXPECT_LE(region.widening, most);
        EXPECT_TRUE(is_within(spiral, spiral.first(), spiral.last(), region.boundary, region.widening));
      }
    }
  };
  expect_widening(float(), 1e-4);  // the shapes over float are made in float, and lose digits
  expect_widening(static_cast<long double>(0), 1e-16);
}

}  // namespace
}  // namespace test_certified_regions
