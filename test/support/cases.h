// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// How much is tried: a part of it where each case takes thirty times as long, under sanitizers, and as many times as
// much as the environment variable BOUNDING_ARCS_CASES says, for a long run by hand.

#ifndef BOUNDING_ARCS_TEST_CASES_H
#define BOUNDING_ARCS_TEST_CASES_H

#include <cstdlib>

namespace bounding_arcs_test {

#ifdef BOUNDING_ARCS_FEW_CASES
inline constexpr bool FEW_CASES = true;
#else
inline constexpr bool FEW_CASES = false;
#endif

/// Of so many cases those to be tried.
inline int cases(int count) {
  static const int factor = [] {
    const char* text = std::getenv("BOUNDING_ARCS_CASES");
    const int number = text == nullptr ? 1 : std::atoi(text);
    return number > 1 ? number : 1;
  }();
  return factor * (FEW_CASES ? (count + 19) / 20 : count);
}

}  // namespace bounding_arcs_test

#endif
