// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Splines of DXF files that are given by points which they run through.

#include "../support/dxf_text.h"

#include <cmath>
#include <cstddef>
#include <string>
#include <vector>

namespace test_dxf_fit_points {
namespace {

using namespace bounding_arcs_test;

// Curvature and speed agree on both sides of every fit point: the derivatives by the length of chords.
void expect_smooth(const std::vector<Bezier>& pieces, bool is_closed) {
  for (std::size_t i = is_closed ? 0 : 1; i < pieces.size(); ++i) {
    const auto &p = pieces[i > 0 ? i - 1 : pieces.size() - 1].control_points(), &q = pieces[i].control_points();
    const Point dp = p[3] - p[0], dq = q[3] - q[0];
    const double h = std::hypot(dp.x, dp.y), k = std::hypot(dq.x, dq.y);
    const Point speed = 3 / h * (p[3] - p[2]) - 3 / k * (q[1] - q[0]);
    const Point bend = 6 / (h * h) * (p[3] - 2 * p[2] + p[1]) - 6 / (k * k) * (q[2] - 2 * q[1] + q[0]);
    EXPECT_LT(std::hypot(speed.x, speed.y), 1e-12) << i;
    EXPECT_LT(std::hypot(bend.x, bend.y), 1e-11) << i;
  }
}

TEST(DxfFitPoints, AreInterpolatedByChordLengths) {
  const std::string head = "0|SPLINE|8|0|71|3|74|4|", points = "11|0|21|0|11|3|21|4|11|6|21|4|11|9|21|0|";
  const Curve_file open = read_entities(head + points);
  ASSERT_EQ(open.curves.size(), 1u);
  ASSERT_EQ(open.notes.size(), 1u);
  EXPECT_EQ(Curve_file::text_of(open.notes),
            "read all the same: 1 SPLINE: through fit points, interpolated by chord lengths");
  const std::vector<Bezier>& pieces = open.curves[0].beziers;
  ASSERT_EQ(pieces.size(), 3u);
  EXPECT_EQ(pieces[1].control_points().front(), (Point{3, 4}));
  EXPECT_EQ(pieces[1].control_points().back(), (Point{6, 4}));
  expect_smooth(pieces, false);
  const auto& first = pieces[0].control_points();
  const Point bend = first[2] - 2 * first[1] + first[0];
  EXPECT_LT(std::hypot(bend.x, bend.y), 1e-13) << "no bend at an end without a tangent";
  // tangents, of any length
  const Curve_file tangents = read_entities(head + "12|0|22|9|13|0|23|-2|" + points);
  expect_smooth(tangents.curves[0].beziers, false);
  const auto &start = tangents.curves[0].beziers.front().control_points(),
             &end = tangents.curves[0].beziers.back().control_points();
  EXPECT_NEAR(start[1].x, 0, 1e-15);
  EXPECT_NEAR(start[1].y, 5.0 / 3, 1e-15) << "a third of the chord";
  EXPECT_NEAR(end[2].x, 9, 1e-15);
  EXPECT_NEAR(end[2].y, 5.0 / 3, 1e-15);
  // closed ones are as smooth where they begin; a first point that is repeated, and one that is twice there, too
  for (const std::string more : {"", "11|0|21|0|", "11|9|21|0|11|0|21|0|"}) {
    const Curve_file closed = read_entities("0|SPLINE|8|0|70|11|71|3|" + points + more);
    ASSERT_EQ(closed.curves[0].beziers.size(), 4u);
    EXPECT_TRUE(closed.curves[0].closed);
    expect_smooth(closed.curves[0].beziers, true);
  }
  // two points are a line; control points go before fit points
  const Curve_file two = read_entities("0|SPLINE|8|0|71|3|11|0|21|0|11|3|21|4|");
  EXPECT_NEAR(length_of(two), 5, NEAR);
  const Curve_file both = read_entities("0|SPLINE|8|0|71|1|40|0|40|0|40|1|40|1|10|0|20|0|10|3|20|4|" + points);
  EXPECT_TRUE(both.notes.empty());
  EXPECT_EQ(both.curves[0].beziers.size(), 1u);
}

}  // namespace
}  // namespace test_dxf_fit_points
