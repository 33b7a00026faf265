#!/usr/bin/env bash
# Copyright (c) 2026 The Bounding Arcs authors.
# This file is part of Bounding Arcs, an add-on to CGAL.
# SPDX-License-Identifier: GPL-3.0-or-later
#
# The medial-axis subcommand as a user runs it: forms of output, pruning, and what is said of what has no axis.
# Usage: test_medial_axis.sh TOOL PROJECT_ROOT
. "$(dirname "${BASH_SOURCE[0]}")/support.sh"

curve=$root/examples/data/d_rabbit.json
# polygon NAME CORNERS: a closed file of straight edges.
polygon() {
  local knots count
  count=$(grep -o '\],' <<< "$2" | wc -l)
  knots=$(seq -s, 0 "$count")
  printf '{"name":"%s","type":"bspline","degree":1,"knots":[0,%s,%d],"closed":true,"control_points":[%s]}\n' \
    "$1" "$knots" "$count" "$2" > "$1.json"
}
polygon oblong '[0,0],[4,0],[4,2],[0,2],[0,0]'
polygon bow '[0,0],[2,2],[2,0],[0,2],[0,0]'

# count NAME: how often it is in what the last run printed.
count() { grep -o "\"$1\":" "$results/out" | wc -l; }
expect_count() { [ "$(count "$1")" -eq "$2" ] || fail "$command_line: $(count "$1") times $1 instead of $2"; }

run medial-axis oblong.json --eps 0.0009765625
expect_status 0
expect_finite
expect_count point 6
expect_count polyline 5
grep -q '^{"eps":0.0009765625,"moved":0,"regions":1,"holes":0,"error":' "$results/out" ||
  fail "$command_line: no head as promised"
grep -q '"point":\[1,1\],"radius":1,"touches":\[{"curve":0,"name":"oblong","bezier":[0-3],"t":' "$results/out" ||
  fail "$command_line: no vertex at 1, 1"
grep -q '"sites":\[{"curve":0,.*},{"curve":0,.*}\],"polyline":\[\[' "$results/out" || fail "$command_line: no sites"
run medial-axis oblong.json --eps 1e-6 --feet
expect_count feet 5
run medial-axis oblong.json --eps 1e-6 --prune 100
expect_count polyline 1

run medial-axis oblong.json --eps 1e-6 --prune-angle 91
expect_count polyline 1
run medial-axis oblong.json --eps 1e-6 --prune-angle 89
expect_count polyline 5
# A bit of 90 degrees goes as deep as the disc's radius, one of 60 by the square root of 3 deeper.
run medial-axis oblong.json --eps 1e-6 --v-bit 90
expect_status 0
grep -q '"v_bit":90' "$results/out" || fail "$command_line: no v_bit"
grep -qE '\[1,1,1,-(1(\.0*[0-9]+)?|0\.99999[0-9]*)\]' "$results/out" || fail "$command_line: not 1 deep at 1, 1"
run medial-axis oblong.json --eps 1e-6 --v-bit 60
grep -qE '\[1,1,1,-1\.7320508075688[0-9]*\]' "$results/out" || fail "$command_line: not as deep at 1, 1"

# Bisectors of the oblong's sides are lines: one conic an edge, its middle point half-way.
run medial-axis oblong.json --eps 1e-6 --conics
expect_status 0
expect_count conics 5
expect_count weights 5
grep -qF '"conics":[{"control_points":[[1,1],[' "$results/out" || fail "$command_line: no conic from a vertex"
grep -qF '"weights":[1,1,1],"error":' "$results/out" || fail "$command_line: no weights"

# One curve has all of what it encloses; of the frame's side there is another cell, and one of the frame.
run medial-axis oblong.json --eps 1e-6 --cells
expect_status 0
expect_count rim 1
grep -q '"curve":0,.*"reversed":false,"whole":true' "$results/out" || fail "$command_line: not a cell of all"
run medial-axis oblong.json --eps 1e-6 --cells --frame 1
expect_count rim 3
run medial-axis oblong.json --eps 1e-6 --cells --frame 1 --format svg
grep -q 'fill-opacity' "$results/out" || fail "$command_line: no cell is drawn"
run medial-axis oblong.json --eps 1e-6 --cells --prune 1
expect_status 2
# An arc whose ends other curves share has a sector, about the vertex in its center.
cat > sector.json << 'END'
{"curves":[{"type":"bezier","degree":2,"control_points":[[1,0],[1,1],[0,1]],"weights":[1,1,2]},
{"type":"bezier","degree":1,"control_points":[[1,0],[1,-1]]},
{"type":"bezier","degree":1,"control_points":[[0,1],[-1,1]]}]}
END
run medial-axis sector.json --eps 1e-3 --cells --frame 1
expect_status 0
grep -qE '"curve":0,.*"reversed":false,"whole":false,"rim":\[\],"vertex":[0-9]+\}' "$results/out" ||
  fail "$command_line: no sector"
! grep -q '"t":-' "$results/out" || fail "$command_line: a parameter below 0"

run medial-axis oblong.json --eps 1e-3 --prune-angle 170
expect_status 2

run medial-axis "$curve" --eps 1e-3
expect_status 0
expect_count point 20
run medial-axis - --eps 1e-3 < /dev/null
expect_status 1
input=$curve run medial-axis - --eps 1e-3
expect_count point 20
run medial-axis "$curve" --eps 1e-3 --format svg --discs -o picture.svg
expect_status 0
expect_silence
[ "$(grep -c '<circle' picture.svg)" -eq 40 ] || fail "$command_line: not 20 discs with their centers"
grep -q '</svg>' picture.svg || fail "$command_line: no picture"
rm picture.svg

run medial-axis bow.json --eps 1e-3 --cells
expect_status 1
expect_line '*bow.json: medial-axis: expected curves that do not cross, or a frame, found a crossing; '\
'boolean union makes curves without one that have the same axis'
run medial-axis bow.json --eps 0.001953125
expect_status 0
expect_finite
grep -q '^{"eps":0.001953125,"moved":[0-9.e-]*,"regions":2,' "$results/out" ||
  fail "$command_line: not the axis of both halves"
printf '{"name":"line","type":"bspline","degree":1,"knots":[0,0,1,1],"control_points":[[0,0],[2,0]]}\n' > line.json
run medial-axis line.json --eps 1e-3
expect_status 1
expect_line "*line.json: curve \"line\": expected a closed curve*"
run medial-axis oblong.json --eps 1e-17
expect_status 1
expect_line '*oblong.json: medial-axis: eps 1e-17 is below what its coordinates and weights resolve*'
# Two curves cross some 1e-12 beside their joint, where one begins with a handle of 1e-6: what they enclose there is
# nothing.
cat > tip.svg << 'END'
<svg xmlns="http://www.w3.org/2000/svg"><path d="M10.2073606875 21.28370146875C10.294007834317002 21.2662350824
12.63360246875 20.82646825 12.63360246875 20.82646825C12.633601686087 20.826469427897 11.6320800656 18.957557426451
11.29270259375 17.6538849375L10.2073606875 21.28370146875z"/></svg>
END
run medial-axis tip.svg --eps 1e-3
expect_status 0
expect_count polyline 3
# Ellipses touch but for rounding: it is the axis of such that are moved.
run medial-axis "$root/test/data/axis/five_shapes.json" --eps 1e-3
expect_status 0
grep -qE '"moved": ?[1-9][.0-9]*e-1[1-5]' "$results/out" || fail "$command_line: nothing is moved"

# Sides of tips leave alike up to third derivatives.
run medial-axis "$root/test/data/axis/sixteen_tips.json" --eps 1e-3
expect_status 0
grep -q '"regions":1,"holes":0,' "$results/out" || fail "$command_line: not one region"

# What cannot be told apart is left out, with its place: slivers 1e-8 wide.
shapes=$root/test/data/axis/two_slivers.json
run medial-axis "$shapes" --eps 1e-3
expect_status 1
expect_finite
where='* told apart at 2 places, the first beside (89.522, -7.277)'
expect_line "*two_slivers.json: medial-axis: discs$where; the rest is written"
grep -q '"status":"unresolved","unresolved":\[\[89.522,-7.277\],\[89.522,-27.277\]\],"vertices":\[$' "$results/out" ||
  fail "$command_line: not the place"
run medial-axis "$shapes" --eps 1e-3 --prune 1
expect_status 1
expect_line "*two_slivers.json: medial-axis: discs$where"
run thickness "$shapes" --eps 1e-3
expect_status 1
expect_finite
expect_line "*two_slivers.json: thickness: discs$where; the rest is written"
grep -q '"status": "unresolved"' "$results/out" || fail "$command_line: no status"
grep -qE '"thickest": ' "$results/out" || fail "$command_line: the rest is not written"
run thickness "$shapes" --eps 1e-3 --format svg
[ "$(grep -c '<circle class="u"' "$results/out")" -eq 2 ] || fail "$command_line: the places are not marked"
for format in csv svg; do
  run thickness "$shapes" --eps 1e-3 --format $format
  expect_status 1
  [ -s "$results/out" ] || fail "$command_line: nothing is written"
done

# A square in a square of its direction bounds nothing under the nonzero rule, and a hole under the even-odd one.
printf '<svg xmlns="http://www.w3.org/2000/svg"><path d="M0 0H9V9H0ZM3 3H6V6H3Z"/></svg>\n' > nest.svg
run medial-axis nest.svg --eps 1e-3 --feet --prove --rule nonzero -o axis.json
expect_status 0
expect_line "*nest.svg: medial-axis: 1 curve bounds nothing: the nonzero rule fills both sides or neither; "\
"--rule chooses"
grep -q '"regions":1,"holes":0,' axis.json || fail "$command_line: not the axis of the outer square"
grep -q '"left_out":\[1\],' axis.json || fail "$command_line: the inner square is not told"
grep -q '"proof":{"proven":true' axis.json || fail "$command_line: not proven"
run verify-axis nest.svg axis.json --rule nonzero
expect_status 0
run verify-axis nest.svg axis.json --rule evenodd
expect_status 1
run medial-axis nest.svg --eps 1e-3 --rule evenodd
expect_status 0
grep -q '"regions":1,"holes":1,' "$results/out" || fail "$command_line: not the axis of a ring"
! grep -q left_out "$results/out" || fail "$command_line: a curve is left out"
rm axis.json nest.svg
run medial-axis no.json --eps 1e-3
expect_status 1
expect_line '*no.json*'
for wrong in 0 -1 one 1e-3,1e-4 inf; do
  run medial-axis oblong.json --eps "$wrong"
  expect_status 2
  expect_silence
done
run medial-axis oblong.json
expect_status 2
for wrong in -1 nan -nan inf 1e301 x; do
  for option in prune prune-angle frame; do
    run medial-axis oblong.json --eps 1e-3 --$option="$wrong"
    expect_status 2
    expect_line "bounding_arcs: --$option*"
    expect_silence
  done
done
run medial-axis oblong.json --eps 1e-3 --rule odd
expect_status 2

# two lines in a frame, and what makes no frame
printf '<svg xmlns="http://www.w3.org/2000/svg"><path d="M0 0L2 0M0 1L2 1"/></svg>\n' > lines.svg
run medial-axis lines.svg --eps 1e-3 --frame=0.5
expect_status 0
expect_finite
grep -q '^{"eps":0.001,"moved":[0-9.e-]*,"frame":2,"regions":1,"holes":2,' "$results/out" ||
  fail "$command_line: no head as promised"
grep -q '"point":\[[^]]*,0.5\],"radius":0.5,' "$results/out" || fail "$command_line: no vertex between the lines"
run medial-axis line.json --eps 1e-3 --frame
expect_status 0
cp "$results/out" expected
for words in 'line.json' '0 line.json' '-- line.json'; do  # only a number is a margin
  # shellcheck disable=SC2086
  run medial-axis --eps 1e-3 --frame $words
  expect_status 0
  cmp -s expected "$results/out" || fail "$command_line: another axis than with --frame as the last word"
done
rm expected
run medial-axis bow.json --eps 0.001953125 --frame
expect_status 0
head=',"moved":[0-9.e-]*,"frame":1,"regions":3,"holes":1,'
grep -q "^{\"eps\":0.001953125$head" "$results/out" ||
  fail "$command_line: not all three parts"
cat > strokes.json <<'JSON'
{"curves":[{"name":"a","type":"bezier","degree":1,"control_points":[[0,0],[2,2]]},
 {"name":"b","type":"bezier","degree":1,"control_points":[[0,2],[2,0]]}]}
JSON
run medial-axis strokes.json --eps 1e-3 --frame
expect_status 0
grep -q '^{"eps":0.001,"moved":[0-9.e-]*,"frame":2,"regions":1,"holes":1,' "$results/out" ||
  fail "$command_line: not the axis of two strokes that cross"
rm strokes.json
for wrong in -1 wide; do
  run medial-axis line.json --eps 1e-3 --frame="$wrong"
  expect_status 2
done
run medial-axis lines.svg --eps 1e-3 --frame --format svg -o picture.svg
grep -q '<path class="f"' picture.svg || fail "$command_line: edges of the frame are drawn as others"
rm picture.svg lines.svg

rm oblong.json bow.json line.json
finish
