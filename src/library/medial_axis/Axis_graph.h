// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Vertices and edges of the axis from the discs and paths of all parts: discs that are one within rounding become one
// vertex, and where a region was cut only to go on, edges are joined.

#ifndef BOUNDING_ARCS_LIBRARY_MEDIAL_AXIS_AXIS_GRAPH_H
#define BOUNDING_ARCS_LIBRARY_MEDIAL_AXIS_AXIS_GRAPH_H

#include <CGAL/Bounding_arcs_2/medial_axis/Medial_axis_2.h>
#include "Axis_parts.h"
#include "Axis_path.h"
#include "join_edges.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace CGAL::Bounding_arcs::internal {

class Axis_graph {
 public:
  explicit Axis_graph(const Axis_parts& parts)
      : parts_(parts), boundary_(parts.boundary()), joined_(parts.nodes.size()) {
    for (std::size_t i = 0; i < joined_.size(); ++i) joined_[i] = i;
  }

  /// An edge between two nodes, for add. Several threads may ask at once.
  [[nodiscard]] Medial_edge edge(std::size_t from, std::size_t to, const std::vector<Axis_sample>& samples) const {
    Medial_edge edge{from, to, {}};
    edge.samples.reserve(samples.size());
    for (const Axis_sample& s : samples)
      edge.samples.push_back({s.center, s.radius, boundary_.curve_place(s.b), boundary_.curve_place(s.a)});
    return edge;
  }
  void add(Medial_edge edge) {
    // a way of no length between discs of more than three feet; from a point where curves meet one may lead back to it
    if (edge.from != edge.to && is_short(edge) && are_one(parts_.nodes[edge.from], parts_.nodes[edge.to]))
      joined_[root(edge.from)] = root(edge.to);
    else edges_.push_back(std::move(edge));
  }

  void write(Medial_axis_2& axis) {
    for (Medial_edge& e : edges_) e.from = root(e.from), e.to = root(e.to);
    join_at_cuts();
    std::vector<std::size_t> vertex(joined_.size(), NONE);
    const auto vertex_of = [&](std::size_t node) {
      if (vertex[node] == NONE) {
        vertex[node] = axis.vertices.size();
        axis.vertices.push_back({parts_.nodes[node].center, parts_.nodes[node].radius, {}, {}});
      }
      return vertex[node];
    };
    for (Medial_edge& e : edges_) {
      e.from = vertex_of(e.from), e.to = vertex_of(e.to);
      for (const bool is_last : {false, true}) {  // one point, whichever disc of a group the vertex took
        const Medial_vertex& v = axis.vertices[is_last ? e.to : e.from];
        Medial_sample& s = is_last ? e.samples.back() : e.samples.front();
        s.center = v.center, s.radius = v.radius;
      }
      axis.edges.push_back(std::move(e));
    }
    for (std::size_t i = 0; i < joined_.size(); ++i) {
      const std::size_t node = root(i);
      if (parts_.nodes[i].kind == Axis_node_kind::CUT && vertex[node] == NONE) continue;
      add_touches(parts_.nodes[i], axis.vertices[vertex_of(node)]);
    }
  }

 private:
  static constexpr std::size_t NONE = static_cast<std::size_t>(-1);

  [[nodiscard]] std::size_t root(std::size_t i) const {
    while (joined_[i] != i) i = joined_[i];
    return i;
  }
  [[nodiscard]] bool is_close(const Xy<double>& p, const Xy<double>& q) const {
    constexpr double CLOSE = 0x1p-20;  // of the size
    return euclidean_norm(p - q) <= CLOSE * boundary_.size();
  }
  [[nodiscard]] bool is_short(const Medial_edge& edge) const {
    const Xy<double>& from = parts_.nodes[edge.from].center;
    return std::all_of(edge.samples.begin(), edge.samples.end(),
                       [&](const Medial_sample& s) { return is_close(s.center, from); });
  }
  // Each of two discs touches what the other one does, within what centers of discs with close feet may be off by.
  [[nodiscard]] bool are_one(const Axis_node& a, const Axis_node& b) const {
    constexpr double ROUNDING = 128;  // times the resolution
    if (!is_close(a.center, b.center)) return false;
    const auto touches = [&](const Axis_node& disc, const Axis_node& other) {
      return std::all_of(other.touches.begin(), other.touches.end(), [&](const Boundary_place& p) {
        const double d = euclidean_norm(boundary_(p).point - disc.center);
        return std::fabs(d - disc.radius) <= ROUNDING * boundary_.resolution();
      });
    };
    return touches(a, b) && touches(b, a);
  }

  // A cut with two edges is no vertex, unless they are one edge that comes back to it.
  void join_at_cuts() {
    const std::size_t count = joined_.size();
    std::vector<bool> is_cut(count, true);
    for (std::size_t i = 0; i < count; ++i)
      if (parts_.nodes[i].kind != Axis_node_kind::CUT) is_cut[root(i)] = false;
    std::vector<std::vector<std::size_t>> at(count);  // the edges of each node
    for (std::size_t i = 0; i < edges_.size(); ++i) {
      at[edges_[i].from].push_back(i);
      at[edges_[i].to].push_back(i);
    }
    std::vector<bool> is_left(edges_.size(), true);
    for (std::size_t node = 0; node < count; ++node) {
      if (root(node) != node || !is_cut[node] || at[node].size() != 2 || at[node][0] == at[node][1]) continue;
      const std::size_t first = (std::min)(at[node][0], at[node][1]), second = (std::max)(at[node][0], at[node][1]);
      join_edges(node, edges_[first], edges_[second]);
      is_left[second] = false;
      std::vector<std::size_t>& beyond = at[edges_[first].to];
      std::replace(beyond.begin(), beyond.end(), second, first);
    }
    std::size_t left = 0;
    for (std::size_t i = 0; i < edges_.size(); ++i)
      if (is_left[i] && left++ != i) edges_[left - 1] = std::move(edges_[i]);
    edges_.resize(left);
  }

  void add_touches(const Axis_node& node, Medial_vertex& vertex) const {
    const Segment_hierarchy& curves = boundary_.curves();
    const auto point = [&](const Curve_place& p) {
      return curves.evaluator(curves.number_of_bezier(p.curve, p.bezier))(p.t).point;
    };
    for (const Boundary_place& touch : node.touches) {
      const Curve_place place = boundary_.curve_place(touch);
      const bool is_known = std::any_of(vertex.touches.begin(), vertex.touches.end(), [&](const Curve_place& p) {
        return euclidean_norm(point(p) - point(place)) <= 64 * boundary_.resolution();
      });
      if (!is_known) vertex.touches.push_back(place);
    }
  }

  const Axis_parts& parts_;
  const Axis_boundary& boundary_;
  std::vector<std::size_t> joined_;
  std::vector<Medial_edge> edges_;
};

}  // namespace CGAL::Bounding_arcs::internal

#endif
