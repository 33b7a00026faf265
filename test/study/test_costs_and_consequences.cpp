// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// What exactness costs, what goes wrong without it, and verdicts on grids of neighbouring doubles.

#include <CGAL/Bounding_arcs_2/number/Mpfr_interval.h>
#include <CGAL/Bounding_arcs_2/region/Bca.h>
#include <CGAL/Bounding_arcs_2/study/Consequence_study.h>
#include <CGAL/Bounding_arcs_2/study/Cost_study.h>
#include <CGAL/Bounding_arcs_2/study/Verdict_grid.h>
#include <CGAL/Bounding_arcs_2/study/stability_families.h>
#include "ray_crossings.h"

#include <gtest/gtest.h>

#include <cmath>
#include <set>
#include <vector>

namespace test_costs_and_consequences {
namespace {

using namespace CGAL::Bounding_arcs;
using Curve = Bezier_curve_2<double>;

Study_piece whole(const Curve& curve) {
  const auto spirals = spiral_segments(curve);
  return {"one", 1, spirals.front(), spirals.front().first(), spirals.front().last()};
}

std::vector<Study_piece> short_pieces(double delta) {
  std::vector<Study_piece> pieces;
  for (const Study_piece& piece : subdivision_family())
    if (piece.delta == delta && pieces.size() < 2) pieces.push_back(piece);
  return pieces;
}

// A thickness T that is left of lengths of size 1 asks the textbook for log2(1 / T) bits more than it has itself.
TEST(CostStudy, TextbookNeedsTheBitsThatItsDifferencesLose) {
  for (const double delta : {1.0, 0x1p-10, 0x1p-20}) {
    const auto pieces = short_pieces(delta);
    const auto rows = cost_rows(pieces, 1);
    ASSERT_EQ(rows.size(), 3u);
    const double thickness = Bca::thickness(pieces[0].spiral.shape<double>(pieces[0].t0, pieces[0].t1));
    const double lost = -std::log2(thickness);
    EXPECT_GT(static_cast<double>(rows[0].textbook_bits), 53 + lost - 8) << delta;
    EXPECT_LT(static_cast<double>(rows[0].textbook_bits), 53 + 2 * lost + 64) << delta;
    for (const Cost_row& row : rows) {
      EXPECT_LE(row.stable_bits, 128u) << row.method;  // whatever delta
      EXPECT_EQ(row.pieces, 2u);
      EXPECT_EQ(row.rational_time > 0, row.method != "bilens");
      EXPECT_EQ(row.root_bits > 0, row.method != "bilens");
    }
  }
}

// An expression gets some hundred bits long beside the double next to it, and far longer before it is called equal.
TEST(CostStudy, ExpressionsNeedFewBitsToDecideAndManyToCallEqual) {
  for (const Cost_row& row : cost_rows({whole(Curve({{0, 0}, {0.5, 0}, {1, 1}}))}, 1)) {
    EXPECT_GE(row.expression_bits, 53u) << row.method;
    EXPECT_LE(row.expression_bits, 1024u) << row.method;
    EXPECT_GE(row.separation_bits, 2 * row.expression_bits) << row.method;
  }
}

TEST(CostStudy, CountsStages) {
  const auto rows = cost_rows({whole(Curve({{0, 0}, {0.5, 0}, {1, 1}}))}, 1);
  ASSERT_EQ(rows.size(), 3u);
  for (const Cost_row& row : rows) {
    EXPECT_EQ(row.decisions.all(), 13u);
    EXPECT_GE(row.decisions.bounded, 2u) << row.method;     // 2^-8 beside
    EXPECT_LE(row.decisions.bounded, 12u) << row.method;    // not the double next to it
    EXPECT_GE(row.decisions.enclosure, 1u) << row.method;   // but many bits
    EXPECT_EQ(row.decisions.expression, 0u) << row.method;  // as no thickness here is a double
  }
}

TEST(CostStudy, LengthsOfRationalsAreThoseOfTheCoordinates) {
  const auto few = cost_rows({whole(Curve({{0, 0}, {0.5, 0}, {1, 1}}))}, 1),
             many = cost_rows({whole(Curve({{0, 0}, {0.5, 0}, {1, 1 + 0x1p-40}}))}, 1);
  EXPECT_LE(few[0].rational_bits, 8u);
  EXPECT_GE(many[0].rational_bits, 41u);
  EXPECT_LE(many[0].rational_bits, 8 * 41u);  // of products of coordinates
  EXPECT_GE(many[1].root_bits, 41u);
}

TEST(ConsequenceStudy, NothingIsWrongWhereNothingIsSmall) {
  for (const Consequence_row& row : consequence_rows({whole(Curve({{0, 0}, {0.5, 0}, {1, 1}}))}))
    for (const Consequences& c : {row.textbook, row.stable}) {
      EXPECT_EQ(c.asked, 6u);
      EXPECT_EQ(c.wrong + c.not_held + c.miscounted + c.torn, 0u) << row.method;
    }
}

TEST(ConsequenceStudy, TextbookMisleadsOnShortPieces) {
  const auto rows = consequence_rows(short_pieces(0x1p-24));
  ASSERT_EQ(rows.size(), 3u);
  for (const Consequence_row& row : rows) {
    EXPECT_GT(row.textbook.wrong, 0u) << row.method;
    EXPECT_EQ(row.textbook.miscounted, row.pieces) << row.method;
    EXPECT_EQ(row.stable.wrong + row.stable.not_held + row.stable.miscounted + row.stable.torn, 0u) << row.method;
  }
}

// A textbook's circle far larger than its arc has a center without the digits of the arc's place.
TEST(ConsequenceStudy, CentersTearOffsetsOfFlatPieces) {
  for (const auto& [height, tears] : {std::pair{1.0, false}, {0x1p-20, true}}) {
    const auto rows = consequence_rows({whole(Curve({{0, 0}, {0.5, 0}, {1, height}}))});
    ASSERT_EQ(rows.size(), 3u);
    for (const Consequence_row& row : rows) {
      EXPECT_EQ(row.textbook.torn, tears ? 1u : 0u) << row.method << ' ' << height;
      EXPECT_EQ(row.stable.torn, 0u) << row.method << ' ' << height;
    }
  }
}

// By rationals and enclosures in other forms than those that the grids are made of.
int exact_side(const Xy<double>& q) {
  using NT = CGAL::Exact_rational;
  const auto exact = [](const Xy<double>& p) { return Xy<NT>{NT(p.x), NT(p.y)}; };
  const Verdict_arc arc;
  const Xy<NT> p0 = exact(arc.p0), n = perp(exact(arc.tangent)), d = exact(arc.p1) - p0;
  const Xy<NT> center = p0 + NT(dot(d, d) / (NT(2) * dot(n, d))) * n, r = p0 - center, v = exact(q) - center;
  return sign_of(NT(dot(r, r) - dot(v, v)));
}
int exact_contact(const Xy<double>& q) {
  const auto exact = [](double x) { return Mpfr_interval(CGAL::Exact_rational(x), 400); };
  const Verdict_circles c;
  const Xy<Mpfr_interval> v{exact(q.x) - exact(c.center.x), exact(q.y) - exact(c.center.y)};
  return (sqrt(dot(v, v)) - exact(c.radius) - exact(c.other_radius)).certain_sign();
}
int exact_location(const Xy<double>& q) {
  using NT = CGAL::Exact_rational;
  std::vector<Xy<NT>> points;
  const Curve curve = verdict_curve();
  for (const Xy<double>& p : curve.control_points()) points.push_back({NT(p.x), NT(p.y)});
  const auto crossings = bounding_arcs_test::exact_ray_crossings(Bezier_curve_2<NT>(points), Xy<NT>{NT(q.x), NT(q.y)});
  return crossings.is_on ? 0 : (crossings.winding == 0 ? 1 : -1);
}

TEST(VerdictGrids, OursAreExactAndNaiveOnesAreNot) {
  const auto grids = verdict_grids(16);
  ASSERT_EQ(grids.size(), 3u);
  int (*const exact[])(const Xy<double>&) = {exact_side, exact_contact, exact_location};
  for (std::size_t k = 0; k < grids.size(); ++k) {
    const Verdict_grid& grid = grids[k];
    EXPECT_GT(grid.differences(), 0u) << grid.name;
    for (std::size_t i = 0; i < grid.ours.size(); ++i)
      EXPECT_EQ(grid.ours[i], exact[k](grid.point(i % 16, i / 16))) << grid.name << ' ' << i;
    const std::set<signed char> seen(grid.ours.begin(), grid.ours.end());
    EXPECT_TRUE(seen.count(1) == 1 && seen.count(-1) == 1) << grid.name;  // the curve passes
  }
}

}  // namespace
}  // namespace test_costs_and_consequences
