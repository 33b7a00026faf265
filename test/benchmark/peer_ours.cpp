// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "peer.h"

#include <CGAL/Bounding_arcs_2/medial_axis/medial_axis.h>
#include <CGAL/Bounding_arcs_2/query/closest_point.h>
#include <CGAL/Bounding_arcs_2/query/distance.h>
#include <CGAL/Bounding_arcs_2/query/intersections.h>
#include <CGAL/Bounding_arcs_2/tree/Bounding_arc_tree_2.h>

#include <algorithm>
#include <memory>
#include <utility>

namespace bounding_arcs_benchmark {
namespace {

using Indices = std::vector<ba::Bounding_arc_tree_2>;

ba::Bezier_curve_2<double> curve_of(const Cubic_points& points) {
  return ba::Bezier_curve_2<double>(std::vector<Point>(points.begin(), points.end()));
}

template <class Found> double count(const Found& found) {
  for (const auto& p : found.points)
    if (p.kind == ba::Intersection_kind::UNDECIDED) return NO_ANSWER;
  return static_cast<double>(found.points.size() + found.overlaps.size());
}

/// The upper end of a bracket that is as narrow as was asked.
double certain(const ba::Bracket& d, double tolerance) { return d.upper - d.lower <= tolerance ? d.upper : NO_ANSWER; }

/// The radius of the largest disc, with everything from control points to the axis.
double axis_radius(const Chain& chain) {
  ba::Drawing_2<double> drawing;
  drawing.add(chain);
  const ba::Medial_axis_2 axis = ba::medial_axis(ba::Bounding_arc_tree_2(std::move(drawing)), 1e-6);
  if (axis.status != ba::Medial_axis_2::Status::COMPLETE) return NO_ANSWER;
  double largest = 0;
  for (const auto& v : axis.vertices) largest = (std::max)(largest, v.radius);
  for (const auto& e : axis.edges)
    for (const auto& s : e.samples) largest = (std::max)(largest, s.radius);
  return largest;
}

}  // namespace

Peers our_peers(const Peer_cases& cases) {
  const auto indices = std::make_shared<Indices>();
  for (const Chain& chain : cases.curves) {
    ba::Drawing_2<double> drawing;
    drawing.add(chain);
    indices->emplace_back(std::move(drawing));
  }
  constexpr double OF_CLOSEST = 1e-12, OF_DISTANCE = 1e-12, OF_HAUSDORFF = 1e-9;
  const std::string name = "Bounding Arcs";
  return {{name, CLOSEST,
           [=, &cases](std::size_t i) {
             const auto& c = cases.closest[i];
             return certain(ba::closest_point((*indices)[c.curve], c.point)->distance, OF_CLOSEST);
           }},
          {name, CUBICS,
           [&cases](std::size_t i) {
             return count(intersections(curve_of(cases.cubics[i].a), curve_of(cases.cubics[i].b)));
           }},
          {name, CURVES,
           [=, &cases](std::size_t i) {
             const auto& c = cases.crossing[i];
             return count(ba::intersections((*indices)[c.a], (*indices)[c.b]));
           }},
          {name, DISTANCE,
           [=, &cases](std::size_t i) {
             const auto& c = cases.apart[i];
             const auto found = ba::distance((*indices)[c.a], (*indices)[c.b], OF_DISTANCE);
             return certain(found->distance, OF_DISTANCE);
           }},
          {name, HAUSDORFF,
           [=, &cases](std::size_t i) {
             const auto& c = cases.crossing[i];
             return certain(ba::hausdorff_distance((*indices)[c.a], (*indices)[c.b], OF_HAUSDORFF)->distance,
                            OF_HAUSDORFF);
           }},
          {name, AXIS, [&cases](std::size_t i) { return axis_radius(cases.curves[i]); }}};
}

}  // namespace bounding_arcs_benchmark
