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

refuses '*subcommand*'
refuses '*' frobnicate
refuses '*frobnicate*' build --frobnicate "$curve" --method bca --eps 1e-3
refuses '*FILES*' build --method bca --eps 1e-3
refuses '*FILES*' compare
refuses '*FILES*' arcs --eps 1e-3
refuses '*FILES*' verify --method bca --eps 1e-3
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
refuses '*eps*' build --method bca --eps 1,2 "$curve" -o out.json
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
refuses '*--certified*--format json*' build --method bca --eps 1 --format svg --certified "$curve"
refuses '*certified*' compare --certified "$curve"
refuses '*format*' compare --format svg "$curve"
refuses '*one tolerance*' arcs --eps 1,2 "$curve"
refuses '*continuity*' arcs --eps 1 --continuity curvature "$curve"
refuses '*side*' arcs --eps 1 --side left "$curve"
refuses '*format*' arcs --eps 1 --format dwg "$curve"
for number in 0 -1 0.999 1e7 nan inf x ''; do
  refuses '--miter-limit*' offset --distance 1 --eps 1 --join miter "--miter-limit=$number" "$curve"
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
