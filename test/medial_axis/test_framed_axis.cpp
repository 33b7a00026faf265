// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Voronoi diagrams of curves within a frame: what geometry says of points and segments, and random drawings of open and
// closed curves against distances. Axes of the outlines of curves that cross.

#include "axis_checks.h"
#include "cases.h"
#include "closed_drawings.h"
#include "near_equal_discs.h"

#include <CGAL/Bounding_arcs_2/medial_axis/medial_axis.h>
#include <CGAL/Bounding_arcs_2/query/intersections.h>
#include <CGAL/Bounding_arcs_2/region/Bca_traits_2.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <random>
#include <stdexcept>
#include <vector>

namespace test_framed_axis {
namespace {

using namespace bounding_arcs_test;

bool crosses(const Drawing& drawing) {
  const auto common = ba::self_intersections(ba::Bounding_arc_tree_2(drawing));
  return !common.points.empty() || !common.overlaps.empty();
}
// Adds what crosses nothing.
void add(Drawing& drawing, const std::vector<Bezier>& chain) {
  Drawing more = drawing;
  more.add(chain);
  if (!crosses(more)) drawing = std::move(more);
}
// Winds round several times, so that both sides of it face each other.
std::vector<Bezier> coil(std::mt19937& random) {
  std::uniform_real_distribution<double> unit(0, 1);
  std::vector<Bezier> chain;
  const auto at = [](double a, double r) { return Point{r * std::cos(a), r * std::sin(a)}; };
  const auto along = [](double a) { return Point{-std::sin(a), std::cos(a)}; };
  double angle = 0, radius = 0.1;
  for (std::size_t k = 0, n = 4 + random() % 12; k < n; ++k) {
    const double next = angle + 0.9, far = radius + 0.03 + 0.06 * unit(random);
    const Point p = at(angle, radius), q = at(next, far);
    chain.push_back(Bezier({p, p + 0.3 * radius * along(angle), q - 0.3 * far * along(next), q}));
    angle = next, radius = far;
  }
  return chain;
}

TEST(FramedAxis, OfTwoPointsIsTheirBisector) {
  Drawing drawing = drawing_of(Bezier({{-1, 0}, {-1, 0}}));
  drawing.add(Bezier({{1, 0}, {1, 0}}));
  drawing = ba::framed(drawing, CGAL::Bbox_2(-4, -3, 4, 3));
  const Medial_axis_2 axis = framed_axis_of(drawing);
  expect_sound(drawing, axis, 1e-6);
  EXPECT_EQ(axis.holes, 2U);
  // as far from both points as from the frame
  const double y = 4.0 / 3;
  EXPECT_NEAR(vertex_at(axis, {0, y}, 1e-12).radius, 3 - y, 1e-12);
  std::size_t count = 0;
  for (const auto& e : axis.edges) {
    if (e.touches(2)) continue;
    ++count;
    for (const auto& s : e.samples) EXPECT_NEAR(s.center.x, 0, 1e-12);
  }
  EXPECT_EQ(count, 1U);
}

TEST(FramedAxis, OfASegmentHasParabolasRoundItsEnds) {
  const Drawing drawing = ba::framed(drawing_of(segment({-1, 0}, {1, 0})), CGAL::Bbox_2(-3, -2, 3, 2));
  const Medial_axis_2 axis = framed_axis_of(drawing);
  expect_sound(drawing, axis, 1e-6);
  EXPECT_EQ(axis.regions, 1U);
  EXPECT_EQ(axis.holes, 1U);
  EXPECT_EQ(leaves_of(axis), 4U);  // of the frame
  for (const auto& e : axis.edges)
    for (const auto& s : e.samples) {
      if (s.left.curve == s.right.curve) continue;
      const double beside = std::fmax(std::fabs(s.center.x) - 1, 0), up = std::fabs(s.center.y);
      EXPECT_NEAR(std::hypot(beside, up), std::fmin(2 - up, 3 - std::fabs(s.center.x)), 1e-12);
    }
}

TEST(FramedAxis, HasBothSidesOfClosedCurves) {
  // within, between and around two circles of one direction
  Drawing drawing = drawing_of(circle({0, 0}, 2));
  drawing.add(circle({0.25, 0}, 1));
  drawing = ba::framed(drawing, 1.0);
  const Medial_axis_2 axis = framed_axis_of(drawing);
  expect_sound(drawing, axis, 1e-6);
  EXPECT_EQ(axis.regions, 3U);
  EXPECT_EQ(axis.holes, 2U);
  EXPECT_NEAR(vertex_at(axis, {0.25, 0}, 1e-12).radius, 1, 1e-12);
}

TEST(FramedAxis, OfRandomCurvesHasAllOfIt) {
  std::mt19937 random(7);
  std::uniform_real_distribution<double> unit(-1, 1);
  int complete = 0;
  const int count = cases(60);
  for (int i = 0; i < count && !HasFailure(); ++i) {
    SCOPED_TRACE(i);
    Drawing drawing;
    for (std::size_t k = 0, n = 1 + random() % 5; k < n; ++k) {
      const Point at{unit(random), unit(random)};
      const double scale = 0.1 + 0.4 * std::fabs(unit(random));
      const Drawing some = moved(random() % 3 == 0 ? drawing_of(coil(random)) : random_drawing(random), scale, at);
      for (const auto& curve : some.curves()) {
        if (i % 2 == 0) add(drawing, curve.beziers);
        else drawing.add(curve.beziers);  // it may cross
      }
    }
    if (drawing.curves().empty()) continue;
    const Drawing all = ba::framed(drawing, 0.25);
    const Medial_axis_2 axis = framed_axis_of(all, 1e-4);
    if (axis.status == Status::UNRESOLVED) continue;  // near-cusps that turn within rounding are among them
    ++complete;
    expect_sound(all, axis, 1e-4, i % 2 == 0 ? 2e-13 : 1e-12);
    expect_whole(all, axis, random, 8);
  }
  EXPECT_GE(complete, count * 9 / 10);
}

TEST(FramedAxis, IsWholeForPolylinesOnALattice) {
  std::mt19937 random(11);
  const auto point = [&] {
    const int x = static_cast<int>(random() % 9), y = static_cast<int>(random() % 9);
    return Point{x - 4.0, y - 4.0};
  };
  for (int i = 0; i < cases(150) && !HasFailure(); ++i) {
    SCOPED_TRACE(i);
    Drawing drawing;
    for (std::size_t k = 0, n = 1 + random() % 4; k < n; ++k) {
      std::vector<Bezier> chain;
      const Point start = point();
      Point last = start;
      for (std::size_t j = 0, pieces = 1 + random() % 4; j < pieces; ++j) {
        const bool is_closing = j > 1 && j + 1 == pieces && random() % 2 == 0;
        const Point next = is_closing ? start : point();
        chain.push_back(segment(last, next));
        last = next;
      }
      add(drawing, chain);
    }
    if (drawing.curves().empty()) continue;
    const Drawing all = ba::framed(drawing, 0.5);
    const Medial_axis_2 axis = framed_axis_of(all);
    expect_sound(all, axis, 1e-6);
    expect_whole(all, axis, random, 8);
  }
}

// A point on a curve is no wall of its own, wherever on it that is.
TEST(FramedAxis, IsTheSameWithPointsOnCurves) {
  const auto with = [](const std::vector<Point>& points) {
    Drawing drawing;
    for (const Point& p : points) drawing.add(segment(p, p));
    drawing.add({segment({-2, 0}, {0, 0}), segment({0, 0}, {1, 1})});
    drawing.add(Bezier({{1, -1}, {2, 1}, {1, 1}}));
    drawing.add(segment({-1, -1}, {-1, 1}));
    return ba::framed(drawing, 1.0);
  };
  const Medial_axis_2 alone = framed_axis_of(with({}));
  ASSERT_EQ(alone.status, Status::COMPLETE);
  const std::vector<Point> on_curves{{-2, 0}, {1, -1}, {0, 0}, {1, 1}, {-1, 0}, {-0.5, 0}, {-1, 0.5}, {1.5, 0.5}};
  std::vector<std::vector<Point>> some{on_curves, {{0, 0}, {0, 0}}};
  for (const Point& p : on_curves) some.push_back({p});
  for (const auto& points : some) {
    SCOPED_TRACE(std::to_string(points.front().x) + " " + std::to_string(points.front().y));
    const Medial_axis_2 axis = framed_axis_of(with(points));
    ASSERT_EQ(axis.status, Status::COMPLETE);
    EXPECT_EQ(axis.vertices.size(), alone.vertices.size());
    EXPECT_EQ(axis.edges.size(), alone.edges.size());
    for (const auto& v : alone.vertices) EXPECT_NEAR(vertex_at(axis, v.center, 1e-9).radius, v.radius, 1e-9);
  }
}

TEST(FramedAxis, RefusesWhatIsNoFrame) {
  Drawing drawing = drawing_of(circle({0, 0}, 1));
  drawing.add(circle({5, 0}, 1));
  EXPECT_THROW((void)framed_axis_of(drawing), std::invalid_argument);
  Drawing open = drawing_of(circle({0, 0}, 1));
  open.add(segment({3, 0}, {4, 0}));
  EXPECT_THROW((void)framed_axis_of(open), std::invalid_argument);
  EXPECT_THROW((void)ba::framed(Drawing(), 1.0), std::invalid_argument);
  EXPECT_THROW((void)ba::framed(open, 0.0), std::invalid_argument);
}

TEST(CrossingCurves, HaveTheAxisOfWhatTheyFill) {
  // two squares that overlap
  Drawing drawing = drawing_of(polygon({{0, 0}, {2, 0}, {2, 2}, {0, 2}}));
  drawing.add(polygon({{1, 1}, {3, 1}, {3, 3}, {1, 3}}));
  ba::Medial_axis_2::Options options;
  constexpr double EPS = 1e-6;
  const Medial_axis_2 both = ba::medial_axis(ba::Bounding_arc_tree_2(drawing), EPS, options);
  expect_sound(drawing, walls_of(drawing, options.rule), both, EPS, 2e-13);
  EXPECT_EQ(both.regions, 1U);
  EXPECT_EQ(leaves_of(both), 6U);
  EXPECT_NEAR(vertex_at(both, {1, 1}, 1e-6).radius, 1, 1e-6);
  options.rule = ba::Fill_rule::EVEN_ODD;
  EXPECT_EQ(ba::medial_axis(ba::Bounding_arc_tree_2(drawing), EPS, options).regions, 2U);  // they touch at corners
}

TEST(CrossingCurves, HaveAWholeAxisOnALattice) {
  std::mt19937 random(3);
  for (int i = 0; i < cases(60) && !HasFailure(); ++i) {
    SCOPED_TRACE(i);
    const Drawing drawing = random_lattice_drawing(random, 4);
    ba::Medial_axis_2::Options options;
    options.rule = i % 2 == 0 ? ba::Fill_rule::NONZERO : ba::Fill_rule::EVEN_ODD;
    const Medial_axis_2 axis = ba::medial_axis(ba::Bounding_arc_tree_2(drawing), 1e-3, options);
    const Drawing walls = walls_of(drawing, options.rule);
    EXPECT_LE(axis.moved, 0x1p-40 * size_of(drawing));
    if (walls.curves().empty()) continue;
    expect_sound(drawing, walls, axis, 1e-3, 1e-12);
    const ba::Bounding_arc_tree_2 index(drawing);
    expect_whole(walls, axis, random, 8,
                 [&](const Point& q) { return ba::locate(index, q, options.rule) == CGAL::ON_BOUNDED_SIDE; });
  }
}

// Discs that touch the curve and its end run into the osculating disc there, whose radius is 1/18.
TEST(FramedAxis, ReachesTheEndThatACurveIsSharpestAt) {
  Drawing drawing;
  drawing.add(Bezier({{-4, -1}, {0, -2}, {3, -1}, {3, 0}}, {2, 3, 1, 3}));
  drawing.add(polygon({{-9, -9}, {13, -9}, {13, 13}, {-9, 13}}));
  const Medial_axis_2 axis = framed_axis_of(drawing, 1e-3);
  expect_sound(drawing, axis, 1e-3);
  EXPECT_NEAR(vertex_at(axis, {3 - 1.0 / 18, 0}, 1e-9).radius, 1.0 / 18, 1e-9);
}

// Both sides of a tip that has one tangent are within rounding of discs outside of it; where two curves cross, and a
// ring comes to the point again, three of its arcs are in one disc without a radius. No branch is at either.
TEST(FramedAxis, HasNoBranchOutsideOfATipNorAtACrossing) {
  const std::vector<Bezier> wide_frame = polygon({{-9, -9}, {13, -9}, {13, 13}, {-9, 13}});
  Drawing tip;
  tip.add({Bezier({{1, -3}, {-4, -1}}), Bezier({{-4, -1}, {0, 3}}, {3, 1})});
  tip.add({Bezier({{-2, -4}, {4, 0}, {-4, 4}}, {1, 2, 3}), Bezier({{-4, 4}, {-2, 3}})});
  tip.add(wide_frame);
  expect_sound(tip, framed_axis_of(tip, 1e-3), 1e-3);
  Drawing crossing;
  crossing.add({Bezier({{1, -1}, {1, 3}, {2, 4}}, {3, 3, 1}), Bezier({{2, 4}, {0, -1}, {-2, 3}}, {1, 2, 3})});
  crossing.add({Bezier({{-4, 0}, {2, -3}}), Bezier({{2, -3}, {-2, 3}, {-1, 0}}), Bezier({{-1, 0}, {3, 3}, {-4, 0}})});
  crossing.add(wide_frame);
  expect_sound(crossing, framed_axis_of(crossing, 1e-3), 1e-3);
}

bool is_in_wide_frame(const Point& q) { return std::max(std::fabs(q.x - 2), std::fabs(q.y - 2)) < 11; }

TEST(FramedAxis, TakesOpenCurvesThatCross) {
  Drawing cross = drawing_of(segment({-1, 0}, {1, 0}));
  cross.add(segment({0, -1}, {0, 1}));
  const Drawing drawing = ba::framed(cross, 1.0);
  const Medial_axis_2 axis = framed_axis_of(drawing);
  expect_sound(drawing, axis, 1e-6);
  EXPECT_EQ(axis.regions, 1U);
  EXPECT_EQ(axis.holes, 1U);
  EXPECT_EQ(vertex_at(axis, {0, 0}, 1e-12).radius, 0);
  // a branch in each of the four corners, as in a square
  EXPECT_EQ(std::count_if(axis.vertices.begin(), axis.vertices.end(), [](const auto& v) { return v.radius == 0; }), 8);
  std::mt19937 random(1);
  expect_whole(drawing, axis, random, 50, [](const Point& q) { return std::max(std::fabs(q.x), std::fabs(q.y)) < 2; });
}

// What ends on a curve, runs along another, goes round in a loop, and comes back to where it began as a lollipop does.
TEST(FramedAxis, TakesCurvesThatMeetInAnyWay) {
  Drawing drawing = drawing_of(segment({0, 0}, {4, 0}));
  drawing.add(segment({2, 0}, {2, 1}));
  drawing.add(segment({3, 0}, {6, 0}));
  drawing.add({Bezier({{0, 2}, {5, 5}, {-1, 5}, {4, 2}})});
  drawing.add({Bezier({{6, 2}, {6, 3}}), Bezier({{6, 3}, {5, 4}}), Bezier({{5, 4}, {6, 5}}), Bezier({{6, 5}, {6, 3}})});
  drawing.add({Bezier({{1, 1}, {1, 1}}), Bezier({{1, 1}, {1, 1}, {1, 1}})});  // a point
  drawing.add({Bezier({{-1, 1}, {-1, 2}}), Bezier({{-1, 2}, {-1, 2}}), Bezier({{-1, 2}, {-2, 3}})});
  drawing = ba::framed(drawing, 1.0);
  const Medial_axis_2 axis = framed_axis_of(drawing, 1e-4);
  expect_sound(drawing, axis, 1e-4);
  EXPECT_EQ(axis.regions, 3U);
  EXPECT_EQ(axis.holes, 5U);
  for (const auto& v : axis.vertices)
    for (const auto& p : v.touches) EXPECT_FALSE(p.curve == 6 && p.bezier == 1);  // a piece that is a point
  std::mt19937 random(1);
  expect_whole(drawing, axis, random, 100, [](const Point& q) { return -3 < q.x && q.x < 7 && -1 < q.y && q.y < 6; });
}

TEST(FramedAxis, HasAllPartsThatCurvesCutAFrameInto) {
  Drawing drawing = drawing_of(polygon({{0, 0}, {2, 0}, {2, 2}, {0, 2}}));
  drawing.add(polygon({{1, 1}, {3, 1}, {3, 3}, {1, 3}}));
  drawing.add(polygon({{-2, -2}, {-2, 5}, {5, 5}, {5, -2}}));  // clockwise
  const Medial_axis_2 axis = framed_axis_of(drawing);
  expect_sound(drawing, axis, 1e-6);
  EXPECT_EQ(axis.regions, 4U);  // what both have, two that touch at two corners, what is around
  EXPECT_EQ(axis.holes, 1U);
  EXPECT_NEAR(vertex_at(axis, {1.5, 1.5}, 1e-9).radius, 0.5, 1e-9);
  // through the frame, too: what is out of it has no axis
  Drawing through = drawing_of(segment({0, 0}, {9, 0}));
  through.add(polygon({{-2, -2}, {5, -2}, {5, 5}, {-2, 5}}));
  const Medial_axis_2 inner = framed_axis_of(through);
  expect_sound(through, inner, 1e-6);
  EXPECT_EQ(inner.regions, 1U);
  EXPECT_EQ(inner.holes, 0U);
  for (const auto& v : inner.vertices) EXPECT_LE(v.center.x, 5);
}

// The frame with a bow in it has a ring of which two corners meet.
TEST(FramedAxis, GoesRoundWhatTouchesAtAVertex) {
  Drawing drawing = drawing_of(polygon({{0, 0}, {2, 2}, {2, 0}, {0, 2}}));
  drawing.add(polygon({{-2, -2}, {4, -2}, {4, 4}, {-2, 4}}));
  const Medial_axis_2 axis = framed_axis_of(drawing);
  expect_sound(drawing, axis, 1e-6);
  EXPECT_EQ(axis.regions, 3U);
  EXPECT_EQ(axis.holes, 1U);
  std::mt19937 random(1);
  expect_whole(drawing, axis, random, 50,
               [](const Point& q) { return std::max(std::fabs(q.x - 1), std::fabs(q.y - 1)) < 3; });
}

// The axis of a circle that a stroke ends in leads from one side of their crossing round the end to the other side.
TEST(FramedAxis, LeadsFromACrossingBackToIt) {
  Drawing drawing = drawing_of(circle({0, 0}, 1));
  drawing.add(segment({-2, -1.5}, {0.125, 0.125}));
  drawing = ba::framed(drawing, 1.0);
  const Medial_axis_2 axis = framed_axis_of(drawing, 1e-4);
  expect_sound(drawing, axis, 1e-4);
  EXPECT_EQ(axis.regions, 2U);
  std::mt19937 random(1);
  expect_whole(drawing, axis, random, 50, [](const Point& q) { return std::hypot(q.x, q.y) < 1; });
}

// The second cubic has a cusp at t = 1/2, next to which it meets itself.
TEST(FramedAxis, HasBranchesThatEndBesideACusp) {
  Drawing drawing;
  drawing.add({Bezier({{4, 0}, {3, 4}, {2, -4}, {4, -2}}), Bezier({{4, -2}, {0, 2}, {0, 0}, {4, 0}})});
  drawing.add(polygon({{-9, -9}, {13, -9}, {13, 13}, {-9, 13}}));
  expect_sound(drawing, framed_axis_of(drawing, 1e-3), 1e-3);
}

// It crosses itself some ulp before it ends where it starts.
TEST(FramedAxis, HasNothingInLoopsOfSomeUlp) {
  const double x = 2.576 + 1.027, y = 9.735 - 1.643;
  Drawing drawing =
      drawing_of({Bezier({{3.603, 8.092}, {2, 9}, {3, 12}, {4.937, 10.5}}), Bezier({{4.937, 10.5}, {2.576, 9.735}}),
                  Bezier({{2.576, 9.735}, {x, y}}), Bezier({{x, y}, {3.603, 8.092}})});
  drawing = ba::framed(drawing, 1.0);
  const Medial_axis_2 axis = framed_axis_of(drawing, 1e-4);
  expect_sound(drawing, axis, 1e-4);
  std::mt19937 random(1);
  expect_whole(drawing, axis, random, 50);
}

// Two curves cross some 1e-12 beside their joint, where one begins with a handle of 1e-6.
TEST(FramedAxis, IsWholeWhereCurvesCrossBesideTheirJoint) {
  const Point tip{12.63360246875, 20.82646825}, start{10.2073606875, 21.28370146875};
  Drawing drawing = drawing_of({Bezier({start, {10.294007834317002, 21.2662350824}, tip, tip}),
                                Bezier({tip,
                                        {12.633601686087, 20.826469427897},
                                        {11.6320800656, 18.957557426451},
                                        {11.29270259375, 17.6538849375}}),
                                Bezier({{11.29270259375, 17.6538849375}, start})});
  drawing = ba::framed(drawing, 1.0);
  const Medial_axis_2 axis = framed_axis_of(drawing, 1e-3);
  expect_sound(drawing, axis, 1e-3, 1e-12);
  std::mt19937 random(1);
  expect_whole(drawing, axis, random, 50);
}

TEST(FramedAxis, IsWholeForRandomLatticeCurvesThatCross) {
  std::mt19937 random(4);
  for (int i = 0; i < cases(60) && !HasFailure(); ++i) {
    SCOPED_TRACE(i);
    const Drawing closed = random_lattice_drawing(random, 4);
    Drawing drawing;
    for (const auto& curve : closed.curves()) {
      std::vector<Bezier> chain = curve.beziers;
      if (i % 3 > 0 && random() % 2 == 0) chain.resize((chain.size() + 1) / 2, chain.front());  // open
      drawing.add(std::move(chain));
    }
    drawing.add(polygon({{-9, -9}, {13, -9}, {13, 13}, {-9, 13}}));
    const Medial_axis_2 axis = framed_axis_of(drawing, 1e-3);
    expect_sound(drawing, axis, 1e-3, 1e-12);
    expect_whole(drawing, axis, random, 8, is_in_wide_frame);
  }
}

#ifdef CGAL_LINKED_WITH_TBB
// Places, discs and brackets, bit for bit.
std::vector<double> numbers_of(const Medial_axis_2& axis) {
  std::vector<double> all{axis.eps, axis.error};
  const auto add = [&](const auto&... numbers) { (all.push_back(static_cast<double>(numbers)), ...); };
  const auto add_place = [&](const ba::Curve_place& p) { add(p.curve, p.bezier, p.t); };
  for (const auto& v : axis.vertices) {
    add(v.center.x, v.center.y, v.radius, v.clearance.lower, v.clearance.upper);
    for (const ba::Curve_place& p : v.touches) add_place(p);
  }
  for (const auto& e : axis.edges) {
    add(e.from, e.to);
    for (const auto& s : e.samples) add(s.center.x, s.center.y, s.radius), add_place(s.left), add_place(s.right);
  }
  return all;
}
TEST(FramedAxis, IsTheSameInAllThreads) {
  std::mt19937 random(6);
  const ba::Bounding_arc_tree_2 tree(ba::framed(spline_field(random, 12, 12), 1));
  ba::Medial_axis_2::Options options;
  options.is_framed = true;
  const Medial_axis_2 axis = ba::medial_axis(tree, 1e-3, options),
                      parallel = ba::medial_axis<CGAL::Parallel_tag>(tree, 1e-3, options);
  EXPECT_EQ(axis.status, ba::Medial_axis_2::Status::COMPLETE);
  EXPECT_EQ(parallel.status, axis.status);
  EXPECT_GT(axis.edges.size(), 900U);
  EXPECT_EQ(numbers_of(parallel), numbers_of(axis));
}
TEST(CrossingCurves, HaveTheSameAxisInAllThreads) {
  std::mt19937 random(9);
  std::uniform_real_distribution<double> place(-3, 3);
  Drawing drawing;
  for (int i = 0; i < 60; ++i) drawing.add(closed_curve(random, {place(random), place(random)}, 5));
  const ba::Bounding_arc_tree_2 tree(drawing);
  const Medial_axis_2 axis = ba::medial_axis(tree, 1e-3), parallel = ba::medial_axis<CGAL::Parallel_tag>(tree, 1e-3);
  EXPECT_EQ(axis.status, ba::Medial_axis_2::Status::COMPLETE);
  EXPECT_GT(axis.edges.size(), 100U);
  EXPECT_EQ(numbers_of(parallel), numbers_of(axis));
}
#endif

}  // namespace
}  // namespace test_framed_axis
