// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Loops of a trimmed offset as chains: directed, with areas and parents, and of one side of open curves where asked.

#ifndef BOUNDING_ARCS_LIBRARY_OFFSET_OFFSET_CHAINS_H
#define BOUNDING_ARCS_LIBRARY_OFFSET_OFFSET_CHAINS_H

#include <CGAL/Bounding_arcs_2/offset/Offset_2.h>
#include "Arc_boxes.h"
#include "Raw_offset.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL::Bounding_arcs::internal {

[[nodiscard]] inline Offset::Piece reversed(const Offset::Piece& piece) {
  Offset::Piece result = piece;
  result.arc = reversed(piece.arc);
  std::swap(result.source.t, result.t_end);
  result.source.bezier = piece.bezier_of_end();
  result.bezier_step = -piece.bezier_step;
  return result;
}
inline void reverse(std::vector<Offset::Piece>& pieces) {
  std::reverse(pieces.begin(), pieces.end());
  for (Offset::Piece& p : pieces) p = reversed(p);
}

[[nodiscard]] inline Offset::Piece piece_of(const Raw_part& part, const Raw_offset& raw, const Source_arcs& sources) {
  const Raw_edge& edge = raw.edges[part.edge];
  const Source_arc& s = sources.arcs[edge.source];
  const auto at = [&](double u) {
    if (edge.is_at_end) return edge.is_backward ? s.t0 : s.t1;
    return edge.is_backward ? s.t1 + u * (s.t0 - s.t1) : s.t0 + u * (s.t1 - s.t0);
  };
  return {part.arc, {s.curve, s.bezier, at(part.u)}, at(part.v), edge.kind, edge.is_round, 0};
}

/// Area and length of a closed chain.
struct Chain_size {
  double area = 0, length = 0;
};
[[nodiscard]] inline Chain_size size_of(const std::vector<Offset::Piece>& pieces) {
  Chain_size size;
  const Xy<double> origin = pieces.front().arc.from;
  for (const Offset::Piece& p : pieces) {
    size.area += cross(p.arc.from - origin, p.arc.to - origin) / 2 + area_of_cap(p.arc);
    size.length += euclidean_norm(p.arc.to - p.arc.from);
  }
  return size;
}

/// Sets the parents of closed chains that do not cross: of those around one the smallest.
inline void nest(std::vector<Offset::Chain>& chains, std::size_t first) {
  Arc_rings rings;
  std::vector<std::size_t> chain_of;  // by ring
  const auto arcs_of = [&](std::size_t ring) {
    return [&pieces = chains[chain_of[ring]].pieces](std::size_t k) -> const Arc_2& { return pieces[k].arc; };
  };
  for (std::size_t i = first; i < chains.size(); ++i) {
    if (!chains[i].is_closed) continue;
    chain_of.push_back(i);
    rings.add(chains[i].pieces.size(), arcs_of(chain_of.size() - 1));
  }
  rings.finish();
  // no chain is around a larger one; of two as large none is around the other
  const auto is_larger = [&](std::size_t i, std::size_t j) {
    const double a = std::fabs(chains[i].area), b = std::fabs(chains[j].area);
    return a != b ? a > b : i > j;
  };
  for (const std::size_t i : chain_of) {
    Offset::Chain& inner = chains[i];
    const Xy<double> x = point(inner.pieces.front().arc, 0.5);
    rings.for_each_about(x, [&](std::size_t ring) {
      const std::size_t outer = chain_of[ring];
      const bool is_next = is_larger(outer, i) && (!inner.parent || is_larger(*inner.parent, outer));
      if (is_next && rings.winding(ring, x, arcs_of(ring)) != 0) inner.parent = outer;
    });
  }
}

/// Appends what of a loop is on one side of open curves: open chains, in the direction of their curves.
inline void add_one_side(const Raw_loop& loop, const Raw_offset& raw, const Source_arcs& sources, Offset::Side side,
                         std::vector<Offset::Chain>& chains) {
  const auto is_wanted = [&](const Raw_part& p) { return is_on_side(raw.edges[p.edge], side); };
  const std::size_t n = loop.size();
  std::size_t first = 0;  // behind one that is not wanted
  while (first < n && is_wanted(loop[(first + n - 1) % n])) ++first;
  const bool is_whole = first == n;
  Offset::Chain chain;
  chain.is_closed = is_whole;
  const auto finish = [&] {
    if (chain.pieces.empty()) return;
    if (side == Offset::Side::RIGHT) reverse(chain.pieces);
    if (is_whole) chain.area = size_of(chain.pieces).area;
    chain.is_ccw = chain.area > 0;
    chains.push_back(std::exchange(chain, Offset::Chain{{}, is_whole, false, 0, {}}));
  };
  for (std::size_t k = 0; k < n; ++k) {
    const Raw_part& p = loop[(first + k) % n];
    if (is_wanted(p)) chain.pieces.push_back(piece_of(p, raw, sources));
    else finish();
  }
  finish();
}

}  // namespace CGAL::Bounding_arcs::internal

namespace CGAL::Bounding_arcs {

// Offsets of few pieces: both functions replace pieces by an arc between the same two points. Its points are no farther
// than some way from those that were there, so that the error of an offset grows by that. What was left of eps is not
// exceeded.

/// Lets neighbours on one circle or line be one piece, of at most half a circle: a whole circle is two. They are of one
/// curve and one kind, and no other piece ends between them; a line and what leads it on in a miter or a square cap are
/// one, too.
/// \param room what rounding may move points by; pieces that are within 64 times that of one circle are on it
/// \return how far points were moved at most
/// \complexity linear in the pieces, but n log n for n pieces that become fewer
[[nodiscard]] double put_together(Offset& offset, double most, double room);

/// Leaves out pieces that are shorter than eps / 16, and less beside thin chains: a neighbour is led on instead, where
/// that moves no point by more than `most` and nothing crosses.
/// \return how far points were moved at most
[[nodiscard]] double leave_out_short(Offset& offset, double eps, double most, double room);

/// Does both, and adds what points were moved by to the error.
void make_few(Offset& offset, double eps, double room);

}  // namespace CGAL::Bounding_arcs

#endif
