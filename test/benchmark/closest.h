// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef BOUNDING_ARCS_TEST_BENCHMARK_CLOSEST_H
#define BOUNDING_ARCS_TEST_BENCHMARK_CLOSEST_H

namespace bounding_arcs_benchmark {

/// Registers closest points on many curves by the arcs of stored and of lazy nodes, and what boxes take.
void add_closest();

}  // namespace bounding_arcs_benchmark

#endif
