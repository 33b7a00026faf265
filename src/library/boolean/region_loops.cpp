// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Bodies of Region_loops.h.

#include "Region_loops.h"

#include <algorithm>
#include <utility>

namespace CGAL::Bounding_arcs::internal {

namespace {

class Loop_tracer {
 public:
  Loop_tracer(const Overlay& overlay, const std::vector<char>& is_inside, Loops_at_vertices at_vertices)
      : overlay_(overlay), edges_(overlay.cut().edges()), is_inside_(is_inside),
        are_split_(at_vertices == Loops_at_vertices::SPLIT), loop_of_(2 * edges_.size(), NO_NUMBER) {
    trace();
    nest();
  }
  [[nodiscard]] std::vector<Region_loop>& loops() { return loops_; }

 private:
  [[nodiscard]] bool is_inside(Edge_side s) const { return is_inside_[overlay_.face_of(s)] != 0; }
  /// Whether the region is on this side of the edge alone.
  [[nodiscard]] bool is_on_boundary(Edge_side s) const { return is_inside(s) && !is_inside(other_side(s)); }
  [[nodiscard]] bool has_ends(Edge_side s) const { return edges_[edge_of(s)].first != NO_NUMBER; }
  [[nodiscard]] std::uint32_t start_of(Edge_side s) const { return overlay_.vertex_at(edge_of(s), !is_reversed(s)); }

  // The first side of the boundary clockwise from the end of another one.
  [[nodiscard]] Edge_side next(Edge_side s) const {
    Edge_side on = overlay_.next(s);
    while (!is_on_boundary(on)) on = overlay_.next(other_side(on));
    return on;
  }

  void trace() {
    std::vector<char> is_done(loop_of_.size(), 0);
    std::vector<std::uint32_t> place(overlay_.cut().number_of_vertices(),
                                     NO_NUMBER);  // of the open side that starts there
    std::vector<Edge_side> open;
    for (Edge_side first = 0; first < loop_of_.size(); ++first) {
      if (!overlay_.cut().is_representative(edge_of(first)) || is_done[first] != 0 || !is_on_boundary(first)) continue;
      Edge_side s = first;
      do {
        is_done[s] = 1;
        if (has_ends(s) && are_split_) {
          std::uint32_t& at = place[start_of(s)];
          if (at != NO_NUMBER) close(open, at, place);
          at = static_cast<std::uint32_t>(open.size());
        }
        open.push_back(s);
        s = next(s);
      } while (s != first);
      close(open, 0, place);
    }
  }
  // Takes a loop off the open sides, from one of these on.
  void close(std::vector<Edge_side>& open, std::uint32_t from, std::vector<std::uint32_t>& place) {
    Region_loop loop;
    loop.sides.assign(open.begin() + from, open.end());
    open.resize(from);
    for (const Edge_side s : loop.sides) {
      loop_of_[s] = loop_of_[other_side(s)] = static_cast<std::uint32_t>(loops_.size());
      if (has_ends(s)) place[start_of(s)] = NO_NUMBER;
    }
    loops_.push_back(std::move(loop));
  }

  // From face to face: the loops around one are a stack, as no two cross.
  void nest() {
    std::vector<std::uint32_t> around;
    std::vector<char> is_known(loops_.size(), 0);
    const auto cross = [&](Edge_side s) {
      const std::uint32_t loop = loop_of_[s];
      if (loop == NO_NUMBER) return;
      if (!around.empty() && around.back() == loop) {
        around.pop_back();
        return;
      }
      if (is_known[loop] == 0) {
        is_known[loop] = 1;
        loops_[loop].is_ccw = is_inside(other_side(s));
        if (!around.empty()) loops_[loop].parent = around.back();
      }
      around.push_back(loop);
    };
    overlay_.for_each_face(cross, [](std::uint32_t) {});
  }

  const Overlay& overlay_;
  const std::vector<Cut_edge>& edges_;
  const std::vector<char>& is_inside_;
  bool are_split_;
  std::vector<std::uint32_t> loop_of_;  // by side
  std::vector<Region_loop> loops_;
};

}  // namespace

std::vector<Region_loop> region_loops(const Overlay& overlay, const std::vector<char>& is_inside,
                                      Loops_at_vertices at_vertices) {
  return std::move(Loop_tracer(overlay, is_inside, at_vertices).loops());
}

}  // namespace CGAL::Bounding_arcs::internal
