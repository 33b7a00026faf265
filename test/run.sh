#!/usr/bin/env bash
# Installs what is missing, builds everything and runs all tests.
#   bash test/run.sh               release build, in build/release
#   bash test/run.sh --sanitize    address and undefined-behaviour sanitizers, by Clang where it is there
#   bash test/run.sh --plain       without the filter
#   bash test/run.sh --often       the tests with this label only: unit tests and some property tests
#   bash test/run.sh --fuzz        builds what fuzz/run.sh runs, with --sanitize, and tests nothing
# Options go together; each of the first two has a build directory of its own.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."
bash .ci/install.sh .ci/packages.txt
directory=build sanitize=OFF filter=ON examples=ON type=Release tests=ON
options=() target=() selection=()
for option in "$@"; do
  case $option in
    --sanitize) sanitize=ON ;;
    --plain) filter=OFF ;;
    --fuzz) target+=(--target fuzz) tests=OFF ;;
    --often) target+=(--target tests_run_often) selection=(-L '^often$') ;;
    *) echo "test/run.sh: unknown option $option; --sanitize, --plain, --often and --fuzz are there" >&2; exit 2 ;;
  esac
done
[ $filter = ON ] || directory=$directory/plain examples=OFF
if [ $sanitize = ON ]; then
  directory=$directory/sanitize examples=OFF type=RelWithDebInfo
  # Sanitizers double the work of an optimizing compiler and more; Clang takes a quarter less time than GCC and half
  # the memory, and sees the tests through another compiler.
  options=(-DCMAKE_CXX_FLAGS_RELWITHDEBINFO='-O1 -DNDEBUG')
  if clang++ -fsanitize=address,undefined -x c++ -o /dev/null - <<< 'int main() {}' 2> /dev/null; then
    options+=(-DCMAKE_CXX_COMPILER=clang++)
  fi
  # CGAL 6, where it can be had, instead of the system's CGAL 5: tests see both
  if cgal=$(bash test/fetch_cgal.sh trixie build/cgal_6); then options+=(-DCGAL_DIR="$cgal")
  else
    [ $? -eq 77 ] || exit 1
    echo "test/run.sh: the following is with the system's CGAL"
  fi
  # CGAL's and CORE's number types keep pools until the process ends
  export ASAN_OPTIONS=detect_leaks=0 UBSAN_OPTIONS=print_stacktrace=1
  export BOUNDING_ARCS_CURVES=${BOUNDING_ARCS_CURVES:-5}  # of each degenerate family: proofs take ten times as long
fi
[ $directory != build ] || directory=build/release
# else ccache takes nothing that is compiled with a precompiled header
export CCACHE_SLOPPINESS=${CCACHE_SLOPPINESS:-pch_defines,time_macros}
# clones share what is compiled
export CCACHE_BASEDIR=${CCACHE_BASEDIR:-$PWD} CCACHE_NOHASHDIR=${CCACHE_NOHASHDIR:-1}
# in which sources need not wait for libraries that their programs link
export CMAKE_GENERATOR=${CMAKE_GENERATOR:-Ninja}
log=$(mktemp)
trap 'rm -f "$log"' EXIT
cmake -S . -B "$directory" -DCMAKE_BUILD_TYPE=$type -DBOUNDING_ARCS_TESTS=ON \
  -DBOUNDING_ARCS_SANITIZE=$sanitize -DBOUNDING_ARCS_FILTER=$filter -DBOUNDING_ARCS_EXAMPLES=$examples \
  -DBOUNDING_ARCS_TBB=ON "${options[@]}" > "$log" ||
  { cat "$log"; exit 1; }
cmake --build "$directory" --parallel "$(nproc)" "${target[@]}"
[ $tests = OFF ] || ctest --test-dir "$directory" --output-on-failure --parallel "$(nproc)" "${selection[@]}"
