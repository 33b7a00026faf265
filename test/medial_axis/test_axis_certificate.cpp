// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Proven bounds of a medial axis's edges: they are there, hold what maximal discs say, and are at most twice that.

#include "axis_checks.h"
#include "cases.h"
#include "near_equal_discs.h"

#include <CGAL/Bounding_arcs_2/curve/Curve_file.h>
#include <CGAL/Bounding_arcs_2/medial_axis/axis_certificate.h>
#include <CGAL/Bounding_arcs_2/medial_axis/maximal_disc.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <random>
#include <string>
#include <vector>

namespace test_axis_certificate {
namespace {

using namespace bounding_arcs_test;
using ba::Axis_certificate;
using ba::Edge_reason;
using ba::Edge_status;

Drawing bundled(const std::string& name) { return ba::read_drawing(BOUNDING_ARCS_EXAMPLE_DATA "/" + name + ".json"); }
const std::vector<std::string>& closed_names() {
  static const std::vector<std::string> all{"a_wrench", "b_angelfish", "c_letter_K", "d_rabbit",
                                            "e_cat",    "f_crow",      "g_chipmunk", "h_maple_leaf"};
  return all;
}
Axis_certificate certificate_of(const Drawing& drawing, const Medial_axis_2& axis) {
  return ba::internal::axis_certificate(ba::Drawing_hierarchy(drawing), axis);
}
void expect_proven(const Drawing& drawing, const Medial_axis_2& axis) {
  const Axis_certificate proof = certificate_of(drawing, axis);
  EXPECT_TRUE(proof.is_tiled);
  EXPECT_TRUE(proof.is_euler);
  EXPECT_TRUE(proof.is_proven());
  ASSERT_EQ(proof.edges.size(), axis.edges.size());
  for (const auto& e : proof.edges) {
    EXPECT_EQ(e.status, Edge_status::PROVEN) << name_of(e.reason);
    EXPECT_LE(e.bound, axis.eps);
    EXPECT_LE(e.bound, proof.bound);
  }
}

TEST(AxisCertificate, ProvesAllEdgesOfBundledCurves) {
  for (const std::string& name : closed_names())
    for (const double eps : {1e-4, 1e-6}) {
      SCOPED_TRACE(name);
      const Drawing drawing = bundled(name);
      expect_proven(drawing, axis_of(drawing, eps));
    }
}

TEST(AxisCertificate, ProvesAllEdgesOfRandomSplines) {
  int proven = 0;
  const int count = cases(80);
  for (int i = 0; i < count && !HasFailure(); ++i) {
    SCOPED_TRACE(i);
    std::mt19937 random(static_cast<unsigned>(i));
    const Drawing drawing = spline_field(random, 1, 1);
    expect_proven(drawing, axis_of(drawing, 1e-4));
    if (certificate_of(drawing, axis_of(drawing, 1e-6)).is_proven()) ++proven;
  }
  EXPECT_GE(proven, count * 97 / 100);  // next to leaves doubles may not tell at 1e-6
}

TEST(AxisCertificate, ProvesAllEdgesBetweenStraightSides) {
  const Drawing oblong = drawing_of(closed_chain({{0, 0}, {4, 0}, {4, 2}, {0, 2}}));
  const Axis_certificate proof = certificate_of(oblong, axis_of(oblong, 1e-4));
  EXPECT_TRUE(proof.is_proven());
  EXPECT_LE(proof.bound, 1e-11);  // lines are their own axis
  const Drawing ell = drawing_of(closed_chain({{0, 0}, {4, 0}, {4, 1}, {1, 1}, {1, 3}, {0, 3}}));
  expect_proven(ell, axis_of(ell, 1e-4));
}

// The distance, radius included, of a disc from the samples' lines next to one of them.
double distance_from(const ba::Medial_edge& edge, std::size_t line, const Point& center, double radius) {
  double least = HUGE_VAL;
  for (std::size_t i = line < 2 ? 0 : line - 2; i < (std::min)(line + 3, edge.samples.size() - 1); ++i) {
    const ba::Medial_sample &s = edge.samples[i], &t = edge.samples[i + 1];
    const Point chord = t.center - s.center, way = center - s.center;
    const double square = dot(chord, chord), share = square > 0 ? std::clamp(dot(way, chord) / square, 0.0, 1.0) : 0;
    const Point off = way - share * chord;
    least = (std::min)(least, std::hypot(off.x, off.y) + std::fabs(radius - s.radius - share * (t.radius - s.radius)));
  }
  return least;
}

// Maximal discs, found without an axis, at places between feet.
double measured(const ba::Maximal_discs_2& discs, const ba::Medial_edge& edge, std::size_t count) {
  double most = 0;
  const std::size_t lines = edge.samples.size() - 1, each = 1 + count / lines;
  for (std::size_t i = 0; i < lines; ++i) {
    const ba::Medial_sample &s = edge.samples[i], &t = edge.samples[i + 1];
    for (const auto& [a, b] : {std::pair(s.left, t.left), std::pair(s.right, t.right)}) {
      if (a.curve != b.curve || a.bezier != b.bezier || a.t == b.t) continue;
      for (std::size_t k = 1; k <= each; ++k) {
        ba::Curve_place p = a;
        p.t += (b.t - a.t) * static_cast<double>(k) / static_cast<double>(each + 1);
        const auto disc = discs(p);
        if (disc && disc->touches) most = (std::max)(most, distance_from(edge, i, disc->center, disc->radius));
      }
    }
  }
  return most;
}

TEST(AxisCertificate, HoldsMaximalDiscsWithinTwiceWhatTheyAreOff) {
  const std::size_t count = FEW_CASES ? 20 : 500;  // places on each side
  for (const std::string name : {"a_wrench", "c_letter_K", "h_maple_leaf"}) {
    const Drawing drawing = bundled(name);
    const ba::Drawing_hierarchy curves(drawing);
    const ba::Maximal_discs_2 discs(curves);
    for (const double eps : {1e-4, 1e-6}) {
      const Medial_axis_2 axis = axis_of(drawing, eps);
      const Axis_certificate proof = certificate_of(drawing, axis);
      constexpr double ROUNDING = 1e-11;  // of maximal discs next to leaves
      for (std::size_t i = 0; i < axis.edges.size(); ++i) {
        const double seen = measured(discs, axis.edges[i], count);
        EXPECT_LE(seen, proof.edges[i].bound + ROUNDING) << name << ", edge " << i;
        if (FEW_CASES) continue;
        EXPECT_LE(proof.edges[i].bound, 2 * seen + ROUNDING) << name << ", edge " << i;
      }
    }
  }
}

TEST(AxisCertificate, ScalesWithTheDrawing) {
  const Drawing drawing = drawing_of(closed_chain({{0, 0}, {4, 0}, {4, 1}, {1, 1}, {1, 3}, {0, 3}}));
  std::vector<Bezier> chain;
  for (const Bezier& b : drawing.curves()[0].beziers) {
    std::vector<Point> points = b.control_points();
    for (Point& p : points) p = 0x1p200 * p;
    chain.emplace_back(points);
  }
  const Drawing huge = drawing_of(chain);
  const Axis_certificate one = certificate_of(drawing, axis_of(drawing, 0x1p-14)),
                         other = certificate_of(huge, axis_of(huge, 0x1p186));
  EXPECT_TRUE(other.is_proven());
  EXPECT_NEAR(other.bound, 0x1p200 * one.bound, 0x1p200 * 1e-6);
}

// What is broken is not proven.
class UnprovenAxis : public testing::Test {
 protected:
  UnprovenAxis() : drawing_(bundled("d_rabbit")), axis_(axis_of(drawing_, 1e-4)) {}
  template <class Change> [[nodiscard]] Axis_certificate broken_by(const Change& change) {
    Medial_axis_2 broken = axis_;
    change(broken);
    return certificate_of(drawing_, broken);
  }
  Drawing drawing_;
  Medial_axis_2 axis_;
};

TEST_F(UnprovenAxis, HasFeetThatLeaveAPartOut) {
  const Axis_certificate proof = broken_by([](auto& a) { a.edges.pop_back(); });
  EXPECT_FALSE(proof.is_tiled);
  EXPECT_FALSE(proof.is_euler);
  EXPECT_FALSE(proof.is_proven());
  for (const auto& e : proof.edges) EXPECT_EQ(e.reason, Edge_reason::ELSEWHERE);
}
TEST_F(UnprovenAxis, HasASampleThatIsMoved) {
  const Axis_certificate proof = broken_by([](auto& a) { a.edges[0].samples[1].center.x += 2e-4; });
  EXPECT_FALSE(proof.is_proven());
  EXPECT_EQ(proof.edges[0].status, Edge_status::ESTIMATED);
  EXPECT_TRUE(proof.edges[0].reason == Edge_reason::BAND || proof.edges[0].reason == Edge_reason::CELL);
}
TEST_F(UnprovenAxis, HasATighterTolerance) {
  const Axis_certificate proof = broken_by([](auto& a) { a.eps = 1e-5; });
  EXPECT_FALSE(proof.is_proven());
  EXPECT_TRUE(proof.is_tiled);
  EXPECT_GT(proof.bound, 1e-5);
  EXPECT_LE(proof.bound, 2e-4);  // which is still a bound
}
TEST_F(UnprovenAxis, HasFeetOnOtherCurves) {
  const Axis_certificate proof = broken_by([](auto& a) {
    auto& foot = a.edges[0].samples[1].left;
    foot.bezier = (foot.bezier + 20) % 44;
  });
  EXPECT_EQ(proof.edges[0].reason, Edge_reason::FEET);
}
TEST_F(UnprovenAxis, HasItsSidesSwapped) {
  const Axis_certificate proof = broken_by([](auto& a) {
    for (auto& s : a.edges[0].samples) std::swap(s.left, s.right);
  });
  EXPECT_EQ(proof.edges[0].reason, Edge_reason::CELL);
}

}  // namespace
}  // namespace test_axis_certificate
