#!/usr/bin/env bash
# Copyright (c) 2026 The Bounding Arcs authors.
# SPDX-License-Identifier: GPL-3.0-or-later
#
# Has Gappa prove what a hint file asks, for both ends where it asks for one. A warning is a failure: Gappa warns of a
# rewriting rule that is no identity, and of one that divides by what may be 0.
# Usage: prove.sh PROGRAM HINT_FILE
set -euo pipefail
program=$1 hints=$2
readonly SECONDS_AT_MOST=300  # Gappa may search without end for what does not hold; a proof takes a few
ends=0
! grep -q '^[^#]*%' "$hints" || ends='0 1'
for end in $ends; do
  script=$("$program" "$hints" "$end")
  said=$(timeout "$SECONDS_AT_MOST" gappa -Wno-unbound-variable 2>&1 <<< "$script") || {
    printf '%s\nend %s: not proven\n%s\n' "$script" "$end" "$said"
    exit 1
  }
  [ -z "$said" ] || { printf 'end %s: Gappa says\n%s\n' "$end" "$said"; exit 1; }
done
