// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Bodies of medial_axis/Medial_axis_2.h.

#include <CGAL/Bounding_arcs_2/arc/Arc_2.h>
#include <CGAL/Bounding_arcs_2/medial_axis/Medial_axis_2.h>

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace CGAL::Bounding_arcs {

[[nodiscard]] static bool is_disc(const Xy<double>& center, double radius) {
  return std::isfinite(center.x) && std::isfinite(center.y) && std::isfinite(radius) && radius >= 0;
}
[[nodiscard]] static bool is_on_curve(const Curve_place& p) { return p.t >= 0 && p.t <= 1; }

[[nodiscard]] static bool is_valid(const Medial_axis_2::Vertex& v, double error) {
  return is_disc(v.center, v.radius) && std::all_of(v.touches.begin(), v.touches.end(), is_on_curve) &&
         v.clearance.lower <= v.clearance.upper && v.clearance.upper - v.radius <= error &&
         v.radius - v.clearance.lower <= error;
}

// No disc of an edge lies in the one before or behind it: the axis is of discs in no larger ones.
[[nodiscard]] static bool is_valid(const Medial_axis_2::Edge& e, double eps) {
  for (std::size_t i = 0; i < e.samples.size(); ++i) {
    const Medial_axis_2::Sample& s = e.samples[i];
    if (!is_disc(s.center, s.radius) || !is_on_curve(s.left) || !is_on_curve(s.right)) return false;
    if (i == 0) continue;
    const Medial_axis_2::Sample& before = e.samples[i - 1];
    if (!(std::fabs(s.radius - before.radius) <= euclidean_norm(s.center - before.center) + eps)) return false;
  }
  return e.samples.size() >= 2;
}

bool Medial_axis_2::is_valid() const {
  if (!(eps >= 0) || !(error >= 0)) return false;
  const auto is_sound = [this](const Medial_axis_2::Vertex& v) { return Bounding_arcs::is_valid(v, error); };
  if (!std::all_of(vertices.begin(), vertices.end(), is_sound)) return false;
  for (const Medial_axis_2::Edge& e : edges) {
    if (!Bounding_arcs::is_valid(e, eps) || e.from >= vertices.size() || e.to >= vertices.size()) return false;
    const auto is_at = [](const Medial_axis_2::Sample& s, const Medial_axis_2::Vertex& v) {
      return s.center == v.center && s.radius == v.radius;
    };
    if (!is_at(e.samples.front(), vertices[e.from]) || !is_at(e.samples.back(), vertices[e.to])) return false;
  }
  return status != Medial_axis_2::Status::COMPLETE || vertices.size() + holes == edges.size() + regions;
}

}  // namespace CGAL::Bounding_arcs
