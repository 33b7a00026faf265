// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The axis as a network of roads: edges with their least radius and their length, cut at the two places where a path
// comes to it and leaves it.

#ifndef CGAL_BOUNDING_ARCS_2_INTERNAL_MEDIAL_AXIS_AXIS_ROADS_H
#define CGAL_BOUNDING_ARCS_2_INTERNAL_MEDIAL_AXIS_AXIS_ROADS_H

#include <CGAL/Bounding_arcs_2/medial_axis/Medial_axis_2.h>
#include <CGAL/Bounding_arcs_2/query/closest_point.h>

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

/// A sample of an edge; of an axis without edges a vertex.
struct Axis_place {
  std::size_t edge, sample;
};

template <class Stations> struct Way_to_axis {
  Stations stations;  ///< the point, and the centre of the disc that it grows to
  Axis_place place;   ///< a sample in that disc
};
/// From a point straight away from the nearest place of the curves, until the disc that touches there is maximal.
/// \return nothing where that has no sample of the axis in it
template <class Stations>
[[nodiscard]] std::optional<Way_to_axis<Stations>> way_to_axis(const Curve_index_2& index, const Medial_axis_2& axis,
                                                               const Xy<double>& from) {
  if (index.empty()) return std::nullopt;
  const Closest_point nearest = *closest_point(index, from);
  const Xy<double> way = from - nearest.point;
  const double distance = euclidean_norm(way);
  const CGAL::Bbox_2& box = index.boxes().box();
  double low = distance, high = (box.xmax() - box.xmin()) + (box.ymax() - box.ymin());
  const double room = 0x1p-30 * high;  // of the radius; the disc may have that much of a curve in it
  Xy<double> centre = from;
  constexpr int MOST_STEPS = 60;
  for (int step = 0; step < MOST_STEPS && distance > 0 && high - low > room; ++step) {
    const double r = low + (high - low) / 2;
    const Xy<double> c = nearest.point + (r / distance) * way;
    if (closest_point(index, c)->distance.upper < r - room) high = r;
    else low = r, centre = c;
  }
  // the nearest sample, which may be beside it by a step of the axis
  std::optional<Axis_place> best;
  double least = std::numeric_limits<double>::infinity();
  const auto look_at = [&](std::size_t edge, std::size_t sample, const Xy<double>& c, double radius) {
    const double d = euclidean_norm(c - centre);
    if (d < least && d < (std::max)(low, radius)) least = d, best = Axis_place{edge, sample};
  };
  for (std::size_t i = 0; i < axis.edges.size(); ++i)
    for (std::size_t k = 0; k < axis.edges[i].samples.size(); ++k)
      look_at(i, k, axis.edges[i].samples[k].centre, axis.edges[i].samples[k].radius);
  if (!best) return std::nullopt;
  return Way_to_axis<Stations>{{{from, nearest.distance.lower}, {centre, low}}, *best};
}

class Axis_roads {
 public:
  explicit Axis_roads(const Medial_axis_2& axis) : axis_(axis), count_(axis.vertices.size()) {}

  /// From one sample to another one, where discs at both ends are as small as given.
  template <class Stations>
  [[nodiscard]] std::optional<Stations> widest(const Axis_place& from, const Axis_place& to, double start,
                                               double stop) {
    const std::size_t a = count_++, b = count_++;
    for (std::size_t i = 0; i < axis_.edges.size(); ++i) add_roads(i, from, a, to, b);
    const double bottleneck = (std::min)({widest_between(a, b), start, stop});
    if (!(bottleneck >= 0)) return std::nullopt;
    return shortest<Stations>(a, b, bottleneck);
  }

 private:
  static constexpr std::size_t NONE = static_cast<std::size_t>(-1);
  struct Road {
    std::size_t from, to, edge, first, last;  // samples
    double width, length;
  };

  void add_roads(std::size_t i, const Axis_place& from, std::size_t a, const Axis_place& to, std::size_t b) {
    const Medial_edge& e = axis_.edges[i];
    std::vector<std::pair<std::size_t, std::size_t>> cuts{{0, e.from}, {e.samples.size() - 1, e.to}};
    if (from.edge == i) cuts.insert(cuts.end() - 1, {from.sample, a});
    if (to.edge == i) cuts.insert(to.sample < cuts[1].first ? cuts.begin() + 1 : cuts.end() - 1, {to.sample, b});
    for (std::size_t k = 1; k < cuts.size(); ++k) {
      Road road{cuts[k - 1].second, cuts[k].second, i, cuts[k - 1].first, cuts[k].first, 0, 0};
      road.width = e.samples[road.first].radius;
      for (std::size_t s = road.first + 1; s <= road.last; ++s) {
        road.width = (std::min)(road.width, e.samples[s].radius);
        road.length += euclidean_norm(e.samples[s].centre - e.samples[s - 1].centre);
      }
      roads_.push_back(road);
    }
  }
  // By adding the widest roads first until both are connected; -1 where they are not.
  [[nodiscard]] double widest_between(std::size_t a, std::size_t b) const {
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
      if (root(a) == root(b)) return roads_[r].width;
    }
    return -1;
  }
  // Of the roads that are wide enough (Dijkstra).
  template <class Stations> [[nodiscard]] Stations shortest(std::size_t a, std::size_t b, double width) const {
    std::vector<std::vector<std::size_t>> at(count_);
    for (std::size_t r = 0; r < roads_.size(); ++r)
      if (roads_[r].width >= width)
        for (const std::size_t v : {roads_[r].from, roads_[r].to}) at[v].push_back(r);
    std::vector<double> distance(count_, std::numeric_limits<double>::infinity());
    std::vector<std::size_t> by(count_, NONE);
    using Entry = std::pair<double, std::size_t>;
    std::priority_queue<Entry, std::vector<Entry>, std::greater<>> queue;
    distance[a] = 0;
    queue.push({0, a});
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
    Stations stations;  // backwards
    for (std::size_t v = b; v != a;) {
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

  const Medial_axis_2& axis_;
  std::size_t count_;
  std::vector<Road> roads_;
};

}  // namespace CGAL::Bounding_arcs::internal

#endif
