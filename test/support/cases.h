// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// How much is tried: a half, and a twentieth under sanitizers, where each case takes thirty times as long. The
// environment variable BOUNDING_ARCS_CASES is for a long run by hand: 1 has all of it tried, 2 twice as much. Such a
// run can hold each case to a time, too: BOUNDING_ARCS_CASE_SECONDS=10 ends it by SIGPROF at the first case that takes
// more of the processor. That asks for loops that call `cases` at each turn. Memory is held by `ulimit -v`.

#ifndef BOUNDING_ARCS_TEST_CASES_H
#define BOUNDING_ARCS_TEST_CASES_H

#include <sys/time.h>

#include <cstdlib>

namespace bounding_arcs_test {

#ifdef BOUNDING_ARCS_FEW_CASES
inline constexpr bool FEW_CASES = true;
#else
inline constexpr bool FEW_CASES = false;
#endif

/// The time of a case begins.
inline void start_case() {
  static const char* const text = std::getenv("BOUNDING_ARCS_CASE_SECONDS");
  if (text == nullptr) return;
  const itimerval most{{0, 0}, {std::atoi(text), 0}};
  setitimer(ITIMER_PROF, &most, nullptr);
}

/// Of so many cases those to be tried.
inline int cases(int count) {
  start_case();
  static const char* const text = std::getenv("BOUNDING_ARCS_CASES");
  static const int factor = text == nullptr ? 0 : std::atoi(text);
  if (factor > 0) return factor * count;
  return FEW_CASES ? (count + 19) / 20 : (count + 1) / 2;
}

}  // namespace bounding_arcs_test

#endif
