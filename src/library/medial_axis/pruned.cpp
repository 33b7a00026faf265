// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Bodies of medial_axis/pruned.h.

#include <CGAL/Bounding_arcs_2/arc/Arc_2.h>
#include <CGAL/Bounding_arcs_2/medial_axis/Medial_axis_2.h>
#include <CGAL/Bounding_arcs_2/medial_axis/internal/axis_units.h>
#include <CGAL/Bounding_arcs_2/medial_axis/pruned.h>
#include "edit_axis.h"

#include <algorithm>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL::Bounding_arcs::internal {

namespace {

// Takes branches away from an axis, the one of least significance first (medial_axis/pruned.h).

class Axis_pruner {
 public:
  Axis_pruner(Medial_axis_2 axis, double significance)
      : axis_(std::move(axis)), most_(significance), degree_(degrees(axis_)), is_left_(axis_.edges.size(), true),
        lost_(axis_.vertices.size()) {}

  [[nodiscard]] Medial_axis_2 pruned() && {
    while (remove_least()) {
    }
    compact();
    return std::move(axis_);
  }

 private:
  struct Disc {
    Xy<double> center;
    double radius;
  };
  static constexpr std::size_t NONE = static_cast<std::size_t>(-1);

  // How far a branch sticks out of the disc of its base: the most of the leaf's own disc and of all discs that were
  // taken away before it became a leaf.
  [[nodiscard]] double significance(std::size_t leaf, std::size_t base) const {
    const Medial_vertex &v = axis_.vertices[leaf], &b = axis_.vertices[base];
    double most = euclidean_norm(v.center - b.center) + v.radius - b.radius;
    for (const Disc& d : lost_[leaf])
      most = (std::max)(most, euclidean_norm(d.center - b.center) + d.radius - b.radius);
    return most;
  }
  bool remove_least() {
    std::size_t best = NONE;
    double least = most_;
    for (std::size_t i = 0; i < axis_.edges.size(); ++i) {
      if (!is_left_[i]) continue;
      const Medial_edge& e = axis_.edges[i];
      if ((degree_[e.from] == 1) == (degree_[e.to] == 1)) continue;  // no leaf, or all that is left
      const bool is_from = degree_[e.from] == 1;
      const double s = significance(is_from ? e.from : e.to, is_from ? e.to : e.from);
      if (s < least) least = s, best = i;
    }
    if (best == NONE) return false;
    const Medial_edge& e = axis_.edges[best];
    const std::size_t leaf = degree_[e.from] == 1 ? e.from : e.to, base = leaf == e.from ? e.to : e.from;
    lost_[base].push_back({axis_.vertices[leaf].center, axis_.vertices[leaf].radius});
    lost_[base].insert(lost_[base].end(), lost_[leaf].begin(), lost_[leaf].end());
    is_left_[best] = false;
    --degree_[e.from], --degree_[e.to];
    if (degree_[base] == 2) pass(base);
    return true;
  }
  // A vertex that two edges are left of is a sample; what was lost there counts for both of its ends.
  void pass(std::size_t vertex) {
    std::size_t found[2] = {NONE, NONE};
    for (std::size_t i = 0; i < axis_.edges.size(); ++i)
      if (is_left_[i] && (axis_.edges[i].from == vertex || axis_.edges[i].to == vertex))
        found[found[0] == NONE ? 0 : 1] = i;
    if (found[1] == NONE) return;  // an edge that comes back
    Medial_edge &e = axis_.edges[found[0]], &f = axis_.edges[found[1]];
    join_edges(vertex, e, f);
    is_left_[found[1]] = false;
    degree_[vertex] = 0;
    for (const std::size_t end : {e.from, e.to})
      lost_[end].insert(lost_[end].end(), lost_[vertex].begin(), lost_[vertex].end());
  }
  void compact() {
    std::vector<std::size_t> number(axis_.vertices.size(), NONE);
    Medial_axis_2 result = axis_;
    result.vertices.clear();
    result.edges.clear();
    const auto vertex = [&](std::size_t i) {
      if (number[i] == NONE) number[i] = result.vertices.size(), result.vertices.push_back(axis_.vertices[i]);
      return number[i];
    };
    const std::vector<std::size_t> before = degrees(axis_);
    for (std::size_t i = 0; i < axis_.vertices.size(); ++i)
      if (before[i] == 0) (void)vertex(i);  // discs
    for (std::size_t i = 0; i < axis_.edges.size(); ++i) {
      if (!is_left_[i]) continue;
      Medial_edge& e = axis_.edges[i];
      const std::size_t from = vertex(e.from), to = vertex(e.to);
      result.edges.push_back({from, to, std::move(e.samples)});
    }
    axis_ = std::move(result);
  }

  Medial_axis_2 axis_;
  double most_;
  std::vector<std::size_t> degree_;
  std::vector<bool> is_left_;
  std::vector<std::vector<Disc>> lost_;  // what was taken away at each vertex
};

}  // namespace

}  // namespace CGAL::Bounding_arcs::internal

namespace CGAL::Bounding_arcs {

Medial_axis_2 pruned(Medial_axis_2 axis, double significance) {
  const Unit unit = internal::unit_of(axis);
  return internal::out(
      unit, internal::Axis_pruner(internal::in(unit, std::move(axis)), unit.tolerance_in(significance)).pruned());
}

}  // namespace CGAL::Bounding_arcs
