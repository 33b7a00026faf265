// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Hunts find the same again, pieces of spirals only, and errors above those of random spirals. The worst cases that
// were found keep the promise of stable formulas.

#include <CGAL/Bounding_arcs_2/curve/Curve_file.h>
#include <CGAL/Bounding_arcs_2/study/Worst_case_hunt.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <stdexcept>
#include <string>

namespace test_worst_case_hunt {
namespace {

using namespace CGAL::Bounding_arcs;

constexpr double PROMISED = 16 * 0x1p-52;
const Stability_choice THICKNESS{{"bca"}, {"stable"}, {"double"}, {"thickness"}};

Worst_case_hunt hunted(const Stability_choice& choice, std::size_t steps) {
  Worst_case_hunt hunt(choice, 5);
  while (hunt.steps() < steps) hunt.step();
  return hunt;
}

TEST(WorstCaseHunt, FindsTheSameInAsManySteps) {
  const Worst_case_hunt first = hunted(THICKNESS, 200), again = hunted(THICKNESS, 200);
  ASSERT_EQ(first.worst().rows().size(), 1u);
  EXPECT_EQ(first.worst().rows()[0].rel_error, again.worst().rows()[0].rel_error);
  EXPECT_EQ(first.worst().rows()[0].control_points, again.worst().rows()[0].control_points);
}

TEST(WorstCaseHunt, ClimbsAboveItsStart) {
  const double start = hunted(THICKNESS, 60).worst().rows()[0].rel_error;
  const Stability_row found = hunted(THICKNESS, 300).worst().rows()[0];
  EXPECT_GT(found.rel_error, start);
  EXPECT_LE(found.rel_error, PROMISED);
  EXPECT_GT(found.number, 60u);
  const auto spiral = spiral_holding(Bezier_curve_2<double>(found.control_points, found.weights), found.t0, found.t1);
  ASSERT_TRUE(spiral);
  EXPECT_EQ(stability_rows(*spiral, found.t0, found.t1, THICKNESS)[0].rel_error, found.rel_error);
}

TEST(WorstCaseHunt, NeedsAFigure) {
  EXPECT_THROW(Worst_case_hunt({{"bca"}, {}, {}, {"joint"}}, 1), std::invalid_argument);
}

// Found by `bounding_arcs stability --hunt-steps`; names tell the figure and its error then.
TEST(WorstCases, ThatWereFoundKeepThePromise) {
  const auto records = read_curve_file(BOUNDING_ARCS_TEST_DATA "/study/worst_cases.json").curves;
  EXPECT_GE(records.size(), 11u);
  double worst = 0;
  for (const Curve_record& record : records) {
    const auto spiral = spiral_holding(record.bezier_pieces<double>().front(), record.part[0], record.part[1]);
    ASSERT_TRUE(spiral) << record.name;
    for (const Stability_row& row :
         stability_rows(*spiral, record.part[0], record.part[1],
                        {{}, {"stable"}, {"double", "filtered"}, {"center", "radius", "joint", "thickness"}})) {
      EXPECT_LE(row.rel_error, PROMISED) << record.name << ": " << row.method << ' ' << row.quantity;
      worst = (std::max)(worst, row.rel_error);
    }
  }
  EXPECT_GT(worst, PROMISED / 4);  // they are what they were
}

}  // namespace
}  // namespace test_worst_case_hunt
