// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Curves with exact coordinates made for a known intersection, and what a list of intersections should say.

#ifndef BOUNDING_ARCS_TEST_EXACT_CURVES_H
#define BOUNDING_ARCS_TEST_EXACT_CURVES_H

#include <CGAL/Bounding_arcs_2/curve/Bezier_curve_2.h>
#include <CGAL/Bounding_arcs_2/polynomial/Bernstein_polynomial.h>
#include "../../src/library/query/exact_intersections.h"

#include <CGAL/Exact_rational.h>

#include <gtest/gtest.h>

#include <cmath>
#include <cstddef>
#include <initializer_list>
#include <random>
#include <utility>
#include <vector>

namespace bounding_arcs_test {

using namespace CGAL::Bounding_arcs;
using Rational = CGAL::Exact_rational;
using Curve = Bezier_curve_2<Rational>;
using Point = Xy<Rational>;
using Powers = std::vector<Rational>;  // coefficients of a polynomial by rising powers

inline Rational ratio(int p, int q) { return Rational(p) / Rational(q); }

inline Curve curve(std::initializer_list<Point> points, std::initializer_list<Rational> weights = {}) {
  return Curve(std::vector<Point>(points), std::vector<Rational>(weights));
}
inline Curve segment(const Point& p, const Point& q) { return curve({p, q}); }

/// p(low + (high - low) t) in Bernstein's basis of a degree.
inline std::vector<Rational> bernstein(const Powers& p, const Rational& low, const Rational& high, int degree) {
  using Polynomial = Bernstein_polynomial<Rational>;
  const Polynomial t(std::vector<Rational>{low, high});
  Polynomial sum(std::vector<Rational>{Rational(0)}), power(std::vector<Rational>{Rational(1)});
  for (const Rational& c : p) {
    sum = sum + c * power;
    power = power * t;
  }
  const Polynomial all = sum.degree() < degree ? sum.elevated(degree) : sum;
  std::vector<Rational> b;
  for (int i = 0; i <= all.degree(); ++i) b.push_back(all.coefficient(i));
  return b;
}

/// (x(u), y(u)) or (x/w, y/w) for u in [low, high].
inline Curve parametric(const Powers& x, const Powers& y, const Rational& low, const Rational& high,
                        const Powers& w = {}, int least_degree = 1) {
  int degree = least_degree;
  for (const Powers* p : {&x, &y, &w}) degree = std::max(degree, static_cast<int>(p->size()) - 1);
  const auto bx = bernstein(x, low, high, degree), by = bernstein(y, low, high, degree);
  const auto bw = w.empty() ? std::vector<Rational>(bx.size(), Rational(1)) : bernstein(w, low, high, degree);
  std::vector<Point> points;
  for (std::size_t i = 0; i < bx.size(); ++i) points.push_back({Rational(bx[i] / bw[i]), Rational(by[i] / bw[i])});
  return Curve(points, w.empty() ? std::vector<Rational>() : bw);
}
/// y = p(x) over [-1, 1].
inline Curve graph(const Powers& p) { return parametric({0, 1}, p, -1, 1); }

/// The same piece in a degree higher by one.
inline Curve elevated(const Curve& c) {
  const int n = c.degree() + 1;
  std::vector<Point> points;
  std::vector<Rational> weights;
  for (int i = 0; i <= n; ++i) {
    const Rational before = i > 0 ? Rational(ratio(i, n) * c.weight(i - 1)) : Rational(0);
    const Rational after = i < n ? Rational(ratio(n - i, n) * c.weight(i)) : Rational(0);
    const auto& p = c.control_points();
    const Point zero{0, 0};
    const Point sum = before * (i > 0 ? p[static_cast<std::size_t>(i - 1)] : zero) +
                      after * (i < n ? p[static_cast<std::size_t>(i)] : zero);
    weights.push_back(before + after);
    points.push_back(Rational(1 / weights.back()) * sum);
  }
  return Curve(points, c.is_rational() ? weights : std::vector<Rational>());
}

/// A quarter of a circle, counterclockwise, the first one from the direction of x to that of y.
inline Curve quarter(const Point& center, const Rational& radius, int number) {
  Point p{radius, 0}, q{radius, radius}, r{0, radius};
  for (int i = 0; i < number; ++i)
    for (Point* corner : {&p, &q, &r}) *corner = perp(*corner);
  return curve({center + p, center + q, center + r}, {1, 1, 2});
}

inline bool holds(const Bracket& r, const Rational& t) { return Rational(r.lower) <= t && t <= Rational(r.upper); }

/// How many points are at these parameters.
inline int count_at(const Piece_intersections& found, const Rational& a, const Rational& b) {
  int count = 0;
  for (const Piece_intersections::Intersection& p : found.points) count += holds(p.a, a) && holds(p.b, b) ? 1 : 0;
  return count;
}

/// The one point found, at these parameters.
inline void expect_one(const Piece_intersections& found, const Rational& a, const Rational& b, Intersection_kind kind) {
  EXPECT_EQ(found.overlaps.size(), 0u);
  ASSERT_EQ(found.points.size(), 1u);
  EXPECT_EQ(count_at(found, a, b), 1) << found.points[0].a.lower << " " << found.points[0].b.lower;
  EXPECT_EQ(found.points[0].kind, kind);
}

/// Whether an overlap is that from (a0, b0) to (a1, b1).
inline bool is_overlap(const Piece_intersections::Overlap& o, const Rational& a0, const Rational& a1,
                       const Rational& b0, const Rational& b1) {
  return holds(o.a_from, a0) && holds(o.a_to, a1) && holds(o.b_from, b0) && holds(o.b_to, b1);
}
inline void expect_overlap(const Piece_intersections& found, const Rational& a0, const Rational& a1, const Rational& b0,
                           const Rational& b1) {
  EXPECT_EQ(found.points.size(), 0u);
  ASSERT_EQ(found.overlaps.size(), 1u);
  EXPECT_TRUE(is_overlap(found.overlaps[0], a0, a1, b0, b1));
}

/// Control points at integers up to `size`.
template <class Random> Curve random_curve(Random& random, int degree, int size) {
  std::uniform_int_distribution<int> number(-size, size);
  std::vector<Point> points;
  for (int i = 0; i <= degree; ++i) {
    const int x = number(random), y = number(random);
    points.push_back({Rational(x), Rational(y)});
  }
  return Curve(points);
}

inline constexpr Intersection_kind TRANSVERSAL = Intersection_kind::TRANSVERSAL;
inline constexpr Intersection_kind TANGENTIAL = Intersection_kind::TANGENTIAL;

}  // namespace bounding_arcs_test

#endif
