// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// A medial axis as a graph of the Boost Graph Library, whose algorithms it is for: paths, components, spanning trees.

#ifndef CGAL_BOUNDING_ARCS_2_MEDIAL_AXIS_MEDIAL_GRAPH_H
#define CGAL_BOUNDING_ARCS_2_MEDIAL_AXIS_MEDIAL_GRAPH_H

#include <CGAL/Bounding_arcs_2/arc/Arc_2.h>
#include <CGAL/Bounding_arcs_2/medial_axis/Medial_axis_2.h>

#include <boost/graph/adjacency_list.hpp>

#include <algorithm>
#include <cstddef>
#include <vector>

namespace CGAL::Bounding_arcs::internal {

/// A vertex of the axis, under its own number there.
struct Medial_graph_vertex {
  Xy<double> point;      ///< the center of its disc
  double clearance = 0;  ///< the radius
};

/// An edge of the axis.
struct Medial_graph_edge {
  std::size_t index = 0;       ///< in Medial_axis_2::edges
  double length = 0;           ///< of the straight lines between its samples
  double least_clearance = 0;  ///< of its samples
  double most_clearance = 0;   ///< of its samples
};

}  // namespace CGAL::Bounding_arcs::internal

namespace CGAL::Bounding_arcs {

/// Vertex i is vertex i of the axis. Two vertices may have several edges between them, and an edge may be a loop.
/// graph[vertex] has `point` and `clearance`, graph[edge] `index`, `length`, `least_clearance` and `most_clearance`.
/// Their types are Medial_graph::vertex_bundled and Medial_graph::edge_bundled, as Boost names them.
using Medial_graph = boost::adjacency_list<boost::vecS, boost::vecS, boost::undirectedS, internal::Medial_graph_vertex,
                                           internal::Medial_graph_edge>;

/// Returns the graph of an axis.
/// \pre axis.is_valid()
/// \complexity linear in the samples
[[nodiscard]] inline Medial_graph graph_of(const Medial_axis_2& axis) {
  Medial_graph graph(axis.vertices.size());
  for (std::size_t i = 0; i < axis.vertices.size(); ++i) graph[i] = {axis.vertices[i].center, axis.vertices[i].radius};
  for (std::size_t i = 0; i < axis.edges.size(); ++i) {
    const std::vector<Medial_axis_2::Sample>& samples = axis.edges[i].samples;
    Medial_graph::edge_bundled edge{i, 0, samples.front().radius, samples.front().radius};
    for (std::size_t k = 1; k < samples.size(); ++k) {
      edge.length += euclidean_norm(samples[k].center - samples[k - 1].center);
      edge.least_clearance = (std::min)(edge.least_clearance, samples[k].radius);
      edge.most_clearance = (std::max)(edge.most_clearance, samples[k].radius);
    }
    boost::add_edge(axis.edges[i].from, axis.edges[i].to, edge, graph);
  }
  return graph;
}

}  // namespace CGAL::Bounding_arcs

#endif
