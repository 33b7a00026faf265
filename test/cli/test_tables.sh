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
finish
