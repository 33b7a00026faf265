// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Winding numbers, sides and signed distances of points, beside Sturm sequences and where they are known.

#include "../../src/library/tree/Segment_hierarchy.h"
#include "cases.h"
#include "closed_drawings.h"
#include "winding_oracle.h"

#include <CGAL/Bounding_arcs_2/query/point_location.h>
#include <CGAL/Bounding_arcs_2/query/signed_distance.h>

#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>
#include <limits>
#include <random>
#include <stdexcept>
#include <string>
#include <vector>

namespace test_point_location {
namespace {

using namespace bounding_arcs_test;
namespace ba = CGAL::Bounding_arcs;
using ba::Bounding_arc_tree_2;
using ba::Fill_rule;
using ba::Winding_number;
using Point = ba::Xy<double>;
using State = Winding_number::State;

ba::Xy<Rational> exactly(const Point& p) { return {Rational(p.x), Rational(p.y)}; }

// What the oracle says, with the point and the case for messages.
void expect_exactly_as_oracle(const Bounding_arc_tree_2& index, const ba::Xy<Rational>& q, const std::string& name) {
  const Winding_number w = ba::winding_number(index, ba::Asked_point(q));
  const auto known = winding_by_sturm(index.drawing(), q);
  ASSERT_EQ(w.state, known ? State::DECIDED : State::ON) << name << " (" << q.x << ", " << q.y << ")";
  if (known) {
    ASSERT_EQ(w.number, *known) << name << " (" << q.x << ", " << q.y << ")";
  }
}
void expect_as_oracle(const Bounding_arc_tree_2& index, const Point& q, const std::string& name) {
  expect_exactly_as_oracle(index, exactly(q), name);
}

TEST(PointLocation, OnALatticeIsThatOfSturmSequences) {
  std::mt19937 random(1);
  constexpr int SIZE = 3;
  std::uniform_int_distribution<int> coordinate(-2 * SIZE, 2 * SIZE);
  int on = 0, inside = 0;
  for (int i = 0; i < cases(500); ++i) {
    const Bounding_arc_tree_2 index(random_lattice_drawing(random, SIZE));
    for (int k = 0; k < 10; ++k) {
      const Point q{coordinate(random) / 2.0, coordinate(random) / 2.0};
      expect_as_oracle(index, q, "drawing " + std::to_string(i));
      const Winding_number w = ba::winding_number(index, q);
      on += w.state == State::ON;
      inside += w.number != 0;
    }
    if (HasFatalFailure()) return;
  }
  EXPECT_GT(on, cases(100));
  EXPECT_GT(inside, cases(250));
}

// Computed points of curves are on one or the other side of it by parts of an ulp.
TEST(PointLocation, NextToACurveIsThatOfSturmSequences) {
  std::mt19937 random(2);
  std::uniform_real_distribution<double> unit(0, 1);
  const Placing places[] = {{}, {1e-9, 0, 0}, {1e9, 0, 0}, {1, 1e8, -3e8}, {1.0 / 3, 0.1, 0.7}};
  for (int i = 0; i < cases(500); ++i) {
    const Bounding_arc_tree_2 index(random_lattice_drawing(random, 3, places[i % 5]));
    for (int k = 0; k < 4; ++k) {
      const auto& chain = index.drawing().curves().front().beziers;
      Point q = chain[random() % chain.size()].point(k == 0 ? std::round(4 * unit(random)) / 4 : unit(random));
      if (k == 2) q.x = std::nextafter(q.x, 1e300);
      if (k == 3) q.y = std::nextafter(q.y, -1e300);
      expect_as_oracle(index, q, "drawing " + std::to_string(i));
    }
    if (HasFatalFailure()) return;
  }
}

// There curves are flat over many ulp, and what is computed of them is on either side of a ray along them.
TEST(PointLocation, AtHighestAndLowestPointsIsThatOfSturmSequences) {
  std::mt19937 random(5);
  std::uniform_int_distribution<int> ulps(-200, 200);
  const Placing places[] = {{1.0 / 3, 0.1, 0.7}, {1e-9 / 3, 0, 0}, {1, 1e8, -3e8}, {1.0 / 7, 0, 0}};
  for (int i = 0; i < cases(400); ++i) {
    const Bounding_arc_tree_2 index(random_lattice_drawing(random, 3, places[i % 4]));
    for (std::uint32_t s = 0; s < index.in_unit().number_of_segments(); ++s) {
      if (index.in_unit().place(s).first != ba::Cut_reason::Y) continue;
      const Point top = index.in_unit().piece(s).first.point;
      for (int k = 0; k < 4; ++k) {
        const double ulp = 0x1p-52 * index.in_unit().evaluator(index.in_unit().bezier_of(s)).coordinate_size();
        expect_as_oracle(index, {top.x + ulps(random) * ulp, top.y + static_cast<double>(k - 1) * ulp / 4},
                         "drawing " + std::to_string(i));
      }
    }
    if (HasFatalFailure()) return;
  }
}

// Where a drawing's vertices, turns and points farthest to the sides are, as exact numbers.
std::vector<ba::Xy<Rational>> special_places(const Bounding_arc_tree_2& index) {
  std::vector<ba::Xy<Rational>> places;
  for (const auto& curve : index.drawing().curves())
    for (const auto& bezier : curve.beziers) places.push_back(exactly(bezier.control_points().front()));
  for (std::uint32_t s = 0; s < index.in_unit().number_of_segments(); ++s) {
    const ba::Cut_reason reason = index.in_unit().place(s).first;
    if (reason != ba::Cut_reason::X && reason != ba::Cut_reason::Y) continue;
    const Point turn = index.in_unit().piece(s).first.point;
    places.push_back({index.unit().exactly_out(Rational(turn.x)), index.unit().exactly_out(Rational(turn.y))});
  }
  return places;
}

// An exact point whose doubles are those of a vertex is above or below it all the same.
TEST(PointLocation, WithinHalfAnUlpOfAVertexIsThatOfSturmSequences) {
  const Rational least = Rational(0x1p-600) * Rational(0x1p-600);
  ba::Drawing_2<double> rectangle;
  rectangle.add({Lattice_curve({{0, 0}, {2, 0}}), Lattice_curve({{2, 0}, {2, 1}}), Lattice_curve({{2, 1}, {0, 1}}),
                 Lattice_curve({{0, 1}, {0, 0}})});
  const Bounding_arc_tree_2 index(rectangle);
  for (const int x : {-1, 0, 1, 2, 3})
    for (const int y : {0, 1})
      for (const int i : {-1, 0, 1})
        for (const int k : {-1, 0, 1})
          expect_exactly_as_oracle(index, ba::Xy<Rational>{x + i * least, y + k * least}, "rectangle");
  EXPECT_EQ(ba::locate(index, ba::Asked_point(ba::Xy<Rational>{1, least})), CGAL::ON_BOUNDED_SIDE);
  EXPECT_EQ(ba::locate(index, ba::Asked_point(ba::Xy<Rational>{1, -least})), CGAL::ON_UNBOUNDED_SIDE);
  EXPECT_EQ(ba::locate(index, ba::Asked_point(ba::Xy<Rational>{1, 1 - least})), CGAL::ON_BOUNDED_SIDE);
  EXPECT_EQ(ba::locate(index, ba::Asked_point(ba::Xy<Rational>{1, 1 + least})), CGAL::ON_UNBOUNDED_SIDE);
}

// Around each such place, and beside it at the height of another one.
void expect_as_oracle_within_half_an_ulp(const Bounding_arc_tree_2& index, std::mt19937& random,
                                         const std::string& name) {
  const Rational least = Rational(0x1p-600) * Rational(0x1p-600);
  const auto special = special_places(index);
  for (const ba::Xy<Rational>& p : special) {
    const ba::Xy<Rational>& q = special[random() % special.size()];
    const int along = static_cast<int>(random() % 3) - 1, up = static_cast<int>(random() % 3) - 1;
    const Rational y = p.y + up * least;
    expect_exactly_as_oracle(index, {p.x + along * least, y}, name);
    expect_exactly_as_oracle(index, {q.x + along * least, y}, name);
    expect_exactly_as_oracle(index, {(p.x + q.x) / 2 + along * least, y}, name);
  }
}

TEST(PointLocation, WithinHalfAnUlpOfVerticesAndTurnsIsThatOfSturmSequences) {
  std::mt19937 random(11);
  const Placing places[] = {{}, {1.0 / 3, 0.1, 0.7}, {1, 1e8, -3e8}};
  for (int i = 0; i < cases(12) && !HasFatalFailure(); ++i)
    expect_as_oracle_within_half_an_ulp(Bounding_arc_tree_2(random_lattice_drawing(random, 3, places[i % 3])), random,
                                        "drawing " + std::to_string(i));
}

// Every second side is level, and a third of them are curves that run along it.
TEST(PointLocation, WithinHalfAnUlpOfLevelSidesIsThatOfSturmSequences) {
  std::mt19937 random(12);
  for (int i = 0; i < cases(12) && !HasFatalFailure(); ++i) {
    const auto coordinate = [&] { return static_cast<double>(random() % 7) / (i % 2 == 0 ? 1 : 3); };
    std::vector<Lattice_curve> chain;
    const Point start{coordinate(), coordinate()};
    Point at = start;
    for (int k = 0; k < 5; ++k) {
      const Point corner{k == 4 ? start.x : coordinate(), at.y}, next{corner.x, k == 4 ? start.y : coordinate()};
      if (corner.x != at.x && random() % 3 == 0) chain.push_back(Lattice_curve({at, {coordinate(), at.y}, corner}));
      else if (corner.x != at.x) chain.push_back(Lattice_curve({at, corner}));
      if (next.y != corner.y) chain.push_back(Lattice_curve({corner, next}));
      at = next;
    }
    if (chain.empty() || chain.front().control_points().front() != chain.back().control_points().back()) continue;
    ba::Drawing_2<double> drawing;
    drawing.add(chain);
    expect_as_oracle_within_half_an_ulp(Bounding_arc_tree_2(drawing), random, "stairs " + std::to_string(i));
  }
}

TEST(PointLocation, KnowsCirclesAndHoles) {
  ba::Drawing_2<double> drawing;
  drawing.add(circle_of_quarters({5, 0, 0}), "outer");
  std::vector<Lattice_curve> hole;
  const std::vector<Lattice_curve> round = circle_of_quarters({1, 0, 0});
  for (std::size_t i = round.size(); i-- > 0;) hole.push_back(round[i].reversed());
  drawing.add(hole, "hole");
  const Bounding_arc_tree_2 index(drawing);
  EXPECT_EQ(ba::locate(index, {0, 0}), CGAL::ON_UNBOUNDED_SIDE);
  EXPECT_EQ(ba::locate(index, {0, 1}), CGAL::ON_BOUNDARY);
  EXPECT_EQ(ba::locate(index, {0, 0}, Fill_rule::EVEN_ODD), CGAL::ON_UNBOUNDED_SIDE);
  EXPECT_EQ(ba::winding_number(index, {3, 0}).number, 1);
  EXPECT_EQ(ba::locate(index, {3, 4}), CGAL::ON_BOUNDARY);  // on the circle, at no double parameter
  EXPECT_EQ(ba::locate(index, {3, std::nextafter(4, 0)}), CGAL::ON_BOUNDED_SIDE);
  EXPECT_EQ(ba::locate(index, {3, std::nextafter(4, 5)}), CGAL::ON_UNBOUNDED_SIDE);
  EXPECT_EQ(ba::locate(index, {-7, 5}), CGAL::ON_UNBOUNDED_SIDE);  // the ray touches the outer circle
  EXPECT_EQ(ba::locate(index, {-7, 1}), CGAL::ON_UNBOUNDED_SIDE);  // the ray touches the hole
}

TEST(PointLocation, CountsWhatIsRunThroughTwice) {
  std::vector<Lattice_curve> twice = circle_of_quarters({5, 0, 0});
  for (const Lattice_curve& c : circle_of_quarters({5, 0, 0})) twice.push_back(c);
  ba::Drawing_2<double> drawing;
  drawing.add(twice);
  const Bounding_arc_tree_2 index(drawing);
  EXPECT_EQ(ba::winding_number(index, {1, 0}).number, 2);
  EXPECT_EQ(ba::locate(index, {1, 0}), CGAL::ON_BOUNDED_SIDE);
  EXPECT_EQ(ba::locate(index, {1, 0}, Fill_rule::EVEN_ODD), CGAL::ON_UNBOUNDED_SIDE);
  EXPECT_EQ(ba::winding_number(index, {4, 3}).state, State::ON);
}

TEST(PointLocation, IsRightAtCuspsLinesAndPoints) {
  ba::Drawing_2<double> drawing;
  // a cusp at the origin, (t^2, t^3) for t in [-1, 1], closed by a segment
  drawing.add({Lattice_curve({{1, -1}, {-1.0 / 3, 1}, {-1.0 / 3, -1}, {1, 1}}), Lattice_curve({{1, 1}, {1, -1}})});
  // back and forth on a line, and a point
  drawing.add({Lattice_curve({{-3, 0}, {-2, 0}, {-1, 0}}), Lattice_curve({{-1, 0}, {-3, 0}})});
  drawing.add({Lattice_curve({{-4, 0}, {-4, 0}, {-4, 0}, {-4, 0}})});
  const Bounding_arc_tree_2 index(drawing);
  for (const double y : {-1.0, -0x1p-60, 0.0, 0x1p-60, 0x1p-30, 0.5})
    for (const double x :
         {-5.0, -4.0, -3.5, -3.0, -2.0, -1.0, -0.5, -0x1p-70, 0.0, 0x1p-70, 0x1p-40, 0x1p-20, 0.25, 0.5, 1.0, 2.0})
      expect_as_oracle(index, {x, y}, "cusp");
  EXPECT_EQ(ba::locate(index, {-4, 0}), CGAL::ON_BOUNDARY);
}

TEST(PointLocation, OfRationalNumbersIsThatOfTheExactCurves) {
  ba::Drawing_2<Rational> drawing;
  using Curve = ba::Bezier_curve_2<Rational>;
  const Rational third = Rational(1) / 3;
  drawing.add({Curve({{0, 0}, {third, 0}}), Curve({{third, 0}, {third, third}}), Curve({{third, third}, {0, 0}})});
  const Bounding_arc_tree_2 index(drawing);
  const double t = 1.0 / 3;
  for (const Point& q : {Point{t, t / 2}, Point{std::nextafter(t, 1), 0.1}, Point{0.25, 0.25}, Point{t, t},
                         Point{0.25, std::nextafter(0.25, 0)}, Point{0.25, 0x1p-200}, Point{0.25, 0}, Point{0, 0}}) {
    const Winding_number w = ba::winding_number(index, q);
    const auto known = winding_by_sturm(drawing, exactly(q));
    EXPECT_EQ(w.state, known ? State::DECIDED : State::ON) << q.x << " " << q.y;
    if (known) {
      EXPECT_EQ(w.number, *known) << q.x << " " << q.y;
    }
  }
}

TEST(PointLocation, InDoublesIsRightOrUndecided) {
  std::mt19937 random(4);
  std::uniform_real_distribution<double> unit(-3, 3);
  int open = 0;
  for (int i = 0; i < cases(300); ++i) {
    const Lattice_drawing drawing = random_lattice_drawing(random, 3);
    const Bounding_arc_tree_2 exact(drawing), plain(drawing, ba::Decisions::DOUBLE);
    for (int k = 0; k < 10; ++k) {
      Point q{unit(random), unit(random)};
      if (k == 0) q = drawing.curves()[0].beziers[0].point(0.375);
      const Winding_number a = ba::winding_number(exact, q), b = ba::winding_number(plain, q);
      if (b.state == State::UNDECIDED) {
        EXPECT_EQ(k, 0);
        EXPECT_FALSE(is_certain(ba::locate(plain, q)));
        ++open;
        continue;
      }
      EXPECT_EQ(a.state, b.state);
      EXPECT_EQ(a.number, b.number);
    }
  }
  EXPECT_GT(open, cases(100));
}

TEST(PointLocation, NamesAnOpenCurve) {
  ba::Drawing_2<double> drawing;
  drawing.add(circle_of_quarters(), "round");
  drawing.add(Lattice_curve({{0, 0}, {1, 1}}), "line");
  const Bounding_arc_tree_2 index(drawing);
  try {
    (void)ba::locate(index, {0, 0});
    FAIL();
  } catch (const std::invalid_argument& e) {
    EXPECT_NE(std::string(e.what()).find("'line'"), std::string::npos);
  }
}

TEST(PointLocation, OfNothingIsOutsideAndOfNoNumberAnError) {
  const Bounding_arc_tree_2 index{ba::Drawing_2<double>()};
  EXPECT_EQ(ba::locate(index, {0, 0}), CGAL::ON_UNBOUNDED_SIDE);
  EXPECT_THROW((void)ba::locate(index, {std::nan(""), 0}), std::invalid_argument);
  EXPECT_THROW((void)ba::locate(index, {0, std::numeric_limits<double>::infinity()}), std::invalid_argument);
}

TEST(SignedDistance, IsThatOfClosestPointsAndSides) {
  std::mt19937 random(7);
  constexpr int SIZE = 3;
  std::uniform_int_distribution<int> coordinate(-2 * SIZE, 2 * SIZE);
  int sides[3] = {0, 0, 0};
  for (int i = 0; i < cases(150); ++i) {
    const Bounding_arc_tree_2 index(random_lattice_drawing(random, SIZE));
    std::vector<Point> points;
    for (int k = 0; k < 20; ++k)  // some of them one step from the one before
      points.push_back(k % 3 == 2 ? points.back() + Point{0x1p-4, 0}
                                  : Point{coordinate(random) / 2.0, coordinate(random) / 2.0});
    for (const Fill_rule rule : {Fill_rule::NONZERO, Fill_rule::EVEN_ODD}) {
      const auto all = ba::signed_distances_of_all(index, points, rule);
      ASSERT_EQ(all.size(), points.size());
      for (std::size_t k = 0; k < points.size(); ++k) {
        const auto one = ba::signed_distance(index, points[k], rule);
        const auto closest = ba::closest_point(index, points[k]);
        const auto known = winding_by_sturm(index.drawing(), exactly(points[k]));
        ASSERT_TRUE(one && closest);
        const bool is_inside = known && (rule == Fill_rule::NONZERO ? *known != 0 : *known % 2 != 0);
        const CGAL::Bounded_side side =
            !known ? CGAL::ON_BOUNDARY : (is_inside ? CGAL::ON_BOUNDED_SIDE : CGAL::ON_UNBOUNDED_SIDE);
        EXPECT_EQ(one->side, side) << i << ' ' << k;
        EXPECT_EQ(all[k].side, side) << i << ' ' << k;
        EXPECT_EQ(one->point, closest->point);
        const double sign = !known ? 0 : (is_inside ? -1 : 1);
        EXPECT_EQ((std::min)(sign * closest->distance.lower, sign * closest->distance.upper), one->distance.lower);
        EXPECT_EQ((std::max)(sign * closest->distance.lower, sign * closest->distance.upper), one->distance.upper);
        EXPECT_LE(all[k].distance.lower, one->distance.upper);
        EXPECT_LE(one->distance.lower, all[k].distance.upper);
        ++sides[static_cast<int>(side) + 1];
      }
    }
  }
  for (const int count : sides) EXPECT_GT(count, cases(150) / 3);
}

TEST(SignedDistance, OfACircleIsKnown) {
  ba::Drawing_2<double> drawing;
  drawing.add(circle_of_quarters({5, 0, 0}));
  const Bounding_arc_tree_2 index(drawing), doubles(drawing, ba::Decisions::DOUBLE);
  const auto at = [&](double x, double y) { return ba::signed_distance(index, {x, y})->distance; };
  const double known[][3] = {{0, 0, -5}, {1, 0, -4}, {3, 4, 0}, {6, 8, 5}, {-3, 0, -2}, {0, 15, 10}};
  for (const auto& [x, y, d] : known) {
    EXPECT_LE(at(x, y).lower, d) << x << ' ' << y;
    EXPECT_GE(at(x, y).upper, d) << x << ' ' << y;
    EXPECT_LE(at(x, y).upper - at(x, y).lower, 1e-12) << x << ' ' << y;
  }
  EXPECT_EQ(at(3, 4).upper, 0);
  EXPECT_LE(at(3, std::nextafter(4, 0)).lower, 0);
  EXPECT_LE(at(3, std::nextafter(4, 0)).upper, 0);
  EXPECT_GE(at(3, std::nextafter(4, 5)).lower, 0);
  const auto open = ba::signed_distance(doubles, {3, 4});  // what doubles do not tell has both signs
  EXPECT_FALSE(is_certain(open->side));
  EXPECT_LT(open->distance.lower, 0);
  EXPECT_GT(open->distance.upper, 0);
}

TEST(SignedDistance, IsNoneOfNothingAndRefusesOpenCurvesAndNonNumbers) {
  const Bounding_arc_tree_2 none{ba::Drawing_2<double>()};
  EXPECT_FALSE(ba::signed_distance(none, {0, 0}));
  EXPECT_TRUE(ba::signed_distances_of_all(none, std::vector<Point>{{0, 0}}).empty());
  ba::Drawing_2<double> drawing;
  drawing.add(circle_of_quarters());
  const Bounding_arc_tree_2 index(drawing);
  EXPECT_THROW((void)ba::signed_distance(index, {std::nan(""), 0}), std::invalid_argument);
  EXPECT_THROW((void)ba::signed_distances_of_all(index, std::vector<Point>{{0, 0}, {0, HUGE_VAL}}),
               std::invalid_argument);
  drawing.add(Lattice_curve({{0, 0}, {1, 1}}));
  const Bounding_arc_tree_2 open(drawing);
  EXPECT_THROW((void)ba::signed_distance(open, {0, 0}), std::invalid_argument);
  EXPECT_THROW((void)ba::signed_distances_of_all(open, std::vector<Point>()), std::invalid_argument);
}

}  // namespace
}  // namespace test_point_location
