#!/usr/bin/env bash
# Copyright (c) 2026 The Bounding Arcs authors.
# This file is part of Bounding Arcs, an add-on to CGAL.
# SPDX-License-Identifier: GPL-3.0-or-later
#
# --plain: SVG goes in and SVG comes out, with the same coordinates, page, names, layers and colours; arcs are arcs.
# Usage: test_plain_svg.sh TOOL PROJECT_ROOT
. "$(dirname "${BASH_SOURCE[0]}")/support.sh"

svg() {
  printf '<svg xmlns="http://www.w3.org/2000/svg" xmlns:inkscape="http://www.inkscape.org/namespaces/inkscape" '
  printf 'width="100mm" height="60mm" viewBox="-10 0 200 120">%s</svg>\n' "$1"
}
paths() { grep -o '<path[^>]*>' "${1:-$results/out}"; }  # of the last run
# expect_paths FILE LINE...: it has these paths and no others
expect_paths() {
  local file=$1
  shift
  # shellcheck disable=SC2053
  [[ $(paths "$file") == $(printf '%s\n' "$@") ]] || fail "$command_line: paths are $(paths "$file")"
}

# The page, ids, layers and colours are those that were read; lines, curves and arcs, of ellipses too, what they are.
svg '<g inkscape:groupmode="layer" inkscape:label="Cut &amp; go" stroke="red">
<path id="mix" d="M0 0L8 0C9 1 9 3 8 4Q6 6 4 4A2 2 0 0 1 0 4Z"/>
<path id="egg" d="M20 20A8 4 30 0 1 30 24L20 24Z"/></g>
<rect id="a&quot;b" x="50" y="1e-5" width="4" height="2" fill="#00f"/>' > in.svg
run boolean union in.svg --plain -o out.svg
expect_status 0
expect_silence
[ -z "$err" ] || fail "$command_line: said $err"
grep -q ' width="100mm" height="60mm" viewBox="-10 0 200 120">' out.svg || fail "$command_line: page $(head -1 out.svg)"
grep -q '<g inkscape:groupmode="layer" inkscape:label="Cut &amp; go">' out.svg || fail "$command_line: no layer"
expect_paths out.svg '<path id="mix" stroke="#ff0000" d="M0 0 L8 0 C9 1 9 3 8 4 Q6 6 4 4 A2 2 0 0 1 0 4 Z"/>' \
  '<path id="egg" stroke="#ff0000" d="M20 20 A8 4 29.999999999999* 0 1 30 24 L20 24 Z"/>' \
  '<path id="a&quot;b" stroke="#0000ff" d="M50 1e-05 L54 1e-05 L54 2.00001 L50 2.00001 Z"/>'
# and again: nothing changes any more
run boolean union out.svg --plain -o again.svg
cmp -s out.svg again.svg || fail "$command_line: another drawing: $(diff out.svg again.svg | head -4)"
run boolean union in.svg --plain
expect_status 2
expect_line 'bounding_arcs: --format: expected svg with --plain, which no other form has, found json'
for command in 'arcs --eps 1' 'offset --distance 1 --eps 0.1' 'clip in.svg' 'medial-axis --eps 1'; do
  # shellcheck disable=SC2086
  run $command in.svg --plain --format csv
  expect_status 2
  expect_line 'bounding_arcs: --format: expected svg with --plain, which no other form has, found csv'
  # shellcheck disable=SC2086
  run $command in.svg --plain -o out.svg
  expect_status 0
  grep -q ' viewBox="-10 0 200 120">' out.svg || fail "$command_line: page $(head -1 out.svg)"
done

# Names that are there already get a number; results of layers one after the other are in one group each.
svg '<g inkscape:groupmode="layer" inkscape:label="a"><rect id="r" width="4" height="2"/></g>
<circle id="r" cx="9" cy="9" r="1"/>
<g inkscape:groupmode="layer" inkscape:label="a"><rect id="r_2" x="20" width="4" height="2"/></g>' > names.svg
run boolean union names.svg --plain --format svg
[ "$(paths | grep -o 'id="[^"]*"' | tr '\n' ' ')" = 'id="r" id="r_2" id="r_3" ' ] || fail "$command_line: $(paths)"
[ "$(grep -c '<g inkscape:groupmode' "$results/out")" -eq 1 ] || fail "$command_line: $(cat "$results/out")"

# Holes and offsets: a group a distance, ids of the sources.
svg '<rect id="plate" width="40" height="20"/><circle id="disc" cx="80" cy="50" r="10"/>' > plate.svg
run offset plate.svg --distance=-2,2 --eps 0.01 --plain -o offset.svg
expect_status 0
for name in offset_-2 offset_2; do grep -q "inkscape:label=\"$name\"" offset.svg || fail "$command_line: no $name"; done
expect_paths offset.svg '<path id="plate" stroke="#000000" d="M2 2 L38 2 L38 18 L2 18 Z"/>' \
  '<path id="disc" stroke="#000000" d="M88 50 A8 8 0 0 1 72 50 A8 8 0 0 1 88 50 Z"/>' \
  '<path id="plate_2" stroke="#000000" d="M-2 0 A2 2 0 0 1 0 -2 L40 -2 A2 2 0 0 1 42 0 L42 20 A2 2 0 0 1 40 22 L0 22 '\
'A2 2 0 0 1 -2 20 Z"/>' \
  '<path id="disc_2" stroke="#000000" d="M92 50 A12 12 0 0 1 68 50 A12 12 0 0 1 92 50 Z"/>'

# What is read again is the same within rounding: lengths and boxes of all curves, of arcs of any turn, too.
measures() { "$tool" info "$1" --format csv --join-ends none | cut -d, -f6,10-13 | tail -n +2; }
same() {  # FILE FILE: numbers within 1e-11 of the largest of a curve
  paste -d, <(measures "$1") <(measures "$2") | awk -F, -v "what=$command_line" '
    { most = 0; for (i = 1; i <= 5; ++i) { a = $i < 0 ? -$i : $i; if (a > most) most = a }
      for (i = 1; i <= 5; ++i) { d = $i - $(i + 5); if (NF != 10 || d > 1e-11 * most || d < -1e-11 * most) bad = 1 } }
    END { exit bad || NR == 0 }' || fail "$command_line: $1 is $(measures "$1"), and $2 is $(measures "$2")"
}
arcs=''
for end in '-0.999999995 1e-4' '-0.9999999999995 1e-6' '-1 1e-9' '-1 1e-7' '-1 1e-4' '-0.99 0.1' \
  '-0.3 0.9' '0.9 0.3' '0.99999 1e-4' '0.9999999 1e-8'; do
  arcs+="<path d='M1 0A1 1 0 0 1 $end'/><path d='M1 0A3 1 77 0 0 $end'/>"
done
svg "$arcs" > arcs.svg
for transform in '' 'scale(3e5)' 'scale(1e-5)' 'rotate(17)translate(100,7)' 'scale(1,-1)' \
  'rotate(17)scale(0.71234567891234567)'; do
  svg "<g fill='none' transform='$transform'>$arcs</g>" > arcs.svg
  svg '<path d="M-9e6-9e6H9e6V9e6H-9e6Z"/>' > all.svg
  run clip arcs.svg all.svg --join-ends none --plain -o out.svg
  expect_status 0
  same arcs.svg out.svg
done
# half circles, where a radius that is too long by its last digit would make 1e-8 of it
for i in 1 2 3 4 5 6 7 8 9; do
  svg "<circle cx='0.$i' cy='1' r='0.7${i}3' transform='rotate($i)'/>" > half.svg
  run offset half.svg --distance 0.1 --eps 0.01 --plain -o out.svg
  run offset out.svg --distance=-0.1 --eps 0.01 --plain -o back.svg
  expect_status 0
  same half.svg back.svg
done

# A drawing with y upwards is mirrored, as SVG has it downwards, and stands on a page around it.
printf '{"name":"box","type":"path","closed":true,"pieces":[%s]}' \
  '{"control_points":[[0,0],[4,0]]},{"control_points":[[4,0],[4,3]]},{"control_points":[[4,3],[0,0]]}' > box.json
run boolean union box.json --format svg --plain
expect_paths "$results/out" '<path id="box" stroke="#000000" d="M0 0 L4 0 L4 -3 Z"/>'
grep -q ' width="4" height="3" viewBox="0 -3 4 3">' "$results/out" || fail "$command_line: $(head -1 "$results/out")"

# Arcs that are cut on the way are one again.
svg '<path id="slot" d="M0 0H20A5 5 0 0 1 20 10H0A5 5 0 0 1 0 0Z"/>' > slot.svg
for command in 'boolean union' 'arcs --eps 1e-3' 'boolean union --eps 1e-3'; do
  # shellcheck disable=SC2086
  run $command slot.svg --plain --format svg
  expect_paths "$results/out" \
    '<path id="slot" stroke="#000000" d="M0 0 L20 0 A5 5 0 0 1 20 10 L0 10 A5 5 0 0 1 0 0 Z"/>'
done

# Curves that SVG has not are refused, or arcs within eps.
degree4='{"control_points":[[0,0],[1,3],[2,-3],[3,3],[4,0]]}'
line='{"control_points":[[4,0],[0,0]]}'
printf '{"name":"four","type":"path","closed":true,"pieces":[%s,%s]}' "$degree4" "$line" > four.json
run boolean union four.json --plain -o out.svg
expect_status 1
expect_line 'bounding_arcs: four.json: curve "four": expected curves that SVG can draw, or --eps for arcs, found no '\
'weights and degree 4 in piece *'
run boolean union four.json --eps 1e-3 --plain -o out.svg
expect_status 0
[ "$(grep -o ' A' out.svg | wc -l)" -gt 5 ] || fail "$command_line: few arcs: $(cat out.svg)"

# The axis: lines between samples, or conics.
run medial-axis plate.svg --eps 0.01 --plain --format svg
[ "$(paths | grep -c 'id="edge_[0-9]*"')" -ge 5 ] || fail "$command_line: $(paths)"
! grep -q '[AQC][0-9]' "$results/out" || fail "$command_line: has curves"
svg '<path d="M0 0H40V20H22V12H18V20H0Z"/>' > notch.svg
run medial-axis notch.svg --eps 0.01 --conics --plain --format svg
expect_status 0
grep -q ' Q' "$results/out" || fail "$command_line: no parabola: $(paths)"

# The rule of a DXF file is another one, where it plays a part.
circle() { printf '0|CIRCLE|8|0|10|0|20|0|40|%s|' "$1"; }
printf '0|SECTION|2|ENTITIES|%s0|ENDSEC|0|EOF|' "$(circle 1)$(circle 2)" | tr '|' '\n' > rings.dxf
run arcs rings.dxf --eps 0.1 --plain -o out.svg
expect_line 'bounding_arcs: rings.dxf: its rule is evenodd, which is not that of plain SVG: read that with --rule '\
'evenodd'
run boolean union rings.dxf --plain -o out.svg
[ -z "$err" ] || fail "$command_line: said $err"
run info out.svg --format csv
[ "$(cut -d, -f8 "$results/out" | sort | tr '\n' ' ')" = 'ccw cw direction ' ] || fail "$command_line: no hole"

rm -f ./*
finish
