// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Studies of one's own formulas and number types: errors are those that the library's own study has, of enclosures that
// of the farther end, and what random rounding estimates is near the true error.

#include <CGAL/Bounding_arcs_2/region/Bca.h>
#include <CGAL/Bounding_arcs_2/study/Formula_study.h>
#include <CGAL/Bounding_arcs_2/study/Randomly_rounded.h>
#include <CGAL/Bounding_arcs_2/study/stability_families.h>

#include <CGAL/Interval_nt.h>

#include <boost/multiprecision/cpp_bin_float.hpp>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <string>
#include <vector>

namespace test_formula_study {
namespace {

using namespace CGAL::Bounding_arcs;

struct Thickness {
  template <class NT> Named_figures<NT> operator()(const Formula_piece<NT>& piece) const {
    return {{"thickness", Bca::thickness(piece.shape)}};
  }
};

// Two pieces of each of three lengths.
std::vector<Study_piece> few_pieces() {
  std::vector<Study_piece> pieces;
  for (const Study_piece& piece : subdivision_family())
    if (piece.number % 5 == 0 && piece.delta > 0x1p-8) pieces.push_back(piece);
  return pieces;
}

TEST(FormulaStudy, HasTheErrorsOfTheLibrarysOwnStudy) {
  Formula_study<Thickness> study("bca", Thickness(), few_pieces());
  study.add<float>("float");
  study.add<long double>("long-double");
  Worst_rows worst;
  for (const Study_piece& piece : few_pieces())
    worst.add(piece, stability_rows(piece.spiral, piece.t0, piece.t1,
                                    {{"bca"}, {"stable"}, {"float", "long-double"}, {"thickness"}}));
  EXPECT_EQ(study.undecided(), 0u);
  ASSERT_EQ(study.rows().size(), worst.rows().size());
  for (const Stability_row& row : study.rows())
    for (const Stability_row& other : worst.rows()) {
      if (row.kernel != other.kernel || row.delta != other.delta) continue;
      EXPECT_DOUBLE_EQ(row.rel_error, other.rel_error) << row.kernel << ", delta " << row.delta;
      EXPECT_EQ(row.control_points, other.control_points);
    }
}

// The largest errors over all delta by kernel and quantity.
template <class Formula> std::map<std::string, double> largest(const Formula_study<Formula>& study) {
  std::map<std::string, double> errors;
  for (const Stability_row& row : study.rows()) {
    double& error = errors[row.kernel + " " + row.quantity];
    error = (std::max)(error, row.rel_error);
  }
  return errors;
}

struct Bend {
  template <class NT> Named_figures<NT> operator()(const Formula_piece<NT>& piece) const {
    return {{"bend", NT(piece.shape.cross0 / dot(piece.shape.chord, piece.shape.chord))}};
  }
};

TEST(FormulaStudy, MoreDigitsHaveSmallerErrors) {
  using Fifty = boost::multiprecision::number<boost::multiprecision::cpp_bin_float<50>, boost::multiprecision::et_off>;
  using Five = boost::multiprecision::number<boost::multiprecision::cpp_bin_float<5>, boost::multiprecision::et_off>;
  Formula_study<Bend> study("bend", Bend(), few_pieces());
  study.add<Five>("five");
  study.add<double>("double");
  study.add<Double_double>("twofold");
  study.add<Fifty>("fifty");
  auto errors = largest(study);
  EXPECT_GT(errors["five bend"], 1e-6);
  EXPECT_LT(errors["five bend"], 1);
  EXPECT_GT(errors["double bend"], 1e-17);
  EXPECT_LT(errors["double bend"], 1e-13);
  EXPECT_LT(errors["twofold bend"], 1e-27);
  EXPECT_GT(errors["fifty bend"], 0);
  EXPECT_LT(errors["fifty bend"], 1e-45);
}

TEST(FormulaStudy, TakesTheFartherEndOfEnclosures) {
  Formula_study<Bend> study("bend", Bend(), few_pieces());
  study.add<double>("double");
  study.add<CGAL::Interval_nt<true>>("interval");
  study.add<Bounded_double>("bounded");
  auto errors = largest(study);
  EXPECT_GT(errors["interval bend"], errors["double bend"]);
  EXPECT_GT(errors["bounded bend"], errors["double bend"]);
  EXPECT_LT(errors["interval bend"], 1e-12);
  EXPECT_LT(errors["bounded bend"], 1e-12);
}

// The side of the chord's middle moved by some ulp of float.
struct Side {
  template <class NT> Named_figures<NT> operator()(const Formula_piece<NT>& piece) const {
    const Xy<NT> p = piece.curve.point(piece.t0), q = piece.curve.point(piece.t1);
    const NT half(0.5), tiny(0x1p-30);
    const Xy<NT> r = half * (p + q) + tiny * perp(q - p);
    return {{"side", Verdict{sign_of(cross(q - p, r - p))}}};
  }
};

TEST(FormulaStudy, CountsWrongVerdictsAsOne) {
  Formula_study<Side> study("side", Side(), few_pieces());
  study.add<float>("float");
  study.add<double>("double");
  EXPECT_EQ(study.undecided(), 0u);
  auto errors = largest(study);
  EXPECT_EQ(errors["float side"], 1);
  EXPECT_EQ(errors["double side"], 0);
}

struct Open_comparison {
  template <class NT> Named_figures<NT> operator()(const Formula_piece<NT>& piece) const {
    const NT root = square_root(NT(2));
    return {{"zero", piece.t0 < piece.t0 + (root - root) ? root : NT(1)}};
  }
};

TEST(FormulaStudy, TellsHowManyPiecesStayUndecided) {
  const std::vector<Study_piece> pieces(3, few_pieces().front());
  Formula_study<Open_comparison> study("open", Open_comparison(), pieces);
  study.add<double>("double");
  EXPECT_EQ(study.undecided(), 3u);
  EXPECT_TRUE(study.rows().empty());
}

TEST(RandomlyRounded, ExactResultsStayWhatTheyAre) {
  const Randomly_rounded x = (Randomly_rounded(3) + 5) * 0.25 / 2 - 4;
  EXPECT_EQ(static_cast<double>(x), -3);
  EXPECT_EQ(x.estimated_error(), 0);
  EXPECT_EQ(x.digits(), 15);
  EXPECT_EQ(static_cast<double>(sqrt(Randomly_rounded(2.25))), 1.5);
  EXPECT_EQ(static_cast<double>(abs(x)), 3);
}

TEST(RandomlyRounded, RoundsToBothNeighbours) {
  int other = 0;
  for (int i = 3; i < 203; i += 2) {
    const Randomly_rounded q = Randomly_rounded(1) / i, r = sqrt(Randomly_rounded(i)),
                           s = Randomly_rounded(1) + 0x1p-60 * i, p = Randomly_rounded(1 + 0x1p-40 * i) * (1 + 0x1p-40);
    for (const Randomly_rounded* x : {&q, &r, &s, &p}) {
      const double mean = static_cast<double>(*x);
      EXPECT_LE(x->estimated_error(), 2 * 0x1p-52 * mean);
      other += x->estimated_error() > 0 ? 1 : 0;
    }
    EXPECT_NEAR(static_cast<double>(q), 1.0 / i, 0x1p-53);
    EXPECT_NEAR(static_cast<double>(r), std::sqrt(i), 0x1p-48);
  }
  EXPECT_GT(other, 300);  // of 400: eight runs agree once in 128
}

TEST(RandomlyRounded, EstimatesAreNearTheErrors) {
  Formula_study<Thickness> study("bca", Thickness(), few_pieces());
  study.add<Randomly_rounded>("random");
  const auto errors = largest(study);
  const double error = errors.at("random thickness"), estimate = errors.at("random thickness, estimated");
  EXPECT_GT(error, 0);
  EXPECT_GT(estimate, error / 30);
  EXPECT_LT(estimate, error * 30);
  const Randomly_rounded nothing = Randomly_rounded(1) / 3 * 3 - 1;
  EXPECT_LT(nothing.digits(), 1);
}

}  // namespace
}  // namespace test_formula_study
