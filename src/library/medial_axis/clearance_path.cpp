// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The path with the most room between two points (medial_axis/medial_axis.h).

#include <CGAL/Bounding_arcs_2/medial_axis/Medial_graph.h>
#include <CGAL/Bounding_arcs_2/medial_axis/medial_axis.h>
#include "../query/Closest_search.h"
#include "../query/query_units.h"
#include "../tree/Segment_hierarchy.h"
#include "Axis_editor.h"
#include "Bounding_parts.h"

#include <boost/graph/dijkstra_shortest_paths.hpp>
#include <boost/graph/filtered_graph.hpp>

#include <algorithm>
#include <cstddef>
#include <functional>
#include <limits>
#include <optional>
#include <utility>
#include <vector>

namespace CGAL::Bounding_arcs::internal {

namespace {

// The axis as a network of roads: edges with their least radius and their length, cut at the two places where a path
// comes to it and leaves it.

/// A place between two samples of an edge, by a share of the way from the first one.
struct Axis_place {
  std::size_t edge, first;
  double share;
};

struct Way_to_axis {
  std::vector<Medial_axis_2::Path::Station> stations;  ///< the point, and the center of the disc that it grows to
  Axis_place place;                                    ///< next to that
};
/// The way from a point straight away from the nearest place of the curves, until the disc that touches there is
/// maximal.
/// \return nothing where the axis is not in it
[[nodiscard]] std::optional<Way_to_axis> way_to_axis(const Segment_hierarchy& curves, const Medial_axis_2& axis,
                                                     const Xy<double>& from) {
  if (curves.empty()) return std::nullopt;
  const Closest_point<> nearest = *closest_point(curves, from);
  const Xy<double> way = from - nearest.point;
  const double distance = euclidean_norm(way);
  const CGAL::Bbox_2& box = curves.boxes().box();
  double low = distance, high = (box.xmax() - box.xmin()) + (box.ymax() - box.ymin());
  const double room = 0x1p-30 * high;  // of the radius; the disc may have that much of a curve in it
  Xy<double> center = from;
  constexpr int MOST_STEPS = 60;
  for (int step = 0; step < MOST_STEPS && distance > 0 && high - low > room; ++step) {
    const double r = low + (high - low) / 2;
    const Xy<double> c = nearest.point + (r / distance) * way;
    if (closest_point(curves, c)->distance.upper < r - room) high = r;
    else low = r, center = c;
  }
  std::optional<Axis_place> best;
  double least = low;
  for (std::size_t i = 0; i < axis.edges.size(); ++i)
    for (std::size_t k = 0; k + 1 < axis.edges[i].samples.size(); ++k) {
      const Xy<double>& p = axis.edges[i].samples[k].center;
      const Xy<double> step = axis.edges[i].samples[k + 1].center - p;
      const double square = dot(step, step),
                   share = square > 0 ? std::clamp(dot(center - p, step) / square, 0.0, 1.0) : 0;
      const double d = euclidean_norm(p + share * step - center);
      if (d < least) least = d, best = Axis_place{i, k, share};
    }
  if (!best) return std::nullopt;
  return Way_to_axis{{{from, nearest.distance.lower}, {center, low}}, *best};
}

/// The axis with two places more as vertices, and paths between these.
class Axis_roads {
 public:
  Axis_roads(const Medial_axis_2& axis, const Axis_place& from, const Axis_place& to)
      : axis_(axis), start_(axis.vertices.size()), stop_(start_ + 1) {
    axis_.vertices.resize(start_ + 2);
    const bool is_turned =
        from.edge == to.edge && (to.first < from.first || (to.first == from.first && to.share < from.share));
    // the later one first, which leaves the earlier one where it is
    if (is_turned) cut(from, start_);
    cut(to, stop_);
    if (!is_turned) cut(from, start_);
    graph_ = graph_of(axis_);
  }

  /// Returns the widest way from one place to the other one, for what is no wider than given at both ends.
  [[nodiscard]] std::optional<std::vector<Medial_axis_2::Path::Station>> widest(double start, double stop) const {
    const double width = widest_between();
    if (!(width >= 0)) return std::nullopt;
    return shortest((std::min)({width, start, stop}));
  }

 private:
  using Road = Medial_graph::edge_descriptor;

  // Makes a vertex of a place, which ends one edge and starts another.
  void cut(const Axis_place& p, std::size_t vertex) {
    Medial_axis_2::Edge& edge = axis_.edges[p.edge];
    const Medial_axis_2::Sample &a = edge.samples[p.first], &b = edge.samples[p.first + 1];
    Medial_axis_2::Sample s = a;
    s.center = a.center + p.share * (b.center - a.center);
    s.radius = a.radius + p.share * (b.radius - a.radius);
    axis_.vertices[vertex].center = s.center;
    axis_.vertices[vertex].radius = s.radius;
    const auto behind = edge.samples.begin() + static_cast<std::ptrdiff_t>(p.first + 1);
    Medial_axis_2::Edge rest{vertex, edge.to, {s}};
    rest.samples.insert(rest.samples.end(), behind, edge.samples.end());
    edge.samples.erase(behind, edge.samples.end());
    edge.samples.push_back(s);
    edge.to = vertex;
    axis_.edges.push_back(std::move(rest));
  }
  // The largest width of which roads connect both places: ways of the largest least width. -1 where none do.
  [[nodiscard]] double widest_between() const {
    std::vector<double> width(axis_.vertices.size());
    const auto least = [](double a, double b) { return (std::min)(a, b); };
    boost::dijkstra_shortest_paths(graph_, start_,
                                   boost::weight_map(boost::get(&Medial_graph::edge_bundled::least_clearance, graph_))
                                       .distance_map(width.data())
                                       .distance_compare(std::greater<double>())
                                       .distance_combine(least)
                                       .distance_inf(-1.0)
                                       .distance_zero(std::numeric_limits<double>::infinity()));
    return width[stop_];
  }
  struct Is_wide_enough {
    const Medial_graph* graph = nullptr;
    double width = 0;
    bool operator()(const Road& r) const { return (*graph)[r].least_clearance >= width; }
  };
  // Returns the shortest way along roads that are wide enough.
  [[nodiscard]] std::vector<Medial_axis_2::Path::Station> shortest(double width) const {
    const boost::filtered_graph<Medial_graph, Is_wide_enough> wide(graph_, {&graph_, width});
    std::vector<Road> by(axis_.vertices.size());
    const auto notes_roads = boost::record_edge_predecessors(by.data(), boost::on_edge_relaxed());
    boost::dijkstra_shortest_paths(wide, start_,
                                   boost::weight_map(boost::get(&Medial_graph::edge_bundled::length, wide))
                                       .visitor(boost::make_dijkstra_visitor(notes_roads)));
    std::vector<Medial_axis_2::Path::Station> stations;  // backwards
    for (std::size_t v = stop_; v != start_;) {
      const Medial_axis_2::Edge& edge = axis_.edges[graph_[by[v]].index];
      const bool is_forward = edge.to == v;
      for (std::size_t k = 0; k < edge.samples.size(); ++k) {
        const Medial_axis_2::Sample& s = edge.samples[is_forward ? edge.samples.size() - 1 - k : k];
        stations.push_back({s.center, s.radius});
      }
      v = is_forward ? edge.from : edge.to;
    }
    std::reverse(stations.begin(), stations.end());
    return stations;
  }

  Medial_axis_2 axis_;  // with two vertices more
  std::size_t start_, stop_;
  Medial_graph graph_;
};

}  // namespace

[[nodiscard]] static std::optional<Medial_axis_2::Path> clearance_path(const Segment_hierarchy& curves,
                                                                       const Medial_axis_2& axis,
                                                                       const Xy<double>& from, const Xy<double>& to) {
  const auto start = way_to_axis(curves, axis, from), stop = way_to_axis(curves, axis, to);
  if (!start || !stop) return std::nullopt;
  const auto between = Axis_roads(axis, start->place, stop->place)
                           .widest(start->stations.front().clearance, stop->stations.front().clearance);
  if (!between) return std::nullopt;
  Medial_axis_2::Path path;
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

std::optional<Medial_axis_2::Path> clearance_path(const Bounding_arc_tree_2& tree, const Medial_axis_2& axis,
                                                  const Asked_point& from, const Asked_point& to) {
  const internal::Unit& unit = tree.unit();
  auto path = internal::clearance_path(internal::bounds_of(axis, tree.in_unit())->segments, internal::in(unit, axis),
                                       point_in(unit, from.point), point_in(unit, to.point));
  if (!path) return path;
  for (Medial_axis_2::Path::Station& s : path->stations)
    s.point = unit.out(s.point), s.clearance = unit.out(s.clearance);
  path->bottleneck = unit.out(path->bottleneck);
  path->length = unit.out(path->length);
  return path;
}

}  // namespace CGAL::Bounding_arcs
