#!/usr/bin/env bash
# Copyright (c) 2026 The Bounding Arcs authors.
# SPDX-License-Identifier: GPL-3.0-or-later
#
# Makes the tables and pictures of doc/stability.md again, by the tool. A table stands between a line that tells its
# command and a line that ends it; all else on the page is prose and stays.
#     <!-- made by bounding_arcs stability --costs --format markdown -->
#     <!-- made -->
# It takes a minute. Times are never the same twice: make them on a quiet machine.
# Usage: bash doc/make_stability.sh [TOOL [PAGE [IMAGES]]]
set -euo pipefail
root=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
tool=${1:-$root/build/release/src/tool/bounding_arcs} page=${2:-$root/doc/stability.md} images=${3:-$root/doc/images}
made=$(mktemp)
trap 'rm -f "$made"' EXIT
is_table=
while IFS= read -r line; do
  case $line in
    '<!-- made by bounding_arcs '*' -->')
      arguments=${line#'<!-- made by bounding_arcs '}
      read -ra words <<< "${arguments%' -->'}"
      printf '%s\n\n' "$line"
      "$tool" "${words[@]}" < /dev/null
      printf '\n'
      is_table=yes
      ;;
    '<!-- made -->') is_table= ;;
  esac
  case $line in '<!-- made by '*) ;; *) [ "$is_table" ] || printf '%s\n' "$line" ;; esac
done < "$page" > "$made"
[ ! "$is_table" ] || { echo "$page: a table has no end" >&2; exit 1; }
cat "$made" > "$page"
[ "$images" = none ] || {
  "$tool" stability --format svg -o "$images/stability.svg"
  "$tool" stability --verdicts --format svg -o "$images/verdicts.svg"
}
