// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The medial axis of a boundary: leaves and holes first, then vertices until all parts have two discs, then edges.

#ifndef CGAL_BOUNDING_ARCS_2_MEDIAL_AXIS_INTERNAL_AXIS_BUILDER_H
#define CGAL_BOUNDING_ARCS_2_MEDIAL_AXIS_INTERNAL_AXIS_BUILDER_H

#include <CGAL/Bounding_arcs_2/medial_axis/Medial_axis_2.h>
#include <CGAL/Bounding_arcs_2/medial_axis/internal/Axis_graph.h>
#include <CGAL/Bounding_arcs_2/medial_axis/internal/Axis_path.h>
#include <CGAL/Bounding_arcs_2/medial_axis/internal/Branch_finder.h>
#include <CGAL/Bounding_arcs_2/medial_axis/internal/start_axis_parts.h>

#include <cstddef>
#include <cstdint>
#include <vector>

namespace CGAL::Bounding_arcs::internal {

class Axis_builder {
 public:
  /// \param is_joining whether vertices are asked at once what else their discs touch within rounding
  Axis_builder(const Axis_boundary& boundary, double eps, bool is_joining)
      : boundary_(boundary), parts_(boundary), eps_(eps), is_joining_(is_joining) {}

  [[nodiscard]] Medial_axis_2 build() {
    Medial_axis_2 axis;
    const Axis_start start(parts_);
    bool is_complete = start.is_complete();
    for (const Axis_part& part : parts_.parts) axis.regions += part.arcs.empty() ? 0U : 1U;
    axis.holes = boundary_.rings().size() - axis.regions;
    struct Path {
      std::uint32_t from, to;
      std::vector<Axis_sample> samples;
    };
    std::vector<Path> paths;
    for (std::uint32_t i = 0; i < parts_.parts.size(); ++i) {
      for (;;) {
        const Axis_part& part = parts_.parts[i];
        if (part.nodes.size() < 3) break;
        const auto branch = Branch_finder(parts_, i, is_joining_).find();
        is_complete = is_complete && branch && can_split(i, *branch);
        if (!branch || !can_split(i, *branch)) break;
        split(i, *branch);
      }
      const Axis_part& part = parts_.parts[i];
      if (part.nodes.size() == 1) is_complete = false;
      if (part.nodes.size() != 2) continue;
      Axis_path path(parts_, i, eps_);
      paths.push_back({part.nodes[1], part.nodes[0], path.samples()});
      is_complete = is_complete && !path.has_failed();
    }
    Axis_graph graph(parts_);
    for (const Path& p : paths) graph.add(p.from, p.to, p.samples);
    graph.write(axis);
    if (!is_complete) axis.status = Medial_axis_status::UNRESOLVED;
    return axis;
  }

 private:
  [[nodiscard]] bool can_split(std::uint32_t part, const Axis_branch& branch) const {
    for (std::size_t k = 0; k < branch.arcs.size(); ++k)
      if (!parts_.is_on(parts_.arcs[parts_.parts[part].arcs[branch.arcs[k]]], branch.feet[k])) return false;
    return true;
  }
  // A part with a vertex becomes as many as that has arcs: the number of the part is kept by the last one.
  void split(std::uint32_t part, const Axis_branch& branch) {
    const auto node = static_cast<std::uint32_t>(parts_.nodes.size());
    parts_.nodes.push_back({Axis_node_kind::BRANCH, branch.centre, branch.radius, branch.feet});
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
};

}  // namespace CGAL::Bounding_arcs::internal

#endif
