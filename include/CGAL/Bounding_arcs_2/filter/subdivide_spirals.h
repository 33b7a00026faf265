// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The subtrees of many spiral segments, one after the other or, with TBB, in parallel: segments do not know of each
// other, so the result is the same.

#ifndef CGAL_BOUNDING_ARCS_2_FILTER_SUBDIVIDE_SPIRALS_H
#define CGAL_BOUNDING_ARCS_2_FILTER_SUBDIVIDE_SPIRALS_H

#include <CGAL/Bounding_arcs_2/filter/Midpoint_subdivision.h>
#include <CGAL/Bounding_arcs_2/internal/tree/for_each_index.h>

#include <algorithm>
#include <atomic>
#include <cstddef>
#include <functional>
#include <mutex>
#include <utility>
#include <vector>

namespace CGAL::Bounding_arcs::filter {

/// Lets the memory of an object be fetched while other work goes on.
template <class T> void prefetch(const T& object) {
  constexpr std::size_t CACHE_LINE = 64;
  const char* bytes = reinterpret_cast<const char*>(&object);
  for (std::size_t i = 0; i < sizeof(T); i += CACHE_LINE) __builtin_prefetch(bytes + i);
  __builtin_prefetch(bytes + sizeof(T) - 1);
}

/// Subtrees of consecutive segments.
template <class Traits, class Spiral> class Subdivided_part {
 public:
  /// \param roots where to put the first node of each segment, counted from the part's own first one
  /// \param done see subdivide_spirals
  template <class Done, class Tell>
  void subdivide(Midpoint_subdivision<Traits, Spiral> subdivision, const Spiral* spirals, std::size_t begin,
                 std::size_t end, std::size_t* roots, const Done& done, const Tell& tell) {
    bool is_foreseen = end - begin < SAMPLE * internal::RANGE_SIZE;
    for (std::size_t i = begin; i < end && !subdivision.is_over_limit();) {
      const std::size_t range_begin = i, range_end = (std::min)(i + internal::RANGE_SIZE, end);
      if (!is_foreseen && i - begin >= (end - begin) / SAMPLE) {
        subdivision.foresee(static_cast<double>(end - begin) / static_cast<double>(i - begin));
        is_foreseen = true;
      }
      for (; i < range_end && !subdivision.is_over_limit(); ++i) {
        if (i + 1 < end) prefetch(spirals[i + 1]);
        *roots++ = subdivision.nodes().size();
        subdivision.add(spirals[i]);
        tell();
      }
      done(range_begin, i);
    }
    result_ = subdivision.result();
    nodes_ = std::move(subdivision.nodes());
  }
  [[nodiscard]] internal::Region_nodes& nodes() { return nodes_; }
  [[nodiscard]] const Subdivision_result& result() const { return result_; }

 private:
  static constexpr std::size_t SAMPLE =
      16;  // one over the part of the segments from which the number of nodes is foreseen

  internal::Region_nodes nodes_;
  Subdivision_result result_;
};

/// Appends the subtrees of segments begin, ..., end - 1 to `nodes`, and to `roots` where each begins and where they
/// end. Does neither, and stops soon, where that would be more than `limit` nodes.
/// \param done done(i, j) is called when segments i, ..., j - 1 are subdivided, by any thread, for ranges that tile
///   the whole one and have begin + k RANGE_SIZE as ends; they are then likely to be in the thread's caches
/// \param progress called with the number of segments done and of all, by one thread at a time
template <class ConcurrencyTag, class Traits, class Spiral, class Done>
[[nodiscard]] Subdivision_result subdivide_spirals(const Piece_decisions<Traits, Spiral>& decide,
                                                   const std::vector<Spiral>& spirals, std::size_t begin,
                                                   std::size_t end, double eps, std::size_t limit,
                                                   internal::Region_nodes& nodes, std::vector<std::size_t>& roots,
                                                   const Done& done,
                                                   const std::function<void(std::size_t, std::size_t)>& progress) {
  // one part for all segments or, in parallel, one a range
  const std::size_t count = end - begin, first_root = roots.size(),
                    step = internal::is_parallel_v<ConcurrencyTag> ? internal::RANGE_SIZE
                                                                   : (std::max<std::size_t>)(count, 1);
  std::vector<Subdivided_part<Traits, Spiral>> parts((count + step - 1) / step);
  roots.resize(first_root + count + 1);
  std::mutex progress_mutex;
  std::size_t ready = 0;
  const auto tell = [&] {
    if (!progress) return;
    const std::lock_guard<std::mutex> lock(progress_mutex);
    progress(++ready, count);
  };
  std::atomic<std::size_t> made{nodes.size()};
  std::atomic<bool> is_over_limit{false};
  internal::for_each_index<ConcurrencyTag>(parts.size(), [&](std::size_t k) {
    if (is_over_limit) return;
    parts[k].subdivide({decide, eps, limit, nodes.keeps_thickness()}, spirals.data(), begin + k * step,
                       begin + (std::min)((k + 1) * step, count), &roots[first_root + k * step], done, tell);
    made += parts[k].nodes().size();
    if (parts[k].result().is_over_limit || made > limit) is_over_limit = true;
  });
  Subdivision_result result;
  for (const auto& part : parts) result.add(part.result());
  result.is_over_limit = is_over_limit;
  if (is_over_limit) return result;
  if (parts.size() == 1 && nodes.size() == 0) {
    nodes = std::move(parts[0].nodes());
  } else {
    const std::vector<std::size_t> begins = nodes.append_all<ConcurrencyTag>(
        parts.size(), [&](std::size_t k) -> const internal::Region_nodes& { return parts[k].nodes(); });
    for (std::size_t k = 0; k < parts.size(); ++k)
      for (std::size_t i = k * step; i < (std::min)((k + 1) * step, count); ++i) roots[first_root + i] += begins[k];
  }
  roots.back() = nodes.size();
  return result;
}

}  // namespace CGAL::Bounding_arcs::filter

#endif
