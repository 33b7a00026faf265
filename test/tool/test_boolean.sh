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

# A sliver that is narrower than rounding is no chain along a line and back.
printf '<svg xmlns="http://www.w3.org/2000/svg"><path d="M0-1L.7.1 4.9.7 0 0Z"/></svg>' > sliver.svg
run boolean union sliver.svg
expect_status 0
[ "$(grep -c '"type":"path"' "$results/out")" -eq 1 ] || fail "$command_line: not one chain: $(cat "$results/out")"
! grep -q '"moved":0[,}]' "$results/out" || fail "$command_line: the sliver was not counted"

# How far rounding moved the result: not at all where no curve is cut inside.
run boolean union a.json c.json
grep -q '"status":"complete","moved":0,"curves"' "$results/out" || fail "$command_line: $(head -c 99 "$results/out")"
# Tiles whose sides are an ulp apart, as programs compute them, overlap by that. What is written is combined again.
cat > tiles.py <<'PYTHON'
import itertools, json, sys
tiles = {"low": (0, 0, 1, 0.1 + 0.2), "high": (0, 0.3, 1, 1), "third": (1 / 3, 0.1, 1 / 3 + 0.7, 0.7)}
if len(sys.argv) == 1:
    for name, (x, y, z, w) in tiles.items():
        p = [[x, y], [z, y], [z, w], [x, w]]
        sides = [{"control_points": [p[i - 1], p[i]]} for i in range(4)]
        json.dump({"type": "path", "pieces": sides}, open(name + ".json", "w"))
else:  # the area by cells of the grid that the sides make
    xs, ys = (sorted({v for t in tiles.values() for v in t[k::2]}) for k in (0, 1))
    area = 0
    for (x, z), (y, w) in itertools.product(zip(xs, xs[1:]), zip(ys, ys[1:])):
        has = {name: a <= x and z <= c and b <= y and w <= d for name, (a, b, c, d) in tiles.items()}
        filled = has["low"] or has["high"]
        for operation, name in (step.split() for step in sys.argv[1:]):
            filled = {"union": filled or has[name], "intersection": filled and has[name],
                      "difference": filled and not has[name], "symmetric-difference": filled != has[name]}[operation]
        area += filled * (z - x) * (w - y)
    print("%.6g" % (area if area > 1e-12 else 0))
PYTHON
python3 tiles.py
run boolean union low.json high.json
expect_status 0
expect_area 1
cp result.json chain.json
steps=()
for step in 'intersection third' 'union low' 'difference third' 'symmetric-difference high' 'union third' \
  'symmetric-difference low' 'intersection high' 'union third' 'difference low' 'symmetric-difference high'; do
  steps+=("$step")
  run boolean "${step% *}" chain.json "${step#* }.json"
  expect_status 0
  moved=$(grep -o '"moved":[^,]*' "$results/out" | cut -d: -f2)
  awk "BEGIN { exit !($moved >= 0 && $moved < 1e-14) }" || fail "$command_line: moved by $moved"
  expect_area "$(python3 tiles.py "${steps[@]}")"
  cp result.json chain.json
done

# The place and the curves are told where doubles do not tell how they meet.
run boolean union a.json c.json --kernel double
expect_status 1
expect_line 'bounding_arcs: a.json: union: curves "a" and "*" meet at about (*, *) in a way that doubles do not tell; '\
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
run boolean union a.json --eps 1
expect_status 2
expect_line 'bounding_arcs: --format: expected dxf, or svg with --plain, with --eps, which no other form has, '\
'found json'
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
