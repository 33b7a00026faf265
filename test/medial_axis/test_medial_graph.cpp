// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// An axis as a graph: what its vertices and edges tell, and paths of Boost's algorithms through it.

#include "query_drawings.h"

#include <CGAL/Bounding_arcs_2.h>
#include <CGAL/Bounding_arcs_2/medial_axis/Medial_graph.h>

#include <boost/graph/connected_components.hpp>

#include <gtest/gtest.h>

#include <cstddef>
#include <random>
#include <vector>

namespace test_medial_graph {
namespace {

using namespace bounding_arcs_test;
using ba::Medial_axis_2;
using ba::Medial_graph;

Medial_axis_2 axis_of(const Drawing& drawing) { return ba::medial_axis(ba::Bounding_arc_tree_2(drawing), 1e-4); }
Drawing square(double r, const Point& center) {
  const Point p[] = {{-r, -r}, {r, -r}, {r, r}, {-r, r}};
  std::vector<Bezier> sides;
  for (std::size_t i = 0; i < 4; ++i) sides.push_back(segment(center + p[i], center + p[(i + 1) % 4]));
  return drawing_of(sides);
}

TEST(MedialGraph, OfASquareHasItsHalfDiagonals) {
  const Medial_graph graph = ba::graph_of(axis_of(square(1, {5, 7})));
  ASSERT_EQ(num_vertices(graph), 5U);
  ASSERT_EQ(num_edges(graph), 4U);
  for (const auto e : boost::make_iterator_range(edges(graph))) {
    EXPECT_NEAR(graph[e].length, std::sqrt(2.0), 1e-12);
    EXPECT_EQ(graph[e].least_clearance, 0);
    EXPECT_NEAR(graph[e].most_clearance, 1, 1e-12);
  }
}

TEST(MedialGraph, HasTheNumbersOfTheAxis) {
  std::mt19937 random(3);
  const Medial_axis_2 axis = axis_of(drawing_of(closed_curve(random, {0, 0}, 7)));
  const Medial_graph graph = ba::graph_of(axis);
  ASSERT_EQ(num_vertices(graph), axis.vertices.size());
  ASSERT_EQ(num_edges(graph), axis.edges.size());
  for (std::size_t v = 0; v < axis.vertices.size(); ++v) {
    EXPECT_EQ(graph[v].point, axis.vertices[v].center);
    EXPECT_EQ(graph[v].clearance, axis.vertices[v].radius);
    EXPECT_EQ(degree(v, graph), axis.degrees()[v]);
  }
  std::vector<int> seen(axis.edges.size(), 0);
  for (const auto e : boost::make_iterator_range(edges(graph))) {
    const ba::Medial_axis_2::Edge& edge = axis.edges[graph[e].index];
    ++seen[graph[e].index];
    EXPECT_EQ(source(e, graph), edge.from);
    EXPECT_EQ(target(e, graph), edge.to);
    for (const ba::Medial_axis_2::Sample& s : edge.samples) {
      EXPECT_LE(graph[e].least_clearance, s.radius);
      EXPECT_GE(graph[e].most_clearance, s.radius);
    }
    EXPECT_GE(graph[e].length, ba::euclidean_norm(edge.samples.back().center - edge.samples.front().center));
  }
  EXPECT_EQ(seen, std::vector<int>(axis.edges.size(), 1));
}

TEST(MedialGraph, HasAComponentForEachRegion) {
  Drawing two = square(1, {0, 0});
  two.add(square(2, {5, 0}).curves().front().beziers);
  const Medial_axis_2 axis = axis_of(two);
  const Medial_graph graph = ba::graph_of(axis);
  std::vector<std::size_t> component(num_vertices(graph));
  EXPECT_EQ(boost::connected_components(graph, component.data()), 2);
  EXPECT_EQ(axis.regions, 2U);
}

}  // namespace
}  // namespace test_medial_graph
