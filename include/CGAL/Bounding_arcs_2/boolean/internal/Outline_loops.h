// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Loops of edges round a region: those classes of edges that have its inside on one side alone, directed so that it is
// on their left.
//
// Where several such edges end in a vertex, each goes on with the first one clockwise from it, which is round the same
// part of the inside.  A loop that comes back to a vertex is taken apart there, so that no loop meets itself, or stays
// one, so that all its corners are the region's.

#ifndef CGAL_BOUNDING_ARCS_2_BOOLEAN_INTERNAL_OUTLINE_LOOPS_H
#define CGAL_BOUNDING_ARCS_2_BOOLEAN_INTERNAL_OUTLINE_LOOPS_H

#include <CGAL/Bounding_arcs_2/boolean/internal/Cut_curves.h>
#include <CGAL/Bounding_arcs_2/boolean/internal/Edge_rays.h>
#include <CGAL/Bounding_arcs_2/boolean/internal/Edge_windings.h>
#include <CGAL/Bounding_arcs_2/boolean/internal/Vertex_order.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <utility>
#include <vector>

namespace CGAL::Bounding_arcs::internal {

struct Edge_loop {
  std::vector<Directed_edge> edges;
  bool is_ccw = true;
  std::optional<std::size_t> parent;
};

class Outline_loops {
 public:
  /// \param is_inside bool(int winding(std::size_t operand)): whether a side belongs to the region
  /// \param are_split loops are taken apart where they come to a vertex again
  /// \param are_short_left_out edges that come back to a vertex within some ulp are none: nothing tells in which order
  ///   they leave it and come back
  template <class IsInside>
  Outline_loops(const Edge_pieces& pieces, Edge_rays& rays, const Edge_windings& windings, const IsInside& is_inside,
                bool are_split, bool are_short_left_out)
      : pieces_(pieces), cut_(pieces.cut()), rays_(rays), are_split_(are_split) {
    const auto edges = static_cast<std::uint32_t>(cut_.edges().size());
    way_.assign(edges, NO_WAY);
    for (std::uint32_t e = 0; e < edges; ++e) {
      if (cut_.edges()[e].representative != e) continue;
      const bool left = is_inside([&](std::size_t k) { return windings.left(e, k); }),
                 right = is_inside([&](std::size_t k) { return windings.right(e, k); });
      if (left == right) continue;
      if (are_short_left_out && cut_.is_short_loop(e)) is_resolved_ = false;
      else way_[e] = left ? ALONG : AGAINST;
    }
    link();
    if (!is_decided_) return;
    trace();
    nest();
  }

  [[nodiscard]] bool is_decided() const { return is_decided_; }
  [[nodiscard]] bool is_resolved() const { return is_resolved_; }  ///< whether no edge is left out
  [[nodiscard]] std::vector<Edge_loop>& loops() { return loops_; }

 private:
  enum Way : char { NO_WAY, ALONG, AGAINST };

  [[nodiscard]] std::uint32_t vertex_of(std::uint32_t e, bool at_start) const {
    const std::uint32_t cut = at_start ? cut_.edges()[e].first : cut_.edges()[e].last;
    return cut_.cuts()[cut].vertex;
  }
  [[nodiscard]] std::uint32_t start_of(std::uint32_t e) const { return vertex_of(e, way_[e] == ALONG); }
  [[nodiscard]] std::uint32_t end_of(std::uint32_t e) const { return vertex_of(e, way_[e] != ALONG); }

  void link() {
    const std::size_t vertices = cut_.number_of_vertices();
    count_.assign(vertices, 0);
    next_.assign(way_.size(), Cut_edge::NONE);
    std::vector<std::uint32_t> start_at(vertices, Cut_edge::NONE), ends(vertices, 0);
    const auto has_ends = [&](std::uint32_t e) { return way_[e] != NO_WAY && cut_.edges()[e].first != Cut_edge::NONE; };
    for (std::uint32_t e = 0; e < way_.size(); ++e) {
      if (!has_ends(e)) continue;
      ++count_[start_of(e)];
      start_at[start_of(e)] = e;
      ++ends[end_of(e)];
    }
    is_decided_ = ends == count_;  // a boundary comes and goes; the numbers of both sides would be wrong
    std::vector<char> is_linked(vertices, 0);
    for (std::uint32_t e = 0; e < way_.size() && is_decided_; ++e) {
      if (!has_ends(e)) continue;
      const std::uint32_t v = end_of(e);
      if (count_[v] == 1) next_[e] = start_at[v];
      else if (is_linked[v] == 0) link_at(v);
      is_linked[v] = 1;
      is_decided_ = is_decided_ && next_[e] != Cut_edge::NONE;
    }
  }
  void link_at(std::uint32_t v) {
    std::vector<Edge_end> ends;
    for (std::uint32_t i = cut_.first_at(v); i < cut_.first_at(v + 1); ++i) {
      const std::uint32_t cut = cut_.cuts_by_vertex()[i];
      const std::uint32_t after = cut_.edge_after(cut), before = cut_.edge_before(cut);
      if (way_[after] != NO_WAY) ends.push_back({after, true});
      if (way_[before] != NO_WAY) ends.push_back({before, false});
    }
    is_decided_ = Vertex_order(pieces_).sort(ends);
    const auto leaves = [this](const Edge_end& e) { return (way_[e.edge] == ALONG) == e.is_start; };
    const std::size_t n = ends.size();
    for (std::size_t i = 0; i < n && is_decided_; ++i) {
      if (leaves(ends[i])) continue;
      const Edge_end& on = ends[(i + n - 1) % n];
      is_decided_ = leaves(on);
      next_[ends[i].edge] = on.edge;
    }
  }

  void trace() {
    std::vector<char> is_done(way_.size(), 0);
    std::vector<std::uint32_t> at(cut_.number_of_vertices(), Cut_edge::NONE);  // how many edges stand before it
    for (std::uint32_t first = 0; first < way_.size(); ++first) {
      if (way_[first] == NO_WAY || is_done[first] != 0) continue;
      if (cut_.edges()[first].first == Cut_edge::NONE) {
        add_loop({first});
        is_done[first] = 1;
        continue;
      }
      std::vector<std::uint32_t> open;
      std::uint32_t e = first;
      do {
        is_done[e] = 1;
        at[start_of(e)] = static_cast<std::uint32_t>(open.size());
        open.push_back(e);
        const std::uint32_t v = end_of(e), whole = next_[e] == first ? 0 : Cut_edge::NONE,
                            closed = are_split_ ? at[v] : whole;
        if (closed != Cut_edge::NONE) {
          const auto begin = open.begin() + closed;
          for (auto i = begin; i != open.end(); ++i) at[start_of(*i)] = Cut_edge::NONE;
          add_loop({begin, open.end()});
          open.erase(begin, open.end());
        }
        e = next_[e];
      } while (e != first);
    }
  }
  void add_loop(const std::vector<std::uint32_t>& edges) {
    Edge_loop loop;
    for (const std::uint32_t e : edges) loop.edges.push_back({e, way_[e] == AGAINST});
    loops_.push_back(std::move(loop));
  }

  // A ray from an edge of each loop: of this one the number on its left tells the direction, 1 or 0, of others whether
  // it is inside.
  void nest() {
    std::vector<std::size_t> loop_of(way_.size(), loops_.size());
    for (std::size_t i = 0; i < loops_.size(); ++i)
      for (const Directed_edge& e : loops_[i].edges) loop_of[e.edge] = i;
    std::vector<std::vector<std::size_t>> around(loops_.size());
    std::vector<int> number(loops_.size(), 0);
    for (std::size_t i = 0; i < loops_.size(); ++i) {
      const auto& edges = loops_[i].edges;
      const auto known =
          std::find_if(edges.begin(), edges.end(), [&](const Directed_edge& e) { return rays_.knows(e.edge); });
      const Directed_edge own = known != edges.end() ? *known : edges.front();
      const std::optional<Edge_ray>& ray = rays_.from(own.edge);
      if (!ray) {
        is_decided_ = false;
        return;
      }
      std::vector<std::size_t> met;
      for (const Ray_hit_of_edge& h : ray->hits) {
        const std::size_t loop = loop_of[h.edge];
        if (loop == loops_.size()) continue;
        number[loop] += way_[h.edge] == ALONG ? h.number : -h.number;
        met.push_back(loop);
      }
      const int rise = own.is_reversed ? -ray->rise : ray->rise, level = own.is_reversed ? -ray->level : ray->level;
      // the left of a rising edge is beyond it, and that of a level one is above it
      loops_[i].is_ccw = number[i] + (rise > 0 || level > 0 ? 1 : 0) == 1;
      for (const std::size_t loop : met) {
        if (number[loop] != 0 && loop != i) around[i].push_back(loop);
        number[loop] = 0;
      }
    }
    for (std::size_t i = 0; i < loops_.size(); ++i)
      for (const std::size_t loop : around[i])
        if (!loops_[i].parent || around[*loops_[i].parent].size() < around[loop].size()) loops_[i].parent = loop;
  }

  const Edge_pieces& pieces_;
  const Cut_curves& cut_;
  Edge_rays& rays_;
  bool are_split_;
  std::vector<Way> way_;              // by class
  std::vector<std::uint32_t> next_;   // by class
  std::vector<std::uint32_t> count_;  // of edges that start, by vertex
  std::vector<Edge_loop> loops_;
  bool is_decided_ = true, is_resolved_ = true;
};

}  // namespace CGAL::Bounding_arcs::internal

#endif
