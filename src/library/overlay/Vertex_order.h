// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The order of edges round a vertex, counterclockwise.
//
// Directions in doubles tell it where they are apart by more than their errors; of those that are not, ways are
// compared exactly (Exact_curve.h).

#ifndef BOUNDING_ARCS_LIBRARY_OVERLAY_VERTEX_ORDER_H
#define BOUNDING_ARCS_LIBRARY_OVERLAY_VERTEX_ORDER_H

#include "Cut_curves.h"

#include <cstdint>
#include <vector>

namespace CGAL::Bounding_arcs::internal {

/// An end of an edge.
struct Edge_end {
  std::uint32_t edge = 0;
  bool is_start = true;
};

class Vertex_order {
 public:
  explicit Vertex_order(const Cut_curves& cut) : cut_(cut), curves_(cut.curves()) {}

  /// Sorts ends at one vertex counterclockwise. \pre no two are of one class
  /// \return false where that is not decided
  [[nodiscard]] bool sort(std::vector<Edge_end>& ends);

 private:
  struct Way {
    Edge_end end;
    double angle, error;
  };

  [[nodiscard]] Way way_of(const Edge_end& end) const;
  [[nodiscard]] Exact_way exact_way_of(const Edge_end& end) const;
  [[nodiscard]] static bool are_close(const Way& p, const Way& q, bool is_past_turn);
  void sort_exactly(std::vector<Way>::iterator first, std::vector<Way>::iterator last) const;
  [[nodiscard]] Bezier_span span_at(const Edge_end& end) const;

  const Cut_curves& cut_;
  const Segment_hierarchy& curves_;
  std::vector<Way> ways_;
};

}  // namespace CGAL::Bounding_arcs::internal

#endif
