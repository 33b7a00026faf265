#!/usr/bin/env bash
# Copyright (c) 2026 The Bounding Arcs authors.
# This file is part of Bounding Arcs, an add-on to CGAL.
# SPDX-License-Identifier: GPL-3.0-or-later
#
# The offset subcommand as a user runs it: forms of output, joins, sides, and what is said of wrong options.
# Usage: test_offset.sh TOOL PROJECT_ROOT
. "$(dirname "${BASH_SOURCE[0]}")/support.sh"

curve=$root/examples/data/d_rabbit.json
cat > square.json <<'JSON'
{"name":"square","type":"bspline","degree":1,"knots":[0,0,1,2,3,4,4],"closed":true,
 "control_points":[[0,0],[2,0],[2,2],[0,2],[0,0]]}
JSON
cat > corner.json <<'JSON'
{"name":"corner","type":"bspline","degree":1,"knots":[0,0,1,2,2],"control_points":[[0,0],[2,0],[2,2]]}
JSON

# areas: those of the last run's chains, rounded to six digits.
areas() { grep -o '"area":[^,]*' "$results/out" | cut -d: -f2 | awk '{ printf("%s%.6g", (NR > 1 ? " " : ""), $1) }'; }
expect_areas() { [ "$(areas)" = "$1" ] || fail "$command_line: areas are $(areas) instead of $1"; }

run offset square.json --distance 0.5,-0.5,-1,-3 --eps 1e-6
expect_status 0
expect_finite
expect_areas '8.7854 1'
[ "$(grep -c '"distance":' "$results/out")" -eq 4 ] || fail "$command_line: not four offsets"
grep -q '"closed":true,"orientation":"ccw","parent":null' "$results/out" || fail "$command_line: no chain as promised"
grep -q '"source":{"curve":0,"name":"square","bezier":[0-3],"t":[^,]*,"t_end":' "$results/out" ||
  fail "$command_line: no sources"
grep -q '"t_end":[^,]*,"bezier_end":[0-3]}' "$results/out" || fail "$command_line: no ends of sources"
run offset square.json --distance 0.5 --eps 1e-6 --join miter
expect_areas 9
run offset square.json --distance 0.5 --eps 1e-6 --join miter --miter-limit 1.1
expect_areas 8.5
run offset square.json --distance 0.5 --eps 1e-6 --join bevel
expect_areas 8.5

run offset corner.json --distance 0.5 --eps 1e-6 --cap butt --join miter
expect_areas 4
run offset corner.json --distance 0.5 --eps 1e-6 --cap square --join miter
expect_areas 5
for side in left right; do
  run offset corner.json --distance 0.5 --eps 1e-6 --side $side
  expect_status 0
  [ "$(grep -c '"closed":false' "$results/out")" -eq 1 ] || fail "$command_line: not one open chain"
done

# One side of a closed curve: its inset on the left, as it runs counterclockwise, and its outset on the right.
run offset square.json --distance 0.5 --eps 1e-6 --side left
expect_status 0
expect_areas 1
run offset square.json --distance 0.5 --eps 1e-6 --side right
expect_areas 8.7854
run offset square.json --distance 0.5 --eps 1e-6 --side right --join miter
expect_areas 9

# Within an eps as large as a distance anything would be right; at distance 0 nothing is moved.
for eps in 0.5 0.25 1e300; do
  run offset square.json --distance 1,-0.25 --eps $eps
  expect_status 2
  expect_silence
  found=$eps
  [ $eps != 1e300 ] || found=1e+300
  smaller=-0.25
  [ $eps != 1e300 ] || smaller=1
  expect_line "bounding_arcs: --eps: expected less than the size of --distance $smaller, found $found"
done
run offset --distance 0.1 --eps 0.1 --stream square.json
expect_status 2
run offset square.json --distance 0 --eps 1
expect_status 0
expect_areas 4

# Numbers have the digits that were typed, in each form.
run offset square.json --distance 0.1,-0.3 --eps 1e-6
for text in '"eps":1e-06' '"distance":0.1,' '"distance":-0.3,' '"from":[2.1,2]'; do
  grep -qF -e "$text" "$results/out" || fail "$command_line: no $text"
done
run offset square.json --distance 0.1,-0.3 --eps 1e-6 --format dxf
for text in offset_0.1 offset_-0.3 2.1; do
  grep -qx -e "$text" "$results/out" || fail "$command_line: no $text"
done
run offset square.json --distance 0.1,-0.3 --eps 0.0123456789 --format svg
for text in '<title>0.1</title>' '<title>offsets within 0.01235: '; do
  grep -qF -e "$text" "$results/out" || fail "$command_line: no $text"
done
run offset square.json --distance 0.1,-0.3 --eps 1e-6 --format csv
grep -q '^0.1,0,curve,square,0,0,1,0,0,-0.1,2,-0.1,0$' "$results/out" || fail "$command_line: other digits"

# A circle is a circle, a slot four pieces, a rounded rectangle eight; a CIRCLE in either form of DXF.
shape() { printf '<svg xmlns="http://www.w3.org/2000/svg">%s</svg>\n' "$1" > shape.svg; }
for case in '2 <circle cx="5" cy="7" r="3"/>' '2 <ellipse cx="5" cy="7" rx="3" ry="3"/>' \
  '2 <path d="M8 7A3 3 0 0 1 2 7A3 3 0 0 1 8 7Z"/>' '4 <rect x="1" y="2" width="30" height="10" rx="5"/>' \
  '4 <path d="M0 0H20A5 5 0 0 1 20 10H0A5 5 0 0 1 0 0Z"/>' '8 <rect x="1" y="2" width="30" height="10" rx="3"/>'; do
  shape "${case#* }"
  for d in 1 -1; do
    run offset shape.svg --distance $d --eps 1e-6
    [ "$(grep -c '"from"' "$results/out")" -eq "${case%% *}" ] || fail "$command_line: not ${case%% *} pieces: $case"
    for form in polylines arcs; do
      run offset shape.svg --distance $d --eps 1e-6 --format dxf --dxf-entities $form
      [ "$(grep -c '^CIRCLE' "$results/out")" -eq $((${case%% *} == 2)) ] || fail "$command_line: circles: $case"
    done
  done
done
shape '<circle cx="5" cy="7" r="3"/>'
run offset shape.svg --distance 1 --eps 1e-6 --format dxf
awk '{ code = $1; getline } code == 0 { on = $1 == "CIRCLE" } on && (code == 10 || code == 20 || code == 40)' \
  "$results/out" | paste -sd ' ' | grep -qx '5 -7 4' || fail "$command_line: another circle"
rm shape.svg

# Each piece starts where the one before ends, to the last digit.
run offset "$curve" --distance 0.1 --eps 1e-5
expect_status 0
grep -o '"from":\[[^]]*\]' "$results/out" | cut -d: -f2 > from
grep -o '"to":\[[^]]*\]' "$results/out" | cut -d: -f2 > to
{ tail -n +2 from; head -n 1 from; } > next
cmp -s next to || fail "$command_line: pieces do not share their ends"
rm from to next

run offset "$curve" --distance 0.1,-0.05 --eps 1e-3 --format svg -o picture.svg
expect_status 0
grep -q '</svg>' picture.svg || fail "$command_line: no picture"
rm picture.svg

for wrong in 'one' '' '1,,2' 'inf' '1x'; do
  run offset square.json --distance "$wrong" --eps 1e-3
  expect_status 2
  expect_silence
done
for far in 1e154 -1e154 1e300 1e308 1e150; do
  run offset square.json --distance "$far" --eps 1e-3
  expect_status 1
  expect_silence
  expect_line "bounding_arcs: square.json: offset: distance: expected a number up to 2^500 (3e150), and up to 2^100\
 (1e30) times the drawing's size, found *"
done
run offset square.json --distance 1 --eps 0
expect_status 2
run offset square.json --distance 1
expect_status 2
run offset square.json --distance 1 --eps 1e-3 --join mitre
expect_status 2
run offset no.json --distance 1 --eps 1e-3
expect_status 1
expect_line '*no.json*'
run offset "$curve" --distance 0.1 --eps 1e-17
expect_status 1
expect_line '*d_rabbit.json: offset: eps 1e-17 is below what its coordinates and weights resolve*'

rm square.json corner.json
finish
