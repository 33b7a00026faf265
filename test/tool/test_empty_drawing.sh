#!/usr/bin/env bash
# Copyright (c) 2026 The Bounding Arcs authors.
# This file is part of Bounding Arcs, an add-on to CGAL.
# SPDX-License-Identifier: GPL-3.0-or-later
#
# A drawing of nothing, as results may be: each subcommand reads it, and answers it or says what it needs.
# Usage: test_empty_drawing.sh TOOL PROJECT_ROOT
. "$(dirname "${BASH_SOURCE[0]}")/support.sh"

cat > a.json <<'JSON'
{"name":"a","type":"path","pieces":[{"control_points":[[0,0],[2,0]]},{"control_points":[[2,0],[2,1]]},
 {"control_points":[[2,1],[0,1]]},{"control_points":[[0,1],[0,0]]}]}
JSON
run boolean difference a.json a.json -o e.json
expect_status 0
echo '1 0.5' > points

# answers ARGUMENTS: in order, without numbers that are none.
answers() {
  run "$@"
  expect_status 0
  expect_finite
  [ -z "$err" ] || fail "$command_line: printed on stderr: $err"
}
# has TEXT: the last run printed it.
has() { grep -qF -e "$1" "$results/out" || fail "$command_line: no $1: $(head -c 200 "$results/out")"; }

# An empty operand is like any other.
for operation in union symmetric-difference; do
  answers boolean $operation e.json a.json
  [ "$(grep -c '"type":"path"' "$results/out")" -eq 1 ] || fail "$command_line: not the other operand"
done
answers boolean difference a.json e.json
[ "$(grep -c '"type":"path"' "$results/out")" -eq 1 ] || fail "$command_line: not the first operand"
for operation in union intersection 'difference e.json' 'intersection a.json'; do
  # shellcheck disable=SC2086
  answers boolean $operation e.json
  has '"curves":[]'
done
# So is one whose curves all are points, but that they are curves.
cat > p.json <<'JSON'
{"curves":[{"type":"bezier","degree":1,"control_points":[[1,0.5],[1,0.5]]},
 {"type":"path","pieces":[{"control_points":[[9,9],[9,9],[9,9]]},{"control_points":[[9,9],[9,9]]}]}]}
JSON
for kernel in double filtered exact; do
  for operation in union intersection difference symmetric-difference; do
    answers boolean $operation p.json --kernel $kernel
    has '"status":"complete","moved":0,"curves":[]'
  done
  answers boolean union p.json a.json --kernel $kernel
  [ "$(grep -c '"type":"path"' "$results/out")" -eq 1 ] || fail "$command_line: not the other operand"
  answers boolean intersection a.json p.json --kernel $kernel
  has '"curves":[]'
done
answers boolean union p.json --format svg
has '</svg>'
answers boolean union p.json --format dxf --eps 1
has EOF
answers clip a.json p.json
has '"curves":[]'

answers clip a.json e.json
has '"curves":[]'
answers clip a.json e.json --keep outside
has '"name":"a"'
answers clip e.json a.json
has '"curves":[]'

for form in json csv svg; do
  answers build --method bca --eps 1 e.json --format $form
  answers offset --distance 1,-1 --eps 0.1 e.json --format $form
  answers arcs --eps 1 e.json --format $form
  answers query self-intersect e.json --format $form
  answers query locate e.json --points points --format $form
done
for command in 'offset --distance 1 --eps 0.1' 'arcs --eps 1' 'boolean union --eps 1'; do
  # shellcheck disable=SC2086
  answers $command e.json --format dxf
  has EOF
done
for command in 'boolean union' arrange 'clip a.json' 'query intersect a.json'; do
  # shellcheck disable=SC2086
  answers $command e.json --format svg
  has '</svg>'
done
answers offset --distance 1 --eps 0.1 e.json
has '"chains":[]'
answers query locate e.json --points points
has '"side":"outside"'
answers arrange e.json
[ "$(grep -c '"bounded"' "$results/out")" -eq 1 ] || fail "$command_line: not the unbounded face alone"
answers arcs --eps 1 e.json
answers compare --eps 1 e.json
answers verify --method bca --eps 1 e.json
answers verify --method bca --eps 1 e.json --format json
has '"regions":0'
answers build --method bca --eps 1 e.json a.json
has '"name":"a"'
printf '{"curves":[]}\n' > records
answers offset --distance 1 --eps 0.1 --stream records
has '"chains":[]'

# needs ARGUMENTS: a curve, which is told.
needs() {
  run "$@"
  expect_status 1
  expect_silence
  expect_line 'bounding_arcs: e.json: curves: expected at least one*, found none'
}
needs query closest e.json --points points
needs query closest e.json --points points --signed
needs query distance e.json a.json
needs query distance a.json e.json
needs query hausdorff a.json e.json
needs query hull e.json
needs compare --queries e.json
needs report e.json --stability none
needs report a.json e.json --stability none

# A DXF or SVG file without a curve shows something else.
run boolean union e.json --eps 1 -o e.dxf
run offset e.dxf --distance 1 --eps 0.1
expect_status 1
expect_line '*e.dxf: *'
echo '<svg xmlns="http://www.w3.org/2000/svg"/>' > e.svg
run offset e.svg --distance 1 --eps 0.1
expect_status 1
expect_line '*e.svg: *'

finish
