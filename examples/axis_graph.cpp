// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// A medial axis as a graph of Boost's: the shortest way along it from one end to another, and the one with most room.

#include <CGAL/Bounding_arcs_2.h>
#include <CGAL/Bounding_arcs_2/medial_axis/Medial_graph.h>

#include <boost/graph/dijkstra_shortest_paths.hpp>

#include <algorithm>
#include <cstdio>
#include <functional>
#include <vector>

using namespace CGAL::Bounding_arcs;

int main() {
  Drawing_2<double> ring;  // a rectangle with a hole that is nearer to its lower side, and runs the other way
  for (const std::vector<Xy<double>>& p : {std::vector<Xy<double>>{{0, 0}, {9, 0}, {9, 6}, {0, 6}, {0, 0}},
                                           std::vector<Xy<double>>{{2, 4}, {7, 4}, {7, 1}, {2, 1}, {2, 4}}}) {
    std::vector<Bezier_curve_2<double>> sides;
    for (std::size_t i = 0; i < 4; ++i) sides.push_back(Bezier_curve_2<double>({p[i], p[i + 1]}));
    ring.add(sides);
  }
  const Medial_graph graph = graph_of(medial_axis(Bounding_arc_tree_2(ring), 1e-4));
  std::vector<std::size_t> branches;
  for (std::size_t v = 0; v < num_vertices(graph); ++v)
    if (degree(v, graph) > 2) branches.push_back(v);
  const std::size_t from = branches.front(), to = branches.back();
  std::vector<double> length(num_vertices(graph)), room(num_vertices(graph));
  dijkstra_shortest_paths(graph, from,
                          weight_map(get(&Medial_graph::edge_bundled::length, graph)).distance_map(length.data()));
  dijkstra_shortest_paths(graph, from,
                          weight_map(get(&Medial_graph::edge_bundled::least_clearance, graph))
                              .distance_map(room.data())
                              .distance_compare(std::greater<>())
                              .distance_combine([](double a, double b) { return std::min(a, b); })
                              .distance_inf(-1.0)
                              .distance_zero(graph[from].clearance));
  std::printf("shortest: %.4f, widest: room for a disc of radius %.4f\n", length[to], room[to]);
}
