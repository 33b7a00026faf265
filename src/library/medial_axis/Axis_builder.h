// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The medial axis of a boundary: leaves and holes first, then vertices until all parts have two discs, then edges.

#ifndef BOUNDING_ARCS_LIBRARY_MEDIAL_AXIS_AXIS_BUILDER_H
#define BOUNDING_ARCS_LIBRARY_MEDIAL_AXIS_AXIS_BUILDER_H

#include <CGAL/Bounding_arcs_2/medial_axis/Medial_axis_2.h>
#include <CGAL/Bounding_arcs_2/medial_axis/internal/Axis_job.h>
#include "Axis_graph.h"
#include "Axis_path.h"
#include "Branch_finder.h"
#include "order_by_place.h"
#include "start_axis_parts.h"

#include <cstddef>
#include <cstdint>
#include <optional>
#include <utility>
#include <vector>

namespace CGAL::Bounding_arcs::internal {

class Axis_builder {
 public:
  /// \param is_joining whether vertices are asked at once what else their discs touch within rounding
  Axis_builder(const Axis_boundary& boundary, double eps, bool is_joining, Index_loop loop)
      : boundary_(boundary), parts_(boundary), eps_(eps), is_joining_(is_joining), loop_(loop) {}

  [[nodiscard]] Medial_axis_2 build() {
    Medial_axis_2 axis;
    const Axis_start start(parts_, loop_);
    unresolved_ = start.unresolved();
    for (const Boundary_ring& ring : boundary_.rings()) axis.regions += ring.is_outer ? 1U : 0U;
    axis.holes = boundary_.rings().size() - axis.regions;
    split_all();
    Axis_graph graph(parts_);
    add_paths(graph);
    graph.write(axis);
    if (!unresolved_.empty()) axis.status = Medial_axis_status::UNRESOLVED;
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
      const std::vector<std::uint32_t> order = order_by_place(
          left.size(), [&](std::uint32_t i) { return place_of(left[i]); }, boundary_.size());
      loop_(left.size(), [&](std::size_t k) {
        const std::uint32_t i = order[k];
        branches[i] = Branch_finder(parts_, left[i], is_joining_).find();
      });
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
    std::vector<Medial_edge> edges(parts_.parts.size());
    std::vector<char> has_failed(edges.size(), 0);
    const std::vector<std::uint32_t> order = order_by_place(
        edges.size(), [&](std::uint32_t i) { return place_of(i); }, boundary_.size());
    loop_over_ranges(loop_, edges.size(), [&](std::size_t begin, std::size_t end) {
      for (; begin < end; ++begin) {
        const std::uint32_t i = order[begin];
        const std::vector<std::uint32_t>& nodes = parts_.parts[i].nodes;
        if (nodes.size() != 2) continue;
        Axis_path path(parts_, i, eps_);
        edges[i] = graph.edge(nodes[1], nodes[0], path.samples());
        has_failed[i] = path.has_failed() ? 1 : 0;
      }
    });
    for (std::uint32_t i = 0; i < edges.size(); ++i) {
      if (has_failed[i] != 0) unresolved_.push_back(place_of(i));
      else if (!edges[i].samples.empty()) graph.add(std::move(edges[i]));
    }
  }
  [[nodiscard]] Xy<double> place_of(std::uint32_t part) const {
    const std::vector<std::uint32_t>& nodes = parts_.parts[part].nodes;
    return nodes.empty() ? Xy<double>{0, 0} : parts_.nodes[nodes.front()].center;
  }
  [[nodiscard]] bool can_split(std::uint32_t part, const Axis_branch& branch) const {
    for (std::size_t k = 0; k < branch.arcs.size(); ++k)
      if (!parts_.is_on(parts_.arcs[parts_.parts[part].arcs[branch.arcs[k]]], branch.feet[k])) return false;
    return true;
  }
  // A part with a vertex becomes as many as that has arcs: the number of the part is kept by the last one.
  void split(std::uint32_t part, const Axis_branch& branch) {
    const auto node = static_cast<std::uint32_t>(parts_.nodes.size());
    parts_.nodes.push_back({Axis_node_kind::BRANCH, branch.center, branch.radius, branch.feet});
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
