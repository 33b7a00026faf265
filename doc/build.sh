#!/usr/bin/env bash
# Copyright (c) 2026 The Bounding Arcs authors.
# SPDX-License-Identifier: GPL-3.0-or-later
#
# Makes the manual in build/manual, from index.html on. Fails for anything that Doxygen warns of, but for what needs no
# description, see below; for links of pages that lead nowhere, in the manual or in the repository; for sources that
# pages name and that are not there; for pages and programs that are not listed; and for a page that loads anything from
# elsewhere.
# Usage: bash doc/build.sh [DOXYGEN]
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."
doxygen=${1:-doxygen}
command -v "$doxygen" > /dev/null || { echo "doc/build.sh: $doxygen is not installed" >&2; exit 2; }
export LC_ALL=C.UTF-8
status=0

# refuse MESSAGE PLACES: any place is a failure.
refuse() {
  [ -n "$2" ] || return 0
  printf '%s\n%s\n' "$1" "$2" >&2
  status=1
}

refuse 'Links to files that are not there:' "$(for page in README.md doc/*.md; do
  grep -oE '\]\([^) #]+(#[^) ]*)?\)' "$page" | sed 's/^](//; s/[#)].*//' | while read -r target; do
    [[ $target =~ ^[a-z]+: ]] || [ -e "$(dirname "$page")/$target" ] || echo "$page: $target"
  done
done)"
refuse 'Paths of sources that are not there:' "$(for page in README.md doc/*.md; do
  [ "$page" != doc/CHANGELOG.md ] || continue  # which tells of what was
  grep -oE '`[A-Za-z_0-9./]+/[A-Za-z_0-9.]+\.(h|cpp|sh)`' "$page" | tr -d '`' | sort -u | while read -r path; do
    for place in . include include/CGAL/Bounding_arcs_2 src test; do [ ! -e "$place/$path" ] || continue 2; done
    echo "$page: $path"
  done
done)"
refuse 'Not listed in doc/index.md or doc/examples.md:' "$(for file in doc/*.md examples/*.cpp; do
  [ "$file" = doc/index.md ] || grep -q "[(/]$(basename "$file"))" doc/index.md doc/examples.md || echo "$file"
done)"
rm -rf build/manual
mkdir -p build
warnings=$("$doxygen" doc/Doxyfile 2>&1 > /dev/null) || { printf '%s\n' "$warnings" >&2; exit 1; }
# Described where names do not say all: members of classes, and helpers in folders that users need nothing of.
member='Member .* of (class|struct) .* is not documented\.$'
rooms='number|polynomial|arc|frame|spiral|verify|study'
helper="/($rooms)/.* \((function|variable|typedef)\) of namespace .* is not documented\.$"
refuse 'Doxygen warns:' "$(grep -vE "$member|$helper" <<< "$warnings" | sed "s|^$PWD/||" | sort -u || true)"
cd build/manual
# What Doxygen has no option for: names in the navigation without what they all begin with, and concepts by their name.
sed -i 's/^\( *\[ "\)CGAL::Bounding_arcs::/\1/' ./*.js
for concept in ../../doc/concepts/*.h; do
  page=$(basename "$concept" .h)
  sed -i '/#include &lt;concepts/d; s/ Struct Reference/ Concept Reference/' "struct${page//_/__}.html"
done
# of references from pages to what is in the manual, those that lead nowhere
refuse 'Links that lead nowhere:' "$(awk '
  FNR == 1 { name = substr(FILENAME, 3); there[name] = 1 }
  {
    for (rest = $0; match(rest, / (id|name)="[^"]+"/); rest = substr(rest, RSTART + RLENGTH)) {
      value = substr(rest, RSTART, RLENGTH - 1)
      sub(/[^"]*"/, "", value)
      there[name "#" value] = 1
    }
    for (rest = name ~ /^(index|page_)/ ? $0 : ""; match(rest, /href="[^"]+"/); rest = substr(rest, RSTART + RLENGTH)) {
      value = substr(rest, RSTART + 6, RLENGTH - 7)
      if (value ~ /^#/) value = name value
      if (value !~ /:|\.(css|js|svg|png)$/) from[value] = name
    }
  }
  END { for (value in from) if (!(value in there)) print from[value] ": " value }' ./*.html | sort)"
refuse 'Loaded from elsewhere:' "$(grep -nEi '(src|<link[^>]*href|<object[^>]*data)="?(https?:)?//' ./*.html || true)"
[ $status -ne 0 ] || echo "The manual is in build/manual/index.html"
exit $status
