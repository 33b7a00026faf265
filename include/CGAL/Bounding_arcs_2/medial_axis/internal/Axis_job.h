// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// What an axis is made by: options, and how near it is to be.

#ifndef CGAL_BOUNDING_ARCS_2_MEDIAL_AXIS_INTERNAL_AXIS_JOB_H
#define CGAL_BOUNDING_ARCS_2_MEDIAL_AXIS_INTERNAL_AXIS_JOB_H

#include <CGAL/Bounding_arcs_2/medial_axis/Medial_axis_2.h>
#include <CGAL/Bounding_arcs_2/tree/for_each_index.h>

#include <algorithm>
#include <cstddef>
#include <functional>

namespace CGAL::Bounding_arcs::internal {

/// A loop of independent pieces of work, for_each_index. A pointer to it is what lets the library, which is compiled
/// without threads, run in those of its user.
using Index_loop = void (*)(std::size_t count, const std::function<void(std::size_t)>& work);
template <class ConcurrencyTag> [[nodiscard]] Index_loop index_loop() {
  return &for_each_index<ConcurrencyTag, std::function<void(std::size_t)>>;
}
/// Calls work(begin, end) for ranges that together are 0, ..., count - 1.
template <class Work> void loop_over_ranges(Index_loop loop, std::size_t count, const Work& work) {
  loop((count + RANGE_SIZE - 1) / RANGE_SIZE,
       [&](std::size_t i) { work(i * RANGE_SIZE, (std::min)((i + 1) * RANGE_SIZE, count)); });
}

struct Axis_job : Medial_axis_options {
  double eps = 1e-6;  ///< how far the axis, and its radius together, may be from the lines between samples
  Index_loop loop = index_loop<CGAL::Sequential_tag>();
};
template <class ConcurrencyTag = CGAL::Sequential_tag>
[[nodiscard]] Axis_job axis_job(double eps, const Medial_axis_options& options) {
  Axis_job job;
  static_cast<Medial_axis_options&>(job) = options;
  job.eps = eps;
  job.loop = index_loop<ConcurrencyTag>();
  return job;
}

}  // namespace CGAL::Bounding_arcs::internal

#endif
