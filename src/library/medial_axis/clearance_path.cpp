// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Bodies of medial_axis/clearance_path.h.

#include <CGAL/Bounding_arcs_2/medial_axis/clearance_path.h>
#include <CGAL/Bounding_arcs_2/medial_axis/internal/axis_units.h>
#include "../query/query_units.h"
#include "../tree/Segment_hierarchy.h"
#include "Axis_roads.h"
#include "Bounding_parts.h"

#include <algorithm>
#include <cstddef>
#include <optional>

namespace CGAL::Bounding_arcs::internal {

[[nodiscard]] static std::optional<Clearance_path> clearance_path(const Segment_hierarchy& curves,
                                                                  const Medial_axis_2& axis, const Xy<double>& from,
                                                                  const Xy<double>& to) {
  const auto start = way_to_axis(curves, axis, from), stop = way_to_axis(curves, axis, to);
  if (!start || !stop) return std::nullopt;
  const auto between = Axis_roads(axis, start->place, stop->place)
                           .widest(start->stations.front().clearance, stop->stations.front().clearance);
  if (!between) return std::nullopt;
  Clearance_path path;
  path.stations = start->stations;
  path.stations.insert(path.stations.end(), between->begin(), between->end());
  path.stations.insert(path.stations.end(), stop->stations.rbegin(), stop->stations.rend());
  path.bottleneck = path.stations.front().clearance;
  for (std::size_t i = 0; i < path.stations.size(); ++i) {
    path.bottleneck = (std::min)(path.bottleneck, path.stations[i].clearance);
    if (i > 0) path.length += euclidean_norm(path.stations[i].point - path.stations[i - 1].point);
  }
  return path;
}

}  // namespace CGAL::Bounding_arcs::internal

namespace CGAL::Bounding_arcs {

std::optional<Clearance_path> clearance_path(const Bounding_arc_tree_2& tree, const Medial_axis_2& axis,
                                             const Asked_point& from, const Asked_point& to) {
  const Unit& unit = tree.unit();
  auto path = internal::clearance_path(internal::bounds_of(axis, tree.in_unit())->segments, internal::in(unit, axis),
                                       point_in(unit, from.point), point_in(unit, to.point));
  if (!path || unit.is_one()) return path;
  for (Clearance_path::Station& s : path->stations) s.point = unit.out(s.point), s.clearance = unit.out(s.clearance);
  path->bottleneck = unit.out(path->bottleneck);
  path->length = unit.out(path->length);
  return path;
}

}  // namespace CGAL::Bounding_arcs
