#!/usr/bin/env bash
# Usage: headers_alone.sh COMPILER INCLUDE_DIRECTORY
# Compiles every header of the library by itself, without a warning, as many at a time as there are cores. What another
# header includes before anything else compiles alone where that one does.
set -uo pipefail
cd "$2"
export compiler=$1
check() {
  echo "#include <$1>" | "$compiler" -std=c++17 -fsyntax-only -frounding-math -Wall -Wextra -Werror -I . -x c++ - ||
    { echo "does not compile alone: $1"; return 1; }
}
export -f check
headers=$(find CGAL -name '*.h' | sort)
first=$(echo "$headers" | xargs -n 1 grep -hm 1 '^#include' | sed -n 's/^#include <\(.*\)>$/\1/p' | sort -u)
comm -23 <(echo "$headers") <(echo "$first") | xargs -P "$(nproc)" -I{} bash -c 'check {}'
