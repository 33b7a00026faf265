// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Closest points of curves of one's own, and arcs along them: a clothoid, an arc of a circle, and Bezier curves by
// their jets beside what a tree of them says.

#include "cases.h"

#include <CGAL/Bounding_arcs_2.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <vector>

namespace test_own_curves {
namespace {

using namespace CGAL::Bounding_arcs;
using Kernel = CGAL::Circular_kernel_2<CGAL::Simple_cartesian<double>, CGAL::Algebraic_kernel_for_circles_2_2<double>>;
constexpr double RELATIVE_ERROR = 1e-15;
template <class Curve> using Regions = Region_hierarchy_2<Bca_traits_2<Kernel>, Jet_spiral_2<Curve>>;

// At the length s the tangent angle is s^2 / 2.
struct Clothoid {
  [[nodiscard]] End_jet_2<double> jet(double s) const {
    const double angle = s * s / 2;
    Xy<double> point;
    double term = s;
    for (int n = 0; n < 24; ++n) {
      (n % 2 == 0 ? point.x : point.y) += (n % 4 < 2 ? term : -term) / (2 * n + 1);
      term *= angle / (n + 1);
    }
    return {point, {std::cos(angle), std::sin(angle)}, {-s * std::sin(angle), s * std::cos(angle)}};
  }
};

struct Unit_circle {
  [[nodiscard]] End_jet_2<double> jet(double t) const {
    const double c = std::cos(t), s = std::sin(t);
    return {{c, s}, {-s, c}, {-c, -s}};
  }
};

struct Bezier_by_jets {
  const Bezier_curve_2<double>* curve;
  [[nodiscard]] End_jet_2<double> jet(double t) const {
    const auto c = curve->taylor_expansion(t, 2);
    return {c[0], c[1], 2.0 * c[2]};
  }
};

double sampled_distance(const Xy<double>& q, double t0, double t1) {
  constexpr int SAMPLES = 4000;
  double least = HUGE_VAL;
  for (int i = 0; i <= SAMPLES; ++i) {
    const Xy<double> p = Clothoid().jet(t0 + (t1 - t0) * i / SAMPLES).point;
    least = (std::min)(least, std::hypot(p.x - q.x, p.y - q.y));
  }
  return least;
}

TEST(OwnCurves, HaveClosestPointsInCertifiedBrackets) {
  const Regions<Clothoid> regions({{Clothoid(), 0, 1.5, RELATIVE_ERROR}}, 1e-2);
  std::mt19937_64 random(63);
  std::uniform_real_distribution<double> coordinate(-1, 2);
  for (int i = 0; i < 200; ++i) {
    const Xy<double> q{coordinate(random), coordinate(random)};
    const double sampled = sampled_distance(q, 0, 1.5);
    for (const double eps : {1e-2, 1e-6, 1e-11}) {
      const auto found = closest_point(regions, q, eps);
      ASSERT_TRUE(found);
      EXPECT_EQ(found->status, Query_status::COMPLETE);
      EXPECT_LE(found->distance.width(), eps);
      EXPECT_LE(found->distance.lower, sampled + 1e-15) << q;
      EXPECT_GE(found->distance.upper, sampled - 2e-4) << q;  // a sample is as near to the foot
      const Xy<double> p = Clothoid().jet(found->t).point;
      EXPECT_LE(std::hypot(p.x - found->point.x, p.y - found->point.y), 1e-14);
      EXPECT_NEAR(std::hypot(p.x - q.x, p.y - q.y), found->distance.upper, 1e-14);
    }
  }
}

TEST(OwnCurves, AreAsFarFromTheCenterOfACircle) {
  const Regions<Unit_circle> regions({{Unit_circle(), 0, 1.5, RELATIVE_ERROR}}, 1e-3);
  const auto found = closest_point(regions, CGAL::Epick::Point_2(0, 0), 1e-12);
  ASSERT_TRUE(found);
  EXPECT_LE(found->distance.lower, 1);
  EXPECT_GE(found->distance.upper, 1);
  EXPECT_LE(found->distance.width(), 1e-12);
  const auto any = closest_point(regions, CGAL::Epick::Point_2(0, 0), HUGE_VAL);  // whichever is looked at first
  ASSERT_TRUE(any);
  EXPECT_LE(any->distance.lower, 1);
  EXPECT_NEAR(any->distance.upper, 1, 1e-12);
}

TEST(OwnCurves, TellWhatTheirErrorsLeaveOpen) {
  constexpr double ROUGH = 1e-6;
  const Regions<Clothoid> regions({{Clothoid(), 0, 1.5, ROUGH}}, 1e-2);
  const auto found = closest_point(regions, Xy<double>{0.5, 0.25}, 1e-9);
  ASSERT_TRUE(found);
  EXPECT_EQ(found->status, Query_status::RESOLUTION_REACHED);
  EXPECT_LE(found->distance.width(), 100 * ROUGH);
  const Arc_chain chain = arc_chain(regions, 1e-9);
  EXPECT_EQ(chain.status, Build_status::RESOLUTION_REACHED);
  EXPECT_GE(chain.error, ROUGH);
  EXPECT_LE(chain.error, 100 * ROUGH);
  EXPECT_EQ(arc_chain(regions, 1e-4, 2).status, Build_status::REGION_LIMIT);
}

TEST(OwnCurves, RefuseWhatIsNoQuestion) {
  const Regions<Clothoid> regions({{Clothoid(), 0, 1.5, RELATIVE_ERROR}}, 1e-2);
  EXPECT_THROW((void)closest_point(regions, Xy<double>{std::nan(""), 0}, 1e-3), std::invalid_argument);
  EXPECT_THROW((void)closest_point(regions, Xy<double>{0, 0}, 0), std::invalid_argument);
  EXPECT_THROW((void)arc_chain(regions, -1), std::invalid_argument);
  EXPECT_FALSE(closest_point(Regions<Clothoid>({}, 1e-2), Xy<double>{0, 0}, 1e-3));
  EXPECT_TRUE(arc_chain(Regions<Clothoid>({}, 1e-2), 1e-3).arcs.empty());
}

TEST(OwnCurves, BecomeChainsWithinTheirErrors) {
  const Regions<Clothoid> regions({{Clothoid(), 0, 0.75, RELATIVE_ERROR}, {Clothoid(), 0.75, 1.5, RELATIVE_ERROR}},
                                  1e-2);
  for (const double eps : {1e-2, 1e-4, 1e-8}) {
    const Arc_chain chain = arc_chain(regions, eps);
    EXPECT_EQ(chain.status, Build_status::COMPLETE);
    ASSERT_FALSE(chain.arcs.empty());
    EXPECT_EQ(chain.arcs.front().t0, 0);
    EXPECT_EQ(chain.arcs.back().t1, 1.5);
    for (std::size_t i = 0; i < chain.arcs.size(); ++i) {
      const Arc_chain::Arc& arc = chain.arcs[i];
      EXPECT_LE(arc.error, eps);
      if (i > 0) {
        EXPECT_EQ(arc.t0, chain.arcs[i - 1].t1);
        EXPECT_EQ(arc.from, chain.arcs[i - 1].to);
      }
      double farthest = 0;
      for (int k = 0; k <= 20; ++k)
        farthest = (std::max)(
            farthest, std::fabs(signed_distance(Clothoid().jet(arc.t0 + (arc.t1 - arc.t0) * k / 20).point, arc)));
      EXPECT_LE(farthest, arc.error);
      EXPECT_GE(farthest, i + 1 < chain.arcs.size() ? 0.05 * arc.error : 0) << "bound of arc " << i;
    }
  }
}

// Random Bezier spirals, by their jets and as a tree.
TEST(OwnCurves, AnswerAsATreeOfTheSameCurves) {
  std::mt19937_64 random(64);
  std::uniform_real_distribution<double> coordinate(-2, 2);
  for (int i = 0; i < bounding_arcs_test::cases(40); ++i) {
    std::vector<Xy<double>> points;
    for (int k = 0; k < 4; ++k) points.push_back({coordinate(random), coordinate(random)});
    const Bezier_curve_2<double> curve(points);
    Drawing_2<double> drawing;
    drawing.add({curve});
    const Bounding_arc_tree_2 tree(drawing);
    std::vector<Jet_spiral_2<Bezier_by_jets>> spirals;
    for (const auto& s : spiral_segments(curve))
      spirals.emplace_back(Bezier_by_jets{&curve}, s.first(), s.last(), 1e-13);
    const Regions<Bezier_by_jets> regions(spirals, 1e-2);
    for (int k = 0; k < 10; ++k) {
      const Xy<double> q{coordinate(random), coordinate(random)};
      const auto own = closest_point(regions, q, 1e-7);
      const auto known = closest_point(tree, q);
      ASSERT_TRUE(own && known);
      EXPECT_LE(own->distance.lower, known->distance.upper);
      EXPECT_GE(own->distance.upper, known->distance.lower);
    }
  }
}

}  // namespace
}  // namespace test_own_curves
