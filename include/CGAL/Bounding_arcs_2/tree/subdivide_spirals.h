// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The subtrees of many spiral segments, one after the other or, with TBB, in parallel: segments do not know of each
// other, so the result is the same.

#ifndef CGAL_BOUNDING_ARCS_2_TREE_SUBDIVIDE_SPIRALS_H
#define CGAL_BOUNDING_ARCS_2_TREE_SUBDIVIDE_SPIRALS_H

#include <CGAL/Bounding_arcs_2/tree/Midpoint_subdivision.h>
#include <CGAL/Bounding_arcs_2/tree/for_each_index.h>

#include <algorithm>
#include <cstddef>
#include <functional>
#include <mutex>
#include <utility>
#include <vector>

namespace CGAL::Bounding_arcs::internal {

struct Subdivision_result {
  Decision_counts counts;
  double bound = 0;  ///< at least the thickness of every leaf
  bool is_resolution_reached = false;
  bool is_over_limit = false;
};

/// Subdivides the segments of a range: their nodes, and where each one's begin.
template <class Traits, class Spiral>
struct Subdivided_range {
  Midpoint_subdivision<Traits, Spiral> subdivision;
  std::vector<std::size_t> roots;

  template <class Progress>
  void add(const std::vector<Spiral>& spirals, std::size_t begin, std::size_t end, const Progress& progress) {
    roots.reserve(end - begin);
    for (std::size_t i = begin; i < end && !subdivision.is_over_limit(); ++i) {
      roots.push_back(subdivision.nodes().size());
      subdivision.add(spirals[i]);
      progress();
    }
  }
};

/// Appends the subtrees of segments begin, ..., end - 1 to `nodes`, and to `roots` where each begins and where they end.
/// \param progress called with the number of segments done and of all, by one thread at a time
template <class ConcurrencyTag, class Traits, class Spiral>
[[nodiscard]] Subdivision_result subdivide_spirals(const Piece_decisions<Traits, Spiral>& decide, const std::vector<Spiral>& spirals,
                                                   std::size_t begin, std::size_t end, double eps, std::size_t limit,
                                                   Region_nodes& nodes, std::vector<std::size_t>& roots,
                                                   const std::function<void(std::size_t, std::size_t)>& progress) {
  using Range = Subdivided_range<Traits, Spiral>;
  constexpr std::size_t SEGMENTS_AT_ONCE = 64;  // enough work for a task, and tasks enough to share
  const std::size_t step = is_parallel_v<ConcurrencyTag> ? SEGMENTS_AT_ONCE : (std::max<std::size_t>)(end - begin, 1);
  std::vector<Range> ranges((end - begin + step - 1) / step, Range{{decide, eps, limit, nodes.keeps_thickness()}, {}});
  std::mutex progress_mutex;
  std::size_t done = 0;
  const auto tell = [&] {
    if (!progress) return;
    const std::lock_guard<std::mutex> lock(progress_mutex);
    progress(++done, end - begin);
  };
  for_each_index<ConcurrencyTag>(ranges.size(), [&](std::size_t i) {
    ranges[i].add(spirals, begin + i * step, (std::min)(begin + (i + 1) * step, end), tell);
  });
  Subdivision_result result;
  for (Range& r : ranges) {
    Midpoint_subdivision<Traits, Spiral>& s = r.subdivision;
    result.counts.add(s.counts());
    result.bound = (std::max)(result.bound, s.bound());
    result.is_resolution_reached |= s.is_resolution_reached();
    result.is_over_limit |= s.is_over_limit();
    for (const std::size_t root : r.roots) roots.push_back(nodes.size() + root);
    if (nodes.size() == 0) nodes = std::move(s.nodes());
    else nodes.append(s.nodes(), 0, s.nodes().size());
  }
  roots.push_back(nodes.size());
  return result;
}

}  // namespace CGAL::Bounding_arcs::internal

#endif
