// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// B-spline curves: closed forms of the Bezier pieces, agreement with the Cox-de Boor recursion, the shared ends, and
// the messages for input that makes no curve.

#include <CGAL/Bounding_arcs_2/curve/B_spline_curve_2.h>

#include "cases.h"

#include <CGAL/Exact_rational.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <functional>
#include <limits>
#include <random>

namespace test_b_spline_curve {
namespace {

using bounding_arcs_test::cases;
using bounding_arcs_test::FEW_CASES;
using Exact = CGAL::Exact_rational;
template <class NT> using Point = CGAL::Bounding_arcs::Xy<NT>;
template <class NT> using B_spline = CGAL::Bounding_arcs::B_spline_curve_2<NT>;
template <class NT> using Bezier = CGAL::Bounding_arcs::Bezier_curve_2<NT>;

constexpr unsigned SEED = 20261;

// Log-uniform magnitudes of both signs: neighbours differ by up to 24 decimal orders.
std::vector<Point<double>> random_points(std::mt19937& random, std::size_t n) {
  std::uniform_real_distribution<double> exponent(-12, 12), sign(-1, 1);
  const auto number = [&] { return std::copysign(std::pow(10.0, exponent(random)), sign(random)); };
  std::vector<Point<double>> points(n);
  for (auto& p : points) p = {number(), number()};
  return points;
}

std::vector<double> random_weights(std::mt19937& random, std::size_t n) {
  std::uniform_real_distribution<double> exponent(-3, 3);
  std::vector<double> weights(n);
  for (double& w : weights) w = std::exp2(exponent(random));
  return weights;
}

// Non-decreasing knots with some of multiplicity up to the degree; the first and the last are simple.
std::vector<double> random_knots(std::mt19937& random, std::size_t n, int degree) {
  std::vector<double> knots{0};
  for (int run = degree; knots.size() < n;) {
    const bool repeat = run < degree && knots.size() + 1 < n && random() % 3 == 0;
    run = repeat ? run + 1 : 1;
    knots.push_back(repeat ? knots.back() : knots.back() + 1 + static_cast<double>(random() % 100) / 7);
  }
  return knots;
}

std::vector<Point<Exact>> exact(const std::vector<Point<double>>& points) {
  std::vector<Point<Exact>> result;
  for (const auto& p : points) result.push_back({Exact(p.x), Exact(p.y)});
  return result;
}

std::vector<Exact> exact(const std::vector<double>& numbers) { return {numbers.begin(), numbers.end()}; }

// The basis function N_(i,d) by the Cox-de Boor recursion, as an oracle independent of the blossom.
Exact basis(const std::vector<Exact>& t, std::size_t i, std::size_t d, const Exact& u) {
  if (d == 0) return Exact(t[i] <= u && u < t[i + 1] ? 1 : 0);
  Exact sum = 0;
  if (t[i] < t[i + d]) sum += (u - t[i]) / (t[i + d] - t[i]) * basis(t, i, d - 1, u);
  if (t[i + 1] < t[i + d + 1]) sum += (t[i + d + 1] - u) / (t[i + d + 1] - t[i + 1]) * basis(t, i + 1, d - 1, u);
  return sum;
}

Point<Exact> oracle(const B_spline<Exact>& curve, const Exact& u) {
  const auto& t = curve.knots();
  const std::size_t d = static_cast<std::size_t>(curve.degree()), n = curve.control_points().size();
  Exact x = 0, y = 0, w = 0;
  for (std::size_t i = 0; i + d + 1 < t.size(); ++i) {
    const Exact b = basis(t, i, d, u) * (curve.is_rational() ? curve.weights()[i % n] : Exact(1));
    x += b * curve.control_points()[i % n].x;
    y += b * curve.control_points()[i % n].y;
    w += b;
  }
  return {Exact(x / w), Exact(y / w)};
}

// Both the pieces and point() against the recursion at five places inside each span.
void expect_matches_oracle(const B_spline<Exact>& curve) {
  const auto& t = curve.knots();
  const auto pieces = curve.bezier_pieces();
  std::size_t piece = 0;
  for (std::size_t k = 0; k + 1 < t.size(); ++k) {
    if (!(curve.domain().lower <= t[k] && t[k] < t[k + 1] && t[k + 1] <= curve.domain().upper)) continue;
    ASSERT_LT(piece, pieces.size());
    for (int i = 0; i < 5; ++i) {
      const Exact s = Exact(i) / 5, u = t[k] + s * (t[k + 1] - t[k]);
      EXPECT_EQ(pieces[piece].point(s), oracle(curve, u)) << "span " << k << " at " << i << "/5";
      EXPECT_EQ(curve.point(u), oracle(curve, u)) << "span " << k << " at " << i << "/5";
    }
    ++piece;
  }
  EXPECT_EQ(piece, pieces.size());
}

bool same_bits(const Point<double>& p, const Point<double>& q) {
  return std::memcmp(&p.x, &q.x, sizeof(double)) == 0 && std::memcmp(&p.y, &q.y, sizeof(double)) == 0;
}

void expect_shared_ends(const std::vector<Bezier<double>>& pieces, bool periodic) {
  for (std::size_t i = periodic ? 0 : 1; i < pieces.size(); ++i) {
    const auto& before = pieces[(i + pieces.size() - 1) % pieces.size()].control_points();
    EXPECT_TRUE(same_bits(before.back(), pieces[i].control_points().front())) << "piece " << i;
  }
}

std::string message_of(const std::function<void()>& make) {
  try {
    make();
  } catch (const std::invalid_argument& error) {
    return error.what();
  }
  return "no error";
}

std::vector<Point<double>> points(std::size_t n) {
  std::vector<Point<double>> result(n);
  for (std::size_t i = 0; i < n; ++i) result[i] = {static_cast<double>(i), static_cast<double>(i * i % 7)};
  return result;
}

TEST(BSplinePeriodic, UniformCubicHasTheClosedFormExactly) {
  std::mt19937 random(SEED);
  for (std::size_t n = 2; n < 12; ++n) {
    const auto p = exact(random_points(random, n));
    const auto pieces = B_spline<Exact>::periodic(3, p).bezier_pieces();
    ASSERT_EQ(pieces.size(), n);
    for (std::size_t i = 0; i < n; ++i) {
      const auto &p0 = p[i], &p1 = p[(i + 1) % n], &p2 = p[(i + 2) % n], &p3 = p[(i + 3) % n];
      const auto& b = pieces[i].control_points();
      ASSERT_EQ(b.size(), 4u);
      EXPECT_EQ(b[0], (Exact(1) / 6) * (p0 + Exact(4) * p1 + p2)) << "seed " << SEED << ", n " << n << ", piece " << i;
      EXPECT_EQ(b[1], (Exact(1) / 3) * (Exact(2) * p1 + p2));
      EXPECT_EQ(b[2], (Exact(1) / 3) * (p1 + Exact(2) * p2));
      EXPECT_EQ(b[3], (Exact(1) / 6) * (p1 + Exact(4) * p2 + p3));
    }
  }
}

TEST(BSplinePeriodic, UniformCubicIsWithinTwoUlpsInDouble) {
  std::mt19937 random(SEED);
  double worst = 0;
  for (int round = 0; round < cases(2000); ++round) {
    std::uniform_real_distribution<double> coordinate(-1, 1);
    std::vector<Point<double>> p(5);
    for (auto& q : p) q = {coordinate(random), coordinate(random)};
    const auto rounded = B_spline<double>::periodic(3, p).bezier_pieces();
    const auto precise = B_spline<Exact>::periodic(3, exact(p)).bezier_pieces();
    for (std::size_t i = 0; i < 5; ++i) {
      double size = 0;
      for (std::size_t j = 0; j < 4; ++j) size = std::max(size, std::abs(p[(i + j) % 5].x));
      const double ulp = std::nextafter(size, 2.0) - size;
      for (std::size_t j = 0; j < 4; ++j) {
        const Exact error = Exact(rounded[i].control_points()[j].x) - precise[i].control_points()[j].x;
        worst = std::max(worst, std::abs(CGAL::to_double(error)) / ulp);
      }
    }
  }
  EXPECT_LE(worst, 2.0) << "seed " << SEED;
}

TEST(BSplinePieces, AgreeWithCoxDeBoor) {
  std::mt19937 random(SEED);
  for (int degree = 1; degree <= 5; ++degree)
    for (int round = 0; round < (FEW_CASES ? 2 : 4); ++round) {
      SCOPED_TRACE("seed " + std::to_string(SEED) + ", degree " + std::to_string(degree) + ", round " +
                   std::to_string(round));
      const std::size_t n = static_cast<std::size_t>(degree) + 1 + random() % 4;
      const auto p = exact(random_points(random, n));
      const auto w = round % 2 == 0 ? std::vector<Exact>() : exact(random_weights(random, n));
      expect_matches_oracle(B_spline<Exact>::uniform(degree, p, w));
      expect_matches_oracle(B_spline<Exact>::periodic(degree, p, {}, w));
      expect_matches_oracle(B_spline<Exact>::periodic(degree, p, exact(random_knots(random, n + 1, degree)), w));
      auto knots = random_knots(random, n + static_cast<std::size_t>(degree) + 1, degree);
      if (knots[static_cast<std::size_t>(degree)] < knots[n])
        expect_matches_oracle(B_spline<Exact>(degree, p, exact(knots), w));
    }
}

TEST(BSplinePieces, OfAClampedCurveWithoutInnerKnotsAreItsControlPoints) {
  const auto p = points(4);
  const std::vector<double> w{1, 0.5, 3, 2};
  const auto pieces = B_spline<double>(3, p, {2, 2, 2, 2, 5, 5, 5, 5}, w).bezier_pieces();
  ASSERT_EQ(pieces.size(), 1u);
  EXPECT_EQ(pieces[0].control_points(), p);
  EXPECT_EQ(pieces[0].weights(), w);
}

TEST(BSplinePieces, SkipSpansOfNoLength) {
  const auto pieces = B_spline<double>(2, points(7), {0, 0, 0, 1, 1, 2, 2, 3, 3, 3}).bezier_pieces();
  EXPECT_EQ(pieces.size(), 3u);
  EXPECT_EQ(pieces[0].control_points().back(), points(7)[2]);
}

TEST(BSplinePieces, ShareTheirEndsBitForBit) {
  std::mt19937 random(SEED);
  for (int degree = 1; degree <= 7; ++degree) {
    SCOPED_TRACE("seed " + std::to_string(SEED) + ", degree " + std::to_string(degree));
    const auto p = random_points(random, 15);
    const auto w = random_weights(random, 15);
    expect_shared_ends(B_spline<double>::periodic(degree, p).bezier_pieces(), true);
    expect_shared_ends(B_spline<double>::periodic(degree, p, random_knots(random, 16, degree), w).bezier_pieces(),
                       true);
    expect_shared_ends(B_spline<double>::uniform(degree, p, w).bezier_pieces(), false);
  }
}

TEST(BSplinePieces, AreWithinTheStatedBoundInDouble) {
  std::mt19937 random(SEED);
  for (int degree = 1; degree <= 8; ++degree)
    for (int round = 0; round < 10; ++round) {
      const auto p = random_points(random, 12);
      const auto t = random_knots(random, 13, degree);
      const auto rounded = B_spline<double>::periodic(degree, p, t).bezier_pieces();
      const auto precise = B_spline<Exact>::periodic(degree, exact(p), exact(t)).bezier_pieces();
      double size = 0;
      for (const auto& q : p) size = std::max(size, std::abs(q.x));
      const double bound = 6 * degree * std::numeric_limits<double>::epsilon() / 2 * size;
      ASSERT_EQ(rounded.size(), precise.size());
      for (std::size_t i = 0; i < rounded.size(); ++i)
        for (std::size_t j = 0; j < rounded[i].control_points().size(); ++j)
          EXPECT_LE(CGAL::abs(Exact(rounded[i].control_points()[j].x) - precise[i].control_points()[j].x), Exact(bound))
              << "seed " << SEED << ", degree " << degree << ", round " << round;
    }
}

TEST(BSplinePieces, KeepACommonCoordinateInDouble) {
  std::mt19937 random(SEED);
  for (int round = 0; round < 20; ++round) {
    auto p = random_points(random, 9);
    for (auto& q : p) q.x = p[0].x;
    const auto curve = B_spline<double>::periodic(4, p, random_knots(random, 10, 4), random_weights(random, 9));
    for (const auto& piece : curve.bezier_pieces())
      for (const auto& q : piece.control_points()) EXPECT_EQ(q.x, p[0].x) << "seed " << SEED << ", round " << round;
  }
}

TEST(BSplinePieces, OfTheRationalQuadraticCircleStayOnIt) {
  const std::vector<Point<Exact>> p{{1, 0}, {1, 1}, {0, 1}, {-1, 1}, {-1, 0}};
  const auto pieces = B_spline<Exact>(2, p, {0, 0, 0, 1, 1, 2, 2, 2}, {1, 1, 2, 1, 1}).bezier_pieces();
  ASSERT_EQ(pieces.size(), 2u);
  for (int i = 0; i <= 10; ++i) {
    const auto q = pieces[1].point(Exact(i) / 10);
    EXPECT_EQ(Exact(q.x * q.x + q.y * q.y), Exact(1));
  }
}

TEST(BSplinePeriodic, UnwrappedKnotsMakeTheSameCurve) {
  const auto one_period = B_spline<double>::periodic(2, points(4), {0, 0.1, 0.4, 0.7, 1.1});
  const auto unwrapped = B_spline<double>::periodic(2, points(4), {-0.7, -0.4, 0, 0.1, 0.4, 0.7, 1.1, 1.2, 1.5});
  EXPECT_EQ(one_period.knots(), unwrapped.knots());
  EXPECT_EQ(unwrapped.bezier_pieces().size(), 4u);
}

TEST(BSplinePeriodic, RepeatedKnotAcrossTheSeamIsKeptInDouble) {
  const auto curve = B_spline<double>::periodic(3, points(5), {0.1, 0.1, 0.3, 0.6, 0.7, 0.7});
  EXPECT_EQ(curve.bezier_pieces().size(), 3u);
  EXPECT_EQ(curve.knots()[2], curve.knots()[3]);
}

TEST(BSplineDomain, IsBoundedByTheKnotsOfTheDegree) {
  const auto open = B_spline<double>::uniform(3, points(6));
  EXPECT_EQ(open.domain().lower, 3);
  EXPECT_EQ(open.domain().upper, 6);
  EXPECT_EQ(open.bezier_pieces().size(), 3u);
  const auto closed = B_spline<double>::periodic(3, points(6));
  EXPECT_EQ(closed.domain().lower, 0);
  EXPECT_EQ(closed.domain().upper, 6);
  EXPECT_EQ(closed.point(0), closed.point(6));
}

TEST(BSplineErrors, NameTheConditionAndTheIndex) {
  const auto curve = [](int d, std::size_t n, std::vector<double> t, std::vector<double> w = {}) {
    return message_of([&] { B_spline<double>(d, points(n), t, w); });
  };
  EXPECT_EQ(curve(0, 3, {0, 1, 2, 3}), "degree: expected at least 1, found 0");
  EXPECT_EQ(curve(3, 3, {}), "control points: expected at least 4 of a B-spline of degree 3, found 3");
  EXPECT_EQ(curve(2, 3, {0, 1, 2}), "knots: expected 6 (control points + degree + 1), found 3");
  EXPECT_EQ(curve(2, 3, {0, 1, 2, 3, 2.5, 4}), "knot 4: expected no less than knot 3, found 2.5");
  EXPECT_EQ(curve(1, 2, {0, NAN, 1, 2}), "knot 1: expected no less than knot 0, found nan");
  EXPECT_EQ(curve(1, 2, {0, 0, HUGE_VAL, HUGE_VAL}),
            "knots: expected a finite number from the first to the last one, found inf");
  EXPECT_EQ(curve(1, 2, {-1e308, -1e308, 1e308, 1e308}),
            "knots: expected a finite number from the first to the last one, found inf");
  EXPECT_EQ(curve(2, 3, {0, 1, 2, 2, 3, 4}), "knots: expected knot 2 below knot 3, found an empty domain");
  EXPECT_EQ(curve(1, 5, {0, 0, 1, 1, 2, 2, 2}),
            "knot 3: expected at most 1 equal ones, as the curve falls apart with more, found 2");
  EXPECT_EQ(curve(1, 4, {0, 0, 0, 1, 2, 2}), "knot 2: expected at most 2 equal ones, found 3");
  EXPECT_EQ(curve(1, 2, {0, 0, 1, 1}, {1}), "weights: expected 2, one a control point, found 1");
  EXPECT_EQ(curve(1, 2, {0, 0, 1, 1}, {1, 0}), "weight 1: expected a number above 0, found 0");
  EXPECT_EQ(curve(1, 2, {0, 0, 1, 1}, {NAN, 1}), "weight 0: expected a number above 0, found nan");
  EXPECT_EQ(curve(1, 2, {0, 0, 1, 1}), "no error");
}

TEST(BSplineErrors, OfPeriodicCurvesNameTheConditionAndTheIndex) {
  const auto curve = [](int d, std::size_t n, std::vector<double> t, std::vector<double> w = {}) {
    return message_of([&] { (void)B_spline<double>::periodic(d, points(n), t, w); });
  };
  EXPECT_EQ(curve(3, 1, {}), "control points: expected at least 2 of a periodic B-spline, found 1");
  EXPECT_EQ(curve(3, 4, {0, 1, 2, 3}),
            "knots: expected 5 (control points + 1, one period) or 11 (control points + 2 degree + 1), found 4");
  EXPECT_EQ(curve(2, 2, {1, 1, 1}), "knots: expected a period above 0, found an empty domain");
  EXPECT_EQ(curve(3, 3, {0, 0, 0, 1}), "no error");
  EXPECT_NE(curve(2, 3, {0, 0, 0, 1}).find("at most 2 equal ones, as the curve falls apart with more"),
            std::string::npos);
  EXPECT_NE(curve(2, 4, {0, 1, 1, 1, 2}).find("the curve falls apart"), std::string::npos);
  EXPECT_NE(curve(2, 4, {0, 0, 1, 2, 2}).find("the curve falls apart"), std::string::npos);
  EXPECT_EQ(curve(1, 3, {-1, 0, 1, 2, 3, 4}), "no error");
  // places in the list as it was given, one period or more
  EXPECT_EQ(curve(2, 4, {0, 1, 1, 1, 4}),
            "knot 3: expected at most 2 equal ones, as the curve falls apart with more, found 3");
  EXPECT_EQ(curve(2, 4, {0, 0, 0, 0, 4}),
            "knot 2: expected at most 2 equal ones, as the curve falls apart with more, found 3");
  EXPECT_EQ(curve(2, 4, {-3, -3, 0, 1, 1, 1, 4, 5, 5}),
            "knot 5: expected at most 2 equal ones, as the curve falls apart with more, found 3");
  EXPECT_EQ(curve(1, 2, {-1, 0, 1, 2, 3.5}), "knots: expected knots 2 and 4 one period apart, found 2.5");
}

}  // namespace
}  // namespace test_b_spline_curve
