// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The rings of edges round the faces that curves cut the plane into, each with its face on the left.
//
// Each edge, one of a class, is gone along on both sides.  At a vertex a ring goes on with the first edge clockwise
// from the one that it came along, which is that one back again where there is no other.

#ifndef CGAL_BOUNDING_ARCS_2_BOOLEAN_INTERNAL_FACE_RINGS_H
#define CGAL_BOUNDING_ARCS_2_BOOLEAN_INTERNAL_FACE_RINGS_H

#include <CGAL/Bounding_arcs_2/boolean/internal/Cut_curves.h>
#include <CGAL/Bounding_arcs_2/boolean/internal/Vertex_order.h>

#include <cstddef>
#include <cstdint>
#include <vector>

namespace CGAL::Bounding_arcs::internal {

class Face_rings {
 public:
  /// \param are_short_left_out see Outline_loops
  Face_rings(const Edge_pieces& pieces, bool are_short_left_out) : cut_(pieces.cut()) {
    for (std::uint32_t e = 0; e < cut_.edges().size(); ++e)
      is_gone_along_.push_back(cut_.edges()[e].representative == e && !(are_short_left_out && cut_.is_short_loop(e)));
    next_.assign(2 * cut_.edges().size(), Cut_edge::NONE);
    for (std::uint32_t v = 0; v < cut_.number_of_vertices() && is_decided_; ++v) link_at(pieces, v);
    if (is_decided_) trace();
  }
  /// Whether the order of edges round each vertex has been told.
  [[nodiscard]] bool is_decided() const { return is_decided_; }
  [[nodiscard]] const std::vector<std::vector<Directed_edge>>& rings() const { return rings_; }

 private:
  // The numbers of an edge in and against its direction.
  [[nodiscard]] static std::uint32_t side(std::uint32_t edge, bool is_reversed) {
    return 2 * edge + (is_reversed ? 1 : 0);
  }

  void link_at(const Edge_pieces& pieces, std::uint32_t v) {
    std::vector<Edge_end> ends;
    const auto add = [&](std::uint32_t edge, bool is_start) {
      if (edge != Cut_edge::NONE && is_gone_along_[edge]) ends.push_back({edge, is_start});
    };
    for (std::uint32_t i = cut_.first_at(v); i < cut_.first_at(v + 1); ++i) {
      const std::uint32_t cut = cut_.cuts_by_vertex()[i];
      add(cut_.edge_after(cut), true);
      add(cut_.edge_before(cut), false);
    }
    const std::size_t n = ends.size();
    if (n > 2) is_decided_ = Vertex_order(pieces).sort(ends);  // two have one order
    for (std::size_t i = 0; i < n; ++i) {
      const Edge_end& on = ends[(i + n - 1) % n];
      next_[side(ends[i].edge, ends[i].is_start)] = side(on.edge, !on.is_start);
    }
  }

  void trace() {
    std::vector<char> is_done(next_.size(), 0);
    for (std::uint32_t first = 0; first < next_.size(); ++first) {
      const Cut_edge& edge = cut_.edges()[first / 2];
      if (!is_gone_along_[first / 2] || is_done[first] != 0) continue;
      std::vector<Directed_edge> ring;
      std::uint32_t s = first;
      do {
        is_done[s] = 1;
        ring.push_back({s / 2, s % 2 == 1});
        if (edge.first != Cut_edge::NONE) s = next_[s];
      } while (s != first);
      rings_.push_back(std::move(ring));
    }
  }

  const Cut_curves& cut_;
  std::vector<bool> is_gone_along_;  // by edge
  std::vector<std::uint32_t> next_;  // by side
  std::vector<std::vector<Directed_edge>> rings_;
  bool is_decided_ = true;
};

}  // namespace CGAL::Bounding_arcs::internal

#endif
