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
#include <sstream>
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

// The height of the circle that touches at the start, over the chord: a difference of two lengths.
struct Height {
  template <class NT> Named_figures<NT> operator()(const Formula_piece<NT>& piece) const {
    const Chord_shape_2<NT>& f = piece.shape;
    const NT c = square_root(dot(f.chord, f.chord)) / NT(2), sine = absolute(f.cross0) / NT(2) / c;
    const NT r = c / sine * square_root(dot(f.tangent0, f.tangent0));
    return {{"height", NT(f.unit * (r - square_root(NT(r * r - c * c))))}};
  }
};

TEST(FormulaStudy, TakesFloat128) {
  Formula_study<Height> study("school", Height(), few_pieces());
  study.add<double>("double");
  study.add<__float128>("quad");
  study.add<Quad>("class");
  auto errors = largest(study);
  EXPECT_GT(errors["quad height"], 0);
  EXPECT_LT(errors["quad height"], 1e-15 * errors["double height"]);
  EXPECT_EQ(errors["quad height"], errors["class height"]);
}

TEST(Quad, RootsAreWithinOneUlp) {
  for (const double x : {2.0, 0.3, 1e300, 1e-300, 4.0, 7e-310}) {
    const Quad root = sqrt(Quad(x) / 3), rest = root * root - Quad(x) / 3;
    EXPECT_LE(std::fabs(static_cast<double>(rest / root / root)), 3 * 0x1p-112) << x;  // 2 of the root, 1 of the square
  }
  EXPECT_EQ(static_cast<double>(sqrt(Quad(0))), 0);
  EXPECT_TRUE(std::isnan(static_cast<double>(sqrt(Quad(-1)))));
}

TEST(FormulaStudy, RowsHaveBothFiguresAndWhereTheyAreOf) {
  Formula_study<Height> study("school", Height(), few_pieces());
  study.add<double>("double");
  ASSERT_FALSE(study.rows().empty());
  for (const Stability_row& row : study.rows()) {
    ASSERT_TRUE(row.computed && row.exact);
    const double off = static_cast<double>((row.computed->value.x - row.exact->value.x).hi);
    EXPECT_NEAR(std::fabs(off), row.abs_error, 1e-6 * row.abs_error);
    EXPECT_EQ(row.frame, "in place");
    EXPECT_EQ(row.placement, few_pieces().front().placement);
  }
}

// The height of an arc of radius r over a chord c is about c^2 / (8 r). Its formula takes away some u r of that.
TEST(FormulaStudy, ConditionsTellWhatTheFormulaLost) {
  Formula_study<Height> study("school", Height(), few_pieces());
  study.add<double>("double");
  for (const Stability_row& row : study.with_conditions(study.rows())) {
    ASSERT_TRUE(row.condition);
    EXPECT_GT(*row.condition, 1);
    EXPECT_LT(*row.condition, 100);
  }
  Formula_study<Thickness> ours("bca", Thickness(), few_pieces());
  ours.add<double>("double");
  for (const Stability_row& row : ours.with_conditions(ours.rows())) {
    const auto spiral = spiral_holding(Bezier_curve_2<double>(row.control_points, row.weights), row.t0, row.t1);
    const auto known = figure_conditions(*spiral, row.t0, row.t1, "bca");
    ASSERT_TRUE(known && row.condition);
    EXPECT_NEAR(*row.condition, known->thickness, 1e-9 * known->thickness);
  }
}

TEST(FormulaStudy, HuntsForTheWorstCaseOfAFormula) {
  const std::vector<Study_piece> pieces = few_pieces();
  Formula_study<Height> study("school", Height(), pieces);
  study.add<double>("double");
  const double before = largest(study)["double height"];
  Worst_case_hunt hunt = study.hunt<double>("double", 3), again = study.hunt<double>("double", 3);
  while (hunt.steps() < 400) hunt.step();
  while (again.steps() < 400) again.step();
  ASSERT_EQ(hunt.worst().rows().size(), 1u);
  const Stability_row& found = hunt.worst().rows().front();
  EXPECT_GT(found.rel_error, 1.2 * before);
  EXPECT_EQ(found.rel_error, again.worst().rows().front().rel_error);
  EXPECT_EQ(found.method, "school");
  EXPECT_EQ(found.family, "hunt");
  EXPECT_EQ(found.placement, pieces.front().placement);  // it climbed from one of them
  // What is found is measured again from its row.
  const auto spiral = spiral_holding(Bezier_curve_2<double>(found.control_points, found.weights), found.t0, found.t1);
  ASSERT_TRUE(spiral);
  Formula_study<Height> once("school", Height(), {{"once", 1, *spiral, found.t0, found.t1}});
  once.add<double>("double");
  EXPECT_EQ(once.rows().front().rel_error, found.rel_error);
}

TEST(FormulaStudy, HuntsFromRandomSpiralsWithoutPieces) {
  Worst_case_hunt hunt = Formula_study<Height>("school", Height(), {}).hunt<Randomly_rounded>("random", 3);
  while (hunt.steps() < 5) hunt.step();
  EXPECT_EQ(hunt.worst().rows().front().placement, "random");
}

TEST(AddPlaced, MakesFamiliesOfOnesOwn) {
  std::vector<Study_piece> pieces;
  for (const double delta : {1.0, 0.1})
    add_placed(pieces, "own", delta, Bezier_curve_2<double>({{0, 0}, {1, delta}, {2, 0}}));
  ASSERT_EQ(pieces.size(), 10u);
  EXPECT_EQ(pieces[7].number, 7u);
  EXPECT_EQ(pieces[7].delta, 0.1);
  EXPECT_EQ(pieces[0].placement, "as given");
  EXPECT_EQ(pieces[9].placement, "turned, moved, reversed");
  EXPECT_EQ(pieces[1].spiral.curve().control_points()[0].x, 2);
}

TEST(WriteCsv, HasAFieldForEachName) {
  Formula_study<Height> study("school, \"own\"", Height(), few_pieces());
  study.add<double>("double");
  std::stringstream out;
  write_csv(out, {study.rows().front()});
  std::string names, line, more;
  std::getline(out, names);
  std::getline(out, line);
  EXPECT_FALSE(std::getline(out, more));
  EXPECT_EQ(names.substr(0, 48), "family,delta,method,formula,kernel,quantity,rel_");
  std::vector<std::string> fields(1);
  bool is_quoted = false;
  for (const char c : line) {
    if (c == '"') is_quoted = !is_quoted;
    if (c == ',' && !is_quoted) fields.emplace_back();
    else fields.back() += c;
  }
  EXPECT_EQ(static_cast<long>(fields.size()), 1 + std::count(names.begin(), names.end(), ','));
  EXPECT_EQ(fields[2], "\"school, \"\"own\"\"\"");
  EXPECT_EQ(std::stod(fields[6]), study.rows().front().rel_error);
  const double computed = std::stod(fields[8]), exact = std::stod(fields[9]);
  EXPECT_NEAR(computed, exact, 1e-9 * exact);
  EXPECT_GT(fields[9].size(), 30u);  // far more digits than a double has
  EXPECT_EQ(fields[14].substr(0, 19), "\"{\"\"type\"\":\"\"bezier");
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
