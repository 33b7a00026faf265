#!/usr/bin/env bash
# Copyright (c) 2026 The Bounding Arcs authors.
# This file is part of Bounding Arcs, an add-on to CGAL.
# SPDX-License-Identifier: GPL-3.0-or-later
#
# The arcs subcommand as a user runs it: forms of output, sides, and what is said when eps cannot be met.
# Usage: test_arcs.sh TOOL PROJECT_ROOT
. "$(dirname "${BASH_SOURCE[0]}")/support.sh"

curve=$root/examples/data/d_rabbit.json

# Every piece starts where the one before ends, to the last digit, and the closed curve's chain closes.
for continuity in tangent position; do
  run arcs --eps 1e-5 --continuity $continuity --format json "$curve"
  expect_status 0
  grep -o '"from":\[[^]]*\]' "$results/out" | cut -d: -f2 > from
  grep -o '"to":\[[^]]*\]' "$results/out" | cut -d: -f2 > to
  { tail -n +2 from; head -n 1 from; } > next
  cmp -s next to || fail "$command_line: pieces do not share their ends"
  arcs=$(grep -o '"arcs":[0-9]*' "$results/out" | cut -d: -f2)
  [ "$(wc -l < from)" -eq "$arcs" ] || fail "$command_line: $(wc -l < from) pieces, but arcs is $arcs"
  grep -q "\"continuity\":\"$continuity\",\"side\":\"two\"" "$results/out" ||
    fail "$command_line: options are not echoed"
done
rm from to next

# area: twice the area inside the polygon of the last run's ends and, above the chord, of its arcs' triangles.
# The inner chain encloses less than the outer one, whichever way the curve runs.
area() {
  sed -n 's/.*"from":\[\([^]]*\)\],"to":\[\([^]]*\)\].*"bulge":\([^,]*\),.*/\1,\2,\3/p' "$results/out" |
    awk -F, '{ a += $1*$4 - $2*$3 + $5 * (($3-$1)^2 + ($4-$2)^2) * 2/3 } END { printf "%.15f", a < 0 ? -a : a }'
}
points='[[0,0],[4,0],[4,3],[1,4],[-1,2]]'
backwards='[[-1,2],[1,4],[4,3],[4,0],[0,0]]'
for list in "$points" "$backwards"; do
  printf '{"type":"bspline","degree":3,"knots":"uniform","periodic":true,"closed":true,"control_points":%s}\n' \
    "$list" > closed.json
  for continuity in tangent position; do
    areas=()
    for side in inner two outer; do
      run arcs --eps 1e-3 --continuity $continuity --side $side --format json closed.json
      expect_status 0
      areas+=("$(area)")
    done
    awk -v a="${areas[0]}" -v b="${areas[1]}" -v c="${areas[2]}" 'BEGIN { exit !(0 < a && a < b && b < c) }' ||
      fail "$continuity: inner, two-sided and outer chain enclose ${areas[*]}"
  done
done
rm closed.json

run arcs --eps 1e-4 --repeat 1 "$curve" "$root/examples/data/a_wrench.json"
expect_status 0
for name in d_rabbit a_wrench all; do grep -q "^$name " "$results/out" || fail "$command_line: no row of $name"; done

run arcs --eps 0.01 --format svg "$curve" -o picture.svg
expect_status 0
expect_files picture.svg
grep -q '</svg>' picture.svg || fail "$command_line: no picture"
rm picture.svg

run arcs --eps 1e-17 --format json "$curve" -o out.json
expect_status 1
expect_line 'bounding_arcs: *d_rabbit.json: curve "d_rabbit": eps 1e-17 is below what its coordinates and*'
expect_files
run arcs --eps 1e-8 --max-arcs 10 "$curve" -o out.json
expect_status 1
expect_line '*eps 1e-08 needs more than 10 arcs*'
expect_files

# A segment is one arc, whatever its weights.
echo '{"type":"bezier","degree":1,"control_points":[[0,0],[1,0]],"weights":[1,1e6]}' > weighted.json
run arcs --eps 1e-12 --format csv weighted.json
expect_status 0
grep -q '^w[^,]*,0,0,1,0,[^,]*,0,0,1,0,0$' "$results/out" || fail "$command_line: not one segment"
[ "$(wc -l < "$results/out")" -eq 2 ] || fail "$command_line: not one arc"

# What is a circle is two halves of it, however many pieces the file has; so are arcs of one circle.
printf '<svg xmlns="http://www.w3.org/2000/svg"><circle id="c" r="5"/>%s</svg>' \
  '<path id="a" d="M20 0A5 5 0 0 1 25 5A5 5 0 0 1 20 10"/>' > circle.svg
run arcs circle.svg --eps 0.01 --format csv
expect_status 0
[ "$(tail -n +2 "$results/out" | cut -d, -f1-5 | paste -sd' ')" = 'c,0,0,1,1 c,2,0,1,3 a,0,0,1,1' ] ||
  fail "$command_line: $(cat "$results/out")"
run arcs circle.svg --eps 0.01 --format json
[ "$(grep -o '"bezier":[0-9]*,"t":\[0,1\],"bezier_end":[0-9]*' "$results/out" | tr -dc '0-9\n' | paste -sd' ')" = \
  '0011 2013 0011' ] || fail "$command_line: $(cat "$results/out")"
rm circle.svg

finish
