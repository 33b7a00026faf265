#!/usr/bin/env bash
# Copyright (c) 2026 The Bounding Arcs authors.
# This file is part of Bounding Arcs, an add-on to CGAL.
# SPDX-License-Identifier: GPL-3.0-or-later
#
# The boolean subcommand as a user runs it: operations, forms of output, and what is said of wrong options.
# Usage: test_boolean.sh TOOL PROJECT_ROOT
. "$(dirname "${BASH_SOURCE[0]}")/support.sh"

# square NAME X Y: of side 2, with that lower left corner.
square() {
  cat > "$1.json" <<JSON
{"name":"$1","type":"bspline","degree":1,"knots":[0,0,1,2,3,4,4],"closed":true,
 "control_points":[[$2,$3],[$(($2 + 2)),$3],[$(($2 + 2)),$(($3 + 2))],[$2,$(($3 + 2))],[$2,$3]]}
JSON
}
square a 0 0
square b 1 1
square c 2 0

# expect_area A: what the last run wrote fills so much.
expect_area() {
  local area
  cp "$results/out" result.json
  area=$("$tool" offset result.json --distance 0 --eps 1e-9 | grep -o '"area":[^,]*' | cut -d: -f2 |
    awk '{ sum += $1 } END { printf("%.6g", sum) }')
  [ "$area" = "$1" ] || fail "$command_line: the area is $area instead of $1"
}

run boolean union a.json b.json
expect_status 0
expect_finite
expect_area 7
grep -q '"status":"complete"' "$results/out" || fail "$command_line: not complete"
[ "$(grep -c '"type":"path"' "$results/out")" -eq 1 ] || fail "$command_line: not one chain"
grep -q '"source":{"operand":1,"curve":0,"name":"b","bezier":' "$results/out" || fail "$command_line: no sources"
run boolean intersection a.json b.json
expect_area 1
run boolean difference a.json b.json
expect_area 3
run boolean symmetric-difference a.json b.json
expect_area 6
# other words for them
for words in 'or 7' 'and 1' 'intersect 1' 'subtract 3' 'xor 6' 'symdiff 6'; do
  run boolean "${words% *}" a.json b.json
  expect_status 0
  expect_area "${words#* }"
done
grep -q '"operation":"symmetric-difference"' result.json || fail "$command_line: not the main word"
# squares that share an edge, and one that is given twice
run boolean union a.json c.json
expect_area 8
[ "$(grep -c '"type":"path"' "$results/out")" -eq 1 ] || fail "$command_line: not one chain"
run boolean intersection a.json c.json
expect_status 0
[ "$(grep -c '"type":"path"' "$results/out")" -eq 0 ] || fail "$command_line: there are chains"
run boolean union a.json a.json b.json --kernel exact
expect_area 7

# The place and the curves are told where doubles do not tell how they meet.
run boolean union a.json c.json --kernel double
expect_status 1
expect_line 'bounding_arcs: a.json: union: curves "a" and "c" meet at about (2, *) in a way that doubles do not tell; '\
'use --kernel filtered'

run boolean union "$root/examples/data/d_rabbit.json" "$root/examples/data/e_cat.json" --format svg -o picture.svg
expect_status 0
grep -q '</svg>' picture.svg || fail "$command_line: no picture"
run boolean union a.json b.json --format dxf --eps 1e-6 -o result.dxf
expect_status 0
run boolean union result.dxf a.json
expect_status 0

cat > open.json <<'JSON'
{"name":"open","type":"bezier","degree":1,"control_points":[[0,0],[1,1]]}
JSON
run boolean union a.json open.json
expect_status 1
expect_silence
expect_line 'bounding_arcs: open.json: curve "open": expected a closed curve, which has an inside, found an open one'
run boolean unite a.json
expect_status 2
run boolean union a.json --format dxf
expect_status 2
expect_line 'bounding_arcs: --eps: expected a tolerance for arcs in DXF, found none'
run boolean union a.json -o result.dxf
expect_status 2
expect_line 'bounding_arcs: --eps: expected a tolerance for arcs in DXF, found none'
run boolean union a.json --eps 1
expect_status 2
expect_line 'bounding_arcs: --format: expected dxf with --eps, which no other form has, found json'
run boolean union - -
expect_status 2

# Paths, which results are, as curve files.
cat > path.json <<'JSON'
{"type":"path","pieces":[{"control_points":[[0,0],[1,0]]},{"control_points":[[2,0],[0,0]]}]}
JSON
run boolean union path.json
expect_status 1
expect_line 'bounding_arcs: path.json: pieces\[1\]: expected a piece that starts where the one before ends, found*'
echo '{"type":"path"}' > path.json
run boolean union path.json
expect_status 1
expect_line 'bounding_arcs: path.json: curve: expected the key "pieces", found none'
echo '{"type":"path","pieces":[]}' > path.json
run boolean union path.json
expect_status 1
expect_line 'bounding_arcs: path.json: pieces: expected at least one piece, found none'
echo '{"type":"path","pieces":[{"control_points":[[0,0],[1,"x"]]}]}' > path.json
run boolean union path.json
expect_status 1
expect_line 'bounding_arcs: path.json: pieces\[0\].control_points\[1\]\[1\]: expected a finite number, found "x"'
finish
