// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The time of work that is done several times.

#ifndef BOUNDING_ARCS_STUDY_LEAST_SECONDS_H
#define BOUNDING_ARCS_STUDY_LEAST_SECONDS_H

#include <algorithm>
#include <chrono>
#include <cstddef>
#include <limits>

namespace CGAL::Bounding_arcs::internal {

/// The least time of some repetitions, which all do the same.
template <class Work> double least_seconds(std::size_t repeat, const Work& work) {
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < (std::max)(repeat, std::size_t(1)); ++i) {
    const auto start = std::chrono::steady_clock::now();
    work();
    least = (std::min)(least, std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count());
  }
  return least;
}

}  // namespace CGAL::Bounding_arcs::internal

#endif
