// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// is_valid() of trees, offsets and axes: true of all bundled drawings, false of copies with one thing broken.

#include "query_drawings.h"

#include <CGAL/Bounding_arcs_2.h>
#include <CGAL/Bounding_arcs_2/curve/Curve_file.h>

#include <gtest/gtest.h>

#include <cmath>
#include <cstddef>
#include <limits>
#include <string>
#include <utility>
#include <vector>

namespace test_validity {
namespace {

using namespace bounding_arcs_test;
using Tree = ba::Bounding_arc_tree_2;
using Regions = ba::Region_hierarchy_2<>;

constexpr double NO_NUMBER = std::numeric_limits<double>::quiet_NaN();

Drawing bundled(const std::string& name) { return ba::read_drawing(BOUNDING_ARCS_EXAMPLE_DATA "/" + name + ".json"); }
const std::vector<std::string>& closed_names() {
  static const std::vector<std::string> all{"a_wrench", "b_angelfish", "c_letter_K", "d_rabbit",
                                            "e_cat",    "f_crow",      "g_chipmunk", "h_maple_leaf"};
  return all;
}
// A square with a square hole about its middle.
Drawing frame() {
  Drawing d;
  for (const double r : {3.0, -1.0}) {  // the hole runs clockwise
    const Point p[] = {{-std::fabs(r), -r}, {std::fabs(r), -r}, {std::fabs(r), r}, {-std::fabs(r), r}};
    d.add({segment(p[0], p[1]), segment(p[1], p[2]), segment(p[2], p[3]), segment(p[3], p[0])});
  }
  return d;
}
// Whether a copy is invalid after a change.
template <class Thing, class Change> [[nodiscard]] bool is_broken_by(Thing copy, const Change& change) {
  change(copy);
  return !copy.is_valid();
}

TEST(ValidTree, IsEachOfBundledDrawings) {
  for (const std::string& name : closed_names()) {
    const Drawing drawing = bundled(name);
    EXPECT_TRUE(Tree(drawing).is_valid()) << name;
    for (const ba::Build_options::Nodes kind :
         {ba::Build_options::Nodes::STORED, ba::Build_options::Nodes::LAZY, ba::Build_options::Nodes::EQUALIZED}) {
      ba::Build_options options;
      options.nodes = kind;
      EXPECT_TRUE(Regions(Tree(drawing), 1e-3, options).is_valid()) << name;
    }
  }
  EXPECT_TRUE(Tree(Drawing()).is_valid());
}

TEST(ValidTree, StaysValidWhenSegmentsAreReplaced) {
  Regions regions(Tree(bundled("a_wrench")), 1e-3);
  regions.replace(1, 3, ba::spiral_segments(Bezier({{0, 0}, {1, 2}, {3, -1}, {4, 0}})));
  EXPECT_TRUE(regions.is_valid());
}

TEST(ValidOffset, IsEachOfBundledDrawings) {
  for (const std::string& name : closed_names()) {
    const Tree tree(bundled(name));
    const CGAL::Bbox_2 box = tree.box();
    const double size = box.xmax() - box.xmin();
    const ba::Offset_source_2 source(tree, 1e-5 * size);
    for (const double d : {0.05, 0.01, -0.01, -0.05}) EXPECT_TRUE(source.at(d * size).is_valid()) << name << ' ' << d;
    EXPECT_TRUE(source.outline().is_valid()) << name;
  }
}

TEST(ValidOffset, IsOneOfAnOpenCurve) {
  const Tree tree(Bezier({{0, 0}, {1, 2}, {3, -1}, {4, 0}}));
  ba::Offset::Options options;
  for (const auto side : {ba::Offset::Side::BOTH, ba::Offset::Side::LEFT}) {
    options.side = side;
    EXPECT_TRUE(ba::offset(tree, 0.25, 1e-4, options).is_valid());
  }
}

TEST(ValidOffset, HasChainsThatCloseAndNestAndTellTheirWay) {
  const ba::Offset offset = ba::offset(Tree(frame()), -0.25, 1e-4);
  ASSERT_TRUE(offset.is_valid());
  ASSERT_EQ(offset.chains.size(), 2U);
  const std::size_t hole = offset.chains[0].parent ? 0 : 1;
  const auto first = [](ba::Offset& o) -> ba::Offset::Piece& { return o.chains[0].pieces[0]; };
  EXPECT_TRUE(is_broken_by(offset, [&](auto& o) { first(o).arc.to.x += 0x1p-40; }));
  EXPECT_TRUE(is_broken_by(offset, [&](auto& o) { first(o).arc.from.x += 0x1p-40; }));
  EXPECT_TRUE(is_broken_by(offset, [&](auto& o) { first(o).arc.bulge = 1.5; }));
  EXPECT_TRUE(is_broken_by(offset, [&](auto& o) { first(o).arc.bulge = NO_NUMBER; }));
  EXPECT_TRUE(is_broken_by(offset, [&](auto& o) { first(o).t_end = 1.25; }));
  EXPECT_TRUE(is_broken_by(offset, [&](auto& o) { o.chains[0].pieces.pop_back(); }));
  EXPECT_TRUE(is_broken_by(offset, [&](auto& o) { o.chains[0].pieces.clear(); }));
  EXPECT_TRUE(is_broken_by(offset, [&](auto& o) { o.chains[0].area = -o.chains[0].area; }));
  EXPECT_TRUE(is_broken_by(offset, [&](auto& o) { o.chains[hole].parent = std::nullopt; }));
  EXPECT_TRUE(is_broken_by(offset, [&](auto& o) { o.chains[hole].parent = 2; }));
  EXPECT_TRUE(is_broken_by(offset, [&](auto& o) { o.chains[1 - hole].parent = hole; }));
  EXPECT_TRUE(is_broken_by(offset, [&](auto& o) { std::swap(o.chains[0].pieces, o.chains[1].pieces); }));
  EXPECT_TRUE(is_broken_by(offset, [&](auto& o) { o.error = NO_NUMBER; }));
}

TEST(ValidAxis, IsEachOfBundledDrawings) {
  for (const std::string& name : closed_names()) {
    const Tree tree(bundled(name));
    const CGAL::Bbox_2 box = tree.box();
    const ba::Medial_axis_2 axis = ba::medial_axis(tree, 1e-4 * (box.xmax() - box.xmin()));
    EXPECT_TRUE(axis.is_valid()) << name;
    EXPECT_TRUE(ba::pruned(axis, 1e-2 * (box.xmax() - box.xmin())).is_valid()) << name;
    EXPECT_TRUE(ba::trimmed(tree, axis, {0.5, 0}).is_valid()) << name;
  }
}

// Handles 1e-9 beside their node: a branch that is missing there is told.
TEST(ValidAxis, IsNotCompleteWhereABranchIsMissing) {
  const Point start{0.624, -0.012}, node{-0.189, 0.808}, end{-0.483, -0.054};
  const Drawing path = drawing_of(std::vector<Bezier>{
      Bezier({start, {0.04009349795170325, 2.844971099307739}, {-0.1889999900071896, 0.8080000003791311}, node}),
      Bezier({node, {-0.1890000099928104, 0.807999999620869}, {-0.539, 0.221}, end}), segment(end, start)});
  ba::Medial_axis_2::Options options;
  options.rule = ba::Fill_rule::EVEN_ODD;
  options.is_framed = true;
  EXPECT_TRUE(ba::medial_axis(Tree(ba::framed(path, 0.3)), 1e-3, options).is_valid());
}

TEST(ValidAxis, HasEdgesBetweenItsVerticesAndEulersRelation) {
  const ba::Medial_axis_2 axis = ba::medial_axis(Tree(frame()), 1e-4);
  ASSERT_TRUE(axis.is_valid());
  EXPECT_TRUE(is_broken_by(axis, [](auto& a) { a.edges[0].from = a.vertices.size(); }));
  EXPECT_TRUE(is_broken_by(axis, [](auto& a) { std::swap(a.edges[0].from, a.edges[0].to); }));
  EXPECT_TRUE(is_broken_by(axis, [](auto& a) { a.edges[0].samples.resize(1); }));
  EXPECT_TRUE(is_broken_by(axis, [](auto& a) { a.edges[0].samples.back().center.x += 0x1p-40; }));
  EXPECT_TRUE(is_broken_by(axis, [](auto& a) { a.edges[0].samples[1].radius += 100; }));
  EXPECT_TRUE(is_broken_by(axis, [](auto& a) { a.edges[0].samples[0].left.t = -0.5; }));
  EXPECT_TRUE(is_broken_by(axis, [](auto& a) { a.edges.pop_back(); }));
  EXPECT_TRUE(is_broken_by(axis, [](auto& a) { ++a.holes; }));
  EXPECT_TRUE(is_broken_by(axis, [](auto& a) { a.vertices[0].clearance.lower -= 0x1p-20; }));
  EXPECT_TRUE(is_broken_by(axis, [](auto& a) { a.vertices[0].clearance.upper += 0x1p-20; }));
  EXPECT_TRUE(is_broken_by(axis, [](auto& a) { a.vertices[0].center.x = NO_NUMBER; }));
  EXPECT_TRUE(is_broken_by(axis, [](auto& a) { a.error = -1; }));
}

}  // namespace
}  // namespace test_validity
