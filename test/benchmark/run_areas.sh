#!/bin/bash
# Copyright (c) 2026 The Bounding Arcs authors.
# SPDX-License-Identifier: GPL-3.0-or-later
#
# Builds the check of offsets' areas beside Clipper's in release mode and runs it for 1e-4 and 1e-6 of the size.
# Nothing here is needed by the project; Clipper is one of packages_peers.txt.
# Usage: run_areas.sh [--install] FILE...    curve files, e.g. examples/data/*.json
#   --install  installs these packages first
set -euo pipefail
root="$(cd "$(dirname "$0")/../.." && pwd)"
bash "$root/.ci/install.sh" "$root/.ci/packages_benchmark.txt"
if [ "${1:-}" = --install ]; then
  shift
  bash "$root/.ci/install.sh" "$root/test/benchmark/packages_peers.txt"
fi
build="${BUILD_DIR:-$root/build/benchmark}"
cmake -S "$root" -B "$build" -DCMAKE_BUILD_TYPE=Release -DBOUNDING_ARCS_BENCHMARKS=ON -DBOUNDING_ARCS_EXAMPLES=OFF \
  -DBOUNDING_ARCS_TBB=ON | grep 'Clipper is not' || true
cmake --build "$build" --target offset_areas --parallel "$(nproc)" > /dev/null
status=0
for eps in 1e-4 1e-6; do
  "$build/test/benchmark/offset_areas" "$eps" 0.125 "$@" || status=1
done
exit "$status"
