#!/usr/bin/env bash
# Copyright (c) 2026 The Bounding Arcs authors.
# This file is part of Bounding Arcs, an add-on to CGAL.
# SPDX-License-Identifier: GPL-3.0-or-later
#
# The info subcommand as a user runs it: what it tells of curves, holes, joints, loose ends, and what was left out.
# Which curves --layers and --ids take, in all subcommands.
# Usage: test_info.sh TOOL PROJECT_ROOT
. "$(dirname "${BASH_SOURCE[0]}")/support.sh"

dxf() {  # UNIT ENTITIES
  printf '0|SECTION|2|HEADER|9|$INSUNITS|70|%s|0|ENDSEC|0|SECTION|2|ENTITIES|%s0|ENDSEC|0|EOF|' "$1" "$2" | tr '|' '\n'
}
segment() { printf '0|LINE|8|%s|10|%s|20|%s|11|%s|21|%s|' "$@"; }
circle() { printf '0|CIRCLE|8|%s|10|%s|20|%s|40|%s|' "$@"; }
plate=$(segment Plate 0 0 10 0; segment Plate 10 0 10 6; segment Plate 0 6 10 6; segment Plate 0 6 0 0)
rest=$(circle Hole 3 3 2; circle Hole 3 3 1; segment Dim 0 8 4 8; segment Dim 4.5 8 10 8)
dxf 1 "$plate${rest}0|MTEXT|8|0|1|x|" > part.dxf

# expect_output PATTERN...: lines of the output are like these, in this order
expect_output() {
  local at=0 line
  mapfile -t found < "$results/out"
  for line in "$@"; do
    # shellcheck disable=SC2053
    while [ "$at" -lt "${#found[@]}" ] && [[ ${found[$at]} != $line ]]; do at=$((at + 1)); done
    [ "$at" -lt "${#found[@]}" ] || fail "$command_line: no line like $line in its place in $(cat "$results/out")"
    at=$((at + 1))
  done
}
run info part.dxf
expect_status 0
[ -z "$err" ] || fail "$command_line: said $err, which is in the output"
expect_output 'part.dxf: 5 curves, 3 closed and 2 open; 1 unit is 25.4 mm; evenodd rule' \
  'left out: 1 MTEXT: no curve' \
  'joined: 4 open curves to 1 closed one' \
  '2 curves run the same way as the one around each: 1, 2; holes by the evenodd rule, not by the nonzero one' \
  '2 open curves, the first from (0, 8) to (4, 8): no inside' \
  'curve  name     layer  closed  pieces  length   area     runs  inside  x and y' \
  '0      Plate.1  Plate  closed  4       32       60       ccw   -       0..10 0..6' \
  '1      Hole.1   Hole   closed  4       12.5664  12.5664  ccw   0       1..5 1..5' \
  '2      Hole.2   Hole   closed  4       6.28319  3.14159  ccw   1       2..4 2..4' \
  '3      Dim.1    Dim    open    1       4        -        -     -       0..4 8..8' \
  '4      Dim.2    Dim    open    1       5.5      -        -     -       4.5..10 8..8' \
  'end                     nearest other end       distance' \
  'start of 3 at (0, 8)    end of 3 at (4, 8)      4' \
  'end of 3 at (4, 8)      start of 4 at (4.5, 8)  0.5' \
  'start of 4 at (4.5, 8)  end of 3 at (4, 8)      0.5' \
  'end of 4 at (10, 8)     start of 4 at (4.5, 8)  5.5'
cp "$results/out" first
run info part.dxf
cmp -s first "$results/out" || fail "$command_line: another answer the second time"

run info part.dxf --rule nonzero --join-ends 0.5 --hidden
expect_output 'joined: 6 open curves to 1 closed and 1 open ones, ends moved by up to 0.5' \
  '2 curves *: 1, 2; they are no holes by the nonzero rule, --rule evenodd makes them holes' \
  '3      Dim.1    Dim    open    2       10       -        -     -       0..10 8..8'
run info part.dxf --skip-open
expect_output 'part.dxf: 3 curves, 3 closed and 0 open;*' 'left out: 2 open curves*'
! grep -q 'Dim' "$results/out" || fail "$command_line: has an open curve"
run info part.dxf --strict --join-ends 0
expect_status 1
expect_silence
expect_line 'bounding_arcs: part.dxf: --strict: *1 MTEXT: no curve'

# Other forms.
run info part.dxf -o out.json
expect_status 0
json() { grep -qF -e "$1" out.json || fail "info -o out.json: no $1 in $(cat out.json)"; }
json '"unit_in_mm":25.4,'
json '"closed":3,'
json '{"curve":0,"name":"Plate.1","layer":"Plate","closed":true,"parts":4,"pieces":4,'
json '"direction":"ccw","inside":1,'
json '{"curve":3,"end":"end","at":[4.0,8.0],"nearest":{"curve":4,"end":"start","at":[4.5,8.0]},"distance":0.5}'
json '{"count":1,"what":"MTEXT","reason":"no curve","read":false}'
json '"same_direction":[1,2]'
if command -v python3 > /dev/null; then
  python3 -c 'import json
curves = json.load(open("out.json"))["curves"]
assert [c["inside"] for c in curves] == [None, 0, 1, None, None]
assert abs(curves[1]["area"] - 12.566370614) < 1e-6' ||
    fail 'info -o out.json: is not what is read'
fi
run info part.dxf -o out.csv
[ "$(wc -l < out.csv)" -eq 6 ] || fail "$command_line: not a line a curve"
run info part.dxf -o out.svg
[ "$(grep -c '<path class="h"' out.svg)" -eq 1 ] && [ "$(grep -c 'path class="c"' out.svg)" -eq 2 ] &&
  [ "$(grep -c 'path class="o"' out.svg)" -eq 2 ] || fail "$command_line: not a hole, two others and two open curves"
for i in 0 1 2 3 4; do grep -q ">$i</text>" out.svg || fail "$command_line: no number $i"; done
[ "$(grep -c '<circle' out.svg)" -eq 4 ] || fail "$command_line: not four open ends"

# What runs the other way is told; inside is by the curves themselves, not by their boxes.
svg() { printf '<svg xmlns="http://www.w3.org/2000/svg">%s</svg>' "$1"; }
svg '<path d="M0 0h9v9h-9z M3 3v3h3v-3z"/><path d="M20 0l9 9h-9z"/><path d="M27 1h1v1h-1z"/>' > two.svg
run info two.svg
expect_output 'two.svg: 4 curves, 4 closed and 0 open; no unit told; nonzero rule' \
  '0      path1.1  -      closed  4       36*81*ccw   -  *' \
  '1      path1.2  -      closed  4       12*9 *cw    0  *' '3      path3 * ccw   -  *'
! grep -q 'the same way' "$results/out" || fail "$command_line: the hole runs the other way"
printf '{"curves":[]}' > none.json
run info none.json
expect_status 0
expect_output 'none.json: 0 curves, 0 closed and 0 open*'
run info none.json --format svg
expect_status 0

# Layers and names, for all subcommands; a joined curve has the name of its first part.
count() {  # WANTED ARGUMENTS: so many curves are read
  local wanted=$1
  shift
  run info "$@" --format json
  expect_status 0
  [ "$(grep -c '^\[\?{"curve":.*"name"' "$results/out")" -eq "$wanted" ] || fail "$command_line: not $wanted curves"
}
count 2 part.dxf --layers Hole
count 3 part.dxf --layers hole,PLATE
count 1 part.dxf --ids Plate.1
count 2 part.dxf --ids Dim
count 3 part.dxf --ids Hole.2,Dim
count 2 two.svg --ids path1
count 1 part.dxf --layers Hole --ids Hole.2
run query locate part.dxf --layers Plate --points <(echo 3 3)
grep -q '"winding":1' "$results/out" || fail "$command_line: the holes are there"
run boolean union part.dxf --ids Hole.1,Hole.2
[ "$(grep -c '"type":"path"' "$results/out")" -eq 2 ] || fail "$command_line: not a ring"
run info part.dxf --layers Hole,Cut
expect_status 1
expect_silence
expect_line 'bounding_arcs: part.dxf: --layers: expected layers that have curves, Dim, Hole or Plate, found "Cut"'
run info two.svg --layers Cut
expect_line 'bounding_arcs: two.svg: --layers: expected a file with layers, found "Cut"'
run info part.dxf --ids Plate.2  # joined to the first one
expect_line 'bounding_arcs: part.dxf: --ids: expected names of curves, which the subcommand info lists, found "Plate.2"'

# Layers of Inkscape are layers.
printf '<svg xmlns="http://www.w3.org/2000/svg" xmlns:inkscape="http://www.inkscape.org/namespaces/inkscape">%s</svg>' \
  '<g inkscape:groupmode="layer" inkscape:label="Cut"><rect id="r" width="4" height="2"/></g><circle r="9"/>' > ink.svg
run info ink.svg --layers cut --format csv
expect_status 0
[ "$(cut -d, -f2,3 "$results/out" | tail -n +2)" = r,Cut ] || fail "$command_line: $(cat "$results/out")"

rm -f ./*
finish
