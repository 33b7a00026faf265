// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef BOUNDING_ARCS_TEST_BENCHMARK_ARCS_H
#define BOUNDING_ARCS_TEST_BENCHMARK_ARCS_H

namespace bounding_arcs_benchmark {

/// Registers chains of arcs beside plain biarcs, and optimal beside midpoint splits.
void add_arcs();

}  // namespace bounding_arcs_benchmark

#endif
