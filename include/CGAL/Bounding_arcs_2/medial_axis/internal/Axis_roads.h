// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The axis as a network of roads: edges with their least radius and their length, cut at the two places where a path
// comes to it and leaves it.

#ifndef CGAL_BOUNDING_ARCS_2_MEDIAL_AXIS_INTERNAL_AXIS_ROADS_H
#define CGAL_BOUNDING_ARCS_2_MEDIAL_AXIS_INTERNAL_AXIS_ROADS_H

#include <CGAL/Bounding_arcs_2/medial_axis/Medial_axis_2.h>
#include <CGAL/Bounding_arcs_2/query/Closest_search.h>

#include <algorithm>
#include <cstddef>
#include <functional>
#include <limits>
#include <numeric>
#include <optional>
#include <queue>
#include <utility>
#include <vector>

namespace CGAL::Bounding_arcs::internal {

/// A place between two samples of an edge, by a share of the way from the first one.
struct Axis_place {
  std::size_t edge, first;
  double share;
};

struct Way_to_axis {
  std::vector<Clearance_path::Station> stations;  ///< the point, and the centre of the disc that it grows to
  Axis_place place;                               ///< next to that
};
/// The way from a point straight away from the nearest place of the curves, until the disc that touches there is
/// maximal.
/// \return nothing where the axis is not in it
[[nodiscard]] inline std::optional<Way_to_axis> way_to_axis(const Segment_hierarchy& curves, const Medial_axis_2& axis,
                                                            const Xy<double>& from) {
  if (curves.empty()) return std::nullopt;
  const Closest_point<> nearest = *closest_point(curves, from);
  const Xy<double> way = from - nearest.point;
  const double distance = euclidean_norm(way);
  const CGAL::Bbox_2& box = curves.boxes().box();
  double low = distance, high = (box.xmax() - box.xmin()) + (box.ymax() - box.ymin());
  const double room = 0x1p-30 * high;  // of the radius; the disc may have that much of a curve in it
  Xy<double> centre = from;
  constexpr int MOST_STEPS = 60;
  for (int step = 0; step < MOST_STEPS && distance > 0 && high - low > room; ++step) {
    const double r = low + (high - low) / 2;
    const Xy<double> c = nearest.point + (r / distance) * way;
    if (closest_point(curves, c)->distance.upper < r - room) high = r;
    else low = r, centre = c;
  }
  std::optional<Axis_place> best;
  double least = low;
  for (std::size_t i = 0; i < axis.edges.size(); ++i)
    for (std::size_t k = 0; k + 1 < axis.edges[i].samples.size(); ++k) {
      const Xy<double>& p = axis.edges[i].samples[k].centre;
      const Xy<double> step = axis.edges[i].samples[k + 1].centre - p;
      const double square = dot(step, step),
                   share = square > 0 ? std::clamp(dot(centre - p, step) / square, 0.0, 1.0) : 0;
      const double d = euclidean_norm(p + share * step - centre);
      if (d < least) least = d, best = Axis_place{i, k, share};
    }
  if (!best) return std::nullopt;
  return Way_to_axis{{{from, nearest.distance.lower}, {centre, low}}, *best};
}

class Axis_roads {
 public:
  Axis_roads(const Medial_axis_2& axis, const Axis_place& from, const Axis_place& to)
      : axis_(axis), count_(axis.vertices.size() + 2), start_(count_ - 2), stop_(count_ - 1) {
    const bool is_turned =
        from.edge == to.edge && (to.first < from.first || (to.first == from.first && to.share < from.share));
    // the later one first, which does not move the earlier one
    const std::size_t a = is_turned ? insert(from) : NONE, b = insert(to), c = is_turned ? a : insert(from);
    const bool are_on_one = from.edge == to.edge;
    const std::size_t sample_from = c + (is_turned ? 1 : 0), sample_to = b + (are_on_one && !is_turned ? 1 : 0);
    for (std::size_t i = 0; i < axis_.edges.size(); ++i) {
      std::vector<Cut> cuts{{0, axis_.edges[i].from}};
      if (from.edge == i) cuts.push_back({sample_from, start_});
      if (to.edge == i) cuts.push_back({sample_to, stop_});
      if (are_on_one && from.edge == i && is_turned) std::swap(cuts[1], cuts[2]);
      cuts.push_back({axis_.edges[i].samples.size() - 1, axis_.edges[i].to});
      add_roads(i, cuts);
    }
  }

  /// Returns the widest way from one place to the other one, for what is no wider than given at both ends.
  [[nodiscard]] std::optional<std::vector<Clearance_path::Station>> widest(double start, double stop) const {
    const double width = widest_between();
    if (!(width >= 0)) return std::nullopt;
    return shortest((std::min)({width, start, stop}));
  }

 private:
  static constexpr std::size_t NONE = static_cast<std::size_t>(-1);
  struct Road {
    std::size_t from, to, edge, first, last;  // samples
    double width, length;
  };

  struct Cut {
    std::size_t sample, vertex;
  };
  // A sample at a place. \return its number
  std::size_t insert(const Axis_place& p) {
    std::vector<Medial_sample>& samples = axis_.edges[p.edge].samples;
    const Medial_sample &a = samples[p.first], &b = samples[p.first + 1];
    Medial_sample s = a;
    s.centre = a.centre + p.share * (b.centre - a.centre);
    s.radius = a.radius + p.share * (b.radius - a.radius);
    samples.insert(samples.begin() + static_cast<std::ptrdiff_t>(p.first + 1), s);
    return p.first + 1;
  }
  void add_roads(std::size_t i, const std::vector<Cut>& cuts) {
    const Medial_edge& e = axis_.edges[i];
    for (std::size_t k = 1; k < cuts.size(); ++k) {
      Road road{cuts[k - 1].vertex, cuts[k].vertex, i, cuts[k - 1].sample, cuts[k].sample, 0, 0};
      road.width = e.samples[road.first].radius;
      for (std::size_t s = road.first + 1; s <= road.last; ++s) {
        road.width = (std::min)(road.width, e.samples[s].radius);
        road.length += euclidean_norm(e.samples[s].centre - e.samples[s - 1].centre);
      }
      roads_.push_back(road);
    }
  }
  // The largest width of which roads connect both places: the widest are added first. -1 where none do.
  [[nodiscard]] double widest_between() const {
    std::vector<std::size_t> order(roads_.size()), parent(count_);
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::iota(parent.begin(), parent.end(), std::size_t{0});
    std::sort(order.begin(), order.end(),
              [&](std::size_t x, std::size_t y) { return roads_[x].width > roads_[y].width; });
    const auto root = [&](std::size_t v) {
      while (parent[v] != v) v = parent[v] = parent[parent[v]];
      return v;
    };
    for (const std::size_t r : order) {
      parent[root(roads_[r].from)] = root(roads_[r].to);
      if (root(start_) == root(stop_)) return roads_[r].width;
    }
    return -1;
  }
  // The shortest way along roads that are wide enough (Dijkstra).
  [[nodiscard]] std::vector<Clearance_path::Station> shortest(double width) const {
    std::vector<std::vector<std::size_t>> at(count_);
    for (std::size_t r = 0; r < roads_.size(); ++r)
      if (roads_[r].width >= width)
        for (const std::size_t v : {roads_[r].from, roads_[r].to}) at[v].push_back(r);
    std::vector<double> distance(count_, std::numeric_limits<double>::infinity());
    std::vector<std::size_t> by(count_, NONE);
    using Entry = std::pair<double, std::size_t>;
    std::priority_queue<Entry, std::vector<Entry>, std::greater<>> queue;
    distance[start_] = 0;
    queue.push({0, start_});
    while (!queue.empty()) {
      const auto [d, v] = queue.top();
      queue.pop();
      if (d > distance[v]) continue;
      for (const std::size_t r : at[v]) {
        const std::size_t w = roads_[r].from == v ? roads_[r].to : roads_[r].from;
        if (!(d + roads_[r].length < distance[w])) continue;
        distance[w] = d + roads_[r].length;
        by[w] = r;
        queue.push({distance[w], w});
      }
    }
    std::vector<Clearance_path::Station> stations;  // backwards
    for (std::size_t v = stop_; v != start_;) {
      const Road& road = roads_[by[v]];
      const std::vector<Medial_sample>& samples = axis_.edges[road.edge].samples;
      const bool is_forward = road.to == v;
      for (std::size_t k = 0; k <= road.last - road.first; ++k) {
        const Medial_sample& s = samples[is_forward ? road.last - k : road.first + k];
        stations.push_back({s.centre, s.radius});
      }
      v = is_forward ? road.from : road.to;
    }
    std::reverse(stations.begin(), stations.end());
    return stations;
  }

  Medial_axis_2 axis_;  // with two samples more
  std::size_t count_, start_, stop_;
  std::vector<Road> roads_;
};

}  // namespace CGAL::Bounding_arcs::internal

#endif
