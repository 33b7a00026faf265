// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Loops of a trimmed offset as chains: directed, with areas and parents, and of one side of open curves where asked.

#ifndef CGAL_BOUNDING_ARCS_2_OFFSET_INTERNAL_OFFSET_CHAINS_H
#define CGAL_BOUNDING_ARCS_2_OFFSET_INTERNAL_OFFSET_CHAINS_H

#include <CGAL/Bounding_arcs_2/offset/Offset_2.h>
#include <CGAL/Bounding_arcs_2/offset/internal/Trimmer.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL::Bounding_arcs::internal {

[[nodiscard]] inline Offset_piece reversed(const Offset_piece& piece) {
  Offset_piece result = piece;
  result.arc = reversed(piece.arc);
  std::swap(result.source.t, result.t_end);
  return result;
}
inline void reverse(std::vector<Offset_piece>& pieces) {
  std::reverse(pieces.begin(), pieces.end());
  for (Offset_piece& p : pieces) p = reversed(p);
}

[[nodiscard]] inline Offset_piece piece_of(const Raw_part& part, const Raw_offset& raw, const Source_arcs& sources) {
  const Raw_edge& edge = raw.edges[part.edge];
  const Source_arc& s = sources.arcs[edge.source];
  const auto at = [&](double u) {
    if (edge.is_at_end) return edge.is_backward ? s.t0 : s.t1;
    return edge.is_backward ? s.t1 + u * (s.t0 - s.t1) : s.t0 + u * (s.t1 - s.t0);
  };
  return {part.arc, {s.curve, s.bezier, at(part.u)}, at(part.v), edge.kind, edge.is_round};
}

/// Area and length of a closed chain.
struct Chain_size {
  double area = 0, length = 0;
};
[[nodiscard]] inline Chain_size size_of(const std::vector<Offset_piece>& pieces) {
  Chain_size size;
  const Xy<double> origin = pieces.front().arc.from;
  for (const Offset_piece& p : pieces) {
    size.area += cross(p.arc.from - origin, p.arc.to - origin) / 2 + area_of_cap(p.arc);
    size.length += euclidean_norm(p.arc.to - p.arc.from);
  }
  return size;
}

/// Whether a closed chain runs round a point.
[[nodiscard]] inline bool is_around(const Offset_chain& chain, const Xy<double>& x) {
  int winding = 0;
  for (const Offset_piece& p : chain.pieces) winding += winding_of_arc(p.arc, x);
  return winding != 0;
}

/// Sets the parents of closed chains that do not cross: of those around one the smallest.
inline void nest(std::vector<Offset_chain>& chains, std::size_t first) {
  std::vector<std::size_t> order;
  std::vector<CGAL::Bbox_2> boxes(chains.size());
  for (std::size_t i = first; i < chains.size(); ++i) {
    if (!chains[i].is_closed) continue;
    order.push_back(i);
    for (const Offset_piece& p : chains[i].pieces) boxes[i] += box_about(p.arc);
  }
  std::sort(order.begin(), order.end(),
            [&](std::size_t i, std::size_t j) { return std::fabs(chains[i].area) < std::fabs(chains[j].area); });
  for (std::size_t k = 0; k < order.size(); ++k) {
    Offset_chain& inner = chains[order[k]];
    const Xy<double> x = point(inner.pieces.front().arc, 0.5);
    for (std::size_t l = k + 1; l < order.size() && !inner.parent; ++l) {
      const CGAL::Bbox_2& b = boxes[order[l]];
      if (x.x < b.xmin() || x.x > b.xmax() || x.y < b.ymin() || x.y > b.ymax()) continue;
      if (is_around(chains[order[l]], x)) inner.parent = order[l];
    }
  }
}

/// Appends what of a loop is on one side of open curves: open chains, in the direction of their curves.
inline void add_one_side(const Raw_loop& loop, const Raw_offset& raw, const Source_arcs& sources, Offset_side side,
                         std::vector<Offset_chain>& chains) {
  const auto is_wanted = [&](const Raw_part& p) { return is_on_side(raw.edges[p.edge], side); };
  const std::size_t n = loop.size();
  std::size_t first = 0;  // behind one that is not wanted
  while (first < n && is_wanted(loop[(first + n - 1) % n])) ++first;
  const bool is_whole = first == n;
  Offset_chain chain;
  chain.is_closed = is_whole;
  const auto finish = [&] {
    if (chain.pieces.empty()) return;
    if (side == Offset_side::RIGHT) reverse(chain.pieces);
    if (is_whole) chain.area = size_of(chain.pieces).area;
    chain.is_ccw = chain.area > 0;
    chains.push_back(std::exchange(chain, Offset_chain{{}, is_whole, false, 0, {}}));
  };
  for (std::size_t k = 0; k < n; ++k) {
    const Raw_part& p = loop[(first + k) % n];
    if (is_wanted(p)) chain.pieces.push_back(piece_of(p, raw, sources));
    else finish();
  }
  finish();
}

}  // namespace CGAL::Bounding_arcs::internal

#endif
