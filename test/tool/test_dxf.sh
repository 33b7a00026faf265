#!/usr/bin/env bash
# Copyright (c) 2026 The Bounding Arcs authors.
# This file is part of Bounding Arcs, an add-on to CGAL.
# SPDX-License-Identifier: GPL-3.0-or-later
#
# DXF: arcs and offsets out with every digit, entities in as long as they are, and what is refused.
# Usage: test_dxf.sh TOOL PROJECT_ROOT
. "$(dirname "${BASH_SOURCE[0]}")/support.sh"

# dxf ENTITIES [BLOCKS]: a file of these, groups with | between.
dxf() {
  printf '0|SECTION|2|BLOCKS|%s0|ENDSEC|0|SECTION|2|ENTITIES|%s0|ENDSEC|0|EOF|' "${2:-}" "$1" | tr '|' '\n'
}
run arcs --eps 1 --format dxf <(dxf '0|LINE|8|a|10|0|20|0|11|1|21|1|')
if [[ $err == *'without dxflib'* ]]; then finish; fi

# Out: the numbers of JSON, all digits of them; y of a drawing downwards changes its sign.
vertices() {  # x, y and bulge of each vertex, a line each
  awk '{ code = $1; getline; sub(/\r/, "") } code == 0 { on = $0 == "LWPOLYLINE" }
       on && code == 10 { if (have) print x, y, b; x = $0; b = 0; have = 1 } on && code == 20 { y = $0 }
       on && code == 42 { b = $0 } code == 0 && have && $0 != "LWPOLYLINE" { print x, y, b; have = 0 }' "$1"
}
starts() {  # the same of arcs in JSON
  grep -oE '"from":\[[^]]*\],"to":\[[^]]*\](,"bulge":[^,]*)?' "$1" |
    sed -E 's/"from":\[([^,]*),([^]]*)\],"to":[^]]*\](,"bulge":)?/\1 \2 /; s/ $/ 0/'
}
curve=$root/examples/data/a_wrench.json
run arcs --eps 1e-4 --format json "$curve" -o arcs.json
run arcs --eps 1e-4 --format dxf "$curve" -o arcs.dxf
expect_status 0
expect_silence
starts arcs.json > wanted
vertices arcs.dxf | head -n "$(wc -l < wanted)" > found
[ "$(wc -l < wanted)" -gt 50 ] || fail 'there are few arcs to compare'
cmp -s wanted found || fail "DXF has other arcs than JSON: $(diff wanted found | head -4)"
[ "$(sed -n '/^LWPOLYLINE/,/^LWPOLYLINE/p' arcs.dxf | grep -c '^a_wrench$')" -ge 1 ] || fail 'the layer is not named'
[ "$(grep -c '^a_wrench$' arcs.dxf)" -ge 2 ] || fail 'the layer is in no table'
run arcs --eps 1e-4 --format dxf "$curve"
cmp -s arcs.dxf "$results/out" || fail 'standard output gets another drawing than -o'

# and in again: ends are the same doubles, and the arcs the same circles; two neighbours of one circle are one arc now
run arcs --eps 1e-9 --continuity position --format json arcs.dxf
expect_status 0
grep -q '"name":"a_wrench"' "$results/out" || fail 'the layer did not come back as a name'
starts "$results/out" | cut -d' ' -f1,2 | sort > ends
cut -d' ' -f1,2 found | sort > starts
[ "$(comm -23 starts ends | wc -l)" -le 1 ] || fail "ends did not come back: $(comm -23 starts ends | head -3)"

printf '<svg xmlns="http://www.w3.org/2000/svg"><path id="bow" d="M0 0C1 2 3 -1 4 1"/></svg>' > bow.svg
run arcs --eps 1e-3 --format json bow.svg -o bow.json
run arcs --eps 1e-3 --format dxf bow.svg -o bow.dxf
starts bow.json | awk '{ print $1, $2 + 0 == 0 ? "" : $2 }' | tr -d '-' > wanted
vertices bow.dxf | awk '{ print $1, $2 + 0 == 0 ? "" : $2 }' | tr -d '-' | head -n "$(wc -l < wanted)" > found
cmp -s wanted found || fail 'the drawing has other arcs as DXF'
sign() { sed -n 2p | cut -d' ' -f2 | cut -c1 | tr -c -- - +; }
[ "$(starts bow.json | sign)" != "$(vertices bow.dxf | sign)" ] || fail 'the drawing is upside down'
turns() { awk '$3 + 0 != 0 { print ($3 < 0) }' | tr -d '\n'; }  # of each arc, the way it turns
[ "$(starts bow.json | turns | tr 01 10)" = "$(vertices bow.dxf | turns)" ] || fail 'arcs turn the wrong way'
# as arcs and lines: a piece each, with the same ends and together as long
# measures FILE EACH: how many pieces, or curves, a file in JSON has, the length of all, and the sums of x and y of the
# ends of each
measures() {
  sed -E 's/\{"name"/\n&/; s/"bulge"//; s/,"center.*//' "$1" | awk -v each="$2" '
    function flush() { if (have) { ++n; x += x0 + x1; y += y0 + y1 } have = 0 }
    /"name"/ || each == "piece" { flush() }
    match($0, /"from":.*/) {
      $0 = substr($0, RSTART); gsub(/"[a-z]+"/, ""); gsub(/[^0-9.e+-]/, " "); $0 = $0
      if (!have) { x0 = $1; y0 = $2 }
      x1 = $3; y1 = $4; have = 1
      c = sqrt(($1 - $3)^2 + ($2 - $4)^2); b = NF > 4 ? $5 : 0; b = b < 0 ? -b : b
      sum += b < 1e-9 ? c : c * (1 + b * b) / b * atan2(b, 1)
    }
    END { flush(); printf "%d %.6f %.6f %.6f\n", n, sum, x, y }'
}
entities() {
  awk -v kind="$1" '{ code = $1; getline; sub(/\r/, "") } code == 0 && $0 == kind { ++n } END { print n + 0 }' "$2"
}
for file in "$curve" bow.svg; do
  run arcs --eps 1e-3 --format json "$file" -o arcs.json
  run arcs --eps 1e-3 --format dxf --dxf-entities arcs "$file" -o arcs.dxf
  expect_status 0
  wanted=$(measures arcs.json piece)
  count=$(($(entities ARC arcs.dxf) + $(entities LINE arcs.dxf)))
  [ "$count" -eq "${wanted%% *}" ] || fail "$file: $count arcs and lines instead of ${wanted%% *}"
  [ "$(entities LWPOLYLINE arcs.dxf)" -eq 0 ] || fail "$file: there are polylines"
  # and in again, a curve each
  run arcs --eps 1e-9 --continuity position --format json --join-ends none arcs.dxf -o again.json
  expect_status 0
  [ "$file" != bow.svg ] || wanted=$(sed 's/\(.*\) -/\1 /; t; s/\(.*\) /\1 -/' <<< "$wanted")  # y upwards
  found=$(measures again.json curve)
  [ "$found" = "$wanted" ] || fail "$file: arcs and lines are $found instead of $wanted"
done
run arcs --eps 1e-3 --format dxf --dxf-entities arcs "$curve"
[ "$(grep -c '^a_wrench$' "$results/out")" -gt 30 ] || fail 'arcs have no layer'
line='{"type":"bezier","degree":1,"control_points":[[0,0],[3,1]]}'
flat='{"type":"bezier","degree":2,"control_points":[[1000,1000],[1001,1000.00000002],[1002,1000]]}'
printf '{"curves":[%s,%s]}' "$line" "$flat" > flat.json
run arcs --eps 1e-9 --format dxf --dxf-entities arcs flat.json -o arcs.dxf
[ "$(entities LINE arcs.dxf)" -eq 1 ] || fail 'a line is no LINE'
[ "$(entities LWPOLYLINE arcs.dxf)" -ge 1 ] || fail 'an arc too flat for its angles has no bulge'
run offset --distance 0.1,-0.1 --eps 1e-3 --format dxf "$curve"
expect_status 0
grep -q '^offset_0.1' "$results/out" && grep -q '^offset_-0.1' "$results/out" || fail 'offsets have no layers'
rm ./*

# In: length and names, measured by their arcs.
# length NUMBER ENTITIES [BLOCKS]: together they are so long, by arcs within 1e-7
length() {
  dxf "$2" "${3:-}" > in.dxf
  run arcs --eps 1e-7 --continuity position --format json in.dxf
  expect_status 0
  starts "$results/out" > arcs
  grep -oE '"to":\[[^]]*\]' "$results/out" | tr -c '0-9.e+\n-' ' ' | paste -d' ' arcs - |
    awk -v wanted="$1" '{ c = sqrt(($1 - $4)^2 + ($2 - $5)^2); b = $3 < 0 ? -$3 : $3
      sum += b < 1e-9 ? c : c * (1 + b * b) / b * atan2(b, 1) }
      END { printf "%.9f", sum; exit sum < wanted - 1e-5 || sum > wanted + 1e-5 }' > sum ||
    fail "another length, $(cat sum) instead of $1, for $2"
}
length 5 '0|LINE|8|0|10|1|20|1|11|4|21|5|'
length 6.283185307 '0|ARC|8|0|10|1|20|1|40|2|50|90|51|270|'
length 10.471975512 '0|ARC|8|0|10|1|20|1|40|2|50|300|51|240|'
length 12.566370614 '0|CIRCLE|8|0|10|1|20|1|40|2|'
length 9.688448220 '0|ELLIPSE|8|0|10|1|20|1|11|2|21|0|40|0.5|41|0|42|6.283185307179586|'
length 9.688448220 '0|ELLIPSE|8|0|10|1|20|1|11|2|21|0|40|0.5|41|1.5708|42|7.854|'  # a turn, by its digits
length 4.844224110 '0|ELLIPSE|8|0|10|1|20|1|11|0|21|2|40|0.5|41|0|42|3.141592653589793|'
length 5.141592654 '0|LWPOLYLINE|8|0|90|3|70|0|10|0|20|0|42|1|10|2|20|0|10|2|20|2|'
length 5.141592654 '0|LWPOLYLINE|8|0|90|2|70|1|10|0|20|0|10|2|20|0|42|1|'
length 12 '0|LWPOLYLINE|8|0|90|3|70|1|10|0|20|0|10|3|20|0|10|3|20|4|'
length 9.424777961 '0|LWPOLYLINE|8|0|90|2|70|0|10|0|20|0|42|2.414213562373095|10|2.82842712474619|20|0|'
vertex='0|VERTEX|8|0|'
length 5.141592654 "0|POLYLINE|8|0|66|1|70|0|${vertex}10|0|20|0|42|1|${vertex}10|2|20|0|${vertex}10|2|20|2|0|SEQEND|"
spline='0|SPLINE|8|0|70|4|74|0|'
knots='40|0|40|0|40|0|40|1|40|1|40|1|'
length 1.570796327 "${spline}71|2|72|6|73|3|${knots}10|1|20|0|41|1|10|1|20|1|41|0.7071067811865476|10|0|20|1|41|1|"
# a block of a line of length 5 on layer 0, inserted twice as large and, in two columns, as it is
block='0|BLOCK|8|0|2|b|70|0|10|1|20|1|0|LINE|8|0|10|1|20|1|11|4|21|5|0|ENDBLK|'
length 20 '0|INSERT|8|p|2|b|10|7|20|8|41|2|42|2|50|30|0|INSERT|8|q|2|b|10|0|20|0|70|2|44|9|' "$block"
for name in '"p"' '"q.1"' '"q.2"'; do
  grep -q "\"name\":$name" "$results/out" || fail "$name is no name: $(grep -o '"name":[^,]*' "$results/out")"
done
grep -q '"from":\[7,8\]' "$results/out" || fail 'the base of the block is not where it was inserted'
# seen from below: a quarter about (1, 1) goes to the other side of x = 0
dxf '0|ARC|8|0|10|1|20|1|40|2|50|0|51|90|210|0|220|0|230|-1|' > in.dxf
run arcs --eps 0.1 --format json in.dxf
grep -q '"from":\[-3,1\]' "$results/out" && grep -q '"to":\[-1,3\]' "$results/out" ||
  fail 'an arc from below is elsewhere'
dxf '0|TEXT|8|0|10|0|20|0|1|a|0|LINE|8|0|10|1|20|1|11|4|21|5|0|CIRCLE|8|c|10|0|20|0|40|1|' | sed 's/$/\r/' > in.dxf
run build --method bca --eps 1 in.dxf
for name in '"line1"' '"c"'; do grep -q "\"name\":$name" "$results/out" || fail "$name is no name, with CR LF"; done

# What is refused, with its place and the reason, and nothing is written.
# refuses PATTERN: in.dxf
refuses() {
  rm -f out.json
  run build --method bca --eps 1 in.dxf -o out.json
  expect_status 1
  expect_line "bounding_arcs: in.dxf: $1"
  expect_silence
  [ ! -e out.json ] || fail "$command_line: wrote a file"
}
rm -f arcs sum
bad() { dxf "$2" "${3:-}" > in.dxf; refuses "$1"; }
bad 'file: no curve in the drawing' ''
bad 'file: no curve in the drawing; left out: 1 LINE: expected a number, found "x" in group 10' \
  '0|LINE|8|0|10|x|20|1|11|4|21|5|'
bad 'line 15: expected a group code, found "ten"' '0|LINE|8|0|ten|1|20|1|11|4|21|5|'
# each block has the one before 100 times
bomb='0|BLOCK|8|0|2|b0|70|0|10|0|20|0|0|LINE|8|0|10|1|20|1|11|4|21|5|0|ENDBLK|'
for i in 1 2 3 4; do
  bomb+="0|BLOCK|8|0|2|b$i|70|0|10|0|20|0|0|INSERT|8|0|2|b$((i - 1))|10|1|20|1|70|100|44|1|0|ENDBLK|"
done
bad 'insert *: expected at most 1000000 entities and pieces*' '0|INSERT|8|p|2|b4|10|7|20|8|' "$bomb"
# cut off anywhere, it is refused in one line, or read to its end; half an entity is no other one
dxf '0|LWPOLYLINE|8|0|90|2|70|0|10|0|20|0|42|1|10|2|20|0|' > whole
length 3.141592654 '0|LWPOLYLINE|8|0|90|2|70|0|10|0|20|0|42|1|10|2|20|0|'
cp "$results/out" wanted
for length in $(seq 20 7 "$(($(wc -c < whole) - 4))"); do
  head -c "$length" whole > in.dxf
  run arcs --eps 1e-7 --continuity position --format json in.dxf
  expect_line 'bounding_arcs: in.dxf: *'
  if [ "$status" -eq 0 ]; then cmp -s wanted "$results/out" || fail "cut off at $length, another curve is read"; fi
done

rm -f ./*
finish
