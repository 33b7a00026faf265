// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// What a segment's widening leaves for the errors of bulges: no more than what points and ends leave of it.

#include "../../../src/library/tree/batch/Arc_points.h"
#include "../../../src/library/tree/batch/Bca_arcs.h"
#include "trees.h"

#include <CGAL/Bounding_arcs_2.h>
#include <CGAL/Bounding_arcs_2/tree/Region_columns.h>

#include <gtest/gtest.h>

#include <cmath>
#include <memory>
#include <vector>

#ifndef BOUNDING_ARCS_WITHOUT_FILTER
namespace test_arc_room {
namespace {

using namespace bounding_arcs_test;

// The room of a segment for arcs of BCAs where no more than the usual widening is allowed.
ba::filter::Arc_room room_of(const Spiral& spiral) {
  const ba::Local_curve curve = spiral.local_curve();
  const double size = spiral.coordinate_size();
  ba::filter::Arc_room room{};
  ba::for_kind(curve.kind, [&](auto kind) {
    room = ba::filter::arc_room<ba::filter::Bca_arcs, kind()>(curve.form, curve.half, {size, ba::ulp_of(size), 0, 0});
  });
  return room;
}

// A part of a curve as fast as its size allows, so short that its own numbers lose little.
TEST(ArcPoints, LeaveRoomForWhatIsBeyondRoundedEnds) {
  const auto curve = std::make_shared<const ba::Tabulated_bezier<double>>(Bezier({{-1, -1}, {1, 1}, {-1, 1}, {1, -1}}));
  const Spiral spiral(curve, 0, 0x1p-10, {}, false);
  const ba::filter::Arc_room points = room_of(spiral);
  const double ulp = 0x1p-52, speed = 3 * std::sqrt(8), of_ends = std::sqrt(2);  // |C'(0)|, and by what ends err
  const double room = points.room * ba::Local_curve(spiral.local_curve()).form.unit;
  EXPECT_GT(room, 0);
  EXPECT_LE(room, 8 * ulp - of_ends * ulp - speed * (ulp / 2));
}

// The parabola (t, t^2), with Taylor coefficients (1, 1) and (0, 1) about 1/2: the terms of a point's way from there
// err by four and seven half ulps of themselves.
TEST(ArcPoints, LeaveRoomForTheRoundingsOnTheWay) {
  const auto curve = std::make_shared<const ba::Tabulated_bezier<double>>(Bezier({{0, 0}, {0.5, 0}, {1, 1}}));
  const Spiral spiral(curve, 0, 1, {}, false);
  const ba::filter::Arc_room points = room_of(spiral);
  const double ulp = 0x1p-52, half_ulp = ulp / 2, h = 0.5;
  const double x = ulp + 4 * h * half_ulp, y = ulp + (4 * h + 7 * h * h) * half_ulp;
  const double beyond = std::sqrt(5) * half_ulp;         // |C'(1)|
  const double moved = std::hypot(1, std::sqrt(2) - 1);  // by ends of an arc of the largest bulge, tan 22.5
  EXPECT_GT(points.room, 0);
  EXPECT_LE(points.room * ba::Local_curve(spiral.local_curve()).form.unit, 8 * ulp - moved * std::hypot(x, y) - beyond);
}

// The quarter of the unit circle by weights (1, 1, 2) about its middle: the numerator's way and the weight's err, and
// their quotient is as long as the chord to the farther end.
TEST(ArcPoints, LeaveRoomForTheRoundingsOfQuotients) {
  const auto curve = std::make_shared<const ba::Tabulated_bezier<double>>(Bezier({{1, 0}, {1, 1}, {0, 1}}, {1, 1, 2}));
  const Spiral spiral(curve, 0.25, 0.75, {}, false);
  const ba::Local_curve local = spiral.local_curve();
  ASSERT_EQ(local.kind, ba::RATIONAL + 2);
  const ba::filter::Arc_room points = room_of(spiral);
  const auto& c = local.form.coefficients;
  const double h = 0.25, ulp = 0x1p-52, half_ulp = ulp / 2, unit = local.form.unit;
  const double least = 1 + 0.0625, middle = 1 + 0.25;  // 1 + t^2 at 1/4 and 1/2
  const auto way = [&](const double* x) {
    return unit * (4 * std::fabs(x[1]) * h + 7 * std::fabs(x[2]) * h * h) / (least / middle);
  };
  const double points_err = std::hypot(ulp + way(c.x) * half_ulp, ulp + way(c.y) * half_ulp);
  EXPECT_GT(points.room, 0);
  EXPECT_LE(points.room * unit, 8 * ulp - std::hypot(1, std::sqrt(2) - 1) * points_err - half_ulp);
  const ba::filter::Weights weights = ba::filter::weights_of<ba::RATIONAL + 2>(local.form, local.half);
  EXPECT_LE(weights.least, least / middle * (1 + 0x1p-40));
  EXPECT_GE(weights.least, 0.95 * least / middle);
  EXPECT_GE(weights.most, 1.5625 / middle * (1 - 0x1p-40));
}

// A piece that is slow at one end, where what its tangent errs by turns it the most.
TEST(BcaArcs, HaveRoomForTheErrorAtTheSlowerEnd) {
  for (const bool is_first : {true, false}) {
    std::vector<Point> control{{0, 0}, {0x1p-10, 0}, {0.5, 0.1}, {1, 0.5}};
    if (!is_first) control = {control.rbegin(), control.rend()};
    const auto curve = std::make_shared<const ba::Tabulated_bezier<double>>(Bezier(control));
    const ba::Local_curve local = Spiral(curve, 0, 1, {}, false).local_curve();
    const ba::Local_form<double>& form = local.form;
    const auto piece = ba::local_piece<3>(form.coefficients, 0.0, local.half);
    const double one = piece.p - piece.half * piece.r, other = piece.p + piece.half * piece.r,
                 slow = (std::min)(one, other), fast = (std::max)(one, other);
    ASSERT_LT(form.least_dot, slow);
    ASSERT_LT(100 * slow, fast);
    const auto holds = [&](double room) { return ba::filter::Bca_arcs::of<true>(form, piece, room).holds; };
    const double bulge = ba::filter::Bca_arcs::of<true>(form, piece, 1).outer;
    // of the angle, whose tangent is at most 2.43 times the bulge, and the roundings of the formula
    const double of_dot = 2.43 * bulge * form.least_dot / ba::Local_precision<double>::DIGITS;
    const double error = (piece.half * form.turn_rate_error + of_dot) / slow + 12 * 0x1p-53 * bulge;
    const double moved = piece.half * std::sqrt(piece.chord_square) * error;
    EXPECT_FALSE(holds(moved * (1 - 0x1p-10)));
    EXPECT_TRUE(holds(moved * (1 + 0x1p-10)));
  }
}

}  // namespace
}  // namespace test_arc_room
#endif
