#!/usr/bin/env bash
# Copyright (c) 2026 The Bounding Arcs authors.
# This file is part of Bounding Arcs, an add-on to CGAL.
# SPDX-License-Identifier: GPL-3.0-or-later
#
# The thickness subcommand as a user runs it: necks, stretches below a limit in all forms, and the exit status.
# Usage: test_thickness.sh TOOL PROJECT_ROOT
. "$(dirname "${BASH_SOURCE[0]}")/support.sh"

# shape NAME PATH: an SVG file of a path.
shape() { printf '<svg xmlns="http://www.w3.org/2000/svg"><path d="%s"/></svg>\n' "$2" > "$1.svg"; }
# count NAME: how often it is in what the last run printed.
expect_count() {
  local found
  found=$(grep -o "\"$1\":" "$results/out" | wc -l)
  [ "$found" -eq "$2" ] || fail "$command_line: $found times $1 instead of $2"
}
# expect_row COLUMNS PATTERN: the only row of a table with these columns is like the glob pattern.
expect_row() {
  [ "$(head -1 "$results/out")" = "$1" ] || fail "$command_line: other columns: $(head -1 "$results/out")"
  [ "$(wc -l < "$results/out")" -eq 2 ] || fail "$command_line: not one row"
  # shellcheck disable=SC2053
  [[ $(tail -1 "$results/out") == $2 ]] || fail "$command_line: $(tail -1 "$results/out") is not like $2"
}
NECKS=x,y,thickness,x1,y1,x2,y2
STRETCHES=$NECKS,length,x_from,y_from,x_to,y_to,curve1,curve2,necks

# A neck, and the stretch that it is on.
shape hourglass 'M0 0L4 0L5 1.5L6 0L10 0V4H6L5 2.5L4 4H0Z'
run thickness hourglass.svg --eps 1e-6 --format csv
expect_status 0
expect_row $NECKS '5*,2*,1*'
run thickness hourglass.svg --eps 1e-6
expect_status 0
expect_count between 1
expect_count thickest 1
expect_count thinnest 1
expect_count stretches 0
grep -q '"status": "complete"' "$results/out" || fail "$command_line: no status"
run thickness hourglass.svg --eps 1e-6 --below 0.9
expect_status 0
[ -z "$err" ] || fail "$command_line: $err"
expect_count between 0
grep -q '"stretches": \[\]' "$results/out" || fail "$command_line: no list of stretches"
run thickness hourglass.svg --eps 1e-6 --below 1.2
expect_status 1
expect_finite
expect_line '*hourglass.svg: thickness: 1 stretch is thinner than 1.2, the least 1 at (5, 2)'
expect_count polyline 1
expect_count prominence 1
tr -d ' \n' < "$results/out" | grep -q '"curves":\[0\],"necks":\[0\]' ||
  fail "$command_line: the neck is not told to be on the stretch"
run thickness hourglass.svg --eps 1e-6 --below 1.2 --format csv
expect_status 1
expect_row $STRETCHES '5*,2*,1*,0,0,1'
run thickness hourglass.svg --eps 1e-3 --format svg -o thickness.svg
expect_status 0
grep -q '1 neck, the narrowest 1 thick' thickness.svg || fail 'thickness.svg: no title'
run thickness hourglass.svg --eps 1e-3 --below 1.2 --format svg -o thickness.svg
expect_status 1
expect_silence
xmllint --noout thickness.svg 2> /dev/null || ! command -v xmllint > /dev/null || fail 'thickness.svg is no XML'
grep -q '<title>1 stretch thinner than 1.2, the least 1 thick; 1 neck' thickness.svg || fail 'thickness.svg: no title'
[ "$(grep -c '<path class="t"' thickness.svg)" -eq 1 ] || fail 'thickness.svg: not one stretch'
# a scale of colours from 0 to the widest disc, and a mark at the limit
labels() { grep -o '<text class="k"[^<]*' "$1" | sed 's/.*>//' | paste -sd' '; }
widest=$(grep -o 'disc is [0-9.]*' thickness.svg | head -1 | cut -d' ' -f3)
[[ $(labels thickness.svg) == "0 "*" $widest thickness, red where it is below the limit" ]] ||
  fail "thickness.svg: the scale says $(labels thickness.svg), and the widest disc is $widest"
[ "$(grep -c '<path class="l"' thickness.svg)" -eq 1 ] || fail 'thickness.svg: no mark at the limit'
run thickness hourglass.svg --eps 1e-3 --below 100 --format svg -o thickness.svg
! grep -q '<path class="l"' thickness.svg || fail 'thickness.svg: a mark beside the scale'
run thickness hourglass.svg --eps 1e-3 --format svg -o thickness.svg
[[ $(labels thickness.svg) == "0 "*" $widest thickness" ]] ||
  fail "thickness.svg: the scale says $(labels thickness.svg)"
rm thickness.svg

# A bar is thin everywhere, and as thick as the limit it is not.
shape bar 'M0 0H5V0.8H0Z'
run thickness bar.svg --eps 1e-3 --below 1 --format csv
expect_status 1
expect_row $STRETCHES '*,0.4*,0.8*,*,0,0,?'
run thickness bar.svg --eps 1e-3 --below 0.8
expect_status 0
run thickness bar.svg --eps 1e-3
expect_status 0
expect_count prominence 0
grep -A9 '"thinnest"' "$results/out" | grep -qE '"thickness": 0\.(8|79999)' || fail "$command_line: not 0.8 at least"

# Fins and wedges are thin, and corners are not but for sharp ones.
shape fin 'M0 0H10V4H6L5.75 8H5.25L5 4H0Z'
run thickness fin.svg --eps 1e-3 --below 0.9 --format csv
expect_status 1
expect_row $STRETCHES '5.5*,7*'
shape wedge 'M0 0L10 2V-2Z'
run thickness wedge.svg --eps 1e-3 --below 0.5 --format csv
expect_status 1
expect_row $STRETCHES '0*,0*,0*,1.27*,0,0,0'
run thickness wedge.svg --eps 1e-3 --below 0.5 --corner 20
expect_status 0
shape square 'M0 0H2V2H0Z'
run thickness square.svg --eps 1e-3 --below 1.9
expect_status 0
run thickness square.svg --eps 1e-3 --below 1.9 --corner 91
expect_status 1
run thickness square.svg --eps 1e-3 --below 2.1 --format csv
expect_status 1
expect_row $STRETCHES '1*,1*,2*,0,0,0'

# Curves that bound nothing are not in the way.
shape nest 'M0 0H9V9H0ZM1 1H8V8H1Z'
run thickness nest.svg --eps 1e-3 --below 2 --rule nonzero
expect_status 0
expect_line '*nest.svg: thickness: 1 curve bounds nothing: the nonzero rule fills both sides or neither; --rule chooses'
grep -q '"left_out"' "$results/out" || fail "$command_line: the inner square is not told"
# The largest disc of an ellipse is about no vertex of its axis.
printf '<svg xmlns="http://www.w3.org/2000/svg"><ellipse rx="10" ry="4"/></svg>\n' > ellipse.svg
run thickness ellipse.svg --eps 0.001
expect_status 0
tr -d ' \n' < "$results/out" | grep -qE '"thickest":\{"point":\[[^]]*\],"thickness":(7\.99|8\.0|8\})' ||
  fail "$command_line: not 8 thick"
run thickness nest.svg --eps 1e-3 --below 2 --rule evenodd
expect_status 1
expect_count polyline 1
tr -d ' \n' < "$results/out" | grep -q '"curves":\[0,1\]' || fail "$command_line: not between both curves"

printf '{"name":"line","type":"bspline","degree":1,"knots":[0,0,1,1],"control_points":[[0,0],[2,0]]}\n' > line.json
run thickness line.json --eps 1e-3
expect_status 1
expect_line '*line.json: curve "line": expected a closed curve*'
for wrong in -1 nan x; do
  for option in below corner; do
    run thickness bar.svg --eps 1e-3 --$option="$wrong"
    expect_status 2
    expect_line "bounding_arcs: --$option*"
    expect_silence
  done
done
run thickness bar.svg --eps 1e-3 --corner 181
expect_status 2
run thickness bar.svg --eps 1e-3 --below 0
expect_status 0

rm ./*.svg line.json
finish
