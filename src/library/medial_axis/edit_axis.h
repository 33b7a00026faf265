// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Edges of an axis that meet in a vertex as one, and vertices and edges left out.

#ifndef BOUNDING_ARCS_LIBRARY_MEDIAL_AXIS_EDIT_AXIS_H
#define BOUNDING_ARCS_LIBRARY_MEDIAL_AXIS_EDIT_AXIS_H

#include <CGAL/Bounding_arcs_2/medial_axis/Medial_axis_2.h>

#include <algorithm>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL::Bounding_arcs::internal {

inline void reverse(Medial_edge& e) {
  std::reverse(e.samples.begin(), e.samples.end());
  for (Medial_sample& s : e.samples) std::swap(s.left, s.right);
  std::swap(e.from, e.to);
}
/// Appends to e what goes on from a vertex along f, which is of no use any more.
inline void join_edges(std::size_t vertex, Medial_edge& e, Medial_edge& f) {
  if (e.to != vertex) reverse(e);
  if (f.from != vertex) reverse(f);
  e.samples.insert(e.samples.end(), f.samples.begin() + 1, f.samples.end());
  e.to = f.to;
}

/// Leaves out what is not kept; vertices and edges that are stay in order.
inline void keep(const std::vector<bool>& is_vertex_kept, const std::vector<bool>& is_edge_kept, Medial_axis_2& axis) {
  std::vector<std::size_t> number(axis.vertices.size());
  std::size_t vertices = 0, edges = 0;
  for (std::size_t i = 0; i < axis.vertices.size(); ++i) {
    if (!is_vertex_kept[i]) continue;
    number[i] = vertices;
    if (vertices++ != i) axis.vertices[number[i]] = std::move(axis.vertices[i]);
  }
  axis.vertices.resize(vertices);
  for (std::size_t i = 0; i < axis.edges.size(); ++i) {
    if (!is_edge_kept[i]) continue;
    if (edges != i) axis.edges[edges] = std::move(axis.edges[i]);
    Medial_edge& e = axis.edges[edges++];
    e.from = number[e.from], e.to = number[e.to];
  }
  axis.edges.resize(edges);
}

}  // namespace CGAL::Bounding_arcs::internal

#endif
