#!/usr/bin/env bash
# Copyright (c) 2026 The Bounding Arcs authors.
# This file is part of Bounding Arcs, an add-on to CGAL.
# SPDX-License-Identifier: GPL-3.0-or-later
#
# Pictures: dots that hide nothing, however small what is drawn, and captions that name what is drawn and no more.
# Usage: test_pictures.sh TOOL PROJECT_ROOT
. "$(dirname "${BASH_SOURCE[0]}")/support.sh"

# A sheet of 15 x 15 rings, of 12 pieces each.
awk 'BEGIN {
  print "<svg xmlns=\"http://www.w3.org/2000/svg\">"
  for (i = 0; i < 225; ++i) {
    x = i % 15 * 100; y = int(i / 15) * 100
    printf "<path d=\"M%g %g", x + 20, y
    for (k = 1; k <= 12; ++k) {
      a = k * 0.5235987755982988; m = a - 0.2617993877991494; r = 20 / cos(0.2617993877991494)
      printf "Q%.4f %.4f %.4f %.4f", x + r * cos(m), y + r * sin(m), x + 20 * cos(a), y + 20 * sin(a)
    }
    print "\"/>"
  }
  print "</svg>"
}' > sheet.svg
line='{"name":"line","type":"bezier","degree":1,"control_points":[[0,0],[3,1]]}'
bow='{"name":"bow","type":"bezier","degree":3,"control_points":[[0,0],[1,2],[2,-1],[4,0]]}'
printf '%s' "$line" > line.json
printf '%s' "$bow" > bow.json

# widest CLASS PIXELS: dots of that class are at most so wide in the last run's picture, and do not outgrow it.
widest() {
  local rule
  rule=$(grep -oE "\\.$1\\{[^}]*\\}" "$results/out" | grep -v vector-effect)
  awk -v rule="$rule" -v most="$2" 'BEGIN { exit !(match(rule, /stroke-width:[0-9.]+/) && \
    substr(rule, RSTART + 13, RLENGTH - 13) + 0 <= most) }' || fail "$command_line: dots $1 are too wide: $rule"
  ! grep -qE "(path|[.,]$1)[^}]*\{[^}]*vector-effect" "$results/out" ||
    fail "$command_line: dots $1 keep their width"
}
# wide CLASS PIXELS: they are exactly so wide, as there is room.
wide() { grep -qE "\\.$1\\{[^}]*stroke-width:$2[;}]" "$results/out" || fail "$command_line: dots $1 are not $2 wide"; }
# says PATTERN, says_not PATTERN: the text of the last run's picture.
says() { grep '<text' "$results/out" | grep -qE -e "$1" || fail "$command_line: the picture says nothing of $1"; }
says_not() { ! grep '<text' "$results/out" | grep -qE -e "$1" || fail "$command_line: the picture speaks of $1"; }

# Ends of pieces are 7.2 pixels apart.
run build --method bca --eps 1e-2 --format svg sheet.svg
widest s 3.6
run arcs --eps 1e-2 --format svg sheet.svg
widest e 3.6
input=<(echo 1 1) run query closest --points - --format svg sheet.svg
widest d 3.6
run build --method bca --eps 0.3 --format svg bow.json
wide s 5.5
wide e 4.5
run arcs --eps 0.3 --format svg bow.json
wide e 4.5

{  # small squares, whose axes have edges of 1.4, beside a large one
  echo '<svg xmlns="http://www.w3.org/2000/svg"><path d="M0 0H1000V1000H0z"/>'
  for x in 1010 1020 1030; do echo "<path d=\"M$x 0h2v2h-2z\"/>"; done
  echo '</svg>'
} > squares.svg
run medial-axis --eps 1e-2 --format svg squares.svg
[ "$(grep -c 'class="v"' "$results/out")" -gt 8 ] || fail "$command_line: the axis has few vertices"
! grep 'class="v"' "$results/out" | grep -vE 'r="0\.[0-3]' || fail "$command_line: dots are larger than squares"
run build --method bca --eps 1e-1 --format svg line.json
says 'where spiral segments end'
says_not 'red'
run build --method bca --eps 1e-3 --format svg bow.json
says 'black .* red'
run offset --distance 1 --eps 1e-2 --format svg bow.json
says 'grey: the curve; blue: grown<'
head -3 sheet.svg > two.svg
echo '</svg>' >> two.svg
run offset --distance 1,-1 --eps 1e-2 --format svg two.svg
says 'grey: the curves; blue: grown; orange: shrunk'
run offset --distance -30 --eps 1e-2 --format svg two.svg  # nothing is left
says 'grey: the curves<'
run stability --family random --count 1 --format svg
says 'sfa, textbook'

# Titles have four digits of a tolerance or distance.
for command in 'arcs --eps 0.0123456' 'build --method bca --eps 0.0123456' 'offset --distance 0.1 --eps 0.0123456'; do
  # shellcheck disable=SC2086
  run $command --format svg bow.json
  says '0\.01235'
  says_not '0123456'
done
sed 's/\[0,0\]/[0,7]/; s/\[4,0\]/[5,7]/' bow.json > other.json
run query distance other.json line.json --format svg
says_not '[0-9]\.[0-9]{4}'
says 'distance: [0-9]'

rm ./*.json ./*.svg
finish
