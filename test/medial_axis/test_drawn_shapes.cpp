// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Axes of single drawings, each hard in its way.

#include "axis_checks.h"
#include "drawn_axis_checks.h"
#include "drawn_shapes.h"
#include "machine_parts.h"

#include <CGAL/Bounding_arcs_2/medial_axis/axis_certificate.h>
#include <CGAL/Bounding_arcs_2/medial_axis/medial_axis.h>
#include <CGAL/Bounding_arcs_2/verify/verify_axis.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <random>
#include <vector>

namespace test_drawn_shapes {

using namespace bounding_arcs_test;

// Ways lead through gaps of 1e-12 to 1e-10 of the size, with large discs at their mouths. There two ends are a disc's
// touches, and its center hangs on all bits of how far they are apart; or ends were moved by as much as gaps are wide.
TEST(DrawnShapes, WithWaysThroughGapsAreProven) {
  for (const unsigned seed : {0U, 6U, 45U, 59U, 69U, 87U, 99U, 106U, 164U, 195U}) {
    std::mt19937 random(seed);
    const Axis_case drawn = in_frame(random, loose_lines(random));
    const ba::Medial_axis_2 axis = axis_of_case(drawn, 1e-4 * size_of(drawn.drawing));
    EXPECT_TRUE(ba::axis_certificate(ba::Bounding_arc_tree_2(drawn.drawing), axis).is_proven()) << "seed " << seed;
  }
}

// Two straight sides leave a corner within an angle of 1e-12: discs between them are no larger than that is wide.
TEST(DrawnShapes, WithSliversOfStraightSidesAreProven) {
  for (const unsigned seed : {196U, 774U, 993U}) {
    std::mt19937 random(seed);
    const Axis_case drawn = in_frame(random, loose_lines(random));
    const ba::Medial_axis_2 axis = axis_of_case(drawn, 1e-4 * size_of(drawn.drawing));
    EXPECT_TRUE(ba::axis_certificate(ba::Bounding_arc_tree_2(drawn.drawing), axis).is_proven()) << "seed " << seed;
  }
}

// A disc touches nearly all of an arc, so that where the samples beside it touch is of rounding: their discs have the
// arc in them.
TEST(DrawnShapes, BesideDiscsThatNearlyTouchAWholeArcAreComplete) {
  std::mt19937 random(1706);
  const Axis_case drawn = in_frame(random, loose_lines(random));
  EXPECT_EQ(axis_of_case(drawn, 1e-4 * size_of(drawn.drawing)).status, ba::Medial_axis_2::Status::COMPLETE);
}

// Handles in their nodes: a derivative beside one is rounding alone, and one disc is that of a joint but for rounding.
TEST(DrawnShapes, WithHandlesInTheirNodesAreWholeAndRight) {
  for (const unsigned seed : {611U, 5282U}) {
    std::mt19937 random(seed);
    const Axis_case drawn = filled(random, pen_paths(random));
    EXPECT_NO_THROW(told_of(drawn, [&] { check_case(drawn, random); })) << "seed " << seed;
  }
}

// At (109.938, 362.521) a curve with endless curvature, a corner to the right and another such curve: the discs of the
// corner and of the second curve are the same but for rounding, as far as they go.
TEST(DrawnShapes, WithACornerBetweenTwoTipsAreWholeAndRight) {
  const Point at{98.33334197578404, 362.9941488591844}, tip{109.938, 362.521}, right{196.625, 356.09447639970483},
      top{99.02191623473229, 371.06030446400683};
  Drawing drawing;
  drawing.add({segment(right, top), segment(top, at),
               Bezier({at, {105.35869259935717, 362.521}, {109.93799999999999, 362.521}, tip}),
               Bezier({tip, tip, {149.1041524529537, 359.5996958878715}, right})});
  const Point corners[] = {{33.444, 312.151},
                           {35.321, 258.351},
                           {17.484, 186.619},
                           {182.625, 235.125},
                           {98.625, 244.125},
                           at,
                           {57.85299595679822, 369.777441360719},
                           {47.526, 360.571}};
  std::vector<Bezier> other{Bezier({corners[7], corners[7], {18.424, 339.948}, corners[0]})};
  for (std::size_t i = 0; i < 7; ++i) other.push_back(segment(corners[i], corners[i + 1]));
  drawing.add(other);
  std::mt19937 random(1);
  EXPECT_NO_THROW(check_case({drawing, {ba::Fill_rule::EVEN_ODD}}, random));
}

// Three arcs of a file with six decimals, whose joints turn by some 1e-7: what is rounded off is told.
TEST(DrawnShapes, OfFewDecimalsTellWhatIsRoundedOff) {
  const Point ends[] = {{10, 5}, {5.5, 7.598076}, {5.5, 2.401924}};
  std::vector<Bezier> chain;
  for (int i = 0; i < 3; ++i) chain.push_back(arc_of_radius(ends[i], ends[(i + 1) % 3], 3));
  const ba::Medial_axis_2 axis = axis_of_case({drawing_of(chain), {}}, 1e-2);
  ASSERT_EQ(axis.status, ba::Medial_axis_2::Status::COMPLETE);
  EXPECT_EQ(axis.vertices.size(), axis.edges.size() + 1);
  for (const auto& v : axis.vertices) EXPECT_LE(std::hypot(v.center.x - 7, v.center.y - 5), 0.1);
  EXPECT_GT(axis.moved, 0);
  EXPECT_LE(axis.moved, 0x1p-40 * 10);
}

/// A rounded rectangle of 40 by 20 whose corners turn by another bulge than that of a quarter.
Drawing rounded_with_bulge(double radius, double bulge) {
  const double w = 40, h = 20, r = radius, half = 2 * std::atan(bulge);  // of the angle
  const Point p[] = {{r, 0}, {w - r, 0}, {w, r}, {w, h - r}, {w - r, h}, {r, h}, {0, h - r}, {0, r}};
  std::vector<Bezier> chain;
  for (int i = 0; i < 8; ++i) {
    const Point &from = p[i], &to = p[(i + 1) % 8], chord = to - from, middle = 0.5 * (from + to);
    if (i % 2 == 0) chain.push_back(segment(from, to));
    else
      chain.push_back(
          Bezier({from, middle + 0.5 * std::tan(half) * Point{chord.y, -chord.x}, to}, {1, std::cos(half), 1}));
  }
  return drawing_of(chain);
}
// A bulge of few digits makes an arc end a little before or beyond the line that it turns into, which is no corner of
// the shape: each corner has the leaf of its arc.
TEST(DrawnShapes, WithBulgesOfFewDigitsHaveALeafInEachCorner) {
  for (const double radius : {1.0, 2.0, 3.175, 5.0, 9.9})
    for (const double bulge : {0.414214, 0.4142136, 0.41421356, 0.414213562, 0.4142135624, 0.41421356237}) {
      const Drawing drawing = rounded_with_bulge(radius, bulge);
      const ba::Medial_axis_2 axis = axis_of_case({drawing, {}}, 1e-2);
      EXPECT_EQ(axis.status, ba::Medial_axis_2::Status::COMPLETE) << radius << ' ' << bulge;
      EXPECT_EQ(axis.vertices.size(), 6u) << radius << ' ' << bulge;
      EXPECT_TRUE(ba::verify_axis(drawing, axis).is_right()) << radius << ' ' << bulge;
    }
}

// The way round the hole ends where it begins: the last disc touches both.
TEST(DrawnShapes, OfAWasherWhoseHoleIsOfArcsOfFewDecimalsAreVerified) {
  for (const double scale : {1.0, 20.0, 0.001}) {
    const auto disc = [&](double x, double radius, int arcs) {
      Bulge_polyline line(0, 6);
      for (int k = 0; k < arcs; ++k) {
        const double angle = 6.283185307179586 * k / arcs;
        line.add({scale * (x + radius * std::cos(angle)), scale * radius * std::sin(angle)},
                 std::tan(1.5707963267948966 / arcs));
      }
      return line.beziers();
    };
    Drawing drawing = drawing_of(disc(0, 20, 2));
    drawing.add(disc(3, 10, 4));
    const ba::Medial_axis_2 axis = axis_of_case({drawing, {ba::Fill_rule::EVEN_ODD}}, 1e-3 * scale);
    EXPECT_EQ(axis.status, ba::Medial_axis_2::Status::COMPLETE) << scale;
    EXPECT_TRUE(ba::verify_axis(drawing, axis, {ba::Fill_rule::EVEN_ODD, false, {}}).is_right()) << scale;
  }
}

// Joints that turn by some 1e-7 have two normals beside leaves; four arcs of one radius have a center each; and sides
// of slots are in the discs of both ends by a rounding.
TEST(DrawnShapes, WithDecimalsAreWholeAndRight) {
  for (const unsigned seed : {140457U, 501247U, 700762U, 701001U, 702197U, 702295U, 930029U}) {
    std::mt19937 random(seed);
    const Axis_case drawn = filled(random, with_decimals(random));
    EXPECT_NO_THROW(told_of(drawn, [&] { check_case(drawn, random); })) << "seed " << seed;
  }
}

ba::Medial_axis_2 axis_in_frame(const Drawing& drawing) { return framed_axis_of(ba::framed(drawing, 1.0), 1e-4); }

// The centers are its ends: a disc about either touches all of the circle that bounds the union.
TEST(DrawnShapes, OfTwoCirclesHaveTheSegmentBetweenTheirCenters) {
  Drawing drawing = drawing_of(circle_of(4, {39, 15}, 58, 0));
  drawing.add(circle_of(4, {6, 38}, 31, 0));
  const ba::Medial_axis_2 axis = axis_of_case({drawing, {}}, 1e-3);
  ASSERT_EQ(axis.status, ba::Medial_axis_2::Status::COMPLETE);
  EXPECT_EQ(axis.vertices.size(), 2u);
  EXPECT_EQ(axis.edges.size(), 1u);
  EXPECT_NEAR(vertex_at(axis, {39, 15}, 1e-9).radius, 58, 1e-9);
  EXPECT_NEAR(vertex_at(axis, {6, 38}, 1e-9).radius, 31, 1e-9);
}

// Doubles make them cross, or leave a gap: each has its center alone.
TEST(DrawnShapes, ThatTouchAreApart) {
  for (const Point& way : {Point{0.6, 0.8}, Point{-0.8, 0.6}, Point{5.0 / 13, 12.0 / 13}, Point{1, 0}}) {
    Drawing drawing = drawing_of(circle_of(4, {0, 0}, 3, 0));
    drawing.add(circle_of(4, 7.0 * way, 4, 0));
    Axis_case odd{drawing, {}};
    odd.options.rule = ba::Fill_rule::EVEN_ODD;
    const ba::Medial_axis_2 axis = axis_of_case(odd, 1e-3);
    EXPECT_EQ(axis.status, ba::Medial_axis_2::Status::COMPLETE);
    EXPECT_EQ(axis.regions, 2u);
    EXPECT_EQ(axis.vertices.size(), 2u);
    EXPECT_TRUE(axis.edges.empty());
    EXPECT_LE(axis.moved, 0x1p-40 * 11);
  }
}

// Four lines, each by itself, have the axis of the square that they are.
TEST(DrawnShapes, OfLooseLinesAreClosed) {
  std::mt19937 random(2);
  const Point corners[] = {{0, 0}, {4, 0}, {4, 4}, {0, 4}};
  const ba::Medial_axis_2 expected = axis_in_frame(drawing_of(polygon({corners, corners + 4})));
  for (const double gap : {0.0, 1e-16, 1e-15, 1e-14, 1e-13, 1e-12}) {
    Drawing drawing;
    std::uniform_real_distribution<double> off(-gap, gap);
    const auto near = [&](const Point& p) {
      const double x = p.x + off(random);
      return Point{x, p.y + off(random)};
    };
    for (int i = 0; i < 4; ++i) drawing.add({segment(near(corners[i]), near(corners[(i + 1) % 4]))});
    const ba::Medial_axis_2 axis = axis_in_frame(drawing);
    EXPECT_EQ(axis.status, ba::Medial_axis_2::Status::COMPLETE);
    EXPECT_EQ(axis.regions, 2u);
    EXPECT_EQ(axis.vertices.size(), expected.vertices.size());
    EXPECT_EQ(axis.edges.size(), expected.edges.size());
    EXPECT_LE(axis.moved, 4 * gap + 0x1p-51 * 8);  // and the rounding of crossings
    EXPECT_NEAR(vertex_at(axis, {2, 2}, 1e-11).radius, 2, 1e-11);
  }
}

// It is too short to have two ends, and no other is near.
TEST(DrawnShapes, ThatAreDotsStay) {
  const Drawing dots[] = {drawing_of({segment({0, 0}, {1e-13, 0})}), drawing_of(circle_of(4, {0, 0}, 1e-13, 0))};
  for (const Drawing& dot : dots) {
    Drawing drawing = dot;
    drawing.add({segment({-2, 1}, {2, 1})});
    const ba::Medial_axis_2 axis = axis_in_frame(drawing);
    EXPECT_EQ(axis.status, ba::Medial_axis_2::Status::COMPLETE);
    EXPECT_EQ(axis.holes, 2u);
    for (const auto& v : axis.vertices) EXPECT_LE(v.radius, std::hypot(v.center.x, v.center.y) + 1e-12);
  }
}

// A closed curve that is no longer than coordinates tell has no region in it.
TEST(DrawnShapes, ThatAreLoopsOfAnUlpAreDots) {
  constexpr double ULP = 0x1p-51;
  const Point at{3, 3}, beside{3 + ULP, 3}, above{3, 3 + ULP};
  Drawing drawing = drawing_of({segment(at, beside), segment(beside, above), segment(above, at)});
  drawing.add({segment({0, 1}, {4, 1})});
  const ba::Medial_axis_2 axis = axis_in_frame(drawing);
  EXPECT_EQ(axis.status, ba::Medial_axis_2::Status::COMPLETE);
  EXPECT_EQ(axis.regions, 1u);
  EXPECT_EQ(axis.holes, 2u);
}

// Sides leave both tips of a sliver within angles of 1e-8: the tangents of given ends tell which one is on which side.
TEST(DrawnShapes, OfASliverHaveBothTips) {
  const Point a{0.114074774, 0.009572396}, b{-0.09057868200000001, -0.004889582};
  const Drawing drawing = drawing_of({segment(a, b), Bezier({b, {-0.022360864, -6.8922e-05}, a, a})});
  const ba::Medial_axis_2 axis = axis_of_case({drawing, {}}, 1e-3);
  EXPECT_EQ(axis.status, ba::Medial_axis_2::Status::COMPLETE);
  EXPECT_EQ(axis.vertices.size(), 2u);
  EXPECT_TRUE(ba::verify_axis(drawing, axis).is_right());
}

// Both curves leave the tip alike up to their third derivatives: it has no branch that doubles tell.
Drawing with_a_third_order_tip() {
  return drawing_of({segment({-4, -3}, {-4, 0}), Bezier({{-4, 0}, {-2, 2}, {-2, 3}, {-1, -2}}),
                     Bezier({{-1, -2}, {-2, 3}, {-2, 2}, {-4, -3}})});
}
TEST(DrawnShapes, ThatRoundingLeavesOpenAreMoved) {
  const ba::Medial_axis_2 axis = axis_of_case({with_a_third_order_tip(), {}}, 1e-3);
  EXPECT_EQ(axis.status, ba::Medial_axis_2::Status::COMPLETE);
  EXPECT_EQ(axis.vertices.size(), 4u);
  EXPECT_EQ(axis.edges.size(), 3u);
  EXPECT_GT(axis.moved, 0);
  EXPECT_LE(axis.moved, 0x1p-40 * 4);
}

// The axis ends where both sides are one, before the tip: what it leaves out is nothing, but no more than that.
TEST(DrawnShapes, WithATipOfThirdOrderAreVerified) {
  const Drawing drawing = with_a_third_order_tip();
  ba::Medial_axis_2 axis = axis_of_case({drawing, {}}, 1e-3);
  const ba::Axis_verification found = ba::verify_axis(drawing, axis);
  EXPECT_TRUE(found.is_right()) << found.findings.front().place;
  const auto at_tip = std::find_if(axis.edges.begin(), axis.edges.end(), [&](const ba::Medial_axis_2::Edge& e) {
    return distance_between(axis.vertices[e.to].center, {-1, -2}) < 1e-4;
  });
  ASSERT_NE(at_tip, axis.edges.end());
  at_tip->samples.pop_back();
  const ba::Medial_axis_2::Sample& last = at_tip->samples.back();
  axis.vertices[at_tip->to] = {last.center, last.radius, {last.left, last.right}, {last.radius, last.radius}};
  const ba::Axis_verification broken = ba::verify_axis(drawing, axis);
  ASSERT_FALSE(broken.is_right());
  EXPECT_EQ(broken.findings.front().fault, ba::Axis_verification::Fault::TILING);
}

// Two arcs are left of the circle: its disc touches both, and is one vertex.
TEST(DrawnShapes, HaveOneDiscForAllPartsOfACircle) {
  Drawing drawing = drawing_of(circle_of(4, {0, 0}, 3, 0));
  for (const double x : {-3.0, 3.0}) drawing.add(turned(rectangle(1, 1), {1, 0}, {x, 0}));
  const ba::Medial_axis_2 axis = axis_of_case({drawing, {}}, 1e-3);
  ASSERT_EQ(axis.status, ba::Medial_axis_2::Status::COMPLETE);
  const auto is_central = [](const ba::Medial_axis_2::Vertex& v) { return std::hypot(v.center.x, v.center.y) < 1e-9; };
  EXPECT_EQ(std::count_if(axis.vertices.begin(), axis.vertices.end(), is_central), 1);
}

}  // namespace test_drawn_shapes
