#!/usr/bin/env bash
# Copyright (c) 2026 The Bounding Arcs authors.
# This file is part of Bounding Arcs, an add-on to CGAL.
# SPDX-License-Identifier: GPL-3.0-or-later
#
# Wrong usage: exit status 2 and one line on standard error. Help: exit status 0, with examples.
# Usage: test_usage.sh TOOL PROJECT_ROOT
. "$(dirname "${BASH_SOURCE[0]}")/support.sh"

curve=$root/examples/data/a_wrench.json

# refuses PATTERN ARGUMENTS: wrong usage, and what the line says about it.
refuses() {
  local pattern=$1
  shift
  run "$@"
  expect_status 2
  expect_line "bounding_arcs: $pattern"
  expect_silence
  expect_files
}

# The subcommands are those of the help.
"$tool" --help > help
subcommands=$(sed -n '/^Subcommands:/,/^$/s/^  \([a-z-]*\) .*/\1/p' help)
rm help
[ "$(wc -w <<< "$subcommands")" -gt 10 ] || fail "the help lists no subcommands"
# shellcheck disable=SC2086
all=$(printf '%s, ' $subcommands)
all="${all%, *, } or $(tail -n 1 <<< "$subcommands")"
refuses "SUBCOMMAND: expected $all, found nothing"
refuses "SUBCOMMAND: expected $all, found \"frobnicate\"" frobnicate
for word in ofset=offset medial_axis=medial-axis intersection=none cilp=clip; do
  meant="; did you mean ${word#*=}?"
  refuses "SUBCOMMAND: expected $all, found \"${word%=*}\"${meant%%*none*}" "${word%=*}" "$curve"
done
refuses 'SUBCOMMAND: expected closest, distance,*, found "closset"; did you mean closest?' query closset "$curve"
refuses 'SUBCOMMAND: expected closest, distance,*, found nothing' query

# An option that is not known comes first, and what was meant by it.
# unknown OPTION MEANT CALL ARGUMENTS
unknown() {
  local text="$1: unknown option; did you mean $2?" call=$3
  [ -n "$2" ] || text="$1: unknown option;"
  shift 3
  refuses "$text \`bounding_arcs $call--help\` lists the options" "$@"
}
unknown --distnace --distance 'offset ' offset --distnace 1 "$curve" --eps 1e-3
unknown --distnace --distance 'offset ' offset --distnace=1 "$curve"
unknown --dist --distance 'offset ' offset "$curve" --dist 1 --join mitre
unknown --tolerance '' 'offset ' offset --tolerance 1e-3 "$curve" --distance 1
unknown --metod --method 'build ' build --metod bca --eps 1e-3 "$curve"
unknown --frobnicate '' 'build ' build --frobnicate "$curve" --method bca --eps 1e-3
unknown -e '' 'arcs ' arcs -e 1e-3 "$curve"
unknown --pionts --points 'query locate ' query locate --pionts 1 "$curve"
unknown --versoin --version '' --versoin
unknown --certified '' 'compare ' compare --certified "$curve"

# missing ARGUMENT CALL ARGUMENTS
missing() {
  local what='this option' call=$2
  [ "${1#--}" != "$1" ] || what='an argument'
  refuses "$1: expected $what, found none; see \`bounding_arcs $call --help\`" "${@:3}"
}
missing FILES build build --method bca --eps 1e-3
missing FILES compare compare
missing FILES arcs arcs --eps 1e-3
missing FILES verify verify --method bca --eps 1e-3
missing FILE offset offset --eps 1e-3 --distance 1
missing B 'query distance' query distance "$curve"
missing --distance offset offset "$curve" --eps 1
missing --eps offset offset "$curve" --distance 1
refuses '--eps: expected a value, found none' offset "$curve" --distance 1 --eps
refuses '"b.json": expected no further argument, found this one; see `bounding_arcs offset --help`' \
  offset "$curve" b.json --distance 1 --eps 1
refuses '--jobs: expected together with --stream, found without' arcs "$curve" --eps 1 --jobs 2
refuses '--rule: expected together with --signed, found without' query closest "$curve" --points p --rule evenodd
refuses '--costs: expected without --verdicts, found with it' stability --costs --verdicts
refuses '--format: expected json with --stream, found csv' arcs "$curve" --eps 1 --stream --format csv
refuses 'FILES: expected one file, or -, with --stream, found 2' arcs "$curve" "$curve" --eps 1 --stream
refuses '--format: expected table, json, csv, svg, dxf or gcode, found "dwg"' arcs "$curve" --eps 1 --format dwg
refuses '--repeat: expected a whole number from 1 to 1000000, found "1.5"' compare --repeat 1.5 "$curve"
refuses '-: expected one input from standard input, found 2' arrange - -
refuses '-: expected one input from standard input, found 3' arcs - - - --eps 1
refuses '--eps: expected one tolerance, found "1,2"' build --method bca --eps 1,2 "$curve"
refuses '--kernel: expected double with method box, found exact' build --method box --eps 1 --kernel exact "$curve"
refuses '--points: expected a file of points for queries closest and locate, found none' report --query locate "$curve"

refuses '--eps: expected one value, found 2' arcs "$curve" --eps 1 --eps 2
refuses '--format: expected one value, found 2' arcs "$curve" --eps 1 --format csv --format json

# An empty argument is none, and no file either.
refuses 'FILES: expected a value, found ""' arcs --eps 1 ''
refuses 'FILES: expected a value, found ""' build --method bca --eps 1 "$curve" ''
refuses 'FILE: expected a value, found ""' offset --distance 2 --eps 1 ''
refuses 'B: expected a value, found ""' query distance "$curve" ''
refuses '--points: expected a value, found ""' query closest "$curve" --points ''
refuses '--points: expected a value, found ""' report "$curve" --points ''
refuses '--worst: expected a value, found ""' stability --worst ''
refuses '--curve: expected a value, found ""' stability --curve ''

# An empty name is no file, and not standard output either.
for subcommand in 'build --method bca --eps 1' compare 'verify --method bca --eps 1' stability 'arcs --eps 1' \
  'boolean union' "clip $curve" arrange 'offset --distance 2 --eps 1' 'medial-axis --eps 1' "verify-axis $curve" \
  'thickness --eps 1' 'query hull' info report; do
  # shellcheck disable=SC2086
  refuses '--output: expected a file name, found ""' $subcommand "$curve" -o ''
done

refuses '*--method*' build --eps 1e-3 "$curve"
refuses '*--method*' verify --eps 1e-3 "$curve"
refuses '*--eps*' build --method bca "$curve"
refuses '*--eps*' arcs "$curve"
refuses '*--eps*' verify --method bca "$curve"
refuses '*' build compare

for eps in '' 0 -1 -0 1e-400 1e400 nan NaN inf -inf infinity 1e-3x x 1e 1,,2 , 1, ,1 1,nan 1,0 '1 2' 1e-3\;2; do
  refuses '*eps*positive number*' build --method bca "--eps=$eps" "$curve" -o out.json
  refuses '*eps*positive number*' verify --method bca "--eps=$eps" "$curve" -o out.json
  refuses '*eps*positive number*' compare "--eps=$eps" "$curve" -o out.json
  refuses '*eps*' arcs "--eps=$eps" "$curve" -o out.json
done
refuses '*eps*' build --method bca "$curve" --eps

for method in '' BCA bilen bca,sfa obb; do
  refuses '*method*' build "--method=$method" --eps 1 "$curve"
  refuses '*method*' verify "--method=$method" --eps 1 "$curve"
done
for methods in '' bca,, bca,obb 'bca sfa'; do refuses '*methods*' compare "--methods=$methods" "$curve"; done
for kernel in '' float DOUBLE gmp; do
  for subcommand in 'build --method bca --eps 1' 'verify --method bca --eps 1' compare; do
    # shellcheck disable=SC2086
    refuses '*kernel*' $subcommand "--kernel=$kernel" "$curve"
  done
done
refuses '*format*' build --method bca --eps 1 --format table "$curve"
refuses '*format*' verify --method bca --eps 1 --format svg "$curve"
refuses '--format: expected json with --certified, as no other form has widenings, found svg' \
  build --method bca --eps 1 --format svg --certified "$curve"
refuses '*format*' compare --format svg "$curve"
refuses '*one positive number*' arcs --eps 1,2 "$curve"
refuses '*continuity*' arcs --eps 1 --continuity curvature "$curve"
refuses '*side*' arcs --eps 1 --side left "$curve"
for number in 0 -1 0.999 1e7 nan inf x ''; do
  refuses '--miter-limit*' offset --distance 2 --eps 1 --join miter "--miter-limit=$number" "$curve"
done
for number in 0 -1 1e4 nan inf x ''; do refuses '--max-size*' report "--max-size=$number" "$curve"; done
for number in 1e400 nan inf x ''; do
  refuses '--distance*' offset --eps 1 "--distance=$number" "$curve"
  refuses '*--seed*' stability "--seed=$number"
done
refuses '*split*' build --method bca --eps 1 --split thirds "$curve"
for number in 0 -1 1.5 x; do
  refuses '*' compare --repeat "$number" "$curve"
  refuses '*' build --method bca --eps 1 --max-regions "$number" "$curve"
  refuses '*' arcs --eps 1 --max-arcs "$number" "$curve"
done

for subcommand in 'offset --distance 1 --eps 1' 'medial-axis --eps 1' 'query locate --points none' report; do
  # shellcheck disable=SC2086
  for rule in '' odd even_odd even-odd,nonzero; do refuses '--rule*' $subcommand "--rule=$rule" "$curve"; done
done

# helps WORDS -- ARGUMENTS: help that names the words.
helps() {
  local words=()
  while [ "$1" != -- ]; do words+=("$1"); shift; done
  shift
  run "$@"
  expect_status 0
  [ -z "$err" ] || fail "$command_line: printed on stderr: $err"
  local word
  for word in "${words[@]}"; do grep -qF -e "$word" "$results/out" || fail "$command_line: says nothing of $word"; done
}

helps build compare verify arcs control_points -- --help
helps build compare verify arcs -- -h
for subcommand in build compare verify; do
  helps Examples "  bounding_arcs $subcommand " FILES --format --kernel --eps --output -- $subcommand --help
done
helps Examples '  bounding_arcs verify-axis ' FILE AXIS --frame --rule --format --output -- verify-axis --help
helps Examples '  bounding_arcs info ' FILE --join-ends --skip-open --layers --ids --strict -- info --help
helps --method --split -- build --help
helps --methods --repeat -- compare --help
helps --method 'status 1' --certified widening -- verify --help
helps Examples '  bounding_arcs arcs ' FILES --format --eps --continuity --side --output -- arcs --help

# The version is the project's.
run --version
expect_status 0
version=$(sed -n 's/^project(Bounding_arcs VERSION \([0-9.]*\).*/\1/p' "$root/CMakeLists.txt")
[ "$(cat "$results/out")" = "bounding_arcs $version" ] || fail "$command_line: printed $(cat "$results/out")"

# Options may come before or after the files, and give their values with or without =.
run build --method bca --eps 1e-1 "$curve"
cp "$results/out" spaced
run build "$curve" --eps=0.1 --method=bca
cmp -s spaced "$results/out" || fail 'the order of options changes the output'
run compare --eps 1e-1 --methods sfa --repeat 1 "$curve"
expect_status 0

finish
