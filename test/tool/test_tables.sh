#!/usr/bin/env bash
# Copyright (c) 2026 The Bounding Arcs authors.
# This file is part of Bounding Arcs, an add-on to CGAL.
# SPDX-License-Identifier: GPL-3.0-or-later
#
# Tables whatever curves are called: one row each, ratios to the row of the same curve.
# Usage: test_tables.sh TOOL PROJECT_ROOT
. "$(dirname "${BASH_SOURCE[0]}")/support.sh"

# curve FILE NAME SOURCE: one of the bundled curves under another name.
curve() { sed 's/"name": *"[^"]*"/"name":"'"$2"'"/' "$root/examples/data/$3.json" > "$1"; }
curve one.json same a_wrench
curve two.json same h_maple_leaf
curve all.json all b_angelfish

# Two curves of one name, and one called as the totals are: the first method's ratios are 1, in each row.
run compare --eps 1e-3 --methods bca,sfa --repeat 1 one.json two.json all.json
expect_status 0
[ "$(grep -c ' bca .* 1\.000$' "$results/out")" -eq 4 ] ||
  fail "not all rows of the first method have the ratio 1: $(cat "$results/out")"

# Long names, and such with control characters, are cut and escaped.
long=$(printf 'n%.0s' {1..3000})
for name in 'a\\nb' 'a\\u0000b' 'a\\u001b[31mb' "$long"; do
  curve odd.json "$name" a_wrench
  for command in 'compare --eps 1e-3 --methods bca --repeat 1' 'verify --method bca --eps 1e-3' 'arcs --eps 1e-3'; do
    # shellcheck disable=SC2086
    run $command odd.json
    expect_status 0
    rows=$(sed '/^$/,$d' "$results/out")
    [ "$(wc -l <<< "$rows")" -eq 2 ] || fail "$command, ${name:0:20}: not a header and a row: ${rows:0:300}"
    [ -z "$(tr -d '\n[:print:]' < "$results/out")" ] || fail "$command, ${name:0:20}: control characters"
    [ "$(awk '{ if (length > most) most = length } END { print most }' "$results/out")" -lt 240 ] ||
      fail "$command, ${name:0:20}: long lines"
    grep -qE ' [0-9]+ .*[0-9]' <<< "${rows#*$'\n'}" || fail "$command, ${name:0:20}: no numbers"
  done
done

# CSV has the same numbers as JSON, a piece a line, and quotes names.
# same ARGUMENTS: the pieces of both forms
same() {
  run "$@" --format json
  grep -oE '"from":[^}]*' "$results/out" | sed -E 's/,"center.*//; s/"[a-z]+"//g; s/[^0-9.e+-]/ /g' |
    awk '{ print $1, $2, $3, $4, (NF > 4 ? $5 : 0) }' > wanted
  run "$@" --format csv
  expect_status 0
  expect_finite
  sed '1d; s/,/ /g' "$results/out" | awk '{ print $(NF - 4), $(NF - 3), $(NF - 2), $(NF - 1), $NF }' > found
  cmp -s wanted found || fail "$command_line: other pieces than in JSON: $(diff wanted found | head -4)"
  [ "$(wc -l < wanted)" -gt 40 ] || fail "$command_line: few pieces"
  sed -n 2p "$results/out" | grep -qF '"a, ""b"""' || fail "$command_line: the name is not quoted"
}
curve odd.json 'a, \\"b\\"' a_wrench
same build --method bilens --eps 1e-2 odd.json
same arcs --eps 1e-3 odd.json
same offset --distance 0.1,-0.1 --eps 1e-3 odd.json
run build --method bca --eps 1e-2 --format csv odd.json
[ "$(head -1 "$results/out")" = curve,bezier,t0,t1,thickness,boundary,x_from,y_from,x_to,y_to,bulge ] ||
  fail "$command_line: the columns are $(head -1 "$results/out")"
for boundary in inner outer; do
  [ "$(grep -c ",$boundary," "$results/out")" -eq 83 ] || fail "$command_line: not all $boundary boundaries"
done
finish
