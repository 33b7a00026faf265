// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Bodies of medial_axis/axis_branches.h.

#include <CGAL/Bounding_arcs_2/medial_axis/axis_branches.h>
#include <CGAL/Bounding_arcs_2/number/expected.h>
#include "Axis_editor.h"

#include <boost/pending/disjoint_sets.hpp>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <numeric>
#include <stdexcept>
#include <utility>

namespace CGAL::Bounding_arcs {

namespace {

class Branch_search {
 public:
  /// \param axis without what is not taken
  explicit Branch_search(Medial_axis_2 axis)
      : axis_(std::move(axis)), is_in_forest_(axis_.edges.size()), at_(axis_.vertices.size()) {
    for (const Medial_axis_2::Edge& e : axis_.edges) lengths_.push_back(internal::length_of(e.samples));
  }

  [[nodiscard]] std::vector<Medial_axis_2::Branch> branches() {
    find_forest();
    std::vector<std::vector<Medial_axis_2::Branch>> parts;
    std::vector<char> is_done(at_.size());
    for (std::size_t i = 0; i < at_.size(); ++i) {
      if (is_done[i] != 0) continue;
      parts.emplace_back();
      if (at_[i].empty()) {
        parts.back().push_back({{internal::disc_of(axis_.vertices[i])}, 0, 0});
        continue;
      }
      const std::vector<Visit> all = visits(i);
      for (const Visit& v : all) is_done[v.node] = 1;
      add_ways(visits(farthest(all)), parts.back());
      std::stable_sort(parts.back().begin() + 1, parts.back().end(), is_longer);
    }
    std::stable_sort(parts.begin(), parts.end(),
                     [](const auto& a, const auto& b) { return is_longer(a.front(), b.front()); });
    std::vector<Medial_axis_2::Branch> result;
    for (std::size_t part = 0; part < parts.size(); ++part)
      for (Medial_axis_2::Branch& branch : parts[part]) {
        branch.part = part;
        result.push_back(std::move(branch));
      }
    return result;
  }

 private:
  // A vertex in a tree of the forest, as a walk from its root comes to it.
  struct Visit {
    std::size_t node, edge;  // by which edge; NONE for the root
    std::size_t before;      // the visit that it comes from
    double distance;         // from the root
  };
  static constexpr std::size_t NONE = static_cast<std::size_t>(-1);

  static bool is_longer(const Medial_axis_2::Branch& a, const Medial_axis_2::Branch& b) { return a.length > b.length; }

  void find_forest() {
    std::vector<std::size_t> order(lengths_.size());
    std::iota(order.begin(), order.end(), std::size_t(0));
    std::stable_sort(order.begin(), order.end(),
                     [&](std::size_t a, std::size_t b) { return lengths_[a] > lengths_[b]; });
    boost::disjoint_sets_with_storage<> trees(at_.size());
    for (const std::size_t i : order) {
      const Medial_axis_2::Edge& e = axis_.edges[i];
      const std::size_t a = trees.find_set(e.from), b = trees.find_set(e.to);
      is_in_forest_[i] = a != b;
      if (a != b) trees.link(a, b);
      at_[e.from].push_back(i);
      if (e.to != e.from) at_[e.to].push_back(i);
    }
  }

  [[nodiscard]] std::vector<Visit> visits(std::size_t root) const {
    std::vector<Visit> result{{root, NONE, NONE, 0}};
    for (std::size_t i = 0; i < result.size(); ++i) {
      const Visit from = result[i];
      for (const std::size_t k : at_[from.node]) {
        const Medial_axis_2::Edge& e = axis_.edges[k];
        if (!is_in_forest_[k] || k == from.edge) continue;
        result.push_back({e.from == from.node ? e.to : e.from, k, i, from.distance + lengths_[k]});
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
  void add_ways(const std::vector<Visit>& tree, std::vector<Medial_axis_2::Branch>& ways) const {
    std::vector<double> beyond(tree.size(), 0);
    std::vector<std::size_t> next(tree.size(), NONE);
    for (std::size_t i = tree.size(); i-- > 1;) {
      const std::size_t before = tree[i].before;
      const double way = beyond[i] + lengths_[tree[i].edge];
      if (next[before] == NONE || way >= beyond[before]) {
        beyond[before] = way;
        next[before] = i;
      }
    }
    for (std::size_t i = 0; i < tree.size(); ++i) {
      if (i > 0 && next[tree[i].before] == i) continue;  // it is on the way that comes there
      Medial_axis_2::Branch way;
      if (i > 0) follow(way, tree[i], tree[tree[i].before].node);
      for (std::size_t at = i; next[at] != NONE; at = next[at]) follow(way, tree[next[at]], tree[at].node);
      if (!way.samples.empty()) ways.push_back(std::move(way));
    }
    for (const Visit& visit : tree)
      for (const std::size_t k : at_[visit.node]) {
        const Medial_axis_2::Edge& e = axis_.edges[k];
        if (!is_in_forest_[k] && e.from == visit.node) ways.push_back({e.samples, lengths_[k], 0});
      }
  }
  void follow(Medial_axis_2::Branch& way, const Visit& visit, std::size_t from) const {
    std::vector<Medial_axis_2::Sample> samples = axis_.edges[visit.edge].samples;
    if (axis_.edges[visit.edge].from != from) internal::reverse(samples);
    way.samples.insert(way.samples.end(), samples.begin() + (way.samples.empty() ? 0 : 1), samples.end());
    way.length += lengths_[visit.edge];
  }

  Medial_axis_2 axis_;
  std::vector<double> lengths_;  // of edges
  std::vector<bool> is_in_forest_;
  std::vector<std::vector<std::size_t>> at_;  // the edges at each vertex
};

}  // namespace

std::vector<Medial_axis_2::Branch> axis_branches(const Medial_axis_2& axis, double largest) {
  if (!(largest > 0)) throw std::invalid_argument(expected("largest", "a radius above 0", largest));
  return Branch_search(internal::with_discs_up_to(largest, largest, axis)).branches();
}

}  // namespace CGAL::Bounding_arcs
