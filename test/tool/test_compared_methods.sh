#!/usr/bin/env bash
# Copyright (c) 2026 The Bounding Arcs authors.
# This file is part of Bounding Arcs, an add-on to CGAL.
# SPDX-License-Identifier: GPL-3.0-or-later
#
# The methods to compare with, as a user runs them: tables, JSON, pictures and proofs; what they do not have is refused.
# Usage: test_compared_methods.sh TOOL PROJECT_ROOT
. "$(dirname "${BASH_SOURCE[0]}")/support.sh"

curve=$root/examples/data/a_wrench.json
yardsticks='fat-arc fat-biarc box oriented-box hull'
all=bca,sfa,bilens,${yardsticks// /,}

# A row a method, and thinner regions need fewer of them.
run compare --eps 1e-3 --methods "$all" --repeat 1 "$curve"
expect_status 0
expect_finite
[ "$(sed '/^$/,$d' "$results/out" | wc -l)" -eq 9 ] || fail "$command_line: not a row a method"
regions() { awk -v method="$1" '$5 == method { print $10 }' "$results/out"; }
for pair in 'box oriented-box' 'hull oriented-box' 'oriented-box bca' 'bca fat-arc' 'fat-arc fat-biarc'; do
  [ "$(regions "${pair% *}")" -gt "$(regions "${pair#* }")" ] ||
    fail "$command_line: ${pair% *} has $(regions "${pair% *}") regions, ${pair#* } $(regions "${pair#* }")"
done

# outer_pieces: of how many pieces outer chains of the last run are, each number once.
outer_pieces() { sed -n 's/.*"outer"://p' "$results/out" | awk '{ print gsub(/"type"/, "") }' | sort -nu; }
for method in $yardsticks; do
  run build --method "$method" --eps 1e-2 "$curve"
  expect_status 0
  expect_finite
  grep -q "^{\"method\":\"$method\"" "$results/out" || fail "$command_line: no such method in JSON"
  case $method in
    box) wanted=2 ;;
    fat-arc) wanted=3 ;;
    fat-biarc) wanted=4 ;;
    *) wanted= ;;
  esac
  [ -z "$wanted" ] || outer_pieces | grep -qx "$wanted" ||
    fail "$command_line: no outer chain of $wanted pieces, but of $(outer_pieces | tr '\n' ' ')"
  run build --method "$method" --eps 1e-2 --format svg "$curve"
  expect_status 0
  expect_finite
  grep -q "<title>$method, eps 0.01" "$results/out" || fail "$command_line: no caption"
  run verify --method "$method" --eps 1e-2 "$curve"
  expect_status 0
  for wrong in '--kernel exact' '--kernel filtered' '--split optimal' '--certified'; do
    # shellcheck disable=SC2086
    run build --method "$method" --eps 1e-2 $wrong "$curve" -o none.json
    expect_status 2
    expect_silence
    expect_line "*${wrong%% *}*$method*"
  done
done
run compare --kernel exact --methods bca,box "$curve"
expect_status 2
expect_line 'bounding_arcs: --kernel: expected double with method box, found exact'

# Orders, within 2 % of theory at the middle of every other spiral segment.
run compare --orders --methods "$all" --format json "$curve"
expect_status 0
expect_finite
[ "$(grep -c '"median"' "$results/out")" -eq 8 ] || fail "$command_line: not all methods have an order"
while IFS=' ' read -r method theory median; do
  awk -v a="$median" -v b="$theory" 'BEGIN { d = a / b - 1; exit !(d < 0.02 && d > -0.02) }' ||
    fail "$command_line: $method has the order $median, in theory $theory"
done < <(sed -n 's/.*"method":"\([^"]*\)","theory":\([0-9]*\),.*"median":\([^,]*\),.*/\1 \2 \3/p' "$results/out")
run compare --orders --methods "$all" "$curve"
expect_status 0
[ "$(sed '/^$/,$d' "$results/out" | wc -l)" -eq 9 ] || fail "$command_line: not a row a method"
run compare --orders --kernel exact "$curve"
expect_status 2
expect_line '*--kernel*orders*'

# Searches over all kinds of region: a row each, and the same answers, which the command asserts itself.
run compare --queries --methods "$all" --eps 1e-3 --repeat 1 "$curve"
expect_status 0
[ "$(sed '/^$/,$d' "$results/out" | wc -l)" -eq 9 ] || fail "$command_line: not a row a method"
run compare --queries --methods "$all" --repeat 1 --format json "$curve"
expect_status 0
expect_finite
[ "$(grep -c '"hausdorff":{"us":' "$results/out")" -eq 8 ] || fail "$command_line: not a row a method"
# By regions alone boxes are asked for more often by far, and fat biarcs less often than boxes along the chord.
while IFS=' ' read -r method regions; do declare "regions_${method//-/_}=$regions"; done < <(
  sed -n 's/.*"method":"\([^"]*\)".*"alone":{"us":[^,]*,"regions":\([0-9]*\).*/\1 \2/p' "$results/out")
[ "$regions_box" -gt $((10 * regions_bca)) ] || fail "$command_line: box $regions_box, bca $regions_bca"
[ "$regions_oriented_box" -gt "$regions_fat_biarc" ] || fail "$command_line: boxes along chords ask for fewer"
run compare --queries --methods "$all" --eps 1e-3 --repeat 1 --format svg "$curve"
expect_status 0
[ "$(grep -c '<rect x' "$results/out")" -eq 40 ] || fail "$command_line: not a bar a method and question"
run compare --queries --kernel exact "$curve"
expect_status 2
expect_line '*--kernel*queries*'
run compare --queries --orders "$curve"
expect_status 2
expect_line '*--orders*--queries*'
run compare --format svg "$curve"
expect_status 2
expect_line 'bounding_arcs: --format: expected table or json without --queries, found svg'

# A box needs more regions than there is room for: told, and nothing hangs.
run build --method box --eps 1e-9 --max-regions 1000 "$curve" -o none.json
expect_status 1
expect_line '*1000 nodes for box*'

# A page of all methods, and none of what they do not have.
run report --methods "$all" --eps 1e-2 --repeat 1 --stability none "$curve" -o page.html
expect_status 0
grep -q '"methods":\["bca","sfa","bilens","fat-arc","fat-biarc","box","oriented-box","hull"\]' page.html ||
  fail "$command_line: not all methods are on the page"
run report --methods hull --kernel filtered --stability none "$curve" -o none.html
expect_status 2
expect_line '*--kernel*hull*'
expect_files page.html
finish
