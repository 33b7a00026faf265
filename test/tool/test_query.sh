#!/usr/bin/env bash
# Copyright (c) 2026 The Bounding Arcs authors.
# This file is part of Bounding Arcs, an add-on to CGAL.
# SPDX-License-Identifier: GPL-3.0-or-later
#
# The query subcommands as a user runs them: known answers, forms of output, kernels, and what is said of bad input.
# Usage: test_query.sh TOOL PROJECT_ROOT
. "$(dirname "${BASH_SOURCE[0]}")/support.sh"

data=$root/examples/data
# A square, its diagonal as a cubic, and a unit circle of rational quadratics.
cat > square.json <<'JSON'
{"name":"square","type":"bspline","degree":1,"closed":true,"knots":[0,0,1,2,3,4,4],
 "control_points":[[0,0],[2,0],[2,2],[0,2],[0,0]]}
JSON
cat > diagonal.json <<'JSON'
{"name":"diagonal","type":"bezier","degree":3,"control_points":[[-1,-1],[0,0],[1,1],[5,5]]}
JSON
cat > far.json <<'JSON'
{"name":"far","type":"bezier","degree":1,"control_points":[[5,0],[5,2]]}
JSON

# expect_json PATTERN: standard output without line ends holds it.
expect_json() {
  tr -d '\n' < "$results/out" | grep -qE -- "$1" || fail "$command_line: $(head -c 400 "$results/out") is not like $1"
}

for kernel in double filtered exact; do
  printf '1 -1\n# a comment\n\n3,3\n' > points
  run query closest square.json --points points --kernel $kernel
  expect_status 0
  expect_json '"query":\[1.0,-1.0\],"distance":\[(1.0|0.999999999999[0-9]*),1.0[0-9]*\],"point":\[1.0,0.0\],"place":\{'
  expect_json '"place":\{"curve":0,"name":"square","bezier":0,"t":0.5\}'
  expect_json '"query":\[3.0,3.0\].*"point":\[2.0,2.0\]'
  run query locate square.json --points points --kernel $kernel
  expect_status 0
  expect_json '"winding":0,"side":"outside"'
  run query intersect square.json diagonal.json --kernel $kernel
  expect_status 0
  expect_json '"overlaps":\[\]'
  run query distance square.json far.json --kernel $kernel
  expect_status 0
  expect_json '"distance":\[(2.99999999999|3.0).*,3.0[0-9]*\],"a":\{"point":\[2.0,'
  run query hausdorff square.json far.json --kernel $kernel
  expect_status 0
  expect_json '"distance":\[(4.99999999|5.0).*,5.0[0-9]*\],"directed":\[\[(4.9999|5.0)[^]]*\],\[(2.9999|3.0)'
  run query self-intersect "$root/doc/images/loop.json" --kernel $kernel
  expect_status 0
  expect_json '^\{"intersections":\[\{"point":[^{]*"kind":"transversal","a":\{[^{]*"b":\{[^{]*\}\}\],"overlaps":\[\]\}$'
  expect_json '"a":\{"curve":0,"bezier":0,"t":\[0.0970[0-9]*,0.0970[0-9]*\]\}'
done

# The three kernels on the hard cases: exact and filtered give the same, double the same points or leaves some open.
points_of() {
  tr -d '\n' < "$1" | grep -oE '"point":\[[^]]*\],"kind":"[a-z]*"' | sed -E 's/([0-9]\.[0-9]{5})[0-9]*/\1/g'
}
for file in "$root"/test/data/queries/*.json; do
  run query self-intersect "$file" --kernel exact
  expect_status 0
  cp "$results/out" exact_answer
  grep -q undecided exact_answer && fail "$command_line: undecided"
  run query self-intersect "$file" --kernel filtered
  cmp -s exact_answer "$results/out" || fail "$command_line: not as with --kernel exact"
  run query self-intersect "$file" --kernel double
  expect_status 0
  grep -q undecided "$results/out" || [ "$(points_of "$results/out")" = "$(points_of exact_answer)" ] ||
    fail "$command_line: not as with --kernel exact"
done
rm exact_answer

# Distances with a sign: inside, outside, and 0 on a curve.
printf '1 0.5\n4 2\n2 1\n' > points
for kernel in filtered exact; do
  run query closest square.json --points points --signed --kernel $kernel
  expect_status 0
  expect_json '"distance":\[-0.50*[0-9]*,-0.4999999[0-9]*\],"side":"inside"'
  expect_json '"distance":\[(2.0|1.999999)[0-9]*,2.0[0-9]*\],"side":"outside"'
  expect_json '"distance":\[0.0,0.0\],"side":"on"'
done

# Lengths are squared in queries and fits, so that what is larger is refused.
echo '{"name":"huge","type":"bezier","degree":1,"control_points":[[0,0],[1e200,0]]}' > huge.json
for command in 'query hull' 'offset --distance 2 --eps 1' 'medial-axis --eps 1' 'arcs --eps 1'; do
  run $command huge.json
  expect_status 1
  expect_silence
  expect_line 'bounding_arcs: huge.json: curve "huge": control point *: expected coordinates up to 2^500 (3e150)*'
done
rm huge.json
for far in 1.4e154 1e300 -1e308; do
  echo "0 $far" > points
  for query in closest locate; do
    run query $query square.json --points points
    expect_status 1
    expect_silence
    expect_line 'bounding_arcs: points: line 1: expected coordinates up to 2^500 (3e150), found *'
  done
done

run query hull square.json
expect_status 0
[ "$(grep -c '"type"' "$results/out")" -eq 4 ] || fail "$command_line: $(cat "$results/out")"
expect_json '"diameter":\[2.82842[0-9]*,2.82842[0-9]*\]'
expect_json '"circle":\{"center":\[[01].[0-9]*,[01].[0-9]*\],"radius":\[1.41421'

# Where doubles tell no more, that is said; weights that differ by a million are no reason to go on for ever.
run query hull "$data/d_rabbit.json" --eps 1e-15
expect_status 0
expect_json '"radius":\[1.08754320832[0-9]*,1.08754320832[0-9]*\]\},"status":"resolution_reached"\}$'
cat > conic.json <<'JSON'
{"type":"bezier","degree":2,"control_points":[[1.5,1.5],[0,1],[-1.5,-0.5]],"weights":[1,1,1e-6]}
JSON
echo '{"type":"bezier","degree":1,"control_points":[[0,-2],[-0.5,0.5]]}' > line.json
run query hausdorff conic.json line.json
expect_status 0
expect_json '"distance":\[2.23606797749[0-9]*,2.23606797[0-9]*\]'
rm conic.json line.json

# A curve is through two corners: found twice, each once, and certainly so only by exact arithmetic.
run query intersect square.json diagonal.json --kernel exact
[ "$(grep -o '"kind":"transversal"' "$results/out" | wc -l)" -eq 2 ] || fail "$command_line: $(cat "$results/out")"
expect_json '"a":\{"curve":0,"bezier":2,"t":\[0.0,0.0\]\}'
# A curve on itself is one overlap from end to end.
run query intersect "$data/a_wrench.json" "$data/a_wrench.json"
expect_json '"intersections":\[\],"overlaps":\[\{"a":\{"from":\{[^}]*"bezier":0,"t":0.0\},'
expect_json '"to":\{[^}]*"bezier":27,"t":1.0\}\}'
printf '1 1\n2 1\n1 0\n2.0000000000000004 1\n' > points
run query locate square.json --points points --kernel exact --format csv
expect_status 0
printf 'x,y,winding,side\n1.0,1.0,1,inside\n2.0,1.0,-,on\n1.0,0.0,-,on\n2.0000000000000004,1.0,0,outside\n' > wanted
cmp -s wanted "$results/out" || fail "$command_line: $(cat "$results/out")"
rm wanted

for form in table csv svg; do
  run query closest square.json --points points --format $form
  expect_status 0
  run query distance square.json far.json --format $form
  expect_status 0
  run query hausdorff square.json far.json --format $form
  expect_status 0
  run query intersect square.json square.json --format $form
  expect_status 0
  [ -s "$results/out" ] || fail "$command_line: printed nothing"
done
grep -q '</svg>' "$results/out" || fail "$command_line: no picture"
run query intersect square.json diagonal.json --format svg -o picture.svg
expect_status 0
expect_silence
grep -q '</svg>' picture.svg || fail "$command_line: no picture"
rm picture.svg

# Bad input: one line, and nothing on standard output.
printf '1 2\n3 x\n' > bad
run query closest square.json --points bad
expect_status 1
expect_silence
expect_line '*bad: line 2: expected two numbers such as*'
printf '1 2 3\n' > bad
run query closest square.json --points bad
expect_status 1
expect_line '*bad: line 1: expected two numbers, found more: *'
printf 'nan 1\n' > bad
run query locate square.json --points bad
expect_status 1
expect_line '*bad: line 1: expected two numbers such as*'
run query closest square.json --points missing
expect_status 1
expect_line '*missing: *'
run query locate diagonal.json --points points
expect_status 1
expect_line '*diagonal.json: curve "diagonal": expected a closed curve*'
run query intersect square.json
expect_status 2
expect_line '*: B: expected an argument, found none*'
run query closest square.json diagonal.json --points points
expect_status 2
expect_line '*'
run query hausdorff square.json far.json --eps 0
expect_status 2
expect_line '*--eps*'
for eps in nan inf -1 x; do
  run query hull square.json --eps $eps
  expect_status 2
  expect_silence
  expect_line '*--eps*positive number*'
done
# Files that hold no curves, and no points; open curves where closed ones are wanted; what is missing.
: > empty
head -c 300 "$tool" > binary
printf '{"type":"bezier","degree":1,"control_points":[[0,0],[NaN,1]]}' > nan.json
for file in empty binary nan.json missing.json; do
  for rest in "hull $file" "closest $file --points points" "intersect square.json $file" \
    "distance $file square.json"; do
    # shellcheck disable=SC2086
    run query $rest
    expect_status 1
    expect_silence
    expect_line "bounding_arcs: $file: *"
  done
done
for file in binary missing; do
  run query locate square.json --points $file
  expect_status 1
  expect_silence
  expect_line "bounding_arcs: $file: *"
done
run query closest square.json --points empty
expect_status 0
expect_json '^\{"results":\[\]\}$'
run query closest diagonal.json --points points --signed
expect_status 1
expect_silence
expect_line '*diagonal.json: curve "diagonal": expected a closed curve*'
# A square within a square, and the two spellings of a rule.
printf '<svg xmlns="http://www.w3.org/2000/svg"><path d="M0 0H9V9H0ZM3 3H6V6H3Z"/></svg>\n' > nested.svg
echo 4 4 > middle
for rule in nonzero evenodd even-odd; do
  side=outside depth='[0-9.]*'
  [ $rule != nonzero ] || side=inside depth=-$depth
  run query locate nested.svg --points middle --rule $rule
  expect_json "\"$side\""
  run query closest nested.svg --points middle --signed --rule $rule
  expect_json "\"distance\":\[$depth,$depth\]"
done
rm nested.svg middle
run query closest square.json --points points --rule evenodd
expect_status 2
expect_line '*--signed*'
rm empty binary nan.json
run query intersect - -
expect_status 2
expect_line '*standard input*'
run query
expect_status 2
expect_line '*'
run query distance square.json missing.json
expect_status 1
expect_line '*missing.json: *'
# What CGAL remarks on while it computes is no part of a result. It does of these two, one nearly the other backwards.
cat > a.json <<'JSON'
{"type":"bezier","degree":2,"control_points":[[-2.1111111111111107,-1.444444444444445],
 [-2.333333333333334,-1.6666666666666672],[-2.9999999999999996,-2]]}
JSON
cat > b.json <<'JSON'
{"type":"bezier","degree":2,"control_points":[[-3,-2],[-2.3333333333333335,-1.666666666666667],
 [-2.1111111111111107,-1.444444444444445]]}
JSON
run query intersect a.json b.json
expect_status 0
python3 -m json.tool "$results/out" > checked.json || fail "$command_line: no JSON: $(head -c 99 "$results/out")"

finish
