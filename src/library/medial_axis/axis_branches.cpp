// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Bodies of medial_axis/axis_branches.h.

#include <CGAL/Bounding_arcs_2/medial_axis/axis_branches.h>
#include <CGAL/Bounding_arcs_2/number/expected.h>

#include <boost/pending/disjoint_sets.hpp>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <numeric>
#include <stdexcept>
#include <utility>

namespace CGAL::Bounding_arcs {

namespace {

[[nodiscard]] Medial_sample turned(Medial_sample s) {
  std::swap(s.left, s.right);
  return s;
}
// The place of a radius between two samples; its feet are those of the nearer one.
[[nodiscard]] Medial_sample sample_of(double radius, const Medial_sample& s, const Medial_sample& t) {
  const double share = (radius - s.radius) / (t.radius - s.radius);
  const Medial_sample& nearer = share < 1 - share ? s : t;
  return {s.center + share * (t.center - s.center), radius, nearer.left, nearer.right};
}

// A run of samples with no larger discs, from node to node: vertices of the axis, or places where discs get larger.
struct Branch_run {
  std::size_t from, to;
  std::vector<Medial_sample> samples;
  double length = 0;
  bool is_in_forest = false;
};

class Branch_search {
 public:
  Branch_search(const Medial_axis_2& axis, double largest) : nodes_(axis.vertices.size()) {
    std::vector<std::size_t> edges(nodes_);
    for (const Medial_edge& edge : axis.edges) {
      ++edges[edge.from], ++edges[edge.to];
      add(edge, largest);
    }
    for (std::size_t i = 0; i < axis.vertices.size(); ++i) {
      const Medial_vertex& v = axis.vertices[i];
      if (edges[i] > 0 || v.radius > largest) continue;
      Medial_sample disc{v.center, v.radius, {}, {}};
      if (!v.touches.empty()) disc.left = v.touches.front(), disc.right = v.touches.back();
      discs_.push_back({{disc}, 0, 0});
    }
  }

  [[nodiscard]] std::vector<Axis_branch> branches() {
    find_forest();
    std::vector<std::vector<Axis_branch>> parts;
    std::vector<char> is_done(nodes_);
    for (std::size_t i = 0; i < nodes_; ++i) {
      if (is_done[i] != 0 || at_[i].empty()) continue;
      parts.emplace_back();
      const std::vector<Visit> all = visits(i);
      for (const Visit& v : all) is_done[v.node] = 1;
      add_ways(visits(farthest(all)), parts.back());
      std::stable_sort(parts.back().begin() + 1, parts.back().end(), is_longer);
    }
    for (Axis_branch& disc : discs_) parts.push_back({std::move(disc)});
    std::stable_sort(parts.begin(), parts.end(),
                     [](const auto& a, const auto& b) { return is_longer(a.front(), b.front()); });
    std::vector<Axis_branch> result;
    for (std::size_t part = 0; part < parts.size(); ++part)
      for (Axis_branch& branch : parts[part]) {
        branch.part = part;
        result.push_back(std::move(branch));
      }
    return result;
  }

 private:
  // A node of a tree of the forest, as a walk from its root comes to it.
  struct Visit {
    std::size_t node, run;  // by which run; NONE for the root
    std::size_t before;     // the visit that it comes from
    double distance;        // from the root
  };
  static constexpr std::size_t NONE = static_cast<std::size_t>(-1);

  static bool is_longer(const Axis_branch& a, const Axis_branch& b) { return a.length > b.length; }

  void add(const Medial_edge& edge, double largest) {
    Branch_run run{edge.from, edge.to, {}};
    const auto finish = [&](std::size_t to) {
      run.to = to;
      for (std::size_t i = 1; i < run.samples.size(); ++i)
        run.length += euclidean_norm(run.samples[i].center - run.samples[i - 1].center);
      if (run.samples.size() > 1) runs_.push_back(run);
      run = {0, 0, {}};
    };
    for (std::size_t i = 0; i < edge.samples.size(); ++i) {
      const Medial_sample& s = edge.samples[i];
      const Medial_sample* const last = i > 0 ? &edge.samples[i - 1] : nullptr;
      if (s.radius <= largest) {
        if (last != nullptr && run.samples.empty()) {
          run.from = nodes_++;
          run.samples.push_back(sample_of(largest, *last, s));
        }
        run.samples.push_back(s);
      } else if (!run.samples.empty()) {
        run.samples.push_back(sample_of(largest, *last, s));
        finish(nodes_++);
      }
    }
    if (!run.samples.empty()) finish(edge.to);
  }

  void find_forest() {
    std::vector<std::size_t> order(runs_.size());
    std::iota(order.begin(), order.end(), std::size_t(0));
    std::stable_sort(order.begin(), order.end(),
                     [&](std::size_t a, std::size_t b) { return runs_[a].length > runs_[b].length; });
    boost::disjoint_sets_with_storage<> trees(nodes_);
    at_.resize(nodes_);
    for (const std::size_t i : order) {
      Branch_run& run = runs_[i];
      const std::size_t a = trees.find_set(run.from), b = trees.find_set(run.to);
      run.is_in_forest = a != b;
      if (run.is_in_forest) trees.link(a, b);
      at_[run.from].push_back(i);
      if (run.to != run.from) at_[run.to].push_back(i);
    }
  }

  [[nodiscard]] std::vector<Visit> visits(std::size_t root) const {
    std::vector<Visit> result{{root, NONE, NONE, 0}};
    for (std::size_t i = 0; i < result.size(); ++i) {
      const Visit from = result[i];
      for (const std::size_t r : at_[from.node]) {
        const Branch_run& run = runs_[r];
        if (!run.is_in_forest || r == from.run) continue;
        result.push_back({run.from == from.node ? run.to : run.from, r, i, from.distance + run.length});
      }
    }
    return result;
  }
  [[nodiscard]] static std::size_t farthest(const std::vector<Visit>& visits) {
    return std::max_element(visits.begin(), visits.end(),
                            [](const Visit& a, const Visit& b) { return a.distance < b.distance; })
        ->node;
  }

  // The ways of a tree: from each node the way goes on to where it is farthest to a leaf, and others begin there. The
  // first one is the longest of the tree, as its root is one end of that.
  void add_ways(const std::vector<Visit>& tree, std::vector<Axis_branch>& ways) const {
    std::vector<double> beyond(tree.size(), 0);
    std::vector<std::size_t> next(tree.size(), NONE);
    for (std::size_t i = tree.size(); i-- > 1;) {
      const std::size_t before = tree[i].before;
      const double way = beyond[i] + runs_[tree[i].run].length;
      if (next[before] == NONE || way >= beyond[before]) {
        beyond[before] = way;
        next[before] = i;
      }
    }
    for (std::size_t i = 0; i < tree.size(); ++i) {
      if (i > 0 && next[tree[i].before] == i) continue;  // it is on the way that comes there
      Axis_branch way;
      if (i > 0) follow(way, tree[i], tree[tree[i].before].node);
      for (std::size_t at = i; next[at] != NONE; at = next[at]) follow(way, tree[next[at]], tree[at].node);
      if (!way.samples.empty()) ways.push_back(std::move(way));
    }
    for (const Visit& visit : tree)
      for (const std::size_t r : at_[visit.node]) {
        const Branch_run& run = runs_[r];
        if (!run.is_in_forest && run.from == visit.node) ways.push_back({run.samples, run.length, 0});
      }
  }
  void follow(Axis_branch& way, const Visit& visit, std::size_t from) const {
    const Branch_run& run = runs_[visit.run];
    std::vector<Medial_sample> samples = run.samples;
    if (run.from != from) {
      std::reverse(samples.begin(), samples.end());
      for (Medial_sample& s : samples) s = turned(s);
    }
    way.samples.insert(way.samples.end(), samples.begin() + (way.samples.empty() ? 0 : 1), samples.end());
    way.length += run.length;
  }

  std::size_t nodes_;
  std::vector<Branch_run> runs_;
  std::vector<Axis_branch> discs_;
  std::vector<std::vector<std::size_t>> at_;  // the runs at each node
};

}  // namespace

std::vector<Axis_branch> axis_branches(const Medial_axis_2& axis, double largest) {
  if (!(largest > 0)) throw std::invalid_argument(expected("largest", "a radius above 0", largest));
  return Branch_search(axis, largest).branches();
}

}  // namespace CGAL::Bounding_arcs
