#!/usr/bin/env bash
# Usage: headers_alone.sh COMPILER INCLUDE_DIRECTORY
# Compiles every header of the library by itself, without a warning.
set -uo pipefail
status=0
cd "$2"
for header in $(find CGAL -name '*.h' | sort); do
  if ! echo "#include <$header>" | "$1" -std=c++17 -fsyntax-only -frounding-math -Wall -Wextra -Werror -I . -x c++ -; then
    echo "does not compile alone: $header"
    status=1
  fi
done
exit $status
