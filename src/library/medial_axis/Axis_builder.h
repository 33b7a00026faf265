// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The medial axis of a boundary: leaves and holes first, then vertices until all parts have two discs, then edges.

#ifndef BOUNDING_ARCS_LIBRARY_MEDIAL_AXIS_AXIS_BUILDER_H
#define BOUNDING_ARCS_LIBRARY_MEDIAL_AXIS_AXIS_BUILDER_H

#include <CGAL/Bounding_arcs_2/medial_axis/Medial_axis_2.h>
#include <CGAL/Bounding_arcs_2/medial_axis/medial_axis.h>
#include "Axis_editor.h"
#include "Axis_parts.h"
#include "Axis_path.h"
#include "Bounding_parts.h"
#include "Branch_finder.h"
#include "start_axis_parts.h"

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Spatial_sort_traits_adapter_2.h>
#include <CGAL/hilbert_sort.h>
#include <CGAL/property_map.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <utility>
#include <vector>

namespace CGAL::Bounding_arcs::internal {

/// Calls work(i) for i = 0, ..., count - 1 in the order of a curve that fills the plane: what lies side by side is
/// looked at in turn, while it is in the processor's cache.
/// \param at_once how many follow each other in one thread
/// \param place Xy<double>(std::size_t i), where work i is
template <class Place_of, class Work>
void for_each_by_place(Index_loop loop, std::size_t at_once, std::size_t count, const Place_of& place,
                       const Work& work) {
  using Kernel = CGAL::Simple_cartesian<double>;
  using Points = CGAL::Pointer_property_map<Kernel::Point_2>::type;
  std::vector<Kernel::Point_2> points;
  std::vector<std::size_t> order(count);
  for (std::size_t i = 0; i < count; ++i) {
    const Xy<double> p = place(i);
    points.emplace_back(p.x, p.y);
    order[i] = i;
  }
  CGAL::hilbert_sort(order.begin(), order.end(),
                     CGAL::Spatial_sort_traits_adapter_2<Kernel, Points>(CGAL::make_property_map(points)));
  for_each_in_turn(loop, at_once, count, [&](std::size_t i) { work(order[i]); });
}

// Vertices and edges of the axis from the discs and paths of all parts: discs that are one within rounding become one
// vertex, and where a region was cut only to go on, edges are joined.

class Axis_graph {
 public:
  explicit Axis_graph(const Axis_parts& parts)
      : parts_(parts), boundary_(parts.boundary()), joined_(parts.nodes.size()) {
    for (std::size_t i = 0; i < joined_.size(); ++i) joined_[i] = i;
  }

  /// An edge between two nodes, for add. Several threads may ask at once.
  [[nodiscard]] Medial_axis_2::Edge edge(std::size_t from, std::size_t to,
                                         const std::vector<Axis_sample>& samples) const {
    Medial_axis_2::Edge edge{from, to, {}};
    edge.samples.reserve(samples.size());
    for (const Axis_sample& s : samples) edge.samples.push_back({s.center, told(s.radius), told(s.b), told(s.a)});
    return edge;
  }
  void add(Medial_axis_2::Edge edge) {
    // a way of no length between discs of more than three feet; from a point where curves meet one may lead back to it
    if (edge.from != edge.to && is_short(edge) && are_one(parts_.nodes[edge.from], parts_.nodes[edge.to]))
      joined_[root(edge.from)] = root(edge.to);
    else edges_.push_back(std::move(edge));
  }

  /// Adds vertices and edges to an axis.
  void write(Medial_axis_2& axis) && {
    const std::size_t count = joined_.size();
    std::vector<std::size_t> groups;  // roots of discs that are one
    std::vector<bool> is_cut(count, true);
    for (const Axis_node& node : parts_.nodes)
      axis.vertices.push_back({node.disc.center, told(node.disc.radius), {}, {}});
    for (std::size_t i = 0; i < count; ++i) {
      Medial_axis_2::Vertex& vertex = axis.vertices[root(i)];
      add_touches(parts_.nodes[i], vertex);
      if (parts_.nodes[i].kind != Axis_node_kind::CUT) is_cut[root(i)] = false;
      if (root(i) != i) groups.push_back(root(i));
    }
    std::sort(groups.begin(), groups.end());
    groups.erase(std::unique(groups.begin(), groups.end()), groups.end());
    for (const std::size_t i : groups) center(axis.vertices[i]);
    for (Medial_axis_2::Edge& e : edges_) {
      e.from = root(e.from), e.to = root(e.to);
      for (const bool is_last : {false, true}) {  // one point, whichever disc of a group the vertex took
        const Medial_axis_2::Vertex& v = axis.vertices[is_last ? e.to : e.from];
        Medial_axis_2::Sample& s = is_last ? e.samples.back() : e.samples.front();
        s.center = v.center, s.radius = v.radius;
      }
    }
    axis.edges = std::move(edges_);
    Axis_editor editor(std::move(axis));
    for (std::size_t i = 0; i < count; ++i) {
      if (is_cut[i]) editor.pass(i);  // no vertex, unless one edge comes back to it
      if (root(i) != i || (is_cut[i] && editor.degree(i) == 0)) editor.remove_vertex(i);
    }
    axis = std::move(editor).edited();
  }

 private:
  // Where curves meet, a radius is 0 but for rounding.
  [[nodiscard]] double told(double radius) const { return radius < 0 && radius > -boundary_.resolution() ? 0 : radius; }
  // Parameters along a reversed side are negative, which makes -0 of 0.
  [[nodiscard]] Curve_place told(const Boundary_place& p) const {
    Curve_place place = boundary_.curve_place(p);
    place.t += 0.0;
    return place;
  }
  [[nodiscard]] std::size_t root(std::size_t i) const {
    while (joined_[i] != i) i = joined_[i];
    return i;
  }
  [[nodiscard]] bool is_close(const Xy<double>& p, const Xy<double>& q) const {
    constexpr double CLOSE = 0x1p-20;  // of the size
    return euclidean_norm(p - q) <= CLOSE * boundary_.size();
  }
  [[nodiscard]] bool is_short(const Medial_axis_2::Edge& edge) const {
    const Xy<double>& from = parts_.nodes[edge.from].disc.center;
    return std::all_of(edge.samples.begin(), edge.samples.end(),
                       [&](const Medial_axis_2::Sample& s) { return is_close(s.center, from); });
  }
  // Each of two discs touches what the other one does, within what centers of discs with close feet may be off by.
  [[nodiscard]] bool are_one(const Axis_node& a, const Axis_node& b) const {
    constexpr double ROUNDING = 32;  // times the resolution
    if (!is_close(a.disc.center, b.disc.center)) return false;
    const auto touches = [&](const Axis_node& disc, const Axis_node& other) {
      const auto is_touched = [&](const Boundary_place& p) {
        return disc.disc.gap(boundary_(p).point) <= ROUNDING * boundary_.resolution();
      };
      if (!std::all_of(other.touches.begin(), other.touches.end(), is_touched)) return false;
      if (other.kind != Axis_node_kind::LEAF) return true;
      // a leaf touches all between its touches
      const std::uint32_t last = other.touches.back().element;
      for (std::uint32_t e = other.touches.front().element; e != last; e = boundary_.after(e))
        if (!is_touched({e, boundary_.element(e).last})) return false;
      return true;
    };
    return touches(a, b) && touches(b, a);
  }

  void add_touches(const Axis_node& node, Medial_axis_2::Vertex& vertex) const {
    const auto point = [&](const Curve_place& p) { return point_at(boundary_.curves(), p); };
    for (const Boundary_place& touch : node.touches) {
      const Curve_place place = told(touch);
      const bool is_known = std::any_of(vertex.touches.begin(), vertex.touches.end(), [&](const Curve_place& p) {
        return euclidean_norm(point(p) - point(place)) <= 64 * boundary_.resolution();
      });
      if (!is_known) vertex.touches.push_back(place);
    }
  }

  // A disc of close feet is off by far more than rounding at the far ones: that through three touches that are far
  // apart is taken where it misses all touches by less.
  void center(Medial_axis_2::Vertex& vertex) const {
    constexpr std::size_t FEET = 3;
    if (vertex.touches.size() < FEET) return;
    std::vector<Xy<double>> points;
    for (const Curve_place& p : vertex.touches) points.push_back(point_at(boundary_.curves(), p));
    const auto farthest = [&](const auto& far) {
      return *std::max_element(points.begin(), points.end(),
                               [&](const Xy<double>& p, const Xy<double>& q) { return far(p) < far(q); });
    };
    const Xy<double> a = points.front(), b = farthest([&](const Xy<double>&p) { return euclidean_norm(p - a); }),
                     c = farthest([&](const Xy<double>&p) { return std::fabs(cross(p - a, b - a)); }), u = b - a,
                     v = c - a;
    const double twice = 2 * cross(u, v);
    if (twice == 0) return;
    const Xy<double> way = (-1 / twice) * perp(dot(u, u) * v - dot(v, v) * u);
    const Touching_disc disc{a + way, euclidean_norm(way)};
    if (most_gap(disc, points) < most_gap({vertex.center, vertex.radius}, points))
      vertex.center = disc.center, vertex.radius = disc.radius;
  }

  const Axis_parts& parts_;
  const Axis_boundary& boundary_;
  std::vector<std::size_t> joined_;
  std::vector<Medial_axis_2::Edge> edges_;
};

class Axis_builder {
 public:
  /// \param is_joining whether vertices are asked at once what else their discs touch within rounding
  Axis_builder(const Axis_boundary& boundary, double eps, bool is_joining, Index_loop loop)
      : boundary_(boundary), parts_(boundary), eps_(eps), is_joining_(is_joining), loop_(loop) {}

  [[nodiscard]] Medial_axis_2 build() {
    Medial_axis_2 axis;
    const Axis_start start(parts_, loop_);
    unresolved_ = start.unresolved();
    axis.moved = start.moved() + boundary_.hidden_height();
    for (const Boundary_ring& ring : boundary_.rings()) axis.regions += ring.is_outer ? 1U : 0U;
    axis.holes = boundary_.rings().size() - axis.regions;
    split_all();
    Axis_graph graph(parts_);
    add_paths(graph);
    std::move(graph).write(axis);
    if (!unresolved_.empty()) axis.status = Medial_axis_2::Status::UNRESOLVED;
    axis.unresolved = std::move(unresolved_);
    return axis;
  }

 private:
  // Cuts parts until all have two discs. Vertices of many parts are found side by side, then cuts are made in order.
  void split_all() {
    const auto is_left = [&](std::uint32_t i) { return parts_.parts[i].nodes.size() > 2; };
    std::vector<std::uint32_t> left;
    for (std::uint32_t i = 0; i < parts_.parts.size(); ++i) {
      if (is_left(i)) left.push_back(i);
      if (parts_.parts[i].nodes.size() == 1) unresolved_.push_back(place_of(i));
    }
    while (!left.empty()) {
      std::vector<std::optional<Axis_branch>> branches(left.size());
      for_each_by_place(
          loop_, 1, left.size(), [&](std::size_t i) { return place_of(left[i]); },
          [&](std::size_t i) { branches[i] = Branch_finder(parts_, left[i], is_joining_).find(); });
      std::vector<std::uint32_t> next;
      for (std::size_t i = 0; i < left.size(); ++i) {
        if (!branches[i] || !can_split(left[i], *branches[i])) {
          unresolved_.push_back(place_of(left[i]));
          continue;
        }
        const auto end = static_cast<std::uint32_t>(parts_.parts.size());
        split(left[i], *branches[i]);
        if (is_left(left[i])) next.push_back(left[i]);
        for (auto k = end; k < parts_.parts.size(); ++k)
          if (is_left(k)) next.push_back(k);
      }
      left = std::move(next);
    }
  }
  // The edges of all parts with two discs, which do not depend on each other.
  void add_paths(Axis_graph& graph) {
    std::vector<Medial_axis_2::Edge> edges(parts_.parts.size());
    std::vector<char> has_failed(edges.size(), 0);
    for_each_by_place(
        loop_, RANGE_SIZE, edges.size(), [&](std::size_t i) { return place_of(static_cast<std::uint32_t>(i)); },
        [&](std::size_t i) {
          const std::vector<std::uint32_t>& nodes = parts_.parts[i].nodes;
          if (nodes.size() != 2) return;
          Axis_path path(parts_, static_cast<std::uint32_t>(i), eps_);
          edges[i] = graph.edge(nodes[1], nodes[0], path.samples());
          has_failed[i] = path.has_failed() ? 1 : 0;
        });
    for (std::uint32_t i = 0; i < edges.size(); ++i) {
      if (has_failed[i] != 0) unresolved_.push_back(place_of(i));
      else if (!edges[i].samples.empty()) graph.add(std::move(edges[i]));
    }
  }
  [[nodiscard]] Xy<double> place_of(std::uint32_t part) const {
    const std::vector<std::uint32_t>& nodes = parts_.parts[part].nodes;
    return nodes.empty() ? Xy<double>{0, 0} : parts_.nodes[nodes.front()].disc.center;
  }
  [[nodiscard]] bool can_split(std::uint32_t part, const Axis_branch& branch) const {
    for (std::size_t k = 0; k < branch.arcs.size(); ++k)
      if (!parts_.is_on(parts_.arcs[parts_.parts[part].arcs[branch.arcs[k]]], branch.feet[k])) return false;
    return true;
  }
  // A part with a vertex becomes as many as that has arcs: the number of the part is kept by the last one.
  void split(std::uint32_t part, const Axis_branch& branch) {
    const auto node = static_cast<std::uint32_t>(parts_.nodes.size());
    parts_.nodes.push_back({Axis_node_kind::BRANCH, branch.disc, branch.feet});
    const Axis_part all = parts_.parts[part];
    const std::size_t n = all.arcs.size(), count = branch.arcs.size();
    std::vector<std::uint32_t> behind;
    for (std::size_t k = 0; k < count; ++k) behind.push_back(parts_.split(all.arcs[branch.arcs[k]], branch.feet[k]));
    for (std::size_t k = 0; k < count; ++k) {
      const std::size_t from = branch.arcs[k], to = branch.arcs[(k + 1) % count];
      Axis_part result;
      result.arcs.push_back(behind[k]);
      for (std::size_t i = from; i != to; i = (i + 1) % n) {
        result.nodes.push_back(all.nodes[i]);
        result.arcs.push_back(all.arcs[(i + 1) % n]);
      }
      result.nodes.push_back(node);
      const auto number = k + 1 == count ? part : static_cast<std::uint32_t>(parts_.parts.size());
      if (k + 1 == count) parts_.parts[part] = result;
      else parts_.parts.push_back(result);
      parts_.number(number);
    }
  }

  const Axis_boundary& boundary_;
  Axis_parts parts_;
  double eps_;
  bool is_joining_;
  Index_loop loop_;
  std::vector<Xy<double>> unresolved_;
};

}  // namespace CGAL::Bounding_arcs::internal

#endif
