// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// What Gappa has proven holds on random spirals, arcs and cubics. Hypotheses of hint files, which it takes as they are,
// are therefore true there. It holds, too, where a hunt has found that a figure errs most, and is not far above that.
// The worst errors are in the test's report.

#include <CGAL/Bounding_arcs_2/number/strict_math.h>

#include "cases.h"
#include "proven_figures.h"
#include "proven_goals.h"
#include "random_spirals.h"
#include "rounding_cases.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <fstream>
#include <iomanip>
#include <map>
#include <random>
#include <string>

namespace test_proven_bounds {
namespace {

using namespace CGAL::Bounding_arcs;
using namespace bounding_arcs_test;

constexpr unsigned SEED = 20261121;

// Errors of some figures beside their bounds.
class Worst_errors {
 public:
  void add(const Figures<double>& rounded, const Figures<long double>& exact, const std::string& where) {
    for (const auto& [name, x] : rounded) {
      const Figure<long double>& y = exact.at(name);
      const auto error = static_cast<double>(std::fabs((x.value - y.value) / y.size) / HALF_ULP);
      EXPECT_LE(error, goals_.at(name)) << name << " of " << where;
      worst_[name] = std::max(worst_[name], error);
    }
  }
  void report() const {
    for (const auto& [name, error] : worst_)
      testing::Test::RecordProperty(name, std::to_string(error) + " u, bound " + std::to_string(goals_.at(name)));
  }

 private:
  std::map<std::string, double> goals_ = proven_goals(), worst_;
};

constexpr Shape_parts PARTS{true, false};

// With 11 bits more, which do for errors of doubles.
Chord_shape_2<long double> exact_shape(const Piece& p) {
  return p.spiral.shape<Exact>(p.t0, p.t1, PARTS).over<long double>([](const Exact& x) {
    const Double_double d = to_double_double(x);
    return static_cast<long double>(d.hi) + d.lo;
  });
}

TEST(ProvenBounds, HoldOnRandomSpirals) {
  Worst_errors errors;
  const double most_ratios = 0.25;  // what bounds of bilens are proven for
  for (const Piece& piece : random_pieces(SEED, static_cast<std::size_t>(cases(3000)), 12)) {
    const auto f = piece.spiral.accurate_shape(piece.t0, piece.t1, PARTS);
    if (!f.proper || !f.tight_first || f.infinite0 || !f.turns_one_way || !tight_frame(f).usable) continue;
    const Figures<long double> exact = frame_figures(exact_shape(piece));
    Figures<double> rounded = frame_figures(f);
    if (exact.at("ratio_a").value * exact.at("ratio_b").value > most_ratios)
      for (const char* name : {"contact_flat", "bilens_thickness"}) rounded.erase(name);
    errors.add(rounded, exact, text(piece));
  }
  errors.report();
}

// Those of vectors are larger than those of coordinates by the root of 2 at most.
TEST(ProvenBounds, AreWithinConstantsOfTheLibrary) {
  const std::map<std::string, double> goals = proven_goals();
  constexpr double OF_FOOT = 22;  // by hand: an end is taken for the foot, or the foot for an end
  EXPECT_LE(goals.at("distance") + OF_FOOT, ARC_DISTANCE_ERROR / HALF_ULP);
  const Bezier_evaluator cubic(Bezier_curve_2<double>({{0, 0}, {1, 0}, {1, 1}, {0, 1}}));
  const double root = std::sqrt(2.0);
  EXPECT_LE(root * goals.at("point"), cubic.point_error() / HALF_ULP);
  EXPECT_LE(root * goals.at("first"), cubic.first_error() / HALF_ULP);
  EXPECT_LE(root * goals.at("second"), cubic.second_error() / HALF_ULP);
}

Xy<long double> longer(const Xy<double>& p) { return {p.x, p.y}; }

TEST(ProvenBounds, HoldOnRandomArcs) {
  Worst_errors errors;
  std::mt19937 random(SEED);
  std::uniform_real_distribution<double> coordinate(-1, 1), exponent(-20, 0);
  const auto point = [&] { return Xy<double>{coordinate(random), coordinate(random)}; };
  for (int i = cases(100000); i > 0; --i) {
    const Xy<double> from = point(), to = point(), q = std::exp2(-exponent(random)) * point();
    const double bulge = std::exp2(exponent(random));
    if (view(q, from, to, bulge).nearest_end >= 0) continue;
    errors.add(arc_figures(q, from, to, bulge), arc_figures<long double>(longer(q), longer(from), longer(to), bulge),
               "an arc");
  }
  errors.report();
}

TEST(ProvenBounds, HoldOnRandomCubics) {
  Worst_errors errors;
  std::mt19937 random(SEED);
  std::uniform_real_distribution<double> coordinate(-1, 1);
  for (int i = cases(100000); i > 0; --i) {
    Xy<double> p[4];
    Xy<long double> exact[4];
    for (int k = 0; k < 4; ++k) {
      p[k] = {coordinate(random), coordinate(random)};
      exact[k] = longer(p[k]);
    }
    const double t = std::fabs(coordinate(random));
    errors.add(cubic_figures(p, t), cubic_figures<long double>(exact, t), "a cubic");
  }
  errors.report();
}

// BOUNDING_ARCS_CASES=1000 hunts for a minute or so, and BOUNDING_ARCS_WORST=FILE writes what is found.
TEST(ProvenBounds, AreAtMostFourTimesTheWorstThatAHuntFinds) {
  const std::map<std::string, double> goals = proven_goals();
  const char* const written = std::getenv("BOUNDING_ARCS_WORST");
  std::mt19937_64 random(SEED);
  std::ofstream out(written == nullptr ? "" : written);
  std::set<std::string> figures;
  for (Rounding_case& c : read_rounding_cases(BOUNDING_ARCS_TEST_DATA "/study/worst_roundings.txt")) {
    const double goal = goals.at(c.figure);
    constexpr double MOST = 4;
    ASSERT_TRUE(rounding_error(c)) << c.figure << ": its bound is not for this case";
    EXPECT_LE(goal, MOST * *rounding_error(c)) << c.figure;
    climb(c, cases(120), random);
    const double error = *rounding_error(c);
    EXPECT_LE(error, goal) << c.figure;
    testing::Test::RecordProperty(c.figure, std::to_string(error) + " u");
    figures.insert(c.figure);
    out << "# " << std::setprecision(3) << error << " u\n" << c.figure << std::setprecision(21);
    for (const long double x : c.inputs) out << ' ' << x;
    out << '\n';
  }
  EXPECT_EQ(figures.size(), 22U) << "as many as rows of doc/error_bounds.md";
}

}  // namespace
}  // namespace test_proven_bounds
