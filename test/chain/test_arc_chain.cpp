// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Chains of arcs: how many arcs, whether bounds hold and are tight, common tangents, sides, degenerate curves.

#include "bundled_spirals.h"
#include "cases.h"
#include "random_spirals.h"

#include <CGAL/Bounding_arcs_2/chain/arc_chain.h>
#include "../../src/study/slope_integral.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <random>
#include <utility>
#include <vector>

namespace test_arc_chain {
namespace {

using namespace CGAL::Bounding_arcs;
using bounding_arcs_test::bundled_curves;
using bounding_arcs_test::cases;
using bounding_arcs_test::FEW_CASES;
using bounding_arcs_test::Spiral;
using Real = long double;  // of 64 bits: errors of 1e-19, far below what is looked at
using Vector = Xy<Real>;

constexpr Arc_chain::Continuity CONTINUITIES[] = {Arc_chain::Continuity::POSITION, Arc_chain::Continuity::TANGENT};

Real length(const Vector& v) { return std::sqrt(dot(v, v)); }

Vector curve_point(const Spiral& spiral, Real t) {
  std::vector<Vector> points;
  std::vector<Real> weights;
  for (const auto& p : spiral.curve().control_points()) points.push_back({p.x, p.y});
  for (const double w : spiral.curve().weights()) weights.push_back(w);
  return Bezier_curve_2<Real>(points, weights).point(t);
}

// An arc in long double: its directions, its points, and the signed distance to it, positive on its left.
struct Exact_arc {
  explicit Exact_arc(const Arc_chain::Arc& a)
      : from{a.from.x, a.from.y}, chord{a.to.x - Real(a.from.x), a.to.y - Real(a.from.y)}, b(a.bulge) {}
  Vector tangent(int end) const { return (1 - b * b) * chord + ((end == 0 ? -2 : 2) * b) * perp(chord); }
  Vector center() const { return from + Real(0.5) * chord + ((1 - b) * (1 + b) / (4 * b)) * perp(chord); }
  Real signed_distance(const Vector& p) const {
    const Vector q = p - from;
    if (dot(q, tangent(0)) < 0) return length(q) * (cross(chord, q) < 0 ? -1 : 1);
    if (dot(q - chord, tangent(1)) > 0) return length(q - chord) * (cross(chord, q) < 0 ? -1 : 1);
    // without the difference of two radii, which are large where the arc is flat
    const Real c = length(chord),
               twice = 2 * ((1 - b * b) * cross(chord, q) + 2 * b * dot(chord - q, q)) / (c * (1 + b * b));
    return twice / (1 + std::sqrt(1 - 4 * b * twice / ((1 + b * b) * c)));
  }
  Vector point(Real x) const {  // x in [0, 1]
    const Real angle = 4 * std::atan(b) * x, c = std::cos(angle), s = std::sin(angle);
    if (std::fabs(b) < 1e-12L) return from + x * chord;
    const Vector r = from - center();
    return center() + Vector{c * r.x - s * r.y, s * r.x + c * r.y};
  }
  Vector from, chord;
  Real b;
};

struct Distances {
  Real least = 0, greatest = 0;  // signed, from points of the curve to the arc
  Real size() const { return std::max(-least, greatest); }
};

Distances sampled(const Spiral& spiral, const Arc_chain::Arc& arc, int samples) {
  const Exact_arc exact(arc);
  Distances d;
  for (int i = 0; i <= samples; ++i) {
    const Real x = exact.signed_distance(curve_point(spiral, arc.t0 + (Real(arc.t1) - arc.t0) * i / samples));
    d.least = std::min(d.least, -x);  // the arc is on the curve's left where the curve is on its right
    d.greatest = std::max(d.greatest, -x);
  }
  return d;
}

double least_number(const std::vector<Spiral>& spirals, double eps, Arc_chain::Continuity continuity) {
  double integral = 0;
  for (const Spiral& s : spirals) integral += slope_integral(s);
  return continuity == Arc_chain::Continuity::TANGENT ? 2 * std::cbrt(cubic_factor::BIARC / eps) * integral
                                                      : std::cbrt(cubic_factor::ARC / eps) * integral;
}

TEST(ArcChain, HasFewArcsWithinEps) {
  for (const auto& curve : bundled_curves())
    for (const Arc_chain::Continuity continuity : CONTINUITIES)
      for (const double eps : {1e-4, 1e-5, 1e-6, 1e-8, 1e-10}) {
        if (FEW_CASES && eps < 1e-4) break;
        const Arc_chain chain = arc_chain(curve.spirals, eps, {continuity, Arc_chain::Side::BOTH});
        EXPECT_EQ(chain.status, Build_status::COMPLETE);
        EXPECT_LE(chain.error, eps);
        EXPECT_LE(chain.arcs.size(), 1.05 * least_number(curve.spirals, eps, continuity) + 2.0 * curve.spirals.size())
            << curve.name << ", eps " << eps;
      }
}

TEST(ArcChain, HasFewArcsOnEachSpiralSegment) {
  for (const auto& curve : bundled_curves())
    for (const Arc_chain::Continuity continuity : CONTINUITIES)
      for (const double eps : {1e-4, 1e-5, 1e-6}) {
        if (FEW_CASES && eps < 1e-4) break;
        std::vector<int> number(curve.spirals.size());
        for (const Arc_chain::Arc& arc : arc_chain(curve.spirals, eps, {continuity, Arc_chain::Side::BOTH}).arcs)
          ++number[arc.spiral];
        for (std::size_t i = 0; i < number.size(); ++i)
          EXPECT_LE(number[i], 1.05 * least_number({curve.spirals[i]}, eps, continuity) + 2)
              << curve.name << ", segment " << i << ", eps " << eps;
      }
}

// The position chain's arcs and, for small eps, the slope integral agree on how many are needed.
TEST(ArcChain, NeedsAsManyArcsAsTheSlopeOfCurvatureSays) {
  for (const auto& curve : bundled_curves()) {
    const double number = static_cast<double>(
        arc_chain(curve.spirals, 1e-9, {Arc_chain::Continuity::POSITION, Arc_chain::Side::BOTH}).arcs.size());
    EXPECT_GE(number, 0.99 * least_number(curve.spirals, 1e-9, Arc_chain::Continuity::POSITION));
  }
}

TEST(ArcChain, ErrorsBoundDistancesAndAreTight) {
  for (const Arc_chain::Continuity continuity : CONTINUITIES)
    for (const double eps : {1e-4, 1e-7}) {
      if (FEW_CASES && eps < 1e-4) break;
      Real loosest = 1, sum = 0;
      std::size_t arcs = 0;
      for (const std::size_t c : {0u, 3u, 5u}) {
        const auto& spirals = bundled_curves()[c].spirals;
        for (const Arc_chain::Arc& arc : arc_chain(spirals, eps, {continuity, Arc_chain::Side::BOTH}).arcs) {
          const Real distance = sampled(spirals[arc.spiral], arc, 40).size();
          ASSERT_LE(distance, arc.error);
          loosest = std::min(loosest, distance / arc.error);
          sum += distance / arc.error;
          ++arcs;
        }
      }
      EXPECT_GT(loosest, 0.75L);
      EXPECT_GT(sum / arcs, 0.98L) << "eps " << eps;
    }
}

TEST(ArcChain, ErrorsBoundDistancesOnRandomCurves) {
  std::mt19937 random(7);
  for (int i = 0; i < cases(60); ++i) {
    const auto spirals = spiral_segments(bounding_arcs_test::random_curve(random));
    for (const Arc_chain::Continuity continuity : CONTINUITIES)
      for (const Arc_chain::Side side : {Arc_chain::Side::BOTH, Arc_chain::Side::LEFT})
        for (const double eps : {1e-2, 1e-5}) {
          const Arc_chain chain = arc_chain(spirals, eps, {continuity, side});
          ASSERT_LE(chain.error, eps);
          for (const Arc_chain::Arc& arc : chain.arcs)
            ASSERT_LE(sampled(spirals[arc.spiral], arc, 12).size(), arc.error) << i;
        }
  }
}

// Bounds hold however much weights differ; what that costs is a factor, not its square.
TEST(ArcChain, ErrorsBoundDistancesWhereWeightsDiffer) {
  std::mt19937 random(19);
  const auto unit = [&] { return std::ldexp(static_cast<double>(random()), -32); };
  for (int i = 0; i < cases(60); ++i) {
    const auto points = bounding_arcs_test::random_curve(random, 2 + i % 4, false).control_points();
    const double spread = i % 2 == 0 ? 1e4 : 1e12;
    std::vector<double> weights;
    for (std::size_t k = 0; k < points.size(); ++k) weights.push_back(std::pow(spread, unit()));
    const auto spirals = spiral_segments(Bezier_curve_2<double>(points, weights));
    for (const Arc_chain::Continuity continuity : CONTINUITIES)
      for (const Arc_chain::Side side : {Arc_chain::Side::BOTH, Arc_chain::Side::LEFT}) {
        const Arc_chain chain = arc_chain(spirals, 1e-8, {continuity, side});
        ASSERT_LE(chain.error, spread * 1e-12) << i;
        for (std::size_t k = 0; k < chain.arcs.size(); k += 7) {
          const Arc_chain::Arc& arc = chain.arcs[k];
          ASSERT_LE(sampled(spirals[arc.spiral], arc, 8).size(), arc.error) << i;
        }
      }
  }
}

// Far from the origin rounding of coordinates is most of what errors close to the resolution consist of.
TEST(ArcChain, ErrorsBoundDistancesNearTheResolution) {
  std::mt19937 random(11);
  for (int i = 0; i < cases(40); ++i) {
    const auto curve = bounding_arcs_test::random_curve(random);
    std::vector<Xy<double>> points = curve.control_points();
    for (auto& p : points) p = p + Xy<double>{3e5, -7e5};
    const auto spirals = spiral_segments(Bezier_curve_2<double>(points, curve.weights()));
    for (const Arc_chain::Continuity continuity : CONTINUITIES)
      for (const Arc_chain::Arc& arc : arc_chain(spirals, 1e-8, {continuity, Arc_chain::Side::BOTH}).arcs)
        ASSERT_LE(sampled(spirals[arc.spiral], arc, 8).size(), arc.error) << i;
  }
}

// From points of the arc to the curve: by the nearest of some curve points, searched on between its neighbours.
TEST(ArcChain, ErrorsBoundDistancesFromTheArcToo) {
  const auto& spirals = bundled_curves()[0].spirals;
  for (const Arc_chain::Continuity continuity : CONTINUITIES)
    for (const Arc_chain::Arc& arc :
         arc_chain(spirals, FEW_CASES ? 1e-4 : 1e-5, {continuity, Arc_chain::Side::BOTH}).arcs)
      for (int i = 0; i <= 8; i += FEW_CASES ? 4 : 1) {
        const Vector p = Exact_arc(arc).point(Real(i) / 8);
        Real low = arc.t0, high = arc.t1;
        for (int k = 0; k < 80; ++k) {  // golden section: one minimum, as the curve runs along the arc
          const Real a = low + (high - low) * 0.382L, b = high - (high - low) * 0.382L;
          if (length(curve_point(spirals[arc.spiral], a) - p) < length(curve_point(spirals[arc.spiral], b) - p))
            high = b;
          else low = a;
        }
        ASSERT_LE(length(curve_point(spirals[arc.spiral], low) - p), arc.error);
      }
}

TEST(ArcChain, ArcsShareTheirEndsAndTangents) {
  for (const auto& curve : bundled_curves())
    for (const auto& [side, eps] : {std::pair(Arc_chain::Side::BOTH, 1e-4), std::pair(Arc_chain::Side::BOTH, 1e-6),
                                    std::pair(Arc_chain::Side::RIGHT, 1e-6)}) {
      const Arc_chain chain = arc_chain(curve.spirals, eps, {Arc_chain::Continuity::TANGENT, side});
      for (std::size_t i = 0; i < chain.arcs.size(); ++i) {
        const Arc_chain::Arc &a = chain.arcs[i], &b = chain.arcs[(i + 1) % chain.arcs.size()];
        ASSERT_EQ(std::memcmp(&a.to, &b.from, sizeof a.to), 0) << curve.name;
        const Vector u = Exact_arc(a).tangent(1), v = Exact_arc(b).tangent(0);
        constexpr Real ROUNDING = 1e-15;  // of the arcs' ends, coordinates near 1
        const Real angle = ROUNDING * (1 / length(Exact_arc(a).chord) + 1 / length(Exact_arc(b).chord));
        ASSERT_LT(std::fabs(cross(u, v)), angle * dot(u, v)) << curve.name << ", arc " << i;
      }
    }
}

TEST(ArcChain, StaysOnItsSide) {
  for (const Arc_chain::Continuity continuity : CONTINUITIES)
    for (const Arc_chain::Side side : {Arc_chain::Side::LEFT, Arc_chain::Side::RIGHT})
      for (const std::size_t c : {1u, 4u}) {
        const auto& spirals = bundled_curves()[c].spirals;
        const Arc_chain chain = arc_chain(spirals, 1e-5, {continuity, side});
        EXPECT_LE(chain.error, 1e-5);
        for (const Arc_chain::Arc& arc : chain.arcs) {
          const Distances d = sampled(spirals[arc.spiral], arc, 20);
          constexpr Real ROUNDING = 1e-15;  // of coordinates near 1
          ASSERT_GE(side == Arc_chain::Side::LEFT ? d.least : -d.greatest, -ROUNDING);
        }
      }
}

Arc_chain chain_of(const Bezier_curve_2<double>& curve, double eps,
                   Arc_chain::Continuity continuity = Arc_chain::Continuity::TANGENT) {
  return arc_chain(spiral_segments(curve), eps, {continuity, Arc_chain::Side::BOTH});
}

TEST(ArcChain, OfLinesAndCirclesIsOnePieceEach) {
  for (const Arc_chain::Continuity continuity : CONTINUITIES) {
    const Arc_chain line = chain_of(Bezier_curve_2<double>({{0, 0}, {1, 2}, {1.5, 3}, {4, 8}}), 1e-3, continuity);
    ASSERT_EQ(line.arcs.size(), 1u);
    EXPECT_EQ(line.arcs[0].bulge, 0);
    const Arc_chain circle = chain_of(Bezier_curve_2<double>({{0, 1}, {1, 1}, {1, 0}}, {1, 1, 2}), 1e-9, continuity);
    ASSERT_EQ(circle.arcs.size(), 1u);
    EXPECT_NEAR(radius(circle.arcs[0]), 1, 1e-12);
    EXPECT_LT(circle.arcs[0].bulge, 0);
    const Arc_chain point = chain_of(Bezier_curve_2<double>({{1, 1}, {1, 1}, {1, 1}}), 1e-3, continuity);
    EXPECT_EQ(point.status, Build_status::COMPLETE);
  }
}

TEST(ArcChain, SaysWhenEpsIsBelowWhatCoordinatesResolve) {
  const Bezier_curve_2<double> curve({{1e6, 1e6}, {1e6 + 1, 1e6 + 2}, {1e6 + 3, 1e6 - 1}, {1e6 + 4, 1e6}});
  for (const Arc_chain::Continuity continuity : CONTINUITIES) {
    const Arc_chain chain = chain_of(curve, 1e-10, continuity);
    EXPECT_EQ(chain.status, Build_status::RESOLUTION_REACHED);
    EXPECT_GT(chain.error, 1e-10);
    EXPECT_LT(chain.error, 1e-7);
    EXPECT_EQ(chain_of(curve, 1e-6, continuity).status, Build_status::COMPLETE);
  }
}

TEST(ArcChain, RefusesWhatItCannotDo) {
  const auto spirals = spiral_segments(Bezier_curve_2<double>({{0, 0}, {1, 2}, {3, -1}, {4, 0}}));
  EXPECT_THROW((void)arc_chain(spirals, 0), std::invalid_argument);
  EXPECT_THROW((void)arc_chain(spirals, NAN), std::invalid_argument);
  const Bezier_curve_2<double> huge({{-1e223, -40}, {-128, -128}, {0.6, 0.3}});  // whose squares are no doubles
  EXPECT_THROW((void)arc_chain(spiral_segments(huge), 1e222), std::invalid_argument);
  const Arc_chain chain = arc_chain(spirals, 1e-8, {Arc_chain::Continuity::TANGENT, Arc_chain::Side::BOTH, 20});
  EXPECT_EQ(chain.status, Build_status::REGION_LIMIT);
  EXPECT_TRUE(chain.arcs.empty());
  const std::size_t needed = arc_chain(spirals, 1e-2).arcs.size();
  EXPECT_EQ(arc_chain(spirals, 1e-2, {Arc_chain::Continuity::TANGENT, Arc_chain::Side::BOTH, needed}).arcs.size(),
            needed);
  EXPECT_EQ(arc_chain(spirals, 1e-2, {Arc_chain::Continuity::TANGENT, Arc_chain::Side::BOTH, needed - 1}).status,
            Build_status::REGION_LIMIT);
}

TEST(ArcChain, IsTheSameForEveryInstructionSet) {
  for (const Arc_chain::Continuity continuity : CONTINUITIES)
    for (const double eps : {1e-5, 1e-9}) {
      const auto& spirals = bundled_curves()[2].spirals;
      const Arc_chain base =
          arc_chain(spirals, eps, {continuity, Arc_chain::Side::BOTH, 1'000'000, Build_options::Instruction_set::BASE});
      for (const Build_options::Instruction_set set :
           {Build_options::Instruction_set::AVX2, Build_options::Instruction_set::AVX512}) {
        const Arc_chain wide = arc_chain(spirals, eps, {continuity, Arc_chain::Side::BOTH, 1'000'000, set});
        ASSERT_EQ(wide.arcs.size(), base.arcs.size());
        static_assert(sizeof(Arc_chain::Arc) == 8 * sizeof(double) + sizeof(std::size_t), "no padding");
        EXPECT_EQ(std::memcmp(wide.arcs.data(), base.arcs.data(), base.arcs.size() * sizeof(Arc_chain::Arc)), 0);
      }
    }
}

// Of a cusp, whose tangent vector vanishes, the chain is the same run through either way.
TEST(ArcChain, TakesACuspAtEitherEnd) {
  const std::vector<Xy<double>> points{{0, 0}, {0, 0}, {1, 0}, {3, 3}};  // 3 (t^2, t^3)
  for (const Arc_chain::Continuity continuity : CONTINUITIES)
    for (const double eps : {1e-2, 1e-4, 1e-6}) {
      const Arc_chain from = chain_of(Bezier_curve_2<double>(points), eps, continuity),
                      to = chain_of(Bezier_curve_2<double>({points.rbegin(), points.rend()}), eps, continuity);
      for (const Arc_chain* chain : {&from, &to}) {
        EXPECT_EQ(chain->status, Build_status::COMPLETE);
        EXPECT_LE(chain->error, eps);
      }
      EXPECT_EQ(from.arcs.size(), to.arcs.size()) << eps;
      const Vector start = Exact_arc(from.arcs.front()).tangent(0), end = Exact_arc(to.arcs.back()).tangent(1);
      if (continuity == Arc_chain::Continuity::TANGENT) {
        EXPECT_NEAR(static_cast<double>(start.y / start.x), 0, 1e-15);
        EXPECT_NEAR(static_cast<double>(end.y / end.x), 0, 1e-15);
      }
    }
}

// Scaling by a power of two scales lengths by exactly that.
TEST(ArcChain, ScalesWithTheCurve) {
  const std::vector<Xy<double>> points{{0.1, 0.2}, {1.3, 2.1}, {3.2, -1.7}, {4.4, 0.3}};
  std::vector<Xy<double>> larger;
  for (const auto& p : points) larger.push_back(1024.0 * p);
  const Arc_chain a = chain_of(Bezier_curve_2<double>(points), 1e-6),
                  b = chain_of(Bezier_curve_2<double>(larger), 1024 * 1e-6);
  ASSERT_EQ(a.arcs.size(), b.arcs.size());
  EXPECT_EQ(1024 * a.error, b.error);
  for (std::size_t i = 0; i < a.arcs.size(); ++i) EXPECT_EQ(a.arcs[i].bulge, b.arcs[i].bulge);
}

}  // namespace
}  // namespace test_arc_chain
