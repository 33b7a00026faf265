// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// What is asked of an arc, beside center and radius in a hundred digits: each within the error that it states.

#include "cases.h"

#include <CGAL/Bounding_arcs_2/arc/Arc_2.h>
#include "../../src/library/offset/Tolerant_trimmer.h"

#include <gtest/gtest.h>

#include <boost/multiprecision/cpp_bin_float.hpp>

#include <algorithm>
#include <cmath>
#include <random>
#include <vector>

namespace test_arcs {
namespace {

namespace ba = CGAL::Bounding_arcs;
using ba::Arc_2;
using bounding_arcs_test::cases;
using Point = ba::Xy<double>;
using Real = boost::multiprecision::number<boost::multiprecision::cpp_bin_float<100>, boost::multiprecision::et_off>;
using Vector = ba::Xy<Real>;
constexpr double U = 0x1p-53;

Vector exact(const Point& p) { return {Real(p.x), Real(p.y)}; }
Real size_of(const Vector& v) { return sqrt(dot(v, v)); }

// An arc by center and radius; of a segment neither, nor where the center has no digits left.
struct Exact_arc {
  Vector from, to, center;
  Real bulge, radius;

  explicit Exact_arc(const Arc_2& arc) : from(exact(arc.from)), to(exact(arc.to)), bulge(arc.bulge) {
    if (std::fabs(arc.bulge) < 0x1p-150) bulge = 0;
    if (bulge == 0) return;
    const Vector chord = to - from;
    const Real height = (1 - bulge * bulge) / (4 * bulge);
    center = Real(0.5) * (from + to) + height * perp(chord);
    radius = size_of(chord) * (1 + bulge * bulge) / (4 * abs(bulge));
  }
  [[nodiscard]] Real chord() const { return size_of(to - from); }
  // The foot of q where it is on the arc, else the nearer end.
  [[nodiscard]] Vector nearest(const Vector& q) const {
    const Vector end = size_of(q - from) < size_of(q - to) ? from : to, chord = to - from;
    if (chord == Vector()) return from;
    if (bulge == 0) {
      const Real share = dot(chord, Vector(q - from)) / dot(chord, chord);
      return share >= 0 && share <= 1 ? from + share * chord : end;
    }
    const Vector ray = q - center;
    if (ray == Vector()) return from;
    const Vector foot = center + Real(radius / size_of(ray)) * ray;
    return cross(chord, Vector(foot - from)) * bulge <= 0 ? foot : end;
  }
  // Positive to the left.
  [[nodiscard]] Real signed_distance(const Vector& q) const {
    const Real side = bulge == 0 ? cross(Vector(to - from), Vector(q - from))
                                 : Real((radius - size_of(q - center)) * (bulge > 0 ? 1 : -1));
    const Real distance = size_of(q - nearest(q));
    return side < 0 ? Real(-distance) : distance;
  }
  [[nodiscard]] Real angle() const { return 4 * atan(bulge); }
  // The point and the unit tangent a share of the length from the start.
  [[nodiscard]] Vector tangent(const Real& share) const {
    const Vector chord = to - from;
    const Real turn = (2 * share - 1) * angle() / 2;
    return Real(1 / size_of(chord)) * (Real(cos(turn)) * chord + Real(sin(turn)) * perp(chord));
  }
  [[nodiscard]] Vector point(const Real& share) const {
    if (bulge == 0) return from + share * (to - from);
    return center - Real(bulge < 0 ? -radius : radius) * perp(tangent(share));
  }
};

struct Case {
  Arc_2 arc;
  double scale;
};

// Arcs of all sizes and places: flat ones, segments, half circles, far from the origin, tiny and huge.
std::vector<Case> various_arcs(unsigned seed, int count) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> unit(-1, 1);
  std::vector<Case> arcs;
  for (int i = 0; i < count; ++i) {
    double scale = std::ldexp(1, static_cast<int>(random() % 40) - 20);
    if (i % 10 == 8) scale = 1e-145;
    if (i % 10 == 9) scale = 1e145;
    Arc_2 arc{{scale * unit(random), scale * unit(random)}, {scale * unit(random), scale * unit(random)}};
    if (i % 7 == 0) arc.to.y = arc.from.y;
    if (i % 11 == 0) arc = {{1e6 + 1e-3 * unit(random), 2e6}, {1e6 + 1e-3 * unit(random), 2e6 + 1e-3 * unit(random)}};
    if (i % 11 == 0) scale = 1e-3;
    const double sign = random() % 2 == 0 ? 1 : -1;
    arc.bulge = sign * (i % 3 == 0 ? std::exp2(45 * unit(random) - 45) : std::fabs(unit(random)));
    if (i % 13 == 0) arc.bulge = 0;
    if (i % 13 == 1) arc.bulge = sign;
    if (i % 13 == 2) arc.bulge = sign * 0x1p-1000;
    arcs.push_back({arc, scale});
  }
  return arcs;
}

// Points about an arc, on it and next to it, beside its ends, and at its center.
std::vector<Point> points_about(const Case& c, std::mt19937& random) {
  std::uniform_real_distribution<double> unit(-1, 1);
  std::vector<Point> points{c.arc.from, c.arc.to, {0, 0}};
  for (const double s : {0.0, 0.3, 0.5, 0.9, 1.0})
    for (const double away : {0.0, 1e-12, 1e-6, 1e-2, 1.0, 1e3}) {
      const double d = c.scale * away * unit(random);
      points.push_back(ba::point(c.arc, s) + d * ba::normal(c.arc, s));
      points.push_back(ba::point(c.arc, s) + Point{d * unit(random), d * unit(random)});
    }
  const Exact_arc e(c.arc);
  if (std::fabs(c.arc.bulge) > 1e-3)
    for (const double away : {0.0, 1e-12, 1e-8, 1e-3})
      points.push_back({static_cast<double>(e.center.x) + away * c.scale, static_cast<double>(e.center.y)});
  return points;
}

TEST(ArcDistance, IsWithinItsErrorOfTheExactOne) {
  std::mt19937 random(1);
  double most = 0;
  for (const Case& c : various_arcs(2, cases(300))) {
    const Exact_arc e(c.arc);
    for (const Point& q : points_about(c, random)) {
      const Real is = e.signed_distance(exact(q)),
                 reach = (std::max)(size_of(exact(q) - e.from), size_of(exact(q) - e.to));
      const Real error = abs(ba::signed_distance(q, c.arc)) - abs(is);
      if (reach == 0) continue;
      most = (std::max)(most, static_cast<double>(abs(error) / reach));
      ASSERT_LE(static_cast<double>(abs(error) / reach), ba::ARC_DISTANCE_ERROR) << c.arc.bulge << ' ' << c.scale;
      if (abs(is) > 1e-12 * reach) {
        EXPECT_EQ(ba::signed_distance(q, c.arc) < 0, is < 0) << c.arc.bulge << ' ' << c.scale;
      }
      EXPECT_EQ(ba::squared_distance(q, c.arc), ba::signed_distance(q, c.arc) * ba::signed_distance(q, c.arc));
    }
  }
  EXPECT_GT(most, U);  // what is measured errs
}

TEST(ArcDistance, OfAPointIsThatOfItsEnds) {
  for (const double bulge : {0.0, 0.5, -1.0}) EXPECT_EQ(ba::squared_distance({4, 6}, {{1, 2}, {1, 2}, bulge}), 25);
}

TEST(NearestPoint, IsAsFarAsTheArcAndOnItsCircle) {
  std::mt19937 random(3);
  for (const Case& c : various_arcs(4, cases(300))) {
    const Exact_arc e(c.arc);
    for (const Point& q : points_about(c, random)) {
      const Point p = ba::nearest_point(q, c.arc);
      const Real reach = (std::max)(size_of(exact(q) - e.from), size_of(exact(q) - e.to));
      const double room =
          2 * ba::ARC_DISTANCE_ERROR * static_cast<double>(reach) + 2 * U * (std::fabs(p.x) + std::fabs(p.y));
      // next to the center all points of the circle are about as near, and which of them is not told
      const Real off =
          e.bulge == 0 ? size_of(exact(p) - e.nearest(exact(p))) : Real(abs(size_of(exact(p) - e.center) - e.radius));
      EXPECT_LE(static_cast<double>(off), room) << c.arc.bulge << ' ' << c.scale;
      const Real further = size_of(exact(p) - exact(q)) - abs(e.signed_distance(exact(q)));
      EXPECT_LE(static_cast<double>(abs(further)), room) << c.arc.bulge << ' ' << c.scale;
    }
  }
}

TEST(PointsOfArcs, AndTangentsAreTheExactOnes) {
  for (const Case& c : various_arcs(5, cases(300))) {
    const Exact_arc e(c.arc);
    EXPECT_EQ(ba::point(c.arc, 0), c.arc.from);
    EXPECT_EQ(ba::point(c.arc, 1), c.arc.to);
    for (const double s : {1e-300, 0.01, 0.25, 0.5, 0.75, 0.999, 1 - U}) {
      const Point p = ba::point(c.arc, s);
      const Vector off = exact(p) - e.point(s);
      const double room = 21 * U * static_cast<double>(e.chord());
      EXPECT_LE(static_cast<double>(abs(off.x)), room + U * std::fabs(p.x)) << c.arc.bulge << ' ' << s;
      EXPECT_LE(static_cast<double>(abs(off.y)), room + U * std::fabs(p.y)) << c.arc.bulge << ' ' << s;
      const Vector tangent = e.tangent(s);
      EXPECT_LE(static_cast<double>(size_of(exact(ba::tangent(c.arc, s)) - tangent)), 16 * U) << c.arc.bulge;
      EXPECT_EQ(ba::normal(c.arc, s), perp(ba::tangent(c.arc, s)));
    }
    for (const Point& p : {c.arc.from, c.arc.to}) {
      const Vector tangent = e.tangent(p == c.arc.from ? 0 : 1);
      EXPECT_LE(static_cast<double>(size_of(exact(ba::tangent_at(p, c.arc)) - tangent)), 16 * U) << c.arc.bulge;
      EXPECT_EQ(ba::normal_at(p, c.arc), perp(ba::tangent_at(p, c.arc)));
    }
  }
}

TEST(ArcFigures, AreTheExactOnes) {
  for (const Case& c : various_arcs(6, cases(300))) {
    const Exact_arc e(c.arc);
    const Real b(c.arc.bulge), length = e.bulge == 0 ? e.chord() : Real(e.radius * abs(e.angle())),
                               curvature = 4 * b / ((1 + b * b) * e.chord());
    EXPECT_LE(static_cast<double>(abs(ba::length(c.arc) - length) / length), 10 * U) << c.arc.bulge;
    EXPECT_LE(static_cast<double>(abs(ba::curvature(c.arc) - curvature)), 7 * U * static_cast<double>(abs(curvature)))
        << c.arc.bulge;
  }
}

TEST(ArcBox, HoldsTheArcAndIsNarrow) {
  for (const Case& c : various_arcs(7, cases(300))) {
    const Exact_arc e(c.arc);
    const CGAL::Bbox_2 box = ba::box(c.arc);
    Vector low = e.from, high = e.from;
    const auto add = [&](const Vector& p) {
      low = {(std::min)(low.x, p.x), (std::min)(low.y, p.y)};
      high = {(std::max)(high.x, p.x), (std::max)(high.y, p.y)};
    };
    add(e.to);
    if (c.arc.bulge != 0)
      for (const Vector& way : {Vector{1, 0}, Vector{-1, 0}, Vector{0, 1}, Vector{0, -1}}) {
        const Vector p = e.center + e.radius * way;
        if (cross(Vector(e.to - e.from), Vector(p - e.from)) * e.bulge < 0) add(p);
      }
    const double room = 0x1p-48 * static_cast<double>(e.chord());
    const auto expect_just_beyond = [&](double is, const Real& exact_one, int sign) {
      const double beyond = static_cast<double>(sign * (Real(is) - exact_one));
      EXPECT_GE(beyond, 0) << c.arc.bulge << ' ' << c.scale;
      EXPECT_LE(beyond, room + 6 * U * std::fabs(is)) << c.arc.bulge << ' ' << c.scale;
    };
    expect_just_beyond(box.xmin(), low.x, -1);
    expect_just_beyond(box.ymin(), low.y, -1);
    expect_just_beyond(box.xmax(), high.x, 1);
    expect_just_beyond(box.ymax(), high.y, 1);
  }
}

// Two arcs whose middles are a gap apart, and the ends of both farther; at any size.
TEST(ArcContacts, AreWhereArcsPassWithinReachWithoutACrossing) {
  for (const double scale : {0x1p-60, 1.0, 0x1p60}) {
    const double gap = scale * 0x1p-10, height = scale / 2 + gap;
    const Arc_2 low{{-scale, 0}, {scale, 0}, -0.25}, high{{-scale, height}, {scale, height}, 0.25};
    EXPECT_EQ(ba::contacts(low, high, 0, 0.9 * gap).count, 0) << scale;
    const ba::Arc_contacts found = ba::contacts(low, high, 0, 1.1 * gap);
    ASSERT_EQ(found.count, 1) << scale;
    EXPECT_NEAR(found.at[0].u, 0.5, 1e-9) << scale;
    EXPECT_NEAR(found.at[0].v, 0.5, 1e-9) << scale;
    EXPECT_EQ(ba::contacts(low, low, 0, gap).count, 4) << scale;  // on one circle the ends alone
    EXPECT_EQ(ba::contacts(low, {{-scale, gap}, {scale, gap}, -0.25}, 0, 1.1 * gap).count, 5) << scale;
  }
}

}  // namespace
}  // namespace test_arcs
