// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Local curves of cubics as the filter makes them against those from tables, what segments keep of them, and what
// bounds of rounding errors by ranges are held to.

#include "cases.h"
#include "random_spirals.h"

#include "../../../src/library/spiral/make_local_curve.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <random>
#include <type_traits>
#include <vector>

namespace test_local_curve {
namespace {

using namespace bounding_arcs_test;
using namespace CGAL::Bounding_arcs;

constexpr unsigned SEED = 1304;
const int COUNT = cases(5000);

// Cubics from round to flat ones, of several sizes, some with integer coordinates.
Bezier random_cubic(std::mt19937& random, int i) {
  std::uniform_real_distribution<double> uniform(-1, 1);
  const double flat = std::ldexp(1.0, -(i % 5) * 5), size = std::ldexp(1.0, (i % 7 - 3) * 30), angle = uniform(random);
  std::vector<Point> p;
  for (int k = 0; k < 4; ++k) {
    const double x = uniform(random), y = flat * uniform(random);
    Point q{size * (std::cos(angle) * x - std::sin(angle) * y), size * (std::sin(angle) * x + std::cos(angle) * y)};
    if (i % 3 == 0) q = {size * std::floor(8 * x), size * std::floor(8 * y)};
    p.push_back(q);
  }
  return Bezier(p);
}

template <class Check> void for_segments(Check check) {
  std::mt19937 random(SEED);
  for (int i = 0; i < COUNT; ++i) {
    const Tabulated_bezier<double> curve(random_cubic(random, i));
    double first = 0;
    const Spiral_parameters cuts = spiral_parameters(curve.curve());
    if (cuts.is_straight) continue;
    auto ends = cuts.breaks;
    ends.push_back(1);
    for (const double last : ends) {
      check(curve, first, last);
      first = last;
    }
  }
}

// Those that the curve's kind has.
std::vector<double> numbers(const Local_curve& curve) {
  const auto& c = curve.form.coefficients;
  std::vector<double> r{curve.middle, curve.half, curve.direction, curve.form.unit};
  const int degree = degree_of_kind(curve.kind);
  for (int k = 1; k <= degree; ++k) r.insert(r.end(), {c.x[k], c.y[k]});
  if (is_rational_kind(curve.kind)) r.insert(r.end(), c.w, c.w + degree + 1);
  if (curve.kind == 3) {
    r.insert(r.end(), c.across, c.across + 4);
    r.insert(r.end(), c.change, c.change + 2);
  }
  return r;
}
std::vector<double> bounds(const Local_curve& curve) {
  const Local_form<double>& f = curve.form;
  return {f.numerator_error, f.least_dot, f.least_square, f.kneser_error, f.turn_rate_error, f.least_tangent};
}

TEST(LocalCurve, OfACubicIsThatFromItsTable) {
  int equal = 0, served = 0, all = 0;
  for_segments([&](const Tabulated_bezier<double>& curve, double first, double last) {
    const Local_curve plain = internal::make_local_curve(curve.table<Double_double>(), first, last),
                      fast = Cubic_local_curves(curve.curve(), curve.unit())(first, last);
    ++all;
    if (plain.kind == 0 || fast.kind == 0) return;
    ++served;
    const std::vector<double> a = numbers(fast), b = numbers(plain);
    equal += a == b;
    // half-way between doubles, as on grids, both are nearest
    for (std::size_t i = 0; i < a.size(); ++i) EXPECT_LE(std::fabs(a[i] - b[i]), 0x1p-52 * std::fabs(b[i])) << i;
    for (std::size_t i = 0; i < bounds(fast).size(); ++i) EXPECT_LE(bounds(fast)[i], 1.01 * bounds(plain)[i]) << i;
  });
  EXPECT_GT(equal, 0.95 * served);
  EXPECT_GT(served, 0.9 * all);
}

TEST(LocalCurve, ExpandsACubicWithinTheErrorsKnownAhead) {
  constexpr internal::Cubic_expansion_errors ERRORS;
  using Terms = internal::Cubic_terms<Pair>;
  std::mt19937 random(SEED);
  std::uniform_real_distribution<double> uniform(-1, 1);
  for (int i = 0; i < COUNT; ++i) {
    double d[2][3];
    for (auto& row : d)
      for (double& x : row) x = i % 3 == 0 ? std::floor(8 * uniform(random)) / 8 : uniform(random);
    const auto axis = [&](int j) { return Terms::axis(Pair{d[j][0], 0}, Pair{d[j][1], 0}, Pair{d[j][2], 0}); };
    const double t = std::fabs(uniform(random));
    const auto c = Terms(axis(0), axis(1)).expand(t);
    Exact taylor[2][4];
    for (int j = 0; j < 2; ++j) {
      const Exact a = d[j][0], b = Exact(d[j][1]) - a, e = Exact(d[j][2]) - Exact(d[j][1]) - b;
      taylor[j][1] = 3 * (a + Exact(t) * (2 * b + Exact(t) * e));
      taylor[j][2] = 3 * (b + Exact(t) * e);
      taylor[j][3] = e;
    }
    const auto expect_near = [](const Pair& z, const Exact& exact, double error) {
      EXPECT_LE(CGAL::abs(Exact(Exact(z.hi) + Exact(z.lo) - exact)), Exact(error));
    };
    for (int k = 1; k <= 3; ++k) {
      expect_near(c.x[k], taylor[0][k], ERRORS.coordinate);
      expect_near(c.y[k], taylor[1][k], ERRORS.coordinate);
    }
    const auto cross_of = [&](int k, int m) {
      return Exact(taylor[0][k] * taylor[1][m] - taylor[1][k] * taylor[0][m]);
    };
    const Exact products[] = {2 * cross_of(1, 2),  6 * cross_of(1, 3),  6 * cross_of(2, 3),
                              -2 * cross_of(2, 3), -2 * cross_of(1, 3), -4 * cross_of(2, 3)};
    for (int k = 0; k < 6; ++k) expect_near(k < 4 ? c.across[k] : c.change[k - 4], products[k], ERRORS.product);
  }
}

// Quotients of polynomials over ranges of both arguments, in double and in float.
TEST(RangedMagnitude, BoundsValuesAndTheirErrors) {
  const auto formula = [](const auto& x, const auto& y) {
    using NT = std::decay_t<decltype(x)>;
    const NT weight = NT(1.25) + x * (NT(0.5) - x * y), even = x * x - y;
    return NT((even * (x - NT(3) * y) + NT(0.75)) * inverse_of(weight) - y * y * y);
  };
  std::mt19937 random(SEED);
  std::uniform_real_distribution<double> uniform(-1, 1);
  double most_used = 0;
  for (int i = 0; i < COUNT; ++i) {
    const double mx = uniform(random), my = uniform(random), r = std::exp2(-1 - 20 * std::fabs(uniform(random)));
    const Ranged_magnitude bounds = formula(Ranged_magnitude(mx, r, 0), Ranged_magnitude(my, r, 0));
    if (!(bounds.size < 0x1p50)) continue;
    for (int k = 0; k < 4; ++k) {
      const auto x = static_cast<float>(mx + 0.99 * r * uniform(random)),
                 y = static_cast<float>(my + 0.99 * r * uniform(random));
      if (std::fabs(x - mx) > r || std::fabs(y - my) > r) continue;
      const Exact exact = formula(Exact(x), Exact(y));
      const auto error = [&](double value) { return CGAL::to_double(CGAL::abs(Exact(Exact(value) - exact))); };
      const double in_double = error(formula(double(x), double(y))), in_float = error(formula(x, y));
      EXPECT_LE(CGAL::to_double(CGAL::abs(Exact(exact - Exact(bounds.middle)))), bounds.radius * (1 + 1e-9) + 1e-14);
      EXPECT_LE(in_double, bounds.bound());
      EXPECT_LE(in_float, bounds.half_ulps * Ranged_magnitude::LARGEST_HALF_ULP);
      most_used = std::max(most_used, in_double / bounds.bound());
    }
  }
  EXPECT_GT(most_used, 0.1);
}

TEST(AccuratePoint, IsTheNearestOfRationalCurves) {
  std::mt19937 random(SEED);
  std::uniform_real_distribution<double> uniform(0, 1);
  for (int i = 0; i < 500; ++i) {
    const Tabulated_bezier<double> curve(random_curve(random, 2 + i % 4, true));
    const double t = uniform(random);
    const Point p = curve.end_point(t);
    const auto exact = curve.exact_curve().point(Exact(t));
    const auto expect_near = [&](double x, const Exact& e) {
      const double half_ulp = std::ldexp(1.0, std::ilogb(x) - 53);
      EXPECT_LE(CGAL::to_double(CGAL::abs(Exact(Exact(x) - e))), half_ulp * (1 + 0x1p-20) + 0x1p-80);
    };
    expect_near(p.x, exact.x);
    expect_near(p.y, exact.y);
  }
}

TEST(LocalCurve, IsKeptBySegmentsInLittleRoom) {
  EXPECT_LE(sizeof(Spiral), 256u);
  std::mt19937 random(SEED);
  for (const bool is_rational : {false, true})
    for (int degree = 2; degree <= (is_rational ? MAX_RATIONAL_DEGREE : MAX_LOCAL_DEGREE); ++degree)
      for (int i = 0; i < 20; ++i)
        for (const Spiral& s : spiral_segments(random_curve(random, degree, is_rational))) {
          const Local_curve made = internal::make_local_curve(s.table<Double_double>(), s.first(), s.last()),
                            kept = Spiral(s).local_curve();
          if (is_rational && made.kind == 0) continue;  // weights that change too much
          ASSERT_EQ(kept.kind, curve_kind(degree, is_rational));
          EXPECT_EQ(numbers(kept), numbers(made));
          EXPECT_EQ(kept.fits_float, made.fits_float);
          // what is above has the digits that formulas count on
          EXPECT_GE(kept.form.least_turn_rate, Local_precision<double>::TURN_RATE_DIGITS * kept.form.turn_rate_error);
          if (kept.kind != 3) {
            EXPECT_EQ(bounds(kept), bounds(made));
          }
        }
}

}  // namespace
}  // namespace test_local_curve
