#!/usr/bin/env bash
# Copyright (c) 2026 The Bounding Arcs authors.
# SPDX-License-Identifier: GPL-3.0-or-later
#
# Sources compile by themselves, without what others bring into a unity build. All of them take three minutes of two
# cores, so that a test compiles those that were changed last. Of the others the test of style has looked at each name
# (test/style/includes.awk). Fails where there is nothing to compile.
# Usage: sources_alone.sh COMPILER [NUMBER]
#   NUMBER  of sources, 3 as a rule, which take 5 s; 1000 are all
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/../.."
export compiler=$1
number=${2:-3}
# Commits tell what was changed last, and where there are none, as in an archive, the times of files do.
changed() {
  git status --porcelain -- src 2> /dev/null | sed 's/^...//' || true
  git log --format= --name-only -- src 2> /dev/null || true
  find src -name '*.cpp' -printf '%T@ %p\n' | sort -rn | cut -d ' ' -f 2
}
mapfile -t sources < <(changed | awk '/\.cpp$/ && !seen[$0]++' | while read -r source; do
  [ ! -e "$source" ] || echo "$source"
done | head -n "$number")
[ ${#sources[@]} -gt 0 ] || { echo 'no source to compile'; exit 1; }
alone() {
  "$compiler" -std=c++17 -frounding-math -ffp-contract=off -fsyntax-only -Iinclude -Isrc/tool -DCGAL_LINKED_WITH_TBB \
    -DBOUNDING_ARCS_VERSION='""' -DBOUNDING_ARCS_COMPILER='""' -DBOUNDING_ARCS_FLAGS='""' "$1" ||
    { echo "does not compile alone: $1"; return 1; }
}
export -f alone
printf '%s\n' "${sources[@]}" | xargs -P "$(nproc)" -I {} bash -c 'alone {}'
echo "${#sources[@]} of $(find src -name '*.cpp' | wc -l) sources compile alone: ${sources[*]}"
