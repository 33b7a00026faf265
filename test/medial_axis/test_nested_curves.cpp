// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Axes of nested curves are of what the rule fills, as offsets and Boolean operations have it: a curve with both sides
// filled bounds nothing, for the axis and for all that is asked of it.

#include "axis_checks.h"
#include "cases.h"
#include "closed_drawings.h"

#include <CGAL/Bounding_arcs_2/medial_axis/axis_certificate.h>
#include <CGAL/Bounding_arcs_2/medial_axis/maximal_disc.h>
#include <CGAL/Bounding_arcs_2/medial_axis/medial_axis.h>
#include <CGAL/Bounding_arcs_2/medial_axis/pruned.h>
#include <CGAL/Bounding_arcs_2/medial_axis/thin_places.h>
#include <CGAL/Bounding_arcs_2/medial_axis/voronoi_cells.h>
#include <CGAL/Bounding_arcs_2/offset/Offset_source_2.h>
#include <CGAL/Bounding_arcs_2/verify/verify_axis.h>

#include <CGAL/Exact_rational.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <random>
#include <string>
#include <vector>

namespace test_nested_curves {
namespace {

using namespace bounding_arcs_test;
using ba::Fill_rule;
using Numbers = std::vector<std::uint32_t>;

Medial_axis_2 axis_under(Fill_rule rule, const Drawing& drawing) {
  ba::Medial_axis_2::Options options;
  options.rule = rule;
  return ba::medial_axis(ba::Bounding_arc_tree_2(drawing), 1e-5, options);
}
// Squares about (5, 5), from the outermost one inward, in the direction of each sign.
Drawing squares(const std::vector<int>& signs) {
  Drawing drawing;
  double half = 5;
  for (const int sign : signs) {
    const Drawing square =
        drawing_of(polygon({{5 - half, 5 - half}, {5 + half, 5 - half}, {5 + half, 5 + half}, {5 - half, 5 + half}}));
    drawing.add((sign > 0 ? square : reversed(square)).curves()[0].beziers, "square " + std::to_string(half));
    half -= 1;
  }
  return drawing;
}
void expect_same(const Medial_axis_2& a, const Medial_axis_2& b) {
  EXPECT_EQ(a.status, b.status);
  EXPECT_EQ(a.regions, b.regions);
  EXPECT_EQ(a.holes, b.holes);
  EXPECT_EQ(a.error, b.error);
  ASSERT_EQ(a.vertices.size(), b.vertices.size());
  ASSERT_EQ(a.edges.size(), b.edges.size());
  for (std::size_t i = 0; i < a.vertices.size(); ++i) {
    EXPECT_EQ(a.vertices[i].center, b.vertices[i].center);
    EXPECT_EQ(a.vertices[i].clearance.lower, b.vertices[i].clearance.lower);
  }
}
// Insets at many depths have as many parts and holes as the axis has where its discs are larger.
void expect_as_insets(const Drawing& drawing, const Medial_axis_2& axis, Fill_rule rule) {
  ba::Offset::Options options;
  options.rule = rule;
  for (const double d : {0.1, 0.3, 0.45}) {
    const ba::Offset inset = ba::offset(ba::Bounding_arc_tree_2(drawing), -d, 1e-6, options);
    EXPECT_EQ(inset.status, ba::Offset::Status::COMPLETE);
    std::size_t outer = 0, holes = 0;
    for (const auto& chain : inset.chains) ++(chain.is_ccw ? outer : holes);
    EXPECT_EQ(outer, axis.regions);
    EXPECT_EQ(holes, axis.holes);
  }
}

struct Nest {
  std::vector<int> signs;
  Numbers left_out;            // under the nonzero rule
  std::size_t regions, holes;  // so
  std::size_t odd_regions, odd_holes;
};
const Nest NESTS[] = {
    {{1, 1}, {1}, 1, 0, 1, 1},       {{-1, -1}, {1}, 1, 0, 1, 1},          {{1, -1}, {}, 1, 1, 1, 1},
    {{1, 1, 1}, {1, 2}, 1, 0, 2, 1}, {{1, 1, -1}, {1, 2}, 1, 0, 2, 1},     {{1, -1, 1}, {}, 2, 1, 2, 1},
    {{1, -1, -1}, {}, 2, 1, 2, 1},   {{1, 1, -1, -1}, {1, 2}, 1, 1, 2, 2}, {{-1, 1, 1, 1}, {3}, 2, 1, 2, 2},
};

TEST(NestedCurves, HaveTheAxisOfWhatTheRuleFills) {
  for (const Nest& nest : NESTS) {
    const Drawing drawing = squares(nest.signs);
    SCOPED_TRACE(testing::PrintToString(nest.signs));
    const Medial_axis_2 nonzero = axis_under(Fill_rule::NONZERO, drawing),
                        odd = axis_under(Fill_rule::EVEN_ODD, drawing);
    for (const Medial_axis_2* axis : {&nonzero, &odd}) EXPECT_EQ(axis->status, Status::COMPLETE);
    EXPECT_EQ(nonzero.left_out, nest.left_out);
    EXPECT_EQ(nonzero.regions, nest.regions);
    EXPECT_EQ(nonzero.holes, nest.holes);
    EXPECT_TRUE(odd.left_out.empty());
    EXPECT_EQ(odd.regions, nest.odd_regions);
    EXPECT_EQ(odd.holes, nest.odd_holes);
    expect_as_insets(drawing, nonzero, Fill_rule::NONZERO);
    expect_as_insets(drawing, odd, Fill_rule::EVEN_ODD);
  }
}

// As without the others, but for the numbers of curves.
TEST(NestedCurves, AreNotSeenWhereTheyBoundNothing) {
  const Drawing outer = squares({1}), nest = squares({1, 1, -1, 1});
  Drawing inner_first;
  for (const std::size_t i : {2, 0, 1}) inner_first.add(nest.curves()[i].beziers);
  const Medial_axis_2 expected = axis_of(outer);
  for (const Drawing& drawing : {nest, inner_first}) {
    const Medial_axis_2 axis = axis_of(drawing);
    expect_same(axis, expected);
    const std::uint32_t number = &drawing == &nest ? 0 : axis.vertices[0].touches[0].curve;
    for (const auto& v : axis.vertices)
      for (const auto& p : v.touches) EXPECT_EQ(p.curve, number);
  }
  EXPECT_EQ(axis_of(inner_first).vertices[0].touches[0].curve, 1u);
}

TEST(NestedCurves, AreProvenAndVerified) {
  for (const Nest& nest : NESTS)
    for (const Fill_rule rule : {Fill_rule::NONZERO, Fill_rule::EVEN_ODD}) {
      SCOPED_TRACE(testing::PrintToString(nest.signs));
      const Drawing drawing = squares(nest.signs);
      Medial_axis_2 axis = axis_under(rule, drawing);
      const ba::Bounding_arc_tree_2 tree(drawing);
      EXPECT_TRUE(ba::axis_certificate(tree, axis).is_proven());
      ba::Axis_verification::Options options;
      options.rule = rule;
      EXPECT_TRUE(ba::verify_axis(drawing, axis, options).is_right());
      if (axis.left_out.empty()) continue;
      axis.bounds.reset();
      EXPECT_TRUE(ba::axis_certificate(tree, axis).is_proven());
      axis.options.rule = Fill_rule::EVEN_ODD;
      EXPECT_FALSE(ba::axis_certificate(tree, axis).is_proven());
      options.rule = Fill_rule::EVEN_ODD;
      EXPECT_FALSE(ba::verify_axis(drawing, axis, options).is_right());
    }
}

TEST(NestedCurves, AreNotSeenByWhatIsAskedOfTheAxis) {
  const Drawing outer = drawing_of(polygon({{0, 0}, {6, 0}, {6, 2}, {0, 2}}));
  Drawing nest = drawing_of(polygon({{4, 0.5}, {5, 0.5}, {5, 1.5}, {4, 1.5}}));
  nest.add(outer.curves()[0].beziers);
  const ba::Bounding_arc_tree_2 tree(nest), of_outer(outer);
  const Medial_axis_2 axis = axis_of(nest), expected = axis_of(outer);
  const auto disc = ba::largest_inscribed_disc(tree, axis);
  ASSERT_TRUE(disc);
  EXPECT_NEAR(disc->radius.lower, 1, 1e-12);
  const Medial_axis_2 cut = ba::trimmed(tree, axis, {0, 0.2});
  EXPECT_LE(cut.error, 1e-12);
  expect_same(cut, ba::trimmed(of_outer, expected, {0, 0.2}));
  const auto path = ba::clearance_path(tree, axis, {0.5, 1}, {5.5, 1});
  ASSERT_TRUE(path);
  EXPECT_NEAR(path->bottleneck, 0.5, 1e-12);
  EXPECT_NEAR(path->length, 5, 1e-9);
  const auto cells = ba::voronoi_cells(tree, axis);
  ASSERT_EQ(cells.size(), 1u);
  EXPECT_EQ(cells[0].curve, 1u);
  EXPECT_TRUE(ba::necks(axis).empty());
}

// New leaves have brackets of their own, which the curve next to the boundary would make too small.
TEST(NestedCurves, AreNotSeenByNewLeaves) {
  std::mt19937 random(4);
  const Drawing outer = drawing_of(closed_curve(random, {0, 0}, 7));
  Drawing nest = outer;
  nest.add(moved(outer, 0.97, {0, 0}).curves()[0].beziers);
  const Medial_axis_2 axis = axis_of(nest), expected = axis_of(outer);
  ASSERT_EQ(axis.status, Status::COMPLETE);
  ASSERT_EQ(axis.left_out, Numbers{1});
  const ba::Medial_axis_2::Feet_apart apart{1, 0};
  const Medial_axis_2 cut = ba::trimmed(ba::Bounding_arc_tree_2(nest), axis, apart);
  EXPECT_LT(cut.edges[0].samples.size() + cut.edges.back().samples.size(),
            axis.edges[0].samples.size() + axis.edges.back().samples.size());
  expect_same(cut, ba::trimmed(ba::Bounding_arc_tree_2(outer), expected, apart));
  EXPECT_LE(cut.error, 1e-12 * size_of(nest));
}

TEST(NestedCurves, HaveMaximalDiscsWhereTheyBoundARegion) {
  const Drawing nest = squares({1, 1, -1, -1});
  const ba::Bounding_arc_tree_2 tree(nest);
  const ba::Maximal_discs_2 discs(tree), odd(tree, Fill_rule::EVEN_ODD);
  for (const std::uint32_t inner : {1, 2}) EXPECT_FALSE(discs({inner, 0, 0.5}));
  const auto disc = discs({0, 0, 0.5});  // to the hole of the third square inward
  ASSERT_TRUE(disc);
  EXPECT_NEAR(disc->radius, 1.5, 1e-12);
  ASSERT_TRUE(disc->touches);
  EXPECT_EQ(disc->touches->curve, 3u);
  EXPECT_NEAR(odd({1, 0, 0.5})->radius, 0.5, 1e-12);
  EXPECT_THROW(static_cast<void>(discs({1, 4, 0.5})), std::invalid_argument);
  EXPECT_THROW(static_cast<void>(discs({4, 0, 0.5})), std::invalid_argument);
  EXPECT_THROW(static_cast<void>(discs({0, 0, 1.5})), std::invalid_argument);
}

// In a frame all curves bound, whatever their direction.
TEST(NestedCurves, BoundInAFrame) {
  ba::Medial_axis_2::Options options;
  options.is_framed = true;
  Drawing nest = squares({-1, 1, 1});  // the first one is the frame
  Drawing framed;
  for (const std::size_t i : {1, 2, 0}) framed.add(nest.curves()[i].beziers);
  const Medial_axis_2 axis = ba::medial_axis(ba::Bounding_arc_tree_2(framed), 1e-6, options);
  EXPECT_EQ(axis.status, Status::COMPLETE);
  EXPECT_TRUE(axis.left_out.empty());
  EXPECT_EQ(axis.regions, 3u);
  EXPECT_EQ(axis.holes, 2u);
}

// Smooth curves one in the other, of either direction, against insets and a check by code of its own.
TEST(NestedCurves, OfRandomCurvesAreRight) {
  std::mt19937 random(9);
  std::size_t checked = 0, left_out = 0;
  for (int round = 0; round < cases(12); ++round) {
    SCOPED_TRACE(round);
    Drawing drawing;
    double size = 4;
    for (int i = 0; i < 3; ++i, size *= 0.2) {
      const Drawing curve = moved(drawing_of(closed_curve(random, {0, 0}, 5 + random() % 5)), size, {0, 0});
      drawing.add((random() % 2 == 0 ? curve : reversed(curve)).curves()[0].beziers);
    }
    for (const Fill_rule rule : {Fill_rule::NONZERO, Fill_rule::EVEN_ODD}) {
      const Medial_axis_2 axis = axis_under(rule, drawing);
      if (axis.status != Status::COMPLETE) continue;
      ++checked;
      left_out += axis.left_out.size();
      ba::Axis_verification::Options options;
      options.rule = rule;
      EXPECT_TRUE(ba::verify_axis(drawing, axis, options).is_right());
      if (HasFailure()) return;
    }
  }
  EXPECT_GE(checked, 10u);
  EXPECT_GE(left_out, 4u);
}

}  // namespace
}  // namespace test_nested_curves
