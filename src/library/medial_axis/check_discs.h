// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// What is checked of an axis that is made.

#ifndef BOUNDING_ARCS_LIBRARY_MEDIAL_AXIS_CHECK_DISCS_H
#define BOUNDING_ARCS_LIBRARY_MEDIAL_AXIS_CHECK_DISCS_H

#include <CGAL/Bounding_arcs_2/medial_axis/Medial_axis_2.h>
#include <CGAL/Bounding_arcs_2/medial_axis/internal/Axis_job.h>
#include "../query/Closest_search.h"
#include "Axis_boundary.h"
#include "order_by_place.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace CGAL::Bounding_arcs::internal {

// Leaves wrong vertices and edges out, and tells where they were.
inline void leave_out(const std::vector<char>& is_wrong_vertex, std::vector<char> is_wrong_edge, Medial_axis_2& axis) {
  constexpr auto NONE = static_cast<std::size_t>(-1);
  for (std::size_t i = 0; i < axis.edges.size(); ++i) {
    const Medial_edge& e = axis.edges[i];
    if (is_wrong_edge[i] != 0) axis.unresolved.push_back(e.samples[e.samples.size() / 2].center);
    if (is_wrong_vertex[e.from] != 0 || is_wrong_vertex[e.to] != 0) is_wrong_edge[i] = 1;
  }
  std::vector<std::size_t> number(axis.vertices.size(), NONE);
  std::size_t vertices = 0, edges = 0;
  for (std::size_t i = 0; i < axis.vertices.size(); ++i) {
    if (is_wrong_vertex[i] != 0) {
      axis.unresolved.push_back(axis.vertices[i].center);
      continue;
    }
    number[i] = vertices;
    if (vertices++ != i) axis.vertices[number[i]] = std::move(axis.vertices[i]);
  }
  axis.vertices.resize(vertices);
  for (std::size_t i = 0; i < axis.edges.size(); ++i) {
    if (is_wrong_edge[i] != 0) continue;
    if (edges != i) axis.edges[edges] = std::move(axis.edges[i]);
    Medial_edge& e = axis.edges[edges++];
    e.from = number[e.from], e.to = number[e.to];
  }
  axis.edges.resize(edges);
  if (!axis.unresolved.empty()) axis.status = Medial_axis_status::UNRESOLVED;
}

// Where a disc nearly touches a whole arc, places of the samples beside it are of rounding. Those within a sixteenth of
// eps of the next one are not needed, and are left out where their discs have a curve in them.
template <class Is_empty>
void leave_samples_out(const Is_empty& is_empty, double eps, std::vector<Medial_sample>& samples) {
  const auto is_near = [&](const Medial_sample& a, const Medial_sample& b) {
    return euclidean_norm(a.center - b.center) <= eps / 16;
  };
  std::size_t kept = 1;
  for (std::size_t i = 1; i < samples.size(); ++i) {
    const bool is_needed = i + 1 == samples.size() ||
                           !(is_near(samples[i], samples[kept - 1]) || is_near(samples[i], samples[i + 1])) ||
                           is_empty(samples[i].center, samples[i].radius);
    if (is_needed) samples[kept++] = samples[i];
  }
  samples.resize(kept);
}

// Whether a sample is far from the chord of those beside it, as places of rounding are.
[[nodiscard]] inline bool is_outlier(const std::vector<Medial_sample>& samples, std::size_t i, double eps) {
  if (i == 0 || i + 1 == samples.size()) return false;
  constexpr double FAR = 16;  // times eps; a chord over two parts is off by four times as much as one over each
  const Xy<double> a = samples[i - 1].center, way = samples[i + 1].center - a, to = samples[i].center - a;
  const double square = dot(way, way), t = square > 0 ? std::clamp(dot(to, way) / square, 0.0, 1.0) : 0;
  return euclidean_norm(to - t * way) > FAR * eps;
}

// Brackets of all vertices. Where a disc of one of these, or of any of many samples, has a curve in it, it is left out:
// what rounding may have made of decisions would be seen there. The first and the last ones of an edge are the
// vertices.
inline void check_discs(const Segment_hierarchy& curves, const Axis_boundary& boundary, Index_loop loop,
                        Medial_axis_2& axis) {
  constexpr double ROUNDING = 64;  // times the resolution
  const auto is_empty = [&](const Xy<double>& center, double radius) {
    Closest_search search(curves, center, radius - ROUNDING * boundary.resolution());
    search.search();
    return !search.result().has_value();
  };
  std::vector<char> is_wrong_edge(axis.edges.size(), 0), is_wrong_vertex(axis.vertices.size(), 0);
  const std::vector<std::uint32_t> edges = order_by_place(
      axis.edges.size(), [&](std::uint32_t i) { return axis.edges[i].samples.front().center; }, boundary.size());
  loop_over_ranges(loop, axis.edges.size(), [&](std::size_t begin, std::size_t end) {
    constexpr std::size_t STEP = 8;
    for (; begin < end; ++begin) {
      std::vector<Medial_sample>& samples = axis.edges[edges[begin]].samples;
      leave_samples_out(is_empty, axis.eps, samples);
      char& is_wrong = is_wrong_edge[edges[begin]];
      for (std::size_t i = 1; i + 1 < samples.size() && is_wrong == 0; ++i) {
        const bool is_looked_at = i == 1 || i + 2 == samples.size() || i % STEP == samples.size() / 2 % STEP ||
                                  is_outlier(samples, i, axis.eps);
        if (is_looked_at && !is_empty(samples[i].center, samples[i].radius)) is_wrong = 1;
      }
    }
  });
  const std::vector<std::uint32_t> vertices = order_by_place(
      axis.vertices.size(), [&](std::uint32_t i) { return axis.vertices[i].center; }, boundary.size());
  loop_over_ranges(loop, axis.vertices.size(), [&](std::size_t begin, std::size_t end) {
    for (; begin < end; ++begin) {
      Medial_vertex& v = axis.vertices[vertices[begin]];
      const auto closest =
          v.touches.empty() ? closest_point(curves, v.center) : closest_point(curves, v.center, v.touches.front());
      v.clearance = closest->distance;
      const bool is_known_empty = v.clearance.lower >= v.radius - ROUNDING * boundary.resolution();
      if (!is_known_empty && !is_empty(v.center, v.radius)) is_wrong_vertex[vertices[begin]] = 1;
    }
  });
  leave_out(is_wrong_vertex, is_wrong_edge, axis);
  for (const Medial_vertex& v : axis.vertices)
    axis.error = (std::max)({axis.error, v.clearance.upper - v.radius, v.radius - v.clearance.lower});
}

/// The most by which a vertex's disc misses one of its touches, or its center's distance from all curves.
[[nodiscard]] inline double most_miss(const Segment_hierarchy& curves, const Medial_axis_2& axis) {
  double most = axis.error;
  for (const Medial_vertex& v : axis.vertices)
    for (const Curve_place& p : v.touches) {
      const Xy<double> point = curves.evaluator(curves.number_of_bezier(p.curve, p.bezier))(p.t).point;
      most = (std::max)(most, std::fabs(euclidean_norm(point - v.center) - v.radius));
    }
  return most;
}

}  // namespace CGAL::Bounding_arcs::internal

#endif
