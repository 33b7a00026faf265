#!/usr/bin/env bash
# Copyright (c) 2026 The Bounding Arcs authors.
# This file is part of Bounding Arcs, an add-on to CGAL.
# SPDX-License-Identifier: GPL-3.0-or-later
#
# Units of drawings: files with other ones are converted to those of the first or of --units, and that is said. Written
# files have them.
# Usage: test_units.sh TOOL PROJECT_ROOT
. "$(dirname "${BASH_SOURCE[0]}")/support.sh"

# dxf UNIT ENTITIES: a file of these, groups with | between; no unit for "".
dxf() {
  { [ -z "$1" ] || printf '0|SECTION|2|HEADER|9|$INSUNITS|70|%s|0|ENDSEC|' "$1"
    printf '0|SECTION|2|ENTITIES|%s0|ENDSEC|0|EOF|' "$2"; } | tr '|' '\n'
}
square() { printf '0|LWPOLYLINE|8|%s|90|4|70|1|10|%s|20|0|10|%s|20|0|10|%s|20|8|10|%s|20|8|' "$1" "$2" "$3" "$3" "$2"; }
svg() { printf '<svg xmlns="http://www.w3.org/2000/svg" %s>%s</svg>' "$1" "$2"; }
dxf 1 "$(square a 0 1)" > inch.dxf
dxf 4 "$(square a 0 25.4)" > mm.dxf
dxf 21 "$(square a 0 1)" > survey.dxf
dxf 2 "$(square a 0 1)" > foot.dxf
dxf '' "$(square a 0 1)" > none.dxf
svg 'width="40mm" height="40mm" viewBox="0 0 80 80"' '<rect id="box" width="40" height="20"/>' > half.svg
svg 'width="25.4000001mm" viewBox="0 0 1 1"' '<rect width="1" height="1"/>' > inch.svg
svg 'width="96px" height="96px" viewBox="0 0 96 96"' '<rect width="96" height="48"/>' > px.svg
printf '{"type":"bezier","degree":1,"control_points":[[0,0],[8,8]]}\n' > line.json

# says LINE: the last run ended well and said that alone; nothing for ""
says() {
  expect_status 0
  [ "$err" = "${1:+bounding_arcs: $1}" ] || fail "$command_line: said \"$err\" instead of \"$1\""
}

# Operands in other units than the first one that has any. An inch is as wide as 25.4 mm, but not as high as 8 of them.
converted='inch.dxf: converted from units of 25.4 mm to units of 1 mm, as in mm.dxf'
taken='no unit told: 1 unit is taken for 25.4 mm, as in inch.dxf'
for command in 'boolean difference' 'clip' 'arrange' 'query distance' 'query hausdorff' 'query intersect' \
  'arcs --eps 1' 'build --eps 1 --method bca' 'compare --eps 1 --repeat 1' 'verify --eps 1 --method bca' \
  'stability --quantities radius --kernels double' 'report --stability none --eps 1'; do
  # shellcheck disable=SC2086
  run $command mm.dxf inch.dxf
  says "$converted"
  for same in 'none.dxf inch.dxf' 'inch.dxf inch.dxf' 'inch.dxf line.json'; do
    if [ "${command% *}" = boolean ] || [ "$command" = clip ]; then same=${same/line.json/none.dxf}; fi
    # shellcheck disable=SC2086
    run $command $same
    case $same in  # what tells no unit beside one that does, in either order
      *none.dxf*) says "none.dxf: $taken" ;;
      *line.json*) says "line.json: $taken" ;;
      *) says '' ;;
    esac
  done
done
run boolean difference mm.dxf inch.dxf --strict
says "$converted"
grep -q '\[25.4,203.2\]' "$results/out" && fail "$command_line: has what only the inch has"
run boolean difference inch.dxf mm.dxf  # an inch less 8 mm of 8 inches
says 'mm.dxf: converted from units of 1 mm to units of 25.4 mm, as in inch.dxf'
grep -q '\[1.0,0.31496062992125984\]' "$results/out" || fail "$command_line: $(head -c 400 "$results/out")"
run query distance inch.dxf inch.svg  # up to the digits that files write
says ''
run query distance foot.dxf survey.dxf
says 'survey.dxf: converted from units of 304.80061 mm to units of 304.8 mm, as in foot.dxf'
run boolean union none.dxf mm.dxf inch.dxf half.svg --rule evenodd
[ "$(grep -c 'to units of 1 mm, as in mm.dxf' "$results/err")" -eq 2 ] || fail "$command_line: said $err"
input=inch.dxf run query distance mm.dxf -
says "stdin: ${converted#*: }"

# --units, which --eps and distances are in, too, and what closes gaps.
run offset inch.dxf --units mm --distance 1 --eps 0.01
says 'inch.dxf: converted from units of 25.4 mm to mm'
grep -q '"to":\[26.4,0\]' "$results/out" || fail "$command_line: $(head -c 400 "$results/out")"
run offset mm.dxf --units mm --distance 1 --eps 0.01
says ''
run offset none.dxf --units mm --distance 0.25 --eps 0.01
says 'none.dxf: no unit told: 1 unit is taken for 1 mm'
grep -q '"to":\[1.25,0\]' "$results/out" || fail "$command_line: $(head -c 400 "$results/out")"
run arcs mm.dxf inch.dxf --units cm --eps 1 --format csv
[ "$(grep -c '2\.54,0,' "$results/out")" -ge 2 ] || fail "$command_line: $(cat "$results/out")"
run arcs px.svg --units in --eps 1 --format csv
says 'px.svg: converted from units of 0.264583333 mm to in'
grep -q ',0,0,1,0,0$' "$results/out" || fail "$command_line: $(cat "$results/out")"
dxf 1 '0|LINE|8|0|10|0|20|0|11|1|21|0|0|LINE|8|0|10|1.01|20|0|11|1|21|1|0|LINE|8|0|10|1|20|1|11|0|21|0|' > gap.dxf
run info gap.dxf --units mm --join-ends 0.3
says ''
grep -q '^converted from units of 25.4 mm to mm$' "$results/out" || fail "$command_line: $(cat "$results/out")"
grep -q '1 closed and 0 open; 1 unit is 1 mm' "$results/out" || fail "$command_line: $(cat "$results/out")"
run info gap.dxf --units mm --join-ends 0.2
grep -q '0 closed and 1 open' "$results/out" || fail "$command_line: $(cat "$results/out")"
run info px.svg --format json
grep -q '"unit_in_mm":0.2645833' "$results/out" || fail "$command_line: $(cat "$results/out")"
run info inch.dxf --units furlong
expect_status 2
expect_line 'bounding_arcs: --units: expected mm, cm, in or px, found "furlong"'
dxf 20 "0|LINE|8|0|10|0|20|0|11|1e290|21|0|" > parsecs.dxf
run arcs parsecs.dxf --units mm --eps 1
expect_status 1
expect_line 'bounding_arcs: parsecs.dxf: curve "line1": expected coordinates of magnitude at most 2^1000 in the other*'

# Written again: SVG on the page that was read, and scaled with what is converted.
run arcs half.svg --eps 1 --plain -o out.svg
says ''
grep -q ' width="40mm" height="40mm" viewBox="0 0 80 80">' out.svg || fail "$command_line: $(head -1 out.svg)"
run arcs half.svg --units in --eps 1 --plain -o out.svg
grep -q ' width="1.574803149606299[0-9]*in" ' out.svg || fail "$command_line: $(head -1 out.svg)"
run info out.svg
grep -q '1 unit is 25.4 mm' "$results/out" || fail "$command_line: $(cat "$results/out")"
run arcs inch.dxf --eps 1 --plain -o out.svg
grep -q ' width="1in" height="8in" viewBox="0 -8 1 8">' out.svg || fail "$command_line: $(head -1 out.svg)"
svg 'width="40mm" height="20mm"' '<rect width="40" height="20"/>' > pixels.svg
run arcs pixels.svg --eps 1 --plain -o out.svg
grep -q ' width="40mm" height="20mm">' out.svg || fail "$command_line: $(head -1 out.svg)"
svg 'width="40" height="20"' '<rect width="40" height="20"/>' > bare.svg
run arcs bare.svg --units mm --eps 1 --plain -o out.svg
grep -q ' width="40mm" height="20mm" viewBox="0 0 40 20">' out.svg || fail "$command_line: $(head -1 out.svg)"

run arcs mm.dxf --eps 1 --format dxf
if [[ $err == *'without dxflib'* ]]; then finish; fi
insunits() { grep -A2 'INSUNITS' "$1" | tail -1; }
for command in 'arcs --eps 1' 'offset --distance 0.1 --eps 0.01' 'boolean union' 'medial-axis --eps 0.1' \
  'thickness --eps 0.1'; do
  # shellcheck disable=SC2086
  run $command half.svg --format dxf -o out.dxf
  says 'half.svg: 1 unit is 0.5 mm, for which DXF has no word: none is written; --units converts'
  [ -z "$(insunits out.dxf)" ] || fail "$command_line: has a unit"
  for unit in 'mm.dxf 4' 'inch.dxf 1' 'foot.dxf 2' 'survey.dxf 21' 'half.svg 5 --units=cm'; do
    read -r file wanted option <<< "$unit"
    # shellcheck disable=SC2086
    run $command "$file" ${option:-} --format dxf -o out.dxf
    expect_status 0
    [ "$(insunits out.dxf)" = "$wanted" ] || fail "$command_line: unit $(insunits out.dxf) instead of $wanted"
  done
done
run clip mm.dxf inch.dxf -o out.dxf
[ "$(insunits out.dxf)" = 4 ] || fail "$command_line: unit $(insunits out.dxf)"

rm -f ./*
finish
