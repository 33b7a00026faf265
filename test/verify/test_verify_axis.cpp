// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The check of a medial axis: axes as they are made are right, and each of twenty-two ways to break one is seen.

#include "axis_checks.h"
#include "near_equal_discs.h"

#include <CGAL/Bounding_arcs_2/curve/Curve_file.h>
#include <CGAL/Bounding_arcs_2/verify/verify_axis.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <initializer_list>
#include <limits>
#include <random>
#include <string>
#include <utility>
#include <vector>

namespace test_verify_axis {
namespace {

using namespace bounding_arcs_test;
using ba::Axis_verification;

constexpr double EPS = 1e-4;
constexpr std::size_t MIDDLE = 12;  // of samples of the longest edge

Drawing bundled(const std::string& name) { return ba::read_drawing(BOUNDING_ARCS_EXAMPLE_DATA "/" + name + ".json"); }
void expect_right(const Drawing& drawing, const Medial_axis_2& axis, const Axis_verification::Options& options = {}) {
  const Axis_verification v = ba::verify_axis(drawing, axis, options);
  EXPECT_TRUE(v.is_right());
  for (const auto& f : v.findings)
    ADD_FAILURE() << ba::Axis_verification::name_of(f.fault) << ' ' << f.place << ' ' << f.amount;
  EXPECT_EQ(v.edges, axis.edges.size());
  EXPECT_EQ(v.tiles, 2 * (v.samples - v.edges));
}

TEST(AxisCheck, FindsNothingInAxesOfBundledCurves) {
  for (const std::string name :
       {"a_wrench", "b_angelfish", "c_letter_K", "d_rabbit", "e_cat", "f_crow", "g_chipmunk", "h_maple_leaf"}) {
    SCOPED_TRACE(name);
    const Drawing drawing = bundled(name);
    expect_right(drawing, axis_of(drawing, EPS));
  }
}

TEST(AxisCheck, FindsNothingInAxesOfRandomSplinesWithAndWithoutAFrame) {
  std::mt19937 random(3);
  const Drawing drawing = spline_field(random, 10, 8);
  expect_right(drawing, axis_of(drawing, EPS));
  const Drawing framed = ba::framed(drawing, 1);
  Axis_verification::Options options;
  options.is_framed = true;
  expect_right(framed, framed_axis_of(framed, EPS), options);
}

TEST(AxisCheck, FindsNothingInAxesWithCornersHolesOpenCurvesAndPoints) {
  const std::vector<Bezier> square = closed_chain({{0, 0}, {4, 0}, {4, 4}, {0, 4}}),
                            hole = closed_chain({{1, 1}, {2, 1}, {2, 2}, {1.5, 1.75}, {1, 2}});
  const Drawing drawing = both(square, hole);
  expect_right(drawing, axis_of(drawing, EPS));
  Drawing strokes;
  strokes.add(Bezier({{0, 0}, {1, 2}, {3, -1}, {4, 0}}));
  strokes.add(Bezier({{2, 3}, {2, 3}}));
  const Drawing framed = ba::framed(strokes, 1);
  Axis_verification::Options options;
  options.is_framed = true;
  expect_right(framed, framed_axis_of(framed, EPS), options);
}

Drawing strokes_of(std::initializer_list<std::vector<Bezier>> curves) {
  Drawing drawing;
  for (const std::vector<Bezier>& curve : curves) drawing.add(curve);
  return drawing;
}

TEST(AxisCheck, FindsNothingWhereWallsRunAlongEachOther) {
  const auto line = [](double from, double to) { return std::vector<Bezier>{segment({from, 0}, {to, 0})}; };
  const Bezier quarter({{1, 0}, {1, 1}, {0, 1}}, {1, 1, 2}),
      other({{0.96, 0.28}, {0.54, 1.72}, {-0.6, 0.8}}, {1, std::sqrt(0.36), 1});
  Axis_verification::Options options;
  options.is_framed = true;
  for (const Drawing& drawing :
       {strokes_of({line(0, 4), line(-2, 2)}), strokes_of({line(0, 4), line(2, -2), line(1, 3)}),
        strokes_of({line(0, 1), line(1, 2), line(4, 2)}), strokes_of({line(0, 3), line(0, 3)}),
        strokes_of({{segment({3, 2}, {6, 2}), segment({6, 2}, {-6, 2})}, {segment({3, 2}, {-1, 2})}}),
        strokes_of({{quarter}, {quarter.subcurve(0.25, 0.75)}, {segment({0, 0}, {1, 0})}}),
        strokes_of({{quarter}, {other}})}) {
    const Drawing framed = ba::framed(drawing, 1);
    expect_right(framed, framed_axis_of(framed, EPS), options);
  }
}

TEST(AxisCheck, IsTheSameInAnyUnit) {
  const Drawing drawing = drawing_of(closed_chain({{0, 0}, {4, 0}, {4, 2}, {0, 2}}));
  Drawing tiny;
  for (const auto& curve : drawing.curves()) {
    std::vector<Bezier> chain;
    for (const Bezier& b : curve.beziers) {
      std::vector<Point> points = b.control_points();
      for (Point& p : points) p = 0x1p-400 * p;
      chain.emplace_back(points);
    }
    tiny.add(chain);
  }
  expect_right(tiny, axis_of(tiny, 0x1p-410));
  Medial_axis_2 axis = axis_of(tiny, 0x1p-410);
  axis.vertices[0].radius += 0x1p-420;
  EXPECT_FALSE(ba::verify_axis(tiny, axis).is_right());
}

// A file cannot tell more than axes may: 2^-40 of the size.
// Handles are 1e-11 of the size beside their node, and so curves turn there within 1e-20.
TEST(AxisCheck, TakesAnyNormalOfATurnThatCoordinatesDoNotTell) {
  const Drawing drawing =
      ba::framed(drawing_of({Bezier({{11, 1}, {11.000000000099314, 0.9999999999208905}, {10.5, 7.4}, {14, 17}}),
                             Bezier({{14, 17}, {6, 2}}),
                             Bezier({{6, 2}, {7.3, 0.5}, {11.00000000016803, 1.0000000001119704}, {11, 1}})}),
                 1);
  Axis_verification::Options options;
  options.is_framed = true;
  Medial_axis_2 axis = framed_axis_of(drawing, EPS);
  expect_right(drawing, axis, options);
  // a foot that is seen is still none beside its normal
  bool is_moved = false;
  for (auto& e : axis.edges)
    for (std::size_t i = 1; i + 1 < e.samples.size() && !is_moved; ++i) {
      ba::Curve_place& foot = e.samples[i].left;
      is_moved = foot.curve == 0 && foot.bezier == 0 && foot.t > 1e-4 && foot.t < 0.1;
      if (is_moved) foot.t *= 1.5;
    }
  ASSERT_TRUE(is_moved);
  EXPECT_FALSE(ba::verify_axis(drawing, axis, options).is_right());
}

// A curve that turns alike everywhere leaves its tangent by 1e-12 within 1e-6: its normals are no choice.
TEST(AxisCheck, TakesTheNormalOfACurveThatIsSeen) {
  const Drawing drawing = bundled("d_rabbit");
  Medial_axis_2 axis = axis_of(drawing, 1e-6);
  expect_right(drawing, axis);
  const auto longest = std::max_element(axis.edges.begin(), axis.edges.end(), [](const auto& e, const auto& f) {
    return e.samples.size() < f.samples.size();
  });
  ba::Curve_place& foot = longest->samples[MIDDLE].left;
  foot.t += foot.t < 0.5 ? 1e-6 : -1e-6;
  const Axis_verification v = ba::verify_axis(drawing, axis);
  ASSERT_FALSE(v.is_right());
  EXPECT_EQ(v.findings.front().fault, Axis_verification::Fault::FOOT);
}

TEST(AxisCheck, CountsWhatCurvesWereMovedBy) {
  const Drawing drawing = drawing_of(closed_chain({{0, 0}, {4, 0}, {4, 2}, {0, 2}}));
  const auto is_right = [&](double by, double told) {
    Medial_axis_2 axis = axis_of(drawing, EPS);
    for (auto& v : axis.vertices) v.center.x += by;
    for (auto& e : axis.edges)
      for (auto& sample : e.samples) sample.center.x += by;
    axis.moved = told;
    return ba::verify_axis(drawing, axis).is_right();
  };
  EXPECT_TRUE(is_right(3e-12, 3e-12));
  EXPECT_FALSE(is_right(3e-12, 0));
  EXPECT_FALSE(is_right(1e-11, 1));
  EXPECT_FALSE(is_right(3e-12, std::numeric_limits<double>::quiet_NaN()));
}

// A rabbit and a square beside it, with what is broken.
class BrokenAxis : public testing::Test {
 protected:
  BrokenAxis() : drawing_(bundled("d_rabbit")) {
    drawing_.add(closed_chain({{3, 0}, {4, 0}, {4, 1}, {3, 1}}));
    axis_ = axis_of(drawing_, EPS);
    longest_ = static_cast<std::size_t>(
        std::max_element(axis_.edges.begin(), axis_.edges.end(),
                         [](const auto& e, const auto& f) { return e.samples.size() < f.samples.size(); }) -
        axis_.edges.begin());
    const auto all = axis_.degrees();
    for (std::size_t i = 0; i < all.size(); ++i)
      if (all[i] == 1) leaves_.push_back(i);
  }
  // The check finds one of these faults after a change, and nothing before it.
  template <class Change>
  void expect_found(std::initializer_list<Axis_verification::Fault> faults, const Change& change,
                    const Axis_verification::Options& options = {}) {
    ASSERT_TRUE(ba::verify_axis(drawing_, axis_).is_right());
    Medial_axis_2 broken = axis_;
    change(broken);
    const Axis_verification v = ba::verify_axis(drawing_, broken, options);
    EXPECT_FALSE(v.is_right());
    for (const Axis_verification::Fault fault : faults) {
      const bool is_found =
          std::any_of(v.findings.begin(), v.findings.end(), [fault](const auto& f) { return f.fault == fault; });
      EXPECT_TRUE(is_found) << "no " << ba::Axis_verification::name_of(fault);
    }
  }
  ba::Medial_axis_2::Sample& middle(Medial_axis_2& axis) const { return axis.edges[longest_].samples[MIDDLE]; }
  // Moves a vertex with the ends of its edges.
  static void move_vertex(Medial_axis_2& axis, std::size_t i, double by) {
    axis.vertices[i].center.x += by;
    for (ba::Medial_axis_2::Edge& e : axis.edges) {
      if (e.from == i) e.samples.front().center.x += by;
      if (e.to == i) e.samples.back().center.x += by;
    }
  }
  // An edge's end at a leaf.
  static void erase_leaf(Medial_axis_2& axis, std::size_t leaf) {
    axis.edges.erase(std::find_if(axis.edges.begin(), axis.edges.end(),
                                  [leaf](const auto& e) { return e.from == leaf || e.to == leaf; }));
    axis.vertices.erase(axis.vertices.begin() + static_cast<std::ptrdiff_t>(leaf));
    for (ba::Medial_axis_2::Edge& e : axis.edges)
      for (std::size_t* end : {&e.from, &e.to})
        if (*end > leaf) --*end;
  }

  Drawing drawing_;
  Medial_axis_2 axis_;
  std::size_t longest_ = 0;
  std::vector<std::size_t> leaves_;
};

TEST_F(BrokenAxis, IsSeenWhereAnEdgeIsLeftOut) {
  expect_found({Axis_verification::Fault::TILING, Axis_verification::Fault::EULER},
               [](auto& a) { a.edges.pop_back(); });
}
TEST_F(BrokenAxis, IsSeenWhereAnEdgeIsLeftOutWithItsLeaf) {
  expect_found({Axis_verification::Fault::TILING}, [&](auto& a) { erase_leaf(a, leaves_[0]); });
}
TEST_F(BrokenAxis, IsSeenWhereAnEdgeIsThereTwice) {
  expect_found({Axis_verification::Fault::TILING, Axis_verification::Fault::EULER},
               [](auto& a) { a.edges.push_back(a.edges.front()); });
}
TEST_F(BrokenAxis, IsSeenWhereAVertexIsMovedWithItsEdges) {
  expect_found({Axis_verification::Fault::TOUCH}, [](auto& a) { move_vertex(a, 0, 1e-9); });
}
TEST_F(BrokenAxis, IsSeenWhereAVertexAloneIsMoved) {
  expect_found({Axis_verification::Fault::END}, [](auto& a) { a.vertices[0].center.x += 1e-9; });
}
TEST_F(BrokenAxis, IsSeenWhereASampleIsMoved) {
  expect_found({Axis_verification::Fault::FOOT}, [&](auto& a) { middle(a).center.x += 2 * EPS; });
}
TEST_F(BrokenAxis, IsSeenWhereASampleIsTheNextOneWithOtherFeet) {
  expect_found({Axis_verification::Fault::FOOT}, [&](auto& a) {
    const ba::Medial_axis_2::Sample& next = a.edges[longest_].samples[MIDDLE + 1];
    middle(a).center = next.center, middle(a).radius = next.radius;
  });
}
TEST_F(BrokenAxis, IsSeenWhereARadiusIsLarger) {
  expect_found({Axis_verification::Fault::FOOT}, [&](auto& a) { middle(a).radius += 2 * EPS; });
}
TEST_F(BrokenAxis, IsSeenWhereAFootIsMoved) {
  expect_found({Axis_verification::Fault::FOOT},
               [&](auto& a) { middle(a).left.t += middle(a).left.t < 0.5 ? 0.01 : -0.01; });
}
TEST_F(BrokenAxis, IsSeenWhereFeetAreOnTheWrongSides) {
  expect_found({Axis_verification::Fault::TILING}, [&](auto& a) { std::swap(middle(a).left, middle(a).right); });
}
TEST_F(BrokenAxis, IsSeenWhereSamplesRunTheOtherWay) {
  expect_found({Axis_verification::Fault::END},
               [&](auto& a) { std::reverse(a.edges[longest_].samples.begin(), a.edges[longest_].samples.end()); });
}
TEST_F(BrokenAxis, IsSeenWhereTwoSamplesAreSwapped) {
  expect_found({}, [&](auto& a) { std::swap(middle(a), a.edges[longest_].samples[MIDDLE + 2]); });
}
TEST_F(BrokenAxis, IsSeenWhereTwoDiscsOfTheSameFeetAreSwapped) {
  // two corners point at each other: the discs between touch them both
  drawing_ = drawing_of(closed_chain({{-2, -2}, {2, -2}, {0.5, 0}, {2, 2}, {-2, 2}, {-0.5, 0}}));
  axis_ = axis_of(drawing_, EPS);
  expect_found({Axis_verification::Fault::CELL}, [](auto& a) {
    const auto are_same = [](const auto& p, const auto& q) { return p.bezier == q.bezier && p.t == q.t; };
    for (ba::Medial_axis_2::Edge& e : a.edges)
      for (std::size_t i = 1; i + 2 < e.samples.size(); ++i) {
        ba::Medial_axis_2::Sample &s = e.samples[i], &t = e.samples[i + 1];
        if (are_same(s.left, t.left) && are_same(s.right, t.right)) return std::swap(s, t);
      }
  });
}
TEST_F(BrokenAxis, IsSeenWhereSamplesAreLeftOut) {
  expect_found({}, [&](auto& a) {
    auto& samples = a.edges[longest_].samples;
    samples.erase(samples.begin() + 1, samples.end() - 1);
  });
}
TEST_F(BrokenAxis, IsSeenWhereABoundIsTooSmall) {
  Axis_verification::Options options;
  options.bounds.assign(axis_.edges.size(), 2 * EPS);
  options.bounds[longest_] = 1e-3 * EPS;
  expect_found(
      {Axis_verification::Fault::BOUND}, [](auto&) {}, options);
}
TEST_F(BrokenAxis, IsSeenWhereTwoLeavesAreOne) {
  expect_found({Axis_verification::Fault::END}, [&](auto& a) {
    for (ba::Medial_axis_2::Edge& e : a.edges)
      for (std::size_t* end : {&e.from, &e.to})
        if (*end == leaves_[1]) *end = leaves_[0];
  });
}
TEST_F(BrokenAxis, IsSeenWhereAnEdgeJoinsTwoLeaves) {
  expect_found({Axis_verification::Fault::END, Axis_verification::Fault::EULER}, [&](auto& a) {
    ba::Medial_axis_2::Edge edge{leaves_[0], leaves_[1], {}};
    for (const std::size_t i : {leaves_[0], leaves_[1]}) {
      const ba::Medial_axis_2::Vertex& v = a.vertices[i];
      edge.samples.push_back({v.center, v.radius, v.touches.front(), v.touches.back()});
    }
    edge.samples.back().left = edge.samples.front().left;
    a.edges.push_back(edge);
  });
}
TEST_F(BrokenAxis, IsSeenWhereATouchIsLeftOut) {
  expect_found({Axis_verification::Fault::END},
               [&](auto& a) { a.vertices[a.edges[longest_].from].touches.pop_back(); });
}
TEST_F(BrokenAxis, IsSeenWhereATouchIsElsewhere) {
  expect_found({Axis_verification::Fault::TOUCH, Axis_verification::Fault::END}, [&](auto& a) {
    ba::Curve_place& p = a.vertices[a.edges[longest_].from].touches.front();
    p.t += p.t < 0.5 ? 0.1 : -0.1;
  });
}
TEST_F(BrokenAxis, IsSeenWhereRegionsOrHolesAreOthers) {
  expect_found({Axis_verification::Fault::EULER}, [](auto& a) { ++a.regions; });
  expect_found({Axis_verification::Fault::EULER}, [](auto& a) { ++a.holes; });
  expect_found({Axis_verification::Fault::EULER}, [](auto& a) { ++a.regions, ++a.holes; });
}
TEST_F(BrokenAxis, IsSeenWhereNumbersAreNone) {
  expect_found({Axis_verification::Fault::FORM},
               [&](auto& a) { middle(a).radius = std::numeric_limits<double>::quiet_NaN(); });
  expect_found({Axis_verification::Fault::FORM}, [&](auto& a) { middle(a).left.curve = 2; });
  expect_found({Axis_verification::Fault::FORM}, [&](auto& a) { a.edges[0].to = a.vertices.size(); });
  expect_found({Axis_verification::Fault::FORM}, [&](auto& a) { a.vertices[0].touches.clear(); });
}
TEST_F(BrokenAxis, IsSeenWhereItIsOfOneOfTwoCurves) {
  expect_found({Axis_verification::Fault::TILING}, [](auto& a) { a = axis_of(bundled("d_rabbit"), EPS); });
}
TEST_F(BrokenAxis, IsSeenWhereAnEdgeBetweenTwoPointsIsLeftOut) {
  Drawing points;
  for (const double x : {0.0, 1.0}) points.add(Bezier({{x, 0}, {x, 0}}));
  const Drawing framed = ba::framed(points, 1);
  Axis_verification::Options options;
  options.is_framed = true;
  Medial_axis_2 axis = framed_axis_of(framed, EPS);
  expect_right(framed, axis, options);
  const auto edge = std::find_if(axis.edges.begin(), axis.edges.end(), [](const auto& e) {
    return e.samples[0].left.curve + e.samples[0].right.curve == 1 && e.samples[1].left.curve < 2 &&
           e.samples[1].right.curve < 2;
  });
  ASSERT_NE(edge, axis.edges.end());
  axis.edges.erase(edge);
  --axis.holes;
  const Axis_verification v = ba::verify_axis(framed, axis, options);
  ASSERT_FALSE(v.is_right());
  for (const auto& f : v.findings) EXPECT_EQ(f.fault, Axis_verification::Fault::TILING);
}
// Two lines in one place: discs touch either of them, and one alone.
TEST_F(BrokenAxis, IsSeenWhereAWallIsTiledTwiceOrNotAtAll) {
  const Drawing framed = ba::framed(strokes_of({{segment({0, 0}, {3, 0})}, {segment({0, 0}, {3, 0})}}), 1);
  Axis_verification::Options options;
  options.is_framed = true;
  const Medial_axis_2 axis = framed_axis_of(framed, EPS);
  expect_right(framed, axis, options);
  Medial_axis_2 twice = axis, none = axis;
  const auto along = std::find_if(none.edges.begin(), none.edges.end(), [](const auto& e) {
    return std::any_of(e.samples.begin() + 1, e.samples.end(),
                       [&](const auto& s) { return std::fabs(s.center.x - (&s - 1)->center.x) > 2; });
  });
  ASSERT_NE(along, none.edges.end());
  twice.edges.push_back(*along);
  for (auto& s : twice.edges.back().samples)
    for (ba::Curve_place* foot : {&s.left, &s.right})
      if (foot->curve < 2) foot->curve = 1 - foot->curve;
  none.edges.erase(along);
  const auto expect_place = [&](const Medial_axis_2& broken, const std::string& place) {
    const Axis_verification v = ba::verify_axis(framed, broken, options);
    EXPECT_TRUE(std::any_of(v.findings.begin(), v.findings.end(), [&](const auto& f) {
      return f.fault == Axis_verification::Fault::TILING && f.place.rfind(place, 0) == 0 && f.amount > 2.9;
    })) << place;
  };
  expect_place(twice, "walls that run along each other");
  expect_place(none, "curve 0");
  expect_place(none, "curve 1");
}
TEST_F(BrokenAxis, IsSeenWhereItIsOfTheOutsideOfAHole) {
  const std::vector<Bezier> square = closed_chain({{0, 0}, {4, 0}, {4, 4}, {0, 4}}),
                            hole = closed_chain({{1, 1}, {2, 1}, {2, 2}, {1, 2}});
  const Axis_verification v = ba::verify_axis(both(square, hole), axis_of(drawing_of(square), EPS));
  EXPECT_FALSE(v.is_right());
  const auto has = [&](Axis_verification::Fault fault) {
    return std::any_of(v.findings.begin(), v.findings.end(), [fault](const auto& f) { return f.fault == fault; });
  };
  EXPECT_TRUE(has(Axis_verification::Fault::TILING));
  EXPECT_TRUE(has(Axis_verification::Fault::DISC));
}

}  // namespace
}  // namespace test_verify_axis
