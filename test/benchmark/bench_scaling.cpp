// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "../../src/library/query/Closest_search.h"
#include "../../src/library/tree/Segment_hierarchy.h"
#include "scaling.h"

#include "../support/near_equal_discs.h"
#include "curves.h"

#include <CGAL/Bounding_arcs_2.h>
#include <CGAL/Bounding_arcs_2/query/closest_point.h>
#include <CGAL/Bounding_arcs_2/query/intersections.h>

#include <CGAL/tags.h>

#ifdef CGAL_LINKED_WITH_TBB
#include <tbb/parallel_for.h>
#endif

#include <algorithm>
#include <atomic>
#include <chrono>
#include <cmath>
#include <cstdlib>
#include <limits>
#include <map>
#include <memory>
#include <new>
#include <queue>
#include <random>
#include <thread>

namespace {

// What is allocated while is_counting, now and at most.
std::atomic<bool> is_counting{false};
std::atomic<std::size_t> in_use{0}, most{0};

}  // namespace

// Each block has its size before it, 0 where it was not counted: what is timed is not to pay for it.
[[gnu::noinline]] void* operator new(std::size_t size) {
  auto* p = static_cast<std::size_t*>(std::malloc(size + sizeof(std::max_align_t)));
  if (p == nullptr) throw std::bad_alloc();
  *p = is_counting ? size : 0;
  if (*p != 0) {
    const std::size_t now = in_use += size;
    if (now > most) most = now;
  }
  return reinterpret_cast<char*>(p) + sizeof(std::max_align_t);
}
[[gnu::noinline]] void operator delete(void* p) noexcept {
  if (p == nullptr) return;
  auto* start = reinterpret_cast<std::size_t*>(static_cast<char*>(p) - sizeof(std::max_align_t));
  if (*start != 0) in_use -= *start;
  std::free(start);
}
void operator delete(void* p, std::size_t) noexcept { operator delete(p); }

namespace bounding_arcs_benchmark {
namespace {

using Traits = ba::Bca_traits_2<Double>;

/// Spirals of about n Bezier pieces: the bundled curves again and again, side by side.
const std::vector<Spiral>& spirals_of(std::size_t n) {
  static std::map<std::size_t, std::vector<Spiral>> made;
  std::vector<Spiral>& spirals = made[n];
  if (!spirals.empty()) return spirals;
  const std::vector<Bezier>& curves = bundled_beziers();
  constexpr std::size_t COLUMNS = 1000, STRIDE = 37;  // prime to the number of curves: a hundred are a fair sample
  for (std::size_t i = 0; i < n; ++i) {
    const std::size_t copy = i / curves.size();
    std::vector<ba::Xy<double>> points;
    for (const auto& p : curves[i * STRIDE % curves.size()].control_points())
      points.push_back(
          {p.x + 4.0 * static_cast<double>(copy % COLUMNS), p.y + 4.0 * static_cast<double>(copy / COLUMNS)});
    for (Spiral& s : ba::spiral_segments(Bezier(points))) spirals.push_back(std::move(s));
  }
  return spirals;
}

constexpr double EPS = 1e-8;
constexpr double SECONDS = 1.5;  // of a repetition, which one build of the most pieces takes

template <class Tag> void build(benchmark::State& state, std::size_t n, double eps) {
  using Tree = ba::Region_hierarchy_2<Traits, Spiral>;
  ba::Build_options options;
  options.max_nodes = 4'000'000'000;
  const auto make = [&](std::vector<Spiral> spirals) {
    return Tree(std::move(spirals), eps, options, Traits(), Tag());
  };
  time_builds(state, spirals_of(n), make, [&](const Tree& tree) {
    state.counters[REGIONS] = static_cast<double>(tree.number_of_leaves());
    state.counters[BYTES] = static_cast<double>(tree.bytes());
  });
  std::vector<Spiral> copy = spirals_of(n);
  const std::size_t before = in_use;
  most = before;
  is_counting = true;
  make(std::move(copy));
  is_counting = false;
  state.counters[PEAK] = static_cast<double>(most - before);
}

#ifdef CGAL_LINKED_WITH_TBB
/// A build in each thread, all at once: what the machine gives to threads that have nothing to do with each other.
void build_apart(benchmark::State& state, std::size_t n, double eps) {
  using Tree = ba::Region_hierarchy_2<Traits, Spiral>;
  ba::Build_options options;
  options.max_nodes = 4'000'000'000;
  const std::vector<std::vector<Spiral>> spirals(std::thread::hardware_concurrency(), spirals_of(n));
  const auto make = [&](std::vector<std::vector<Spiral>> copies) {
    std::vector<std::unique_ptr<Tree>> trees(copies.size());
    tbb::parallel_for(
        std::size_t(0), trees.size(), std::size_t(1),
        [&](std::size_t i) { trees[i] = std::make_unique<Tree>(std::move(copies[i]), eps, options); },
        tbb::simple_partitioner());
    return trees;
  };
  time_builds(state, spirals, make, [&](const std::vector<std::unique_ptr<Tree>>& trees) {
    state.counters[REGIONS] = static_cast<double>(trees.size() * trees.front()->number_of_leaves());
  });
}
#endif

double squared_distance(const CGAL::Bbox_2& box, double x, double y) {
  const double dx = (std::max)({box.xmin() - x, x - box.xmax(), 0.0}),
               dy = (std::max)({box.ymin() - y, y - box.ymax(), 0.0});
  return dx * dx + dy * dy;
}

/// Closest point, best first by boxes; returns the number of region nodes seen.
template <class Tree> std::size_t descend(const Tree& tree, double x, double y) {
  using Entry = std::pair<double, typename Tree::Handle>;
  const auto later = [](const Entry& a, const Entry& b) { return a.first > b.first; };
  std::priority_queue<Entry, std::vector<Entry>, decltype(later)> open(later);
  open.push({0, tree.root()});
  std::size_t seen = 0;
  while (!open.empty()) {
    const Entry nearest = open.top();
    open.pop();
    if (tree.is_leaf(nearest.second)) break;
    tree.for_each_child(nearest.second, [&](const auto& child) {
      seen += child.is_region;
      open.push({squared_distance(tree.box(child), x, y), child});
    });
  }
  return seen;
}

void lazy_descent(benchmark::State& state, std::size_t n, double eps) {
  using Tree = ba::Region_hierarchy_2<Traits, Spiral>;
  ba::Build_options options;
  options.nodes = ba::Build_options::Nodes::LAZY;
  std::size_t seen = 0;
  time_builds(
      state, spirals_of(n),
      [&](std::vector<Spiral> spirals) {
        Tree tree(std::move(spirals), eps, options);
        seen = descend(tree, 0.1, 0.2);
        return tree;
      },
      [&](const Tree&) { state.counters[REGIONS] = static_cast<double>(seen); });
}

/// The bundled curves side by side, about n Bezier pieces of them.
ba::Drawing_2<double> copies(std::size_t n, double away) {
  ba::Drawing_2<double> drawing;
  const std::vector<Bezier>& curves = bundled_beziers();
  const auto columns = static_cast<std::size_t>(std::ceil(std::sqrt(static_cast<double>(n) / 400.0)));
  for (std::size_t i = 0; i < n; ++i) {
    const std::size_t copy = i / curves.size();
    std::vector<ba::Xy<double>> points;
    for (const auto& p : curves[i % curves.size()].control_points())
      points.push_back({p.x + away + 4.0 * static_cast<double>(copy % columns),
                        p.y + away + 4.0 * static_cast<double>(copy / columns)});
    drawing.add(Bezier(points));
  }
  return drawing;
}

/// A thousand closest points to points all over the drawing; nodes of boxes that were looked at for one.
void closest(benchmark::State& state, std::size_t n) {
  const ba::Bounding_arc_tree_2 index(copies(n, 0));
  const CGAL::Bbox_2 box = index.in_unit().boxes().box();
  std::mt19937 random(1);
  std::uniform_real_distribution<double> x(box.xmin(), box.xmax()), y(box.ymin(), box.ymax());
  std::vector<ba::Xy<double>> points(1000);
  for (auto& p : points) p = {x(random), y(random)};
  for (auto _ : state) {
    std::size_t nodes = 0;
    const auto start = std::chrono::steady_clock::now();
    for (const auto& p : points) {
      ba::Closest_search search(index.in_unit(), p, std::numeric_limits<double>::infinity());
      search.search();
      nodes += search.nodes();
    }
    state.SetIterationTime(std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count());
    state.counters[REGIONS] = static_cast<double>(nodes) / 1000;
  }
}
/// All intersections with the same drawing moved; how many there are.
void all_intersections(benchmark::State& state, std::size_t n) {
  const ba::Bounding_arc_tree_2 a(copies(n, 0)), b(copies(n, 0.1));
  for (auto _ : state) {
    const auto start = std::chrono::steady_clock::now();
    const std::size_t found = ba::intersections(a, b).points.size();
    state.SetIterationTime(std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count());
    state.counters[REGIONS] = static_cast<double>(found);
  }
}
/// The axis of n random closed splines in a frame, of 5 to 9 pieces each; how many edges it has.
template <class Tag> void axis_in_frame(benchmark::State& state, std::size_t n) {
  std::mt19937 random(1);
  const auto side = static_cast<std::size_t>(std::sqrt(static_cast<double>(n)));
  const ba::Bounding_arc_tree_2 tree(
      ba::framed(bounding_arcs_test::spline_field(random, side, (n + side - 1) / side), 1));
  ba::Medial_axis_2::Options options;
  options.is_framed = true;
  for (auto _ : state) {
    const auto start = std::chrono::steady_clock::now();
    const ba::Medial_axis_2 axis = ba::medial_axis<Tag>(tree, 3e-4, options);  // cells are 3 wide
    state.SetIterationTime(std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count());
    state.counters[REGIONS] = static_cast<double>(axis.edges.size());
    if (axis.status != ba::Medial_axis_2::Status::COMPLETE) state.SkipWithError("the axis is not complete");
  }
}

}  // namespace

void add_scaling() {
  for (const std::size_t n : {100u, 1000u, 10000u, 100000u, 1000000u})
    add_row("1000 closest points, pieces: " + std::to_string(n), "1000 closest points, pieces: 100",
            [=](benchmark::State& state) { closest(state, n); });
  for (const std::size_t n : {100u, 1000u, 10000u, 100000u, 1000000u})
    add_row("intersections of two, pieces: " + std::to_string(n), "intersections of two, pieces: 100",
            [=](benchmark::State& state) { all_intersections(state, n); });
  for (const std::size_t n : {100u, 1000u, 10000u, 100000u, 1000000u})
    add_row(
        "bca, 1e-8, pieces: " + std::to_string(n), "bca, 1e-8, pieces: 100",
        [=](benchmark::State& state) { build<CGAL::Sequential_tag>(state, n, EPS); }, SECONDS);
  const auto axis = [](std::size_t n) { return "axis of splines in a frame: " + std::to_string(n); };
  for (const std::size_t n : {100u, 1000u, 10000u})
    add_row(
        axis(n), axis(100), [=](benchmark::State& state) { axis_in_frame<CGAL::Sequential_tag>(state, n); }, SECONDS);
#ifdef CGAL_LINKED_WITH_TBB
  add_row(
      axis(10000) + ", all threads", axis(10000),
      [](benchmark::State& state) { axis_in_frame<CGAL::Parallel_tag>(state, 10000); }, SECONDS);
  add_row(
      "bca, 1e-8, all threads, pieces: 100000", "bca, 1e-8, pieces: 100000",
      [](benchmark::State& state) { build<CGAL::Parallel_tag>(state, 100000, EPS); }, SECONDS);
  add_row(
      "bca, 1e-8, a build in each thread, pieces: 100000", "bca, 1e-8, pieces: 100000",
      [](benchmark::State& state) { build_apart(state, 100000, EPS); }, SECONDS);
  add_row(
      "bca, 1e-10, all threads, pieces: 100000", "bca, 1e-10, pieces: 100000",
      [](benchmark::State& state) { build<CGAL::Parallel_tag>(state, 100000, 1e-10); }, SECONDS);
#endif
  add_row(
      "bca, 1e-10, pieces: 100000", "",
      [](benchmark::State& state) { build<CGAL::Sequential_tag>(state, 100000, 1e-10); }, SECONDS);
  add_row("bca, 1e-10, lazy, nodes of a descent, pieces: 100000", "bca, 1e-10, pieces: 100000",
          [](benchmark::State& state) { lazy_descent(state, 100000, 1e-10); });
}

}  // namespace bounding_arcs_benchmark
