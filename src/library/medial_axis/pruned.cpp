// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Bodies of medial_axis/pruned.h.

#include <CGAL/Bounding_arcs_2/medial_axis/pruned.h>
#include <CGAL/Bounding_arcs_2/number/expected.h>
#include "../query/Closest_search.h"
#include "../tree/Segment_hierarchy.h"
#include "Axis_editor.h"
#include "Bounding_parts.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <stdexcept>
#include <utility>
#include <vector>

namespace CGAL::Bounding_arcs::internal {

namespace {

// Takes branches away from an axis, the one of least significance first.

class Axis_pruner {
 public:
  Axis_pruner(Medial_axis_2 axis, double significance)
      : editor_(std::move(axis)), most_(significance), lost_(editor_.axis().vertices.size()) {}

  [[nodiscard]] Medial_axis_2 pruned() && {
    for (Branch least = least_branch(); least.leaf != least.base; least = least_branch()) remove(least);
    return std::move(editor_).edited();
  }

 private:
  struct Disc {
    Xy<double> center;
    double radius;
  };
  struct Branch {
    std::size_t leaf, base;
  };

  // How far a branch sticks out of the disc of its base: the most of the leaf's own disc and of all discs that were
  // taken away before it became a leaf.
  [[nodiscard]] double significance(const Branch& of) const {
    const Medial_axis_2::Vertex &v = editor_.axis().vertices[of.leaf], &b = editor_.axis().vertices[of.base];
    double most = euclidean_norm(v.center - b.center) + v.radius - b.radius;
    for (const Disc& d : lost_[of.leaf])
      most = (std::max)(most, euclidean_norm(d.center - b.center) + d.radius - b.radius);
    return most;
  }
  // \return one without a length where none is to go
  [[nodiscard]] Branch least_branch() const {
    Branch best{0, 0};
    double least = most_;
    const auto& edges = editor_.axis().edges;
    for (std::size_t i = 0; i < edges.size(); ++i) {
      const bool is_from = editor_.degree(edges[i].from) == 1, is_to = editor_.degree(edges[i].to) == 1;
      if (!editor_.is_edge_left(i) || is_from == is_to) continue;  // no leaf, or all that is left
      const Branch branch = is_from ? Branch{edges[i].from, edges[i].to} : Branch{edges[i].to, edges[i].from};
      const double s = significance(branch);
      if (s < least) least = s, best = branch;
    }
    return best;
  }
  void remove(const Branch& branch) {
    const Medial_axis_2::Vertex& leaf = editor_.axis().vertices[branch.leaf];
    lost_[branch.base].push_back({leaf.center, leaf.radius});
    add_lost(branch.leaf, branch.base);
    editor_.remove_vertex(branch.leaf);
    // what was lost where two edges are left counts for both of their ends
    if (const auto edge = editor_.pass(branch.base))
      for (const std::size_t end : {editor_.axis().edges[*edge].from, editor_.axis().edges[*edge].to})
        add_lost(branch.base, end);
  }
  void add_lost(std::size_t from, std::size_t to) {
    const std::vector<Disc> lost = lost_[from];
    lost_[to].insert(lost_[to].end(), lost.begin(), lost.end());
  }

  Axis_editor editor_;
  double most_;
  std::vector<std::vector<Disc>> lost_;  // what was taken away at each vertex
};

/// \param curves the parts that discs touch
[[nodiscard]] Medial_axis_2 trimmed(Medial_axis_2 axis, const Segment_hierarchy& curves, double least_angle,
                                    double half_distance) {
  const auto is_apart = [&](const Medial_axis_2::Sample& s) {
    const Xy<double> left = point_at(curves, s.left), right = point_at(curves, s.right), a = left - s.center,
                     b = right - s.center;
    const double angle = std::fabs(std::atan2(cross(a, b), dot(a, b)));
    return angle >= least_angle && euclidean_norm(left - right) >= 2 * half_distance;
  };
  Axis_editor editor(std::move(axis));
  // feet at ends of edges are those of the way there; of the leaf itself any
  const std::vector<std::size_t> moved = editor.shorten([&](const Medial_axis_2::Edge& e, bool is_alone) {
    std::size_t first = 1;
    while (first + 1 < e.samples.size() && !is_apart(e.samples[first])) ++first;
    const bool is_whole =
        first + 1 < e.samples.size() ? first == 1 : is_alone || (first == 1 && is_apart(e.samples[1]));
    return is_whole ? 0 : first;
  });
  for (const std::size_t i : moved) {
    Medial_axis_2::Vertex& v = editor.axis().vertices[i];
    v.clearance = closest_point(curves, v.center)->distance;
    double& error = editor.axis().error;
    error = (std::max)({error, v.clearance.upper - v.radius, v.radius - v.clearance.lower});
  }
  return std::move(editor).edited();
}

}  // namespace

}  // namespace CGAL::Bounding_arcs::internal

namespace CGAL::Bounding_arcs {

Medial_axis_2 pruned(Medial_axis_2 axis, double significance) {
  const internal::Unit unit = internal::unit_of(axis);
  return internal::out(
      unit, internal::Axis_pruner(internal::in(unit, std::move(axis)), unit.tolerance_in(significance)).pruned());
}

Medial_axis_2 trimmed(const Bounding_arc_tree_2& tree, Medial_axis_2 axis, const Medial_axis_2::Feet_apart& apart) {
  constexpr double MOST_ANGLE = 2;
  if (!(apart.angle >= 0 && apart.angle <= MOST_ANGLE))
    throw std::invalid_argument(expected("angle", "a number from 0 to 2", apart.angle));
  if (!(apart.half_distance >= 0))
    throw std::invalid_argument(expected("distance", "a number of at least 0", 2 * apart.half_distance));
  const internal::Unit& unit = tree.unit();
  const auto bounds = internal::bounds_of(axis, tree.in_unit());
  return internal::out(unit, internal::trimmed(internal::in(unit, std::move(axis)), bounds->segments, apart.angle,
                                               unit.tolerance_in(apart.half_distance)));
}

}  // namespace CGAL::Bounding_arcs
