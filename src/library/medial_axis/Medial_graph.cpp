// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Bodies of medial_axis/Medial_graph.h.

#include <CGAL/Bounding_arcs_2/arc/Arc_2.h>
#include <CGAL/Bounding_arcs_2/medial_axis/Medial_graph.h>

#include <algorithm>
#include <cstddef>

namespace CGAL::Bounding_arcs {

[[nodiscard]] static Medial_graph_edge edge_of(const Medial_axis_2& axis, std::size_t i) {
  const std::vector<Medial_sample>& samples = axis.edges[i].samples;
  Medial_graph_edge edge{i, 0, samples.front().radius, samples.front().radius};
  for (std::size_t k = 1; k < samples.size(); ++k) {
    edge.length += euclidean_norm(samples[k].center - samples[k - 1].center);
    edge.least_clearance = (std::min)(edge.least_clearance, samples[k].radius);
    edge.most_clearance = (std::max)(edge.most_clearance, samples[k].radius);
  }
  return edge;
}

Medial_graph graph_of(const Medial_axis_2& axis) {
  Medial_graph graph(axis.vertices.size());
  for (std::size_t i = 0; i < axis.vertices.size(); ++i) graph[i] = {axis.vertices[i].center, axis.vertices[i].radius};
  for (std::size_t i = 0; i < axis.edges.size(); ++i)
    boost::add_edge(axis.edges[i].from, axis.edges[i].to, edge_of(axis, i), graph);
  return graph;
}

}  // namespace CGAL::Bounding_arcs
