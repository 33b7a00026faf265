// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Axes of drawings as people make them: complete, and right within what is told of them.

#include "../../src/library/medial_axis/Bounding_parts.h"
#include "axis_checks.h"
#include "counted_faults.h"
#include "drawn_shapes.h"
#include "faults.h"

#include <CGAL/Bounding_arcs_2/boolean/boolean_operations.h>
#include <CGAL/Bounding_arcs_2/medial_axis/axis_certificate.h>
#include <CGAL/Bounding_arcs_2/medial_axis/medial_axis.h>
#include <CGAL/Bounding_arcs_2/query/closest_point.h>
#include <CGAL/Bounding_arcs_2/query/point_location.h>
#include <CGAL/Bounding_arcs_2/verify/verify_axis.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdlib>
#include <exception>
#include <iostream>
#include <iterator>
#include <memory>
#include <random>
#include <stdexcept>
#include <string>
#include <vector>

namespace test_drawn_axes {

using namespace bounding_arcs_test;

// What bounds the regions, found in another way: the outline, or all that is drawn in a frame.
class Bounds {
 public:
  // \param are_slits_walls whether slits are there that are narrower than curves may be moved by
  Bounds(const Axis_case& of, bool are_slits_walls)
      : size_(size_of(of.drawing)), frame_(of.drawing), rule_(of.options.rule) {
    if (of.options.is_framed) {
      rule_ = ba::Fill_rule::NONZERO;
      frame_ = drawing_of(of.drawing.curves().back().beziers);
    }
    inside_ = std::make_unique<ba::Bounding_arc_tree_2>(frame_);
    if (of.options.is_framed) walls_ = of.drawing;
    else add_outline(of, are_slits_walls);
    tree_ = std::make_unique<ba::Bounding_arc_tree_2>(walls_);
  }
  [[nodiscard]] double size() const { return size_; }
  [[nodiscard]] bool has_slits() const { return has_slits_; }
  [[nodiscard]] bool empty() const { return walls_.curves().empty(); }
  [[nodiscard]] auto closest(const Point& p) const { return ba::closest_point(*tree_, p); }
  [[nodiscard]] bool is_inside(const Point& p) const { return ba::locate(*inside_, p, rule_) == CGAL::ON_BOUNDED_SIDE; }

 private:
  void add_outline(const Axis_case& of, bool are_slits_walls) {
    const ba::Bounding_arc_tree_2 tree(of.drawing);
    for (const auto& curve : ba::drawn_outline({&tree}, ba::outline(tree, of.options.rule), {false}).drawing.curves()) {
      if (is_speck(curve.beziers)) continue;
      for (const Bezier& piece : curve.beziers) {
        if (!is_slit(piece) || are_slits_walls) walls_.add({piece});
        else has_slits_ = true;
      }
    }
  }
  // Whether a loop is no larger than what curves may be moved by.
  [[nodiscard]] bool is_speck(const std::vector<Bezier>& loop) const {
    const Point at = loop.front().control_points().front();
    const auto is_there = [&](const Point& p) { return std::hypot(p.x - at.x, p.y - at.y) <= 0x1p-40 * size_; };
    return std::all_of(loop.begin(), loop.end(), [&](const Bezier& piece) {
      return std::all_of(piece.control_points().begin(), piece.control_points().end(), is_there);
    });
  }
  // Whether all is inside beside the middle of a piece.
  [[nodiscard]] bool is_slit(const Bezier& piece) const {
    const Point q = piece.point(0.5), way = piece.point(0.75) - piece.point(0.25);
    const double length = std::hypot(way.x, way.y), beside = 4 * 0x1p-40 * size_ / length;
    if (!(length > 0x1p-40 * size_)) return false;
    return is_inside(q + beside * Point{-way.y, way.x}) && is_inside(q + beside * Point{way.y, -way.x});
  }

  double size_;
  bool has_slits_ = false;
  Drawing walls_, frame_;
  ba::Fill_rule rule_;
  std::unique_ptr<ba::Bounding_arc_tree_2> tree_, inside_;
};

double distance_between(const Point& a, const Point& b) { return std::hypot(a.x - b.x, a.y - b.y); }
double distance_to_line(const Point& q, const Point& a, const Point& b) {
  const Point way = b - a;
  const double square = way.x * way.x + way.y * way.y,
               t = square > 0 ? ((q.x - a.x) * way.x + (q.y - a.y) * way.y) / square : 0;
  return distance_between(q, a + std::clamp(t, 0.0, 1.0) * way);
}

void require_disc(const Bounds& bounds, const Point& center, double radius, double room, const char* what) {
  const auto d = bounds.closest(center)->distance;
  if (d.upper < radius - room || d.lower > radius + room)
    throw Fault(what, "radius " + std::to_string(radius) + " for a distance that is off by " +
                          std::to_string((d.upper - radius) / bounds.size() * 1e12) + "e-12 of the size");
}
// Discs touch, and hold nothing; between samples they do so within eps.
void require_discs(const Bounds& bounds, const ba::Medial_axis_2& axis) {
  const double room = 0x1p-40 * bounds.size();
  if (!(axis.moved <= room)) throw Fault("moved", "it is too much");
  for (const auto& v : axis.vertices) require_disc(bounds, v.center, v.radius, axis.moved + room, "vertex");
  for (const auto& e : axis.edges)
    for (std::size_t i = 0; i < e.samples.size(); ++i) {
      const auto& s = e.samples[i];
      require_disc(bounds, s.center, s.radius, axis.moved + room, "sample");
      if (i > 0)
        require_disc(bounds, 0.5 * (e.samples[i - 1].center + s.center), 0.5 * (e.samples[i - 1].radius + s.radius),
                     axis.eps + room, "between samples");
    }
}
// No branch is missing: discs that grow from random points, where these are nearest, end on the axis.
void require_whole(const Bounds& bounds, const ba::Medial_axis_2& axis, std::mt19937& random, int count) {
  const double size = bounds.size();
  std::uniform_real_distribution<double> coordinate(-size, size);
  for (int i = 0; i < count; ++i) {
    const Point q{coordinate(random), coordinate(random)};
    const auto nearest = bounds.closest(q);
    const double d = nearest->distance.lower;
    if (!(d > 1e-3 * size) || !bounds.is_inside(q)) continue;
    const Point p = nearest->point, way = q - p, normal = (1 / std::hypot(way.x, way.y)) * way;
    double low = d, high = 8 * size;
    for (int k = 0; k < 60; ++k) {
      const double r = (low + high) / 2;
      (bounds.closest(p + r * normal)->distance.upper < r - 1e-9 * size ? high : low) = r;
    }
    const Point center = p + low * normal;
    double least = HUGE_VAL;
    for (const auto& v : axis.vertices) least = (std::min)(least, distance_between(center, v.center));
    for (const auto& e : axis.edges)
      for (std::size_t k = 1; k < e.samples.size(); ++k)
        least = (std::min)(least, distance_to_line(center, e.samples[k - 1].center, e.samples[k].center));
    // where discs grow along a curve that hardly bends away, 1e-9 of the distance is much of the radius
    if (!(least <= 2e-3 * size))
      throw Fault("missing branch", "at " + std::to_string(center.x) + " " + std::to_string(center.y));
  }
}

ba::Medial_axis_2 axis_of_case(const Axis_case& of, double eps) {
  return ba::medial_axis(ba::Bounding_arc_tree_2(of.drawing), eps, of.options);
}
template <class Check> void told_of(const Axis_case& of, const Check& check) {
  try {
    check();
  } catch (const std::exception& e) {
    std::string text = e.what();
    if (text.find(": ") == std::string::npos) text = "exception: " + text;
    const char* how =
        of.options.is_framed ? "frame" : (of.options.rule == ba::Fill_rule::NONZERO ? "nonzero" : "evenodd");
    throw std::runtime_error(text + '\n' + how + '\n' + json_text(of.drawing));
  }
}

class DrawnAxes : public testing::TestWithParam<Drawn_kind> {};

// The curves that an axis is of: those that were given, or these moved by no more than it tells.
Axis_case moved_case(const Axis_case& drawn, const ba::Medial_axis_2& axis) {
  Axis_case moved{axis.bounds->segments.drawing(), drawn.options};
  for (std::size_t c = 0; c < drawn.drawing.curves().size(); ++c)
    for (std::size_t b = 0; b < drawn.drawing.curves()[c].beziers.size(); ++b) {
      const Bezier &given = drawn.drawing.curves()[c].beziers[b], &now = moved.drawing.curves()[c].beziers[b];
      if (given.weights() != now.weights()) throw Fault("moved", "weights are others");
      for (std::size_t i = 0; i < given.control_points().size(); ++i)
        if (distance_between(given.control_points()[i], now.control_points()[i]) > axis.moved)
          throw Fault("moved", "it is less than what curves were");
    }
  return moved;
}

void check_case(const Axis_case& drawn, std::mt19937& random) {
  const ba::Medial_axis_2 axis = axis_of_case(drawn, 1e-4 * size_of(drawn.drawing));
  if (axis.status != ba::Medial_axis_2::Status::COMPLETE)
    throw Fault("unresolved", axis.unresolved.empty() ? "anywhere"
                                                      : std::to_string(axis.unresolved.front().x) + " " +
                                                            std::to_string(axis.unresolved.front().y));
  if (!axis.is_valid()) throw Fault("invalid", std::to_string(axis.vertices.size()));
  const auto require_axis_of = [&](const Bounds& bounds) {
    if (bounds.empty()) return;
    require_discs(bounds, axis);
    require_whole(bounds, axis, random, 8);
  };
  const Axis_case moved = moved_case(drawn, axis);
  const Bounds bounds(moved, false);
  try {
    require_axis_of(bounds);
  } catch (const Fault&) {
    if (!bounds.has_slits()) throw;
    require_axis_of(Bounds(moved, true));  // less than curves may be moved by: there or not, both are right
  }
}

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

// Joints that turn by some 1e-7 have two normals beside leaves, and four arcs of one radius have a center each.
TEST(DrawnShapes, WithDecimalsAreWholeAndRight) {
  for (const unsigned seed : {700762U, 701001U, 702197U, 702295U}) {
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

INSTANTIATE_TEST_SUITE_P(Kinds, DrawnAxes, testing::ValuesIn(DRAWN_KINDS),
                         [](const auto& kind) { return kind.param.name; });
INSTANTIATE_TEST_SUITE_P(Kinds, PromisedAxes, testing::ValuesIn(kinds_with_a_promise()),
                         [](const auto& kind) { return kind.param.name; });

}  // namespace test_drawn_axes
