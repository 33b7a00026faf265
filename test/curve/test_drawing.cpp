// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Drawings: places of segments and leaves, their neighbours along the curves, and why segments end.

#include "trees.h"

#include <CGAL/Bounding_arcs_2.h>

#include <gtest/gtest.h>

#include <cstddef>
#include <optional>
#include <stdexcept>
#include <string>
#include <type_traits>
#include <vector>

namespace test_drawing {
namespace {

using namespace CGAL::Bounding_arcs;
using bounding_arcs_test::Bca_tree;
using bounding_arcs_test::nodes_of_kind;
using Curve = Bezier_curve_2<double>;
using Spline = B_spline_curve_2<double>;

// An open cubic with an inflection, a closed periodic spline, and a closed chain of a line and an arch.
Drawing_2<double> three_curves() {
  Drawing_2<double> drawing;
  drawing.add(Curve({{0, 0}, {1, 1}, {2, -1}, {3, 0}}), "wave");
  drawing.add(Spline::periodic(3, {{0, 0}, {2, 0}, {2, 2}, {0, 2}}), "ring");
  drawing.add({Curve({{5, 0}, {6, 0}}), Curve({{6, 0}, {5.5, 1}, {5, 0}})}, "arch");
  return drawing;
}

TEST(Drawing, KeepsNamesOrderAndClosedness) {
  const Drawing_2<double> drawing = three_curves();
  ASSERT_EQ(drawing.curves().size(), 3u);
  EXPECT_EQ(drawing.curves()[1].name, "ring");
  EXPECT_EQ(drawing.curves()[1].beziers.size(), 4u);
  EXPECT_FALSE(drawing.curves()[0].is_closed);
  EXPECT_TRUE(drawing.curves()[1].is_closed);
  EXPECT_TRUE(drawing.curves()[2].is_closed);
}

TEST(Drawing, KeepsItsCurvesForALoopWhereItHasNoName) {
  static_assert(!std::is_reference_v<decltype(three_curves().curves())>);
  std::string names;
  for (const auto& curve : three_curves().curves()) names += curve.name;
  EXPECT_EQ(names, "waveringarch");
}

TEST(Drawing, TellsKnotParameters) {
  Drawing_2<double> drawing;
  drawing.add(Spline(2, {{0, 0}, {1, 2}, {3, 1}, {4, 4}}, {0, 0, 0, 0.25, 2, 2, 2}));
  EXPECT_EQ(drawing.curves()[0].parameters, std::vector<double>({0, 0.25, 2}));
  EXPECT_EQ(drawing.parameter(0, 0, 0.5), 0.125);
  EXPECT_EQ(drawing.parameter(0, 1, 0), 0.25);
  EXPECT_EQ(drawing.parameter(0, 1, 1), 2);
  EXPECT_EQ(three_curves().parameter(2, 1, 0.25), 1.25);
}

TEST(Drawing, RefusesWhatIsNoChain) {
  Drawing_2<double> drawing;
  EXPECT_THROW(drawing.add({Curve({{0, 0}, {1, 0}}), Curve({{1, 1}, {2, 0}})}), std::invalid_argument);
  EXPECT_THROW(drawing.add(std::vector<Curve>{}), std::invalid_argument);
  EXPECT_THROW(drawing.add({Curve({{0, 0}, {1, 0}})}, "", {0, 1, 2}), std::invalid_argument);
  EXPECT_TRUE(drawing.curves().empty());
}

TEST(Drawing, HasSegmentsThatKnowTheirPlacesAndEnds) {
  const Drawing_2<double> drawing = three_curves();
  const auto spirals = spiral_segments(drawing);
  std::uint32_t curve = 0, bezier = 0;
  double reached = 0;
  for (const auto& s : spirals) {
    const Segment_place& p = s.place();
    if (p.curve != curve || p.bezier != bezier) {
      EXPECT_EQ(reached, 1);
      EXPECT_TRUE(p.curve == curve ? p.bezier == bezier + 1 : p.curve == curve + 1 && p.bezier == 0);
      curve = p.curve;
      bezier = p.bezier;
      reached = 0;
    }
    EXPECT_EQ(s.first(), reached);
    reached = s.last();
    const std::size_t count = drawing.curves()[p.curve].beziers.size();
    const bool is_closed = drawing.curves()[p.curve].is_closed;
    EXPECT_EQ(p.first == Cut_reason::END, !is_closed && p.bezier == 0 && s.first() == 0);
    EXPECT_EQ(p.last == Cut_reason::END, !is_closed && p.bezier + 1 == count && s.last() == 1);
    EXPECT_EQ(p.first == Cut_reason::JOINT || p.first == Cut_reason::END, s.first() == 0);
    EXPECT_EQ(p.last == Cut_reason::JOINT || p.last == Cut_reason::END, s.last() == 1);
  }
  EXPECT_EQ(curve, 2u);
}

TEST(Drawing, HasSegmentsThatEndForAReason) {
  const auto reasons = [](const Curve& c) {
    std::vector<Cut_reason> r;
    for (const auto& s : spiral_segments(c)) r.push_back(s.place().last);
    return r;
  };
  using R = Cut_reason;
  EXPECT_EQ(reasons(Curve({{0, 0}, {1, 2}, {2, 0}})), (std::vector{R::Y, R::END}));  // its vertex, too
  EXPECT_EQ(reasons(Curve({{0, 0}, {2, 1}, {0, 2}})), (std::vector{R::X, R::END}));
  EXPECT_EQ(reasons(Curve({{0, 0}, {1, 1}, {0, 1}, {1, 0}})), (std::vector{R::CUSP, R::END}));
  const auto wave = reasons(Curve({{0, 0}, {1, 3}, {2, 1}, {3, 4}}));
  EXPECT_EQ(std::count(wave.begin(), wave.end(), R::INFLECTION), 1);
  EXPECT_GT(std::count(wave.begin(), wave.end(), R::VERTEX), 0);
}

TEST(Drawing, HasSegmentsWithNeighboursAlongTheCurve) {
  const auto spirals = spiral_segments(three_curves());
  for (std::size_t i = 0; i < spirals.size(); ++i) {
    const auto after = segment_after(spirals, i);
    EXPECT_EQ(after.has_value(), spirals[i].place().last != Cut_reason::END);
    if (!after) continue;
    EXPECT_EQ(segment_before(spirals, *after), i);
    EXPECT_TRUE(spirals[i].point(spirals[i].last()) == spirals[*after].point(spirals[*after].first()));
  }
  EXPECT_EQ(segment_before(spirals, 0), std::nullopt);
}

TEST(Drawing, HasLeavesWithNeighboursAlongTheCurve) {
  for (const Build_options::Nodes kind :
       {Build_options::Nodes::STORED, Build_options::Nodes::LAZY, Build_options::Nodes::EQUALIZED}) {
    const Bca_tree tree(spiral_segments(three_curves()), 1e-3, nodes_of_kind(kind));
    std::size_t leaves = 0, ends = 0;
    tree.for_each_leaf([&](const Node_handle& h) {
      ++leaves;
      const auto next = tree.next_leaf(h);
      if (!next) {
        ++ends;
        return;
      }
      const Region_node n = tree.node(h), m = tree.node(*next);
      EXPECT_TRUE(m.is_leaf);
      EXPECT_TRUE(tree.spirals()[n.spiral].point(n.t1) == tree.spirals()[m.spiral].point(m.t0));
      EXPECT_EQ(tree.place_of(n, n.t1).curve, tree.place_of(m, m.t0).curve);
      const auto back = tree.previous_leaf(*next);
      ASSERT_TRUE(back.has_value());
      const Region_node b = tree.node(*back);
      EXPECT_TRUE(b.spiral == n.spiral && b.t0 == n.t0 && b.t1 == n.t1);
    });
    EXPECT_GT(leaves, 30u);
    EXPECT_EQ(ends, 1u);  // of the wave
  }
}

TEST(Drawing, OfASplineNeedsNoLoop) {
  const Spline ring = Spline::periodic(3, {{0, 0}, {2, 0}, {2, 2}, {0, 2}});
  std::size_t count = 0;
  for (const Curve& piece : ring.bezier_pieces()) count += spiral_segments(piece).size();
  EXPECT_EQ(spiral_segments(ring).size(), count);
}

}  // namespace
}  // namespace test_drawing
