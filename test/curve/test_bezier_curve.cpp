// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Bezier curves against their definition, split, cut and reversed, their error bound in double, and derivatives.

#include <CGAL/Bounding_arcs_2/curve/Bezier_curve_2.h>

#include <CGAL/Exact_rational.h>

#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <stdexcept>
#include <vector>

namespace test_bezier_curve {
namespace {

using namespace CGAL::Bounding_arcs;
using Exact = CGAL::Exact_rational;

constexpr unsigned SEED = 20261121;

Bezier_curve_2<Exact> random_curve(std::mt19937& random, int degree, bool rational) {
  std::uniform_int_distribution<int> coordinate(-50, 50), weight(1, 9);
  std::vector<Xy<Exact>> points;
  std::vector<Exact> weights;
  for (int i = 0; i <= degree; ++i) {
    points.push_back({Exact(coordinate(random)), Exact(coordinate(random))});
    if (rational) weights.push_back(Exact(weight(random)));
  }
  return Bezier_curve_2<Exact>(points, weights);
}

// sum w_i P_i B_i / sum w_i B_i by the definition
Xy<Exact> by_definition(const Bezier_curve_2<Exact>& curve, const Exact& t) {
  Xy<Exact> sum;
  Exact weight(0), binomial(1);
  const int n = curve.degree();
  for (int i = 0; i <= n; ++i) {
    Exact b = binomial * curve.weight(i);
    for (int k = 0; k < i; ++k) b *= t;
    for (int k = i; k < n; ++k) b *= Exact(1) - t;
    sum = sum + b * curve.control_points()[static_cast<std::size_t>(i)];
    weight += b;
    binomial = binomial * (n - i) / (i + 1);
  }
  return {Exact(sum.x / weight), Exact(sum.y / weight)};
}

TEST(BezierCurve, EqualsItsDefinitionAtAnyDegree) {
  std::mt19937 random(SEED);
  for (int degree = 1; degree <= 16; ++degree)
    for (const bool rational : {false, true}) {
      const auto curve = random_curve(random, degree, rational);
      for (int k = 0; k <= 7; ++k) EXPECT_EQ(curve.point(Exact(k) / 7), by_definition(curve, Exact(k) / 7)) << degree;
    }
}

TEST(BezierCurve, KeepsItsPointsWhenSplitCutAndReversed) {
  std::mt19937 random(SEED);
  for (int degree = 1; degree <= 9; ++degree)
    for (const bool rational : {false, true}) {
      const auto curve = random_curve(random, degree, rational);
      const Exact a = Exact(2) / 7, b = Exact(5) / 6;
      const auto [left, right] = curve.split(a);
      const auto cut = curve.subcurve(a, b);
      for (int k = 0; k <= 4; ++k) {
        const Exact s = Exact(k) / 4;
        EXPECT_EQ(left.point(s), curve.point(Exact(a * s)));
        EXPECT_EQ(right.point(s), curve.point(Exact(a + (1 - a) * s)));
        if (!rational) {
          EXPECT_EQ(cut.point(s), curve.point(Exact(a + (b - a) * s)));
        }
        EXPECT_EQ(curve.reversed().point(s), curve.point(Exact(1 - s)));
      }
      EXPECT_EQ(cut.control_points().front(), curve.point(a));
      EXPECT_EQ(cut.control_points().back(), curve.point(b));
    }
}

TEST(BezierCurve, StaysWithinItsErrorBoundInDouble) {
  std::mt19937 random(SEED);
  std::uniform_real_distribution<double> coordinate(-1, 1), parameter(0, 1);
  for (int i = 0; i < 3000; ++i) {
    const int degree = 1 + i % 15;
    std::vector<Xy<double>> points;
    std::vector<Xy<Exact>> exact;
    for (int k = 0; k <= degree; ++k) {
      points.push_back({coordinate(random), coordinate(random)});
      exact.push_back({Exact(points.back().x), Exact(points.back().y)});
    }
    const double t = parameter(random);
    const auto p = Bezier_curve_2<double>(points).point(t);
    const auto q = Bezier_curve_2<Exact>(exact).point(Exact(t));
    const double bound = 3 * degree * 0x1p-53;
    EXPECT_LE(std::fabs(CGAL::to_double(Exact(Exact(p.x) - q.x))), bound) << degree << ' ' << t;
    EXPECT_LE(std::fabs(CGAL::to_double(Exact(Exact(p.y) - q.y))), bound) << degree << ' ' << t;
  }
}

TEST(BezierCurve, RefusesWrongCountsAndWeights) {
  using Curve = Bezier_curve_2<double>;
  EXPECT_THROW(Curve({{0, 0}}), std::invalid_argument);
  EXPECT_THROW(Curve({{0, 0}, {1, 1}}, {1}), std::invalid_argument);
  EXPECT_THROW(Curve({{0, 0}, {1, 1}}, {1, 0}), std::invalid_argument);
  EXPECT_THROW(Curve({{0, 0}, {1, 1}}, {1, std::nan("")}), std::invalid_argument);
}

TEST(Derivatives, EqualDifferenceQuotientsOfTheirAntiderivatives) {
  // Taylor's theorem, exactly: C(t + h) = sum c_k h^k for polynomials of degree up to the order
  std::mt19937 random(SEED);
  for (int degree = 1; degree <= 9; ++degree) {
    const auto curve = random_curve(random, degree, false);
    const Exact t = Exact(3) / 8, h = Exact(1) / 5;
    Xy<Exact> sum;
    Exact power(1);
    for (const Xy<Exact>& c : curve.taylor_expansion(t, degree)) {
      sum = sum + power * c;
      power *= h;
    }
    EXPECT_EQ(sum, curve.point(Exact(t + h))) << degree;
  }
}

TEST(Derivatives, OfRationalCurvesObeyTheProductRule) {
  // (w C)^(k) = sum binomial(k, j) w^(j) C^(k-j): compared as Taylor coefficients of numerator and weight
  std::mt19937 random(SEED);
  for (int degree = 1; degree <= 6; ++degree) {
    const auto curve = random_curve(random, degree, true);
    const Exact t = Exact(3) / 8;
    std::vector<Xy<Exact>> numerator, weight;
    for (std::size_t i = 0; i < curve.weights().size(); ++i) {
      numerator.push_back(curve.weights()[i] * curve.control_points()[i]);
      weight.push_back({curve.weights()[i], Exact(0)});
    }
    const auto a = Bezier_curve_2<Exact>(numerator).taylor_expansion(t, 5),
               w = Bezier_curve_2<Exact>(weight).taylor_expansion(t, 5);
    const auto c = curve.taylor_expansion(t, 5);
    for (std::size_t k = 0; k <= 5; ++k) {
      Xy<Exact> sum;
      for (std::size_t j = 0; j <= k; ++j) sum = sum + w[j].x * c[k - j];
      EXPECT_EQ(sum, a[k]) << degree << ' ' << k;
    }
    EXPECT_EQ(curve.derivative(t, 3), Exact(6) * c[3]);
  }
}

TEST(EndJet, TakesTheOneSidedTangentWhereTheDerivativeVanishes) {
  // (t^2, t^3) about its cusp at t = 1/2 of a cubic run from -1 to 1: t = 2s - 1
  const Bezier_curve_2<Exact> cusp(
      {{Exact(1), Exact(-1)}, {Exact(-1) / 3, Exact(1)}, {Exact(-1) / 3, Exact(-1)}, {Exact(1), Exact(1)}});
  const Exact half = Exact(1) / 2;
  const auto before = cusp.end_jet(half, false), after = cusp.end_jet(half, true);
  ASSERT_TRUE(before && after);
  EXPECT_EQ(after->point, (Xy<Exact>{Exact(0), Exact(0)}));
  EXPECT_EQ(after->first, (Xy<Exact>{Exact(8), Exact(0)}));
  EXPECT_EQ(before->first, (Xy<Exact>{Exact(-8), Exact(0)}));
  // a zero-length handle, seen from its only side
  const Bezier_curve_2<Exact> handle(
      {{Exact(0), Exact(0)}, {Exact(0), Exact(0)}, {Exact(1), Exact(2)}, {Exact(3), Exact(0)}});
  EXPECT_EQ(cross(handle.end_jet(Exact(0), true)->first, Xy<Exact>{Exact(1), Exact(2)}), Exact(0));
  EXPECT_GT(handle.end_jet(Exact(0), true)->first.x, Exact(0));
  // an ordinary point, and a curve that is one point
  EXPECT_EQ(handle.end_jet(half, true)->first, handle.derivative(half, 1));
  EXPECT_EQ(handle.end_jet(half, true)->second, handle.derivative(half, 2));
  EXPECT_FALSE(Bezier_curve_2<Exact>({{Exact(1), Exact(1)}, {Exact(1), Exact(1)}}).end_jet(half, true));
}

}  // namespace
}  // namespace test_bezier_curve
