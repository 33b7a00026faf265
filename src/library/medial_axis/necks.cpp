// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Bodies of medial_axis/necks.h.

#include <CGAL/Bounding_arcs_2/medial_axis/necks.h>

#include <boost/pending/disjoint_sets.hpp>

#include <algorithm>
#include <limits>
#include <numeric>

namespace CGAL::Bounding_arcs {

namespace {

// The discs of an axis as a graph: its vertices, then the samples between them, edge by edge.
struct Disc_graph {
  struct Disc {
    double radius;
    std::size_t edge, sample;
    std::vector<std::size_t> beside;
  };
  std::vector<Disc> discs;

  explicit Disc_graph(const Medial_axis_2& axis) {
    for (const Medial_vertex& v : axis.vertices) discs.push_back({v.radius, 0, 0, {}});
    for (std::size_t e = 0; e < axis.edges.size(); ++e) {
      const Medial_edge& edge = axis.edges[e];
      const std::size_t last = edge.samples.size() - 1;
      discs[edge.from].edge = discs[edge.to].edge = e;
      discs[edge.from].sample = 0, discs[edge.to].sample = last;
      std::size_t before = edge.from;
      for (std::size_t i = 1; i <= last; ++i) {
        const std::size_t next = i == last ? edge.to : discs.size();
        if (i < last) discs.push_back({edge.samples[i].radius, e, i, {}});
        discs[before].beside.push_back(next);
        discs[next].beside.push_back(before);
        before = next;
      }
    }
  }
  [[nodiscard]] bool is_end(std::size_t i) const { return discs[i].beside.size() < 2; }
};

}  // namespace

std::vector<Neck> necks(const Medial_axis_2& axis, double least_prominence) {
  const Disc_graph graph(axis);
  const std::size_t count = graph.discs.size();
  std::vector<std::size_t> order(count), rank(count);
  std::iota(order.begin(), order.end(), std::size_t(0));
  std::stable_sort(order.begin(), order.end(),
                   [&](std::size_t a, std::size_t b) { return graph.discs[a].radius < graph.discs[b].radius; });
  for (std::size_t i = 0; i < count; ++i) rank[order[i]] = i;

  std::vector<Neck> result;
  const double least = (std::max)(least_prominence, axis.eps);
  const auto end_pool = [&](std::size_t bottom, double prominence) {
    if (graph.is_end(bottom) || !(prominence > least)) return;
    const Disc_graph::Disc& disc = graph.discs[bottom];
    result.push_back({axis.edges[disc.edge].samples[disc.sample], disc.edge, prominence});
  };
  boost::disjoint_sets_with_storage<> pools(count);
  std::vector<std::size_t> bottom(count);  // of the pool that is found by this disc
  std::iota(bottom.begin(), bottom.end(), std::size_t(0));
  for (const std::size_t disc : order)
    for (const std::size_t other : graph.discs[disc].beside) {
      const std::size_t a = pools.find_set(disc), b = pools.find_set(other);
      if (rank[other] > rank[disc] || a == b) continue;
      const auto [lower, higher] =
          std::minmax(bottom[a], bottom[b], [&](std::size_t x, std::size_t y) { return rank[x] < rank[y]; });
      end_pool(higher, graph.discs[disc].radius - graph.discs[higher].radius);
      const std::size_t kept = lower;
      pools.link(a, b);
      bottom[pools.find_set(disc)] = kept;
    }
  for (std::size_t i = 0; i < count; ++i)
    if (pools.find_set(i) == i) end_pool(bottom[i], std::numeric_limits<double>::infinity());
  std::stable_sort(result.begin(), result.end(),
                   [](const Neck& a, const Neck& b) { return a.disc.radius < b.disc.radius; });
  return result;
}

}  // namespace CGAL::Bounding_arcs
