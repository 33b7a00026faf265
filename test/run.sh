#!/usr/bin/env bash
# Installs what is missing, builds everything and runs all tests.
#   bash test/run.sh                   release build, in build/release
#   bash test/run.sh --sanitize        address and undefined-behaviour sanitizers, in build/sanitize
#   bash test/run.sh --sanitize unit   the same, unit and property tests only
#   bash test/run.sh --plain           unit and property tests without the filter, by Clang where it is there, at -O3
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."
bash .ci/install.sh
directory=build/release sanitize=OFF examples=ON type=Release
options=() target=() selection=()
unit=(--target unit_tests) unit_selection=(-L '^(unit|property)$')
use_clang() {
  if clang++ "$@" -x c++ -o /dev/null - <<< 'int main() {}' 2> /dev/null; then
    options+=(-DCMAKE_CXX_COMPILER=clang++)
  fi
}
if [ "${1:-}" = --sanitize ]; then
  directory=build/sanitize sanitize=ON examples=OFF type=RelWithDebInfo
  [ "${2:-}" != unit ] || target=("${unit[@]}") selection=("${unit_selection[@]}")
  # Sanitizers double the work of an optimizing compiler and more; Clang takes a quarter less time than GCC and half
  # the memory, and sees the tests through another compiler.
  options=(-DCMAKE_CXX_FLAGS_RELWITHDEBINFO='-O1 -DNDEBUG')
  use_clang -fsanitize=address,undefined
  # CGAL's and CORE's number types keep pools until the process ends
  export ASAN_OPTIONS=detect_leaks=0 UBSAN_OPTIONS=print_stacktrace=1
  export BOUNDING_ARCS_CURVES=${BOUNDING_ARCS_CURVES:-12}  # of each degenerate family: proofs take ten times as long
elif [ "${1:-}" = --plain ]; then
  directory=build/plain examples=OFF target=("${unit[@]}") selection=("${unit_selection[@]}")
  options=(-DBOUNDING_ARCS_FILTER=OFF -DBOUNDING_ARCS_TEST_OPTIMIZATION=-O3)
  use_clang
fi
# else ccache takes nothing that is compiled with a precompiled header
export CCACHE_SLOPPINESS=${CCACHE_SLOPPINESS:-pch_defines,time_macros}
log=$(mktemp)
trap 'rm -f "$log"' EXIT
cmake -S . -B "$directory" -DCMAKE_BUILD_TYPE=$type -DBOUNDING_ARCS_TESTS=ON -DBOUNDING_ARCS_SANITIZE=$sanitize \
  -DBOUNDING_ARCS_EXAMPLES=$examples -DBOUNDING_ARCS_TBB=ON "${options[@]}" > "$log" ||
  { cat "$log"; exit 1; }
cmake --build "$directory" --parallel "$(nproc)" "${target[@]}"
ctest --test-dir "$directory" --output-on-failure --parallel "$(nproc)" "${selection[@]}"
