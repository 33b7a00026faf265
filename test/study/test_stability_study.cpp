// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The stability study: figures of stable formulas stay within the promised ulp on every family, textbook ones lose
// digits where expected, and its tables tell that.

#include <CGAL/Bounding_arcs_2/region/Bca_traits_2.h>
#include <CGAL/Bounding_arcs_2/region/Bilens_traits_2.h>
#include <CGAL/Bounding_arcs_2/region/Spiral_fat_arc_traits_2.h>
#include <CGAL/Bounding_arcs_2/study/Stability_study.h>
#include <CGAL/Bounding_arcs_2/study/Worst_case_hunt.h>
#include <CGAL/Bounding_arcs_2/study/stability_families.h>
#include <CGAL/Bounding_arcs_2/verify/Certified_traits_2.h>

#include "cases.h"
#include "random_spirals.h"

#include <CGAL/Algebraic_kernel_for_circles_2_2.h>
#include <CGAL/Circular_kernel_2.h>
#include <CGAL/Simple_cartesian.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <set>
#include <string>
#include <vector>

namespace test_stability_study {
namespace {

using namespace CGAL::Bounding_arcs;
using bounding_arcs_test::cases;
using bounding_arcs_test::random_curve;
using Curve = Bezier_curve_2<double>;

constexpr unsigned SEED = 20261121;
constexpr double ULP = 0x1p-52, PROMISED = 16 * ULP;
const std::vector<std::string> METHODS{"bca", "sfa", "bilens"};

const Stability_choice FIGURES{{}, {}, {}, {"center", "radius", "joint", "thickness"}};  // without outside

bool is_rounded_to_double(const Stability_row& row) { return row.kernel == "double" || row.kernel == "filtered"; }

// All stable rows of double keep the promise; returns how many there were.
std::size_t expect_digits(const Study_piece& piece, const std::vector<Stability_row>& rows) {
  std::size_t count = 0;
  for (const Stability_row& r : rows) {
    if (!is_rounded_to_double(r) || r.formula != "stable") continue;
    ++count;
    EXPECT_LE(r.rel_error, PROMISED) << piece.family << ", delta " << piece.delta << ": " << r.method << ' ' << r.kernel
                                     << ' ' << r.quantity << " of "
                                     << bounding_arcs_test::Piece{piece.spiral, piece.t0, piece.t1};
  }
  return count;
}

// One piece in three, unless more cases are asked for: each delta keeps some of each curve, and three deltas together
// have all placements.
std::vector<Study_piece> thinned(const std::vector<Study_piece>& family) {
  const std::size_t step = cases(1) > 1 ? 1 : 3;
  std::vector<Study_piece> pieces;
  for (std::size_t i = 0; i < family.size(); i += step) pieces.push_back(family[i]);
  return pieces;
}

std::vector<Stability_row> study(const std::vector<Study_piece>& family, std::size_t& stable_rows) {
  Worst_rows worst;
  stable_rows = 0;
  for (const Study_piece& piece : family) {
    const auto rows = stability_rows(piece.spiral, piece.t0, piece.t1, FIGURES);
    stable_rows += expect_digits(piece, rows);
    worst.add(piece, rows);
  }
  return worst.rows();
}

// What a study holds for one method, formula and quantity in double, at delta up to a limit.
std::vector<double> errors(const std::vector<Stability_row>& rows, const std::string& method,
                           const std::string& formula, const std::string& quantity, double largest_delta) {
  std::vector<double> found;
  for (const Stability_row& r : rows)
    if (r.method == method && r.formula == formula && r.quantity == quantity && r.kernel == "double" &&
        r.delta <= largest_delta)
      found.push_back(r.rel_error);
  return found;
}

constexpr std::size_t ROWS_OF_A_KERNEL = 3 + 4 + 4;  // center, radius, thickness of BCA; joints too of SFA and bilens
constexpr double ALL_LOST = 0.5;                     // relative error: not even the first digit is right
constexpr double NARROW = 1e-8;                      // delta from which on the paper's steps have no digit left

TEST(StabilityStudy, ShowsTextbookThicknessLostOnNearLinearPieces) {
  std::size_t stable_rows = 0;
  const auto family = thinned(near_linear_family());
  const auto rows = study(family, stable_rows);
  EXPECT_GT(stable_rows, family.size() / 2 * 2 * ROWS_OF_A_KERNEL);
  for (const std::string& method : METHODS) {
    const auto lost = errors(rows, method, "textbook", "thickness", NARROW);
    ASSERT_EQ(lost.size(), 77u) << method;
    EXPECT_GT(*std::min_element(lost.begin(), lost.end()), ALL_LOST) << method;
  }
}

TEST(StabilityStudy, ShowsTextbookBilensLostOnNearCircularPieces) {
  std::size_t stable_rows = 0;
  std::vector<Study_piece> family;  // all places, as centers are right or wrong by luck, of one delta in three
  for (const Study_piece& piece : near_circular_family())
    if (std::ilogb(piece.delta) % 3 == 0) family.push_back(piece);
  const auto rows = study(family, stable_rows);
  EXPECT_EQ(stable_rows, family.size() * 2 * ROWS_OF_A_KERNEL);
  for (const char* quantity : {"center", "radius", "joint", "thickness"}) {
    const auto lost = errors(rows, "bilens", "textbook", quantity, NARROW);
    ASSERT_EQ(lost.size(), 9u);
    EXPECT_GT(*std::min_element(lost.begin(), lost.end()), ALL_LOST) << quantity;
  }
  const auto kept =
      errors(rows, "sfa", "textbook", "center", NARROW);  // the osculating circles do not depend on differences
  EXPECT_LT(*std::max_element(kept.begin(), kept.end()), PROMISED);
}

TEST(StabilityStudy, ShowsTextbookThicknessLostAfterSubdivision) {
  std::size_t stable_rows = 0;
  const auto family = subdivision_family();
  const auto rows = study(family, stable_rows);
  EXPECT_EQ(stable_rows, family.size() * 2 * ROWS_OF_A_KERNEL);
  for (const std::string& method : METHODS) {
    const auto lost = errors(rows, method, "textbook", "thickness", 0x1p-20);
    ASSERT_EQ(lost.size(), 21u);
    EXPECT_GT(*std::min_element(lost.begin(), lost.end()), ALL_LOST) << method;
  }
}

TEST(StabilityStudy, KeepsItsPromiseOnRandomSpirals) {
  const auto count = static_cast<std::size_t>(cases(120));
  std::size_t stable_rows = 0;
  const auto rows = study(random_family(count, SEED), stable_rows);
  EXPECT_GT(stable_rows, count * 2 * ROWS_OF_A_KERNEL * 9 / 10);
  double worst = 0;
  for (const Stability_row& r : rows)
    if (is_rounded_to_double(r) && r.formula == "stable") worst = std::max(worst, r.rel_error);
  RecordProperty("worst_in_ulp", std::to_string(worst / ULP));
}

std::vector<Stability_row> rows_of(const Curve& curve) {
  const auto spirals = spiral_segments(curve);
  EXPECT_EQ(spirals.size(), 1u);
  return stability_rows(spirals[0], 0, 1, FIGURES);
}

TEST(StabilityRows, FilteredFiguresAreThoseOfDouble) {
  const auto rows = rows_of(Curve({{0, 0}, {0.5, 0}, {1, 0.3}}));
  EXPECT_EQ(rows.size(), 4 * 2 * ROWS_OF_A_KERNEL);
  for (const Stability_row& d : rows)
    for (const Stability_row& f : rows) {
      const bool is_pair =
          d.kernel == "double" && f.kernel == "filtered" && d.formula == "stable" && f.formula == "stable";
      if (!is_pair || d.method != f.method || d.quantity != f.quantity) continue;
      EXPECT_EQ(d.rel_error, f.rel_error) << d.method << ' ' << d.quantity;
    }
}

// The errors of kernels grow as their digits get fewer, so each is measured in its own numbers.
TEST(StabilityRows, KernelsDiffer) {
  const auto rows = rows_of(Curve({{0, 0}, {0.5, 0}, {1, 0.3}}));
  for (const Stability_row& r : rows) {
    if (r.formula != "stable" || r.quantity != "thickness") continue;
    const bool is_float = r.kernel == "float", is_long = r.kernel == "long-double";
    EXPECT_EQ(r.rel_error > PROMISED, is_float) << r.method << ' ' << r.kernel;
    EXPECT_LT(r.rel_error, is_float ? 1e-5 : (is_long ? ULP / 2 : PROMISED)) << r.method << ' ' << r.kernel;
  }
}

TEST(StabilityRows, InfiniteRadiusAndNoThicknessAreExactOnLines) {
  const auto rows = rows_of(Curve({{0.1, 0.2}, {1.1, 1.2}}));
  std::size_t stable_rows = 0;
  for (const Stability_row& r : rows) {
    EXPECT_EQ(r.method, "bca");
    if (r.formula != "stable") continue;
    ++stable_rows;
    EXPECT_EQ(r.rel_error, 0) << r.kernel << ' ' << r.quantity;
    EXPECT_EQ(r.abs_error, 0) << r.kernel << ' ' << r.quantity;
  }
  EXPECT_EQ(stable_rows, 4u * 3u);
}

TEST(StabilityRows, AnOsculatingLineIsALineInAllStableKernels) {
  const auto spirals = spiral_segments(Curve({{0, 0}, {1, 0}, {2, 0}, {3, 1}}));  // inflection at the start
  const auto rows = stability_rows(spirals[0], 0, spirals[0].last(), FIGURES);
  EXPECT_EQ(expect_digits({"inflection", 0, spirals[0], 0, spirals[0].last()}, rows), 2 * ROWS_OF_A_KERNEL);
  std::set<std::string> methods;
  for (const Stability_row& r : rows) {
    methods.insert(r.method);
    const bool has_no_center =
        r.method != "bca" && r.formula == "textbook" && r.kernel == "double" && r.quantity == "radius";
    EXPECT_TRUE(!has_no_center || r.rel_error == 1) << r.method;
  }
  EXPECT_EQ(methods.size(), 3u);
}

TEST(StabilityRows, ThicknessOfACircularArcIsNothing) {
  const auto rows = rows_of(Curve({{1, 0}, {1, 1}, {0, 1}}, {1, 1, 2}));
  for (const Stability_row& r : rows) {
    EXPECT_EQ(r.method, "bca");
    const bool is_nothing = is_rounded_to_double(r) && r.formula == "stable" && r.quantity == "thickness";
    EXPECT_TRUE(!is_nothing || r.abs_error == 0) << r.kernel;
  }
  EXPECT_EQ(rows.size(), 4u * 2u * 3u);
}

// One of the random spirals. The flat end's curvature and the angle of the inner segment to its tangent are small,
// which an angle formed as a difference would not survive: 105 ulp.
TEST(StabilityRows, KeepTheDigitsOfAnAlmostStraightOuterArc) {
  const Curve curve(
      {{6.04352303876329e-12, -6.7131642110626501e-12},
       {4.8173020082415914e-12, -6.8622928486915811e-12},
       {5.7496855776694457e-12, -6.8160383042560005e-12},
       {5.5815130971073004e-12, -5.582687279605742e-12},
       {6.3152983623213987e-12, -8.4821173739987733e-12},
       {5.9791219213540176e-12, -6.0569547058613399e-12},
       {5.6286783987185572e-12, -4.8878906502296598e-12},
       {7.5609999416444981e-12, -4.0330746708644836e-12},
       {7.013751179492262e-12, -8.5016629930520836e-12}},
      {0.41751883025624431, 3.8099382185430457, 1.3354034095437695, 0.65139029888699962, 1.5735171634366771,
       0.64702277253631557, 0.57139165884046372, 3.5053774926766175, 1.3158774268188704});
  for (const auto& spiral : spiral_segments(curve)) {
    if (spiral.first() != 0.097625040106307862) continue;
    const Study_piece piece{"straight arc", 0, spiral, spiral.first(), 0.11752562488316187};
    EXPECT_EQ(expect_digits(piece, stability_rows(spiral, piece.t0, piece.t1, FIGURES)), 2 * ROWS_OF_A_KERNEL);
    return;
  }
  FAIL() << "the spiral is not there";
}

TEST(StabilityRows, TinySizesKeepTheirDigits) {
  for (const auto& spiral : spiral_segments(Curve({{0, 0}, {1e-150, 2e-150}, {2e-150, -1e-150}}, {1, 2, 0.5})))
    expect_digits({"tiny", 0, spiral, spiral.first(), spiral.last()},
                  stability_rows(spiral, spiral.first(), spiral.last(), FIGURES));
}

using Double_kernel =
    CGAL::Circular_kernel_2<CGAL::Simple_cartesian<double>, CGAL::Algebraic_kernel_for_circles_2_2<double>>;

// Rounded regions leave out a little of the curve; what the certified ones leave out is 0.
template <class Traits> void expect_certified(const Study_piece& piece) {
  const auto region =
      Certified_traits_2<Traits>().construct_certified_region_2_object()(piece.spiral, piece.t0, piece.t1);
  EXPECT_TRUE(std::isfinite(region.widening)) << piece.family << ", delta " << piece.delta;
  EXPECT_TRUE(is_within(piece.spiral, piece.t0, piece.t1, region.boundary, region.widening))
      << piece.family << ", delta " << piece.delta;
}

TEST(StabilityStudy, NothingIsOutsideOfCertifiedRegions) {
  for (const auto& family : {near_linear_family(), near_circular_family(), subdivision_family()})
    for (const Study_piece& piece : family) {
      expect_certified<Bca_traits_2<Double_kernel>>(piece);
      expect_certified<Spiral_fat_arc_traits_2<Double_kernel>>(piece);
      expect_certified<Bilens_traits_2<Double_kernel>>(piece);
    }
}

TEST(StabilityRows, OutsideIsARoundingOfThePlaceForStableFormulas) {
  const auto spirals = spiral_segments(Curve({{0, 0}, {0.5, 0}, {1, 0.3}}));
  const double chord = std::hypot(1, 0.3);
  const auto rows = stability_rows(spirals[0], 0, 1, {{}, {}, {}, {"outside"}});
  EXPECT_EQ(rows.size(), 3u * 2u * 4u);
  for (const Stability_row& r : rows) {
    EXPECT_EQ(r.quantity, "outside");
    EXPECT_LE(r.abs_error, r.kernel == "float" ? 1e-6 : (r.kernel == "long-double" ? ULP / 2 : PROMISED))
        << r.method << ' ' << r.kernel << ' ' << r.formula;
    EXPECT_TRUE(r.kernel != "float" || r.abs_error > ULP) << r.method << ' ' << r.formula;
    EXPECT_NEAR(r.rel_error, r.abs_error / chord, ULP * r.rel_error);
  }
}

// What is left out is not above the floor, and what is not has the figures that it has without one.
TEST(StabilityRows, OutsideUpToAFloorIsLeftOut) {
  const auto spirals = spiral_segments(Curve({{0, 0}, {0.5, 0}, {1, 0.3}}));
  Stability_choice choice{{}, {}, {}, {"outside"}};
  const auto all = stability_rows(spirals[0], 0, 1, choice);
  const double floor = 1e-12;  // between float and the others
  choice.floor = [&](const Stability_row&) { return floor; };
  const auto above = stability_rows(spirals[0], 0, 1, choice);
  ASSERT_EQ(above.size(), 3u * 2u);
  for (const Stability_row& r : above) {
    const auto is_same = [&](const Stability_row& other) {
      return r.method == other.method && r.formula == other.formula && r.kernel == other.kernel &&
             r.rel_error == other.rel_error && r.abs_error == other.abs_error;
    };
    EXPECT_EQ(r.kernel, "float");
    EXPECT_EQ(std::count_if(all.begin(), all.end(), is_same), 1);
  }
}

// On a piece of size 1, where nothing is small, they keep the digits of their type; a box is the chord's side.
TEST(StabilityRows, ComparedMethodsHaveAThickness) {
  const auto spirals = spiral_segments(Curve({{0, 0}, {0.5, 0}, {1, 0.3}}));
  const std::vector<std::string> methods{"fat-arc", "fat-biarc", "box", "oriented-box", "hull"};
  const auto rows = stability_rows(spirals[0], 0, 1, {methods, {}, {}, {}});
  ASSERT_EQ(rows.size(), 5u * 3u);
  double of_float = 0;
  for (const Stability_row& r : rows) {
    const double unit = r.kernel == "float" ? 0x1p-24 : (r.kernel == "double" ? 0x1p-53 : 0x1p-64);
    EXPECT_EQ(r.quantity, "thickness");
    EXPECT_LE(r.rel_error, unit * (r.method == "box" ? 4 : 256)) << r.method << ' ' << r.kernel;
    if (r.kernel == "float") of_float = (std::max)(of_float, r.rel_error);
  }
  EXPECT_GT(of_float, ULP);
  EXPECT_TRUE(stability_rows(spirals[0], 0, 1, {{"box"}, {"stable"}, {}, {}}).empty());
  EXPECT_FALSE(figure_conditions(spirals[0], 0, 1, "box"));
}

TEST(StabilityRows, OnlyWhatIsChosenIsMeasured) {
  const auto spirals = spiral_segments(Curve({{0, 0}, {0.5, 0}, {1, 0.3}}));
  const auto all = stability_rows(spirals[0], 0, 1);
  const auto rows = stability_rows(spirals[0], 0, 1, {{"sfa"}, {"textbook"}, {"float", "filtered"}, {"joint"}});
  ASSERT_EQ(rows.size(), 2u);
  for (const Stability_row& r : rows)
    for (const Stability_row& other : all) {
      const bool is_same = r.method == other.method && r.formula == other.formula && r.kernel == other.kernel &&
                           r.quantity == other.quantity;
      EXPECT_TRUE(!is_same || r.rel_error == other.rel_error);
    }
}

// A normal's direction is a difference of coordinates of size 1. A bisector's constant is rounded at |p| |chord|, so
// that its place is lost by about u |p| / |chord| of the chord's length.
TEST(StabilityRows, StepsTellWhereDigitsAreLost) {
  const double chord = 0x1p-20, place = std::hypot(0.3, 0.7);
  const auto spirals = spiral_segments(Curve({{0.3, 0.7}, {0.8, 0.7}, {1.3, 1.1}, {1.4, 1.9}}));
  const auto& spiral = spirals.front();
  const double t0 = spiral.first() + 0.1, t1 = t0 + chord / 1.5;  // |C'| is about 1.5
  const auto rows = stability_rows(spiral, t0, t1, {{}, {}, {"double"}, {"normal", "bisector"}});
  ASSERT_EQ(rows.size(), 3u * 2u + 1u + 1u);  // no bisectors of SFA, nor of stable formulas
  for (const Stability_row& r : rows) {
    EXPECT_TRUE(r.quantity == "bisector" || r.rel_error <= PROMISED) << r.method << ' ' << r.formula;
    if (r.quantity != "bisector" || r.method != "bca") continue;
    EXPECT_EQ(r.formula, "textbook");
    EXPECT_LT(r.rel_error, 8 * ULP * place / chord);
    EXPECT_GT(r.rel_error, ULP * place / chord / 64);
  }
}

// Tangents of a parabola are differences of control points, its foot is the chord's half.
TEST(FigureConditions, OfNormalsAndBisectorsHaveClosedForms) {
  const auto spirals = spiral_segments(Curve({{0, 0}, {0.5, 0}, {1, 0.3}}));
  const auto c = figure_conditions(spirals[0], 0, 1, "bca");
  ASSERT_TRUE(c);
  EXPECT_NEAR(c->normal, (0.5 * 0.3 + 1 * 0.3 + 0.3 * 0.5) / (0.5 * 0.5 + 0.3 * 0.3), 1e-12);
  EXPECT_NEAR(c->bisector, (1 + 0.3) / std::hypot(1, 0.3), 1e-12);
}

TEST(StabilityRows, APointHasNone) { EXPECT_TRUE(rows_of(Curve({{1, 1}, {1, 1}})).empty()); }

// A row is of one curve: the absolute error of another one does not come into it.
TEST(WorstRows, AreOfTheCurveWithTheLargestRelativeError) {
  const auto family = random_family(2, SEED);
  Stability_row small{{}, 0, "bca", "stable", "double", "radius", 1e-16, 3}, large = small, other = small;
  large.rel_error = 1e-15;
  large.abs_error = 1;
  other.quantity = "thickness";
  Worst_rows by_delta, of_all(false);
  for (Worst_rows* worst : {&by_delta, &of_all}) {
    EXPECT_EQ(worst->floor(family[0], small), -1);
    worst->add(family[0], {small, other});
    worst->add(family[1], {large});
    worst->add(family[1], {small});
    EXPECT_EQ(worst->floor(family[1], small), 1e-15);
  }
  ASSERT_EQ(by_delta.rows().size(), 3u);
  ASSERT_EQ(of_all.rows().size(), 2u);
  for (const Stability_row& row : {by_delta.rows()[2], of_all.rows()[0]}) {
    EXPECT_EQ(row.rel_error, 1e-15);
    EXPECT_EQ(row.abs_error, 1);
    EXPECT_EQ(row.delta, 1);
    EXPECT_EQ(row.number, 1u);
    EXPECT_EQ(row.control_points, family[1].spiral.curve().control_points());
    EXPECT_EQ(row.weights, family[1].spiral.curve().weights());
    EXPECT_EQ(row.t0, family[1].t0);
    EXPECT_EQ(row.t1, family[1].t1);
  }
  EXPECT_EQ(of_all.rows()[1].delta, 0);
}

// What rows tell suffices to measure them again.
TEST(WorstRows, AreMeasuredAgainFromTheirCurves) {
  Worst_rows worst(false);
  for (const Study_piece& piece : random_family(20, SEED))
    worst.add(piece, stability_rows(piece.spiral, piece.t0, piece.t1, FIGURES));
  for (const Stability_row& row : worst.rows()) {
    const auto spiral = spiral_holding(Curve(row.control_points, row.weights), row.t0, row.t1);
    ASSERT_TRUE(spiral);
    const auto again =
        stability_rows(*spiral, row.t0, row.t1, {{row.method}, {row.formula}, {row.kernel}, {row.quantity}});
    ASSERT_EQ(again.size(), 1u);
    EXPECT_EQ(again[0].rel_error, row.rel_error);
    EXPECT_EQ(again[0].abs_error, row.abs_error);
  }
}

TEST(TextbookFormulas, AgreeWithTheStableOnesWhereNothingIsSmall) {
  std::mt19937 random(SEED);
  int pieces = 0;
  for (int i = 0; i < 200; ++i)
    for (const auto& spiral : spiral_segments(random_curve(random))) {
      const auto f = spiral.shape<double>(spiral.first(), spiral.last());
      const auto t = tight_frame(f);
      const bool is_large = t.usable && t.chord > 0.05 && t.sin_delta > 0.02 && t.k_flat > 0.02 && t.k_tight < 20;
      if (!is_large) continue;
      ++pieces;
      for (const Stability_row& r : stability_rows(spiral, spiral.first(), spiral.last(), FIGURES))
        EXPECT_TRUE(r.rel_error <= 1e-8 || !is_rounded_to_double(r))
            << "curve " << i << ' ' << r.method << ' ' << r.kernel << ' ' << r.quantity;
    }
  EXPECT_GT(pieces, 50);
}

}  // namespace
}  // namespace test_stability_study
