// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef BOUNDING_ARCS_TEST_BENCHMARK_SCALING_H
#define BOUNDING_ARCS_TEST_BENCHMARK_SCALING_H

namespace bounding_arcs_benchmark {

/// Registers builds from 10^2 to 10^6 Bezier pieces, in one thread and in all, and lazy against eager descents.
void add_scaling();

}  // namespace bounding_arcs_benchmark

#endif
