// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Cutting curves into spiral segments: closed forms, degenerate curves, cuts that nearly coincide, and an independent
// exact oracle that counts the distinct roots in each break's rounding interval by Sturm sequences in the power basis.

#include "../support/Sturm.h"
#include "../support/cases.h"

#include <CGAL/Bounding_arcs_2/curve/served_range.h>
#include <CGAL/Bounding_arcs_2/spiral/spiral_parameters.h>

#include <CGAL/CORE_Expr.h>
#include <CGAL/Exact_rational.h>
#include <CGAL/Gmpq.h>
#include <CGAL/Lazy_exact_nt.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <random>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace test_spiral_parameters {
namespace {

using namespace CGAL::Bounding_arcs;
using namespace bounding_arcs_test;
using Doubles = internal::Short_list<double>;

constexpr double CUT_WIDTH = 0x1p-51;

constexpr int ROUNDS = bounding_arcs_test::FEW_CASES ? 1 : 20;

template <class NT = double> Bezier_curve_2<NT> curve(const Doubles& x, const Doubles& y, const Doubles& w = {}) {
  std::vector<Xy<NT>> p;
  for (std::size_t i = 0; i < x.size(); ++i) p.push_back({NT(x[i]), NT(y[i])});
  return Bezier_curve_2<NT>(p, std::vector<NT>(w.begin(), w.end()));
}

struct Range {
  Rational low, high;
};
Range rounding_interval(double t) {
  return {(Rational(std::nextafter(t, 0.0)) + Rational(t)) / 2, (Rational(std::nextafter(t, 1.0)) + Rational(t)) / 2};
}

// The ranges in [0,1] where a root may be without a break of its own, disjoint and in order: a root and the break that
// stands for it are rounded by 2^-54 each.
std::vector<Range> merging_ranges(const Doubles& breaks) {
  const Rational width = Rational(CUT_WIDTH) + Rational(0x1p-53);
  std::vector<Range> ranges{{0, width}};
  const auto append = [&](const Rational& low, const Rational& high) {
    if (low <= ranges.back().high) ranges.back().high = high;
    else ranges.push_back({low, high});
  };
  for (const double t : breaks) append(Rational(t) - width, Rational(t) + width);
  append(1 - width, 1);
  return ranges;
}

void expect_separated(const Doubles& breaks) {
  double last = 0;
  for (const double t : breaks) {
    EXPECT_GT(t - last, CUT_WIDTH) << "before break " << t;
    last = t;
  }
  EXPECT_GT(1 - last, CUT_WIDTH);
}

// Every break has a root in its rounding interval, no root lies farther than merging allows from all of them, and no
// two of them are as near as that.
template <class NT> void expect_every_root_cut(const Bezier_curve_2<NT>& c) {
  const Spiral_parameters s = spiral_parameters(c);
  expect_separated(s.breaks);
  std::vector<int> hits(s.breaks.size(), 0);
  const std::array<Powers, 4> all = numerators(c);
  for (std::size_t k = 0; k < all.size(); ++k) {
    if (all[k].empty()) continue;
    const Sturm sturm(all[k]);
    for (std::size_t i = 0; i < s.breaks.size(); ++i) {
      const Range r = rounding_interval(s.breaks[i]);
      hits[i] += sturm.roots(r.low, r.high);
    }
    int found = 0;
    for (const Range& r : merging_ranges(s.breaks)) found += sturm.roots(r.low, r.high);
    EXPECT_EQ(found, sturm.roots(0, 1)) << "numerator " << k;
  }
  for (std::size_t i = 0; i < hits.size(); ++i) EXPECT_GT(hits[i], 0) << "no root near break " << s.breaks[i];
  EXPECT_EQ(s.reasons.size(), s.breaks.size());
  EXPECT_EQ(s.is_straight, all[2].empty());
  EXPECT_EQ(s.is_circular, all[3].empty() && !all[2].empty());
}

bool contains(const Doubles& a, double t) { return std::find(a.begin(), a.end(), t) != a.end(); }

struct Family {
  int degree;
  bool is_rational;
  int grid = 64;  // coordinates are integers up to this size, before scaling; small ones make degenerate curves
  double scale = 1, offset = 0;
};

Bezier_curve_2<double> random_curve(std::mt19937& engine, const Family& f) {
  std::uniform_int_distribution<int> grid(-f.grid, f.grid), weight(1, std::max(1, f.grid / 2));
  Doubles x, y, w;
  for (int i = 0; i <= f.degree; ++i) {
    x.push_back(f.offset + f.scale * grid(engine));
    y.push_back(f.offset + f.scale * grid(engine));
    if (f.is_rational) w.push_back(weight(engine));
  }
  return curve(x, y, w);
}

TEST(SpiralParameters, CutsAtEveryRootOfACubicWithAnInflection) {
  const auto c = curve({0, 1, 2, 3}, {0, 1, -1, 0});
  const Doubles breaks = spiral_parameters(c).breaks;
  EXPECT_TRUE(contains(breaks, 0.5));
  EXPECT_TRUE(contains(breaks, 0.21132486540518711775));
  EXPECT_TRUE(contains(breaks, 0.78867513459481288225));
  expect_every_root_cut(c);
}

TEST(SpiralParameters, CountsARootSharedByTwoPolynomialsOnce) {
  EXPECT_EQ(spiral_parameters(curve({0, 1, 2}, {0, 2, 0})).breaks, Doubles({0.5}));
  EXPECT_EQ(spiral_parameters(curve({0, 1, 2}, {0, -1, 1})).breaks.front(), 1.0 / 3);
}

TEST(SpiralParameters, CutsALoop) {
  const auto c = curve({0, 2, -1, 1}, {0, 1, 1, 0});
  EXPECT_TRUE(contains(spiral_parameters(c).breaks, 0.5));
  expect_every_root_cut(c);
}

TEST(SpiralParameters, CutsACuspOnceAndCallsItSingular) {
  const Spiral_parameters dyadic = spiral_parameters(curve({0, 1, 0, 1}, {0, 1, 1, 0}));
  const auto at = std::find(dyadic.breaks.begin(), dyadic.breaks.end(), 0.5);
  ASSERT_NE(at, dyadic.breaks.end());
  EXPECT_EQ(dyadic.reasons[static_cast<std::size_t>(at - dyadic.breaks.begin())], Cut_reason::CUSP);
  // C' = (u^2, u) with u = 3 t - 1
  const Spiral_parameters third = spiral_parameters(curve({0, 1, -1, 3}, {0, -1, -0.5, 1.5}));
  EXPECT_EQ(third.breaks, Doubles({1.0 / 3}));
  EXPECT_EQ(third.reasons, internal::Short_list<Cut_reason>({Cut_reason::CUSP}));
}

TEST(SpiralParameters, CutsOnceAtAMultipleRootOfOneCoordinate) {
  for (const auto& c : {curve({0, 1, -1, 3}, {0, 1, 2, 3}), curve({0, -1, 1, -3, 5}, {0, 1, 2, 3, 4})}) {
    const Spiral_parameters s = spiral_parameters(c);
    const auto at = std::find(s.breaks.begin(), s.breaks.end(), 1.0 / 3);
    ASSERT_NE(at, s.breaks.end());
    EXPECT_NE(s.reasons[static_cast<std::size_t>(at - s.breaks.begin())], Cut_reason::CUSP);
    expect_every_root_cut(c);
  }
}

TEST(SpiralParameters, LeavesOutACurvatureExtremumAtAnEnd) {
  const Spiral_parameters s = spiral_parameters(curve({0, 1, 2}, {0, 0, 1}));
  EXPECT_TRUE(s.breaks.empty());
  EXPECT_FALSE(s.is_straight || s.is_circular || s.is_point);
  EXPECT_TRUE(spiral_parameters(curve({0, 1, 2}, {1, 0, 0})).breaks.empty());
}

TEST(SpiralParameters, KeepsRootsBesideAnEndThatVanishesByCancellation) {
  // Two legs are parallel, in numbers whose products doubles cannot hold: an inflection at t = 0.
  const double a = 1099511627791, b = 1099511627689;
  const auto c = curve({0, a, 3 * a, 3 * a - b, 4 * a - b}, {0, b, 3 * b, 3 * b + a, 4 * b + a});
  EXPECT_GT(spiral_parameters(c).breaks.size(), 1u);
  expect_every_root_cut(c);
  expect_every_root_cut(c.reversed());
}

TEST(SpiralParameters, LeavesStraightCurvesWhole) {
  for (const auto& c : {curve({0, 3}, {0, 1}), curve({0, 1, 1, 5}, {0, 1, 1, 5}), curve({7, 7, 7}, {0, 1, 3}),
                        curve({0, 1, 4}, {0, 3, 12}, {1, 2, 5})}) {
    const Spiral_parameters s = spiral_parameters(c);
    EXPECT_TRUE(s.breaks.empty());
    EXPECT_TRUE(s.is_straight);
    EXPECT_FALSE(s.is_circular || s.is_point);
  }
}

TEST(SpiralParameters, CutsAFoldedStraightCurveOnceAtASingularBreak) {
  for (const auto& c : {curve({0, 2, 1}, {5, 5, 5}), curve({5, 5, 5}, {0, 2, 1}), curve({0, 2, 1}, {0, 6, 3}),
                        curve({0, 2, 1}, {0, -6, -3}, {1, 1, 1})}) {
    const Spiral_parameters s = spiral_parameters(c);
    EXPECT_EQ(s.breaks, Doubles({2.0 / 3}));
    EXPECT_EQ(s.reasons, internal::Short_list<Cut_reason>({Cut_reason::CUSP}));
    EXPECT_TRUE(s.is_straight);
  }
}

TEST(SpiralParameters, KnowsAPoint) {
  for (const auto& c : {curve({3, 3, 3, 3}, {1, 1, 1, 1}), curve({3, 3, 3}, {1, 1, 1}, {1, 2, 3})}) {
    const Spiral_parameters s = spiral_parameters(c);
    EXPECT_TRUE(s.breaks.empty());
    EXPECT_TRUE(s.is_point && s.is_straight);
    EXPECT_FALSE(s.is_circular);
  }
  EXPECT_FALSE(spiral_parameters(curve({3, 3}, {1, 1.5})).is_point);
}

TEST(SpiralParameters, KnowsACircularArcOnlyWhenItIsExact) {
  const Rational c = Rational(4) / 5, s = Rational(3) / 5;
  const Bezier_curve_2<Rational> arc({{c, -s}, {1 / c, 0}, {c, s}}, {1, c, 1});
  const Spiral_parameters exact = spiral_parameters(arc);
  EXPECT_TRUE(exact.is_circular);
  EXPECT_EQ(exact.breaks, Doubles({0.5}));
  ASSERT_EQ(exact.reasons.size(), 1u);
  EXPECT_NE(exact.reasons[0], Cut_reason::CUSP);

  const auto rounded = curve({1, 1, 0}, {0, 1, 1}, {1, std::sqrt(0.5), 1});
  EXPECT_FALSE(spiral_parameters(rounded).is_circular);
  EXPECT_EQ(spiral_parameters(rounded).breaks, Doubles({0.5}));
  expect_every_root_cut(rounded);
}

// The curve over rationals with a given derivative, from the Bernstein coefficients of x' and y'.
Bezier_curve_2<Rational> curve_with_derivative(const Bernstein_polynomial<Rational>& dx,
                                               const Bernstein_polynomial<Rational>& dy) {
  std::vector<Xy<Rational>> p{{0, 0}};
  for (int i = 0; i <= dx.degree(); ++i) p.push_back({p.back().x + dx.coefficient(i), p.back().y + dy.coefficient(i)});
  return Bezier_curve_2<Rational>(std::move(p));
}
Bernstein_polynomial<Rational> vanishing_at(const Rational& t) {
  return Bernstein_polynomial<Rational>({Rational(-t), Rational(1 - t)});
}
// C' = (t - a, t - b): x' and y' vanish at a and b, curvature is greatest in the middle.
Doubles breaks_of_tight_turn(const Rational& a, const Rational& b) {
  return spiral_parameters(curve_with_derivative(vanishing_at(a), vanishing_at(b))).breaks;
}

TEST(SpiralParameters, MakesOneCutOfRootsWithinFourSpacings) {
  const double t = 0.625, next = t + CUT_WIDTH + 0x1p-53, far = t + 0x1p-40;
  EXPECT_EQ(breaks_of_tight_turn(t, t + 0x1p-53), Doubles({t}));
  EXPECT_EQ(breaks_of_tight_turn(t, t + CUT_WIDTH), Doubles({t}));
  EXPECT_EQ(breaks_of_tight_turn(t, next), Doubles({t, next}));
  EXPECT_EQ(breaks_of_tight_turn(t, far), Doubles({t, t + 0x1p-41, far}));
  EXPECT_EQ(breaks_of_tight_turn(far, t), Doubles({t, t + 0x1p-41, far}));
}

TEST(SpiralParameters, MakesNoCutWithinFourSpacingsOfAnEnd) {
  const double inside = CUT_WIDTH + 0x1p-53;
  EXPECT_EQ(breaks_of_tight_turn(0.25, 0x1p-52).front(), 0.125 + 0x1p-53);
  EXPECT_EQ(breaks_of_tight_turn(0.25, CUT_WIDTH).front(), 0.125 + 0x1p-52);
  EXPECT_EQ(breaks_of_tight_turn(0.25, inside).front(), inside);
  EXPECT_EQ(breaks_of_tight_turn(0.25, 1 - CUT_WIDTH).back(), 0.625 - 0x1p-52);
  EXPECT_EQ(breaks_of_tight_turn(0.25, 1 - inside).back(), 1 - inside);
}

TEST(SpiralParameters, PrefersTurnsOfACoordinateToEarlierRootsNearby) {
  // C' = (t - r, 1 + d (t - r)) with x' zero at r and curvature greatest at r - d
  const double r = 0.625, d = 0x1p-52;
  const Bernstein_polynomial<Rational> line({1 - Rational(d) * Rational(r), 1 + Rational(d) * (1 - Rational(r))});
  EXPECT_EQ(spiral_parameters(curve_with_derivative(vanishing_at(r), line)).breaks, Doubles({r}));
}

TEST(SpiralParameters, PrefersASingularRootToAnEarlierTurnNearby) {
  // C' = (t - r) (t - r + d, 1)
  const double r = 0.625, d = 0x1p-52;
  const Bernstein_polynomial<Rational> v = vanishing_at(r), one({1, 1});
  const Spiral_parameters s = spiral_parameters(curve_with_derivative(v * vanishing_at(r - d), v * one));
  EXPECT_EQ(s.breaks, Doubles({r}));
  EXPECT_EQ(s.reasons, internal::Short_list<Cut_reason>({Cut_reason::CUSP}));
}

// C' = (t - c) (a linear vector), rounded to double: the cusp is pulled apart into a tight turn.
Bezier_curve_2<double> rounded_cusp(double c, std::mt19937& engine) {
  std::uniform_real_distribution<double> random(-1, 1);
  std::array<Doubles, 2> xy;
  for (Doubles& x : xy) {
    const double a = random(engine), b = random(engine);
    x = {random(engine)};
    for (const double step : {-c * a, ((1 - c) * a - c * (a + b)) / 2, (1 - c) * (a + b)})
      x.push_back(x.back() + step / 3);
  }
  return curve(xy[0], xy[1]);
}

TEST(SpiralParameters, CutsARoundedCuspWithoutSlivers) {
  std::mt19937 engine(5);
  for (int round = 0; round < ROUNDS; ++round) {
    SCOPED_TRACE("seed 5, round " + std::to_string(round));
    const double at = std::uniform_real_distribution<double>(0.2, 0.8)(engine);
    const auto c = rounded_cusp(at, engine);
    expect_every_root_cut(c);
    const Doubles breaks = spiral_parameters(c).breaks;
    EXPECT_TRUE(std::any_of(breaks.begin(), breaks.end(), [&](double t) { return std::abs(t - at) < 1e-14; }));
  }
}

// Cubics with a cusp, whose control points are rounded: the speed vanishes but for rounding, at no cut in most of them.
TEST(SpiralParameters, TellsOfTipsThatRoundingHides) {
  std::mt19937 random(1);
  std::uniform_real_distribution<double> unit(-1, 1), inside(0.1, 0.9);
  const auto point = [&] {
    const double x = unit(random);
    return Xy<double>{x, unit(random)};
  };
  int hidden = 0;
  for (int i = 0; i < 200; ++i) {
    const double t = inside(random);
    // C'(s) = 3 (t - s) ((1 - s) a + s c): what is between control points
    const Xy<double> a = point(), c = point(), start = 3.0 * point(), first = start + t * a,
                     second = first + 0.5 * (t * c - (1 - t) * a), end = second - (1 - t) * c;
    const Bezier_curve_2<double> curve({start, first, second, end});
    hidden += spiral_parameters(curve).has_hidden_tip ? 1 : 0;
    const Bezier_curve_2<double> smooth({start, first, second + Xy<double>{0.01, 0.01}, end});
    EXPECT_FALSE(spiral_parameters(smooth).has_hidden_tip) << i;
  }
  EXPECT_GT(hidden, 100);
}

TEST(SpiralParameters, AgreesWithSturmSequencesOnRandomCurves) {
  std::mt19937 engine(20260101);
  for (int round = 0; round < ROUNDS; ++round) {
    SCOPED_TRACE("seed 20260101, round " + std::to_string(round));
    for (const int grid : {64, 2}) {
      for (int degree = 1; degree <= 5; ++degree) expect_every_root_cut(random_curve(engine, {degree, false, grid}));
      for (int degree = 1; degree <= 3; ++degree) expect_every_root_cut(random_curve(engine, {degree, true, grid}));
    }
  }
  expect_every_root_cut(random_curve(engine, {5, true}));
  if (FEW_CASES) return;
  expect_every_root_cut(random_curve(engine, {9, false}));
  expect_every_root_cut(random_curve(engine, {15, false}));
}

TEST(SpiralParameters, AgreesWithSturmSequencesAtAnyScaleAndOffset) {
  std::mt19937 engine(7);
  for (const bool is_rational : {false, true}) {
    for (const double scale : {1e-150, 1e-310, 1e150, 1e306, 0.1}) {
      SCOPED_TRACE("scale " + std::to_string(scale));
      expect_every_root_cut(random_curve(engine, {3, is_rational, 64, scale}));
    }
    expect_every_root_cut(random_curve(engine, {3, is_rational, 64, 1e-3 / 64, 1e6}));
  }
}

TEST(SpiralParameters, DoesNotDependOnPowersOfTwo) {
  std::mt19937 engine(11);
  const auto c = random_curve(engine, {6, true});
  const Doubles breaks = spiral_parameters(c).breaks;
  ASSERT_FALSE(breaks.empty());
  for (const int k : {-900, 900}) {
    std::vector<Xy<double>> p = c.control_points();
    for (auto& q : p) q = std::ldexp(1.0, k) * q;
    EXPECT_EQ(spiral_parameters(Bezier_curve_2<double>(p, c.weights())).breaks, breaks);
  }
}

TEST(SpiralParameters, TakesNumbersOutsideTheRangeOfDoubles) {
  const Doubles breaks = spiral_parameters(curve({0, 1, 2, 3}, {0, 1, -1, 0})).breaks;
  for (const Rational& unit : {Rational(1e-300), Rational(1e300)}) {
    const Rational u = unit * unit;
    const Bezier_curve_2<Rational> c({{0, 0}, {u, u}, {2 * u, -u}, {3 * u, 0}});
    EXPECT_EQ(spiral_parameters(c).breaks, breaks);
  }
}

template <class NT> class SpiralParametersOver : public testing::Test {};
using Number_types =
    testing::Types<float, long double, Rational, CGAL::Gmpq, CGAL::Lazy_exact_nt<CGAL::Gmpq>, CORE::Expr>;
TYPED_TEST_SUITE(SpiralParametersOver, Number_types);

TYPED_TEST(SpiralParametersOver, GivesTheSameBreaksAsOverDoubles) {
  const std::array<std::array<Doubles, 3>, 4> curves = {{{{{0, 1, 3, 7}, {0, 4, -3, 1}, {}}},
                                                         {{{0, 1, -1, 3}, {0, -1, -0.5, 1.5}, {}}},
                                                         {{{0, 4, 5}, {0, 1, 4}, {1, 2, 1}}},
                                                         {{{0, 2, 1}, {0, 6, 3}, {}}}}};
  for (const auto& [x, y, w] : curves) {
    const Spiral_parameters s = spiral_parameters(curve<TypeParam>(x, y, w)), d = spiral_parameters(curve(x, y, w));
    EXPECT_FALSE(d.breaks.empty());
    EXPECT_EQ(s.breaks, d.breaks);
    EXPECT_EQ(s.reasons, d.reasons);
    EXPECT_EQ(s.is_straight, d.is_straight);
  }
}

TEST(SpiralParameters, TakesLongDoublesForWhatTheyAre) {
  // The middle control point lies off the line of the others by less than the spacing of doubles.
  const long double more = 2 + std::ldexp(1.0L, -60);
  const Bezier_curve_2<long double> c({{0, 0}, {more, 2}, {1, 1}});
  EXPECT_EQ(spiral_parameters(c).is_straight, more == 2.0L);
}

TEST(SpiralParameters, TurnsAwayNumbersThatAreNotFinite) {
  const double infinity = std::numeric_limits<double>::infinity();
  for (const double x : {infinity, -infinity, std::numeric_limits<double>::quiet_NaN()}) {
    EXPECT_THROW((void)spiral_parameters(curve({0, x, 2, 3}, {0, 1, 4, 2})), std::invalid_argument);
    EXPECT_THROW((void)spiral_parameters(curve({0, 1, 2, 3}, {0, 1, 4, x})), std::invalid_argument);
  }
  EXPECT_THROW((void)spiral_parameters(curve({0, 1, 2}, {0, 1, 4}, {1, infinity, 1})), std::invalid_argument);
}

TEST(ServedCurves, HaveWeightsWhoseProductsAreNumbers) {
  const auto weighed = [](double w0, double w1) { internal::check_served(curve({0, 1, 2}, {0, 1, 4}, {w0, w1, w0})); };
  EXPECT_NO_THROW(weighed(0x1p-500, 0x1p-460));
  EXPECT_NO_THROW(weighed(0x1p500, 0x1p460));
  EXPECT_THROW(weighed(0x1p-501, 0x1p-500), std::invalid_argument);
  EXPECT_THROW(weighed(0x1p500, 0x1p501), std::invalid_argument);
  EXPECT_THROW(weighed(1, 0x1p41), std::invalid_argument);
}

}  // namespace
}  // namespace test_spiral_parameters
