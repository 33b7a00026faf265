// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// A loop in one thread or, with TBB, in many, as CGAL's concurrency tags say.

#ifndef CGAL_BOUNDING_ARCS_2_TREE_FOR_EACH_INDEX_H
#define CGAL_BOUNDING_ARCS_2_TREE_FOR_EACH_INDEX_H

#include <CGAL/tags.h>

#ifdef CGAL_LINKED_WITH_TBB
#include <tbb/parallel_for.h>
#endif

#include <cstddef>
#include <type_traits>

namespace CGAL::Bounding_arcs::internal {

template <class ConcurrencyTag>
inline constexpr bool is_parallel_v = std::is_convertible_v<ConcurrencyTag, CGAL::Parallel_tag>;

/// Calls work(i) for i = 0, ..., count - 1, with Parallel_tag in any order and at the same time.
template <class ConcurrencyTag, class Work>
void for_each_index(std::size_t count, const Work& work) {
  if constexpr (is_parallel_v<ConcurrencyTag>) {
#ifdef CGAL_LINKED_WITH_TBB
    tbb::parallel_for(std::size_t(0), count, work);
#else
    static_assert(!is_parallel_v<ConcurrencyTag>, "Parallel_tag needs TBB: link CGAL::TBB_support");
#endif
  } else {
    for (std::size_t i = 0; i < count; ++i) work(i);
  }
}

}  // namespace CGAL::Bounding_arcs::internal

#endif
