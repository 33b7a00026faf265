#!/usr/bin/env bash
# Copyright (c) 2026 The Bounding Arcs authors.
# SPDX-License-Identifier: GPL-3.0-or-later
#
# The rules of style that a program can check: sources are as clang-format leaves them, no line is longer than 120
# columns, and what is internal is in internal/.
# Usage: run.sh [--fix]
#   --fix  formats the sources first
set -eu
cd "$(dirname "${BASH_SOURCE[0]}")/../.."
export LC_ALL=C.UTF-8  # columns are characters
command -v clang-format > /dev/null || { echo 'clang-format is not installed'; exit 1; }
status=0

# refuse MESSAGE PLACES: any place is a failure.
refuse() {
  [ -n "$2" ] || return 0
  printf '%s\n%s\n' "$1" "$2"
  status=1
}

mapfile -t sources < <(find include src test examples doc -name '*.h' -o -name '*.cpp' | sort)
mapfile -t scripts < <(find CMakeLists.txt .ci src test examples doc \
  -name CMakeLists.txt -o -name '*.cmake' -o -name '*.in' -o -name '*.sh' -o -name '*.awk' -o -path .ci/run \
  -o -path '*/report/page/*' -o -name '*.js' | sort -u)

[ "${1:-}" != --fix ] || clang-format -i "${sources[@]}"
refuse 'Not formatted; bash test/style/run.sh --fix does it:' \
  "$(clang-format --dry-run "${sources[@]}" 2>&1 | sed -n 's/:[0-9]*:[0-9]*: .*//p' | uniq)"
refuse 'Longer than 120 columns:' "$(grep -nE '^.{121,}' "${sources[@]}" "${scripts[@]}" | cut -d: -f1,2)"
refuse 'Opens a namespace internal, but is not in internal/:' \
  "$(find include -name '*.h' -not -path '*/internal/*' -exec grep -nE 'namespace +([A-Za-z_:]+::)?internal\b' {} +)"
exit $status
