#!/usr/bin/env bash
# Installs what is missing, builds everything and runs all tests.
#   bash test/run.sh              release build, in build/test
#   bash test/run.sh --sanitize   address and undefined-behaviour sanitizers, in build/sanitize
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."
bash .ci/install.sh
directory=build/test sanitize=OFF type=Release
if [ "${1:-}" = --sanitize ]; then
  directory=build/sanitize sanitize=ON type=RelWithDebInfo
  # CGAL's and CORE's number types keep pools until the process ends
  export ASAN_OPTIONS=detect_leaks=0 UBSAN_OPTIONS=print_stacktrace=1
fi
log=$(mktemp)
trap 'rm -f "$log"' EXIT
cmake -S . -B "$directory" -DCMAKE_BUILD_TYPE=$type -DBOUNDING_ARCS_TESTS=ON -DBOUNDING_ARCS_SANITIZE=$sanitize > "$log" ||
  { cat "$log"; exit 1; }
cmake --build "$directory" --parallel "$(nproc)"
ctest --test-dir "$directory" --output-on-failure --parallel "$(nproc)"
