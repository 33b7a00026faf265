// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Boolean operations of drawings against exact winding numbers of the operands.

#include "cases.h"
#include "closed_drawings.h"
#include "outline_checks.h"

#include <CGAL/Bounding_arcs_2/boolean/clip.h>

#include <gtest/gtest.h>

#include <cmath>
#include <cstddef>
#include <random>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace test_boolean_operations {

using namespace bounding_arcs_test;

constexpr Boolean_operation OPERATIONS[] = {Boolean_operation::UNION, Boolean_operation::INTERSECTION,
                                            Boolean_operation::DIFFERENCE, Boolean_operation::SYMMETRIC_DIFFERENCE};

// Closed splines about different points, some of which cross themselves.
Drawing random_closed(std::mt19937& random) {
  Drawing drawing;
  std::uniform_real_distribution<double> unit(-1, 1);
  for (std::size_t i = 0, n = 1 + random() % 2; i < n; ++i) {
    std::vector<Bezier> chain = closed_curve(random, {0.5 * unit(random), 0.5 * unit(random)}, 3 + random() % 5);
    if (random() % 3 == 0)  // a crossing of neighbours
      for (Bezier& b : chain) {
        auto p = b.control_points();
        if (p.size() == 4 && random() % 2 == 0) std::swap(p[1], p[2]);
        b = Bezier(p);
      }
    drawing.add(chain);
  }
  return drawing;
}

TEST(BooleanOperations, AgreeWithWindingNumbersOfClosedSplines) {
  for (int i = 0; i < cases(60); ++i) {
    std::mt19937 random(static_cast<unsigned>(i));
    const Operands operands({random_closed(random), random_closed(random)});
    const Fill_rule rule = i % 2 == 0 ? Fill_rule::NONZERO : Fill_rule::EVEN_ODD;
    for (const Boolean_operation operation : OPERATIONS)
      expect_outline(operands, operation, rule, random, 25,
                     "case " + std::to_string(i) + " operation " + std::to_string(static_cast<int>(operation)));
    if (HasFailure()) return;
  }
}

TEST(BooleanOperations, AgreeWithWindingNumbersOnSmallLattices) {
  for (int i = 0; i < cases(60); ++i) {
    std::mt19937 random(static_cast<unsigned>(i));
    const Operands operands({random_lattice_drawing(random, 3), random_lattice_drawing(random, 3)});
    const Fill_rule rule = i % 2 == 0 ? Fill_rule::NONZERO : Fill_rule::EVEN_ODD;
    for (const Boolean_operation operation : OPERATIONS)
      expect_outline(operands, operation, rule, random, 25,
                     "case " + std::to_string(i) + " operation " + std::to_string(static_cast<int>(operation)));
    if (HasFailure()) return;
  }
}

// Curves that share halves with others, exactly, or but for the rounding of rational control points: then they meet at
// points that doubles do not tell apart.
void expect_outlines_of_related(int i) {
  std::mt19937 random(static_cast<unsigned>(i));
  const Drawing first = random_lattice_drawing(random, 3);
  const Operands operands({first, related_drawing(first, random, 3, i % 3 == 0)});
  const Fill_rule rule = i % 2 == 0 ? Fill_rule::NONZERO : Fill_rule::EVEN_ODD;
  for (const Boolean_operation operation : OPERATIONS)
    expect_outline(operands, operation, rule, random, 25,
                   "case " + std::to_string(i) + " operation " + std::to_string(static_cast<int>(operation)));
}
TEST(BooleanOperations, AgreeWithWindingNumbersOfCurvesThatRunTogether) {
  for (int i = 0; i < cases(60) && !HasFailure(); ++i) expect_outlines_of_related(i);
}

// In these, rounded halves cross the whole next to a joint, a cusp, a tip or each other, some ulp away.
TEST(BooleanOperations, AreDecidedWhereCrossingsAreSomeUlpApart) {
  for (const int i : {267, 6210, 7629, 10419, 11025, 13029, 20970, 26646, 28701, 29997, 54915, 62772})
    expect_outlines_of_related(i);
}

// What random drawings found, one of each kind.
TEST(BooleanOperations, AreCompleteWhereManyThingsMeetAtOnePoint) {
  const Bezier line({{-2, -3}, {2, 2}}), level({{-2, -3}, {2, -3}}, {3, 1});
  const std::vector<std::pair<Drawing, Drawing>> pairs = {
      // a line crosses at the tip of a fold, which is at 5/9 of its piece
      {drawing_of({Bezier({{-3, 2}, {2, -3}, {-2, 1}}), Bezier({{-2, 1}, {0, -1}, {-3, 2}})}),
       drawing_of({line, Bezier({{2, 2}, {-1, 0}, {1, 2}, {-2, -3}})})},
      // four edges leave a vertex in one direction
      {drawing_of({Bezier({{3, -3}, {-1, 3}, {1, -3}, {-1, -3}}, {2, 3, 2, 3}), Bezier({{-1, -3}, {2, -3}}),
                   Bezier({{2, -3}, {3, -3}})}),
       drawing_of({Bezier({{1, -1}, {1, -2}, {0, -3}, {-1, -3}}), Bezier({{-1, -3}, {3, -3}, {3, -1}}),
                   Bezier({{3, -1}, {-3, -1}, {-3, 2}, {1, -1}})})},
      // two leave upwards, one to the left and one to the right of that
      {drawing_of({Bezier({{3, -1}, {-3, -2}, {3, 1}}), Bezier({{3, 1}, {3, -1}})}),
       drawing_of(Bezier({{0, -1}, {-3, -2}, {0, 1}, {0, -1}}))},
      // a point of a level rational line is an ulp off in doubles
      {drawing_of({Bezier({{2, -3}, {3, -3}, {2, 2}, {-2, 0}}),
                   Bezier({{-2, 0}, {-2, -2}, {3, 1}, {-2, -3}}, {2, 3, 1, 1}), level}),
       drawing_of(
           {Bezier({{1, -3}, {3, -1}, {1, -2}, {2, -1}}, {3, 1, 2, 1}), Bezier({{2, -1}, {2, 2}, {-2, 2}, {1, -3}})})},
      // a fold over its own start, twice
      {drawing_of(Bezier({{-1, 3}, {-3, 3}, {2, 3}, {-1, 3}})),
       drawing_of(Bezier({{-1, 3}, {-3, 3}, {2, 3}, {-1, 3}}))},
      // through a cusp at t = 1/3
      {drawing_of({Bezier({{-3, -3}, {0, -2}}, {3, 1}), Bezier({{0, -2}, {1, -1}, {1, -2}, {-3, -2}}),
                   Bezier({{-3, -2}, {-3, -3}})}),
       drawing_of({Bezier({{2, -1}, {-1, 2}, {2, -1}, {-3, -2}}), Bezier({{-3, -2}, {0, -2}, {2, -1}})})},
  };
  std::mt19937 random(1);
  for (std::size_t i = 0; i < pairs.size(); ++i) {
    const Operands operands({pairs[i].first, pairs[i].second});
    for (const Boolean_operation operation : OPERATIONS)
      for (const Fill_rule rule : {Fill_rule::NONZERO, Fill_rule::EVEN_ODD})
        expect_outline(operands, operation, rule, random, 25,
                       "pair " + std::to_string(i) + " operation " + std::to_string(static_cast<int>(operation)));
  }
}

// A path in relative coordinates ends some ulp before it starts, and a line closes it. Its last piece but that one
// crosses its first one there.
TEST(BooleanOperations, HaveLoopsOfSomeUlp) {
  const Operands operands(
      {drawing_of({Bezier({{3.603, 8.092}, {2, 9}, {3, 12}, {4.937, 10.5}}), Bezier({{4.937, 10.5}, {2.576, 9.735}}),
                   Bezier({{2.576, 9.735}, {2.576 + 1.027, 9.735 - 1.643}}),
                   Bezier({{2.576 + 1.027, 9.735 - 1.643}, {3.603, 8.092}})})});
  std::mt19937 random(1);
  for (const Fill_rule rule : {Fill_rule::NONZERO, Fill_rule::EVEN_ODD})
    expect_outline(operands, Boolean_operation::UNION, rule, random, 100, "path");
}

TEST(BooleanOperations, HaveAreasThatAddUp) {
  constexpr double EPS = 1e-12;
  for (int i = 0; i < cases(40); ++i) {
    std::mt19937 random(static_cast<unsigned>(1000 + i));
    const Operands operands({random_closed(random), random_closed(random)});
    const auto area = [&](Boolean_operation operation) {
      return area_of(
          ba::drawn_outline(operands.trees(), operands.outline(operation, Fill_rule::NONZERO), {false}).drawing, EPS);
    };
    const auto own = [&](std::size_t k) {
      const Operands one({*operands.drawings()[k]});
      return area_of(
          ba::drawn_outline(one.trees(), one.outline(Boolean_operation::UNION, Fill_rule::NONZERO), {false}).drawing,
          EPS);
    };
    const double sum = own(0) + own(1), both = area(Boolean_operation::INTERSECTION);
    constexpr double ROUNDING = 1e-11;
    EXPECT_NEAR(area(Boolean_operation::UNION) + both, sum, ROUNDING) << "case " << i;
    EXPECT_NEAR(area(Boolean_operation::DIFFERENCE) + both, own(0), ROUNDING) << "case " << i;
    EXPECT_NEAR(area(Boolean_operation::SYMMETRIC_DIFFERENCE), sum - 2 * both, ROUNDING) << "case " << i;
  }
}

TEST(BooleanOperations, UniteTheSameInEitherOrder) {
  for (int i = 0; i < cases(40); ++i) {
    std::mt19937 random(static_cast<unsigned>(2000 + i));
    const Drawing a = random_closed(random), b = random_closed(random);
    const auto first = Operands({a, b}).outline(Boolean_operation::UNION, Fill_rule::NONZERO),
               second = Operands({b, a}).outline(Boolean_operation::UNION, Fill_rule::NONZERO);
    EXPECT_EQ(parts_of(first, false).size(), parts_of(second, true).size()) << "case " << i;
    EXPECT_EQ(first.chains.size(), second.chains.size()) << "case " << i;
  }
}

// Where regions touch at a vertex, each goes on with its own edges, so that chains do not cross there.
TEST(BooleanOperations, KeepRegionsThatTouchApart) {
  Drawing a, b;
  a.add(polygon({{0, 0}, {2, 0}, {2, 2}, {0, 2}}));
  b.add(polygon({{1, 1}, {3, 1}, {3, 3}, {1, 3}}));
  const Operands squares({a, b});
  const Outline_2 outline = squares.outline(Boolean_operation::SYMMETRIC_DIFFERENCE, Fill_rule::NONZERO);
  ASSERT_EQ(outline.chains.size(), 2u);
  const Drawing drawing = ba::drawn_outline(squares.trees(), outline, {false}).drawing;
  for (std::size_t i = 0; i < 2; ++i) {
    EXPECT_TRUE(outline.chains[i].is_ccw);
    EXPECT_FALSE(outline.chains[i].parent);
    EXPECT_NEAR(area_of(drawing_of(drawing.curves()[i].beziers), 1e-12), 3, 1e-12);
  }
}

// Circles that touch from inside leave the common point in one direction: their order there is told exactly.
TEST(BooleanOperations, TellApartCirclesThatTouch) {
  Drawing large, small;
  large.add(circle({0, 0}, 2));
  small.add(circle({1, 0}, 1));
  const Operands circles({large, small});
  std::mt19937 random(1);
  for (const Boolean_operation operation : OPERATIONS)
    expect_outline(circles, operation, Fill_rule::NONZERO, random, 100, "circles");
  EXPECT_EQ(circles.outline(Boolean_operation::DIFFERENCE, Fill_rule::NONZERO).chains.size(), 2u);
}

// Each drawing is filled by its own rule: of nested squares, and of a star, the rules fill different points.
TEST(BooleanOperations, FillEachOperandByItsOwnRule) {
  Drawing nested;
  nested.add(polygon({{0, 0}, {8, 0}, {8, 8}, {0, 8}}));
  nested.add(polygon({{2, 2}, {6, 2}, {6, 6}, {2, 6}}));
  const Drawing star = drawing_of(polygon({{4, 9}, {7, 0}, {-1, 6}, {9, 6}, {1, 0}}));
  constexpr Fill_rule NONZERO = Fill_rule::NONZERO, EVEN_ODD = Fill_rule::EVEN_ODD;
  const Operands operands({nested, star});
  std::mt19937 random(1);
  std::vector<double> areas;
  for (const Fill_rule first : {NONZERO, EVEN_ODD})
    for (const Fill_rule second : {NONZERO, EVEN_ODD}) {
      for (const Boolean_operation operation : OPERATIONS)
        expect_outline(operands, operation, {first, second}, random, 50,
                       "rules " + std::to_string(static_cast<int>(first)) + std::to_string(static_cast<int>(second)));
      areas.push_back(
          area_of(ba::drawn_outline(operands.trees(),
                                    operands.outline(Boolean_operation::SYMMETRIC_DIFFERENCE, {first, second}), {false})
                      .drawing,
                  1e-12));
    }
  for (std::size_t i = 0; i < areas.size(); ++i)
    for (std::size_t k = 0; k < i; ++k) EXPECT_GT(std::fabs(areas[i] - areas[k]), 1) << i << ' ' << k;
  EXPECT_EQ(parts_of(operands.outline(Boolean_operation::UNION, EVEN_ODD), false),
            parts_of(operands.outline(Boolean_operation::UNION, {EVEN_ODD, EVEN_ODD}), false));
  EXPECT_THROW((void)operands.outline(Boolean_operation::UNION, {NONZERO}), std::invalid_argument);
  EXPECT_THROW((void)operands.outline(Boolean_operation::UNION, {NONZERO, NONZERO, NONZERO}), std::invalid_argument);
}

// Three squares of which each two have a common part, and all have one: what is in one or in three.
TEST(BooleanOperations, TakeThreeOperands) {
  const auto square = [](double x, double y) {
    return drawing_of(polygon({{x, y}, {x + 4, y}, {x + 4, y + 4}, {x, y + 4}}));
  };
  const Operands operands({square(0, 0), square(1, 2), square(3, 1)});
  // all 3 have 1 x 2, pairs 3 x 2, 1 x 3 and 2 x 3
  const double all = 2, pairs = 6 + 3 + 6,
               areas[] = {48 - pairs + all, all, 16 - 6 - 3 + all, 48 - 2 * pairs + 4 * all};
  for (std::size_t i = 0; i < 4; ++i) {
    std::mt19937 random(1);
    expect_outline(operands, OPERATIONS[i], Fill_rule::NONZERO, random, 200, std::to_string(i));
    const Outline_2 outline = operands.outline(OPERATIONS[i], Fill_rule::NONZERO);
    EXPECT_EQ(area_of(ba::drawn_outline(operands.trees(), outline, {false}).drawing, 0), areas[i]) << i;
  }
}

// Drawings without curves, and those whose curves all are points, fill nothing.
TEST(BooleanOperations, TakeOperandsThatFillNothing) {
  Drawing points;
  points.add(Bezier({{1, 1}, {1, 1}, {1, 1}}));
  points.add({segment({5, 5}, {5, 5}), segment({5, 5}, {5, 5})});
  const Drawing square = drawing_of(polygon({{0, 0}, {2, 0}, {2, 2}, {0, 2}}));
  const std::vector<std::pair<double, std::vector<Drawing>>> drawings = {{0, {}},
                                                                         {0, {Drawing()}},
                                                                         {0, {points}},
                                                                         {4, {square}},
                                                                         {0, {Drawing(), points}},
                                                                         {4, {square, points, Drawing()}},
                                                                         {4, {Drawing(), square}}};
  for (std::size_t i = 0; i < drawings.size(); ++i) {
    const auto& [area, given] = drawings[i];
    for (const ba::Decisions decisions : {ba::Decisions::DOUBLE, ba::Decisions::EXACT}) {
      const Operands operands(given, decisions);
      for (const Boolean_operation operation : OPERATIONS) {
        const Outline_2 outline = operands.outline(operation, Fill_rule::NONZERO);
        const ba::Outline_2::Drawn drawn = ba::drawn_outline(operands.trees(), outline);
        const bool is_square = area > 0 && (given.size() == 1 || operation == Boolean_operation::UNION ||
                                            operation == Boolean_operation::SYMMETRIC_DIFFERENCE ||
                                            (operation == Boolean_operation::DIFFERENCE && i == 5));
        EXPECT_EQ(outline.status, ba::Outline_2::Status::COMPLETE) << i;
        EXPECT_EQ(outline.chains.size(), is_square ? 1u : 0u) << i << ' ' << static_cast<int>(operation);
        EXPECT_EQ(area_of(drawn.drawing, 1e-12), is_square ? 4 : 0) << i;
        EXPECT_EQ(drawn.moved, 0) << i;
      }
    }
  }
  const ba::Bounding_arc_tree_2 none{Drawing()}, some(square), all_points(points);
  for (const auto* region : {&none, &all_points}) {
    const ba::Clipped_2 clipped = ba::clip(some, *region, Fill_rule::NONZERO);
    EXPECT_EQ(clipped.status, ba::Outline_2::Status::COMPLETE);
    ASSERT_FALSE(clipped.parts.empty());
    for (const auto& part : clipped.parts) EXPECT_EQ(part.side, CGAL::ON_UNBOUNDED_SIDE);
  }
  EXPECT_TRUE(ba::clip(none, some, Fill_rule::NONZERO).parts.empty());
}

// Two curves cross a tenth of an ulp from where they are told to, nearly along each other: the parameter is a root.
TEST(BooleanOperations, TellTheOrderOfCurvesThatCrossNearlyAlongEachOther) {
  const Operands operands({drawing_of({Bezier({{2.7755575615628914e-17, 7.4},
                                               {2.7755575615628914e-17, 7.400000000000001},
                                               {2.7755575615628485e-17, 7.400000000000002}}),
                                       segment({2.7755575615628485e-17, 7.400000000000002}, {1, 8}),
                                       segment({1, 8}, {2.7755575615628914e-17, 7.4})}),
                           drawing_of({Bezier({{2.775557561562891e-17, 7.3999999999999995},
                                               {2.775557561562891e-17, 7.3999999999999995},
                                               {2.7755575615628488e-17, 7.400000000000002}}),
                                       segment({2.7755575615628488e-17, 7.400000000000002}, {2, 7}),
                                       segment({2, 7}, {2.775557561562891e-17, 7.3999999999999995})})});
  std::mt19937 random(1);
  for (const Boolean_operation operation : OPERATIONS)
    expect_outline(operands, operation, Fill_rule::NONZERO, random, 25, "curves");
}

// A curve meets another one and the first half of that: one of the three parameters is known less well than the others.
TEST(BooleanOperations, HaveVerticesWhereTheBestKnownCurveHasThem) {
  const Drawing drawings[] = {
      drawing_of({Bezier({{0, -2}, {3, -2}, {1, -1}}), Bezier({{1, -1}, {-3, -2}, {-3, -2}, {0, -2}})}),
      drawing_of({Bezier({{-2.125, -1.875}, {-2, -1.75}, {-1, -1.5}, {1, -1}}), Bezier({{1, -1}, {2, -1.5}, {0, -2}}),
                  Bezier({{0, -2}, {2, 3}, {2, 2}, {-2.125, -1.875}})})};
  const Outline_2 outline = ba::difference(ba::Bounding_arc_tree_2(drawings[0]), ba::Bounding_arc_tree_2(drawings[1]));
  std::size_t vertices = 0;
  for (const auto& chain : outline.chains)
    for (const auto& part : chain.parts) {
      const Point at = drawings[part.operand].curves()[part.curve].beziers[part.bezier].point(part.from.middle());
      EXPECT_LE(std::hypot(at.x - part.start.x, at.y - part.start.y), 0x1p-50) << part.start.x << ' ' << part.start.y;
      ++vertices;
    }
  EXPECT_GE(vertices, 3u);
}

// Circles that touch a thousand units away: doubles leave open how, and tell where and which.
TEST(BooleanOperations, TellWhichCurvesMeetWhereThatIsUndecided) {
  Drawing first, second;
  first.add(circle({-500, 0}, 1));
  first.add(circle({1000, 3}, 2));
  second.add(circle({1003, 3}, 1));
  const ba::Bounding_arc_tree_2 curves(first, ba::Decisions::DOUBLE), region(second, ba::Decisions::DOUBLE);
  const Outline_2 outline = ba::unite(curves, region);
  ASSERT_EQ(outline.status, ba::Outline_2::Status::UNDECIDED);
  ASSERT_TRUE(outline.undecided);
  EXPECT_NEAR(outline.undecided->at.x, 1002, 1e-3);
  EXPECT_NEAR(outline.undecided->at.y, 3, 1e-3);
  EXPECT_EQ(outline.undecided->a.operand, 0u);
  EXPECT_EQ(outline.undecided->a.curve, 1u);
  EXPECT_EQ(outline.undecided->b.operand, 1u);
  EXPECT_EQ(outline.undecided->b.curve, 0u);
  const Outline_2 decided = ba::unite(ba::Bounding_arc_tree_2(first), ba::Bounding_arc_tree_2(second));
  EXPECT_FALSE(decided.undecided);
  const ba::Clipped_2 clipped = ba::clip(curves, region, Fill_rule::NONZERO);
  ASSERT_EQ(clipped.status, ba::Outline_2::Status::UNDECIDED);
  ASSERT_TRUE(clipped.undecided);
  EXPECT_NEAR(clipped.undecided->at.x, 1002, 1e-3);
  EXPECT_EQ(clipped.undecided->a.curve, 1u);
  EXPECT_EQ(clipped.undecided->b.operand, 1u);
}

}  // namespace test_boolean_operations
