// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Intersections of drawings against exact ones of each two Bezier pieces.

#include "../../src/library/tree/Segment_hierarchy.h"
#include "cases.h"
#include "intersection_checks.h"

#include <CGAL/Bounding_arcs_2/query/intersections.h>
#include "../../src/library/query/exact_intersections.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
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

}  // namespace
}  // namespace test_intersections
