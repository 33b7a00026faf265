// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Bodies of offset/Offset_2.h.

#include "../arc/Arc_text.h"

#include <CGAL/Bounding_arcs_2/offset/Offset_2.h>

#include <CGAL/Bbox_2.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

namespace CGAL::Bounding_arcs {

[[nodiscard]] static bool is_valid(const Offset::Piece& p) {
  const auto is_parameter = [](double t) { return t >= 0 && t <= 1; };
  return p.arc.is_valid() && is_parameter(p.source.t) && is_parameter(p.t_end);
}

// Each piece starts where the one before ends.
[[nodiscard]] static bool follow_each_other(const Offset::Chain& chain) {
  const std::vector<Offset::Piece>& p = chain.pieces;
  for (std::size_t i = 0; i + 1 < p.size(); ++i)
    if (p[i].arc.to != p[i + 1].arc.from) return false;
  return !p.empty() && (!chain.is_closed || p.back().arc.to == p.front().arc.from);
}

[[nodiscard]] static bool is_within(const Offset::Chain& chain, const Offset::Chain& other, double room) {
  CGAL::Bbox_2 all;
  for (const Offset::Piece& p : other.pieces) all += box(p.arc);
  return std::all_of(chain.pieces.begin(), chain.pieces.end(), [&](const Offset::Piece& p) {
    const Xy<double>& q = p.arc.from;
    return all.xmin() - room <= q.x && q.x <= all.xmax() + room && all.ymin() - room <= q.y && q.y <= all.ymax() + room;
  });
}

// Regions and holes take turns up to a chain without a parent.
[[nodiscard]] static bool is_nested(const Offset& offset, std::size_t i) {
  for (std::size_t steps = 0; offset.chains[i].parent; ++steps) {
    const std::size_t parent = *offset.chains[i].parent;
    if (parent >= offset.chains.size() || steps == offset.chains.size()) return false;
    if (offset.chains[parent].is_ccw == offset.chains[i].is_ccw) return false;
    i = parent;
  }
  return offset.chains[i].is_ccw;
}

std::ostream& operator<<(std::ostream& out, const Offset::Chain& chain) {
  Arc_text text(out);
  for (const Offset::Piece& p : chain.pieces) text << p.arc;
  return out;
}

bool Offset::is_valid() const {
  if (!std::isfinite(distance) || !(error >= 0)) return false;
  for (std::size_t i = 0; i < chains.size(); ++i) {
    const Offset::Chain& c = chains[i];
    const auto is_sound = [](const Offset::Piece& p) { return Bounding_arcs::is_valid(p); };
    if (!std::all_of(c.pieces.begin(), c.pieces.end(), is_sound) || !follow_each_other(c)) return false;
    if (!c.is_closed) continue;
    if (!std::isfinite(c.area) || c.is_ccw != (c.area > 0)) return false;
    if (side != Offset::Side::BOTH) continue;
    if (!is_nested(*this, i)) return false;
    if (c.parent && !is_within(c, chains[*c.parent], error)) return false;
  }
  return true;
}

}  // namespace CGAL::Bounding_arcs
