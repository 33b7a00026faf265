// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The three regions over double kernels: symmetry under mirrors and reversal, boundaries that are connected and touch
// the curve as they should, thickness against sampled distances, boxes, and what happens on nearly circular pieces.

#include "random_spirals.h"
#include "region_samples.h"

#include <CGAL/Bounding_arcs_2.h>

#include <CGAL/Simple_cartesian.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <type_traits>

namespace test_regions {
namespace {

using namespace CGAL::Bounding_arcs;
using namespace bounding_arcs_test;
using Kernel = CGAL::Circular_kernel_2<CGAL::Simple_cartesian<double>, CGAL::Algebraic_kernel_for_circles_2_2<double>>;
using Boundary = Region_boundary_2<double>;
using Frame = Chord_frame_2<double>;

// What the rounding of two end points costs, as a length: 2 sqrt(2) (3 degree + 1) 2u each way for rational curves of
// degree 9 with control points in [-1, 1]^2 (Bezier_spiral_2::point_error), and a few u for a joint.
constexpr double ROUNDING = 2e-14;
constexpr unsigned SEED = 201;

template <class Construction> class Region : public testing::Test {
 protected:
  static constexpr bool IS_BCA = std::is_same_v<Construction, Bca>;
  static constexpr bool IS_SFA = std::is_same_v<Construction, Spiral_fat_arc>;
};
using Constructions = testing::Types<Bca, Spiral_fat_arc, Bilens>;
TYPED_TEST_SUITE(Region, Constructions);

// The piece under x -> sign_x x, y -> sign_y y, and run through backwards if asked to.
Frame transformed(const Piece& p, double sign_x, double sign_y, bool is_reversed) {
  std::vector<Point> points = p.spiral.curve().control_points();
  for (Point& q : points) q = {sign_x * q.x, sign_y * q.y};
  Bezier curve(points, p.spiral.curve().weights());
  if (is_reversed) curve = curve.reversed();
  const auto table = std::make_shared<const Tabulated_bezier<double>>(curve);
  const double first = p.spiral.first(),
               last = p.spiral.last();  // whose points are rounded otherwise than those between
  if (!is_reversed) return Spiral(table, first, last, p.spiral.orders(first, last), false).frame(p.t0, p.t1);
  const End_orders orders = p.spiral.orders(p.t0, p.t1);
  return Spiral(table, 1 - p.t1, 1 - p.t0, {orders.end, orders.start}, false).frame(1 - p.t1, 1 - p.t0);
}

void expect_mirrored(const Boundary_chain_2<double>& a, const Boundary_chain_2<double>& b, double sign_x,
                     double sign_y) {
  ASSERT_EQ(a.size(), b.size());
  const auto mirrored = [&](const Point& p) { return Point{sign_x * p.x, sign_y * p.y}; };
  for (std::size_t i = 0; i < a.size(); ++i) {
    EXPECT_EQ(mirrored(a[i].from), b[i].from);
    EXPECT_EQ(mirrored(a[i].to), b[i].to);
    EXPECT_EQ(mirrored(a[i].support.point), b[i].support.point);
    // the left normal is the mirror image of the right one
    EXPECT_EQ(sign_x * sign_y * mirrored(a[i].support.normal), b[i].support.normal);
    EXPECT_EQ(sign_x * sign_y * a[i].support.curvature, b[i].support.curvature);
  }
}

TYPED_TEST(Region, IsMirroredBitForBit) {
  for (const Piece& p : random_pieces(SEED, 300, 20)) {
    for (const auto& [sx, sy] : {std::pair(1.0, -1.0), std::pair(-1.0, 1.0), std::pair(-1.0, -1.0)}) {
      SCOPED_TRACE(text(p) + ", seed 201");
      const Frame frame = p.spiral.frame(p.t0, p.t1), image = transformed(p, sx, sy, false);
      EXPECT_EQ(TypeParam::thickness(image.shape), TypeParam::thickness(frame.shape));
      const Boundary a = TypeParam::boundary(frame), b = TypeParam::boundary(image);
      EXPECT_EQ(a.form, b.form);
      expect_mirrored(a.inner, b.inner, sx, sy);
      expect_mirrored(a.outer, b.outer, sx, sy);
    }
  }
}

void expect_same_curve(const Boundary_chain_2<double>& forth, const Boundary_chain_2<double>& back) {
  ASSERT_EQ(forth.size(), back.size());
  const auto there = sampled(forth), again = sampled(back);
  for (std::size_t i = 0; i < there.size(); ++i) {
    const Sampled_piece& opposite = again[there.size() - 1 - i];
    EXPECT_LT(length(there[i].from - opposite.to), ROUNDING);
    EXPECT_LT(length(there[i].at(0.5L) - opposite.at(0.5L)), ROUNDING);
    EXPECT_LT(std::fabs(opposite.signed_distance(there[i].at(0.5L))), ROUNDING);
  }
}

TYPED_TEST(Region, IsTheSameRunThroughBackwards) {
  for (const Piece& p : random_pieces(SEED, 300, 4)) {
    // 1 - t is exact only on a grid
    const Piece q{p.spiral, std::ldexp(std::ceil(std::ldexp(p.t0, 30)), -30),
                  std::ldexp(std::floor(std::ldexp(p.t1, 30)), -30)};
    if (!(q.t0 < q.t1)) continue;
    SCOPED_TRACE(text(q) + ", seed 201");
    const Frame frame = transformed(q, 1, 1, false), back = transformed(q, 1, 1, true);
    EXPECT_EQ(frame.shape.turn, -back.shape.turn);
    EXPECT_NE(frame.shape.tight_first, back.shape.tight_first);
    EXPECT_NEAR(TypeParam::thickness(back.shape), TypeParam::thickness(frame.shape), ROUNDING);
    const Boundary a = TypeParam::boundary(frame), b = TypeParam::boundary(back);
    ASSERT_EQ(a.form, b.form);
    expect_same_curve(a.inner, b.inner);
    expect_same_curve(a.outer, b.outer);
  }
}

Real angle_between(const Vector& u, const Vector& v) { return std::fabs(std::atan2(cross(u, v), dot(u, v))); }

// A piece has this direction at q, but for what the rounding of points turns something of that length.
void expect_tangent(const Sampled_piece& piece, const Vector& direction, const Vector& q, Real shortest) {
  EXPECT_LT(angle_between(piece.tangent_at(q), direction), 1e-12L + ROUNDING / shortest);
}
Real chord_length(const Sampled_piece& piece) { return length(piece.to - piece.from); }

TYPED_TEST(Region, HasConnectedBoundariesThatTouchTheCurveWhereTheyShould) {
  std::size_t forms[2] = {0, 0};
  for (const Piece& p : random_pieces(SEED, 1000, 10)) {
    SCOPED_TRACE(text(p) + ", seed 201");
    const Frame f = p.spiral.frame(p.t0, p.t1);
    const Boundary b = TypeParam::boundary(f);
    ++forms[b.form == Region_form::BCA];
    const Vector t0 = widened(f.shape.tangent0), t1 = widened(f.shape.tangent1);
    for (const auto* chain : {&b.inner, &b.outer}) {
      const bool osculates_a_cusp = chain == &b.inner && (f.shape.infinite0 || f.shape.infinite1);
      EXPECT_EQ(chain->size(), b.form == Region_form::BCA || osculates_a_cusp ? 1u : 2u);
      EXPECT_EQ((*chain)[0].from, f.p0);
      EXPECT_EQ((*chain)[chain->size() - 1].to, f.p1);
      const auto pieces = sampled(*chain);
      for (const Sampled_piece& piece : pieces) {
        EXPECT_LT(std::fabs(piece.signed_distance(piece.from)), ROUNDING);
        EXPECT_LT(std::fabs(piece.signed_distance(piece.to)), ROUNDING);
      }
      if (pieces.size() == 1) continue;
      EXPECT_EQ((*chain)[0].to, (*chain)[1].from);
      if (chain == &b.inner || !TestFixture::IS_SFA)
        expect_tangent(pieces[0], pieces[1].tangent_at(pieces[0].to), pieces[0].to,
                       std::min(chord_length(pieces[0]), chord_length(pieces[1])));
      const bool free_start = TestFixture::IS_SFA && chain == &b.inner && !f.shape.tight_first;
      const bool free_end = TestFixture::IS_SFA && chain == &b.inner && f.shape.tight_first;
      if (!free_start) expect_tangent(pieces.front(), t0, pieces.front().from, chord_length(pieces.front()));
      if (!free_end) expect_tangent(pieces.back(), t1, pieces.back().to, chord_length(pieces.back()));
    }
    if (b.form == Region_form::BCA) {
      const Sampled_piece first = sampled(f.shape.tight_first ? b.outer : b.inner)[0];
      const Sampled_piece last = sampled(f.shape.tight_first ? b.inner : b.outer)[0];
      expect_tangent(first, t0, first.from, chord_length(first));
      expect_tangent(last, t1, last.to, chord_length(last));
    }
    if (testing::Test::HasFailure()) return;
  }
  if (!TestFixture::IS_BCA) {
    EXPECT_GT(forms[0], 10 * forms[1]);
  }
}

TYPED_TEST(Region, HasTheThicknessOfTheDistanceBetweenItsBoundaries) {
  for (const int depth : {0, 4}) {
    for (const Piece& p : random_pieces(SEED, 200, depth)) {
      SCOPED_TRACE(text(p) + ", seed 201");
      const Frame frame = p.spiral.frame(p.t0, p.t1);
      const double thickness = TypeParam::thickness(frame.shape);
      const Boundary b = TypeParam::boundary(frame);
      const auto inner = sampled(b.inner), outer = sampled(b.outer);
      const double there = static_cast<double>(one_sided_distance(outer, inner));
      EXPECT_LE(there, thickness * (1 + 1e-12) + ROUNDING);
      EXPECT_LE(one_sided_distance(inner, outer), thickness * (1 + 1e-12) + ROUNDING);
      // The bound is close: 64 samples a piece miss little of BCA and bilens; SFA bounds by the osculating circle.
      EXPECT_GE(there, (TestFixture::IS_SFA ? 0.4 : 0.99) * thickness - ROUNDING);
    }
  }
}

TYPED_TEST(Region, HasABoxThatHoldsCurveAndBoundary) {
  const Bounding_region_traits_2<Kernel, TypeParam> traits;
  for (const Piece& p : random_pieces(SEED, 300, 6)) {
    SCOPED_TRACE(text(p) + ", seed 201");
    const Frame frame = p.spiral.frame(p.t0, p.t1);
    const CGAL::Bbox_2 box = traits.construct_bbox_2_object()({frame});
    const Boundary b = TypeParam::boundary(frame);
    std::vector<Vector> points = samples(sampled(b.inner), 16);
    for (const Vector& q : samples(sampled(b.outer), 16)) points.push_back(q);
    for (int i = 0; i <= 16; ++i) points.push_back(widened(p.spiral.point(p.t0 + (p.t1 - p.t0) * i / 16)));
    for (const Vector& q : points) {
      EXPECT_TRUE(box.xmin() - ROUNDING <= q.x && q.x <= box.xmax() + ROUNDING) << double(q.x) << " in " << box;
      EXPECT_TRUE(box.ymin() - ROUNDING <= q.y && q.y <= box.ymax() + ROUNDING) << double(q.y) << " in " << box;
    }
    const double c = static_cast<double>(length(widened(frame.p1 - frame.p0)));
    EXPECT_LE(box.xmax() - box.xmin(), 3 * c + ROUNDING);
    if (testing::Test::HasFailure()) return;
  }
}

// A chain far from the origin with one short piece, whose chord has lost half its digits: they are in the tangents.
TEST(Bulge, KeepsItsDigitsOfAShortPieceOfASmoothChain) {
  constexpr double SHORT = 0x1p-28, TURN = 0.25;  // radius of the short arc, and what it and the long one turn by
  for (const bool is_first : {true, false}) {
    // arcs of radii r0, r1 and equal angles, from p0 with the tangent (1, 0)
    const double r0 = is_first ? SHORT : 1, r1 = is_first ? 1 : SHORT, s = std::sin(TURN), c = std::cos(TURN);
    const Point p0{1 / 3.0, -1 / 7.0}, normal0{0, 1}, normal1{-std::sin(2 * TURN), std::cos(2 * TURN)};
    const Point joint = p0 + Point{r0 * s, r0 * (1 - c)};
    const Point p1 = joint + r1 * (Point{-s, c} - normal1);
    const Boundary_chain_2<double> chain({p0, joint, {p0, normal0, 1 / r0}}, {joint, p1, {p1, normal1, 1 / r1}});
    EXPECT_NEAR(bulge(chain, is_first ? 0 : 1, true), std::tan(TURN / 4), 1e-15) << is_first;
    EXPECT_NEAR(bulge(chain, is_first ? 1 : 0, true), std::tan(TURN / 4), 1e-15) << is_first;
  }
}

// Curvature that differs by rounding alone: every number is finite, whatever form the region takes.
TYPED_TEST(Region, IsFiniteOnNearlyCircularPieces) {
  const Bezier quarter({{1, 0}, {1, 1}, {0, 1}}, {1, std::sqrt(0.5), 1});
  const double k = 4 * (std::sqrt(2.0) - 1) / 3;
  const Bezier cubic({{1, 0}, {1, k}, {k, 1}, {0, 1}});
  std::mt19937 random(SEED);
  for (const Bezier& curve : {quarter, cubic}) {
    for (const Spiral& spiral : spiral_segments(curve)) {
      for (int i = 0; i < 500; ++i) {
        const Piece p = random_piece(random, spiral, i % 50);
        SCOPED_TRACE(text(p) + ", seed 201");
        const Frame frame = p.spiral.frame(p.t0, p.t1);
        EXPECT_GE(TypeParam::thickness(frame.shape), 0);
        EXPECT_LE(TypeParam::thickness(frame.shape), 1e-3);
        const Boundary b = TypeParam::boundary(frame);
        for (const auto* chain : {&b.inner, &b.outer}) {
          for (const auto& piece : *chain) {
            EXPECT_TRUE(std::isfinite(piece.from.x + piece.from.y + piece.to.x + piece.to.y));
            EXPECT_TRUE(std::isfinite(piece.support.normal.x + piece.support.normal.y + piece.support.curvature));
          }
        }
      }
    }
  }
}

}  // namespace
}  // namespace test_regions
