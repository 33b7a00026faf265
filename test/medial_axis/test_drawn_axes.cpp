// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Axes of random drawings as people make them: complete, and right within what is told of them.

#include "counted_faults.h"
#include "drawn_axis_checks.h"
#include "drawn_shapes.h"

#include <CGAL/Bounding_arcs_2/medial_axis/axis_certificate.h>
#include <CGAL/Bounding_arcs_2/medial_axis/medial_axis.h>
#include <CGAL/Bounding_arcs_2/verify/verify_axis.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <iostream>
#include <iterator>
#include <random>
#include <utility>
#include <vector>

namespace test_drawn_axes {

using namespace bounding_arcs_test;

class DrawnAxes : public testing::TestWithParam<Drawn_kind> {};

TEST_P(DrawnAxes, AreWholeAndRight) {
  expect_no_faults(200, [&](std::mt19937& random) {
    const Axis_case drawn = GetParam().make(random);
    told_of(drawn, [&] { check_case(drawn, random); });
  });
}

// Of turns that coordinates do not tell nothing is promised.
std::vector<Drawn_kind> kinds_with_a_promise() {
  std::vector<Drawn_kind> kinds;
  std::copy_if(std::begin(DRAWN_KINDS), std::end(DRAWN_KINDS), std::back_inserter(kinds),
               [](const Drawn_kind& kind) { return kind.proven > 0; });
  return kinds;
}
class PromisedAxes : public testing::TestWithParam<Drawn_kind> {};

TEST_P(PromisedAxes, AreProven) {
  int proven = 0, all = 0;
  expect_no_faults(40, [&](std::mt19937& random) {
    const Axis_case drawn = GetParam().make(random);
    told_of(drawn, [&] {
      const ba::Medial_axis_2 axis = axis_of_case(drawn, 1e-4 * size_of(drawn.drawing));
      ++all;
      if (axis.status == ba::Medial_axis_2::Status::COMPLETE &&
          ba::axis_certificate(ba::Bounding_arc_tree_2(drawn.drawing), axis).is_proven())
        ++proven;
    });
  });
  if (std::getenv("BOUNDING_ARCS_CASES") != nullptr) std::cout << proven << " of " << all << " proven\n";
  EXPECT_GE(100 * (proven + 1), GetParam().proven * all) << proven << " of " << all;
}

void require_verified(const Axis_case& drawn, double eps) {
  told_of(drawn, [&] {
    const ba::Medial_axis_2 axis = axis_of_case(drawn, eps);
    if (axis.status != ba::Medial_axis_2::Status::COMPLETE) throw Fault("unresolved", "");
    if (!axis.is_valid()) throw Fault("invalid", "");
    const auto found = ba::verify_axis(drawn.drawing, axis, {drawn.options.rule, false, {}});
    if (!found.is_right()) throw Fault("not verified", found.findings.front().place);
  });
}

// Arcs that end a rounding beside the lines that they turn into: feet go on along them, cells tile all parts.
TEST(MachineParts, OfFewDecimalsAreVerified) {
  expect_no_faults(60, [](std::mt19937& random) {
    const Axis_case drawn = machine_part(random);
    require_verified(drawn, 3e-4 * size_of(drawn.drawing));
  });
}

// At 10^6 coordinates tell 10^-10, and products of them far less.
TEST(MachineParts, InTheCoordinatesOfACountryAreVerified) {
  expect_no_faults(60, [](std::mt19937& random) {
    Axis_case drawn = machine_part(random);
    const double eps = 3e-4 * size_of(drawn.drawing);
    constexpr Point PLACES[] = {{350000, 5800000}, {2600000, 1200000}, {-1e6, 1e6}};
    const Point& place = one_of(random, PLACES);
    Drawing moved;
    for (const auto& curve : drawn.drawing.curves())
      moved.add(mapped_chain(curve.beziers, [&](const Point& p) { return p + place; }));
    drawn.drawing = std::move(moved);
    require_verified(drawn, eps);
  });
}

INSTANTIATE_TEST_SUITE_P(Kinds, DrawnAxes, testing::ValuesIn(DRAWN_KINDS),
                         [](const auto& kind) { return kind.param.name; });
INSTANTIATE_TEST_SUITE_P(Kinds, PromisedAxes, testing::ValuesIn(kinds_with_a_promise()),
                         [](const auto& kind) { return kind.param.name; });

}  // namespace test_drawn_axes
