// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// What tests of measures share.

#ifndef BOUNDING_ARCS_TEST_MEASURE_CHECKS_H
#define BOUNDING_ARCS_TEST_MEASURE_CHECKS_H

#include <CGAL/Bounding_arcs_2/query/measures.h>

#include <gtest/gtest.h>

#include <string>

namespace bounding_arcs_test {

inline void expect_holds(const CGAL::Bounding_arcs::Measure_bounds& b, long double value, long double room,
                         const std::string& what) {
  EXPECT_LE(b.lower, value + room) << what;
  EXPECT_GE(b.upper, value - room) << what;
}

}  // namespace bounding_arcs_test

#endif
