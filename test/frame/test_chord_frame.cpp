// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Chord shapes in double against exact ones within their certified error bounds, and the shapes of degenerate ends,
// arcs, lines and jets, which are known in closed form.

#include "cases.h"
#include "chord_invariants.h"
#include "random_spirals.h"

#include <CGAL/Bounding_arcs_2/frame/accurate_shape.h>
#include <CGAL/Bounding_arcs_2/region/Bilens.h>
#include <CGAL/Bounding_arcs_2/region/Spiral_fat_arc.h>

#include <CGAL/CORE_Expr.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <utility>

namespace test_chord_frame {
namespace {

using namespace CGAL::Bounding_arcs;
using namespace bounding_arcs_test;
using Expr = CORE::Expr;

constexpr int DEEPEST = 45;  // halvings: pieces down to 2^-45 of a spiral segment

// The relative errors of one member over many pieces.
class Relative_errors {
 public:
  void add(double found, const Exact& wanted) {
    if (wanted != 0) errors_.push_back(CGAL::to_double(Exact(abs(Exact(found) - wanted) / abs(wanted))));
  }
  double quantile(double fraction) {
    const auto at = errors_.begin() + static_cast<std::ptrdiff_t>(fraction * double(errors_.size() - 1));
    std::nth_element(errors_.begin(), at, errors_.end());
    return *at;
  }

 private:
  std::vector<double> errors_;
};

TEST(ChordShape, LiesWithinItsOwnErrorBoundOfTheExactOne) {
  constexpr unsigned SEED = 101;
  Relative_errors change, kneser0, kneser1;
  for (const Piece& p : random_pieces(SEED, static_cast<std::size_t>(cases(3000)), DEEPEST)) {
    SCOPED_TRACE(text(p) + ", seed 101");
    const Chord_shape_2<Exact> e = p.spiral.shape<Exact>(p.t0, p.t1);
    const auto d = p.spiral.shape<double>(p.t0, p.t1);
    const auto b = p.spiral.shape<Bounded_double>(p.t0, p.t1);
    const auto expect_within = [](double found, const Bounded_double& bounded, const Exact& wanted) {
      EXPECT_EQ(found, bounded.value());
      EXPECT_LE(Exact(abs(Exact(found) - wanted)), Exact(bounded.error_bound()));
    };
    const auto found = members(d);
    const auto bounded = members(b);
    const auto wanted = members(e);
    for (std::size_t i = 0; i < wanted.size(); ++i) expect_within(found[i], bounded[i], wanted[i]);
    change.add(d.cross_change, e.cross_change);
    kneser0.add(d.kneser0, e.kneser0);
    kneser1.add(d.kneser1, e.kneser1);
    if (testing::Test::HasFailure()) return;
  }
  // Cancellation would show here: a difference formed plainly loses half of its digits on the median piece.
  for (Relative_errors* errors : {&change, &kneser0, &kneser1}) {
    EXPECT_LT(errors->quantile(0.5), 4e-15);
    EXPECT_LT(errors->quantile(0.99), 1e-12);
  }
}

TEST(ChordShape, IsTheSameFromJetsAndFromTaylorCoefficients) {
  constexpr unsigned SEED = 103;
  for (const Piece& p : random_pieces(SEED, 300, 20)) {
    SCOPED_TRACE(text(p) + ", seed 103");
    const auto piece = p.spiral.exact_curve().subcurve(Exact(p.t0), Exact(p.t1));
    const auto jets = chord_frame(end_jet(piece, true), end_jet(piece, false)).shape;
    const auto shape = p.spiral.shape<Exact>(p.t0, p.t1);
    EXPECT_EQ(invariants(shape), invariants(jets));
    EXPECT_EQ(shape.unit * shape.chord, jets.chord);
    EXPECT_TRUE(cross(shape.tangent0, jets.tangent0) == 0 && dot(shape.tangent0, jets.tangent0) > 0);
    EXPECT_TRUE(cross(shape.tangent1, jets.tangent1) == 0 && dot(shape.tangent1, jets.tangent1) > 0);
    EXPECT_EQ(shape.proper, jets.proper);
    EXPECT_EQ(shape.tight_first, jets.tight_first);
  }
}

TEST(ChordShape, ScalesThicknessByExactPowersOfTwo) {
  constexpr unsigned SEED = 104;
  for (const Piece& p : random_pieces(SEED, 500, 20)) {
    for (const int k : {-700, -30, 1, 40, 900}) {
      SCOPED_TRACE(text(p) + ", seed 104, scaled by 2^" + std::to_string(k));
      std::vector<Point> points = p.spiral.curve().control_points();
      for (Point& q : points) q = std::ldexp(1.0, k) * q;
      const Bezier curve(points, p.spiral.curve().weights());
      const auto table = std::make_shared<const Tabulated_bezier<double>>(curve);
      const double first = p.spiral.first(), last = p.spiral.last();
      const Spiral scaled(table, first, last, p.spiral.orders(first, last), false);
      const auto shape = p.spiral.shape<double>(p.t0, p.t1), grown = scaled.shape<double>(p.t0, p.t1);
      EXPECT_EQ(Bca::thickness(grown), std::ldexp(Bca::thickness(shape), k));
      EXPECT_EQ(Spiral_fat_arc::thickness(grown), std::ldexp(Spiral_fat_arc::thickness(shape), k));
      EXPECT_EQ(Bilens::thickness(grown), std::ldexp(Bilens::thickness(shape), k));
    }
  }
}

// A piece so short that products of its vectors would be no doubles: another unit changes nothing else.
TEST(ChordShape, IsTheSameInAUnitNearItsSize) {
  const Spiral spiral = spiral_segments(Bezier({{0, 0}, {0.5, 0}, {1, 1}})).front();
  const Chord_shape_2<Exact> shape = spiral.shape<Exact>(0, 0x1p-200, {true, true}), other = in_range(shape);
  EXPECT_EQ(other.chord.x, 1);
  EXPECT_EQ(Exact(other.unit * other.chord.x), Exact(shape.unit * shape.chord.x));
  EXPECT_EQ(invariants(other), invariants(shape));
  const Exact scale = other.unit / shape.unit, square = scale * scale, fourth = square * square;
  EXPECT_EQ(Exact(square * other.cross_change), shape.cross_change);
  EXPECT_EQ(Exact(fourth * other.square_change), shape.square_change);
  EXPECT_EQ(Exact(fourth * other.sine_change), shape.sine_change);
  EXPECT_EQ(scale * other.tangent_change, shape.tangent_change);
  ASSERT_EQ(other.control_points.size(), 3u);
  for (std::size_t i = 0; i < 3; ++i) {
    const Xy<Exact> is = other.unit * other.control_points[i], expected = shape.unit * shape.control_points[i];
    EXPECT_EQ(is, expected) << i;
  }
}

// No number and no vector of a shape may have lost its digits.
TEST(ChordShape, IsAccurateWhereAllOfItIs) {
  using Shape = Chord_shape_2<Double_double>;
  const Spiral spiral = spiral_segments(Bezier({{0, 0}, {0.5, 0}, {1, 1}})).front();
  const Shape shape = spiral.shape<Double_double>(0.25, 0.5);
  ASSERT_TRUE(is_accurate(shape, true) && is_accurate(shape, false));
  const auto spoil = [](Double_double& x) { x.err = std::fabs(x.hi) * 0x1p-50; };
  for (const auto member : {&Shape::cross0, &Shape::cross1, &Shape::square_change, &Shape::sine_change, &Shape::unit}) {
    Shape other = shape;
    spoil(other.*member);
    EXPECT_FALSE(is_accurate(other, true) || is_accurate(other, false));
  }
  for (const auto member : {&Shape::curvature0, &Shape::curvature1, &Shape::kneser0, &Shape::kneser1}) {
    Shape other = shape;
    spoil(other.*member);
    EXPECT_FALSE(is_accurate(other, true));
    EXPECT_TRUE(is_accurate(other, false));
  }
  for (const auto member : {&Shape::chord, &Shape::tangent0, &Shape::tangent1, &Shape::tangent_change}) {
    Shape other = shape;
    Xy<Double_double>& v = other.*member;
    spoil(std::fabs(v.x.hi) > std::fabs(v.y.hi) ? v.x : v.y);
    EXPECT_FALSE(is_accurate(other, true) || is_accurate(other, false));
  }
}

template <class NT> Chord_shape_2<NT> whole(const std::vector<Xy<NT>>& points, const std::vector<NT>& weights = {}) {
  const auto spirals = spiral_segments(Bezier_curve_2<NT>(points, weights));
  EXPECT_EQ(spirals.size(), 1u);
  return spirals.front().template shape<NT>(0, 1);
}

// The same shape run through backwards: what was at the start is at the end.
void expect_reversed(const Chord_shape_2<Exact>& forth, const Chord_shape_2<Exact>& back) {
  const Invariants f = invariants(forth), b = invariants(back);
  for (const auto& [start, end] :
       {std::pair(SINE0, SINE1), std::pair(CURVATURE0, CURVATURE1), std::pair(KNESER0, KNESER1)}) {
    const int sign = start == KNESER0 ? 1 : -1;  // a difference of two that change sign, taken the other way round
    EXPECT_EQ(f[start], sign * b[end]);
    EXPECT_EQ(f[end], sign * b[start]);
  }
  EXPECT_EQ(forth.infinite0, back.infinite1);
  EXPECT_EQ(forth.infinite1, back.infinite0);
  EXPECT_EQ(forth.proper, back.proper);
  EXPECT_NE(forth.tight_first, back.tight_first);
}

template <class NT> std::vector<Xy<NT>> reversed(std::vector<Xy<NT>> points) {
  return {points.rbegin(), points.rend()};
}

TEST(ChordShape, KnowsInfiniteCurvatureWhereHandlesAreZero) {
  const Exact third = Exact(1) / 3, quarter = Exact(1) / 4;
  const std::vector<Xy<Exact>> semicubical{{0, 0}, {0, 0}, {third, 0}, {1, 1}};        // (t^2, t^3)
  const std::vector<Xy<Exact>> quartic{{0, 0}, {0, 0}, {0, 0}, {quarter, 0}, {1, 1}};  // (t^3, t^4)
  for (const auto& points : {semicubical, quartic}) {
    const auto shape = whole(points);
    EXPECT_TRUE(shape.infinite0 && !shape.infinite1);
    EXPECT_TRUE(shape.proper && shape.tight_first);
    EXPECT_EQ(shape.turn, 1);
    EXPECT_TRUE(shape.tangent0.x > 0 && shape.tangent0.y == 0);
    EXPECT_EQ(shape.unit * shape.chord, (Xy<Exact>{1, 1}));
    expect_reversed(shape, whole(reversed(points)));
  }
}

TEST(ChordShape, KnowsFiniteCurvatureWhereHandlesAreZero) {
  const Exact sixth = Exact(1) / 6, half = Exact(1) / 2, twentieth = Exact(1) / 20, fifth = Exact(1) / 5;
  const auto parabola = whole<Exact>({{0, 0}, {half, 0}, {1, 1}});
  const std::vector<Xy<Exact>> square{{0, 0}, {0, 0}, {sixth, 0}, {half, 0}, {1, 1}};  // (t^2, t^4)
  const std::vector<Xy<Exact>> cube{{0, 0},     {0, 0},    {0, 0}, {twentieth, 0},
                                    {fifth, 0}, {half, 0}, {1, 1}};  // (t^3, t^6)
  for (const auto& points : {square, cube}) {
    const auto shape = whole(points);
    EXPECT_FALSE(shape.infinite0 || shape.infinite1);
    EXPECT_EQ(invariants(shape), invariants(parabola));
    expect_reversed(shape, whole(reversed(points)));
  }
}

// Next to where three control points are one, vectors are too short for products of six: the shape has another unit.
TEST(ChordShape, KeepsItsDigitsInDoubleWhereVectorsAreTiny) {
  const std::vector<Point> cube{{0, 0}, {0, 0}, {0, 0}, {1, 0}, {4, 0}, {10, 0}, {20, 20}};  // 20 (t^3, t^6)
  for (const bool is_reversed : {false, true}) {
    const auto spirals = spiral_segments(Bezier(is_reversed ? reversed(cube) : cube));
    ASSERT_EQ(spirals.size(), 1u);
    for (const int depth : {10, 30, 36, 45}) {
      const double length = std::ldexp(1.0, -depth), t0 = is_reversed ? 1 - length : 0, t1 = t0 + length;
      const Invariants wanted = invariants(spirals[0].shape<Exact>(t0, t1)),
                       found = invariants(spirals[0].accurate_shape(t0, t1).over<Exact>());
      for (std::size_t i = 0; i < wanted.size(); ++i)
        EXPECT_LE(abs(Exact(found[i] - wanted[i])), abs(wanted[i]) * Exact(0x1p-45)) << i << ", depth " << depth;
    }
  }
}

// Weights that are a geometric sequence change the parameter and not the curve.
TEST(ChordShape, DoesNotDependOnTheParameterOfARationalCurve) {
  const Exact third = Exact(1) / 3, sixth = Exact(1) / 6, half = Exact(1) / 2;
  const std::vector<std::vector<Xy<Exact>>> curves{{{0, 0}, {0, 0}, {third, 0}, {1, 1}},
                                                   {{0, 0}, {third, 0}, {2 * third, third}, {1, Exact(5) / 6}},
                                                   {{0, 0}, {0, 0}, {sixth, 0}, {half, 0}, {1, 1}}};
  for (const auto& points : curves) {
    for (const auto& p : {points, reversed(points)}) {
      std::vector<Exact> weights{5};
      while (weights.size() < p.size()) weights.push_back(Exact(weights.back() * 3 / 7));
      const auto shape = whole(p), rational = whole(p, weights);
      EXPECT_EQ(invariants(rational), invariants(shape));
      EXPECT_TRUE(rational.infinite0 == shape.infinite0 && rational.infinite1 == shape.infinite1);
    }
  }
}

// Only the ratios of weights matter, also where products of two leave the range of double.
TEST(ChordShape, DoesNotDependOnTheUnitOfWeights) {
  for (const int k : {-900, -100, 100, 900}) {
    std::vector<double> weights{1, 3, 0.5, 2};
    const std::vector<Point> points{{0, 0}, {1, 0}, {2, 1}, {2, 3}};
    const Bezier curve(points, weights);
    for (double& w : weights) w = std::ldexp(w, k);
    const Bezier scaled(points, weights);
    const auto thickness = [](const Bezier& c) {
      return Bilens::thickness(bezier_chord_shape(Taylor_table<double>(c, length_unit(c)), 0.25, 0.5, Shape_parts()));
    };
    EXPECT_EQ(thickness(scaled), thickness(curve)) << k;
  }
}

TEST(ChordShape, GivesCircularArcsTheThicknessZero) {
  const Exact c = Exact(4) / 5, s = Exact(3) / 5;
  for (const auto& spiral : spiral_segments(Bezier_curve_2<Exact>({{c, -s}, {1 / c, 0}, {c, s}}, {1, c, 1}))) {
    const auto shape = spiral.shape<Exact>(spiral.first(), spiral.last());
    EXPECT_FALSE(shape.proper);
    EXPECT_EQ(shape.turn, 1);
    EXPECT_TRUE(shape.kneser0 == 0 && shape.kneser1 == 0);
    const auto expression = shape.over<Expr>();
    EXPECT_EQ(Bca::thickness(expression), Expr(0));
    EXPECT_EQ(Spiral_fat_arc::thickness(expression), Expr(0));
    EXPECT_EQ(Bilens::thickness(expression), Expr(0));
  }
}

TEST(ChordShape, GivesStraightSegmentsTheThicknessZero) {
  const std::vector<Bezier> lines{Bezier({{0, 0}, {3, 1}}),
                                  Bezier({{0.1, 0.1}, {0.2, 0.2}, {0.7, 0.7}, {5.3, 5.3}}),
                                  Bezier({{0, 0}, {0, 0}, {1, 3}, {1, 3}}),
                                  Bezier({{0, 0}, {1, 3}, {4, 12}}, {1, 0.3, 5}),
                                  Bezier({{0, 0}, {2, 6}, {1, 3}}),
                                  Bezier({{2, 2}, {2, 2}, {2, 2}})};
  for (const Bezier& line : lines) {
    for (const Spiral& spiral : spiral_segments(line)) {
      const auto shape = spiral.shape<double>(spiral.first(), spiral.last());
      EXPECT_FALSE(shape.proper);
      EXPECT_EQ(shape.turn, 0);
      EXPECT_EQ(Bca::thickness(shape), 0);
      EXPECT_EQ(Spiral_fat_arc::thickness(shape), 0);
      EXPECT_EQ(Bilens::thickness(shape), 0);
      EXPECT_EQ(Bca::thickness(spiral.shape<Bounded_double>(spiral.first(), spiral.last())).upper(), 0);
    }
  }
}

}  // namespace
}  // namespace test_chord_frame
