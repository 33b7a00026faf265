// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// How much is tried: a part of it where each case takes thirty times as long, under sanitizers.

#ifndef BOUNDING_ARCS_TEST_CASES_H
#define BOUNDING_ARCS_TEST_CASES_H

namespace bounding_arcs_test {

#ifdef BOUNDING_ARCS_FEW_CASES
inline constexpr bool FEW_CASES = true;
#else
inline constexpr bool FEW_CASES = false;
#endif

/// Of so many cases those to be tried.
constexpr int cases(int count) { return FEW_CASES ? (count + 9) / 10 : count; }

}  // namespace bounding_arcs_test

#endif
