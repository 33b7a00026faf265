#!/usr/bin/env bash
# Copyright (c) 2026 The Bounding Arcs authors.
# SPDX-License-Identifier: GPL-3.0-or-later
#
# The rules of style that a program can check: sources are as clang-format leaves them, no line is longer than 120
# columns, files include from rooms before their own and all that they name, public classes have a comment, comments
# begin with their subject, pages begin with a question and a picture, their sentences are short, tests stand in the
# folders of the rooms, and README.md names the packages that scripts install.
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
refuse 'Tests of the tool that do not end by finish, and so cannot fail:' \
  "$(for f in test/tool/test_*.sh; do tail -n 1 "$f" | grep -q '^finish' || echo "$f"; done)"
refuse 'Longer than 120 columns:' "$(grep -nE '^.{121,}' "${sources[@]}" "${scripts[@]}" | cut -d: -f1,2)"
# Rooms, ground first: a file includes from rooms before its own, and only what is at their top. What is in src/library
# has the rooms of the headers, and src/study is the room study.
rooms='number polynomial curve arc frame spiral region tree query chain overlay boolean arrangement offset'
rooms="$rooms medial_axis exchange verify study"
refuse 'Includes from a later room, or from the inside of another one:' \
  "$(grep -rnoE '#include (<CGAL/Bounding_arcs_2/|"[./]*\.\./)[^>"]+' include/CGAL/Bounding_arcs_2 src/library \
    src/study |
    awk -F: -v rooms="$rooms" '
    BEGIN { for (n = split(rooms, r, " "); n > 0; --n) place[r[n]] = n }
    { path = $1; sub(/^(include\/CGAL\/Bounding_arcs_2|src\/library|src)\//, "", path); split(path, own, "/")
      sub(/.*(Bounding_arcs_2|\.\.)\/(library\/)?/, "", $3); depth = split($3, other, "/")
      is_below = place[other[1]] && place[other[1]] < place[own[1]]
      if (other[1] != own[1] && !(is_below && depth == 2)) print $1 ":" $2 }')"
refuse 'Outside of a folder internal, the tool, examples and tests by what users do not see:' \
  "$(grep -rnE '(ba|arcs)::internal::' src/tool examples test --include='*.cpp' --include='*.h' |
    grep -vE '^test/([a-z_]+/internal|consumer)/' | cut -d: -f1,2)"
refuse 'Names whose header is not included:' \
  "$(printf '%s\n' "${sources[@]}" | grep -E '^(include|src)/' | xargs awk -f test/style/includes.awk)"
refuse 'Comments without a subject: say what it is that is "Of ..." or "The same ...":' "$(
  grep -rnE '^ *///? (Of|The same|That of|Those|Its|Nor) |^ *///?.*\. +(Of|That of|Those of|Nor) ' \
    include src doc/concepts | cut -d: -f1,2)"
refuse 'Classes of public headers without a comment right above:' "$(
  find include/CGAL/Bounding_arcs_2 -name '*.h' -not -path '*/internal/*' -exec awk '
    /^(template <.*> )?(class|struct|enum class) [A-Z]/ && !/;/ && !/^template <> / && above !~ /^\/\/\// {
      print FILENAME ":" FNR }
    !/^(template|  .*>$)/ { above = $0 }' {} +)"
mapfile -t pages < <(printf '%s\n' README.md doc/*.md | grep -v CHANGELOG)
refuse 'Pages whose second line is not their question, **...?**, or without a picture in the first 30 lines:' "$(
  awk 'FNR == 3 && /^\*\*.*\?\*\*$/ { asks[FILENAME] = 1 } FNR <= 30 && /!\[/ { shows[FILENAME] = 1 }
    { seen[FILENAME] = 1 }
    END { for (f in seen) if (f != "README.md" && !(f in asks && f in shows)) print f }' "${pages[@]}" | sort)"
# Words count from blank to blank. Cells of tables count for the longest sentence only. Code, formulas that are set in
# and the numbers of lists do not count.
refuse 'Sentences of more than 30 words, or of more than 16 on the mean:' "$(awk '
  function finish() {
    if (words > 30) print FILENAME ":" FNR ": a sentence of " words " words ends"
    if (words && !in_table) { ++sentences[FILENAME]; total[FILENAME] += words }
    words = 0
  }
  function take(text,    count, i, word) {
    count = split(text, word, " ")
    for (i = 1; i <= count; ++i) {
      if (word[i] ~ /[^[:punct:]]/) ++words
      if (word[i] ~ /[.!?][])*]*$/) finish()
    }
  }
  FNR == 1 || /^(```|#|\||<!--| *\* | *[0-9]+\. |    |$)/ { finish() }
  { in_table = /^\|/; gsub(/\]\([^)]*\)/, "]"); sub(/^ *[0-9]+\. /, "") }
  /^```/ { in_code = !in_code }
  in_code || /^(```|#|\|-|<!--|    )/ { next }
  in_table { cells = split($0, cell, "|"); for (c = 1; c <= cells; ++c) { take(cell[c]); finish() } next }
  { take($0) }
  END { finish(); for (f in total) if (total[f] > 16 * sentences[f]) print f ": " total[f] / sentences[f] " words" }
  ' "${pages[@]}" | sort -V)"
refuse 'README.md installs other packages than .ci/packages_build.txt lists:' \
  "$(diff <(sed -n 's/^apt-get install //p' README.md | tr ' ' '\n') .ci/packages_build.txt)"
# What users can name is a list, so that a new name is a decision; --fix writes it.
names=$(find include/CGAL/Bounding_arcs_2 -name '*.h' -not -path '*/internal/*' | LC_ALL=C sort |
  xargs awk -f test/style/public_names.awk | LC_ALL=C sort -u)
[ "${1:-}" != --fix ] || printf '%s\n' "$names" > test/style/public_names.txt
refuse 'Names of public headers that are not in test/style/public_names.txt (>), or only there (<):' \
  "$(diff test/style/public_names.txt <(printf '%s\n' "$names") | grep '^[<>]')"
# What is installed is what a user includes, and what templates need that a user instantiates. These limits are what is
# there, and are lowered with it.
# limit WHAT MOST COUNT: more than the most is a failure.
limit() {
  [ "$3" -le "$2" ] || refuse "$1: expected at most $2, found $3" 'test/style/run.sh says why there is a limit'
}
# named KIND ROOMS: counts the names of a kind at the tops of rooms.
named() { grep -cE "^(${2// /|}) $1 " <<< "$names"; }
for_users='curve tree query chain overlay boolean offset medial_axis arrangement exchange'
for_kernels='number polynomial arc frame spiral region verify'
mapfile -t installed < <(find include/CGAL/Bounding_arcs_2 -name '*.h')
limit 'Installed headers' 143 "${#installed[@]}"
limit 'Lines of installed headers' 16852 "$(cat "${installed[@]}" | wc -l)"
limit 'Types in rooms for users' 60 "$(named type "$for_users")"
limit 'Functions in rooms for users' 80 "$(named function "$for_users")"
limit 'Types in rooms for kernels' 59 "$(named type "$for_kernels")"
limit 'Functions in rooms for kernels' 88 "$(named function "$for_kernels")"
refuse 'Not in the folder of a room, of input or of tool:' \
  "$(find test -name 'test_*.cpp' | grep -vE "^test/(${rooms// /|}|input|tool)/(internal/)?[^/]+$")"
exit $status
