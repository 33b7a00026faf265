#!/usr/bin/env bash
# Copyright (c) 2026 The Bounding Arcs authors.
# This file is part of Bounding Arcs, an add-on to CGAL.
# SPDX-License-Identifier: GPL-3.0-or-later
#
# What drawings have and is not read: told in a line, refused with --strict, read with --hidden and --paper. What closed
# curves enclose without --rule. Loose lines that are joined, and open curves among closed ones.
# Usage: test_left_out.sh TOOL PROJECT_ROOT
. "$(dirname "${BASH_SOURCE[0]}")/support.sh"

# dxf ENTITIES [TABLES]: a file of these, groups with | between.
dxf() {
  printf '0|SECTION|2|TABLES|%s0|ENDSEC|0|SECTION|2|ENTITIES|%s0|ENDSEC|0|EOF|' "${2:-}" "$1" | tr '|' '\n'
}
square() { printf '0|LWPOLYLINE|8|%s|90|4|70|1|10|%s|20|0|10|%s|20|0|10|%s|20|8|10|%s|20|8|' "$1" "$2" "$3" "$3" "$2"; }
hole='0|CIRCLE|8|0|10|4|20|4|40|2|'
text='0|MTEXT|8|0|10|0|20|0|1|a title|'
line='0|LINE|8|0|10|0|20|0|11|1|21|1|'
dxf "$(square 0 0 8)$hole$text$text" > part.dxf
dxf "$(square 0 0 8)$hole" > clean.dxf
dxf "$(square 0 0 8)" > solid.dxf
echo 4 4 > middle
printf '{"type":"bezier","degree":1,"control_points":[[0,0],[8,8]]}\n' > line.json
left='bounding_arcs: part.dxf: left out: 2 MTEXT: no curve'

# Every subcommand that reads drawings says it in one line, and refuses the file with --strict.
run medial-axis clean.dxf --eps 0.1 --feet -o axis.json
for command in 'build --method bca --eps 1' 'compare --eps 1 --repeat 1' 'compare --orders' 'compare --queries' \
  'verify --method bca --eps 1' 'stability --quantities radius --kernels double' 'arcs --eps 0.1' 'arrange' \
  'boolean union' 'offset --distance 1 --eps 0.1' 'medial-axis --eps 0.1' 'thickness --eps 0.1' \
  'report --stability none --eps 1' 'query closest --points middle' 'query closest --signed --points middle' \
  'query locate --points middle' 'query hull' 'query self-intersect' \
  'query distance line.json' 'query hausdorff line.json' 'query intersect line.json' 'clip line.json'; do
  # shellcheck disable=SC2086
  run $command part.dxf
  expect_status 0
  expect_line "$left"
  # shellcheck disable=SC2086
  run $command part.dxf --strict -o out
  expect_status 1
  expect_silence
  expect_line "${left/left/--strict: expected a file that is read as it stands, found one that is not: left}"
  [ ! -e out ] || fail "$command_line: wrote a file"
  # shellcheck disable=SC2086
  run $command clean.dxf --strict
  expect_status 0
  [ -z "$err" ] || fail "$command_line: said $err"
done
run verify-axis part.dxf axis.json
expect_status 0
expect_line "$left"
run verify-axis part.dxf axis.json --strict
expect_status 1
run arcs part.dxf clean.dxf part.dxf --eps 1  # a line a file
[ "$(wc -l < "$results/err")" -eq 2 ] || fail "$command_line: said $err"
input=part.dxf run query hull -
expect_line 'bounding_arcs: stdin: left out: 2 MTEXT: no curve'

# Hidden entities and those in paper space.
layers='0|TABLE|2|LAYER|0|LAYER|2|OFF|70|0|62|-7|0|LAYER|2|FRZ|70|1|62|7|0|ENDTAB|'
longer=${line/|11|/|11|1} longest=${line/|11|/|11|11}  # not the same on one layer
dxf "$line${line/|8|0/|8|off}${line/|8|0/|8|FRZ}${longer/|8|0/|8|0|60|1}${longest/|8|0/|8|0|67|1}" "$layers" \
  > hidden.dxf
curves() {  # WANTED OPTIONS...: so many are read
  local wanted=$1
  shift
  run arcs hidden.dxf --eps 1 --format json --join-ends none "$@"
  expect_status 0
  [ "$(grep -o '"name"' "$results/out" | wc -l)" -eq "$wanted" ] || fail "$command_line: not $wanted curves"
}
off='1 LINE: on a layer that is off; 1 LINE: on a frozen layer; 1 LINE: invisible'
curves 1
expect_line "bounding_arcs: hidden.dxf: left out: $off; 1 LINE: in paper space"
curves 4 --hidden
expect_line 'bounding_arcs: hidden.dxf: left out: 1 LINE: in paper space'
curves 2 --paper
expect_line "bounding_arcs: hidden.dxf: left out: $off"
curves 5 --hidden --paper --strict
[ -z "$err" ] || fail "$command_line: said $err"

# Curves of a DXF file have no direction that means anything: a circle in a square is a hole, unless --rule differs.
inside() {  # WANTED ARGUMENTS: the answer has it
  local wanted=$1
  shift
  run "$@"
  expect_status 0
  grep -qE -e "$wanted" "$results/out" || fail "$command_line: no $wanted in $(head -c 300 "$results/out")"
}
inside '"outside"' query locate clean.dxf --points middle
inside '"inside"' query locate clean.dxf --points middle --rule nonzero
inside '"side":"outside"' query closest --signed clean.dxf --points middle
inside '"side":"inside"' query closest --signed clean.dxf --points middle --rule nonzero
inside '"parent":0' boolean union clean.dxf
inside '"parent":[01]' offset clean.dxf --distance=-0.5 --eps 0.01
run offset clean.dxf --distance=-0.5 --eps 0.01 --rule nonzero
! grep -q '"parent":[01]' "$results/out" || fail "$command_line: has a hole"
inside '"regions":1,"holes":1,"error":[^,]*,"rule":"evenodd"' medial-axis clean.dxf --eps 0.1
inside '"rule":"nonzero"' medial-axis clean.dxf --eps 0.1 --rule nonzero --feet
cp "$results/out" nonzero.json
inside 'right' verify-axis clean.dxf axis.json
inside 'right' verify-axis clean.dxf nonzero.json  # its rule is in it
run verify-axis clean.dxf nonzero.json --rule evenodd
expect_status 1
sed 's/"nonzero"/"odd"/' nonzero.json > odd.json
run verify-axis clean.dxf odd.json
expect_status 1
expect_line 'bounding_arcs: odd.json: rule: expected nonzero or evenodd*'
inside '"thickness": ' thickness clean.dxf --eps 0.1
inside '^\{"side":"inside".*' clip line.json clean.dxf
paths() { grep -o '"type":"path"' "$results/out" | wc -l; }
[ "$(paths)" -eq 2 ] || fail "$command_line: the line is not on both sides of the hole"
inside '^\{"side":"inside".*' clip line.json clean.dxf --rule nonzero
[ "$(paths)" -eq 1 ] || fail "$command_line: the line is cut"
inside '&quot;|"outside"' report --stability none --eps 1 --query locate --points middle clean.dxf
inside '"inside"' report --stability none --eps 1 --query locate --points middle clean.dxf --rule nonzero
inside 'In the file: left out: 2 MTEXT: no curve' report --stability none --eps 1 part.dxf
# what bounds nothing is told
printf '<svg xmlns="http://www.w3.org/2000/svg"><rect width="30" height="30"/><circle cx="15" cy="15" r="5"/></svg>' \
  > pair.svg
run offset pair.svg --distance=-1 --eps 0.01
expect_status 0
expect_line 'bounding_arcs: pair.svg: offset: 1 curve bounds nothing: the nonzero rule fills both sides or neither; *'
run offset pair.svg --distance=-1 --eps 0.01 --rule evenodd
expect_status 0
[ -z "$err" ] || fail "$command_line: said $err"
# where a rule is asked for that of the file is none of one's business
printf '<svg xmlns="http://www.w3.org/2000/svg">%s%s</svg>' '<path d="M0 0h9v9h-9zM2 2h3v3h-3z" fill-rule="evenodd"/>' \
  '<path d="M20 0h9v9h-9zM22 2h3v3h-3z"/>' > rules.svg
run offset rules.svg --distance=1 --eps 0.01
expect_status 0
expect_line 'bounding_arcs: rules.svg: read all the same: 1 path: has fill-rule evenodd, read as nonzero'
run offset rules.svg --distance=1 --eps 0.01 --rule evenodd --strict
expect_status 0
[ -z "$err" ] || fail "$command_line: said $err"
rm pair.svg rules.svg
# the curves of JSON have one
printf '{"curves":[{"type":"path","pieces":[%s,%s,%s]},{"type":"path","pieces":[%s,%s,%s]}]}' \
  '{"control_points":[[0,0],[9,0]]}' '{"control_points":[[9,0],[0,9]]}' '{"control_points":[[0,9],[0,0]]}' \
  '{"control_points":[[1,1],[3,1]]}' '{"control_points":[[3,1],[1,3]]}' '{"control_points":[[1,3],[1,1]]}' > nested.json
echo 1.5 1.5 > within
inside '"inside"' query locate nested.json --points within
inside '"outside"' query locate nested.json --points within --rule evenodd
tr -d '\n' < nested.json > records.jsonl
inside '"inside"' query locate --stream records.jsonl --points within
# operands with different rules: the circle in a square of a DXF file is a hole, a square in one of an SVG file is none
printf '<svg xmlns="http://www.w3.org/2000/svg"><path d="%s"/></svg>' 'M2 2h4v4h-4zM3 3h2v2h-2z' > nested.svg
sed 's/<path/<path fill-rule="evenodd"/' nested.svg > odd.svg
result_area() {  # WANTED ARGUMENTS: what they make fills so much
  local area wanted=$1
  shift
  run boolean "$@" -o result.json
  expect_status 0
  [ -z "$err" ] || fail "$command_line: said $err"
  area=$("$tool" offset result.json --distance 0 --eps 1e-9 | grep -o '"area":[^,]*' | cut -d: -f2 |
    awk '{ sum += $1 } END { printf("%.4f", sum) }')
  [ "$area" = "$wanted" ] || fail "$command_line: the area is $area instead of $wanted"
}
result_area 51.4336 union clean.dxf  # 64 - 4 pi
result_area 16.0000 union nested.svg
result_area 12.0000 union odd.svg
result_area 3.4336 intersection clean.dxf nested.svg  # 16 - 4 pi: corners of the square beside the hole
result_area 12.5664 difference nested.svg clean.dxf
result_area 8.5664 difference odd.svg clean.dxf
result_area 3.4336 intersection clean.dxf odd.svg
result_area 0.0000 difference nested.svg clean.dxf --rule nonzero  # one for all
result_area 16.0000 intersection clean.dxf nested.svg --rule nonzero
result_area 8.5664 difference nested.svg clean.dxf --rule evenodd
# records have that of JSON beside others with their own
for rule in '' '--rule evenodd' '--rule nonzero'; do
  # shellcheck disable=SC2086
  run boolean intersection --stream records.jsonl clean.dxf $rule
  expect_status 0
  sed 's/"name":"[^"]*",//g' "$results/out" | tr -d '\n' > streamed
  # shellcheck disable=SC2086
  run boolean intersection nested.json clean.dxf $rule
  sed 's/"name":"[^"]*",//g' "$results/out" | tr -d '\n' | cmp -s - streamed ||
    fail "$command_line: a record is filled otherwise"
  cksum < streamed >> sums
done
[ "$(sort -u sums | wc -l)" -eq 3 ] || fail "rules of records make no difference"

# Open curves have no inside: they are left out among closed ones, numbers of curves stay those of the file.
apart='0|LINE|8|0|10|5|20|0|11|6|21|1|'
dxf "$line$(square a 0 8)$apart$hole" > open.dxf
open='bounding_arcs: open.dxf: left out: 2 open curves, the first from (0, 0) to (1, 1): no inside'
inside '"outside"' query locate open.dxf --points middle
expect_line "$open"
inside '"curve":3,' query closest --signed open.dxf --points middle
expect_line "$open"
inside 'circle1 3\.' query closest --signed open.dxf --points middle --format table
inside '"curve":3,' boolean union open.dxf
expect_line "$open"
grep -q '"curve":1,' "$results/out" || fail "$command_line: another number for the square"
! grep -qE '"curve":[02],' "$results/out" || fail "$command_line: has an open curve"
inside '"curve": 3' thickness open.dxf --eps 0.1
expect_line "$open"
inside '"curve":3,' medial-axis open.dxf --eps 0.1 --feet
expect_line "$open"
! grep -oE '"curve":[02],|"feet":\[[^"]*' "$results/out" | grep -qE '"curve"|\[[02],' ||
  fail "$command_line: has a place on an open curve"
cp "$results/out" open_axis.json
inside 'right' verify-axis open.dxf open_axis.json
sed 's/\[\[3,/[[2,/' open_axis.json > wrong.json
run verify-axis open.dxf wrong.json
expect_status 1
run clip line.json open.dxf
expect_status 0
expect_line "$open"
inside 'Medial axis|medial axis' report --stability none --eps 1 --medial-axis --query locate --points middle open.dxf
expect_line "$open"
for command in 'query locate --points middle' 'boolean union' 'medial-axis --eps 0.1' 'thickness --eps 0.1' \
  'clip line.json'; do
  # shellcheck disable=SC2086
  run $command open.dxf --strict
  expect_status 1
  expect_line "bounding_arcs: open.dxf: --strict: *: ${open#*dxf: }"
done
# they belong to what needs none
for command in 'medial-axis --frame --eps 0.1' 'query closest --points middle'; do
  # shellcheck disable=SC2086
  run $command open.dxf --strict
  expect_status 0
  [ -z "$err" ] || fail "$command_line: said $err"
done
# but an offset of one among closed ones is told
run offset open.dxf --distance 1 --eps 0.1
expect_status 0
expect_line "bounding_arcs: open.dxf: taken for open: ${open#*left out: }; --skip-open leaves them out"
run offset open.dxf --distance 1 --eps 0.1 --strict
expect_status 1
dxf "$line" > none.dxf  # none is left
for command in 'query locate --points middle' 'boolean union' 'medial-axis --eps 0.1'; do
  # shellcheck disable=SC2086
  run $command none.dxf
  expect_status 1
  expect_silence
  expect_line 'bounding_arcs: none.dxf: curve "line1": expected a closed curve*'
done

# An open subpath of an SVG shape that is filled counts as closed by a line; not without fill, nor in other files.
svg() { printf '<svg xmlns="http://www.w3.org/2000/svg">%s</svg>' "$1"; }
svg '<path d="M0 0h8v8h-8"/><path d="M2 2h4v4" fill="none"/><path d="M20 0h4v4h-4z"/>' > fill.svg
filled='read all the same: 1 open curve: closed by a straight line, as SVG fills what is open'
told="bounding_arcs: fill.svg: left out: 1 open curve, from (2, 2) to (6, 6): no inside; $filled"
inside '"inside"' query locate fill.svg --points middle
expect_line "$told"
inside '"side":"inside"' query closest --signed fill.svg --points middle
expect_line "$told"
inside '"parent":null' boolean union fill.svg
expect_line "$told"
grep -q '"bezier":3,' "$results/out" || fail "$command_line: no line behind the last piece"
[ "$(grep -c '"type":"path"' "$results/out")" -eq 2 ] || fail "$command_line: not two squares"
inside '"regions":2,' medial-axis fill.svg --eps 0.1 --feet
expect_line "$told"
cp "$results/out" axis.json
inside 'right' verify-axis fill.svg axis.json
inside '"thickness": ' thickness fill.svg --eps 0.1
expect_line "$told"
inside '"type":"path"' clip line.json fill.svg
expect_line "$told"
inside '"inside"' report --stability none --eps 1 --query locate --points middle fill.svg
expect_line "$told"
run boolean union fill.svg --strict
expect_status 1
expect_line "bounding_arcs: fill.svg: --strict: *: left out: 1 open curve, from (2, 2) to (6, 6): no inside; $filled"
# as it is where no inside is asked for
for command in 'build --method bca --eps 1' 'arcs --eps 0.1' 'arrange' 'query closest --points middle' 'query hull' \
  'offset --distance 1 --eps 0.1' 'clip fill.svg clean.dxf' 'medial-axis --frame --eps 0.1'; do
  # shellcheck disable=SC2086
  [[ $command = clip* ]] && run $command || run $command fill.svg
  expect_status 0
  [ -z "$err" ] || [[ $err = *'whose ends meet'* || $err = *'taken for open'* ]] || fail "$command_line: said $err"
  ! grep -q '"curve":0,[^}]*"bezier":3' "$results/out" || fail "$command_line: has a line that the file has not"
done
svg '<polyline points="0,0 8,0 8,8"/><path d="M0 20h4v4" style="fill:red"/>' > fill.svg
run boolean union fill.svg
expect_status 0
expect_line 'bounding_arcs: fill.svg: read all the same: 2 open curves: closed by a straight line*'
svg '<style>.a{fill:none}</style><path d="M0 0h8v8"/>' > fill.svg
run boolean union fill.svg
expect_status 1
expect_line '*expected a closed curve*, found an open one; a style sheet, which is not read, may fill it'
svg '<style>.a{fill:none}</style><path d="M0 0h8v8"/><circle r="3"/>' > fill.svg
run boolean union fill.svg
expect_status 0
expect_line 'bounding_arcs: fill.svg: left out: 1 open curve, from (0, 0) to (8, 8): perhaps filled by a style sheet, *'

# Loose lines whose ends meet are joined, by all subcommands alike.
segment() { printf '0|LINE|8|0|10|%s|20|%s|11|%s|21|%s|' "$@"; }
arc() { printf '0|ARC|8|0|10|%s|20|2|40|2|50|%s|51|%s|' "$@"; }
rectangle=$(segment 0 0 10 0; segment 10 6 10 0; segment 10 6 0 6; segment 0 6 0 0)
# lines WANTED...: the lines of the last run on standard error
lines() {
  [ "$err" = "$(printf 'bounding_arcs: loose.dxf: %s\n' "$@")" ] || fail "$command_line: said $err instead of $*"
}
needing_inside=('query locate --points middle' 'query closest --signed --points middle' 'boolean union'
  'medial-axis --eps 0.1' 'thickness --eps 0.1' 'clip line.json')
needing_none=('offset --distance=-1 --eps 0.01' 'medial-axis --frame --eps 0.1' 'query closest --points middle'
  'arcs --eps 0.1' 'build --method bca --eps 1' 'arrange' 'query hull')
dxf "$rectangle" > loose.dxf
joined='joined: 4 open curves to 1 closed one'
for command in "${needing_inside[@]}" "${needing_none[@]}"; do
  # shellcheck disable=SC2086
  run $command loose.dxf
  expect_status 0
  lines "$joined"
  # shellcheck disable=SC2086
  run $command loose.dxf --strict
  expect_status 1
  lines "--strict: expected a file that is read as it stands, found one that is not: $joined"
  # shellcheck disable=SC2086
  run $command loose.dxf --strict --join-ends 0  # as it was asked for
  expect_status 0
  lines "$joined"
done
run info loose.dxf --strict
expect_status 1
expect_silence
run info loose.dxf --strict --join-ends 0
expect_status 0
inside '"area":32,' offset loose.dxf --distance=-1 --eps 0.01
inside 'offset by' report --stability none --eps 1 --offset 1 loose.dxf
lines "$joined"
inside '"winding":1' query locate --points middle loose.dxf
# not without being asked where no file was rounded, or where it is forbidden
at_four='4 open curves, whose ends meet at 4 places, the first from (0, 0) to (10, 0): --join-ends 0 joins them'
for command in "${needing_inside[@]}"; do
  # shellcheck disable=SC2086
  run $command loose.dxf --join-ends none
  expect_status 1
  lines "curve \"line1\": expected a closed curve, which has an inside, found an open one; the file has $at_four"
done
run offset loose.dxf --distance 1 --eps 0.01 --join-ends none
expect_status 0
lines "$at_four"
run offset loose.dxf --distance 1 --eps 0.01 --join-ends none --strict
expect_status 1
run arcs loose.dxf --eps 1 --join-ends none
lines_of_json='{"curves":[{"type":"bezier","degree":1,"control_points":[[0,0],[9,0]]},
{"type":"bezier","degree":1,"control_points":[[9,0],[0,9]]},
{"type":"bezier","degree":1,"control_points":[[0,9],[0,0]]}]}'
echo "$lines_of_json" > triangle.json
run query locate --points middle triangle.json
expect_status 1
inside '"winding":1' query locate --points middle triangle.json --join-ends 0
expect_line 'bounding_arcs: triangle.json: joined: 3 open curves to 1 closed one'
for word in -1 nan x 1x; do
  run arcs loose.dxf --eps 1 "--join-ends=$word"
  expect_status 2
  expect_line 'bounding_arcs: --join-ends: *expected none, or one number from 0 such as 0.01*'
done

# Gaps that are told can be joined so.
dxf "$(segment 0 0 10 0; segment 10 0.002 10 6; segment 10 6 0 6; segment 0 6 0 0)" > loose.dxf
run boolean union loose.dxf
expect_status 1
gap='1 open curve, whose ends are up to 0.002 apart at 1 place, from (10, 0.002) to (10, 0)'
try='--join-ends 0.002 joins them'
lines 'joined: 4 open curves to 1 open one' \
  "curve \"line1\": expected a closed curve, which has an inside, found an open one; the file has $gap: $try"
inside '"parent":null' boolean union loose.dxf --join-ends 0.002
lines 'joined: 4 open curves to 1 closed one, ends moved by up to 0.002'
# more than two ends at a place: a loop is one whatever else ends there, and others are left apart
dxf "$rectangle$(segment 10 6 12 8)" > loose.dxf
run offset loose.dxf --distance 1 --eps 0.01
expect_status 0
lines "$joined" 'taken for open: 1 open curve, from (10, 6) to (12, 8): no inside; --skip-open leaves it out'
dxf "$rectangle$(segment 0 0 10 6)" > loose.dxf
run offset loose.dxf --distance 1 --eps 0.01
expect_status 0
ambiguous='ambiguous: more than two ends meet at 2 places, the first (0, 0), and are not joined'
lines 'joined: 4 open curves to 2 open ones' "$ambiguous"
run offset loose.dxf --distance 1 --eps 0.01 --strict --join-ends 0
expect_status 1
lines 'joined: 4 open curves to 2 open ones' \
  "--strict: expected a file that is read as it stands, found one that is not: $ambiguous"
run info loose.dxf
grep -qx "$ambiguous" "$results/out" || fail "$command_line: does not tell: $ambiguous"
# but two that go on straight are joined
dxf "$(segment 0 0 4 0; segment 4 0 4 3; segment 4 0 9 0)" > loose.dxf
run offset loose.dxf --distance 1 --eps 0.01
expect_status 0
lines 'joined: 2 open curves to 1 open one'

# What stays open is left out where it is asked for, by all alike, and that is no fault.
dxf "$rectangle$(square a 20 30)$apart" > loose.dxf  # the last one meets no other
open='left out: 1 open curve, from (5, 0) to (6, 1): no inside'
for command in "${needing_inside[@]}"; do
  # shellcheck disable=SC2086
  run $command loose.dxf
  expect_status 0
  lines "$joined" "$open"
done
for command in "${needing_inside[@]}" "${needing_none[@]}"; do
  # shellcheck disable=SC2086
  [[ $command = clip* ]] || run $command loose.dxf --skip-open --strict --join-ends 0
  expect_status 0
  lines "$joined" "$open"
done
dxf "$rectangle$(segment 20 0 30 0)" > loose.dxf
run offset loose.dxf --distance 1 --eps 0.01 --skip-open
[ "$(grep -c '"parent":' "$results/out")" -eq 1 ] || fail "$command_line: not one chain"
run offset loose.dxf --distance 1 --eps 0.01
[ "$(grep -c '"parent":' "$results/out")" -eq 2 ] || fail "$command_line: not two chains"
run offset line.json --distance 1 --eps 0.01 --skip-open
expect_status 1
expect_line 'bounding_arcs: line.json: --skip-open: expected a closed curve, found 1 open curve, from (0, 0) to (8, 8)*'

# Ends that rounding parts, of doubles and of a file's digits, also across zero and of one curve alone.
offset_says() {  # ENTITIES LINE...
  dxf "$1" > loose.dxf
  run offset loose.dxf --distance 1 --eps 0.01
  expect_status 0
  shift
  if [ "$1" ]; then lines "$@"; else [ -z "$err" ] || fail "$command_line: said $err"; fi
}
offset_says "$(segment 0 0 10 0; segment 10 -1e-12 10 6; segment 10 6 0 6)" \
  'joined: 3 open curves to 1 open one, ends moved by up to 1e-12'
offset_says "$(segment 0.000000 0 10 0; segment 10 0.000001 10 6)" \
  'joined: 2 open curves to 1 open one, ends moved by up to 1e-06'
offset_says "$(segment 0 0 10 0; segment 10 0.1 10 6)" ''  # one digit tells nothing
offset_says "$(segment 0 0 1e-3 0; segment 1e-3 9e-7 1e-3 5e-4)" \
  '2 open curves, whose ends are up to 9e-07 apart at 1 place, the first from (0, 0) to (0.001, 0): '\
'--join-ends 9e-07 joins them'
offset_says "$(segment 0 0 10 0; segment 10 1 10 6)" ''
offset_says '0|LWPOLYLINE|8|0|90|4|70|0|10|0|20|0|10|4|20|0|10|4|20|4|10|1e-13|20|0|' \
  'joined: 1 open curve to 1 closed one, ends moved by up to 1e-13'
offset_says "$(segment 0 0 10 0; arc 10 270 90; segment 10 4 0 4; arc 0 90 270)" "$joined"
# ends of one layer go first
offset_says "$(segment 0 0 10 0; segment 10 0 10 6; segment 10 6 0 0)0|LINE|8|dim|10|10|20|0|11|12|21|0|" \
  'joined: 3 open curves to 1 closed one' \
  'taken for open: 1 open curve, from (10, 0) to (12, 0): no inside; --skip-open leaves it out'

# Of SVG files likewise, but for what the file itself fills.
svg '<g fill="none"><path d="M0 0h8v8"/><path d="M0 0v8h8"/></g>' > strokes.svg
inside '"parent":null' boolean union strokes.svg
expect_line 'bounding_arcs: strokes.svg: joined: 2 open curves to 1 closed one'
svg '<path d="M0 0h8v8"/><path d="M0 0v8h8"/>' > strokes.svg
run boolean union strokes.svg
expect_line 'bounding_arcs: strokes.svg: read all the same: 2 open curves: closed by a straight line*'
run boolean union strokes.svg --join-ends 0
expect_line 'bounding_arcs: strokes.svg: joined: 2 open curves to 1 closed one'

# What is on layers that were not asked for is not told.
dxf "$(square a 0 8)$text${text/MTEXT|8|0/TEXT|8|a}" > layers.dxf
run arcs layers.dxf --eps 1
expect_line 'bounding_arcs: layers.dxf: left out: 1 MTEXT: no curve; 1 TEXT: no curve'
run arcs layers.dxf --eps 1 --layers A
expect_line 'bounding_arcs: layers.dxf: left out: 1 TEXT: no curve'

# What is neither, by its name where it has one.
other() {
  run arcs other --eps 1
  expect_status 1
  expect_silence
  expect_line "bounding_arcs: other: line 1, column 1: $1"
}
printf 'AutoCAD Binary DXF\r\n\032\000' > other
other '*a binary DXF file*'
printf 'AC1032\000\000\000' > other
other '*a DWG file*'
printf 'PK\003\004' > other
other 'expected JSON, SVG or text DXF, found a file that begins with "PK\\x03\\x04"'

rm -f ./*
finish
