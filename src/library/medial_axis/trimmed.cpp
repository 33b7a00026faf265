// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Bodies of medial_axis/trimmed.h.

#include <CGAL/Bounding_arcs_2/medial_axis/Medial_axis_2.h>
#include <CGAL/Bounding_arcs_2/medial_axis/internal/axis_units.h>
#include <CGAL/Bounding_arcs_2/medial_axis/trimmed.h>
#include <CGAL/Bounding_arcs_2/number/expected.h>
#include "../query/Closest_search.h"
#include "../tree/Segment_hierarchy.h"
#include "Bounding_parts.h"
#include "edit_axis.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <stdexcept>
#include <utility>
#include <vector>

namespace CGAL::Bounding_arcs::internal {

namespace {

// Cuts ends of an axis off whose feet are close together (medial_axis/trimmed.h).

class Axis_trimmer {
 public:
  /// \param curves the parts that discs touch
  Axis_trimmer(Medial_axis_2 axis, const Segment_hierarchy& curves, double angle, double half_distance)
      : axis_(std::move(axis)), curves_(curves), angle_(angle), half_distance_(half_distance),
        is_left_(axis_.edges.size(), true), at_(axis_.vertices.size()), was_cut_(at_.size()),
        is_disc_(at_.size(), true) {
    constexpr double MOST_ANGLE = 2;
    if (!(angle >= 0 && angle <= MOST_ANGLE))
      throw std::invalid_argument(expected("angle", "a number from 0 to 2", angle));
    if (!(half_distance >= 0))
      throw std::invalid_argument(expected("distance", "a number of at least 0", 2 * half_distance));
    for (std::size_t i = 0; i < axis_.edges.size(); ++i)
      for (const std::size_t v : {axis_.edges[i].from, axis_.edges[i].to}) at_[v].push_back(i), is_disc_[v] = false;
  }

  [[nodiscard]] Medial_axis_2 trimmed() && {
    std::vector<std::size_t> leaves;
    for (std::size_t v = 0; v < at_.size(); ++v)
      if (at_[v].size() == 1) leaves.push_back(v);
    while (!leaves.empty()) {
      const std::size_t leaf = leaves.back();
      leaves.pop_back();
      if (at_[leaf].size() != 1) continue;  // its edge is gone
      const std::size_t base = trim(leaf);
      if (base != NONE && at_[base].size() == 1) leaves.push_back(base);
    }
    for (std::size_t v = 0; v < at_.size(); ++v)
      if (at_[v].size() == 2 && was_cut_[v] && at_[v][0] != at_[v][1]) pass(v);
    std::vector<bool> is_vertex_left;
    for (std::size_t v = 0; v < at_.size(); ++v) is_vertex_left.push_back(!at_[v].empty() || is_disc_[v]);
    keep(is_vertex_left, is_left_, axis_);
    return std::move(axis_);
  }

 private:
  static constexpr std::size_t NONE = static_cast<std::size_t>(-1);

  [[nodiscard]] bool is_apart(const Medial_sample& s) const {
    const Xy<double> left = point_at(curves_, s.left), right = point_at(curves_, s.right), a = left - s.center,
                     b = right - s.center;
    const double angle = std::fabs(std::atan2(cross(a, b), dot(a, b)));
    return angle >= angle_ && euclidean_norm(left - right) >= 2 * half_distance_;
  }
  // \return the vertex at the other end of an edge that is gone
  std::size_t trim(std::size_t leaf) {
    const std::size_t i = at_[leaf].front();
    Medial_edge& e = axis_.edges[i];
    if (e.from != leaf) reverse(e);
    // feet at ends of edges are those of the way there; of the leaf itself any
    std::size_t first = 1;
    while (first + 1 < e.samples.size() && !is_apart(e.samples[first])) ++first;
    if (first + 1 == e.samples.size()) {
      const std::size_t base = e.to;
      const bool is_alone = at_[base].size() == 1;
      if (is_alone || (e.samples.size() == 2 && is_apart(e.samples[1]))) return NONE;
      is_left_[i] = false;
      at_[leaf].clear();
      at_[base].erase(std::find(at_[base].begin(), at_[base].end(), i));
      was_cut_[base] = true;
      return base;
    }
    if (first == 1) return NONE;
    e.samples.erase(e.samples.begin(), e.samples.begin() + static_cast<std::ptrdiff_t>(first));
    const Medial_sample& s = e.samples.front();
    Medial_vertex& v = axis_.vertices[leaf];
    v = {s.center, s.radius, {s.left, s.right}, closest_point(curves_, s.center)->distance};
    axis_.error = (std::max)({axis_.error, v.clearance.upper - v.radius, v.radius - v.clearance.lower});
    return NONE;
  }
  // Two edges that are left at a vertex are one.
  void pass(std::size_t vertex) {
    const std::size_t i = at_[vertex][0], k = at_[vertex][1];
    join_edges(vertex, axis_.edges[i], axis_.edges[k]);
    is_left_[k] = false;
    at_[vertex].clear();
    std::vector<std::size_t>& beyond = at_[axis_.edges[i].to];
    std::replace(beyond.begin(), beyond.end(), k, i);
  }
  Medial_axis_2 axis_;
  const Segment_hierarchy& curves_;
  double angle_, half_distance_;
  std::vector<bool> is_left_;
  std::vector<std::vector<std::size_t>> at_;  // the edges of each vertex
  std::vector<bool> was_cut_, is_disc_;       // an edge of it is gone; it never had one
};

}  // namespace

}  // namespace CGAL::Bounding_arcs::internal

namespace CGAL::Bounding_arcs {

Medial_axis_2 trimmed(const Bounding_arc_tree_2& tree, Medial_axis_2 axis, const Feet_apart& apart) {
  const Unit& unit = tree.unit();
  const auto bounds = internal::bounds_of(axis, tree.in_unit());
  return internal::out(unit, internal::Axis_trimmer(internal::in(unit, std::move(axis)), bounds->segments, apart.angle,
                                                    unit.tolerance_in(apart.half_distance))
                                 .trimmed());
}

}  // namespace CGAL::Bounding_arcs
