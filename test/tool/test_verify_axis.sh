#!/usr/bin/env bash
# Copyright (c) 2026 The Bounding Arcs authors.
# This file is part of Bounding Arcs, an add-on to CGAL.
# SPDX-License-Identifier: GPL-3.0-or-later
#
# The verify-axis subcommand as a user runs it, on what medial-axis writes and on what is broken of it.
# Usage: test_verify_axis.sh TOOL PROJECT_ROOT
. "$(dirname "${BASH_SOURCE[0]}")/support.sh"

curve=$root/examples/data/d_rabbit.json
run medial-axis "$curve" --eps 1e-4 --feet --prove -o axis.json
expect_status 0
grep -q '"proof":{"proven":true,"tiled":true,"euler":true}' axis.json || fail "$command_line: no proof"
[ "$(grep -o '"status":"PROVEN","bound":' axis.json | wc -l)" -eq 19 ] || fail "$command_line: not 19 proven edges"
run verify-axis "$curve" axis.json
expect_status 0
grep -q '^right$' "$results/out" || fail "$command_line: not right"
run verify-axis "$curve" axis.json --format json
expect_status 0
expect_finite
grep -q '^{"right":true,"vertices":20,"edges":19,' "$results/out" || fail "$command_line: no head as promised"
input=axis.json run verify-axis "$curve" -
expect_status 0

# finds FAULT SCRIPT: what sed makes of the axis has that fault.
finds() {
  sed -e "$2" axis.json > broken.json
  cmp -s axis.json broken.json && fail "sed $2: changes nothing"
  run verify-axis "$curve" broken.json --format json
  expect_status 1
  grep -q "\"fault\":\"$1\"" "$results/out" || fail "$command_line, $2: no $1"
}
finds EULER 's/"holes":0/"holes":1/'
finds EULER '/^{"from":0,"to":/d'
finds TILING '/^{"from":0,"to":/d'
finds END '0,/"from":[0-9]*,/s//"from":3,/'
finds BOUND 's/"bound":[0-9.e-]*/"bound":1e-9/'
finds FORM 's/\[\[0,[0-9]*,/[[7,0,/'

# Half circles of four decimals: many tiles beside their ends are shorter than what counts as nothing.
printf '%s\n' 0 SECTION 2 ENTITIES 0 LWPOLYLINE 70 1 10 -0.4696 20 -0.3966 10 -3.7456 20 -13.2961 42 -1 \
  10 -5.7596 20 -12.7846 10 -2.4836 20 0.1149 42 -1 0 ENDSEC 0 EOF > slot.dxf
# All root arcs of a gear are on one circle: feet of its disc are anywhere on them.
cp "$root/test/data/axis/gear_of_root_arcs.dxf" gear.dxf
for name in slot gear; do
  run medial-axis $name.dxf --eps 0.01 --feet -o of_arcs.json
  expect_status 0
  run verify-axis $name.dxf of_arcs.json
  expect_status 0
done

# A vertex that is there twice is no crossing.
path() { printf '{"type":"path","pieces":[%s]}' "$(printf ',{"control_points":[%s]}' "$@" | cut -c2-)"; }
path '[0,0],[2,0]' '[2,0],[2,0]' '[2,0],[2,0]' '[2,0],[2,2]' '[2,2],[0,0]' '[0,0],[0,0]' > twice.json
run medial-axis twice.json --eps 1e-3 --cells -o cells.json
expect_status 0
run medial-axis twice.json --eps 1e-3 --feet --prove -o twice_axis.json
expect_status 0
run verify-axis twice.json twice_axis.json
expect_status 0
# but passing it again is one
path '[0,0],[2,0]' '[2,0],[2,0]' '[2,0],[2,2]' '[2,2],[3,0]' '[3,0],[2,0]' '[2,0],[0,0]' > again.json
run medial-axis again.json --eps 1e-3 --cells -o cells.json
expect_status 1

# What is no axis of the curves is refused, with its place.
# refuses PATTERN SCRIPT
refuses() {
  sed -e "$2" axis.json > broken.json
  run verify-axis "$curve" broken.json
  expect_status 1
  case $err in *broken.json*$1*) ;; *) fail "$command_line, $2: says $err" ;; esac
}
refuses 'edges\[0\]*--feet' 's/"feet"/"hands"/'
refuses 'edges\[0\].feet: expected * values, found *' 's/"feet":\[\[\[[^]]*\],\[[^]]*\]\],/"feet":[/'
refuses 'eps: expected a number, found "small"' 's/"eps":[^,]*/"eps":"small"/'
refuses 'vertices: expected a list, found an object' 's/"vertices":\[$/"vertices":{},"others":[/'
refuses 'document: expected JSON, found other text' 's/^.*$/[/'
refuses 'frame: *--frame' 's/"regions"/"frame":0,"regions"/'
run verify-axis "$curve" none.json
expect_status 1
run medial-axis "$curve" --eps 1e-3 --prove --prune 1
expect_status 2

run medial-axis "$root/doc/images/strokes.svg" --eps 0.05 --frame --feet -o framed.json
run verify-axis "$root/doc/images/strokes.svg" framed.json --frame
expect_status 0
run verify-axis "$root/doc/images/strokes.svg" framed.json
expect_status 1
run verify-axis "$root/doc/images/strokes.svg" framed.json --frame 100
expect_status 1

finish
