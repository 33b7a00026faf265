// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// How often curves were cut, for the test that nothing cuts one twice.

#ifndef CGAL_BOUNDING_ARCS_2_SPIRAL_INTERNAL_CUT_COUNT_H
#define CGAL_BOUNDING_ARCS_2_SPIRAL_INTERNAL_CUT_COUNT_H

#include <cstddef>

namespace CGAL::Bounding_arcs::internal {

/// The number of curves that this thread has cut into spiral segments so far.
[[nodiscard]] inline std::size_t& cut_count() {
  thread_local std::size_t count = 0;
  return count;
}

}  // namespace CGAL::Bounding_arcs::internal

#endif
