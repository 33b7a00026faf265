#!/usr/bin/env bash
# Usage: headers_alone.sh COMPILER INCLUDE_DIRECTORY
# Compiles every header of the library by itself, without a warning, as many at a time as there are cores.
set -uo pipefail
cd "$2"
export compiler=$1
check() {
  echo "#include <$1>" | "$compiler" -std=c++17 -fsyntax-only -frounding-math -Wall -Wextra -Werror -I . -x c++ - ||
    { echo "does not compile alone: $1"; return 1; }
}
export -f check
find CGAL -name '*.h' | sort | xargs -P "$(nproc)" -I{} bash -c 'check {}'
