#!/bin/bash
# Copyright (c) 2026 The Bounding Arcs authors.
# SPDX-License-Identifier: GPL-3.0-or-later
#
# Builds queries, offsets and unions beside those of other libraries in release mode and prints their tables. Nothing
# here is needed by the project: of the packages in packages_peers.txt those that are installed take part.
# Usage: run_peers.sh [--install] [SECONDS of CPU time of a row in each repetition] [PAIRS of cubics]
#   --install  installs these packages first
set -euo pipefail
cd "$(dirname "$0")/../.."
bash .ci/install.sh .ci/packages_benchmark.txt
if [ "${1:-}" = --install ]; then
  shift
  bash .ci/install.sh test/benchmark/packages_peers.txt
fi
build="${BUILD_DIR:-build/benchmark}"
cmake -S . -B "$build" -DCMAKE_BUILD_TYPE=Release -DBOUNDING_ARCS_BENCHMARKS=ON -DBOUNDING_ARCS_EXAMPLES=OFF \
  -DBOUNDING_ARCS_TBB=ON | grep '^-- Benchmark of queries' || true
cmake --build "$build" --target peers offset_peers boolean_peers arrangement_peers --parallel "$(nproc)" > /dev/null
"$build/test/benchmark/peers" "$@"
"$build/test/benchmark/offset_peers"
"$build/test/benchmark/boolean_peers" 1e-6 examples/data/d_rabbit.json examples/data/e_cat.json
"$build/test/benchmark/boolean_peers" 1e-6 examples/data/f_crow.json
"$build/test/benchmark/boolean_peers" 1e-6
"$build/test/benchmark/arrangement_peers" 30 100
