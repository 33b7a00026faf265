// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Intersections of drawings against exact ones of each two Bezier pieces, and on cases whose answers are known.

#include "../../src/library/tree/Segment_hierarchy.h"
#include "cases.h"

#include <CGAL/Bounding_arcs_2/query/intersections.h>
#include <CGAL/Bounding_arcs_2/query/shapes.h>
#include "../../src/library/curve/exact_bezier.h"
#include "../../src/library/query/exact_intersections.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <numeric>
#include <random>
#include <string>
#include <vector>

namespace test_intersections {
namespace {

using namespace bounding_arcs_test;
namespace ba = CGAL::Bounding_arcs;
using ba::intersections;
using Bezier = ba::Bezier_curve_2<double>;
using Points = std::vector<ba::Xy<double>>;
using Kind = ba::Intersection_kind;

ba::Bounding_arc_tree_2 index_of(std::vector<Bezier> chain, ba::Decisions decisions = ba::Decisions::EXACT) {
  ba::Drawing_2<double> drawing;
  drawing.add(std::move(chain));
  return ba::Bounding_arc_tree_2(drawing, decisions);
}
ba::Bounding_arc_tree_2 polygon(const Points& p) {
  std::vector<Bezier> sides;
  for (std::size_t i = 0; i + 1 < p.size(); ++i) sides.emplace_back(Points{p[i], p[i + 1]});
  return index_of(sides);
}
std::string text_of(const Bezier& b) {
  std::string text;
  for (const auto& p : b.control_points()) text += "(" + std::to_string(p.x) + "," + std::to_string(p.y) + ") ";
  for (const double w : b.weights()) text += std::to_string(w) + " ";
  return text;
}

bool touch(const ba::Bracket& p, const ba::Bracket& q) { return p.lower <= q.upper && q.lower <= p.upper; }

// Both lists have the same points: ranges that meet, and the same kinds.
void expect_same(const ba::Piece_intersections& exact, const ba::Intersections_2<>& found, const std::string& place) {
  ASSERT_EQ(exact.points.size(), found.points.size()) << place;
  ASSERT_EQ(exact.overlaps.size(), found.overlaps.size()) << place;
  for (const ba::Piece_intersections::Intersection& p : exact.points) {
    bool is_found = false;
    for (const ba::Intersections_2<>::Intersection& q : found.points)
      is_found = is_found || (touch(p.a, q.a.t) && touch(p.b, q.b.t) && p.kind == q.kind);
    EXPECT_TRUE(is_found) << place << " t " << p.a.lower << " s " << p.b.lower;
  }
}

void expect_same(const ba::Piece_intersections& exact, const ba::Piece_intersections& found, const std::string& place) {
  ASSERT_EQ(exact.points.size(), found.points.size()) << place;
  ASSERT_EQ(exact.overlaps.size(), found.overlaps.size()) << place;
  for (std::size_t i = 0; i < exact.points.size(); ++i) {
    bool is_found = false;
    for (const ba::Piece_intersections::Intersection& q : found.points)
      is_found = is_found ||
                 (touch(exact.points[i].a, q.a) && touch(exact.points[i].b, q.b) && exact.points[i].kind == q.kind);
    EXPECT_TRUE(is_found) << place << " t " << exact.points[i].a.lower << " s " << exact.points[i].b.lower;
  }
}

bool is_closed(const Bezier& b) { return b.control_points().front() == b.control_points().back(); }

class Random_pieces {
 public:
  explicit Random_pieces(unsigned seed) : random_(seed) {}
  // Coordinates are integers up to `size`, or, for 0, any numbers in the unit square.
  Bezier operator()(int size, int degree) {
    std::uniform_real_distribution<double> real(0, 1);
    std::uniform_int_distribution<int> integer(0, size), weight(1, 3);
    Points points;
    std::vector<double> weights;
    const bool is_rational = size > 0 && random_() % 4 == 0;
    for (int i = 0; i <= degree; ++i) {
      if (size == 0) points.push_back({real(random_), real(random_)});
      else points.push_back({double(integer(random_)), double(integer(random_))});
      if (is_rational) weights.push_back(weight(random_));
    }
    return Bezier(points, weights);
  }
  int degree() { return 1 + static_cast<int>(random_() % 4); }

 private:
  std::mt19937 random_;
};

void expect_exact_points(unsigned seed, int size, int count) {
  Random_pieces piece(seed);
  std::size_t points = 0;
  for (int i = 0; i < count; ++i) {
    const Bezier p = piece(size, size == 0 ? 3 : piece.degree()), q = piece(size, size == 0 ? 3 : piece.degree());
    const ba::Bounding_arc_tree_2 a = index_of({p}), b = index_of({q});
    const ba::Piece_intersections exact =
        ba::exact_intersections(a.in_unit().exact_bezier(0), b.in_unit().exact_bezier(0));
    expect_same(exact, intersections(p, q), text_of(p) + "and " + text_of(q));
    if (is_closed(p) || is_closed(q)) continue;  // joints of closed pieces count once in drawings
    const ba::Intersections_2<> found = intersections(a, b);
    expect_same(exact, found, text_of(p) + "| " + text_of(q));
    EXPECT_EQ(ba::do_intersect(a, b), !exact.points.empty() || !exact.overlaps.empty());
    points += found.points.size();
  }
  EXPECT_GT(points, static_cast<std::size_t>(count) / 2);
}

TEST(Intersections, OfRandomPiecesInTheUnitSquareAreTheExactOnes) { expect_exact_points(1, 0, cases(4000)); }
TEST(Intersections, OfPiecesOnACoarseGridAreTheExactOnes) { expect_exact_points(2, 3, cases(1500)); }
TEST(Intersections, OfPiecesOnAGridAreTheExactOnes) { expect_exact_points(3, 12, cases(3000)); }

TEST(Intersections, InDoublesAloneAreRightOrUndecided) {
  Random_pieces piece(4);
  std::size_t undecided = 0, points = 0;
  for (int i = 0; i < cases(2000); ++i) {
    const int size = i % 2 == 0 ? 3 : 0;
    const Bezier p = piece(size, 3), q = piece(size, 3);
    if (is_closed(p) || is_closed(q)) continue;
    const ba::Bounding_arc_tree_2 a = index_of({p}, ba::Decisions::DOUBLE), b = index_of({q}, ba::Decisions::DOUBLE);
    const ba::Piece_intersections exact =
        ba::exact_intersections(a.in_unit().exact_bezier(0), b.in_unit().exact_bezier(0));
    const ba::Intersections_2<> found = intersections(a, b);
    for (const ba::Piece_intersections::Intersection& x : exact.points) {
      bool is_held = false;
      for (const ba::Intersections_2<>::Intersection& y : found.points)
        is_held =
            is_held || (touch(x.a, y.a.t) && touch(x.b, y.b.t) && (y.kind == Kind::UNDECIDED || y.kind == x.kind));
      EXPECT_TRUE(is_held) << text_of(p) << "| " << text_of(q);
    }
    for (const ba::Intersections_2<>::Intersection& y : found.points) {
      ++points;
      if (y.kind == Kind::UNDECIDED) {
        ++undecided;
        continue;
      }
      bool is_exact = false;
      for (const ba::Piece_intersections::Intersection& x : exact.points)
        is_exact = is_exact || (touch(x.a, y.a.t) && touch(x.b, y.b.t) && x.kind == y.kind);
      EXPECT_TRUE(is_exact) << text_of(p) << "| " << text_of(q);
    }
  }
  EXPECT_GT(undecided, 0U);
  EXPECT_GT(points, 10 * undecided);
}

// y = x^2 over [-1, 1] and its mirror image moved up by `gap`: none, a touching point, or two.
TEST(Intersections, OfParabolasThatAlmostTouchAreCounted) {
  for (const int exponent : {20, 30, 50})
    for (const int sign : {-1, 0, 1}) {
      const double gap = sign * std::ldexp(1.0, -exponent);
      const Bezier up(Points{{-1, 1}, {0, -1}, {1, 1}}), down(Points{{-1, -1 - gap}, {0, 1 - gap}, {1, -1 - gap}});
      const ba::Intersections_2<> found = intersections(index_of({up}), index_of({down}));
      ASSERT_EQ(found.points.size(), sign > 0 ? 0U : (sign == 0 ? 1U : 2U)) << exponent << " " << sign;
      for (const ba::Intersections_2<>::Intersection& p : found.points)
        EXPECT_EQ(p.kind, sign == 0 ? Kind::TANGENTIAL : Kind::TRANSVERSAL);
    }
}

TEST(Intersections, OfAVerticalSegmentThroughACuspIsOnePoint) {
  const Bezier cusp(Points{{0, 0}, {2, 2}, {0, 2}, {2, 0}}), straight(Points{{1, 0}, {1, 1}, {1, 1.5}, {1, 3}});
  const ba::Intersections_2<> found = intersections(index_of({cusp}), index_of({straight}));
  ASSERT_EQ(found.points.size(), 1U);
  EXPECT_EQ(found.points[0].kind, Kind::TANGENTIAL);
  EXPECT_TRUE(found.overlaps.empty());
  EXPECT_TRUE(ba::self_intersections(index_of({cusp})).points.empty());
}

TEST(Intersections, AtJointsCountOnce) {
  const ba::Bounding_arc_tree_2 square = polygon({{0, 0}, {2, 0}, {2, 2}, {0, 2}, {0, 0}});
  const ba::Intersections_2<> diagonal = intersections(square, polygon({{-1, -1}, {1, 1}, {3, 3}}));
  ASSERT_EQ(diagonal.points.size(), 2U);
  EXPECT_EQ(diagonal.points[0].a.bezier, 0U);
  EXPECT_EQ(diagonal.points[0].a.t.upper, 0);
  EXPECT_EQ(diagonal.points[1].a.bezier, 2U);
  const ba::Intersections_2<> corner = intersections(square, polygon({{2, 2}, {3, 2}, {3, 3}}));
  ASSERT_EQ(corner.points.size(), 1U);
  EXPECT_EQ(corner.points[0].kind, Kind::TANGENTIAL);  // with the side that goes on straight
  EXPECT_TRUE(ba::self_intersections(square).points.empty());
  const ba::Intersections_2<> eight = ba::self_intersections(polygon({{0, 0}, {1, 1}, {2, 2}, {2, 0}, {1, 1}, {0, 2}}));
  ASSERT_EQ(eight.points.size(), 1U);
  EXPECT_EQ(eight.points[0].kind, Kind::TRANSVERSAL);
}

TEST(Intersections, OfOneCurveGivenTwiceIsOneOverlap) {
  const Bezier curve(Points{{0, 0}, {1, 3}, {2, -3}, {3, 1}});
  const auto halves = curve.split(0.5);
  for (const auto& other : {std::vector<Bezier>{curve},
                            {curve.reversed()},
                            {halves.first, halves.second},
                            {halves.second.reversed(), halves.first.reversed()}}) {
    const ba::Intersections_2<> found = intersections(index_of({curve}), index_of(other));
    EXPECT_TRUE(found.points.empty());
    ASSERT_EQ(found.overlaps.size(), 1U);
    EXPECT_EQ(found.overlaps[0].a_from.t.lower, 0);
    EXPECT_EQ(found.overlaps[0].a_to.t.upper, 1);
  }
  const ba::Intersections_2<> half = intersections(index_of({curve}), index_of({halves.second}));
  ASSERT_EQ(half.overlaps.size(), 1U);
  EXPECT_EQ(half.overlaps[0].a_from.t.lower, 0.5);
  EXPECT_TRUE(half.points.empty());
  const ba::Bounding_arc_tree_2 square = polygon({{0, 0}, {2, 0}, {2, 2}, {0, 2}, {0, 0}});
  const ba::Intersections_2<> ring = intersections(square, square);
  EXPECT_TRUE(ring.points.empty());
  ASSERT_EQ(ring.overlaps.size(), 1U);
  EXPECT_EQ(ring.overlaps[0].a_to.bezier, 3U);
}

TEST(Intersections, WithCirclesLinesAndArcsAreKnown) {
  const ba::Bounding_arc_tree_2 unit(ba::circle_drawing({0, 0}, 1)), inner(ba::circle_drawing({0, 0}, 0.5)),
      beside(ba::circle_drawing({2, 0}, 1)), within(ba::circle_drawing({0.5, 0}, 0.5)),
      across(ba::circle_drawing({1, 0}, 1));
  EXPECT_TRUE(intersections(unit, inner).points.empty());
  EXPECT_EQ(intersections(unit, unit).overlaps.size(), 1U);
  for (const ba::Bounding_arc_tree_2* touching : {&beside, &within}) {
    const ba::Intersections_2<> found = intersections(unit, *touching);
    ASSERT_EQ(found.points.size(), 1U);
    EXPECT_EQ(found.points[0].kind, Kind::TANGENTIAL);
    EXPECT_EQ(found.points[0].point, (ba::Xy<double>{1, 0}));
  }
  const ba::Intersections_2<> two = intersections(unit, across);
  ASSERT_EQ(two.points.size(), 2U);
  EXPECT_NEAR(two.points[0].point.y, std::sqrt(0.75), 1e-15);
  EXPECT_NEAR(two.points[1].point.y, -std::sqrt(0.75), 1e-15);
  EXPECT_EQ(intersections(unit, ba::Bounding_arc_tree_2(ba::line_drawing(unit, {0, 1}, {1, 0}))).points.size(), 1U);
  EXPECT_EQ(intersections(unit, ba::Bounding_arc_tree_2(ba::line_drawing(unit, {0, 1e-3}, {7, 1}))).points.size(), 2U);
  EXPECT_EQ(intersections(unit, ba::Bounding_arc_tree_2(ba::ray_drawing(unit, {0, 1e-3}, {7, 1}))).points.size(), 1U);
  EXPECT_EQ(intersections(unit, ba::Bounding_arc_tree_2(ba::ray_drawing(unit, {3, 0}, {1, 0}))).points.size(), 0U);
  EXPECT_EQ(intersections(unit, ba::Bounding_arc_tree_2(ba::segment_drawing({0, 0}, {0.5, 0.5}))).points.size(), 0U);
  for (const double bulge : {1.0, 0.25, 0x1p-40, 0.0, -0.5}) {
    // half of the circle about the chord's middle, and flatter arcs: all meet the vertical axis once, where b says
    const ba::Bounding_arc_tree_2 arc(ba::arc_drawing({{-1, 0}, {1, 0}, bulge}));
    const ba::Intersections_2<> found =
        intersections(arc, ba::Bounding_arc_tree_2(ba::line_drawing(arc, {0, 0}, {0, 1})));
    ASSERT_EQ(found.points.size(), 1U) << bulge;
    EXPECT_NEAR(found.points[0].point.y, -bulge, 1e-15);
  }
  EXPECT_EQ(intersections(unit, ba::Bounding_arc_tree_2(ba::arc_drawing({{-1, 0}, {1, 0}, 1}))).overlaps.size(), 1U);
}

TEST(Intersections, OfCurvesWithNumbersThatAreNoDoublesAreThoseOfTheExactCurves) {
  using Exact = CGAL::Exact_rational;
  const Exact third = Exact(1) / Exact(3);
  ba::Drawing_2<Exact> line, touching, above;
  line.add(ba::Bezier_curve_2<Exact>({{Exact(0), third}, {Exact(1), third}}));
  // y = 1/3 + (x - 1/2)^2, and 2^-80 above
  touching.add(ba::Bezier_curve_2<Exact>(
      {{Exact(0), third + Exact(0.25)}, {Exact(0.5), third - Exact(0.25)}, {Exact(1), third + Exact(0.25)}}));
  const Exact higher = third + Exact(std::ldexp(1.0, -80));
  above.add(ba::Bezier_curve_2<Exact>(
      {{Exact(0), higher + Exact(0.25)}, {Exact(0.5), higher - Exact(0.25)}, {Exact(1), higher + Exact(0.25)}}));
  const ba::Bounding_arc_tree_2 a(line);
  const ba::Intersections_2<> one = intersections(a, ba::Bounding_arc_tree_2(touching));
  ASSERT_EQ(one.points.size(), 1U);
  EXPECT_EQ(one.points[0].kind, Kind::TANGENTIAL);
  EXPECT_TRUE(intersections(a, ba::Bounding_arc_tree_2(above)).points.empty());
  EXPECT_EQ(ba::do_intersect(a, ba::Bounding_arc_tree_2(above, ba::Decisions::DOUBLE)), std::nullopt);
}

TEST(Intersections, DoNotDependOnScaleAndPlace) {
  Random_pieces piece(5);
  const auto moved = [](const Bezier& b, double scale, double shift) {
    Points points;
    for (const auto& p : b.control_points()) points.push_back({scale * (p.x + shift), scale * (p.y - shift)});
    return Bezier(points);
  };
  for (int i = 0; i < cases(300); ++i) {
    const Bezier p = piece(0, 3), q = piece(0, 3);
    const std::size_t count = intersections(index_of({p}), index_of({q})).points.size();
    for (const double scale : {1e-9, 1e9, 1e-150, 1e150})
      EXPECT_EQ(intersections(index_of({moved(p, scale, 0)}), index_of({moved(q, scale, 0)})).points.size(), count);
    // rounding to a multiple of 2^-26 moves transversal points but makes and loses none here
    EXPECT_EQ(intersections(index_of({moved(p, 1, 1e8)}), index_of({moved(q, 1, 1e8)})).points.size(), count);
  }
}

// Waves on a square, in no order, and the same moved: both grow as the number of pieces, and so does what is looked at.
TEST(Intersections, LookAtAsManyBoxesAsThereArePieces) {
  std::vector<double> rows_a_piece, found_a_piece;
  for (const std::size_t columns : {10U, 60U, FEW_CASES ? 60U : 200U}) {
    std::mt19937 random(6);
    std::vector<Points> waves;
    for (std::size_t i = 0; i < columns * columns; ++i) {
      const double x = static_cast<double>(i % columns), y = static_cast<double>(i / columns);
      waves.push_back({{x, y}, {x + 0.4, y + 0.9}, {x + 0.6, y - 0.9}, {x + 1, y}});
    }
    std::shuffle(waves.begin(), waves.end(), random);
    ba::Drawing_2<double> at, beside;
    for (Points& p : waves) {
      at.add(Bezier(p));
      for (auto& q : p) q = {q.x + 0.31, q.y + 0.07};
      beside.add(Bezier(p));
    }
    const ba::Bounding_arc_tree_2 a(at), b(beside);
    std::size_t pairs = 0;
    const auto visit = [&](std::uint32_t, std::uint32_t) { return ++pairs > 0; };
    ba::Overlap_search search(a.in_unit().boxes(), b.in_unit().boxes(), visit);
    search(a.in_unit().boxes().root(), b.in_unit().boxes().root());
    const double n = static_cast<double>(waves.size());
    EXPECT_LE(static_cast<double>(pairs), 8 * n);
    rows_a_piece.push_back(static_cast<double>(search.rows()) / n);
    found_a_piece.push_back(static_cast<double>(intersections(a, b).points.size()) / n);
  }
  EXPECT_LE(rows_a_piece.back(), 1.5 * rows_a_piece.front());
  EXPECT_NEAR(found_a_piece.back(), found_a_piece.front(), 0.5);
  EXPECT_GT(found_a_piece.front(), 0.5);
}

// Doubles tell of equal segments that they are, of one with other weights they do not. That stays open beside the
// others.
TEST(Intersections, BesideAnOverlapStayOpen) {
  const ba::Xy<double> a{-3, 2}, b{0, -3}, c{1, -2};
  for (const auto decisions : {ba::Decisions::DOUBLE, ba::Decisions::EXACT}) {
    const ba::Bounding_arc_tree_2 p = index_of({Bezier({a, b}), Bezier({b, c}, {3, 2})}, decisions),
                                  q = index_of({Bezier({a, b}), Bezier({b, c})}, decisions);
    const auto common = intersections(p, q);
    EXPECT_EQ(common.overlaps.size(), 1U);
    const bool is_open = decisions == ba::Decisions::DOUBLE;
    ASSERT_EQ(common.points.size(), is_open ? 1U : 0U);
    if (!is_open) continue;
    EXPECT_EQ(common.points.front().kind, Kind::UNDECIDED);
    EXPECT_TRUE(touch(common.points.front().a.t, {0.5, 0.5}));
  }
}

// Weights between 10^-decades and 10^decades: parameters are coarser than coordinates where the curve is fast.
Bezier uneven_piece(std::mt19937& random, int degree, double decades) {
  std::uniform_real_distribution<double> coordinate(-1, 1), exponent(-decades, decades);
  Points points;
  std::vector<double> weights;
  for (int i = 0; i <= degree; ++i) {
    const double x = coordinate(random), y = coordinate(random);
    points.push_back({x, y});
    weights.push_back(std::pow(10, exponent(random)));
  }
  return Bezier(points, weights);
}

TEST(Intersections, OfUnevenWeightsAreTheExactOnes) {
  std::mt19937 random(4);
  const int count = cases(150);
  for (int i = 0; i < count; ++i) {
    const Bezier p = uneven_piece(random, 3 + i % 3, 3);
    const ba::Bounding_arc_tree_2 a = index_of({p});
    expect_same(ba::exact_self_intersections(a.in_unit().exact_bezier(0)), ba::self_intersections(a), text_of(p));
  }
}

// Ends of lines that miss others by 1e-11 to 1e-14: a crossing beside two ends that are not one point is a crossing.
TEST(Intersections, BesideEndsThatAreNotOneAreFound) {
  const std::vector<Bezier> lines{Bezier(Points{{0, 0}, {-2, -2}}), Bezier(Points{{-2, -1.9999999999908515}, {4, -2}}),
                                  Bezier(Points{{3.9999999981730983, -2.0000000018269017}, {-3, -2}}),
                                  Bezier(Points{{-2.999999916418225, -1.9999999164182252}, {-1, -2}}),
                                  Bezier(Points{{-1, -2.0000000000000067}, {-2, 1}})};
  for (const Bezier& p : lines)
    for (const Bezier& q : lines) {
      if (&p == &q) continue;
      EXPECT_EQ(ba::intersections(index_of({p}), index_of({q})).points.size(),
                ba::exact_intersections(ba::exact_bezier(p), ba::exact_bezier(q)).points.size())
          << text_of(p) << text_of(q);
    }
}

// The middle of such a curve has waves of 1e-6 of its size and less, of which doubles tell little.
Bezier with_small_waves(int degree) {
  Points points;
  for (int i = 0; i <= degree; ++i) points.push_back({std::cos(2.7 * i), std::sin(1.9 * i)});
  return Bezier(points);
}
TEST(Intersections, InSmallWavesAreThoseOfElimination) {
  for (int degree = 8; degree <= 13; ++degree) {
    const Bezier curve = with_small_waves(degree);
    const auto found = ba::self_intersections(index_of({curve})).points;
    const auto exact = ba::exact_self_intersections(ba::exact_bezier(curve)).points;
    ASSERT_EQ(found.size(), exact.size()) << degree;
    for (std::size_t i = 0; i < found.size(); ++i) {
      EXPECT_TRUE(found[i].a.t.touches(exact[i].a) && found[i].b.t.touches(exact[i].b)) << degree;
      EXPECT_EQ(found[i].kind, exact[i].kind) << degree;
    }
  }
}
// Elimination takes a quarter of a minute, and tells these.
TEST(Intersections, InSmallWavesOfDegreeTwentyAreFound) {
  Points points = with_small_waves(20).control_points();
  points.back() = points.front();
  const auto found = ba::self_intersections(index_of({Bezier(points)})).points;
  const double expected[][2] = {{0.13633924787028015, 0.28232709792915298},
                                {0.13643698180746291, 0.24498892866188111},
                                {0.31117314888602857, 0.41596069363158148}};
  ASSERT_EQ(found.size(), 3u);
  for (std::size_t i = 0; i < found.size(); ++i) {
    EXPECT_LE(found[i].a.t.lower, expected[i][0] + 1e-16);
    EXPECT_GE(found[i].a.t.upper, expected[i][0] - 1e-16);
    EXPECT_LE(found[i].b.t.lower, expected[i][1] + 1e-16);
    EXPECT_GE(found[i].b.t.upper, expected[i][1] - 1e-16);
  }
}

// Crossings of the polygon of samples with itself; sides next to each other have none.
std::size_t sampled_crossings(const std::vector<Bezier>& chain) {
  constexpr int SAMPLES = 1 << 14;
  Points points;
  for (const Bezier& piece : chain)
    for (int i = 0; i < SAMPLES; ++i) points.push_back(piece.point(double(i) / SAMPLES));
  std::vector<std::size_t> sides(points.size() - 1);
  std::iota(sides.begin(), sides.end(), std::size_t(0));
  const auto least = [&](std::size_t i) { return (std::min)(points[i].x, points[i + 1].x); };
  std::sort(sides.begin(), sides.end(), [&](std::size_t i, std::size_t j) { return least(i) < least(j); });
  const auto are_parted = [&](std::size_t i, std::size_t j) {  // the ends of side j by the line of side i
    const auto along = points[i + 1] - points[i];
    return (cross(along, points[j] - points[i]) < 0) != (cross(along, points[j + 1] - points[i]) < 0);
  };
  std::size_t count = 0;
  for (std::size_t k = 0; k < sides.size(); ++k) {
    const std::size_t i = sides[k];
    const double most = (std::max)(points[i].x, points[i + 1].x);
    for (std::size_t m = k + 1; m < sides.size() && least(sides[m]) <= most; ++m) {
      const std::size_t j = sides[m];
      if (i + 1 != j && j + 1 != i && are_parted(i, j) && are_parted(j, i)) ++count;
    }
  }
  return count;
}

// Elimination would take minutes for each of them: where doubles leave a curve open beside a cut, it runs ahead.
TEST(Intersections, OfUnevenWeightsInHighDegreesAreThoseOfSamples) {
  std::size_t points = 0;
  for (const unsigned seed : {1U, 2U, 3U, 4U}) {
    std::mt19937 random(seed);
    const Bezier p = uneven_piece(random, 32, 1), q = uneven_piece(random, 24, 1);
    Points next = q.control_points();
    next.front() = p.control_points().back();
    const std::vector<Bezier> chain{p, Bezier(next, q.weights())};
    const ba::Intersections_2<> found = ba::self_intersections(index_of(chain));
    EXPECT_EQ(found.points.size(), sampled_crossings(chain)) << seed;
    EXPECT_TRUE(found.overlaps.empty()) << seed;
    points += found.points.size();
  }
  EXPECT_GT(points, 8U);
}

TEST(Intersections, OfPartsThatRunAheadAreNone) {
  const auto exact = [](const Bezier& b) { return ba::exact_bezier(b); };
  const auto loop = exact(Bezier(Points{{0, 0}, {3, 2}, {-2, 2}, {1, 0}}));
  EXPECT_FALSE(ba::runs_ahead(loop, 0, 1));
  EXPECT_TRUE(ba::runs_ahead(loop, 0, 0.25));
  EXPECT_TRUE(ba::runs_ahead(loop, 0.5, 0.5 + 0x1p-50));
  const auto cusp = exact(Bezier(Points{{0, 0}, {1, 1}, {0, 1}, {1, 0}}));  // at 1/2
  EXPECT_FALSE(ba::runs_ahead(cusp, 0.5 - 0x1p-40, 0.5 + 0x1p-40));
  EXPECT_TRUE(ba::runs_ahead(cusp, 0.5 + 0x1p-20, 0.5 + 0x1p-19));
  const auto fast = exact(Bezier(Points{{0, 0}, {1, 1}, {2, 0}}, {1, 0x1p-4, 0x1p-8}));
  EXPECT_TRUE(ba::runs_ahead(fast, 0, 1));
}

TEST(Intersections, OfNothingAreNone) {
  const ba::Bounding_arc_tree_2 nothing{ba::Drawing_2<double>()}, segment = polygon({{0, 0}, {1, 1}});
  EXPECT_TRUE(intersections(nothing, segment).points.empty());
  EXPECT_TRUE(ba::self_intersections(nothing).points.empty());
  EXPECT_EQ(ba::do_intersect(nothing, nothing), false);
  const ba::Bounding_arc_tree_2 point = polygon({{0.5, 0.5}, {0.5, 0.5}});
  EXPECT_EQ(ba::do_intersect(point, segment), true);
  EXPECT_EQ(ba::do_intersect(polygon({{0.5, 0.25}, {0.5, 0.25}}), segment), false);
}

}  // namespace
}  // namespace test_intersections
