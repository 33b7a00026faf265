#!/usr/bin/env bash
# Copyright (c) 2026 The Bounding Arcs authors.
# This file is part of Bounding Arcs, an add-on to CGAL.
# SPDX-License-Identifier: GPL-3.0-or-later
#
# --stream as programs that feed it use it: a result a line, in order, whatever the threads; bad lines, long lines,
# lines that come one by one, pipes that close.
# Usage: test_stream.sh TOOL PROJECT_ROOT
. "$(dirname "${BASH_SOURCE[0]}")/support.sh"

# expect_equal WHAT FILE FILE
expect_equal() { cmp -s "$2" "$3" || fail "$1: $(cmp "$2" "$3" 2>&1); $(head -c 300 "$2") and $(head -c 300 "$3")"; }

line='{"name":"line","type":"bezier","degree":1,"control_points":[[0,0],[2,1]]}'
arch='{"type":"bezier","degree":2,"control_points":[[0,0],[0.5,0],[1,1]]}'
pair="{\"curves\":[$line,$arch]}"
square='{"name":"a \"square\"","type":"bspline","degree":1,"knots":[0,0,1,2,3,4,4],
 "control_points":[[0,0],[2,0],[2,2],[0,2],[0,0]]}'
echo '0.5 0.25' > points

# The result is the document that the subcommand makes of a file with that record, on one line.
# as_file ARGUMENTS
as_file() {
  local record
  for record in "$line" "$arch" "$pair" "$square"; do
    echo "$record" > curve.json  # the name that a curve without one gets in a stream, too
    "$tool" "$@" curve.json | tr -d '\n'
    echo
  done > expected
  printf '%s\n' "$line" "$arch" "$pair" "${square//$'\n'/}" > records
  run "$@" --stream records
  expect_status 0
  expect_equal "$command_line" expected "$results/out"
}
as_file build --method bca --eps 0.01
as_file build --method sfa --eps 0.01 --kernel exact --split optimal
as_file build --method bilens --eps 0.01 --certified
as_file offset --distance 0.1,-0.1 --eps 0.01
as_file query self-intersect --kernel exact
as_file query hull
as_file query closest --points points
for record in "$line" "$arch"; do
  echo "$record" > curve.json
  "$tool" arcs --eps 1e-3 --format json curve.json | tr -d '\n'
  echo
done > expected
printf '%s\n' "$line" "$arch" > records
run arcs --eps 1e-3 --stream records
expect_status 0
expect_equal arcs expected "$results/out"
echo "$square" | tee curve.json | tr -d '\n' > records
"$tool" medial-axis --eps 0.1 curve.json | tr -d '\n' > expected
echo >> expected
run medial-axis --eps 0.1 --stream records
expect_status 0
expect_equal medial-axis expected "$results/out"
"$tool" boolean difference curve.json "$root/examples/data/a_wrench.json" | tr -d '\n' > expected
echo >> expected
run boolean difference --stream records "$root/examples/data/a_wrench.json"  # from each record
expect_status 0
expect_equal boolean expected "$results/out"

# Blank lines, ends of lines as on other systems, no end of the last one; ids; bad records in their places.
printf '%s\r\n\n \t\n%s\n%s\n%s\n%s\n%s\n%s\n%s\n%s' "{\"id\":12,${line:1}" 'none {' '{"id":"a\"b","curves":[]}' '[1]' \
  "{\"curves\":[{\"id\":5,${line:1}],\"id\":6}" \
  '{"id":[1],"type":"bezier"}' '{"type":"bezier","id":{"id":3}}' \
  '{"id":3,"type":"bezier","degree":1,"control_points":[[0,0]]}' \
  "${arch%\}},\"id\":\"last\"}" > records
cat > expected << 'END'
{"id":12,"intersections":[],"overlaps":[]}
{"line":4,"error":"column 2: syntax error while parsing value - invalid literal; last read: 'no'"}
{"id":"a\"b","intersections":[],"overlaps":[]}
{"line":6,"error":"document: expected an object, found a list of 1"}
{"id":6,"intersections":[],"overlaps":[]}
{"line":8,"error":"id: expected a string of at most 1000 bytes or a whole number, found another value"}
{"line":9,"error":"id: expected a string of at most 1000 bytes or a whole number, found another value"}
{"id":3,"line":10,"error":"control_points: expected 2 of a bezier of degree 1, found 1"}
{"id":"last","intersections":[],"overlaps":[]}
END
for jobs in 1 3; do
  input=records run query self-intersect --stream --jobs $jobs -
  expect_status 1
  expect_line 'bounding_arcs: stdin: line 4: 5 of 9 records were answered by errors, this line the first'
  expect_equal "$command_line" expected "$results/out"
done

# What is out of the range of the library, and what eps cannot be reached for, is an answer, too.
printf '%s\n' '{"type":"bezier","degree":1,"control_points":[[0,0],[1e302,0]]}' \
  '{"type":"bezier","degree":2,"control_points":[[1e9,0],[1000000000.5,0],[1000000001,1]]}' > records
run build --method bca --eps 1e-12 --stream records
expect_status 1
grep -q '^{"line":1,"error":"control_points\[1\]\[0\]: expected a number of magnitude' "$results/out" ||
  fail "$command_line: $(cat "$results/out")"
grep -q '^{"line":2,"error":"curve \\"curve\\": eps 1e-12 is below what its coordinates' "$results/out" ||
  fail "$command_line: $(cat "$results/out")"

# Any number of threads, and any number of processes, give the same results. Lines differ in what they cost, so that
# results are ready in another order than that of the lines.
for file in "$root"/examples/data/*.json; do tr -d '\n' < "$file"; echo; done > some
for ((i = 0; i < 40; ++i)); do
  case $((i % 5)) in
    0) cat some ;;
    3) echo "{\"id\":$i,\"curves\":[}" ;;
    *) for ((j = 0; j < 40; ++j)); do echo "{\"id\":$((100 * i + j)),${pair:1}"; done ;;
  esac
done > records
run arcs --eps 1e-2 --stream records
expect_status 1
said=$err
cp "$results/out" expected
[ "$(wc -l < expected)" -eq "$(wc -l < records)" ] || fail "$command_line: $(wc -l < expected) results"
for jobs in 2 5; do
  run arcs --eps 1e-2 --stream --jobs $jobs - -o results  # of no input
  expect_status 0
  input=records run arcs --eps 1e-2 --stream --jobs $jobs - -o results
  expect_status 1
  expect_line "bounding_arcs: stdin: ${said#*records: }"
  expect_equal "$command_line" expected results
done
grep -v '"curves":\[}' records > good
grep -v '"error":"column' expected > expected_of_good
split -n l/5 good part.
export tool
# shellcheck disable=SC2016
printf '%s\n' part.?? | xargs -P 2 -I PART bash -c '"$tool" arcs --eps 1e-2 --stream PART -o result.PART'
cat result.part.?? > together
expect_equal 'processes by xargs' expected_of_good together
if parallel --version 2> /dev/null | grep -q GNU; then
  parallel --pipe --keep-order --block 20k "$tool arcs --eps 1e-2 --stream -" < good > together 2> /dev/null
  expect_equal 'processes by GNU parallel' expected_of_good together
fi
rm -f part.* result.* results together

# A line is answered before the next one comes.
coproc "$tool" query self-intersect --stream --jobs 2 -
process=$COPROC_PID  # bash forgets it when the process ends
for id in 1 2; do
  echo "{\"id\":$id,${line:1}" >&"${COPROC[1]}"
  read -r -t 60 answer <&"${COPROC[0]}" || answer=none
  [ "$answer" = "{\"id\":$id,\"intersections\":[],\"overlaps\":[]}" ] || fail "one line at a time: $answer"
done
exec {COPROC[1]}>&-
wait "$process" || fail 'one line at a time: the status is not 0'

# A reader that has had enough ends the program, and so the input without end; also where nobody is told by a signal.
for trap in '' 'trap "" PIPE'; do
  (eval "$trap"; yes "$arch" 2> /dev/null | timeout 60 "$tool" arcs --eps 0.1 --stream --jobs 2 - 2> "$results/err"
   echo "${PIPESTATUS[1]}" > "$results/status") | head -n 1 > first
  [ "$(wc -l < first)" -eq 1 ] || fail 'a closed pipe: no first line'
  case "$(cat "$results/status")" in
    1) grep -q 'standard output: cannot write: Broken pipe' "$results/err" ||
        fail "a closed pipe: $(cat "$results/err")" ;;
    141) ;;
    *) fail "a closed pipe: status $(cat "$results/status")" ;;
  esac
done
rm first

# A line without end is an error record, in memory that is bounded; sanitizers need more for themselves.
limit='ulimit -v 400000'
(eval "$limit"; "$tool" --version) > /dev/null 2>&1 || limit=:
{ head -c 600000000 /dev/zero; printf '\n%s' "$line"; } |
  (eval "$limit"; "$tool" query self-intersect --stream - > "$results/out" 2> "$results/err")
[ $? -eq 1 ] || fail "a long line: $(cat "$results/err")"
printf '%s\n' '{"line":1,"error":"expected at most 16777216 bytes, found a longer line"}' \
  '{"intersections":[],"overlaps":[]}' \
  > expected
expect_equal 'a long line' expected "$results/out"
# So do many lines.
if [ "$limit" != : ]; then
  { yes "$line" | head -n 200000; yes '' | head -c 300000000; } |
    (eval "$limit"; "$tool" query self-intersect --stream --jobs 2 - 2> "$results/err") | uniq -c > "$results/out"
  grep -qx ' *200000 {"intersections":\[\],"overlaps":\[\]}' "$results/out" || fail "many lines: $(cat "$results/out")"
fi

# Wrong usage, and files that cannot be read: nothing is written.
rm -f ./*
run build --method bca --eps 1 --stream --format svg -
expect_status 2
expect_line 'bounding_arcs: --format: expected json with --stream, found svg'
run build --method bca --eps 1 --stream a b
expect_status 2
expect_line 'bounding_arcs: FILES: expected one file, or -, with --stream, found 2'
run build --method bca --eps 1 --jobs 2 -
expect_status 2
expect_line 'bounding_arcs: --jobs: expected together with --stream, found without'
run build --method bca --eps 1 --stream --jobs 0 -
expect_status 2
run build --method bca --eps 1 --stream missing -o results
expect_status 1
expect_line 'bounding_arcs: missing: file: cannot be opened: No such file or directory'
run build --method bca --eps 1 --stream . -o results
expect_status 1
expect_line 'bounding_arcs: .: file: cannot be read: Is a directory'
expect_files

finish
