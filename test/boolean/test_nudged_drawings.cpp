// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Boolean operations of drawings that differ by rounding: right to the last bit, and complete.

#include "counted_faults.h"
#include "kernel_trees.h"
#include "outline_areas.h"
#include "overlay_checks.h"
#include "winding_oracle.h"

#include <CGAL/Bounding_arcs_2.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cstddef>
#include <iterator>
#include <random>
#include <string>

namespace test_nudged_drawings {

using namespace bounding_arcs_test;

class NudgedDrawings : public testing::TestWithParam<Nudged_kind> {
 protected:
  // How many cases: a second or less of each.
  static constexpr int MANY = 40, SOME = 12, FEW = 4;

  template <class Check> static void expect_of_pairs(int count, const Check& check) {
    expect_no_faults(count, [&](std::mt19937& random) {
      const Drawing_pair pair = GetParam().pair(random);
      told("", pair.a, pair.b, [&] { check(pair, random); });
    });
  }
  static void expect_most_asked(const Asked_points& points) {
    EXPECT_LE(2 * points.left_out, points.asked) << "too many points are too near to rounded curves";
  }

  static void require_identities(const Drawing& a, const Drawing& b, const Operation& how, std::mt19937& random,
                                 Asked_points& points) {
    const Operation all{Boolean_operation::UNION, how.rule_a, how.rule_a},
        nothing{Boolean_operation::DIFFERENCE, how.rule_a, how.rule_a},
        without{Boolean_operation::DIFFERENCE, how.rule_a, how.rule_b},
        with{Boolean_operation::INTERSECTION, how.rule_a, how.rule_b};
    const Combined own = checked<Filtered_tree>(a, a, all, random, points);
    if (!combined<Filtered_tree>(a, a, nothing).outline.chains.empty())
      throw Fault("identity", "a drawing without itself is not empty");
    const Combined outer = combined<Filtered_tree>(a, b, without), inner = combined<Filtered_tree>(a, b, with),
                   united = checked<Filtered_tree>(outer.drawn.drawing, inner.drawn.drawing, all, random, points);
    const Checked_outline outlines[] = {{a, b, without, outer},
                                        {a, b, with, inner},
                                        {outer.drawn.drawing, inner.drawn.drawing, all, united},
                                        {a, a, all, own}};
    const double eps = area_eps(a, b), moved = outlines[0].swept_by_drawing() + outlines[1].swept_by_drawing();
    require_same(sum(outlines[2].area(eps), {-moved, moved}), outlines[3].area(eps), "what is made of the parts");
    const ba::Bounding_arc_tree_2 of_parts(united.drawn.drawing), of_all(a);
    const double error = (std::max)({outer.drawn.moved, inner.drawn.moved, united.drawn.moved});
    for (int i = 0; i < 12; ++i) {
      const Point q = outlines[3].random_point(random);
      ++points.asked;
      if (std::any_of(std::begin(outlines), std::end(outlines),
                      [&](const auto& o) { return o.is_near_rounded(q, error); })) {
        ++points.left_out;
        continue;
      }
      const auto w = ba::Point_location_2(of_parts).winding_number(q),
                 v = ba::Point_location_2(of_all).winding_number(q);
      if (w.state != ba::Winding_number::State::DECIDED || v.state != ba::Winding_number::State::DECIDED) continue;
      if ((w.number != 0) != ba::is_filled(how.rule_a, v.number))
        throw Fault("identity", "another region at " + std::to_string(q.x) + ' ' + std::to_string(q.y));
    }
  }
};

TEST_P(NudgedDrawings, HaveRightOutlines) {
  Asked_points points;
  expect_of_pairs(MANY, [&](const Drawing_pair& pair, std::mt19937& random) {
    const Operation how = random_operation(random);
    static_cast<void>(checked<Filtered_tree>(pair.a, pair.b, how, random, points));
  });
  expect_most_asked(points);
}

TEST_P(NudgedDrawings, HaveRightOutlinesOverExactKernels) {
  Asked_points points;
  expect_of_pairs(FEW, [&](const Drawing_pair& pair, std::mt19937& random) {
    const Operation how = random_operation(random);
    static_cast<void>(checked<Exact_tree>(pair.a, pair.b, how, random, points));
  });
}

TEST_P(NudgedDrawings, HaveAreasThatAddUp) {
  expect_of_pairs(SOME, [&](const Drawing_pair& pair, std::mt19937& random) {
    const Operation how = random_operation(random);
    require_areas<Filtered_tree>(pair.a, pair.b, how.rule_a, how.rule_b);
  });
}

// A and A is A, A without A is nothing, and A is what it has in common with B and what it has not: of pairs, and of
// what was made of them.
TEST_P(NudgedDrawings, AreMadeOfTheirParts) {
  Asked_points points;
  expect_of_pairs(SOME, [&](const Drawing_pair& pair, std::mt19937& random) {
    const Operation how = random_operation(random);
    require_identities(pair.a, pair.b, how, random, points);
    if (one_in(random, 2))
      require_identities(combined<Filtered_tree>(pair.a, pair.b, how).drawn.drawing, pair.b, how, random, points);
  });
  expect_most_asked(points);
}

// A without what A is without B, A without what it has in common with B, and all other operations.
TEST_P(NudgedDrawings, CombineWithTheirOwnResults) {
  Asked_points points;
  expect_of_pairs(SOME, [&](const Drawing_pair& pair, std::mt19937& random) {
    const Operation first = random_operation(random), second = random_operation(random);
    const Drawing result = combined<Filtered_tree>(pair.a, pair.b, first).drawn.drawing;
    const bool is_first = one_in(random, 3);
    static_cast<void>(
        checked<Filtered_tree>(is_first ? result : pair.a, is_first ? pair.a : result, second, random, points));
  });
  expect_most_asked(points);
}

TEST_P(NudgedDrawings, StandTenOperations) {
  Asked_points points;
  expect_of_pairs(FEW, [&](const Drawing_pair& pair, std::mt19937& random) {
    Drawing drawing = pair.a;
    for (int i = 0; i < 10; ++i) {
      const Drawing other = one_in(random, 3) ? pair.b : GetParam().pair(random).a;
      drawing = checked<Filtered_tree>(drawing, other, random_operation(random), random, points).drawn.drawing;
    }
  });
  expect_most_asked(points);
}

// The middle of each part is on the side that it is told to be on.
TEST_P(NudgedDrawings, ClipEachOther) {
  expect_of_pairs(MANY, [&](const Drawing_pair& pair, std::mt19937& random) {
    const Fill_rule rule = random_operation(random).rule_b;
    const ba::Clipped_2 clipped = ba::clip(Filtered_tree(pair.a), Filtered_tree(pair.b), rule);
    if (clipped.status != ba::Outline_2::Status::COMPLETE) throw Fault("incomplete", "another status");
    const Whole_curves whole({&pair.a, &pair.b});
    for (const ba::Clipped_2::Part& part : clipped.parts) {
      const double t = ba::Bracket{part.from.upper, part.to.lower}.middle();
      if (!(part.from.upper < t && t < part.to.lower)) continue;  // shorter than parameters tell
      const auto q = whole.point(whole.number_of(0, part.curve, part.bezier), t);
      const auto winding = whole.winding(1, whole.seen(q, random));
      const CGAL::Bounded_side side = !winding                        ? CGAL::ON_BOUNDARY
                                      : ba::is_filled(rule, *winding) ? CGAL::ON_BOUNDED_SIDE
                                                                      : CGAL::ON_UNBOUNDED_SIDE;
      if (side != part.side) throw Fault("side", "another one");
    }
  });
}

// What all of these are measured by.
TEST(ExactWindings, AreThoseOfSturmSequences) {
  std::mt19937 random(1);
  std::uniform_real_distribution<double> share(0, 1);
  int around = 0;
  for (int i = 0; i < cases(60); ++i) {
    const Drawing drawing = one_of(random, NUDGED_KINDS).pair(random).a;
    const auto box = box_of(drawing);
    const double x = share(random), y = share(random);
    Point q{box.xmin() + x * (box.xmax() - box.xmin()), box.ymin() + y * (box.ymax() - box.ymin())};
    if (i % 4 == 0) q = drawing.curves().front().beziers.front().control_points().front();
    const Whole_curves curves({&drawing});
    const auto winding = curves.winding(0, curves.seen(curves.point(q), random));
    EXPECT_EQ(winding, winding_by_sturm(drawing, {Rational(q.x), Rational(q.y)})) << i;
    around += winding && *winding != 0 ? 1 : 0;
  }
  EXPECT_GE(around, cases(60) / 10);
}

INSTANTIATE_TEST_SUITE_P(Kinds, NudgedDrawings, testing::ValuesIn(NUDGED_KINDS),
                         [](const auto& param) { return std::string(param.param.name); });

}  // namespace test_nudged_drawings
