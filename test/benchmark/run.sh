#!/bin/bash
# Copyright (c) 2026 The Bounding Arcs authors.
# SPDX-License-Identifier: GPL-3.0-or-later
#
# Installs what is missing, builds in release mode and prints one table of ratios. Arguments go to the benchmark
# program, for example --benchmark_filter='^bca, 1e-10/'.
set -euo pipefail
cd "$(dirname "$0")/../.."
bash .ci/install.sh .ci/packages_benchmark.txt
build="${BUILD_DIR:-build/benchmark}"
cmake -S . -B "$build" -DCMAKE_BUILD_TYPE=Release -DBOUNDING_ARCS_BENCHMARKS=ON -DBOUNDING_ARCS_EXAMPLES=OFF \
  -DBOUNDING_ARCS_TBB=ON > /dev/null
cmake --build "$build" --target benchmarks --parallel "$(nproc)" > /dev/null
"$build/test/benchmark/benchmarks" "$@"
