// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Loops in one thread or, with TBB, in many, as CGAL's concurrency tags say.

#ifndef CGAL_BOUNDING_ARCS_2_TREE_FOR_EACH_INDEX_H
#define CGAL_BOUNDING_ARCS_2_TREE_FOR_EACH_INDEX_H

#include <CGAL/Bounding_arcs_2/number/strict_math.h>

#include <CGAL/tags.h>

#ifdef CGAL_LINKED_WITH_TBB
#include <tbb/parallel_for.h>
#include <tbb/partitioner.h>
#endif

#include <algorithm>
#include <cstddef>
#include <type_traits>

namespace CGAL::Bounding_arcs::internal {

/// Whether a tag asks for several threads.
template <class ConcurrencyTag>
inline constexpr bool is_parallel_v = std::is_convertible_v<ConcurrencyTag, CGAL::Parallel_tag>;

/// Calls work(i) for i = 0, ..., count - 1, with Parallel_tag in any order and at the same time, as tasks of their own,
/// which should take microseconds at least.
template <class ConcurrencyTag, class Work> void for_each_index(std::size_t count, const Work& work) {
  if constexpr (is_parallel_v<ConcurrencyTag>) {
#ifdef CGAL_LINKED_WITH_TBB
    // one at a time, as shares of equal numbers may be far from equal work
    tbb::parallel_for(std::size_t(0), count, std::size_t(1), work, tbb::simple_partitioner());
#else
    static_assert(!is_parallel_v<ConcurrencyTag>, "Parallel_tag needs TBB: link CGAL::TBB_support");
#endif
  } else {
    for (std::size_t i = 0; i < count; ++i) work(i);
  }
}

/// Items that ranges hold: a power of 2, enough work for a task, and few enough for all their data to stay in caches.
inline constexpr std::size_t RANGE_SIZE = 64;

/// Calls work(begin, end) for the ranges [0, RANGE_SIZE), [RANGE_SIZE, 2 RANGE_SIZE), ... up to count.
template <class ConcurrencyTag, class Work> void for_each_range(std::size_t count, const Work& work) {
  for_each_index<ConcurrencyTag>((count + RANGE_SIZE - 1) / RANGE_SIZE,
                                 [&](std::size_t i) { work(i * RANGE_SIZE, (std::min)((i + 1) * RANGE_SIZE, count)); });
}

}  // namespace CGAL::Bounding_arcs::internal

#endif
