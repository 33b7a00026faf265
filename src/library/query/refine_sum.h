// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Pieces of a drawing fine enough for a sum over them: the one that leaves most open is halved, until all together
// leave open no more than a tolerance, or halving does not help, or there are as many as a limit allows.

#ifndef BOUNDING_ARCS_LIBRARY_QUERY_REFINE_SUM_H
#define BOUNDING_ARCS_LIBRARY_QUERY_REFINE_SUM_H

#include "../tree/Segment_hierarchy.h"
#include "Work_limit.h"

#include <algorithm>
#include <optional>
#include <utility>
#include <vector>

namespace CGAL::Bounding_arcs::internal {

/// What a piece leaves open of a sum.
struct Open_part {
  double width = 0;
  bool is_final = true;  ///< halving does not help
};

/// \param open gives the Open_part of a piece
/// \param limit of halvings; where it is reached the rest stays as it is
/// \return the pieces in any order
template <class Open>
[[nodiscard]] std::vector<Spiral_piece_2> refine_sum(const Segment_hierarchy& curves,
                                                     const std::vector<Spiral_piece_2>& pieces, double tolerance,
                                                     const Open& open, Work_limit& limit) {
  struct Entry {
    Open_part open;
    Spiral_piece_2 piece;
  };
  const auto is_less = [](const Entry& a, const Entry& b) { return a.open.width < b.open.width; };
  std::vector<Spiral_piece_2> done;
  std::vector<Entry> heap;
  double sum = 0;
  heap.reserve(pieces.size());
  for (const Spiral_piece_2& p : pieces) heap.push_back({open(p), p});
  for (const Entry& e : heap) sum += e.open.width;
  std::make_heap(heap.begin(), heap.end(), is_less);
  while (!heap.empty() && !(sum <= tolerance)) {
    if (!heap.front().open.is_final && !limit.spend()) break;
    std::pop_heap(heap.begin(), heap.end(), is_less);
    const Entry widest = heap.back();
    heap.pop_back();
    const auto middle = widest.open.is_final ? std::optional<Spiral_halves_2>() : halves(curves, widest.piece);
    if (!middle) {
      done.push_back(widest.piece);
      continue;
    }
    const Entry parts[2] = {{open(middle->first), middle->first}, {open(middle->second), middle->second}};
    sum += (parts[0].open.width + parts[1].open.width) - widest.open.width;
    for (const Entry& e : parts) {
      heap.push_back(e);
      std::push_heap(heap.begin(), heap.end(), is_less);
    }
  }
  for (const Entry& e : heap) done.push_back(e.piece);
  return done;
}

}  // namespace CGAL::Bounding_arcs::internal

#endif
