// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Offsets and medial axes of drawings of any size: the same bits but for the scale, and distances at the ends of
// the range.

#include "axis_checks.h"
#include "cases.h"
#include "closed_drawings.h"
#include "scaled_answers.h"

#include <CGAL/Bounding_arcs_2/medial_axis/bisector.h>
#include <CGAL/Bounding_arcs_2/medial_axis/local_thickness.h>
#include <CGAL/Bounding_arcs_2/medial_axis/maximal_disc.h>
#include <CGAL/Bounding_arcs_2/medial_axis/medial_axis.h>
#include <CGAL/Bounding_arcs_2/medial_axis/pruned.h>
#include <CGAL/Bounding_arcs_2/offset/Offset_source_2.h>
#include <CGAL/Bounding_arcs_2/offset/offset_bracket.h>
#include <CGAL/Bounding_arcs_2/offset/offset_series.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <random>
#include <stdexcept>
#include <vector>

namespace test_scaled_offsets {
namespace {

using namespace bounding_arcs_test;
using ba::Bounding_arc_tree_2;
using ba::Offset;

void add(Answers& to, const Offset& offset) {
  to.length(offset.distance), to.length(offset.error), to.count(static_cast<std::size_t>(offset.status));
  for (const auto& chain : offset.chains) {
    to.area(chain.area), to.count(chain.is_ccw ? 1 : 0);
    for (const auto& p : chain.pieces)
      to.point(p.arc.from), to.number(p.arc.bulge), to.place(p.source), to.number(p.t_end);
  }
}
void add(Answers& to, const Medial_axis_2& axis) {
  to.count(static_cast<std::size_t>(axis.status)), to.count(axis.regions), to.count(axis.holes);
  to.length(axis.eps), to.length(axis.error);
  for (const auto& v : axis.vertices) to.point(v.center), to.length(v.radius), to.lengths(v.clearance);
  for (const auto& e : axis.edges)
    for (const auto& s : e.samples) to.point(s.center), to.length(s.radius), to.place(s.left);
}

Answers offsets(const Drawing& unscaled, double scale) {
  const Drawing drawing = moved(unscaled, scale, {0, 0});
  const Bounding_arc_tree_2 tree(drawing);
  Answers to;
  ba::Offset::Options options;
  const double eps = scale * 1e-4;
  const ba::Offset_source_2 source(tree, eps, options);
  to.of("offsets");
  for (const double d : {0.01, -0.01, 0.2, 0.0}) add(to, source.at(scale * d));
  to.of("outline");
  add(to, source.outline());
  to.of("offsets with miters");
  options.join = ba::Offset::Join::MITER;
  options.cap = ba::Offset::Cap::SQUARE;
  add(to, ba::offset(tree, scale * 0.01, eps, options));
  to.of("offset twice");
  add(to, ba::closing(tree, scale * 0.01, eps));
  to.of("insets");
  for (const Offset& o : ba::insets(tree, scale * 0.02, eps)) add(to, o);
  to.of("offset bracket");
  add(to, ba::offset_bracket(tree, scale * 0.01, eps).inside);
  to.of("error of an offset");
  const Bounding_arc_tree_2 index(drawing, ba::Decisions::DOUBLE);
  if (const auto e = ba::offset_error(index, source.at(scale * 0.01), scale * 1e-5))
    to.lengths(e->nearest), to.lengths(e->farthest);
  return to;
}

// Of curves that do not cross.
Answers axes(const Drawing& unscaled, double scale) {
  const Drawing drawing = moved(unscaled, scale, {0, 0});
  const Bounding_arc_tree_2 index(drawing);
  const double eps = scale * 1e-5;
  Answers to;
  to.of("axis");
  const Medial_axis_2 axis = ba::medial_axis(index, eps);
  add(to, axis);
  to.of("pruned axis");
  add(to, ba::pruned(axis, scale * 0.002));
  to.of("trimmed axis");
  add(to, ba::trimmed(index, axis, {1, scale * 0.001}));
  to.of("largest disc");
  if (const auto disc = ba::largest_inscribed_disc(index, axis)) to.point(disc->center), to.lengths(disc->radius);
  to.of("maximal discs");
  const ba::Maximal_discs_2 discs(index);
  for (const double t : {0.0, 0.3, 0.7})
    if (const auto disc = discs({0, 0, t})) to.point(disc->center), to.length(disc->radius);
  const ba::Local_thickness_2 thickness(axis);
  to.of("thickness");
  for (const double x : {-0.02, 0.0, 0.02}) to.length(thickness({scale * x, scale * 0.01}));
  to.of("path");
  if (const auto path = ba::clearance_path(index, axis, {scale * -0.02, 0}, {scale * 0.02, scale * 0.01})) {
    to.length(path->bottleneck), to.length(path->length);
    for (const auto& s : path->stations) to.point(s.point), to.length(s.clearance);
  }
  to.of("bisector");
  const Bezier wall({{scale * -0.2, scale * -0.1}, {scale * 0.2, scale * -0.1}});
  for (const auto& chain : ba::Bisector_2(wall, index, scale).sample(eps))
    for (const auto& s : chain) to.point(s.center), to.length(s.radius), to.number(s.t);
  to.of("axis in a frame");
  ba::Medial_axis_2::Options options;
  options.is_framed = true;
  add(to, ba::medial_axis(Bounding_arc_tree_2(ba::framed(drawing, scale * 0.05)), eps, options));
  return to;
}

template <class Ask> void expect_same_at_all_scales(const Ask& ask, const Drawing& drawing, std::mt19937& random) {
  const Answers unscaled = ask(drawing, 1);
  EXPECT_GT(unscaled.size(), 100U);
  for (const int k : exponents(random, cases(1))) {
    ask(drawing, std::ldexp(1.0, k)).expect_scaled(unscaled, k);
    if (testing::Test::HasFailure()) return;
  }
}

TEST(ScaledOffsets, AreTheSameBitsButForTheScale) {
  std::mt19937 random(1);
  for (int i = 0; i < 4; ++i) {
    SCOPED_TRACE(i);
    Drawing drawing;
    if (i % 2 == 0) drawing.add(closed_curve(random, {0, 0}, 5));
    if (i < 3) drawing.add(random_lattice_chain(random, 3));
    if (i > 1) drawing.add(Bezier({{0, 0}, {5, 3}, {-2, 3}, {3, 0}}));
    expect_same_at_all_scales(offsets, small_drawing(drawing), random);
    if (HasFailure()) return;
  }
}

TEST(ScaledAxes, AreTheSameBitsButForTheScale) {
  std::mt19937 random(2);
  for (int i = 0; i < 2; ++i) {
    SCOPED_TRACE(i);
    Drawing drawing = moved(drawing_of(closed_curve(random, {0, 0}, 7)), 4, {0, 0});
    if (i > 0)
      drawing.add(reversed(moved(drawing_of(closed_curve(random, {0, 0}, 4)), 0.3, {0, 0})).curves()[0].beziers);
    expect_same_at_all_scales(axes, small_drawing(drawing), random);
    if (HasFailure()) return;
  }
}

// About a curve that is small beside them offsets are circles.
TEST(ScaledOffsets, AreServedToTheEndOfTheRange) {
  const Drawing curve = small_drawing(drawing_of(Bezier({{0, 0}, {5, 3}, {-2, 3}, {3, 0}})));
  constexpr double PI = 3.14159265358979323846;
  for (const int size : {-900, -500, -41, 0, 41, 300, 400})
    for (int k = size + 10; k <= std::min(size + 100, 499); k += 10) {
      const double d = std::ldexp(1.0, k);
      const Offset offset = ba::offset(Bounding_arc_tree_2(moved(curve, std::ldexp(1.0, size), {0, 0})), d, 1e-6 * d);
      ASSERT_EQ(offset.chains.size(), 1U) << size << ' ' << k;
      EXPECT_EQ(offset.status, ba::Offset::Status::COMPLETE) << size << ' ' << k;
      if (size == -900) continue;  // no double is as small as its area
      EXPECT_NEAR(std::sqrt(offset.chains[0].area / PI) / d, 1, 1e-3) << size << ' ' << k;
    }
}

// As small as that nothing is seen of them.
TEST(ScaledOffsets, AreTheCurvesAtTheSmallestDistances) {
  const Drawing square = drawing_of(polygon({{0, 0}, {1, 0}, {1, 1}, {0, 1}}));
  for (const double scale : {1.0, 0x1p400, 0x1p-400})
    for (const double d : {1e-30, 1e-100, 1e-200, 1e-300, -1e-300, -1e-200, -1e-30}) {
      const Bounding_arc_tree_2 tree(moved(square, scale, {0, 0}));
      const Offset offset = ba::offset(tree, d * std::min(1.0, scale), scale * 1e-4);
      ASSERT_EQ(offset.chains.size(), 1U) << scale << ' ' << d;
      EXPECT_EQ(offset.distance, d * std::min(1.0, scale));
      EXPECT_NEAR(std::sqrt(offset.chains[0].area) / scale, 1, 1e-12) << scale << ' ' << d;
    }
}

TEST(ScaledOffsets, RefuseDistancesOutOfRange) {
  for (const double scale : {1.0, 0x1p-400, 0x1p400}) {
    const Drawing square = drawing_of(polygon({{0, 0}, {scale, 0}, {scale, scale}, {0, scale}}));
    const ba::Offset_source_2 source(Bounding_arc_tree_2(square), 1e-6);
    for (const double d : {0x1p501, 1e154, 1e300, 1e308, HUGE_VAL, std::numeric_limits<double>::quiet_NaN()})
      for (const double sign : {1.0, -1.0})
        EXPECT_THROW(static_cast<void>(source.at(sign * d)), std::invalid_argument) << scale << ' ' << d;
  }
  const Drawing huge = drawing_of(polygon({{0, 0}, {0x1p500, 0}, {0x1p500, 0x1p500}, {0, 0x1p500}}));
  const ba::Offset_source_2 large(Bounding_arc_tree_2(huge), 1e-6);
  EXPECT_THROW(static_cast<void>(large.at(0x1p480)), std::invalid_argument);  // what comes out is not in range
  EXPECT_EQ(large.at(-0x1p480).chains.size(), 1U);
}

}  // namespace
}  // namespace test_scaled_offsets
