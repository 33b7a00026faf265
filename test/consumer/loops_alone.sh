#!/bin/bash
# Copyright (c) 2026 The Bounding Arcs authors.
# SPDX-License-Identifier: GPL-3.0-or-later
#
# Loops for wide registers define no function that other code might be linked to: a machine without these registers
# would run it. Usage: loops_alone.sh <nm> <library>
set -euo pipefail
# of all objects in the library those of the loops
symbols=$("$1" --demangle "$2" | awk '/^$/ { loops = 0 } /^(arc|batch)_loops.*:$/ { loops = 1 } loops')
for loop in bound_batch fit_biarcs; do
  grep -q "$loop<.*Base_set" <<< "$symbols" || { echo "no $loop in $2"; exit 1; }
done
if grep ' [WV] ' <<< "$symbols" | grep -v '_set'; then
  echo 'the functions above are compiled for wide registers and visible to all; they should be always_inline'
  exit 1
fi
