// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Leaves out of a raw offset what is covered as a whole, so that its crossings need not be found.
//
// Most of a raw offset far beyond radii and gaps is that, and edges there cross as the square of their number.  What
// is left over of an offset loses nothing: where it goes on from one edge to another neither is covered, so that these
// crossings are found as before.

#ifndef BOUNDING_ARCS_LIBRARY_OFFSET_DROP_COVERED_H
#define BOUNDING_ARCS_LIBRARY_OFFSET_DROP_COVERED_H

#include <CGAL/Bounding_arcs_2/arc/arc_crossings.h>
#include "Cover.h"
#include "Raw_offset.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace CGAL::Bounding_arcs::internal {

/// Whether a part of an arc is covered, by more than a depth: a disc that holds it, or those of its halves.
[[nodiscard]] inline bool is_covered(const Arc_2& arc, double u, double v, const Cover& cover, double depth,
                                     int halvings) {
  // no point of at most half a circle is farther from its middle than its ends, which a little more makes up for
  constexpr double ROUNDING = 1 + 0x1p-20;
  const Xy<double> middle = moebius_point(arc, (u + v) / 2);
  const double radius =
      (std::max)(euclidean_norm(moebius_point(arc, u) - middle), euclidean_norm(moebius_point(arc, v) - middle));
  if (cover.covers(middle, ROUNDING * radius + depth)) return true;
  if (halvings == 0 || !cover.covers(middle, depth)) return false;
  return is_covered(arc, u, (u + v) / 2, cover, depth, halvings - 1) &&
         is_covered(arc, (u + v) / 2, v, cover, depth, halvings - 1);
}

/// Sets a flag of those of a few edges that are covered: all at once, or each by itself where they are long and the
/// one in the middle looks covered.
inline void find_covered(const Raw_offset& raw, std::uint32_t begin, std::uint32_t end, const Cover& cover,
                         double depth, std::vector<bool>::iterator flag) {
  constexpr int HALVINGS = 4;
  CGAL::Bbox_2 box = box_about(raw.edges[begin].arc);
  for (std::uint32_t i = begin + 1; i < end; ++i) box += box_about(raw.edges[i].arc);
  const Xy<double> center{box.xmin() / 2 + box.xmax() / 2, box.ymin() / 2 + box.ymax() / 2};
  const double radius = euclidean_norm(Xy<double>{box.xmax(), box.ymax()} - center);
  if (radius < cover.distance() && cover.covers(center, radius + depth)) {
    std::fill_n(flag, end - begin, true);
    return;
  }
  if (2 * radius < cover.distance()) return;
  if (!cover.covers(moebius_point(raw.edges[(begin + end) / 2].arc, 0.5), depth)) return;
  for (std::uint32_t i = begin; i < end; ++i, ++flag)
    *flag = is_covered(raw.edges[i].arc, 0, 1, cover, depth, HALVINGS);
}

inline void drop_covered(Raw_offset& raw, const Cover& cover, double depth) {
  constexpr std::uint32_t AT_ONCE = 4;
  std::vector<Raw_edge> edges;
  std::vector<Raw_run> runs;
  edges.reserve(raw.edges.size());
  std::vector<bool> is_dead;
  for (const Raw_run& run : raw.runs) {
    const std::uint32_t length = run.end - run.begin;
    is_dead.assign(length, false);
    for (std::uint32_t i = 0; i < length; i += AT_ONCE) {
      const std::uint32_t end = (std::min)(i + AT_ONCE, length);
      find_covered(raw, run.begin + i, run.begin + end, cover, depth, is_dead.begin() + i);
    }
    const auto dead = static_cast<std::uint32_t>(std::find(is_dead.begin(), is_dead.end(), true) - is_dead.begin());
    const bool is_whole = dead == length;
    const std::uint32_t first = run.is_closed && !is_whole ? dead : 0;  // an open run's seam is where it is broken
    auto begin = static_cast<std::uint32_t>(edges.size());
    const auto finish = [&] {
      const auto end = static_cast<std::uint32_t>(edges.size());
      if (end > begin) runs.push_back({begin, end, run.is_closed && is_whole});
      begin = end;
    };
    for (std::uint32_t k = 0; k < length; ++k) {
      const std::uint32_t i = (first + k) % length;
      if (is_dead[i]) finish();
      else edges.push_back(raw.edges[run.begin + i]);
    }
    finish();
  }
  raw.edges = std::move(edges);
  raw.runs = std::move(runs);
}

}  // namespace CGAL::Bounding_arcs::internal

#endif
