// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "closest.h"

#include "closest_point.h"
#include "curves.h"

#include <cstdint>
#include <memory>
#include <random>

namespace bounding_arcs_benchmark {
namespace {

using Tree = ba::Region_hierarchy_2<ba::Bca_traits_2<Double>, Spiral>;
constexpr double EPS = 1e-10;
constexpr std::size_t PIECES = 100000;

/// The bundled curves again and again, drawing beside drawing.
std::vector<Spiral> many_spirals() {
  std::vector<Spiral> spirals;
  const std::vector<Bezier>& curves = bundled_beziers();
  constexpr std::size_t COLUMNS = 1000;
  for (std::size_t i = 0; i < PIECES; ++i) {
    const std::size_t copy = i / curves.size();
    std::vector<ba::Xy<double>> points;
    for (const auto& p : curves[i % curves.size()].control_points())
      points.push_back(
          {p.x + 4.0 * static_cast<double>(copy % COLUMNS), p.y + 4.0 * static_cast<double>(copy / COLUMNS)});
    for (Spiral& s : ba::spiral_segments(Bezier(points))) spirals.push_back(std::move(s));
  }
  return spirals;
}

const Tree& tree_of(ba::Build_options::Nodes kind) {
  static std::unique_ptr<Tree> made;  // one at a time, as it is large
  if (!made || made->nodes() != kind) {
    ba::Build_options options;
    options.nodes = kind;
    options.max_nodes = 4'000'000'000;
    made = std::make_unique<Tree>(many_spirals(), EPS, options);
  }
  return *made;
}

/// Points some hundredths of a drawing away from curves.
std::vector<ba::Xy<double>> queries(const Tree& tree) {
  constexpr int COUNT = 1000;
  constexpr double AWAY = 0.05;
  std::mt19937 random(1);
  std::normal_distribution<double> away(0, AWAY);
  std::vector<ba::Xy<double>> points;
  for (int i = 0; i < COUNT; ++i) {
    const Spiral& s = tree.spirals()[random() % tree.spirals().size()];
    const ba::Xy<double> p = s.point((s.first() + s.last()) / 2);
    points.push_back({p.x + away(random), p.y + away(random)});
  }
  return points;
}

/// Times run(search, i) for all queries i; `seen(search)` tells how many of what is timed there were.
template <class Run, class Seen>
void time_queries(benchmark::State& state, const Tree& tree, const Run& run, const Seen& seen) {
  const std::vector<ba::Xy<double>> points = queries(tree);
  for (auto _ : state) {
    Closest_point_search<Tree> search(tree);
    const auto start = std::chrono::steady_clock::now();
    for (std::size_t i = 0; i < points.size(); ++i) run(search, points[i], i);
    state.SetIterationTime(std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count());
    state.counters[REGIONS] = static_cast<double>(seen(search));
  }
}

void search(benchmark::State& state, ba::Build_options::Nodes kind) {
  time_queries(
      state, tree_of(kind),
      [](auto& search, const ba::Xy<double>& q, std::size_t) { benchmark::DoNotOptimize(search(q).upper); },
      [](const auto& search) { return search.regions(); });
}

/// The boxes over segments that such a search looks at, by themselves.
void look_at_boxes(benchmark::State& state) {
  const Tree& tree = tree_of(ba::Build_options::Nodes::LAZY);
  std::vector<double> distances;
  Closest_point_search<Tree> first(tree);
  for (const ba::Xy<double>& q : queries(tree)) distances.push_back(first(q).upper);
  time_queries(
      state, tree, [&](auto& search, const ba::Xy<double>& q, std::size_t i) { search.look_at_boxes(q, distances[i]); },
      [](const auto& search) { return search.boxes(); });
}

/// Boxes of region nodes, those on the ways from segments to some of their leaves.
void node_boxes(benchmark::State& state, ba::Build_options::Nodes kind) {
  const Tree& tree = tree_of(kind);
  std::mt19937 random(2);
  std::vector<ba::Node_handle> nodes;
  for (std::uint32_t i = 0; i < 1000; ++i)
    for (ba::Node_handle h = tree.segment_root(i); !h.is_leaf;) {
      nodes.push_back(h);
      const std::size_t chosen = random() % 2;
      std::size_t child = 0;
      tree.for_each_child(nodes.back(), [&](const ba::Node_handle& c) {
        if (child++ == chosen) h = c;
      });
    }
  for (auto _ : state) {
    const auto start = std::chrono::steady_clock::now();
    for (const ba::Node_handle& h : nodes) benchmark::DoNotOptimize(tree.box(h));
    state.SetIterationTime(std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count());
    state.counters[REGIONS] = static_cast<double>(nodes.size());
  }
}

}  // namespace

void add_closest() {
  const std::string of_pieces = ", pieces: " + std::to_string(PIECES);
  const auto add = [&](const std::string& name, const auto& run) { add_row(name + of_pieces, "", run); };
  add("closest point, lazy", [](benchmark::State& state) { search(state, ba::Build_options::Nodes::LAZY); });
  add("closest point, boxes over segments alone", look_at_boxes);
  add("closest point, boxes of region nodes alone",
      [](benchmark::State& state) { node_boxes(state, ba::Build_options::Nodes::LAZY); });
  add("closest point, eager", [](benchmark::State& state) { search(state, ba::Build_options::Nodes::STORED); });
}

}  // namespace bounding_arcs_benchmark
