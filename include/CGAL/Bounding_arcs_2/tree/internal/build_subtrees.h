// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The subtrees of many spiral segments, one after the other or, with TBB, in parallel: segments do not know of each
// other, so the result is the same.

#ifndef CGAL_BOUNDING_ARCS_2_TREE_INTERNAL_BUILD_SUBTREES_H
#define CGAL_BOUNDING_ARCS_2_TREE_INTERNAL_BUILD_SUBTREES_H

#include <CGAL/Bounding_arcs_2/tree/Build_options.h>
#include <CGAL/Bounding_arcs_2/tree/Piece_source.h>
#include <CGAL/Bounding_arcs_2/tree/for_each_index.h>

#include <algorithm>
#include <atomic>
#include <cstddef>
#include <mutex>
#include <vector>

namespace CGAL::Bounding_arcs::internal {

/// Appends the subtrees of segments begin, ..., end - 1 to `nodes`.
/// \param empty nodes without any
/// \return false, soon, if there would be more nodes than allowed; then not all are there
template <class ConcurrencyTag, class Decider, class Spiral, class Nodes>
[[nodiscard]] bool build_subtrees(const Decider& decide, const std::vector<Spiral>& spirals, std::size_t begin,
                                  std::size_t end, double eps, const Build_options& options, const Nodes& empty,
                                  Nodes& nodes, Decision_counts& counts) {
  constexpr std::size_t AHEAD = 64;  // segments
  std::mutex mutex;                  // of what is told and counted
  std::size_t ready = 0;
  std::atomic<bool> is_over_limit{false};
  const auto add = [&](std::size_t i, std::size_t j, Nodes& to) {
    Decider own = decide;
    Decision_counts own_counts;
    for (const std::size_t start = i; i < j && !is_over_limit; ++i) {
      if ((i - start) % AHEAD == 0) to.look_ahead(own, &spirals[i], (std::min)(j - i, AHEAD), eps);
      if (!to.add(own, spirals[i], reachable(eps, spirals[i]), options.max_nodes, own_counts)) is_over_limit = true;
      if (!options.progress) continue;
      const std::lock_guard<std::mutex> lock(mutex);
      options.progress(++ready, end - begin);
    }
    const std::lock_guard<std::mutex> lock(mutex);
    counts.add(own_counts);
  };
  if constexpr (is_parallel_v<ConcurrencyTag>) {
    std::atomic<std::size_t> made{nodes.number_of_nodes()};
    std::vector<Nodes> parts((end - begin + RANGE_SIZE - 1) / RANGE_SIZE, empty);
    for_each_index<ConcurrencyTag>(parts.size(), [&](std::size_t k) {
      add(begin + k * RANGE_SIZE, (std::min)(begin + (k + 1) * RANGE_SIZE, end), parts[k]);
      if ((made += parts[k].number_of_nodes()) > options.max_nodes) is_over_limit = true;
    });
    if (!is_over_limit) nodes.template append_all<ConcurrencyTag>(parts);
  } else {
    add(begin, end, nodes);
  }
  return !is_over_limit;
}

}  // namespace CGAL::Bounding_arcs::internal

#endif
