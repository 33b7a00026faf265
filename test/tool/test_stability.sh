#!/usr/bin/env bash
# Copyright (c) 2026 The Bounding Arcs authors.
# This file is part of Bounding Arcs, an add-on to CGAL.
# SPDX-License-Identifier: GPL-3.0-or-later
#
# stability: its columns, families, formats and errors.
# Usage: test_stability.sh TOOL PROJECT_ROOT
. "$(dirname "${BASH_SOURCE[0]}")/support.sh"

columns='family,delta,method,formula,kernel,quantity,rel_error,abs_error,outside'
curve=$root/doc/images/loop.json

# expect_rows N PATTERN: the last run, in CSV, has so many rows like the extended regular expression.
expect_rows() {
  local found
  found=$(grep -cE -e "$2" "$results/out")
  [ "$found" -eq "$1" ] || fail "$command_line: $found rows like $2 instead of $1"
}

run stability --family subdivision
expect_status 0
expect_finite
[ "$(head -1 "$results/out")" = "$columns" ] || fail "$command_line: columns are $(head -1 "$results/out")"
# 41 lengths, 2 formulas, 4 kernels; no joints of BCA
expect_rows $((41 * 2 * 4 * 11)) '^subdivision,'
expect_rows $((41 * 2 * 3)) ',filtered,joint,|,(float|long-double),nothing,|,bca,.*,double,thickness,'
expect_rows 0 ',bca,[a-z]*,[a-z-]*,joint,'
for kernel in float double long-double filtered; do expect_rows $((41 * 2 * 11)) ",$kernel,"; done
awk -F, 'NR > 1 && $4 == "stable" && ($5 == "double" || $5 == "filtered") && $7 > 16 * 2^-52' "$results/out" > above
[ ! -s above ] || fail "$command_line: above 16 ulp: $(head -3 above)"
awk -F, '$4 == "textbook" && $5 == "double" && $6 == "thickness" && $2 < 1e-6 && $7 < 0.5' "$results/out" > kept
[ ! -s kept ] || fail "$command_line: the textbook keeps digits: $(head -3 kept)"
rm above kept

run stability --family random --count 10 --seed 7 --format json
expect_status 0
expect_finite
for key in family delta method formula kernel quantity rel_error abs_error outside; do
  [ "$(grep -c "\"$key\":" "$results/out")" -eq "$(grep -c '"family":' "$results/out")" ] ||
    fail "$command_line: rows without $key"
done
cp "$results/out" first
run stability --family random --count 10 --seed 7 --format json -o again
expect_status 0
expect_silence
cmp -s first again || fail "$command_line: the same seed gives other rows"
run stability --family random --count 5 --seed 8
grep -q '^random,' "$results/out" || fail "$command_line: no rows"
rm first again

run stability "$curve"
expect_status 0
expect_rows 0 '^(near|subdivision|random)'
expect_rows $((2 * 4 * 11)) '^curves,0,'
run stability --family subdivision "$curve"
grep -q '^curves,' "$results/out" && grep -q '^subdivision,' "$results/out" || fail "$command_line: a family is missing"

run stability --format svg "$curve" --family subdivision -o plot.svg
expect_status 0
for word in center radius joint thickness 'bca, textbook' 'bilens, stable' subdivision curves; do
  grep -qF "$word" plot.svg || fail "the plot says nothing of $word"
done
! grep -qiE "$NO_NUMBER" plot.svg || fail 'the plot has numbers that are none'
rm plot.svg

# A study that takes minutes says so after some seconds, though nobody watches.
timeout 60 "$tool" stability --family random --count 100000 > "$results/out" 2> "$results/err" &
study=$!
for _ in $(seq 500); do [ ! -s "$results/err" ] || break; sleep 0.1; done
kill "$study"
wait "$study" 2> "$results/wait"
command_line='stability of 100000 spirals'
err=$(cat "$results/err")
expect_line 'bounding_arcs: measuring random, spirals: * of 100000 after * s, some * s to come'

# refuses STATUS PATTERN ARGUMENTS
refuses() {
  local wanted=$1 pattern=$2
  shift 2
  run stability "$@"
  expect_status "$wanted"
  expect_line "bounding_arcs: $pattern"
  expect_silence
  expect_files
}
refuses 2 '*family*' --family round
refuses 2 '*family*' --family ''
refuses 2 '*format*' --format table
refuses 2 '*count*' --family random --count 0
refuses 2 '*seed*' --family random --seed x
refuses 1 'missing.json*' missing.json
refuses 1 'no/plot.svg*' --format svg -o no/plot.svg "$curve"

run stability --help
expect_status 0
for word in Examples '  bounding_arcs stability ' FILES --family --count --seed --format --output outside \
    near-linear; do
  grep -qF -e "$word" "$results/out" || fail "$command_line: says nothing of $word"
done

finish
