// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// How long the slowest call of a test took, without what the test does to check it.

#ifndef BOUNDING_ARCS_TEST_LONGEST_CALL_H
#define BOUNDING_ARCS_TEST_LONGEST_CALL_H

#include <algorithm>
#include <ctime>

namespace bounding_arcs_test {

/// In seconds of the processor, of all calls by `timed`.
inline double& longest_call() {
  static double seconds = 0;
  return seconds;
}

template <class Call> auto timed(const Call& call) {
  const std::clock_t start = std::clock();
  auto result = call();
  longest_call() = (std::max)(longest_call(), static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC);
  return result;
}

}  // namespace bounding_arcs_test

#endif
