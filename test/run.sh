#!/usr/bin/env bash
# Installs what is missing, builds everything and runs all tests.
#   bash test/run.sh                   release build, in build/release
#   bash test/run.sh --sanitize        address and undefined-behaviour sanitizers, in build/sanitize
#   bash test/run.sh --sanitize unit   the same, unit and property tests only
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."
bash .ci/install.sh
directory=build/release sanitize=OFF examples=ON type=Release
target=() selection=()
if [ "${1:-}" = --sanitize ]; then
  directory=build/sanitize sanitize=ON examples=OFF type=RelWithDebInfo
  [ "${2:-}" != unit ] || target=(--target unit_tests) selection=(-L '^(unit|property)$')
  # CGAL's and CORE's number types keep pools until the process ends
  export ASAN_OPTIONS=detect_leaks=0 UBSAN_OPTIONS=print_stacktrace=1
fi
log=$(mktemp)
trap 'rm -f "$log"' EXIT
cmake -S . -B "$directory" -DCMAKE_BUILD_TYPE=$type -DBOUNDING_ARCS_TESTS=ON -DBOUNDING_ARCS_SANITIZE=$sanitize \
  -DBOUNDING_ARCS_EXAMPLES=$examples -DBOUNDING_ARCS_TBB=ON > "$log" ||
  { cat "$log"; exit 1; }
cmake --build "$directory" --parallel "$(nproc)" "${target[@]}"
ctest --test-dir "$directory" --output-on-failure --parallel "$(nproc)" "${selection[@]}"
